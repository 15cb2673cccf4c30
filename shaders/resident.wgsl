// A displacement that stays on the card, and the hessian that does.

// In cells, a whole number and what is left of it: differences of whole numbers are exact, whatever the compiler makes of
// the sum.
struct Coordinate {
    whole: i32,
    rest: f32,
}

struct Trial {
    // How far against the direction.
    step: f32,
}

@group(0) @binding(24) var<storage, read_write> coordinates: array<Coordinate>;
@group(0) @binding(25) var<uniform> trial: Trial;
// What the other kernels read as `nodes`.
@group(0) @binding(26) var<storage, read_write> placed: array<f32>;

// Of a component, in cells.
fn advance_of(number: u32) -> f32 {
    return trial.step * f32(level.cells) * direction[number];
}

// u − step·d, and its differences to the next node along each axis.
@compute @workgroup_size(GROUP)
fn place_nodes(@builtin(global_invocation_id) id: vec3u) {
    let node = id.x;
    if node >= nodes_of(level.side) {
        return;
    }
    let first = node * NODE_NUMBERS;
    let index = index_of(node, level.side);
    for (var k = 0u; k < D; k++) {
        let own = node * D + k;
        placed[first + k] = f32(coordinates[own].whole) + (coordinates[own].rest - advance_of(own));
        for (var axis = 0u; axis < D; axis++) {
            if u32(index[axis]) < level.cells {
                let next = own + stride_of(axis) * D;
                let change = coordinates[next].rest - coordinates[own].rest;
                placed[first + D + axis * D + k] = f32(coordinates[next].whole - coordinates[own].whole)
                    + (change - (advance_of(next) - advance_of(own)));
            }
        }
    }
}

// u becomes u − step·d.
@compute @workgroup_size(GROUP)
fn move_nodes(@builtin(global_invocation_id) id: vec3u) {
    if id.x < nodes_of(level.side) * D {
        let rest = coordinates[id.x].rest - advance_of(id.x);
        let whole = round(rest);
        coordinates[id.x] = Coordinate(coordinates[id.x].whole + i32(whole), rest - whole);
    }
}

// Adds the slab's blocks to the operator that the multigrid has.
@compute @workgroup_size(GROUP)
fn gather_stencil(@builtin(global_invocation_id) id: vec3u) {
    let layer_nodes = stride_of(D - 1u);
    let count = (slab.layers + 1u) * layer_nodes;
    let slot = id.x / count;
    if slot < HALF {
        let node = slab.first_layer * layer_nodes + id.x % count;
        write_block(fine_mesh(), node, slot, read_block(fine_mesh(), node, slot) + gathered(node, slot));
    }
}

// The trace of the operator's diagonal.
@compute @workgroup_size(GROUP)
fn weigh(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    var sum = 0.0;
    if id.x < nodes_of(place.fine_side) {
        sum = trace(read_block(fine_mesh(), id.x, 0u));
    }
    leave_partial(sum, lane, group.x);
}

@compute @workgroup_size(GROUP)
fn weighed(@builtin(local_invocation_index) lane: u32) {
    let sum = sum_of_partials(lane, nodes_of(place.fine_side));
    if lane == 0u {
        scalars.mean = sum / f32(numbers());
    }
}

@compute @workgroup_size(GROUP)
fn stiffen(@builtin(global_invocation_id) id: vec3u) {
    if id.x < nodes_of(place.fine_side) {
        var block = read_block(fine_mesh(), id.x, 0u);
        for (var k = 0u; k < D; k++) {
            block[k][k] += scalars.shift * scalars.mean;
        }
        write_block(fine_mesh(), id.x, 0u, block);
    }
}
