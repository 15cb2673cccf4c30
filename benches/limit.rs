//! How far the energy kernel is from what one core sustains: `cargo bench --bench limit`.
//!
//! The kernel is run once over a scalar that counts, then timed over its lanes, then compared with a plain loop that
//! does the same numbers of additions, multiplications, divisions and roots on independent registers and nothing else.

#[path = "kernels/mod.rs"]
mod kernels;

use kernels::{displacement, distances, pairs};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Instant;
use thinshell::assemble::{Assembler, CpuAssembler};
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::settings::Settings;
use thinshell::small::{F64x2, Scalar};

static SUMS: AtomicU64 = AtomicU64::new(0);
static PRODUCTS: AtomicU64 = AtomicU64::new(0);
static QUOTIENTS: AtomicU64 = AtomicU64::new(0);

/// A number that counts what is done with it. Signs, comparisons and loads are free.
#[derive(Clone, Copy, Default)]
struct Counted(f64);

fn count(counter: &AtomicU64, value: f64) -> Counted {
    counter.fetch_add(1, Relaxed);
    Counted(value)
}

impl Add for Counted {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        count(&SUMS, self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        count(&SUMS, self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        count(&PRODUCTS, self.0 * other.0)
    }
}

impl Div for Counted {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        count(&QUOTIENTS, self.0 / other.0)
    }
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl AddAssign for Counted {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Counted {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Scalar for Counted {
    const LANES: usize = 1;

    fn splat(value: f64) -> Self {
        Self(value)
    }
    fn gather(f: impl Fn(usize) -> f64) -> Self {
        Self(f(0))
    }
    fn lane(self, _: usize) -> f64 {
        self.0
    }
    fn sqrt(self) -> Self {
        count(&QUOTIENTS, self.0.sqrt())
    }
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
}

const LEVEL: u32 = 7;
const RUNS: usize = 41;

fn main() {
    let grid = Grid::<2>::of_level(LEVEL);
    let cells = grid.cell_count() as f64;
    let [reference, template] = distances(LEVEL, &pairs()[0].1);
    let functional = Settings::default().functional(LEVEL);
    let u = displacement(grid);
    let mut gradient = vec![0.0; u.len()];

    let mut counting: CpuAssembler<2, Counted> = CpuAssembler::new(&functional, &reference, &template);
    ready(counting.gradient(&u, &mut gradient));
    let [sums, products, quotients] =
        [&SUMS, &PRODUCTS, &QUOTIENTS].map(|counter| counter.load(Relaxed) as f64 / cells);
    let band = counting.band_cells() as f64 / cells;

    let mut assembler: CpuAssembler<2, F64x2> = CpuAssembler::new(&functional, &reference, &template);
    let mut kernel = || {
        std::hint::black_box(ready(assembler.gradient(&u, &mut gradient)));
    };
    let mut plain = || plain_loop(cells, sums, products, quotients);
    // In turn, so that a change of the machine's speed meets both.
    let (mut kernel_times, mut plain_times) = (Vec::new(), Vec::new());
    for _ in 0..RUNS {
        kernel_times.push(nanoseconds(&mut kernel) / cells);
        plain_times.push(nanoseconds(&mut plain) / cells);
    }
    let [kernel, plain] = [kernel_times, plain_times].map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[RUNS / 2]
    });
    // u and the gradient in and out, the weight; in the band 9 points of 7 numbers, and 4 nodes of 4 numbers a point.
    let bytes = 16.0 + 32.0 + 8.0 + band * 9.0 * (7.0 + 16.0) * 8.0;
    println!("energy + gradient, circle → ellipse at 129², a cell ({:.0} % of them in the band):", 100.0 * band);
    println!("  {sums:.0} additions, {products:.0} multiplications, {quotients:.1} divisions");
    println!("  {bytes:.0} bytes touched, {:.1} operations a byte", (sums + products + quotients) / bytes);
    println!("  kernel {kernel:.1} ns, {:.2} operations a ns", (sums + products + quotients) / kernel);
    println!("  plain loop of the same operations {plain:.1} ns");
    println!("  share of what the core sustains {:.0} %", 100.0 * plain / kernel);
}

fn nanoseconds(run: &mut impl FnMut()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64() * 1e9
}

/// The same numbers of operations on independent pairs of lanes, divisions among the others: they have a unit of their own.
fn plain_loop(cells: f64, sums: f64, products: f64, quotients: f64) {
    const CHAINS: usize = 12;
    let one = F64x2::splat(std::hint::black_box(1.000_000_1));
    let mut chains: [F64x2; CHAINS] = std::array::from_fn(|k| F64x2::splat(1.0 + k as f64));
    let mut divided: [F64x2; 4] = std::array::from_fn(|k| F64x2::splat(1.5 + k as f64));
    let lanes = F64x2::LANES as f64;
    let divisions = (cells * quotients / lanes) as usize;
    let pairs = (cells * sums.min(products) / lanes) as usize / CHAINS;
    let rest = (cells * (sums - products).abs() / lanes) as usize / CHAINS;
    let (mut pairs_due, mut rest_due) = (0, 0);
    for division in 0..divisions {
        (pairs_due, rest_due) = (pairs_due + pairs, rest_due + rest);
        while pairs_due >= divisions {
            pairs_due -= divisions;
            for chain in &mut chains {
                *chain = *chain * one + one;
            }
        }
        while rest_due >= divisions {
            rest_due -= divisions;
            for chain in &mut chains {
                *chain *= one;
            }
        }
        let quotient = &mut divided[division % 4];
        *quotient = one / *quotient;
    }
    std::hint::black_box((chains, divided));
}
