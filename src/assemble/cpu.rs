//! The reference assembler: f64, one thread, two cells at a time in the lanes of a register.

use super::band::{Band, ReferenceSample, TemplateField};
use super::{Assembler, Evaluation};
use crate::distance::SignedDistance;
use crate::energy::{CURVATURE, Energies, Functional, GRADIENT, Point, Response, Term, VALUE, Volume};
use crate::grid::{Grid, MAX_CORNERS};
use crate::quadrature::{Rule, edge_ends};
use crate::small::{F32x4, F64x2, Matrix, Scalar, Vector, add_scaled, determinant};
use crate::stencil::StencilOperator;

const MAX_EDGES: usize = 4;
const MAX_COLUMNS: usize = 9;

/// Evaluates the functional of one level for two shapes given on the same grid.
///
/// The volume energy runs over all cells, the shell energies over the band's cells only. `S` is the scalar of the
/// kernels: `f64`, or lanes of it for two cells at once.
pub struct CpuAssembler<const D: usize, S: Scalar = F64x2> {
    functional: Functional,
    grid: Grid<D>,
    gauss3: Rule<D, 3>,
    gauss2: Rule<D, 2>,
    vertices: Rule<D, 2>,
    band: Band<S, D>,
    template: TemplateField<D>,
    /// Weight of the volume density by cells, quadrature weights excluded.
    volume_weight: Vec<f64>,
    corner_neighbours: [[usize; MAX_CORNERS]; MAX_CORNERS],
}

/// Differences of a cell's displacements along its edges, and what hangs on them.
type Edges<S, const D: usize> = [[Vector<S, D>; MAX_EDGES]; D];
type Columns<S, const D: usize> = [[Vector<S, D>; MAX_COLUMNS]; D];
type Corners<S, const D: usize> = [Vector<S, D>; MAX_CORNERS];
/// The curvature of a cell: `pairs[a][b]` is the block of corners a ≤ b.
type Pairs<S, const D: usize, const C: usize> = [[Matrix<S, D>; C]; C];

impl<const D: usize, S: Scalar> CpuAssembler<D, S> {
    /// # Panics
    /// If the shapes live on different grids, or the cells of a row are no multiple of four.
    pub fn new(functional: &Functional, reference: &SignedDistance<D>, template: &SignedDistance<D>) -> Self {
        let grid = reference.grid();
        assert_eq!(grid, template.grid(), "both shapes live on the level's grid");
        assert_eq!(grid.cells() % F32x4::LANES, 0, "a row of cells fills its lanes");
        let gauss3 = Rule::gauss3();
        let cell_volume = grid.spacing().powi(D as i32);
        let offsets = grid.corner_offsets();
        let inside = |cell: usize| {
            let base = grid.lowest_node(cell);
            (0..Grid::<D>::CORNERS).map(|c| reference.values()[base + offsets[c]]).sum::<f64>() < 0.0
        };
        let volume_weight = (0..grid.cell_count())
            .map(|cell| {
                let softness = if inside(cell) { 1.0 } else { functional.interior };
                functional.volume * softness * cell_volume
            })
            .collect();
        Self {
            functional: *functional,
            grid,
            band: Band::new(functional, reference, &gauss3),
            template: TemplateField::new(template, functional.fit_radius),
            gauss3,
            gauss2: Rule::gauss2(),
            vertices: Rule::vertices(),
            volume_weight,
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
        let least_determinant = self.volume_pass::<ORDER>(displacement, gradient, &mut energies);
        if least_determinant > 0.0 {
            self.shell_pass::<ORDER, C>(displacement, gradient, operator, &mut energies);
            if let Some(operator) = operator {
                // The operator is f32, and so may be what goes into it: four cells at a time instead of two.
                self.volume_curvature_pass::<F32x4, C>(displacement, operator);
            }
        }
        Evaluation { energies, least_determinant }
    }

    /// Volume energy over all cells; returns the least determinant, and early once it is not positive.
    fn volume_pass<const ORDER: u8>(&self, displacement: &[f64], gradient: &mut [f64], energies: &mut Energies) -> f64 {
        let volume = Volume(self.functional.material);
        let share = S::splat(self.functional.vertex_share);
        let rest = S::splat(1.0 - self.functional.vertex_share);
        let inverse = S::splat(self.grid.cells() as f64);
        let mut energy = S::zero();
        let mut least = S::splat(f64::INFINITY);
        let packs_a_row = self.grid.cells() / S::LANES;

        for (pack, weights) in self.volume_weight.chunks_exact(S::LANES).enumerate() {
            let base = self.grid.lowest_node(pack * S::LANES);
            let nodes: [usize; 2] = std::array::from_fn(|lane| base + lane.min(S::LANES - 1));
            let weight = S::gather(|lane| weights[lane]);
            let corners = self.gather(displacement, nodes);
            let edges = edge_differences(&corners, inverse);
            let mut forces = [[[S::zero(); D]; MAX_EDGES]; D];

            // The corners first: they decide whether the deformation is admissible.
            let columns = columns_of(&self.vertices, &edges);
            for point in 0..Rule::<D, 2>::POINTS {
                least = least.min(determinant(&slots_at(&self.vertices, &columns, point)));
            }
            if self.functional.vertex_share > 0.0 {
                energy += self.volume_rule::<2, ORDER>(&self.vertices, &volume, weight * share, &columns, &mut forces);
            }
            let columns = columns_of(&self.gauss3, &edges);
            energy += self.volume_rule::<3, ORDER>(&self.gauss3, &volume, weight * rest, &columns, &mut forces);

            if ORDER >= GRADIENT {
                let mut corner_forces = [[S::zero(); D]; MAX_CORNERS];
                edge_forces_to_corners(&forces, inverse, &mut corner_forces);
                self.scatter(&corner_forces, nodes, gradient);
            }
            if (pack + 1) % packs_a_row == 0 && least.least() <= 0.0 {
                break;
            }
        }
        energies.volume = energy.sum();
        least.least()
    }

    /// The volume energy of a pack by one rule; adds forces on the edges.
    #[inline(always)]
    fn volume_rule<const M: usize, const ORDER: u8>(
        &self,
        rule: &Rule<D, M>,
        volume: &Volume,
        weight: S,
        columns: &Columns<S, D>,
        forces: &mut Edges<S, D>,
    ) -> S {
        let mut energy = S::zero();
        let mut stress = [[[S::zero(); D]; MAX_COLUMNS]; D];
        for point in 0..Rule::<D, M>::POINTS {
            let weight = weight * S::splat(rule.weight[point]);
            let slots = slots_at(rule, columns, point);
            let mut response = Response::zero();
            // The curvature has a rule of its own, see `volume_curvature_pass`.
            energy += weight
                * if ORDER == VALUE {
                    volume.add::<S, VALUE>(weight, &Point::of_slots(slots), &mut response)
                } else {
                    volume.add::<S, GRADIENT>(weight, &Point::of_slots(slots), &mut response)
                };
            if ORDER >= GRADIENT {
                for k in 0..D {
                    let column = &mut stress[k][rule.column[point][k]];
                    *column = add_scaled(column, S::splat(1.0), &response.gradient[k]);
                }
            }
        }
        if ORDER >= GRADIENT {
            stress_to_edges(rule, &stress, forces);
        }
        energy
    }

    /// The volume's curvature over all cells, `T` lanes at a time. 2^D Gauss points suffice: they leave no mode of a cell
    /// without curvature, and the minimiser needs as many iterations as with 3^D.
    fn volume_curvature_pass<T: Scalar, const C: usize>(
        &self,
        displacement: &[f64],
        operator: &mut StencilOperator<D>,
    ) {
        let volume = Volume(self.functional.material);
        let cells = self.grid.cells() as f64;
        let offsets = self.grid.corner_offsets();
        let rule = &self.gauss2;
        for (pack, weights) in self.volume_weight.chunks_exact(T::LANES).enumerate() {
            let base = self.grid.lowest_node(pack * T::LANES);
            // Differences are taken before the numbers are rounded to T.
            let mut edges = [[[T::zero(); D]; MAX_EDGES]; D];
            for (axis, edges) in edges.iter_mut().enumerate() {
                for (edge, difference) in edges.iter_mut().enumerate().take(1 << (D - 1)) {
                    let (low, high) = edge_ends(axis, edge);
                    let (low, high) =
                        (&displacement[(base + offsets[low]) * D..], &displacement[(base + offsets[high]) * D..]);
                    for k in 0..D {
                        difference[k] = T::gather(|lane| (high[lane * D + k] - low[lane * D + k]) * cells);
                    }
                }
            }
            let columns = columns_of(rule, &edges);
            let scaled = T::gather(|lane| weights[lane] * cells * cells);
            let mut curvatures = [[[[[T::zero(); D]; D]; D]; D]; C];
            for (point, curvature) in curvatures.iter_mut().enumerate() {
                let mut response = Response::zero();
                let slots = slots_at(rule, &columns, point);
                let weight = scaled * T::splat(rule.weight[point]);
                volume.add::<T, CURVATURE>(weight, &Point::of_slots(slots), &mut response);
                *curvature = response.curvature;
            }
            let mut pairs = [[[[T::zero(); D]; D]; C]; C];
            // A derivative of φ is an average over edges, so edge pairs are integrated and then handed to their ends.
            for p in 0..D {
                for q in p..D {
                    for e in 0..Rule::<D, 2>::EDGES {
                        for f in 0..Rule::<D, 2>::EDGES {
                            let mut block = [[T::zero(); D]; D];
                            for (point, curvature) in curvatures.iter().enumerate() {
                                let column = &rule.column[point];
                                let share = T::splat(rule.edge[column[p]][e] * rule.edge[column[q]][f]);
                                for a in 0..D {
                                    for b in 0..D {
                                        block[a][b] += share * curvature[p][q][a][b];
                                    }
                                }
                            }
                            add_edge_pair(&mut pairs, (p, e), (q, f), &block);
                        }
                    }
                }
            }
            self.scatter_pairs(&pairs, |lane| base + lane, operator);
        }
    }

    /// Membrane, bending and mismatch over the band's cells.
    fn shell_pass<const ORDER: u8, const C: usize>(
        &self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut Option<&mut StencilOperator<D>>,
        energies: &mut Energies,
    ) {
        let rule = &self.gauss3;
        let (spacing, inverse) = (S::splat(self.grid.spacing()), S::splat(self.grid.cells() as f64));
        let mut sums = [S::zero(); 3];
        for (pack, &nodes) in self.band.packs.iter().enumerate() {
            let corners = self.gather(displacement, nodes);
            let edges = edge_differences(&corners, inverse);
            let columns = columns_of(rule, &edges);
            let samples = self.band.pack_samples(pack);
            let indices = nodes.map(|node| self.grid.node_index(node));
            let origin: Vector<S, D> = std::array::from_fn(|k| S::gather(|lane| indices[lane][k] as f64) * spacing);

            let mut stress = [[[S::zero(); D]; MAX_COLUMNS]; D];
            let mut corner_forces = [[S::zero(); D]; MAX_CORNERS];
            let mut pairs = [[[[S::zero(); D]; D]; C]; C];
            for point in 0..Rule::<D, 3>::POINTS {
                let sample = ReferenceSample::<S, D>::read(samples, point);
                let derivative = slots_at(rule, &columns, point);
                let mut moved = origin;
                for corner in 0..Grid::<D>::CORNERS {
                    let shape = S::splat(rule.shape[point][corner]);
                    for k in 0..D {
                        let at = if corner >> k & 1 == 1 { corners[corner][k] + spacing } else { corners[corner][k] };
                        moved[k] += shape * at;
                    }
                }
                let mut slots = [[S::zero(); D]; D];
                slots[D - 1] = moved;
                for i in 0..D - 1 {
                    for (k, column) in derivative.iter().enumerate() {
                        slots[i] = add_scaled(&slots[i], sample.tangents[i][k], column);
                    }
                }
                let template = self.template.sample::<S, ORDER>(&moved);
                let mut response = Response::zero();
                let densities = self.functional.shell::<S, D, ORDER>(
                    sample.weight,
                    &Point { slots, reference: sample.jet, template },
                    &mut response,
                );
                for (sum, density) in sums.iter_mut().zip(densities) {
                    *sum += density;
                }
                if ORDER >= GRADIENT {
                    for (k, stress) in stress.iter_mut().enumerate() {
                        let column = &mut stress[rule.column[point][k]];
                        for i in 0..D - 1 {
                            *column = add_scaled(column, sample.tangents[i][k], &response.gradient[i]);
                        }
                    }
                    for corner in 0..Grid::<D>::CORNERS {
                        let shape = S::splat(rule.shape[point][corner]);
                        corner_forces[corner] = add_scaled(&corner_forces[corner], shape, &response.gradient[D - 1]);
                    }
                }
                if ORDER >= CURVATURE {
                    self.add_shell_pairs(&mut pairs, point, &sample.tangents, &response, inverse);
                }
            }
            if ORDER >= GRADIENT {
                let mut forces = [[[S::zero(); D]; MAX_EDGES]; D];
                stress_to_edges(rule, &stress, &mut forces);
                edge_forces_to_corners(&forces, inverse, &mut corner_forces);
                self.scatter(&corner_forces, nodes, gradient);
            }
            if ORDER >= CURVATURE
                && let Some(operator) = operator
            {
                self.scatter_pairs(&pairs, |lane| nodes[lane], operator);
            }
        }
        energies.membrane = sums[0].sum();
        energies.bending = sums[1].sum();
        energies.mismatch = sums[2].sum();
    }

    /// pairs[a][b] += Σ_pq s_ap s_bq H_pq with the slots' shape values s_ai = ∇N_a·t_i and s_ay = N_a.
    #[inline(always)]
    fn add_shell_pairs<const C: usize>(
        &self,
        pairs: &mut Pairs<S, D, C>,
        point: usize,
        tangents: &[Vector<S, D>; D],
        response: &Response<S, D>,
        inverse: S,
    ) {
        let rule = &self.gauss3;
        let mut values = [[S::zero(); D]; C];
        for axis in 0..D {
            for edge in 0..Rule::<D, 3>::EDGES {
                let slope = inverse * S::splat(rule.edge[rule.column[point][axis]][edge]);
                let (low, high) = edge_ends(axis, edge);
                for i in 0..D - 1 {
                    let along = slope * tangents[i][axis];
                    values[high][i] += along;
                    values[low][i] -= along;
                }
            }
        }
        for corner in 0..Grid::<D>::CORNERS {
            values[corner][D - 1] = S::splat(rule.shape[point][corner]);
        }
        for b in 0..Grid::<D>::CORNERS {
            // moved[p] = Σ_q s_bq H_pq
            let mut moved = [[[S::zero(); D]; D]; D];
            for p in 0..D {
                for q in 0..D {
                    for i in 0..D {
                        for j in 0..D {
                            let entry =
                                if p <= q { response.curvature[p][q][i][j] } else { response.curvature[q][p][j][i] };
                            moved[p][i][j] += values[b][q] * entry;
                        }
                    }
                }
            }
            for a in 0..=b {
                for p in 0..D {
                    for i in 0..D {
                        for j in 0..D {
                            pairs[a][b][i][j] += values[a][p] * moved[p][i][j];
                        }
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn gather(&self, displacement: &[f64], nodes: [usize; 2]) -> Corners<S, D> {
        let offsets = self.grid.corner_offsets();
        let mut corners = [[S::zero(); D]; MAX_CORNERS];
        for corner in 0..Grid::<D>::CORNERS {
            let rows: [&[f64]; 2] = nodes.map(|node| &displacement[(node + offsets[corner]) * D..][..D]);
            for k in 0..D {
                corners[corner][k] = S::gather(|lane| rows[lane][k]);
            }
        }
        corners
    }

    #[inline(always)]
    fn scatter(&self, forces: &Corners<S, D>, nodes: [usize; 2], gradient: &mut [f64]) {
        let offsets = self.grid.corner_offsets();
        for corner in 0..Grid::<D>::CORNERS {
            for lane in 0..S::LANES {
                let row = &mut gradient[(nodes[lane] + offsets[corner]) * D..][..D];
                for k in 0..D {
                    row[k] += forces[corner][k].lane(lane);
                }
            }
        }
    }

    #[inline(always)]
    fn scatter_pairs<T: Scalar, const C: usize>(
        &self,
        pairs: &Pairs<T, D, C>,
        node: impl Fn(usize) -> usize,
        operator: &mut StencilOperator<D>,
    ) {
        let offsets = self.grid.corner_offsets();
        for a in 0..Grid::<D>::CORNERS {
            for b in a..Grid::<D>::CORNERS {
                for lane in 0..T::LANES {
                    let (first, second) = (node(lane) + offsets[a], node(lane) + offsets[b]);
                    let block = operator.block_mut(first, self.corner_neighbours[a][b]);
                    for i in 0..D {
                        for j in 0..D {
                            block[i * D + j] += pairs[a][b][i][j].lane(lane) as f32;
                        }
                    }
                    if a != b {
                        let block = operator.block_mut(second, self.corner_neighbours[b][a]);
                        for i in 0..D {
                            for j in 0..D {
                                block[i * D + j] += pairs[a][b][j][i].lane(lane) as f32;
                            }
                        }
                    }
                }
            }
        }
    }
}

/// (u_high − u_low)/h along every edge.
#[inline(always)]
fn edge_differences<S: Scalar, const D: usize>(corners: &Corners<S, D>, inverse: S) -> Edges<S, D> {
    let mut edges = [[[S::zero(); D]; MAX_EDGES]; D];
    for (axis, edges) in edges.iter_mut().enumerate() {
        for (edge, difference) in edges.iter_mut().enumerate().take(1 << (D - 1)) {
            let (low, high) = edge_ends(axis, edge);
            for k in 0..D {
                difference[k] = (corners[high][k] - corners[low][k]) * inverse;
            }
        }
    }
    edges
}

/// The distinct columns ∂φ/∂x_k of a rule.
#[inline(always)]
fn columns_of<S: Scalar, const D: usize, const M: usize>(rule: &Rule<D, M>, edges: &Edges<S, D>) -> Columns<S, D> {
    let mut columns = [[[S::zero(); D]; MAX_COLUMNS]; D];
    for axis in 0..D {
        for column in 0..Rule::<D, M>::COLUMNS {
            let sum = &mut columns[axis][column];
            sum[axis] = S::splat(1.0);
            for edge in 0..Rule::<D, M>::EDGES {
                *sum = add_scaled(sum, S::splat(rule.edge[column][edge]), &edges[axis][edge]);
            }
        }
    }
    columns
}

#[inline(always)]
fn slots_at<S: Scalar, const D: usize, const M: usize>(
    rule: &Rule<D, M>,
    columns: &Columns<S, D>,
    point: usize,
) -> [Vector<S, D>; D] {
    std::array::from_fn(|k| columns[k][rule.column[point][k]])
}

/// The transpose of [`columns_of`].
#[inline(always)]
fn stress_to_edges<S: Scalar, const D: usize, const M: usize>(
    rule: &Rule<D, M>,
    stress: &Columns<S, D>,
    forces: &mut Edges<S, D>,
) {
    for axis in 0..D {
        for edge in 0..Rule::<D, M>::EDGES {
            for column in 0..Rule::<D, M>::COLUMNS {
                let share = S::splat(rule.edge[column][edge]);
                forces[axis][edge] = add_scaled(&forces[axis][edge], share, &stress[axis][column]);
            }
        }
    }
}

/// The transpose of [`edge_differences`].
#[inline(always)]
fn edge_forces_to_corners<S: Scalar, const D: usize>(forces: &Edges<S, D>, inverse: S, corners: &mut Corners<S, D>) {
    for (axis, forces) in forces.iter().enumerate() {
        for (edge, force) in forces.iter().enumerate().take(1 << (D - 1)) {
            let (low, high) = edge_ends(axis, edge);
            corners[high] = add_scaled(&corners[high], inverse, force);
            corners[low] = add_scaled(&corners[low], -inverse, force);
        }
    }
}

/// Adds the block of two edges to the blocks of their ends; (p, e) against (q, f) stands for its mirror image too.
#[inline(always)]
fn add_edge_pair<S: Scalar, const D: usize, const C: usize>(
    pairs: &mut Pairs<S, D, C>,
    (p, e): (usize, usize),
    (q, f): (usize, usize),
    block: &Matrix<S, D>,
) {
    let mut add = |a: usize, b: usize, positive: bool, transposed: bool| {
        if a > b {
            return;
        }
        for i in 0..D {
            for j in 0..D {
                let entry = if transposed { block[j][i] } else { block[i][j] };
                pairs[a][b][i][j] += if positive { entry } else { -entry };
            }
        }
    };
    let (first, second) = (edge_ends(p, e), edge_ends(q, f));
    for (a, a_high) in [(first.0, false), (first.1, true)] {
        for (b, b_high) in [(second.0, false), (second.1, true)] {
            add(a, b, a_high == b_high, false);
            if p != q {
                add(b, a, a_high == b_high, true);
            }
        }
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

    async fn curvature(
        &mut self,
        displacement: &[f64],
        gradient: &mut [f64],
        operator: &mut StencilOperator<D>,
    ) -> Evaluation {
        self.evaluate::<CURVATURE>(displacement, gradient, &mut Some(operator))
    }
}
