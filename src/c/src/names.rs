//! Codes and their words. The header lists them; [`vocabularies`] is what it is made from.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::list::put;
use crate::text::mapd_text;
use mapd_client::view::OverlayKind;
use mapd_client::vocabulary::{
    Class, ConflictKind, ContactPoint, EdgeKind, JunctionGroupKind, LaneMethod, LaneType,
    MarkLaneChange, ObjectShape, Orientation, QuarantinedKind, Relation, RelationReason,
    RoadMarkColor, RoadMarkKind, RoadMarkWeight, RoadType, SignalPosition, StructureKind,
    VehicleClass,
};

/// Codes of one thing, with their words as OpenDRIVE or the vocabulary of classes has them.
pub struct Vocabulary {
    /// What stands before the words of the header's constants.
    pub prefix: &'static str,
    /// Code, name in this program, and word of each.
    pub words: Vec<(u32, String, &'static str)>,
}

macro_rules! vocabularies {
    ($($code:literal $constant:ident $prefix:literal $kind:ident;)*) => {
        $(
            #[doc = concat!("`vocabulary` of `mapd_word`: `", $prefix, "_…`.")]
            const $constant: u32 = $code;
        )*

        /// Every vocabulary whose codes stand in results.
        pub fn vocabularies() -> Vec<Vocabulary> {
            vec![$(Vocabulary {
                prefix: $prefix,
                words: $kind::ALL.iter().map(|one| (u32::from(one.code()), format!("{one:?}"), one.name())).collect(),
            }),*]
        }

        /// Numbers of the vocabularies for [`mapd_word`].
        pub fn vocabulary_numbers() -> Vec<(&'static str, u32)> {
            vec![$((stringify!($constant), $constant)),*]
        }

        fn word(vocabulary: u32, code: u16) -> Option<&'static str> {
            match vocabulary {
                $($constant => Some($kind::ALL.iter().find(|one| u16::from(one.code()) == code).map_or("unknown", |one| one.name())),)*
                _ => None,
            }
        }
    };
}

vocabularies! {
    1 MAPD_WORDS_LANE_TYPE "MAPD_LANE_TYPE" LaneType;
    2 MAPD_WORDS_CLASS "MAPD_CLASS" Class;
    3 MAPD_WORDS_VEHICLE_CLASS "MAPD_VEHICLE_CLASS" VehicleClass;
    4 MAPD_WORDS_CONTACT_POINT "MAPD_CONTACT_POINT" ContactPoint;
    5 MAPD_WORDS_EDGE_KIND "MAPD_EDGE_KIND" EdgeKind;
    6 MAPD_WORDS_CONFLICT_KIND "MAPD_CONFLICT_KIND" ConflictKind;
    7 MAPD_WORDS_ORIENTATION "MAPD_ORIENTATION" Orientation;
    8 MAPD_WORDS_SIGNAL_POSITION "MAPD_SIGNAL_POSITION" SignalPosition;
    9 MAPD_WORDS_LANE_METHOD "MAPD_LANE_METHOD" LaneMethod;
    10 MAPD_WORDS_RELATION "MAPD_RELATION" Relation;
    11 MAPD_WORDS_RELATION_REASON "MAPD_RELATION_REASON" RelationReason;
    12 MAPD_WORDS_OBJECT_SHAPE "MAPD_OBJECT_SHAPE" ObjectShape;
    13 MAPD_WORDS_ROAD_MARK_KIND "MAPD_ROAD_MARK_KIND" RoadMarkKind;
    14 MAPD_WORDS_ROAD_MARK_COLOR "MAPD_ROAD_MARK_COLOR" RoadMarkColor;
    15 MAPD_WORDS_ROAD_MARK_WEIGHT "MAPD_ROAD_MARK_WEIGHT" RoadMarkWeight;
    16 MAPD_WORDS_MARK_LANE_CHANGE "MAPD_MARK_LANE_CHANGE" MarkLaneChange;
    17 MAPD_WORDS_ROAD_TYPE "MAPD_ROAD_TYPE" RoadType;
    18 MAPD_WORDS_STRUCTURE_KIND "MAPD_STRUCTURE_KIND" StructureKind;
    19 MAPD_WORDS_OVERLAY_KIND "MAPD_OVERLAY_KIND" OverlayKind;
    20 MAPD_WORDS_QUARANTINED_KIND "MAPD_QUARANTINED_KIND" QuarantinedKind;
    21 MAPD_WORDS_JUNCTION_GROUP_KIND "MAPD_JUNCTION_GROUP_KIND" JunctionGroupKind;
}

/// The word of a code, as OpenDRIVE or the vocabulary of classes has it; `unknown` for a code that this release does not know. `vocabulary`
/// is a `MAPD_WORDS_…`. The text is there for ever.
///
/// Errors: `MAPD_CODE_ARGUMENT` for an unknown vocabulary.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_word(
    vocabulary: u32,
    code: u16,
    out: *mut mapd_text,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let word = word(vocabulary, code);
            let unknown = || Failure::argument(format!("{vocabulary} is no vocabulary"));
            put(out, word.ok_or_else(unknown)?.into())
        })
    }
}

/// The release of the library, such as `0.1.0`. The text is there for ever.
#[unsafe(no_mangle)]
pub extern "C" fn mapd_version() -> mapd_text {
    env!("CARGO_PKG_VERSION").into()
}
