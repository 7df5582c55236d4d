//! Hard cases of contact dynamics: right, or refused by name.

use tribos::cd::WorldError as E;
use tribos_tests::hard::{TOLERANCES, cases, refusals};

/// Largest error and overlap of each case at the two tolerances: measured, rounded up.
///
/// Where a heavy body lies on a light one, a sweep takes back only the ratio of their masses of
/// what is wrong: what a sweep leaves of the approach ends it, not its change.
const BOUNDS: [(&str, [f64; 2], [f64; 2]); 13] = [
    ("chain of 200", [2e-3, 1e-7], [3e-4, 4e-10]),
    ("column of 50", [1e-3, 2e-6], [5e-4, 2e-9]),
    ("one sphere, plate of 1e6", [3e-5, 6e-5], [1e-3, 5e-4]),
    ("two spheres", [3e-5, 6e-5], [1e-3, 5e-4]),
    ("tower of 12", [4e-6, 1e-5], [6e-4, 2e-7]),
    ("jammed box", [1e-5, 1e-12], [1e-5, 1e-11]),
    ("pull of exactly", [1e-15, 1e-15], [1e-15, 1e-15]),
    ("push of exactly", [1e-15, 1e-15], [1e-15, 1e-15]),
    ("pair with an overlap", [2e-8, 3e-14], [1e-6, 1e-12]),
    (
        "sliding on a sphere of radius 1e3",
        [4e-4, 4e-4],
        [1e-15, 1e-15],
    ),
    (
        "sliding on a sphere of radius 1e6",
        [4e-7, 4e-7],
        [1e-15, 1e-15],
    ),
    ("chain of 20, radius 1e-30", [2e-3, 2e-9], [3e-5, 3e-11]),
    ("chain of 20, radius 1e30", [2e-3, 2e-9], [3e-5, 3e-11]),
];

#[test]
fn every_hard_case_stays_within_its_bounds() {
    let mut seen = 0;
    for case in cases() {
        println!("{case:?}");
        let (_, errors, overlaps) = BOUNDS
            .iter()
            .find(|(name, ..)| case.name.starts_with(name))
            .expect("every case has its bounds");
        let column = usize::from(case.tolerance == TOLERANCES[1]);
        assert!(case.error <= errors[column], "{case:?}");
        assert!(case.overlap <= overlaps[column], "{case:?}");
        // The residual is of the tolerance, or the world says that it was missed.
        assert!(
            case.residual <= 2.0 * case.tolerance || !case.met,
            "{case:?}"
        );
        seen += 1;
    }
    assert_eq!(seen, 2 * BOUNDS.len());
}

#[test]
fn bad_input_is_refused_by_name() {
    let expected = |input: &str, error: &E| match input {
        "longest step 0" | "longest step NaN" | "motion 0" => matches!(error, E::StepLimits { .. }),
        "coincident centres" | "centre in a wall" => matches!(error, E::Touch { step: 0, .. }),
        "position NaN" | "period too short for two spheres" => {
            matches!(error, E::Neighbours { .. })
        }
        "gravity NaN" | "gravity infinite" => matches!(error, E::Gravity),
        "gravity 1e300" => matches!(error, E::NotFinite { .. }),
        "wall's load infinite" | "wall's normal of length 2" => {
            matches!(error, E::Wall { wall: 0 })
        }
        "radius 0" | "radius NaN" => matches!(error, E::Radius { body: 0, .. }),
        "a radius missing" => matches!(error, E::Count { radii: 1, .. }),
        "speed of stillness NaN" => matches!(error, E::StillSpeed { .. }),
        "pull of 1e30 across a gap" => matches!(error, E::TooFast { .. }),
        _ => matches!(error, E::Sphere { .. }),
    };
    for (input, error) in refusals() {
        let error = error.unwrap_or_else(|| panic!("{input}: nothing is refused"));
        assert!(expected(input, &error), "{input}: {error}");
    }
}
