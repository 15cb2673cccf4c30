// What the kernels are given: the functional of a level, the part of the cells that a dispatch is for, and the arrays.

const INTRINSIC = 0u;
const PROJECTED = 1u;
const SHAPE_OPERATOR = 0u;
const MEAN_CURVATURE = 1u;

struct Level {
    // Cells and nodes a side.
    cells: u32,
    side: u32,
    // Weights: α_mem δ, α_bend δ³ or α_bend, 1/ε, ρ².
    membrane: f32,
    bending: f32,
    penalty: f32,
    tangency: f32,
    membrane_model: u32,
    bending_model: u32,
    lambda: f32,
    mu: f32,
    // θ.
    vertex_share: f32,
    // Of the energies, of quadrature.wgsl.
    rule: u32,
}

// Whole layers of cells across the last axis, and the band's cells among them.
struct Slab {
    first_cell: u32,
    cell_count: u32,
    first_layer: u32,
    layers: u32,
    band_count: u32,
    // Rows of sums: the first of this slab's volume and shell.
    volume_row: u32,
    shell_row: u32,
}

// Sums over some cells: membrane, bending, mismatch and volume; the least determinant, and the least in units of what
// its factors could make, by which rounding is measured; in one row of the results, what the pins cost.
struct Sums {
    energies: vec4f,
    least: vec2f,
    pins: f32,
}

// Numbers a node: u in cells, then its differences to the next node along each axis.
const NODE_NUMBERS = D + D * D;

@group(0) @binding(0) var<uniform> level: Level;
@group(0) @binding(1) var<uniform> slab: Slab;
@group(0) @binding(2) var<storage, read> nodes: array<f32>;
// Weight of the volume density by cells.
@group(0) @binding(3) var<storage, read> volume_weights: array<f32>;
@group(0) @binding(4) var<storage, read> template_jets: array<f32>;
// The band's cells in this slab, and the reference at their points.
@group(0) @binding(5) var<storage, read> band: array<u32>;
@group(0) @binding(6) var<storage, read> samples: array<f32>;
// Forces on the corners of the slab's cells.
@group(0) @binding(7) var<storage, read_write> forces: array<f32>;
@group(0) @binding(8) var<storage, read_write> rows: array<Sums>;
@group(0) @binding(9) var<storage, read_write> gradient: array<f32>;
@group(0) @binding(10) var<storage, read_write> results: array<Sums>;
// Blocks of the hessian: of pairs of corners of the slab's cells, and of the slab's nodes with the neighbours that do not
// come before them.
@group(0) @binding(11) var<storage, read_write> pairs: array<f32>;
@group(0) @binding(12) var<storage, read_write> blocks: array<f32>;
