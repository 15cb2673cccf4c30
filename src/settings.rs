//! Everything that can be chosen for a registration, with its range.

use crate::energy::{BendingModel, Cutoff, Functional, Material, MembraneModel};
use crate::error::Error;

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

/// The settings of a registration. Lengths are domain units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// α_mem.
    pub membrane: f64,
    pub membrane_model: MembraneModel,
    /// α_bend.
    pub bending: f64,
    pub bending_model: BendingModel,
    /// δ on the coarsest level.
    pub thickness: f64,
    /// 1/ε on the coarsest level.
    pub penalty: f64,
    /// ρ of the H¹ residual on the finest level, in cells of a level; 0 leaves it out, as the paper does.
    pub tangency: f64,
    /// Weight of the pins, in units of the penalty; 0 ignores them.
    pub pin_weight: f64,
    /// ξ.
    pub volume: f64,
    /// ζ.
    pub softness: f64,
    pub material: Material,
    /// σ, one value for all levels; 0 takes max(0.05, 1.5 h) with h of the finest level.
    pub bandwidth: f64,
    /// η.
    pub cutoff: Cutoff,
    /// r in cells.
    pub fit_radius: f64,
    /// θ.
    pub vertex_share: f64,
    /// The first level l, with 2^l cells a side.
    pub coarsest: u32,
    /// The last level.
    pub finest: u32,
    /// Halve δ and ε from level to level.
    pub halving: bool,
    pub alignment: Alignment,
    pub minimizer: MinimizerKind,
    /// β_max of the Sobolev metric.
    pub sobolev: f64,
    /// Relative decrease of the energy at which a level ends.
    pub tolerance: f64,
}

/// The coarsest level there can be: 9 nodes a side.
pub const LEAST_LEVEL: u32 = 3;
/// The finest level there can be: 1025 nodes a side.
pub const MOST_LEVEL: u32 = 10;

impl Default for Settings {
    fn default() -> Self {
        Self {
            membrane: 1.0,
            membrane_model: MembraneModel::Intrinsic,
            bending: 1.0,
            bending_model: BendingModel::ShapeOperator,
            thickness: 0.5,
            penalty: 1e3,
            tangency: 0.25,
            pin_weight: 1.0,
            volume: 1e-3,
            softness: 1.0,
            material: Material { lambda: 2.0, mu: 0.25 },
            bandwidth: 0.0,
            cutoff: Cutoff::Quartic,
            fit_radius: 2.0,
            vertex_share: 0.25,
            coarsest: 4,
            finest: 7,
            halving: true,
            alignment: Alignment::Similarity,
            minimizer: MinimizerKind::Newton,
            sobolev: 0.5,
            tolerance: 1e-5,
        }
    }
}

impl Settings {
    /// # Errors
    /// Names the first setting that is not finite or out of its range.
    pub fn validate(&self) -> Result<(), Error> {
        let at_least = |name, value: f64, least: f64| {
            check(name, value, value.is_finite() && value >= least, || format!("a number from {least} up"))
        };
        let positive = |name, value: f64| {
            check(name, value, value.is_finite() && value > 0.0, || "a number greater than 0".into())
        };
        let between = |name, value: f64, least: f64, most: f64| {
            check(name, value, (least..=most).contains(&value), || format!("a number from {least} to {most}"))
        };
        at_least("membrane", self.membrane, 0.0)?;
        at_least("bending", self.bending, 0.0)?;
        positive("thickness", self.thickness)?;
        positive("penalty", self.penalty)?;
        between("tangency", self.tangency, 0.0, 10.0)?;
        between("pinWeight", self.pin_weight, 0.0, 1e6)?;
        // Without volume energy nothing keeps the space around the shell from folding.
        positive("volume", self.volume)?;
        between("interior", self.softness, 1e-6, 1.0)?;
        positive("mu", self.material.mu)?;
        at_least("lambda", self.material.lambda, 0.0)?;
        between("bandwidth", self.bandwidth, 0.0, 1.0)?;
        between("fitRadius", self.fit_radius, 1.5, 4.0)?;
        between("vertexShare", self.vertex_share, 0.0, 1.0)?;
        between("sobolev", self.sobolev, 0.0, 10.0)?;
        between("tolerance", self.tolerance, 1e-14, 0.1)?;
        let level = |name, value: u32, least: u32| {
            check(name, f64::from(value), (least..=MOST_LEVEL).contains(&value), || {
                format!("a level from {least} to {MOST_LEVEL} (2^level cells a side)")
            })
        };
        level("coarsest", self.coarsest, LEAST_LEVEL)?;
        level("finest", self.finest, self.coarsest)
    }

    /// The functional of a level.
    pub fn functional(&self, level: u32) -> Functional {
        let finer = if self.halving { f64::from(1_u32 << (level - self.coarsest)) } else { 1.0 };
        let automatic = (1.5 / f64::from(1_u32 << self.finest)).max(0.05);
        Functional {
            membrane: self.membrane,
            bending: self.bending,
            bending_model: self.bending_model,
            thickness: self.thickness / finer,
            penalty: self.penalty * finer,
            volume: self.volume,
            softness: self.softness,
            material: self.material,
            bandwidth: if self.bandwidth > 0.0 { self.bandwidth } else { automatic },
            cutoff: self.cutoff,
            fit_radius: self.fit_radius,
            vertex_share: self.vertex_share,
        }
    }
}

fn check(name: &'static str, value: f64, fits: bool, range: impl Fn() -> String) -> Result<(), Error> {
    if fits { Ok(()) } else { Err(Error::Setting { name, value: value.to_string(), range: range() }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_valid() {
        assert_eq!(Settings::default().validate(), Ok(()));
    }

    #[test]
    fn a_setting_out_of_range_is_named_with_its_range() {
        type Spoil = fn(&mut Settings);
        let broken: [(&str, Spoil); 6] = [
            ("penalty", |s| s.penalty = -1.0),
            ("thickness", |s| s.thickness = f64::NAN),
            ("membrane", |s| s.membrane = f64::INFINITY),
            ("coarsest", |s| s.coarsest = 2),
            ("finest", |s| s.finest = 3),
            ("finest", |s| s.finest = 11),
        ];
        for (name, spoil) in broken {
            let mut settings = Settings::default();
            spoil(&mut settings);
            let message = settings.validate().unwrap_err().to_string();
            assert!(message.starts_with(name) && message.contains("must be"), "{message}");
        }
    }

    #[test]
    fn thickness_and_epsilon_are_halved_level_by_level() {
        let settings = Settings::default();
        let (coarse, fine) = (settings.functional(4), settings.functional(6));
        assert_eq!(fine.thickness * 4.0, coarse.thickness);
        assert_eq!(fine.penalty, coarse.penalty * 4.0);
        assert_eq!(fine.bandwidth, coarse.bandwidth);
    }
}
