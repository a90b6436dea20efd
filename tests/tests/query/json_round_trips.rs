//! Every type of the public list that can be read from JSON is written and read back without loss: values are made up from what a type asks serde for, with
//! every case of its enums and with and without what is optional.

use mapd_client::batch::{NearestLanes, Poses, TrackPositions};
use mapd_client::document::{Annotated, HeaderOffset, Revision, SourcePosition};
use mapd_client::geodesy::GeodeticPoint;
use mapd_client::junctions::{ConnectedLanes, GridHeight};
use mapd_client::localisation::*;
use mapd_client::objects::{NearObject, PlacementId, SkeletonVertex};
use mapd_client::path::*;
use mapd_client::roads::*;
use mapd_client::route::*;
use mapd_client::rules::*;
use mapd_client::signals::{LightStates, NearSignal};
use mapd_client::vocabulary::ClassSet;
use mapd_client::*;
use mapd_tests::workspace;
use serde::de::{self, DeserializeSeed, EnumAccess, IntoDeserializer as _, MapAccess, SeqAccess};
use serde::de::{VariantAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;

/// Texts that a type may ask for: an id, a lane's key, and a word of each vocabulary.
const TEXTS: [&str; 14] = [
    "000000000000002a0123456789abcdef",
    "12:3:-4",
    "truck",
    "broken",
    "yellow",
    "caution",
    "maximum",
    "rural",
    "driving",
    "priority",
    "stopSign",
    "crossing",
    "roadSign",
    "unknown",
];

/// Fields that are not written: they are borrowed lists, which cannot be read back.
const LEFT_OUT: [(&str, &str); 1] = [("MatchOptions", "expected")];

/// Elements of a made-up list.
const ELEMENTS: usize = 2;

/// What a value is made up of.
struct Source {
    /// Which case of an enum is taken; values beyond the last begin anew.
    case: usize,
    /// Cases that the widest enum has had.
    cases: usize,
    has_options: bool,
    /// Numbers so far: each is another one.
    numbers: u8,
    /// Of each text that was asked for, in order, which one of [`TEXTS`] is tried.
    tried: Vec<usize>,
    /// Texts so far.
    texts: usize,
}

impl Source {
    fn number(&mut self) -> u8 {
        self.numbers = self.numbers % 100 + 1;
        self.numbers
    }
}

type Error = de::value::Error;

macro_rules! number {
    ($($method:ident $visit:ident $kind:ty)*) => {
        $(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
            visitor.$visit(<$kind>::from(self.number()))
        })*
    };
}

impl<'de> Deserializer<'de> for &mut Source {
    type Error = Error;

    number! {
        deserialize_u8 visit_u8 u8
        deserialize_u16 visit_u16 u16
        deserialize_u32 visit_u32 u32
        deserialize_u64 visit_u64 u64
        deserialize_i16 visit_i16 i16
        deserialize_i32 visit_i32 i32
        deserialize_i64 visit_i64 i64
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_f64(f64::from(self.number()) + 0.25)
    }

    fn deserialize_f32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_f32(f32::from(self.number()) + 0.25)
    }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_f64(visitor)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_bool(self.case.is_multiple_of(2))
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        if self.texts == self.tried.len() {
            self.tried.push(0);
        }
        let text = TEXTS[self.tried[self.texts]];
        self.texts += 1;
        visitor.visit_str(text)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_str(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        if self.has_options { visitor.visit_some(self) } else { visitor.visit_none() }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_seq(List { source: self, left: ELEMENTS })
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, n: usize, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_seq(List { source: self, left: n })
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        count: usize,
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.deserialize_tuple(count, visitor)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_map(Fields { source: self, names: fields })
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.cases = self.cases.max(variants.len());
        let name = variants[self.case % variants.len()];
        visitor.visit_enum(Case { source: self, name })
    }

    serde::forward_to_deserialize_any! {
        i8 i128 u128 char bytes byte_buf unit unit_struct map identifier ignored_any
    }
}

struct List<'s> {
    source: &'s mut Source,
    left: usize,
}

impl<'de> SeqAccess<'de> for List<'_> {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Error> {
        let Some(left) = self.left.checked_sub(1) else { return Ok(None) };
        self.left = left;
        seed.deserialize(&mut *self.source).map(Some)
    }
}

struct Fields<'s> {
    source: &'s mut Source,
    names: &'static [&'static str],
}

impl<'de> MapAccess<'de> for Fields<'_> {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Error> {
        let Some((name, rest)) = self.names.split_first() else { return Ok(None) };
        self.names = rest;
        seed.deserialize((*name).into_deserializer()).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Error> {
        seed.deserialize(&mut *self.source)
    }
}

struct Case<'s> {
    source: &'s mut Source,
    name: &'static str,
}

impl<'de, 's> EnumAccess<'de> for Case<'s> {
    type Error = Error;
    type Variant = Content<'s>;

    fn variant_seed<V: DeserializeSeed<'de>>(
        self,
        seed: V,
    ) -> Result<(V::Value, Content<'s>), Error> {
        Ok((seed.deserialize(self.name.into_deserializer())?, Content(self.source)))
    }
}

/// What the case of an enum holds.
struct Content<'s>(&'s mut Source);

impl<'de> VariantAccess<'de> for Content<'_> {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Error> {
        seed.deserialize(self.0)
    }

    fn tuple_variant<V: Visitor<'de>>(self, n: usize, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_seq(List { source: self.0, left: n })
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_map(Fields { source: self.0, names: fields })
    }
}

/// A value of a type, and how many cases its widest enum has. Texts are tried until one fits.
fn made_up<T: Deserialize<'static>>(case: usize, has_options: bool) -> (T, usize) {
    let mut tried = Vec::new();
    loop {
        let mut source = Source { case, cases: 1, has_options, numbers: 0, tried, texts: 0 };
        let found = T::deserialize(&mut source);
        tried = source.tried;
        match found {
            Ok(value) => return (value, source.cases),
            Err(error) => {
                // The last text that was asked for does not fit.
                tried.truncate(source.texts);
                let last = tried.last_mut().unwrap_or_else(|| panic!("{error}"));
                *last += 1;
                let name = std::any::type_name::<T>();
                assert!(*last < TEXTS.len(), "{name} takes none of the texts: {error}");
            }
        }
    }
}

/// Names of the fields that a type writes.
type Keys = BTreeSet<String>;

fn check<T: Serialize + Deserialize<'static> + Debug>() -> Keys {
    let (mut case, mut cases, mut keys) = (0, 1, Keys::new());
    while case < cases {
        for has_options in [true, false] {
            let (value, widest) = made_up::<T>(case, has_options);
            cases = cases.max(widest);
            let json = serde_json::to_string(&value).expect("can be written");
            // Some types borrow from the text.
            let json: &'static str = json.leak();
            let read: T = serde_json::from_str(json)
                .unwrap_or_else(|error| panic!("{}: {error}: {json}", std::any::type_name::<T>()));
            assert_eq!(format!("{read:?}"), format!("{value:?}"), "{json}");
            let json: serde_json::Value = serde_json::from_str(json).expect("JSON");
            keys.extend(json.as_object().iter().flat_map(|object| object.keys().cloned()));
        }
        case += 1;
    }
    keys
}

macro_rules! check_all {
    ($($kind:ty),* $(,)?) => {
        BTreeMap::from([$((
            stringify!($kind).split('<').next().unwrap_or_default().trim().to_owned(),
            check::<$kind>(),
        )),*])
    };
}

/// Public fields of the types of the public list that can be read, by the types' last names. Cases of enums have fields of their own.
fn listed() -> BTreeMap<String, Keys> {
    let list = std::fs::read_to_string(workspace().join("docs/api/mapd-query.txt"));
    let list = list.expect("the list");
    let paths = list.lines().filter_map(|line| line.split_once("de::Deserialize<'de> for "));
    let paths = paths.filter_map(|(_, path)| path.split(['<', ' ']).next());
    let fields_of = |path: &str| {
        let fields = list.lines().filter_map(|line| {
            let field = line.strip_prefix("pub ")?.strip_prefix(path)?;
            let (name, _) =
                field.trim_start_matches("<'a>").trim_start_matches("<C>").split_once(": ")?;
            name.strip_prefix("::").filter(|name| !name.contains("::")).map(str::to_owned)
        });
        fields.collect()
    };
    let name = |path: &str| path.rsplit("::").next().unwrap_or(path).to_owned();
    paths.map(|path| (name(path), fields_of(path))).collect()
}

#[test]
fn all_that_can_be_read_is_read_as_it_was_written() {
    let checked = check_all!(
        AlternativeOptions,
        Annotated,
        Basis,
        BoundarySegment,
        Bounds,
        Clamped,
        ClassSet,
        ConflictLane,
        ConnectedLanes,
        ControllerId,
        Corridor,
        CorridorEdges,
        CorridorSurface,
        CostBound,
        CrossSection,
        EdgeKind,
        EdgeMark,
        Enter,
        GeodeticPoint,
        GridHeight,
        HeaderOffset,
        JunctionId,
        Landmark,
        LandmarkInView,
        LandmarkSource,
        LaneChange,
        LaneChangeAhead,
        LaneEdges,
        LaneHeight,
        LaneId,
        LaneKey<'static>,
        LaneLayer,
        LaneLine,
        LaneMatch,
        LanePosition,
        LaneRange,
        LaneSectionId,
        LaneSpeed,
        LaneTypes,
        LaneVisibility,
        LightStates,
        LineAhead,
        LinePoint,
        LineSource,
        MarkFilter,
        MarkKinds,
        MarkPoint,
        MarkSource,
        MatchOptions<'static>,
        NearMark,
        NearObject,
        NearSignal,
        Nearest,
        NearestLanes,
        NearestOptions,
        NextJunction,
        NodeId,
        ObjectId,
        OvertakingRule,
        PathChange,
        PathChangeKind,
        PathConflict,
        PathCrossing,
        PathFact,
        PathFactKind,
        PathJoint,
        PathLane,
        PathOptions,
        PathPoint,
        PathPosition,
        PathPositions,
        PathSpeed,
        PathTime,
        PlacementId,
        Point,
        Pose,
        Poses,
        PositionOnLane,
        ReachLink,
        Region,
        Revision,
        RoadId,
        RoadMarkExtent,
        RoadMarkLine,
        RoadMarkSegment,
        RoadTypeRecord,
        Route,
        RouteEnd,
        RouteStep,
        SRange,
        Sensor,
        ShortestLength,
        ShortestTime,
        Side,
        SignalId,
        SkeletonVertex,
        SourcePosition,
        SpeedOrigin,
        SpeedRule,
        SpeedStretch,
        Stance,
        TraceFix,
        TraceMatch,
        TraceOptions,
        TracePosition,
        Track,
        TrackPosition,
        TrackPositions,
        Tracked,
        TrackerFix,
        TrackerOptions<'static>,
        Turn,
        VehicleOutline,
        VehiclePose,
        Waypoint,
        WithTurns<ShortestLength>,
        Yields,
        YieldsBy,
    );
    let listed = listed();
    assert_eq!(checked.keys().collect::<Vec<_>>(), listed.keys().collect::<Vec<_>>());
    for (name, fields) in listed {
        let left_out = fields.difference(&checked[&name]).map(String::as_str);
        let due = LEFT_OUT.iter().filter(|(owner, _)| *owner == name).map(|(_, field)| *field);
        assert_eq!(left_out.collect::<Vec<_>>(), due.collect::<Vec<_>>(), "fields of {name}");
    }
}

/// A field that is written and not read back.
#[derive(Debug, Serialize, Deserialize)]
struct Forgetful {
    kept: f64,
    #[serde(skip_serializing, default)]
    #[expect(dead_code, reason = "only shown")]
    lost: u32,
}

#[test]
#[should_panic(expected = "lost: 0")]
fn what_is_lost_is_found() {
    check::<Forgetful>();
}
