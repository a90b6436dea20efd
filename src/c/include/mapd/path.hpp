/// Routes as one line, and the room along them; `mapd.h` documents units, signs and errors of each.
#pragma once

#include "queries.hpp"

namespace mapd {

/// A route as one line. It keeps its snapshot; several threads may use it at once.
class Path : public detail::Owner<mapd_path, mapd_path_close> {
 public:
  using Owner::Owner;

  /// Length: the largest S [m].
  Result<double> try_length() const {
    return detail::value<double>([&](auto... out) { return mapd_path_length(get(), out...); });
  }
  /// The place at S [m].
  Result<PathPoint> try_at(double along) const {
    return detail::value<PathPoint>([&](auto... out) { return mapd_path_at(get(), along, out...); });
  }
  /// A point in the path's coordinates; the search begins at the hint.
  Result<PathPosition> try_project(Vec2 point, std::optional<double> hint = std::nullopt) const {
    const double* begin = hint ? &*hint : nullptr;
    return detail::value<PathPosition>([&](auto... out) { return mapd_path_project(get(), point, begin, out...); });
  }
  /// The speed limit at S.
  Result<std::optional<SpeedRule>> try_speed_at(double along) const {
    return detail::optional<SpeedRule>([&](auto... out) { return mapd_path_speed_at(get(), along, out...); });
  }
  /// Where the line is not continuous, or changes lanes.
  Result<std::vector<PathJoint>> try_joints() const {
    return detail::list<PathJoint>([&](auto... out) { return mapd_path_joints(get(), out...); });
  }
  /// Whether some joint is broken.
  Result<bool> try_is_broken() const {
    const auto found = detail::value<std::uint8_t>([&](auto... out) { return mapd_path_is_broken(get(), out...); });
    if (!found) return found.error();
    return *found != 0;
  }
  /// The lanes that are driven on.
  Result<std::vector<PathLane>> try_lanes() const {
    return detail::list<PathLane>([&](auto... out) { return mapd_path_lanes(get(), out...); });
  }
  /// S of a place on one of the path's lanes [m].
  Result<std::optional<double>> try_along_of(PositionOnLane place) const {
    return detail::optional<double>(
        [&](auto... out) { return mapd_path_along_of(get(), place.lane, place.s, out...); });
  }
  /// The room along the path, a station every `step` [m] from S on.
  Result<std::vector<CorridorStation>> try_corridor(double from, double length, double step, std::uint8_t vehicle,
                                                    Scratch& scratch) const {
    return detail::list<CorridorStation>([&](auto... out) {
      return mapd_path_corridor(get(), from, length, step, vehicle, scratch.get(), out...);
    });
  }
  /// The road's surface at the same stations.
  Result<std::vector<CorridorSurface>> try_corridor_surface(double from, double length, double step,
                                                            Scratch& scratch) const {
    return detail::list<CorridorSurface>([&](auto... out) {
      return mapd_path_corridor_surface(get(), from, length, step, scratch.get(), out...);
    });
  }
  /// What the path comes by.
  Result<std::vector<PathFact>> try_facts(Scratch& scratch) const {
    return detail::list<PathFact>([&](auto... out) { return mapd_path_facts(get(), scratch.get(), out...); });
  }
  /// The speed limits along the path.
  Result<std::vector<PathSpeed>> try_speeds(Scratch& scratch) const {
    return detail::list<PathSpeed>([&](auto... out) { return mapd_path_speeds(get(), scratch.get(), out...); });
  }
  /// How long a vehicle takes from S to S [m] at the speed limits.
  Result<PathTime> try_travel_time(double from, double to) const {
    return detail::value<PathTime>([&](auto... out) { return mapd_path_travel_time(get(), from, to, out...); });
  }
  /// From which lanes the goal is reached, and until where a change of lane may wait.
  Result<std::vector<PathSegment>> try_segments(std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<PathSegment>(
        [&](auto... out) { return mapd_path_segments(get(), vehicle, scratch.get(), out...); });
  }
  /// The part of the path's own steps from one S to another [m].
  Result<std::vector<RouteStep>> try_steps_between(span<const RouteStep> steps, double from, double to,
                                                   Scratch& scratch) const {
    return detail::list<RouteStep>([&](auto... out) {
      return mapd_path_steps_between(get(), steps.data(), steps.size(), from, to, scratch.get(), out...);
    });
  }
  /// The way of the path on another snapshot, such as the next version of its map.
  Result<Rebased> try_rebase(const Queries& map, Cost cost, Scratch& scratch) const {
    Rebased out;
    std::vector<PathChange> changes(16);
    for (;;) {
      std::size_t change_count = 0;
      auto route = detail::route<Route>([&](auto sum, auto steps, auto capacity, auto count, auto error) {
        const mapd_code code = mapd_path_rebase(get(), map.get(), cost, scratch.get(), sum, steps, capacity, count,
                                                changes.data(), changes.size(), &change_count, error);
        // The steps are whole before the changes are: those are looked at below.
        return code == MAPD_CODE_TOO_SMALL && *count <= capacity ? MAPD_CODE_OK : code;
      });
      if (!route) return route.error();
      const bool fits = change_count <= changes.size();
      changes.resize(change_count);
      if (!fits) continue;
      out.route = *std::move(route);
      out.changes = std::move(changes);
      return out;
    }
  }
  /// Where other traffic meets the path.
  Result<std::vector<PathConflict>> try_conflicts(Scratch& scratch) const {
    return detail::list<PathConflict>([&](auto... out) { return mapd_path_conflicts(get(), scratch.get(), out...); });
  }
  /// Crosswalks and bicycle crossings over the path.
  Result<std::vector<PathCrossing>> try_crossings(Scratch& scratch) const {
    return detail::list<PathCrossing>([&](auto... out) { return mapd_path_crossings(get(), scratch.get(), out...); });
  }
  /// Many places; `out` has as many entries as `along`.
  Error try_at(span<const double> along, span<PathPoint> out) const {
    return detail::batch(along, out, [&](auto... rest) { return mapd_path_at_batch(get(), rest...); });
  }
  /// Many points in the path's coordinates; `out` has as many entries as `points`.
  Error try_project(span<const Vec2> points, span<PathPosition> out) const {
    return detail::batch(points, out, [&](auto... rest) { return mapd_path_project_batch(get(), rest...); });
  }
#if MAPD_EXCEPTIONS
  double length() const { return try_length().value(); }
  PathPoint at(double along) const { return try_at(along).value(); }
  PathPosition project(Vec2 point, std::optional<double> hint = std::nullopt) const {
    return try_project(point, hint).value();
  }
  std::optional<SpeedRule> speed_at(double along) const { return try_speed_at(along).value(); }
  std::vector<PathJoint> joints() const { return try_joints().value(); }
  bool is_broken() const { return try_is_broken().value(); }
  std::vector<PathLane> lanes() const { return try_lanes().value(); }
  std::optional<double> along_of(PositionOnLane place) const { return try_along_of(place).value(); }
  std::vector<CorridorStation> corridor(double from, double length, double step, std::uint8_t vehicle,
                                        Scratch& scratch) const {
    return try_corridor(from, length, step, vehicle, scratch).value();
  }
  std::vector<CorridorSurface> corridor_surface(double from, double length, double step, Scratch& scratch) const {
    return try_corridor_surface(from, length, step, scratch).value();
  }
  std::vector<PathFact> facts(Scratch& scratch) const { return try_facts(scratch).value(); }
  std::vector<PathSpeed> speeds(Scratch& scratch) const { return try_speeds(scratch).value(); }
  PathTime travel_time(double from, double to) const { return try_travel_time(from, to).value(); }
  std::vector<PathSegment> segments(std::uint8_t vehicle, Scratch& scratch) const {
    return try_segments(vehicle, scratch).value();
  }
  std::vector<RouteStep> steps_between(span<const RouteStep> steps, double from, double to, Scratch& scratch) const {
    return try_steps_between(steps, from, to, scratch).value();
  }
  Rebased rebase(const Queries& map, Cost cost, Scratch& scratch) const { return try_rebase(map, cost, scratch).value(); }
  std::vector<PathConflict> conflicts(Scratch& scratch) const { return try_conflicts(scratch).value(); }
  std::vector<PathCrossing> crossings(Scratch& scratch) const { return try_crossings(scratch).value(); }
  void at(span<const double> along, span<PathPoint> out) const { detail::must(try_at(along, out)); }
  void project(span<const Vec2> points, span<PathPosition> out) const { detail::must(try_project(points, out)); }
#endif
};

/// Who goes first, a MAPD_YIELDS_…, and what that rests on, a MAPD_BASIS_….
struct YieldsBy {
  std::uint8_t yields = MAPD_YIELDS_UNKNOWN;
  std::uint8_t basis = MAPD_BASIS_UNKNOWN;
};

/// Who goes first at a conflict by the file, else by the rules of a country; none for a country whose rules are not known.
inline Result<std::optional<YieldsBy>> try_yields_by(const PathConflict& conflict, const std::string& country) {
  YieldsBy out;
  mapd_error error;
  const mapd_code code = mapd_path_conflict_yields_by(&conflict, country.c_str(), &out.yields, &out.basis, &error);
  if (code == MAPD_CODE_NONE) return std::optional<YieldsBy>();
  if (code != MAPD_CODE_OK) return detail::failed(code, error);
  return std::optional<YieldsBy>(out);
}
#if MAPD_EXCEPTIONS
inline std::optional<YieldsBy> yields_by(const PathConflict& conflict, const std::string& country) {
  return try_yields_by(conflict, country).value();
}
#endif

/// The room of stations as one polygon; edges is a MAPD_CORRIDOR_EDGES_….
inline Result<Outline> try_outline(span<const CorridorStation> stations, std::uint32_t edges, Scratch& scratch) {
  Outline out;
  std::uint8_t is_simple = 0;
  auto points = detail::list<Vec2>([&](auto to, auto capacity, auto count, auto error) {
    return mapd_corridor_outline(stations.data(), stations.size(), edges, scratch.get(), to, capacity, count, &is_simple,
                                 error);
  });
  if (!points) return points.error();
  out.points = *std::move(points);
  out.is_simple = is_simple != 0;
  return out;
}
#if MAPD_EXCEPTIONS
inline Outline outline(span<const CorridorStation> stations, std::uint32_t edges, Scratch& scratch) {
  return try_outline(stations, edges, scratch).value();
}
#endif

}  // namespace mapd
