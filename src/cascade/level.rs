use crate::assemble::{Assembler, CpuAssembler, Evaluation};
use crate::distance::SignedDistance;
use crate::grid::Grid;
use crate::minimize::{Minimizer, Ncg, Newton, Progress, Stop};
use crate::settings::{MinimizerKind, Settings};

/// Iterations that refine the inverse of an exchanged match. More would start to crumple the shell, which is what the
/// exchange avoids.
const REFINEMENT: usize = 10;

/// Relative decrease at which levels before the finest end: the next one changes the functional, so the last digits of
/// this one's minimum are not worth their iterations.
const COARSE_TOLERANCE: f64 = 1e-4;

/// What one level needs.
pub(super) struct Level<const D: usize> {
    pub number: u32,
    /// The template is the shell and the reference its aim: the level works on φ⁻¹.
    pub exchanged: bool,
    pub assembler: CpuAssembler<D>,
    minimizer: AnyMinimizer<D>,
    limit: usize,
}

enum AnyMinimizer<const D: usize> {
    Newton(Newton<D>),
    Ncg(Ncg<D>),
}

impl<const D: usize> Level<D> {
    /// `shapes` are reference and template; the deformation starts from the identity if none is given.
    pub fn new(
        number: u32,
        settings: &Settings,
        shapes: [&SignedDistance<D>; 2],
        exchanged: bool,
        displacement: Option<Vec<f64>>,
    ) -> Self {
        let [reference, template] = shapes.map(|shape| shape.to_cells(1 << number));
        let (shell, aim) = if exchanged { (template, reference) } else { (reference, template) };
        let assembler = CpuAssembler::new(&settings.functional(number), &shell, &aim);
        let displacement = displacement.unwrap_or_else(|| vec![0.0; shell.grid().node_count() * D]);
        let minimizer = AnyMinimizer::new(number, settings, displacement);
        Self { number, exchanged, assembler, minimizer, limit: usize::MAX }
    }

    /// Begins again from another displacement.
    pub fn restart(&mut self, settings: &Settings, displacement: Vec<f64>) {
        self.minimizer = AnyMinimizer::new(self.number, settings, displacement);
    }

    /// Starts a little nearer to the identity if the first deformation is not admissible; from the identity at last.
    ///
    /// A level may end within rounding of a fold, and the interpolant's determinants are rounded differently.
    pub async fn unfold(&mut self, settings: &Settings) {
        let given = self.displacement().to_vec();
        let mut displacement = given.clone();
        let mut share = f64::EPSILON;
        while share < 1.0 && !self.assembler.energy(&displacement).await.is_admissible() {
            share = (4.0 * share).min(1.0);
            displacement = given.iter().map(|u| (1.0 - share) * u).collect();
        }
        if share > f64::EPSILON {
            self.restart(settings, displacement);
        }
    }

    pub fn limit_to_refinement(&mut self) {
        self.limit = REFINEMENT;
    }

    pub async fn step(&mut self) -> Progress {
        let mut progress = match &mut self.minimizer {
            AnyMinimizer::Newton(minimizer) => minimizer.step(&mut self.assembler).await,
            AnyMinimizer::Ncg(minimizer) => minimizer.step(&mut self.assembler).await,
        };
        if progress.iterations >= self.limit {
            progress.stop = progress.stop.or(Some(Stop::Refined));
        }
        progress
    }

    /// The energy at the present displacement.
    pub async fn energy(&mut self) -> Evaluation {
        self.assembler.energy(self.minimizer.displacement()).await
    }

    /// The displacement the level works on: of φ, or of φ⁻¹ while the roles are exchanged.
    pub fn displacement(&self) -> &[f64] {
        self.minimizer.displacement()
    }
}

impl<const D: usize> AnyMinimizer<D> {
    fn displacement(&self) -> &[f64] {
        match self {
            Self::Newton(minimizer) => minimizer.displacement(),
            Self::Ncg(minimizer) => minimizer.displacement(),
        }
    }

    fn new(number: u32, settings: &Settings, displacement: Vec<f64>) -> Self {
        let grid = Grid::of_level(number);
        let finest = number == settings.finest;
        let tolerance = if finest { settings.tolerance } else { settings.tolerance.max(COARSE_TOLERANCE) };
        match settings.minimizer {
            MinimizerKind::Newton => Self::Newton(Newton::new(grid, displacement, tolerance)),
            MinimizerKind::Ncg => Self::Ncg(Ncg::new(grid, displacement, settings.sobolev, tolerance)),
        }
    }
}
