//! Fast marching: |∇d| = 1 solved outward from the zero set of a level set.
//!
//! Source: J. A. Sethian, "A fast marching level set method for monotonically advancing fronts", PNAS 93 (1996);
//! the second-order differences and the start from projections onto the zero set follow Sethian, "Fast marching
//! methods", SIAM Review 41 (1999) and D. L. Chopp, "Some improvements of the fast marching method", SIAM J. Sci.
//! Comput. 23 (2001).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::project::Cubic;
use crate::grid::Grid;

/// The signed distance to the zero set of `values`; zero counts as positive.
///
/// Nodes next to the zero set are projected onto the zero set of the cubic interpolant (which is fourth-order close to
/// that of a smooth function), the others follow by second-order upwind differences.
pub(super) fn redistance<const D: usize>(grid: Grid<D>, values: &[f64]) -> Vec<f64> {
    let cubic = Cubic::new(grid, values);
    let mut signed = vec![f64::INFINITY; values.len()];
    let mut seeds = Vec::new();
    for node in 0..values.len() {
        if let Some(distance) = next_to_zero(&cubic, grid, values, node) {
            signed[node] = distance * side(values[node]);
            seeds.push(node);
        } else {
            signed[node] *= side(values[node]);
        }
    }
    march(grid, &mut signed, &seeds);
    // No node is at −0.
    signed.iter_mut().for_each(|value| *value += 0.0);
    signed
}

/// −1 inside; zero is outside, whatever its own sign.
fn side(value: f64) -> f64 {
    if value < 0.0 { -1.0 } else { 1.0 }
}

/// The distance of a node that has a neighbour of the other sign.
fn next_to_zero<const D: usize>(cubic: &Cubic<D>, grid: Grid<D>, values: &[f64], node: usize) -> Option<f64> {
    let value = values[node];
    let index = grid.node_index(node);
    let (mut inverse_squares, mut without) = (0.0, 0.0);
    for axis in 0..D {
        let stride = grid.stride(axis);
        let below = (index[axis] > 0).then(|| values[node - stride]);
        let above = (index[axis] < grid.cells()).then(|| values[node + stride]);
        let crossing = [below, above]
            .into_iter()
            .flatten()
            .filter(|neighbour| (*neighbour < 0.0) != (value < 0.0))
            .map(|neighbour| value / (value - neighbour))
            .fold(f64::INFINITY, f64::min);
        inverse_squares += 1.0 / (crossing * crossing);
        without += if crossing.is_finite() { 0.0 } else { 1.0 };
    }
    if inverse_squares == 0.0 {
        return None;
    }
    // The plane through the crossings on the axes, in cells; a zero crossing gives 1/∞ = 0. On axes without a
    // crossing the plane may pass anywhere from one cell off to never: that leaves a range, and rough data a margin.
    let (nearest, farthest) = (1.0 / f64::sqrt(inverse_squares + without), 1.0 / f64::sqrt(inverse_squares));
    let trusted = |distance: &f64| (nearest - 0.25..=farthest + 0.1).contains(distance);
    let cells = cubic.distance(index).filter(trusted).unwrap_or(farthest);
    Some(cells * grid.spacing())
}

/// Solves |∇d| = 1. On entry `signed` is right at the seeds and ±∞ elsewhere, the sign telling the side.
///
/// Across the seeds differences see the other side's values with their sign, which continues d smoothly.
pub(super) fn march<const D: usize>(grid: Grid<D>, signed: &mut [f64], seeds: &[usize]) {
    let mut known = vec![false; signed.len()];
    for &seed in seeds {
        known[seed] = true;
    }
    // The bits of a non-negative number sort as the number does.
    let mut front = BinaryHeap::new();
    let offer = |from: usize, known: &[bool], signed: &mut [f64], front: &mut BinaryHeap<_>| {
        let index = grid.node_index(from);
        for axis in 0..D {
            let stride = grid.stride(axis);
            let below = (index[axis] > 0).then(|| from - stride);
            let above = (index[axis] < grid.cells()).then(|| from + stride);
            for node in [below, above].into_iter().flatten().filter(|&node| !known[node]) {
                let distance = upwind(grid, known, signed, node);
                if distance < signed[node].abs() {
                    signed[node] = distance.copysign(signed[node]);
                    front.push(Reverse((distance.to_bits(), node)));
                }
            }
        }
    };
    for &seed in seeds {
        offer(seed, &known, signed, &mut front);
    }
    while let Some(Reverse((_, node))) = front.pop() {
        // Superseded entries stay in the heap until they come up.
        if !known[node] {
            known[node] = true;
            offer(node, &known, signed, &mut front);
        }
    }
}

/// The |d| at `node` that its known neighbours imply.
///
/// Along each axis the upwind difference is c (d − b)/h: first order with b the neighbour's value and c = 1, second
/// order with b = (4 d₁ − d₂)/3 and c = 3/2. Then Σ c² (d − b)² = h² over the axes that d is downwind of.
fn upwind<const D: usize>(grid: Grid<D>, known: &[bool], signed: &[f64], node: usize) -> f64 {
    let index = grid.node_index(node);
    let side = 1f64.copysign(signed[node]);
    // (d₁, b, c) for each axis with a known neighbour, d₁ ascending.
    let mut axes = [(0.0, 0.0, 0.0); D];
    let mut count = 0;
    for axis in 0..D {
        let stride = grid.stride(axis);
        let room = [index[axis], grid.cells() - index[axis]];
        let neighbour = |down: bool, steps: usize| {
            let there = if down { node.wrapping_sub(steps * stride) } else { node + steps * stride };
            (room[usize::from(!down)] >= steps && known[there]).then(|| side * signed[there])
        };
        let nearest = [true, false]
            .into_iter()
            .filter_map(|down| neighbour(down, 1).map(|value| (value, down)))
            .min_by(|left, right| left.0.total_cmp(&right.0));
        if let Some((first, down)) = nearest {
            let mut place = count;
            while place > 0 && axes[place - 1].0 > first {
                axes[place] = axes[place - 1];
                place -= 1;
            }
            axes[place] = match neighbour(down, 2).filter(|&second| second <= first) {
                Some(second) => (first, (4.0 * first - second) / 3.0, 1.5),
                None => (first, first, 1.0),
            };
            count += 1;
        }
    }
    let axes = &axes[..count];
    let square = grid.spacing() * grid.spacing();
    for used in (1..=count).rev() {
        let [mut a, mut b, mut c] = [0.0, 0.0, -square];
        for &(_, base, weight) in &axes[..used] {
            let weight = weight * weight;
            a += weight;
            b += weight * base;
            c += weight * base * base;
        }
        let discriminant = b * b - a * c;
        if discriminant >= 0.0 {
            let distance = (b + discriminant.sqrt()) / a;
            // Upwind of d: nothing used may lie farther than d itself.
            if distance >= axes[used - 1].0 {
                return distance.max(0.0);
            }
        }
    }
    // Values that break |∇d| ≤ 1 leave only the first-order step from the nearest.
    axes.first().map_or(f64::INFINITY, |&(first, _, _)| (first + grid.spacing()).max(0.0))
}
