//! The assembler on a graphics card, through WebGPU: f32, one invocation a cell, gathered by nodes.
//!
//! Displacements are differenced before they are rounded, sums are trees whose last stage is f64, and what f32 cannot
//! decide the processor's twin does: whether a deformation next to a fold is admissible, and what a displacement that is
//! no number costs. So both take the same steps. Pins, a few multiplications each, are the twin's too, unless the
//! displacement stays on the card.
//!
//! A step of Newton's method stays on the card as a whole ([`attempt`](Assembler::attempt)): what comes back are sums.
//!
//! Where both may compute, the first derivatives of a size tell who is faster ([`Pace`]).
//!
//! A device may be lost at any time. From then on the twin computes; nothing above notices, and
//! [`backend`](GpuAssembler::backend) says why.

#[cfg(target_arch = "wasm32")]
mod browser;
mod buffer;
mod device;
mod forces;
mod gradients;
mod hessian;
mod hierarchy;
mod kernels;
mod level;
mod multigrid;
mod pace;
mod pins;
mod resident;
mod slab;
mod upload;

pub use device::{Counts, Gpu};
pub use multigrid::GpuMultigrid;
pub use pace::{Clock, Pace, set_clock};

use super::step::{Ask, Attempt, Renewal, is_enough};
use super::{Assembler, CpuAssembler, Evaluation};
use crate::energy::{Energies, GRADIENT, HESSIAN, VALUE};
use crate::grid::Grid;
use crate::ready::ready;
use crate::stencil::StencilOperator;
use bytemuck::cast_slice;
use forces::{Forces, Sums};
use hessian::{Hessian, Pairs};
use kernels::Kernels;
use level::Level;
use resident::{EAGER, Resident, STEPS};
use slab::BandRows;
use std::rc::Rc;
use upload::Upload;

/// A least determinant nearer to zero than this, in units of what the edges of its cell could make, is the twin's affair. In
/// f32 it is wrong by some 2⁻²³ of that unit: nearer than that it may have either sign in f64, and long before, the energy,
/// which has it squared in a denominator, has lost its fifth digit.
const DOUBT: f64 = 1e-2;

/// By more than this no determinant is wrong that lies so near to zero.
const ROUNDED: f64 = 1e-4;

/// Evaluates the functional of one level on a graphics card.
pub struct GpuAssembler<const D: usize> {
    gpu: Rc<Gpu>,
    twin: CpuAssembler<D>,
    chosen: Chosen,
    /// Made when the card is first asked for something.
    there: Option<There<D>>,
}

/// Who computes.
enum Chosen {
    Card,
    /// The processor, until the first derivatives have told who is faster.
    Undecided,
    Processor(String),
}

/// What of a level is on the card.
struct There<const D: usize> {
    kernels: Rc<Kernels>,
    upload: Upload<D>,
    level: Level,
    band: BandRows,
    forces: Forces,
    /// Made when the first hessian is asked for.
    hessian: Option<Hessian>,
    /// Made when the first step is asked for; None if it was, and cannot be.
    resident: Option<Option<Resident<D>>>,
}

impl<const D: usize> There<D> {
    fn new(gpu: &Gpu, twin: &CpuAssembler<D>) -> Self {
        let (kernels, band, level) = (gpu.kernels::<D>(), BandRows::of(twin), Level::new(gpu, twin));
        let forces = Forces::new(gpu, &kernels, &level, twin, &band);
        Self { kernels, upload: Upload::new(twin.grid), level, band, forces, hessian: None, resident: None }
    }
}

impl<const D: usize> GpuAssembler<D> {
    /// Takes over what `twin` has been given: the functional, the shapes, the pins.
    pub fn new(gpu: Rc<Gpu>, twin: CpuAssembler<D>) -> Self {
        Self { gpu, twin, chosen: Chosen::Card, there: None }
    }

    /// The same, but the processor computes where it is as fast: both are timed once for a grid of this size.
    pub fn if_faster(gpu: Rc<Gpu>, twin: CpuAssembler<D>) -> Self {
        let chosen = gpu.pace::<D>(twin.grid.cells()).map_or(Chosen::Undecided, Chosen::by);
        Self { gpu, twin, chosen, there: None }
    }

    /// What the processor computes with.
    pub(crate) fn twin(&mut self) -> &mut CpuAssembler<D> {
        &mut self.twin
    }

    /// What computes: "gpu: " and the adapter's name, or "cpu: " and the reason.
    pub fn backend(&self) -> String {
        match (&self.chosen, self.gpu.trouble()) {
            (Chosen::Processor(reason), _) => format!("cpu: {reason}"),
            (_, Some(reason)) => format!("cpu: {reason}"),
            (Chosen::Undecided, None) => "cpu: the first step will tell whether the graphics card is faster".into(),
            (Chosen::Card, None) => format!("gpu: {}", self.gpu.name()),
        }
    }

    async fn evaluate<const ORDER: u8>(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        mut operator: Option<&mut StencilOperator<D>>,
    ) -> Evaluation {
        match self.chosen {
            Chosen::Undecided if ORDER > VALUE => return self.decide::<ORDER>(displacement, gradient, operator).await,
            Chosen::Undecided | Chosen::Processor(_) => {}
            Chosen::Card => {
                if let Some(evaluation) = self.compute::<ORDER>(displacement, gradient, operator.as_deref_mut()).await {
                    return evaluation;
                }
            }
        }
        self.by_twin::<ORDER>(displacement, gradient, operator)
    }

    /// Once in the module, wherever it is called from.
    #[inline(never)]
    fn by_twin<const ORDER: u8>(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: Option<&mut StencilOperator<D>>,
    ) -> Evaluation {
        match operator {
            Some(operator) => ready(self.twin.hessian(displacement, gradient, operator)),
            None if ORDER == VALUE => ready(self.twin.energy(displacement)),
            None => ready(self.twin.gradient(displacement, gradient)),
        }
    }

    /// Computes by the processor and, where that takes long enough for a card to be worth its answer's delay, on the card.
    async fn decide<const ORDER: u8>(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        mut operator: Option<&mut StencilOperator<D>>,
    ) -> Evaluation {
        let Some(clock) = pace::clock() else {
            self.chosen = Chosen::Processor(pace::NO_CLOCK.into());
            return self.by_twin::<ORDER>(displacement, gradient, operator);
        };
        let begun = clock();
        let evaluation = self.by_twin::<ORDER>(displacement, gradient, operator.as_deref_mut());
        let mut pace = Pace { cpu_millis: clock() - begun, gpu_millis: None };
        let mut found = None;
        if pace.is_worth_a_trial() {
            // The first time, its driver has to get ready.
            if self.compute::<ORDER>(displacement, gradient, operator.as_deref_mut()).await.is_some() {
                let begun = clock();
                found = self.compute::<ORDER>(displacement, gradient, operator.as_deref_mut()).await;
                pace.gpu_millis = Some(clock() - begun);
            }
            if found.is_none() {
                // Lost, or next to a fold, which tells nothing of its pace.
                return self.by_twin::<ORDER>(displacement, gradient, operator);
            }
        }
        self.gpu.keep_pace::<D>(self.twin.grid.cells(), pace);
        self.chosen = Chosen::by(pace);
        if !matches!(self.chosen, Chosen::Card) {
            self.there = None;
        }
        found.unwrap_or(evaluation)
    }

    /// What the card makes of a displacement. None if it is lost, or where the twin must decide.
    async fn compute<const ORDER: u8>(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        mut operator: Option<&mut StencilOperator<D>>,
    ) -> Option<Evaluation> {
        let Self { gpu, twin, there, .. } = self;
        assert_eq!(displacement.len(), twin.grid.node_count() * D);
        if gpu.trouble().is_some() {
            return None;
        }
        let There { kernels, upload, level, band, forces, hessian, .. } =
            there.get_or_insert_with(|| There::new(gpu, twin));
        let numbers = upload.of(displacement)?;
        gpu.queue.write_buffer(&level.nodes, 0, cast_slice(numbers));
        let sums = forces.evaluate(gpu, kernels, gradient).await?;
        let mut evaluation = decided(&sums)?;
        if sums.least > 0.0 {
            if let Some(operator) = &mut operator {
                let pairs = || Pairs::new(gpu, kernels, level, twin, band);
                let hessian = hessian.get_or_insert_with(|| Hessian::new::<D>(gpu, kernels, level, pairs()));
                hessian.evaluate(gpu, kernels, operator).await?;
            }
            twin.add_pins::<ORDER>(displacement, gradient, &mut operator, &mut evaluation.energies);
        }
        Some(evaluation)
    }

    /// The same step as a minimiser would make that has derivatives and energies from here.
    async fn try_step(&mut self, start: Option<&[f64]>, ask: &Ask) -> Option<Attempt> {
        let Self { gpu, twin, chosen, there } = self;
        if !matches!(chosen, Chosen::Card) || gpu.trouble().is_some() {
            return None;
        }
        let There { kernels, level, band, forces, resident, .. } = there.get_or_insert_with(|| There::new(gpu, twin));
        let made = || Resident::new(gpu, kernels, level, forces, Pairs::new(gpu, kernels, level, twin, band), twin);
        let resident = resident.get_or_insert_with(made).as_mut()?;
        let mut renewal = ask.renewal;
        if let Some(displacement) = start {
            resident.put(gpu, displacement)?;
            renewal = Renewal::Hessian;
        }
        if !resident.is_there {
            return None;
        }
        let told = resident.search(gpu, kernels, forces, renewal, ask.shift).await?;
        // The direction solves H d = +∇E: the way down is against it.
        let slope = -told.slope;
        let mut trials = told.sums.into_iter();
        let before = decided(&trials.next()?).filter(Evaluation::is_admissible)?;
        let mut attempt = Attempt { before, taken: None, evaluations: 1 };
        for number in (1..STEPS.len()).take_while(|_| slope < 0.0) {
            if number == EAGER {
                trials = resident.search_on(gpu, kernels, forces).await?.sums.into_iter();
            }
            let sums = trials.next()?;
            let length = STEPS[number];
            attempt.evaluations += 1;
            let after = match decided(&sums) {
                Some(evaluation) => evaluation,
                None if is_refused_anyway(&before, &sums, length, slope) => continue,
                None => {
                    let mut displacement = vec![0.0; twin.grid.node_count() * D];
                    resident.fetch(gpu, Some(number), &mut displacement).await?;
                    ready(twin.energy(&displacement))
                }
            };
            if is_enough(&before, &after, length, slope) {
                resident.choose(number);
                attempt.taken = Some((length, after));
                break;
            }
        }
        Some(attempt)
    }
}

/// What the sums say; None where that is the twin's affair.
fn decided(sums: &Sums) -> Option<Evaluation> {
    let [membrane, bending, mismatch, volume] = sums.energies;
    let energies = Energies { membrane, bending, mismatch, volume, pins: sums.pins };
    // Not a number is not greater, either.
    let is_decided = sums.ratio.abs() > DOUBT && energies.total().is_finite();
    is_decided.then_some(Evaluation { energies, least_determinant: sums.least })
}

/// Whether a step next to a fold would not be enough even if it cost no energy, however its least determinant is rounded.
fn is_refused_anyway(before: &Evaluation, sums: &Sums, length: f64, slope: f64) -> bool {
    let least_determinant = sums.least + ROUNDED;
    !sums.ratio.is_nan()
        && !is_enough(before, &Evaluation { energies: Energies::default(), least_determinant }, length, slope)
}

impl Chosen {
    fn by(pace: Pace) -> Self {
        if pace.is_card_faster() { Self::Card } else { Self::Processor(pace.to_string()) }
    }
}

impl<const D: usize> Assembler<D> for GpuAssembler<D> {
    fn grid(&self) -> Grid<D> {
        self.twin.grid
    }

    async fn energy(&mut self, displacement: &[f64]) -> Evaluation {
        self.evaluate::<VALUE>(displacement, &mut [], None).await
    }

    async fn gradient(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        self.evaluate::<GRADIENT>(displacement, gradient, None).await
    }

    async fn hessian(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut StencilOperator<D>,
    ) -> Evaluation {
        self.evaluate::<HESSIAN>(displacement, gradient, Some(operator)).await
    }

    async fn attempt(&mut self, start: Option<&[f64]>, ask: &Ask) -> Option<Attempt> {
        self.try_step(start, ask).await
    }

    async fn fetch(&mut self, displacement: &mut [f64]) -> Option<()> {
        let resident = self.there.as_mut()?.resident.as_mut()?.as_mut()?;
        if self.gpu.trouble().is_some() || !resident.is_there {
            return None;
        }
        resident.fetch(&self.gpu, None, displacement).await
    }
}
