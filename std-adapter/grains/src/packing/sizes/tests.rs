use super::{Radii, SettingError, SizeDistribution, table};
use std::path::Path;
use tribos_base::record::{OtherColumns, Rows};

/// Moments of the radii by the midpoint rule over their quantiles, which is exact to 1e-6 here.
fn moments(radii: &Radii) -> [f64; 3] {
    const POINTS: u32 = 20_000;
    let mut sums = [0.0; 3];
    for point in 0..POINTS {
        let r = radii.at((f64::from(point) + 0.5) / f64::from(POINTS));
        for (sum, power) in sums.iter_mut().zip([r, r * r, r * r * r]) {
            *sum += power / f64::from(POINTS);
        }
    }
    sums
}

#[test]
fn moments_are_those_of_the_closed_forms() {
    for text in [
        "uniform:0.2",
        "uniform:0.9",
        "normal:0.1",
        "normal:0.3",
        "lognormal:0.1",
        "lognormal:0.7",
    ] {
        let radii = text.parse::<SizeDistribution>().unwrap().radii().unwrap();
        let [mean, square, cube] = moments(&radii);
        assert!((mean - 1.0).abs() < 2e-5, "{text}: {mean}");
        assert!((radii.mean() - 1.0).abs() < 1e-15, "{text}");
        assert!(
            (cube / radii.mean_cube() - 1.0).abs() < 2e-4,
            "{text}: {cube}"
        );
        let variance = square - mean * mean;
        // scipy 1.14: truncnorm(-3, 3).var() is 0.973337; uniform S²/3; for the cut logarithm
        // exp(σ²)[Φ(3−2σ)−Φ(−3−2σ)] [2Φ(3)−1]/[Φ(3−σ)−Φ(−3−σ)]² − 1, evaluated with mpmath.
        let expected = match text {
            "uniform:0.2" => 0.04 / 3.0,
            "uniform:0.9" => 0.81 / 3.0,
            "normal:0.1" => 0.009_733_369,
            "normal:0.3" => 0.087_600_32,
            _ => continue,
        };
        assert!(
            (variance / expected - 1.0).abs() < 1e-3,
            "{text}: {variance}"
        );
    }
}

#[test]
fn quantiles_rise_from_bound_to_bound() {
    for text in ["uniform:0.5", "normal:0.25", "lognormal:1"] {
        let radii = text.parse::<SizeDistribution>().unwrap().radii().unwrap();
        let [low, high] = radii.bounds();
        assert!(low > 0.0);
        let shares = (0..=1000).map(|n| f64::from(n) / 1000.0);
        let all: Vec<f64> = shares.map(|share| radii.at(share)).collect();
        assert!(all.windows(2).all(|pair| pair[0] < pair[1]), "{text}");
        assert!(
            (all[0] / low - 1.0).abs() < 1e-12,
            "{text}: {} {low}",
            all[0]
        );
        assert!((all[1000] / high - 1.0).abs() < 1e-12, "{text}");
    }
}

fn read(text: &str) -> Result<Vec<[f64; 2]>, SettingError> {
    let (name, others) = (Path::new("t.csv"), OtherColumns::Refused);
    let rows = Rows::of(name, text.as_bytes(), others, |_| &table::COLUMNS);
    rows.and_then(table::read).map_err(table::refused)
}

#[test]
fn a_table_gives_each_radius_its_share_and_keeps_the_mean() {
    let rows = read("# sieve\nradius,weight\n3,1\n1,3\n").unwrap();
    let radii = Radii::table(rows);
    // Three of four have radius 1, the mean is 1.5.
    assert_eq!(radii.bounds(), [1.0 / 1.5, 2.0]);
    assert_eq!(
        [0.0, 0.7499, 0.7501, 0.999].map(|share| radii.at(share)),
        [1.0 / 1.5, 1.0 / 1.5, 2.0, 2.0]
    );
    assert!((radii.mean_cube() - (0.75 / 3.375 + 0.25 * 8.0)).abs() < 1e-14);
}

#[test]
fn refusals_name_file_line_and_what_would_be_valid() {
    for (text, reason) in [
        (
            "r,w\n1,1",
            "t.csv:1: column `radius` is missing; the header must be radius,weight",
        ),
        (
            "radius,weight\n1,0",
            "t.csv:2: weight must be a finite number > 0, not `0`",
        ),
        (
            "radius,weight\n-1,1",
            "t.csv:2: radius must be a finite number > 0, not `-1`",
        ),
        (
            "radius,weight\n",
            "t.csv:2: no rows; give one line of radius,weight for each",
        ),
    ] {
        assert_eq!(
            read(text).map_err(|error| error.to_string()),
            Err(reason.to_owned()),
            "{text:?}"
        );
    }
    for text in ["", "normal", "gamma:0.1", "table:", "uniform:x"] {
        assert_eq!(
            text.parse::<SizeDistribution>(),
            Err(SettingError::Sizes(text.into())),
            "{text:?}"
        );
    }
    for text in [
        "uniform:0",
        "uniform:1",
        "normal:0.34",
        "normal:nan",
        "lognormal:-0.1",
        "lognormal:1.1",
    ] {
        assert!(
            matches!(
                text.parse::<SizeDistribution>(),
                Err(SettingError::Width { .. })
            ),
            "{text}"
        );
    }
}
