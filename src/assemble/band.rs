//! What the shell terms need of both shapes, prepared once a level.

use super::jets::{Cell, Jets};
use crate::distance::SignedDistance;
use crate::energy::{Functional, GRADIENT, ReferenceJet, TemplateJet};
use crate::field::CornerWeights;
use crate::grid::Grid;
use crate::quadrature::Rule;
use crate::small::{Scalar, Vector, dot, frame, frobenius, normal_to};
use std::ops::Range;

/// The cells that the band η(d1/σ) > 0 meets, in packs of one cell a lane, with the reference's jets at their
/// quadrature points.
pub(super) struct Band<S, const D: usize> {
    /// Lowest nodes of a pack's cells, one a lane.
    pub packs: Vec<[usize; 2]>,
    /// Where the packs of each layer of cells begin, and where those of the last end. The plane is one layer.
    layers: Vec<usize>,
    /// `ReferenceSample`s, flattened: pack by pack, point by point.
    pub samples: Vec<S>,
}

/// The reference at one quadrature point of a pack.
pub(super) struct ReferenceSample<S, const D: usize> {
    /// η times the quadrature weight.
    pub weight: S,
    /// Tangents and, last, the normal, by rows.
    pub frame: [Vector<S, D>; D],
    pub jet: ReferenceJet<S, D>,
}

impl<S: Scalar, const D: usize> Band<S, D> {
    /// weight, distance, off-tangential, trace, steepness; D−1 tangents; the upper triangle of the curvature.
    const STRIDE: usize = 5 + (D - 1) * D + (D - 1) * D / 2;

    pub fn new<const M: usize>(functional: &Functional, reference: &SignedDistance<D>, rule: &Rule<D, M>) -> Self {
        let points = Rule::<D, M>::POINTS;
        let grid = reference.grid();
        let jets = Jets::new(reference, functional.fit_radius);
        let offsets = grid.corner_offsets();
        let volume = grid.spacing().powi(D as i32);
        let candidates: Vec<usize> = (0..grid.cell_count())
            .filter(|&cell| {
                let base = grid.lowest_node(cell);
                let values = || (0..Grid::<D>::CORNERS).map(|corner| reference.values()[base + offsets[corner]]);
                // The interpolant lies between its nodal values.
                let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
                low < functional.bandwidth && high > -functional.bandwidth
            })
            .collect();

        let per_cell = points * Self::STRIDE;
        let layers = Self::layer_count(grid);
        let most = candidates.len() / S::LANES + layers;
        let (packs, samples) = (Vec::with_capacity(most), Vec::with_capacity(most * per_cell));
        let mut band = Self { packs, layers: vec![0], samples };
        // Of the cells of a pack that is not full yet.
        let (mut nodes, mut rows): (Vec<usize>, Vec<f64>) = (Vec::new(), Vec::with_capacity(S::LANES * per_cell));
        let mut begun = 0;
        for layer in 0..layers {
            let end = candidates.partition_point(|&cell| cell < (layer + 1) * (grid.cell_count() / layers));
            for cell in &candidates[begun..end] {
                let first = rows.len();
                let jet = jets.cell(grid.cell_index(*cell));
                let mut touched = false;
                for point in 0..points {
                    let mut value = 0.0;
                    let mut gradient = [0.0; D];
                    let mut curvature = [[0.0; D]; D];
                    for corner in 0..Grid::<D>::CORNERS {
                        let (share, row) = (rule.shape[point][corner], jets.corner(jet, corner));
                        value += share * row[0];
                        let mut k = 1 + D;
                        for a in 0..D {
                            gradient[a] += share * row[1 + a];
                            for b in a..D {
                                curvature[a][b] += share * row[k];
                                k += 1;
                            }
                        }
                    }
                    for a in 0..D {
                        for b in 0..a {
                            curvature[a][b] = curvature[b][a];
                        }
                    }
                    let weight = functional.cutoff.weight(value / functional.bandwidth) * rule.weight[point] * volume;
                    touched |= weight > 0.0;
                    push_sample(&mut rows, weight, value, gradient, &curvature);
                }
                if !touched {
                    rows.truncate(first);
                    continue;
                }
                nodes.push(grid.lowest_node(*cell));
                if nodes.len() == S::LANES {
                    band.push_pack(&mut nodes, &mut rows);
                }
            }
            if !nodes.is_empty() {
                band.push_pack(&mut nodes, &mut rows);
            }
            begun = end;
            band.layers.push(band.packs.len());
        }
        band
    }

    /// Layers of cells that are gone through one after the other.
    pub fn layer_count(grid: Grid<D>) -> usize {
        if D == 3 { grid.cells() } else { 1 }
    }

    /// The lowest nodes of a layer's cells, and others.
    pub fn layer_nodes(grid: Grid<D>, layer: usize) -> Range<usize> {
        let count = if D == 3 { grid.stride(D - 1) } else { grid.node_count() };
        layer * count..(layer + 1) * count
    }

    /// The packs of a layer.
    pub fn layer(&self, layer: usize) -> Range<usize> {
        self.layers[layer]..self.layers[layer + 1]
    }

    /// Adds cells by their lowest nodes and their samples one after the other, and empties both. A layer's last pack that is not full repeats its
    /// last cell, without weight.
    fn push_pack(&mut self, nodes: &mut Vec<usize>, rows: &mut Vec<f64>) {
        let (last, per_cell) = (nodes.len() - 1, rows.len() / nodes.len());
        self.packs.push(std::array::from_fn(|lane| nodes[lane.min(last)]));
        self.samples.extend((0..per_cell).map(|k| {
            S::gather(|lane| {
                let is_spare = lane > last && k % Self::STRIDE == 0;
                if is_spare { 0.0 } else { rows[lane.min(last) * per_cell + k] }
            })
        }));
        nodes.clear();
        rows.clear();
    }

    /// With M points an axis, as it was made.
    #[inline(always)]
    pub fn pack_samples<const M: usize>(&self, pack: usize) -> &[S] {
        let count = Rule::<D, M>::POINTS * Self::STRIDE;
        &self.samples[pack * count..][..count]
    }
}

fn push_sample<const D: usize>(
    row: &mut Vec<f64>,
    weight: f64,
    distance: f64,
    gradient: [f64; D],
    curvature: &[[f64; D]; D],
) {
    let length = dot(&gradient, &gradient).sqrt();
    // On the skeleton the gradient vanishes and no direction is right: any unit vector serves.
    let normal = if length > 1e-12 {
        gradient.map(|g| g / length)
    } else {
        std::array::from_fn(|k| if k == 0 { 1.0 } else { 0.0 })
    };
    let tangents = frame(&normal);
    let along = |i: usize, j: usize| -> f64 {
        (0..D).map(|a| (0..D).map(|b| tangents[i][a] * curvature[a][b] * tangents[j][b]).sum::<f64>()).sum()
    };
    let mut tangential = 0.0;
    for i in 0..D - 1 {
        for j in 0..D - 1 {
            tangential += along(i, j).powi(2);
        }
    }
    let trace = (0..D).map(|k| curvature[k][k]).sum();
    row.extend([weight, distance, frobenius(curvature) - tangential, trace, length]);
    for tangent in tangents.iter().take(D - 1) {
        row.extend_from_slice(tangent);
    }
    for i in 0..D - 1 {
        for j in i..D - 1 {
            row.push(along(i, j));
        }
    }
}

impl<S: Scalar, const D: usize> ReferenceSample<S, D> {
    #[inline(always)]
    pub fn read(samples: &[S], point: usize) -> Self {
        let row = &samples[point * Band::<S, D>::STRIDE..][..Band::<S, D>::STRIDE];
        let zero = S::zero();
        let mut frame = [[zero; D]; D];
        let mut curvature = [[zero; D]; D];
        let mut k = 5;
        for tangent in frame.iter_mut().take(D - 1) {
            for t in tangent.iter_mut() {
                *t = row[k];
                k += 1;
            }
        }
        for i in 0..D - 1 {
            for j in i..D - 1 {
                curvature[i][j] = row[k];
                curvature[j][i] = row[k];
                k += 1;
            }
        }
        frame[D - 1] = normal_to(&frame);
        let jet =
            ReferenceJet { distance: row[1], curvature, off_tangential: row[2], trace: row[3], steepness: row[4] };
        Self { weight: row[0], frame, jet }
    }
}

/// The template's distance and fitted second derivative, to be sampled anywhere.
pub(super) struct TemplateField<const D: usize> {
    pub jets: Jets<D>,
}

impl<const D: usize> TemplateField<D> {
    pub fn new(template: &SignedDistance<D>, fit_radius: f64) -> Self {
        Self { jets: Jets::new(template, fit_radius) }
    }

    /// The jet at a point a lane. Beyond the box the distance goes on as the boundary cell's polynomial, while the
    /// second derivative keeps its value at the nearest point of the box: extrapolated second derivatives grow wild.
    #[inline(always)]
    pub fn sample<S: Scalar, const ORDER: u8>(&self, point: &Vector<S, D>) -> TemplateJet<S, D> {
        let (zero, one) = (S::zero(), S::splat(1.0));
        let cells = S::splat(self.jets.grid().cells() as f64);
        let last = cells - S::splat(0.5);
        let mut places = [[0; D]; 2];
        let mut local = [zero; D];
        let mut beyond = zero;
        for axis in (0..D).rev() {
            let scaled = point[axis] * cells;
            // Rounded down this is the cell, the last one for its upper end.
            let held = scaled.max(zero).min(last);
            let index = |lane| held.lane(lane) as i32;
            for (lane, place) in places.iter_mut().enumerate().take(S::LANES) {
                place[axis] = index(lane) as usize;
            }
            local[axis] = scaled - S::gather(|lane| f64::from(index(lane)));
            beyond += local[axis].max(one) - one - local[axis].min(zero);
        }
        // Not a number is beyond, too.
        let outside = beyond.sum() != 0.0;
        let weights = CornerWeights::at(&local);
        let (clamped, inside) = if outside {
            let inside = std::array::from_fn(|axis| {
                S::gather(|lane| if (0.0..=1.0).contains(&local[axis].lane(lane)) { 1.0 } else { 0.0 })
            });
            (CornerWeights::at(&local.map(|x| x.max(zero).min(one))), inside)
        } else {
            (weights, [one; D])
        };

        let mut jet = TemplateJet {
            distance: zero,
            gradient: [zero; D],
            normal: [zero; D],
            normal_slope: [[zero; D]; D],
            curvature: [[zero; D]; D],
            curvature_slope: [[[zero; D]; D]; D],
        };
        let found: [Cell<'_>; 2] = std::array::from_fn(|lane| self.jets.cell(places[lane.min(S::LANES - 1)]));
        for corner in 0..Grid::<D>::CORNERS {
            let rows = found.map(|cell| self.jets.corner(cell, corner));
            let distance = S::gather(|lane| rows[lane][0]);
            jet.distance += weights.value[corner] * distance;
            if ORDER >= GRADIENT {
                for axis in 0..D {
                    jet.gradient[axis] += weights.derivative[corner][axis] * distance;
                }
            }
            for a in 0..D {
                let entry = S::gather(|lane| rows[lane][1 + a]);
                jet.normal[a] += clamped.value[corner] * entry;
                if ORDER >= GRADIENT {
                    for axis in 0..D {
                        jet.normal_slope[axis][a] += clamped.derivative[corner][axis] * entry;
                    }
                }
            }
            let mut k = 1 + D;
            for a in 0..D {
                for b in a..D {
                    let entry = S::gather(|lane| rows[lane][k]);
                    jet.curvature[a][b] += clamped.value[corner] * entry;
                    if ORDER >= GRADIENT {
                        for axis in 0..D {
                            jet.curvature_slope[axis][a][b] += clamped.derivative[corner][axis] * entry;
                        }
                    }
                    k += 1;
                }
            }
        }
        for a in 0..D {
            for b in a..D {
                jet.curvature[b][a] = jet.curvature[a][b];
            }
        }
        if ORDER >= GRADIENT {
            for axis in 0..D {
                jet.gradient[axis] = jet.gradient[axis] * cells;
                let scale = cells * inside[axis];
                for a in 0..D {
                    jet.normal_slope[axis][a] = jet.normal_slope[axis][a] * scale;
                    for b in a..D {
                        jet.curvature_slope[axis][a][b] = jet.curvature_slope[axis][a][b] * scale;
                        jet.curvature_slope[axis][b][a] = jet.curvature_slope[axis][a][b];
                    }
                }
            }
        }
        jet
    }
}
