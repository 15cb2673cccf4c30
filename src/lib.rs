//! Elastic registration of shapes by thin shell energies.
//!
//! Two closed curves or surfaces in the unit box Ω = `[0,1]^D`, D = 2 or 3, are given by their signed distances d1
//! (reference) and d2 (template), positive outside. Sought is the deformation φ: Ω → R^D that minimises
//!
//! ```text
//! E[φ] = ∫ η(d1/σ) [ α_mem δ W_mem + α_bend δ³ |S_rel|² + 1/ε ((d2∘φ − d1)² + ρ² W_tan) ] dx
//!      + ξ ∫ (ζ + (1−ζ) χ_{d1<0}) W_vol dx
//! ```
//!
//! | symbol | meaning | where |
//! |---|---|---|
//! | φ = x + u | deformation; u, D numbers a node, is what is stored | [`assemble`] |
//! | n, t | unit normal and tangents of the level set of d1 | [`small::frame`] |
//! | W_mem(A_tg), A_tg = D_tgφᵀ D_tgφ | membrane, of the tangential Cauchy–Green strain | [`energy::Membrane`] |
//! | S_rel = D_tgφᵀ D²d2(φ) D_tgφ − D²d1 | relative shape operator | [`energy::Bending`] |
//! | (d2∘φ − d1)² | mismatch | [`energy::Mismatch`] |
//! | W_tan = |∇(d2∘φ − d1)|² | H¹ residual of the mismatch, in the length ρ | [`energy::Tangency`] |
//! | W_vol(DφᵀDφ) | volume | [`energy::Volume`] |
//! | η, σ | profile and half width of the band | [`energy::Cutoff`] |
//! | α, δ, 1/ε, ξ, ζ, θ | weights, thickness, penalty, softness outside, vertex share | [`settings::Settings`] |
//!
//! Conventions: lengths are in units of the box; nodes and cells are numbered x fastest; φ is multilinear on a grid of
//! 2^l cells a side with all nodes free; a deformation is admissible if det Dφ > 0 in all cells: for D = 2 at all corners, for
//! D = 3 by its Bernstein coefficients.
//!
//! Source: J. A. Iglesias, B. Berkels, M. Rumpf, O. Scherzer, "A Thin Shell Approach to the Registration of Implicit
//! Surfaces", Vision, Modeling and Visualization 2013; equation numbers in this crate are the paper's.
//!
//! Modules, each using only those before it: [`error`], [`ready`], [`small`], [`grid`], [`contour`], [`quadrature`],
//! [`field`], [`hypersurface`], [`distance`], [`energy`], [`stencil`], [`assemble`], [`metric`], [`multigrid`],
//! [`minimize`], [`prolongation`], [`inverse`], [`align`], [`settings`], [`cascade`], [`report`], [`search`]; [`surface`],
//! [`narrow`] and [`verdict`] look at shapes and results, [`shape`] takes input. Two types go the other way: the assembly
//! names the settings' `Backend` and, on a graphics card, the multigrid's `Solve`.
//!
//! ```
//! use thinshell::{search::Search, ready::ready, settings::Settings, shape::Shape};
//! use glam::DVec2;
//!
//! let loop_of = |a: f64, b: f64| -> Vec<DVec2> {
//!     let angles = (0..100).map(|k| f64::from(k) * std::f64::consts::TAU / 100.0);
//!     angles.map(|t| DVec2::new(0.5 + a * t.cos(), 0.5 + b * t.sin())).collect()
//! };
//! let settings = Settings { finest: 5, ..Settings::default() };
//! let reference = Shape::Curves(vec![loop_of(0.2, 0.2)]).distance(settings.finest)?;
//! let template = Shape::Curves(vec![loop_of(0.3, 0.2)]).distance(settings.finest)?;
//! let mut search = ready(Search::new(reference, template, settings))?;
//! let end = loop {
//!     let progress = ready(search.step());
//!     if progress.stop.is_some() {
//!         break progress;
//!     }
//! };
//! assert!(end.evaluation.least_determinant > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod align;
pub mod assemble;
pub mod cascade;
pub mod contour;
pub mod distance;
pub mod energy;
pub mod error;
pub mod field;
mod fourier;
pub mod grid;
pub mod hypersurface;
pub mod inverse;
pub mod metric;
pub mod minimize;
pub mod multigrid;
pub mod narrow;
mod numbers;
mod order;
pub mod prolongation;
pub mod quadrature;
pub mod ready;
pub mod report;
pub mod search;
pub mod settings;
pub mod shape;
pub mod small;
pub mod stencil;
pub mod surface;
pub mod verdict;
#[cfg(target_arch = "wasm32")]
mod web;
mod words;
