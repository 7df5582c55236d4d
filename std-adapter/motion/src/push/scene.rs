//! The scene of a body that a pusher moves slowly over the floor.

use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::{as_written, scene};
use tribos_friction::{FlatPatch, PATCH, Patch};

scene! {
    /// A body on the floor that a pusher moves, slowly enough that nothing has inertia.
    ///
    /// Places are in the frame of the body, about the origin of its patch. A second contact makes the
    /// pusher a line, which holds the body or not. The default is a box of 30 × 20 cm, pushed at its long side.
    ///
    /// ```
    /// use tribos::{push::ContactMode, scene::PushScene};
    /// let scene = PushScene { contact_x: 0.05, ..PushScene::default() }; // m
    /// let pushed = scene.run()?;
    /// assert_eq!(pushed.first.mode, ContactMode::SlidingLeft);
    /// assert!(pushed.journey.moments.last().is_some_and(|last| last.pose.angle > 0.1));
    /// # Ok::<(), tribos::push::PushError>(())
    /// ```
    pub struct PushScene = "push", "A body that is pushed over the floor", rules, as_written;

    /// Contact of the body with the floor: box:AxB, polygon:FILE, bar:L, or a round patch such as disk.
    patch: Patch = Patch::Flat(FlatPatch::Box([0.3, 0.2])), "-", PATCH, Required;
    /// Radius of a round patch.
    radius: f64 = 0.05, "m", Positive;
    /// Friction coefficient between body and floor.
    mu was coefficient: f64 = 0.4, "-", Positive, Required;
    /// Friction coefficient between body and floor across an axis of the patch, `mu` being that along it; the same if it is left out.
    mu_across: Option<f64> = None, "-", Positive;
    /// Angle from the x axis of the patch to that axis.
    axis: f64 = 0.0, "rad", Finite;
    /// Load of the body on the floor.
    load: f64 = 20.0, "N", Positive, Required;
    /// Centre of pressure of a box or polygon along x, under linear pressure; the centroid if left out.
    centre_x: Option<f64> = None, "m", Finite;
    /// Centre of pressure along y.
    centre_y: Option<f64> = None, "m", Finite;
    /// Where the pusher touches the body.
    contact_x: f64 = 0.0, "m", Finite, Required;
    /// The same along y.
    contact_y: f64 = -0.1, "m", Finite, Required;
    /// The other end of a straight pusher; a point if left out.
    end_x: Option<f64> = None, "m", Finite;
    /// The same along y.
    end_y: Option<f64> = None, "m", Finite;
    /// Inward normal at the contact, of any length; that of the nearest side if left out.
    normal_x: Option<f64> = None, "-", Finite;
    /// The same along y.
    normal_y: Option<f64> = None, "-", Finite;
    /// Friction coefficient between pusher and body.
    mu_pusher was pusher_coefficient: f64 = 0.3, "-", NotNegative, Required;
    /// Velocity of the pusher.
    velocity_x: f64 = 0.0, "m/s", Finite, Required;
    /// The same along y.
    velocity_y: f64 = 0.02, "m/s", Finite, Required;
    /// Spin of a straight pusher, about the origin of the patch.
    spin: f64 = 0.0, "rad/s", Finite;
    /// How far the pusher moves.
    distance: Option<f64> = Some(0.2), "m", Positive, UnlessGiven("duration");
    /// How long the pusher moves.
    duration: Option<f64> = None, "s", Positive;
    /// Number of recorded times.
    samples: u32 = 100, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
    /// Largest error of the path.
    tolerance: f64 = 1e-7, "m", Between { above: 1e-13, up_to: 1.0 };
}

fn rules(scene: &PushScene, judge: &mut SceneDiagnostics<'_>) {
    let pairs: [(&[&'static str], _); 3] = [
        (&["centre_x", "centre_y"], [scene.centre_x, scene.centre_y]),
        (&["end_x", "end_y"], [scene.end_x, scene.end_y]),
        (&["normal_x", "normal_y"], [scene.normal_x, scene.normal_y]),
    ];
    for (names, [x, y]) in pairs {
        if x.is_some() != y.is_some() {
            judge.refuse(
                names,
                format!("give both `{}` and `{}`, or none", names[0], names[1]),
            );
        }
    }
    if scene.velocity_x == 0.0 && scene.velocity_y == 0.0 && scene.spin == 0.0 {
        let message = "nothing moves: give `velocity_x` or `velocity_y` a value other than 0";
        judge.refuse(&["velocity_x", "velocity_y"], message);
    }
    if scene.end_x.is_none() && scene.spin != 0.0 {
        let message =
            "a pusher that is a point has no `spin`; give its other end by `end_x` and `end_y`";
        judge.refuse(&["spin"], message);
    }
    if scene.end_x.is_some() && scene.normal_x.is_some() {
        let message = "a straight pusher has its own normal: leave `normal_x` and `normal_y` out";
        judge.refuse(&["normal_x", "normal_y"], message);
    }
    if (scene.normal_x, scene.normal_y) == (Some(0.0), Some(0.0)) {
        let message =
            "the normal must have a direction: give `normal_x` or `normal_y` a value other than 0";
        judge.refuse(&["normal_x", "normal_y"], message);
    }
    if scene.centre_x.is_some() && !matches!(scene.patch, Patch::Flat(_)) {
        let message =
            "a centre of pressure is for boxes and polygons: leave `centre_x` and `centre_y` out";
        judge.refuse(&["centre_x", "centre_y"], message);
    }
    let has_sides = match &scene.patch {
        Patch::Flat(flat) => matches!(
            flat,
            FlatPatch::Box(_) | FlatPatch::Polygon(_) | FlatPatch::Bar(_) | FlatPatch::Mesh(_)
        ),
        other => !matches!(other, Patch::Points(_)),
    };
    if !has_sides {
        let message =
            "a pusher needs a side to touch: name a box, a polygon, a bar, a mesh or a round patch";
        judge.refuse(&["patch"], message);
    }
    if [scene.contact_x, scene.contact_y] == [0.0; 2]
        && !matches!(scene.patch, Patch::Flat(_))
        && scene.normal_x.is_none()
    {
        let message =
            "at the centre of a round patch no side is nearest: give `normal_x` and `normal_y`";
        judge.refuse(&["contact_x", "contact_y"], message);
    }
}
