//! From densities to numbers over the grid: energies, gradient, hessian at a displacement.

mod band;
mod cpu;
#[cfg_attr(not(feature = "gpu"), path = "assemble/processor.rs")]
mod device;
#[cfg(feature = "gpu")]
mod gpu;
mod jets;
#[cfg(any(test, feature = "gpu"))]
mod shaders;
pub mod step;

pub use cpu::CpuAssembler;
pub(crate) use device::AnyAssembler;
pub use device::Device;
#[cfg(feature = "gpu")]
pub use gpu::{Clock, Counts, Gpu, GpuAssembler, GpuMultigrid, Pace, set_clock};

use crate::energy::Energies;
use crate::grid::Grid;
use crate::stencil::StencilOperator;
use step::{Ask, Attempt};

/// The energies at one displacement, and whether it is admissible.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Evaluation {
    /// Weighted energies; meaningless where the deformation folds.
    pub energies: Energies,
    /// A lower bound of det Dφ over all cells: D = 2, where it is linear along every edge of a cell, the least over all
    /// corners, which is attained; D = 3 the least coefficient in Bernstein's basis.
    pub least_determinant: f64,
}

impl Evaluation {
    /// The energy to be minimised: infinite where the deformation folds, so that a line search refuses it.
    pub fn total(&self) -> f64 {
        let total = self.energies.total();
        if self.least_determinant > 0.0 && total.is_finite() { total } else { f64::INFINITY }
    }

    pub fn is_admissible(&self) -> bool {
        self.total().is_finite()
    }
}

/// Evaluates one level's functional. Displacements are u = φ − x at the nodes: D numbers a node, x fastest.
///
/// The methods are asynchronous because a GPU's answer is; a CPU's is ready at once.
#[allow(async_fn_in_trait, reason = "used by static dispatch within one thread only")]
pub trait Assembler<const D: usize> {
    fn grid(&self) -> Grid<D>;

    async fn energy(&mut self, displacement: &[f64]) -> Evaluation;

    /// Also overwrites `gradient` with the derivative by the nodal displacements.
    async fn gradient(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation;

    /// Also overwrites `operator` with a positive semi-definite approximation of the second derivative.
    async fn hessian(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut StencilOperator<D>,
    ) -> Evaluation;

    /// Tries a step of Newton's method where the displacement stays with the assembler, from `start` if it is not there yet.
    /// None where it does not, or does not any more: then the step is the minimiser's affair.
    async fn attempt(&mut self, _start: Option<&[f64]>, _ask: &Ask) -> Option<Attempt> {
        None
    }

    /// Overwrites `displacement` with the one that stays with the assembler. None if it is lost.
    async fn fetch(&mut self, _displacement: &mut [f64]) -> Option<()> {
        None
    }
}
