// What differs for D = 2: curves in the plane. `space.wgsl` has the same names.

const D = 2u;
alias Vec = vec2f;
alias Mat = mat2x2f;

// The last vector of a frame from those before it.
fn normal_to(tangents: Mat) -> Vec {
    return Vec(tangents[0].y, -tangents[0].x);
}

// So that det m = m[0]·cof[0], and ∂det/∂m = cof m.
fn cofactor(m: Mat) -> Mat {
    return Mat(Vec(m[1].y, -m[1].x), Vec(-m[0].y, m[0].x));
}

// G_ij = v_i·v_j of the tangent vectors.
fn strain_of(v: Mat) -> Strain {
    let square = dot(v[0], v[0]);
    return Strain(square, square, mat2x2f(1.0, 0.0, 0.0, 1.0));
}

// det Dφ is linear along every edge of a cell, so that its least value is at a corner.
fn least_determinant(edges: ptr<function, Edges>) -> f32 {
    var least = LARGEST;
    for (var corner = 0u; corner < CORNERS; corner++) {
        let f = derivative(edges, Vec(corner_bits(corner)));
        least = min(least, dot(f[0], cofactor(f)[0]));
    }
    return least;
}

fn corner_bits(corner: u32) -> vec2u {
    return vec2u(corner & 1u, corner >> 1u);
}

// The projected second derivative of `membrane` by the tangent vector.
fn membrane_hessian(v: Mat, strain: Strain, result: ptr<function, array<Mat, 3>>) {
    let slopes = dilation(strain.det);
    let mean = level.mu + 2.0 * slopes.y;
    let across = max(mean, 0.0);
    let along = mean + 4.0 * strain.det * slopes.z;
    let difference = (along - across) / strain.det;
    (*result)[0] = Mat(difference * v[0].x * v[0] + Vec(across, 0.0), difference * v[0].y * v[0] + Vec(0.0, across));
}

// The projected second derivative of `volume` by the columns: (0, 0), (0, 1) and (1, 1). Twin of `planar_hessian`.
fn volume_hessian(weight: f32, f: Mat, result: ptr<function, array<Mat, 3>>) {
    let det = dot(f[0], cofactor(f)[0]);
    let slopes = dilation(det * det);
    let first = 2.0 * det * slopes.y;
    let second = 2.0 * slopes.y + 4.0 * det * det * slopes.z;
    let plus = sqrt(0.5) * Vec(f[0].x + f[1].y, f[0].y - f[1].x);
    let minus = sqrt(0.5) * Vec(f[0].x - f[1].y, f[0].y + f[1].x);
    let a = length(plus);
    let b = length(minus);
    let e = plus / max(a, 1e-30);
    let d = minus / max(b, 1e-30);
    let twist = level.mu + first;
    let flip = level.mu - first;
    let scaling = positive_part(twist + second * a * a, -second * a * b, flip + second * b * b);
    let p = outer(e, e) * (scaling.x - max(twist, 0.0)) + max(twist, 0.0) * Mat(1.0, 0.0, 0.0, 1.0);
    let m = outer(d, d) * (scaling.z - max(flip, 0.0)) + max(flip, 0.0) * Mat(1.0, 0.0, 0.0, 1.0);
    let c = scaling.y * outer(e, d);

    // Back to the entries: F₀₀ = (z₀+z₂)/√2, F₁₁ = (z₀−z₂)/√2, F₀₁ = (z₁+z₃)/√2, F₁₀ = (z₃−z₁)/√2.
    let w = 0.5 * weight;
    let mixed = c[0].y + c[1].x;
    let turned = c[0].y - c[1].x;
    let off = p[0].y + mixed + m[0].y;
    let far = -p[0].y + mixed - m[0].y;
    (*result)[0] = w * Mat(p[0].x + 2.0 * c[0].x + m[0].x, off, off, p[1].y + 2.0 * c[1].y + m[1].y);
    (*result)[2] = w * Mat(p[1].y - 2.0 * c[1].y + m[1].y, far, far, p[0].x - 2.0 * c[0].x + m[0].x);
    (*result)[1] = w * Mat(
        -p[0].y + turned + m[0].y,
        p[0].x - m[0].x,
        m[1].y - p[1].y,
        p[0].y + turned - m[0].y,
    );
}

// The volume's hessian of a cell, at the four Gauss points; weight in units of 1/h².
fn write_volume_pairs(number: u32, weight: f32, edges: ptr<function, Edges>) {
    var hessians = array<array<Mat, 3>, 4>();
    for (var point = 0u; point < 4u; point++) {
        var hessian = array<Mat, 3>();
        volume_hessian(0.25 * weight, derivative(edges, place_of(GAUSS_2, point)), &hessian);
        hessians[point] = hessian;
    }
    for (var b = 0u; b < CORNERS; b++) {
        for (var a = 0u; a <= b; a++) {
            var block = Mat();
            for (var point = 0u; point < 4u; point++) {
                let place = place_of(GAUSS_2, point);
                let s = shape_gradient(place, a);
                let t = shape_gradient(place, b);
                let mixed = hessians[point][1];
                block += s.x * t.x * hessians[point][0] + s.y * t.y * hessians[point][2]
                    + s.x * t.y * mixed + s.y * t.x * transpose(mixed);
            }
            write_pair(number, a, b, block);
        }
    }
}
