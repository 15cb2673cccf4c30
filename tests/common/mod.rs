//! Shapes by formula, for tests, benchmarks and examples.
#![allow(dead_code, reason = "each user takes some of the shapes")]

use glam::DVec2;
use std::f64::consts::TAU;
use thinshell::distance::SignedDistance;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::search::Search;
use thinshell::settings::{Backend, Settings};
use thinshell::stencil::StencilOperator;

/// r(θ) around `centre`, turned by `angle`, at `count` points.
pub fn polar(centre: [f64; 2], angle: f64, count: usize, radius: impl Fn(f64) -> f64) -> Vec<DVec2> {
    (0..count)
        .map(|k| {
            let theta = TAU * k as f64 / count as f64;
            DVec2::from(centre) + radius(theta) * DVec2::from_angle(theta + angle)
        })
        .collect()
}

pub fn circle(centre: [f64; 2], radius: f64) -> Vec<DVec2> {
    polar(centre, 0.0, 256, |_| radius)
}

pub fn ellipse(centre: [f64; 2], a: f64, b: f64) -> Vec<DVec2> {
    (0..512)
        .map(|k| {
            let (sin, cos) = (TAU * k as f64 / 512.0).sin_cos();
            DVec2::new(centre[0] + a * cos, centre[1] + b * sin)
        })
        .collect()
}

/// A star with soft tips.
pub fn star(centre: [f64; 2], radius: f64, tips: u32, depth: f64, angle: f64) -> Vec<DVec2> {
    polar(centre, angle, 512, |theta| radius * (1.0 + depth * (f64::from(tips) * theta).cos()))
}

/// A lobed leaf: one long lobe, two to the sides, a notch at the stalk.
pub fn leaf(centre: [f64; 2], size: f64, lobes: f64, angle: f64) -> Vec<DVec2> {
    polar(centre, angle, 512, |theta| {
        size * (1.0 + 0.3 * theta.cos() + lobes * (3.0 * theta).cos() + 0.08 * (5.0 * theta).cos())
    })
}

/// SplitMix64: a small seeded generator, so that the same pairs come out everywhere.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in low..high.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A smooth closed curve: a circle of about `radius` with random harmonics 2 to 5.
pub fn blob(random: &mut Random, centre: [f64; 2], radius: f64) -> Vec<DVec2> {
    let harmonics: Vec<[f64; 3]> =
        (2..6).map(|k| [f64::from(k), random.between(0.0, 0.3) / f64::from(k), random.between(0.0, TAU)]).collect();
    polar(centre, 0.0, 512, |theta| {
        radius * (1.0 + harmonics.iter().map(|[k, size, phase]| size * (k * theta + phase).cos()).sum::<f64>())
    })
}

/// The image of a curve under a turn, a scaling about its own centre `from`, and a shift of the centre to `to`.
pub fn moved(curve: &[DVec2], from: [f64; 2], to: [f64; 2], angle: f64, scale: f64) -> Vec<DVec2> {
    let turn = scale * DVec2::from_angle(angle);
    curve.iter().map(|&p| DVec2::from(to) + turn.rotate(p - DVec2::from(from))).collect()
}

/// A random pair: two blobs, or two stars with as many tips but of different depths; the second turned by up to ±60°,
/// scaled by 0.6 to 1.6 and shifted by up to 0.12.
pub fn random_pair(random: &mut Random) -> [Vec<DVec2>; 2] {
    let centre = [0.5, 0.5];
    let scale = random.between(0.6, 1.6);
    // The larger of the two has radius 0.2, so that it stays in the box when shifted.
    let radius = 0.2 / scale.max(1.0);
    let blobs = random.next().is_multiple_of(2);
    let tips = 3 + (random.next() % 4) as u32;
    let mut shape = || {
        if blobs {
            blob(random, centre, radius)
        } else {
            let (depth, angle) = (random.between(0.1, 0.3), random.between(-0.2, 0.2));
            star(centre, radius, tips, depth, angle)
        }
    };
    let (reference, template) = (shape(), shape());
    let shift = random.between(0.0, 0.12) * DVec2::from_angle(random.between(0.0, TAU));
    let to = [centre[0] + shift.x, centre[1] + shift.y];
    let angle = random.between(-60_f64, 60.0).to_radians();
    [reference, moved(&template, centre, to, angle, scale)]
}

/// Energies (membrane, bending, mismatch, volume) at the end of circle → ellipse on 33², as the native
/// build gave them (printed by the function below when they do not agree); converged far beyond the default tolerance, so
/// that they say where the minimum lies and not where an iteration stopped.
const CIRCLE_TO_ELLIPSE: [f64; 4] =
    [0.012702951575170467, 0.0006135391261549896, 9.379433499240043e-5, 0.008867746375324722];

/// Registers the pair and compares with the record, relative to the total energy.
pub fn assert_circle_to_ellipse(tolerance: f64) {
    let grid = Grid::of_level(5);
    let shape = |curve| SignedDistance::from_loops(grid, &[curve]).expect("a valid curve");
    let (reference, template) = (shape(circle([0.5; 2], 0.15)), shape(ellipse([0.5; 2], 0.3, 0.2)));
    // A build that has graphics cards would wait for one.
    let settings = Settings { finest: 5, tolerance: 1e-12, backend: Backend::Cpu, ..Settings::default() };
    let mut cascade = ready(Search::new(reference, template, settings)).expect("valid settings");
    let end = loop {
        let progress = ready(cascade.step());
        if progress.stop.is_some() {
            break progress.evaluation.energies;
        }
    };
    let found = [end.membrane, end.bending, end.mismatch, end.volume];
    for (a, b) in found.iter().zip(CIRCLE_TO_ELLIPSE) {
        assert!((a - b).abs() <= tolerance * end.total(), "{found:?} is not {CIRCLE_TO_ELLIPSE:?}");
    }
}

/// A x by the stencil, f64.
pub fn apply<const D: usize>(operator: &StencilOperator<D>, x: &[f64]) -> Vec<f64> {
    let mut result = vec![0.0; x.len()];
    operator.for_each_block(|node, other, block| {
        for i in 0..D {
            for j in 0..D {
                result[node * D + i] += f64::from(block[i][j]) * x[other * D + j];
            }
        }
    });
    result
}
