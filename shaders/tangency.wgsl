// W = Σ_i r_i² + r_n²,  r_i = g(y)·Dφ t_i,  r_n = g(y)·Dφ n − |∇d₁|.  Twin of src/energy/tangency.rs.
fn tangency(weight: f32, point: ptr<function, Point>, response: ptr<function, Response>) -> f32 {
    var value = 0.0;
    for (var i = 0u; i < D; i++) {
        let column = (*point).slots[i];
        var residual = dot((*point).normal, column);
        if i == NORMAL {
            residual -= (*point).steepness;
        }
        value += residual * residual;
        if ORDER >= GRADIENT {
            var direction = Direction();
            direction[i] = (*point).normal;
            for (var k = 0u; k < D; k++) {
                direction[POSITION][k] = dot((*point).normal_slope[k], column);
            }
            add_square(weight, residual, &direction, response);
        }
    }
    return value;
}
