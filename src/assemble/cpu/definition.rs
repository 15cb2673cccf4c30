//! The volume energy as its definition has it, in any dimension: what the passes of the plane and of space are compared with.

use super::CpuAssembler;
use super::certificate::coefficients;
use super::element::{
    Columns, Edges, MAX_COLUMNS, MAX_EDGES, add_edge_pair, columns_of, edge_differences, edge_forces_to_corners,
    slots_at, stress_to_edges,
};
use crate::energy::{Energies, GRADIENT, HESSIAN, Point, Response, Term, VALUE, Volume};
use crate::grid::MAX_CORNERS;
use crate::quadrature::{Rule, edge_ends};
use crate::small::{Scalar, add_scaled, determinant};
use crate::stencil::StencilOperator;

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// Volume energy over all cells; returns the least determinant, and early once it is not positive.
    pub(super) fn volume_pass<const ORDER: u8, const M: usize>(
        &self,
        rule: &Rule<D, M>,
        displacement: &[f64],
        gradient: &mut [f64],
        energies: &mut Energies,
    ) -> f64 {
        let volume = Volume(self.functional.material);
        let share = S::splat(self.functional.vertex_share);
        let rest = S::splat(1.0 - self.functional.vertex_share);
        let inverse = S::splat(self.grid.cells() as f64);
        let mut energy = S::zero();
        let mut least = S::splat(f64::INFINITY);
        let packs_a_row = self.grid.cells() / S::LANES;

        for (pack, weights) in self.volume_weight.chunks_exact(S::LANES).enumerate() {
            let base = self.grid.lowest_node(pack * S::LANES);
            let nodes: [usize; 2] = std::array::from_fn(|lane| base + lane.min(S::LANES - 1));
            let weight = S::gather(|lane| weights[lane]);
            let corners = self.gather(displacement, nodes);
            let edges = edge_differences(&corners, inverse);
            let mut forces = [[[S::zero(); D]; MAX_EDGES]; D];

            if D == 3 {
                least = coefficients(&edges).into_iter().fold(least, S::min);
            }
            let columns = columns_of(&self.vertices, &edges);
            if D != 3 {
                for point in 0..Rule::<D, 2>::POINTS {
                    least = least.min(determinant(&slots_at(&self.vertices, &columns, point)));
                }
            }
            if self.functional.vertex_share > 0.0 {
                energy += self.volume_rule::<2, ORDER>(&self.vertices, &volume, weight * share, &columns, &mut forces);
            }
            let columns = columns_of(rule, &edges);
            energy += self.volume_rule::<M, ORDER>(rule, &volume, weight * rest, &columns, &mut forces);

            if ORDER >= GRADIENT {
                let mut corner_forces = [[S::zero(); D]; MAX_CORNERS];
                edge_forces_to_corners(&forces, inverse, &mut corner_forces);
                self.scatter(&corner_forces, nodes, gradient);
            }
            if (pack + 1) % packs_a_row == 0 && least.least() <= 0.0 {
                break;
            }
        }
        energies.volume = energy.sum();
        least.least()
    }

    /// The volume energy of a pack by one rule; adds forces on the edges.
    #[inline(always)]
    fn volume_rule<const M: usize, const ORDER: u8>(
        &self,
        rule: &Rule<D, M>,
        volume: &Volume,
        weight: S,
        columns: &Columns<S, D>,
        forces: &mut Edges<S, D>,
    ) -> S {
        let mut energy = S::zero();
        let mut stress = [[[S::zero(); D]; MAX_COLUMNS]; D];
        for point in 0..Rule::<D, M>::POINTS {
            let weight = weight * S::splat(rule.weight[point]);
            let slots = slots_at(rule, columns, point);
            let mut response = Response::zero();
            // The hessian has a rule of its own.
            energy += weight
                * if ORDER == VALUE {
                    volume.add::<S, VALUE>(weight, &Point::of_derivative(slots), &mut response)
                } else {
                    volume.add::<S, GRADIENT>(weight, &Point::of_derivative(slots), &mut response)
                };
            if ORDER >= GRADIENT {
                for k in 0..D {
                    let column = &mut stress[k][rule.column[point][k]];
                    *column = add_scaled(column, S::splat(1.0), &response.gradient[k]);
                }
            }
        }
        if ORDER >= GRADIENT {
            stress_to_edges(rule, &stress, forces);
        }
        energy
    }

    /// The volume's hessian over all cells, at 2^D Gauss points.
    pub(super) fn volume_hessian_pass<T: Scalar, const C: usize>(
        &self,
        displacement: &[f64],
        operator: &mut StencilOperator<D>,
    ) {
        let volume = Volume(self.functional.material);
        let cells = self.grid.cells() as f64;
        let offsets = self.grid.corner_offsets();
        let rule = &self.gauss2;
        for (pack, weights) in self.volume_weight.chunks_exact(T::LANES).enumerate() {
            let base = self.grid.lowest_node(pack * T::LANES);
            // Differences are taken before the numbers are rounded to T.
            let mut edges = [[[T::zero(); D]; MAX_EDGES]; D];
            for (axis, edges) in edges.iter_mut().enumerate() {
                for (edge, difference) in edges.iter_mut().enumerate().take(1 << (D - 1)) {
                    let (low, high) = edge_ends(axis, edge);
                    let (low, high) =
                        (&displacement[(base + offsets[low]) * D..], &displacement[(base + offsets[high]) * D..]);
                    for k in 0..D {
                        difference[k] = T::gather(|lane| (high[lane * D + k] - low[lane * D + k]) * cells);
                    }
                }
            }
            let columns = columns_of(rule, &edges);
            let scaled = T::gather(|lane| weights[lane] * cells * cells);
            let mut hessians = [[[[[T::zero(); D]; D]; D]; D]; C];
            for (point, hessian) in hessians.iter_mut().enumerate() {
                let mut response = Response::zero();
                let slots = slots_at(rule, &columns, point);
                let weight = scaled * T::splat(rule.weight[point]);
                volume.add::<T, HESSIAN>(weight, &Point::of_derivative(slots), &mut response);
                *hessian = std::array::from_fn(|p| std::array::from_fn(|q| response.hessian[p][q]));
            }
            let mut pairs = [[[[T::zero(); D]; D]; C]; C];
            // A derivative of φ is an average over edges, so edge pairs are integrated and then handed to their ends.
            for p in 0..D {
                for q in p..D {
                    for e in 0..Rule::<D, 2>::EDGES {
                        for f in 0..Rule::<D, 2>::EDGES {
                            let mut block = [[T::zero(); D]; D];
                            for (point, hessian) in hessians.iter().enumerate() {
                                let column = &rule.column[point];
                                let share = T::splat(rule.edge[column[p]][e] * rule.edge[column[q]][f]);
                                for a in 0..D {
                                    for b in 0..D {
                                        block[a][b] += share * hessian[p][q][a][b];
                                    }
                                }
                            }
                            add_edge_pair(&mut pairs, (p, e), (q, f), &block);
                        }
                    }
                }
            }
            self.scatter_pairs(&pairs, |lane| base + lane, operator);
            let corners = columns_of(&self.vertices, &edges);
            let mut least = T::splat(f64::INFINITY);
            for point in 0..Rule::<D, 2>::POINTS {
                least = least.min(determinant(&slots_at(&self.vertices, &corners, point)));
            }
            self.stiffen_corners::<T, C>(least, base, weights, displacement, operator);
        }
    }
}
