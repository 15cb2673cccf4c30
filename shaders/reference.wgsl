// The reference at the quadrature points of the band's cells.  Twin of `ReferenceSample` in src/assemble/band.rs.

// Numbers a point: η times the quadrature weight; distance, off-tangential, trace, steepness; the tangents; the upper
// triangle of the curvature in their frame.
const SAMPLE_NUMBERS = 5u + (D - 1u) * D + (D - 1u) * D / 2u;

// Fills in what the reference knows; returns tangents and, last, the normal.
fn read_reference(first: u32, point: ptr<function, Point>) -> Mat {
    (*point).reference_distance = samples[first + 1u];
    (*point).off_tangential = samples[first + 2u];
    (*point).reference_trace = samples[first + 3u];
    (*point).steepness = samples[first + 4u];
    var next = first + 5u;
    var frame = Mat();
    for (var i = 0u; i < NORMAL; i++) {
        for (var k = 0u; k < D; k++) {
            frame[i][k] = samples[next];
            next += 1u;
        }
    }
    for (var i = 0u; i < NORMAL; i++) {
        for (var j = i; j < NORMAL; j++) {
            (*point).reference_curvature[i][j] = samples[next];
            (*point).reference_curvature[j][i] = samples[next];
            next += 1u;
        }
    }
    frame[NORMAL] = normal_to(frame);
    return frame;
}
