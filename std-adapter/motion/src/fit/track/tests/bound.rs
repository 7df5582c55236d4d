//! What no estimate can be better than: the errors of the linearised motion at the truth under the true noise.

use super::super::super::parameter::Model;
use super::super::super::unknowns::Unknowns;
use super::super::body::Body;
use super::super::errors::Errors;
use super::super::model::TrackModel;
use super::super::weighted::{Noise, Weighted};
use super::*;

/// Standard error of μ by the bound of Cramér and Rao over μ, and the deviation of the linear estimate over that error:
/// a control of the noise that was drawn.
pub fn of_mu(body: &Filmed, track: &Track) -> Option<[f64; 2]> {
    let disk = Body::new(&Patch::Disk, TrackLaw::Coulomb, GRAVITY, 0.5).ok()?;
    let model = TrackModel::new(track, &disk);
    let truths = truths(body);
    let names = model.parameters().iter().map(|parameter| parameter.name);
    let values = names.map(|name| {
        truths
            .iter()
            .find(|known| known.0 == name)
            .map(|known| known.1)
    });
    let values: Option<Vec<f64>> = values.collect();
    let unknowns = Unknowns::new(&model, &[]).ok()?;
    let q = unknowns.coordinates(&values?);
    let [position, angle] = body.noise;
    let mut film = Weighted::new(&model, unknowns, Noise { position, angle });
    film.is_robust = false;
    let (residuals, slopes) = film.slopes(&film.unknowns, &q)?;
    let covariance = Errors::new(&film, &q, 1.0)?.covariance;
    let step = &covariance * (slopes.transpose() * Vector::from_vec(residuals));
    let bound = covariance[(0, 0)].sqrt();
    Some([bound, -step[0] / bound])
}
