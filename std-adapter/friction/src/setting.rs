//! Laws and patches as values of scene files.

use crate::{Law, Patch};
use tribos_base::scene::key::reads;
use tribos_base::scene::{Domain, Form};

/// A friction law with its parameters, as [`Law`] reads it.
pub const LAW: Domain = Domain::Form(&Form {
    name: "law",
    valid: "a law with its parameters, such as \"stribeck:mu_s=0.4,mu_d=0.2,vs=0.05\"",
    read: reads::<Law>,
    numbers: None,
    names_absence: false,
});

/// A contact patch, as [`Patch`] reads it.
pub const PATCH: Domain = Domain::Form(&Form {
    name: "patch",
    valid: "a patch such as \"box:0.3x0.2\", \"polygon:FILE\" or \"disk\"",
    read: reads::<Patch>,
    numbers: None,
    names_absence: true,
});

tribos_base::spelled!(Law, Patch);
