// What differs for D = 3: surfaces in space. `plane.wgsl` has the same names.

const D = 3u;
alias Vec = vec3f;
alias Mat = mat3x3f;

// The last vector of a frame from those before it.
fn normal_to(tangents: Mat) -> Vec {
    return cross(tangents[0], tangents[1]);
}

// So that det m = m[0]·cof[0], and ∂det/∂m = cof m.
fn cofactor(m: Mat) -> Mat {
    return Mat(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
}

// G_ij = v_i·v_j of the tangent vectors.
fn strain_of(v: Mat) -> Strain {
    let a = dot(v[0], v[0]);
    let b = dot(v[0], v[1]);
    let c = dot(v[1], v[1]);
    // The area squared by the normal: a c − b² would cancel.
    let n = normal_to(v);
    return Strain(a + c, dot(n, n), mat2x2f(c, -b, -b, a));
}

// A lower bound of det Dφ over a cell: the least of its 27 coefficients in Bernstein's basis, see
// src/assemble/cpu/certificate.rs.
fn least_determinant(edges: ptr<function, Edges>) -> f32 {
    // By α₀, k′ and j″; the mean of two where α₀ = 1.
    var crosses = array<Vec, 12>();
    for (var k = 0u; k < 2u; k++) {
        for (var j = 0u; j < 2u; j++) {
            let low = cross(whole_edge(edges, 1u, 2u * k), whole_edge(edges, 2u, 2u * j));
            let high = cross(whole_edge(edges, 1u, 1u + 2u * k), whole_edge(edges, 2u, 1u + 2u * j));
            let between = cross(whole_edge(edges, 1u, 2u * k), whole_edge(edges, 2u, 1u + 2u * j))
                + cross(whole_edge(edges, 1u, 1u + 2u * k), whole_edge(edges, 2u, 2u * j));
            crosses[2u * k + j] = low;
            crosses[4u + 2u * k + j] = 0.5 * between;
            crosses[8u + 2u * k + j] = high;
        }
    }
    var coefficients = array<f32, 27>();
    for (var first = 0u; first < 3u; first++) {
        for (var along = 0u; along < 4u; along++) {
            let edge = whole_edge(edges, 0u, along);
            for (var other = 0u; other < 4u; other++) {
                // Of along, j is the first bit and k the second; of other, j is the first and k the second.
                let j = (along & 1u) + (other & 1u);
                let k = (along >> 1u) + (other >> 1u);
                let share = select(0.5, 1.0, j != 1u) * select(0.5, 1.0, k != 1u);
                coefficients[first + 3u * j + 9u * k] += share * dot(edge, crosses[4u * first + other]);
            }
        }
    }
    var least = LARGEST;
    for (var number = 0u; number < 27u; number++) {
        least = min(least, coefficients[number]);
    }
    return least;
}

fn corner_bits(corner: u32) -> vec3u {
    return vec3u(corner & 1u, (corner >> 1u) & 1u, corner >> 2u);
}

// The projected second derivative of `membrane` by the tangent vectors: (0, 0), (0, 1) and (1, 1).
fn membrane_hessian(v: Mat, strain: Strain, result: ptr<function, array<Mat, 3>>) {
    let slopes = dilation(strain.det);
    let area = sqrt(strain.det);
    let first = 2.0 * area * slopes.y;
    let second = 2.0 * slopes.y + 4.0 * strain.det * slopes.z;
    let within = first * (level.mu / max(abs(first), level.mu));
    let normal = normal_to(v) / area;
    // ∂J/∂v₀ = v₁×n and ∂J/∂v₁ = n×v₀.
    let by_first = cross(v[1], normal);
    let by_second = cross(normal, v[0]);

    // (μ 1 + k′ cof(G)/J)₊ by its mean and the deviation from it.
    let ratio = first / area;
    let aa = level.mu + ratio * strain.cof[0][0];
    let bb = level.mu + ratio * strain.cof[1][1];
    let ab = ratio * strain.cof[0][1];
    let across = positive_part(aa, ab, bb);

    let normals = outer(normal, normal);
    let own = Mat(Vec(level.mu, 0.0, 0.0), Vec(0.0, level.mu, 0.0), Vec(0.0, 0.0, level.mu));
    (*result)[0] = second * outer(by_first, by_first) + (across.x - level.mu) * normals + own;
    (*result)[1] = second * outer(by_first, by_second) + across.y * normals;
    (*result)[2] = second * outer(by_second, by_second) + (across.z - level.mu) * normals + own;
    // ∂²J takes changes a of v₀ and b of v₁ within the plane to n·(a×b).
    (*result)[1] += turn_by(within * normal);
}

// Takes a and b to v·(a×b).
fn turn_by(v: Vec) -> Mat {
    return Mat(Vec(0.0, v.z, -v.y), Vec(-v.z, 0.0, v.x), Vec(v.y, -v.x, 0.0));
}

// t k′ of the volume's hessian at F: of its indefinite part, what μ outweighs. Twin of `shortened`.
fn shortened_twist(f: Mat) -> f32 {
    let det = max(dot(f[0], cofactor(f)[0]), LEAST_DETERMINANT);
    let first = 2.0 * det * dilation(det * det).y;
    let square = frobenius(f);
    let squares = frobenius(transpose(f) * f);
    let mean = square / 3.0;
    let largest = mean + sqrt(max(squares - square * mean, 0.0) * (2.0 / 3.0));
    let bound = max(-first, 0.0) * sqrt(largest) + max(first, 0.0) * sqrt(square);
    return first * (level.mu / max(bound, level.mu));
}

// The volume's hessian of a cell, weight in units of 1/h². Twin of src/assemble/cpu/spatial.rs: that at the middle of the cell,
// integrated exactly with it.
fn write_volume_pairs(number: u32, weight: f32, edges: ptr<function, Edges>) {
    let middle = derivative(edges, Vec(0.5));
    let cof = cofactor(middle);
    let det = max(dot(middle[0], cof[0]), LEAST_DETERMINANT);
    let slopes = dilation(det * det);
    let second = weight * (2.0 * slopes.y + 4.0 * det * det * slopes.z);
    let twist = weight * shortened_twist(middle);
    for (var b = 0u; b < CORNERS; b++) {
        for (var a = 0u; a <= b; a++) {
            // ∫ ∇N_a ⊗ ∇N_b and ∫ ∇N_a × ∇N_b: along an axis ∫ N N is 1/3 or 1/6, ∫ N′ N is ±1/2, ∫ N′ N′ is ±1.
            let s = 2.0 * Vec(corner_bits(a)) - 1.0;
            let t = 2.0 * Vec(corner_bits(b)) - 1.0;
            let along = s * t;
            let mass = select(Vec(1.0 / 6.0), Vec(1.0 / 3.0), along > Vec(0.0));
            let same = along * mass.yzx * mass.zxy;
            var both = 0.25 * outer(s, t);
            both[0] *= Vec(0.0, mass.z, mass.y);
            both[1] *= Vec(mass.z, 0.0, mass.x);
            both[2] *= Vec(mass.y, mass.x, 0.0);
            both += Mat(Vec(same.x, 0.0, 0.0), Vec(0.0, same.y, 0.0), Vec(0.0, 0.0, same.z));
            let own = weight * level.mu * (same.x + same.y + same.z);
            var block = second * (cof * both * transpose(cof));
            block += Mat(Vec(own, 0.0, 0.0), Vec(0.0, own, 0.0), Vec(0.0, 0.0, own));
            block += turn_by(twist * (middle * (0.25 * mass * cross(s, t))));
            write_pair(number, a, b, block);
        }
    }
}
