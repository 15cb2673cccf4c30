// W(F) = μ/2 |F|² + g(J²), F = Dφ, J = det F.  Twin of src/energy/volume.rs.

// Returns the density; adds weight · ∂W/∂F.
fn volume(weight: f32, f: Mat, stress: ptr<function, Mat>) -> f32 {
    let cof = cofactor(f);
    let det = dot(f[0], cof[0]);
    let slopes = dilation(det * det);
    if ORDER >= GRADIENT {
        *stress += weight * (level.mu * f + 2.0 * det * slopes.y * cof);
    }
    return 0.5 * level.mu * frobenius(f) + slopes.x;
}
