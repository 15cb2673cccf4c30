// W(y) = (d₂(y) − d₁)²,  ∂W/∂y = 2 (d₂ − d₁) ∇d₂.  Twin of src/energy/mismatch.rs.
fn mismatch(weight: f32, point: ptr<function, Point>, response: ptr<function, Response>) -> f32 {
    let residual = (*point).distance - (*point).reference_distance;
    if ORDER >= GRADIENT {
        var direction = Direction();
        direction[POSITION] = (*point).gradient;
        add_square(weight, residual, &direction, response);
    }
    return residual * residual;
}
