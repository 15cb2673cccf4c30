//! The outline of what a set of contours encloses, whatever way they cross, touch or repeat themselves.

use glam::DVec2;

use super::winding::{Edge, Region, Strips};
use crate::error::ShapeError;
use crate::numbers::Numbers;
use crate::order::ascending;

/// Points closer than this are one: coordinates are of order one and rounded to 1e-16, crossings to a little more.
pub(super) const COINCIDENT: f64 = 1e-12;

/// How far from a piece its two sides are looked at. Strips thinner than this count as lines.
const ASIDE: f64 = 1e-9;

/// More crossings than any drawing has; their number may grow with the square of the number of points.
const MOST_CUTS: usize = 500_000;

/// Pairs of edges looked at for contacts, and edges looked at by rays: about a second's work each. Many strokes on top
/// of each other may need more without ever crossing.
const MOST_WORK: usize = 200_000_000;
/// What finding a contact costs, in such looks.
const CONTACT_WORK: usize = 25;

/// The region that closed contours enclose, and the pieces of its outline in the order of the contours.
///
/// A contour that lies wholly inside an odd number of others is a hole, any other a body; see [`Region`].
///
/// # Errors
///
/// Contours that cross or overlap hundreds of thousands of times.
pub(super) fn outline(contours: &[Vec<DVec2>]) -> Result<(Region, Vec<[DVec2; 2]>), ShapeError> {
    let mut region = Region::of_contours(contours);
    let Some(cuts) = contacts(&region.edges, contours)? else {
        // Simple, disjoint contours: nesting alternates, so every edge separates inside from outside.
        if contours.len() > 1 {
            let strips = Strips::new(&region);
            let mut signs = vec![1; contours.len()];
            for (contour, points) in contours.iter().enumerate() {
                strips.enclosing(points[0], |other| {
                    if other != contour {
                        signs[contour] = -signs[contour];
                    }
                });
                bounded(strips.scanned())?;
            }
            region.signs = signs;
        }
        let segments = region.edges.iter().map(|edge| [edge.a, edge.b]).collect();
        return Ok((region, segments));
    };

    let pieces = pieces(&region.edges, cuts);
    let strips = Strips::new(&region);
    let signs = signs(&strips, &pieces, contours.len())?;
    let mut segments = Vec::with_capacity(pieces.len());
    // Where contours share a stretch, the outline has it once.
    let (mut places, mut seen) = (Numbers::default(), Numbers::default());
    for piece in &pieces {
        let [left, right] = piece.sides();
        if strips.inside(&signs, left) != strips.inside(&signs, right) && seen.is_new(piece.key(&mut places)) {
            segments.push([piece.a, piece.b]);
        }
        bounded(strips.scanned())?;
    }
    region.signs = signs;
    Ok((region, segments))
}

fn bounded(work: usize) -> Result<(), ShapeError> {
    if work <= MOST_WORK { Ok(()) } else { Err(ShapeError::Tangled { most: MOST_CUTS / 2 }) }
}

/// The edges cut at their sorted cuts, grouped by contour; pieces too short to have sides are left out.
fn pieces(edges: &[Edge], cuts: Vec<(u32, f64)>) -> Vec<Edge> {
    let mut cuts = cuts.into_iter().peekable();
    let mut pieces = Vec::with_capacity(edges.len() + cuts.len());
    for (number, edge) in edges.iter().enumerate() {
        let mut from = edge.a;
        let own = std::iter::from_fn(|| cuts.next_if(|cut| cut.0 as usize == number));
        for to in own.map(|cut| edge.a + (edge.b - edge.a) * cut.1).chain([edge.b]) {
            if from.distance_squared(to) > (10.0 * COINCIDENT).powi(2) {
                pieces.push(Edge { a: from, b: to, contour: edge.contour });
                from = to;
            }
        }
    }
    pieces
}

impl Edge {
    /// The numbers of the ends, the same for edges that coincide, whichever way they go.
    fn key(&self, places: &mut Numbers) -> [i64; 2] {
        let rounded = |x: f64| (x / (100.0 * COINCIDENT)).round() as i64;
        let [a, b] = [self.a, self.b].map(|p| i64::from(places.of(p.to_array().map(rounded))));
        [a.min(b), a.max(b)]
    }

    /// A point close to the middle on the left, and one on the right.
    fn sides(&self) -> [DVec2; 2] {
        let middle = (self.a + self.b) * 0.5;
        let along = self.b - self.a;
        let length = along.length();
        let aside = along.perp() * (ASIDE.min(0.01 * length) / length);
        [middle + aside, middle - aside]
    }
}

/// +1 for a body, −1 for a hole: a contour all of whose pieces lie inside an odd number of the other contours.
fn signs(strips: &Strips, pieces: &[Edge], count: usize) -> Result<Vec<i32>, ShapeError> {
    // None until the contour's first piece that borders or lies in its own inside. All lists ascend.
    let mut holders: Vec<Option<Vec<usize>>> = vec![None; count];
    for piece in pieces {
        let holders = &mut holders[piece.contour];
        if count == 1 || holders.as_ref().is_some_and(Vec::is_empty) {
            continue;
        }
        for side in piece.sides() {
            // On an edge shared with another contour only the contour's own inner side tells what holds it.
            let mut around = Vec::new();
            strips.enclosing(side, |contour| around.push(contour));
            if around.binary_search(&piece.contour).is_ok() {
                match holders {
                    None => *holders = Some(around),
                    Some(known) => known.retain(|contour| around.binary_search(contour).is_ok()),
                }
            }
        }
        bounded(strips.scanned())?;
    }
    let holds = |outer: usize, inner: usize| {
        holders[inner].as_ref().is_some_and(|list: &Vec<usize>| list.binary_search(&outer).is_ok())
    };
    let signs = (0..count)
        .map(|inner| {
            let depth = holders[inner]
                .iter()
                .flatten()
                // Contours that hold each other are the same curve drawn twice; neither is the other's hole.
                .filter(|&&outer| outer != inner && !holds(inner, outer))
                .count();
            if depth % 2 == 1 { -1 } else { 1 }
        })
        .collect();
    Ok(signs)
}

/// Where edges are to be cut, as sorted (edge, parameter); `None` if the contours are simple and nowhere touch.
fn contacts(edges: &[Edge], contours: &[Vec<DVec2>]) -> Result<Option<Vec<(u32, f64)>>, ShapeError> {
    let mut starts = Vec::with_capacity(contours.len());
    let mut total = 0;
    for points in contours {
        starts.push(total);
        total += points.len();
    }
    let follows = |first: usize, second: usize| {
        let contour = edges[first].contour;
        edges[second].contour == contour && {
            let next = first + 1;
            second == if next == starts[contour] + contours[contour].len() { starts[contour] } else { next }
        }
    };

    let (mut touching, mut work) = (false, 0);
    let mut cuts = Vec::new();
    for_close_pairs(edges, |first, second| {
        work += 1;
        if !near(&edges[first], &edges[second]) {
            return work <= MOST_WORK;
        }
        work += CONTACT_WORK;
        let consecutive = follows(first, second) || follows(second, first);
        let contact = Contact::of(&edges[first], &edges[second], consecutive);
        touching |= contact.touching;
        cuts.extend(contact.on_first.into_iter().flatten().map(|t| (first as u32, t)));
        cuts.extend(contact.on_second.into_iter().flatten().map(|t| (second as u32, t)));
        // Pairs that share several buckets come several times; a few is what they do on average.
        cuts.len() <= 4 * MOST_CUTS && work <= MOST_WORK
    });
    let complete = cuts.len() <= 4 * MOST_CUTS && work <= MOST_WORK;
    // By edges, and by parameters on each.
    for key in [|cut: &(u32, f64)| cut.1, |cut: &(u32, f64)| f64::from(cut.0)] {
        let order = ascending(&cuts.iter().map(key).collect::<Vec<_>>());
        cuts = order.into_iter().map(|cut| cuts[cut as usize]).collect();
    }
    cuts.dedup();
    if !complete || cuts.len() > MOST_CUTS {
        return Err(ShapeError::Tangled { most: MOST_CUTS / 2 });
    }
    Ok(touching.then_some(cuts))
}

/// Whether the boxes around two edges meet.
fn near(first: &Edge, second: &Edge) -> bool {
    let [low, high] = [first.a.min(first.b) - COINCIDENT, first.a.max(first.b) + COINCIDENT];
    second.a.max(second.b).cmpge(low).all() && second.a.min(second.b).cmple(high).all()
}

/// How two edges meet: the parameters of their interior points where they do.
struct Contact {
    touching: bool,
    on_first: [Option<f64>; 3],
    on_second: [Option<f64>; 3],
}

impl Contact {
    fn of(first: &Edge, second: &Edge, consecutive: bool) -> Self {
        let mut on_first = [on_interior(first, second.a), on_interior(first, second.b), None];
        let mut on_second = [on_interior(second, first.a), on_interior(second, first.b), None];
        if !consecutive && [on_first, on_second].iter().flatten().all(Option::is_none) {
            let (along, across) = (first.b - first.a, second.b - second.a);
            let denominator = along.perp_dot(across);
            let offset = second.a - first.a;
            let (t, s) = (offset.perp_dot(across) / denominator, offset.perp_dot(along) / denominator);
            // Parallel edges divide by zero and fail the comparison.
            if t > 0.0 && t < 1.0 && s > 0.0 && s < 1.0 {
                (on_first[2], on_second[2]) = (Some(t), Some(s));
            }
        }
        let common = [first.a, first.b]
            .iter()
            .flat_map(|p| [p.distance_squared(second.a), p.distance_squared(second.b)])
            .filter(|&square| square <= COINCIDENT * COINCIDENT)
            .count();
        let interior = [on_first, on_second].iter().flatten().any(Option::is_some);
        Self { touching: interior || common > usize::from(consecutive), on_first, on_second }
    }
}

/// The parameter of `point` on the edge, if it lies on it and away from its ends.
fn on_interior(edge: &Edge, point: DVec2) -> Option<f64> {
    let along = edge.b - edge.a;
    let t = (point - edge.a).dot(along) / along.length_squared();
    let margin = COINCIDENT / along.length();
    let close = || (edge.a + along * t).distance_squared(point) <= COINCIDENT * COINCIDENT;
    (t > margin && t < 1.0 - margin && close()).then_some(t)
}

/// Calls `visit` with every pair of edges that could meet, found by sorting them into square buckets.
/// A pair that shares several buckets is visited as often. `visit` tells whether to go on.
fn for_close_pairs(edges: &[Edge], mut visit: impl FnMut(usize, usize) -> bool) {
    let (low, high) = edges
        .iter()
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), edge| (low.min(edge.a), high.max(edge.a)));
    let extent = (high - low).max_element().max(COINCIDENT);
    let side = ((edges.len() as f64).sqrt() * 2.0).ceil().clamp(1.0, 2048.0);
    let width = extent / side;
    let side = side as usize;

    // Fill row by row: within a row an edge covers the columns between where it enters and leaves the row.
    let buckets_of = |edge: &Edge, put: &mut dyn FnMut(usize)| {
        let index = |x: f64| ((x / width) as usize).min(side - 1);
        let (a, b) = if edge.a.y <= edge.b.y { (edge.a - low, edge.b - low) } else { (edge.b - low, edge.a - low) };
        for row in index(a.y - COINCIDENT)..=index(b.y + COINCIDENT) {
            let x_at = |y: f64| {
                let t = if b.y > a.y { ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0) } else { 0.0 };
                a.x + t * (b.x - a.x)
            };
            let (mut left, mut right) = (x_at(row as f64 * width), x_at((row + 1) as f64 * width));
            // Wider by a little: touching edges must meet in a bucket in spite of rounding.
            if b.y - a.y <= 1e-6 {
                (left, right) = (a.x, b.x);
            }
            for column in index(left.min(right) - 1e-9)..=index(left.max(right) + 1e-9) {
                put(row * side + column);
            }
        }
    };
    let mut starts = vec![0usize; side * side + 1];
    for edge in edges {
        buckets_of(edge, &mut |bucket| starts[bucket + 1] += 1);
    }
    for bucket in 0..side * side {
        starts[bucket + 1] += starts[bucket];
    }
    let mut members = vec![0u32; starts[side * side]];
    let mut cursor = starts.clone();
    for (number, edge) in edges.iter().enumerate() {
        buckets_of(edge, &mut |bucket| {
            members[cursor[bucket]] = number as u32;
            cursor[bucket] += 1;
        });
    }
    for bucket in 0..side * side {
        let members = &members[starts[bucket]..starts[bucket + 1]];
        for (position, &first) in members.iter().enumerate() {
            for &second in &members[position + 1..] {
                if !visit(first as usize, second as usize) {
                    return;
                }
            }
        }
    }
}
