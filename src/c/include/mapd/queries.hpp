/// What handles are asked, a method for each function of C; `mapd.h` documents units, signs and errors of each. Made from the sources of the
/// crate mapd-c by `cargo run -p mapd-c --example header`.
#pragma once

#include "base.hpp"

namespace mapd {

/// Converts between a map's inertial frame and WGS 84.
class Projector : public detail::Owner<mapd_projector, mapd_projector_close> {
 public:
  using Owner::Owner;

  // Places on Earth.

  /// Where a point of the map lies on Earth.
  Result<Geodetic> try_to_geodetic(Vec3 point) const {
    return detail::value<Geodetic>([&](auto... rest) { return mapd_to_geodetic(get(), point, rest...); });
  }

  /// The point of the map at a place on Earth.
  Result<Vec3> try_from_geodetic(Geodetic place) const {
    return detail::value<Vec3>([&](auto... rest) { return mapd_from_geodetic(get(), place, rest...); });
  }

  /// As `mapd_to_geodetic`, of `count` points; `out` has room for as many.
  Error try_to_geodetic(span<const Vec3> points, span<Geodetic> out) const {
    return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_to_geodetic_batch(get(), all, count, rest...); });
  }

  /// As `mapd_from_geodetic`, of `count` places; `out` has room for as many.
  Error try_from_geodetic(span<const Geodetic> places, span<Vec3> out) const {
    return detail::batch(places, out, [&](auto all, auto count, auto... rest) { return mapd_from_geodetic_batch(get(), all, count, rest...); });
  }

  /// Heading of true north at each of `count` points of the map [rad], counter-clockwise from x, in (−π, π]. A heading that a receiver gives clockwise from
  /// true north is this minus that one. `out` has room for as many.
  Error try_north_at(span<const Vec3> points, span<double> out) const {
    return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_north_at_batch(get(), all, count, rest...); });
  }

  /// East, north and up [m] of each of `count` points of the map, from `origin`, a point of the map: the topocentric frame, in the plane that touches the Earth
  /// there. `out` has room for as many.
  Error try_to_enu(Vec3 origin, span<const Vec3> points, span<Vec3> out) const {
    return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_to_enu_batch(get(), origin, all, count, rest...); });
  }

  /// The points of the map at each of `count` easts, norths and ups [m] from `origin`, a point of the map. `out` has room for as many.
  Error try_from_enu(Vec3 origin, span<const Vec3> places, span<Vec3> out) const {
    return detail::batch(places, out, [&](auto all, auto count, auto... rest) { return mapd_from_enu_batch(get(), origin, all, count, rest...); });
  }

#if MAPD_EXCEPTIONS
  Geodetic to_geodetic(Vec3 point) const { return try_to_geodetic(point).value(); }
  Vec3 from_geodetic(Geodetic place) const { return try_from_geodetic(place).value(); }
  void to_geodetic(span<const Vec3> points, span<Geodetic> out) const { detail::must(try_to_geodetic(points, out)); }
  void from_geodetic(span<const Geodetic> places, span<Vec3> out) const { detail::must(try_from_geodetic(places, out)); }
  void north_at(span<const Vec3> points, span<double> out) const { detail::must(try_north_at(points, out)); }
  void to_enu(Vec3 origin, span<const Vec3> points, span<Vec3> out) const { detail::must(try_to_enu(origin, points, out)); }
  void from_enu(Vec3 origin, span<const Vec3> places, span<Vec3> out) const { detail::must(try_from_enu(origin, places, out)); }
#endif
};

/// What a path is asked: see `Path`.
class PathQueries : public detail::Owner<mapd_path, mapd_path_close> {
 public:
  using Owner::Owner;

  // A route as one line.

  /// Length: the largest S [m].
  Result<double> try_length() const {
    return detail::value<double>([&](auto... rest) { return mapd_path_length(get(), rest...); });
  }

  /// The place at S, `along` [m]. S outside the path is moved to its nearer end and flagged.
  Result<PathPoint> try_at(double along) const {
    return detail::value<PathPoint>([&](auto... rest) { return mapd_path_at(get(), along, rest...); });
  }

  /// A point in the path's coordinates.
  Result<PathPosition> try_project(Vec2 point, std::optional<double> hint = std::nullopt) const {
    const double* begin = hint ? &*hint : nullptr;
    return detail::value<PathPosition>([&](auto... rest) { return mapd_path_project(get(), point, begin, rest...); });
  }

  /// The speed limit at S, `along` [m]; in a junction that which comes in on the path.
  Result<std::optional<SpeedRule>> try_speed_at(double along) const {
    return detail::optional<SpeedRule>([&](auto... rest) { return mapd_path_speed_at(get(), along, rest...); });
  }

  /// Gaps, overlaps and kinks of more than rounding, and changes of lane, in ascending S.
  Result<std::vector<PathJoint>> try_joints() const {
    return detail::list<PathJoint>([&](auto... rest) { return mapd_path_joints(get(), rest...); });
  }
  Error try_joints(std::vector<PathJoint>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_joints(get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  double length() const { return try_length().value(); }
  PathPoint at(double along) const { return try_at(along).value(); }
  PathPosition project(Vec2 point, std::optional<double> hint = std::nullopt) const { return try_project(point, hint).value(); }
  std::optional<SpeedRule> speed_at(double along) const { return try_speed_at(along).value(); }
  std::vector<PathJoint> joints() const { return try_joints().value(); }
  void joints(std::vector<PathJoint>& out) const { detail::must(try_joints(out)); }
#endif

  // Places along a path: its lanes, and many places at once.

  /// The lanes that are driven on, in ascending S; one that is only changed from is not among them.
  Result<std::vector<PathLane>> try_lanes() const {
    return detail::list<PathLane>([&](auto... rest) { return mapd_path_lanes(get(), rest...); });
  }
  Error try_lanes(std::vector<PathLane>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_lanes(get(), rest...); });
  }

  /// S of a place on one of the path's lanes [m]: the first where it is driven over several times.
  Result<std::optional<double>> try_along_of(PositionOnLane place) const {
    return detail::optional<double>([&](auto... rest) { return mapd_path_along_of(get(), place.lane, place.s, rest...); });
  }

  /// Whether some joint is broken, 1 or 0: a gap of more than 0.1 m or a kink of more than 0.3 rad.
  Result<bool> try_is_broken() const {
    return detail::boolean([&](auto... rest) { return mapd_path_is_broken(get(), rest...); });
  }

  /// As `mapd_path_at`, of `count` places; `out` has room for as many.
  Error try_at(span<const double> along, span<PathPoint> out) const {
    return detail::batch(along, out, [&](auto all, auto count, auto... rest) { return mapd_path_at_batch(get(), all, count, rest...); });
  }

  /// As `mapd_path_project` without a hint, of `count` points; `out` has room for as many.
  Error try_project(span<const Vec2> points, span<PathPosition> out) const {
    return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_path_project_batch(get(), all, count, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<PathLane> lanes() const { return try_lanes().value(); }
  void lanes(std::vector<PathLane>& out) const { detail::must(try_lanes(out)); }
  std::optional<double> along_of(PositionOnLane place) const { return try_along_of(place).value(); }
  bool is_broken() const { return try_is_broken().value(); }
  void at(span<const double> along, span<PathPoint> out) const { detail::must(try_at(along, out)); }
  void project(span<const Vec2> points, span<PathPosition> out) const { detail::must(try_project(points, out)); }
#endif

  // What a path comes by, how fast it may be driven, and from which lanes its goal is reached.

  /// What the path comes by, in ascending S: junctions with the turn, signals, stop lines and crossings, types of roads and lanes, countries, who may use the
  /// lane, bridges and tunnels, and holes of the map. What goes on over several lanes stands once. Speed limits are `mapd_path_speeds`.
  Result<std::vector<PathFact>> try_facts(Scratch& scratch) const {
    return detail::list<PathFact>([&](auto... rest) { return mapd_path_facts(get(), scratch.get(), rest...); });
  }
  Error try_facts(Scratch& scratch, std::vector<PathFact>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_facts(get(), scratch.get(), rest...); });
  }

  /// The speed limits along the path, in ascending S without gaps.
  Result<std::vector<PathSpeed>> try_speeds(Scratch& scratch) const {
    return detail::list<PathSpeed>([&](auto... rest) { return mapd_path_speeds(get(), scratch.get(), rest...); });
  }
  Error try_speeds(Scratch& scratch, std::vector<PathSpeed>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_speeds(get(), scratch.get(), rest...); });
  }

  /// How long a vehicle takes from S, `from`, to S, `to` [m], at the speed limits. S outside the path is moved to its nearer end.
  Result<PathTime> try_travel_time(double from, double to) const {
    return detail::value<PathTime>([&](auto... rest) { return mapd_path_travel_time(get(), from, to, rest...); });
  }

  /// On every stretch of the path the lanes from which its goal is reached along the same roads, from left to right as the driver sees them. Stretches are in
  /// ascending S and cover the path; on each it is the same who may go where. `vehicle` is a `MAPD_VEHICLE_CLASS_…`.
  Result<std::vector<PathSegment>> try_segments(std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<PathSegment>([&](auto... rest) { return mapd_path_segments(get(), vehicle, scratch.get(), rest...); });
  }
  Error try_segments(std::uint8_t vehicle, Scratch& scratch, std::vector<PathSegment>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_segments(get(), vehicle, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<PathFact> facts(Scratch& scratch) const { return try_facts(scratch).value(); }
  void facts(Scratch& scratch, std::vector<PathFact>& out) const { detail::must(try_facts(scratch, out)); }
  std::vector<PathSpeed> speeds(Scratch& scratch) const { return try_speeds(scratch).value(); }
  void speeds(Scratch& scratch, std::vector<PathSpeed>& out) const { detail::must(try_speeds(scratch, out)); }
  PathTime travel_time(double from, double to) const { return try_travel_time(from, to).value(); }
  std::vector<PathSegment> segments(std::uint8_t vehicle, Scratch& scratch) const { return try_segments(vehicle, scratch).value(); }
  void segments(std::uint8_t vehicle, Scratch& scratch, std::vector<PathSegment>& out) const { detail::must(try_segments(vehicle, scratch, out)); }
#endif

  // Steps of routes and paths: made of lanes, cut out of a path, found again on the next version of a map; their changes of lane and length.

  /// The part of a path's steps from S, `from`, to S, `to` [m]: what a new path over it is made of. `steps` are those that the path was made from.
  Result<std::vector<RouteStep>> try_steps_between(span<const RouteStep> steps, double from, double to, Scratch& scratch) const {
    return detail::list<RouteStep>([&](auto... rest) { return mapd_path_steps_between(get(), steps.data(), steps.size(), from, to, scratch.get(), rest...); });
  }
  Error try_steps_between(span<const RouteStep> steps, double from, double to, Scratch& scratch, std::vector<RouteStep>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_steps_between(get(), steps.data(), steps.size(), from, to, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<RouteStep> steps_between(span<const RouteStep> steps, double from, double to, Scratch& scratch) const { return try_steps_between(steps, from, to, scratch).value(); }
  void steps_between(span<const RouteStep> steps, double from, double to, Scratch& scratch, std::vector<RouteStep>& out) const { detail::must(try_steps_between(steps, from, to, scratch, out)); }
#endif

  // The room along a path.

  /// The room along the path from S, `from` [m], on: a station every `step` [m] and one at the end, `length` [m] on or where the path ends. `vehicle` is a
  /// `MAPD_VEHICLE_CLASS_…`.
  Result<std::vector<CorridorStation>> try_corridor(double from, double length, double step, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<CorridorStation>([&](auto... rest) { return mapd_path_corridor(get(), from, length, step, vehicle, scratch.get(), rest...); });
  }
  Error try_corridor(double from, double length, double step, std::uint8_t vehicle, Scratch& scratch, std::vector<CorridorStation>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_corridor(get(), from, length, step, vehicle, scratch.get(), rest...); });
  }

  /// The road's surface at the stations that `mapd_path_corridor` has for the same numbers.
  Result<std::vector<CorridorSurface>> try_corridor_surface(double from, double length, double step, Scratch& scratch) const {
    return detail::list<CorridorSurface>([&](auto... rest) { return mapd_path_corridor_surface(get(), from, length, step, scratch.get(), rest...); });
  }
  Error try_corridor_surface(double from, double length, double step, Scratch& scratch, std::vector<CorridorSurface>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_corridor_surface(get(), from, length, step, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<CorridorStation> corridor(double from, double length, double step, std::uint8_t vehicle, Scratch& scratch) const { return try_corridor(from, length, step, vehicle, scratch).value(); }
  void corridor(double from, double length, double step, std::uint8_t vehicle, Scratch& scratch, std::vector<CorridorStation>& out) const { detail::must(try_corridor(from, length, step, vehicle, scratch, out)); }
  std::vector<CorridorSurface> corridor_surface(double from, double length, double step, Scratch& scratch) const { return try_corridor_surface(from, length, step, scratch).value(); }
  void corridor_surface(double from, double length, double step, Scratch& scratch, std::vector<CorridorSurface>& out) const { detail::must(try_corridor_surface(from, length, step, scratch, out)); }
#endif

  // Who meets a path: other lanes' traffic, where it comes from, and who crosses on foot.

  /// Where other traffic meets the path, in ascending S: on lanes of junctions and others that the map knows to conflict, where lanes merge into one, and on
  /// roads that lie at the same place. What the path itself drives just before or behind is left out. Lanes that lead into each other are one conflict where
  /// what they have in common with the path touches; `lanes` gets all lanes, those of a conflict behind each other, and `lane_count` their number.
  Result<PathConflicts> try_conflicts(Scratch& scratch) const {
    return detail::conflicts<PathConflicts>([&](auto... rest) { return mapd_path_conflicts(get(), scratch.get(), rest...); });
  }

  /// Crosswalks and bicycle crossings over the path, in ascending S, whether the file writes them as signals or as objects.
  Result<std::vector<PathCrossing>> try_crossings(Scratch& scratch) const {
    return detail::list<PathCrossing>([&](auto... rest) { return mapd_path_crossings(get(), scratch.get(), rest...); });
  }
  Error try_crossings(Scratch& scratch, std::vector<PathCrossing>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_path_crossings(get(), scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  PathConflicts conflicts(Scratch& scratch) const { return try_conflicts(scratch).value(); }
  std::vector<PathCrossing> crossings(Scratch& scratch) const { return try_crossings(scratch).value(); }
  void crossings(Scratch& scratch, std::vector<PathCrossing>& out) const { detail::must(try_crossings(scratch, out)); }
#endif
};

/// What a snapshot is asked: see `Snapshot`.
class Queries : public detail::Owner<mapd_snapshot, mapd_snapshot_close> {
 public:
  using Owner::Owner;

  // One pinned generation, and facts about its map.

  /// Revision of the map's overlay, which rises with each change; 0 without an overlay. `mapd_view_new` applies the overlay.
  Result<std::uint64_t> try_overlay_revision() const {
    return detail::value<std::uint64_t>([&](auto... rest) { return mapd_snapshot_overlay_revision(get(), rest...); });
  }

  /// Facts about the map.
  Result<MapFacts> try_facts() const {
    return detail::value<MapFacts>([&](auto... rest) { return mapd_map_facts_of(get(), rest...); });
  }

  /// Latitudes and longitudes of the map's bounds, rounded to 1e-9 degrees.
  Result<std::optional<GeodeticBounds>> try_geodetic_bounds() const {
    return detail::optional<GeodeticBounds>([&](auto... rest) { return mapd_map_geodetic_bounds(get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::uint64_t overlay_revision() const { return try_overlay_revision().value(); }
  MapFacts facts() const { return try_facts().value(); }
  std::optional<GeodeticBounds> geodetic_bounds() const { return try_geodetic_bounds().value(); }
#endif

  // From names and rows to ids and back.

  /// The road with OpenDRIVE's id, compared byte by byte.
  Result<std::optional<RoadId>> try_road_by_id(const std::string& id) const {
    return detail::optional<RoadId>([&](auto... rest) { return mapd_road_by_id(get(), id.c_str(), rest...); });
  }

  /// The junction with OpenDRIVE's id, compared byte by byte.
  Result<std::optional<JunctionId>> try_junction_by_id(const std::string& id) const {
    return detail::optional<JunctionId>([&](auto... rest) { return mapd_junction_by_id(get(), id.c_str(), rest...); });
  }

  /// A signal with OpenDRIVE's id, compared byte by byte; of several with one id any.
  Result<std::optional<SignalId>> try_signal_by_id(const std::string& id) const {
    return detail::optional<SignalId>([&](auto... rest) { return mapd_signal_by_id(get(), id.c_str(), rest...); });
  }

  /// The object with OpenDRIVE's id, compared byte by byte; of several the first.
  Result<std::optional<ObjectId>> try_object_by_id(const std::string& id) const {
    return detail::optional<ObjectId>([&](auto... rest) { return mapd_object_by_id(get(), id.c_str(), rest...); });
  }

  /// The lane with a key such as `12:0:-1`; of one in several pieces the first.
  Result<std::optional<LaneId>> try_lane_by_key(const std::string& key) const {
    return detail::optional<LaneId>([&](auto... rest) { return mapd_lane_by_key(get(), key.c_str(), rest...); });
  }

  /// OpenDRIVE's id of a road, verbatim.
  Result<std::string_view> try_road_name_id(RoadId road) const {
    return detail::text([&](auto... rest) { return mapd_road_name_id(get(), road, rest...); });
  }

  /// All roads in file order.
  Result<std::vector<RoadId>> try_roads() const {
    return detail::list<RoadId>([&](auto... rest) { return mapd_roads(get(), rest...); });
  }
  Error try_roads(std::vector<RoadId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_roads(get(), rest...); });
  }

  /// All junctions in file order.
  Result<std::vector<JunctionId>> try_junctions() const {
    return detail::list<JunctionId>([&](auto... rest) { return mapd_junctions(get(), rest...); });
  }
  Error try_junctions(std::vector<JunctionId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_junctions(get(), rest...); });
  }

  /// All lanes, those of the number 0 and of the temporary layer left out.
  Result<std::vector<LaneId>> try_lanes() const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_lanes(get(), rest...); });
  }
  Error try_lanes(std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lanes(get(), rest...); });
  }

  /// All signals in file order, signs on boards behind what carries them.
  Result<std::vector<SignalId>> try_signals() const {
    return detail::list<SignalId>([&](auto... rest) { return mapd_signals(get(), rest...); });
  }
  Error try_signals(std::vector<SignalId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_signals(get(), rest...); });
  }

  /// All objects: those of roads in the order of the roads, then those of junctions.
  Result<std::vector<ObjectId>> try_objects() const {
    return detail::list<ObjectId>([&](auto... rest) { return mapd_objects(get(), rest...); });
  }
  Error try_objects(std::vector<ObjectId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_objects(get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<RoadId> road_by_id(const std::string& id) const { return try_road_by_id(id).value(); }
  std::optional<JunctionId> junction_by_id(const std::string& id) const { return try_junction_by_id(id).value(); }
  std::optional<SignalId> signal_by_id(const std::string& id) const { return try_signal_by_id(id).value(); }
  std::optional<ObjectId> object_by_id(const std::string& id) const { return try_object_by_id(id).value(); }
  std::optional<LaneId> lane_by_key(const std::string& key) const { return try_lane_by_key(key).value(); }
  std::string_view road_name_id(RoadId road) const { return try_road_name_id(road).value(); }
  std::vector<RoadId> roads() const { return try_roads().value(); }
  void roads(std::vector<RoadId>& out) const { detail::must(try_roads(out)); }
  std::vector<JunctionId> junctions() const { return try_junctions().value(); }
  void junctions(std::vector<JunctionId>& out) const { detail::must(try_junctions(out)); }
  std::vector<LaneId> lanes() const { return try_lanes().value(); }
  void lanes(std::vector<LaneId>& out) const { detail::must(try_lanes(out)); }
  std::vector<SignalId> signals() const { return try_signals().value(); }
  void signals(std::vector<SignalId>& out) const { detail::must(try_signals(out)); }
  std::vector<ObjectId> objects() const { return try_objects().value(); }
  void objects(std::vector<ObjectId>& out) const { detail::must(try_objects(out)); }
#endif

  // Lanes near a place.

  /// The lane whose area is nearest to a point in plan view, within the options' radius; distance 0 inside. Ties go by heading difference, z difference, lanes
  /// without width last, |offset|, then key.
  Result<std::optional<Nearest>> try_nearest_lane(Point point, const NearestOptions& options = {}) const {
    const mapd_nearest_options own = options.c();
    return detail::optional<Nearest>([&](auto... rest) { return mapd_nearest_lane(get(), point, &own, rest...); });
  }

  /// As `mapd_nearest_lane`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW` and a position of
  /// zeros. Points near each other, in whatever order, cost a fraction of single calls.
  Error try_nearest_lanes(span<const mapd_point> points, span<Nearest> out, Scratch& scratch, const NearestOptions& options = {}) const {
    const mapd_nearest_options own = options.c();
    return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_nearest_lane_batch(get(), all, count, &own, scratch.get(), rest...); });
  }

  /// Every lane whose area lies within the options' radius of a point, nearest first, each once.
  Result<std::vector<Nearest>> try_lanes_near(Point point, Scratch& scratch, const NearestOptions& options = {}) const {
    const mapd_nearest_options own = options.c();
    return detail::list<Nearest>([&](auto... rest) { return mapd_lanes_near(get(), point, &own, scratch.get(), rest...); });
  }
  Error try_lanes_near(Point point, Scratch& scratch, std::vector<Nearest>& out, const NearestOptions& options = {}) const {
    const mapd_nearest_options own = options.c();
    return detail::list_into(out, [&](auto... rest) { return mapd_lanes_near(get(), point, &own, scratch.get(), rest...); });
  }

  /// Every lane of these types whose area meets a rectangle in plan view, in the order of their rows.
  Result<std::vector<LaneId>> try_lanes_in(Region region, std::uint64_t types, Scratch& scratch) const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_lanes_in(get(), region, types, scratch.get(), rest...); });
  }
  Error try_lanes_in(Region region, std::uint64_t types, Scratch& scratch, std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lanes_in(get(), region, types, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<Nearest> nearest_lane(Point point, const NearestOptions& options = {}) const { return try_nearest_lane(point, options).value(); }
  void nearest_lanes(span<const mapd_point> points, span<Nearest> out, Scratch& scratch, const NearestOptions& options = {}) const { detail::must(try_nearest_lanes(points, out, scratch, options)); }
  std::vector<Nearest> lanes_near(Point point, Scratch& scratch, const NearestOptions& options = {}) const { return try_lanes_near(point, scratch, options).value(); }
  void lanes_near(Point point, Scratch& scratch, std::vector<Nearest>& out, const NearestOptions& options = {}) const { detail::must(try_lanes_near(point, scratch, out, options)); }
  std::vector<LaneId> lanes_in(Region region, std::uint64_t types, Scratch& scratch) const { return try_lanes_in(region, types, scratch).value(); }
  void lanes_in(Region region, std::uint64_t types, Scratch& scratch, std::vector<LaneId>& out) const { detail::must(try_lanes_in(region, types, scratch, out)); }
#endif

  // Roads.

  /// What a road is.
  Result<RoadFacts> try_road(RoadId road) const {
    return detail::value<RoadFacts>([&](auto... rest) { return mapd_road_facts_of(get(), road, rest...); });
  }

  /// Inertial pose of a track position: (x, y, e) + t along the rolled lateral axis + h along its normal. s beyond the reference line is moved to its end and
  /// flagged.
  Result<Pose> try_to_inertial(RoadId road, Track track) const {
    return detail::value<Pose>([&](auto... rest) { return mapd_road_to_inertial(get(), road, track, rest...); });
  }

  /// Track position of a point: the foot on the nearest place of the whole reference line. Without z in plan view.
  Result<TrackPosition> try_to_track(RoadId road, Point point) const {
    return detail::value<TrackPosition>([&](auto... rest) { return mapd_road_to_track(get(), road, point, rest...); });
  }

  /// As `mapd_road_to_inertial`, of `count` track positions; `out` has room for as many.
  Error try_to_inertial(RoadId road, span<const Track> tracks, span<Pose> out) const {
    return detail::batch(tracks, out, [&](auto all, auto count, auto... rest) { return mapd_road_to_inertial_batch(get(), road, all, count, rest...); });
  }

  /// As `mapd_road_to_track`, of `count` points; `out` has room for as many.
  Error try_to_track(RoadId road, span<const mapd_point> points, span<TrackPosition> out) const {
    return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_road_to_track_batch(get(), road, all, count, rest...); });
  }

  /// Elevation of the reference line at s [m]. s outside the road counts as its nearer end.
  Result<double> try_elevation_at(RoadId road, double s) const {
    return detail::value<double>([&](auto... rest) { return mapd_road_elevation_at(get(), road, s, rest...); });
  }

  /// Superelevation at s [rad]; positive lifts the left side. s outside the road counts as its nearer end.
  Result<double> try_superelevation_at(RoadId road, double s) const {
    return detail::value<double>([&](auto... rest) { return mapd_road_superelevation_at(get(), road, s, rest...); });
  }

  /// Lane offset at s [m]; positive to the left. s outside the road counts as its nearer end.
  Result<double> try_lane_offset_at(RoadId road, double s) const {
    return detail::value<double>([&](auto... rest) { return mapd_road_lane_offset_at(get(), road, s, rest...); });
  }

  /// The lane that covers (s, t); on a shared edge the one nearer to lane 0.
  Result<std::optional<LaneId>> try_lane_at(RoadId road, double s, double t) const {
    return detail::optional<LaneId>([&](auto... rest) { return mapd_road_lane_at(get(), road, s, t, rest...); });
  }

  /// The lane with OpenDRIVE's number at s; at a boundary of two sections that of the later one.
  Result<std::optional<LaneId>> try_lane_numbered(RoadId road, double s, std::int32_t number) const {
    return detail::optional<LaneId>([&](auto... rest) { return mapd_road_lane_numbered(get(), road, s, number, rest...); });
  }

  /// Lanes of a section of the road, by the section's number from 0, from left to right, lane 0 among them.
  Result<std::vector<LaneId>> try_section_lanes(RoadId road, std::uint32_t section) const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_road_section_lanes(get(), road, section, rest...); });
  }
  Error try_section_lanes(RoadId road, std::uint32_t section, std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_road_section_lanes(get(), road, section, rest...); });
  }

#if MAPD_EXCEPTIONS
  RoadFacts road(RoadId road) const { return try_road(road).value(); }
  Pose to_inertial(RoadId road, Track track) const { return try_to_inertial(road, track).value(); }
  TrackPosition to_track(RoadId road, Point point) const { return try_to_track(road, point).value(); }
  void to_inertial(RoadId road, span<const Track> tracks, span<Pose> out) const { detail::must(try_to_inertial(road, tracks, out)); }
  void to_track(RoadId road, span<const mapd_point> points, span<TrackPosition> out) const { detail::must(try_to_track(road, points, out)); }
  double elevation_at(RoadId road, double s) const { return try_elevation_at(road, s).value(); }
  double superelevation_at(RoadId road, double s) const { return try_superelevation_at(road, s).value(); }
  double lane_offset_at(RoadId road, double s) const { return try_lane_offset_at(road, s).value(); }
  std::optional<LaneId> lane_at(RoadId road, double s, double t) const { return try_lane_at(road, s, t).value(); }
  std::optional<LaneId> lane_numbered(RoadId road, double s, std::int32_t number) const { return try_lane_numbered(road, s, number).value(); }
  std::vector<LaneId> section_lanes(RoadId road, std::uint32_t section) const { return try_section_lanes(road, section).value(); }
  void section_lanes(RoadId road, std::uint32_t section, std::vector<LaneId>& out) const { detail::must(try_section_lanes(road, section, out)); }
#endif

  // Lanes: facts, places on them, neighbours, successors.

  /// What a lane is.
  Result<LaneFacts> try_lane(LaneId lane) const {
    return detail::value<LaneFacts>([&](auto... rest) { return mapd_lane_facts_of(get(), lane, rest...); });
  }

  /// A point in the lane's coordinates: exact foot on the reference line within the lane's section, distance from the lane's area.
  Result<LanePosition> try_position_of(LaneId lane, Point point) const {
    return detail::value<LanePosition>([&](auto... rest) { return mapd_lane_position_of(get(), lane, point, rest...); });
  }

  /// Pose at s as the lane's traffic has it, `offset` [m] to its left of the lane's centre, on the plane h = 0. Heading and curvature are those of the line
  /// that keeps this offset, in driving direction; slope and superelevation are the road's. s outside the lane's section is moved to its nearer end and
  /// flagged.
  Result<Pose> try_pose_at(LaneId lane, double s, double offset) const {
    return detail::value<Pose>([&](auto... rest) { return mapd_lane_pose_at(get(), lane, s, offset, rest...); });
  }

  /// As `mapd_lane_pose_at`, in the road's frame: heading and curvature are those of the reference line, ahead is the way s rises, and `offset` counts to the
  /// left of that.
  Result<Pose> try_pose_of_reference_line(LaneId lane, double s, double offset) const {
    return detail::value<Pose>([&](auto... rest) { return mapd_lane_pose_of_reference_line(get(), lane, s, offset, rest...); });
  }

  /// The centre line's exact place at s, with its own direction: that of `mapd_lane_pose_at` at offset 0. s outside the lane's section is moved to its nearer
  /// end and flagged.
  Result<Waypoint> try_waypoint_at(LaneId lane, double s) const {
    return detail::value<Waypoint>([&](auto... rest) { return mapd_lane_waypoint_at(get(), lane, s, rest...); });
  }

  /// Waypoints in driving direction, `step` [m] of s apart, from where the lane is entered to where it is left; both ends are among them.
  Result<std::vector<Waypoint>> try_waypoints(LaneId lane, double step) const {
    return detail::list<Waypoint>([&](auto... rest) { return mapd_lane_waypoints(get(), lane, step, rest...); });
  }
  Error try_waypoints(LaneId lane, double step, std::vector<Waypoint>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_waypoints(get(), lane, step, rest...); });
  }

  /// Both edges at s, as lateral coordinates. s outside the lane's section counts as its nearer end.
  Result<LaneEdges> try_edges_at(LaneId lane, double s) const {
    return detail::value<LaneEdges>([&](auto... rest) { return mapd_lane_edges_at(get(), lane, s, rest...); });
  }

  /// Both edges at s, inertial. s outside the lane's section counts as its nearer end.
  Result<LaneBounds> try_bounds_at(LaneId lane, double s) const {
    return detail::value<LaneBounds>([&](auto... rest) { return mapd_lane_bounds_at(get(), lane, s, rest...); });
  }

  /// Width at s [m], never negative. s outside the lane's section counts as its nearer end.
  Result<double> try_width_at(LaneId lane, double s) const {
    return detail::value<double>([&](auto... rest) { return mapd_lane_width_at(get(), lane, s, rest...); });
  }

  /// The speed limit that is recorded at s [m/s]: in the lane's own record, else in that of the road's type; infinite where the file says `no limit`. What
  /// holds may be another: `mapd_lane_speed_rule_at`.
  Result<std::optional<double>> try_recorded_speed_limit_at(LaneId lane, double s) const {
    return detail::optional<double>([&](auto... rest) { return mapd_lane_recorded_speed_limit_at(get(), lane, s, rest...); });
  }

  /// Length of the centre line in plan view between two places on the road [m]. s outside the lane's section counts as its nearer end.
  Result<double> try_length_between(LaneId lane, double a, double b) const {
    return detail::value<double>([&](auto... rest) { return mapd_lane_length_between(get(), lane, a, b, rest...); });
  }

  /// What a route by time counts for the centre line between two places on the road [s]: its length at `mapd_lane_recorded_speed_limit_at`, at 50 km/h where no
  /// limit is recorded, at 130 km/h where there is none. The time at the limits of a way is `mapd_path_travel_time`. s outside the lane's section counts as its
  /// nearer end.
  Result<double> try_time_between(LaneId lane, double a, double b) const {
    return detail::value<double>([&](auto... rest) { return mapd_lane_time_between(get(), lane, a, b, rest...); });
  }

  /// Which signs forbid overtaking at s. A sign holds from its place on, in driving direction, until another one ends it, over lanes that lead on alone, and
  /// not beyond a junction. What road marks forbid is `change_left` and `change_right` of `mapd_node_facts`.
  Result<OvertakingRule> try_overtaking_rule_at(LaneId lane, double s) const {
    return detail::value<OvertakingRule>([&](auto... rest) { return mapd_lane_overtaking_rule_at(get(), lane, s, rest...); });
  }

  /// The lane beside this one; `side` is a `MAPD_BESIDE_…`. One that shares the direction and may be changed to is `change_left` or `change_right` of
  /// `mapd_node_facts`.
  Result<std::optional<LaneId>> try_beside(LaneId lane, std::uint32_t side) const {
    return detail::optional<LaneId>([&](auto... rest) { return mapd_lane_beside(get(), lane, side, rest...); });
  }

  /// Lanes entered from this one in its own driving direction, in order of road id, section and lane.
  Result<std::vector<LaneId>> try_successors(LaneId lane) const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_lane_successors(get(), lane, rest...); });
  }
  Error try_successors(LaneId lane, std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_successors(get(), lane, rest...); });
  }

  /// Lanes from which this one is entered in its own driving direction, in order of road id, section and lane.
  Result<std::vector<LaneId>> try_predecessors(LaneId lane) const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_lane_predecessors(get(), lane, rest...); });
  }
  Error try_predecessors(LaneId lane, std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_predecessors(get(), lane, rest...); });
  }

#if MAPD_EXCEPTIONS
  LaneFacts lane(LaneId lane) const { return try_lane(lane).value(); }
  LanePosition position_of(LaneId lane, Point point) const { return try_position_of(lane, point).value(); }
  Pose pose_at(LaneId lane, double s, double offset) const { return try_pose_at(lane, s, offset).value(); }
  Pose pose_of_reference_line(LaneId lane, double s, double offset) const { return try_pose_of_reference_line(lane, s, offset).value(); }
  Waypoint waypoint_at(LaneId lane, double s) const { return try_waypoint_at(lane, s).value(); }
  std::vector<Waypoint> waypoints(LaneId lane, double step) const { return try_waypoints(lane, step).value(); }
  void waypoints(LaneId lane, double step, std::vector<Waypoint>& out) const { detail::must(try_waypoints(lane, step, out)); }
  LaneEdges edges_at(LaneId lane, double s) const { return try_edges_at(lane, s).value(); }
  LaneBounds bounds_at(LaneId lane, double s) const { return try_bounds_at(lane, s).value(); }
  double width_at(LaneId lane, double s) const { return try_width_at(lane, s).value(); }
  std::optional<double> recorded_speed_limit_at(LaneId lane, double s) const { return try_recorded_speed_limit_at(lane, s).value(); }
  double length_between(LaneId lane, double a, double b) const { return try_length_between(lane, a, b).value(); }
  double time_between(LaneId lane, double a, double b) const { return try_time_between(lane, a, b).value(); }
  OvertakingRule overtaking_rule_at(LaneId lane, double s) const { return try_overtaking_rule_at(lane, s).value(); }
  std::optional<LaneId> beside(LaneId lane, std::uint32_t side) const { return try_beside(lane, side).value(); }
  std::vector<LaneId> successors(LaneId lane) const { return try_successors(lane).value(); }
  void successors(LaneId lane, std::vector<LaneId>& out) const { detail::must(try_successors(lane, out)); }
  std::vector<LaneId> predecessors(LaneId lane) const { return try_predecessors(lane).value(); }
  void predecessors(LaneId lane, std::vector<LaneId>& out) const { detail::must(try_predecessors(lane, out)); }
#endif

  // Which lanes a vehicle may be in, by a pose or by a trace.

  /// The lanes of a trace: the most probable way through all its fixes. `out` has room for `count` answers, one for each fix.
  Error try_match_trace(span<const TraceFix> fixes, span<TraceMatch> out, Scratch& scratch, const TraceOptions& options = {}) const {
    return detail::batch(fixes, out, [&](auto all, auto count, auto... rest) { return mapd_match_trace(get(), all, count, &options, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  void match_trace(span<const TraceFix> fixes, span<TraceMatch> out, Scratch& scratch, const TraceOptions& options = {}) const { detail::must(try_match_trace(fixes, out, scratch, options)); }
#endif

  // The ground below a place, and the road mark beside it.

  /// The ground at a place, on the level whose height is nearest to the point's z. A point without z is on the lowest level with one of `expected_count` lanes,
  /// such as the one that the vehicle was in and those that it can reach from there; with none of them, on the lowest one. Heights more than 2 m apart are
  /// levels of their own.
  Result<std::optional<Ground>> try_ground_at(Point point, Scratch& scratch, span<const LaneId> expected = {}) const {
    return detail::optional<Ground>([&](auto... rest) { return mapd_ground_at(get(), point, expected.data(), expected.size(), scratch.get(), rest...); });
  }

  /// As `mapd_ground_at`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW`.
  Error try_ground_below(span<const mapd_point> points, span<Ground> out, Scratch& scratch, span<const LaneId> expected = {}) const {
    return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_ground_at_batch(get(), all, count, expected.data(), expected.size(), scratch.get(), rest...); });
  }

  /// The road mark that is nearest to a point, on the exact course of each of its lines. Lines count along their whole length, gaps included.
  Result<std::optional<NearMark>> try_nearest_mark(Vec2 point, const MarkFilter& filter = {}) const {
    return detail::optional<NearMark>([&](auto... rest) { return mapd_nearest_mark(get(), point, &filter, rest...); });
  }

  /// As `mapd_nearest_mark`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW`.
  Error try_nearest_marks(span<const Vec2> points, span<NearMark> out, const MarkFilter& filter = {}) const {
    return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_nearest_mark_batch(get(), all, count, &filter, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<Ground> ground_at(Point point, Scratch& scratch, span<const LaneId> expected = {}) const { return try_ground_at(point, scratch, expected).value(); }
  void ground_below(span<const mapd_point> points, span<Ground> out, Scratch& scratch, span<const LaneId> expected = {}) const { detail::must(try_ground_below(points, out, scratch, expected)); }
  std::optional<NearMark> nearest_mark(Vec2 point, const MarkFilter& filter = {}) const { return try_nearest_mark(point, filter).value(); }
  void nearest_marks(span<const Vec2> points, span<NearMark> out, const MarkFilter& filter = {}) const { detail::must(try_nearest_marks(points, out, filter)); }
#endif

  // Centre lines and borders as they are stored.

  /// Points of a lane's centre line or of one of its borders, in ascending s: a polyline of bounded error, as it is stored. `line` is a `MAPD_LINE_…`.
  Result<std::vector<LinePoint>> try_line(LaneId lane, std::uint32_t line) const {
    return detail::list<LinePoint>([&](auto... rest) { return mapd_lane_line(get(), lane, line, rest...); });
  }
  Error try_line(LaneId lane, std::uint32_t line, std::vector<LinePoint>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_line(get(), lane, line, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<LinePoint> line(LaneId lane, std::uint32_t line) const { return try_line(lane, line).value(); }
  void line(LaneId lane, std::uint32_t line, std::vector<LinePoint>& out) const { detail::must(try_line(lane, line, out)); }
#endif

  // The lane graph.

  /// Number of nodes of the lane graph; their rows count from 0.
  Result<std::size_t> try_node_count() const {
    return detail::value<std::size_t>([&](auto... rest) { return mapd_node_count(get(), rest...); });
  }

  /// What a node is.
  Result<NodeFacts> try_node(NodeId node) const {
    return detail::value<NodeFacts>([&](auto... rest) { return mapd_node_facts_of(get(), node, rest...); });
  }

  /// Edges that leave a node, by road id, section and lane of their targets.
  Result<std::vector<Edge>> try_edges(NodeId node) const {
    return detail::list<Edge>([&](auto... rest) { return mapd_node_edges(get(), node, rest...); });
  }
  Error try_edges(NodeId node, std::vector<Edge>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_node_edges(get(), node, rest...); });
  }

  /// Nodes from which a node is entered.
  Result<std::vector<NodeId>> try_node_predecessors(NodeId node) const {
    return detail::list<NodeId>([&](auto... rest) { return mapd_node_predecessors(get(), node, rest...); });
  }
  Error try_node_predecessors(NodeId node, std::vector<NodeId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_node_predecessors(get(), node, rest...); });
  }

  /// A lane's nodes in driving order; of a lane travelled both ways then those of the other way.
  Result<std::vector<NodeId>> try_nodes(LaneId lane) const {
    return detail::list<NodeId>([&](auto... rest) { return mapd_lane_nodes(get(), lane, rest...); });
  }
  Error try_nodes(LaneId lane, std::vector<NodeId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_nodes(get(), lane, rest...); });
  }

  /// The node that holds s, towards +s (`forward` not 0) or −s; at a cut the later one in that direction. s outside the lane's section counts as its nearer
  /// end.
  Result<std::optional<NodeId>> try_node_at(LaneId lane, double s, bool forward) const {
    return detail::optional<NodeId>([&](auto... rest) { return mapd_lane_node_at(get(), lane, s, detail::to_byte(forward), rest...); });
  }

  /// Whether a class of vehicles may use the lane at s in its own direction: 1 or 0. `vehicle` is a `MAPD_VEHICLE_CLASS_…`.
  Result<bool> try_allows_at(LaneId lane, double s, std::uint8_t vehicle) const {
    return detail::boolean([&](auto... rest) { return mapd_lane_allows_at(get(), lane, s, vehicle, rest...); });
  }

  /// Lanes of the same junction whose areas meet this one's.
  Result<std::vector<Conflict>> try_conflicts(LaneId lane) const {
    return detail::list<Conflict>([&](auto... rest) { return mapd_lane_conflicts(get(), lane, rest...); });
  }
  Error try_conflicts(LaneId lane, std::vector<Conflict>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_conflicts(get(), lane, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::size_t node_count() const { return try_node_count().value(); }
  NodeFacts node(NodeId node) const { return try_node(node).value(); }
  std::vector<Edge> edges(NodeId node) const { return try_edges(node).value(); }
  void edges(NodeId node, std::vector<Edge>& out) const { detail::must(try_edges(node, out)); }
  std::vector<NodeId> node_predecessors(NodeId node) const { return try_node_predecessors(node).value(); }
  void node_predecessors(NodeId node, std::vector<NodeId>& out) const { detail::must(try_node_predecessors(node, out)); }
  std::vector<NodeId> nodes(LaneId lane) const { return try_nodes(lane).value(); }
  void nodes(LaneId lane, std::vector<NodeId>& out) const { detail::must(try_nodes(lane, out)); }
  std::optional<NodeId> node_at(LaneId lane, double s, bool forward) const { return try_node_at(lane, s, forward).value(); }
  bool allows_at(LaneId lane, double s, std::uint8_t vehicle) const { return try_allows_at(lane, s, vehicle).value(); }
  std::vector<Conflict> conflicts(LaneId lane) const { return try_conflicts(lane).value(); }
  void conflicts(LaneId lane, std::vector<Conflict>& out) const { detail::must(try_conflicts(lane, out)); }
#endif

  // Routes, what can be reached, and what comes next.

  /// The cheapest way through `place_count` places, two or more, in their order, in driving direction and by allowed lane changes only.
  Result<std::optional<Route>> try_route(span<const PositionOnLane> places, Cost cost, Scratch& scratch) const {
    return detail::route<Route>([&](auto... rest) { return mapd_route(get(), places.data(), places.size(), cost, scratch.get(), rest...); });
  }

  /// Every node whose beginning can be reached within a cost, nearest first; the start's own node and those beside it come first of all.
  Result<std::vector<Reached>> try_reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch) const {
    return detail::list<Reached>([&](auto... rest) { return mapd_reachable(get(), from, limit, cost, scratch.get(), rest...); });
  }
  Error try_reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch, std::vector<Reached>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_reachable(get(), from, limit, cost, scratch.get(), rest...); });
  }

  /// Every node from whose beginning a place can be reached within a cost, nearest first: who can come here. The place's own node and those beside it come with
  /// what is to be driven on them.
  Result<std::vector<Reached>> try_reachable_to(PositionOnLane to, double limit, Cost cost, Scratch& scratch) const {
    return detail::list<Reached>([&](auto... rest) { return mapd_reachable_to(get(), to, limit, cost, scratch.get(), rest...); });
  }
  Error try_reachable_to(PositionOnLane to, double limit, Cost cost, Scratch& scratch, std::vector<Reached>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_reachable_to(get(), to, limit, cost, scratch.get(), rest...); });
  }

  /// All sequences of lanes that a vehicle can follow from a place without changing lanes (`ahead` not 0), or on which it can have come there, until each is
  /// `distance` [m] long or ends: what they have in common, as `mapd_reach` writes it, each piece of a lane once. `mapd_next_sequence` tells them one by one.
  /// The lane of the place may be any; every other one must be open to the vehicle.
  Result<Reach> try_lane_sequences(PositionOnLane from, double distance, std::uint8_t vehicle, bool ahead, Scratch& scratch) const {
    return detail::reach<Reach>([&](auto... rest) { return mapd_lane_sequences(get(), from, distance, vehicle, detail::to_byte(ahead), scratch.get(), rest...); });
  }

  /// The next junction ahead of a place within a distance [m], following the lanes as long as there is but one way on, or all ways lead into one junction. On a
  /// connecting road the distance is 0.
  Result<std::optional<NextJunction>> try_next_junction(PositionOnLane from, double distance, std::uint8_t vehicle) const {
    return detail::optional<NextJunction>([&](auto... rest) { return mapd_next_junction_of(get(), from, distance, vehicle, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<Route> route(span<const PositionOnLane> places, Cost cost, Scratch& scratch) const { return try_route(places, cost, scratch).value(); }
  std::vector<Reached> reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch) const { return try_reachable(from, limit, cost, scratch).value(); }
  void reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch, std::vector<Reached>& out) const { detail::must(try_reachable(from, limit, cost, scratch, out)); }
  std::vector<Reached> reachable_to(PositionOnLane to, double limit, Cost cost, Scratch& scratch) const { return try_reachable_to(to, limit, cost, scratch).value(); }
  void reachable_to(PositionOnLane to, double limit, Cost cost, Scratch& scratch, std::vector<Reached>& out) const { detail::must(try_reachable_to(to, limit, cost, scratch, out)); }
  Reach lane_sequences(PositionOnLane from, double distance, std::uint8_t vehicle, bool ahead, Scratch& scratch) const { return try_lane_sequences(from, distance, vehicle, ahead, scratch).value(); }
  std::optional<NextJunction> next_junction(PositionOnLane from, double distance, std::uint8_t vehicle) const { return try_next_junction(from, distance, vehicle).value(); }
#endif

  // What a path comes by, how fast it may be driven, and from which lanes its goal is reached.

  /// A country of a path's fact, as the file writes it: two or three letters, or a name in older versions.
  Result<std::optional<std::string_view>> try_country(std::uint32_t number) const {
    return detail::optional_text([&](auto... rest) { return mapd_country(get(), number, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<std::string_view> country(std::uint32_t number) const { return try_country(number).value(); }
#endif

  // Steps of routes and paths: made of lanes, cut out of a path, found again on the next version of a map; their changes of lane and length.

  /// The steps over lanes that follow each other, as `mapd_lane_sequences` lists them, from s [m] on the first to s on the last; each in its own driving
  /// direction, one for both directions in that which links ask for.
  Result<std::vector<RouteStep>> try_steps_of_lanes(span<const LaneId> lanes, double s_from, double s_to, Scratch& scratch) const {
    return detail::list<RouteStep>([&](auto... rest) { return mapd_steps_of_lanes(get(), lanes.data(), lanes.size(), s_from, s_to, scratch.get(), rest...); });
  }
  Error try_steps_of_lanes(span<const LaneId> lanes, double s_from, double s_to, Scratch& scratch, std::vector<RouteStep>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_steps_of_lanes(get(), lanes.data(), lanes.size(), s_from, s_to, scratch.get(), rest...); });
  }

  /// The next change of lane on a route, seen from a place on step number `at`.
  Result<std::optional<LaneChange>> try_next_lane_change(span<const RouteStep> steps, std::size_t at, PositionOnLane place, Scratch& scratch) const {
    return detail::optional<LaneChange>([&](auto... rest) { return mapd_next_lane_change(get(), steps.data(), steps.size(), at, place, scratch.get(), rest...); });
  }

  /// The length of a route's steps along centre lines [m].
  Result<double> try_steps_length(span<const RouteStep> steps) const {
    return detail::value<double>([&](auto... rest) { return mapd_steps_length(get(), steps.data(), steps.size(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<RouteStep> steps_of_lanes(span<const LaneId> lanes, double s_from, double s_to, Scratch& scratch) const { return try_steps_of_lanes(lanes, s_from, s_to, scratch).value(); }
  void steps_of_lanes(span<const LaneId> lanes, double s_from, double s_to, Scratch& scratch, std::vector<RouteStep>& out) const { detail::must(try_steps_of_lanes(lanes, s_from, s_to, scratch, out)); }
  std::optional<LaneChange> next_lane_change(span<const RouteStep> steps, std::size_t at, PositionOnLane place, Scratch& scratch) const { return try_next_lane_change(steps, at, place, scratch).value(); }
  double steps_length(span<const RouteStep> steps) const { return try_steps_length(steps).value(); }
#endif

  // Who meets a path: other lanes' traffic, where it comes from, and who crosses on foot.

  /// The lanes on which traffic comes to a conflict of a path, back to a distance [m] from its first place on the other lanes, each by the shortest way,
  /// nearest first. `lanes` are those of the conflict, from its `lanes_from` to its `lanes_to`; those come first that none of the others leads to. Changes of
  /// lane are not among the ways. `vehicle`, a `MAPD_VEHICLE_CLASS_…`, is the class of who comes, not of who drives the path: lanes that are closed to it
  /// bring none, the other lanes neither.
  Result<std::vector<ConflictApproach>> try_approaches(span<const ConflictLane> lanes, double distance, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<ConflictApproach>([&](auto... rest) { return mapd_conflict_approaches(get(), lanes.data(), lanes.size(), distance, vehicle, scratch.get(), rest...); });
  }
  Error try_approaches(span<const ConflictLane> lanes, double distance, std::uint8_t vehicle, Scratch& scratch, std::vector<ConflictApproach>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_conflict_approaches(get(), lanes.data(), lanes.size(), distance, vehicle, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<ConflictApproach> approaches(span<const ConflictLane> lanes, double distance, std::uint8_t vehicle, Scratch& scratch) const { return try_approaches(lanes, distance, vehicle, scratch).value(); }
  void approaches(span<const ConflictLane> lanes, double distance, std::uint8_t vehicle, Scratch& scratch, std::vector<ConflictApproach>& out) const { detail::must(try_approaches(lanes, distance, vehicle, scratch, out)); }
#endif

  // Routes by request: several starts and goals, lanes to avoid, costs of turns; alternatives; the network that can be reached.

  /// The cheapest way from any start of a request to any of its goals, in driving direction and by allowed lane changes only.
  Result<std::optional<Route>> try_find_route(const RouteRequest& request, Scratch& scratch) const {
    return detail::route<Route>([&](auto... rest) { return mapd_find_route(get(), &request, scratch.get(), rest...); });
  }

  /// The cheapest route of a request and alternatives to it, cheapest first. `sums` and `ends` have room for `capacity` routes each: what each comes to, and
  /// where its steps end in `out`.
  Result<std::vector<Route>> try_alternatives(const RouteRequest& request, Scratch& scratch, const AlternativeOptions& options = {}) const {
    return detail::routes<Route>([&](auto... rest) { return mapd_alternatives(get(), &request, &options, scratch.get(), rest...); });
  }

  /// What can be reached from a request's starts within a cost, nearest first, with the ways on; with `to` not 0 from where its goals can be reached, and the
  /// ways back. What lies beyond the limit is not among the links.
  Result<Reach> try_reach(const RouteRequest& request, double limit, bool to, Scratch& scratch) const {
    return detail::reach<Reach>([&](auto... rest) { return mapd_reach(get(), &request, limit, detail::to_byte(to), scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<Route> find_route(const RouteRequest& request, Scratch& scratch) const { return try_find_route(request, scratch).value(); }
  std::vector<Route> alternatives(const RouteRequest& request, Scratch& scratch, const AlternativeOptions& options = {}) const { return try_alternatives(request, scratch, options).value(); }
  Reach reach(const RouteRequest& request, double limit, bool to, Scratch& scratch) const { return try_reach(request, limit, to, scratch).value(); }
#endif

  // Junctions.

  /// What a junction is.
  Result<JunctionFacts> try_junction(JunctionId junction) const {
    return detail::value<JunctionFacts>([&](auto... rest) { return mapd_junction_facts_of(get(), junction, rest...); });
  }

  /// Connections of a junction in file order.
  Result<std::vector<Connection>> try_connections(JunctionId junction) const {
    return detail::list<Connection>([&](auto... rest) { return mapd_junction_connections(get(), junction, rest...); });
  }
  Error try_connections(JunctionId junction, std::vector<Connection>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_junction_connections(get(), junction, rest...); });
  }

#if MAPD_EXCEPTIONS
  JunctionFacts junction(JunctionId junction) const { return try_junction(junction).value(); }
  std::vector<Connection> connections(JunctionId junction) const { return try_connections(junction).value(); }
  void connections(JunctionId junction, std::vector<Connection>& out) const { detail::must(try_connections(junction, out)); }
#endif

  // Signals: what they are, where they stand, for which lanes they are.

  /// What a signal is.
  Result<SignalFacts> try_signal(SignalId signal) const {
    return detail::value<SignalFacts>([&](auto... rest) { return mapd_signal_facts_of(get(), signal, rest...); });
  }

  /// Signals that are for a lane, ascending in s; `which` is a `MAPD_LANE_SIGNALS_…`.
  Result<std::vector<LaneSignal>> try_lane_signals(LaneId lane, std::uint32_t which) const {
    return detail::list<LaneSignal>([&](auto... rest) { return mapd_lane_signals(get(), lane, which, rest...); });
  }
  Error try_lane_signals(LaneId lane, std::uint32_t which, std::vector<LaneSignal>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_signals(get(), lane, which, rest...); });
  }

  /// The speed limit at s: sign before lane before road type before the header's regulations.
  Result<SpeedRule> try_speed_rule_at(LaneId lane, double s) const {
    return detail::value<SpeedRule>([&](auto... rest) { return mapd_lane_speed_rule_at(get(), lane, s, rest...); });
  }

  /// The speed limits along the lane, in ascending s without gaps, each as `mapd_lane_speed_rule_at` has it between the ends of its stretch; where the limit
  /// depends on the way, with the lowest that may hold.
  Result<std::vector<SpeedStretch>> try_speed_rules(LaneId lane) const {
    return detail::list<SpeedStretch>([&](auto... rest) { return mapd_lane_speed_rules(get(), lane, rest...); });
  }
  Error try_speed_rules(LaneId lane, std::vector<SpeedStretch>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_speed_rules(get(), lane, rest...); });
  }

  /// Every signal that stands as near to a point as `radius` [m] in plan view, nearest first, whatever lanes it is for.
  Result<std::vector<NearSignal>> try_signals_near(Vec2 point, double radius, Scratch& scratch) const {
    return detail::list<NearSignal>([&](auto... rest) { return mapd_signals_near(get(), point, radius, scratch.get(), rest...); });
  }
  Error try_signals_near(Vec2 point, double radius, Scratch& scratch, std::vector<NearSignal>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_signals_near(get(), point, radius, scratch.get(), rest...); });
  }

  /// Every signal that stands in a rectangle in plan view, in the order of their rows.
  Result<std::vector<SignalId>> try_signals_in(Region region, Scratch& scratch) const {
    return detail::list<SignalId>([&](auto... rest) { return mapd_signals_in(get(), region, scratch.get(), rest...); });
  }
  Error try_signals_in(Region region, Scratch& scratch, std::vector<SignalId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_signals_in(get(), region, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  SignalFacts signal(SignalId signal) const { return try_signal(signal).value(); }
  std::vector<LaneSignal> lane_signals(LaneId lane, std::uint32_t which) const { return try_lane_signals(lane, which).value(); }
  void lane_signals(LaneId lane, std::uint32_t which, std::vector<LaneSignal>& out) const { detail::must(try_lane_signals(lane, which, out)); }
  SpeedRule speed_rule_at(LaneId lane, double s) const { return try_speed_rule_at(lane, s).value(); }
  std::vector<SpeedStretch> speed_rules(LaneId lane) const { return try_speed_rules(lane).value(); }
  void speed_rules(LaneId lane, std::vector<SpeedStretch>& out) const { detail::must(try_speed_rules(lane, out)); }
  std::vector<NearSignal> signals_near(Vec2 point, double radius, Scratch& scratch) const { return try_signals_near(point, radius, scratch).value(); }
  void signals_near(Vec2 point, double radius, Scratch& scratch, std::vector<NearSignal>& out) const { detail::must(try_signals_near(point, radius, scratch, out)); }
  std::vector<SignalId> signals_in(Region region, Scratch& scratch) const { return try_signals_in(region, scratch).value(); }
  void signals_in(Region region, Scratch& scratch, std::vector<SignalId>& out) const { detail::must(try_signals_in(region, scratch, out)); }
#endif

  // Signals and lines ahead, along all ways that lanes lead or along a route.

  /// Signals for traffic that goes on from a place without changing lanes, up to a distance [m] along any way, the nearest first. `vehicle` is a
  /// `MAPD_VEHICLE_CLASS_…`.
  Result<std::vector<SignalAhead>> try_signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<SignalAhead>([&](auto... rest) { return mapd_signals_ahead(get(), from, distance, vehicle, scratch.get(), rest...); });
  }
  Error try_signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch, std::vector<SignalAhead>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_signals_ahead(get(), from, distance, vehicle, scratch.get(), rest...); });
  }

  /// Signals along a route, with distances from its start.
  Result<std::vector<SignalAhead>> try_signals_along(span<const RouteStep> steps, Scratch& scratch) const {
    return detail::list<SignalAhead>([&](auto... rest) { return mapd_signals_along(get(), steps.data(), steps.size(), scratch.get(), rest...); });
  }
  Error try_signals_along(span<const RouteStep> steps, Scratch& scratch, std::vector<SignalAhead>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_signals_along(get(), steps.data(), steps.size(), scratch.get(), rest...); });
  }

  /// Stop lines, lines to give way at, crosswalks and bicycle crossings along a route, nearest first, whether the file writes them as signals or as objects;
  /// one over several lanes stands once for each that is driven on.
  Result<std::vector<LaneLine>> try_lines_along(span<const RouteStep> steps, Scratch& scratch) const {
    return detail::list<LaneLine>([&](auto... rest) { return mapd_lines_along(get(), steps.data(), steps.size(), scratch.get(), rest...); });
  }
  Error try_lines_along(span<const RouteStep> steps, Scratch& scratch, std::vector<LaneLine>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lines_along(get(), steps.data(), steps.size(), scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<SignalAhead> signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch) const { return try_signals_ahead(from, distance, vehicle, scratch).value(); }
  void signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch, std::vector<SignalAhead>& out) const { detail::must(try_signals_ahead(from, distance, vehicle, scratch, out)); }
  std::vector<SignalAhead> signals_along(span<const RouteStep> steps, Scratch& scratch) const { return try_signals_along(steps, scratch).value(); }
  void signals_along(span<const RouteStep> steps, Scratch& scratch, std::vector<SignalAhead>& out) const { detail::must(try_signals_along(steps, scratch, out)); }
  std::vector<LaneLine> lines_along(span<const RouteStep> steps, Scratch& scratch) const { return try_lines_along(steps, scratch).value(); }
  void lines_along(span<const RouteStep> steps, Scratch& scratch, std::vector<LaneLine>& out) const { detail::must(try_lines_along(steps, scratch, out)); }
#endif

  // Movements through junctions and who goes first.

  /// Where the movement through this lane of a junction leads: a `MAPD_TURN_…`.
  Result<std::uint8_t> try_turn(LaneId lane) const {
    return detail::value<std::uint8_t>([&](auto... rest) { return mapd_lane_turn(get(), lane, rest...); });
  }

  /// Lanes from which the junction is entered on the way through this one.
  Result<std::vector<LaneId>> try_entries(LaneId lane) const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_lane_entries(get(), lane, rest...); });
  }
  Error try_entries(LaneId lane, std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_entries(get(), lane, rest...); });
  }

  /// Lanes of the junction that the movement through this one goes over, first to last; itself where it is in no junction.
  Result<std::vector<LaneId>> try_movement_lanes(LaneId lane) const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_lane_movement_lanes(get(), lane, rest...); });
  }
  Error try_movement_lanes(LaneId lane, std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_movement_lanes(get(), lane, rest...); });
  }

  /// Lights that govern the movement through this lane of a junction.
  Result<std::vector<LaneSignal>> try_movement_lights(LaneId lane) const {
    return detail::list<LaneSignal>([&](auto... rest) { return mapd_lane_movement_lights(get(), lane, rest...); });
  }
  Error try_movement_lights(LaneId lane, std::vector<LaneSignal>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_movement_lights(get(), lane, rest...); });
  }

  /// Where the movement through this lane of a junction stops: at the marked line nearest to the junction, up to 30 m before it or on the movement's first
  /// lane; without one at its light.
  Result<std::optional<LaneLine>> try_movement_stop(LaneId lane) const {
    return detail::optional<LaneLine>([&](auto... rest) { return mapd_lane_movement_stop(get(), lane, rest...); });
  }

  /// Lines on a lane, or that its movement passes; `which` is a `MAPD_LANE_LINES_…`.
  Result<std::vector<LaneLine>> try_lane_lines(LaneId lane, std::uint32_t which) const {
    return detail::list<LaneLine>([&](auto... rest) { return mapd_lane_lines(get(), lane, which, rest...); });
  }
  Error try_lane_lines(LaneId lane, std::uint32_t which, std::vector<LaneLine>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_lines(get(), lane, which, rest...); });
  }

  /// Who goes first where this lane of a junction meets others, by what the file says: unknown where a rule of the road would have to say.
  Result<std::vector<RightOfWay>> try_right_of_way(LaneId lane) const {
    return detail::list<RightOfWay>([&](auto... rest) { return mapd_lane_right_of_way(get(), lane, rest...); });
  }
  Error try_right_of_way(LaneId lane, std::vector<RightOfWay>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_right_of_way(get(), lane, rest...); });
  }

  /// As `mapd_lane_right_of_way` by what the file says, else by the rules of a country, by its two letters of ISO 3166-1 such as `DE`: that they hold there is
  /// for the caller to know. Where neither says, the relation is unknown.
  Result<std::optional<std::vector<RightOfWay>>> try_right_of_way_by(LaneId lane, const std::string& country) const {
    return detail::optional_list<RightOfWay>([&](auto... rest) { return mapd_lane_right_of_way_by(get(), lane, country.c_str(), rest...); });
  }

  /// First lanes of the movements through junctions that a light governs; none of what is no light. Looks at all places of signals of the map.
  Result<std::vector<LaneId>> try_signal_movements(SignalId signal) const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_signal_movements(get(), signal, rest...); });
  }
  Error try_signal_movements(SignalId signal, std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_signal_movements(get(), signal, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::uint8_t turn(LaneId lane) const { return try_turn(lane).value(); }
  std::vector<LaneId> entries(LaneId lane) const { return try_entries(lane).value(); }
  void entries(LaneId lane, std::vector<LaneId>& out) const { detail::must(try_entries(lane, out)); }
  std::vector<LaneId> movement_lanes(LaneId lane) const { return try_movement_lanes(lane).value(); }
  void movement_lanes(LaneId lane, std::vector<LaneId>& out) const { detail::must(try_movement_lanes(lane, out)); }
  std::vector<LaneSignal> movement_lights(LaneId lane) const { return try_movement_lights(lane).value(); }
  void movement_lights(LaneId lane, std::vector<LaneSignal>& out) const { detail::must(try_movement_lights(lane, out)); }
  std::optional<LaneLine> movement_stop(LaneId lane) const { return try_movement_stop(lane).value(); }
  std::vector<LaneLine> lane_lines(LaneId lane, std::uint32_t which) const { return try_lane_lines(lane, which).value(); }
  void lane_lines(LaneId lane, std::uint32_t which, std::vector<LaneLine>& out) const { detail::must(try_lane_lines(lane, which, out)); }
  std::vector<RightOfWay> right_of_way(LaneId lane) const { return try_right_of_way(lane).value(); }
  void right_of_way(LaneId lane, std::vector<RightOfWay>& out) const { detail::must(try_right_of_way(lane, out)); }
  std::optional<std::vector<RightOfWay>> right_of_way_by(LaneId lane, const std::string& country) const { return try_right_of_way_by(lane, country).value(); }
  std::vector<LaneId> signal_movements(SignalId signal) const { return try_signal_movements(signal).value(); }
  void signal_movements(SignalId signal, std::vector<LaneId>& out) const { detail::must(try_signal_movements(signal, out)); }
#endif

  // Objects: what they are and where they stand.

  /// What an object is.
  Result<ObjectFacts> try_object(ObjectId object) const {
    return detail::value<ObjectFacts>([&](auto... rest) { return mapd_object_facts_of(get(), object, rest...); });
  }

  /// Every place where an object stands: its own, or those of its copies.
  Result<std::vector<PlacementFacts>> try_placements(ObjectId object) const {
    return detail::list<PlacementFacts>([&](auto... rest) { return mapd_object_placements(get(), object, rest...); });
  }
  Error try_placements(ObjectId object, std::vector<PlacementFacts>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_object_placements(get(), object, rest...); });
  }

  /// An object where it stands.
  Result<PlacementFacts> try_placement(PlacementId place) const {
    return detail::value<PlacementFacts>([&](auto... rest) { return mapd_placement_facts_of(get(), place, rest...); });
  }

  /// Corners of the area that an object covers, at its foot, inertial [m].
  Result<std::vector<Vec3>> try_footprint(PlacementId place, Scratch& scratch) const {
    return detail::list<Vec3>([&](auto... rest) { return mapd_placement_footprint(get(), place, scratch.get(), rest...); });
  }
  Error try_footprint(PlacementId place, Scratch& scratch, std::vector<Vec3>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_placement_footprint(get(), place, scratch.get(), rest...); });
  }

  /// Lanes that an object belongs to, nearer ones first.
  Result<std::vector<ObjectLane>> try_object_lanes(ObjectId object) const {
    return detail::list<ObjectLane>([&](auto... rest) { return mapd_object_lanes(get(), object, rest...); });
  }
  Error try_object_lanes(ObjectId object, std::vector<ObjectLane>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_object_lanes(get(), object, rest...); });
  }

  /// Objects that belong to a lane, in ascending s: crosswalks, stop lines, parking spaces, what stands beside it.
  Result<std::vector<ObjectLane>> try_lane_objects(LaneId lane) const {
    return detail::list<ObjectLane>([&](auto... rest) { return mapd_lane_objects(get(), lane, rest...); });
  }
  Error try_lane_objects(LaneId lane, std::vector<ObjectLane>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_objects(get(), lane, rest...); });
  }

  /// Every place of an object whose area comes as near to a point as `radius` [m] in plan view, nearest first.
  Result<std::vector<NearObject>> try_objects_near(Vec2 point, double radius, Scratch& scratch) const {
    return detail::list<NearObject>([&](auto... rest) { return mapd_objects_near(get(), point, radius, scratch.get(), rest...); });
  }
  Error try_objects_near(Vec2 point, double radius, Scratch& scratch, std::vector<NearObject>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_objects_near(get(), point, radius, scratch.get(), rest...); });
  }

  /// Every place of an object whose area meets a rectangle in plan view, in the order of their rows.
  Result<std::vector<PlacementId>> try_objects_in(Region region, Scratch& scratch) const {
    return detail::list<PlacementId>([&](auto... rest) { return mapd_objects_in(get(), region, scratch.get(), rest...); });
  }
  Error try_objects_in(Region region, Scratch& scratch, std::vector<PlacementId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_objects_in(get(), region, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  ObjectFacts object(ObjectId object) const { return try_object(object).value(); }
  std::vector<PlacementFacts> placements(ObjectId object) const { return try_placements(object).value(); }
  void placements(ObjectId object, std::vector<PlacementFacts>& out) const { detail::must(try_placements(object, out)); }
  PlacementFacts placement(PlacementId place) const { return try_placement(place).value(); }
  std::vector<Vec3> footprint(PlacementId place, Scratch& scratch) const { return try_footprint(place, scratch).value(); }
  void footprint(PlacementId place, Scratch& scratch, std::vector<Vec3>& out) const { detail::must(try_footprint(place, scratch, out)); }
  std::vector<ObjectLane> object_lanes(ObjectId object) const { return try_object_lanes(object).value(); }
  void object_lanes(ObjectId object, std::vector<ObjectLane>& out) const { detail::must(try_object_lanes(object, out)); }
  std::vector<ObjectLane> lane_objects(LaneId lane) const { return try_lane_objects(lane).value(); }
  void lane_objects(LaneId lane, std::vector<ObjectLane>& out) const { detail::must(try_lane_objects(lane, out)); }
  std::vector<NearObject> objects_near(Vec2 point, double radius, Scratch& scratch) const { return try_objects_near(point, radius, scratch).value(); }
  void objects_near(Vec2 point, double radius, Scratch& scratch, std::vector<NearObject>& out) const { detail::must(try_objects_near(point, radius, scratch, out)); }
  std::vector<PlacementId> objects_in(Region region, Scratch& scratch) const { return try_objects_in(region, scratch).value(); }
  void objects_in(Region region, Scratch& scratch, std::vector<PlacementId>& out) const { detail::must(try_objects_in(region, scratch, out)); }
#endif

  // Landmarks for localisation.

  /// Signals and places of objects of these classes as near to a point as `radius` [m] in plan view, nearest first; objects that move are left out.
  Result<std::vector<Landmark>> try_landmarks_near(Vec2 point, double radius, const ClassSet* classes, Scratch& scratch) const {
    return detail::list<Landmark>([&](auto... rest) { return mapd_landmarks_near(get(), point, radius, classes, scratch.get(), rest...); });
  }
  Error try_landmarks_near(Vec2 point, double radius, const ClassSet* classes, Scratch& scratch, std::vector<Landmark>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_landmarks_near(get(), point, radius, classes, scratch.get(), rest...); });
  }

  /// As `mapd_landmarks_near`, in a rectangle: signals by row, then places of objects whose area meets it.
  Result<std::vector<Landmark>> try_landmarks_in(Region region, const ClassSet* classes, Scratch& scratch) const {
    return detail::list<Landmark>([&](auto... rest) { return mapd_landmarks_in(get(), region, classes, scratch.get(), rest...); });
  }
  Error try_landmarks_in(Region region, const ClassSet* classes, Scratch& scratch, std::vector<Landmark>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_landmarks_in(get(), region, classes, scratch.get(), rest...); });
  }

  /// What a sensor sees of the signals and places of objects of these classes, nearest first; objects that move are left out. Signals are seen from the front
  /// only, objects from all sides. What stands in between hides nothing.
  Result<std::vector<LandmarkInView>> try_landmarks_in_view(Sensor sensor, const ClassSet* classes, Scratch& scratch) const {
    return detail::list<LandmarkInView>([&](auto... rest) { return mapd_landmarks_in_view(get(), sensor, classes, scratch.get(), rest...); });
  }
  Error try_landmarks_in_view(Sensor sensor, const ClassSet* classes, Scratch& scratch, std::vector<LandmarkInView>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_landmarks_in_view(get(), sensor, classes, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<Landmark> landmarks_near(Vec2 point, double radius, const ClassSet* classes, Scratch& scratch) const { return try_landmarks_near(point, radius, classes, scratch).value(); }
  void landmarks_near(Vec2 point, double radius, const ClassSet* classes, Scratch& scratch, std::vector<Landmark>& out) const { detail::must(try_landmarks_near(point, radius, classes, scratch, out)); }
  std::vector<Landmark> landmarks_in(Region region, const ClassSet* classes, Scratch& scratch) const { return try_landmarks_in(region, classes, scratch).value(); }
  void landmarks_in(Region region, const ClassSet* classes, Scratch& scratch, std::vector<Landmark>& out) const { detail::must(try_landmarks_in(region, classes, scratch, out)); }
  std::vector<LandmarkInView> landmarks_in_view(Sensor sensor, const ClassSet* classes, Scratch& scratch) const { return try_landmarks_in_view(sensor, classes, scratch).value(); }
  void landmarks_in_view(Sensor sensor, const ClassSet* classes, Scratch& scratch, std::vector<LandmarkInView>& out) const { detail::must(try_landmarks_in_view(sensor, classes, scratch, out)); }
#endif

  // Road marks and borders.

  /// A lane's road marks in ascending s, those that hold somewhere in its section. The kind `none` is among them.
  Result<std::vector<RoadMark>> try_road_marks(LaneId lane) const {
    return detail::list<RoadMark>([&](auto... rest) { return mapd_lane_road_marks(get(), lane, rest...); });
  }
  Error try_road_marks(LaneId lane, std::vector<RoadMark>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_lane_road_marks(get(), lane, rest...); });
  }

  /// The road mark that holds at s; at a boundary the later one.
  Result<std::optional<RoadMark>> try_road_mark_at(LaneId lane, double s) const {
    return detail::optional<RoadMark>([&](auto... rest) { return mapd_lane_road_mark_at(get(), lane, s, rest...); });
  }

  /// Every piece of the borders of lanes of these types that meets a rectangle in plan view, each once, in the order of their lanes and of s.
  Result<std::vector<BoundarySegment>> try_boundary_segments(Region region, std::uint64_t types, Scratch& scratch) const {
    return detail::list<BoundarySegment>([&](auto... rest) { return mapd_boundary_segments(get(), region, types, scratch.get(), rest...); });
  }
  Error try_boundary_segments(Region region, std::uint64_t types, Scratch& scratch, std::vector<BoundarySegment>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_boundary_segments(get(), region, types, scratch.get(), rest...); });
  }

  /// Every piece of the road marks of lanes of these types that meets a rectangle in plan view, along the borders, without sway.
  Result<std::vector<RoadMarkSegment>> try_road_mark_segments(Region region, std::uint64_t types, Scratch& scratch) const {
    return detail::list<RoadMarkSegment>([&](auto... rest) { return mapd_road_mark_segments(get(), region, types, scratch.get(), rest...); });
  }
  Error try_road_mark_segments(Region region, std::uint64_t types, Scratch& scratch, std::vector<RoadMarkSegment>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_road_mark_segments(get(), region, types, scratch.get(), rest...); });
  }

  /// Points along all paint and kerbs in a rectangle, at every multiple of `spacing` [m] of their road's s, of lines along objects from their beginning; 1 cm
  /// at least: the same ones whatever rectangle they are asked for by. Gaps of broken lines have none; where the file does not say which places are gaps, all
  /// have. In no particular order.
  Result<std::vector<MarkPoint>> try_mark_points(Region region, double spacing, Scratch& scratch, const MarkFilter& filter = {}) const {
    return detail::list<MarkPoint>([&](auto... rest) { return mapd_mark_points(get(), region, spacing, &filter, scratch.get(), rest...); });
  }
  Error try_mark_points(Region region, double spacing, Scratch& scratch, std::vector<MarkPoint>& out, const MarkFilter& filter = {}) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_mark_points(get(), region, spacing, &filter, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<RoadMark> road_marks(LaneId lane) const { return try_road_marks(lane).value(); }
  void road_marks(LaneId lane, std::vector<RoadMark>& out) const { detail::must(try_road_marks(lane, out)); }
  std::optional<RoadMark> road_mark_at(LaneId lane, double s) const { return try_road_mark_at(lane, s).value(); }
  std::vector<BoundarySegment> boundary_segments(Region region, std::uint64_t types, Scratch& scratch) const { return try_boundary_segments(region, types, scratch).value(); }
  void boundary_segments(Region region, std::uint64_t types, Scratch& scratch, std::vector<BoundarySegment>& out) const { detail::must(try_boundary_segments(region, types, scratch, out)); }
  std::vector<RoadMarkSegment> road_mark_segments(Region region, std::uint64_t types, Scratch& scratch) const { return try_road_mark_segments(region, types, scratch).value(); }
  void road_mark_segments(Region region, std::uint64_t types, Scratch& scratch, std::vector<RoadMarkSegment>& out) const { detail::must(try_road_mark_segments(region, types, scratch, out)); }
  std::vector<MarkPoint> mark_points(Region region, double spacing, Scratch& scratch, const MarkFilter& filter = {}) const { return try_mark_points(region, spacing, scratch, filter).value(); }
  void mark_points(Region region, double spacing, Scratch& scratch, std::vector<MarkPoint>& out, const MarkFilter& filter = {}) const { detail::must(try_mark_points(region, spacing, scratch, out, filter)); }
#endif

  // The road's surface.

  /// The surface at (s, t), with lateral shape, crossfall or cross-section surface, lane heights, and in a junction its elevation grid. s beyond the reference
  /// line is moved to its end and flagged.
  Result<Surface> try_surface_at(RoadId road, double s, double t) const {
    return detail::value<Surface>([&](auto... rest) { return mapd_road_surface_at(get(), road, s, t, rest...); });
  }

  /// What a lane lies above the road's surface at s.
  Result<LaneHeight> try_height_at(LaneId lane, double s) const {
    return detail::value<LaneHeight>([&](auto... rest) { return mapd_lane_height_at(get(), lane, s, rest...); });
  }

  /// What a lane is made of at s.
  Result<std::optional<Material>> try_material_at(LaneId lane, double s) const {
    return detail::optional<Material>([&](auto... rest) { return mapd_lane_material_at(get(), lane, s, rest...); });
  }

  /// Height of a junction's elevation grid at a point in plan view, its edge held beyond it.
  Result<std::optional<GridHeight>> try_grid_height_at(JunctionId junction, Vec2 point) const {
    return detail::optional<GridHeight>([&](auto... rest) { return mapd_junction_grid_height_at(get(), junction, point, rest...); });
  }

#if MAPD_EXCEPTIONS
  Surface surface_at(RoadId road, double s, double t) const { return try_surface_at(road, s, t).value(); }
  LaneHeight height_at(LaneId lane, double s) const { return try_height_at(lane, s).value(); }
  std::optional<Material> material_at(LaneId lane, double s) const { return try_material_at(lane, s).value(); }
  std::optional<GridHeight> grid_height_at(JunctionId junction, Vec2 point) const { return try_grid_height_at(junction, point).value(); }
#endif

  // What a map has beside its lanes: bridges and tunnels, references to objects, holes.

  /// All bridges and tunnels, by road.
  Result<std::vector<Structure>> try_structures() const {
    return detail::list<Structure>([&](auto... rest) { return mapd_structures(get(), rest...); });
  }
  Error try_structures(std::vector<Structure>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_structures(get(), rest...); });
  }

  /// All references to objects of other roads, by referring road.
  Result<std::vector<ObjectReference>> try_object_references() const {
    return detail::list<ObjectReference>([&](auto... rest) { return mapd_object_references(get(), rest...); });
  }
  Error try_object_references(std::vector<ObjectReference>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_object_references(get(), rest...); });
  }

  /// Parts of the document that are not in the map as written, in the order of the document. None of a map that was accepted whole.
  Result<std::vector<Quarantined>> try_quarantined_parts() const {
    return detail::list<Quarantined>([&](auto... rest) { return mapd_quarantined_parts(get(), rest...); });
  }
  Error try_quarantined_parts(std::vector<Quarantined>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_quarantined_parts(get(), rest...); });
  }

  /// Those whose extent comes as near to a point as `radius` [m] in plan view: an answer about that place may lack them.
  Result<std::vector<Quarantined>> try_quarantined_near(Vec2 point, double radius) const {
    return detail::list<Quarantined>([&](auto... rest) { return mapd_quarantined_near(get(), point, radius, rest...); });
  }
  Error try_quarantined_near(Vec2 point, double radius, std::vector<Quarantined>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_quarantined_near(get(), point, radius, rest...); });
  }

  /// Why the map has no part of this kind and id, or has a road without its lanes; `kind` is a `MAPD_QUARANTINED_KIND_…`.
  Result<std::optional<Quarantined>> try_left_out(std::uint8_t kind, const std::string& id) const {
    return detail::optional<Quarantined>([&](auto... rest) { return mapd_left_out(get(), kind, id.c_str(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<Structure> structures() const { return try_structures().value(); }
  void structures(std::vector<Structure>& out) const { detail::must(try_structures(out)); }
  std::vector<ObjectReference> object_references() const { return try_object_references().value(); }
  void object_references(std::vector<ObjectReference>& out) const { detail::must(try_object_references(out)); }
  std::vector<Quarantined> quarantined_parts() const { return try_quarantined_parts().value(); }
  void quarantined_parts(std::vector<Quarantined>& out) const { detail::must(try_quarantined_parts(out)); }
  std::vector<Quarantined> quarantined_near(Vec2 point, double radius) const { return try_quarantined_near(point, radius).value(); }
  void quarantined_near(Vec2 point, double radius, std::vector<Quarantined>& out) const { detail::must(try_quarantined_near(point, radius, out)); }
  std::optional<Quarantined> left_out(std::uint8_t kind, const std::string& id) const { return try_left_out(kind, id).value(); }
#endif

  // What belongs together: junctions of a roundabout, signals of a controller, what a signal names.

  /// All groups of junctions in file order: group k has the number k.
  Result<std::vector<JunctionGroup>> try_junction_groups() const {
    return detail::list<JunctionGroup>([&](auto... rest) { return mapd_junction_groups(get(), rest...); });
  }
  Error try_junction_groups(std::vector<JunctionGroup>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_junction_groups(get(), rest...); });
  }

  /// Junctions of a group in file order, by its number; those that the map does not have are left out.
  Result<std::vector<JunctionId>> try_junction_group_members(std::uint32_t number) const {
    return detail::list<JunctionId>([&](auto... rest) { return mapd_junction_group_members(get(), number, rest...); });
  }
  Error try_junction_group_members(std::uint32_t number, std::vector<JunctionId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_junction_group_members(get(), number, rest...); });
  }

  /// Lanes of a roundabout's ring, by its group's number; none of other groups.
  Result<std::vector<LaneId>> try_junction_group_ring(std::uint32_t number) const {
    return detail::list<LaneId>([&](auto... rest) { return mapd_junction_group_ring(get(), number, rest...); });
  }
  Error try_junction_group_ring(std::uint32_t number, std::vector<LaneId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_junction_group_ring(get(), number, rest...); });
  }

  /// All controllers in file order: controller k has the number k.
  Result<std::vector<Controller>> try_controllers() const {
    return detail::list<Controller>([&](auto... rest) { return mapd_controllers(get(), rest...); });
  }
  Error try_controllers(std::vector<Controller>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_controllers(get(), rest...); });
  }

  /// Signals of a controller that the map has, in file order, by its number.
  Result<std::vector<SignalId>> try_controller_signals(std::uint32_t number) const {
    return detail::list<SignalId>([&](auto... rest) { return mapd_controller_signals(get(), number, rest...); });
  }
  Error try_controller_signals(std::uint32_t number, std::vector<SignalId>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_controller_signals(get(), number, rest...); });
  }

  /// Numbers of the controllers that switch a signal.
  Result<std::vector<std::uint32_t>> try_signal_controllers(SignalId signal) const {
    return detail::list<std::uint32_t>([&](auto... rest) { return mapd_signal_controllers(get(), signal, rest...); });
  }
  Error try_signal_controllers(SignalId signal, std::vector<std::uint32_t>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_signal_controllers(get(), signal, rest...); });
  }

  /// Numbers of the controllers of a junction's synchronisation group, in file order; those that the map does not have are left out.
  Result<std::vector<std::uint32_t>> try_junction_controllers(JunctionId junction) const {
    return detail::list<std::uint32_t>([&](auto... rest) { return mapd_junction_controllers(get(), junction, rest...); });
  }
  Error try_junction_controllers(JunctionId junction, std::vector<std::uint32_t>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_junction_controllers(get(), junction, rest...); });
  }

  /// What a signal names; `which` is a `MAPD_SIGNAL_LINKS_…`.
  Result<std::vector<SignalLink>> try_signal_links(SignalId signal, std::uint32_t which) const {
    return detail::list<SignalLink>([&](auto... rest) { return mapd_signal_links(get(), signal, which, rest...); });
  }
  Error try_signal_links(SignalId signal, std::uint32_t which, std::vector<SignalLink>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_signal_links(get(), signal, which, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<JunctionGroup> junction_groups() const { return try_junction_groups().value(); }
  void junction_groups(std::vector<JunctionGroup>& out) const { detail::must(try_junction_groups(out)); }
  std::vector<JunctionId> junction_group_members(std::uint32_t number) const { return try_junction_group_members(number).value(); }
  void junction_group_members(std::uint32_t number, std::vector<JunctionId>& out) const { detail::must(try_junction_group_members(number, out)); }
  std::vector<LaneId> junction_group_ring(std::uint32_t number) const { return try_junction_group_ring(number).value(); }
  void junction_group_ring(std::uint32_t number, std::vector<LaneId>& out) const { detail::must(try_junction_group_ring(number, out)); }
  std::vector<Controller> controllers() const { return try_controllers().value(); }
  void controllers(std::vector<Controller>& out) const { detail::must(try_controllers(out)); }
  std::vector<SignalId> controller_signals(std::uint32_t number) const { return try_controller_signals(number).value(); }
  void controller_signals(std::uint32_t number, std::vector<SignalId>& out) const { detail::must(try_controller_signals(number, out)); }
  std::vector<std::uint32_t> signal_controllers(SignalId signal) const { return try_signal_controllers(signal).value(); }
  void signal_controllers(SignalId signal, std::vector<std::uint32_t>& out) const { detail::must(try_signal_controllers(signal, out)); }
  std::vector<std::uint32_t> junction_controllers(JunctionId junction) const { return try_junction_controllers(junction).value(); }
  void junction_controllers(JunctionId junction, std::vector<std::uint32_t>& out) const { detail::must(try_junction_controllers(junction, out)); }
  std::vector<SignalLink> signal_links(SignalId signal, std::uint32_t which) const { return try_signal_links(signal, which).value(); }
  void signal_links(SignalId signal, std::uint32_t which, std::vector<SignalLink>& out) const { detail::must(try_signal_links(signal, which, out)); }
#endif

  // Places on Earth.

  /// As `mapd_nearest_lane`, from a place on Earth through a projector of this map. The altitude counts where `has_altitude` is not 0.
  Result<std::optional<Nearest>> try_nearest_lane_geodetic(const Projector& projector, Geodetic place, bool has_altitude, const NearestOptions& options = {}) const {
    const mapd_nearest_options own = options.c();
    return detail::optional<Nearest>([&](auto... rest) { return mapd_nearest_lane_geodetic(get(), projector.get(), place, detail::to_byte(has_altitude), &own, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<Nearest> nearest_lane_geodetic(const Projector& projector, Geodetic place, bool has_altitude, const NearestOptions& options = {}) const { return try_nearest_lane_geodetic(projector, place, has_altitude, options).value(); }
#endif
};

/// What a view is asked: see `View`.
class ViewQueries : public detail::Owner<mapd_view, mapd_view_close> {
 public:
  using Owner::Owner;

  // A map under what is laid over it, at a moment: closures, temporary limits, warnings.

  /// Everything that the overlay says, whether it holds now or not, in the order in which it was given: entry k has the number k.
  Result<std::vector<OverlayEntry>> try_entries() const {
    return detail::list<OverlayEntry>([&](auto... rest) { return mapd_view_entries(get(), rest...); });
  }
  Error try_entries(std::vector<OverlayEntry>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_entries(get(), rest...); });
  }

  /// What holds now, wherever it does: each entry once for each piece of a lane, for each way in which that is travelled.
  Result<std::vector<Restriction>> try_restrictions() const {
    return detail::list<Restriction>([&](auto... rest) { return mapd_view_restrictions(get(), rest...); });
  }
  Error try_restrictions(std::vector<Restriction>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_restrictions(get(), rest...); });
  }

  /// Entries that hold now at s of a lane, in its direction of travel, for any class of vehicles, in the order of the overlay.
  Result<std::vector<Restriction>> try_restrictions_at(PositionOnLane place) const {
    return detail::list<Restriction>([&](auto... rest) { return mapd_view_restrictions_at(get(), place.lane, place.s, rest...); });
  }
  Error try_restrictions_at(PositionOnLane place, std::vector<Restriction>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_restrictions_at(get(), place.lane, place.s, rest...); });
  }

  /// What holds now along a route or any list of steps, in its order: each entry once for each stretch on which it holds that a step drives over. `vehicle` is
  /// a `MAPD_VEHICLE_CLASS_…`.
  Result<std::vector<Restriction>> try_restrictions_along(span<const RouteStep> steps, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<Restriction>([&](auto... rest) { return mapd_view_restrictions_along(get(), steps.data(), steps.size(), vehicle, scratch.get(), rest...); });
  }
  Error try_restrictions_along(span<const RouteStep> steps, std::uint8_t vehicle, Scratch& scratch, std::vector<Restriction>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_restrictions_along(get(), steps.data(), steps.size(), vehicle, scratch.get(), rest...); });
  }

  /// Whether a class of vehicles may use a lane at s, in its own direction: as `mapd_lane_allows_at`, unless an entry closes or opens it. What one entry closes
  /// no other opens.
  Result<Permission> try_allows(PositionOnLane place, std::uint8_t vehicle) const {
    return detail::value<Permission>([&](auto... rest) { return mapd_view_allows(get(), place.lane, place.s, vehicle, rest...); });
  }

  /// The speed limit at s of a lane for a class of vehicles: the lowest that an entry states, else as `mapd_lane_speed_rule_at`.
  Result<SpeedToday> try_speed_rule_at(PositionOnLane place, std::uint8_t vehicle) const {
    return detail::value<SpeedToday>([&](auto... rest) { return mapd_view_speed_rule_at(get(), place.lane, place.s, vehicle, rest...); });
  }

  /// Whether a class of vehicles may overtake at s of a lane: what signs forbid, as `mapd_lane_overtaking_rule_at`, and entries.
  Result<OvertakingToday> try_overtaking_rule_at(PositionOnLane place, std::uint8_t vehicle) const {
    return detail::value<OvertakingToday>([&](auto... rest) { return mapd_view_overtaking_rule_at(get(), place.lane, place.s, vehicle, rest...); });
  }

  /// The number of the entry by which a signal is out of service now.
  Result<std::optional<std::uint32_t>> try_signal_out_of_service(SignalId signal) const {
    return detail::optional<std::uint32_t>([&](auto... rest) { return mapd_view_signal_out_of_service(get(), signal, rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<OverlayEntry> entries() const { return try_entries().value(); }
  void entries(std::vector<OverlayEntry>& out) const { detail::must(try_entries(out)); }
  std::vector<Restriction> restrictions() const { return try_restrictions().value(); }
  void restrictions(std::vector<Restriction>& out) const { detail::must(try_restrictions(out)); }
  std::vector<Restriction> restrictions_at(PositionOnLane place) const { return try_restrictions_at(place).value(); }
  void restrictions_at(PositionOnLane place, std::vector<Restriction>& out) const { detail::must(try_restrictions_at(place, out)); }
  std::vector<Restriction> restrictions_along(span<const RouteStep> steps, std::uint8_t vehicle, Scratch& scratch) const { return try_restrictions_along(steps, vehicle, scratch).value(); }
  void restrictions_along(span<const RouteStep> steps, std::uint8_t vehicle, Scratch& scratch, std::vector<Restriction>& out) const { detail::must(try_restrictions_along(steps, vehicle, scratch, out)); }
  Permission allows(PositionOnLane place, std::uint8_t vehicle) const { return try_allows(place, vehicle).value(); }
  SpeedToday speed_rule_at(PositionOnLane place, std::uint8_t vehicle) const { return try_speed_rule_at(place, vehicle).value(); }
  OvertakingToday overtaking_rule_at(PositionOnLane place, std::uint8_t vehicle) const { return try_overtaking_rule_at(place, vehicle).value(); }
  std::optional<std::uint32_t> signal_out_of_service(SignalId signal) const { return try_signal_out_of_service(signal).value(); }
#endif

  // What is laid over a map along a path: entries, today's limits and times, from which lanes the goal is reached.

  /// What holds now for a class of vehicles along a path, in ascending S: each entry once for each stretch of a driven lane. The path itself is the map's: a
  /// lane that is closed stays where it is.
  Result<std::vector<PathRestriction>> try_restrictions_on_path(const PathQueries& path, std::uint8_t vehicle) const {
    return detail::list<PathRestriction>([&](auto... rest) { return mapd_view_restrictions_on_path(get(), path.get(), vehicle, rest...); });
  }
  Error try_restrictions_on_path(const PathQueries& path, std::uint8_t vehicle, std::vector<PathRestriction>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_restrictions_on_path(get(), path.get(), vehicle, rest...); });
  }

  /// The speed limit at S of a path, `along` [m], for a class of vehicles: the lowest that an entry states, else as `mapd_path_speed_at`.
  Result<SpeedToday> try_speed_on_path(const PathQueries& path, double along, std::uint8_t vehicle) const {
    return detail::value<SpeedToday>([&](auto... rest) { return mapd_view_speed_on_path(get(), path.get(), along, vehicle, rest...); });
  }

  /// The speed limits along a path for a class of vehicles, in ascending S without gaps, each place as `mapd_view_speed_on_path` has it. `vehicle` is a
  /// `MAPD_VEHICLE_CLASS_…`.
  Result<std::vector<PathSpeedToday>> try_speeds_on_path(const PathQueries& path, std::uint8_t vehicle) const {
    return detail::list<PathSpeedToday>([&](auto... rest) { return mapd_view_speeds_on_path(get(), path.get(), vehicle, rest...); });
  }
  Error try_speeds_on_path(const PathQueries& path, std::uint8_t vehicle, std::vector<PathSpeedToday>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_speeds_on_path(get(), path.get(), vehicle, rest...); });
  }

  /// As `mapd_path_travel_time` for a class of vehicles, at the limits of `mapd_view_speeds_on_path`. What is closed takes as long as if it were open:
  /// `mapd_view_restrictions_on_path` tells of it.
  Result<PathTime> try_travel_time_on_path(const PathQueries& path, double from, double to, std::uint8_t vehicle) const {
    return detail::value<PathTime>([&](auto... rest) { return mapd_view_travel_time_on_path(get(), path.get(), from, to, vehicle, rest...); });
  }

  /// As `mapd_path_segments`, with the overlay's current entries applied: a lane that is closed is not entered, so that before it a change of lane is due; one
  /// that is opened may be.
  Result<std::vector<PathSegment>> try_segments_on_path(const PathQueries& path, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<PathSegment>([&](auto... rest) { return mapd_view_segments_on_path(get(), path.get(), vehicle, scratch.get(), rest...); });
  }
  Error try_segments_on_path(const PathQueries& path, std::uint8_t vehicle, Scratch& scratch, std::vector<PathSegment>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_segments_on_path(get(), path.get(), vehicle, scratch.get(), rest...); });
  }

  /// As `mapd_path_conflicts`, with lights that are out of service now left out: where they would decide, signs do, then priorities of the file, then rules of
  /// the road.
  Result<PathConflicts> try_conflicts(const PathQueries& path, Scratch& scratch) const {
    return detail::conflicts<PathConflicts>([&](auto... rest) { return mapd_view_conflicts(get(), path.get(), scratch.get(), rest...); });
  }

  /// As `mapd_path_crossings`, with lights that are out of service now left out.
  Result<std::vector<PathCrossing>> try_crossings(const PathQueries& path, Scratch& scratch) const {
    return detail::list<PathCrossing>([&](auto... rest) { return mapd_view_crossings(get(), path.get(), scratch.get(), rest...); });
  }
  Error try_crossings(const PathQueries& path, Scratch& scratch, std::vector<PathCrossing>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_crossings(get(), path.get(), scratch.get(), rest...); });
  }

  /// As `mapd_path_facts`, with today's permissions; a light that is out of service now governs nothing.
  Result<std::vector<PathFact>> try_facts(const PathQueries& path, Scratch& scratch) const {
    return detail::list<PathFact>([&](auto... rest) { return mapd_view_facts(get(), path.get(), scratch.get(), rest...); });
  }
  Error try_facts(const PathQueries& path, Scratch& scratch, std::vector<PathFact>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_facts(get(), path.get(), scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::vector<PathRestriction> restrictions_on_path(const PathQueries& path, std::uint8_t vehicle) const { return try_restrictions_on_path(path, vehicle).value(); }
  void restrictions_on_path(const PathQueries& path, std::uint8_t vehicle, std::vector<PathRestriction>& out) const { detail::must(try_restrictions_on_path(path, vehicle, out)); }
  SpeedToday speed_on_path(const PathQueries& path, double along, std::uint8_t vehicle) const { return try_speed_on_path(path, along, vehicle).value(); }
  std::vector<PathSpeedToday> speeds_on_path(const PathQueries& path, std::uint8_t vehicle) const { return try_speeds_on_path(path, vehicle).value(); }
  void speeds_on_path(const PathQueries& path, std::uint8_t vehicle, std::vector<PathSpeedToday>& out) const { detail::must(try_speeds_on_path(path, vehicle, out)); }
  PathTime travel_time_on_path(const PathQueries& path, double from, double to, std::uint8_t vehicle) const { return try_travel_time_on_path(path, from, to, vehicle).value(); }
  std::vector<PathSegment> segments_on_path(const PathQueries& path, std::uint8_t vehicle, Scratch& scratch) const { return try_segments_on_path(path, vehicle, scratch).value(); }
  void segments_on_path(const PathQueries& path, std::uint8_t vehicle, Scratch& scratch, std::vector<PathSegment>& out) const { detail::must(try_segments_on_path(path, vehicle, scratch, out)); }
  PathConflicts conflicts(const PathQueries& path, Scratch& scratch) const { return try_conflicts(path, scratch).value(); }
  std::vector<PathCrossing> crossings(const PathQueries& path, Scratch& scratch) const { return try_crossings(path, scratch).value(); }
  void crossings(const PathQueries& path, Scratch& scratch, std::vector<PathCrossing>& out) const { detail::must(try_crossings(path, scratch, out)); }
  std::vector<PathFact> facts(const PathQueries& path, Scratch& scratch) const { return try_facts(path, scratch).value(); }
  void facts(const PathQueries& path, Scratch& scratch, std::vector<PathFact>& out) const { detail::must(try_facts(path, scratch, out)); }
#endif

  // Ways, corridors, signals and poses under what is laid over a map.

  /// As `mapd_route`, with the overlay's current entries applied: closed stretches are not entered, opened ones may be, and times are those of today's speeds.
  /// The lane of the start may be closed.
  Result<std::optional<Route>> try_route(span<const PositionOnLane> places, Cost cost, Scratch& scratch) const {
    return detail::route<Route>([&](auto... rest) { return mapd_view_route(get(), places.data(), places.size(), cost, scratch.get(), rest...); });
  }

  /// As `mapd_reachable`, with the overlay's current entries applied. If the overlay cuts a node, the answer lists its pieces one by one.
  Result<std::vector<ReachedPiece>> try_reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch) const {
    return detail::list<ReachedPiece>([&](auto... rest) { return mapd_view_reachable(get(), from, limit, cost, scratch.get(), rest...); });
  }
  Error try_reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch, std::vector<ReachedPiece>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_reachable(get(), from, limit, cost, scratch.get(), rest...); });
  }

  /// As `mapd_path_corridor`, with the overlay's current entries applied: beside the path a lane that is closed cannot be changed to and adds no room, and one
  /// that is opened may and does; the speeds are today's, with the origin `MAPD_SPEED_ORIGIN_OVERLAY` where an entry states them.
  Result<std::vector<CorridorStation>> try_corridor(const PathQueries& path, double from, double length, double step, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<CorridorStation>([&](auto... rest) { return mapd_view_corridor(get(), path.get(), from, length, step, vehicle, scratch.get(), rest...); });
  }
  Error try_corridor(const PathQueries& path, double from, double length, double step, std::uint8_t vehicle, Scratch& scratch, std::vector<CorridorStation>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_corridor(get(), path.get(), from, length, step, vehicle, scratch.get(), rest...); });
  }

  /// As `mapd_signals_ahead`, with the overlay's current entries applied: ways through closed lanes are not followed. Signals that are out of service are among
  /// them; `mapd_view_signal_out_of_service` tells which are.
  Result<std::vector<SignalAhead>> try_signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<SignalAhead>([&](auto... rest) { return mapd_view_signals_ahead(get(), from, distance, vehicle, scratch.get(), rest...); });
  }
  Error try_signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch, std::vector<SignalAhead>& out) const {
    return detail::list_into(out, [&](auto... rest) { return mapd_view_signals_ahead(get(), from, distance, vehicle, scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<Route> route(span<const PositionOnLane> places, Cost cost, Scratch& scratch) const { return try_route(places, cost, scratch).value(); }
  std::vector<ReachedPiece> reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch) const { return try_reachable(from, limit, cost, scratch).value(); }
  void reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch, std::vector<ReachedPiece>& out) const { detail::must(try_reachable(from, limit, cost, scratch, out)); }
  std::vector<CorridorStation> corridor(const PathQueries& path, double from, double length, double step, std::uint8_t vehicle, Scratch& scratch) const { return try_corridor(path, from, length, step, vehicle, scratch).value(); }
  void corridor(const PathQueries& path, double from, double length, double step, std::uint8_t vehicle, Scratch& scratch, std::vector<CorridorStation>& out) const { detail::must(try_corridor(path, from, length, step, vehicle, scratch, out)); }
  std::vector<SignalAhead> signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch) const { return try_signals_ahead(from, distance, vehicle, scratch).value(); }
  void signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle, Scratch& scratch, std::vector<SignalAhead>& out) const { detail::must(try_signals_ahead(from, distance, vehicle, scratch, out)); }
#endif

  // Routes by request: several starts and goals, lanes to avoid, costs of turns; alternatives; the network that can be reached.

  /// As `mapd_find_route`, heeding what holds now.
  Result<std::optional<Route>> try_find_route(const RouteRequest& request, Scratch& scratch) const {
    return detail::route<Route>([&](auto... rest) { return mapd_view_find_route(get(), &request, scratch.get(), rest...); });
  }

  /// As `mapd_alternatives`, heeding what holds now.
  Result<std::vector<Route>> try_alternatives(const RouteRequest& request, Scratch& scratch, const AlternativeOptions& options = {}) const {
    return detail::routes<Route>([&](auto... rest) { return mapd_view_alternatives(get(), &request, &options, scratch.get(), rest...); });
  }

  /// As `mapd_reach`, heeding what holds now. Where the overlay cuts a node, each piece is told of by itself.
  Result<Reach> try_reach(const RouteRequest& request, double limit, bool to, Scratch& scratch) const {
    return detail::reach<Reach>([&](auto... rest) { return mapd_view_reach(get(), &request, limit, detail::to_byte(to), scratch.get(), rest...); });
  }

#if MAPD_EXCEPTIONS
  std::optional<Route> find_route(const RouteRequest& request, Scratch& scratch) const { return try_find_route(request, scratch).value(); }
  std::vector<Route> alternatives(const RouteRequest& request, Scratch& scratch, const AlternativeOptions& options = {}) const { return try_alternatives(request, scratch, options).value(); }
  Reach reach(const RouteRequest& request, double limit, bool to, Scratch& scratch) const { return try_reach(request, limit, to, scratch).value(); }
#endif
};

}  // namespace mapd
