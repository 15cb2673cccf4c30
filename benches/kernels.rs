//! Medians of every kernel: `cargo bench --bench kernels [part of a name]`.

#[path = "kernels/mod.rs"]
mod kernels;

use std::time::Instant;

/// Time spent on each kernel, and the fewest runs.
const BUDGET_SECONDS: f64 = 1.0;
const LEAST_RUNS: usize = 7;

fn main() {
    // cargo passes its own flags; a word without a dash selects.
    let wanted = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();
    println!("{:42} {:>10} {:>10} {:>10}   {:>9}", "", "least ms", "median ms", "most ms", "ns a cell");
    for mut kernel in kernels::kernels().into_iter().filter(|kernel| kernel.name.contains(&wanted)) {
        (kernel.run)();
        let (begin, mut times) = (Instant::now(), Vec::new());
        while times.len() < LEAST_RUNS || begin.elapsed().as_secs_f64() < BUDGET_SECONDS {
            let start = Instant::now();
            (kernel.run)();
            times.push(start.elapsed().as_secs_f64() * 1e3);
        }
        times.sort_by(f64::total_cmp);
        let median = times[times.len() / 2];
        let share =
            if kernel.cells > 1 { format!("{:9.1}", median * 1e6 / kernel.cells as f64) } else { String::new() };
        println!("{:42} {:10.3} {:10.3} {:10.3}   {share}", kernel.name, times[0], median, times[times.len() - 1]);
    }
}
