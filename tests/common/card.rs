//! The graphics card of tests.

use std::io::{Write, stderr};
use std::rc::Rc;
use thinshell::assemble::Gpu;
use thinshell::ready::ready;

/// The card, or a processor that plays one. Without, there is nothing to test; on a machine that is to test everything
/// that is a failure.
pub fn card() -> Option<Rc<Gpu>> {
    match ready(Gpu::open()) {
        Ok(gpu) => Some(gpu),
        Err(reason) => {
            assert!(std::env::var_os("CI").is_none(), "CI has a software card: {reason}");
            // Not by `eprintln`, which a test that passes keeps to itself.
            let told =
                writeln!(stderr(), "skipped: {reason}; on Debian `apt-get install mesa-vulkan-drivers` brings one");
            told.expect("the standard error is open");
            None
        }
    }
}
