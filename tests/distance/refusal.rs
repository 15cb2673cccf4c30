//! What is no shape, and what is said about it.

use glam::DVec2;
use thinshell::distance::SignedDistance;
use thinshell::error::ShapeError;
use thinshell::grid::Grid;

use crate::support::{CENTRE, from_loops, rectangle, regular, reversed};

fn refusal(loops: &[Vec<DVec2>]) -> ShapeError {
    SignedDistance::from_loops(Grid::new(64), loops).err().unwrap()
}

#[test]
fn loops_that_are_no_shape_are_refused_with_the_reason() {
    let square = rectangle([0.3, 0.3], [0.7, 0.7]);
    assert_eq!(refusal(&[]), ShapeError::Empty);
    assert_eq!(refusal(&[vec![], vec![]]), ShapeError::Empty);
    assert_eq!(refusal(&[square.clone(), vec![]]), ShapeError::TooFewPoints { index: 1, points: 0 });
    let twice = vec![CENTRE, CENTRE, square[0], square[0], CENTRE];
    assert_eq!(refusal(&[twice]), ShapeError::TooFewPoints { index: 0, points: 2 });
    for poison in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut broken = square.clone();
        broken[2].y = poison;
        assert_eq!(refusal(&[square.clone(), broken]), ShapeError::NotFinite { index: 1, point: 2 });
    }
    let line = vec![DVec2::new(0.2, 0.3), DVec2::new(0.8, 0.6), DVec2::new(0.4, 0.4)];
    assert_eq!(refusal(&[line]), ShapeError::NoArea);
    // A star polygon every stroke of which crosses almost every other.
    let tangle: Vec<_> = regular(1601, CENTRE, 0.4);
    let tangle = (0..1601).map(|k| tangle[800 * k % 1601]).collect();
    assert_eq!(refusal(&[tangle]), ShapeError::Tangled { most: 250_000 });
    assert_eq!(refusal(&[rectangle([0.501, 0.501], [0.505, 0.505])]), ShapeError::TooSmall { cells: 64 });
}

#[test]
fn shapes_at_the_border_are_refused_with_the_side() {
    let sides = [
        ([0.01, 0.3], [0.5, 0.7], "left", "x", 0.01),
        ([0.3, 0.3], [0.99, 0.7], "right", "x", 0.99),
        ([0.3, 0.01], [0.5, 0.7], "bottom", "y", 0.01),
        ([0.3, 0.3], [0.5, 0.99], "top", "y", 0.99),
    ];
    for (low, high, side, coordinate, value) in sides {
        let ShapeError::NearBorder { side: found, coordinate: axis, value: place, cells, needed } =
            refusal(&[rectangle(low, high)])
        else {
            panic!("not refused for the border")
        };
        assert_eq!((found, axis, place, needed), (side, coordinate, value, 2.0));
        assert!((cells - 0.64).abs() < 1e-12);
    }
    let refused = refusal(&[rectangle([0.3, 0.3], [1.04, 0.7])]);
    assert_eq!(refused, ShapeError::OutsideBox { side: "right", coordinate: "x", value: 1.04 });
    assert!(refused.to_string().contains("leaves the box on the right (x = 1.040)"));
    let far = refusal(&[rectangle([0.3, 0.3], [1e300, 0.7])]);
    assert!(far.to_string().contains("(x = 1.000e300)"), "{far}");
    // Two cells are enough, and on a coarser grid the same room is fewer.
    let close = from_loops(64, &[rectangle([2.0 / 64.0, 0.3], [0.5, 0.7])]);
    assert_eq!(close.check_clearance(64), Ok(()));
    assert!(matches!(close.check_clearance(16), Err(ShapeError::NearBorder { side: "left", .. })));
}

#[test]
fn level_sets_and_masks_that_do_not_fit_are_refused_with_the_reason() {
    let grid = Grid::<3>::new(8);
    let ball: Vec<_> = (0..grid.node_count())
        .map(|node| grid.position(node).iter().map(|x| (x - 0.5) * (x - 0.5)).sum::<f64>().sqrt() - 0.2)
        .collect();
    for make in
        [|grid, values: &[f64]| SignedDistance::<3>::from_level_set(grid, values.to_vec()), SignedDistance::redistance]
    {
        assert!(make(grid, &ball).is_ok());
        assert_eq!(
            make(grid, &ball[1..]).err().unwrap(),
            ShapeError::LevelSetLength { found: 728, expected: 729, cells: 8, dim: 3 }
        );
        let mut broken = ball.clone();
        broken[77] = f64::NAN;
        assert_eq!(make(grid, &broken).err().unwrap(), ShapeError::LevelSetNotFinite { node: 77 });
        let outside: Vec<_> = ball.iter().map(|d| d.abs() + 1.0).collect();
        assert_eq!(make(grid, &outside).err().unwrap(), ShapeError::NoSignChange);
        let inverted: Vec<_> = ball.iter().map(|d| -d).collect();
        assert!(matches!(make(grid, &inverted).err().unwrap(), ShapeError::NearBorder { cells: 0.0, .. }));
        let shifted: Vec<_> = (0..grid.node_count())
            .map(|node| {
                let [x, y, z] = grid.position(node);
                ((x - 0.5).powi(2) + (y - 0.5).powi(2) + (z - 0.7).powi(2)).sqrt() - 0.2
            })
            .collect();
        assert!(matches!(
            make(grid, &shifted).err().unwrap(),
            ShapeError::NearBorder { side: "back", coordinate: "z", .. }
        ));
    }

    let from =
        |width, height, data: &[u8]| SignedDistance::from_mask(Grid::new(64), width, height, data).err().unwrap();
    assert_eq!(from(3, 2, &[255; 5]), ShapeError::MaskLength { found: 5, width: 3, height: 2, expected: 6 });
    assert_eq!(from(0, 5, &[]), ShapeError::Empty);
    assert_eq!(from(4, 4, &[127; 16]), ShapeError::NoArea);
    assert!(matches!(from(4, 4, &[255; 16]), ShapeError::NearBorder { cells: 0.0, .. }));
    let noise: Vec<u8> = (0..2000 * 2000).map(|i| if (i % 2000 + i / 2000) % 2 == 0 { 255 } else { 0 }).collect();
    assert_eq!(from(2000, 2000, &noise), ShapeError::TooManyPoints { most: 2_000_000 });
}

#[test]
fn what_the_grid_hardly_sees_is_refused() {
    let ring = |width: f64| [regular(400, CENTRE, 0.3), regular(400, CENTRE, 0.3 - width)];
    assert!(SignedDistance::from_loops(Grid::new(64), &ring(0.8 / 64.0)).is_ok());
    assert!(matches!(refusal(&ring(0.2 / 64.0)), ShapeError::TooThin { cells: 64, share } if share < 1.0 / 3.0));
    // A sliver along a line of nodes is seen whole, down to where rounding takes over.
    let sliver = |half: f64| [rectangle([0.2, 0.5 - half], [0.8, 0.5 + half])];
    assert!(SignedDistance::from_loops(Grid::new(64), &sliver(1e-4)).is_ok());
    assert_eq!(refusal(&sliver(1e-9)), ShapeError::TooSmall { cells: 64 });
}

#[test]
fn level_sets_are_checked_on_the_solver_s_grid() {
    let given = Grid::<2>::new(64);
    let on = |cells: usize, redistance: bool, value: &dyn Fn(DVec2) -> f64| {
        let values: Vec<_> = (0..given.node_count()).map(|node| value(DVec2::from(given.position(node)))).collect();
        SignedDistance::from_level_set_on(Grid::new(cells), given, &values, redistance)
    };
    for redistance in [false, true] {
        // Two cells of 1/64 are half a cell of 1/16.
        let wide = |p: DVec2| p.distance(CENTRE) - 0.45;
        assert!(on(64, redistance, &wide).is_ok());
        assert!(matches!(on(16, redistance, &wide).err(), Some(ShapeError::NearBorder { .. })));
        // A disc between the nodes of the coarser grid.
        let small = |p: DVec2| p.distance(CENTRE + 1.0 / 32.0) - 0.02;
        assert!(on(64, redistance, &small).is_ok());
        assert_eq!(on(16, redistance, &small).err(), Some(ShapeError::TooSmall { cells: 16 }));
    }
    let disc = |scale: f64| move |p: DVec2| scale * (p.distance(CENTRE) - 0.2);
    for scale in [1e-300, 1e-160, 0.01, 50.0, 1e160, 1e300] {
        let refused = on(64, false, &disc(scale)).err();
        assert!(matches!(refused, Some(ShapeError::LevelSetSlope { .. })), "{scale:e}: {refused:?}");
        let (found, expected) = (on(64, true, &disc(scale)).unwrap(), on(64, true, &disc(1.0)).unwrap());
        for (a, b) in found.values().iter().zip(expected.values()) {
            assert!((a - b).abs() < 1e-12, "{scale:e}");
        }
    }
}

#[test]
fn loops_on_top_of_each_other_by_thousands_are_united_or_refused_in_bounded_work() {
    let circle = regular(32, CENTRE, 0.3);
    let equal: Vec<_> = (0..5000).map(|k| if k % 2 == 0 { circle.clone() } else { reversed(&circle) }).collect();
    let (united, single) = (from_loops(64, &equal), from_loops(64, &[circle]));
    assert_eq!(united.values(), single.values());
    // None equals another, and every one crosses all the others.
    let shifted: Vec<_> = (0..3000).map(|k| regular(16, CENTRE + 1e-6 * k as f64, 0.3)).collect();
    assert_eq!(refusal(&shifted), ShapeError::Tangled { most: 250_000 });
    // Two hundred thousand long strokes that never meet.
    let zigzag: Vec<_> = (0..200_000)
        .map(|k| DVec2::new(if k % 2 == 0 { 0.1 } else { 0.9 }, 0.1 + 0.8 * f64::from(k) / 200_000.0))
        .collect();
    assert_eq!(refusal(&[zigzag]), ShapeError::Tangled { most: 250_000 });
}
