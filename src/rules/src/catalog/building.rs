//! What only building the map finds. The compiler writes findings of these rules and of no others: it has no ids of its own.
//!
//! They say what was built of what is written, which is the same in every profile; that the standard forbids it is for other rules.

use crate::example::Example::{
    self, Document, File, Header, Junction, Lane, Lanes, Objects, PlanView, Road, Section, Signals,
    Words,
};
use crate::rule::Check::Building;
use crate::rule::{Rule, Tolerance};
use mapd_xodr::Severity;

const fn error(id: &'static str, words: [&'static str; 2], examples: [Example; 2]) -> Rule {
    Rule::error(id, words, Building, examples)
}

const fn warning(id: &'static str, meaning: &'static str, examples: [Example; 2]) -> Rule {
    Rule::warning(id, meaning, Building, examples).strict(Severity::Warning)
}

const fn info(id: &'static str, meaning: &'static str, examples: [Example; 2]) -> Rule {
    Rule::info(id, meaning, Building, examples)
}

const SOUND: Example = Header("");
const POLE: Example =
    Objects(r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"/>"#);
const SIGNAL: Example = Signals(
    r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE"/>"#,
);

/// What a part is built from is missing or cannot be read, and the reader has no error about it.
pub const UNUSABLE: Rule = error(
    "mapd:compile.unusable",
    [
        "Data that the map is built from is present and can be read.",
        "nothing can be built without it",
    ],
    [
        File(
            r#"<OpenDRIVE><header revMajor="1" revMinor="4"/><road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road></OpenDRIVE>"#,
        ),
        File(
            r#"<OpenDRIVE><header revMajor="1" revMinor="4"/><road id="1" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road></OpenDRIVE>"#,
        ),
    ],
)
.fixed();

/// A parametric cubic without `pRange`.
pub const P_RANGE: Rule = warning(
    "mapd:compile.p_range",
    "A parametric cubic states its parameter range; otherwise it is read as normalized.",
    [
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" bU="100" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/></geometry>"#,
        ),
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" bU="100" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0"/></geometry>"#,
        ),
    ],
);

/// A record or link that lacks its place or number, and is left out alone.
pub const RECORD: Rule = warning(
    "mapd:compile.record",
    "A record states where it begins, and a lane's link names a lane; otherwise it is left out.",
    [
        Lane(r#"<speed sOffset="0" max="50" unit="km/h"/>"#),
        Lane(r#"<speed max="50" unit="km/h"/>"#),
    ],
);

/// A second layer of one kind.
pub const LANE_LAYER: Rule = info(
    "mapd:compile.lane_layer",
    "A road has one layer of each kind of lanes; others are not built.",
    [
        SOUND,
        Road(
            r#"<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes>"#,
        ),
    ],
);

/// A map without roads.
pub const NO_ROADS: Rule = warning(
    "mapd:compile.no_roads",
    "A map has roads.",
    [SOUND, File(r#"<OpenDRIVE><header revMajor="1" revMinor="8"/></OpenDRIVE>"#)],
);

/// Tables or lanes outgrow their limits.
pub const TOO_LARGE: Rule = error(
    "mapd:compile.too_large",
    [
        "A map is within the limits of its tables, a lane within those of a line; reading.md lists them.",
        "the archive has no room for it",
    ],
    [
        SOUND,
        Words("a lane that needs more than 65,535 points"),
    ],
)
.fixed();

/// So many roads lie over one another that the search for overlaps was cut short.
pub const OVERLAPS: Rule = warning(
    "mapd:compile.overlaps",
    "Few roads overlap; otherwise not all overlaps are searched.",
    [SOUND, Words("a map of many copies of the same roads")],
);

/// Something that is read, and not built.
pub const UNSUPPORTED: Rule = info(
    "mapd:compile.unsupported",
    "Everything in a file is built into the map.",
    [
        SOUND,
        Road(
            r#"<surface><CRG file="a.crg" sStart="0" sEnd="10" orientation="same" mode="attached"/></surface>"#,
        ),
    ],
);

/// A section for one side that has lanes of both.
pub const SINGLE_SIDE: Rule = warning(
    "mapd:compile.single_side",
    "A section for one side has lanes only on that side, and follows a section for the other side.",
    [
        SOUND,
        Lanes(
            r#"<laneSection s="0" singleSide="true"><center><lane id="0"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection>"#,
        ),
    ],
);

/// No lane 0.
pub const CENTER_LANE: Rule = warning(
    "mapd:compile.center_lane",
    "A section has a lane 0; otherwise the reference line takes its place.",
    [
        Section(
            r#"<center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#,
        ),
        Section(
            r#"<right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#,
        ),
    ],
);

/// An elevation grid that cannot be used.
pub const ELEVATION_GRID: Rule = warning(
    "mapd:compile.elevation_grid",
    "An elevation grid has one straight reference line of its junction and readable numbers; otherwise its roads keep their own heights.",
    [
        Junction(r#"<junction id="9" name=""/>"#),
        Junction(
            r#"<junction id="9" name=""><elevationGrid sStart="0" gridSpacing="5"/></junction>"#,
        ),
    ],
);

/// A part of an object that is left out.
pub const OBJECT_PART: Rule = warning(
    "mapd:compile.object_part",
    "The parts of an object can be built: an outline has two corners or a curve, and a number of points within the limits.",
    [
        POLE,
        Objects(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"><outlines><outline id="0"><cornerLocal id="0" u="1" v="1" z="0" height="1"/></outline></outlines></object>"#,
        ),
    ],
);

/// An object whose place overflows.
pub const OBJECT_PLACE: Rule = error(
    "mapd:compile.object_place",
    ["An object has a position, within the range of numbers.", "it has no position"],
    [POLE, Words("an object whose place beside its reference line no number can hold")],
)
.fixed();

/// A repetition that is left out in part.
pub const OBJECT_REPEAT: Rule = warning(
    "mapd:compile.object_repeat",
    "The copies of a repetition are on the road, and their number is within the limits.",
    [
        Objects(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"><repeat s="10" length="20" distance="5" tStart="4" tEnd="4" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/></object>"#,
        ),
        Objects(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"><repeat s="10" length="20" distance="0.00001" tStart="4" tEnd="4" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/></object>"#,
        ),
    ],
);

/// A number without its unit.
pub const ASSUMED_UNIT: Rule = info(
    "mapd:compile.assumed_unit",
    "A value has a unit; otherwise the usual unit is assumed.",
    [
        POLE,
        Objects(
            r#"<object id="1" name="Speed_30" type="none" s="10" t="4" zOffset="0" orientation="none"/>"#,
        ),
    ],
);

/// A speed limit that is stated and unknown.
pub const SPEED_LIMIT: Rule = warning(
    "mapd:compile.speed_limit",
    "A speed limit is a number that is not negative, in a unit of speed or in m/s without one; otherwise it is unknown.",
    [
        Lane(r#"<speed sOffset="0" max="50" unit="km/h"/>"#),
        Lane(r#"<speed sOffset="0" max="50" unit="knots"/>"#),
    ],
);

/// Largest limit without a unit that may be meant in m/s: 130 km/h are 36 m/s, and 50 without a unit is a town's limit in km/h.
pub const MOST_WITHOUT_UNIT: Tolerance =
    Tolerance { name: "speed limit without a unit", value: 40.0, unit: "m/s" };
/// Largest limit of any road: no country has one, and the fastest cars hardly pass it.
pub const MOST_SPEED: Tolerance =
    Tolerance { name: "speed limit", value: 400.0 / 3.6, unit: "m/s" };

/// A speed limit that no road has.
pub const SPEED_PLAUSIBLE: Rule = warning(
    "mapd:compile.speed_plausible",
    "A speed limit is one that roads have: a larger one has the wrong unit or none.",
    [
        Lane(r#"<speed sOffset="0" max="50" unit="km/h"/>"#),
        Lane(r#"<speed sOffset="0" max="50"/>"#),
    ],
)
.within(&[MOST_WITHOUT_UNIT, MOST_SPEED]);

/// An object far from all lanes.
pub const OBJECT_LANE: Rule = info(
    "mapd:compile.object_lane",
    "An object is near a lane that it may belong to.",
    [
        POLE,
        Objects(r#"<object id="1" type="pole" s="10" t="900" zOffset="0" orientation="none"/>"#),
    ],
);

/// A signal for no lane.
pub const SIGNAL_LANES: Rule = warning(
    "mapd:compile.signal_lanes",
    "A signal applies to a lane; otherwise it is kept on the road.",
    [
        SIGNAL,
        Signals(
            r#"<signal id="2" s="50" t="-700" zOffset="3" dynamic="yes" orientation="+" country="OpenDRIVE" type="1000001" subtype="-1"><validity fromLane="-9" toLane="-9"/></signal>"#,
        ),
    ],
);

/// A signal that shows its back to its traffic.
pub const SIGNAL_FACING: Rule = warning(
    "mapd:compile.signal_facing",
    "A signal faces the traffic that it is for; one that shows its back to all of its lanes is turned round.",
    [
        SIGNAL,
        Signals(
            r#"<signal id="1" s="10" t="-4" zOffset="2" hOffset="3.14" dynamic="no" orientation="+" type="274" subtype="50" country="DE"/>"#,
        ),
    ],
);

/// A zone of a speed limit that no sign ends.
pub const ZONE_END: Rule = warning(
    "mapd:compile.zone_end",
    "A sign ends a speed zone on each way out of it; otherwise what holds behind depends on the way that one has come.",
    [
        File(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="-60" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes><signals><signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" country="DE" type="274.1" subtype="-1" value="30" unit="km/h"/><signal id="2" s="40" t="-4" zOffset="2" dynamic="no" orientation="+" country="DE" type="274.2" subtype="-1"/></signals></road>
<road id="2" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="0" y="-60" hdg="1.5707963267948966" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="3" length="20" junction="9"><link><predecessor elementType="road" elementId="1" contactPoint="end"/><successor elementType="road" elementId="5" contactPoint="start"/></link><planView><geometry s="0" x="-10" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="4" length="15.707963267948966" junction="9"><link><predecessor elementType="road" elementId="2" contactPoint="end"/><successor elementType="road" elementId="5" contactPoint="start"/></link><planView><geometry s="0" x="0" y="-10" hdg="1.5707963267948966" length="15.707963267948966"><arc curvature="-0.1"/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="5" length="50" junction="-1"><link><predecessor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="10" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9"><connection id="0" incomingRoad="1" connectingRoad="3" contactPoint="start"><laneLink from="-1" to="-1"/></connection><connection id="1" incomingRoad="2" connectingRoad="4" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction></OpenDRIVE>"#,
        ),
        File(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="-60" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes><signals><signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" country="DE" type="274.1" subtype="-1" value="30" unit="km/h"/></signals></road>
<road id="2" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="0" y="-60" hdg="1.5707963267948966" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="3" length="20" junction="9"><link><predecessor elementType="road" elementId="1" contactPoint="end"/><successor elementType="road" elementId="5" contactPoint="start"/></link><planView><geometry s="0" x="-10" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="4" length="15.707963267948966" junction="9"><link><predecessor elementType="road" elementId="2" contactPoint="end"/><successor elementType="road" elementId="5" contactPoint="start"/></link><planView><geometry s="0" x="0" y="-10" hdg="1.5707963267948966" length="15.707963267948966"><arc curvature="-0.1"/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="5" length="50" junction="-1"><link><predecessor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="10" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9"><connection id="0" incomingRoad="1" connectingRoad="3" contactPoint="start"><laneLink from="-1" to="-1"/></connection><connection id="1" incomingRoad="2" connectingRoad="4" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction></OpenDRIVE>"#,
        ),
    ],
);

/// A reference to a signal that is not there.
pub const SIGNAL_REFERENCE: Rule = warning(
    "mapd:compile.signal_reference",
    "A reference names a signal that the map has.",
    [
        Signals(
            r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE"/><signalReference id="1" s="20" t="0" orientation="+"/>"#,
        ),
        Signals(
            r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE"/><signalReference id="2" s="20" t="0" orientation="+"/>"#,
        ),
    ],
);

/// An access record that does not say who is meant.
pub const ACCESS: Rule = warning(
    "mapd:compile.access",
    "An access record says who is meant in words of the standard; otherwise `deny` closes to all motor vehicles, and `allow` opens to nobody. `lorry` and `trucks` are read as `truck`.",
    [
        Lane(r#"<access sOffset="0" rule="deny"><restriction type="truck"/></access>"#),
        Lane(r#"<access sOffset="0" rule="deny"><restriction type="van"/></access>"#),
    ],
);

/// A link between roads without `contactPoint`.
pub const CONTACT_POINT: Rule = warning(
    "mapd:compile.contact_point",
    "A link to a road has a contact point; otherwise the nearer end is taken.",
    [
        TWO_ROADS,
        Document(
            r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road>"#,
        ),
    ],
);

/// A georeference that cannot be used, or with warnings.
pub const GEO_REFERENCE: Rule = warning(
    "mapd:compile.geo_reference",
    "A georeference can be used without warnings, and the map is in its area.",
    [
        Header("<geoReference>+proj=utm +zone=32 +datum=WGS84</geoReference>"),
        Header("<geoReference>somewhere</geoReference>"),
    ],
);

/// An offset whose sign is turned.
pub const OFFSET_SIGN: Rule = warning(
    "mapd:compile.offset_sign",
    "The header's offset is added to inertial coordinates.",
    [
        SOUND,
        Words(
            "a map whose offset leads out of its georeference's area, and whose turned offset does not",
        ),
    ],
);

/// An offset that turns and shifts.
pub const OFFSET_ORDER: Rule = warning(
    "mapd:compile.offset_order",
    "An offset shifts or rotates, not both: the standard contradicts itself on the order.",
    [
        Header(
            r#"<geoReference>+proj=utm +zone=32 +datum=WGS84</geoReference><offset x="500000" y="5400000" z="0" hdg="0"/>"#,
        ),
        Header(
            r#"<geoReference>+proj=utm +zone=32 +datum=WGS84</geoReference><offset x="500000" y="5400000" z="0" hdg="1"/>"#,
        ),
    ],
);

/// A map beyond the bounds that its header states.
pub const STATED_BOUNDS: Rule = warning(
    "mapd:compile.stated_bounds",
    "A map is within the bounds that its header states.",
    [
        SOUND,
        File(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8" north="1" south="0" east="1" west="0"/><road id="1" length="900" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="900"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>"#,
        ),
    ],
);

/// A frame that the map cannot be moved into.
pub const TARGET_FRAME: Rule = error(
    "mapd:compile.target_frame",
    [
        "With --crs, the map and each of its roads have a place in the target frame.",
        "it has no coordinates there",
    ],
    [
        SOUND,
        Words("with --crs: a map without a georeference, or a road outside of the target's area"),
    ],
)
.fixed();

/// More is lost than the policy allows.
pub const QUARANTINE: Rule = error(
    "mapd:compile.quarantine",
    [
        "No more parts are left out than --max-quarantined and --max-quarantined-share allow.",
        "the user's limit excludes a map with larger gaps",
    ],
    [SOUND, Words("with --max-quarantined 0: a map with a part that is left out")],
)
.fixed();

/// A cycle within one junction.
pub const JUNCTION_CYCLE: Rule = error(
    "mapd:graph.junction_cycle",
    [
        "Every route through a junction leaves it.",
        "following successors within the junction never ends",
    ],
    [
        SOUND,
        Document(
            r#"<road id="5" length="20" junction="7"><link><predecessor elementType="road" elementId="6" contactPoint="end"/><successor elementType="road" elementId="6" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="6" length="20" junction="7"><link><predecessor elementType="road" elementId="5" contactPoint="end"/><successor elementType="road" elementId="5" contactPoint="start"/></link><planView><geometry s="0" x="20" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road><junction id="7" name=""/>"#,
        ),
    ],
);

/// A cycle without any length.
pub const NO_PROGRESS: Rule = error(
    "mapd:graph.no_progress",
    ["A loop is longer than 1 m.", "following successors there makes no progress"],
    [
        SOUND,
        Document(
            r#"<road id="1" length="0.04" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/><successor elementType="road" elementId="1" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="0.04"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#,
        ),
    ],
);

/// A loop that the policy of cycles forbids or tells.
pub const CYCLE: Rule = error(
    "mapd:graph.cycle",
    [
        "With --cycles all, the lane graph has no loop; with --cycles report, each is reported as information.",
        "the user asked for a map without loops",
    ],
    [SOUND, Words("with --cycles all: a road that is its own successor")],
);

/// A link to a lane that is not there.
pub const MISSING_LANE: Rule = error(
    "mapd:graph.missing_lane",
    [
        "A link names an existing lane.",
        "a lane link begins or ends at no lane; a lane's own link is left out (warning)",
    ],
    [
        Junction(
            r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#,
        ),
        Junction(
            r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-7"/></connection></junction>"#,
        ),
    ],
);

const TWO_ROADS: Example = Document(
    r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#,
);

/// A link into a lane that travels the other way.
pub const DIRECTION: Rule = warning(
    "mapd:graph.direction",
    "A link leads into a lane with the same direction of travel; otherwise it is not used.",
    [
        TWO_ROADS,
        Document(
            r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><link><successor id="1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><left><lane id="1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></left><center><lane id="0"/></center></laneSection></lanes></road>"#,
        ),
    ],
);

/// A virtual connection or path across that ends nowhere.
pub const NO_PLACE: Rule = warning(
    "mapd:graph.no_place",
    "A virtual connection or a path across names an existing road, place and lane; otherwise it is not used.",
    [
        Junction(r#"<junction id="9" name=""/>"#),
        Words("a virtual junction whose connection touches its main road behind the road's end"),
    ],
);

/// Largest distance between two linked lanes' ends that is no finding: files round to centimetres, and tools snap to decimetres.
pub const JOINT: Tolerance = Tolerance { name: "gap", value: 0.1, unit: "m" };

/// Linked lanes that do not meet.
pub const GAP: Rule = warning(
    "mapd:graph.gap",
    "Linked lanes meet; otherwise they are linked as written.",
    [
        TWO_ROADS,
        Document(
            r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="5" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#,
        ),
    ],
)
.within(&[JOINT]);

/// A junction with too many lanes to look for conflicts.
pub const CONFLICTS: Rule = warning(
    "mapd:graph.conflicts",
    "The number of lanes in a junction is within the limit of the search for conflicts.",
    [Junction(r#"<junction id="9" name=""/>"#), Words("a junction of more than 512 lanes")],
);

pub(super) static RULES: &[&[Rule]] = &[&[
    UNUSABLE,
    P_RANGE,
    RECORD,
    LANE_LAYER,
    NO_ROADS,
    TOO_LARGE,
    OVERLAPS,
    UNSUPPORTED,
    SINGLE_SIDE,
    CENTER_LANE,
    ELEVATION_GRID,
    OBJECT_PART,
    OBJECT_PLACE,
    OBJECT_REPEAT,
    ASSUMED_UNIT,
    SPEED_LIMIT,
    SPEED_PLAUSIBLE,
    OBJECT_LANE,
    SIGNAL_LANES,
    SIGNAL_FACING,
    ZONE_END,
    SIGNAL_REFERENCE,
    ACCESS,
    CONTACT_POINT,
    GEO_REFERENCE,
    OFFSET_SIGN,
    OFFSET_ORDER,
    STATED_BOUNDS,
    TARGET_FRAME,
    QUARANTINE,
    JUNCTION_CYCLE,
    NO_PROGRESS,
    CYCLE,
    MISSING_LANE,
    DIRECTION,
    NO_PLACE,
    GAP,
    CONFLICTS,
]];
