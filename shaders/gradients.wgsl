// Conjugate gradients, preconditioned by V-cycles. Between kernels numbers wait in `scalars`; once the residual is small
// enough what is left of the steps does nothing.  Twin of `Multigrid::solve` in src/multigrid.rs.
//
// The residual is the right side of the finest level, a V-cycle makes `solution` of it, and between cycles `residual` holds
// A·search.

@group(0) @binding(21) var<storage, read_write> search: array<f32>;
@group(0) @binding(22) var<storage, read_write> direction: array<f32>;
@group(0) @binding(23) var<storage, read_write> partials: array<f32>;

fn numbers() -> u32 {
    return nodes_of(place.fine_side) * D;
}

// Each workgroup's part of a sum.
fn leave_partial(value: f32, lane: u32, group: u32) {
    let sums = sum_of_group(lane, vec4f(value, 0.0, 0.0, 0.0), vec2f());
    if lane == 0u {
        partials[group] = sums.energies.x;
    }
}

// The sum of all, known to the first invocation of the only workgroup.
fn sum_of_partials(lane: u32, count: u32) -> f32 {
    var sum = 0.0;
    for (var k = lane; k < (count + GROUP - 1u) / GROUP; k += GROUP) {
        sum += partials[k];
    }
    return sum_of_group(lane, vec4f(sum, 0.0, 0.0, 0.0), vec2f()).energies.x;
}

// From the gradient that is to be solved for.
@compute @workgroup_size(GROUP)
fn begin(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    var square = 0.0;
    if id.x < numbers() {
        let value = gradient[id.x];
        right[id.x] = value;
        direction[id.x] = 0.0;
        solution[id.x] = 0.0;
        square = value * value;
    }
    leave_partial(square, lane, group.x);
}

@compute @workgroup_size(GROUP)
fn begun(@builtin(local_invocation_index) lane: u32) {
    let square = sum_of_partials(lane, numbers());
    if lane == 0u {
        scalars.first = square;
        scalars.rest = square;
        scalars.steps = 0u;
        scalars.done = select(0u, 1u, square == 0.0);
        scalars.square = 0.0;
        scalars.slope = 0.0;
    }
}

// r·z.
@compute @workgroup_size(GROUP)
fn overlap(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    var product = 0.0;
    if id.x < numbers() {
        product = right[id.x] * solution[id.x];
    }
    leave_partial(product, lane, group.x);
}

@compute @workgroup_size(GROUP)
fn choose_turn(@builtin(local_invocation_index) lane: u32) {
    let square = sum_of_partials(lane, numbers());
    if lane == 0u && scalars.done == 0u {
        scalars.turn = 0.0;
        if scalars.steps > 0u {
            scalars.turn = square / scalars.square;
        }
        scalars.square = square;
    }
}

// The next search direction; leaves a zero for the next cycle to begin with.
@compute @workgroup_size(GROUP)
fn turn(@builtin(global_invocation_id) id: vec3u) {
    if id.x < numbers() && scalars.done == 0u {
        var kept = 0.0;
        if scalars.steps > 0u {
            kept = scalars.turn * search[id.x];
        }
        search[id.x] = solution[id.x] + kept;
        solution[id.x] = 0.0;
    }
}

// A·search, which is bound as the solution; its product with the search direction.
@compute @workgroup_size(GROUP)
fn apply(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    var curvature = 0.0;
    if id.x < nodes_of(place.fine_side) && scalars.done == 0u {
        let image = product_at(fine_mesh(), id.x);
        for (var k = 0u; k < D; k++) {
            residual[id.x * D + k] = image[k];
            curvature += image[k] * solution[id.x * D + k];
        }
    }
    leave_partial(curvature, lane, group.x);
}

@compute @workgroup_size(GROUP)
fn choose_step(@builtin(local_invocation_index) lane: u32) {
    let curvature = sum_of_partials(lane, nodes_of(place.fine_side));
    if lane == 0u && scalars.done == 0u {
        // No curvature left along the search direction: f32 is at its end, or the operator is singular there.
        if curvature > 0.0 && abs(scalars.square) < LARGEST {
            scalars.step = scalars.square / curvature;
        } else {
            scalars.done = 1u;
        }
    }
}

@compute @workgroup_size(GROUP)
fn advance(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    var square = 0.0;
    if id.x < numbers() && scalars.done == 0u {
        direction[id.x] += scalars.step * search[id.x];
        let rest = right[id.x] - scalars.step * residual[id.x];
        right[id.x] = rest;
        square = rest * rest;
    }
    leave_partial(square, lane, group.x);
}

@compute @workgroup_size(GROUP)
fn judge(@builtin(local_invocation_index) lane: u32) {
    let square = sum_of_partials(lane, numbers());
    if lane == 0u && scalars.done == 0u {
        scalars.rest = square;
        scalars.steps += 1u;
        if square <= place.tolerance * scalars.first {
            scalars.done = 1u;
        }
    }
}

// ∇E·d.
@compute @workgroup_size(GROUP)
fn fall(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    var product = 0.0;
    if id.x < numbers() {
        product = gradient[id.x] * direction[id.x];
    }
    leave_partial(product, lane, group.x);
}

@compute @workgroup_size(GROUP)
fn fallen(@builtin(local_invocation_index) lane: u32) {
    let slope = sum_of_partials(lane, numbers());
    if lane == 0u {
        scalars.slope = slope;
    }
}
