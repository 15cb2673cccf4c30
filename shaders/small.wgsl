// Vectors and matrices of the dimension D. A matrix is its vectors: `m[k]` is the k-th, and in a hessian's block the k-th
// row.

const CORNERS = 1u << D;
const LARGEST = 3e38;

// m[i] = a_i b.
fn outer(a: Vec, b: Vec) -> Mat {
    var m = Mat();
    for (var i = 0u; i < D; i++) {
        m[i] = a[i] * b;
    }
    return m;
}

fn frobenius(m: Mat) -> f32 {
    var sum = 0.0;
    for (var k = 0u; k < D; k++) {
        sum += dot(m[k], m[k]);
    }
    return sum;
}

fn trace(m: Mat) -> f32 {
    var sum = 0.0;
    for (var k = 0u; k < D; k++) {
        sum += m[k][k];
    }
    return sum;
}

// What is positive of the symmetric matrix (a b; b c), as (a, b, c): by its mean and the deviation from it.
fn positive_part(a: f32, b: f32, c: f32) -> vec3f {
    let mean = 0.5 * (a + c);
    let deviation = 0.5 * (a - c);
    let radius = sqrt(deviation * deviation + b * b);
    let high = max(mean + radius, 0.0);
    let low = max(mean - radius, 0.0);
    let centre = 0.5 * (high + low);
    let spread = 0.5 * (high - low) / max(radius, 1e-30);
    return vec3f(centre + spread * deviation, spread * b, centre - spread * deviation);
}
