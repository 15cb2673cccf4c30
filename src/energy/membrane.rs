use super::{GRADIENT, HESSIAN, Material, Point, Response, Term};
use crate::small::{Matrix, Scalar, Vector, dot, normal_to};

/// Penalises stretching and squeezing within the shell.
///
/// W = μ/2 tr G + g(det G), G_ij = v_i·v_j (Cauchy–Green strain in the tangent frame), v_i = Dφ t_i,
/// ∂W/∂v_i = μ v_i + 2 g′(det G) Σ_j cof(G)_ij v_j.
///
/// Hessian, D = 2, with s = |v|²: the eigenvalue along v is μ + 2g′ + 4s g″, always positive; the one across is
/// μ + 2g′, negative under compression and clipped at 0 (a compressed bar buckles).
///
/// Hessian, D = 3, with k(J) = g(J²), J = √det G, and the normal n of the moved shell: within its plane
/// μ 1 + t k′ ∂²J + k″ ∂J ⊗ ∂J, where ∂²J has the eigenvalues ±1 and t = min(1, μ/|k′|) leaves none negative; across it
/// (μ 1 + k′ cof(G)/J)₊ ⊗ n ⊗ n, clipped at 0.
/// Units: none.  Source: eq. (2).
pub struct Membrane(pub Material);

impl<const D: usize> Term<D> for Membrane {
    #[inline(always)]
    fn add<S: Scalar, const ORDER: u8>(&self, weight: S, point: &Point<S, D>, response: &mut Response<S, D>) -> S {
        let (material, v) = (&self.0, &point.slots);
        let tangents: [Vector<S, D>; D] = std::array::from_fn(|i| v[i]);
        let strain = Strain::of(&tangents);
        let mu = S::splat(material.mu);
        let (g, slope, _) = material.dilation(strain.det);
        if ORDER >= GRADIENT {
            let forces = strain.forces(&tangents);
            for i in 0..D - 1 {
                for a in 0..D {
                    response.gradient[i][a] += weight * (mu * v[i][a] + slope * forces[i][a]);
                }
            }
        }
        if ORDER >= HESSIAN {
            let blocks = projected_hessian(material, &tangents, &strain);
            for i in 0..D - 1 {
                for j in i..D - 1 {
                    for a in 0..D {
                        for b in 0..D {
                            response.hessian[i][j][a][b] += weight * blocks[i][j][a][b];
                        }
                    }
                }
            }
        }
        S::splat(0.5) * mu * strain.trace + g
    }
}

/// G of the tangent vectors, the first D−1 of those given.
pub(super) struct Strain<S> {
    pub trace: S,
    pub det: S,
    pub cof: Matrix<S, 2>,
}

impl<S: Scalar> Strain<S> {
    #[inline(always)]
    pub fn of<const D: usize>(v: &[Vector<S, D>; D]) -> Self {
        if D == 2 {
            let square = dot(&v[0], &v[0]);
            let cof = [[S::splat(1.0), S::zero()], [S::zero(), S::splat(1.0)]];
            return Self { trace: square, det: square, cof };
        }
        let (a, b, c) = (dot(&v[0], &v[0]), dot(&v[0], &v[1]), dot(&v[1], &v[1]));
        Self { trace: a + c, det: a * c - b * b, cof: [[c, -b], [-b, a]] }
    }

    /// ∂ det G/∂v_i = 2 Σ_j cof_ij v_j.
    #[inline(always)]
    pub fn forces<const D: usize>(&self, v: &[Vector<S, D>; D]) -> [Vector<S, D>; D] {
        let mut forces = [[S::zero(); D]; D];
        for i in 0..D - 1 {
            for a in 0..D {
                for j in 0..D - 1 {
                    forces[i][a] += (self.cof[i][j] + self.cof[i][j]) * v[j][a];
                }
            }
        }
        forces
    }
}

/// The projected second derivative of [`Membrane`] by the tangent vectors: `[i][j]`, i ≤ j < D−1.
#[inline(always)]
pub(super) fn projected_hessian<S: Scalar, const D: usize>(
    material: &Material,
    v: &[Vector<S, D>; D],
    strain: &Strain<S>,
) -> [[Matrix<S, D>; D]; D] {
    if D == 3 {
        return surface_hessian(material, v, strain);
    }
    let mu = S::splat(material.mu);
    let (_, slope, bend) = material.dilation(strain.det);
    let across = (mu + slope + slope).max(S::zero());
    let along = mu + slope + slope + S::splat(4.0) * strain.det * bend;
    let difference = (along - across) / strain.det;
    let mut blocks = [[[[S::zero(); D]; D]; D]; D];
    for a in 0..D {
        for b in 0..D {
            blocks[0][0][a][b] = difference * v[0][a] * v[0][b];
        }
        blocks[0][0][a][a] += across;
    }
    blocks
}

/// [`projected_hessian`] for D = 3.
#[inline(always)]
fn surface_hessian<S: Scalar, const D: usize>(
    material: &Material,
    v: &[Vector<S, D>; D],
    strain: &Strain<S>,
) -> [[Matrix<S, D>; D]; D] {
    let (zero, half, tiny) = (S::zero(), S::splat(0.5), S::splat(1e-30));
    let mu = S::splat(material.mu);
    let (_, slope, bend) = material.dilation(strain.det);
    let area = strain.det.sqrt();
    let first = (area + area) * slope;
    let second = slope + slope + S::splat(4.0) * strain.det * bend;
    let within = first * (mu / first.abs().max(mu));
    let normal = normal_to(v).map(|x| x / area);
    // ∂J/∂v₀ = v₁×n and ∂J/∂v₁ = n×v₀.
    let by_first = normal_to(&pair_of(&v[1], &normal));
    let by_second = normal_to(&pair_of(&normal, &v[0]));

    // (μ 1 + k′ cof(G)/J)₊ by its mean and the deviation from it.
    let ratio = first / area;
    let (aa, bb, ab) = (mu + ratio * strain.cof[0][0], mu + ratio * strain.cof[1][1], ratio * strain.cof[0][1]);
    let (mean, deviation) = (half * (aa + bb), half * (aa - bb));
    let radius = (deviation * deviation + ab * ab).sqrt();
    let (high, low) = ((mean + radius).max(zero), (mean - radius).max(zero));
    let (centre, spread) = (half * (high + low), half * (high - low) / radius.max(tiny));
    let across = [[centre + spread * deviation, spread * ab], [spread * ab, centre - spread * deviation]];

    let slopes = [by_first, by_second];
    let mut blocks = [[[[zero; D]; D]; D]; D];
    for (i, j) in [(0, 0), (0, 1), (1, 1)] {
        let own = if i == j { mu } else { zero };
        for a in 0..D {
            for b in 0..D {
                blocks[i][j][a][b] =
                    second * slopes[i][a] * slopes[j][b] + (across[i][j] - own) * normal[a] * normal[b];
            }
            blocks[i][j][a][a] += own;
        }
    }
    // ∂²J takes changes a of v₀ and b of v₁ within the plane to n·(a×b).
    for a in 0..D {
        let (b, c) = ((a + 1) % D, (a + 2) % D);
        blocks[0][1][a][b] += within * normal[c];
        blocks[0][1][b][a] += -(within * normal[c]);
    }
    blocks
}

/// Two vectors as the first of a frame, for their cross product.
#[inline(always)]
fn pair_of<S: Scalar, const D: usize>(a: &Vector<S, D>, b: &Vector<S, D>) -> [Vector<S, D>; D] {
    std::array::from_fn(|k| if k == 0 { *a } else { *b })
}
