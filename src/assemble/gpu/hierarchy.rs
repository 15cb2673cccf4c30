//! A V-cycle on the card: the operators of all levels and what a cycle needs, each kind in one array, the finest level first.

use super::buffer::Buffer;
use super::device::Gpu;
use super::kernels::{GROUP, Kernel, Solver, binding};
use crate::grid::Grid;
use crate::stencil::StencilOperator;
use wgpu::{BindGroup, BufferUsages, ComputePass};

/// Nodes of a level that one workgroup does together with all coarser ones: 9² or 5³.
const SMALL: usize = 125;
/// Numbers of `Scalars` in `shaders/multigrid.wgsl`, and where some of them are.
pub(super) const SCALARS: usize = 10;
pub(super) const SHIFT: usize = 9;

pub(super) struct Hierarchy<const D: usize> {
    /// Of the levels, nodes a side and the nodes of all finer ones.
    meshes: Vec<[usize; 2]>,
    pub near: Buffer,
    pub far: Buffer,
    pub right: Buffer,
    pub solution: Buffer,
    pub residual: Buffer,
    pub scalars: Buffer,
    /// The finest level's place.
    pub place: Buffer,
    /// From the finest level to the one from which on a workgroup does it all.
    levels: Vec<Level>,
    small_cycle: BindGroup,
    /// To each level but the finest.
    coarsen: Vec<BindGroup>,
    /// Of each level.
    invert: Vec<BindGroup>,
    // Bound, and kept for that.
    _places: Vec<Buffer>,
    _inverse: Buffer,
}

struct Level {
    /// By colour.
    sweep: Vec<BindGroup>,
    leave_residual: BindGroup,
    restrict: BindGroup,
    prolongate: BindGroup,
}

impl<const D: usize> Hierarchy<D> {
    /// Blocks of a node that lie in `near`, the others in `far`.
    pub const NEAR: usize = StencilOperator::<D>::HALF.div_ceil(2);

    /// None if the operators are larger than what the device lets a shader see. `tolerance`: the relative residual at which
    /// conjugate gradients end.
    pub fn new(gpu: &Gpu, solver: &Solver, grid: Grid<D>, tolerance: f32) -> Option<Self> {
        let mut meshes = vec![[grid.side(), 0]];
        let mut nodes = grid.node_count();
        let mut cells = grid.cells();
        while cells > 2 && cells.is_multiple_of(2) {
            cells /= 2;
            meshes.push([cells + 1, nodes]);
            nodes += Grid::<D>::new(cells).node_count();
        }
        let near_bytes = nodes * Self::NEAR * StencilOperator::<D>::BLOCK * 4;
        if cells > 2 || near_bytes as u64 > gpu.device.limits().max_storage_buffer_binding_size {
            return None;
        }
        let (stored, copied) = (BufferUsages::STORAGE, BufferUsages::COPY_SRC | BufferUsages::COPY_DST);
        let blocks =
            |count: usize| Buffer::empty(gpu, stored | copied, nodes * count * StencilOperator::<D>::BLOCK * 4);
        let vectors = || Buffer::empty(gpu, stored | copied, nodes * D * 4);
        let (near, far, inverse) = (blocks(Self::NEAR), blocks(StencilOperator::<D>::HALF - Self::NEAR), blocks(1));
        let [right, solution, residual] = [(), (), ()].map(|()| vectors());
        let scalars = Buffer::empty(gpu, stored | copied, SCALARS * 4);

        let mut places = Vec::new();
        let mut bind = |kernel: &Kernel, level: usize, colour: usize| {
            let coarse = meshes.get(level + 1).copied().unwrap_or_default();
            let numbers = [meshes[level][0], meshes[level][1], coarse[0], coarse[1], colour].map(|x| x as u32);
            let numbers = [&numbers[..], &[(tolerance * tolerance).to_bits()]].concat();
            let place = Buffer::filled(gpu, BufferUsages::UNIFORM, &numbers);
            let group = kernel.bind(&gpu.device, |number| match number {
                binding::PLACE => &place,
                binding::NEAR => &near,
                binding::FAR => &far,
                binding::INVERSE => &inverse,
                binding::RIGHT => &right,
                binding::SOLUTION => &solution,
                binding::RESIDUAL => &residual,
                _ => &scalars,
            });
            places.push(place);
            group
        };
        let small = meshes.iter().position(|mesh| mesh[0].pow(D as u32) <= SMALL).unwrap_or(meshes.len() - 1);
        let levels = (0..small)
            .map(|level| Level {
                sweep: (0..Grid::<D>::CORNERS).map(|colour| bind(&solver.sweep, level, colour)).collect(),
                leave_residual: bind(&solver.leave_residual, level, 0),
                restrict: bind(&solver.restrict, level, 0),
                prolongate: bind(&solver.prolongate, level, 0),
            })
            .collect();
        let small_cycle = bind(&solver.small_cycle, small, 0);
        let coarsen = (0..meshes.len() - 1).map(|level| bind(&solver.coarsen, level, 0)).collect();
        let invert: Vec<_> = (0..meshes.len()).map(|level| bind(&solver.invert_diagonal, level, 0)).collect();
        let place = places.remove(places.len() - meshes.len());
        Some(Self {
            levels,
            small_cycle,
            coarsen,
            invert,
            _places: places,
            meshes,
            near,
            far,
            _inverse: inverse,
            right,
            solution,
            residual,
            scalars,
            place,
        })
    }

    fn nodes(&self, level: usize) -> usize {
        self.meshes[level][0].pow(D as u32)
    }

    /// Derives the coarse operators and the smoothers from the finest operator.
    pub fn prepare(&self, gpu: &Gpu, solver: &Solver, pass: &mut ComputePass<'_>) {
        for (level, invert) in self.invert.iter().enumerate() {
            solver.invert_diagonal.dispatch(gpu, pass, invert, self.nodes(level));
            if let Some(coarsen) = self.coarsen.get(level) {
                solver.coarsen.dispatch(gpu, pass, coarsen, self.nodes(level + 1) * StencilOperator::<D>::HALF);
            }
        }
    }

    /// One V-cycle on the finest level's right side, into its solution, which is zero.
    pub fn cycle(&self, gpu: &Gpu, solver: &Solver, pass: &mut ComputePass<'_>) {
        let a_colour = |level: usize| self.meshes[level][0].div_ceil(2).pow(D as u32);
        for (level, Level { sweep, leave_residual, restrict, .. }) in self.levels.iter().enumerate() {
            for colour in sweep {
                solver.sweep.dispatch(gpu, pass, colour, a_colour(level));
            }
            solver.leave_residual.dispatch(gpu, pass, leave_residual, self.nodes(level));
            solver.restrict.dispatch(gpu, pass, restrict, self.nodes(level + 1));
        }
        solver.small_cycle.dispatch(gpu, pass, &self.small_cycle, GROUP);
        for (level, Level { sweep, prolongate, .. }) in self.levels.iter().enumerate().rev() {
            solver.prolongate.dispatch(gpu, pass, prolongate, self.nodes(level));
            for colour in sweep.iter().rev() {
                solver.sweep.dispatch(gpu, pass, colour, a_colour(level));
            }
        }
    }
}
