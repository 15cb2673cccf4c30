//! Lets a page run the kernels one by one; it holds the clock.
#![cfg(target_arch = "wasm32")]

#[path = "../../kernels/mod.rs"]
mod kernels;

use wasm_bindgen::prelude::*;

#[wasm_bindgen]
pub struct Kernels(Vec<kernels::Kernel>);

#[wasm_bindgen]
impl Kernels {
    #[wasm_bindgen(constructor)]
    #[allow(clippy::new_without_default, reason = "a constructor for JavaScript")]
    pub fn new() -> Self {
        Self(kernels::kernels())
    }

    pub fn names(&self) -> Vec<String> {
        self.0.iter().map(|kernel| kernel.name.clone()).collect()
    }

    /// The cells that a kernel's time is shared among.
    pub fn cells(&self, index: usize) -> usize {
        self.0[index].cells
    }

    pub fn run(&mut self, index: usize) {
        (self.0[index].run)();
    }
}
