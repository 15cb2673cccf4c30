//! Registers a family of pairs with default settings and says of each how it ended:
//! `cargo run --release --example families -- FAMILY [--count N] [--from N] [--level L] [--only NAME] [--threads N]`.
//!
//! | FAMILY | pairs |
//! |---|---|
//! | `silhouettes` | unlike silhouettes of the page's gallery; `npm run silhouettes` writes them first |
//! | `unlike` | stars with unlike numbers of tips, 3 to 9 |
//! | `deep` | stars whose tips are long and narrow |
//! | `random` | blobs and stars, turned, scaled and shifted |
//! | `PATH.json` | neighbours and third neighbours of a file of polygons, `[{ "name": …, "points": [[x, y], …] }, …]` |
//!
//! A match is good if no part of the moved reference is further than half a cell from the template and no part of the
//! template is further than a cell from the moved reference. A pair is resolvable if the necks and gaps of both shapes are two cells wide. The cost
//! counts iterations in units of the finest level. Pairs run on as many threads as asked for, one unless told, which changes
//! their times and nothing else.

#[path = "../../tests/common/mod.rs"]
mod common;
mod family;
mod run;

use family::Pair;
use run::{Outcome, run};
use std::process::exit;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

struct Options {
    family: String,
    count: Option<usize>,
    from: usize,
    level: u32,
    only: Option<String>,
    threads: usize,
}

fn main() {
    let options = options().unwrap_or_else(|problem| {
        eprintln!("{problem}\n\nfamilies silhouettes|unlike|deep|random|PATH.json [--count N] [--from N] [--level L] [--only NAME] [--threads N]");
        exit(2)
    });
    let pairs = family::pairs(&options.family, options.from, options.count).unwrap_or_else(|problem| {
        eprintln!("{problem}");
        exit(1)
    });
    let wanted = |pair: &Pair| options.only.as_ref().is_none_or(|name| pair.name.contains(name.as_str()));
    let pairs: Vec<Pair> = pairs.into_iter().filter(wanted).collect();
    println!("{}", Outcome::HEAD);
    let outcomes = register(&pairs, options.level, options.threads);
    summarise(&outcomes, options.level);
}

fn options() -> Result<Options, String> {
    let mut words = std::env::args().skip(1);
    let family = words.next().ok_or("Which family?")?;
    let mut options = Options { family, count: None, from: 0, level: 7, only: None, threads: 1 };
    while let Some(word) = words.next() {
        let value = words.next().ok_or(format!("{word} needs a value."))?;
        let number = || value.parse::<usize>().map_err(|_| format!("{word} needs a whole number, not {value}."));
        match word.as_str() {
            "--count" => options.count = Some(number()?),
            "--from" => options.from = number()?,
            "--level" => options.level = number()? as u32,
            "--threads" => options.threads = number()?.max(1),
            "--only" => options.only = Some(value),
            _ => return Err(format!("There is no option {word}.")),
        }
    }
    Ok(options)
}

/// Registers all pairs and prints each in its order, as soon as those before it are done.
fn register(pairs: &[Pair], level: u32, threads: usize) -> Vec<Outcome> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    std::thread::scope(|scope| {
        for _ in 0..threads {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    let Some(pair) = pairs.get(number) else { break };
                    // The receiver lives as long as this scope.
                    let _ = sender.send((number, run(pair, level)));
                }
            });
        }
        drop(sender);
        let mut ended: Vec<Option<Outcome>> = pairs.iter().map(|_| None).collect();
        let mut printed = 0;
        for (number, outcome) in receiver {
            ended[number] = Some(outcome);
            while let Some(Some(outcome)) = ended.get(printed) {
                println!("{outcome}");
                printed += 1;
            }
        }
        ended.into_iter().flatten().collect()
    })
}

fn summarise(outcomes: &[Outcome], level: u32) {
    let median = |value: &dyn Fn(&Outcome) -> f64| {
        let mut values: Vec<f64> = outcomes.iter().filter(|outcome| outcome.resolvable()).map(value).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
    };
    let resolvable: Vec<&Outcome> = outcomes.iter().filter(|outcome| outcome.resolvable()).collect();
    let good = resolvable.iter().filter(|outcome| outcome.is_good()).count();
    let folded = outcomes.iter().filter(|outcome| outcome.least_determinant <= 0.0).count();
    let worst = resolvable.iter().map(|outcome| outcome.mismatch_max).max_by(f64::total_cmp).unwrap_or(f64::NAN);
    println!("\n{} pairs at level {level}, {} resolvable: {good} good", outcomes.len(), resolvable.len());
    let rest = outcomes.len() - resolvable.len();
    let good_rest = outcomes.iter().filter(|outcome| !outcome.resolvable() && outcome.is_good()).count();
    println!("of the {rest} that are not: {good_rest} good; folded of all: {folded}");
    println!(
        "resolvable: greatest mismatch {:.2} cells in the median, {worst:.2} at worst; cost {:.0}, {:.0} ms in the median",
        median(&|outcome| outcome.mismatch_max),
        median(&|outcome| outcome.cost),
        median(&|outcome| outcome.millis),
    );
    for outcome in resolvable.iter().filter(|outcome| !outcome.is_good()) {
        println!("missed: {outcome}: {}", outcome.verdict);
    }
}
