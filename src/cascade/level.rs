use super::Ties;
use crate::assemble::{AnyAssembler, Assembler, CpuAssembler, Device, Evaluation};
use crate::distance::SignedDistance;
use crate::grid::Grid;
#[cfg(not(feature = "gpu"))]
use crate::minimize::Newton;
#[cfg(feature = "gpu")]
use crate::minimize::Resident as Newton;
use crate::minimize::{Minimizer, Ncg, Progress};
use crate::settings::{MinimizerKind, Settings};
use std::rc::Rc;

/// Relative decrease at which levels before the finest end: the next one changes the functional, so the last digits of
/// this one's minimum are not worth their iterations.
const COARSE_TOLERANCE: f64 = 1e-4;

/// Weight of each point of a guide, and of each that has been missed.
const GUIDE_WEIGHT: f64 = 0.3;
const MISSED_WEIGHT: f64 = 2.0;

/// What one level needs.
pub(super) struct Level<const D: usize> {
    pub number: u32,
    pub assembler: AnyAssembler<D>,
    /// The shell and its aim on this level.
    shapes: [SignedDistance<D>; 2],
    minimizer: AnyMinimizer<D>,
}

impl<const D: usize> Level<D> {
    /// `shapes` are the shell and its aim; the deformation starts from the identity if none is given.
    pub fn new(
        number: u32,
        settings: &Settings,
        device: &Device,
        shapes: &[Rc<SignedDistance<D>>; 2],
        ties: &Ties<D>,
        displacement: Option<Vec<f64>>,
    ) -> Self {
        let shapes = [0, 1].map(|k| shapes[k].to_cells(1 << number));
        let mut assembler = CpuAssembler::new(&settings.thrifty_functional::<D>(number), &shapes[0], &shapes[1]);
        assembler.tie(&ties.pins, settings.pin_weight);
        if number < settings.finest {
            assembler.tie(&ties.guide, GUIDE_WEIGHT);
        } else {
            assembler.tie(&ties.missed, MISSED_WEIGHT);
        }
        let displacement = displacement.unwrap_or_else(|| vec![0.0; shapes[0].grid().node_count() * D]);
        let minimizer = AnyMinimizer::new(number, settings, displacement);
        Self { number, assembler: device.assembler(assembler), shapes, minimizer }
    }

    /// Begins again from another displacement.
    pub fn restart(&mut self, settings: &Settings, displacement: Vec<f64>) {
        self.minimizer = AnyMinimizer::new(self.number, settings, displacement);
    }

    /// Starts a little nearer to the identity if the first deformation is not admissible; from the identity at last.
    ///
    /// A level may end within rounding of a fold, and the interpolant's determinants are rounded differently.
    pub async fn unfold(&mut self, settings: &Settings) {
        let mut share = f64::EPSILON;
        let mut nearer: Option<Vec<f64>> = None;
        while share < 1.0 {
            let displacement = nearer.as_deref().unwrap_or(self.minimizer.displacement());
            if self.assembler.energy(displacement).await.is_admissible() {
                break;
            }
            share = (4.0 * share).min(1.0);
            nearer = Some(self.displacement().iter().map(|u| (1.0 - share) * u).collect());
        }
        if let Some(displacement) = nearer {
            self.restart(settings, displacement);
        }
    }

    /// Gives back what only further iterations would need.
    pub fn rest(&mut self) {
        if let AnyMinimizer::Newton(minimizer) = &mut self.minimizer {
            minimizer.rest();
        }
    }

    pub async fn step(&mut self) -> Progress {
        self.minimizer.step(&mut self.assembler).await
    }

    /// Brings the displacement up to date. None if that is lost: then the next step goes on from what was known last.
    #[cfg(feature = "gpu")]
    pub async fn fetch(&mut self) -> Option<()> {
        match &mut self.minimizer {
            AnyMinimizer::Newton(minimizer) => minimizer.fetch(&mut self.assembler).await,
            AnyMinimizer::Ncg(_) => Some(()),
        }
    }

    /// The energy at the present displacement.
    pub async fn energy(&mut self) -> Evaluation {
        self.assembler.energy(self.minimizer.displacement()).await
    }

    pub fn displacement(&self) -> &[f64] {
        self.minimizer.displacement()
    }

    pub fn shapes(&self) -> [&SignedDistance<D>; 2] {
        [&self.shapes[0], &self.shapes[1]]
    }
}

/// The minimiser that the settings choose.
pub(super) enum AnyMinimizer<const D: usize> {
    Newton(Box<Newton<D>>),
    Ncg(Box<Ncg<D>>),
}

impl<const D: usize> AnyMinimizer<D> {
    pub fn new(number: u32, settings: &Settings, displacement: Vec<f64>) -> Self {
        let grid = Grid::of_level(number);
        let finest = number == settings.finest;
        let tolerance = if finest { settings.tolerance } else { settings.tolerance.max(COARSE_TOLERANCE) };
        match settings.minimizer {
            MinimizerKind::Newton => Self::Newton(Box::new(Newton::new(grid, displacement, tolerance))),
            MinimizerKind::Ncg => Self::Ncg(Box::new(Ncg::new(grid, displacement, settings.sobolev, tolerance))),
        }
    }
}

impl<const D: usize> Minimizer<D> for AnyMinimizer<D> {
    async fn step(&mut self, assembler: &mut impl Assembler<D>) -> Progress {
        match self {
            Self::Newton(minimizer) => minimizer.step(assembler).await,
            Self::Ncg(minimizer) => minimizer.step(assembler).await,
        }
    }

    fn displacement(&self) -> &[f64] {
        match self {
            Self::Newton(minimizer) => minimizer.displacement(),
            Self::Ncg(minimizer) => minimizer.displacement(),
        }
    }
}
