//! The inverse at any points: first the cell whose image holds the point, then the place in it.

use crate::field::{interpolate, interpolate_derivative};
use crate::grid::{Grid, MAX_CORNERS};
use crate::small::{Matrix, apply, cofactor, dot};

/// Newton steps in one cell; its polynomial is smooth, so that a few are the rule.
const MAX_STEPS: usize = 50;
/// The residual, in cells, at which a preimage is found, and how far beyond its cell it may lie.
const ACCURACY: f64 = 1e-11;
const MARGIN: f64 = 1e-9;

/// φ⁻¹ for an admissible φ = x + u.
pub struct Inverse<'a, const D: usize> {
    grid: Grid<D>,
    displacement: &'a [f64],
    /// The box around φ's image, in as many bins a side as the grid has cells.
    low: [f64; D],
    per_length: [f64; D],
    /// The cells whose image may meet bin b: `cells[starts[b]..starts[b + 1]]`.
    starts: Vec<u32>,
    cells: Vec<u32>,
}

impl<'a, const D: usize> Inverse<'a, D> {
    pub fn new(grid: Grid<D>, displacement: &'a [f64]) -> Self {
        let image = |node: usize| -> [f64; D] {
            let x = grid.position(node);
            std::array::from_fn(|k| x[k] + displacement[node * D + k])
        };
        let widen = |(low, high): ([f64; D], [f64; D]), y: [f64; D]| {
            (std::array::from_fn(|k| low[k].min(y[k])), std::array::from_fn(|k| high[k].max(y[k])))
        };
        let nothing = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
        let (low, high) = (0..grid.node_count()).map(image).fold(nothing, widen);
        let bins = grid.cells() as f64;
        let per_length = std::array::from_fn(|k| bins / (high[k] - low[k]).max(f64::MIN_POSITIVE));
        let mut inverse = Self { grid, displacement, low, per_length, starts: vec![], cells: vec![] };

        // A multilinear cell lies in the box around its corners.
        let offsets = grid.corner_offsets();
        let spans: Vec<_> = (0..grid.cell_count())
            .map(|cell| {
                let base = grid.lowest_node(cell);
                let (low, high) = offsets[..Grid::<D>::CORNERS].iter().map(|c| image(base + c)).fold(nothing, widen);
                [low, high].map(|corner| std::array::from_fn::<_, D, _>(|k| inverse.bin(corner[k], k)))
            })
            .collect();
        let mut starts = vec![0_u32; grid.cell_count() + 1];
        for span in &spans {
            for_bins(grid, span, |bin| starts[bin + 1] += 1);
        }
        for bin in 0..grid.cell_count() {
            starts[bin + 1] += starts[bin];
        }
        let mut cells = vec![0; starts[grid.cell_count()] as usize];
        let mut next = starts.clone();
        for (cell, span) in spans.iter().enumerate() {
            for_bins(grid, span, |bin| {
                cells[next[bin] as usize] = cell as u32;
                next[bin] += 1;
            });
        }
        (inverse.starts, inverse.cells) = (starts, cells);
        inverse
    }

    /// A preimage of a point; none outside the image of the box. There is one, unless the image lies over itself: no cell
    /// of a box that is much inflated need be folded for its margins to meet.
    pub fn at(&self, point: &[f64; D]) -> Option<[f64; D]> {
        let inside = |k: usize| {
            let place = (point[k] - self.low[k]) * self.per_length[k];
            (-MARGIN..=self.grid.cells() as f64 + MARGIN).contains(&place)
        };
        if !(0..D).all(inside) {
            return None;
        }
        let bin = self.grid.cell(std::array::from_fn(|k| self.bin(point[k], k)));
        let candidates = &self.cells[self.starts[bin] as usize..self.starts[bin + 1] as usize];
        candidates.iter().find_map(|&cell| self.within(cell as usize, point))
    }

    fn bin(&self, y: f64, axis: usize) -> usize {
        // The cast sends what lies below to the first bin.
        (((y - self.low[axis]) * self.per_length[axis]) as usize).min(self.grid.cells() - 1)
    }

    /// Newton's method on the polynomial of one cell, as a field on a grid of that one cell.
    fn within(&self, cell: usize, point: &[f64; D]) -> Option<[f64; D]> {
        let (one, scale) = (Grid::<D>::new(1), self.grid.cells() as f64);
        let (base, offsets) = (self.grid.lowest_node(cell), self.grid.corner_offsets());
        let origin = self.grid.position(base);
        // y of the corners in cells, from the cell's own corner on.
        let mut corners = [[0.0; D]; MAX_CORNERS];
        for (corner, y) in corners.iter_mut().enumerate().take(Grid::<D>::CORNERS) {
            let node = base + offsets[corner];
            let x = self.grid.position(node);
            *y = std::array::from_fn(|k| (x[k] + self.displacement[node * D + k] - origin[k]) * scale);
        }
        let corners = corners.as_flattened();
        let target: [f64; D] = std::array::from_fn(|k| (point[k] - origin[k]) * scale);
        let mut place = [0.5; D];
        let residual = |place: &[f64; D]| -> [f64; D] {
            let y = interpolate::<D, D>(one, corners, place);
            std::array::from_fn(|k| y[k] - target[k])
        };
        let mut defect = residual(&place);
        for _ in 0..MAX_STEPS {
            let square = dot(&defect, &defect);
            if square.sqrt() <= ACCURACY {
                break;
            }
            let jacobian = interpolate_derivative::<D, D>(one, corners, &place);
            let cof = cofactor(&jacobian);
            let det = dot(&jacobian[0], &cof[0]);
            let inverse: Matrix<f64, D> = std::array::from_fn(|i| std::array::from_fn(|j| cof[j][i] / det));
            let step = apply(&inverse, &defect);
            let mut length = 1.0;
            loop {
                let trial = std::array::from_fn(|k| place[k] - length * step[k]);
                let next = residual(&trial);
                if dot(&next, &next) < square {
                    (place, defect) = (trial, next);
                    break;
                }
                length *= 0.5;
                if length < 1e-4 {
                    // Rounding ends the descent, or the cell's polynomial does not reach the point.
                    return (square.sqrt() < MARGIN).then(|| self.position(&origin, &place)).flatten();
                }
            }
        }
        self.position(&origin, &place).filter(|_| dot(&defect, &defect).sqrt() < MARGIN)
    }

    fn position(&self, origin: &[f64; D], place: &[f64; D]) -> Option<[f64; D]> {
        let inside = place.iter().all(|t| (-MARGIN..=1.0 + MARGIN).contains(t));
        inside.then(|| std::array::from_fn(|k| origin[k] + place[k].clamp(0.0, 1.0) * self.grid.spacing()))
    }
}

fn for_bins<const D: usize>(grid: Grid<D>, [first, last]: &[[usize; D]; 2], mut visit: impl FnMut(usize)) {
    let count: usize = (0..D).map(|k| last[k] - first[k] + 1).product();
    for mut number in 0..count {
        let index = std::array::from_fn(|k| {
            let extent = last[k] - first[k] + 1;
            let i = first[k] + number % extent;
            number /= extent;
            i
        });
        visit(grid.cell(index));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn undoes<const D: usize>() {
        let grid = Grid::<D>::new(16);
        let displacement: Vec<f64> = (0..grid.node_count())
            .flat_map(|node| {
                let x = grid.position(node);
                std::array::from_fn::<f64, D, _>(|k| 0.06 * (9.0 * x[(k + 1) % D]).sin() + 0.3 * (x[k] - 0.4))
            })
            .collect();
        let inverse = Inverse::new(grid, &displacement);
        // Nodes, edges, the border and places in between.
        for number in 0..37_usize.pow(D as u32) {
            let x: [f64; D] = std::array::from_fn(|k| (number / 37_usize.pow(k as u32) % 37) as f64 / 36.0);
            let u = interpolate::<D, D>(grid, &displacement, &x);
            let found = inverse.at(&std::array::from_fn(|k| x[k] + u[k])).expect("a point of the image");
            for k in 0..D {
                assert!((found[k] - x[k]).abs() < 1e-9, "{found:?} is not {x:?}");
            }
        }
        for far in [-1.0, 1.9, 1e300, f64::NAN, f64::INFINITY] {
            assert_eq!(inverse.at(&[far; D]), None);
        }
    }

    #[test]
    fn the_inverse_undoes_the_deformation_everywhere_and_is_nowhere_else() {
        undoes::<2>();
        undoes::<3>();
    }

    #[test]
    fn where_the_image_lies_over_itself_a_point_has_a_preimage_still() {
        let grid = Grid::<2>::new(32);
        // A strip bent round by more than a whole turn.
        let turned = |[x, y]: [f64; 2]| {
            let (sin, cos) = (7.5 * x).sin_cos();
            [(1.0 + y) * cos, -(1.0 + y) * sin]
        };
        let displacement: Vec<f64> = (0..grid.node_count())
            .flat_map(|node| {
                let (x, y) = (grid.position(node), turned(grid.position(node)));
                [y[0] - x[0], y[1] - x[1]]
            })
            .collect();
        let inverse = Inverse::new(grid, &displacement);
        let mut twice = 0;
        for node in 0..grid.node_count() {
            let (x, y) = (grid.position(node), turned(grid.position(node)));
            let found = inverse.at(&y).expect("a point of the image");
            let u = interpolate::<2, 2>(grid, &displacement, &found);
            for k in 0..2 {
                assert!((found[k] + u[k] - y[k]).abs() < 1e-9, "{found:?} is not sent to {y:?}");
            }
            twice += usize::from((found[0] - x[0]).abs() > 0.5);
        }
        assert!(twice > 0, "the image lies over itself");
    }
}
