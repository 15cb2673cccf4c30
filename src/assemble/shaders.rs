//! The shaders' text: WGSL twins of the energies and of what assembles them, in `shaders/`.

/// The modules that all dimensions share, in the order of the crate's own.
const SHARED: [&str; 14] = [
    include_str!("../../shaders/level.wgsl"),
    include_str!("../../shaders/small.wgsl"),
    include_str!("../../shaders/quadrature.wgsl"),
    include_str!("../../shaders/cell.wgsl"),
    include_str!("../../shaders/energy.wgsl"),
    include_str!("../../shaders/membrane.wgsl"),
    include_str!("../../shaders/projected.wgsl"),
    include_str!("../../shaders/bending.wgsl"),
    include_str!("../../shaders/mismatch.wgsl"),
    include_str!("../../shaders/tangency.wgsl"),
    include_str!("../../shaders/volume.wgsl"),
    include_str!("../../shaders/reference.wgsl"),
    include_str!("../../shaders/template.wgsl"),
    include_str!("../../shaders/reduce.wgsl"),
];

const PLANE: &str = include_str!("../../shaders/plane.wgsl");
const SPACE: &str = include_str!("../../shaders/space.wgsl");
/// What follows the energies: their sums, then what a minimiser does with them that stays on the card.
const LAST: [&str; 6] = [
    include_str!("../../shaders/assemble.wgsl"),
    include_str!("../../shaders/hessian.wgsl"),
    include_str!("../../shaders/multigrid.wgsl"),
    include_str!("../../shaders/gradients.wgsl"),
    include_str!("../../shaders/resident.wgsl"),
    include_str!("../../shaders/pins.wgsl"),
];

/// The whole module for D dimensions.
pub(super) fn source<const D: usize>() -> String {
    let dimension = if D == 2 { PLANE } else { SPACE };
    [&[dimension], SHARED.as_slice(), LAST.as_slice()].concat().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use naga::front::wgsl;
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    fn is_valid<const D: usize>() {
        let text = source::<D>();
        let module = wgsl::parse_str(&text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        validator.validate(&module).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
        let entries: Vec<&str> = module.entry_points.iter().map(|entry| entry.name.as_str()).collect();
        let expected = [
            "reduce",
            "volume_cells",
            "shell_cells",
            "gather_gradient",
            "volume_pairs",
            "shell_pairs",
            "gather_blocks",
            "sweep",
            "leave_residual",
            "restrict_residual",
            "prolongate",
            "small_cycle",
            "coarsen",
            "invert_diagonal",
            "begin",
            "begun",
            "overlap",
            "choose_turn",
            "turn",
            "apply",
            "choose_step",
            "advance",
            "judge",
            "fall",
            "fallen",
            "place_nodes",
            "move_nodes",
            "gather_stencil",
            "weigh",
            "weighed",
            "stiffen",
            "pull_pins",
            "stiffen_pins",
        ];
        assert_eq!(entries, expected);
    }

    /// Within a loop, Chromium's compiler leaves a variable that is given none as the iteration before left it.
    #[test]
    fn every_local_variable_is_given_a_value() {
        for text in [source::<2>(), source::<3>()] {
            let locals = text.lines().map(str::trim_start).filter(|line| line.starts_with("var "));
            let bare: Vec<&str> = locals.filter(|line| !line.contains('=')).collect();
            assert!(bare.is_empty(), "{bare:?}");
        }
    }

    #[test]
    fn the_shaders_are_valid_in_both_dimensions() {
        is_valid::<2>();
        is_valid::<3>();
    }
}
