//! Membrane, bending and mismatch, over the cells of the band.

use super::CpuAssembler;
use super::element::{
    MAX_COLUMNS, MAX_EDGES, Pairs, columns_of, edge_differences, edge_forces_to_corners, slots_at, stress_to_edges,
};
use super::modes::PointHessians;
use crate::assemble::band::ReferenceSample;
use crate::energy::{GRADIENT, HESSIAN, MAX_SLOTS, Point, Response, normal_slot, position_slot};
use crate::grid::{Grid, MAX_CORNERS};
use crate::quadrature::{Rule, edge_ends};
use crate::small::{Scalar, Vector, add_scaled};
use crate::stencil::StencilOperator;
use std::ops::Range;

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// Membrane, bending and mismatch over packs of the band's cells; adds to the sums of their densities.
    pub(super) fn shell_pass<const ORDER: u8, const C: usize, const M: usize>(
        &self,
        rule: &Rule<D, M>,
        packs: Range<usize>,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut Option<&mut StencilOperator<D>>,
        sums: &mut [S; 3],
    ) {
        let (spacing, inverse) = (S::splat(self.grid.spacing()), S::splat(self.grid.cells() as f64));
        // Where two points an axis suffice, what they have is integrated together.
        let by_modes = D == 3 && M == 2;
        let mut hessians = PointHessians::<S, D, C>::zero();
        for pack in packs {
            let nodes = self.band.packs[pack];
            let corners = self.gather(displacement, nodes);
            let edges = edge_differences(&corners, inverse);
            let columns = columns_of(rule, &edges);
            let samples = self.band.pack_samples::<M>(pack);
            let indices = nodes.map(|node| self.grid.node_index(node));
            let origin: Vector<S, D> = std::array::from_fn(|k| S::gather(|lane| indices[lane][k] as f64) * spacing);

            let mut stress = [[[S::zero(); D]; MAX_COLUMNS]; D];
            let mut corner_forces = [[S::zero(); D]; MAX_CORNERS];
            let mut pairs = [[[[S::zero(); D]; D]; C]; C];
            for point in 0..Rule::<D, M>::POINTS {
                let sample = ReferenceSample::<S, D>::read(samples, point);
                let derivative = slots_at(rule, &columns, point);
                let mut moved = origin;
                for corner in 0..Grid::<D>::CORNERS {
                    let shape = S::splat(rule.shape[point][corner]);
                    for k in 0..D {
                        let at = if corner >> k & 1 == 1 { corners[corner][k] + spacing } else { corners[corner][k] };
                        moved[k] += shape * at;
                    }
                }
                let mut slots = [[S::zero(); D]; MAX_SLOTS];
                slots[position_slot::<D>()] = moved;
                for i in 0..D {
                    for (k, column) in derivative.iter().enumerate() {
                        slots[i] = add_scaled(&slots[i], sample.frame[i][k], column);
                    }
                }
                let template = self.template.sample::<S, ORDER>(&moved);
                let mut response = Response::zero();
                let densities = self.functional.shell::<S, D, ORDER>(
                    sample.weight,
                    &Point { slots, reference: sample.jet, template },
                    &mut response,
                );
                for (sum, density) in sums.iter_mut().zip(densities) {
                    *sum += density;
                }
                if ORDER >= GRADIENT {
                    for (k, stress) in stress.iter_mut().enumerate() {
                        let column = &mut stress[rule.column[point][k]];
                        for i in 0..D {
                            *column = add_scaled(column, sample.frame[i][k], &response.gradient[i]);
                        }
                    }
                    for corner in 0..Grid::<D>::CORNERS {
                        let shape = S::splat(rule.shape[point][corner]);
                        let force = &response.gradient[position_slot::<D>()];
                        corner_forces[corner] = add_scaled(&corner_forces[corner], shape, force);
                    }
                }
                if ORDER >= HESSIAN {
                    if by_modes {
                        hessians.put(point, &sample.frame, &response, self.grid.cells() as f64);
                    } else {
                        add_point_pairs(rule, &mut pairs, point, &sample.frame, &response, inverse);
                    }
                }
            }
            if ORDER >= GRADIENT {
                let mut forces = [[[S::zero(); D]; MAX_EDGES]; D];
                stress_to_edges(rule, &stress, &mut forces);
                edge_forces_to_corners(&forces, inverse, &mut corner_forces);
                self.scatter(&corner_forces, nodes, gradient);
            }
            if ORDER >= HESSIAN
                && let Some(operator) = operator
            {
                if by_modes {
                    hessians.integrate(&mut pairs);
                }
                self.scatter_pairs(&pairs, |lane| nodes[lane], operator);
            }
        }
    }
}

/// pairs[a][b] += Σ_pq s_ap s_bq H_pq with the slots' shape values s_ai = ∇N_a·t_i, s_an = ∇N_a·n and s_ay = N_a.
#[inline(always)]
pub(super) fn add_point_pairs<S: Scalar, const D: usize, const C: usize, const M: usize>(
    rule: &Rule<D, M>,
    pairs: &mut Pairs<S, D, C>,
    point: usize,
    frame: &[Vector<S, D>; D],
    response: &Response<S, D>,
    inverse: S,
) {
    // No term couples the tangents with the normal. Loops of known length come apart and leave no arrays in memory.
    let normal = normal_slot::<D>();
    let coupled = |p: usize, q: usize| (p == normal) == (q == normal) || p > normal || q > normal;
    let mut values = [[S::zero(); MAX_SLOTS]; C];
    for axis in 0..D {
        for edge in 0..Rule::<D, M>::EDGES {
            let slope = inverse * S::splat(rule.edge[rule.column[point][axis]][edge]);
            let (low, high) = edge_ends(axis, edge);
            for i in 0..D {
                let along = slope * frame[i][axis];
                values[high][i] += along;
                values[low][i] -= along;
            }
        }
    }
    for corner in 0..Grid::<D>::CORNERS {
        values[corner][position_slot::<D>()] = S::splat(rule.shape[point][corner]);
    }
    for b in 0..C {
        // moved[p] = Σ_q s_bq H_pq
        let mut moved = [[[S::zero(); D]; D]; MAX_SLOTS];
        for p in 0..D + 1 {
            for q in 0..D + 1 {
                if !coupled(p, q) {
                    continue;
                }
                for i in 0..D {
                    for j in 0..D {
                        let entry = if p <= q { response.hessian[p][q][i][j] } else { response.hessian[q][p][j][i] };
                        moved[p][i][j] += values[b][q] * entry;
                    }
                }
            }
        }
        for a in 0..C {
            if a > b {
                continue;
            }
            for p in 0..D + 1 {
                for i in 0..D {
                    for j in 0..D {
                        pairs[a][b][i][j] += values[a][p] * moved[p][i][j];
                    }
                }
            }
        }
    }
}
