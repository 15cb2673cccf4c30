//! What evaluates a level: the processor, or a graphics card where there is one and it is faster. Without the feature `gpu`,
//! `processor.rs` stands here.

use super::step::{Ask, Attempt};
use super::{Assembler, CpuAssembler, Evaluation, Gpu, GpuAssembler};
use crate::error::Error;
use crate::grid::Grid;
use crate::settings::Backend;
use crate::stencil::StencilOperator;
use std::rc::Rc;

/// What a search computes on; without a graphics card unless [`open`](Self::open) finds one.
#[derive(Clone, Default)]
pub struct Device {
    choice: Choice,
}

#[derive(Clone, Default)]
enum Choice {
    #[default]
    Processor,
    /// There was the choice, and why it fell on the processor.
    NoCard(Rc<str>),
    Card(Rc<Gpu>),
    /// The card where it is faster.
    Faster(Rc<Gpu>),
}

impl Device {
    /// What `backend` asks for.
    ///
    /// # Errors
    /// [`Error::NoCard`], if a graphics card is insisted on and there is none.
    pub async fn open(backend: Backend) -> Result<Self, Error> {
        let choice = match backend {
            Backend::Cpu => Choice::Processor,
            Backend::Gpu => Choice::Card(Gpu::shared().await.map_err(|reason| Error::NoCard { reason })?),
            Backend::Auto => match Gpu::shared().await {
                Ok(card) if card.is_software() => Choice::NoCard(
                    format!("the graphics card is none, the processor plays it ({})", card.name()).into(),
                ),
                Ok(card) => Choice::Faster(card),
                Err(reason) => Choice::NoCard(reason.into()),
            },
        };
        Ok(Self { choice })
    }

    /// Takes over what `twin` has been given.
    pub(crate) fn assembler<const D: usize>(&self, twin: CpuAssembler<D>) -> AnyAssembler<D> {
        match &self.choice {
            Choice::Processor => AnyAssembler::Cpu(Box::new(twin), None),
            Choice::NoCard(reason) => AnyAssembler::Cpu(Box::new(twin), Some(reason.clone())),
            Choice::Card(card) => AnyAssembler::Gpu(Box::new(GpuAssembler::new(card.clone(), twin))),
            Choice::Faster(card) => AnyAssembler::Gpu(Box::new(GpuAssembler::if_faster(card.clone(), twin))),
        }
    }
}

/// The assembler of one level.
pub(crate) enum AnyAssembler<const D: usize> {
    /// And why, where there was a choice.
    Cpu(Box<CpuAssembler<D>>, Option<Rc<str>>),
    Gpu(Box<GpuAssembler<D>>),
}

/// The same of either assembler.
macro_rules! of_any {
    ($any:expr, $assembler:ident => $answer:expr) => {
        match $any {
            AnyAssembler::Cpu($assembler, _) => $answer,
            AnyAssembler::Gpu($assembler) => $answer,
        }
    };
}

impl<const D: usize> AnyAssembler<D> {
    /// The processor's, whose answers are ready at once.
    pub fn twin(&mut self) -> &mut CpuAssembler<D> {
        match self {
            Self::Cpu(assembler, _) => assembler,
            Self::Gpu(assembler) => assembler.twin(),
        }
    }

    /// What computes: "cpu", "gpu: " and the card's name, or "cpu: " and why it is not the card.
    pub fn backend(&self) -> String {
        match self {
            Self::Cpu(_, None) => "cpu".into(),
            Self::Cpu(_, Some(reason)) => format!("cpu: {reason}"),
            Self::Gpu(assembler) => assembler.backend(),
        }
    }
}

impl<const D: usize> Assembler<D> for AnyAssembler<D> {
    fn grid(&self) -> Grid<D> {
        of_any!(self, assembler => assembler.grid())
    }

    async fn energy(&mut self, displacement: &[f64]) -> Evaluation {
        of_any!(self, assembler => assembler.energy(displacement).await)
    }

    async fn gradient(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        of_any!(self, assembler => assembler.gradient(displacement, gradient).await)
    }

    async fn hessian(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut StencilOperator<D>,
    ) -> Evaluation {
        of_any!(self, assembler => assembler.hessian(displacement, gradient, operator).await)
    }

    async fn attempt(&mut self, start: Option<&[f64]>, ask: &Ask) -> Option<Attempt> {
        of_any!(self, assembler => assembler.attempt(start, ask).await)
    }

    async fn fetch(&mut self, displacement: &mut [f64]) -> Option<()> {
        of_any!(self, assembler => assembler.fetch(displacement).await)
    }
}
