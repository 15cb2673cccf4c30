// The projected Gauss–Newton hessian: blocks of pairs of corners of each cell, which each node then gathers with its
// neighbours.  Twin of src/assemble/cpu/{shell,planar,spatial,corners}.rs.

// Pairs of corners a ≤ b of a cell; D² numbers each.
const PAIRS = CORNERS * (CORNERS + 1u) / 2u;
const BLOCK = D * D;

// The neighbours that do not come before a node, itself the first: from the middle of all 3^D on.
const CENTRE = select(4u, 13u, D == 3u);
const HALF = CENTRE + 1u;

// Determinants below this are taken as this: k″ must stay within f32.
const LEAST_DETERMINANT = 1e-4;

// Corners with a lesser determinant are stiffened.
const STIFFENED = 0.7;

fn pair_place(number: u32, a: u32, b: u32) -> u32 {
    return (number * PAIRS + b * (b + 1u) / 2u + a) * BLOCK;
}

fn write_pair(number: u32, a: u32, b: u32, block: Mat) {
    let first = pair_place(number, a, b);
    for (var i = 0u; i < D; i++) {
        for (var j = 0u; j < D; j++) {
            pairs[first + i * D + j] = block[i][j];
        }
    }
}

fn add_pair(number: u32, a: u32, b: u32, block: Mat) {
    let first = pair_place(number, a, b);
    for (var i = 0u; i < D; i++) {
        for (var j = 0u; j < D; j++) {
            pairs[first + i * D + j] += block[i][j];
        }
    }
}

// Adds w k″(J) ∇J ⊗ ∇J for each corner that is about to fold.
fn stiffen_corners(number: u32, weight: f32, edges: ptr<function, Edges>) {
    for (var corner = 0u; corner < CORNERS; corner++) {
        let place = Vec(corner_bits(corner));
        let f = derivative(edges, place);
        let cof = cofactor(f);
        let det = dot(f[0], cof[0]);
        if det < STIFFENED {
            let inverse = 1.0 / max(det, LEAST_DETERMINANT);
            let square = inverse * inverse;
            let second = (level.lambda - 2.0 * level.mu) / 4.0
                + 0.75 * (level.lambda + 2.0 * level.mu) * square * square;
            let share = weight * level.vertex_share / f32(CORNERS) * second;
            for (var b = 0u; b < CORNERS; b++) {
                let slope = share * (cof * shape_gradient(place, b));
                for (var a = 0u; a <= b; a++) {
                    add_pair(number, a, b, outer(cof * shape_gradient(place, a), slope));
                }
            }
        }
    }
}

@compute @workgroup_size(GROUP)
fn volume_pairs(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= slab.cell_count {
        return;
    }
    let cell = slab.first_cell + id.x;
    var edges = read_edges(lowest_node(cell));
    let weight = volume_weights[cell] * f32(level.cells) * f32(level.cells);
    write_volume_pairs(id.x, weight, &edges);
    stiffen_corners(id.x, weight, &edges);
}

// pairs[a][b] += Σ_pq s_ap s_bq H_pq with the slots' shape values s_ai = ∇N_a·t_i, s_an = ∇N_a·n and s_ay = N_a.
@compute @workgroup_size(GROUP)
fn shell_pairs(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= slab.band_count {
        return;
    }
    let cell = band[id.x];
    let node = lowest_node(cell);
    var edges = read_edges(node);
    for (var at = 0u; at < points_of(level.rule); at++) {
        var point = Point();
        var frame = shell_point(id.x, cell, node, &edges, at, &point);
        var response = Response();
        shell(samples[(id.x * points_of(level.rule) + at) * SAMPLE_NUMBERS], &point, &response);
        var values = array<array<f32, SLOTS>, CORNERS>();
        let place = place_of(level.rule, at);
        for (var corner = 0u; corner < CORNERS; corner++) {
            for (var i = 0u; i < D; i++) {
                values[corner][i] = f32(level.cells) * dot(shape_gradient(place, corner), frame[i]);
            }
            values[corner][POSITION] = shape(place, corner);
        }
        for (var b = 0u; b < CORNERS; b++) {
            // moved[p] = Σ_q s_bq H_pq
            var moved = array<Mat, SLOTS>();
            for (var p = 0u; p < SLOTS; p++) {
                moved[p] += values[b][p] * response.hessian[p * SLOTS + p];
                for (var q = p + 1u; q < SLOTS; q++) {
                    let entry = response.hessian[p * SLOTS + q];
                    moved[p] += values[b][q] * entry;
                    moved[q] += values[b][p] * transpose(entry);
                }
            }
            for (var a = 0u; a <= b; a++) {
                var block = Mat();
                for (var p = 0u; p < SLOTS; p++) {
                    block += values[a][p] * moved[p];
                }
                add_pair(cell - slab.first_cell, a, b, block);
            }
        }
    }
}

// The block of a node and a neighbour that does not come before it: the sum over the slab's cells that have both as corners.
fn gathered(node: u32, slot: u32) -> Mat {
    var sum = Mat();
    for (var corner = 0u; corner < CORNERS; corner++) {
        var other = 0u;
        var rest = CENTRE + slot;
        var within = true;
        for (var axis = 0u; axis < D; axis++) {
            // One more than the corner's bit, or −1, if the neighbour is beyond the cell.
            let bit = ((corner >> axis) & 1u) + rest % 3u;
            within = within && bit >= 1u && bit <= 2u;
            other |= (bit - 1u) << axis;
            rest /= 3u;
        }
        let cell = cell_at(node, corner);
        if within && cell != SLAB_HAS_NONE {
            let first = pair_place(cell, corner, other);
            for (var i = 0u; i < D; i++) {
                for (var j = 0u; j < D; j++) {
                    sum[i][j] += pairs[first + i * D + j];
                }
            }
        }
    }
    return sum;
}

// All blocks of a node side by side, for whoever reads them back.
@compute @workgroup_size(GROUP)
fn gather_blocks(@builtin(global_invocation_id) id: vec3u) {
    let layer_nodes = stride_of(D - 1u);
    let number = id.x / HALF;
    if number >= (slab.layers + 1u) * layer_nodes {
        return;
    }
    let sum = gathered(slab.first_layer * layer_nodes + number, id.x % HALF);
    for (var i = 0u; i < D; i++) {
        for (var j = 0u; j < D; j++) {
            blocks[id.x * BLOCK + i * D + j] = sum[i][j];
        }
    }
}
