//! Points that are tied together, each in the cell where it lies.

use super::CpuAssembler;
use crate::energy::{Energies, GRADIENT, HESSIAN, Pin};
use crate::field::CornerWeights;
use crate::grid::{Grid, MAX_CORNERS};
use crate::small::Scalar;
use crate::stencil::StencilOperator;
use std::ops::Range;

/// A pin on the grid.
pub(in crate::assemble) struct Placed<const D: usize> {
    /// Lowest node of its cell, and the corners' shares in φ(p).
    pub base: usize,
    pub shares: [f64; MAX_CORNERS],
    /// p − q: what is left of φ(p) − q where u vanishes.
    pub offset: [f64; D],
    /// w σ²/ε.
    pub weight: f64,
}

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// Ties points together, in addition to those tied before, with a weight in units of the penalty. Without weight
    /// nothing happens.
    pub fn tie(&mut self, pins: &[Pin<D>], weight: f64) {
        let weight = weight * self.functional.penalty * self.functional.bandwidth.powi(2);
        if weight == 0.0 {
            return;
        }
        self.pins.extend(pins.iter().map(|pin| {
            let (cell, local) = self.grid.locate(&pin.reference);
            Placed {
                base: self.grid.node(cell),
                shares: CornerWeights::at(&local).value,
                offset: std::array::from_fn(|k| pin.reference[k] - pin.template[k]),
                weight,
            }
        }));
    }

    /// [`pins_pass`](Self::pins_pass), for an assembler that computes all else.
    #[cfg(feature = "gpu")]
    pub(in crate::assemble) fn add_pins<const ORDER: u8>(
        &self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut Option<&mut StencilOperator<D>>,
        energies: &mut Energies,
    ) {
        match D {
            2 => self.pins_pass::<ORDER, 4>(0..self.grid.node_count(), displacement, gradient, operator, energies),
            _ => self.pins_pass::<ORDER, 8>(0..self.grid.node_count(), displacement, gradient, operator, energies),
        }
    }

    /// The energy of the pins in cells whose lowest node is among these.
    pub(super) fn pins_pass<const ORDER: u8, const C: usize>(
        &self,
        nodes: Range<usize>,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut Option<&mut StencilOperator<D>>,
        energies: &mut Energies,
    ) {
        let offsets = self.grid.corner_offsets();
        for Placed { base, shares, offset, weight } in self.pins.iter().filter(|pin| nodes.contains(&pin.base)) {
            let mut residual = *offset;
            for corner in 0..Grid::<D>::CORNERS {
                for (k, r) in residual.iter_mut().enumerate() {
                    *r += shares[corner] * displacement[(base + offsets[corner]) * D + k];
                }
            }
            energies.pins += weight * residual.iter().map(|r| r * r).sum::<f64>();
            if ORDER >= GRADIENT {
                for corner in 0..Grid::<D>::CORNERS {
                    for (k, r) in residual.iter().enumerate() {
                        gradient[(base + offsets[corner]) * D + k] += 2.0 * weight * shares[corner] * r;
                    }
                }
            }
            if ORDER >= HESSIAN
                && let Some(operator) = operator
            {
                let places = self.corner_places::<C>(*base);
                for a in 0..C {
                    for b in a..C {
                        let entry = (2.0 * weight * shares[a] * shares[b]) as f32;
                        let block = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { entry } else { 0.0 }));
                        operator.add(places[a], self.corner_neighbours[a][b], &block);
                    }
                }
            }
        }
    }
}
