//! Row types of the tables of signals and of what is left out.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use crate::table::Range;
use bytemuck::{Pod, Zeroable};
use rkyv::Archive;

/// One row per signal, in file order, signs on boards behind the signal that carries them. The row number is the SignalId.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SignalRow {
    /// `[m]` Where it stands, inertial: by `positionInertial` or `positionRoad` where given, else by s, t and zOffset.
    pub x: f64,
    /// `[m]` Where it stands.
    pub y: f64,
    /// `[m]` Where it stands.
    pub z: f64,
    /// `[rad]` Direction of the face's normal in plan view, in (−π, π]: towards the traffic that it is for.
    pub facing: f64,
    /// `[m]` signal/@s.
    pub s: f64,
    /// `[m]` signal/@t.
    pub t: f64,
    /// `[m]` signal/@zOffset.
    pub z_offset: f64,
    /// `[rad]` signal/@hOffset.
    pub h_offset: f64,
    /// `[rad]` Pitch of what stands there.
    pub pitch: f64,
    /// `[rad]` Roll of what stands there.
    pub roll: f64,
    /// `[m]` signal/@width; −1 if not given.
    pub width: f64,
    /// `[m]` signal/@height; −1 if not given.
    pub height: f64,
    /// `[m]` signal/@length; −1 if not given.
    pub length: f64,
    /// signal/@value as written, if `has_value` has bit 1; else 0.
    pub written_value: f64,
    /// `[m/s, m or kg]` What the class means by its value, if `has_value` has bit 2; else 0.
    pub value: f64,
    /// signal/@id verbatim.
    pub id: u32,
    /// signal/@name.
    pub name: u32,
    /// signal/@type verbatim.
    pub r#type: u32,
    /// signal/@subtype verbatim.
    pub subtype: u32,
    /// signal/@country verbatim.
    pub country: u32,
    /// signal/@countryRevision verbatim.
    pub country_revision: u32,
    /// signal/@text.
    pub text: u32,
    /// signal/@unit.
    pub unit: u32,
    /// The road that it is written in.
    pub road: u32,
    /// Of a sign on a board: the signal that carries the board.
    pub carrier: u32,
    /// Signals that it controls or depends on.
    pub dependencies: Range,
    /// Objects and signals that belong to it.
    pub links: Range,
    /// What it says itself that it means (1.8, 1.9).
    pub semantics: Range,
    /// Variable message boards.
    pub boards: Range,
    /// Controllers that switch it.
    pub controllers: Range,
    /// Line of the start tag, from 1.
    pub line: u32,
    /// Column of the start tag in bytes, from 1.
    pub column: u32,
    /// What it means: code of a class of docs/ontology.md, 65535 if no table maps it.
    pub class: u16,
    /// Direction of travel that it is for: 0 both, 1 along s, 2 against s.
    pub orientation: u8,
    /// 1 if its state changes.
    pub dynamic: u8,
    /// Where x, y, z and facing come from: 0 s and t, 1 positionRoad, 2 positionInertial.
    pub position: u8,
    /// Lamps of a light: 1 red, 2 yellow, 4 green.
    pub bulbs: u8,
    /// What a light can show: 1 red, 2 red and yellow, 4 yellow, 8 green, 16 flashing red, 32 flashing yellow, 64 flashing green, 128 off.
    pub phases: u8,
    /// Movements that a light is for, 0 all: 1 left, 2 straight, 4 right, 8 back.
    pub arrows: u8,
    /// 1 a value is written, 2 the class has a value, 4 the unit of that value is not written: the country's table or the SI defines it, 8 the class is a speed limit whose stated unit is none of speed.
    pub has_value: u8,
    /// 1 temporary, 2 invalidated (1.9), 4 s was moved to the road's end.
    pub flags: u8,
    /// 0.
    pub reserved: [u8; 6],
}
const _: () = assert!(size_of::<SignalRow>() == 224 && size_of::<ArchivedSignalRow>() == 224);

/// Places where signals apply: on their own road and on roads that refer to them, by road and s.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SignalPlaceRow {
    /// `[m]` s on the road.
    pub s: f64,
    /// `[m]` Lateral place on the road.
    pub t: f64,
    /// The signal.
    pub signal: u32,
    /// The road.
    pub road: u32,
    /// Lanes that it is for.
    pub lanes: Range,
    /// Line of the start tag of signal or signalReference, from 1.
    pub line: u32,
    /// Column of that start tag in bytes, from 1.
    pub column: u32,
    /// Direction of travel that it is for here: 0 both, 1 along s, 2 against s.
    pub orientation: u8,
    /// 0 the signal itself, 1 a reference to it.
    pub kind: u8,
    /// 0.
    pub reserved: [u8; 6],
}
const _: () =
    assert!(size_of::<SignalPlaceRow>() == 48 && size_of::<ArchivedSignalPlaceRow>() == 48);

/// Lanes of the signals' places, by place; lanes from left to right.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SignalLaneRow {
    /// The place.
    pub place: u32,
    /// The lane.
    pub lane: u32,
    /// `[m]` Distance of the signal's s and t from the lane's area, in plan view.
    pub distance: f32,
    /// How they belong together: 0 validity, 1 orientation (no validity: all lanes that travel that way), 2 s and t, 3 nearest lane, 4 a guess by orientation (the validity names lane 0 alone, and no reference names others).
    pub method: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(size_of::<SignalLaneRow>() == 16 && size_of::<ArchivedSignalLaneRow>() == 16);

/// Speed signs in force where a lane's traffic enters it, by lane; a lane without such a sign has no row. A map with signals of lanes has at least one row, which may be empty.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SpeedSignsAtEntryRow {
    /// The lane.
    pub lane: u32,
    /// The sign of a limit, which holds over lanes that lead on alone, not beyond a junction.
    pub limit: u32,
    /// The sign of a zone, in force until a sign ends it, if it is the same on all lanes that lead here; if `zone_depends` is 1 that of the lowest.
    pub zone: u32,
    /// 1: the lanes that lead here are in different zones, or some in one and some in none.
    pub zone_depends: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(
    size_of::<SpeedSignsAtEntryRow>() == 16 && size_of::<ArchivedSpeedSignsAtEntryRow>() == 16
);

/// signal/dependency, and those of boards.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SignalDependencyRow {
    /// The signal that is named, where the map has it.
    pub signal: u32,
    /// dependency/@id verbatim.
    pub id: u32,
    /// dependency/@type.
    pub r#type: u32,
}
const _: () = assert!(
    size_of::<SignalDependencyRow>() == 12 && size_of::<ArchivedSignalDependencyRow>() == 12
);

/// signal/reference, and those of boards.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SignalLinkRow {
    /// The signal that is named, where it is one and the map has it.
    pub signal: u32,
    /// The object that is named, where it is one and the map has it.
    pub object: u32,
    /// The signal that names it, itself or by a board that it carries.
    pub owner: u32,
    /// reference/@elementId verbatim.
    pub id: u32,
    /// reference/@type.
    pub r#type: u32,
    /// 0 an object, 1 a signal.
    pub kind: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(size_of::<SignalLinkRow>() == 24 && size_of::<ArchivedSignalLinkRow>() == 24);

/// Children of signal/semantics, and of the header's default regulations.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SignalSemanticsRow {
    /// Value as written; 0 if none.
    pub written_value: f64,
    /// Name of the element, such as `speed`.
    pub element: u32,
    /// Its type, such as `maximum`.
    pub kind: u32,
    /// Unit as written.
    pub unit: u32,
    /// What it means, as in `signals`.
    pub class: u16,
    /// 0.
    pub reserved: [u8; 2],
}
const _: () =
    assert!(size_of::<SignalSemanticsRow>() == 24 && size_of::<ArchivedSignalSemanticsRow>() == 24);

/// signal/vmsBoard, by signal: variable message boards (OpenDRIVE 1.8).
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct SignalBoardRow {
    /// `[m]` vmsBoard/@displayWidth; −1 if not given.
    pub width: f64,
    /// `[m]` vmsBoard/@displayHeight; −1 if not given.
    pub height: f64,
    /// `[m]` Lateral place on the carrier.
    pub v: f64,
    /// `[m]` Height on the carrier.
    pub z: f64,
    /// The signal that carries it.
    pub signal: u32,
    /// vmsBoard/@displayType.
    pub display: u32,
    /// Its display areas in file order.
    pub areas: Range,
    /// Lane numbers that it is written to hold for.
    pub validities: Range,
    /// Signals that it controls or depends on.
    pub dependencies: Range,
    /// Objects and signals that belong to it.
    pub links: Range,
}
const _: () =
    assert!(size_of::<SignalBoardRow>() == 72 && size_of::<ArchivedSignalBoardRow>() == 72);

/// vmsBoard/displayArea, by board: parts of variable message boards (OpenDRIVE 1.8).
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct DisplayAreaRow {
    /// `[m]` displayArea/@width; −1 if not given as a number.
    pub width: f64,
    /// `[m]` displayArea/@height; −1 if not given as a number.
    pub height: f64,
    /// `[m]` Lateral place on the carrier.
    pub v: f64,
    /// `[m]` Height on the carrier.
    pub z: f64,
    /// The board.
    pub board: u32,
    /// displayArea/@index; −1 if not given.
    pub index: i32,
}
const _: () =
    assert!(size_of::<DisplayAreaRow>() == 40 && size_of::<ArchivedDisplayAreaRow>() == 40);

/// vmsGroup/vmsBoardReference, by group: variable message boards that work together (OpenDRIVE 1.8).
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct BoardGroupRow {
    /// vmsGroup/@id.
    pub group: u32,
    /// The signal that carries the board, where the map has it.
    pub signal: u32,
    /// vmsBoardReference/@signalId verbatim.
    pub id: u32,
    /// Number of the board at the signal; −1 if not given.
    pub board: i32,
    /// Rank in the group; −1 if not given.
    pub rank: i32,
}
const _: () = assert!(size_of::<BoardGroupRow>() == 20 && size_of::<ArchivedBoardGroupRow>() == 20);

/// One row per controller, in file order: a signal group, whose signals switch together.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ControllerRow {
    /// controller/@id verbatim.
    pub id: u32,
    /// controller/@name.
    pub name: u32,
    /// controller/@sequence; −1 if not given.
    pub sequence: i32,
    /// Its signals, in file order.
    pub controls: Range,
    /// Line of the start tag, from 1.
    pub line: u32,
    /// Column of the start tag in bytes, from 1.
    pub column: u32,
}
const _: () = assert!(size_of::<ControllerRow>() == 28 && size_of::<ArchivedControllerRow>() == 28);

/// controller/control, by controller.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct ControlRow {
    /// The signal, where the map has it.
    pub signal: u32,
    /// control/@signalId verbatim.
    pub id: u32,
    /// control/@type.
    pub r#type: u32,
}
const _: () = assert!(size_of::<ControlRow>() == 12 && size_of::<ArchivedControlRow>() == 12);

/// junction/controller, by junction: the controllers of a junction are its synchronisation group.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct JunctionControllerRow {
    /// The junction.
    pub junction: u32,
    /// The controller, where the map has it.
    pub controller: u32,
    /// controller/@id verbatim.
    pub id: u32,
    /// controller/@type.
    pub r#type: u32,
    /// Rank in the junction's sequence; −1 if not given.
    pub sequence: i32,
}
const _: () = assert!(
    size_of::<JunctionControllerRow>() == 20 && size_of::<ArchivedJunctionControllerRow>() == 20
);

/// junction/priority, by junction.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct JunctionPriorityRow {
    /// The junction.
    pub junction: u32,
    /// Road with priority, where the map has it.
    pub high: u32,
    /// Road that gives way, where the map has it.
    pub low: u32,
}
const _: () = assert!(
    size_of::<JunctionPriorityRow>() == 12 && size_of::<ArchivedJunctionPriorityRow>() == 12
);

/// header/defaultRegulations: speeds by type of road (OpenDRIVE 1.8.1, 6.4).
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct DefaultSpeedRow {
    /// `[m/s]` Speed limit.
    pub max: f64,
    /// Road type code.
    pub kind: u8,
    /// 0.
    pub reserved: [u8; 7],
}
const _: () =
    assert!(size_of::<DefaultSpeedRow>() == 16 && size_of::<ArchivedDefaultSpeedRow>() == 16);

/// Parts of the document that have errors and are not in the map as written, in the order of the document.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct QuarantinedRow {
    /// `[m]` Smallest x of the part, inertial; 0 if not known.
    pub min_x: f64,
    /// `[m]` Smallest y of the part.
    pub min_y: f64,
    /// `[m]` Largest x of the part.
    pub max_x: f64,
    /// `[m]` Largest y of the part.
    pub max_y: f64,
    /// `[m]` Length of a road as written; 0 for other parts.
    pub length: f64,
    /// Id of the part; of a lane link `connection:from:to`.
    pub id: u32,
    /// Id of the road or junction that it belongs to; its own for these.
    pub owner: u32,
    /// Id of the rule whose finding is the reason.
    pub rule: u32,
    /// What the finding says.
    pub message: u32,
    /// Line of the finding, from 1.
    pub line: u32,
    /// Column of the finding in bytes, from 1.
    pub column: u32,
    /// 0 road, 1 junction, 2 connection, 3 object, 4 signal, 5 controller, 6 other group, 7 lane link.
    pub kind: u8,
    /// 0 left out, 1 kept as reference line.
    pub treatment: u8,
    /// 1 if the extent is known.
    pub has_extent: u8,
    /// What the owner is, as `kind`.
    pub owner_kind: u8,
    /// 0.
    pub reserved: [u8; 4],
}
const _: () =
    assert!(size_of::<QuarantinedRow>() == 72 && size_of::<ArchivedQuarantinedRow>() == 72);

/// Parts in quarantine whose finding is in an included file, by part. The findings of all other parts are in the document itself.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct QuarantinedFileRow {
    /// The part.
    pub part: u32,
    /// Name of the included file, without its folder.
    pub file: u32,
}
const _: () =
    assert!(size_of::<QuarantinedFileRow>() == 8 && size_of::<ArchivedQuarantinedFileRow>() == 8);

/// Objects and signals that are missing because the road or junction that they belong to is in quarantine, by that part.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct QuarantinedContentRow {
    /// Id of the object or signal.
    pub id: u32,
    /// The road or junction.
    pub part: u32,
    /// As `kind` of the part.
    pub kind: u8,
    /// 0.
    pub reserved: [u8; 3],
}
const _: () = assert!(
    size_of::<QuarantinedContentRow>() == 12 && size_of::<ArchivedQuarantinedContentRow>() == 12
);
