//! What a registration takes of the four gigabytes that a module can have, and of what a page should take.

use crate::error::Error;
use crate::settings::{Alignment, Settings};

/// Bytes a node of the level that is worked on, the band as wide as the box: measured at 129² and 257² (1.6 to 1.7 kB).
const LEVEL: f64 = 1_800.0;
/// The same on the coarsest level while starts are compared (2.4 to 2.7 kB).
const STARTS: f64 = 2_800.0;
/// Half of what a module can have; the rest is shapes, and memory in pieces.
const MOST: f64 = 2e9;

/// Refuses settings that would need more memory than there is, rather than dying of it later.
pub(super) fn check(settings: &Settings) -> Result<(), Error> {
    let nodes = |level: u32| f64::from((1_u32 << level) + 1).powi(2);
    let starts = if settings.alignment == Alignment::Similarity { STARTS } else { LEVEL };
    let bytes = (LEVEL * nodes(settings.finest)).max(starts * nodes(settings.coarsest));
    // Asking for it and giving it back shows whether it is there.
    let there = bytes <= MOST && Vec::<u8>::new().try_reserve_exact(bytes as usize).is_ok();
    if there { Ok(()) } else { Err(Error::Memory { gigabytes: bytes * 1e-9, finest: settings.finest }) }
}
