//! Everything that can be chosen for a registration, with its range.

mod declaration;
mod kind;
mod pins;
mod reading;

pub use crate::energy::Pin;
pub use declaration::{Alignment, Backend, LEAST_LEVEL, MOST_LEVEL, MinimizerKind, PINS, SETTINGS, Settings};
pub use kind::{Group, Kind, Range, Setting, Value, Words};
pub use pins::MOST_PINS;
pub use reading::named;

use crate::energy::{Functional, Material};
use crate::error::Error;
use crate::words::number;

/// Half widths of a band, in cells of the finest level, that a registration makes sense with. Every point of a curve
/// has a quadrature point within √D √0.6 / 4 ≤ 0.34 cells, so that such a band is seen everywhere; half a cell leaves
/// that point some weight.
const LEAST_BAND: f64 = 0.5;
/// The same on levels before the finest, where the band is widened to it.
const LEAST_COARSE_BAND: f64 = 0.35;
/// Half width of the band in cells from which 2³ Gauss points find what 3³ do. Below, they mislead the search.
const WIDE_BAND: f64 = 1.5;
/// Half width of the band where none is chosen: in domain units, and in cells of the finest level.
const USUAL_BAND: (f64, f64) = (0.05, 1.5);
/// The finest level for surfaces.
const MOST_SOLID_LEVEL: u32 = 7;
/// ρ on levels before the finest, in units of the setting: a wide residual holds the shell there, and on the finest level
/// would cost accuracy.
const COARSE_TANGENCY: f64 = 4.0;

impl Settings {
    /// # Errors
    /// Names the first setting that is not finite or out of its range, or does not go with another.
    pub fn validate(&self) -> Result<(), Error> {
        for setting in SETTINGS {
            setting.check(self.get(setting))?;
        }
        let refuse = |name, value, range: String| Err(Error::Setting { name, value: number(value), range });
        if self.finest < self.coarsest {
            let range = format!("at least {}, the value of coarsest", self.coarsest);
            return refuse("finest", f64::from(self.finest), range);
        }
        if self.lambda < 2.0 * self.mu {
            let range = format!(
                "at least 2 mu = {}, or the energy falls without bound as the deformation grows; raise lambda or lower mu",
                number(2.0 * self.mu)
            );
            return refuse("lambda", self.lambda, range);
        }
        let least = LEAST_BAND / f64::from(1_u32 << self.finest);
        if self.bandwidth != 0.0 && self.bandwidth < least {
            let range = format!(
                "0 (automatic) or at least {}, half a cell of the finest grid, or no quadrature point sees the shell; widen it or raise finest",
                number(least)
            );
            return refuse("bandwidth", self.bandwidth, range);
        }
        Ok(())
    }

    /// The finest level where none is chosen, for surfaces: the next one takes ten times as long.
    pub const USUAL_SOLID_LEVEL: u32 = 5;

    /// What [`validate`](Self::validate) checks, and that the levels are some for surfaces.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    pub fn validate_for_surfaces(&self) -> Result<(), Error> {
        self.validate()?;
        if self.finest > MOST_SOLID_LEVEL {
            let range = format!(
                "at most {MOST_SOLID_LEVEL} for surfaces, {}³ nodes; each level more takes eight times the memory",
                (1_u32 << MOST_SOLID_LEVEL) + 1
            );
            return Err(Error::Setting { name: "finest", value: number(f64::from(self.finest)), range });
        }
        Ok(())
    }

    pub fn material(&self) -> Material {
        Material { lambda: self.lambda, mu: self.mu }
    }

    /// The functional of a level.
    pub fn functional(&self, level: u32) -> Functional {
        let finer = if self.halving { f64::from(1_u32 << (level - self.coarsest)) } else { 1.0 };
        let tangency = if level < self.finest { COARSE_TANGENCY * self.tangency } else { self.tangency };
        Functional {
            membrane: self.membrane,
            membrane_model: self.membrane_model,
            bending: self.bending,
            bending_model: self.bending_model,
            thickness: self.thickness / finer,
            penalty: self.penalty * finer,
            tangency: tangency / f64::from(1_u32 << level),
            volume: self.volume,
            softness: self.softness,
            material: self.material(),
            bandwidth: self.bandwidth_on(level),
            cutoff: self.cutoff,
            fit_radius: self.fit_radius,
            vertex_share: self.vertex_share,
            gauss_points: 3,
        }
    }

    /// The same with the points that suffice in D dimensions: in space two an axis where the band spans some cells.
    pub fn thrifty_functional<const D: usize>(&self, level: u32) -> Functional {
        let functional = self.functional(level);
        let is_wide = functional.bandwidth * f64::from(1_u32 << level) >= WIDE_BAND;
        Functional { gauss_points: if D == 3 && is_wide { 2 } else { 3 }, ..functional }
    }

    fn bandwidth_on(&self, level: u32) -> f64 {
        let spacing = |level: u32| 1.0 / f64::from(1_u32 << level);
        if self.bandwidth > 0.0 {
            self.bandwidth.max(LEAST_COARSE_BAND * spacing(level))
        } else {
            USUAL_BAND.0.max(USUAL_BAND.1 * spacing(self.finest))
        }
    }
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
        let broken: [(&str, Spoil); 14] = [
            ("penalty", |s| s.penalty = -1.0),
            ("penalty", |s| s.penalty = 1e308),
            ("thickness", |s| s.thickness = f64::NAN),
            ("thickness", |s| s.thickness = 1e200),
            ("membrane", |s| s.membrane = f64::INFINITY),
            ("volume", |s| s.volume = 0.0),
            ("coarsest", |s| s.coarsest = 2),
            ("finest", |s| s.finest = 3),
            ("finest", |s| s.finest = 11),
            ("lambda", |s| s.lambda = 0.49),
            ("lambda", |s| s.mu = 1.01),
            ("bandwidth", |s| s.bandwidth = 0.49 / 128.0),
            ("tangency", |s| s.tangency = -0.1),
            ("pinWeight", |s| s.pin_weight = 1e7),
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

    #[test]
    fn a_narrow_band_is_widened_where_cells_are_too_wide_to_see_it() {
        let settings = Settings { bandwidth: 0.5 / 128.0, ..Settings::default() };
        assert_eq!(settings.validate(), Ok(()));
        assert_eq!(settings.functional(7).bandwidth, 0.5 / 128.0);
        assert_eq!(settings.functional(4).bandwidth, 0.35 / 16.0);
    }
}
