//! The volume energy in the plane, where a bilinear cell is three vectors.
//!
//! With local coordinates s, t ∈ [−½, ½] a bilinear φ has ∂φ/∂x = a + t c and ∂φ/∂y = b + s c: a and b are the mean
//! differences along the axes, c is the mixed one, and so
//!
//! det Dφ = a×b + s a×c + t c×b
//!
//! is affine on the cell. The density μ/2 |Dφ|² + g(det²) then takes one sum a quadrature point for the determinant, and
//! gives forces on the three vectors by moments of ∂g. The same numbers as by `definition`.

use super::CpuAssembler;
use super::bilinear::{Cell, Line, combined, to_corners, transposed, turned};
use super::element::Pairs;
use crate::energy::{Energies, GRADIENT, HESSIAN, Point, Response, Term, Volume};
use crate::small::{F32x4, Scalar, Vector, add_scaled, dot};
use crate::stencil::StencilOperator;

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// What [`spatial_volume_pass`](Self::spatial_volume_pass) returns and adds, for D = 2.
    pub(super) fn planar_volume_pass<const ORDER: u8>(
        &self,
        displacement: &[f64],
        gradient: &mut [f64],
        energies: &mut Energies,
    ) -> f64 {
        let volume = Volume(self.functional.material);
        let share = S::splat(self.functional.vertex_share);
        let rest = S::splat(1.0 - self.functional.vertex_share);
        let (gauss, vertices) = (Line::of(&self.gauss3), Line::of(&self.vertices));
        let inverse = S::splat(self.grid.cells() as f64);
        let zero = S::zero();
        let mut energy = zero;
        let mut least = S::splat(f64::INFINITY);
        for (row, weights) in self.volume_weight.chunks_exact(self.grid.cells()).enumerate() {
            let first = row * self.grid.side();
            for (pack, weights) in weights.chunks_exact(S::LANES).enumerate() {
                let base = first + pack * S::LANES;
                let nodes: [usize; 2] = std::array::from_fn(|lane| base + lane.min(S::LANES - 1));
                let weight = S::gather(|lane| weights[lane]);
                let cell = Cell::of_corners(&self.gather(displacement, nodes), inverse);
                let affine = cell.determinant();
                least = least.min(cell.least_determinant());

                let mut forces = Cell { a: [zero; D], b: [zero; D], c: [zero; D] };
                let weights = weight * rest;
                energy += volume.planar::<S, D, 3, ORDER>(weights, &gauss, &cell, &affine, &mut forces);
                if self.functional.vertex_share > 0.0 {
                    let weights = weight * share;
                    energy += volume.planar::<S, D, 2, ORDER>(weights, &vertices, &cell, &affine, &mut forces);
                }
                if ORDER >= GRADIENT {
                    self.scatter(&forces.corner_forces(inverse), nodes, gradient);
                }
            }
            if least.least() <= 0.0 {
                break;
            }
        }
        energies.volume = energy.sum();
        least.least()
    }

    /// What [`spatial_hessian_pass`](Self::spatial_hessian_pass) adds, for D = 2.
    pub(super) fn planar_hessian_pass<const C: usize>(&self, displacement: &[f64], operator: &mut StencilOperator<D>) {
        let volume = Volume(self.functional.material);
        let (cells, side) = (self.grid.cells() as f64, self.grid.side());
        let line: Line<F32x4, 2> = Line::of(&self.gauss2);
        for (row, weights) in self.volume_weight.chunks_exact(self.grid.cells()).enumerate() {
            for (pack, weights) in weights.chunks_exact(F32x4::LANES).enumerate() {
                let base = row * side + pack * F32x4::LANES;
                // Differences are taken before the numbers are rounded.
                let edges = |low: usize, high: usize| -> Vector<F32x4, D> {
                    let [low, high] =
                        [low, high].map(|offset| &displacement[(base + offset) * D..][..F32x4::LANES * D]);
                    std::array::from_fn(|k| F32x4::gather(|lane| (high[lane * D + k] - low[lane * D + k]) * cells))
                };
                let cell = Cell::of_edges(&edges(0, 1), &edges(side, side + 1), &edges(0, side), &edges(1, side + 1));
                let scaled = F32x4::gather(|lane| weights[lane] * cells * cells);
                let mut pairs: Pairs<F32x4, D, C> = [[[[F32x4::zero(); D]; D]; C]; C];
                add_cell_pairs(&volume, scaled, &line, &cell, &mut pairs);
                for (a, place) in self.corner_places::<C>(base).into_iter().enumerate() {
                    for b in a..C {
                        operator.add_lanes(place, self.corner_neighbours[a][b], &pairs[a][b]);
                    }
                }
                self.stiffen_corners::<F32x4, C>(cell.least_determinant(), base, weights, displacement, operator);
            }
        }
    }
}

impl Volume {
    /// The energy of a pack of cells by the rule with this line; adds forces.
    #[inline(always)]
    fn planar<S: Scalar, const D: usize, const M: usize, const ORDER: u8>(
        &self,
        weight: S,
        line: &Line<S, M>,
        cell: &Cell<S, D>,
        affine: &[S; 3],
        forces: &mut Cell<S, D>,
    ) -> S {
        let material = &self.0;
        let (zero, half_mu) = (S::zero(), S::splat(0.5 * material.mu));
        let along: [S; M] = std::array::from_fn(|i| line.place[i] * affine[1]);
        let mut dilation = zero;
        // Of ∂g/∂det: the mean and the first moments.
        let (mut mean, mut by_t, mut columns) = (zero, zero, [zero; M]);
        for j in 0..M {
            let start = affine[0] + line.place[j] * affine[2];
            let (mut sum, mut slopes) = (zero, zero);
            for i in 0..M {
                let det = start + along[i];
                let (g, slope, _) = material.dilation(det * det);
                sum += line.weight[i] * g;
                if ORDER >= GRADIENT {
                    let slope = line.weight[i] * (det * slope);
                    slopes += slope;
                    columns[i] += line.weight[j] * slope;
                }
            }
            dilation += line.weight[j] * sum;
            let slopes = line.weight[j] * slopes;
            mean += slopes;
            by_t += line.place[j] * slopes;
        }
        let Cell { a, b, c } = cell;
        // |Dφ|² integrates to |a|² + |b|² + 2⟨s²⟩|c|².
        let moment = line.second_moment() + line.second_moment();
        if ORDER >= GRADIENT {
            let mut by_s = zero;
            for i in 0..M {
                by_s += line.place[i] * columns[i];
            }
            let twice = weight + weight;
            let [mean, by_s, by_t] = [mean, by_s, by_t].map(|moment| twice * moment);
            let mu = weight * S::splat(material.mu);
            let on_a = turned(&combined(mean, b, by_s, c));
            let on_b = turned(&combined(mean, a, by_t, c));
            let on_c = turned(&combined(by_t, b, -by_s, a));
            for k in 0..D {
                forces.a[k] += mu * a[k] + on_a[k];
                forces.b[k] += mu * b[k] - on_b[k];
                forces.c[k] += mu * moment * c[k] + on_c[k];
            }
        }
        weight * (half_mu * (dot(a, a) + dot(b, b) + moment * dot(c, c)) + dilation)
    }
}

/// Adds the hessian of a pack of cells: by (a, b, c) first, then handed to the corners from both sides.
#[inline(always)]
fn add_cell_pairs<T: Scalar, const D: usize, const C: usize>(
    volume: &Volume,
    weight: T,
    line: &Line<T, 2>,
    cell: &Cell<T, D>,
    pairs: &mut Pairs<T, D, C>,
) {
    // Two Gauss points an axis, at ∓o with one weight for all.
    let o = line.place[1];
    let weight = weight * (line.weight[0] * line.weight[1]);
    let at = |s: T, t: T| {
        let mut slots = [cell.a; D];
        slots[0] = add_scaled(&cell.a, t, &cell.c);
        slots[1] = add_scaled(&cell.b, s, &cell.c);
        let mut response = Response::zero();
        volume.add::<T, HESSIAN>(weight, &Point::of_derivative(slots), &mut response);
        let [[aa, ab, ..], [_, bb, ..], ..] = response.hessian;
        [aa, ab, bb]
    };
    let points = [at(-o, -o), at(o, -o), at(-o, o), at(o, o)];
    // The sum over the points of a pair of slots, and its moments by s/o, t/o and st/o².
    let moments = |pair: usize, k: usize, l: usize| {
        let [x, y, z, w] = points.each_ref().map(|hessians| hessians[pair][k][l]);
        let (low, high, left, right) = (x + y, z + w, y - x, w - z);
        [low + high, left + right, high - low, right - left]
    };
    // Corners move a and b by half of what they move along.
    let (quarter, half_o, squared) = (T::splat(0.25), T::splat(0.5) * o, o * o);
    let mut hessian = [[[[T::zero(); D]; D]; 3]; 3];
    for k in 0..D {
        for l in 0..D {
            let (aa, ab, bb, ba) = (moments(0, k, l), moments(1, k, l), moments(2, k, l), moments(1, l, k));
            hessian[0][0][k][l] = quarter * aa[0];
            hessian[0][1][k][l] = quarter * ab[0];
            hessian[1][1][k][l] = quarter * bb[0];
            hessian[0][2][k][l] = half_o * (aa[2] + ab[1]);
            hessian[1][2][k][l] = half_o * (ba[2] + bb[1]);
            hessian[2][2][k][l] = squared * (aa[0] + bb[0] + ab[3] + ba[3]);
        }
    }
    for (p, q) in [(0, 1), (0, 2), (1, 2)] {
        hessian[q][p] = transposed(&hessian[p][q]);
    }
    for k in 0..D {
        for l in 0..D {
            let mut moved = [[T::zero(); 4]; 3];
            for p in 0..3 {
                moved[p] = to_corners(hessian[p][0][k][l], hessian[p][1][k][l], hessian[p][2][k][l]);
            }
            for second in 0..C {
                let column = to_corners(moved[0][second], moved[1][second], moved[2][second]);
                for first in 0..C {
                    if first <= second {
                        pairs[first][second][k][l] += column[first];
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::distance::SignedDistance;
    use crate::grid::Grid;
    use crate::settings::Settings;
    use crate::small::F64x2;

    /// A level's assembler of two discs, and a displacement with all modes of a cell in it, far from a fold.
    fn example(vertex_share: f64) -> (CpuAssembler<2, F64x2>, Vec<f64>) {
        let grid = Grid::<2>::of_level(4);
        let disc = |radius: f64| {
            let distance = |node| {
                let [x, y] = grid.position(node);
                (x - 0.5_f64).hypot(y - 0.5) - radius
            };
            SignedDistance::from_nodal(grid, (0..grid.node_count()).map(distance).collect())
        };
        let functional = crate::energy::Functional { vertex_share, ..Settings::default().functional(4) };
        let displacement = (0..grid.node_count() * 2).map(|k| 0.015 * (1.7 * (k * k) as f64).sin()).collect();
        (CpuAssembler::new(&functional, &disc(0.2), &disc(0.25)), displacement)
    }

    fn close(a: f64, b: f64, size: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance * size, "{a} is not {b}");
    }

    #[test]
    fn energy_gradient_and_determinant_are_those_of_the_general_pass() {
        for vertex_share in [0.0, 0.25] {
            let (assembler, displacement) = example(vertex_share);
            let pass = |planar: bool| {
                let (mut gradient, mut energies) = (vec![0.0; displacement.len()], Energies::default());
                let least = if planar {
                    assembler.planar_volume_pass::<GRADIENT>(&displacement, &mut gradient, &mut energies)
                } else {
                    assembler.volume_pass::<GRADIENT, 3>(&assembler.gauss3, &displacement, &mut gradient, &mut energies)
                };
                (least, energies.volume, gradient)
            };
            let (found, expected) = (pass(true), pass(false));
            assert!(expected.0 > 0.2 && expected.0 < 0.8, "bent, not folded: {}", expected.0);
            close(found.0, expected.0, 1.0, 1e-14);
            close(found.1, expected.1, expected.1, 1e-13);
            let size = expected.2.iter().fold(0.0_f64, |most, g| most.max(g.abs()));
            found.2.iter().zip(&expected.2).for_each(|(a, b)| close(*a, *b, size, 1e-12));
        }
    }

    #[test]
    fn the_hessian_is_that_of_the_general_pass() {
        let (assembler, displacement) = example(0.0);
        let [mut found, mut expected] = [0, 1].map(|_| StencilOperator::zero(assembler.grid));
        assembler.planar_hessian_pass::<4>(&displacement, &mut found);
        assembler.volume_hessian_pass::<f64, 4>(&displacement, &mut expected);
        let size = expected.numbers().fold(0.0_f32, |most, x| most.max(x.abs()));
        let pairs = found.numbers().zip(expected.numbers());
        pairs.for_each(|(a, b)| close(a.into(), b.into(), size.into(), 1e-5));
    }
}
