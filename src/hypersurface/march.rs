//! Zero sets by marching over the Kuhn simplices of the cells.

use super::Hypersurface;
use crate::grid::Grid;
use crate::numbers::Numbers;

/// A Kuhn simplex goes from a cell's lowest corner to its highest along its edges; the order of the axes tells which.
fn orders<const D: usize>() -> Vec<[usize; D]> {
    let mut orders: Vec<Vec<usize>> = vec![Vec::new()];
    for axis in 0..D {
        let longer = |order: Vec<usize>| {
            (0..=order.len()).map(move |place| {
                let mut longer = order.clone();
                longer.insert(place, axis);
                longer
            })
        };
        orders = orders.into_iter().flat_map(longer).collect();
    }
    orders.into_iter().map(|order| std::array::from_fn(|k| order[k])).collect()
}

pub(super) fn zero_set<const D: usize>(grid: Grid<D>, values: &[f64]) -> Hypersurface<D> {
    assert_eq!(values.len(), grid.node_count(), "one value a node");
    let orders = orders::<D>();
    let offsets = grid.corner_offsets();
    let mut zeros = Zeros { grid, values, points: Vec::new(), edges: Numbers::default() };
    let mut simplices = Vec::new();
    for cell in 0..grid.cell_count() {
        let base = grid.lowest_node(cell);
        let negative = (0..Grid::<D>::CORNERS).filter(|&corner| values[base + offsets[corner]] < 0.0).count();
        if negative == 0 || negative == Grid::<D>::CORNERS {
            continue;
        }
        for order in &orders {
            let (mut inside, mut outside) = (Vec::with_capacity(D), Vec::with_capacity(D));
            let mut corner = 0;
            for step in 0..=D {
                let node = base + offsets[corner];
                if values[node] < 0.0 {
                    inside.push(node)
                } else {
                    outside.push(node)
                }
                if step < D {
                    corner |= 1 << order[step];
                }
            }
            if !inside.is_empty() && !outside.is_empty() {
                staircases(inside.len(), outside.len(), &mut [(0, 0); D], 1, &mut |path: &[(usize, usize); D]| {
                    simplices.push(path.map(|(i, j)| zeros.on_edge(inside[i], outside[j])));
                });
            }
        }
    }
    Hypersurface { points: zeros.points, simplices }
}

/// The zero set in a simplex is the product of the simplex of its `inside` corners with that of its `outside` ones: its
/// corners are the pairs (i, j), and the monotone paths from (0, 0) to the last pair cut it into simplices.
fn staircases<const D: usize>(
    inside: usize,
    outside: usize,
    path: &mut [(usize, usize); D],
    length: usize,
    visit: &mut impl FnMut(&[(usize, usize); D]),
) {
    let (i, j) = path[length - 1];
    if length == D {
        visit(path);
        return;
    }
    for (next, fits) in [((i + 1, j), i + 1 < inside), ((i, j + 1), j + 1 < outside)] {
        if fits {
            path[length] = next;
            staircases(inside, outside, path, length + 1, visit);
        }
    }
}

struct Zeros<'a, const D: usize> {
    grid: Grid<D>,
    values: &'a [f64],
    points: Vec<[f64; D]>,
    /// Of the points, by the nodes of their edges.
    edges: Numbers,
}

impl<const D: usize> Zeros<'_, D> {
    /// The number of the zero between two nodes, by linear interpolation.
    fn on_edge(&mut self, inside: usize, outside: usize) -> u32 {
        let number = self.edges.of([inside as i64, outside as i64]);
        if number as usize == self.points.len() {
            let (from, to) = (self.grid.position(outside), self.grid.position(inside));
            let t = self.values[outside] / (self.values[outside] - self.values[inside]);
            self.points.push(std::array::from_fn(|axis| from[axis] + t * (to[axis] - from[axis])));
        }
        number
    }
}
