//! The settings: names, symbols, words, ranges, defaults. Everything else that knows a setting follows from here: how
//! it is read and checked, `Settings` in TypeScript, the page's fields, docs/settings.md.

use super::kind::{Field, Group, Kind, Range, Setting, Value, Words, choices, declare};
use crate::energy::{BendingModel, Cutoff, MembraneModel};

/// How the first deformation is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alignment {
    /// The identity, as in the paper.
    None,
    /// The best of the identity and similarities that match centroid and area.
    Similarity,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MinimizerKind {
    /// Projected Gauss–Newton with multigrid.
    Newton,
    /// The paper's: Fletcher–Reeves in a Sobolev metric.
    Ncg,
}

impl MinimizerKind {
    /// About as many iterations as so many of Newton's method.
    pub(crate) fn iterations(self, newton: usize) -> usize {
        match self {
            Self::Newton => newton,
            Self::Ncg => 10 * newton,
        }
    }
}

/// What computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backend {
    Auto,
    Cpu,
    Gpu,
}

choices! {
    MembraneModel: MEMBRANE_MODELS {
        Intrinsic = "intrinsic", "along the moved curve";
        Projected = "projected", "along the target";
    }
    BendingModel: BENDING_MODELS {
        ShapeOperator = "shape-operator", "shape operators";
        MeanCurvature = "mean-curvature", "mean curvatures";
    }
    Cutoff: CUTOFFS {
        Quartic = "quartic", "(1 − s²)²";
        Cosine = "cosine", "(1 + cos πs)/2";
        Bump = "bump", "exp(1 − 1/(1 − s²))";
    }
    Alignment: ALIGNMENTS {
        Similarity = "similarity", "the best similarity";
        None = "none", "the identity";
    }
    MinimizerKind: MINIMIZERS {
        Newton = "newton", "projected Newton";
        Ncg = "ncg", "conjugate gradients";
    }
    Backend: BACKENDS {
        Auto = "auto", "the fastest there is";
        Cpu = "cpu", "the processor";
        Gpu = "gpu", "the graphics card";
    }
}

/// The coarsest level there can be: 9 nodes a side.
pub const LEAST_LEVEL: u32 = 3;
/// The finest level there can be: 1025 nodes a side.
pub const MOST_LEVEL: u32 = 10;

// The hessian's entries are sums of all terms in single precision, which has seven digits.
const LOST: &str = "a term that outweighs the others by more is all that single precision sees";
const VANISHED: &str = "below it the term is lost in rounding";

const fn weight(least: f64, most: f64) -> Range {
    Range::new(least, most, LOST)
}

const fn level(usual: (u32, u32)) -> Kind {
    Kind::Level { least: LEAST_LEVEL, most: MOST_LEVEL, usual }
}

declare! {
    membrane: f64 = 1.0 => {
        name: "membrane", symbol: "α_mem", group: Energies, on_page: true,
        label: "Stretching",
        help: "How much the shell resists being stretched along the curve. 0 leaves it out.",
        kind: Kind::Number(weight(0.0, 1e6).usual(0.0, 100.0)),
    }
    membrane_model: MembraneModel = MembraneModel::Intrinsic => {
        name: "membraneModel", symbol: "", group: Energies, on_page: true,
        label: "Compression counts",
        help: "Along the moved curve, as in the paper, a curve that has to shrink may crumple instead; along the target crumpling does not help it.",
        kind: Kind::Choice(MEMBRANE_MODELS),
    }
    bending: f64 = 0.03 => {
        name: "bending", symbol: "α_bend", group: Energies, on_page: true,
        label: "Bending",
        help: "How much the shell resists a change of curvature. 0 leaves it out.",
        kind: Kind::Number(weight(0.0, 1e6).usual(0.0, 100.0)),
    }
    bending_model: BendingModel = BendingModel::ShapeOperator => {
        name: "bendingModel", symbol: "", group: Energies, on_page: true,
        label: "Bending compares",
        help: "The relative shape operator sees direction too; mean curvature alone is the simpler alternative.",
        kind: Kind::Choice(BENDING_MODELS),
    }
    thickness: f64 = 0.5 => {
        name: "thickness", symbol: "δ", group: Energies, on_page: true,
        label: "Thickness",
        help: "Of the shell, on the coarsest grid. Stretching counts δ times, bending δ³ times.",
        kind: Kind::Number(
            Range::new(1e-6, 10.0, "bending goes with its cube").usual(1e-3, 10.0).unit("box sides"),
        ),
    }
    penalty: f64 = 1e3 => {
        name: "penalty", symbol: "1/ε", group: Energies, on_page: true,
        label: "Mismatch",
        help: "How strongly the reference is drawn onto the target, on the coarsest grid.",
        kind: Kind::Number(weight(1e-6, 1e9).usual(1e-3, 1e7).unit("per side²")),
    }
    tangency: f64 = 0.25 => {
        name: "tangency", symbol: "ρ", group: Energies, on_page: true,
        label: "Tangency",
        help: "Keeps the moved curve along the target, not in waves about it. Coarser grids take four times as much. 0 is the paper.",
        kind: Kind::Number(Range::new(0.0, 10.0, "wider than that it sees no detail").usual(0.0, 4.0).unit("cells")),
    }
    pin_weight: f64 = 1.0 => {
        name: "pinWeight", symbol: "", group: Energies, on_page: true,
        label: "Pin strength",
        help: "How strongly pins pull, in units of 1/ε. 0 ignores them.",
        kind: Kind::Number(weight(0.0, 1e6).usual(0.0, 100.0)),
    }
    volume: f64 = 1e-2 => {
        name: "volume", symbol: "ξ", group: Energies, on_page: true,
        label: "Volume",
        help: "How much the plane around the curve resists being deformed.",
        kind: Kind::Number(
            Range::new(1e-9, 1e6, "without it nothing keeps the space around the shell from folding").usual(1e-6, 1e3),
        ),
    }
    softness: f64 = 1.0 => {
        name: "interior", symbol: "ζ", group: Energies, on_page: false,
        label: "Softness outside",
        help: "Volume counts so much outside of the reference and 1 inside; 1 treats both alike.",
        kind: Kind::Number(Range::new(1e-6, 1.0, "without it the outside folds")),
    }
    lambda: f64 = 2.0 => {
        name: "lambda", symbol: "λ", group: Energies, on_page: false,
        label: "Resistance to a change of size",
        help: "The first Lamé coefficient of shell and plane, at least 2 μ: below, growing beyond all bounds would gain energy.",
        kind: Kind::Number(weight(0.0, 1e6)),
    }
    mu: f64 = 0.25 => {
        name: "mu", symbol: "μ", group: Energies, on_page: false,
        label: "Resistance to a change of shape",
        help: "The second Lamé coefficient of shell and plane, the shear modulus.",
        kind: Kind::Number(Range::new(1e-6, 1e6, VANISHED)),
    }
    finest: u32 = 7 => {
        name: "finest", symbol: "", group: Grid, on_page: true,
        label: "Finest grid",
        help: "The match is refined up to this grid.",
        kind: level((5, 9)),
    }
    coarsest: u32 = 4 => {
        name: "coarsest", symbol: "", group: Grid, on_page: false,
        label: "Coarsest grid",
        help: "The match begins on this grid.",
        kind: level((3, 6)),
    }
    bandwidth: f64 = 0.0 => {
        name: "bandwidth", symbol: "σ", group: Grid, on_page: true,
        label: "Band",
        help: "Half width of the shell's band around the reference. 0 chooses it from the finest grid.",
        kind: Kind::Number(Range::new(0.0, 1.0, "there is no more than the box").usual(0.0, 0.25).unit("box sides")),
    }
    cutoff: Cutoff = Cutoff::Quartic => {
        name: "cutoff", symbol: "η", group: Grid, on_page: false,
        label: "Profile of the band",
        help: "How the shell fades towards the band's edge; s is the distance in units of σ.",
        kind: Kind::Choice(CUTOFFS),
    }
    fit_radius: f64 = 2.0 => {
        name: "fitRadius", symbol: "r", group: Grid, on_page: false,
        label: "Radius of curvature's fit",
        help: "Curvature is that of a quadratic fitted to the distances within this radius of a node.",
        kind: Kind::Number(
            Range::new(1.5, 4.0, "fewer nodes determine no quadratic, more blur the corners").unit("cells"),
        ),
    }
    vertex_share: f64 = 0.25 => {
        name: "vertexShare", symbol: "θ", group: Grid, on_page: true,
        label: "Corner share",
        help: "Part of the volume term taken at cell corners, which keeps cells from folding there. 0 is the paper.",
        kind: Kind::Number(Range::new(0.0, 1.0, "it is a share")),
    }
    halving: bool = true => {
        name: "halving", symbol: "", group: Grid, on_page: true,
        label: "Per finer grid",
        help: "Halving thickness and ε with the cell size sharpens the match level by level.",
        kind: Kind::Flag(["halve δ and ε", "keep δ and ε"]),
    }
    alignment: Alignment = Alignment::Similarity => {
        name: "align", symbol: "", group: Method, on_page: true,
        label: "Start from",
        help: "The best similarity moves, turns and scales the reference towards the target first; the paper starts from the identity.",
        kind: Kind::Choice(ALIGNMENTS),
    }
    minimizer: MinimizerKind = MinimizerKind::Newton => {
        name: "minimizer", symbol: "", group: Method, on_page: true,
        label: "Minimiser",
        help: "Newton's method takes a few costly steps, the paper's conjugate gradients many cheap ones.",
        kind: Kind::Choice(MINIMIZERS),
    }
    sobolev: f64 = 0.5 => {
        name: "sobolev", symbol: "β_max", group: Method, on_page: false,
        label: "Reach of the metric",
        help: "Conjugate gradients move regions of this size as wholes at first. 0 begins with single cells.",
        kind: Kind::Number(Range::new(0.0, 10.0, "there is no more than the box").unit("box sides")),
    }
    tolerance: f64 = 1e-5 => {
        name: "tolerance", symbol: "", group: Method, on_page: false,
        label: "Tolerance",
        help: "Relative decrease of the energy at which a level ends.",
        kind: Kind::Number(Range::new(1e-14, 0.1, "energies have sixteen digits, and a level shall do something")),
    }
    backend: Backend = Backend::Auto => {
        name: "backend", symbol: "", group: Method, on_page: true,
        label: "Computed by",
        help: "What computes; a graphics card pays where grids are large.",
        kind: Kind::Choice(BACKENDS),
    }
}

/// The pins are a list, which [`Settings`] does not hold; see [`super::Pin`].
pub const PINS: Words = Words {
    name: "pins",
    symbol: "",
    group: Group::Energies,
    on_page: false,
    label: "Pins",
    help: "Points of the reference's plane, each with a point of the target's that it is drawn to: x y, then its partner's x y, pin by pin (in 3D x y z and x y z).",
};
