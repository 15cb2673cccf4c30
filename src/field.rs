//! Nodal fields: multilinear interpolation, its derivatives, and the local quadratic fit.

use crate::grid::{Grid, MAX_CORNERS};
use crate::small::{Matrix, Scalar, Vector};

/// Multilinear weights of the corners at a local coordinate, and their derivatives by the local coordinate.
#[derive(Clone, Copy)]
pub struct CornerWeights<S, const D: usize> {
    pub value: [S; MAX_CORNERS],
    pub derivative: [Vector<S, D>; MAX_CORNERS],
}

impl<S: Scalar, const D: usize> CornerWeights<S, D> {
    #[inline(always)]
    pub fn at(local: &Vector<S, D>) -> Self {
        let mut weights = Self { value: [S::zero(); MAX_CORNERS], derivative: [[S::zero(); D]; MAX_CORNERS] };
        let low: Vector<S, D> = local.map(|x| S::splat(1.0) - x);
        for corner in 0..Grid::<D>::CORNERS {
            let factor = |axis: usize| if corner >> axis & 1 == 1 { local[axis] } else { low[axis] };
            let mut product = factor(0);
            for axis in 1..D {
                product = product * factor(axis);
            }
            weights.value[corner] = product;
            for axis in 0..D {
                let mut slope = S::splat(if corner >> axis & 1 == 1 { 1.0 } else { -1.0 });
                for other in 0..D {
                    if other != axis {
                        slope = slope * factor(other);
                    }
                }
                weights.derivative[corner][axis] = slope;
            }
        }
        weights
    }
}

/// The multilinear interpolant of `COMPONENTS` interleaved nodal values at a point; beyond the box the
/// polynomial of the boundary cell goes on.
pub fn interpolate<const D: usize, const COMPONENTS: usize>(
    grid: Grid<D>,
    values: &[f64],
    point: &[f64; D],
) -> [f64; COMPONENTS] {
    let (cell, local) = grid.locate(point);
    let weights = CornerWeights::at(&local);
    let (base, offsets) = (grid.node(cell), grid.corner_offsets());
    let mut result = [0.0; COMPONENTS];
    for corner in 0..Grid::<D>::CORNERS {
        let node = base + offsets[corner];
        for (k, r) in result.iter_mut().enumerate() {
            *r += weights.value[corner] * values[node * COMPONENTS + k];
        }
    }
    result
}

/// The derivative of [`interpolate`], by rows: `result[component][axis]`.
pub fn interpolate_derivative<const D: usize, const COMPONENTS: usize>(
    grid: Grid<D>,
    values: &[f64],
    point: &[f64; D],
) -> [[f64; D]; COMPONENTS] {
    let (cell, local) = grid.locate(point);
    let weights = CornerWeights::at(&local);
    let (base, offsets) = (grid.node(cell), grid.corner_offsets());
    let mut result = [[0.0; D]; COMPONENTS];
    for corner in 0..Grid::<D>::CORNERS {
        let node = base + offsets[corner];
        for (k, row) in result.iter_mut().enumerate() {
            for (axis, r) in row.iter_mut().enumerate() {
                *r += weights.derivative[corner][axis] * values[node * COMPONENTS + k] * grid.cells() as f64;
            }
        }
    }
    result
}

/// Value, gradient and second derivative of a scalar field at a node, domain units.
#[derive(Clone, Copy, Debug)]
pub struct Jet<const D: usize> {
    pub value: f64,
    pub gradient: Vector<f64, D>,
    pub curvature: Matrix<f64, D>,
}

/// Gradients and second derivatives at all nodes, see [`QuadraticFit`].
///
/// # Panics
/// As [`QuadraticFit::new`], or if there is not one value a node.
pub fn quadratic_fit<const D: usize>(grid: Grid<D>, values: &[f64], radius: f64) -> Vec<Jet<D>> {
    assert_eq!(values.len(), grid.node_count());
    let fit = QuadraticFit::new(grid, radius);
    (0..grid.node_count()).map(|node| fit.at(values, grid.node_index(node))).collect()
}

/// Gradients and second derivatives at nodes by a least-squares quadratic over the neighbours within some cells.
///
/// The polynomial c + g·o + ½ o·H·o is fitted, unweighted, to the values at all integer offsets |o| ≤ radius.
/// Near the boundary the stencil's centre moves inside and the polynomial is differentiated at the node.
/// `value` stays the nodal value, not the polynomial's.
pub struct QuadraticFit<const D: usize> {
    grid: Grid<D>,
    reach: usize,
    stencil: Stencil<D>,
    strides: Vec<isize>,
}

impl<const D: usize> QuadraticFit<D> {
    /// # Panics
    /// If the stencil does not determine a quadratic (radius < √2) or does not fit the grid.
    pub fn new(grid: Grid<D>, radius: f64) -> Self {
        let reach = radius.floor() as usize;
        assert!(2 * reach <= grid.cells(), "the stencil does not fit {} cells", grid.cells());
        let stencil = Stencil::<D>::new(radius);
        let strides =
            stencil.offsets.iter().map(|o| (0..D).map(|axis| o[axis] * grid.stride(axis) as isize).sum()).collect();
        Self { grid, reach, stencil, strides }
    }

    /// At one node, from the values at all.
    pub fn at(&self, values: &[f64], index: [usize; D]) -> Jet<D> {
        let n = self.grid.cells() as f64;
        let centre = index.map(|i| i.clamp(self.reach, self.grid.cells() - self.reach));
        let centre_node = self.grid.node(centre) as isize;
        let mut gradient = [0.0; D];
        let mut curvature = [[0.0; D]; D];
        for (row, &stride) in self.stencil.weights.iter().zip(&self.strides) {
            let value = values[(centre_node + stride) as usize];
            let mut k = D;
            for a in 0..D {
                gradient[a] += row[a] * value;
                for b in a..D {
                    curvature[a][b] += row[k] * value;
                    k += 1;
                }
            }
        }
        for a in 0..D {
            for b in 0..a {
                curvature[a][b] = curvature[b][a];
            }
        }
        for a in 0..D {
            let shift: f64 = (0..D).map(|b| curvature[a][b] * (index[b] as f64 - centre[b] as f64)).sum();
            gradient[a] = (gradient[a] + shift) * n;
        }
        let value = values[self.grid.node(index)];
        Jet { value, gradient, curvature: curvature.map(|row| row.map(|x| x * n * n)) }
    }
}

/// Weights that take the values around a node to the coefficients of the fitted quadratic.
struct Stencil<const D: usize> {
    offsets: Vec<[isize; D]>,
    /// By offset: D weights of the gradient, then D(D+1)/2 of the second derivative's upper triangle.
    weights: Vec<Vec<f64>>,
}

impl<const D: usize> Stencil<D> {
    fn new(radius: f64) -> Self {
        let reach = radius.floor() as isize;
        let side = 2 * reach + 1;
        let offsets: Vec<[isize; D]> = (0..side.pow(D as u32))
            .map(|mut number| {
                std::array::from_fn(|_| {
                    let o = number % side - reach;
                    number /= side;
                    o
                })
            })
            .filter(|o: &[isize; D]| o.iter().map(|x| (x * x) as f64).sum::<f64>() <= radius * radius)
            .collect();

        let monomials: Vec<Vec<f64>> = offsets
            .iter()
            .map(|o| {
                let mut row = vec![1.0];
                row.extend(o.iter().map(|&x| x as f64));
                for a in 0..D {
                    for b in a..D {
                        let factor = if a == b { 0.5 } else { 1.0 };
                        row.push(factor * (o[a] * o[b]) as f64);
                    }
                }
                row
            })
            .collect();
        let unknowns = monomials[0].len();
        let mut normal = vec![vec![0.0; unknowns + offsets.len()]; unknowns];
        for (column, row) in monomials.iter().enumerate() {
            for i in 0..unknowns {
                for j in 0..unknowns {
                    normal[i][j] += row[i] * row[j];
                }
                normal[i][unknowns + column] = row[i];
            }
        }
        eliminate(&mut normal);
        let weights = (0..offsets.len()).map(|c| (1..unknowns).map(|i| normal[i][unknowns + c]).collect()).collect();
        Self { offsets, weights }
    }
}

/// Gauss–Jordan with pivoting: the left square block becomes the identity.
fn eliminate(rows: &mut [Vec<f64>]) {
    for pivot in 0..rows.len() {
        let best = (pivot..rows.len()).max_by(|&a, &b| rows[a][pivot].abs().total_cmp(&rows[b][pivot].abs()));
        rows.swap(pivot, best.unwrap_or(pivot));
        let scale = rows[pivot][pivot];
        assert!(scale.abs() > 1e-9, "the radius of the local fit is too small to determine a quadratic");
        let row: Vec<f64> = rows[pivot].iter().map(|x| x / scale).collect();
        for (i, other) in rows.iter_mut().enumerate() {
            let factor = other[pivot];
            if i != pivot && factor != 0.0 {
                other.iter_mut().zip(&row).for_each(|(x, r)| *x -= factor * r);
            }
        }
        rows[pivot] = row;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fit_reproduces_quadratics<const D: usize>() {
        let grid = Grid::<D>::new(8);
        let value = |x: &[f64; D]| {
            let mut sum = 0.3;
            for a in 0..D {
                sum += (a as f64 + 0.5) * x[a];
                for b in 0..D {
                    sum += 0.5 * ((1 + a.min(b)) as f64 - 0.7 * (a.max(b)) as f64) * x[a] * x[b];
                }
            }
            sum
        };
        let values: Vec<f64> = (0..grid.node_count()).map(|k| value(&grid.position(k))).collect();
        for radius in [1.5, 2.0, 3.0] {
            for (node, jet) in quadratic_fit(grid, &values, radius).iter().enumerate() {
                let x = grid.position(node);
                for a in 0..D {
                    let mut slope = a as f64 + 0.5;
                    for b in 0..D {
                        let h = (1 + a.min(b)) as f64 - 0.7 * (a.max(b)) as f64;
                        assert!((jet.curvature[a][b] - h).abs() < 1e-9);
                        slope += h * x[b];
                    }
                    assert!((jet.gradient[a] - slope).abs() < 1e-10);
                }
            }
        }
    }

    #[test]
    fn the_local_fit_reproduces_quadratics_up_to_the_boundary() {
        fit_reproduces_quadratics::<2>();
        fit_reproduces_quadratics::<3>();
    }

    fn interpolation_reproduces_linear_fields<const D: usize>() {
        let grid = Grid::<D>::new(4);
        let values: Vec<f64> = (0..grid.node_count()).flat_map(|k| grid.position(k).map(|x| 2.0 * x + 0.25)).collect();
        let point = std::array::from_fn(|axis| 0.37 + 0.9 * axis as f64);
        let value = interpolate::<D, D>(grid, &values, &point);
        let slope = interpolate_derivative::<D, D>(grid, &values, &point);
        for a in 0..D {
            assert!((value[a] - (2.0 * point[a] + 0.25)).abs() < 1e-13);
            for b in 0..D {
                assert!((slope[a][b] - if a == b { 2.0 } else { 0.0 }).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn interpolation_goes_on_linearly_beyond_the_box() {
        interpolation_reproduces_linear_fields::<2>();
        interpolation_reproduces_linear_fields::<3>();
    }
}
