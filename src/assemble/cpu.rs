//! The reference assembler: f64, one thread, two cells at a time in the lanes of a register.

mod bilinear;
mod certificate;
mod corners;
#[cfg(test)]
mod definition;
mod element;
mod modes;
mod pins;
mod planar;
mod shell;
mod spatial;
mod transfer;
mod trilinear;
mod volume;

use super::band::{Band, TemplateField};
use super::{Assembler, Evaluation};
use crate::distance::SignedDistance;
use crate::energy::{Energies, Functional, GRADIENT, HESSIAN, VALUE};
use crate::grid::{Grid, MAX_CORNERS};
use crate::quadrature::Rule;
use crate::small::{F32x4, F64x2, Scalar};
use crate::stencil::StencilOperator;

/// Evaluates the functional of one level for two shapes given on the same grid.
///
/// The volume energy runs over all cells, the shell energies over the band's cells only. `S` is the scalar of the
/// kernels: `f64`, or lanes of it for two cells at once.
pub struct CpuAssembler<const D: usize, S: Scalar = F64x2> {
    pub(super) functional: Functional,
    pub(super) grid: Grid<D>,
    gauss3: Rule<D, 3>,
    gauss2: Rule<D, 2>,
    vertices: Rule<D, 2>,
    pub(super) band: Band<S, D>,
    pub(super) template: TemplateField<D>,
    /// Weight of the volume density by cells, quadrature weights excluded.
    pub(super) volume_weight: Vec<f64>,
    pub(super) pins: Vec<pins::Placed<D>>,
    corner_neighbours: [[usize; MAX_CORNERS]; MAX_CORNERS],
    integrals: spatial::CellIntegrals<D>,
}

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// # Panics
    /// If the shapes live on different grids, or the cells of a row are no multiple of four.
    pub fn new(functional: &Functional, reference: &SignedDistance<D>, template: &SignedDistance<D>) -> Self {
        let grid = reference.grid();
        assert_eq!(grid, template.grid(), "both shapes live on the level's grid");
        assert_eq!(grid.cells() % F32x4::LANES, 0, "a row of cells fills its lanes");
        let (gauss3, gauss2) = (Rule::gauss3(), Rule::gauss2());
        let cell_volume = grid.spacing().powi(D as i32);
        let offsets = grid.corner_offsets();
        let inside = |cell: usize| {
            let base = grid.lowest_node(cell);
            (0..Grid::<D>::CORNERS).map(|c| reference.values()[base + offsets[c]]).sum::<f64>() < 0.0
        };
        let volume_weight = (0..grid.cell_count())
            .map(|cell| {
                let softness = if inside(cell) { 1.0 } else { functional.softness };
                functional.volume * softness * cell_volume
            })
            .collect();
        Self {
            functional: *functional,
            grid,
            band: match functional.gauss_points {
                2 if D == 3 => Band::new(functional, reference, &gauss2),
                3 => Band::new(functional, reference, &gauss3),
                _ => unreachable!("3 points an axis, or in space 2"),
            },
            template: TemplateField::new(template, functional.fit_radius),
            gauss3,
            integrals: spatial::CellIntegrals::new(),
            gauss2,
            vertices: Rule::vertices(),
            volume_weight,
            pins: Vec::new(),
            corner_neighbours: StencilOperator::<D>::corner_neighbours(),
        }
    }

    /// Cells that carry shell energies.
    pub fn band_cells(&self) -> usize {
        self.band.packs.len() * S::LANES
    }

    /// With C = 2^D, which the type system cannot compute, as the size of local arrays.
    fn evaluate<const ORDER: u8>(
        &self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut Option<&mut StencilOperator<D>>,
    ) -> Evaluation {
        match D {
            2 => self.evaluate_cells::<ORDER, 4>(displacement, gradient, operator),
            3 => self.evaluate_cells::<ORDER, 8>(displacement, gradient, operator),
            _ => unreachable!("curves and surfaces live in 2 or 3 dimensions"),
        }
    }

    fn evaluate_cells<const ORDER: u8, const C: usize>(
        &self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut Option<&mut StencilOperator<D>>,
    ) -> Evaluation {
        assert_eq!(displacement.len(), self.grid.node_count() * D);
        if ORDER >= GRADIENT {
            assert_eq!(gradient.len(), displacement.len());
            gradient.fill(0.0);
        }
        if let Some(operator) = operator {
            assert_eq!(operator.grid(), self.grid);
            operator.clear();
        }
        let mut energies = Energies::default();
        // In the plane there are always three: what is for two then takes no room in the module.
        let few = D == 3 && self.functional.gauss_points == 2;
        let least_determinant = if D == 2 {
            self.planar_volume_pass::<ORDER>(displacement, gradient, &mut energies)
        } else if few {
            self.spatial_volume_pass::<ORDER, 2>(&self.gauss2, displacement, gradient, &mut energies)
        } else {
            self.spatial_volume_pass::<ORDER, 3>(&self.gauss3, displacement, gradient, &mut energies)
        };
        if least_determinant > 0.0 {
            let mut sums = [S::zero(); 3];
            for layer in 0..Band::<S, D>::layer_count(self.grid) {
                let packs = self.band.layer(layer);
                if few {
                    self.shell_pass::<ORDER, C, 2>(&self.gauss2, packs, displacement, gradient, operator, &mut sums);
                } else {
                    self.shell_pass::<ORDER, C, 3>(&self.gauss3, packs, displacement, gradient, operator, &mut sums);
                }
                let nodes = Band::<S, D>::layer_nodes(self.grid, layer);
                self.pins_pass::<ORDER, C>(nodes, displacement, gradient, operator, &mut energies);
                if let Some(operator) = operator {
                    // The operator is f32, and so is what goes into it here: four cells at a time instead of two.
                    if D == 2 {
                        self.planar_hessian_pass::<C>(displacement, operator);
                    } else {
                        self.spatial_hessian_pass::<C>(layer, displacement, operator);
                    }
                }
            }
            [energies.membrane, energies.bending, energies.mismatch] = sums.map(S::sum);
        }
        Evaluation { energies, least_determinant }
    }
}

impl<const D: usize, S: Scalar> Assembler<D> for CpuAssembler<D, S> {
    fn grid(&self) -> Grid<D> {
        self.grid
    }

    async fn energy(&mut self, displacement: &[f64]) -> Evaluation {
        self.evaluate::<VALUE>(displacement, &mut [], &mut None)
    }

    async fn gradient(&mut self, displacement: &[f64], gradient: &mut [f64]) -> Evaluation {
        self.evaluate::<GRADIENT>(displacement, gradient, &mut None)
    }

    async fn hessian(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut StencilOperator<D>,
    ) -> Evaluation {
        self.evaluate::<HESSIAN>(displacement, gradient, &mut Some(operator))
    }
}
