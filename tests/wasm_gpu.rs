//! The assembler on a graphics card, in a worker of headless Chromium, whose own compiler takes the shaders and whose
//! answers are waited for: `npm test -- wasm`. What it computes is tested natively, in `gpu.rs`.
#![cfg(all(target_arch = "wasm32", feature = "gpu"))]

use thinshell::assemble::{Assembler, CpuAssembler, Gpu, GpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::settings::Settings;
use thinshell::stencil::StencilOperator;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_dedicated_worker);

/// As natively: of energies ten times what was found, of gradients and blocks relative to their norms.
const TOLERANCE: f64 = 1e-4;

fn ball<const D: usize>(grid: Grid<D>, radius: f64) -> SignedDistance<D> {
    let distance = |x: [f64; D]| x.iter().map(|x| (x - 0.5).powi(2)).sum::<f64>().sqrt() - radius;
    SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|node| distance(grid.position(node))).collect())
}

fn is_near(found: &[f64], expected: &[f64]) -> bool {
    let square = |a: &mut dyn Iterator<Item = f64>| a.map(|x| x * x).sum::<f64>();
    let error = square(&mut found.iter().zip(expected).map(|(a, b)| a - b));
    error <= TOLERANCE * TOLERANCE * square(&mut expected.iter().copied())
}

async fn agree<const D: usize>(level: u32) {
    let gpu = Gpu::open().await.expect("Chromium plays a graphics card");
    let grid = Grid::<D>::of_level(level);
    let functional = Settings::default().thrifty_functional::<D>(level);
    let [mut truth, twin] = [(), ()].map(|()| CpuAssembler::new(&functional, &ball(grid, 0.25), &ball(grid, 0.28)));
    let mut assembler = GpuAssembler::<D>::new(gpu.clone(), twin);
    let count = grid.node_count() * D;
    let u: Vec<f64> = (0..count).map(|k| 0.07 * grid.spacing() * (1.7 * (k * k % 1000) as f64).sin()).collect();
    let [(mut expected, mut operator), (mut gradient, mut computed)] =
        [(), ()].map(|()| (vec![0.0; count], StencilOperator::zero(grid)));
    let evaluation = truth.hessian(&u, &mut expected, &mut operator).await;
    let found = assembler.hessian(&u, &mut gradient, &mut computed).await;
    assert!(assembler.backend().starts_with("gpu: "), "{}", assembler.backend());
    assert!((found.total() - evaluation.total()).abs() <= TOLERANCE * evaluation.total(), "{found:?} {evaluation:?}");
    assert!(is_near(&gradient, &expected));
    let [computed, operator] = [computed, operator].map(|o| o.numbers().map(f64::from).collect::<Vec<_>>());
    assert!(is_near(&computed, &operator));

    gpu.destroy();
    assert_eq!(assembler.energy(&u).await, truth.energy(&u).await, "without a device the processor goes on");
    assert!(assembler.backend().starts_with("cpu: "), "{}", assembler.backend());
}

#[wasm_bindgen_test]
async fn curves_on_the_card_are_the_processors_and_outlive_it() {
    agree::<2>(5).await;
}

#[wasm_bindgen_test]
async fn surfaces_on_the_card_are_the_processors_and_outlive_it() {
    agree::<3>(4).await;
}
