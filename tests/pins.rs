//! Points of the reference tied to points of the template.

mod common;

use common::{Random, circle, ellipse, star};
use thinshell::assemble::{Assembler, CpuAssembler};
use thinshell::distance::SignedDistance;
use thinshell::energy::{Functional, Pin};
use thinshell::field::interpolate;
use thinshell::grid::Grid;
use thinshell::ready::ready;
use thinshell::search::Search;
use thinshell::settings::{Alignment, Settings};
use thinshell::stencil::StencilOperator;

fn ball<const D: usize>(level: u32) -> SignedDistance<D> {
    let grid = Grid::<D>::of_level(level);
    let distance = |x: [f64; D]| x.iter().map(|x| (x - 0.5).powi(2)).sum::<f64>().sqrt() - 0.25;
    SignedDistance::from_nodal(grid, (0..grid.node_count()).map(|node| distance(grid.position(node))).collect())
}

/// The energy of pins is quadratic: its gradient and the operator give it back exactly.
fn energy_gradient_and_hessian_agree<const D: usize>() {
    let shape = ball::<D>(3);
    let grid = shape.grid();
    let next_to_none = Functional {
        membrane: 0.0,
        bending: 0.0,
        volume: 1e-12,
        tangency: 0.0,
        penalty: 1e3,
        ..Settings::default().functional(4)
    };
    let mut random = Random(29);
    let mut point = || -> [f64; D] { std::array::from_fn(|_| random.between(0.1, 0.9)) };
    let pins: Vec<Pin<D>> = (0..5).map(|_| Pin { reference: point(), template: point() }).collect();
    let with = |weight: f64| {
        let mut assembler: CpuAssembler<D> = CpuAssembler::new(&next_to_none, &shape, &shape);
        assembler.tie(&pins, weight);
        assembler
    };
    let count = grid.node_count() * D;
    let (zero, mut random) = (vec![0.0; count], Random(31));
    let d: Vec<f64> = (0..count).map(|_| 0.01 * random.between(-1.0, 1.0)).collect();
    let evaluate = |weight: f64, u: &[f64]| {
        let (mut gradient, mut operator) = (vec![0.0; count], StencilOperator::zero(grid));
        let evaluation = ready(with(weight).hessian(u, &mut gradient, &mut operator));
        let mut applied = vec![0.0; count];
        operator.for_each_block(|node, other, block| {
            for i in 0..D {
                for j in 0..D {
                    applied[node * D + i] += f64::from(block[i][j]) * d[other * D + j];
                }
            }
        });
        (evaluation.energies, gradient, applied)
    };
    // What the pins add.
    let ((loose, g0, h0), (tied, g1, h1)) = (evaluate(0.0, &zero), evaluate(2.0, &zero));
    let (moved, ..) = evaluate(2.0, &d);
    assert_eq!(loose.pins, 0.0);
    let inner = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).zip(&d).map(|((a, b), d)| (a - b) * d).sum() };
    let (slope, bend) = (inner(&g1, &g0), inner(&h1, &h0));
    let expected = tied.pins + slope + 0.5 * bend;
    assert!((moved.pins - expected).abs() < 1e-5 * tied.pins, "{} is not {expected}", moved.pins);
    assert!(slope.abs() > 1e-4 * tied.pins && bend > 0.0, "the pins are felt: {slope}, {bend}");
}

#[test]
fn the_pins_have_an_exact_gradient_and_hessian() {
    energy_gradient_and_hessian_agree::<2>();
    energy_gradient_and_hessian_agree::<3>();
}

fn register(settings: Settings, pins: &[Pin<2>]) -> (Search<2>, f64) {
    let grid = Grid::of_level(settings.finest);
    let [reference, template] = [circle([0.5; 2], 0.2), ellipse([0.5; 2], 0.3, 0.2)]
        .map(|curve| SignedDistance::from_loops(grid, &[curve]).expect("a valid curve"));
    let mut search = ready(Search::with_pins(reference, template, settings, pins)).expect("valid settings");
    while ready(search.step()).stop.is_none() {}
    let determinant = search.progress().evaluation.least_determinant;
    (search, determinant)
}

fn image(search: &Search<2>, x: [f64; 2]) -> [f64; 2] {
    let u = interpolate::<2, 2>(search.grid(), search.displacement(), &x);
    [x[0] + u[0], x[1] + u[1]]
}

#[test]
fn a_pin_draws_its_point_to_where_it_is_tied() {
    // The rightmost point of the circle would go to the rightmost of the ellipse; it is tied to the topmost one.
    let pin = Pin { reference: [0.7, 0.5], template: [0.5, 0.7] };
    let settings = Settings { finest: 6, alignment: Alignment::None, ..Settings::default() };
    let off = |weight: f64| {
        let (search, determinant) = register(Settings { pin_weight: weight, ..settings }, &[pin]);
        assert!(determinant > 0.0);
        let [x, y] = image(&search, pin.reference);
        (x - 0.5).hypot(y - 0.7)
    };
    let (ignored, tied) = (off(0.0), off(10.0));
    assert!(ignored > 0.2, "without weight it stays {ignored} away");
    assert!(tied < 0.02, "with weight it comes within {tied}");
}

#[test]
fn a_pin_chooses_among_starts_that_are_equally_good() {
    // A star onto itself: any tip may go to any other, and without a pin none moves.
    let star = star([0.5; 2], 0.21, 5, 0.24, 0.0);
    let settings = Settings { finest: 5, ..Settings::default() };
    let grid = Grid::of_level(settings.finest);
    let tip = |number: u32| -> [f64; 2] {
        let angle = std::f64::consts::TAU * f64::from(number) / 5.0;
        let radius = 0.21 * 1.24;
        [0.5 + radius * angle.cos(), 0.5 + radius * angle.sin()]
    };
    for aim in 0..5 {
        let [reference, template] =
            [(), ()].map(|()| SignedDistance::from_loops(grid, std::slice::from_ref(&star)).expect("a star"));
        let pin = Pin { reference: tip(0), template: tip(aim) };
        let mut search = ready(Search::with_pins(reference, template, settings, &[pin])).expect("valid settings");
        while ready(search.step()).stop.is_none() {}
        for number in 0..5 {
            let ([x, y], [u, v]) = (image(&search, tip(number)), tip((number + aim) % 5));
            let off = (x - u).hypot(y - v);
            assert!(off < 0.02, "tied by {aim} tips, tip {number} ends {off} from its partner");
        }
    }
}

#[test]
fn pins_that_contradict_each_other_never_fold_the_plane() {
    // Neighbours tied crosswise, and one point tied to two.
    let pins = [
        Pin { reference: [0.68, 0.5], template: [0.2, 0.5] },
        Pin { reference: [0.32, 0.5], template: [0.8, 0.5] },
        Pin { reference: [0.5, 0.7], template: [0.5, 0.3] },
        Pin { reference: [0.5, 0.7], template: [0.1, 0.9] },
    ];
    for pin_weight in [1.0, 1e3, 1e6] {
        let (search, determinant) = register(Settings { finest: 5, pin_weight, ..Settings::default() }, &pins);
        assert!(determinant > 0.0, "weight {pin_weight}: {determinant}");
        assert!(search.displacement().iter().all(|u| u.is_finite()));
    }
}

#[test]
fn an_update_takes_pins_away_again() {
    let settings = Settings { finest: 5, alignment: Alignment::None, ..Settings::default() };
    let (mut search, _) = register(settings, &[Pin { reference: [0.7, 0.5], template: [0.5, 0.7] }]);
    assert!(search.progress().evaluation.energies.pins > 0.0);
    let [reference, template] = search.shapes().map(Clone::clone);
    ready(search.update(reference, template, settings, &[])).expect("valid settings");
    assert_eq!(search.progress().evaluation.energies.pins, 0.0);
}
