//! Measures as JSON and tables.

use super::{Measures, Table};
use serde_json::{Map, Value, json};
use tribos_base::record::json_number;
use tribos_base::results::Recorded;

impl Measures {
    /// The summary; lengths, forces and stresses in the units of the packing.
    pub fn json(&self) -> Value {
        let mut map = Map::new();
        let mut put = |name: &str, value: Value| map.insert(name.into(), value);
        put("spheres", self.assembly.radii.len().into());
        put("mean_radius", json_number(self.assembly.mean_radius()));
        put("volume", json_number(self.assembly.volume()));
        put("porosity", json_number(self.porosity));
        put("contacts", self.assembly.contacts.len().into());
        put("stress", self.stress_json());
        put("fabric", self.fabric_json());
        put("coordination", self.coordination_json());
        put("forces", self.forces_json());
        put("force_chains", self.chains_json());
        put("necks", self.necks_json());
        put("scene", self.assembly.scene.clone());
        put("version", env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }

    /// Tables of pair correlation, forces, coordination, force chains, necks and profile, as far as they are
    /// known.
    pub fn tables(&self) -> Vec<Table> {
        let mut tables = vec![
            self.pairs.table(),
            self.coordination.table(),
            self.profile.table(),
            self.necks.table(),
        ];
        tables.extend(self.forces.as_ref().map(super::ForceDistribution::table));
        tables.extend(self.chains.as_ref().map(super::ForceChains::table));
        tables
    }

    fn stress_json(&self) -> Value {
        let Some(stress) = &self.stress else {
            return Value::Null;
        };
        json!({
            "pressure": json_number(stress.pressure()),
            "deviator": json_number(stress.deviator()),
            "total": stress.total().recorded(),
            "plus": stress.plus.recorded(),
            "minus": stress.minus.recorded(),
            "kinetic": stress.kinetic.recorded(),
            "forces": match self.assembly.forces {
                super::KnownForces::Complete => "complete",
                super::KnownForces::Rounded => "rounded",
                _ => "normal only",
            },
        })
    }

    fn fabric_json(&self) -> Value {
        let fabric = &self.fabric;
        let direction: Vec<Value> = fabric.direction.iter().map(|x| json_number(*x)).collect();
        json!({
            "tensor": fabric.tensor.recorded(),
            "values": fabric.values.map(json_number),
            "direction": direction,
            "anisotropy": json_number(fabric.anisotropy),
        })
    }

    fn coordination_json(&self) -> Value {
        let coordination = &self.coordination;
        json!({
            "mean": json_number(coordination.mean),
            "rattlers": coordination.rattlers,
            "mean_without_rattlers": json_number(coordination.mean_without),
        })
    }

    fn forces_json(&self) -> Value {
        let Some(forces) = &self.forces else {
            return Value::Null;
        };
        json!({
            "mean": json_number(forces.mean),
            "largest": json_number(forces.largest),
            "push": forces.signs[0],
            "pull": forces.signs[1],
            "mean_pull": json_number(forces.mean_pull),
            "tail_decay": json_number(forces.tail[0]),
            "tail_decay_error": json_number(forces.tail[1]),
        })
    }

    fn chains_json(&self) -> Value {
        let Some(chains) = &self.chains else {
            return Value::Null;
        };
        json!({
            "chains": chains.chains.len(),
            "mean_length": json_number(chains.mean_length()),
            "longest": chains.longest(),
            "share_of_spheres": json_number(chains.share),
            "mean_principal_stress": json_number(chains.mean_stress),
        })
    }

    fn necks_json(&self) -> Value {
        let necks = &self.necks;
        let mean = |value: f64| json_number(value);
        json!({
            "mean_effective_radius": mean(necks.mean(|neck| neck.effective_radius)),
            "mean_torsion_lever": mean(necks.mean(|neck| neck.torsion_lever)),
            "mean_rolling_lever": mean(necks.mean(|neck| neck.rolling_lever)),
            "mean_neck_radius": mean(necks.mean(|neck| neck.radius)),
            "necks_beyond_sphere": necks.beyond,
        })
    }
}
