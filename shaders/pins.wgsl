// Points that are tied together, where the displacement stays on the card.  E = w Σ_p |φ(p) − q|².  Twin of
// src/energy/pin.rs and src/assemble/cpu/pins.rs.

struct Pin {
    // Lowest node of its cell, and the corners' shares in φ(p).
    base: u32,
    shares: array<f32, CORNERS>,
    // In cells, p − q.
    offset: array<f32, D>,
}

// A corner of a pin's cell; those of a node one after the other.
struct Tie {
    node: u32,
    pin: u32,
    // Of |φ(p) − q|² in cells; the shares of a pin's ties are 1 together.
    energy: f32,
    // Of φ(p) − q in cells.
    force: f32,
}

// A block of the hessian: a number times 1.
struct Knot {
    node: u32,
    slot: u32,
    stiffness: f32,
    unused: u32,
}

@group(0) @binding(27) var<storage, read> pins: array<Pin>;
@group(0) @binding(28) var<storage, read> ties: array<Tie>;
@group(0) @binding(29) var<storage, read> knots: array<Knot>;

// φ(p) − q in cells.
fn left_of_pin(number: u32) -> Vec {
    var left = Vec();
    for (var k = 0u; k < D; k++) {
        left[k] = pins[number].offset[k];
    }
    for (var corner = 0u; corner < CORNERS; corner++) {
        let first = (pins[number].base + corner_offset(corner)) * NODE_NUMBERS;
        for (var k = 0u; k < D; k++) {
            left[k] += pins[number].shares[corner] * nodes[first + k];
        }
    }
    return left;
}

// Energy and forces of all pins, by the only workgroup: there are few.
@compute @workgroup_size(GROUP)
fn pull_pins(@builtin(local_invocation_index) lane: u32) {
    let count = arrayLength(&ties);
    var energy = 0.0;
    for (var number = lane; number < count; number += GROUP) {
        let left = left_of_pin(ties[number].pin);
        energy += ties[number].energy * dot(left, left);
    }
    if ORDER >= GRADIENT {
        for (var number = lane; number < count; number += GROUP) {
            // Whoever has a node's first tie has all of that node.
            let node = ties[number].node;
            var next = number;
            while next < count && ties[next].node == node && (number == 0u || ties[number - 1u].node != node) {
                let force = ties[next].force * left_of_pin(ties[next].pin);
                for (var k = 0u; k < D; k++) {
                    gradient[node * D + k] += force[k];
                }
                next++;
            }
        }
    }
    let sums = sum_of_group(lane, vec4f(energy, 0.0, 0.0, 0.0), vec2f());
    if lane == 0u {
        results[0].pins = sums.energies.x;
    }
}

@compute @workgroup_size(GROUP)
fn stiffen_pins(@builtin(global_invocation_id) id: vec3u) {
    if id.x < arrayLength(&knots) {
        let knot = knots[id.x];
        var block = read_block(fine_mesh(), knot.node, knot.slot);
        for (var k = 0u; k < D; k++) {
            block[k][k] += knot.stiffness;
        }
        write_block(fine_mesh(), knot.node, knot.slot, block);
    }
}
