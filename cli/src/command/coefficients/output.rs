//! Coefficients and their errors as text, JSON and CSV.

use super::engines::{ENGINES, Engine, Value};
use super::torsion::{Fit, MODELS, Model, Torsion};
use crate::command::digits::shown;
use serde_json::{Value as Json, json};
use std::fmt::Write;
use tribos::record::{json_number, number};

/// Ratios of spin·R to speed in the table of errors.
const RATIOS: [f64; 5] = [0.1, 0.3, 1.0, 3.0, 10.0];
/// Per cent of a share.
const PER_CENT: f64 = 100.0;

/// Both fits of a model.
struct Fits {
    model: Model,
    exact: Fit,
    least: Fit,
}

/// A patch in all engines.
pub struct Report<'a> {
    torsion: &'a Torsion,
    mu: f64,
    fits: Vec<Fits>,
}

impl<'a> Report<'a> {
    /// Fits all models.
    pub fn new(torsion: &'a Torsion, mu: f64) -> Self {
        let fits = |model| Fits {
            model,
            exact: torsion.exact_at_spin(model),
            least: torsion.least_error(model),
        };
        Self {
            torsion,
            mu,
            fits: MODELS.into_iter().map(fits).collect(),
        }
    }

    /// Both values of an engine's parameter with their errors; nothing where it has none.
    fn values(&self, engine: &Engine) -> Option<[(f64, f64); 2]> {
        let fits = self
            .fits
            .iter()
            .find(|fits| Some(fits.model) == engine.model)?;
        let of = |fit: Fit| {
            engine
                .value
                .of(self.mu, fit.length)
                .map(|value| (value, fit.error))
        };
        Some([of(fits.exact)?, of(fits.least)?])
    }

    /// For people.
    pub fn text(&self) -> String {
        let (arm, radius) = (self.torsion.arm, self.torsion.radius);
        let mut text = format!(
            "T0/(mu N)   {} m, spinning about the centre of pressure\n\
             R           {} m, the farthest point from it\n\
             rolling     0 in every engine: dry friction on a flat patch resists no rolling\n\
             for         one contact point; a geometry that touches at several resists turning beside it\n\
             error       largest error of the torque beside sliding, as a share of T0\n\n",
            shown(arm),
            shown(radius)
        );
        let line = |cells: [&str; 6]| {
            let [name, parameter, exact, error, least, left] = cells;
            let line =
                format!("{name:<8} {parameter:<50} {exact:>11} {error:>7} {least:>11} {left:>7}");
            line.trim_end().to_owned() + "\n"
        };
        text += &line([
            "engine",
            "parameter",
            "at spin [m]",
            "error",
            "least [m]",
            "error",
        ]);
        for engine in &ENGINES {
            let cells = self.values(engine).map_or_else(
                || ["-".to_owned(), String::new(), "-".to_owned(), String::new()],
                |[exact, least]| {
                    [
                        shown(exact.0),
                        share(exact.1),
                        shown(least.0),
                        share(least.1),
                    ]
                },
            );
            let [exact, error, least, left] = &cells;
            text += &line([engine.name, engine.parameter, exact, error, least, left]);
        }
        text + "\n" + &self.errors_text()
    }

    /// Errors of the torque by the ratio of spin to speed.
    fn errors_text(&self) -> String {
        let mut text = format!("{:<14} {:>9}", "error of torque", "exact");
        for fits in &self.fits {
            let _ = write!(text, "   {:>15}", fits.model.name());
        }
        let _ = write!(text, "\n{:<15} {:>8}", "spin R/speed", "of T0");
        for _ in &self.fits {
            let _ = write!(text, "   {:>7} {:>7}", "at spin", "least");
        }
        text.push('\n');
        for ratio in RATIOS {
            let exact = PER_CENT * self.torsion.share_at(ratio);
            let _ = write!(text, "{ratio:<15} {exact:>6.1} %");
            for fits in &self.fits {
                let of = |fit: Fit| {
                    PER_CENT * self.torsion.error_at(fits.model, fit.length, ratio) + 0.0
                };
                let _ = write!(
                    text,
                    "   {:>+6.1}% {:>+6.1}%",
                    of(fits.exact),
                    of(fits.least)
                );
            }
            text.push('\n');
        }
        text
    }

    /// One object.
    pub fn json(&self) -> Json {
        let engines: Vec<Json> = ENGINES
            .iter()
            .map(|engine| self.engine_json(engine))
            .collect();
        let errors: Vec<Json> = RATIOS
            .iter()
            .map(|ratio| self.errors_json(*ratio))
            .collect();
        json!({
            "arm": json_number(self.torsion.arm),
            "radius": json_number(self.torsion.radius),
            "mu": json_number(self.mu),
            "rolling": 0.0,
            "engines": engines,
            "errors": errors,
        })
    }

    fn engine_json(&self, engine: &Engine) -> Json {
        let mut object = json!({
            "engine": engine.name,
            "parameter": engine.parameter,
            "model": engine.model.map(Model::name),
        });
        for (name, value) in ["at_spin", "least_error"]
            .into_iter()
            .zip(self.values(engine).into_iter().flatten())
        {
            object[name] =
                json!({"value": json_number(value.0), "largest_error": json_number(value.1)});
        }
        object
    }

    fn errors_json(&self, ratio: f64) -> Json {
        let mut object = json!({
            "spin_radius_over_speed": json_number(ratio),
            "exact": json_number(self.torsion.share_at(ratio)),
        });
        for fits in &self.fits {
            let of = |fit: Fit| json_number(self.torsion.error_at(fits.model, fit.length, ratio));
            object[fits.model.name()] =
                json!({"at_spin": of(fits.exact), "least_error": of(fits.least)});
        }
        object
    }

    /// A line for each engine.
    pub fn csv(&self) -> String {
        let mut text =
            "engine,parameter,model,at_spin,at_spin_error,least,least_error\n".to_owned();
        for engine in &ENGINES {
            let model = engine.model.map_or("", Model::name);
            let cells = self.values(engine).map_or_else(
                || ",,,".to_owned(),
                |values| {
                    values
                        .map(|(value, error)| number(value) + "," + &number(error))
                        .join(",")
                },
            );
            let _ = writeln!(
                text,
                "{},\"{}\",{model},{cells}",
                engine.name, engine.parameter
            );
        }
        text
    }
}

/// A share in per cent.
fn share(of: f64) -> String {
    format!("{:.1} %", PER_CENT * of)
}

/// What the table of patches has of one: T₀/(μN), the radius of Gazebo's patch, and the best length of an ellipsoid with its error.
fn row(torsion: &Torsion) -> [f64; 4] {
    let least = torsion.least_error(Model::Ellipsoid);
    let radius = Value::PatchRadius.of(1.0, torsion.arm).unwrap_or(f64::NAN);
    [torsion.arm, radius, least.length, least.error]
}

/// The table of patches for people.
pub fn patches_text(rows: &[(&str, Torsion)]) -> String {
    let mut text = format!(
        "{:<12} {:>13} {:>16} {:>14} {:>7}\n",
        "patch", "T0/(mu N) [m]", "patch_radius [m]", "ellipsoid [m]", "error"
    );
    for (name, torsion) in rows {
        let [arm, radius, length, error] = row(torsion);
        let _ = writeln!(
            text,
            "{name:<12} {:>13} {:>16} {:>14} {:>7}",
            shown(arm),
            shown(radius),
            shown(length),
            share(error)
        );
    }
    text
}

/// The same as an array.
pub fn patches_json(rows: &[(&str, Torsion)]) -> Json {
    let object = |(name, torsion): &(&str, Torsion)| {
        let [arm, radius, length, error] = row(torsion).map(json_number);
        json!({"patch": name, "arm": arm, "patch_radius": radius, "ellipsoid": length, "error": error})
    };
    rows.iter().map(object).collect()
}

/// The same as a table.
pub fn patches_csv(rows: &[(&str, Torsion)]) -> String {
    let mut text = "patch,arm,patch_radius,ellipsoid,error\n".to_owned();
    for (name, torsion) in rows {
        let _ = writeln!(text, "{name},{}", row(torsion).map(number).join(","));
    }
    text
}
