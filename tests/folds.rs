//! Near folds: the search goes on while the energy can fall, and no level starts folded.

#[path = "common/mod.rs"]
mod shapes;
#[path = "common/solids.rs"]
mod solids;

use solids::{ellipsoid, solid, sphere};
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::minimize::Stop;
use thinshell::ready::ready;
use thinshell::search::{Search, SearchProgress};
use thinshell::settings::{Alignment, MinimizerKind, Settings};

/// What nothing but the volume energy holds, the paper's Table 1, right: nothing evens out the stretch, so single cells
/// come close to folding.
fn torn(settings: Settings) -> Settings {
    Settings {
        membrane: 0.0,
        bending: 0.0,
        volume: 1.0,
        softness: 1e-3,
        penalty: 1e5,
        halving: false,
        bandwidth: 0.04,
        alignment: Alignment::None,
        ..settings
    }
}

/// Registers; admissible all the way.
fn register<const D: usize>([reference, template]: [SignedDistance<D>; 2], settings: Settings) -> SearchProgress {
    let mut search = ready(Search::new(reference, template, torn(settings))).unwrap();
    loop {
        let progress = ready(search.step());
        assert!(progress.evaluation.is_admissible(), "level {}: {:?}", progress.level, progress.evaluation);
        if progress.stop.is_some() {
            return progress;
        }
    }
}

/// A circle, and an ellipse more than three times as long.
fn curves(level: u32) -> [SignedDistance<2>; 2] {
    [shapes::circle([0.5, 0.5], 0.12), shapes::ellipse([0.5, 0.5], 0.4106, 0.12)]
        .map(|curve| SignedDistance::from_loops(Grid::of_level(level), &[curve]).unwrap())
}

/// A sphere, and an ellipsoid more than three times as long.
fn surfaces(level: u32) -> [SignedDistance<3>; 2] {
    [solid(level, sphere(0.11)), solid(level, ellipsoid([0.37, 0.11, 0.11]))]
}

#[test]
fn newton_finds_a_step_beside_a_nearly_folded_cell() {
    let settings = |level| Settings { coarsest: level, finest: level, ..Settings::default() };
    for (what, progress) in
        [("curves", register(curves(5), settings(5))), ("surfaces", register(surfaces(4), settings(4)))]
    {
        assert_ne!(progress.stop, Some(Stop::NoDescent), "{what}, at iteration {}", progress.iteration);
    }
}

#[test]
fn a_level_that_ends_at_a_fold_hands_on_an_admissible_deformation() {
    for minimizer in [MinimizerKind::Newton, MinimizerKind::Ncg] {
        // Without vertex share nothing but refusal keeps the corners from folding.
        let settings =
            |coarsest, finest| Settings { coarsest, finest, vertex_share: 0.0, minimizer, ..Settings::default() };
        assert_eq!(register(curves(6), settings(4, 6)).level, 6);
        assert_eq!(register(surfaces(4), settings(3, 4)).level, 4);
    }
}
