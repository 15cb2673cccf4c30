//! What is true of signed distances, whatever makes them.

#![cfg(not(target_arch = "wasm32"))]

mod degenerate;
mod level_set;
mod mesh;
mod picture;
mod polygon;
mod refusal;
#[path = "../common/solids.rs"]
mod solids;
mod support;
