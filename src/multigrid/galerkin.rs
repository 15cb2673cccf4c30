//! The coarse operator Pᵀ A P of multilinear prolongation P.

use crate::stencil::StencilOperator;

/// With B = D² numbers a block and N = 3^D blocks a row, so that a row is summed in registers.
fn coarsen_blocks<const D: usize, const B: usize, const N: usize>(
    routes: &Routes<D>,
    fine: &StencilOperator<D>,
    coarse: &mut StencilOperator<D>,
) {
    let (fine_grid, grid) = (fine.grid(), coarse.grid());
    let (sources, _) = fine.blocks().as_chunks::<B>();
    let (targets, _) = coarse.blocks_mut().as_chunks_mut::<B>();
    for (node, target) in targets.chunks_exact_mut(N).enumerate() {
        let index = grid.node_index(node);
        let mut sums = [[0.0; B]; N];
        for (offset, routes) in &routes.by_offset {
            let place: [isize; D] = std::array::from_fn(|k| 2 * index[k] as isize + offset[k]);
            if place.iter().any(|&i| i < 0 || i as usize >= fine_grid.side()) {
                continue;
            }
            let first = fine_grid.node(place.map(|i| i as usize)) * N;
            let source: &[[f32; B]; N] = sources[first..][..N].try_into().expect("a row has N blocks");
            for route in routes {
                let (from, to) = (&source[route.from], &mut sums[route.to]);
                for k in 0..B {
                    to[k] += route.share * from[k];
                }
            }
        }
        target.copy_from_slice(&sums);
    }
}

/// From which neighbour of a fine node to which neighbour of the coarse one, and by which share.
struct Route {
    from: usize,
    to: usize,
    share: f32,
}

/// How the rows around a coarse node make up its own.
///
/// A fine node at offset o ∈ {−1,0,1}^D from a coarse node belongs to it by the share 2^(−|o|). The row of each such
/// node is passed on to the coarse nodes around, by the same shares.
pub(super) struct Routes<const D: usize> {
    by_offset: Vec<([isize; D], Vec<Route>)>,
}

impl<const D: usize> Routes<D> {
    /// Overwrites `coarse` with Pᵀ · `fine` · P.
    pub fn coarsen(&self, fine: &StencilOperator<D>, coarse: &mut StencilOperator<D>) {
        match D {
            2 => coarsen_blocks::<D, 4, 9>(self, fine, coarse),
            3 => coarsen_blocks::<D, 9, 27>(self, fine, coarse),
            _ => unreachable!("curves and surfaces live in 2 or 3 dimensions"),
        }
    }

    pub fn new() -> Self {
        let by_offset = (0..StencilOperator::<D>::NEIGHBOURS)
            .map(|own| {
                let offset = StencilOperator::<D>::offset(own);
                let own_share: f32 = offset.iter().map(|&o| share(o)).product();
                let mut routes = Vec::new();
                for from in 0..StencilOperator::<D>::NEIGHBOURS {
                    let beside = StencilOperator::<D>::offset(from);
                    for to in 0..StencilOperator::<D>::NEIGHBOURS {
                        let coarse = StencilOperator::<D>::offset(to);
                        let weight: f32 = (0..D).map(|k| share(offset[k] + beside[k] - 2 * coarse[k])).product();
                        if weight > 0.0 {
                            routes.push(Route { from, to, share: own_share * weight });
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
