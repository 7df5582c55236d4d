//! Solid friction on a host: scenes, sliding bodies, records.
