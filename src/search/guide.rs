//! Corresponding points of two closed curves, by elastic matching of the curves alone.
//!
//! Which point of one outline belongs to which of the other does not need the plane: of all monotone assignments γ of arc
//! lengths, the one is sought that makes
//!
//! ∫ |q₁(s) − √γ′ q₂(γ(s))|² + w |x₁(s) − x₂(γ(s))|² ds,  q the unit tangents, x the places in units of the curves' size,
//!
//! least: the first part is the elastic energy of curves by square-root velocities, the second keeps a limb from being
//! matched with one elsewhere. It is found by dynamic programming over sampled arc lengths. Curves cross limbs and gaps in
//! one go that a shell in the plane has to creep into; the shell, led along by some of these points, does not fold.
//!
//! Source: A. Srivastava, E. Klassen, S. H. Joshi, I. H. Jermyn, "Shape Analysis of Elastic Curves in Euclidean Spaces",
//! IEEE TPAMI 33(7), 2011.

use crate::contour::zero_set;
use crate::distance::SignedDistance;
use crate::energy::Pin;
use crate::field::interpolate;
use crate::grid::Grid;
use crate::search::missed::in_plane;
use glam::DVec2;
use std::rc::Rc;

/// Samples of each curve.
const SAMPLES: usize = 160;
/// Beginnings on the second curve that are tried.
const BEGINNINGS: usize = 20;
/// Steps (i, j) of an assignment: γ′ = j/i. A gap's mouth may have to become the whole gap.
const MOST_STEP: usize = 4;
const LONGEST_STEP: usize = 8;
/// w.
const PLACE_WEIGHT: f64 = 1.0;
/// Every which knot of the assignment becomes a pin.
const STRIDE: usize = 2;

/// Share of the length of all outlines that one must have to be matched alone.
const ALONE: f64 = 0.8;

/// Whether there is a guide for these shapes.
pub(super) fn can_guide<const D: usize>(shapes: &[Rc<SignedDistance<D>>; 2]) -> bool {
    shapes.iter().all(|shape| only(&outlines(shape)).is_some())
}

/// The closed curves of a shape in the plane; none of a surface.
fn outlines<const D: usize>(shape: &SignedDistance<D>) -> Vec<Vec<DVec2>> {
    if D == 2 { zero_set(Grid::new(shape.grid().cells()), shape.values()) } else { Vec::new() }
}

/// The same as they were drawn.
fn drawn<const D: usize>(shape: &SignedDistance<D>) -> Vec<Vec<DVec2>> {
    let mut loops: Vec<Vec<DVec2>> = in_plane(&shape.outline()).loops().into_iter().map(|one| one.points).collect();
    for points in &mut loops {
        // As the grid's run.
        let next = |k: usize| points[(k + 1) % points.len()];
        if (0..points.len()).map(|k| points[k].perp_dot(next(k))).sum::<f64>() < 0.0 {
            points.reverse();
        }
    }
    loops
}

/// Pins between the two outlines; none unless both are, but for specks, one closed curve in the plane. `displacement`, at
/// the nodes of the shapes' grid, tells how far the first is turned, where something is known.
pub(super) fn guide<const D: usize>(
    shapes: &[Rc<SignedDistance<D>>; 2],
    as_drawn: bool,
    displacement: Option<&[f64]>,
) -> Vec<Pin<D>> {
    let [first, second] = [0, 1].map(|k| if as_drawn { drawn(&shapes[k]) } else { outlines(&shapes[k]) });
    let (Some(first), Some(second)) = (only(&first), only(&second)) else { return Vec::new() };
    let turn = displacement.map_or(DVec2::X, |u| turn_of(first, Grid::new(shapes[0].grid().cells()), u));
    let (from, to) = (Curve::of(first, turn), Curve::of(second, DVec2::X));
    let step_costs = StepCosts::of(&from, &to);
    let (mut best, mut least) = (Vec::new(), f64::INFINITY);
    for beginning in 0..BEGINNINGS {
        let (cost, path) = assign(&step_costs, beginning * SAMPLES / BEGINNINGS, least);
        if cost < least {
            (best, least) = (path, cost);
        }
    }
    let place = |point: DVec2| std::array::from_fn(|axis| point[axis]);
    let pin = |&[i, j]: &[usize; 2]| Pin { reference: place(from.point(i)), template: place(to.point(j)) };
    best.iter().step_by(STRIDE).map(pin).collect()
}

/// The outline that is nearly all there is.
fn only(outlines: &[Vec<DVec2>]) -> Option<&[DVec2]> {
    let lengths: Vec<f64> = outlines.iter().map(|outline| length(outline)).collect();
    let longest = (0..lengths.len()).max_by(|&a, &b| lengths[a].total_cmp(&lengths[b]))?;
    (lengths[longest] >= ALONE * lengths.iter().sum::<f64>()).then_some(outlines[longest].as_slice())
}

fn length(closed: &[DVec2]) -> f64 {
    (0..closed.len()).map(|k| closed[k].distance(closed[(k + 1) % closed.len()])).sum()
}

/// The rotation, as a unit vector, that comes nearest to φ on a curve.
fn turn_of(curve: &[DVec2], grid: Grid<2>, displacement: &[f64]) -> DVec2 {
    let moved: Vec<DVec2> =
        curve.iter().map(|&x| x + DVec2::from(interpolate::<2, 2>(grid, displacement, &x.to_array()))).collect();
    let mean = |points: &[DVec2]| points.iter().sum::<DVec2>() / points.len() as f64;
    let (from, to) = (mean(curve), mean(&moved));
    let sum: DVec2 =
        curve.iter().zip(&moved).map(|(&x, &y)| DVec2::new((x - from).dot(y - to), (x - from).perp_dot(y - to))).sum();
    sum.try_normalize().unwrap_or(DVec2::X)
}

/// A closed curve at equal arc lengths.
struct Curve {
    points: Vec<DVec2>,
    /// About the centroid, in units of the root mean square distance from it, turned.
    places: Vec<DVec2>,
    /// Unit tangents between a point and the next, turned.
    tangents: Vec<DVec2>,
}

impl Curve {
    fn of(polyline: &[DVec2], turn: DVec2) -> Self {
        let next = |k: usize| polyline[(k + 1) % polyline.len()];
        let length = length(polyline);
        let mut points = Vec::with_capacity(SAMPLES);
        let mut before = 0.0;
        for k in 0..polyline.len() {
            let piece = polyline[k].distance(next(k));
            while points.len() < SAMPLES && points.len() as f64 * length <= (before + piece) * SAMPLES as f64 {
                let t = (points.len() as f64 * length / SAMPLES as f64 - before) / piece;
                points.push(polyline[k].lerp(next(k), t.clamp(0.0, 1.0)));
            }
            before += piece;
        }
        points.resize(SAMPLES, polyline[0]);
        let centre = points.iter().sum::<DVec2>() / SAMPLES as f64;
        let square = points.iter().map(|point| point.distance_squared(centre)).sum::<f64>() / SAMPLES as f64;
        let places = points.iter().map(|&point| turn.rotate(point - centre) / square.sqrt()).collect();
        let tangent = |k: usize| (points[(k + 1) % SAMPLES] - points[k]).try_normalize().unwrap_or(DVec2::X);
        let tangents = (0..SAMPLES).map(|k| turn.rotate(tangent(k))).collect();
        Self { points, places, tangents }
    }

    fn point(&self, k: usize) -> DVec2 {
        self.points[k % SAMPLES]
    }
}

/// The steps (i, j) that an assignment may take.
fn allowed_steps() -> Vec<[usize; 2]> {
    (1..=LONGEST_STEP)
        .flat_map(|i| (1..=LONGEST_STEP).map(move |j| [i, j]))
        .filter(|&[i, j]| coprime(i, j) && (i.max(j) <= MOST_STEP || i.min(j) == 1))
        .collect()
}

/// What each step costs that ends in sample i of one curve, 1 ≤ i ≤ `SAMPLES`, and sample j of the other; for all
/// beginnings the same.
struct StepCosts {
    steps: Vec<[usize; 2]>,
    /// All steps to (1, 0), then those to (1, 1), …
    costs: Vec<f64>,
}

impl StepCosts {
    fn of(from: &Curve, to: &Curve) -> Self {
        let steps = allowed_steps();
        let mut costs = Vec::with_capacity(SAMPLES * SAMPLES * steps.len());
        for i in 1..=SAMPLES {
            for j in 0..SAMPLES {
                let place = from.places[i % SAMPLES].distance_squared(to.places[j]);
                costs.extend(steps.iter().map(|&[a, b]| {
                    let rate = b as f64 / a as f64;
                    let pieces = a.max(b);
                    let along: f64 = (0..pieces)
                        .filter(|_| a <= i)
                        .map(|piece| {
                            let s = i - a + piece * a / pieces;
                            let t = j + SAMPLES - b + piece * b / pieces;
                            from.tangents[s].dot(to.tangents[t % SAMPLES])
                        })
                        .sum();
                    let elastic = 1.0 + rate - 2.0 * rate.sqrt() * along / pieces as f64;
                    a as f64 * (elastic + PLACE_WEIGHT * place)
                }));
            }
        }
        Self { steps, costs }
    }

    fn to(&self, i: usize, j: usize) -> &[f64] {
        let first = ((i - 1) * SAMPLES + j) * self.steps.len();
        &self.costs[first..first + self.steps.len()]
    }
}

/// The least cost of an assignment that begins with sample 0 against `beginning`, and its knots; infinite if it exceeds
/// `bound`.
fn assign(step_costs: &StepCosts, beginning: usize, bound: f64) -> (f64, Vec<[usize; 2]>) {
    let side = SAMPLES + 1;
    let mut costs = vec![f64::INFINITY; side * side];
    let mut taken = vec![0_u8; side * side];
    costs[0] = 0.0;
    for i in 1..=SAMPLES {
        let mut lowest = f64::INFINITY;
        // Beyond these slopes of the whole path nothing ends in the corner.
        for j in i.div_ceil(LONGEST_STEP)..=SAMPLES.min(i * LONGEST_STEP) {
            let (mut least, mut by) = (f64::INFINITY, 0);
            let steps = step_costs.steps.iter().zip(step_costs.to(i, (j + beginning) % SAMPLES));
            for (number, (&[a, b], step)) in steps.enumerate() {
                if a > i || b > j {
                    continue;
                }
                let cost = costs[(i - a) * side + j - b] + step;
                if cost < least {
                    (least, by) = (cost, number);
                }
            }
            (costs[i * side + j], taken[i * side + j]) = (least, by as u8);
            lowest = lowest.min(least);
        }
        if lowest > bound && i > LONGEST_STEP {
            return (f64::INFINITY, Vec::new());
        }
    }
    let mut knots = Vec::new();
    let (mut i, mut j) = (SAMPLES, SAMPLES);
    while i > 0 && costs[SAMPLES * side + SAMPLES].is_finite() {
        let [a, b] = step_costs.steps[usize::from(taken[i * side + j])];
        (i, j) = (i - a, j - b);
        knots.push([i, j + beginning]);
    }
    (costs[SAMPLES * side + SAMPLES], knots)
}

fn coprime(a: usize, b: usize) -> bool {
    if b == 0 { a == 1 } else { coprime(b, a % b) }
}
