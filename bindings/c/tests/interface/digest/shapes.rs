//! Shapes, feet and steps under static friction.

use super::stream::{Precision, Range, Stream};
use super::surfaces::{feed_projection, feed_step};
use tribos_core::contact::TimeStep;
use tribos_core::coupling::WornAnnulus;
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch};
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::floor::{Feet, Foot, SteadyState};
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, ShapeLimitSurface};
use tribos_core::patch::affine_image::AffineImage;
use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::feet::{CompoundPatch, PatchPart};
use tribos_core::patch::nodes::{Node, Nodes};
use tribos_core::patch::outline::{Edge, Polygon, PressureField};
use tribos_core::patch::piece::HalfPlane;
use tribos_core::patch::points::PointPatch;
use tribos_core::patch::round::RoundPatch;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// The pressures in the order of their numbers in C.
const PRESSURES: [EllipsePressure; 4] = [
    EllipsePressure::FlatPunch,
    EllipsePressure::Uniform,
    EllipsePressure::Hertz,
    EllipsePressure::Paraboloid,
];

/// What all shapes of a case share.
struct Case<R: Precision> {
    p: [R; 8],
    axis: [R; 2],
    twist: Twist<R>,
    push: Wrench<R>,
}

type Stretched<R, P> = Option<AnisotropicPatch<R, P>>;

impl<R: Precision> Case<R> {
    fn feed(&self, s: &mut Stream, patch: &impl PatchShape<R>) {
        let [coefficient, load, force_limit, length, ..] = self.p;
        let friction = ShapeFriction::new(patch, coefficient);
        let friction = friction.as_ref().map_err(|_| ());
        s.wrench_of(friction.map(|f| f.wrench(load, &self.twist)));
        let both = friction.map(|f| f.wrench_and_jacobian(load, &self.twist));
        s.wrench_of(both.map(|(wrench, _)| wrench));
        s.jacobian_of(both.map(|(_, jacobian)| jacobian));
        let set = ShapeLimitSurface::new(patch, force_limit);
        let set = set.as_ref().map_err(|_| ());
        s.result(set.map(|set| set.gauge(&self.push)));
        s.twist_of(set.map(|set| set.twist_normal_to(&self.push)));
        // In C a length of 0 represents the radius.
        let nearest = set.map(|set| {
            if length == R::ZERO {
                set.project(&self.push)
            } else {
                set.project_with_length(&self.push, length)
            }
        });
        feed_projection(s, nearest.ok());
    }

    /// A patch with one coefficient, then `stretchable` with two.
    fn feed_both<P: AffineImage<R>>(
        &self,
        s: &mut Stream,
        patch: Option<impl PatchShape<R>>,
        stretchable: Option<P>,
    ) -> Stretched<R, P> {
        let patch = s.ok(patch.ok_or(()))?;
        self.feed(s, &patch);
        let two = (|| {
            let coefficients = AxisCoefficients::new([self.p[4], self.p[5]], self.axis).ok()?;
            AnisotropicPatch::new(stretchable?, coefficients).ok()
        })();
        let two = s.ok(two.ok_or(()))?;
        self.feed(s, &two);
        Some(two)
    }

    /// A disk, which two coefficients stretch to an ellipse.
    fn disk(
        &self,
        s: &mut Stream,
        pressure: EllipsePressure,
        centre: [R; 2],
    ) -> Stretched<R, Ellipse<R>> {
        let radius = self.p[7];
        let image = Ellipse::new(centre, [radius; 2], pressure).ok();
        macro_rules! of {
            ($coupling:expr) => {
                self.feed_both(s, RoundPatch::new($coupling, centre, radius).ok(), image)
            };
        }
        match pressure {
            EllipsePressure::FlatPunch => of!(CoulombPunch),
            EllipsePressure::Uniform => of!(CoulombDisk),
            EllipsePressure::Hertz => of!(CoulombHertz),
            EllipsePressure::Paraboloid => of!(CoulombParaboloid),
        }
    }

    /// Bars, a worn annulus, which takes one coefficient, and points.
    fn feed_others(&self, s: &mut Stream, x: &[R; 8], centre: [R; 2]) {
        let bar = Bar::new([x[0], -x[1]], [-x[2], x[3]]).ok();
        self.feed_both(s, bar, bar);
        // In C a centre of 0 is uniform pressure.
        let lean = centre[0] / R::from_f64(8.0);
        if lean == R::ZERO {
            self.feed_both(s, bar, bar);
        } else {
            let bar = bar.and_then(|bar| bar.with_centre_of_pressure(lean).ok());
            self.feed_both(s, bar, bar);
        }
        let worn = WornAnnulus::new(self.p[6] * R::HALF).ok();
        let worn = worn.and_then(|worn| RoundPatch::new(worn, centre, self.p[7]).ok());
        self.feed_both(s, worn, None::<Ellipse<R>>);
        let places = [[x[0], x[1]], [-x[1], x[3]], [x[4], -x[3]]];
        let nodes = [0, 1, 2].map(|i| Node {
            x: places[i][0],
            y: places[i][1],
            weight: self.p[i],
        });
        let points = Nodes::new(nodes).and_then(PointPatch::new).ok();
        self.feed_both(s, points, points);
    }

    fn feed_feet(&self, s: &mut Stream, feet: &[Foot<R, &dyn PatchShape<R>>]) {
        let feet = Feet::new(feet);
        let feet = feet.as_ref().map_err(|_| ());
        s.wrench_of(feet.map(|feet| feet.wrench(&self.twist)));
        let both = feet.map(|feet| feet.wrench_and_jacobian(&self.twist));
        s.wrench_of(both.map(|(wrench, _)| wrench));
        s.jacobian_of(both.map(|(_, jacobian)| jacobian));
        let steady = feet.and_then(|feet| match feet.steady_motion(&self.push) {
            SteadyState::Balanced(motion) => Ok(motion),
            _ => Err(()),
        });
        if let Some(found) = s.ok(steady) {
            s.feed_bits(found.carried_by.unwrap_or(3) as u64);
            s.feed_bits(found.evaluations as u64);
            s.twist_and_friction(&found.twist, &found.friction);
        }
        let step = (|| {
            let body = PlanarBody::new(self.p[0], self.p[1]).ok()?;
            let dt = TimeStep::new(self.p[6]).ok()?;
            Some(feet.ok()?.step(&body, &self.twist, &self.push, dt))
        })();
        if let Some(end) = s.ok(step.ok_or(())) {
            s.feed_bits(end.carried_by.unwrap_or(3) as u64);
            s.number(end.imbalance);
            s.twist_and_friction(&end.twist, &end.friction);
        }
    }

    fn feed_piece<K: PressureField<R>>(
        &self,
        s: &mut Stream,
        patch: &Polygon<R, [Edge<R>; 8], K>,
        centre: [R; 2],
    ) {
        let side = HalfPlane::new(centre, self.axis);
        let piece = side.and_then(|side| patch.within(&side, [Edge::default(); 8]));
        let Some(piece) = s.ok(piece) else { return };
        s.number(piece.map_or(R::ZERO, |piece| piece.share));
        if let Some(piece) = piece {
            s.feed_bits(piece.patch.edge_count() as u64);
            let friction = ShapeFriction::new(piece.patch, self.p[0]);
            s.wrench_of(friction.map(|f| f.wrench(self.p[1], &self.twist)));
        }
    }

    /// A step from this motion and one from rest, on a disk and on a shape; then the feet.
    fn feed_steps(
        mut self,
        s: &mut Stream,
        shape: Option<&dyn PatchShape<R>>,
        feet: Option<&[Foot<R, &dyn PatchShape<R>>]>,
    ) {
        let [mass, inertia, limit, above, _, _, dt, radius] = self.p;
        let (body, dt) = (PlanarBody::new(mass, inertia).ok(), TimeStep::new(dt).ok());
        for _ in 0..2 {
            let strength = R::ONE + above;
            let step = |set: Option<&dyn FrictionSet<R>>| {
                Some(body?.step_sticking(set?, strength, &self.twist, &self.push, dt?))
            };
            let disk = RoundLimitSurface::new(CoulombDisk, limit, radius).ok();
            feed_step(s, step(disk.as_ref().map(|set| set as _)));
            let set = shape.and_then(|shape| ShapeLimitSurface::new(shape, limit).ok());
            feed_step(s, step(set.as_ref().map(|set| set as _)));
            if let Some(feet) = feet {
                self.feed_feet(s, feet);
            }
            self.twist = Twist::ZERO;
        }
    }

    /// Cuts the polygon, gives it two coefficients, and lets three feet stand.
    fn feed_polygon<K: PressureField<R>>(
        self,
        s: &mut Stream,
        patch: Polygon<R, [Edge<R>; 8], K>,
        centre: [R; 2],
        others: [Stretched<R, Ellipse<R>>; 2],
        (limits, surfaces): ([R; 3], [Twist<R>; 3]),
    ) {
        self.feed_piece(s, &patch, centre);
        let own = self.feed_both(s, Some(patch), Some(patch));
        let [first, second] = &others;
        let all: Option<[&dyn PatchShape<R>; 3]> = (|| {
            Some([
                first.as_ref()? as &dyn PatchShape<R>,
                second.as_ref()?,
                own.as_ref()?,
            ])
        })();
        if let Some(all) = all {
            let parts = [0, 1, 2].map(|i| PatchPart {
                patch: all[i],
                load: limits[i],
            });
            self.feed_both(s, CompoundPatch::new(&parts).ok(), None::<Ellipse<R>>);
        }
        let feet = all.map(|all| {
            [0, 1, 2].map(|i| Foot {
                patch: all[i],
                limit: limits[i],
                surface: surfaces[i],
            })
        });
        let shape = all.map(|[_, _, own]| own);
        self.feed_steps(s, shape, feet.as_ref().map(|feet| &feet[..]));
    }
}

pub fn all<R: Precision>(s: &mut Stream, range: Range) {
    let x: [R; 8] = s.draws(Range::Fit);
    let p: [R; 8] = s.draws(Range::Fit);
    let place: [R; 4] = s.draws(Range::Mild);
    let (twist, push) = (s.twist(range), s.wrench(range));
    let pressure = PRESSURES[(s.bits() >> 62) as usize];
    let centre = [place[0], place[1]];
    let surfaces = [(); 3].map(|()| s.twist(Range::Mild));
    let case = Case {
        p,
        axis: [place[2], place[3]],
        twist,
        push,
    };
    let disk = case.disk(s, pressure, centre);
    let ellipse = Ellipse::new(centre, [x[0], x[1]], pressure).ok();
    let ellipse = case.feed_both(s, ellipse, ellipse);
    let turned = [[x[2], x[3]], [-x[4], x[5]]];
    let turned = Ellipse::with_half_diameters(centre, turned, pressure).ok();
    case.feed_both(s, turned, turned);
    case.feed_others(s, &x, centre);
    let corners = [[x[0], x[1]], [-x[2], x[3]], [-x[4], -x[5]], [x[6], -x[7]]];
    let patch = Polygon::with_holes(&[&corners], [Edge::default(); 8]);
    let Some(patch) = s.ok(patch) else { return };
    let by = centre.map(|part| part / R::from_f64(8.0));
    let centre = [patch.centre().x + by[0], patch.centre().y + by[1]];
    let (others, on) = ([disk, ellipse], ([x[5], x[6], x[7]], surfaces));
    match s.ok(patch.with_centre_of_pressure(centre)) {
        Some(leaning) => case.feed_polygon(s, leaning, centre, others, on),
        None => case.feed_polygon(s, patch, centre, others, on),
    }
}
