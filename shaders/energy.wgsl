// What a term of the shell sees and gives: a quadrature point with the slots Dφ t_1, …, Dφ n, φ and both shapes' jets, and
// derivatives by the slots. Twin of src/energy.rs.

const VALUE = 0u;
const GRADIENT = 1u;
const HESSIAN = 2u;
override ORDER: u32 = VALUE;

const SLOTS = D + 1u;
const NORMAL = D - 1u;
const POSITION = D;

struct Point {
    slots: array<Vec, SLOTS>,
    // The reference: d1, what of |D²d1|² is off the tangent space, tr D²d1, |∇d1|, and t_iᵀ D²d1 t_j.
    reference_distance: f32,
    off_tangential: f32,
    reference_trace: f32,
    steepness: f32,
    reference_curvature: Mat,
    // The template at φ: d2 and its derivative; the fitted ∇d2 and D²d2, each with its derivatives by axes.
    distance: f32,
    gradient: Vec,
    normal: Vec,
    normal_slope: Mat,
    curvature: Mat,
    curvature_slope: array<Mat, D>,
}

struct Response {
    gradient: array<Vec, SLOTS>,
    // Slot p against slot q at p · SLOTS + q; filled for p ≤ q.
    hessian: array<Mat, SLOTS * SLOTS>,
}

// A direction in the slots.
alias Direction = array<Vec, SLOTS>;

fn add_gradient(weight: f32, direction: ptr<function, Direction>, response: ptr<function, Response>) {
    for (var slot = 0u; slot < SLOTS; slot++) {
        (*response).gradient[slot] += weight * (*direction)[slot];
    }
}

// hessian += weight · direction ⊗ direction.
fn add_outer(weight: f32, direction: ptr<function, Direction>, response: ptr<function, Response>) {
    for (var p = 0u; p < SLOTS; p++) {
        for (var q = p; q < SLOTS; q++) {
            (*response).hessian[p * SLOTS + q] += outer(weight * (*direction)[p], (*direction)[q]);
        }
    }
}

// A residual r with ∂r = direction: adds what weight · r² gives.
fn add_square(weight: f32, residual: f32, direction: ptr<function, Direction>, response: ptr<function, Response>) {
    add_gradient(2.0 * weight * residual, direction, response);
    if ORDER >= HESSIAN {
        add_outer(2.0 * weight, direction, response);
    }
}

// g, g′ and g″ of the law W = μ/2 tr A + g(det A).
fn dilation(x: f32) -> vec3f {
    let linear = (level.lambda - 2.0 * level.mu) / 8.0;
    let inverse = (level.lambda + 2.0 * level.mu) / 8.0;
    let q = 1.0 / x;
    let second = inverse * q * q;
    return vec3f(linear * x + inverse * q, linear - second, 2.0 * second * q);
}

// Weighted densities: membrane, bending, mismatch with its H¹ part.
fn shell(weight: f32, point: ptr<function, Point>, response: ptr<function, Response>) -> vec3f {
    var densities = vec3f();
    let stretching = weight * level.membrane;
    if level.membrane_model == PROJECTED {
        densities.x = stretching * projected(stretching, point, response);
    } else {
        densities.x = stretching * membrane(stretching, point, response);
    }
    let turning = weight * level.bending;
    if level.bending_model == MEAN_CURVATURE {
        densities.y = turning * mean_curvature(turning, point, response);
    } else {
        densities.y = turning * bending(turning, point, response);
    }
    let penalty = weight * level.penalty;
    densities.z = penalty * mismatch(penalty, point, response);
    if level.tangency > 0.0 {
        let residual = penalty * level.tangency;
        densities.z += residual * tangency(residual, point, response);
    }
    return densities;
}
