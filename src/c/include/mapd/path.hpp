/// Routes as one line, and the room along them; `mapd.h` documents units, signs and errors of each.
#pragma once

#include "queries.hpp"

namespace mapd {

/// A route as one line. It keeps its snapshot; several threads may use it at once.
class Path : public PathQueries {
 public:
  using PathQueries::PathQueries;

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
#if MAPD_EXCEPTIONS
  Rebased rebase(const Queries& map, Cost cost, Scratch& scratch) const { return try_rebase(map, cost, scratch).value(); }
#endif
};

/// Who goes first, a MAPD_YIELDS_…, and what that rests on, a MAPD_BASIS_….
struct YieldsBy {
  std::uint8_t yields = MAPD_YIELDS_UNKNOWN;
  std::uint8_t basis = MAPD_BASIS_UNKNOWN;
};

/// Who goes first at a conflict of these lanes by the file, else by the rules of a country; none for a country whose rules are not known.
inline Result<std::optional<YieldsBy>> try_yields_by(span<const ConflictLane> lanes, const std::string& country) {
  YieldsBy out;
  mapd_error error;
  const mapd_code code =
      mapd_path_conflict_yields_by(lanes.data(), lanes.size(), country.c_str(), &out.yields, &out.basis, &error);
  if (code == MAPD_CODE_NONE) return std::optional<YieldsBy>();
  if (code != MAPD_CODE_OK) return detail::failed(code, error);
  return std::optional<YieldsBy>(out);
}
#if MAPD_EXCEPTIONS
inline std::optional<YieldsBy> yields_by(span<const ConflictLane> lanes, const std::string& country) {
  return try_yields_by(lanes, country).value();
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
