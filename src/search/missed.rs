//! What a match has missed, as pins that draw it there.
//!
//! Each point of the shell is drawn to the aim, but nothing draws the aim's tips to the shell: in a corner that the shell
//! rounds off, all its points may be near though the tip is not. A few ties help: of each such tip to the point of the
//! shell that came nearest, and of each point of the shell that stays off to the nearest of the aim.

use crate::distance::SignedDistance;
use crate::energy::Pin;
use crate::hypersurface::{Hypersurface, Tree, image};
use crate::order::ascending;
use std::rc::Rc;
use std::sync::Arc;

/// What is farther than this is tied, in cells.
const MISSED_TIP: f64 = 0.5;
const MISSED_POINT: f64 = 0.25;
/// A tie of an earlier round is kept if less than this is left of it, in cells.
const REACHED: f64 = 1.0;
/// Ties are at least as far from each other, in cells, or as far as they are long.
const APART: f64 = 2.0;
const MOST: usize = 40;

/// Pins from the shell to its aim where they are still apart, the longest first; then those of `before` that have done
/// their work: a tip that has been reached would be lost again without.
pub(super) fn missed<const D: usize>(
    shapes: &[Rc<SignedDistance<D>>; 2],
    displacement: &[f64],
    before: &[Pin<D>],
) -> Vec<Pin<D>> {
    let grid = shapes[0].grid();
    let cell = grid.spacing();
    let [shell, aim] = [0, 1].map(|k| shapes[k].outline());
    let matched = Arc::new(shell.moved(grid, displacement));
    let (to_shell, to_aim) = (Tree::new(matched.clone()), Tree::new(aim.clone()));
    let mut ties: Vec<(f64, Pin<D>)> = Vec::new();
    for tip in places(&aim) {
        if let Some(nearest) = to_shell.nearest(&tip)
            && nearest.distance > MISSED_TIP * cell
        {
            let reference = shell.point_at(nearest.simplex, &nearest.shares);
            ties.push((nearest.distance, Pin { reference, template: tip }));
        }
    }
    for (point, place) in places(&shell).zip(places(&matched)) {
        if let Some(nearest) = to_aim.nearest(&place)
            && nearest.distance > MISSED_POINT * cell
        {
            let template = aim.point_at(nearest.simplex, &nearest.shares);
            ties.push((nearest.distance, Pin { reference: point, template }));
        }
    }
    let lengths: Vec<f64> = ties.iter().map(|(length, _)| -length).collect();
    let in_order = ascending(&lengths).into_iter().map(|place| ties[place as usize]);
    let mut chosen: Vec<Pin<D>> = Vec::new();
    let reached = before
        .iter()
        .filter(|pin| distance(&image(grid, displacement, &pin.reference), &pin.template) < REACHED * cell);
    for (length, pin) in in_order.chain(reached.map(|&pin| (0.0, pin))) {
        let apart = (APART * cell).max(length);
        if chosen.len() < MOST && chosen.iter().all(|other| distance(&pin.template, &other.template) > apart) {
            chosen.push(pin);
        }
    }
    chosen
}

/// The closed curves, outer ones and holes, that each of two shapes in the plane consists of are as many. Of surfaces it is
/// supposed.
pub(super) fn have_as_many_outlines<const D: usize>(shapes: &[Rc<SignedDistance<D>>; 2]) -> bool {
    let [first, second] = shapes.each_ref().map(|shape| outlines(&shape.outline()));
    first == second
}

fn outlines<const D: usize>(outline: &Hypersurface<D>) -> usize {
    if D == 2 { in_plane(outline).loops().len() } else { 1 }
}

/// A curve, for those who know that D = 2.
pub(super) fn in_plane<const D: usize>(outline: &Hypersurface<D>) -> Hypersurface<2> {
    let points = outline.points().iter().map(|point| [point[0], point[1]]).collect();
    let segments = outline.simplices().iter().map(|ends| [ends[0], ends[1]]).collect();
    Hypersurface::new(points, segments)
}

fn distance<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    (0..D).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Corners, then middles.
fn places<const D: usize>(surface: &Hypersurface<D>) -> impl Iterator<Item = [f64; D]> {
    surface.points().iter().copied().chain(surface.middles().map(|(middle, _)| middle))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;
    use glam::DVec2;
    use std::f64::consts::TAU;

    const CELLS: usize = 64;

    fn polygon(corners: u32, radius: f64) -> Rc<SignedDistance<2>> {
        let corner = |k: u32| DVec2::splat(0.5) + radius * DVec2::from_angle(TAU * f64::from(k) / f64::from(corners));
        let outline = (0..corners).map(corner).collect();
        Rc::new(SignedDistance::from_loops(Grid::new(CELLS), &[outline]).expect("a valid shape"))
    }

    fn ball(centre: f64) -> Rc<SignedDistance<3>> {
        let grid = Grid::<3>::new(24);
        let value = |node| grid.position(node).map(|x| (x - centre).powi(2)).iter().sum::<f64>().sqrt() - 0.25;
        Rc::new(SignedDistance::from_nodal(grid, (0..grid.node_count()).map(value).collect()))
    }

    fn still<const D: usize>(shape: &SignedDistance<D>) -> Vec<f64> {
        vec![0.0; shape.grid().node_count() * D]
    }

    #[test]
    fn a_shape_misses_nothing_of_itself() {
        let (star, sphere) = (polygon(5, 0.3), ball(0.5));
        assert_eq!(missed(&[star.clone(), star.clone()], &still(&star), &[]), []);
        assert_eq!(missed(&[sphere.clone(), sphere.clone()], &still(&sphere), &[]), []);
    }

    #[test]
    fn each_corner_that_is_cut_off_is_tied_to_the_middle_of_the_cut() {
        let (square, circle) = (polygon(4, 0.4), polygon(360, 0.3));
        let pins = missed(&[circle.clone(), square], &still(&circle), &[]);
        for corner in 0..4 {
            let direction = DVec2::from_angle(TAU * f64::from(corner) / 4.0);
            let tied = pins[..4].iter().find(|pin| (DVec2::from(pin.template) - 0.5).distance(0.4 * direction) < 1e-9);
            let tied = tied.unwrap_or_else(|| panic!("corner {corner} is not among the longest of {pins:?}"));
            assert!((DVec2::from(tied.reference) - 0.5).distance(0.3 * direction) < 0.004, "{tied:?}");
        }
    }

    /// A disc on a neck much thinner than a cell, which the grid's own contour cuts off.
    #[test]
    fn outlines_are_counted_as_they_were_drawn() {
        let thin = 0.1 / CELLS as f64;
        let head = (1..=9).map(|k| DVec2::new(0.5, 0.6) + 0.15 * DVec2::from_angle(TAU * (f64::from(k) / 10.0 - 0.25)));
        let foot = [[0.5 - thin, 0.3], [0.3, 0.3], [0.3, 0.2], [0.7, 0.2], [0.7, 0.3], [0.5 + thin, 0.3]];
        // Between two columns of nodes.
        let aside = DVec2::new(0.5 / CELLS as f64, 0.0);
        let outline: Vec<DVec2> = head.chain(foot.map(DVec2::from)).map(|point| point + aside).collect();
        let grid = Grid::new(CELLS);
        let shape = Rc::new(SignedDistance::from_loops(grid, &[outline]).expect("a valid shape"));
        assert_eq!(crate::contour::zero_set(grid, shape.values()).len(), 2);
        assert!(have_as_many_outlines(&[shape.clone(), polygon(4, 0.3)]));
        let two = [0.3, 0.7].map(|x| {
            [[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]].map(|at| DVec2::new(x, 0.5) + 0.1 * DVec2::from(at)).to_vec()
        });
        let two = Rc::new(SignedDistance::from_loops(grid, &two).expect("a valid shape"));
        assert!(!have_as_many_outlines(&[shape, two]));
    }

    #[test]
    fn points_that_stay_off_are_tied_to_the_nearest_of_the_aim() {
        let (from, to) = (ball(0.48), ball(0.52));
        let (cell, pins) = (from.grid().spacing(), missed(&[from.clone(), to], &still(&from), &[]));
        assert!(!pins.is_empty());
        for pin in &pins {
            let radius = |x: &[f64; 3], centre: f64| distance(x, &[centre; 3]);
            assert!((radius(&pin.reference, 0.48) - 0.25).abs() < 0.1 * cell, "{pin:?} begins on the shell");
            assert!((radius(&pin.template, 0.52) - 0.25).abs() < 0.1 * cell, "{pin:?} ends on the aim");
            let length = distance(&pin.reference, &pin.template);
            assert!((MISSED_POINT * cell..0.08).contains(&length), "{pin:?} is {length} long");
        }
    }

    #[test]
    fn ties_that_have_been_reached_stay_until_new_ones_are_near() {
        let (square, circle) = (polygon(4, 0.4), polygon(360, 0.3));
        let tie = |reference: [f64; 2]| Pin { reference, template: [0.9, 0.5] };
        let (reached, far) = (tie([0.895, 0.5]), tie([0.85, 0.5]));
        assert_eq!(missed(&[square.clone(), square.clone()], &still(&square), &[far, reached]), [reached]);
        assert!(!missed(&[circle.clone(), square], &still(&circle), &[reached]).contains(&reached));
    }
}
