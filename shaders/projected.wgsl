// W = μ/2 tr G + a det G + b / det G̃: compression measured along the template.  Twin of src/energy/projected.rs, where
// the letters are explained.

// κ = 0.02: 2 (1 − √κ).
const TWICE_ALONG = 1.7171572875253811;

fn projected(weight: f32, point: ptr<function, Point>, response: ptr<function, Response>) -> f32 {
    let g = (*point).normal;
    let v = tangents_of(point);
    let gamma = dot(g, g);
    let rest = 1.0 / (1.0 + gamma * gamma);
    let c = TWICE_ALONG * rest;
    var p = Vec();
    var w = Mat();
    for (var i = 0u; i < NORMAL; i++) {
        p[i] = dot(g, v[i]);
        w[i] = v[i] - c * p[i] * g;
    }
    let plain = strain_of(v);
    let along = strain_of(w);
    let a = (level.lambda - 2.0 * level.mu) / 8.0;
    let b = (level.lambda + 2.0 * level.mu) / 8.0;
    let inverse = 1.0 / along.det;
    if ORDER >= GRADIENT {
        let stretching = forces_of(plain, v);
        let squeezing = forces_of(along, w);
        let slope = -b * inverse * inverse;
        // c depends on g through γ = |g|².
        let c_slope = -2.0 * gamma * rest * c;
        var by_g = Vec();
        for (var i = 0u; i < NORMAL; i++) {
            let force = squeezing[i];
            let across = dot(force, g);
            (*response).gradient[i] +=
                weight * (level.mu * v[i] + a * stretching[i] + slope * (force - c * across * g));
            by_g += 2.0 * c_slope * p[i] * across * g + c * (across * v[i] + p[i] * force);
        }
        for (var k = 0u; k < D; k++) {
            (*response).gradient[POSITION][k] -= weight * slope * dot(by_g, (*point).normal_slope[k]);
        }
    }
    if ORDER >= HESSIAN {
        projected_hessian(weight, point, v, w, along, c, response);
    }
    return 0.5 * level.mu * plain.trace + a * plain.det + b * inverse;
}

fn projected_hessian(
    weight: f32,
    point: ptr<function, Point>,
    v: Mat,
    w: Mat,
    along: Strain,
    c: f32,
    response: ptr<function, Response>,
) {
    let g = (*point).normal;
    let a = (level.lambda - 2.0 * level.mu) / 8.0;
    let q = weight * (2.0 * c - c * c * dot(g, g));
    var cof = along.cof;
    var by_position = Mat();
    for (var i = 0u; i < NORMAL; i++) {
        for (var k = 0u; k < D; k++) {
            by_position[i][k] = dot((*point).normal_slope[k], v[i]);
        }
    }
    var second = array<Mat, 3>();
    membrane_hessian(w, along, &second);
    for (var i = 0u; i < NORMAL; i++) {
        for (var j = 0u; j < NORMAL; j++) {
            let stiffness = q * (select(0.0, level.mu, i == j) + 2.0 * a * cof[i][j]);
            (*response).hessian[i * SLOTS + POSITION] += stiffness * outer(g, by_position[j]);
            (*response).hessian[POSITION * SLOTS + POSITION] += stiffness * outer(by_position[i], by_position[j]);
            if i <= j {
                // From w to v: (1 − c g ⊗ g) B (1 − c g ⊗ g). A matrix is its rows, so that WGSL's products are transposed.
                let block = second[i + j];
                let right = g * block;
                let left = block * g;
                let both = c * dot(g, right);
                (*response).hessian[i * SLOTS + j] += stiffness * outer(g, g)
                    + weight * (block - c * (outer(g, left - both * g) + outer(right, g)));
            }
        }
    }
}
