/// Every query of a snapshot that follows one form; `mapd.h` documents units, signs and errors of each.
#pragma once

#include "base.hpp"

namespace mapd {

/// What a snapshot can be asked: see `Snapshot`.
class Queries : public detail::Owner<mapd_snapshot, mapd_snapshot_close> {
 public:
  using Owner::Owner;

  // Lookup.

  /// The road with OpenDRIVE's id.
  Result<std::optional<RoadId>> try_road_by_id(const std::string& id) const {
    return detail::optional<RoadId>([&](auto... out) { return mapd_road_by_id(get(), id.c_str(), out...); });
  }

  /// The junction with OpenDRIVE's id.
  Result<std::optional<JunctionId>> try_junction_by_id(const std::string& id) const {
    return detail::optional<JunctionId>([&](auto... out) { return mapd_junction_by_id(get(), id.c_str(), out...); });
  }

  /// A signal with OpenDRIVE's id.
  Result<std::optional<SignalId>> try_signal_by_id(const std::string& id) const {
    return detail::optional<SignalId>([&](auto... out) { return mapd_signal_by_id(get(), id.c_str(), out...); });
  }

  /// The object with OpenDRIVE's id.
  Result<std::optional<ObjectId>> try_object_by_id(const std::string& id) const {
    return detail::optional<ObjectId>([&](auto... out) { return mapd_object_by_id(get(), id.c_str(), out...); });
  }

  /// The lane with a key such as `12:0:-1`.
  Result<std::optional<LaneId>> try_lane_by_key(const std::string& key) const {
    return detail::optional<LaneId>([&](auto... out) { return mapd_lane_by_key(get(), key.c_str(), out...); });
  }

  /// All roads in file order.
  Result<std::vector<RoadId>> try_roads() const {
    return detail::list<RoadId>([&](auto... out) { return mapd_roads(get(), out...); });
  }

  /// All junctions in file order.
  Result<std::vector<JunctionId>> try_junctions() const {
    return detail::list<JunctionId>([&](auto... out) { return mapd_junctions(get(), out...); });
  }

  /// All lanes but those of number 0 and of the temporary layer.
  Result<std::vector<LaneId>> try_lanes() const {
    return detail::list<LaneId>([&](auto... out) { return mapd_lanes(get(), out...); });
  }

  /// All signals in file order.
  Result<std::vector<SignalId>> try_signals() const {
    return detail::list<SignalId>([&](auto... out) { return mapd_signals(get(), out...); });
  }

  /// All objects.
  Result<std::vector<ObjectId>> try_objects() const {
    return detail::list<ObjectId>([&](auto... out) { return mapd_objects(get(), out...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<RoadId> road_by_id(const std::string& id) const { return try_road_by_id(id).value(); }
  std::optional<JunctionId> junction_by_id(const std::string& id) const { return try_junction_by_id(id).value(); }
  std::optional<SignalId> signal_by_id(const std::string& id) const { return try_signal_by_id(id).value(); }
  std::optional<ObjectId> object_by_id(const std::string& id) const { return try_object_by_id(id).value(); }
  std::optional<LaneId> lane_by_key(const std::string& key) const { return try_lane_by_key(key).value(); }
  std::vector<RoadId> roads() const { return try_roads().value(); }
  std::vector<JunctionId> junctions() const { return try_junctions().value(); }
  std::vector<LaneId> lanes() const { return try_lanes().value(); }
  std::vector<SignalId> signals() const { return try_signals().value(); }
  std::vector<ObjectId> objects() const { return try_objects().value(); }
#endif

  // Near a place.

  /// The lane whose area is nearest to a point, within the options' radius.
  Result<std::optional<Nearest>> try_nearest_lane(Point point, const NearestOptions& options = {}) const {
    const mapd_nearest_options own = options.c();
    return detail::optional<Nearest>([&](auto... out) { return mapd_nearest_lane(get(), point, &own, out...); });
  }

  /// Every lane within the options' radius, nearest first.
  Result<std::vector<Nearest>> try_lanes_near(Point point, Scratch& scratch, const NearestOptions& options = {}) const {
    const mapd_nearest_options own = options.c();
    return detail::list<Nearest>([&](auto... out) { return mapd_lanes_near(get(), point, &own, scratch.get(), out...); });
  }

  /// Every lane of these types that meets a rectangle.
  Result<std::vector<LaneId>> try_lanes_in(Region region, std::uint64_t types, Scratch& scratch) const {
    return detail::list<LaneId>([&](auto... out) { return mapd_lanes_in(get(), region, types, scratch.get(), out...); });
  }

  /// The ground at a place, on the level whose height is nearest to the point's z.
  Result<std::optional<Ground>> try_ground_at(Point point, Scratch& scratch, span<const LaneId> expected = {}) const {
    return detail::optional<Ground>([&](auto... out) { return mapd_ground_at(get(), point, expected.data(), expected.size(), scratch.get(), out...); });
  }

  /// The road mark that is nearest to a point.
  Result<std::optional<NearMark>> try_nearest_mark(Vec2 point, const MarkFilter& filter = {}) const {
    return detail::optional<NearMark>([&](auto... out) { return mapd_nearest_mark(get(), point, &filter, out...); });
  }

  /// Signals and objects that localisers find again, nearest first; no classes: the usual ones.
  Result<std::vector<Landmark>> try_landmarks_near(Vec2 point, double radius, const ClassSet* classes, Scratch& scratch) const {
    return detail::list<Landmark>([&](auto... out) { return mapd_landmarks_near(get(), point, radius, classes, scratch.get(), out...); });
  }

  /// The same in a rectangle.
  Result<std::vector<Landmark>> try_landmarks_in(Region region, const ClassSet* classes, Scratch& scratch) const {
    return detail::list<Landmark>([&](auto... out) { return mapd_landmarks_in(get(), region, classes, scratch.get(), out...); });
  }

  /// What a sensor sees of them, nearest first.
  Result<std::vector<LandmarkInView>> try_landmarks_in_view(const Sensor& sensor, const ClassSet* classes, Scratch& scratch) const {
    return detail::list<LandmarkInView>([&](auto... out) { return mapd_landmarks_in_view(get(), sensor, classes, scratch.get(), out...); });
  }

  /// Points along the paint in a rectangle.
  Result<std::vector<MarkPoint>> try_mark_points(Region region, double spacing, Scratch& scratch, const MarkFilter& filter = {}) const {
    return detail::list<MarkPoint>([&](auto... out) { return mapd_mark_points(get(), region, spacing, &filter, scratch.get(), out...); });
  }

  /// How a vehicle stands on the ground below its four wheels.
  Result<std::optional<Stance>> try_stance_at(const VehiclePose& pose, const std::array<Vec2, 4>& wheels, Scratch& scratch, span<const LaneId> expected = {}) const {
    return detail::optional<Stance>([&](auto... out) { return mapd_stance_at(get(), pose, wheels.data(), expected.data(), expected.size(), scratch.get(), out...); });
  }

  /// Parts of the document that are left out near a point.
  Result<std::vector<Quarantined>> try_quarantined_near(Vec2 point, double radius) const {
    return detail::list<Quarantined>([&](auto... out) { return mapd_quarantined_near(get(), point, radius, out...); });
  }

  /// Every signal that stands so near, nearest first.
  Result<std::vector<NearSignal>> try_signals_near(Vec2 point, double radius, Scratch& scratch) const {
    return detail::list<NearSignal>([&](auto... out) { return mapd_signals_near(get(), point, radius, scratch.get(), out...); });
  }

  /// Every signal that stands in a rectangle.
  Result<std::vector<SignalId>> try_signals_in(Region region, Scratch& scratch) const {
    return detail::list<SignalId>([&](auto... out) { return mapd_signals_in(get(), region, scratch.get(), out...); });
  }

  /// Every place of an object that comes so near, nearest first.
  Result<std::vector<NearObject>> try_objects_near(Vec2 point, double radius, Scratch& scratch) const {
    return detail::list<NearObject>([&](auto... out) { return mapd_objects_near(get(), point, radius, scratch.get(), out...); });
  }

  /// Every place of an object that meets a rectangle.
  Result<std::vector<PlacementId>> try_objects_in(Region region, Scratch& scratch) const {
    return detail::list<PlacementId>([&](auto... out) { return mapd_objects_in(get(), region, scratch.get(), out...); });
  }

  /// Pieces of borders that meet a rectangle.
  Result<std::vector<BoundarySegment>> try_boundary_segments(Region region, std::uint64_t types, Scratch& scratch) const {
    return detail::list<BoundarySegment>([&](auto... out) { return mapd_boundary_segments(get(), region, types, scratch.get(), out...); });
  }

  /// Pieces of road marks that meet a rectangle.
  Result<std::vector<RoadMarkSegment>> try_road_mark_segments(Region region, std::uint64_t types, Scratch& scratch) const {
    return detail::list<RoadMarkSegment>([&](auto... out) { return mapd_road_mark_segments(get(), region, types, scratch.get(), out...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<Nearest> nearest_lane(Point point, const NearestOptions& options = {}) const { return try_nearest_lane(point, options).value(); }
  std::vector<Nearest> lanes_near(Point point, Scratch& scratch, const NearestOptions& options = {}) const { return try_lanes_near(point, scratch, options).value(); }
  std::vector<LaneId> lanes_in(Region region, std::uint64_t types, Scratch& scratch) const { return try_lanes_in(region, types, scratch).value(); }
  std::optional<Ground> ground_at(Point point, Scratch& scratch, span<const LaneId> expected = {}) const { return try_ground_at(point, scratch, expected).value(); }
  std::optional<NearMark> nearest_mark(Vec2 point, const MarkFilter& filter = {}) const { return try_nearest_mark(point, filter).value(); }
  std::vector<Landmark> landmarks_near(Vec2 point, double radius, const ClassSet* classes, Scratch& scratch) const { return try_landmarks_near(point, radius, classes, scratch).value(); }
  std::vector<Landmark> landmarks_in(Region region, const ClassSet* classes, Scratch& scratch) const { return try_landmarks_in(region, classes, scratch).value(); }
  std::vector<LandmarkInView> landmarks_in_view(const Sensor& sensor, const ClassSet* classes, Scratch& scratch) const { return try_landmarks_in_view(sensor, classes, scratch).value(); }
  std::vector<MarkPoint> mark_points(Region region, double spacing, Scratch& scratch, const MarkFilter& filter = {}) const { return try_mark_points(region, spacing, scratch, filter).value(); }
  std::optional<Stance> stance_at(const VehiclePose& pose, const std::array<Vec2, 4>& wheels, Scratch& scratch, span<const LaneId> expected = {}) const { return try_stance_at(pose, wheels, scratch, expected).value(); }
  std::vector<Quarantined> quarantined_near(Vec2 point, double radius) const { return try_quarantined_near(point, radius).value(); }
  std::vector<NearSignal> signals_near(Vec2 point, double radius, Scratch& scratch) const { return try_signals_near(point, radius, scratch).value(); }
  std::vector<SignalId> signals_in(Region region, Scratch& scratch) const { return try_signals_in(region, scratch).value(); }
  std::vector<NearObject> objects_near(Vec2 point, double radius, Scratch& scratch) const { return try_objects_near(point, radius, scratch).value(); }
  std::vector<PlacementId> objects_in(Region region, Scratch& scratch) const { return try_objects_in(region, scratch).value(); }
  std::vector<BoundarySegment> boundary_segments(Region region, std::uint64_t types, Scratch& scratch) const { return try_boundary_segments(region, types, scratch).value(); }
  std::vector<RoadMarkSegment> road_mark_segments(Region region, std::uint64_t types, Scratch& scratch) const { return try_road_mark_segments(region, types, scratch).value(); }
#endif

  // Roads.

  /// What a road is.
  Result<RoadFacts> try_road(RoadId road) const {
    return detail::value<RoadFacts>([&](auto... out) { return mapd_road_facts_of(get(), road, out...); });
  }

  /// OpenDRIVE's id of a road; it points into the snapshot.
  Result<std::string_view> try_road_name_id(RoadId road) const {
    const auto text = detail::value<mapd_text>([&](auto... out) { return mapd_road_name_id(get(), road, out...); });
    if (!text) return text.error();
    return view(*text);
  }

  /// Inertial pose of a track position.
  Result<Pose> try_to_inertial(RoadId road, Track track) const {
    return detail::value<Pose>([&](auto... out) { return mapd_road_to_inertial(get(), road, track, out...); });
  }

  /// Track position of a point.
  Result<TrackPosition> try_to_track(RoadId road, Point point) const {
    return detail::value<TrackPosition>([&](auto... out) { return mapd_road_to_track(get(), road, point, out...); });
  }

  /// Elevation of the reference line [m].
  Result<double> try_elevation_at(RoadId road, double s) const {
    return detail::value<double>([&](auto... out) { return mapd_road_elevation_at(get(), road, s, out...); });
  }

  /// Superelevation [rad].
  Result<double> try_superelevation_at(RoadId road, double s) const {
    return detail::value<double>([&](auto... out) { return mapd_road_superelevation_at(get(), road, s, out...); });
  }

  /// Lane offset [m].
  Result<double> try_lane_offset_at(RoadId road, double s) const {
    return detail::value<double>([&](auto... out) { return mapd_road_lane_offset_at(get(), road, s, out...); });
  }

  /// The lane that covers (s, t).
  Result<std::optional<LaneId>> try_lane_at(RoadId road, double s, double t) const {
    return detail::optional<LaneId>([&](auto... out) { return mapd_road_lane_at(get(), road, s, t, out...); });
  }

  /// The lane with OpenDRIVE's number at s.
  Result<std::optional<LaneId>> try_lane_numbered(RoadId road, double s, std::int32_t number) const {
    return detail::optional<LaneId>([&](auto... out) { return mapd_road_lane_numbered(get(), road, s, number, out...); });
  }

  /// Lanes of a section from left to right, lane 0 among them; nothing for a section that the road does not have.
  Result<std::vector<LaneId>> try_section_lanes(RoadId road, std::uint32_t section) const {
    return detail::list<LaneId>([&](auto... out) { return mapd_road_section_lanes(get(), road, section, out...); });
  }

  /// The surface at (s, t).
  Result<Surface> try_surface_at(RoadId road, double s, double t) const {
    return detail::value<Surface>([&](auto... out) { return mapd_road_surface_at(get(), road, s, t, out...); });
  }

#if MAPD_EXCEPTIONS
  RoadFacts road(RoadId road) const { return try_road(road).value(); }
  std::string_view road_name_id(RoadId road) const { return try_road_name_id(road).value(); }
  Pose to_inertial(RoadId road, Track track) const { return try_to_inertial(road, track).value(); }
  TrackPosition to_track(RoadId road, Point point) const { return try_to_track(road, point).value(); }
  double elevation_at(RoadId road, double s) const { return try_elevation_at(road, s).value(); }
  double superelevation_at(RoadId road, double s) const { return try_superelevation_at(road, s).value(); }
  double lane_offset_at(RoadId road, double s) const { return try_lane_offset_at(road, s).value(); }
  std::optional<LaneId> lane_at(RoadId road, double s, double t) const { return try_lane_at(road, s, t).value(); }
  std::optional<LaneId> lane_numbered(RoadId road, double s, std::int32_t number) const { return try_lane_numbered(road, s, number).value(); }
  std::vector<LaneId> section_lanes(RoadId road, std::uint32_t section) const { return try_section_lanes(road, section).value(); }
  Surface surface_at(RoadId road, double s, double t) const { return try_surface_at(road, s, t).value(); }
#endif

  // Lanes.

  /// What a lane is.
  Result<LaneFacts> try_lane(LaneId lane) const {
    return detail::value<LaneFacts>([&](auto... out) { return mapd_lane_facts_of(get(), lane, out...); });
  }

  /// A point in the lane's coordinates.
  Result<LanePosition> try_position_of(LaneId lane, Point point) const {
    return detail::value<LanePosition>([&](auto... out) { return mapd_lane_position_of(get(), lane, point, out...); });
  }

  /// Pose at s as the lane's traffic has it, offset [m] to the left of its centre.
  Result<Pose> try_pose_at(LaneId lane, double s, double offset) const {
    return detail::value<Pose>([&](auto... out) { return mapd_lane_pose_at(get(), lane, s, offset, out...); });
  }

  /// The same along the reference line.
  Result<Pose> try_pose_of_reference_line(LaneId lane, double s, double offset) const {
    return detail::value<Pose>([&](auto... out) { return mapd_lane_pose_of_reference_line(get(), lane, s, offset, out...); });
  }

  /// The centre line's exact place at s.
  Result<Waypoint> try_waypoint_at(LaneId lane, double s) const {
    return detail::value<Waypoint>([&](auto... out) { return mapd_lane_waypoint_at(get(), lane, s, out...); });
  }

  /// Waypoints in driving direction, step metres of s apart.
  Result<std::vector<Waypoint>> try_waypoints(LaneId lane, double step) const {
    return detail::list<Waypoint>([&](auto... out) { return mapd_lane_waypoints(get(), lane, step, out...); });
  }

  /// Both edges at s, lateral.
  Result<LaneEdges> try_edges_at(LaneId lane, double s) const {
    return detail::value<LaneEdges>([&](auto... out) { return mapd_lane_edges_at(get(), lane, s, out...); });
  }

  /// Both edges at s, inertial.
  Result<LaneBounds> try_bounds_at(LaneId lane, double s) const {
    return detail::value<LaneBounds>([&](auto... out) { return mapd_lane_bounds_at(get(), lane, s, out...); });
  }

  /// Width at s [m].
  Result<double> try_width_at(LaneId lane, double s) const {
    return detail::value<double>([&](auto... out) { return mapd_lane_width_at(get(), lane, s, out...); });
  }

  /// Speed limit of lane and road type [m/s].
  Result<std::optional<double>> try_speed_limit_at(LaneId lane, double s) const {
    return detail::optional<double>([&](auto... out) { return mapd_lane_speed_limit_at(get(), lane, s, out...); });
  }

  /// The speed limit, signs included.
  Result<SpeedRule> try_speed_rule_at(LaneId lane, double s) const {
    return detail::value<SpeedRule>([&](auto... out) { return mapd_lane_speed_rule_at(get(), lane, s, out...); });
  }

  /// Length of the centre line between two s [m].
  Result<double> try_length_between(LaneId lane, double a, double b) const {
    return detail::value<double>([&](auto... out) { return mapd_lane_length_between(get(), lane, a, b, out...); });
  }

  /// Time on the centre line between two s at the limits [s].
  Result<double> try_time_between(LaneId lane, double a, double b) const {
    return detail::value<double>([&](auto... out) { return mapd_lane_time_between(get(), lane, a, b, out...); });
  }

  /// The signs that forbid overtaking.
  Result<OvertakingRule> try_overtaking_rule_at(LaneId lane, double s) const {
    return detail::value<OvertakingRule>([&](auto... out) { return mapd_lane_overtaking_rule_at(get(), lane, s, out...); });
  }

  /// The lane beside; side is a MAPD_BESIDE_….
  Result<std::optional<LaneId>> try_beside(LaneId lane, std::uint32_t side) const {
    return detail::optional<LaneId>([&](auto... out) { return mapd_lane_beside(get(), lane, side, out...); });
  }

  /// Lanes entered from this one.
  Result<std::vector<LaneId>> try_successors(LaneId lane) const {
    return detail::list<LaneId>([&](auto... out) { return mapd_lane_successors(get(), lane, out...); });
  }

  /// Lanes from which this one is entered.
  Result<std::vector<LaneId>> try_predecessors(LaneId lane) const {
    return detail::list<LaneId>([&](auto... out) { return mapd_lane_predecessors(get(), lane, out...); });
  }

  /// Centre line or border; line is a MAPD_LINE_….
  Result<std::vector<LinePoint>> try_line(LaneId lane, std::uint32_t line) const {
    return detail::list<LinePoint>([&](auto... out) { return mapd_lane_line(get(), lane, line, out...); });
  }

  /// The lane's road marks.
  Result<std::vector<RoadMark>> try_road_marks(LaneId lane) const {
    return detail::list<RoadMark>([&](auto... out) { return mapd_lane_road_marks(get(), lane, out...); });
  }

  /// The road mark that holds at s.
  Result<std::optional<RoadMark>> try_road_mark_at(LaneId lane, double s) const {
    return detail::optional<RoadMark>([&](auto... out) { return mapd_lane_road_mark_at(get(), lane, s, out...); });
  }

  /// What the lane lies above the road's surface.
  Result<LaneHeight> try_height_at(LaneId lane, double s) const {
    return detail::value<LaneHeight>([&](auto... out) { return mapd_lane_height_at(get(), lane, s, out...); });
  }

  /// What the lane is made of.
  Result<std::optional<Material>> try_material_at(LaneId lane, double s) const {
    return detail::optional<Material>([&](auto... out) { return mapd_lane_material_at(get(), lane, s, out...); });
  }

#if MAPD_EXCEPTIONS
  LaneFacts lane(LaneId lane) const { return try_lane(lane).value(); }
  LanePosition position_of(LaneId lane, Point point) const { return try_position_of(lane, point).value(); }
  Pose pose_at(LaneId lane, double s, double offset) const { return try_pose_at(lane, s, offset).value(); }
  Pose pose_of_reference_line(LaneId lane, double s, double offset) const { return try_pose_of_reference_line(lane, s, offset).value(); }
  Waypoint waypoint_at(LaneId lane, double s) const { return try_waypoint_at(lane, s).value(); }
  std::vector<Waypoint> waypoints(LaneId lane, double step) const { return try_waypoints(lane, step).value(); }
  LaneEdges edges_at(LaneId lane, double s) const { return try_edges_at(lane, s).value(); }
  LaneBounds bounds_at(LaneId lane, double s) const { return try_bounds_at(lane, s).value(); }
  double width_at(LaneId lane, double s) const { return try_width_at(lane, s).value(); }
  std::optional<double> speed_limit_at(LaneId lane, double s) const { return try_speed_limit_at(lane, s).value(); }
  SpeedRule speed_rule_at(LaneId lane, double s) const { return try_speed_rule_at(lane, s).value(); }
  double length_between(LaneId lane, double a, double b) const { return try_length_between(lane, a, b).value(); }
  double time_between(LaneId lane, double a, double b) const { return try_time_between(lane, a, b).value(); }
  OvertakingRule overtaking_rule_at(LaneId lane, double s) const { return try_overtaking_rule_at(lane, s).value(); }
  std::optional<LaneId> beside(LaneId lane, std::uint32_t side) const { return try_beside(lane, side).value(); }
  std::vector<LaneId> successors(LaneId lane) const { return try_successors(lane).value(); }
  std::vector<LaneId> predecessors(LaneId lane) const { return try_predecessors(lane).value(); }
  std::vector<LinePoint> line(LaneId lane, std::uint32_t line) const { return try_line(lane, line).value(); }
  std::vector<RoadMark> road_marks(LaneId lane) const { return try_road_marks(lane).value(); }
  std::optional<RoadMark> road_mark_at(LaneId lane, double s) const { return try_road_mark_at(lane, s).value(); }
  LaneHeight height_at(LaneId lane, double s) const { return try_height_at(lane, s).value(); }
  std::optional<Material> material_at(LaneId lane, double s) const { return try_material_at(lane, s).value(); }
#endif

  // The lane graph and routes.

  /// Number of nodes.
  Result<std::size_t> try_node_count() const {
    return detail::value<std::size_t>([&](auto... out) { return mapd_node_count(get(), out...); });
  }

  /// What a node is.
  Result<NodeFacts> try_node(NodeId node) const {
    return detail::value<NodeFacts>([&](auto... out) { return mapd_node_facts_of(get(), node, out...); });
  }

  /// Edges that leave a node.
  Result<std::vector<Edge>> try_edges(NodeId node) const {
    return detail::list<Edge>([&](auto... out) { return mapd_node_edges(get(), node, out...); });
  }

  /// Nodes from which a node is entered.
  Result<std::vector<NodeId>> try_node_predecessors(NodeId node) const {
    return detail::list<NodeId>([&](auto... out) { return mapd_node_predecessors(get(), node, out...); });
  }

  /// A lane's nodes in driving order.
  Result<std::vector<NodeId>> try_nodes(LaneId lane) const {
    return detail::list<NodeId>([&](auto... out) { return mapd_lane_nodes(get(), lane, out...); });
  }

  /// The node that holds s.
  Result<std::optional<NodeId>> try_node_at(LaneId lane, double s, bool forward) const {
    return detail::optional<NodeId>([&](auto... out) { return mapd_lane_node_at(get(), lane, s, forward ? std::uint8_t{1} : std::uint8_t{0}, out...); });
  }

  /// Lanes of the junction whose areas meet this one's.
  Result<std::vector<Conflict>> try_conflicts(LaneId lane) const {
    return detail::list<Conflict>([&](auto... out) { return mapd_lane_conflicts(get(), lane, out...); });
  }

  /// Every node that can be reached within a cost.
  Result<std::vector<Reached>> try_reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch) const {
    return detail::list<Reached>([&](auto... out) { return mapd_reachable(get(), from, limit, cost, scratch.get(), out...); });
  }

  /// Every node from which a place can be reached within a cost.
  Result<std::vector<Reached>> try_reachable_to(PositionOnLane to, double limit, Cost cost, Scratch& scratch) const {
    return detail::list<Reached>([&](auto... out) { return mapd_reachable_to(get(), to, limit, cost, scratch.get(), out...); });
  }

  /// The next junction ahead.
  Result<std::optional<NextJunction>> try_next_junction(PositionOnLane from, double distance, std::uint8_t vehicle) const {
    return detail::optional<NextJunction>([&](auto... out) { return mapd_next_junction_of(get(), from, distance, vehicle, out...); });
  }

  /// The steps over lanes that follow each other, from s on the first to s on the last.
  Result<std::vector<RouteStep>> try_steps_of_lanes(span<const LaneId> lanes, double s_from, double s_to, Scratch& scratch) const {
    return detail::list<RouteStep>([&](auto... out) { return mapd_steps_of_lanes(get(), lanes.data(), lanes.size(), s_from, s_to, scratch.get(), out...); });
  }

  /// The next change of lane on a route.
  Result<std::optional<LaneChange>> try_next_lane_change(span<const RouteStep> steps, std::size_t at, PositionOnLane place, Scratch& scratch) const {
    return detail::optional<LaneChange>([&](auto... out) { return mapd_next_lane_change(get(), steps.data(), steps.size(), at, place, scratch.get(), out...); });
  }

  /// Length of a route's steps [m].
  Result<double> try_steps_length(span<const RouteStep> steps) const {
    return detail::value<double>([&](auto... out) { return mapd_steps_length(get(), steps.data(), steps.size(), out...); });
  }

#if MAPD_EXCEPTIONS
  std::size_t node_count() const { return try_node_count().value(); }
  NodeFacts node(NodeId node) const { return try_node(node).value(); }
  std::vector<Edge> edges(NodeId node) const { return try_edges(node).value(); }
  std::vector<NodeId> node_predecessors(NodeId node) const { return try_node_predecessors(node).value(); }
  std::vector<NodeId> nodes(LaneId lane) const { return try_nodes(lane).value(); }
  std::optional<NodeId> node_at(LaneId lane, double s, bool forward) const { return try_node_at(lane, s, forward).value(); }
  std::vector<Conflict> conflicts(LaneId lane) const { return try_conflicts(lane).value(); }
  std::vector<Reached> reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch) const { return try_reachable(from, limit, cost, scratch).value(); }
  std::vector<Reached> reachable_to(PositionOnLane to, double limit, Cost cost, Scratch& scratch) const { return try_reachable_to(to, limit, cost, scratch).value(); }
  std::optional<NextJunction> next_junction(PositionOnLane from, double distance, std::uint8_t vehicle) const { return try_next_junction(from, distance, vehicle).value(); }
  std::vector<RouteStep> steps_of_lanes(span<const LaneId> lanes, double s_from, double s_to, Scratch& scratch) const { return try_steps_of_lanes(lanes, s_from, s_to, scratch).value(); }
  std::optional<LaneChange> next_lane_change(span<const RouteStep> steps, std::size_t at, PositionOnLane place, Scratch& scratch) const { return try_next_lane_change(steps, at, place, scratch).value(); }
  double steps_length(span<const RouteStep> steps) const { return try_steps_length(steps).value(); }
#endif

  // Junctions, signals and right of way.

  /// What a junction is.
  Result<JunctionFacts> try_junction(JunctionId junction) const {
    return detail::value<JunctionFacts>([&](auto... out) { return mapd_junction_facts_of(get(), junction, out...); });
  }

  /// Connections in file order.
  Result<std::vector<Connection>> try_connections(JunctionId junction) const {
    return detail::list<Connection>([&](auto... out) { return mapd_junction_connections(get(), junction, out...); });
  }

  /// Height of a junction's elevation grid.
  Result<std::optional<GridHeight>> try_grid_height_at(JunctionId junction, Vec2 point) const {
    return detail::optional<GridHeight>([&](auto... out) { return mapd_junction_grid_height_at(get(), junction, point, out...); });
  }

  /// What a signal is.
  Result<SignalFacts> try_signal(SignalId signal) const {
    return detail::value<SignalFacts>([&](auto... out) { return mapd_signal_facts_of(get(), signal, out...); });
  }

  /// Signals for a lane; which is a MAPD_LANE_SIGNALS_….
  Result<std::vector<LaneSignal>> try_lane_signals(LaneId lane, std::uint32_t which) const {
    return detail::list<LaneSignal>([&](auto... out) { return mapd_lane_signals(get(), lane, which, out...); });
  }

  /// Signals ahead on any way.
  Result<std::vector<SignalAhead>> try_signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<SignalAhead>([&](auto... out) { return mapd_signals_ahead(get(), from, distance, vehicle, scratch.get(), out...); });
  }

  /// Signals along a route.
  Result<std::vector<SignalAhead>> try_signals_along(span<const RouteStep> steps, Scratch& scratch) const {
    return detail::list<SignalAhead>([&](auto... out) { return mapd_signals_along(get(), steps.data(), steps.size(), scratch.get(), out...); });
  }

  /// Stop lines and crosswalks along a route.
  Result<std::vector<LaneLine>> try_lines_along(span<const RouteStep> steps, Scratch& scratch) const {
    return detail::list<LaneLine>([&](auto... out) { return mapd_lines_along(get(), steps.data(), steps.size(), scratch.get(), out...); });
  }

  /// Where the movement leads: a MAPD_TURN_….
  Result<std::uint8_t> try_turn(LaneId lane) const {
    return detail::value<std::uint8_t>([&](auto... out) { return mapd_lane_turn(get(), lane, out...); });
  }

  /// Lanes from which the junction is entered on the way through this one.
  Result<std::vector<LaneId>> try_entries(LaneId lane) const {
    return detail::list<LaneId>([&](auto... out) { return mapd_lane_entries(get(), lane, out...); });
  }

  /// Lanes of the junction that the movement goes over.
  Result<std::vector<LaneId>> try_movement_lanes(LaneId lane) const {
    return detail::list<LaneId>([&](auto... out) { return mapd_lane_movement_lanes(get(), lane, out...); });
  }

  /// Lights that govern the movement.
  Result<std::vector<LaneSignal>> try_movement_lights(LaneId lane) const {
    return detail::list<LaneSignal>([&](auto... out) { return mapd_lane_movement_lights(get(), lane, out...); });
  }

  /// Where the movement stops.
  Result<std::optional<LaneLine>> try_movement_stop(LaneId lane) const {
    return detail::optional<LaneLine>([&](auto... out) { return mapd_lane_movement_stop(get(), lane, out...); });
  }

  /// Lines on a lane; which is a MAPD_LANE_LINES_….
  Result<std::vector<LaneLine>> try_lane_lines(LaneId lane, std::uint32_t which) const {
    return detail::list<LaneLine>([&](auto... out) { return mapd_lane_lines(get(), lane, which, out...); });
  }

  /// Who goes first where this lane meets others.
  Result<std::vector<RightOfWay>> try_right_of_way(LaneId lane) const {
    return detail::list<RightOfWay>([&](auto... out) { return mapd_lane_right_of_way(get(), lane, out...); });
  }

  /// The same by the rules of a country where the file does not say; none for a country whose rules are not known.
  Result<std::optional<std::vector<RightOfWay>>> try_right_of_way_by(LaneId lane, const std::string& country) const {
    return detail::optional_list<RightOfWay>([&](auto... out) { return mapd_lane_right_of_way_by(get(), lane, country.c_str(), out...); });
  }

  /// The lanes on which traffic comes to a conflict of a path.
  Result<std::vector<ConflictApproach>> try_approaches(const PathConflict& conflict, double distance, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<ConflictApproach>([&](auto... out) { return mapd_conflict_approaches(get(), &conflict, distance, vehicle, scratch.get(), out...); });
  }

  /// What a signal names; which is a MAPD_SIGNAL_LINKS_….
  Result<std::vector<SignalLink>> try_signal_links(SignalId signal, std::uint32_t which) const {
    return detail::list<SignalLink>([&](auto... out) { return mapd_signal_links(get(), signal, which, out...); });
  }

  /// All controllers: the groups of signals that switch together.
  Result<std::vector<Controller>> try_controllers() const {
    return detail::list<Controller>([&](auto... out) { return mapd_controllers(get(), out...); });
  }

  /// Signals of a controller, by its number.
  Result<std::vector<SignalId>> try_controller_signals(std::uint32_t number) const {
    return detail::list<SignalId>([&](auto... out) { return mapd_controller_signals(get(), number, out...); });
  }

  /// Numbers of the controllers that switch a signal.
  Result<std::vector<std::uint32_t>> try_signal_controllers(SignalId signal) const {
    return detail::list<std::uint32_t>([&](auto... out) { return mapd_signal_controllers(get(), signal, out...); });
  }

  /// Numbers of the controllers of a junction.
  Result<std::vector<std::uint32_t>> try_junction_controllers(JunctionId junction) const {
    return detail::list<std::uint32_t>([&](auto... out) { return mapd_junction_controllers(get(), junction, out...); });
  }

  /// All groups of junctions.
  Result<std::vector<JunctionGroup>> try_junction_groups() const {
    return detail::list<JunctionGroup>([&](auto... out) { return mapd_junction_groups(get(), out...); });
  }

  /// Junctions of a group, by its number.
  Result<std::vector<JunctionId>> try_junction_group_members(std::uint32_t number) const {
    return detail::list<JunctionId>([&](auto... out) { return mapd_junction_group_members(get(), number, out...); });
  }

  /// Lanes of a roundabout's ring, by its group's number.
  Result<std::vector<LaneId>> try_junction_group_ring(std::uint32_t number) const {
    return detail::list<LaneId>([&](auto... out) { return mapd_junction_group_ring(get(), number, out...); });
  }

  /// First lanes of the movements that a light governs.
  Result<std::vector<LaneId>> try_signal_movements(SignalId signal) const {
    return detail::list<LaneId>([&](auto... out) { return mapd_signal_movements(get(), signal, out...); });
  }

#if MAPD_EXCEPTIONS
  JunctionFacts junction(JunctionId junction) const { return try_junction(junction).value(); }
  std::vector<Connection> connections(JunctionId junction) const { return try_connections(junction).value(); }
  std::optional<GridHeight> grid_height_at(JunctionId junction, Vec2 point) const { return try_grid_height_at(junction, point).value(); }
  SignalFacts signal(SignalId signal) const { return try_signal(signal).value(); }
  std::vector<LaneSignal> lane_signals(LaneId lane, std::uint32_t which) const { return try_lane_signals(lane, which).value(); }
  std::vector<SignalAhead> signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch) const { return try_signals_ahead(from, distance, vehicle, scratch).value(); }
  std::vector<SignalAhead> signals_along(span<const RouteStep> steps, Scratch& scratch) const { return try_signals_along(steps, scratch).value(); }
  std::vector<LaneLine> lines_along(span<const RouteStep> steps, Scratch& scratch) const { return try_lines_along(steps, scratch).value(); }
  std::uint8_t turn(LaneId lane) const { return try_turn(lane).value(); }
  std::vector<LaneId> entries(LaneId lane) const { return try_entries(lane).value(); }
  std::vector<LaneId> movement_lanes(LaneId lane) const { return try_movement_lanes(lane).value(); }
  std::vector<LaneSignal> movement_lights(LaneId lane) const { return try_movement_lights(lane).value(); }
  std::optional<LaneLine> movement_stop(LaneId lane) const { return try_movement_stop(lane).value(); }
  std::vector<LaneLine> lane_lines(LaneId lane, std::uint32_t which) const { return try_lane_lines(lane, which).value(); }
  std::vector<RightOfWay> right_of_way(LaneId lane) const { return try_right_of_way(lane).value(); }
  std::optional<std::vector<RightOfWay>> right_of_way_by(LaneId lane, const std::string& country) const { return try_right_of_way_by(lane, country).value(); }
  std::vector<ConflictApproach> approaches(const PathConflict& conflict, double distance, std::uint8_t vehicle, Scratch& scratch) const { return try_approaches(conflict, distance, vehicle, scratch).value(); }
  std::vector<SignalLink> signal_links(SignalId signal, std::uint32_t which) const { return try_signal_links(signal, which).value(); }
  std::vector<Controller> controllers() const { return try_controllers().value(); }
  std::vector<SignalId> controller_signals(std::uint32_t number) const { return try_controller_signals(number).value(); }
  std::vector<std::uint32_t> signal_controllers(SignalId signal) const { return try_signal_controllers(signal).value(); }
  std::vector<std::uint32_t> junction_controllers(JunctionId junction) const { return try_junction_controllers(junction).value(); }
  std::vector<JunctionGroup> junction_groups() const { return try_junction_groups().value(); }
  std::vector<JunctionId> junction_group_members(std::uint32_t number) const { return try_junction_group_members(number).value(); }
  std::vector<LaneId> junction_group_ring(std::uint32_t number) const { return try_junction_group_ring(number).value(); }
  std::vector<LaneId> signal_movements(SignalId signal) const { return try_signal_movements(signal).value(); }
#endif

  // Objects.

  /// What an object is.
  Result<ObjectFacts> try_object(ObjectId object) const {
    return detail::value<ObjectFacts>([&](auto... out) { return mapd_object_facts_of(get(), object, out...); });
  }

  /// Every place where an object stands.
  Result<std::vector<PlacementFacts>> try_placements(ObjectId object) const {
    return detail::list<PlacementFacts>([&](auto... out) { return mapd_object_placements(get(), object, out...); });
  }

  /// An object where it stands.
  Result<PlacementFacts> try_placement(PlacementId place) const {
    return detail::value<PlacementFacts>([&](auto... out) { return mapd_placement_facts_of(get(), place, out...); });
  }

  /// Corners of the area that an object covers.
  Result<std::vector<Vec3>> try_footprint(PlacementId place, Scratch& scratch) const {
    return detail::list<Vec3>([&](auto... out) { return mapd_placement_footprint(get(), place, scratch.get(), out...); });
  }

  /// Lanes that an object belongs to.
  Result<std::vector<ObjectLane>> try_object_lanes(ObjectId object) const {
    return detail::list<ObjectLane>([&](auto... out) { return mapd_object_lanes(get(), object, out...); });
  }

  /// Objects that belong to a lane.
  Result<std::vector<ObjectLane>> try_lane_objects(LaneId lane) const {
    return detail::list<ObjectLane>([&](auto... out) { return mapd_lane_objects(get(), lane, out...); });
  }

#if MAPD_EXCEPTIONS
  ObjectFacts object(ObjectId object) const { return try_object(object).value(); }
  std::vector<PlacementFacts> placements(ObjectId object) const { return try_placements(object).value(); }
  PlacementFacts placement(PlacementId place) const { return try_placement(place).value(); }
  std::vector<Vec3> footprint(PlacementId place, Scratch& scratch) const { return try_footprint(place, scratch).value(); }
  std::vector<ObjectLane> object_lanes(ObjectId object) const { return try_object_lanes(object).value(); }
  std::vector<ObjectLane> lane_objects(LaneId lane) const { return try_lane_objects(lane).value(); }
#endif

  // The map itself.

  /// Facts about the map.
  Result<MapFacts> try_facts() const {
    return detail::value<MapFacts>([&](auto... out) { return mapd_map_facts_of(get(), out...); });
  }

  /// Revision of what is laid over the map; 0 where nothing is.
  Result<std::uint64_t> try_overlay_revision() const {
    return detail::value<std::uint64_t>([&](auto... out) { return mapd_snapshot_overlay_revision(get(), out...); });
  }

  /// A country of a path's fact, as the file writes it; it points into the snapshot.
  Result<std::optional<std::string_view>> try_country(std::uint32_t number) const {
    const auto text = detail::optional<mapd_text>([&](auto... out) { return mapd_country(get(), number, out...); });
    if (!text) return text.error();
    return *text ? std::optional(view(**text)) : std::nullopt;
  }

  /// All bridges and tunnels.
  Result<std::vector<Structure>> try_structures() const {
    return detail::list<Structure>([&](auto... out) { return mapd_structures(get(), out...); });
  }

  /// All references to objects of other roads.
  Result<std::vector<ObjectReference>> try_object_references() const {
    return detail::list<ObjectReference>([&](auto... out) { return mapd_object_references(get(), out...); });
  }

  /// Parts of the document that are not in the map as written.
  Result<std::vector<Quarantined>> try_quarantined_parts() const {
    return detail::list<Quarantined>([&](auto... out) { return mapd_quarantined_parts(get(), out...); });
  }

  /// Why the map has no part of this kind and id; kind is a MAPD_QUARANTINED_KIND_….
  Result<std::optional<Quarantined>> try_left_out(std::uint8_t kind, const std::string& id) const {
    return detail::optional<Quarantined>([&](auto... out) { return mapd_left_out(get(), kind, id.c_str(), out...); });
  }

  /// Latitudes and longitudes of the map's bounds.
  Result<std::optional<GeodeticBounds>> try_geodetic_bounds() const {
    return detail::optional<GeodeticBounds>([&](auto... out) { return mapd_map_geodetic_bounds(get(), out...); });
  }

#if MAPD_EXCEPTIONS
  MapFacts facts() const { return try_facts().value(); }
  std::uint64_t overlay_revision() const { return try_overlay_revision().value(); }
  std::optional<std::string_view> country(std::uint32_t number) const { return try_country(number).value(); }
  std::vector<Structure> structures() const { return try_structures().value(); }
  std::vector<ObjectReference> object_references() const { return try_object_references().value(); }
  std::vector<Quarantined> quarantined_parts() const { return try_quarantined_parts().value(); }
  std::optional<Quarantined> left_out(std::uint8_t kind, const std::string& id) const { return try_left_out(kind, id).value(); }
  std::optional<GeodeticBounds> geodetic_bounds() const { return try_geodetic_bounds().value(); }
#endif
};

}  // namespace mapd
