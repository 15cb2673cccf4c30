//! What the shell terms need of both shapes, prepared once a level.

use crate::distance::SignedDistance;
use crate::energy::{Functional, GRADIENT, ReferenceJet, TemplateJet};
use crate::field::{CornerWeights, quadratic_fit};
use crate::grid::{Grid, MAX_CORNERS};
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
        let jets = quadratic_fit(grid, reference.values(), functional.fit_radius);
        let offsets = grid.corner_offsets();
        let volume = grid.spacing().powi(D as i32);

        let mut cells = Vec::new();
        let mut rows: Vec<f64> = Vec::new();
        let mut cell_rows = Vec::with_capacity(points * Self::STRIDE);
        for cell in 0..grid.cell_count() {
            let base = grid.lowest_node(cell);
            let values = || (0..Grid::<D>::CORNERS).map(|corner| jets[base + offsets[corner]].value);
            // The interpolant lies between its nodal values.
            let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
            if low >= functional.bandwidth || high <= -functional.bandwidth {
                continue;
            }
            cell_rows.clear();
            let mut touched = false;
            for point in 0..points {
                let mut value = 0.0;
                let mut gradient = [0.0; D];
                let mut curvature = [[0.0; D]; D];
                for corner in 0..Grid::<D>::CORNERS {
                    let (share, jet) = (rule.shape[point][corner], &jets[base + offsets[corner]]);
                    value += share * jet.value;
                    for a in 0..D {
                        gradient[a] += share * jet.gradient[a];
                        for b in 0..D {
                            curvature[a][b] += share * jet.curvature[a][b];
                        }
                    }
                }
                let weight = functional.cutoff.weight(value / functional.bandwidth) * rule.weight[point] * volume;
                touched |= weight > 0.0;
                push_sample(&mut cell_rows, weight, value, gradient, &curvature);
            }
            if touched {
                cells.push(base);
                rows.extend_from_slice(&cell_rows);
            }
        }

        let per_cell = points * Self::STRIDE;
        let (mut packs, mut samples, mut layers) = (Vec::new(), Vec::new(), vec![0]);
        let mut first = 0;
        for layer in 0..Self::layer_count(grid) {
            let nodes = Self::layer_nodes(grid, layer);
            let end = first + cells[first..].partition_point(|base| nodes.contains(base));
            for pack in (first..end).step_by(S::LANES) {
                let lane_cell = |lane: usize| (pack + lane).min(end - 1);
                packs.push(std::array::from_fn(|lane| cells[lane_cell(lane)]));
                for k in 0..per_cell {
                    samples.push(S::gather(|lane| {
                        // A layer's last pack that is not full repeats its last cell, without weight.
                        let spare = pack + lane >= end && k % Self::STRIDE == 0;
                        if spare { 0.0 } else { rows[lane_cell(lane) * per_cell + k] }
                    }));
                }
            }
            first = end;
            layers.push(packs.len());
        }
        Self { packs, layers, samples }
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

/// The template's distance and fitted second derivative at the nodes, to be sampled anywhere.
pub(super) struct TemplateField<const D: usize> {
    grid: Grid<D>,
    offsets: [usize; MAX_CORNERS],
    /// By node: the distance, then the second derivative's upper triangle.
    pub values: Vec<f64>,
}

impl<const D: usize> TemplateField<D> {
    const STRIDE: usize = 1 + D + D * (D + 1) / 2;

    pub fn new(template: &SignedDistance<D>, fit_radius: f64) -> Self {
        let grid = template.grid();
        let mut values = Vec::with_capacity(grid.node_count() * Self::STRIDE);
        for jet in quadratic_fit(grid, template.values(), fit_radius) {
            values.push(jet.value);
            values.extend_from_slice(&jet.gradient);
            for a in 0..D {
                values.extend_from_slice(&jet.curvature[a][a..]);
            }
        }
        Self { grid, offsets: grid.corner_offsets(), values }
    }

    /// The jet at a point a lane. Beyond the box the distance goes on as the boundary cell's polynomial, while the
    /// second derivative keeps its value at the nearest point of the box: extrapolated second derivatives grow wild.
    #[inline(always)]
    pub fn sample<S: Scalar, const ORDER: u8>(&self, point: &Vector<S, D>) -> TemplateJet<S, D> {
        let (zero, one) = (S::zero(), S::splat(1.0));
        let cells = S::splat(self.grid.cells() as f64);
        let last = cells - S::splat(0.5);
        let mut base = [0; 2];
        let mut local = [zero; D];
        let mut beyond = zero;
        for axis in (0..D).rev() {
            let scaled = point[axis] * cells;
            // Rounded down this is the cell, the last one for its upper end.
            let held = scaled.max(zero).min(last);
            let index = |lane| held.lane(lane) as i32;
            for (lane, base) in base.iter_mut().enumerate().take(S::LANES) {
                *base = *base * self.grid.side() + index(lane) as usize;
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
        for corner in 0..Grid::<D>::CORNERS {
            let rows: [&[f64]; 2] = std::array::from_fn(|lane| {
                let lane = lane.min(S::LANES - 1);
                &self.values[(base[lane] + self.offsets[corner]) * Self::STRIDE..][..Self::STRIDE]
            });
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
