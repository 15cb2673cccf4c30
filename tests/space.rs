//! Whole matches in space: what symmetry tells of them, and the twins of what the plane's tests say.

#[path = "common/solids.rs"]
mod solids;

use glam::{DQuat, DVec3};
use solids::{Bumpy, CENTRE, ellipsoid, octahedron, solid, sphere};
use thinshell::assemble::CpuAssembler;
use thinshell::distance::SignedDistance;
use thinshell::energy::Pin;
use thinshell::field::interpolate;
use thinshell::grid::Grid;
use thinshell::minimize::{Minimizer, Ncg};
use thinshell::ready::ready;
use thinshell::report::report;
use thinshell::search::{Approach, Search, SearchProgress};
use thinshell::settings::{Alignment, Settings};

const LEVEL: u32 = 4;

/// From the identity, on one level.
fn straight() -> Settings {
    Settings { coarsest: LEVEL, finest: LEVEL, alignment: Alignment::None, ..Settings::default() }
}

fn register(shapes: &[SignedDistance<3>; 2], settings: Settings, pins: &[Pin<3>]) -> (Search<3>, SearchProgress) {
    let [reference, template] = shapes.clone();
    let mut search = ready(Search::with_pins(reference, template, settings, pins)).expect("valid settings");
    loop {
        let progress = ready(search.step());
        if progress.stop.is_some() {
            assert!(progress.evaluation.least_determinant > 0.0, "folded: {progress:?}");
            return (search, progress);
        }
    }
}

fn image(search: &Search<3>, x: DVec3) -> DVec3 {
    x + DVec3::from(interpolate::<3, 3>(search.grid(), search.displacement(), &x.to_array()))
}

/// A map of the box onto itself: each axis goes to another, and some are turned round.
#[derive(Clone, Copy)]
struct Symmetry {
    name: &'static str,
    /// The axis from which each axis of the image comes,
    from: [usize; 3],
    /// and whether it comes the other way round.
    is_reversed: [bool; 3],
}

const SYMMETRIES: [Symmetry; 4] = [
    Symmetry { name: "a quarter turn about z", from: [1, 0, 2], is_reversed: [true, false, false] },
    Symmetry { name: "a quarter turn about x", from: [0, 2, 1], is_reversed: [false, true, false] },
    Symmetry { name: "a third of a turn about the diagonal", from: [2, 0, 1], is_reversed: [false; 3] },
    Symmetry { name: "a mirror", from: [0, 1, 2], is_reversed: [true, false, false] },
];

impl Symmetry {
    /// Of a function: its values where they belong now.
    fn of(self, shape: &SignedDistance<3>) -> SignedDistance<3> {
        let grid = shape.grid();
        let mut values = vec![0.0; grid.node_count()];
        for (node, value) in shape.values().iter().enumerate() {
            values[self.node(grid, node)] = *value;
        }
        SignedDistance::from_nodal(grid, values)
    }

    fn node(self, grid: Grid<3>, node: usize) -> usize {
        let index = grid.node_index(node);
        grid.node(std::array::from_fn(|axis| {
            let place = index[self.from[axis]];
            if self.is_reversed[axis] { grid.cells() - place } else { place }
        }))
    }

    /// The largest difference of the second displacement to the image of the first, in cells.
    fn difference(self, grid: Grid<3>, plain: &[f64], image: &[f64]) -> f64 {
        let mut largest = 0.0_f64;
        for node in 0..grid.node_count() {
            let there = self.node(grid, node);
            for axis in 0..3 {
                let u = plain[3 * node + self.from[axis]];
                let expected = if self.is_reversed[axis] { -u } else { u };
                largest = largest.max((image[3 * there + axis] - expected).abs());
            }
        }
        largest * grid.cells() as f64
    }
}

/// Without any symmetry of their own.
fn bumpy_pair() -> [SignedDistance<3>; 2] {
    let bumps = |x: f64| {
        vec![(DVec3::new(1.0, 0.2, 0.1).normalize(), 0.4), (DVec3::new(-0.2, 1.0, 0.5 + x).normalize(), 0.5 - x)]
    };
    let turn = DQuat::from_axis_angle(DVec3::new(0.3, -0.5, 0.8).normalize(), 0.15);
    let [from, to] = [0.0, 0.1].map(|x| Bumpy::reaching(bumps(x), 0.33));
    [solid(LEVEL, from.turned(DQuat::IDENTITY)), solid(LEVEL, to.turned(turn))]
}

#[test]
fn turns_and_mirrors_of_the_box_commute_with_the_gradient_method_step_by_step() {
    let shapes = bumpy_pair();
    let after_five_steps = |[reference, template]: &[SignedDistance<3>; 2]| {
        let mut assembler: CpuAssembler<3> =
            CpuAssembler::new(&Settings::default().functional(LEVEL), reference, template);
        let mut minimizer = Ncg::new(reference.grid(), vec![0.0; 3 * reference.grid().node_count()], 0.5, 1e-5);
        for _ in 0..5 {
            ready(minimizer.step(&mut assembler));
        }
        minimizer.displacement().to_vec()
    };
    let plain = after_five_steps(&shapes);
    assert!(plain.iter().any(|u| u.abs() > 1e-3), "something has moved");
    for symmetry in SYMMETRIES {
        let image = after_five_steps(&[symmetry.of(&shapes[0]), symmetry.of(&shapes[1])]);
        let error = symmetry.difference(shapes[0].grid(), &plain, &image);
        assert!(error < 1e-6, "{}: {error} cells", symmetry.name);
    }
}

#[test]
fn turns_and_mirrors_of_the_box_commute_with_the_solver() {
    // Without the ranking of starts, whose turns those of the box take to others.
    let settings = Settings { tolerance: 1e-8, ..straight() };
    let shapes = bumpy_pair();
    let (plain, end) = register(&shapes, settings, &[]);
    for symmetry in SYMMETRIES {
        let (image, other) = register(&[symmetry.of(&shapes[0]), symmetry.of(&shapes[1])], settings, &[]);
        let ratio = other.evaluation.total() / end.evaluation.total();
        assert!((ratio - 1.0).abs() < 1e-5, "{}: {ratio} times the energy", symmetry.name);
        // The smoother runs through the nodes in another direction, so agreement ends at the tolerance.
        let error = symmetry.difference(plain.grid(), plain.displacement(), image.displacement());
        assert!(error < 0.05, "{}: {error} cells", symmetry.name);
    }
}

#[test]
fn a_sphere_goes_to_an_ellipsoid_as_their_common_symmetry_tells() {
    let (radius, axes) = (0.22, [0.3, 0.24, 0.19]);
    let settings = Settings { coarsest: 3, finest: 5, tolerance: 1e-7, ..straight() };
    let shapes = [solid(5, sphere(radius)), solid(5, ellipsoid(axes))];
    let (search, _) = register(&shapes, settings, &[]);
    let cells = search.grid().cells() as f64;
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let direction = side * DVec3::AXES[axis];
            // The poles are fixed by two mirrors, so they go to the tips.
            let off = image(&search, CENTRE + radius * direction).distance(CENTRE + axes[axis] * direction) * cells;
            assert!(off < 0.1, "the pole of axis {axis} ends {off} cells from the tip");
        }
        // A mirror's plane stays in itself, and what it mirrors stays mirrored.
        for k in 0..40 {
            let angle = std::f64::consts::TAU * f64::from(k) / 40.0;
            let mut direction = DVec3::ZERO;
            direction[(axis + 1) % 3] = angle.cos();
            direction[(axis + 2) % 3] = angle.sin();
            let off = (image(&search, CENTRE + radius * direction)[axis] - 0.5).abs() * cells;
            assert!(off < 0.1, "a point leaves the plane across axis {axis} by {off} cells");
            let beside = direction + 0.6 * DVec3::AXES[axis];
            let [mut found, other] = [beside, beside - 1.2 * DVec3::AXES[axis]]
                .map(|direction| image(&search, CENTRE + radius * direction.normalize()));
            found[axis] = 1.0 - found[axis];
            let off = found.distance(other) * cells;
            assert!(off < 0.1, "across axis {axis} images differ by {off} cells");
        }
    }
}

#[test]
fn a_sphere_is_scaled_onto_a_larger_sphere() {
    let (radius, ratio) = (0.16, 1.6);
    let settings = Settings { coarsest: 3, finest: 5, ..straight() };
    let shapes = [solid(5, sphere(radius)), solid(5, sphere(ratio * radius))];
    let (search, _) = register(&shapes, settings, &[]);
    let found = report(&shapes[0], &shapes[1], search.displacement());
    assert!(found.mismatch.max < 0.1 && found.cover.max < 0.1, "{found:?}");
    assert!((found.stretch.mean / (ratio * ratio) - 1.0).abs() < 0.02, "{:?}", found.stretch);
    for direction in [DVec3::X, DVec3::new(0.0, 0.6, -0.8), DVec3::new(-2.0, 1.0, 2.0) / 3.0] {
        let off = image(&search, CENTRE + radius * direction).distance(CENTRE + ratio * radius * direction) * 32.0;
        assert!(off < 0.25, "a point lands {off} cells from its image under the scaling");
    }
}

#[test]
fn in_space_the_identity_is_the_minimiser_for_equal_shapes() {
    let shape = bumpy_pair()[0].clone();
    for alignment in [Alignment::None, Alignment::Similarity] {
        let settings = Settings { alignment, tolerance: 1e-9, ..straight() };
        let (search, _) = register(&[shape.clone(), shape.clone()], settings, &[]);
        let farthest = search.displacement().iter().fold(0.0_f64, |most, u| most.max(u.abs())) * 16.0;
        assert!(farthest < 0.1, "{alignment:?} moves by {farthest} cells");
    }
}

#[test]
fn in_space_the_same_input_gives_the_same_bits() {
    let settings = Settings { alignment: Alignment::Similarity, ..straight() };
    let [first, second] = [(), ()].map(|()| register(&bumpy_pair(), settings, &[]).0.displacement().to_vec());
    assert_eq!(first, second);
}

/// Turned so far that the identity leads elsewhere.
#[test]
fn turned_bumps_are_found_among_the_starts_about_any_axis() {
    let bumps: Vec<(DVec3, f64)> =
        [([1.0, 0.2, 0.1], 0.6), ([-0.2, 1.0, 0.5], 0.45), ([0.1, -0.6, 0.8], 0.3), ([-0.8, -0.4, -0.4], -0.2)]
            .map(|(towards, height)| (DVec3::from(towards).normalize(), height))
            .into();
    let bumpy = Bumpy::reaching(bumps.clone(), 0.33);
    let settings = Settings { alignment: Alignment::Similarity, ..straight() };
    for axis in DVec3::AXES {
        let turn = DQuat::from_axis_angle(axis, 60_f64.to_radians());
        let shapes = [DQuat::IDENTITY, turn].map(|turn| solid(LEVEL, bumpy.clone().turned(turn)));
        let (search, _) = register(&shapes, settings, &[]);
        let found = report(&shapes[0], &shapes[1], search.displacement());
        assert!(found.mismatch.max < 0.5 && found.cover.max < 1.0, "about {axis}: {found:?}");
        for (towards, height) in &bumps[..2] {
            let tip = bumpy.radius * (1.0 + height) * *towards;
            let off = (image(&search, CENTRE + tip) - CENTRE).angle_between(turn * tip).to_degrees();
            assert!(off < 15.0, "about {axis}: a bump ends {off}° from its own");
        }
    }
}

#[test]
fn a_sphere_is_not_turned_without_gain() {
    let settings = Settings { alignment: Alignment::Similarity, ..straight() };
    for axes in [[0.3, 0.24, 0.2], [0.2, 0.3, 0.24], [0.22, 0.25, 0.25]] {
        let (search, _) = register(&[solid(LEVEL, sphere(0.22)), solid(LEVEL, ellipsoid(axes))], settings, &[]);
        for direction in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(0.6, 0.8, 0.0), DVec3::new(0.0, 0.6, -0.8)] {
            let turned = (image(&search, CENTRE + 0.22 * direction) - CENTRE).angle_between(direction).to_degrees();
            assert!(turned < 45.0, "to {axes:?}: turned by {turned}°");
        }
    }
}

#[test]
fn a_much_smaller_sphere_is_matched_the_other_way_round_and_inverted() {
    let settings = Settings { alignment: Alignment::Similarity, ..straight() };
    let shapes = [solid(LEVEL, sphere(0.34)), solid(LEVEL, sphere(0.2))];
    let [reference, template] = shapes.clone();
    let mut search = ready(Search::new(reference, template, settings)).expect("valid settings");
    let mut approaches = vec![search.progress().approach];
    while ready(search.step()).stop.is_none() {
        approaches.push(search.progress().approach);
    }
    approaches.push(search.progress().approach);
    approaches.dedup();
    assert_eq!(approaches[..2], [Approach::Exchanged, Approach::Inverted]);
    let found = report(&shapes[0], &shapes[1], search.displacement());
    assert!(found.mismatch.max < 0.5 && found.cover.max < 1.0, "{found:?}");
}

#[test]
fn in_space_a_pin_draws_its_point_to_where_it_is_tied() {
    // The corner of an octahedron to the one beside it.
    let shapes = [(), ()].map(|()| solid(LEVEL, octahedron(0.33, DQuat::IDENTITY)));
    let corner = 0.3;
    let pin = Pin { reference: [0.5 + corner, 0.5, 0.5], template: [0.5, 0.5 + corner, 0.5] };
    let off = |pin_weight: f64| {
        let settings = Settings { pin_weight, alignment: Alignment::Similarity, ..straight() };
        let (search, _) = register(&shapes, settings, &[pin]);
        image(&search, DVec3::from(pin.reference)).distance(DVec3::from(pin.template))
    };
    let (ignored, tied) = (off(0.0), off(10.0));
    assert!(ignored > 0.3, "without weight it stays {ignored} away");
    assert!(tied < 0.03, "with weight it comes within {tied}");
}

#[test]
fn in_space_pins_that_contradict_each_other_never_fold() {
    let pins = [
        Pin { reference: [0.7, 0.5, 0.5], template: [0.25, 0.5, 0.5] },
        Pin { reference: [0.3, 0.5, 0.5], template: [0.75, 0.5, 0.5] },
        Pin { reference: [0.5, 0.7, 0.5], template: [0.5, 0.3, 0.5] },
        Pin { reference: [0.5, 0.7, 0.5], template: [0.1, 0.9, 0.9] },
    ];
    let shapes = [solid(LEVEL, sphere(0.22)), solid(LEVEL, ellipsoid([0.3, 0.24, 0.19]))];
    for pin_weight in [1.0, 1e4] {
        let (search, _) = register(&shapes, Settings { pin_weight, ..straight() }, &pins);
        assert!(search.displacement().iter().all(|u| u.is_finite()));
    }
}

#[test]
fn in_space_an_update_goes_on_from_the_deformation_there_is() {
    let settings = Settings { alignment: Alignment::Similarity, ..straight() };
    let [reference, template] = bumpy_pair();
    let (mut search, _) = register(&[reference.clone(), template.clone()], settings, &[]);
    // The template, a fifth of a cell to the side.
    let grid = template.grid();
    let moved = |node: usize| {
        let [x, y, z] = grid.position(node);
        interpolate::<3, 1>(grid, template.values(), &[(x - 0.2 / 16.0).max(0.0), y, z])[0]
    };
    let near = SignedDistance::from_nodal(grid, (0..grid.node_count()).map(moved).collect());
    ready(search.update(reference.clone(), near.clone(), settings, &[])).expect("valid settings");
    let mut steps = 0;
    while ready(search.step()).stop.is_none() {
        steps += 1;
    }
    assert!(steps < 12, "{steps} iterations after a small change");
    let found = report(&reference, &near, search.displacement());
    assert!(found.mismatch.max < 0.5, "{found:?}");
}
