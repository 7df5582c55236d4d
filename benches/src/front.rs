//! The list of fronts.

/// A front.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Front {
    /// One evaluation of force and torque.
    Kernel,
    /// Calls one by one and in batches.
    Batch,
    /// Every patch, law and tier.
    Patches,
    /// Flat feet with straight edges.
    Polygons,
    /// One stop of a sliding, spinning disk.
    Integrators,
    /// Contacts of packings and their solvers.
    Contacts,
    /// Sweeps of packings from a thousand to a million spheres.
    Scale,
    /// Events, contact dynamics and soft particles.
    Methods,
    /// Contact problems beside Siconos.
    Problems,
    /// Molecular dynamics beside LAMMPS.
    Atoms,
    /// Whole runs with a mode left out.
    Modes,
    /// What each item costs a microcontroller.
    Firmware,
}

impl Front {
    /// In the order of the index.
    pub const ALL: [Self; 12] = [
        Self::Kernel,
        Self::Batch,
        Self::Patches,
        Self::Polygons,
        Self::Integrators,
        Self::Contacts,
        Self::Scale,
        Self::Methods,
        Self::Problems,
        Self::Atoms,
        Self::Modes,
        Self::Firmware,
    ];

    /// The order of work: what builds comes before what is timed, and the kernel's front shows
    /// instructions that the firmware's counts.
    pub(crate) const WORK: [Self; 12] = [
        Self::Firmware,
        Self::Kernel,
        Self::Batch,
        Self::Patches,
        Self::Polygons,
        Self::Integrators,
        Self::Contacts,
        Self::Scale,
        Self::Methods,
        Self::Problems,
        Self::Atoms,
        Self::Modes,
    ];

    /// Of the option, and of the front's files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kernel => "kernel",
            Self::Batch => "batch",
            Self::Patches => "patches",
            Self::Polygons => "polygons",
            Self::Integrators => "integrators",
            Self::Contacts => "contacts",
            Self::Scale => "scale",
            Self::Methods => "methods",
            Self::Problems => "problems",
            Self::Atoms => "atoms",
            Self::Modes => "modes",
            Self::Firmware => "firmware",
        }
    }

    /// The heading of its page.
    pub fn title(self) -> &'static str {
        match self {
            Self::Kernel => "Force and torque: speed against error",
            Self::Batch => "One by one and in batches: time, instructions",
            Self::Patches => "Every patch, law and tier: speed, error, size",
            Self::Polygons => "Flat feet: speed against error",
            Self::Integrators => "A disk brought to rest: step, order, error, cost",
            Self::Contacts => "Contacts of packings: speed, residual, size",
            Self::Scale => "Packings up to a million spheres: speed, order, threads, memory",
            Self::Methods => "Three methods: error against time",
            Self::Problems => "Contact problems: speed and reliability beside Siconos",
            Self::Atoms => "Atoms in motion: speed, conserved energy",
            Self::Modes => "A mode left out: time, memory, same result",
            Self::Firmware => "What the kernel costs a microcontroller",
        }
    }
}
