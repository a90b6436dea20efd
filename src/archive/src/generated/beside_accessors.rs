//! Reading the rows of what is derived from the network and lies beside it.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::beside_rows::*;
use crate::table::Range;

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
    /// `[m]` s on the road.
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

impl ArchivedRoadMarkRow {
    /// `[m]` Start, relative to the start of the section in which the lane is written.
    #[inline]
    pub fn s_offset(&self) -> f64 {
        self.s_offset.to_native()
    }
    /// How it looks.
    #[inline]
    pub fn style(&self) -> u32 {
        self.style.to_native()
    }
    /// 1 for the last of a sequence.
    #[inline]
    pub fn last(&self) -> u8 {
        self.last
    }
}

impl ArchivedRoadMarkStyleRow {
    /// `[m]` roadMark/@width; −1 if not given.
    #[inline]
    pub fn width(&self) -> f64 {
        self.width.to_native()
    }
    /// `[m]` roadMark/@height; −1 if not given.
    #[inline]
    pub fn height(&self) -> f64 {
        self.height.to_native()
    }
    /// roadMark/@material.
    #[inline]
    pub fn material(&self) -> u32 {
        self.material.to_native()
    }
    /// roadMark/type/@name.
    #[inline]
    pub fn name(&self) -> u32 {
        self.name.to_native()
    }
    /// Lines of the pattern or the explicit mark, in file order.
    #[inline]
    pub fn lines(&self) -> Range {
        self.lines.to_native()
    }
    /// Lateral shift `[m]` of the mark's middle over s (OpenDRIVE 1.8.1, 11.10.4); a style with sway belongs to one mark.
    #[inline]
    pub fn sway(&self) -> Range {
        self.sway.to_native()
    }
    /// Kind: 0 not given, 1 none, 2 solid, 3 broken, 4 solid solid, 5 solid broken, 6 broken solid, 7 broken broken, 8 botts dots, 9 grass, 10 curb, 11 custom, 12 edge.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
    /// 0 not given, 1 standard, 2 bold.
    #[inline]
    pub fn weight(&self) -> u8 {
        self.weight
    }
    /// 0 not given, 1 standard, 2 blue, 3 green, 4 red, 5 white, 6 yellow, 7 black, 8 orange, 9 violet.
    #[inline]
    pub fn color(&self) -> u8 {
        self.color
    }
    /// 0 not given, 1 increase, 2 decrease, 3 both, 4 none.
    #[inline]
    pub fn lane_change(&self) -> u8 {
        self.lane_change
    }
}

impl ArchivedRoadMarkLineRow {
    /// `[m]` Length of a line.
    #[inline]
    pub fn length(&self) -> f64 {
        self.length.to_native()
    }
    /// `[m]` Gap to the next one; −1 for an explicit line.
    #[inline]
    pub fn space(&self) -> f64 {
        self.space.to_native()
    }
    /// `[m]` Of the line's middle from the lane's border.
    #[inline]
    pub fn t_offset(&self) -> f64 {
        self.t_offset.to_native()
    }
    /// `[m]` Start of the first line after the mark's start.
    #[inline]
    pub fn s_offset(&self) -> f64 {
        self.s_offset.to_native()
    }
    /// `[m]` Width; −1 if not given.
    #[inline]
    pub fn width(&self) -> f64 {
        self.width.to_native()
    }
    /// Who may cross, seen from inside: 0 not given, 1 no passing, 2 caution, 3 none.
    #[inline]
    pub fn rule(&self) -> u8 {
        self.rule
    }
    /// As `color` of a style.
    #[inline]
    pub fn color(&self) -> u8 {
        self.color
    }
}

impl ArchivedLaneLayerRow {
    /// The road.
    #[inline]
    pub fn road(&self) -> u32 {
        self.road.to_native()
    }
    /// Sections, ascending in s; there may be gaps between them.
    #[inline]
    pub fn sections(&self) -> Range {
        self.sections.to_native()
    }
    /// Lane offset of the layer `[m]` over s.
    #[inline]
    pub fn lane_offsets(&self) -> Range {
        self.lane_offsets.to_native()
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
    /// Number of places in `landmark_lengths` and `landmark_times`.
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
    /// Strongly connected component, numbered in topological order of the condensation.
    #[inline]
    pub fn component(&self) -> u32 {
        self.component.to_native()
    }
    /// Place in `landmark_lengths` and `landmark_times` of the node's anchor: the node itself, or one from which a way without a change of lane leads to it; u32::MAX if no motor vehicle may use the node.
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
    /// `[s]` What a route by time counts for it: its length at the recorded speed limits, at 50 km/h where none is recorded, at 130 km/h where there is none.
    #[inline]
    pub fn time(&self) -> f32 {
        self.time.to_native()
    }
    /// Node beside it, in driving direction to the left, that travels the same way: its row is this one's plus this less 32768; 32768 if there is none.
    #[inline]
    pub fn left(&self) -> u16 {
        self.left.to_native()
    }
    /// Node beside it, in driving direction to the right, that travels the same way, in the same way.
    #[inline]
    pub fn right(&self) -> u16 {
        self.right.to_native()
    }
    /// Length of the way from the anchor, in the graph's `length_step`, rounded up; 0 for the anchor itself.
    #[inline]
    pub fn anchor_length(&self) -> u16 {
        self.anchor_length.to_native()
    }
    /// Time from the anchor, in `time_step`, rounded up.
    #[inline]
    pub fn anchor_time(&self) -> u16 {
        self.anchor_time.to_native()
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
    /// 0 within a lane, 1 link inside a road, 2 link over a road's end, 3 lane link of a connection, 4 implied by a connection without lane links, 5 at a virtual junction, 6 end of a path across a road.
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
    /// Start of the common area on `lane`, from its section's start, rounded down to steps: of the least power of two metres above a 65,535th of the section's length.
    #[inline]
    pub fn from(&self) -> u16 {
        self.from.to_native()
    }
    /// End of the common area on `lane`, rounded up; not beyond the section's end.
    #[inline]
    pub fn to(&self) -> u16 {
        self.to.to_native()
    }
    /// Start of the common area on `other`, in steps of its section, rounded down.
    #[inline]
    pub fn other_from(&self) -> u16 {
        self.other_from.to_native()
    }
    /// End of the common area on `other`, rounded up; not beyond the section's end.
    #[inline]
    pub fn other_to(&self) -> u16 {
        self.other_to.to_native()
    }
    /// 0 cross, 1 merge, 2 overlap, 3 crossing of roads.
    #[inline]
    pub fn kind(&self) -> u8 {
        self.kind
    }
    /// Who goes first: 0 `lane` yields, 1 `lane` has priority, 2 lights decide, 3 nothing decides; 4 for lanes that come from one entry, and where roads cross.
    #[inline]
    pub fn relation(&self) -> u8 {
        self.relation
    }
    /// Why: 0 none, 1 lights, 2 stop sign, 3 yield sign, 4 priority road, 5 junction priority, 6 turn across oncoming traffic, 7 from the right.
    #[inline]
    pub fn reason(&self) -> u8 {
        self.reason
    }
}
