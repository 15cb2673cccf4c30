//! Near folds: the search goes on while the energy can fall, and no level starts folded.

#[path = "common/mod.rs"]
mod shapes;

use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::minimize::Stop;
use thinshell::ready::ready;
use thinshell::search::{Search, SearchProgress};
use thinshell::settings::{Alignment, MinimizerKind, Settings};

/// A circle drawn out to an ellipse more than three times as long by volume energy alone, the paper's Table 1, right:
/// nothing evens out the stretch, so single cells come close to folding.
fn drawn_out(settings: Settings) -> (Search<2>, SearchProgress) {
    let settings = Settings {
        membrane: 0.0,
        bending: 0.0,
        volume: 1.0,
        softness: 1e-3,
        penalty: 1e5,
        halving: false,
        bandwidth: 0.04,
        alignment: Alignment::None,
        ..settings
    };
    let grid = Grid::of_level(settings.finest);
    let reference = SignedDistance::from_loops(grid, &[shapes::circle([0.5, 0.5], 0.12)]).unwrap();
    let template = SignedDistance::from_loops(grid, &[shapes::ellipse([0.5, 0.5], 0.4106, 0.12)]).unwrap();
    let mut cascade = ready(Search::new(reference, template, settings)).unwrap();
    loop {
        let progress = ready(cascade.step());
        assert!(progress.evaluation.is_admissible(), "level {}: {:?}", progress.level, progress.evaluation);
        if progress.stop.is_some() {
            return (cascade, progress);
        }
    }
}

#[test]
fn newton_finds_a_step_beside_a_nearly_folded_cell() {
    let (_, progress) = drawn_out(Settings { coarsest: 5, finest: 5, ..Settings::default() });
    assert_ne!(progress.stop, Some(Stop::NoDescent), "at iteration {}", progress.iteration);
}

#[test]
fn a_level_that_ends_at_a_fold_hands_on_an_admissible_deformation() {
    for minimizer in [MinimizerKind::Newton, MinimizerKind::Ncg] {
        // Without vertex share nothing but refusal keeps the corners from folding.
        let settings = Settings { coarsest: 4, finest: 6, vertex_share: 0.0, minimizer, ..Settings::default() };
        let (_, progress) = drawn_out(settings);
        assert_eq!(progress.level, 6);
    }
}
