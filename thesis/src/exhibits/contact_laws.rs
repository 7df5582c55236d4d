//! Figures 4.2 and 4.3: the contact laws of cohesive spheres as set-valued graphs.

use tribos_report::figure::{Axis, Color, Figure, Legend, Panels, ReferenceLine, Region, Series};

/// What the graphs depend on, in any consistent units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactLaws {
    /// Friction coefficient μ.
    pub mu: f64,
    /// Rolling coefficient μ_t.
    pub mu_rolling: f64,
    /// Torsion coefficient μ_n.
    pub mu_torsion: f64,
    /// Cohesion force F_coh.
    pub cohesion_force: f64,
    /// Range of cohesion d_c.
    pub cohesion_range: f64,
    /// Effective radius r_eff of the two spheres.
    pub effective_radius: f64,
}

/// Shown part of the graphs: gap in d_c, normal force in F_coh.
const GAP: (f64, f64) = (-0.5, 2.5);
const FORCE: (f64, f64) = (-1.5, 2.5);
/// Normal forces of the threshold graphs, in F_coh: a pressed contact and one without load.
const LOADS: [f64; 2] = [1.0, 0.0];
/// Height of the threshold graphs over their largest threshold.
const HEADROOM: f64 = 1.35;
/// Velocities are shown without scale: only their sign matters.
const VELOCITY: f64 = 1.0;

impl ContactLaws {
    /// Normal force over the gap in both readings of cohesion, and friction over the sliding
    /// velocity (thesis, fig. 4.2).
    pub fn figure_4_2(&self) -> Panels {
        let friction = |load: f64| self.mu * (load + self.cohesion_force);
        Panels::new("", 3)
            .cell(366, 340)
            .figure(self.resistance())
            .figure(self.constant_pull())
            .figure(self.threshold("Sliding", "sliding velocity v_t", "F_t", friction))
    }

    /// Rolling torque and torsion torque over their angular velocities (thesis, fig. 4.3).
    pub fn figure_4_3(&self) -> Panels {
        let arm = |coefficient: f64| {
            let lever = coefficient * self.effective_radius;
            move |load: f64| lever * (load + self.cohesion_force)
        };
        let (rolling, torsion) = (arm(self.mu_rolling), arm(self.mu_torsion));
        let (roll, spin) = ("rolling velocity ω_t", "torsion velocity ω_n");
        Panels::new("", 2)
            .figure(self.threshold("Rolling", roll, "T_t", rolling))
            .figure(self.threshold("Torsion", spin, "T_n", torsion))
    }

    // Cohesion as a resistance: any pull up to F_coh within the range.
    fn resistance(&self) -> Figure {
        let (pull, range) = (-self.cohesion_force, self.cohesion_range);
        let band = Region {
            label: "any".into(),
            outline: vec![(0.0, 0.0), (range, 0.0), (range, pull), (0.0, pull)],
            fill: Color::pale(0),
            label_at: (0.5 * range, 0.5 * pull),
        };
        let edge = vec![(0.0, pull), (range, pull), (range, 0.0), self.far()];
        self.normal("Cohesion as a resistance")
            .region(band)
            .series(self.contact())
            .series(Series::line("", edge).color(Color::palette(0)))
    }

    // Cohesion as a pull of F_coh within the range, resisted by the contact at gap zero.
    fn constant_pull(&self) -> Figure {
        let (pull, range) = (-self.cohesion_force, self.cohesion_range);
        let graph = vec![(0.0, pull), (range, pull), (range, 0.0), self.far()];
        self.normal("Cohesion as a constant pull")
            .series(self.contact())
            .series(Series::line("", graph).color(Color::palette(0)))
    }

    // At gap zero any force from −F_coh upwards.
    fn contact(&self) -> Series {
        let top = 2.0 * FORCE.1 * self.cohesion_force;
        let graph = vec![(0.0, -self.cohesion_force), (0.0, top)];
        Series::line("", graph).color(Color::palette(0))
    }

    // A gap without force beyond the shown part.
    fn far(&self) -> (f64, f64) {
        (2.0 * GAP.1 * self.cohesion_range, 0.0)
    }

    // Axes of a graph of the normal force, with F_coh and d_c marked.
    fn normal(&self, title: &str) -> Figure {
        let (length, force) = (self.cohesion_range, self.cohesion_force);
        Figure::new(
            title,
            Axis::linear("gap").range(GAP.0 * length, GAP.1 * length),
            Axis::linear("normal force F_n").range(FORCE.0 * force, FORCE.1 * force),
        )
        .guide(ReferenceLine::horizontal(-force, "−F_coh"))
        .guide(ReferenceLine::horizontal(0.0, ""))
        .guide(ReferenceLine::vertical(length, "d_c"))
        .legend(Legend::Hidden)
    }

    // A set-valued graph: any value up to the threshold at rest, the threshold against the motion.
    fn threshold(
        &self,
        title: &str,
        velocity: &str,
        answer: &str,
        most: impl Fn(f64) -> f64,
    ) -> Figure {
        let loads = LOADS.map(|load| load * self.cohesion_force);
        let top = HEADROOM * loads.iter().map(|load| most(*load)).fold(0.0, f64::max);
        // Without a threshold the graph is the axis; any height shows it.
        let top = if top > 0.0 { top } else { 1.0 };
        let figure = Figure::new(
            title,
            Axis::linear(velocity).range(-VELOCITY, VELOCITY),
            Axis::linear(answer).range(-top, top),
        )
        .guide(ReferenceLine::horizontal(0.0, ""))
        .guide(ReferenceLine::vertical(0.0, ""))
        .legend(Legend::TopRight);
        let names = ["F_n = F_coh", "F_n = 0"];
        let graphs = loads.into_iter().zip(names);
        graphs.fold(figure, |figure, (load, name)| {
            let most = most(load);
            let ends = 2.0 * VELOCITY;
            let graph = vec![(-ends, most), (0.0, most), (0.0, -most), (ends, -most)];
            figure.series(Series::line(name, graph))
        })
    }
}
