//! Every energy density against its own derivatives, in both dimensions, by one checker.

mod common;

use common::Random;
use thinshell::energy::{
    Bending, GRADIENT, HESSIAN, MAX_SLOTS, Material, MeanCurvature, Membrane, Mismatch, Point, ProjectedMembrane,
    ReferenceJet, Response, Slots, Tangency, TemplateJet, Term, VALUE, Volume, normal_slot, position_slot,
};
use thinshell::small::{F64x2, Scalar};

const MATERIAL: Material = Material { lambda: 2.0, mu: 0.25 };

/// A template whose distance, normal and curvature are quadratic functions of y, with exact derivatives.
struct Template<const D: usize> {
    value: [f64; 8],
    normal: [[f64; 8]; 3],
    curvature: [[[f64; 8]; 3]; 3],
}

impl<const D: usize> Template<D> {
    fn random(random: &mut Random) -> Self {
        let mut coefficients = || std::array::from_fn(|_| random.between(-1.0, 1.0));
        let mut curvature = [[[0.0; 8]; 3]; 3];
        for a in 0..D {
            for b in a..D {
                curvature[a][b] = coefficients();
                curvature[b][a] = curvature[a][b];
            }
        }
        let mut normal = [[0.0; 8]; 3];
        for (axis, normal) in normal.iter_mut().enumerate().take(D) {
            // About a unit vector along the last axis.
            *normal = coefficients().map(|c| 0.2 * c);
            normal[0] += if axis == D - 1 { 1.0 } else { 0.0 };
        }
        Self { value: coefficients(), normal, curvature }
    }

    /// With the same normal everywhere.
    fn with_even_normal(mut self) -> Self {
        for normal in &mut self.normal {
            normal[1..].fill(0.0);
        }
        self
    }

    /// c₀ + Σ c_{1+k} y_k + Σ c_{4+k} y_k², and its gradient.
    fn quadratic(c: &[f64; 8], y: &[f64; D]) -> (f64, [f64; D]) {
        let value = c[0] + (0..D).map(|k| c[1 + k] * y[k] + c[4 + k] * y[k] * y[k]).sum::<f64>();
        (value, std::array::from_fn(|k| c[1 + k] + 2.0 * c[4 + k] * y[k]))
    }

    fn point(&self, slots: Slots<f64, D>, reference: ReferenceJet<f64, D>) -> Point<f64, D> {
        let y = &slots[position_slot::<D>()];
        let (distance, gradient) = Self::quadratic(&self.value, y);
        let mut normal = [0.0; D];
        let mut normal_slope = [[0.0; D]; D];
        for a in 0..D {
            let (value, slope) = Self::quadratic(&self.normal[a], y);
            normal[a] = value;
            for k in 0..D {
                normal_slope[k][a] = slope[k];
            }
        }
        let mut curvature = [[0.0; D]; D];
        let mut curvature_slope = [[[0.0; D]; D]; D];
        for a in 0..D {
            for b in 0..D {
                let (value, slope) = Self::quadratic(&self.curvature[a][b], y);
                curvature[a][b] = value;
                for k in 0..D {
                    curvature_slope[k][a][b] = slope[k];
                }
            }
        }
        let template = TemplateJet { distance, gradient, normal, normal_slope, curvature, curvature_slope };
        Point { slots, reference, template }
    }
}

fn random_slots<const D: usize>(random: &mut Random) -> Slots<f64, D> {
    // Near the identity, so that no determinant changes sign.
    std::array::from_fn(|p| std::array::from_fn(|a| random.between(-0.3, 0.3) + if p == a { 1.0 } else { 0.0 }))
}

fn random_reference<const D: usize>(random: &mut Random) -> ReferenceJet<f64, D> {
    let mut curvature = [[0.0; D]; D];
    for a in 0..D {
        for b in a..D {
            curvature[a][b] = random.between(-1.0, 1.0);
            curvature[b][a] = curvature[a][b];
        }
    }
    ReferenceJet {
        distance: random.between(-0.2, 0.2),
        curvature,
        off_tangential: random.between(0.0, 1.0),
        trace: random.between(-1.0, 1.0),
        steepness: random.between(0.8, 1.1),
    }
}

fn moved<const D: usize>(slots: &Slots<f64, D>, step: f64, direction: &Slots<f64, D>) -> Slots<f64, D> {
    std::array::from_fn(|p| std::array::from_fn(|a| slots[p][a] + step * direction[p][a]))
}

fn pair<const D: usize>(a: &Slots<f64, D>, b: &Slots<f64, D>) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(x, y)| x * y).sum()
}

/// E(z + τ d) − E(z) − τ ⟨∇E, d⟩ falls like τ²: halving τ quarters it.
fn taylor<const D: usize>(term: &impl Term<D>) {
    let mut random = Random(7);
    let mut bent = 0;
    for _ in 0..20 {
        let template = Template::<D>::random(&mut random);
        let reference = random_reference(&mut random);
        let slots = random_slots(&mut random);
        let direction: Slots<f64, D> = std::array::from_fn(|_| std::array::from_fn(|_| random.between(-1.0, 1.0)));
        let mut response = Response::zero();
        let value = term.add::<f64, GRADIENT>(1.0, &template.point(slots, reference), &mut response);
        let slope = pair(&response.gradient, &direction);
        let remainder = |step: f64| {
            let mut unused = Response::zero();
            let point = template.point(moved(&slots, step, &direction), reference);
            term.add::<f64, VALUE>(1.0, &point, &mut unused) - value - step * slope
        };
        let (first, second) = (remainder(1e-3), remainder(5e-4));
        if first.abs() < 1e-10 {
            continue; // linear along this direction but for rounding
        }
        let order = (first / second).log2();
        assert!((order - 2.0).abs() < 0.1, "the remainder falls with order {order}, not 2 ({first:e}, {second:e})");
        bent += 1;
    }
    assert!(bent > 10, "{bent} of 20 tell something");
}

/// The full symmetric matrix of a response's hessian.
fn matrix<const D: usize>(response: &Response<f64, D>) -> Vec<Vec<f64>> {
    let mut m = vec![vec![0.0; (D + 1) * D]; (D + 1) * D];
    for p in 0..=D {
        for q in p..=D {
            for a in 0..D {
                for b in 0..D {
                    m[p * D + a][q * D + b] = response.hessian[p][q][a][b];
                    m[q * D + b][p * D + a] = response.hessian[p][q][a][b];
                }
            }
        }
    }
    m
}

/// No negative eigenvalue beyond rounding: the shifted matrix has a Cholesky factor.
fn assert_semidefinite(mut m: Vec<Vec<f64>>) {
    let n = m.len();
    let scale: f64 = (0..n).map(|k| m[k][k]).sum::<f64>().max(1e-300);
    for column in 0..n {
        m[column][column] += 1e-10 * scale;
        let pivot = m[column][column];
        assert!(pivot > 0.0, "a negative eigenvalue: pivot {pivot:e} of trace {scale:e}");
        let upper = m[column].clone();
        for row in m.iter_mut().skip(column + 1) {
            let factor = row[column] / pivot;
            for (entry, above) in row.iter_mut().zip(&upper).skip(column) {
                *entry -= factor * above;
            }
        }
    }
}

/// Diagonal blocks are symmetric and the whole has no negative eigenvalue, also far from the identity.
fn hessian_is_semidefinite<const D: usize>(term: &impl Term<D>) {
    let mut random = Random(11);
    for _ in 0..200 {
        let template = Template::<D>::random(&mut random);
        let squeeze = random.between(0.2, 2.0);
        let slots = random_slots::<D>(&mut random).map(|v| v.map(|x| x * squeeze));
        let mut response = Response::zero();
        term.add::<f64, HESSIAN>(1.0, &template.point(slots, random_reference(&mut random)), &mut response);
        for p in 0..=D {
            for a in 0..D {
                for b in 0..D {
                    let (upper, lower) = (response.hessian[p][p][a][b], response.hessian[p][p][b][a]);
                    assert!((upper - lower).abs() < 1e-9 * (1.0 + upper.abs()), "{upper} is not {lower}");
                }
            }
        }
        assert_semidefinite(matrix(&response));
    }
}

/// Where nothing is clipped and the residual is zero, the hessian is the derivative of the gradient.
fn hessian_is_exact<const D: usize>(
    term: &impl Term<D>,
    point: impl Fn(Slots<f64, D>) -> Point<f64, D>,
    slots: Slots<f64, D>,
) {
    let gradient = |slots: Slots<f64, D>| {
        let mut response = Response::zero();
        term.add::<f64, GRADIENT>(1.0, &point(slots), &mut response);
        response.gradient
    };
    let mut response = Response::zero();
    term.add::<f64, HESSIAN>(1.0, &point(slots), &mut response);
    let found = matrix(&response);
    let step = 1e-5;
    for q in 0..=D {
        for b in 0..D {
            let mut direction = [[0.0; D]; MAX_SLOTS];
            direction[q][b] = 1.0;
            let (ahead, behind) =
                (gradient(moved(&slots, step, &direction)), gradient(moved(&slots, -step, &direction)));
            for p in 0..=D {
                for a in 0..D {
                    let quotient = (ahead[p][a] - behind[p][a]) / (2.0 * step);
                    let entry = found[p * D + a][q * D + b];
                    assert!((entry - quotient).abs() < 1e-6 * (1.0 + entry.abs()), "{entry} is not {quotient}");
                }
            }
        }
    }
}

#[test]
fn all_terms_have_second_order_taylor_remainders() {
    taylor::<2>(&Membrane(MATERIAL));
    taylor::<3>(&Membrane(MATERIAL));
    taylor::<2>(&ProjectedMembrane(MATERIAL));
    taylor::<3>(&ProjectedMembrane(MATERIAL));
    taylor::<2>(&Tangency);
    taylor::<3>(&Tangency);
    taylor::<2>(&Bending);
    taylor::<3>(&Bending);
    taylor::<2>(&MeanCurvature);
    taylor::<3>(&MeanCurvature);
    taylor::<2>(&Mismatch);
    taylor::<3>(&Mismatch);
    taylor::<2>(&Volume(MATERIAL));
    taylor::<3>(&Volume(MATERIAL));
}

#[test]
fn all_hessians_are_symmetric_without_negative_eigenvalues() {
    hessian_is_semidefinite::<2>(&Membrane(MATERIAL));
    hessian_is_semidefinite::<3>(&Membrane(MATERIAL));
    hessian_is_semidefinite::<2>(&ProjectedMembrane(MATERIAL));
    hessian_is_semidefinite::<3>(&ProjectedMembrane(MATERIAL));
    hessian_is_semidefinite::<2>(&Tangency);
    hessian_is_semidefinite::<3>(&Tangency);
    hessian_is_semidefinite::<2>(&Bending);
    hessian_is_semidefinite::<3>(&Bending);
    hessian_is_semidefinite::<2>(&MeanCurvature);
    hessian_is_semidefinite::<3>(&MeanCurvature);
    hessian_is_semidefinite::<2>(&Mismatch);
    hessian_is_semidefinite::<3>(&Mismatch);
    hessian_is_semidefinite::<2>(&Volume(MATERIAL));
    hessian_is_semidefinite::<3>(&Volume(MATERIAL));
}

/// Slightly and evenly stretched, both isotropic densities are convex, hence not clipped.
fn stretched_densities_are_exact<const D: usize>() {
    let mut random = Random(3);
    let unused = random_reference(&mut random);
    let template = Template::<D>::random(&mut random);
    for _ in 0..20 {
        let slots: Slots<f64, D> = std::array::from_fn(|p| {
            std::array::from_fn(|a| random.between(-0.01, 0.01) + if p == a { 1.05 } else { 0.0 })
        });
        hessian_is_exact(&Membrane(MATERIAL), |slots| template.point(slots, unused), slots);
        hessian_is_exact(&Volume(MATERIAL), |slots| template.point(slots, unused), slots);
    }
}

#[test]
fn the_hessian_of_a_stretched_body_is_the_second_derivative() {
    stretched_densities_are_exact::<2>();
    stretched_densities_are_exact::<3>();
}

/// Along a template with an even normal, a tangential shell has the hessian of the plain membrane and, across, one of
/// its own; both exact.
fn projected_membrane_is_exact_on_the_template<const D: usize>() {
    let mut random = Random(17);
    for _ in 0..20 {
        let template = Template::<D>::random(&mut random).with_even_normal();
        let reference = random_reference(&mut random);
        let mut slots: Slots<f64, D> = std::array::from_fn(|p| {
            std::array::from_fn(|a| random.between(-0.01, 0.01) + if p == a { 1.05 } else { 0.0 })
        });
        align_with_template(&template, reference, &mut slots);
        hessian_is_exact(&ProjectedMembrane(MATERIAL), |slots| template.point(slots, reference), slots);
    }
}

#[test]
fn the_projected_membrane_has_its_second_derivative_on_the_template() {
    projected_membrane_is_exact_on_the_template::<2>();
    projected_membrane_is_exact_on_the_template::<3>();
}

/// Makes Dφ t_i tangential to the template and Dφ n its normal's inverse: g·Dφ t_i = 0, g·Dφ n = |∇d1|.
fn align_with_template<const D: usize>(
    template: &Template<D>,
    reference: ReferenceJet<f64, D>,
    slots: &mut Slots<f64, D>,
) {
    let g = template.point(*slots, reference).template.normal;
    let square = thinshell::small::dot(&g, &g);
    for (i, slot) in slots.iter_mut().enumerate().take(D) {
        let wanted = if i == normal_slot::<D>() { reference.steepness } else { 0.0 };
        let missing = (wanted - thinshell::small::dot(&g, slot)) / square;
        *slot = thinshell::small::add_scaled(slot, missing, &g);
    }
}

/// A shell that lies on the template costs what the plain membrane costs, however stretched.
#[test]
fn on_the_template_both_membranes_are_one() {
    fn compare<const D: usize>() {
        let mut random = Random(19);
        for _ in 0..20 {
            let mut template = Template::<D>::random(&mut random).with_even_normal();
            // A unit vector.
            let length = (0..D).map(|k| template.normal[k][0].powi(2)).sum::<f64>().sqrt();
            template.normal.iter_mut().for_each(|normal| normal[0] /= length);
            let reference = random_reference(&mut random);
            let mut slots = random_slots(&mut random);
            align_with_template(&template, reference, &mut slots);
            let point = template.point(slots, reference);
            let mut unused = Response::zero();
            let plain = Membrane(MATERIAL).add::<f64, VALUE>(1.0, &point, &mut unused);
            let projected = ProjectedMembrane(MATERIAL).add::<f64, VALUE>(1.0, &point, &mut unused);
            assert!((plain - projected).abs() < 1e-12 * plain, "{projected} is not {plain}");
        }
    }
    compare::<2>();
    compare::<3>();
}

/// With the reference's jet equal to the template's, the residual vanishes and Gauss–Newton is exact.
fn gauss_newton_is_exact_without_residual<const D: usize>() {
    let mut random = Random(5);
    for _ in 0..20 {
        let template = Template::<D>::random(&mut random);
        let slots = random_slots::<D>(&mut random);
        let mut reference = random_reference(&mut random);
        let there = template.point(slots, reference);
        reference.distance = there.template.distance;
        reference.trace = (0..D).map(|k| there.template.curvature[k][k]).sum();
        for i in 0..D {
            for j in 0..D {
                let bent = thinshell::small::apply(&there.template.curvature, &slots[j]);
                reference.curvature[i][j] = thinshell::small::dot(&slots[i], &bent);
            }
        }
        hessian_is_exact(&Bending, |slots| template.point(slots, reference), slots);
        hessian_is_exact(&MeanCurvature, |slots| template.point(slots, reference), slots);
        hessian_is_exact(&Mismatch, |slots| template.point(slots, reference), slots);
        let mut aligned = slots;
        align_with_template(&template, reference, &mut aligned);
        hessian_is_exact(&Tangency, |slots| template.point(slots, reference), aligned);
    }
}

#[test]
fn gauss_newton_is_the_second_derivative_at_residual_zero() {
    gauss_newton_is_exact_without_residual::<2>();
    gauss_newton_is_exact_without_residual::<3>();
}

#[test]
fn lanes_give_what_the_scalar_gives() {
    fn compare<const D: usize>(term: &impl Term<D>) {
        let mut random = Random(13);
        let template = Template::<D>::random(&mut random);
        let points: [Point<f64, D>; 2] =
            std::array::from_fn(|_| template.point(random_slots(&mut random), random_reference(&mut random)));
        let pick = |f: &dyn Fn(&Point<f64, D>) -> f64| F64x2::gather(|lane| f(&points[lane]));
        let matrix = |f: &dyn Fn(&Point<f64, D>) -> [[f64; D]; D]| {
            std::array::from_fn(|a| std::array::from_fn(|b| pick(&|point| f(point)[a][b])))
        };
        let lanes = Point {
            slots: std::array::from_fn(|slot| std::array::from_fn(|a| pick(&|p| p.slots[slot][a]))),
            reference: ReferenceJet {
                distance: pick(&|p| p.reference.distance),
                curvature: matrix(&|p| p.reference.curvature),
                off_tangential: pick(&|p| p.reference.off_tangential),
                trace: pick(&|p| p.reference.trace),
                steepness: pick(&|p| p.reference.steepness),
            },
            template: TemplateJet {
                distance: pick(&|p| p.template.distance),
                gradient: std::array::from_fn(|a| pick(&|p| p.template.gradient[a])),
                normal: std::array::from_fn(|a| pick(&|p| p.template.normal[a])),
                normal_slope: matrix(&|p| p.template.normal_slope),
                curvature: matrix(&|p| p.template.curvature),
                curvature_slope: std::array::from_fn(|k| matrix(&|p| p.template.curvature_slope[k])),
            },
        };
        let mut wide = Response::zero();
        let values = term.add::<F64x2, HESSIAN>(F64x2::splat(1.0), &lanes, &mut wide);
        for (lane, point) in points.iter().enumerate() {
            let mut response = Response::zero();
            assert_eq!(term.add::<f64, HESSIAN>(1.0, point, &mut response), values.lane(lane));
            for p in 0..=D {
                for a in 0..D {
                    assert_eq!(response.gradient[p][a], wide.gradient[p][a].lane(lane));
                    for q in p..=D {
                        for b in 0..D {
                            assert_eq!(response.hessian[p][q][a][b], wide.hessian[p][q][a][b].lane(lane));
                        }
                    }
                }
            }
        }
    }
    compare::<2>(&Membrane(MATERIAL));
    compare::<2>(&ProjectedMembrane(MATERIAL));
    compare::<2>(&Tangency);
    compare::<2>(&Bending);
    compare::<2>(&MeanCurvature);
    compare::<2>(&Mismatch);
    compare::<2>(&Volume(MATERIAL));
    compare::<3>(&Membrane(MATERIAL));
    compare::<3>(&ProjectedMembrane(MATERIAL));
    compare::<3>(&Tangency);
    compare::<3>(&Bending);
    compare::<3>(&MeanCurvature);
    compare::<3>(&Mismatch);
    compare::<3>(&Volume(MATERIAL));
}
