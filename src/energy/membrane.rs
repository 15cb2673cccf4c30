use super::spectral::{by_lane, membrane_hessian};
use super::{GRADIENT, HESSIAN, Material, Point, Response, Term};
use crate::small::{Matrix, Scalar, Vector, dot};

/// Penalises stretching and squeezing within the shell.
///
/// W = μ/2 tr G + g(det G), G_ij = v_i·v_j (Cauchy–Green strain in the tangent frame), v_i = Dφ t_i,
/// ∂W/∂v_i = μ v_i + 2 g′(det G) Σ_j cof(G)_ij v_j.
///
/// Hessian, D = 2, with s = |v|²: the eigenvalue along v is μ + 2g′ + 4s g″, always positive; the one across is
/// μ + 2g′, negative under compression and clipped at 0 (a compressed bar buckles).  D = 3: see `spectral`.
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
        return by_lane(v, |v| membrane_hessian(material, v));
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
