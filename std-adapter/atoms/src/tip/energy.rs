//! Where the work of the drive went.

use tribos_base::results::summary;

summary! {
    /// Where the drive's energy went; NaN where a stage is missing.
    #[derive(Copy)]
    pub struct DriveEnergy = part;

    /// Work of the drive: its force on each driven atom times the atom's displacement, summed over all steps.
    work: f64, "eps";
    /// Rise of the potential energy while driven, between means over 20 tau at the ends of stages. Pairs that cross a
    /// cut-off without shift change it without work.
    stored: f64, "eps";
    /// Heat absorbed by thermostats and damping while driven: the work that was not stored.
    heat: f64, "eps";
    /// Fall of the potential energy after the drive.
    released: f64, "eps";
    /// Standard error of `stored`, from the scatter of lines 0.5 tau apart, treated as independent.
    uncertainty: f64, "eps";
}
