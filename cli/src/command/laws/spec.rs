//! A law on the command line, `NAME:key=value,…`.

use super::catalogue::{self, Entry, LAWS};
use crate::command::number::in_range;
use crate::command::unknown::unknown;
use crate::failure::Failure;
use std::fmt::Write as _;
use std::str::FromStr;
use tribos::scene::nearest;
use tribos_core::Real;
use tribos_core::law::{
    CoulombLaw, DryFriction, LawError, LocalLaw, LuGre, LuGreParameters, PlateauPower,
    PlateauPowerParameters, PowerLaw, RateState, RateStateParameters, Stribeck, StribeckParameters,
};

/// A local law with a value for each of its parameters.
#[derive(Clone, Debug)]
pub struct LawSpec {
    entry: &'static Entry,
    values: Vec<f64>,
}

impl FromStr for LawSpec {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, list) = text.split_once(':').unwrap_or((text, ""));
        let entry = catalogue::find(name.trim()).ok_or_else(|| {
            let local = LAWS.iter().filter(|law| law.is_local);
            let names = local.map(|law| law.name);
            unknown(&format!("unknown local law `{name}`"), name, names)
        })?;
        if !entry.is_local {
            return Err(format!(
                "`{name}` is not a law of the local speed; `tribos laws` says which are"
            ));
        }
        Ok(Self {
            entry,
            values: values(entry, list)?,
        })
    }
}

/// One value a parameter, in their order.
fn values(entry: &Entry, list: &str) -> Result<Vec<f64>, String> {
    let mut given: Vec<Option<f64>> = vec![None; entry.parameters.len()];
    for item in list.split(',').filter(|item| !item.trim().is_empty()) {
        let (key, value) = item
            .split_once('=')
            .ok_or_else(|| format!("`{item}` is not of the form key=value"))?;
        let index = entry
            .parameters
            .iter()
            .position(|parameter| parameter.name == key.trim())
            .ok_or_else(|| {
                let names = entry.parameters.iter().map(|parameter| parameter.name);
                let meant = nearest(key.trim(), names)
                    .map_or(String::new(), |near| format!(", did you mean `{near}`?"));
                format!(
                    "{} has no `{}`{meant}; {}",
                    entry.name,
                    key.trim(),
                    needs(entry)
                )
            })?;
        let number = crate::command::number::finite(value)
            .map_err(|cure| format!("{}: {cure}", key.trim()))?;
        if let Some(slot) = given.get_mut(index)
            && slot.replace(number).is_some()
        {
            return Err(format!("`{}` is given twice", key.trim()));
        }
    }
    let filled = given.into_iter().zip(entry.parameters);
    filled
        .map(|(value, parameter)| {
            value
                .or(parameter.default)
                .ok_or_else(|| format!("`{}` is missing; {}", parameter.name, needs(entry)))
        })
        .collect()
}

/// "stribeck needs mu_s, mu_d, vs [m/s] and may have delta, k [s/m]".
fn needs(entry: &Entry) -> String {
    let list = |optional: bool| -> Vec<String> {
        let chosen = entry.parameters.iter();
        chosen
            .filter(|parameter| parameter.default.is_some() == optional)
            .map(|parameter| match parameter.unit {
                "-" => parameter.name.to_owned(),
                unit => format!("{} [{unit}]", parameter.name),
            })
            .collect()
    };
    let mut text = format!("{} needs {}", entry.name, list(false).join(", "));
    if !list(true).is_empty() {
        let _ = write!(text, " and may have {}", list(true).join(", "));
    }
    text
}

/// Any local law.
pub struct AnyLaw<R>(pub Box<dyn LocalLaw<R>>);

impl<R: Real> LocalLaw<R> for AnyLaw<R> {
    fn friction(&self, speed: R) -> R {
        self.0.friction(speed)
    }
    fn slope(&self, speed: R) -> R {
        self.0.slope(speed)
    }
}

impl LawSpec {
    /// Coefficient and exponent of a law that is a power of the speed.
    pub fn power(&self) -> Option<[f64; 2]> {
        match (self.entry.name, self.values.as_slice()) {
            ("coulomb", &[mu]) => Some([mu, 0.0]),
            ("power", &[gamma, alpha]) => Some([gamma, alpha]),
            _ => None,
        }
    }

    /// The law itself.
    pub fn law<R: Real>(&self) -> Result<AnyLaw<R>, Failure> {
        for (parameter, &x) in self.entry.parameters.iter().zip(&self.values) {
            in_range::<R>(parameter.name, x)?;
        }
        self.build().map(AnyLaw).map_err(|error| {
            Failure::input(format!(
                "{}: {error}; {}",
                self.entry.name,
                needs(self.entry)
            ))
        })
    }

    /// Its name and values.
    pub fn describe(&self) -> String {
        let parameters = self.entry.parameters.iter().zip(&self.values);
        let list: Vec<String> = parameters
            .map(|(parameter, value)| format!("{}={value}", parameter.name))
            .collect();
        format!("{}:{}", self.entry.name, list.join(","))
    }

    fn build<R: Real>(&self) -> Result<Box<dyn LocalLaw<R>>, LawError> {
        let values: Vec<R> = self.values.iter().map(|&x| R::from_f64(x)).collect();
        Ok(match (self.entry.name, values.as_slice()) {
            ("coulomb", &[mu]) => Box::new(CoulombLaw::new(mu)?),
            ("dry", &[mu_s, mu_d]) => Box::new(DryFriction::new(mu_s, mu_d)?),
            ("power", &[gamma, alpha]) => Box::new(PowerLaw::new(alpha, gamma)?),
            ("plateau", &[gamma, alpha, vp, vd, r]) => {
                Box::new(PlateauPower::new(PlateauPowerParameters {
                    alpha,
                    coefficient: gamma,
                    plateau_speed: vp,
                    drop_speed: vd,
                    rest_share: r,
                })?)
            }
            ("stribeck", &[mu_s, mu_d, vs, delta, k]) => {
                Box::new(Stribeck::new(StribeckParameters {
                    dry: DryFriction::new(mu_s, mu_d)?,
                    speed: vs,
                    exponent: delta,
                    viscous: k,
                })?)
            }
            ("rate-state", &[mu, a, b, reference_speed, slip_distance, viscous]) => {
                let parameters = RateStateParameters {
                    mu,
                    a,
                    b,
                    reference_speed,
                    slip_distance,
                    viscous,
                };
                Box::new(RateState::<R>::new(parameters)?.steady())
            }
            (
                "lugre",
                &[
                    coulomb_force,
                    static_force,
                    stribeck_speed,
                    viscous_damping,
                    load,
                ],
            ) => {
                let parameters = LuGreParameters {
                    coulomb_force,
                    static_force,
                    stribeck_speed,
                    viscous_damping,
                    // Steady sliding does not feel the bristles.
                    stiffness: R::ONE,
                    bristle_damping: R::ONE,
                };
                Box::new(LuGre::new(parameters)?.steady_per_load(load)?)
            }
            _ => unreachable!("every local law of the catalogue has a constructor"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_local_law_can_be_made() {
        for entry in LAWS.iter().filter(|law| law.is_local) {
            let list: Vec<String> = entry
                .parameters
                .iter()
                .map(|parameter| {
                    // Exponents that fall must be negative; the rest may be a half.
                    let value = if parameter.name == "alpha" { -0.5 } else { 0.5 };
                    format!("{}={value}", parameter.name)
                })
                .collect();
            let spec: LawSpec = format!("{}:{}", entry.name, list.join(","))
                .parse()
                .unwrap();
            assert!(
                spec.law::<f64>().unwrap().friction(1.0) > 0.0,
                "{}",
                entry.name
            );
            assert!(
                spec.law::<f32>().unwrap().friction(1.0) > 0.0,
                "{}",
                entry.name
            );
        }
    }

    #[test]
    fn refusals_name_the_cure() {
        let refused = |text: &str| text.parse::<LawSpec>().unwrap_err();
        assert!(refused("strybeck").contains("stribeck"));
        assert!(refused("stribeck:mu_s=1").contains("`mu_d` is missing"));
        assert!(refused("coulomb:mu=1,nu=2").contains("no `nu`"));
        assert!(refused("coulomb:mu=1,mu=2").contains("twice"));
        assert!(refused("coulomb:mu=high").contains("number"));
        assert!(refused("stokes:eta=1,r=1").contains("not a law of the local speed"));
    }
}
