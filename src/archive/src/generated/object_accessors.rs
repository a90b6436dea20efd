//! Reading the rows of objects.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::object_rows::*;
use crate::table::Range;
use rkyv::rend;

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
    /// `[m]` s on the road; of a swept copy, its start.
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
    /// 0 by validity, 2 the object's area lies on the lane, 3 as the nearest lane; 1 is not used for objects.
    #[inline]
    pub fn method(&self) -> u8 {
        self.method
    }
}

impl ArchivedBoxNodeRow {
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

impl ArchivedObjectValueRow {
    /// `[m/s, m or kg]` What the class means by its value.
    #[inline]
    pub fn value(&self) -> f64 {
        self.value.to_native()
    }
    /// The object.
    #[inline]
    pub fn object(&self) -> u32 {
        self.object.to_native()
    }
    /// Unit in which the number is read: objects state none. `SI`: whatever SI unit fits.
    #[inline]
    pub fn unit(&self) -> u32 {
        self.unit.to_native()
    }
}

impl ArchivedObjectReferenceRow {
    /// `[m]` s on the referring road.
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
    /// `[m]` s on the main track.
    #[inline]
    pub fn main_s(&self) -> f64 {
        self.main_s.to_native()
    }
    /// `[m]` s on the side track.
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
