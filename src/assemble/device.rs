//! What evaluates a level: the processor, or a graphics card where there is one and it is faster.

use super::{Assembler, CpuAssembler, Evaluation};
#[cfg(feature = "gpu")]
use super::{Gpu, GpuAssembler};
use crate::error::Error;
use crate::grid::Grid;
use crate::settings::Backend;
use crate::stencil::StencilOperator;
#[cfg(feature = "gpu")]
use std::rc::Rc;

/// What a search computes on; without a graphics card unless [`open`](Self::open) finds one.
#[derive(Clone, Default)]
pub struct Device {
    #[cfg(feature = "gpu")]
    card: Option<Rc<Gpu>>,
}

impl Device {
    /// What `backend` asks for.
    ///
    /// # Errors
    /// [`Error::NoCard`], if a graphics card is insisted on and there is none.
    #[cfg(feature = "gpu")]
    pub async fn open(backend: Backend) -> Result<Self, Error> {
        match backend {
            Backend::Gpu => match Gpu::shared().await {
                Ok(card) => Ok(Self { card: Some(card) }),
                Err(reason) => Err(Error::NoCard { reason }),
            },
            Backend::Auto | Backend::Cpu => Ok(Self::default()),
        }
    }

    /// What `backend` asks for.
    ///
    /// # Errors
    /// [`Error::NoCard`], if a graphics card is insisted on: this build computes on none.
    #[cfg(not(feature = "gpu"))]
    #[expect(clippy::unused_async, reason = "with graphics cards it waits for one")]
    pub async fn open(backend: Backend) -> Result<Self, Error> {
        match backend {
            Backend::Gpu => {
                Err(Error::NoCard { reason: "this build computes on the processor; load the package wasm-gpu".into() })
            }
            Backend::Auto | Backend::Cpu => Ok(Self::default()),
        }
    }

    /// Takes over what `twin` has been given.
    pub(crate) fn assembler<const D: usize>(&self, twin: CpuAssembler<D>) -> AnyAssembler<D> {
        #[cfg(feature = "gpu")]
        if let Some(card) = &self.card {
            return AnyAssembler::Gpu(Box::new(GpuAssembler::new(card.clone(), twin)));
        }
        AnyAssembler::Cpu(twin)
    }
}

/// The assembler of one level.
pub(crate) enum AnyAssembler<const D: usize> {
    Cpu(CpuAssembler<D>),
    #[cfg(feature = "gpu")]
    Gpu(Box<GpuAssembler<D>>),
}

impl<const D: usize> AnyAssembler<D> {
    /// The processor's, whose answers are ready at once.
    pub fn twin(&mut self) -> &mut CpuAssembler<D> {
        match self {
            Self::Cpu(assembler) => assembler,
            #[cfg(feature = "gpu")]
            Self::Gpu(assembler) => assembler.twin(),
        }
    }

    /// What computes: "cpu", "gpu: " and the card's name, or "cpu: " and why it is not the card.
    pub fn backend(&self) -> String {
        match self {
            Self::Cpu(_) => "cpu".into(),
            #[cfg(feature = "gpu")]
            Self::Gpu(assembler) => assembler.backend(),
        }
    }
}

impl<const D: usize> Assembler<D> for AnyAssembler<D> {
    fn grid(&self) -> Grid<D> {
        match self {
            Self::Cpu(assembler) => assembler.grid(),
            #[cfg(feature = "gpu")]
            Self::Gpu(assembler) => assembler.grid(),
        }
    }

    async fn energy(&mut self, displacement: &[f64]) -> Evaluation {
        match self {
            Self::Cpu(assembler) => assembler.energy(displacement).await,
            #[cfg(feature = "gpu")]
            Self::Gpu(assembler) => assembler.energy(displacement).await,
        }
    }

    async fn gradient(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        match self {
            Self::Cpu(assembler) => assembler.gradient(displacement, gradient).await,
            #[cfg(feature = "gpu")]
            Self::Gpu(assembler) => assembler.gradient(displacement, gradient).await,
        }
    }

    async fn hessian(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut StencilOperator<D>,
    ) -> Evaluation {
        match self {
            Self::Cpu(assembler) => assembler.hessian(displacement, gradient, operator).await,
            #[cfg(feature = "gpu")]
            Self::Gpu(assembler) => assembler.hessian(displacement, gradient, operator).await,
        }
    }
}
