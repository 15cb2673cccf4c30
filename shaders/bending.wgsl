// W = Σ_ij r_ij² + const,  r_ij = v_iᵀ D²d₂(y) v_j − t_iᵀ D²d₁ t_j.  Twin of src/energy/bending.rs.
fn bending(weight: f32, point: ptr<function, Point>, response: ptr<function, Response>) -> f32 {
    var value = (*point).off_tangential;
    for (var i = 0u; i < NORMAL; i++) {
        for (var j = i; j < NORMAL; j++) {
            let v = (*point).slots[i];
            let w = (*point).slots[j];
            let bent = (*point).curvature * w;
            let residual = dot(v, bent) - (*point).reference_curvature[i][j];
            // r_ij and r_ji are one number and count twice.
            let count = select(2.0, 1.0, i == j);
            value += count * residual * residual;
            if ORDER >= GRADIENT {
                var direction = Direction();
                direction[i] += bent;
                direction[j] += (*point).curvature * v;
                for (var k = 0u; k < D; k++) {
                    direction[POSITION][k] = dot(v, (*point).curvature_slope[k] * w);
                }
                add_square(weight * count, residual, &direction, response);
            }
        }
    }
    return value;
}

// W(y) = (tr D²d₂(y) − tr D²d₁)².
fn mean_curvature(weight: f32, point: ptr<function, Point>, response: ptr<function, Response>) -> f32 {
    let residual = trace((*point).curvature) - (*point).reference_trace;
    if ORDER >= GRADIENT {
        var direction = Direction();
        for (var k = 0u; k < D; k++) {
            direction[POSITION][k] = trace((*point).curvature_slope[k]);
        }
        add_square(weight, residual, &direction, response);
    }
    return residual * residual;
}
