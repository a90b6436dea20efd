//! Reading the rows of signals and of what is left out.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::signal_rows::*;
use crate::table::Range;

impl ArchivedSignalRow {
    /// `[m]` Where it stands, inertial: by `positionInertial` or `positionRoad` where given, else by s, t and zOffset.
    #[inline]
    pub fn x(&self) -> f64 {
        self.x.to_native()
    }
    /// `[m]` Where it stands.
    #[inline]
    pub fn y(&self) -> f64 {
        self.y.to_native()
    }
    /// `[m]` Where it stands.
    #[inline]
    pub fn z(&self) -> f64 {
        self.z.to_native()
    }
    /// `[rad]` Direction of the face's normal in plan view, in (−π, π]: towards the traffic that it is for.
    #[inline]
    pub fn facing(&self) -> f64 {
        self.facing.to_native()
    }
    /// `[m]` signal/@s.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` signal/@t.
    #[inline]
    pub fn t(&self) -> f64 {
        self.t.to_native()
    }
    /// `[m]` signal/@zOffset.
    #[inline]
    pub fn z_offset(&self) -> f64 {
        self.z_offset.to_native()
    }
    /// `[rad]` signal/@hOffset.
    #[inline]
    pub fn h_offset(&self) -> f64 {
        self.h_offset.to_native()
    }
    /// `[rad]` Pitch of what stands there.
    #[inline]
    pub fn pitch(&self) -> f64 {
        self.pitch.to_native()
    }
    /// `[rad]` Roll of what stands there.
    #[inline]
    pub fn roll(&self) -> f64 {
        self.roll.to_native()
    }
    /// `[m]` signal/@width; −1 if not given.
    #[inline]
    pub fn width(&self) -> f64 {
        self.width.to_native()
    }
    /// `[m]` signal/@height; −1 if not given.
    #[inline]
    pub fn height(&self) -> f64 {
        self.height.to_native()
    }
    /// `[m]` signal/@length; −1 if not given.
    #[inline]
    pub fn length(&self) -> f64 {
        self.length.to_native()
    }
    /// signal/@value as written, if `has_value` has bit 1; else 0.
    #[inline]
    pub fn written_value(&self) -> f64 {
        self.written_value.to_native()
    }
    /// `[m/s, m or kg]` What the class means by its value, if `has_value` has bit 2; else 0.
    #[inline]
    pub fn value(&self) -> f64 {
        self.value.to_native()
    }
    /// signal/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// signal/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// signal/@type verbatim.
    #[inline]
    pub fn r#type(&self) -> u32 {
        self.r#type.to_native()
    }
    /// signal/@subtype verbatim.
    #[inline]
    pub fn subtype(&self) -> u32 {
        self.subtype.to_native()
    }
    /// signal/@country verbatim.
    #[inline]
    pub fn country(&self) -> u32 {
        self.country.to_native()
    }
    /// signal/@countryRevision verbatim.
    #[inline]
    pub fn country_revision(&self) -> u32 {
        self.country_revision.to_native()
    }
    /// signal/@text.
    #[inline]
    pub fn text(&self) -> u32 {
        self.text.to_native()
    }
    /// signal/@unit.
    #[inline]
    pub fn unit(&self) -> u32 {
        self.unit.to_native()
    }
    /// The road that it is written in.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// Of a sign on a board: the signal that carries the board.
    #[inline]
    pub fn carrier(&self) -> u32 {
        self.carrier.to_native()
    }
    /// Signals that it controls or depends on.
    #[inline]
    pub fn dependencies(&self) -> Range {
        self.dependencies.to_native()
    }
    /// Objects and signals that belong to it.
    #[inline]
    pub fn links(&self) -> Range {
        self.links.to_native()
    }
    /// What it says itself that it means (1.8, 1.9).
    #[inline]
    pub fn semantics(&self) -> Range {
        self.semantics.to_native()
    }
    /// Variable message boards.
    #[inline]
    pub fn boards(&self) -> Range {
        self.boards.to_native()
    }
    /// Controllers that switch it.
    #[inline]
    pub fn controllers(&self) -> Range {
        self.controllers.to_native()
    }
    /// Line of the start tag, from 1.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of the start tag in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
    /// What it means: code of a class of docs/ontology.md, 65535 if no table maps it.
    #[inline]
    pub fn class(&self) -> u16 {
        self.class.to_native()
    }
    /// Direction of travel that it is for: 0 both, 1 along s, 2 against s.
    #[inline]
    pub fn orientation(&self) -> u8 {
        self.orientation
    }
    /// 1 if its state changes.
    #[inline]
    pub fn dynamic(&self) -> u8 {
        self.dynamic
    }
    /// Where x, y, z and facing come from: 0 s and t, 1 positionRoad, 2 positionInertial.
    #[inline]
    pub fn position(&self) -> u8 {
        self.position
    }
    /// Lamps of a light: 1 red, 2 yellow, 4 green.
    #[inline]
    pub fn bulbs(&self) -> u8 {
        self.bulbs
    }
    /// What a light can show: 1 red, 2 red and yellow, 4 yellow, 8 green, 16 flashing red, 32 flashing yellow, 64 flashing green, 128 off.
    #[inline]
    pub fn phases(&self) -> u8 {
        self.phases
    }
    /// Movements that a light is for, 0 all: 1 left, 2 straight, 4 right, 8 back.
    #[inline]
    pub fn arrows(&self) -> u8 {
        self.arrows
    }
    /// 1 a value is written, 2 the class has a value, 4 the unit of that value is not written: the country's table or the SI defines it, 8 the class is a speed limit whose stated unit is none of speed.
    #[inline]
    pub fn has_value(&self) -> u8 {
        self.has_value
    }
    /// 1 temporary, 2 invalidated (1.9), 4 s was moved to the road's end.
    #[inline]
    pub fn flags(&self) -> u8 {
        self.flags
    }
}

impl ArchivedSignalPlaceRow {
    /// `[m]` s on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` Lateral place on the road.
    #[inline]
    pub fn t(&self) -> f64 {
        self.t.to_native()
    }
    /// The signal.
    #[inline]
    pub fn signal(&self) -> u32 {
        self.signal.to_native()
    }
    /// The road.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// Lanes that it is for.
    #[inline]
    pub fn lanes(&self) -> Range {
        self.lanes.to_native()
    }
    /// Line of the start tag of signal or signalReference, from 1.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of that start tag in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
    /// Direction of travel that it is for here: 0 both, 1 along s, 2 against s.
    #[inline]
    pub fn orientation(&self) -> u8 {
        self.orientation
    }
    /// 0 the signal itself, 1 a reference to it.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
}

impl ArchivedSignalLaneRow {
    /// The place.
    #[inline]
    pub fn place(&self) -> u32 {
        self.place.to_native()
    }
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
    /// `[m]` Distance of the signal's s and t from the lane's area, in plan view.
    #[inline]
    pub fn distance(&self) -> f32 {
        self.distance.to_native()
    }
    /// How they belong together: 0 validity, 1 orientation (no validity: all lanes that travel that way), 2 s and t, 3 nearest lane, 4 a guess by orientation (the validity names lane 0 alone, and no reference names others).
    #[inline]
    pub fn method(&self) -> u8 {
        self.method
    }
}

impl ArchivedSpeedSignsAtEntryRow {
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
    /// The sign of a limit, which holds over lanes that lead on alone, not beyond a junction.
    #[inline]
    pub fn limit(&self) -> u32 {
        self.limit.to_native()
    }
    /// The sign of a zone, in force until a sign ends it, if it is the same on all lanes that lead here; if `zone_depends` is 1 that of the lowest.
    #[inline]
    pub fn zone(&self) -> u32 {
        self.zone.to_native()
    }
    /// 1: the lanes that lead here are in different zones, or some in one and some in none.
    #[inline]
    pub fn zone_depends(&self) -> u8 {
        self.zone_depends
    }
}

impl ArchivedSignalDependencyRow {
    /// The signal that is named, where the map has it.
    #[inline]
    pub fn signal(&self) -> u32 {
        self.signal.to_native()
    }
    /// dependency/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// dependency/@type.
    #[inline]
    pub fn r#type(&self) -> u32 {
        self.r#type.to_native()
    }
}

impl ArchivedSignalLinkRow {
    /// The signal that is named, where it is one and the map has it.
    #[inline]
    pub fn signal(&self) -> u32 {
        self.signal.to_native()
    }
    /// The object that is named, where it is one and the map has it.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// The signal that names it, itself or by a board that it carries.
    #[inline]
    pub fn owner(&self) -> u32 {
        self.owner.to_native()
    }
    /// reference/@elementId verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// reference/@type.
    #[inline]
    pub fn r#type(&self) -> u32 {
        self.r#type.to_native()
    }
    /// 0 an object, 1 a signal.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
}

impl ArchivedSignalSemanticsRow {
    /// Value as written; 0 if none.
    #[inline]
    pub fn written_value(&self) -> f64 {
        self.written_value.to_native()
    }
    /// Name of the element, such as `speed`.
    #[inline]
    pub fn element(&self) -> u32 {
        self.element.to_native()
    }
    /// Its type, such as `maximum`.
    #[inline]
    pub fn kind(&self) -> u32 {
        self.kind.to_native()
    }
    /// Unit as written.
    #[inline]
    pub fn unit(&self) -> u32 {
        self.unit.to_native()
    }
    /// What it means, as in `signals`.
    #[inline]
    pub fn class(&self) -> u16 {
        self.class.to_native()
    }
}

impl ArchivedSignalBoardRow {
    /// `[m]` vmsBoard/@displayWidth; −1 if not given.
    #[inline]
    pub fn width(&self) -> f64 {
        self.width.to_native()
    }
    /// `[m]` vmsBoard/@displayHeight; −1 if not given.
    #[inline]
    pub fn height(&self) -> f64 {
        self.height.to_native()
    }
    /// `[m]` Lateral place on the carrier.
    #[inline]
    pub fn v(&self) -> f64 {
        self.v.to_native()
    }
    /// `[m]` Height on the carrier.
    #[inline]
    pub fn z(&self) -> f64 {
        self.z.to_native()
    }
    /// The signal that carries it.
    #[inline]
    pub fn signal(&self) -> u32 {
        self.signal.to_native()
    }
    /// vmsBoard/@displayType.
    #[inline]
    pub fn display(&self) -> u32 {
        self.display.to_native()
    }
    /// Its display areas in file order.
    #[inline]
    pub fn areas(&self) -> Range {
        self.areas.to_native()
    }
    /// Lane numbers that it is written to hold for.
    #[inline]
    pub fn validities(&self) -> Range {
        self.validities.to_native()
    }
    /// Signals that it controls or depends on.
    #[inline]
    pub fn dependencies(&self) -> Range {
        self.dependencies.to_native()
    }
    /// Objects and signals that belong to it.
    #[inline]
    pub fn links(&self) -> Range {
        self.links.to_native()
    }
}

impl ArchivedDisplayAreaRow {
    /// `[m]` displayArea/@width; −1 if not given as a number.
    #[inline]
    pub fn width(&self) -> f64 {
        self.width.to_native()
    }
    /// `[m]` displayArea/@height; −1 if not given as a number.
    #[inline]
    pub fn height(&self) -> f64 {
        self.height.to_native()
    }
    /// `[m]` Lateral place on the carrier.
    #[inline]
    pub fn v(&self) -> f64 {
        self.v.to_native()
    }
    /// `[m]` Height on the carrier.
    #[inline]
    pub fn z(&self) -> f64 {
        self.z.to_native()
    }
    /// The board.
    #[inline]
    pub fn board(&self) -> u32 {
        self.board.to_native()
    }
    /// displayArea/@index; −1 if not given.
    #[inline]
    pub fn index(&self) -> i32 {
        self.index.to_native()
    }
}

impl ArchivedBoardGroupRow {
    /// vmsGroup/@id.
    #[inline]
    pub fn group(&self) -> u32 {
        self.group.to_native()
    }
    /// The signal that carries the board, where the map has it.
    #[inline]
    pub fn signal(&self) -> u32 {
        self.signal.to_native()
    }
    /// vmsBoardReference/@signalId verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// Number of the board at the signal; −1 if not given.
    #[inline]
    pub fn board(&self) -> i32 {
        self.board.to_native()
    }
    /// Rank in the group; −1 if not given.
    #[inline]
    pub fn rank(&self) -> i32 {
        self.rank.to_native()
    }
}

impl ArchivedControllerRow {
    /// controller/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// controller/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// controller/@sequence; −1 if not given.
    #[inline]
    pub fn sequence(&self) -> i32 {
        self.sequence.to_native()
    }
    /// Its signals, in file order.
    #[inline]
    pub fn controls(&self) -> Range {
        self.controls.to_native()
    }
    /// Line of the start tag, from 1.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of the start tag in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
}

impl ArchivedControlRow {
    /// The signal, where the map has it.
    #[inline]
    pub fn signal(&self) -> u32 {
        self.signal.to_native()
    }
    /// control/@signalId verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// control/@type.
    #[inline]
    pub fn r#type(&self) -> u32 {
        self.r#type.to_native()
    }
}

impl ArchivedJunctionControllerRow {
    /// The junction.
    #[inline]
    pub fn junction(&self) -> u32 {
        self.junction.to_native()
    }
    /// The controller, where the map has it.
    #[inline]
    pub fn controller(&self) -> u32 {
        self.controller.to_native()
    }
    /// controller/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// controller/@type.
    #[inline]
    pub fn r#type(&self) -> u32 {
        self.r#type.to_native()
    }
    /// Rank in the junction's sequence; −1 if not given.
    #[inline]
    pub fn sequence(&self) -> i32 {
        self.sequence.to_native()
    }
}

impl ArchivedJunctionPriorityRow {
    /// The junction.
    #[inline]
    pub fn junction(&self) -> u32 {
        self.junction.to_native()
    }
    /// Road with priority, where the map has it.
    #[inline]
    pub fn high(&self) -> u32 {
        self.high.to_native()
    }
    /// Road that gives way, where the map has it.
    #[inline]
    pub fn low(&self) -> u32 {
        self.low.to_native()
    }
}

impl ArchivedDefaultSpeedRow {
    /// `[m/s]` Speed limit.
    #[inline]
    pub fn max(&self) -> f64 {
        self.max.to_native()
    }
    /// Road type code.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
}

impl ArchivedQuarantinedRow {
    /// `[m]` Smallest x of the part, inertial; 0 if not known.
    #[inline]
    pub fn min_x(&self) -> f64 {
        self.min_x.to_native()
    }
    /// `[m]` Smallest y of the part.
    #[inline]
    pub fn min_y(&self) -> f64 {
        self.min_y.to_native()
    }
    /// `[m]` Largest x of the part.
    #[inline]
    pub fn max_x(&self) -> f64 {
        self.max_x.to_native()
    }
    /// `[m]` Largest y of the part.
    #[inline]
    pub fn max_y(&self) -> f64 {
        self.max_y.to_native()
    }
    /// `[m]` Length of a road as written; 0 for other parts.
    #[inline]
    pub fn length(&self) -> f64 {
        self.length.to_native()
    }
    /// Id of the part; of a lane link `connection:from:to`.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// Id of the road or junction that it belongs to; its own for these.
    #[inline]
    pub fn owner(&self) -> u32 {
        self.owner.to_native()
    }
    /// Id of the rule whose finding is the reason.
    #[inline]
    pub fn rule(&self) -> u32 {
        self.rule.to_native()
    }
    /// What the finding says.
    #[inline]
    pub fn message(&self) -> u32 {
        self.message.to_native()
    }
    /// Line of the finding, from 1.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of the finding in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
    /// 0 road, 1 junction, 2 connection, 3 object, 4 signal, 5 controller, 6 other group, 7 lane link.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
    /// 0 left out, 1 kept as reference line.
    #[inline]
    pub fn treatment(&self) -> u8 {
        self.treatment
    }
    /// 1 if the extent is known.
    #[inline]
    pub fn has_extent(&self) -> u8 {
        self.has_extent
    }
    /// What the owner is, as `kind`.
    #[inline]
    pub fn owner_kind(&self) -> u8 {
        self.owner_kind
    }
}

impl ArchivedQuarantinedFileRow {
    /// The part.
    #[inline]
    pub fn part(&self) -> u32 {
        self.part.to_native()
    }
    /// Name of the included file, without its folder.
    #[inline]
    pub fn file(&self) -> u32 {
        self.file.to_native()
    }
}

impl ArchivedQuarantinedContentRow {
    /// Id of the object or signal.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// The road or junction.
    #[inline]
    pub fn part(&self) -> u32 {
        self.part.to_native()
    }
    /// As `kind` of the part.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
}
