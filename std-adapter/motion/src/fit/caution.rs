//! What to know before a fit is used, in words.

use super::estimate::{Fit, Uncertainty};
use super::residual_tests::ResidualTests;
use super::result::CORRELATED;
use std::fmt;

/// What makes a fit less certain than its errors say.
#[derive(Clone, Debug, PartialEq)]
pub enum Caution {
    /// The residuals are larger than the given deviations allow.
    LargeResiduals {
        /// χ² over the degrees of freedom.
        reduced_chi_squared: f64,
    },
    /// Few starts ended at the best minimum.
    FewAgree {
        /// That ended there.
        agreeing: usize,
        /// Starts.
        starts: usize,
    },
    /// The search did not converge.
    NotConverged,
    /// The data determine nothing of a parameter, or only a combination of several.
    Undetermined {
        /// Names.
        names: Vec<&'static str>,
    },
    /// A parameter is at an end of its range.
    AtBound {
        /// Name.
        name: &'static str,
        /// Value.
        value: f64,
    },
    /// Two parameters can hardly be told apart.
    Entangled {
        /// Names.
        names: [&'static str; 2],
        /// Their correlation.
        correlation: f64,
    },
    /// Residuals follow each other: errors are enlarged.
    Correlated {
        /// Factor of the errors.
        factor: f64,
        /// Over so many points.
        points: f64,
    },
    /// Residuals hold a constant force.
    Offset {
        /// In the unit of friction.
        value: f64,
    },
    /// An offset is fitted to data of one direction.
    OneWay,
    /// Residuals follow the acceleration.
    Inertia {
        /// Force over acceleration.
        value: f64,
    },
    /// Residuals of steady sliding follow each other over the velocity.
    Curved,
    /// Residuals drift with time.
    Drift {
        /// From the first to the last point, in the unit of friction.
        change: f64,
    },
    /// Outliers among the residuals.
    Outliers {
        /// Number.
        count: usize,
    },
    /// More steps between the points would still change a parameter.
    Steps {
        /// Name.
        name: &'static str,
        /// Change.
        change: f64,
        /// Change over the standard error.
        errors: f64,
    },
    /// A spring between the load point and the contact explains the record better.
    LoadPoint {
        /// Its stiffness per load, in 1/m.
        spring: f64,
        /// Deviations of the residuals without it and with it.
        deviations: [f64; 2],
    },
    /// Another course of the velocity between the points would change a parameter: the record is too coarse.
    Course {
        /// Name.
        name: &'static str,
        /// Change.
        change: f64,
        /// Change over the standard error.
        errors: f64,
    },
}

impl fmt::Display for Caution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LargeResiduals { .. } => {
                write!(
                    f,
                    "residuals are larger than sigma allows: the law or sigma is wrong"
                )
            }
            Self::FewAgree { agreeing, starts } => write!(
                f,
                "only {agreeing} of {starts} starts ended at the best minimum; try more --starts, or --fix a \
                 parameter"
            ),
            Self::NotConverged => {
                write!(f, "the search did not converge: standard errors are rough")
            }
            Self::Undetermined { names } => match names.as_slice() {
                [name] => write!(
                    f,
                    "the data do not determine {name}; give --fix {name}=VALUE"
                ),
                names => write!(
                    f,
                    "the data determine only a combination of {}; give --fix NAME=VALUE for one",
                    names.join(" and ")
                ),
            },
            Self::AtBound { name, value } => write!(
                f,
                "{name} is at the end of its range, {value:.4e}: the data ask for no more of it, or for another \
                 law"
            ),
            Self::Entangled {
                names: [a, b],
                correlation,
            } => write!(
                f,
                "correlation of {a} and {b} is {correlation:.4}: the data hardly tell these apart; fix one"
            ),
            Self::Correlated { factor, points } => write!(
                f,
                "residuals follow each other over some {points:.0} points: the law lacks something or the noise is filtered; \
                 errors are enlarged {factor:.1} times for it"
            ),
            Self::Offset { value } => write!(
                f,
                "the directions differ: residuals hold a constant {value:.3e}; fit it by --offset"
            ),
            Self::OneWay => write!(
                f,
                "the data move in one direction: an offset cannot be told from dry friction there; leave --offset out"
            ),
            Self::Inertia { value } => write!(
                f,
                "residuals follow the acceleration, as an inertia of {value:.3e} would; fit it by --inertia"
            ),
            Self::Curved => write!(
                f,
                "residuals follow each other over the velocity: another curve fits better; try --law all"
            ),
            Self::Drift { change } => write!(
                f,
                "residuals drift by {change:.3e} from the first to the last point: running-in, temperature or a \
                 sensor's zero; take the settled part with --skip"
            ),
            Self::Outliers { count } => write!(
                f,
                "residuals more than five deviations away: {count}; look at residuals.csv"
            ),
            Self::Steps {
                name,
                change,
                errors,
            } => write!(
                f,
                "more steps between the points would still change {name} by {change:.2e} ({errors:.1} standard \
                 errors): sample more often"
            ),
            Self::LoadPoint {
                spring,
                deviations: [without, with],
            } => write!(
                f,
                "v looks like the speed of the load point: with a spring of {spring:.4e} 1/m residuals fall from \
                 {without:.2e} to {with:.2e}; a, b and dc above are those of the machine too: give --spring K or --spring fit"
            ),
            Self::Course {
                name,
                change,
                errors,
            } => write!(
                f,
                "the points are too far apart to tell the velocity between them: another course may change {name} by \
                 {change:.2e} ({errors:.1} standard errors); sample more often"
            ),
        }
    }
}

/// Correlation beyond which two parameters are hardly told apart.
const ENTANGLED: f64 = 0.99;
/// Standard deviations, of its own, by which a reduced χ² may exceed 1.
const BEYOND: f64 = 5.0;
/// Starts that should agree.
const ENOUGH: usize = 3;
/// Probability of a drift by chance, below which it is told.
const DRIFT: f64 = 1e-4;
/// Drift over the deviation of the residuals, below which it does not matter.
const SMALL_DRIFT: f64 = 0.3;

/// A parameter's name, and the change that a path makes of it, also in standard errors.
pub(super) type NamedShift = (&'static str, f64, f64);

/// All of a fit; `by_path` are changes by more steps and by another course between the points.
pub(super) fn cautions(
    fit: &Fit,
    tests: Option<&ResidualTests>,
    by_path: [Option<NamedShift>; 2],
) -> Vec<Caution> {
    let mut all = Vec::new();
    let reduced_chi_squared = fit.deviation * fit.deviation;
    let scatter = (2.0 / fit.freedoms as f64).sqrt();
    if fit.is_weighted && reduced_chi_squared > 1.0 + BEYOND * scatter {
        all.push(Caution::LargeResiduals {
            reduced_chi_squared,
        });
    }
    if fit.at_best < ENOUGH.min(fit.starts) {
        all.push(Caution::FewAgree {
            agreeing: fit.at_best,
            starts: fit.starts,
        });
    }
    if !fit.converged {
        all.push(Caution::NotConverged);
    }
    let [steps, course] = by_path;
    all.extend(steps.map(|(name, change, errors)| Caution::Steps {
        name,
        change,
        errors,
    }));
    all.extend(course.map(|(name, change, errors)| Caution::Course {
        name,
        change,
        errors,
    }));
    undetermined(fit, &mut all);
    entangled(fit, &mut all);
    if let Some(tests) = tests {
        of_residuals(fit, tests, &mut all);
    }
    all
}

fn undetermined(fit: &Fit, all: &mut Vec<Caution>) {
    for estimate in &fit.parameters {
        let name = estimate.parameter.name;
        match &estimate.known {
            Uncertainty::Undetermined(others) => {
                let mut names = others.clone();
                names.push(name);
                names.sort_unstable();
                names.dedup();
                let caution = Caution::Undetermined { names };
                if !all.contains(&caution) {
                    all.push(caution);
                }
            }
            Uncertainty::AtBound if estimate.value != 0.0 => all.push(Caution::AtBound {
                name,
                value: estimate.value,
            }),
            _ => {}
        }
    }
}

/// Pairs that the data hardly tell apart.
fn entangled(fit: &Fit, all: &mut Vec<Caution>) {
    let names: Vec<&'static str> = fit.determined().map(|e| e.parameter.name).collect();
    for b in 0..names.len() {
        for a in 0..b {
            let correlation = fit.correlation(a, b);
            if correlation.abs() > ENTANGLED {
                all.push(Caution::Entangled {
                    names: [names[a], names[b]],
                    correlation,
                });
            }
        }
    }
}

fn of_residuals(fit: &Fit, tests: &ResidualTests, all: &mut Vec<Caution>) {
    if tests.runs_p < CORRELATED {
        all.push(Caution::Correlated {
            factor: tests.error_factor,
            points: (2.0 * tests.correlation_time).ceil(),
        });
    }
    // The tests saw residuals in another unit: only ratios count.
    let rows = fit.predictions.len() as f64;
    let change = tests.drift * rows / tests.robust_deviation;
    if tests.drift_p < DRIFT && change.abs() > SMALL_DRIFT {
        all.push(Caution::Drift {
            change: change * fit.deviation,
        });
    }
    if tests.outliers > 0 {
        all.push(Caution::Outliers {
            count: tests.outliers,
        });
    }
}
