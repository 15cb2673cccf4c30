// A cell of multilinear elements: what its corners do along its edges, and back. Corner c lies at the upper end of axis k
// if bit k of c is set; e runs over the 2^(D−1) edges of an axis.

const EDGES = CORNERS / 2u;

// (u_high − u_low)/h along every edge: axis · EDGES + e.
alias Edges = array<Vec, D * EDGES>;
alias Corners = array<Vec, CORNERS>;

fn lower_end(axis: u32, edge: u32) -> u32 {
    return (edge & ((1u << axis) - 1u)) | ((edge >> axis) << (axis + 1u));
}

fn stride_of(axis: u32) -> u32 {
    return select(select(level.side * level.side, level.side, axis == 1u), 1u, axis == 0u);
}

fn corner_offset(corner: u32) -> u32 {
    var offset = 0u;
    for (var axis = 0u; axis < D; axis++) {
        offset += ((corner >> axis) & 1u) * stride_of(axis);
    }
    return offset;
}

fn lowest_node(cell: u32) -> u32 {
    var node = 0u;
    var rest = cell;
    for (var axis = 0u; axis < D; axis++) {
        node += (rest % level.cells) * stride_of(axis);
        rest /= level.cells;
    }
    return node;
}

// The share of a corner in a value at `place`.
fn shape(place: Vec, corner: u32) -> f32 {
    var share = 1.0;
    for (var axis = 0u; axis < D; axis++) {
        share *= select(1.0 - place[axis], place[axis], ((corner >> axis) & 1u) == 1u);
    }
    return share;
}

// Its derivative along an axis, and the share of an edge, which has the corner as an end, in the derivative along it.
fn shape_across(place: Vec, corner: u32, axis: u32) -> f32 {
    var share = 1.0;
    for (var other = 0u; other < D; other++) {
        if other != axis {
            share *= select(1.0 - place[other], place[other], ((corner >> other) & 1u) == 1u);
        }
    }
    return share;
}

fn shape_slope(place: Vec, corner: u32, axis: u32) -> f32 {
    let share = shape_across(place, corner, axis);
    return select(-share, share, ((corner >> axis) & 1u) == 1u);
}

fn shape_gradient(place: Vec, corner: u32) -> Vec {
    var slopes = Vec();
    for (var axis = 0u; axis < D; axis++) {
        slopes[axis] = shape_slope(place, corner, axis);
    }
    return slopes;
}

fn read_edges(base: u32) -> Edges {
    var edges = Edges();
    for (var axis = 0u; axis < D; axis++) {
        for (var edge = 0u; edge < EDGES; edge++) {
            let first = (base + corner_offset(lower_end(axis, edge))) * NODE_NUMBERS + D + axis * D;
            for (var k = 0u; k < D; k++) {
                edges[axis * EDGES + edge][k] = nodes[first + k];
            }
        }
    }
    return edges;
}

// ∂φ/∂x_axis along an edge.
fn whole_edge(edges: ptr<function, Edges>, axis: u32, edge: u32) -> Vec {
    var column = (*edges)[axis * EDGES + edge];
    column[axis] += 1.0;
    return column;
}

// Dφ at a place, by columns.
fn derivative(edges: ptr<function, Edges>, place: Vec) -> Mat {
    var columns = Mat();
    for (var axis = 0u; axis < D; axis++) {
        var column = Vec();
        column[axis] = 1.0;
        for (var edge = 0u; edge < EDGES; edge++) {
            column += shape_across(place, lower_end(axis, edge), axis) * (*edges)[axis * EDGES + edge];
        }
        columns[axis] = column;
    }
    return columns;
}

// The transpose of `derivative`: what forces on the columns are on the corners, in units of 1/h.
fn add_stress(stress: Mat, place: Vec, corners: ptr<function, Corners>) {
    for (var axis = 0u; axis < D; axis++) {
        for (var edge = 0u; edge < EDGES; edge++) {
            let low = lower_end(axis, edge);
            let force = shape_across(place, low, axis) * stress[axis];
            (*corners)[low] -= force;
            (*corners)[low | (1u << axis)] += force;
        }
    }
}
