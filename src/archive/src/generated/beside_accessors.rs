//! Reading the rows of what lies beside the network.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::rows::*;
use crate::table::Range;
use rkyv::rend;

impl ArchivedSurfaceRow {
    /// The road.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// Stations of the lateral shape, ascending in s (OpenDRIVE 1.8.1, 10.5.3).
    #[inline]
    pub fn shapes(&self) -> Range {
        self.shapes.to_native()
    }
    /// Crossfall `[rad]` over s left of the reference line; positive falls outwards (OpenDRIVE 1.4, 1.5).
    #[inline]
    pub fn crossfall_left(&self) -> Range {
        self.crossfall_left.to_native()
    }
    /// Crossfall `[rad]` over s right of the reference line; positive falls outwards.
    #[inline]
    pub fn crossfall_right(&self) -> Range {
        self.crossfall_right.to_native()
    }
    /// t `[m]` over s from which the strips count.
    #[inline]
    pub fn strip_offset(&self) -> Range {
        self.strip_offset.to_native()
    }
    /// Strips of the cross-section surface (OpenDRIVE 1.8.1, 10.6).
    #[inline]
    pub fn strips(&self) -> Range {
        self.strips.to_native()
    }
}

impl ArchivedShapeStationRow {
    /// `[m]` Place on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// Height `[m]` over t: each record starts at the t `[m]` in its field `s`.
    #[inline]
    pub fn records(&self) -> Range {
        self.records.to_native()
    }
}

impl ArchivedSurfaceStripRow {
    /// Width `[m]` over s; empty for a strip without an outer end.
    #[inline]
    pub fn width(&self) -> Range {
        self.width.to_native()
    }
    /// Constant part `[m]` over s.
    #[inline]
    pub fn constant(&self) -> Range {
        self.constant.to_native()
    }
    /// Linear part over s.
    #[inline]
    pub fn linear(&self) -> Range {
        self.linear.to_native()
    }
    /// Quadratic part `[1/m]` over s.
    #[inline]
    pub fn quadratic(&self) -> Range {
        self.quadratic.to_native()
    }
    /// Cubic part `[1/m²]` over s.
    #[inline]
    pub fn cubic(&self) -> Range {
        self.cubic.to_native()
    }
    /// strip/@id: 1 and 2 to the left, −1 and −2 to the right, from the middle outwards.
    #[inline]
    pub fn id(&self) -> i32 {
        self.id.to_native()
    }
    /// 0 absolute, 1 relative to the inner strip's outer edge.
    #[inline]
    pub fn mode(&self) -> u32 {
        self.mode.to_native()
    }
}

impl ArchivedLaneHeightRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` Height at the edge nearer to lane 0.
    #[inline]
    pub fn inner(&self) -> f64 {
        self.inner.to_native()
    }
    /// `[m]` Height at the edge away from lane 0.
    #[inline]
    pub fn outer(&self) -> f64 {
        self.outer.to_native()
    }
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
}

impl ArchivedLaneMaterialRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// Friction coefficient; −1 if not given.
    #[inline]
    pub fn friction(&self) -> f64 {
        self.friction.to_native()
    }
    /// Roughness as written; −1 if not given.
    #[inline]
    pub fn roughness(&self) -> f64 {
        self.roughness.to_native()
    }
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
    /// material/@surface.
    #[inline]
    pub fn surface(&self) -> u32 {
        self.surface.to_native()
    }
}

impl ArchivedElevationGridRow {
    /// `[m]` Start of the junction's reference line, relative to the local origin.
    #[inline]
    pub fn x(&self) -> f64 {
        self.x.to_native()
    }
    /// `[m]` Start of the junction's reference line, relative to the local origin.
    #[inline]
    pub fn y(&self) -> f64 {
        self.y.to_native()
    }
    /// Cosine of the line's heading.
    #[inline]
    pub fn cos(&self) -> f64 {
        self.cos.to_native()
    }
    /// Sine of the line's heading.
    #[inline]
    pub fn sin(&self) -> f64 {
        self.sin.to_native()
    }
    /// `[m]` First row's place on the line.
    #[inline]
    pub fn s_start(&self) -> f64 {
        self.s_start.to_native()
    }
    /// `[m]` Distance between rows, and between points of a row.
    #[inline]
    pub fn spacing(&self) -> f64 {
        self.spacing.to_native()
    }
    /// The junction.
    #[inline]
    pub fn junction(&self) -> u32 {
        self.junction.to_native()
    }
    /// Rows along the line.
    #[inline]
    pub fn rows(&self) -> Range {
        self.rows.to_native()
    }
    /// Joints at which the roads' own heights pass into the grid's.
    #[inline]
    pub fn transitions(&self) -> Range {
        self.transitions.to_native()
    }
}

impl ArchivedGridRowRow {
    /// `[m]` Height on the reference line.
    #[inline]
    pub fn center(&self) -> f64 {
        self.center.to_native()
    }
    /// Heights to the left `[m]`.
    #[inline]
    pub fn left(&self) -> Range {
        self.left.to_native()
    }
    /// Heights to the right `[m]`.
    #[inline]
    pub fn right(&self) -> Range {
        self.right.to_native()
    }
}

impl ArchivedGridTransitionRow {
    /// `[m]` One end of the joint, relative to the local origin.
    #[inline]
    pub fn start_x(&self) -> f64 {
        self.start_x.to_native()
    }
    /// `[m]` One end of the joint.
    #[inline]
    pub fn start_y(&self) -> f64 {
        self.start_y.to_native()
    }
    /// `[m]` The other end of the joint.
    #[inline]
    pub fn end_x(&self) -> f64 {
        self.end_x.to_native()
    }
    /// `[m]` The other end of the joint.
    #[inline]
    pub fn end_y(&self) -> f64 {
        self.end_y.to_native()
    }
    /// `[m]` Length of the transition into the junction.
    #[inline]
    pub fn length(&self) -> f64 {
        self.length.to_native()
    }
}

impl ArchivedGraphRow {
    /// `[m]` Unit of `landmark_lengths`.
    #[inline]
    pub fn length_step(&self) -> f64 {
        self.length_step.to_native()
    }
    /// `[s]` Unit of `landmark_times`.
    #[inline]
    pub fn time_step(&self) -> f64 {
        self.time_step.to_native()
    }
    /// `[m]` What a change of lane counts in `landmark_lengths`.
    #[inline]
    pub fn change_length(&self) -> f64 {
        self.change_length.to_native()
    }
    /// `[s]` What a change of lane counts in `landmark_times`.
    #[inline]
    pub fn change_time(&self) -> f64 {
        self.change_time.to_native()
    }
    /// Number of strongly connected components.
    #[inline]
    pub fn components(&self) -> u32 {
        self.components.to_native()
    }
    /// Number of nodes with a place in `landmark_lengths` and `landmark_times`.
    #[inline]
    pub fn bounds(&self) -> u32 {
        self.bounds.to_native()
    }
    /// Number of landmarks; 0 if the map has none.
    #[inline]
    pub fn landmarks(&self) -> u32 {
        self.landmarks.to_native()
    }
}

impl ArchivedLaneNodeRow {
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
    /// Node beside it, in driving direction to the left, that travels the same way.
    #[inline]
    pub fn left(&self) -> u32 {
        self.left.to_native()
    }
    /// Node beside it, in driving direction to the right, that travels the same way.
    #[inline]
    pub fn right(&self) -> u32 {
        self.right.to_native()
    }
    /// Strongly connected component, numbered in topological order of the condensation.
    #[inline]
    pub fn component(&self) -> u32 {
        self.component.to_native()
    }
    /// Place in `landmark_lengths` and `landmark_times`; u32::MAX if no motor vehicle may use the node.
    #[inline]
    pub fn bound(&self) -> u32 {
        self.bound.to_native()
    }
    /// `[m]` Smaller end of the piece, from the section's start.
    #[inline]
    pub fn s_from(&self) -> f32 {
        self.s_from.to_native()
    }
    /// `[m]` Length of the centre line in plan view.
    #[inline]
    pub fn length(&self) -> f32 {
        self.length.to_native()
    }
    /// `[s]` Time to pass it at the speed limit.
    #[inline]
    pub fn time(&self) -> f32 {
        self.time.to_native()
    }
    /// Bit i: vehicle class i may use it.
    #[inline]
    pub fn access(&self) -> u16 {
        self.access.to_native()
    }
    /// 1 travels towards +s, 2 change to the left allowed, 4 change to the right allowed.
    #[inline]
    pub fn flags(&self) -> u8 {
        self.flags
    }
}

impl ArchivedEdgeRow {
    /// Line of the link, from 1; 0 where no link is needed.
    #[inline]
    pub fn line(&self) -> u32 {
        self.line.to_native()
    }
    /// Column of the link in bytes, from 1.
    #[inline]
    pub fn column(&self) -> u32 {
        self.column.to_native()
    }
    /// 0 for the document itself, else the number of the included file.
    #[inline]
    pub fn file(&self) -> u16 {
        self.file.to_native()
    }
    /// 0 within a lane, 1 link inside a road, 2 link over a road's end, 3 lane link of a connection, 4 implied by a connection without lane links, 5 at a virtual junction.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
    /// 1 closes a loop: without these edges the graph has no cycle.
    #[inline]
    pub fn flags(&self) -> u8 {
        self.flags
    }
}

impl ArchivedConflictRow {
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
    /// The lane that it conflicts with.
    #[inline]
    pub fn other(&self) -> u32 {
        self.other.to_native()
    }
    /// `[m]` Start of the common area on `lane`, from its section's start.
    #[inline]
    pub fn s_from(&self) -> f32 {
        self.s_from.to_native()
    }
    /// `[m]` End of the common area on `lane`.
    #[inline]
    pub fn s_to(&self) -> f32 {
        self.s_to.to_native()
    }
    /// `[m]` Start of the common area on `other`, from its section's start.
    #[inline]
    pub fn other_from(&self) -> f32 {
        self.other_from.to_native()
    }
    /// `[m]` End of the common area on `other`.
    #[inline]
    pub fn other_to(&self) -> f32 {
        self.other_to.to_native()
    }
    /// 0 cross, 1 merge, 2 overlap, 3 crossing of roads.
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
    /// Id of the part.
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
    /// 0 road, 1 junction, 2 connection, 3 object, 4 signal, 5 controller, 6 other group.
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
}

impl ArchivedObjectRow {
    /// `[m]` x of the object's origin relative to the local origin.
    #[inline]
    pub fn x(&self) -> f64 {
        self.x.to_native()
    }
    /// `[m]` y of the object's origin relative to the local origin.
    #[inline]
    pub fn y(&self) -> f64 {
        self.y.to_native()
    }
    /// `[m]` z of the object's origin: elevation of the reference line at s plus zOffset.
    #[inline]
    pub fn z(&self) -> f64 {
        self.z.to_native()
    }
    /// `[m]` object/@s as written.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` object/@t as written.
    #[inline]
    pub fn t(&self) -> f64 {
        self.t.to_native()
    }
    /// `[rad]` Inertial heading of the object's u axis, in (−π, π].
    #[inline]
    pub fn heading(&self) -> f64 {
        self.heading.to_native()
    }
    /// `[rad]` Inertial pitch, turned after the heading; positive lowers the front.
    #[inline]
    pub fn pitch(&self) -> f32 {
        self.pitch.to_native()
    }
    /// `[rad]` Inertial roll, turned last; positive lifts the left side.
    #[inline]
    pub fn roll(&self) -> f32 {
        self.roll.to_native()
    }
    /// `[m]` object/@zOffset.
    #[inline]
    pub fn z_offset(&self) -> f32 {
        self.z_offset.to_native()
    }
    /// `[m]` object/@length; 0 if absent.
    #[inline]
    pub fn length(&self) -> f32 {
        self.length.to_native()
    }
    /// `[m]` object/@width; 0 if absent.
    #[inline]
    pub fn width(&self) -> f32 {
        self.width.to_native()
    }
    /// `[m]` object/@height; 0 if absent.
    #[inline]
    pub fn height(&self) -> f32 {
        self.height.to_native()
    }
    /// `[m]` object/@radius; 0 if absent.
    #[inline]
    pub fn radius(&self) -> f32 {
        self.radius.to_native()
    }
    /// `[m]` object/@validLength; 0 if absent.
    #[inline]
    pub fn valid_length(&self) -> f32 {
        self.valid_length.to_native()
    }
    /// object/@id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// object/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// object/@type verbatim.
    #[inline]
    pub fn kind(&self) -> u32 {
        self.kind.to_native()
    }
    /// object/@subtype.
    #[inline]
    pub fn subtype(&self) -> u32 {
        self.subtype.to_native()
    }
    /// Road that it is written in; none for an object of a junction.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// Junction that it is written in.
    #[inline]
    pub fn junction(&self) -> u32 {
        self.junction.to_native()
    }
    /// Outlines in file order.
    #[inline]
    pub fn outlines(&self) -> Range {
        self.outlines.to_native()
    }
    /// Where the object stands if it is repeated; empty if it stands at its own place.
    #[inline]
    pub fn copies(&self) -> Range {
        self.copies.to_native()
    }
    /// Lanes that it belongs to.
    #[inline]
    pub fn lanes(&self) -> Range {
        self.lanes.to_native()
    }
    /// Lane numbers that it is written to hold for.
    #[inline]
    pub fn validities(&self) -> Range {
        self.validities.to_native()
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
    /// Class in mapd's vocabulary.
    #[inline]
    pub fn class(&self) -> u16 {
        self.class.to_native()
    }
    /// 0 point, 1 box, 2 cylinder, 3 outlines.
    #[inline]
    pub fn shape(&self) -> u8 {
        self.shape
    }
    /// Direction of travel that it is for: 0 both or not given, 1 along s, 2 against s.
    #[inline]
    pub fn orientation(&self) -> u8 {
        self.orientation
    }
    /// 1 dynamic, 2 perpendicular to the road, 4 temporary, 8 invalidated, 16 s beyond the road and moved to its end.
    #[inline]
    pub fn flags(&self) -> u8 {
        self.flags
    }
}

impl ArchivedObjectOutlineRow {
    /// Corners in order; a closed outline leads from the last to the first.
    #[inline]
    pub fn points(&self) -> Range {
        self.points.to_native()
    }
    /// outline/@id; u32::MAX if absent.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// What fills it: 0 not given, 1 grass, 2 concrete, 3 cobble, 4 asphalt, 5 pavement, 6 gravel, 7 soil, 8 paint.
    #[inline]
    pub fn fill(&self) -> u8 {
        self.fill
    }
    /// Lane type code that it stands for; 0 if none.
    #[inline]
    pub fn lane_type(&self) -> u8 {
        self.lane_type
    }
    /// 1 outer, 2 closed.
    #[inline]
    pub fn flags(&self) -> u8 {
        self.flags
    }
}

impl ArchivedObjectPointRow {
    /// `[m]` Ahead of the origin.
    #[inline]
    pub fn u(&self) -> f32 {
        self.u.to_native()
    }
    /// `[m]` Left of the origin.
    #[inline]
    pub fn v(&self) -> f32 {
        self.v.to_native()
    }
    /// `[m]` Above the origin.
    #[inline]
    pub fn z(&self) -> f32 {
        self.z.to_native()
    }
    /// `[m]` Height of the object at this corner.
    #[inline]
    pub fn height(&self) -> f32 {
        self.height.to_native()
    }
}

impl ArchivedObjectCopyRow {
    /// `[m]` x of the origin relative to the local origin.
    #[inline]
    pub fn x(&self) -> f64 {
        self.x.to_native()
    }
    /// `[m]` y of the origin relative to the local origin.
    #[inline]
    pub fn y(&self) -> f64 {
        self.y.to_native()
    }
    /// `[m]` z of the origin.
    #[inline]
    pub fn z(&self) -> f64 {
        self.z.to_native()
    }
    /// `[m]` Place on the road; of a swept copy its start.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` Lateral place; of a swept copy at its start.
    #[inline]
    pub fn t(&self) -> f64 {
        self.t.to_native()
    }
    /// `[rad]` Inertial heading of the u axis; 0 for a swept copy.
    #[inline]
    pub fn heading(&self) -> f64 {
        self.heading.to_native()
    }
    /// `[rad]` As in `objects`.
    #[inline]
    pub fn pitch(&self) -> f32 {
        self.pitch.to_native()
    }
    /// `[rad]` As in `objects`.
    #[inline]
    pub fn roll(&self) -> f32 {
        self.roll.to_native()
    }
    /// `[m]` Length; of a swept copy along the road.
    #[inline]
    pub fn length(&self) -> f32 {
        self.length.to_native()
    }
    /// `[m]` Width; of a swept copy at its start.
    #[inline]
    pub fn width(&self) -> f32 {
        self.width.to_native()
    }
    /// `[m]` Height; of a swept copy at its start.
    #[inline]
    pub fn height(&self) -> f32 {
        self.height.to_native()
    }
    /// `[m]` Radius; 0 if it has none.
    #[inline]
    pub fn radius(&self) -> f32 {
        self.radius.to_native()
    }
    /// The object.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// What a swept copy covers; empty for the others, which have the object's own outlines.
    #[inline]
    pub fn outlines(&self) -> Range {
        self.outlines.to_native()
    }
    /// As in `objects`.
    #[inline]
    pub fn shape(&self) -> u8 {
        self.shape
    }
    /// 1 swept.
    #[inline]
    pub fn flags(&self) -> u8 {
        self.flags
    }
}

impl ArchivedLaneRangeRow {
    /// Lowest lane number.
    #[inline]
    pub fn from(&self) -> i32 {
        self.from.to_native()
    }
    /// Highest lane number.
    #[inline]
    pub fn to(&self) -> i32 {
        self.to.to_native()
    }
}

impl ArchivedObjectLaneRow {
    /// The object.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// The lane.
    #[inline]
    pub fn lane(&self) -> u32 {
        self.lane.to_native()
    }
    /// `[m]` Where the object begins along the lane, from its section's start.
    #[inline]
    pub fn s_from(&self) -> f32 {
        self.s_from.to_native()
    }
    /// `[m]` Where it ends along the lane.
    #[inline]
    pub fn s_to(&self) -> f32 {
        self.s_to.to_native()
    }
    /// `[m]` Plan-view distance of the object from the lane's area; 0 on it.
    #[inline]
    pub fn distance(&self) -> f32 {
        self.distance.to_native()
    }
    /// 0 by validity, 1 by s and t, 2 as the nearest lane.
    #[inline]
    pub fn method(&self) -> u8 {
        self.method
    }
}

impl ArchivedObjectIndexNodeRow {
    /// `[m]` Smallest x of each child.
    #[inline]
    pub fn min_x(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.min_x)
    }
    /// `[m]` Smallest y of each child.
    #[inline]
    pub fn min_y(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.min_y)
    }
    /// `[m]` Largest x of each child.
    #[inline]
    pub fn max_x(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.max_x)
    }
    /// `[m]` Largest y of each child.
    #[inline]
    pub fn max_y(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.max_y)
    }
}

impl ArchivedObjectMarkingRow {
    /// The object.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// Outline that the corners are of; none where none is meant.
    #[inline]
    pub fn outline(&self) -> u32 {
        self.outline.to_native()
    }
    /// Corners that the line runs along, in order; empty: the whole outline, or the side.
    #[inline]
    pub fn corners(&self) -> Range {
        self.corners.to_native()
    }
    /// marking/@color.
    #[inline]
    pub fn color(&self) -> u32 {
        self.color.to_native()
    }
    /// marking/@weight.
    #[inline]
    pub fn weight(&self) -> u32 {
        self.weight.to_native()
    }
    /// parkingSpace/marking/@type of OpenDRIVE 1.4; empty elsewhere.
    #[inline]
    pub fn kind(&self) -> u32 {
        self.kind.to_native()
    }
    /// `[m]` Width of the line; 0 if not given.
    #[inline]
    pub fn width(&self) -> f32 {
        self.width.to_native()
    }
    /// `[m]` Height of the line above the object's foot.
    #[inline]
    pub fn z_offset(&self) -> f32 {
        self.z_offset.to_native()
    }
    /// `[m]` Length of a stroke; 0 if not given.
    #[inline]
    pub fn line_length(&self) -> f32 {
        self.line_length.to_native()
    }
    /// `[m]` Length of the gap between two strokes; 0: none.
    #[inline]
    pub fn space_length(&self) -> f32 {
        self.space_length.to_native()
    }
    /// `[m]` How far after its first corner the line begins.
    #[inline]
    pub fn start_offset(&self) -> f32 {
        self.start_offset.to_native()
    }
    /// `[m]` How far before its last corner the line ends.
    #[inline]
    pub fn stop_offset(&self) -> f32 {
        self.stop_offset.to_native()
    }
    /// 0 not given, 1 left, 2 right, 3 front, 4 rear.
    #[inline]
    pub fn side(&self) -> u8 {
        self.side
    }
}

impl ArchivedObjectBorderRow {
    /// The object.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// The outline; none where the object has none of that id.
    #[inline]
    pub fn outline(&self) -> u32 {
        self.outline.to_native()
    }
    /// Corners that the border runs along; empty: the whole outline.
    #[inline]
    pub fn corners(&self) -> Range {
        self.corners.to_native()
    }
    /// border/@type.
    #[inline]
    pub fn kind(&self) -> u32 {
        self.kind.to_native()
    }
    /// `[m]` Width.
    #[inline]
    pub fn width(&self) -> f32 {
        self.width.to_native()
    }
}

impl ArchivedObjectSkeletonRow {
    /// The object.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// Vertices in order.
    #[inline]
    pub fn vertices(&self) -> Range {
        self.vertices.to_native()
    }
}

impl ArchivedSkeletonVertexRow {
    /// `[m]` Ahead of the origin.
    #[inline]
    pub fn u(&self) -> f32 {
        self.u.to_native()
    }
    /// `[m]` Left of the origin.
    #[inline]
    pub fn v(&self) -> f32 {
        self.v.to_native()
    }
    /// `[m]` Above the origin.
    #[inline]
    pub fn z(&self) -> f32 {
        self.z.to_native()
    }
    /// `[m]` Radius of the tube around the line; 0 if not given.
    #[inline]
    pub fn radius(&self) -> f32 {
        self.radius.to_native()
    }
    /// 1 the object meets the ground here.
    #[inline]
    pub fn flags(&self) -> u32 {
        self.flags.to_native()
    }
}

impl ArchivedParkingSpaceRow {
    /// The object.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// parkingSpace/@restrictions.
    #[inline]
    pub fn restrictions(&self) -> u32 {
        self.restrictions.to_native()
    }
    /// parkingSpace/@access.
    #[inline]
    pub fn access(&self) -> u32 {
        self.access.to_native()
    }
}

impl ArchivedObjectMaterialRow {
    /// The object.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// material/@surface.
    #[inline]
    pub fn surface(&self) -> u32 {
        self.surface.to_native()
    }
    /// material/@roadMarkColor.
    #[inline]
    pub fn color(&self) -> u32 {
        self.color.to_native()
    }
    /// Friction coefficient; −1 if not given.
    #[inline]
    pub fn friction(&self) -> f32 {
        self.friction.to_native()
    }
    /// Roughness as written; −1 if not given.
    #[inline]
    pub fn roughness(&self) -> f32 {
        self.roughness.to_native()
    }
}

impl ArchivedObjectReferenceRow {
    /// `[m]` Place on the referring road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` Lateral place on the referring road.
    #[inline]
    pub fn t(&self) -> f64 {
        self.t.to_native()
    }
    /// The referring road.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// The object; none if the map has none of this id.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// Id of the object as written.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// Lane numbers of the referring road that it holds for.
    #[inline]
    pub fn validities(&self) -> Range {
        self.validities.to_native()
    }
    /// `[m]` objectReference/@zOffset.
    #[inline]
    pub fn z_offset(&self) -> f32 {
        self.z_offset.to_native()
    }
    /// `[m]` Length along s over which it holds; 0 if absent.
    #[inline]
    pub fn valid_length(&self) -> f32 {
        self.valid_length.to_native()
    }
    /// As in `objects`.
    #[inline]
    pub fn orientation(&self) -> u8 {
        self.orientation
    }
}

impl ArchivedStructureRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s(&self) -> f64 {
        self.s.to_native()
    }
    /// `[m]` Length along s.
    #[inline]
    pub fn length(&self) -> f64 {
        self.length.to_native()
    }
    /// The road.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// Id verbatim.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// Name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// bridge/@type or tunnel/@type.
    #[inline]
    pub fn material(&self) -> u32 {
        self.material.to_native()
    }
    /// Lane numbers that it is written to hold for.
    #[inline]
    pub fn validities(&self) -> Range {
        self.validities.to_native()
    }
    /// Degree of artificial light in a tunnel; −1 if not given.
    #[inline]
    pub fn lighting(&self) -> f32 {
        self.lighting.to_native()
    }
    /// Degree of daylight in a tunnel; −1 if not given.
    #[inline]
    pub fn daylight(&self) -> f32 {
        self.daylight.to_native()
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
    /// 0 bridge, 1 tunnel.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
}

impl ArchivedSwitchRow {
    /// `[m]` Place on the main track.
    #[inline]
    pub fn main_s(&self) -> f64 {
        self.main_s.to_native()
    }
    /// `[m]` Place on the side track.
    #[inline]
    pub fn side_s(&self) -> f64 {
        self.side_s.to_native()
    }
    /// The road that it is written in.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// switch/@id.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// switch/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// Main track; none if the map does not have it.
    #[inline]
    pub fn main(&self) -> u32 {
        self.main.to_native()
    }
    /// Side track; none if the map does not have it.
    #[inline]
    pub fn side(&self) -> u32 {
        self.side.to_native()
    }
    /// Switch at the other end of the side track.
    #[inline]
    pub fn partner(&self) -> u32 {
        self.partner.to_native()
    }
    /// 0 not given, 1 dynamic, 2 straight, 3 turn.
    #[inline]
    pub fn position(&self) -> u8 {
        self.position
    }
    /// 0 not given, 1 along s, 2 against s.
    #[inline]
    pub fn main_direction(&self) -> u8 {
        self.main_direction
    }
    /// As `main_direction`.
    #[inline]
    pub fn side_direction(&self) -> u8 {
        self.side_direction
    }
}

impl ArchivedStationRow {
    /// station/@id.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// station/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// station/@type.
    #[inline]
    pub fn kind(&self) -> u32 {
        self.kind.to_native()
    }
    /// Platforms in file order.
    #[inline]
    pub fn platforms(&self) -> Range {
        self.platforms.to_native()
    }
}

impl ArchivedPlatformRow {
    /// platform/@id.
    #[inline]
    pub fn id(&self) -> u32 {
        self.id.to_native()
    }
    /// platform/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// Stretches of track beside it.
    #[inline]
    pub fn segments(&self) -> Range {
        self.segments.to_native()
    }
}

impl ArchivedPlatformSegmentRow {
    /// `[m]` Start on the road.
    #[inline]
    pub fn s_start(&self) -> f64 {
        self.s_start.to_native()
    }
    /// `[m]` End on the road.
    #[inline]
    pub fn s_end(&self) -> f64 {
        self.s_end.to_native()
    }
    /// The road; none if the map does not have it.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// Side of the road that the platform is on: 0 not given, 1 left, 2 right.
    #[inline]
    pub fn side(&self) -> u8 {
        self.side
    }
}
