//! The assembler on a graphics card, through WebGPU: f32, one invocation a cell, gathered by nodes.
//!
//! Displacements are differenced before they are rounded, sums are trees whose last stage is f64, and what f32 cannot
//! decide the processor's twin does: whether a deformation next to a fold is admissible, and what a displacement that is
//! no number costs. So both take the same steps. Pins, a few multiplications each, are the twin's too.
//!
//! A device may be lost at any time. From then on the twin computes; nothing above notices, and
//! [`backend`](GpuAssembler::backend) says why.

mod buffer;
mod device;
mod forces;
mod hessian;
mod kernels;
mod level;
mod slab;
mod upload;

pub use device::Gpu;

use super::{Assembler, CpuAssembler, Evaluation};
use crate::energy::{Energies, GRADIENT, HESSIAN, VALUE};
use crate::grid::Grid;
use crate::stencil::StencilOperator;
use bytemuck::cast_slice;
use forces::Forces;
use hessian::Hessian;
use kernels::Kernels;
use level::Level;
use slab::BandRows;
use std::rc::Rc;
use upload::Upload;

/// A least determinant nearer to zero than this, in units of what the edges of its cell could make, is the twin's affair. In
/// f32 it is wrong by some 2⁻²³ of that unit: nearer than that it may have either sign in f64, and long before, the energy,
/// which has it squared in a denominator, has lost its fifth digit.
const DOUBT: f64 = 1e-2;

/// Evaluates the functional of one level on a graphics card.
pub struct GpuAssembler<const D: usize> {
    gpu: Rc<Gpu>,
    kernels: Rc<Kernels>,
    twin: CpuAssembler<D>,
    upload: Upload<D>,
    level: Level,
    band: BandRows,
    forces: Forces,
    /// Made when the first hessian is asked for.
    hessian: Option<Hessian>,
}

impl<const D: usize> GpuAssembler<D> {
    /// Takes over what `twin` has been given: the functional, the shapes, the pins.
    pub fn new(gpu: Rc<Gpu>, twin: CpuAssembler<D>) -> Self {
        let level = Level::new(&gpu, &twin);
        let (kernels, band) = (gpu.kernels::<D>(), BandRows::of(&twin));
        let forces = Forces::new(&gpu, &kernels, &level, &twin, &band);
        Self { upload: Upload::new(twin.grid), gpu, kernels, twin, level, band, forces, hessian: None }
    }

    /// What the processor computes with.
    pub(crate) fn twin(&mut self) -> &mut CpuAssembler<D> {
        &mut self.twin
    }

    /// What computes: "gpu: " and the adapter's name, or "cpu: " and the reason.
    pub fn backend(&self) -> String {
        match self.gpu.trouble() {
            None => format!("gpu: {}", self.gpu.name()),
            Some(reason) => format!("cpu: {reason}"),
        }
    }

    /// What the card makes of a displacement. None if it is lost, or where the twin must decide.
    async fn compute<const ORDER: u8>(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        mut operator: Option<&mut StencilOperator<D>>,
    ) -> Option<Evaluation> {
        assert_eq!(displacement.len(), self.twin.grid.node_count() * D);
        if self.gpu.trouble().is_some() {
            return None;
        }
        let numbers = self.upload.of(displacement)?;
        self.gpu.queue.write_buffer(&self.level.nodes, 0, cast_slice(numbers));
        let sums = self.forces.evaluate(&self.gpu, &self.kernels, gradient).await?;
        let [membrane, bending, mismatch, volume] = sums.energies;
        let mut energies = Energies { membrane, bending, mismatch, volume, pins: 0.0 };
        // Not a number is not greater, either.
        let is_decided = sums.ratio.abs() > DOUBT && energies.total().is_finite();
        if !is_decided {
            return None;
        }
        if sums.least > 0.0 {
            if let Some(operator) = &mut operator {
                let new = || Hessian::new(&self.gpu, &self.kernels, &self.level, &self.twin, &self.band);
                let hessian = self.hessian.get_or_insert_with(new);
                hessian.evaluate(&self.gpu, &self.kernels, operator).await?;
            }
            self.twin.add_pins::<ORDER>(displacement, gradient, &mut operator, &mut energies);
        }
        Some(Evaluation { energies, least_determinant: sums.least })
    }
}

impl<const D: usize> Assembler<D> for GpuAssembler<D> {
    fn grid(&self) -> Grid<D> {
        self.twin.grid
    }

    async fn energy(&mut self, displacement: &[f64]) -> Evaluation {
        match self.compute::<VALUE>(displacement, &mut [], None).await {
            Some(evaluation) => evaluation,
            None => self.twin.energy(displacement).await,
        }
    }

    async fn gradient(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        match self.compute::<GRADIENT>(displacement, gradient, None).await {
            Some(evaluation) => evaluation,
            None => self.twin.gradient(displacement, gradient).await,
        }
    }

    async fn hessian(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut StencilOperator<D>,
    ) -> Evaluation {
        match self.compute::<HESSIAN>(displacement, gradient, Some(operator)).await {
            Some(evaluation) => evaluation,
            None => self.twin.hessian(displacement, gradient, operator).await,
        }
    }
}
