use super::{GRADIENT, HESSIAN, MAX_SLOTS, Material, Point, Response, Term};
use crate::small::{Matrix, Scalar, cofactor, determinant, dot, frobenius};

/// Penalises the deformation of the surrounding space; infinite where it would fold.
///
/// W(F) = μ/2 |F|² + g(J²), F = Dφ, J = det F,  ∂W/∂F = μ F + 2J g′(J²) cof F.
///
/// Curvature, D = 2: split F into its conformal part z₊ and its anticonformal part z₋ (two coordinates each,
/// orthonormal), so that |F|² = |z₊|² + |z₋|² and J = (|z₊|² − |z₋|²)/2.  With k(J) = g(J²) the second derivative is
/// μ + k′ across z₊ (twist), μ − k′ across z₋ (flip), and a 2×2 block along (z₊, z₋) (scaling); each is projected
/// onto the positive semi-definite ones.
///
/// Curvature, D = 3: μ 1 + t k′ ∂²J + k″ ∂J ⊗ ∂J, of which only the middle part is indefinite. ∂²J has the eigenvalues ±σ_i
/// (twists and flips), σ the singular values of F, and those of a block in the span of the stretches, of least value
/// −|F| or more. Under compression (k′J < 0) that block is no danger: off its diagonal, k″ ∂J ⊗ ∂J has the same entries times
/// k″J > |k′|. So t = min(1, μ/(|k′| s)) with s the largest σ_i under compression and |F| otherwise leaves no negative
/// eigenvalue; at F = 1, as nearly everywhere, t = 1 and the second derivative is exact.
/// Units: none.  Source: eq. (8).
pub struct Volume(pub Material);

impl<const D: usize> Term<D> for Volume {
    #[inline(always)]
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S {
        let material = &self.0;
        let f: &Matrix<S, D> = &std::array::from_fn(|k| point.slots[k]);
        let mu = S::splat(material.mu);
        let det = determinant(f);
        let (g, slope, bend) = material.dilation(det * det);
        let twist = (det + det) * slope;
        if ORDER >= GRADIENT {
            let cof = cofactor(f);
            for k in 0..D {
                for a in 0..D {
                    response.gradient[k][a] += weight * (mu * f[k][a] + twist * cof[k][a]);
                }
            }
        }
        if ORDER >= HESSIAN {
            let bulk = slope + slope + S::splat(4.0) * det * det * bend;
            if D == 2 {
                planar_hessian(weight, f, mu, twist, bulk, &mut response.hessian);
            } else {
                spatial_hessian(weight, f, mu, twist, bulk, &mut response.hessian);
            }
        }
        S::splat(0.5) * mu * frobenius(f) + g
    }
}

/// Adds the projected second derivative of μ/2|F|² + k(det F), with k′ and k″ given, for D = 2.
#[inline(always)]
fn planar_hessian<S: Scalar, const D: usize>(
    weight: S,
    f: &Matrix<S, D>,
    mu: S,
    first: S,
    second: S,
    hessian: &mut [[Matrix<S, D>; MAX_SLOTS]; MAX_SLOTS],
) {
    let (zero, half, tiny) = (S::zero(), S::splat(0.5), S::splat(1e-30));
    let root = S::splat(std::f64::consts::FRAC_1_SQRT_2);
    let plus = [root * (f[0][0] + f[1][1]), root * (f[0][1] - f[1][0])];
    let minus = [root * (f[0][0] - f[1][1]), root * (f[0][1] + f[1][0])];
    let length = |z: &[S; 2]| (z[0] * z[0] + z[1] * z[1]).sqrt();
    let (a, b) = (length(&plus), length(&minus));
    let unit = |z: &[S; 2], length: S| {
        let inverse = S::splat(1.0) / length.max(tiny);
        [z[0] * inverse, z[1] * inverse]
    };
    let (e, d) = (unit(&plus, a), unit(&minus, b));

    // The scaling block, projected: its positive part is (p₊ + p₋)/2 I + (p₊ − p₋)/2 · deviator/radius.
    let (twist, flip) = (mu + first, mu - first);
    let (aa, bb, ab) = (twist + second * a * a, flip + second * b * b, -(second * a * b));
    let (mean, deviation) = (half * (aa + bb), half * (aa - bb));
    let radius = (deviation * deviation + ab * ab).sqrt();
    let (high, low) = ((mean + radius).max(zero), (mean - radius).max(zero));
    let (centre, spread) = (half * (high + low), half * (high - low) / radius.max(tiny));
    let (aa, bb, ab) = (centre + spread * deviation, centre - spread * deviation, spread * ab);
    let (twist, flip) = (twist.max(zero), flip.max(zero));

    let own = |e: &[S; 2], across: S, along: S| {
        let difference = along - across;
        [across + difference * e[0] * e[0], difference * e[0] * e[1], across + difference * e[1] * e[1]]
    };
    let (p, m) = (own(&e, twist, aa), own(&d, flip, bb));
    let cross: [[S; 2]; 2] = [[ab * e[0] * d[0], ab * e[0] * d[1]], [ab * e[1] * d[0], ab * e[1] * d[1]]];

    // Back to the entries: F₀₀ = (z₀+z₂)/√2, F₁₁ = (z₀−z₂)/√2, F₀₁ = (z₁+z₃)/√2, F₁₀ = (z₃−z₁)/√2.
    let w = weight * half;
    let two = |x: S| x + x;
    hessian[0][0][0][0] += w * (p[0] + two(cross[0][0]) + m[0]);
    hessian[1][1][1][1] += w * (p[0] - two(cross[0][0]) + m[0]);
    hessian[0][0][1][1] += w * (p[2] + two(cross[1][1]) + m[2]);
    hessian[1][1][0][0] += w * (p[2] - two(cross[1][1]) + m[2]);
    let off = w * (p[1] + cross[0][1] + cross[1][0] + m[1]);
    hessian[0][0][0][1] += off;
    hessian[0][0][1][0] += off;
    let off = w * (-p[1] + cross[0][1] + cross[1][0] - m[1]);
    hessian[1][1][0][1] += off;
    hessian[1][1][1][0] += off;
    hessian[0][1][0][0] += w * (-p[1] + cross[0][1] - cross[1][0] + m[1]);
    hessian[0][1][0][1] += w * (p[0] - m[0]);
    hessian[0][1][1][0] += w * (m[2] - p[2]);
    hessian[0][1][1][1] += w * (p[1] + cross[0][1] - cross[1][0] - m[1]);
}

/// Adds the shortened second derivative of μ/2|F|² + k(det F), with k′ and k″ given, for D = 3.
#[inline(always)]
fn spatial_hessian<S: Scalar, const D: usize>(
    weight: S,
    f: &Matrix<S, D>,
    mu: S,
    first: S,
    second: S,
    hessian: &mut [[Matrix<S, D>; MAX_SLOTS]; MAX_SLOTS],
) {
    let cof = cofactor(f);
    let det = dot(&f[0], &cof[0]);
    let first = weight * shortened(first, f, det, mu);
    let (mu, second) = (weight * mu, weight * second);
    for p in 0..D {
        for a in 0..D {
            hessian[p][p][a][a] += mu;
            for q in p..D {
                for b in 0..D {
                    hessian[p][q][a][b] += second * cof[p][a] * cof[q][b];
                }
            }
        }
        // ∂²J takes changes a and b of columns p < q to ±r·(a×b), r the third column.
        for q in p + 1..D {
            let r = D - p - q;
            let sign = if q == p + 1 { first } else { -first };
            for a in 0..D {
                let (b, c) = ((a + 1) % D, (a + 2) % D);
                hessian[p][q][a][b] += sign * f[r][c];
                hessian[p][q][b][a] += -(sign * f[r][c]);
            }
        }
    }
}

/// t k′: of the indefinite part k′ ∂²J of the second derivative at F, with J = det F, what μ outweighs.
#[inline(always)]
pub(crate) fn shortened<S: Scalar, const D: usize>(first: S, f: &Matrix<S, D>, det: S, mu: S) -> S {
    let square = frobenius(f);
    // A bound of the largest eigenvalue of FᵀF by its mean and the deviation from it, sharp at the identity.
    let mut squares = S::zero();
    for p in 0..D {
        for q in 0..D {
            squares += dot(&f[p], &f[q]).square();
        }
    }
    let mean = square * S::splat(1.0 / D as f64);
    let deviation = (squares - square * mean).max(S::zero()) * S::splat((D as f64 - 1.0) / D as f64);
    let largest = mean + deviation.sqrt();
    let zero = S::zero();
    let outward = first * (det / det.abs().max(S::splat(1e-30)));
    let bound = (-outward).max(zero) * largest.sqrt() + outward.max(zero) * square.sqrt();
    first * (mu / bound.max(mu))
}
