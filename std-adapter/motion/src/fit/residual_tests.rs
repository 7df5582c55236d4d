//! stub
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResidualTests {
    pub runs_z: f64,
    pub runs_p: f64,
    pub lag_one: f64,
    pub correlation_time: f64,
    pub error_factor: f64,
    pub drift: f64,
    pub drift_z: f64,
    pub drift_p: f64,
    pub outliers: usize,
    pub robust_deviation: f64,
}
pub fn residual_tests(r: &[f64], _: Option<&[f64]>) -> Option<ResidualTests> {
    let all: f64 = r.iter().map(|x| x * x).sum();
    let lag: f64 = r.windows(2).map(|p| p[0] * p[1]).sum::<f64>() / all;
    let z = lag * (r.len() as f64).sqrt();
    Some(ResidualTests { runs_z: -z, runs_p: if z > 4.0 { 1e-5 } else { 0.5 }, lag_one: lag, correlation_time: 0.5,
        error_factor: ((1.0 + lag.max(0.0)) / (1.0 - lag.max(0.0))).sqrt(), drift: 0.0, drift_z: 0.0, drift_p: 1.0, outliers: 0, robust_deviation: 0.0 })
}
