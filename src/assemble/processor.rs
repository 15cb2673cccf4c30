//! What evaluates a level in a build that computes on no graphics card: the processor. The names are those of `device.rs`.

use super::CpuAssembler;
use crate::error::Error;
use crate::settings::Backend;

/// What a search computes on.
#[derive(Clone, Default)]
pub struct Device {}

impl Device {
    /// What `backend` asks for.
    ///
    /// # Errors
    /// [`Error::NoCard`], if a graphics card is insisted on.
    #[expect(clippy::unused_async, reason = "with graphics cards it waits for one")]
    pub async fn open(backend: Backend) -> Result<Self, Error> {
        match backend {
            Backend::Gpu => {
                Err(Error::NoCard { reason: "this build computes on the processor; load the package wasm-gpu".into() })
            }
            Backend::Auto | Backend::Cpu => Ok(Self {}),
        }
    }

    pub(crate) fn assembler<const D: usize>(&self, twin: CpuAssembler<D>) -> AnyAssembler<D> {
        twin
    }
}

/// The assembler of one level.
pub(crate) type AnyAssembler<const D: usize> = CpuAssembler<D>;

impl<const D: usize> CpuAssembler<D> {
    pub(crate) fn twin(&mut self) -> &mut Self {
        self
    }

    /// What computes.
    pub(crate) fn backend(&self) -> String {
        "cpu".into()
    }
}
