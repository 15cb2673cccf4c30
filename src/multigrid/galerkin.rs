//! The coarse operator Pᵀ A P of multilinear prolongation P.

use crate::stencil::StencilOperator;

/// Overwrites `coarse` with Pᵀ · `fine` · P.
///
/// A fine node at offset o ∈ {−1,0,1}^D from a coarse node belongs to it by the share 2^(−|o|). The row of each such
/// node is passed on to the coarse nodes around, by the same shares.
pub(super) fn coarsen<const D: usize>(fine: &StencilOperator<D>, coarse: &mut StencilOperator<D>) {
    let (fine_grid, grid) = (fine.grid(), coarse.grid());
    let routes = Routes::<D>::new();
    let row_length = StencilOperator::<D>::ROW;
    for node in 0..grid.node_count() {
        let index = grid.node_index(node);
        let target = &mut coarse.blocks_mut()[node * row_length..][..row_length];
        target.fill(0.0);
        for (offset, routes) in &routes.by_offset {
            let place: [isize; D] = std::array::from_fn(|k| 2 * index[k] as isize + offset[k]);
            if place.iter().any(|&i| i < 0 || i as usize >= fine_grid.side()) {
                continue;
            }
            let source = &fine.blocks()[fine_grid.node(place.map(|i| i as usize)) * row_length..][..row_length];
            for &(from, to, share) in routes {
                let (from, to) = (&source[from..][..D * D], &mut target[to..][..D * D]);
                for (t, f) in to.iter_mut().zip(from) {
                    *t += share * f;
                }
            }
        }
    }
}

/// Where the blocks of a fine row go: positions in the rows, and the share.
struct Routes<const D: usize> {
    by_offset: Vec<([isize; D], Vec<(usize, usize, f32)>)>,
}

impl<const D: usize> Routes<D> {
    fn new() -> Self {
        let block = D * D;
        let by_offset = (0..StencilOperator::<D>::NEIGHBOURS)
            .map(|own| {
                let offset = StencilOperator::<D>::offset(own);
                let own_share: f32 = offset.iter().map(|&o| share(o)).product();
                let mut routes = Vec::new();
                for neighbour in 0..StencilOperator::<D>::NEIGHBOURS {
                    let beside = StencilOperator::<D>::offset(neighbour);
                    for target in 0..StencilOperator::<D>::NEIGHBOURS {
                        let coarse = StencilOperator::<D>::offset(target);
                        let weight: f32 = (0..D).map(|k| share(offset[k] + beside[k] - 2 * coarse[k])).product();
                        if weight > 0.0 {
                            routes.push((neighbour * block, target * block, own_share * weight));
                        }
                    }
                }
                (offset, routes)
            })
            .collect();
        Self { by_offset }
    }
}

/// The value of a coarse hat function, in fine cells from its centre.
fn share(distance: isize) -> f32 {
    match distance.abs() {
        0 => 1.0,
        1 => 0.5,
        _ => 0.0,
    }
}
