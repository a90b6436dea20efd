//! What planners and localisers ask of an HD map, answered in place on a borrowed mapd archive.
//!
//! [`Map`] is a small `Copy` view; [`Road`], [`LaneSection`], [`Lane`], [`Junction`] and [`Object`](objects::Object) are cursors into it.
//!
//! Invariants: a query never allocates, locks, prints, panics or does I/O, also on a damaged archive; there is no global
//! state; the compiler evaluates geometry through the same functions, bit for bit. Deliberately absent: how the bytes
//! came here (see `mapd-client`).
//!
//! Of a lane, left, right and ahead are those of its traffic unless a name says `of_reference_line`; of a road, those of its
//! reference line. An s that is no finite number has no answer: [`QueryError::NotFinite`], `None`, or NaN where the answer is a bare
//! number. One that lies outside is moved to the nearer end of the road, or of the lane's section: answers that say where they are
//! tell so ([`Clamped`]), bare numbers are those of the end.
//!
//! Results that are plain data (numbers, vectors, ids, words, and each other) are `#[repr(C)]`, and their words `#[repr(u8)]`: within one release of mapd they have the
//! same layout from every compiler and in every build, so that programs built apart may hand them on. Results with options, text, cases with values or
//! private parts are not; no layout is promised from one release to the next.
//!
//! # By task
//!
//! Where am I?
//! - The nearest lane to a point: [`Map::nearest_lane`]. The lanes that an uncertain pose may be in: [`Map::match_pose`]. The lanes of a
//!   recorded trace: [`Map::match_trace`]. See [`localisation`].
//! - What sensors see there: [`Map::ground_at`], [`Map::nearest_mark`], [`Map::landmarks_near`].
//! - Frenet coordinates: [`Road::to_track`] and [`Road::to_inertial`] on a road, [`Lane::position_of`] on a lane. Latitudes and longitudes: `geodesy`, with
//!   the feature of that name.
//!
//! What is ahead?
//! - Lane by lane: [`Lane::successors`], [`graph`]. A way through lanes: [`Map::route`], [`route`].
//! - Along the way: [`Map::path`] has the driven line, its corridor, speeds and conflicts; [`path`]. Signals: [`Map::signals_ahead`].
//!
//! What may I do here?
//! - Speed: [`Lane::speed_rule_at`], [`Lane::speed_rules`]. Overtaking: [`Lane::overtaking_rule_at`]. Where to stop: [`Lane::lines_to_stop_at`]. Who goes first:
//!   [`Lane::right_of_way`]. See [`rules`].
//! - Who may use a lane, and change to the next one: [`graph::LaneNode::allows`], [`graph::LaneNode::change_left`].
//!
//! What is around me?
//! - Lanes beside and borders: [`Lane::left`], [`Lane::opposite`], [`Lane::left_bound`]; in a [`Region`]: [`Map::lanes_in`], [`Map::boundary_segments`].
//! - [`Map::objects_near`] and [`objects`]; [`Map::signals_near`] and [`signals`].
//!
//! What does the file say?
//! - The network in detail: [`roads`], [`junctions`], [`railway`]; its words: [`vocabulary`]; what stands beside it, and what was left out:
//!   [`document`]; the archive's tables and rows: [`raw`].
//!
//! ```
//! use mapd_query::{Map, NearestOptions, glam::DVec2};
//!
//! fn lane_under(map: Map<'_>, x: f64, y: f64) -> Option<String> {
//!     let hit = map.nearest_lane(DVec2::new(x, y), &NearestOptions::default()).ok()??;
//!     Some(map.lane(hit.lane).ok()?.key().to_string())
//! }
//! ```

mod annotation;
mod area;
mod around;
pub mod batch;
mod begun;
mod beside;
mod by_row;
mod class_set;
mod cross_section;
mod error;
mod extents;
mod fetch;
mod file_frame;
mod folds;
#[cfg(feature = "geodesy")]
mod geodetic;
pub mod graph;
mod grid;
mod ground;
mod groups;
mod held;
mod ids;
mod index;
mod integral;
mod junction;
mod junction_group;
mod key;
mod landmark;
mod lane;
mod lane_edges;
mod lane_length;
mod lane_words;
mod lengths_along;
mod line_stretch;
mod map;
mod marks;
mod matching;
mod near;
mod nearest;
#[cfg(feature = "serde")]
mod numbers;
pub mod objects;
mod packed;
mod parallel;
mod passing;
pub mod path;
mod polyline;
mod position;
mod profile;
mod quarantine;
pub mod railway;
mod rank;
mod ready;
mod region;
mod road;
mod road_mark;
pub mod route;
pub mod rules;
mod section;
pub mod signals;
mod structures;
mod surface;
mod types;
pub mod view;
mod waypoints;

pub use error::QueryError;
pub use extents::{Bounds, SRange};
pub use glam;
#[doc(hidden)]
pub use groups::compiling;
#[cfg(feature = "geodesy")]
pub use groups::geodesy;
pub use groups::{document, junctions, localisation, roads, vocabulary};
pub use ids::{
    ControllerId, JunctionId, LaneId, LaneSectionId, NodeId, ObjectId, RoadId, SignalId,
};
pub use junction::Junction;
pub use key::{LaneKey, LaneLayer, ParseLaneKeyError};
pub use lane::Lane;
pub use map::Map;
/// The archive itself: tables, rows, opening and verifying.
pub use mapd_archive as raw;
pub use nearest::{LaneTypes, Nearest, NearestOptions};
pub use region::Region;
pub use road::Road;
pub use section::LaneSection;
pub use types::{Clamped, LaneEdges, LanePosition, Point, Pose, Track, TrackPosition};
