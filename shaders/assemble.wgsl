// From densities to numbers over the grid: energies, and forces on the corners of each cell, which each node then gathers
// from its 2^D cells.  Twin of src/assemble/cpu/{volume,shell}.rs.

// Of a cell of the slab, in units of h: forces[((cell · CORNERS) + corner) · D + k].
fn write_forces(number: u32, corners: ptr<function, Corners>) {
    for (var corner = 0u; corner < CORNERS; corner++) {
        for (var k = 0u; k < D; k++) {
            forces[(number * CORNERS + corner) * D + k] = (*corners)[corner][k];
        }
    }
}

// The volume energy over the points of a rule; adds forces.
fn volume_of_cell(weight: f32, rule: u32, edges: ptr<function, Edges>, corners: ptr<function, Corners>) -> f32 {
    var energy = 0.0;
    for (var point = 0u; point < points_of(rule); point++) {
        let place = place_of(rule, point);
        let share = weight * weight_of(rule, point);
        var stress = Mat();
        energy += share * volume(share, derivative(edges, place), &stress);
        if ORDER >= GRADIENT {
            add_stress(stress, place, corners);
        }
    }
    return energy;
}

// What the determinants of a cell could at most be: the product of its longest edges along the axes.
fn determinant_scale(edges: ptr<function, Edges>) -> f32 {
    var scale = 1.0;
    for (var axis = 0u; axis < D; axis++) {
        var longest = 0.0;
        for (var edge = 0u; edge < EDGES; edge++) {
            let column = whole_edge(edges, axis, edge);
            longest = max(longest, dot(column, column));
        }
        scale *= sqrt(longest);
    }
    return scale;
}

@compute @workgroup_size(GROUP)
fn volume_cells(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    var energy = 0.0;
    var least = vec2f(LARGEST);
    if id.x < slab.cell_count {
        let cell = slab.first_cell + id.x;
        var edges = read_edges(lowest_node(cell));
        let bound = least_determinant(&edges);
        least = vec2f(bound, bound / max(determinant_scale(&edges), 1e-30));
        let weight = volume_weights[cell];
        var corners = Corners();
        energy = volume_of_cell(weight * (1.0 - level.vertex_share), level.rule, &edges, &corners);
        if level.vertex_share > 0.0 {
            energy += volume_of_cell(weight * level.vertex_share, VERTICES, &edges, &corners);
        }
        if ORDER >= GRADIENT {
            write_forces(id.x, &corners);
        }
    }
    let sums = sum_of_group(lane, vec4f(0.0, 0.0, 0.0, energy), least);
    if lane == 0u {
        rows[slab.volume_row + group.x] = sums;
    }
}

// The quadrature point of a cell of the band; returns the reference's frame.
fn shell_point(number: u32, cell: u32, node: u32, edges: ptr<function, Edges>, at: u32, point: ptr<function, Point>) -> Mat {
    let place = place_of(level.rule, at);
    let columns = derivative(edges, place);
    let frame = read_reference((number * points_of(level.rule) + at) * SAMPLE_NUMBERS, point);
    for (var i = 0u; i < D; i++) {
        (*point).slots[i] = columns * frame[i];
    }
    var moved = place;
    for (var corner = 0u; corner < CORNERS; corner++) {
        let first = (node + corner_offset(corner)) * NODE_NUMBERS;
        for (var k = 0u; k < D; k++) {
            moved[k] += shape(place, corner) * nodes[first + k];
        }
    }
    // No term looks at φ itself, only at what the template has there.
    sample_template(cell, moved, point);
    return frame;
}

@compute @workgroup_size(GROUP)
fn shell_cells(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    var densities = vec3f();
    if id.x < slab.band_count {
        let cell = band[id.x];
        let node = lowest_node(cell);
        var edges = read_edges(node);
        var corners = Corners();
        for (var at = 0u; at < points_of(level.rule); at++) {
            var point = Point();
            let frame = shell_point(id.x, cell, node, &edges, at, &point);
            var response = Response();
            let weight = samples[(id.x * points_of(level.rule) + at) * SAMPLE_NUMBERS];
            densities += shell(weight, &point, &response);
            if ORDER >= GRADIENT {
                let place = place_of(level.rule, at);
                var stress = Mat();
                for (var i = 0u; i < D; i++) {
                    stress += outer(frame[i], response.gradient[i]);
                }
                add_stress(stress, place, &corners);
                for (var corner = 0u; corner < CORNERS; corner++) {
                    corners[corner] += shape(place, corner) / f32(level.cells) * response.gradient[POSITION];
                }
            }
        }
        if ORDER >= GRADIENT {
            let first = (cell - slab.first_cell) * CORNERS;
            for (var corner = 0u; corner < CORNERS; corner++) {
                for (var k = 0u; k < D; k++) {
                    corners[corner][k] += forces[(first + corner) * D + k];
                }
            }
            write_forces(cell - slab.first_cell, &corners);
        }
    }
    let sums = sum_of_group(lane, vec4f(densities, 0.0), vec2f(LARGEST));
    if lane == 0u {
        rows[slab.shell_row + group.x] = sums;
    }
}

const SLAB_HAS_NONE = 0xffffffffu;

// The number in the slab of the cell of which a node is this corner; SLAB_HAS_NONE where the slab has none.
fn cell_at(node: u32, corner: u32) -> u32 {
    var cell = 0u;
    var rest = node;
    var stride = 1u;
    for (var axis = 0u; axis < D; axis++) {
        // Wraps around below zero.
        let index = rest % level.side - ((corner >> axis) & 1u);
        if index >= level.cells {
            return SLAB_HAS_NONE;
        }
        rest /= level.side;
        cell += index * stride;
        stride *= level.cells;
    }
    let number = cell - slab.first_cell;
    return select(SLAB_HAS_NONE, number, number < slab.cell_count);
}

// Adds to a node's gradient the forces of its cells in the slab.
@compute @workgroup_size(GROUP)
fn gather_gradient(@builtin(global_invocation_id) id: vec3u) {
    let layer_nodes = stride_of(D - 1u);
    if id.x >= (slab.layers + 1u) * layer_nodes {
        return;
    }
    let node = slab.first_layer * layer_nodes + id.x;
    var sum = Vec();
    for (var corner = 0u; corner < CORNERS; corner++) {
        let number = cell_at(node, corner);
        if number != SLAB_HAS_NONE {
            for (var k = 0u; k < D; k++) {
                sum[k] += forces[(number * CORNERS + corner) * D + k];
            }
        }
    }
    for (var k = 0u; k < D; k++) {
        gradient[node * D + k] += f32(level.cells) * sum[k];
    }
}
