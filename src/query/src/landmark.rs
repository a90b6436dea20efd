//! Landmarks for localisation: signals and objects that a vehicle recognises when it drives past them.
//!
//! The landmarks that bound routing's searches (`--landmarks`) are places of the lane graph and have nothing to do with these.

use crate::class_set::ClassSet;
use crate::error::QueryError;
use crate::ids::SignalId;
use crate::map::Map;
use crate::objects::{ObjectPlacement, PlacementId};
use crate::region::Region;
use crate::signals::Signal;
use glam::{DVec2, DVec3};
use mapd_archive::Class;
use mapd_geometry::normalize_angle;
use std::f64::consts::{FRAC_PI_2, PI};

/// Where a landmark is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum LandmarkSource {
    /// A signal.
    Signal(SignalId),
    /// A place of an object.
    Object(PlacementId),
}

/// A thing that localisers find again.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Landmark {
    /// What it is in the map.
    pub source: LandmarkSource,
    /// What it means.
    pub class: Class,
    /// Where it stands, inertial `[m]`: its origin, which the standard puts at the middle of its lower side.
    pub position: DVec3,
    /// Of a signal the direction of its face's normal, of an object that of its u axis, in plan view `[rad]`, in (−π, π].
    pub heading: f64,
    /// Pitch `[rad]`; positive lowers the front. Of a signal as written.
    pub pitch: f64,
    /// Roll `[rad]`; positive lifts the left side. Of a signal as written.
    pub roll: f64,
    /// Length, width and height `[m]`; 0 where not given. A round object is as long and wide as its diameter.
    pub size: [f64; 3],
    /// Plan-view distance `[m]` from the point that was asked about: of a signal from where it stands, of an object from what
    /// it covers; 0 where none was.
    pub distance: f64,
}

/// A sensor that looks for landmarks.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sensor {
    /// Where it is, inertial `[m]`.
    pub position: DVec2,
    /// Where it looks `[rad]`, counter-clockwise from x.
    pub heading: f64,
    /// How far it sees in plan view `[m]`.
    pub range: f64,
    /// Angle that it sees, half of it to either side `[rad]`; 2π and more is all round.
    pub field_of_view: f64,
}

/// A landmark as a sensor sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LandmarkInView {
    /// The landmark; its `distance` is the range from the sensor.
    pub landmark: Landmark,
    /// Direction of where it stands from the sensor's heading `[rad]`, positive to the left, in (−π, π].
    pub bearing: f64,
    /// How far it is turned away from the sensor `[rad]`, counter-clockwise, in (−π, π]: 0 looks at the sensor, π away from it. Of an object that of its u axis.
    pub facing: f64,
}

impl Landmark {
    fn of_signal(signal: &Signal<'_>) -> Self {
        let [width, height, length] = signal.size().map(|size| size.unwrap_or(0.0));
        Self {
            source: LandmarkSource::Signal(signal.signal_id()),
            class: signal.class(),
            position: signal.position(),
            heading: signal.facing(),
            pitch: signal.pitch(),
            roll: signal.roll(),
            size: [length, width, height],
            distance: 0.0,
        }
    }

    fn of_object(place: &ObjectPlacement<'_>) -> Self {
        let [heading, pitch, roll] = place.angles();
        let or_round = |size: f64| if size > 0.0 { size } else { 2.0 * place.radius() };
        Self {
            source: LandmarkSource::Object(place.placement_id()),
            class: place.object().class(),
            position: place.position(),
            heading,
            pitch,
            roll,
            size: [or_round(place.length()), or_round(place.width()), place.height()],
            distance: 0.0,
        }
    }
}

impl<'a> Map<'a> {
    /// Signals and places of objects of these classes as near to a point as `radius` `[m]` in plan view, nearest first; objects
    /// that move are left out. [`ClassSet::LANDMARKS`] are the classes that localisers use. `out` is emptied first; it grows
    /// only if its capacity is too small.
    ///
    /// Errors: numbers that are not finite.
    pub fn landmarks_near(
        &self,
        point: DVec2,
        radius: f64,
        classes: ClassSet,
        out: &mut Vec<Landmark>,
    ) -> Result<(), QueryError> {
        out.clear();
        self.visit_landmarks(point, radius, classes, |landmark| out.push(landmark))?;
        // Sorting in place allocates nothing.
        out.sort_unstable_by(|a, b| {
            a.distance.total_cmp(&b.distance).then(a.source.cmp(&b.source))
        });
        Ok(())
    }

    /// Signals of these classes that stand in a rectangle in plan view, by row, then places of objects whose area meets it; as
    /// [`Map::landmarks_near`].
    ///
    /// Errors: a rectangle that is not finite.
    pub fn landmarks_in(
        &self,
        region: Region,
        classes: ClassSet,
        out: &mut Vec<Landmark>,
    ) -> Result<(), QueryError> {
        out.clear();
        region.check()?;
        self.visit_signals(region, |signal| {
            if classes.contains(signal.class()) {
                out.push(Landmark::of_signal(&signal));
            }
        });
        self.visit_fixed(region, classes, |place| {
            if place.meets(region) {
                out.push(Landmark::of_object(&place));
            }
        });
        out.sort_unstable_by_key(|landmark| landmark.source);
        Ok(())
    }

    /// What a sensor sees of the signals and places of objects of these classes, nearest first; objects that move are left out. Signals are seen from
    /// the front only, objects from all sides. What stands in between hides nothing: occlusion is not modelled. `out` is emptied first; it grows
    /// only if its capacity is too small.
    ///
    /// Errors: numbers that are not finite.
    pub fn landmarks_in_view(
        &self,
        sensor: &Sensor,
        classes: ClassSet,
        out: &mut Vec<LandmarkInView>,
    ) -> Result<(), QueryError> {
        out.clear();
        if !(sensor.heading.is_finite() && sensor.field_of_view.is_finite()) {
            return Err(QueryError::NotFinite);
        }
        self.visit_landmarks(sensor.position, sensor.range, classes, |landmark| {
            let way = landmark.position.truncate() - sensor.position;
            let direction = libm::atan2(way.y, way.x);
            let bearing = normalize_angle(direction - sensor.heading);
            let facing = normalize_angle(landmark.heading - direction - PI);
            let is_signal = matches!(landmark.source, LandmarkSource::Signal(_));
            let is_seen = !is_signal || facing.abs() < FRAC_PI_2;
            if is_seen && bearing.abs() <= 0.5 * sensor.field_of_view {
                out.push(LandmarkInView { landmark, bearing, facing });
            }
        })?;
        out.sort_unstable_by(|a, b| {
            let (a, b) = (&a.landmark, &b.landmark);
            a.distance.total_cmp(&b.distance).then(a.source.cmp(&b.source))
        });
        Ok(())
    }

    /// Landmarks near a point, in no order.
    fn visit_landmarks(
        &self,
        point: DVec2,
        radius: f64,
        classes: ClassSet,
        mut visit: impl FnMut(Landmark),
    ) -> Result<(), QueryError> {
        let region = Region::around_circle(point, radius)?;
        let mut add = |landmark: Landmark, distance: f64| {
            if distance <= radius {
                visit(Landmark { distance, ..landmark });
            }
        };
        self.visit_signals(region, |signal| {
            if classes.contains(signal.class()) {
                let distance = signal.position().truncate().distance(point);
                add(Landmark::of_signal(&signal), distance);
            }
        });
        self.visit_fixed(region, classes, |place| {
            add(Landmark::of_object(&place), place.distance(point));
        });
        Ok(())
    }

    /// Places of objects of these classes that do not move and whose boxes meet a rectangle.
    fn visit_fixed(
        &self,
        region: Region,
        classes: ClassSet,
        mut visit: impl FnMut(ObjectPlacement<'a>),
    ) {
        self.visit_places(region, |place| {
            let object = place.object();
            if classes.contains(object.class()) && !object.is_dynamic() {
                visit(place);
            }
        });
    }
}
