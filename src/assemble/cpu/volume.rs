//! The volume energy in space.
//!
//! The [modes](super::trilinear) of a cell are orthogonal: with the second moment ⟨s²⟩ = ⟨t²⟩ = r of a quadrature rule,
//! ⟨|∂φ/∂x_k|²⟩ = |m₀|² + r (|m₁|² + |m₂|²) + r² |m₃|². So the density μ/2 |Dφ|² + g(det²) takes a determinant and one
//! reciprocal at a point, and its derivative the cofactors once. The same numbers as by `definition`.

use super::CpuAssembler;
use super::certificate::{coefficients, quick_bound};
use super::element::{MAX_EDGES, edge_differences};
use super::trilinear::{
    Columns, add_to_edges, add_to_modes, columns_of, corner_columns, corner_forces, derivative_at, modes_of, places_of,
};
use crate::energy::{Energies, GRADIENT, Material};
use crate::quadrature::Rule;
use crate::small::{Scalar, add_scaled, cofactor, determinant, dot};
use std::cmp::Ordering;

/// r of a Gauss rule, and of the one at the corners.
const GAUSS_MOMENT: f64 = 1.0 / 3.0;
const CORNER_MOMENT: f64 = 1.0;

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// Volume energy over all cells, for D = 3; returns a lower bound of the least determinant, and early once it is not
    /// positive.
    pub(super) fn spatial_volume_pass<const ORDER: u8, const M: usize>(
        &self,
        rule: &Rule<D, M>,
        displacement: &[f64],
        gradient: &mut [f64],
        energies: &mut Energies,
    ) -> f64 {
        let material = &self.functional.material;
        let share = self.functional.vertex_share;
        let moment = share * CORNER_MOMENT + (1.0 - share) * GAUSS_MOMENT;
        let both = share * CORNER_MOMENT.powi(2) + (1.0 - share) * GAUSS_MOMENT.powi(2);
        let stiffness = [1.0, moment, moment, both].map(|moment| S::splat(material.mu * moment));
        let (half, inverse) = (S::splat(0.5), S::splat(self.grid.cells() as f64));
        let mut energy = S::zero();
        let mut least = S::splat(f64::INFINITY);
        let packs_a_row = self.grid.cells() / S::LANES;

        for (pack, weights) in self.volume_weight.chunks_exact(S::LANES).enumerate() {
            let base = self.grid.lowest_node(pack * S::LANES);
            let nodes: [usize; 2] = std::array::from_fn(|lane| base + lane.min(S::LANES - 1));
            let weight = S::gather(|lane| weights[lane]);
            let edges = edge_differences(&self.gather(displacement, nodes), inverse);
            let modes = modes_of(&edges);

            // Admissibility first. Only cells that may lower the bound are looked at closely, and those that are not numbers.
            let bound = quick_bound(&edges, &modes);
            if (bound - least).least().partial_cmp(&0.0) != Some(Ordering::Greater) {
                least = coefficients(&edges).into_iter().fold(least, S::min);
            }

            let mut forces = modes;
            let mut density = S::zero();
            for modes in &mut forces {
                for (mode, stiffness) in modes.iter_mut().zip(stiffness) {
                    let force = mode.map(|entry| stiffness * entry);
                    density += half * dot(mode, &force);
                    *mode = force;
                }
            }
            let mut on_edges = [[[S::zero(); D]; MAX_EDGES]; D];
            if share > 0.0 {
                let mut stress = [[[[S::zero(); D]; 2]; 2]; D];
                let columns = corner_columns(&edges);
                density += dilation::<S, D, 2, ORDER>(&self.vertices, material, share, &columns, &mut stress);
                for (edges, stress) in on_edges.iter_mut().zip(&stress) {
                    edges.copy_from_slice(stress.as_flattened());
                }
            }
            let mut stress = [[[[S::zero(); D]; M]; M]; D];
            let columns = columns_of(rule, &modes);
            density += dilation::<S, D, M, ORDER>(rule, material, 1.0 - share, &columns, &mut stress);
            energy += weight * density;
            if ORDER >= GRADIENT {
                add_to_modes(rule, &stress, &mut forces);
                add_to_edges(&forces, &mut on_edges);
                self.scatter(&corner_forces(&on_edges, weight * inverse), nodes, gradient);
            }
            if (pack + 1) % packs_a_row == 0 && least.least() <= 0.0 {
                break;
            }
        }
        energies.volume = energy.sum();
        least.least()
    }
}

/// The mean of g(det²) over the points of a rule, times `share`; adds its derivatives by the columns.
#[inline(always)]
fn dilation<S: Scalar, const D: usize, const M: usize, const ORDER: u8>(
    rule: &Rule<D, M>,
    material: &Material,
    share: f64,
    columns: &Columns<S, D, M>,
    stress: &mut Columns<S, D, M>,
) -> S {
    let mut sum = S::zero();
    for point in 0..Rule::<D, M>::POINTS {
        let weight = S::splat(share * rule.weight[point]);
        let places = places_of::<D, M>(point);
        let f = derivative_at(columns, &places);
        if ORDER >= GRADIENT {
            let cof = cofactor(&f);
            let det = dot(&f[0], &cof[0]);
            let (g, slope, _) = material.dilation(det * det);
            sum += weight * g;
            let twist = weight * (det + det) * slope;
            for axis in 0..D {
                let column = &mut stress[axis][places[axis][1]][places[axis][0]];
                *column = add_scaled(column, twist, &cof[axis]);
            }
        } else {
            let det = determinant(&f);
            sum += weight * material.dilation(det * det).0;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::distance::SignedDistance;
    use crate::energy::Functional;
    use crate::grid::Grid;
    use crate::settings::Settings;
    use crate::small::F64x2;

    #[test]
    fn energy_gradient_and_determinant_are_those_of_the_general_pass() {
        let grid = Grid::<3>::of_level(3);
        let ball = |radius: f64| {
            let away = |x: [f64; 3]| x.iter().map(|x| (x - 0.5).powi(2)).sum::<f64>().sqrt() - radius;
            SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|node| away(grid.position(node))).collect())
        };
        // All modes of a cell, far from a fold.
        let displacement: Vec<f64> = (0..grid.node_count() * 3).map(|k| 0.02 * (1.7 * (k * k) as f64).sin()).collect();
        for vertex_share in [0.0, 0.25] {
            let functional = Functional { vertex_share, ..Settings::default().functional(4) };
            let assembler: CpuAssembler<3, F64x2> = CpuAssembler::new(&functional, &ball(0.2), &ball(0.25));
            for few in [true, false] {
                let pass = |by_modes: bool| {
                    let (two, three) = (&assembler.gauss2, &assembler.gauss3);
                    let (mut gradient, mut energies) = (vec![0.0; displacement.len()], Energies::default());
                    let (g, e) = (&mut gradient, &mut energies);
                    let least = match (by_modes, few) {
                        (true, true) => assembler.spatial_volume_pass::<GRADIENT, 2>(two, &displacement, g, e),
                        (true, false) => assembler.spatial_volume_pass::<GRADIENT, 3>(three, &displacement, g, e),
                        (false, true) => assembler.volume_pass::<GRADIENT, 2>(two, &displacement, g, e),
                        (false, false) => assembler.volume_pass::<GRADIENT, 3>(three, &displacement, g, e),
                    };
                    (least, energies.volume, gradient)
                };
                let (found, expected) = (pass(true), pass(false));
                assert!(expected.0 > 0.2 && expected.0 < 0.8, "bent, not folded: {}", expected.0);
                assert!((found.0 - expected.0).abs() < 1e-14);
                assert!((found.1 - expected.1).abs() < 1e-13 * expected.1);
                let size = expected.2.iter().fold(0.0_f64, |most, g| most.max(g.abs()));
                for (a, b) in found.2.iter().zip(&expected.2) {
                    assert!((a - b).abs() < 1e-12 * size, "{a} is not {b}");
                }
            }
        }
    }
}
