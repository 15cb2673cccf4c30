// The template's jet at a moved point.  Twin of `TemplateField` in src/assemble/band.rs.

// Numbers a node: the distance, the fitted gradient, the upper triangle of the fitted second derivative.
const TEMPLATE_NUMBERS = 1u + D + D * (D + 1u) / 2u;

// φ at a place of a cell is that place moved by `moved`, both in cells: what is large is an integer and is not rounded.
// Beyond the box the distance goes on as the boundary cell's polynomial, while the fitted derivatives keep their values
// at the nearest point of the box.
fn sample_template(cell: u32, moved: Vec, point: ptr<function, Point>) {
    var local = Vec();
    var inside = Vec();
    var base = 0u;
    var rest = cell;
    for (var axis = 0u; axis < D; axis++) {
        let start = i32(rest % level.cells);
        rest /= level.cells;
        let cells = f32(level.cells);
        let index = clamp(start + i32(floor(clamp(moved[axis], -cells, cells))), 0, i32(level.cells) - 1);
        local[axis] = moved[axis] - f32(index - start);
        inside[axis] = select(0.0, 1.0, local[axis] >= 0.0 && local[axis] <= 1.0);
        base += u32(index) * stride_of(axis);
    }
    let held = clamp(local, Vec(0.0), Vec(1.0));
    (*point).distance = 0.0;
    (*point).gradient = Vec(0.0);
    (*point).normal = Vec(0.0);
    (*point).normal_slope = Mat();
    (*point).curvature = Mat();
    (*point).curvature_slope = array<Mat, D>();
    for (var corner = 0u; corner < CORNERS; corner++) {
        let first = (base + corner_offset(corner)) * TEMPLATE_NUMBERS;
        let distance = template_jets[first];
        (*point).distance += shape(local, corner) * distance;
        var normal = Vec();
        var curvature = Mat();
        var next = first + 1u + D;
        for (var a = 0u; a < D; a++) {
            normal[a] = template_jets[first + 1u + a];
            for (var b = a; b < D; b++) {
                curvature[a][b] = template_jets[next];
                curvature[b][a] = template_jets[next];
                next += 1u;
            }
        }
        let share = shape(held, corner);
        (*point).normal += share * normal;
        (*point).curvature += share * curvature;
        if ORDER >= GRADIENT {
            for (var axis = 0u; axis < D; axis++) {
                let cells = f32(level.cells);
                (*point).gradient[axis] += cells * shape_slope(local, corner, axis) * distance;
                let slope = cells * inside[axis] * shape_slope(held, corner, axis);
                (*point).normal_slope[axis] += slope * normal;
                (*point).curvature_slope[axis] += slope * curvature;
            }
        }
    }
}
