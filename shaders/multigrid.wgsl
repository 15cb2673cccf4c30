// V-cycles for an operator of which a block is stored for each node and each neighbour that does not come before it.  Twin
// of src/multigrid.rs, whose sweeps go node by node; these go by 2^D colours: no two nodes of a colour are neighbours.

// All levels lie in each array one after the other, the finest first.
struct Mesh {
    // Nodes a side; those of all finer levels.
    side: u32,
    first: u32,
}

struct Place {
    fine_side: u32,
    fine_first: u32,
    coarse_side: u32,
    coarse_first: u32,
    // By bits, whether a node's index along an axis is odd.
    colour: u32,
    // Relative residual at which conjugate gradients end, squared.
    tolerance: f32,
}

// Numbers that stay on the card from one kernel to the next.
struct Scalars {
    // r·z, α and β of conjugate gradients; |r|² at first and now.
    square: f32,
    step: f32,
    turn: f32,
    first: f32,
    rest: f32,
    // Steps done; whether no more are needed.
    steps: u32,
    done: u32,
    // ∇E·d of the direction d that was found.
    slope: f32,
    // Of the operator's diagonal, before anything was added to it; what has been, in its units.
    mean: f32,
    shift: f32,
}

// As many blocks of a node lie in `near`, the others in `far`: one array of all would be larger than a shader may see.
// Entry by entry, each for all nodes of a level.
const NEAR = select(3u, 7u, D == 3u);

@group(0) @binding(13) var<uniform> place: Place;
@group(0) @binding(14) var<storage, read_write> near: array<f32>;
@group(0) @binding(15) var<storage, read_write> far: array<f32>;
// Inverse blocks of the diagonal, times the damping.
@group(0) @binding(16) var<storage, read_write> inverse: array<f32>;
@group(0) @binding(17) var<storage, read_write> right: array<f32>;
@group(0) @binding(18) var<storage, read_write> solution: array<f32>;
@group(0) @binding(19) var<storage, read_write> residual: array<f32>;
@group(0) @binding(20) var<storage, read_write> scalars: Scalars;

// Share of the correction that is applied.
const DAMPING = 0.9;

const BEYOND = 0xffffffffu;
const NEIGHBOURS = 2u * CENTRE + 1u;

fn fine_mesh() -> Mesh {
    return Mesh(place.fine_side, place.fine_first);
}

fn coarse_mesh() -> Mesh {
    return Mesh(place.coarse_side, place.coarse_first);
}

fn nodes_of(side: u32) -> u32 {
    return select(side * side, side * side * side, D == 3u);
}

fn index_of(node: u32, side: u32) -> vec3i {
    return vec3i(vec3u(node % side, node / side % side, node / (side * side)));
}

fn offset_of(neighbour: u32) -> vec3i {
    return vec3i(vec3u(neighbour % 3u, neighbour / 3u % 3u, select(1u, neighbour / 9u, D == 3u))) - 1;
}

// The node at an index; BEYOND the grid there is none.
fn node_at(index: vec3i, side: u32) -> u32 {
    let last = vec3i(i32(side) - 1, i32(side) - 1, select(0, i32(side) - 1, D == 3u));
    if any(index < vec3i(0)) || any(index > last) {
        return BEYOND;
    }
    let i = vec3u(index);
    return i.x + side * (i.y + side * i.z);
}

fn read_block(mesh: Mesh, node: u32, slot: u32) -> Mat {
    let stride = nodes_of(mesh.side);
    var block = Mat();
    if slot < NEAR {
        let start = (mesh.first * NEAR + slot * stride) * BLOCK + node;
        for (var k = 0u; k < BLOCK; k++) {
            block[k / D][k % D] = near[start + k * stride];
        }
    } else {
        let start = (mesh.first * (HALF - NEAR) + (slot - NEAR) * stride) * BLOCK + node;
        for (var k = 0u; k < BLOCK; k++) {
            block[k / D][k % D] = far[start + k * stride];
        }
    }
    return block;
}

fn write_block(mesh: Mesh, node: u32, slot: u32, block: Mat) {
    let stride = nodes_of(mesh.side);
    if slot < NEAR {
        let start = (mesh.first * NEAR + slot * stride) * BLOCK + node;
        for (var k = 0u; k < BLOCK; k++) {
            near[start + k * stride] = block[k / D][k % D];
        }
    } else {
        let start = (mesh.first * (HALF - NEAR) + (slot - NEAR) * stride) * BLOCK + node;
        for (var k = 0u; k < BLOCK; k++) {
            far[start + k * stride] = block[k / D][k % D];
        }
    }
}

// The block of a node, the row, and any neighbour on the grid.
fn coupling(mesh: Mesh, node: u32, neighbour: u32, other: u32) -> Mat {
    if neighbour >= CENTRE {
        return read_block(mesh, node, neighbour - CENTRE);
    }
    return transpose(read_block(mesh, other, CENTRE - neighbour));
}

// Σ A_ij x_j over a node's neighbours and itself.
fn product_at(mesh: Mesh, node: u32) -> Vec {
    let index = index_of(node, mesh.side);
    var sum = Vec();
    for (var neighbour = 0u; neighbour < NEIGHBOURS; neighbour++) {
        let other = node_at(index + offset_of(neighbour), mesh.side);
        if other != BEYOND {
            let first = (mesh.first + other) * D;
            var x = Vec();
            for (var k = 0u; k < D; k++) {
                x[k] = solution[first + k];
            }
            sum += x * coupling(mesh, node, neighbour, other);
        }
    }
    return sum;
}

// b_i − Σ A_ij x_j.
fn residual_at(mesh: Mesh, node: u32) -> Vec {
    var rest = -product_at(mesh, node);
    for (var k = 0u; k < D; k++) {
        rest[k] += right[(mesh.first + node) * D + k];
    }
    return rest;
}

fn write_residual(mesh: Mesh, node: u32) {
    let rest = residual_at(mesh, node);
    for (var k = 0u; k < D; k++) {
        residual[(mesh.first + node) * D + k] = rest[k];
    }
}

fn relax(mesh: Mesh, node: u32) {
    let rest = residual_at(mesh, node);
    let first = mesh.first + node;
    for (var i = 0u; i < D; i++) {
        for (var j = 0u; j < D; j++) {
            solution[first * D + i] += inverse[first * BLOCK + i * D + j] * rest[j];
        }
    }
}

// Pᵀ of the finer level's residual, and zero to begin with.
fn restrict_to(coarse: Mesh, fine: Mesh, node: u32) {
    let index = 2 * index_of(node, coarse.side);
    var sum = Vec();
    for (var neighbour = 0u; neighbour < NEIGHBOURS; neighbour++) {
        let offset = offset_of(neighbour);
        let other = node_at(index + offset, fine.side);
        if other != BEYOND {
            let share = share_of(offset);
            for (var k = 0u; k < D; k++) {
                sum[k] += share * residual[(fine.first + other) * D + k];
            }
        }
    }
    for (var k = 0u; k < D; k++) {
        right[(coarse.first + node) * D + k] = sum[k];
        solution[(coarse.first + node) * D + k] = 0.0;
    }
}

// The value of a coarse node's hat function at a fine node so far away.
fn share_of(offset: vec3i) -> f32 {
    return exp2(-f32(abs(offset.x) + abs(offset.y) + abs(offset.z)));
}

// Adds P of the coarser level's solution.
fn prolongate_to(fine: Mesh, coarse: Mesh, node: u32) {
    let index = index_of(node, fine.side);
    for (var corner = 0u; corner < CORNERS; corner++) {
        let bits = vec3i(vec3u(corner & 1u, (corner >> 1u) & 1u, corner >> 2u));
        // Between two coarse nodes both count, on one it alone.
        let odd = index & vec3i(1);
        if all(bits <= odd) {
            let first = (coarse.first + node_at((index + bits) / 2, coarse.side)) * D;
            let share = share_of(odd);
            for (var k = 0u; k < D; k++) {
                solution[(fine.first + node) * D + k] += share * solution[first + k];
            }
        }
    }
}

@compute @workgroup_size(GROUP)
fn sweep(@builtin(global_invocation_id) id: vec3u) {
    let half = (place.fine_side + 1u) / 2u;
    if id.x >= nodes_of(half) || scalars.done != 0u {
        return;
    }
    let odd = vec3i(vec3u(place.colour & 1u, (place.colour >> 1u) & 1u, place.colour >> 2u));
    let node = node_at(2 * index_of(id.x, half) + odd, place.fine_side);
    if node != BEYOND {
        relax(fine_mesh(), node);
    }
}

@compute @workgroup_size(GROUP)
fn leave_residual(@builtin(global_invocation_id) id: vec3u) {
    if id.x < nodes_of(place.fine_side) && scalars.done == 0u {
        write_residual(fine_mesh(), id.x);
    }
}

@compute @workgroup_size(GROUP)
fn restrict_residual(@builtin(global_invocation_id) id: vec3u) {
    if id.x < nodes_of(place.coarse_side) && scalars.done == 0u {
        restrict_to(coarse_mesh(), fine_mesh(), id.x);
    }
}

@compute @workgroup_size(GROUP)
fn prolongate(@builtin(global_invocation_id) id: vec3u) {
    if id.x < nodes_of(place.fine_side) && scalars.done == 0u {
        prolongate_to(fine_mesh(), coarse_mesh(), id.x);
    }
}

// Levels in one dispatch, by one workgroup.
const CREW = 256u;
// Sweeps there and back on the coarsest level, of 3^D nodes.
const COARSEST_SWEEPS = 8u;

fn level_below(fine: Mesh, depth: u32) -> Mesh {
    var mesh = fine;
    for (var k = 0u; k < depth; k++) {
        mesh = Mesh((mesh.side + 1u) / 2u, mesh.first + nodes_of(mesh.side));
    }
    return mesh;
}

fn sweep_colour(mesh: Mesh, colour: u32, lane: u32) {
    let odd = vec3i(vec3u(colour & 1u, (colour >> 1u) & 1u, colour >> 2u));
    for (var node = lane; node < nodes_of(mesh.side); node += CREW) {
        if all((index_of(node, mesh.side) & vec3i(1)) == odd) {
            relax(mesh, node);
        }
    }
    storageBarrier();
}

// A V-cycle from this level on, whose right side and start are given.
@compute @workgroup_size(CREW)
fn small_cycle(@builtin(local_invocation_index) lane: u32) {
    var depth = 0u;
    for (var side = place.fine_side; side > 3u; side = (side + 1u) / 2u) {
        let fine = level_below(fine_mesh(), depth);
        let coarse = level_below(fine_mesh(), depth + 1u);
        for (var colour = 0u; colour < CORNERS; colour++) {
            sweep_colour(fine, colour, lane);
        }
        for (var node = lane; node < nodes_of(fine.side); node += CREW) {
            write_residual(fine, node);
        }
        storageBarrier();
        for (var node = lane; node < nodes_of(coarse.side); node += CREW) {
            restrict_to(coarse, fine, node);
        }
        storageBarrier();
        depth += 1u;
    }
    for (var turn = 0u; turn < COARSEST_SWEEPS; turn++) {
        for (var k = 0u; k < 2u * CORNERS; k++) {
            sweep_colour(level_below(fine_mesh(), depth), min(k, 2u * CORNERS - 1u - k), lane);
        }
    }
    for (; depth > 0u; depth--) {
        let fine = level_below(fine_mesh(), depth - 1u);
        for (var node = lane; node < nodes_of(fine.side); node += CREW) {
            prolongate_to(fine, level_below(fine_mesh(), depth), node);
        }
        storageBarrier();
        for (var colour = CORNERS; colour > 0u; colour--) {
            sweep_colour(fine, colour - 1u, lane);
        }
    }
}

// The coarse operator Pᵀ A P: by node and block, the sum over the fine nodes around both of their blocks, each by its share
// in both.
@compute @workgroup_size(GROUP)
fn coarsen(@builtin(global_invocation_id) id: vec3u) {
    let stride = nodes_of(place.coarse_side);
    let slot = id.x / stride;
    let node = id.x % stride;
    if slot >= HALF {
        return;
    }
    let index = index_of(node, place.coarse_side);
    let towards = offset_of(CENTRE + slot);
    var sum = Mat();
    if node_at(index + towards, place.coarse_side) != BEYOND {
        for (var e = 0u; e < NEIGHBOURS; e++) {
            let row = node_at(2 * index + offset_of(e), place.fine_side);
            if row == BEYOND {
                continue;
            }
            for (var neighbour = 0u; neighbour < NEIGHBOURS; neighbour++) {
                let to = 2 * index + offset_of(e) + offset_of(neighbour);
                let away = to - 2 * (index + towards);
                let column = node_at(to, place.fine_side);
                if column != BEYOND && all(abs(away) <= vec3i(1)) {
                    let share = share_of(offset_of(e)) * share_of(away);
                    sum += share * coupling(fine_mesh(), row, neighbour, column);
                }
            }
        }
    }
    write_block(coarse_mesh(), node, slot, sum);
}

@compute @workgroup_size(GROUP)
fn invert_diagonal(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= nodes_of(place.fine_side) {
        return;
    }
    var block = read_block(fine_mesh(), id.x, 0u);
    // Keeps the inverse of a block bounded that the clipping of negative curvature left singular.
    let least = 1e-6 * trace(block) + 1e-30;
    for (var k = 0u; k < D; k++) {
        block[k][k] += least;
    }
    // The cofactor's rows are the inverse's columns.
    let cof = cofactor(block);
    let share = DAMPING / dot(block[0], cof[0]);
    for (var i = 0u; i < D; i++) {
        for (var j = 0u; j < D; j++) {
            inverse[(place.fine_first + id.x) * BLOCK + i * D + j] = share * cof[j][i];
        }
    }
}
