//! The rotation that a deformation comes nearest to on a shell.

use glam::{DQuat, DVec3, DVec4};
use thinshell::distance::SignedDistance;

/// Of the nodes next to the reference, by least squares.
///
/// Source: B. K. P. Horn, "Closed-form solution of absolute orientation using unit quaternions", J. Opt. Soc. Am. A 4, 1987.
pub fn mean_turn(reference: &SignedDistance<3>, displacement: &[f64]) -> DQuat {
    let grid = reference.grid();
    let near: Vec<[DVec3; 2]> = (0..grid.node_count())
        .filter(|&node| reference.values()[node].abs() < 1.5 * grid.spacing())
        .map(|node| {
            let x = DVec3::from(grid.position(node));
            [x, x + DVec3::from_slice(&displacement[3 * node..3 * node + 3])]
        })
        .collect();
    let middle = [0, 1].map(|k| near.iter().map(|pair| pair[k]).sum::<DVec3>() / near.len() as f64);
    let mut m = [[0.0; 3]; 3];
    for pair in &near {
        let [from, to] = [pair[0] - middle[0], pair[1] - middle[1]];
        for (i, row) in m.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry += from[i] * to[j];
            }
        }
    }
    // The quaternion (w, x, y, z) is the eigenvector of the largest eigenvalue, found by powers of the shifted matrix.
    let rows = [
        DVec4::new(m[0][0] + m[1][1] + m[2][2], m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]),
        DVec4::new(m[1][2] - m[2][1], m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[2][0] + m[0][2]),
        DVec4::new(m[2][0] - m[0][2], m[0][1] + m[1][0], m[1][1] - m[0][0] - m[2][2], m[1][2] + m[2][1]),
        DVec4::new(m[0][1] - m[1][0], m[2][0] + m[0][2], m[1][2] + m[2][1], m[2][2] - m[0][0] - m[1][1]),
    ];
    let shift: f64 = rows.iter().map(|row| row.length()).sum();
    let mut q = DVec4::new(1.0, 0.1, 0.1, 0.1);
    for _ in 0..2000 {
        q = (DVec4::from_array(rows.map(|row| row.dot(q))) + shift * q).normalize();
    }
    DQuat::from_xyzw(q.y, q.z, q.w, q.x)
}
