//! What a registration takes of the four gigabytes that a module can have, and of what a page should take.

#[cfg(feature = "surfaces")]
use crate::distance::SignedDistance;
use crate::error::Error;
use crate::settings::{Alignment, Settings};

/// Bytes a node of the level that is worked on, the band as wide as the box: measured at 129² and 257² (1.6 to 1.7 kB).
const LEVEL: f64 = 1_800.0;
/// The same on the coarsest level while starts are compared (2.4 to 2.7 kB).
const STARTS: f64 = 2_800.0;
/// Half of what a module can have; the rest is shapes, and memory in pieces.
const MOST: f64 = 2e9;

/// Bytes a node in space: operators on all levels, vectors, distances; and more for each that the band holds. A match in a
/// module took 730 at 65³ and 630 at 129³ with the usual band.
#[cfg(feature = "surfaces")]
const SOLID_LEVEL: f64 = 500.0;
#[cfg(feature = "surfaces")]
const SOLID_BAND: f64 = 1_000.0;
/// What a module can have, but for what cannot be used because it lies in pieces.
#[cfg(feature = "surfaces")]
const SOLID_MOST: f64 = 3.2e9;
/// Starts on the coarsest level, a displacement each: with the level itself they took 4 200 at 33³ and 4 300 at 65³.
#[cfg(feature = "surfaces")]
const SOLID_STARTS: f64 = 3_700.0;

const PIECE: f64 = 1e9;

/// Refuses settings that would need more memory than there is, rather than dying of it later.
pub(super) fn check(settings: &Settings) -> Result<(), Error> {
    let nodes = |level: u32| f64::from((1_u32 << level) + 1).powi(2);
    let starts = if settings.alignment == Alignment::Similarity { STARTS } else { LEVEL };
    let bytes = (LEVEL * nodes(settings.finest)).max(starts * nodes(settings.coarsest));
    is_there(bytes, MOST, settings)
}

/// The same for surfaces, of which each may be the shell.
#[cfg(feature = "surfaces")]
pub(super) fn check_solid(settings: &Settings, shapes: &[SignedDistance<3>; 2]) -> Result<(), Error> {
    let nodes = |level: u32| f64::from((1_u32 << level) + 1).powi(3);
    let bandwidth = settings.functional(settings.finest).bandwidth;
    let is_held = |distance: &&f64| distance.abs() < bandwidth;
    let held = shapes.iter().map(|shape| shape.values().iter().filter(is_held).count()).fold(0, usize::max);
    let level = SOLID_LEVEL + SOLID_BAND * held as f64 / nodes(settings.finest);
    let starts = if settings.alignment == Alignment::Similarity { SOLID_STARTS } else { 0.0 };
    let bytes = (level * nodes(settings.finest)).max((level + starts) * nodes(settings.coarsest));
    is_there(bytes, SOLID_MOST, settings)
}

fn is_there(bytes: f64, most: f64, settings: &Settings) -> Result<(), Error> {
    // Asking for it and giving it back shows whether it is there; in pieces, as no one may be larger than two gigabytes.
    let pieces = (bytes / PIECE).ceil();
    let mut held: Vec<Vec<u8>> = Vec::new();
    let mut reserve = || {
        let mut piece = Vec::new();
        let is_there = piece.try_reserve_exact((bytes / pieces) as usize).is_ok();
        held.push(piece);
        is_there
    };
    let there = bytes <= most && (0..pieces as usize).all(|_| reserve());
    if there { Ok(()) } else { Err(Error::Memory { gigabytes: bytes * 1e-9, finest: settings.finest }) }
}
