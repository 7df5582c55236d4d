//! What columns of a log may mean.

use crate::record::heading::{Heading, plain_name};
use crate::record::units::{Dimension, any_unit};

/// A quantity that a log is asked for.
#[derive(Clone, Copy, Debug)]
pub struct LogRole {
    /// Its short name, such as v.
    pub name: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// What it may measure; numbers without a unit are of the first.
    pub dimensions: &'static [Dimension],
    /// Whether a log without it is refused.
    pub is_needed: bool,
    /// Names in the logs of others between blanks, in small letters and digits alone; those with capitals count with these.
    /// Names of an earlier text are preferred to those of a later one.
    pub synonyms: &'static [&'static str],
}

impl LogRole {
    /// Time, in s.
    pub const TIME: Self = Self::optional(
        "t",
        "time",
        &[Dimension::Time],
        &[
            "time zeit timestamp zeitstempel elapsedtime testtime runtime messzeit laufzeit \
                 versuchszeit timestamps temps tempo",
        ],
    );
    /// Sliding velocity, in m/s or rad/s.
    pub const VELOCITY: Self = Self::optional(
        "v",
        "sliding velocity",
        &[Dimension::Speed, Dimension::Rotation],
        &[
            "velocity speed slidingvelocity slidingspeed slipvelocity sliprate \
                 geschwindigkeit gleitgeschwindigkeit relativgeschwindigkeit relativevelocity vel \
                 velocities linearspeed vitesse",
            "jointvelocity angularvelocity angularspeed winkelgeschwindigkeit omega ω qd dq qdot \
                 rpm drehzahl rotationalspeed motorspeed rotationspeed xdot vx jointspeed",
        ],
    );
    /// Friction: a coefficient, a force in N or a torque in N m.
    pub const FRICTION: Self = Self::optional(
        "f",
        "friction",
        &[
            Dimension::Ratio,
            Dimension::Force,
            Dimension::Torque,
            Dimension::Electric,
        ],
        &[
            "friction frictioncoefficient coefficientoffriction cof mu µ frictionforce \
                 frictiontorque reibung reibwert reibungszahl reibzahl reibungskoeffizient \
                 reibkoeffizient reibkraft reibungskraft reibmoment reibungsmoment frictioncoeff \
                 coeffriction coefoffriction frictioncoef frottement",
            "force kraft tangentialforce tangentialkraft lateralforce shearforce torque moment \
                 drehmoment FT Ft FR Fr Ff FF Fx FX tau τ jointtorque motortorque shearstress \
                 motorcurrent current strom",
        ],
    );
    /// Standard deviation of the friction, in its unit.
    pub const DEVIATION: Self = Self::optional(
        "sigma",
        "standard deviation of the friction",
        Self::FRICTION.dimensions,
        &["σ standarddeviation standardabweichung stddev std uncertainty fstd sigmaf error"],
    );
    /// Position along the sliding, in m or rad.
    pub const POSITION: Self = Self::optional(
        "x",
        "position",
        &[Dimension::Length, Dimension::Angle],
        &[
            "position displacement displ disp weg verschiebung gleitweg slip slidingdistance \
                 distance stroke pos xpos posx jointposition q auslenkung hub",
        ],
    );
    /// Position across, in m.
    pub const ACROSS: Self = Self::optional(
        "y",
        "position across",
        &[Dimension::Length],
        &["ypos posy yposition"],
    );
    /// Angle of a body, in rad.
    pub const ANGLE: Self = Self::optional(
        "angle",
        "angle",
        &[Dimension::Angle],
        &["theta θ winkel drehwinkel yaw orientation phi φ heading rotation"],
    );
    /// Acceleration, in m/s² or rad/s².
    pub const ACCELERATION: Self = Self::optional(
        "a",
        "acceleration",
        &[Dimension::Acceleration, Dimension::AngularAcceleration],
        &[
            "acceleration beschleunigung acc accel angularacceleration winkelbeschleunigung qdd \
                 ddq qddot jointacceleration",
        ],
    );
    /// Normal load, in N.
    pub const LOAD: Self = Self::optional(
        "load",
        "normal load",
        &[Dimension::Force, Dimension::Pressure],
        &[
            "normalforce normalload normalkraft last normal normallast FN Fn FZ Fz verticalforce \
                 anpresskraft belastung normalstress effectivenormalstress auflast",
            "pressure pressung",
        ],
    );
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::TIME,
        Self::VELOCITY,
        Self::FRICTION,
        Self::DEVIATION,
        Self::POSITION,
        Self::ACROSS,
        Self::ANGLE,
        Self::ACCELERATION,
        Self::LOAD,
    ];

    const fn optional(
        name: &'static str,
        meaning: &'static str,
        dimensions: &'static [Dimension],
        synonyms: &'static [&'static str],
    ) -> Self {
        Self {
            name,
            meaning,
            dimensions,
            is_needed: false,
            synonyms,
        }
    }

    /// The same, without which a log is refused.
    #[must_use]
    pub const fn needed(self) -> Self {
        Self {
            is_needed: true,
            ..self
        }
    }

    /// The same, for a column that bears its own name or is named by the user alone.
    #[must_use]
    pub const fn by_own_name(self) -> Self {
        Self {
            synonyms: &[],
            ..self
        }
    }

    /// The unit in SI of numbers that have none.
    pub fn unit(&self) -> &'static str {
        self.dimensions
            .first()
            .map_or("", |dimension| dimension.unit())
    }

    /// How well a heading names it: 0 for its own name alone, more for worse; none for other names and for units of
    /// what it does not measure.
    pub(super) fn rank(&self, heading: &Heading) -> Option<usize> {
        let unit = heading.unit.as_deref();
        if unit.is_some_and(|unit| self.is_foreign(unit)) {
            return None;
        }
        if heading.text == self.name {
            return Some(0);
        }
        if heading.name == self.name {
            return Some(1);
        }
        let name = letters(&heading.name);
        // F_N is a normal force, F/N a force in newtons.
        let is_simple = heading
            .text
            .chars()
            .all(|letter| letter.is_alphanumeric() || letter == '_');
        let text = if is_simple {
            letters(&heading.text)
        } else {
            String::new()
        };
        let plain = plain_name(&heading.name);
        let is_named =
            |synonym: &str| match synonym.chars().any(|letter| letter.is_ascii_uppercase()) {
                true => name == synonym || text == synonym,
                false => plain == synonym,
            };
        let mut lists = self.synonyms.iter();
        let list = lists.position(|list| list.split_whitespace().any(is_named));
        let loosely = plain == self.name;
        list.map(|list| 2 + list)
            .or(loosely.then_some(2 + self.synonyms.len()))
    }

    /// Whether a unit is known, and of something else.
    pub(super) fn is_foreign(&self, unit: &str) -> bool {
        any_unit(unit).is_some() && crate::record::units::unit(unit, self.dimensions).is_none()
    }
}

/// Letters and digits of a name.
fn letters(name: &str) -> String {
    name.chars()
        .filter(|letter| letter.is_alphanumeric())
        .collect()
}

/// The best rank of a heading for any role.
pub(super) fn best_rank(heading: &Heading) -> Option<usize> {
    LogRole::ALL
        .iter()
        .filter_map(|role| role.rank(heading))
        .min()
}
