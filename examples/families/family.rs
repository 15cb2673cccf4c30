//! The families of pairs.

use super::common::{Random, polar, random_pair, star};
use glam::DVec2;
use serde::Deserialize;
use std::f64::consts::TAU;

pub struct Pair {
    pub name: String,
    pub reference: Vec<Vec<DVec2>>,
    pub template: Vec<Vec<DVec2>>,
}

pub fn pairs(family: &str, from: usize, count: Option<usize>) -> Result<Vec<Pair>, String> {
    let seeded = |usual: usize, make: fn(&mut Random) -> (String, [Vec<DVec2>; 2])| {
        (from..from + count.unwrap_or(usual)).map(|seed| seeded(seed, make)).collect()
    };
    match family {
        "unlike" => Ok(seeded(200, unlike)),
        "deep" => Ok(seeded(50, deep)),
        "random" => Ok(seeded(500, |random| (String::new(), random_pair(random)))),
        "silhouettes" => Ok(part(silhouettes()?, from, count)),
        path if path.ends_with(".json") => Ok(part(neighbours(path)?, from, count)),
        _ => Err(format!("There is no family {family}.")),
    }
}

fn part(pairs: Vec<Pair>, from: usize, count: Option<usize>) -> Vec<Pair> {
    pairs.into_iter().skip(from).take(count.unwrap_or(usize::MAX)).collect()
}

fn seeded(seed: usize, make: fn(&mut Random) -> (String, [Vec<DVec2>; 2])) -> Pair {
    let (name, [reference, template]) = make(&mut Random(seed as u64));
    Pair { name: format!("{seed} {name}").trim().into(), reference: vec![reference], template: vec![template] }
}

/// Stars of 3 to 9 soft tips, the template with another number of them.
fn unlike(random: &mut Random) -> (String, [Vec<DVec2>; 2]) {
    let from = 3 + random.next() % 7;
    let to = 3 + (from - 3 + 1 + random.next() % 6) % 7;
    let mut make = |tips: u64| {
        let (depth, angle) = (random.between(0.15, 0.35), random.between(0.0, TAU));
        star([0.5; 2], random.between(0.18, 0.26), tips as u32, depth, angle)
    };
    (format!("{from} → {to} tips"), [make(from), make(to)])
}

/// Stars of 4 to 7 tips, as many each, of which one has them long and narrow.
fn deep(random: &mut Random) -> (String, [Vec<DVec2>; 2]) {
    let tips = 4 + random.next() % 4;
    let mut make = |depth: f64| {
        let (angle, sharpness) = (random.between(-0.3, 0.3), random.between(1.0, 1.6));
        let radius = random.between(0.2, 0.24);
        polar([0.5; 2], angle, 1024, |theta| {
            let wave = 0.5 + 0.5 * (tips as f64 * theta).cos();
            radius * (1.0 - depth + 2.0 * depth * wave.powf(sharpness))
        })
    };
    let (shallow, deep) = (make(0.2), make(0.5));
    let pair = if tips.is_multiple_of(2) { [shallow, deep] } else { [deep, shallow] };
    (format!("{tips} tips"), pair)
}

#[derive(Deserialize)]
struct Silhouette {
    name: String,
    loops: Vec<Vec<[f64; 2]>>,
}

const SILHOUETTES: &str = "target/silhouettes.json";

/// How many silhouettes there are in the gallery, and how many pairs are taken of them: by their names in alphabetical
/// order each with the one `STRIDE` further on, which shares nothing with it but chance.
const PAIRS: usize = 60;
const STRIDE: usize = 29;

/// Pairs that are known to be hard.
const NAMED: [[&str; 2]; 6] = [
    ["Hand", "Cactus"],
    ["Guitar", "Airplane"],
    ["France", "Spain"],
    ["Heart", "Butterfly’s wings"],
    ["Butterfly’s wings", "Heart"],
    ["Horse", "Dog"],
];

fn silhouettes() -> Result<Vec<Pair>, String> {
    let text = std::fs::read_to_string(SILHOUETTES)
        .map_err(|_| format!("There is no {SILHOUETTES}; `npm run silhouettes` writes it."))?;
    let all: Vec<Silhouette> = serde_json::from_str(&text).map_err(|problem| format!("{SILHOUETTES}: {problem}"))?;
    let loops = |silhouette: &Silhouette| silhouette.loops.iter().map(|points| curve(points)).collect();
    let pair = |from: &Silhouette, to: &Silhouette| Pair {
        name: format!("{} → {}", from.name, to.name),
        reference: loops(from),
        template: loops(to),
    };
    // The last one is not in the gallery.
    let gallery = &all[..all.len() - 1];
    let mut pairs: Vec<Pair> =
        (0..PAIRS).map(|i| pair(&gallery[i % gallery.len()], &gallery[(i + STRIDE) % gallery.len()])).collect();
    let find = |name: &str| all.iter().find(|s| s.name == name).ok_or(format!("{SILHOUETTES} has no {name}."));
    for [from, to] in NAMED {
        pairs.push(pair(find(from)?, find(to)?));
    }
    Ok(pairs)
}

#[derive(Deserialize)]
struct Polygon {
    name: String,
    points: Vec<[f64; 2]>,
}

fn neighbours(path: &str) -> Result<Vec<Pair>, String> {
    let text = std::fs::read_to_string(path).map_err(|problem| format!("{path}: {problem}"))?;
    let all: Vec<Polygon> = serde_json::from_str(&text).map_err(|problem| format!("{path}: {problem}"))?;
    let pair = |from: &Polygon, to: &Polygon| Pair {
        name: format!("{} → {}", from.name, to.name),
        reference: vec![curve(&from.points)],
        template: vec![curve(&to.points)],
    };
    let apart = |steps: usize| (steps..all.len()).map(move |i| (i - steps, i));
    Ok(apart(1).chain(apart(3)).map(|(from, to)| pair(&all[from], &all[to])).collect())
}

fn curve(points: &[[f64; 2]]) -> Vec<DVec2> {
    points.iter().map(|&point| DVec2::from(point)).collect()
}
