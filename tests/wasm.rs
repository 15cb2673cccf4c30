//! Runs in headless Chromium, in a dedicated worker as on the page: `npm test -- wasm`.
#![cfg(target_arch = "wasm32")]

mod common;

use thinshell::grid::Grid;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_dedicated_worker);

// usize has 32 bits here and 64 natively: numbers of nodes are the first thing that could go wrong for it.
#[wasm_bindgen_test]
fn numbering_is_that_of_the_native_build_on_the_largest_grid() {
    let grid = Grid::<3>::of_level(8);
    assert_eq!(grid.node_count(), 257 * 257 * 257);
    let last = grid.node([256, 256, 256]);
    assert_eq!(last, grid.node_count() - 1);
    assert_eq!(grid.node_index(last), [256, 256, 256]);
    assert_eq!(grid.position(grid.node([0, 128, 256])), [0.0, 0.5, 1.0]);
}

// Sines and cosines differ in their last bits between the platforms: energies agree to a millionth, not to the bit.
#[wasm_bindgen_test]
fn circle_to_ellipse_gives_the_native_result() {
    common::assert_circle_to_ellipse(1e-6);
}
