//! What a reader must know of how the strokes were taken apart.

use super::{DividedBy, FrictionSign, RunIn, Strokes};

/// Static peaks that exceed the mean by fewer standard deviations of the noise are noise.
const CLEAR: f64 = 5.0;

impl Strokes {
    /// Sentences on what was assumed and what the data do not tell.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        notes.extend(self.division().map(str::to_owned));
        notes.extend(self.sign().map(str::to_owned));
        notes.extend(self.settling());
        let cut_off = self.strokes.iter().filter(|stroke| stroke.is_cut_off);
        match cut_off.count() {
            0 => {}
            1 => notes.push("the record cuts one stroke off; the summary leaves it out".to_owned()),
            count => notes.push(format!(
                "the record cuts {count} strokes off; the summary leaves them out"
            )),
        }
        let excess = self
            .summary
            .static_peak
            .map(|peak| peak - self.summary.mean);
        if excess.is_some_and(|excess| excess < CLEAR * self.noise) {
            notes.push(
                "static peaks do not exceed the mean by more than the noise: no peak is seen"
                    .to_owned(),
            );
        }
        notes
    }

    /// What divides the record, in words.
    pub fn divided_by(&self) -> &'static str {
        match self.divided_by {
            DividedBy::Velocity => "velocity",
            DividedBy::Position => "position",
            DividedBy::FrictionSign => "sign of the friction",
            DividedBy::Nothing => "nothing",
        }
    }

    /// The run-in in words.
    pub fn run_in(&self) -> String {
        match self.run_in {
            RunIn::TooFew => "not decided with fewer than 8 strokes; all are used".to_owned(),
            RunIn::None => "none: no stroke differs from the rest".to_owned(),
            RunIn::Settled { after } => format!("settled after stroke {after}"),
            RunIn::NotSettled { after: 0, .. } => "not settled; all strokes are used".to_owned(),
            RunIn::NotSettled { after, .. } => {
                format!("not settled; strokes up to {after} are left out")
            }
        }
    }

    fn division(&self) -> Option<&'static str> {
        match self.divided_by {
            DividedBy::Velocity if self.sticks => Some(
                "friction rises through the rests of the velocity: they are taken as sticks of \
                 stick-slip, not as rests between strokes",
            ),
            DividedBy::Velocity => None,
            DividedBy::Position => {
                Some("the velocity is the difference of the positions over time")
            }
            DividedBy::FrictionSign => Some(
                "there is no velocity and no position: strokes are divided by the sign of the friction",
            ),
            DividedBy::Nothing => Some(
                "there is no velocity and no position, and friction keeps its sign: the record is \
                 taken as one stroke",
            ),
        }
    }

    fn sign(&self) -> Option<&'static str> {
        match self.friction_sign {
            FrictionSign::Along => None,
            FrictionSign::Against => {
                Some("friction is opposite to the velocity: its sign is turned")
            }
            FrictionSign::Unsigned => {
                Some("friction has the same sign in both directions: it is taken as a magnitude")
            }
        }
    }

    fn settling(&self) -> Option<String> {
        match self.run_in {
            RunIn::NotSettled { after, drift } => Some(format!(
                "friction has not settled for certain: {after} of {} strokes are left out, and over the \
                 others it changes by {drift:.3e} from stroke to stroke; record more strokes",
                self.strokes.len()
            )),
            _ => None,
        }
    }
}
