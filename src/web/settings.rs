//! Settings from JavaScript.

use crate::energy::{BendingModel, Cutoff, Material, MembraneModel};
use crate::error::Error;
use crate::settings::{Alignment, MinimizerKind, Settings as Chosen};
use js_sys::{Object, Reflect};
use serde::Deserialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// Every field optional; lengths in domain units.
#[derive(Deserialize, Tsify)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct Settings {
    /// α_mem.
    membrane: f64,
    #[tsify(type = "\"intrinsic\" | \"projected\"")]
    membrane_model: Membrane,
    /// α_bend.
    bending: f64,
    #[tsify(type = "\"shape-operator\" | \"mean-curvature\"")]
    bending_model: Bending,
    /// δ on the coarsest level.
    thickness: f64,
    /// 1/ε on the coarsest level.
    penalty: f64,
    /// ρ of the H¹ residual, in cells of a level; 0 is the paper.
    tangency: f64,
    /// In units of the penalty; 0 ignores the pins.
    pin_weight: f64,
    /// ξ.
    volume: f64,
    /// ζ, softness outside the reference.
    interior: f64,
    lambda: f64,
    mu: f64,
    /// σ; 0 is automatic.
    bandwidth: f64,
    #[tsify(type = "\"quartic\" | \"cosine\" | \"bump\"")]
    cutoff: Profile,
    /// r in cells.
    fit_radius: f64,
    /// θ.
    vertex_share: f64,
    /// First level l: (2^l + 1)^D nodes.
    coarsest: f64,
    /// Last level.
    finest: f64,
    /// Halve δ and ε from level to level.
    halving: bool,
    #[tsify(type = "\"none\" | \"similarity\"")]
    align: Align,
    #[tsify(type = "\"newton\" | \"ncg\"")]
    minimizer: Minimizer,
    /// β_max of the Sobolev metric ("ncg" only).
    sobolev: f64,
    /// Relative decrease of the energy at which a level ends.
    tolerance: f64,
    #[tsify(type = "\"cpu\" | \"auto\"")]
    backend: Backend,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Membrane {
    Intrinsic,
    Projected,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Bending {
    ShapeOperator,
    MeanCurvature,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Profile {
    Quartic,
    Cosine,
    Bump,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Align {
    None,
    Similarity,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Minimizer {
    Newton,
    Ncg,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Backend {
    Cpu,
    Auto,
}

impl Default for Settings {
    fn default() -> Self {
        let chosen = Chosen::default();
        Self {
            membrane: chosen.membrane,
            membrane_model: match chosen.membrane_model {
                MembraneModel::Intrinsic => Membrane::Intrinsic,
                MembraneModel::Projected => Membrane::Projected,
            },
            bending: chosen.bending,
            bending_model: match chosen.bending_model {
                BendingModel::ShapeOperator => Bending::ShapeOperator,
                BendingModel::MeanCurvature => Bending::MeanCurvature,
            },
            thickness: chosen.thickness,
            penalty: chosen.penalty,
            tangency: chosen.tangency,
            pin_weight: chosen.pin_weight,
            volume: chosen.volume,
            interior: chosen.softness,
            lambda: chosen.material.lambda,
            mu: chosen.material.mu,
            bandwidth: chosen.bandwidth,
            cutoff: match chosen.cutoff {
                Cutoff::Quartic => Profile::Quartic,
                Cutoff::Cosine => Profile::Cosine,
                Cutoff::Bump => Profile::Bump,
            },
            fit_radius: chosen.fit_radius,
            vertex_share: chosen.vertex_share,
            coarsest: f64::from(chosen.coarsest),
            finest: f64::from(chosen.finest),
            halving: chosen.halving,
            align: match chosen.alignment {
                Alignment::None => Align::None,
                Alignment::Similarity => Align::Similarity,
            },
            minimizer: match chosen.minimizer {
                MinimizerKind::Newton => Minimizer::Newton,
                MinimizerKind::Ncg => Minimizer::Ncg,
            },
            sobolev: chosen.sobolev,
            tolerance: chosen.tolerance,
            backend: Backend::Auto,
        }
    }
}

impl Settings {
    pub(super) fn chosen(self) -> Result<Chosen, Error> {
        // One CPU backend serves both names for now.
        let (Backend::Cpu | Backend::Auto) = self.backend;
        let settings = Chosen {
            membrane: self.membrane,
            membrane_model: match self.membrane_model {
                Membrane::Intrinsic => MembraneModel::Intrinsic,
                Membrane::Projected => MembraneModel::Projected,
            },
            bending: self.bending,
            bending_model: match self.bending_model {
                Bending::ShapeOperator => BendingModel::ShapeOperator,
                Bending::MeanCurvature => BendingModel::MeanCurvature,
            },
            thickness: self.thickness,
            penalty: self.penalty,
            tangency: self.tangency,
            pin_weight: self.pin_weight,
            volume: self.volume,
            softness: self.interior,
            material: Material { lambda: self.lambda, mu: self.mu },
            bandwidth: self.bandwidth,
            cutoff: match self.cutoff {
                Profile::Quartic => Cutoff::Quartic,
                Profile::Cosine => Cutoff::Cosine,
                Profile::Bump => Cutoff::Bump,
            },
            fit_radius: self.fit_radius,
            vertex_share: self.vertex_share,
            coarsest: level("coarsest", self.coarsest)?,
            finest: level("finest", self.finest)?,
            halving: self.halving,
            alignment: match self.align {
                Align::None => Alignment::None,
                Align::Similarity => Alignment::Similarity,
            },
            minimizer: match self.minimizer {
                Minimizer::Newton => MinimizerKind::Newton,
                Minimizer::Ncg => MinimizerKind::Ncg,
            },
            sobolev: self.sobolev,
            tolerance: self.tolerance,
        };
        settings.validate()?;
        Ok(settings)
    }
}

fn level(name: &'static str, value: f64) -> Result<u32, Error> {
    if (0.0..=30.0).contains(&value) && value.fract() == 0.0 {
        Ok(value as u32)
    } else {
        Err(Error::Setting { name, value: value.to_string(), range: "a whole number of halvings of the box".into() })
    }
}

/// The fields of both; where both have one, the change's.
pub(super) fn merged(settings: &Object, change: JsValue) -> Result<Object, JsError> {
    let fresh = Object::assign(&Object::new(), settings);
    if change.is_undefined() || change.is_null() {
        return Ok(fresh);
    }
    let Ok(change) = change.dyn_into::<Object>() else {
        return Err(JsError::new("the settings must be an object, every field optional"));
    };
    let fresh = Object::assign(&fresh, &change);
    for key in Object::keys(&fresh).iter() {
        // A field set to undefined is one left out.
        if Reflect::get(&fresh, &key).is_ok_and(|value| value.is_undefined()) {
            let _ = Reflect::delete_property(&fresh, &key);
        }
    }
    Ok(fresh)
}

pub(super) fn read_settings(settings: &Object) -> Result<Settings, JsError> {
    let deserializer = serde_wasm_bindgen::Deserializer::from(JsValue::from(settings));
    serde_path_to_error::deserialize(deserializer).map_err(|error| {
        let name = error.path().to_string();
        let problem = error.into_inner();
        JsError::new(&if name == "." { format!("settings: {problem}") } else { format!("{name}: {problem}") })
    })
}
