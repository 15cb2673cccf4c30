//! The zero set of nodal values as closed polylines, by marching squares.

use glam::DVec2;

use crate::grid::Grid;

/// The zero set of a nodal field as closed polylines in domain units, counter-clockwise around what is negative
/// (clockwise around holes); the first point is not repeated at the end.
///
/// Zeros on the grid's edges are found by linear interpolation. Where both diagonals of a cell change sign, the
/// bilinear interpolant's saddle decides. A zero value counts as positive. What is negative at the border is closed
/// along the border.
pub fn zero_set(grid: Grid<2>, values: &[f64]) -> Vec<Vec<DVec2>> {
    assert_eq!(values.len(), grid.node_count(), "one value for each node");
    let side = grid.side();
    let traced = trace(side, side, |column, row| values[row * side + column], f64::MAX, usize::MAX);
    let mut loops = traced.unwrap_or_default();
    for point in loops.iter_mut().flatten() {
        *point *= grid.spacing();
    }
    loops
}

/// Marching squares over `width` × `height` values, in units of their spacing, the first at the origin.
/// `beyond` > 0 is the value all around the array. None if there are more than `most` points.
pub(crate) fn trace(
    width: usize,
    height: usize,
    value: impl Fn(usize, usize) -> f64,
    beyond: f64,
    most: usize,
) -> Option<Vec<Vec<DVec2>>> {
    let at = |[column, row]: [isize; 2]| {
        let within = column >= 0 && row >= 0 && (column as usize) < width && (row as usize) < height;
        if within { value(column as usize, row as usize) } else { beyond }
    };
    // Every closed curve enters what is negative from the left on some row: marks there are enough.
    let mut visited = vec![0u64; (width * height).div_ceil(64)];
    let (mut loops, mut points) = (Vec::new(), 0);
    for row in 0..height {
        let mut before = beyond;
        for column in 0..width {
            let here = value(column, row);
            let enters = before >= 0.0 && here < 0.0;
            before = here;
            let place = row * width + column;
            if enters && visited[place / 64] >> (place % 64) & 1 == 0 {
                let curve = follow([column as isize, row as isize], &at, |[column, row]| {
                    let place = row as usize * width + column as usize;
                    visited[place / 64] |= 1 << (place % 64);
                });
                points += curve.len();
                if points > most {
                    return None;
                }
                loops.push(curve);
            }
        }
    }
    loops.retain(|points: &Vec<DVec2>| points.len() >= 3);
    Some(loops)
}

/// Follows the curve from the edge between the negative node `start` and its left neighbour back to there, with
/// what is negative on the left. `entered` is told the negative node of each edge of that kind.
fn follow(start: [isize; 2], at: &impl Fn([isize; 2]) -> f64, mut entered: impl FnMut([isize; 2])) -> Vec<DVec2> {
    let step = |[x, y]: [isize; 2], [dx, dy]: [isize; 2]| [x + dx, y + dy];
    let mut points: Vec<DVec2> = Vec::new();
    // The edge just crossed: its negative end is on the left of the direction of travel, its positive on the right.
    let (mut left, mut right) = (start, step(start, [-1, 0]));
    loop {
        let (negative, positive) = (at(left), at(right));
        let t = positive / (positive - negative);
        let from = DVec2::new(right[0] as f64, right[1] as f64);
        let to = DVec2::new(left[0] as f64, left[1] as f64);
        let point = from + (to - from) * t;
        if points.last().is_none_or(|last| *last != point) {
            points.push(point);
        }
        let across = [right[0] - left[0], right[1] - left[1]];
        if across == [-1, 0] {
            entered(left);
        }
        // Right of the direction of travel turned by 90° to the left is ahead.
        let ahead = [-across[1], across[0]];
        let (far_left, far_right) = (step(left, ahead), step(right, ahead));
        let (a, b) = (at(far_left), at(far_right));
        // Two negative corners on a diagonal are joined if the bilinear interpolant's saddle between them is negative.
        let joined = || (negative * b - positive * a) / (negative + b - positive - a) < 0.0;
        (left, right) = match (a < 0.0, b < 0.0) {
            (true, false) => (far_left, far_right),
            (true, true) => (far_right, right),
            (false, true) if joined() => (far_right, right),
            (false, _) => (left, far_left),
        };
        if left == start && right == step(start, [-1, 0]) {
            break;
        }
    }
    while points.len() > 1 && points[0] == points[points.len() - 1] {
        points.pop();
    }
    points
}
