// W = μ/2 tr G + g(det G), G_ij = v_i·v_j, v_i = Dφ t_i.  Twin of src/energy/membrane.rs.

struct Strain {
    trace: f32,
    det: f32,
    cof: mat2x2f,
}

// ∂ det G/∂v_i = 2 Σ_j cof_ij v_j.
fn forces_of(strain: Strain, v: Mat) -> Mat {
    var cof = strain.cof;
    var forces = Mat();
    for (var i = 0u; i < NORMAL; i++) {
        for (var j = 0u; j < NORMAL; j++) {
            forces[i] += 2.0 * cof[i][j] * v[j];
        }
    }
    return forces;
}

fn tangents_of(point: ptr<function, Point>) -> Mat {
    var v = Mat();
    for (var i = 0u; i < NORMAL; i++) {
        v[i] = (*point).slots[i];
    }
    return v;
}

fn membrane(weight: f32, point: ptr<function, Point>, response: ptr<function, Response>) -> f32 {
    let v = tangents_of(point);
    let strain = strain_of(v);
    let slopes = dilation(strain.det);
    if ORDER >= GRADIENT {
        let forces = forces_of(strain, v);
        for (var i = 0u; i < NORMAL; i++) {
            (*response).gradient[i] += weight * (level.mu * v[i] + slopes.y * forces[i]);
        }
    }
    if ORDER >= HESSIAN {
        var second = array<Mat, 3>();
        membrane_hessian(v, strain, &second);
        for (var i = 0u; i < NORMAL; i++) {
            for (var j = i; j < NORMAL; j++) {
                (*response).hessian[i * SLOTS + j] += weight * second[i + j];
            }
        }
    }
    return 0.5 * level.mu * strain.trace + slopes.x;
}
