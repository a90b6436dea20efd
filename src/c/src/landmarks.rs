//! Landmarks for localisation.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::{MAPD_NO_ROW, mapd_object_id, mapd_signal_id};
use crate::list::{List, get, get_mut};
use crate::objects::mapd_placement_id;
use crate::point::{mapd_region, mapd_vec2, mapd_vec3};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::localisation::{Landmark, LandmarkInView, LandmarkSource, Sensor};
use mapd_client::vocabulary::ClassSet;

/// A set of classes of signals and objects: the bit of each is that of its code.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_class_set {
    /// The lowest bits first; the highest one stands for unknown classes.
    pub words: [u64; 4],
}

/// A thing that localisers find again.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_landmark {
    /// The signal that it is; one of `signal` and `place` names something.
    pub signal: mapd_signal_id,
    /// The place of an object that it is.
    pub place: mapd_placement_id,
    /// What it means: a `MAPD_CLASS_…`.
    pub class_code: u16,
    /// Where it stands, inertial \[m\].
    pub position: mapd_vec3,
    /// Of a signal the direction of its face's normal, of an object that of its u axis \[rad\], in (−π, π].
    pub heading: f64,
    /// Pitch \[rad\]; positive lowers the front.
    pub pitch: f64,
    /// Roll \[rad\]; positive lifts the left side.
    pub roll: f64,
    /// Length \[m\]; 0 where not given.
    pub length: f64,
    /// Width \[m\]; 0 where not given.
    pub width: f64,
    /// Height \[m\]; 0 where not given.
    pub height: f64,
    /// Plan-view distance from the point that was asked about \[m\]; 0 where none was.
    pub distance: f64,
}

/// A sensor that looks for landmarks.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_sensor {
    /// Where it is, inertial \[m\].
    pub position: mapd_vec2,
    /// Where it looks \[rad\], counter-clockwise from x.
    pub heading: f64,
    /// How far it sees in plan view \[m\].
    pub range: f64,
    /// Angle that it sees, half of it to either side \[rad\]; 2π and more is all round.
    pub field_of_view: f64,
}

/// A landmark as a sensor sees it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_landmark_in_view {
    /// The landmark; its distance is the range from the sensor.
    pub landmark: mapd_landmark,
    /// Direction of where it stands from the sensor's heading \[rad\], positive to the left, in (−π, π].
    pub bearing: f64,
    /// How far it is turned away from the sensor \[rad\], counter-clockwise, in (−π, π]: 0 looks at the sensor. Of an object that of its u axis.
    pub facing: f64,
}

fn landmark(one: &Landmark) -> mapd_landmark {
    let no_place = mapd_placement_id { object: mapd_object_id::NONE, copy: MAPD_NO_ROW };
    let (signal, place) = match one.source {
        LandmarkSource::Signal(signal) => (signal.into(), no_place),
        LandmarkSource::Object(place) => (mapd_signal_id::NONE, place.into()),
    };
    let [length, width, height] = one.size;
    mapd_landmark {
        signal,
        place,
        class_code: one.class.code(),
        position: one.position.into(),
        heading: one.heading,
        pitch: one.pitch,
        roll: one.roll,
        length,
        width,
        height,
        distance: one.distance,
    }
}

/// The classes of a caller's; null is what localisers use.
///
/// # Safety
///
/// As [`get`].
unsafe fn classes_of(classes: *const mapd_class_set) -> Result<ClassSet, crate::code::Failure> {
    if classes.is_null() {
        return Ok(ClassSet::LANDMARKS);
    }
    unsafe { Ok(ClassSet::from_words(get(classes, "the classes")?.words)) }
}

/// The classes that localisers use.
#[unsafe(no_mangle)]
pub extern "C" fn mapd_class_set_landmarks() -> mapd_class_set {
    mapd_class_set { words: ClassSet::LANDMARKS.words() }
}

/// Signals and places of objects of these classes as near to a point as `radius` \[m\] in plan view, nearest first; objects that move are left out.
/// `classes`: null is what localisers use.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_landmarks_near(
    snapshot: *const mapd_snapshot,
    point: mapd_vec2,
    radius: f64,
    classes: *const mapd_class_set,
    scratch: *mut mapd_scratch,
    out: *mut mapd_landmark,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = &mut get_mut(scratch, "a scratch")?.landmarks;
            map_of(snapshot)?.landmarks_near(point.into(), radius, classes_of(classes)?, found)?;
            List { out, capacity, count }.write(found.iter().map(landmark))
        })
    }
}

/// As `mapd_landmarks_near`, in a rectangle: signals by row, then places of objects whose area meets it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_landmarks_in(
    snapshot: *const mapd_snapshot,
    region: mapd_region,
    classes: *const mapd_class_set,
    scratch: *mut mapd_scratch,
    out: *mut mapd_landmark,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = &mut get_mut(scratch, "a scratch")?.landmarks;
            map_of(snapshot)?.landmarks_in(region.into(), classes_of(classes)?, found)?;
            List { out, capacity, count }.write(found.iter().map(landmark))
        })
    }
}

/// What a sensor sees of the signals and places of objects of these classes, nearest first; objects that move are left out. Signals are seen from the front
/// only, objects from all sides. What stands in between hides nothing. `classes`: null is what localisers use.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_landmarks_in_view(
    snapshot: *const mapd_snapshot,
    sensor: mapd_sensor,
    classes: *const mapd_class_set,
    scratch: *mut mapd_scratch,
    out: *mut mapd_landmark_in_view,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = &mut get_mut(scratch, "a scratch")?.in_view;
            let mapd_sensor { position, heading, range, field_of_view } = sensor;
            let sensor = Sensor { position: position.into(), heading, range, field_of_view };
            map_of(snapshot)?.landmarks_in_view(&sensor, classes_of(classes)?, found)?;
            let seen = |one: &LandmarkInView| mapd_landmark_in_view {
                landmark: landmark(&one.landmark),
                bearing: one.bearing,
                facing: one.facing,
            };
            List { out, capacity, count }.write(found.iter().map(seen))
        })
    }
}
