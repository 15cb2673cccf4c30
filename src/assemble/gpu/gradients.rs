//! Conjugate gradients on the card.

use super::buffer::Buffer;
use super::device::Gpu;
use super::hierarchy::Hierarchy;
use super::kernels::{GROUP, Kernel, Solver, binding};
use crate::grid::Grid;
use wgpu::{BindGroup, BufferUsages, ComputePass};

/// Solves A d = ∇E, A the finest operator of a hierarchy.
pub(super) struct Gradients<const D: usize> {
    pub hierarchy: Hierarchy<D>,
    nodes: usize,
    pub direction: Buffer,
    pub partials: Buffer,
    begin: BindGroup,
    overlap: BindGroup,
    turn: BindGroup,
    apply: BindGroup,
    advance: BindGroup,
    fall: BindGroup,
    /// Of every kernel that ends a sum.
    pub sum: BindGroup,
    // Bound, and kept for that.
    _search: Buffer,
}

impl<const D: usize> Gradients<D> {
    pub fn new(gpu: &Gpu, solver: &Solver, grid: Grid<D>, hierarchy: Hierarchy<D>, gradient: &Buffer) -> Self {
        let nodes = grid.node_count();
        let vector = |usage| Buffer::empty(gpu, BufferUsages::STORAGE | usage, nodes * D * 4);
        let (search, direction) = (vector(BufferUsages::empty()), vector(BufferUsages::COPY_SRC));
        let partials = Buffer::empty(gpu, BufferUsages::STORAGE, (nodes * D).div_ceil(GROUP) * 4);
        let with = |kernel: &Kernel, solution: &Buffer| {
            kernel.bind(&gpu.device, |number| match number {
                binding::PLACE => &hierarchy.place,
                binding::NEAR => &hierarchy.near,
                binding::FAR => &hierarchy.far,
                binding::RIGHT => &hierarchy.right,
                binding::SOLUTION => solution,
                binding::RESIDUAL => &hierarchy.residual,
                binding::SCALARS => &hierarchy.scalars,
                binding::SEARCH => &search,
                binding::DIRECTION => &direction,
                binding::GRADIENT => gradient,
                _ => &partials,
            })
        };
        let bind = |kernel| with(kernel, &hierarchy.solution);
        Self {
            begin: bind(&solver.begin),
            overlap: bind(&solver.overlap),
            turn: bind(&solver.turn),
            apply: with(&solver.apply, &search),
            advance: bind(&solver.advance),
            fall: bind(&solver.fall),
            sum: bind(&solver.begun),
            nodes,
            hierarchy,
            direction,
            partials,
            _search: search,
        }
    }

    /// At most so many steps, from d = 0; then the slope ∇E·d.
    pub fn solve(&self, gpu: &Gpu, solver: &Solver, pass: &mut ComputePass<'_>, steps: usize) {
        let numbers = self.nodes * D;
        solver.begin.dispatch(gpu, pass, &self.begin, numbers);
        solver.begun.dispatch(gpu, pass, &self.sum, GROUP);
        for _ in 0..steps {
            self.hierarchy.cycle(gpu, solver, pass);
            solver.overlap.dispatch(gpu, pass, &self.overlap, numbers);
            solver.choose_turn.dispatch(gpu, pass, &self.sum, GROUP);
            solver.turn.dispatch(gpu, pass, &self.turn, numbers);
            solver.apply.dispatch(gpu, pass, &self.apply, self.nodes);
            solver.choose_step.dispatch(gpu, pass, &self.sum, GROUP);
            solver.advance.dispatch(gpu, pass, &self.advance, numbers);
            solver.judge.dispatch(gpu, pass, &self.sum, GROUP);
        }
        solver.fall.dispatch(gpu, pass, &self.fall, numbers);
        solver.fallen.dispatch(gpu, pass, &self.sum, GROUP);
    }
}
