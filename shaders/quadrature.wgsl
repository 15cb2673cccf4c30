// Tensor-product rules on a cell [0,1]^D, x fastest, named by their points an axis.

const VERTICES = 0u;
const GAUSS_2 = 2u;
const GAUSS_3 = 3u;

fn points_of(rule: u32) -> u32 {
    let line = max(rule, 2u);
    return select(line * line, line * line * line, D == 3u);
}

// √0.6/2 and 1/(2√3) are the Gauss points' distances from the middle.
fn place_on_line(rule: u32, number: u32) -> f32 {
    let offset = f32(number);
    if rule == GAUSS_3 {
        return 0.5 + (offset - 1.0) * 0.3872983346207417;
    }
    return 0.5 + (2.0 * offset - 1.0) * select(0.5, 0.28867513459481287, rule == GAUSS_2);
}

fn weight_on_line(rule: u32, number: u32) -> f32 {
    if rule == GAUSS_3 {
        return select(5.0 / 18.0, 8.0 / 18.0, number == 1u);
    }
    return 0.5;
}

fn place_of(rule: u32, point: u32) -> Vec {
    let line = max(rule, 2u);
    var place = Vec();
    var rest = point;
    for (var axis = 0u; axis < D; axis++) {
        place[axis] = place_on_line(rule, rest % line);
        rest /= line;
    }
    return place;
}

fn weight_of(rule: u32, point: u32) -> f32 {
    let line = max(rule, 2u);
    var weight = 1.0;
    var rest = point;
    for (var axis = 0u; axis < D; axis++) {
        weight *= weight_on_line(rule, rest % line);
        rest /= line;
    }
    return weight;
}
