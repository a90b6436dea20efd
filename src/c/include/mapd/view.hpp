/// A map under what is laid over it; `mapd.h` documents units, signs and errors of each.
#pragma once

#include "path.hpp"

#include <chrono>

namespace mapd {

/// A map under its overlay at a moment: closures, temporary limits, warnings. It keeps its snapshot; several threads may use it at once.
class View : public detail::Owner<mapd_view, mapd_view_close> {
 public:
  using Owner::Owner;

  /// A moment in seconds since 1970-01-01 00:00 UTC.
  static double seconds(std::chrono::system_clock::time_point at) noexcept {
    return std::chrono::duration<double>(at.time_since_epoch()).count();
  }

  /// Everything that the overlay says, whether it holds now or not.
  Result<std::vector<OverlayEntry>> try_entries() const {
    return detail::list<OverlayEntry>([&](auto... out) { return mapd_view_entries(get(), out...); });
  }
  /// What holds now, wherever it does.
  Result<std::vector<Restriction>> try_restrictions() const {
    return detail::list<Restriction>([&](auto... out) { return mapd_view_restrictions(get(), out...); });
  }
  /// Entries that hold now at a place, in the lane's own direction.
  Result<std::vector<Restriction>> try_restrictions_at(PositionOnLane place) const {
    return detail::list<Restriction>(
        [&](auto... out) { return mapd_view_restrictions_at(get(), place.lane, place.s, out...); });
  }
  /// What holds now along a route.
  Result<std::vector<Restriction>> try_restrictions_along(span<const RouteStep> steps, std::uint8_t vehicle,
                                                          Scratch& scratch) const {
    return detail::list<Restriction>([&](auto... out) {
      return mapd_view_restrictions_along(get(), steps.data(), steps.size(), vehicle, scratch.get(), out...);
    });
  }
  /// What holds now along a path.
  Result<std::vector<PathRestriction>> try_restrictions_on_path(const Path& path, std::uint8_t vehicle) const {
    return detail::list<PathRestriction>(
        [&](auto... out) { return mapd_view_restrictions_on_path(get(), path.get(), vehicle, out...); });
  }
  /// Whether a class of vehicles may use a lane at a place, in its own direction.
  Result<Permission> try_allows(PositionOnLane place, std::uint8_t vehicle) const {
    return detail::value<Permission>(
        [&](auto... out) { return mapd_view_allows(get(), place.lane, place.s, vehicle, out...); });
  }
  /// The speed limit at a place.
  Result<SpeedToday> try_speed_rule_at(PositionOnLane place, std::uint8_t vehicle) const {
    return detail::value<SpeedToday>(
        [&](auto... out) { return mapd_view_speed_rule_at(get(), place.lane, place.s, vehicle, out...); });
  }
  /// Whether a class of vehicles may overtake at a place.
  Result<OvertakingToday> try_overtaking_rule_at(PositionOnLane place, std::uint8_t vehicle) const {
    return detail::value<OvertakingToday>(
        [&](auto... out) { return mapd_view_overtaking_rule_at(get(), place.lane, place.s, vehicle, out...); });
  }
  /// The speed limit at S of a path [m].
  Result<SpeedToday> try_speed_on_path(const Path& path, double along, std::uint8_t vehicle) const {
    return detail::value<SpeedToday>(
        [&](auto... out) { return mapd_view_speed_on_path(get(), path.get(), along, vehicle, out...); });
  }
  /// The speed limits along a path, in ascending S without gaps.
  Result<std::vector<PathSpeedToday>> try_speeds_on_path(const Path& path, std::uint8_t vehicle) const {
    return detail::list<PathSpeedToday>(
        [&](auto... out) { return mapd_view_speeds_on_path(get(), path.get(), vehicle, out...); });
  }
  /// How long a vehicle takes from one S of a path to another [m] at these limits.
  Result<PathTime> try_travel_time_on_path(const Path& path, double from, double to, std::uint8_t vehicle) const {
    return detail::value<PathTime>(
        [&](auto... out) { return mapd_view_travel_time_on_path(get(), path.get(), from, to, vehicle, out...); });
  }
  /// The lanes from which a path's goal is reached, none of them through what is closed now.
  Result<std::vector<PathSegment>> try_segments_on_path(const Path& path, std::uint8_t vehicle,
                                                        Scratch& scratch) const {
    return detail::list<PathSegment>(
        [&](auto... out) { return mapd_view_segments_on_path(get(), path.get(), vehicle, scratch.get(), out...); });
  }
  /// The number of the entry by which a signal is out of service.
  Result<std::optional<std::uint32_t>> try_signal_out_of_service(SignalId signal) const {
    return detail::optional<std::uint32_t>(
        [&](auto... out) { return mapd_view_signal_out_of_service(get(), signal, out...); });
  }
  /// The cheapest way that is open now.
  Result<std::optional<Route>> try_route(span<const PositionOnLane> places, Cost cost, Scratch& scratch) const {
    return detail::route<Route>([&](auto... out) {
      return mapd_view_route(get(), places.data(), places.size(), cost, scratch.get(), out...);
    });
  }
  /// The cheapest way from any start of a request to any of its goals.
  Result<std::optional<Route>> try_find_route(const RouteRequest& request, Scratch& scratch) const {
    return detail::route<Route>(
        [&](auto... out) { return mapd_view_find_route(get(), &request, scratch.get(), out...); });
  }
  /// It and alternatives to it, cheapest first.
  Result<std::vector<Route>> try_alternatives(const RouteRequest& request, Scratch& scratch,
                                              const AlternativeOptions& options = {}) const {
    return detail::routes<Route>(
        [&](auto... out) { return mapd_view_alternatives(get(), &request, &options, scratch.get(), out...); });
  }
  /// What can be reached from a request's starts within a cost, or, with `to`, from where its goals can be.
  Result<Reach> try_reach(const RouteRequest& request, double limit, bool to, Scratch& scratch) const {
    return detail::reach<Reach>([&](auto... out) {
      return mapd_view_reach(get(), &request, limit, to ? std::uint8_t{1} : std::uint8_t{0}, scratch.get(), out...);
    });
  }
#if MAPD_EXCEPTIONS
  std::optional<Route> find_route(const RouteRequest& request, Scratch& scratch) const {
    return try_find_route(request, scratch).value();
  }
  std::vector<Route> alternatives(const RouteRequest& request, Scratch& scratch,
                                  const AlternativeOptions& options = {}) const {
    return try_alternatives(request, scratch, options).value();
  }
  Reach reach(const RouteRequest& request, double limit, bool to, Scratch& scratch) const {
    return try_reach(request, limit, to, scratch).value();
  }
#endif
  /// What can be reached now within a cost.
  Result<std::vector<ReachedPiece>> try_reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch) const {
    return detail::list<ReachedPiece>(
        [&](auto... out) { return mapd_view_reachable(get(), from, limit, cost, scratch.get(), out...); });
  }
  /// The room along a path, as lanes beside it are open now, with today's speed limits.
  Result<std::vector<CorridorStation>> try_corridor(const Path& path, double from, double length, double step,
                                                    std::uint8_t vehicle, Scratch& scratch) const {
    return detail::list<CorridorStation>([&](auto... out) {
      return mapd_view_corridor(get(), path.get(), from, length, step, vehicle, scratch.get(), out...);
    });
  }
  /// Signals ahead on any way that is open now.
  Result<std::vector<SignalAhead>> try_signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle,
                                                     Scratch& scratch) const {
    return detail::list<SignalAhead>([&](auto... out) {
      return mapd_view_signals_ahead(get(), from, distance, vehicle, scratch.get(), out...);
    });
  }
  /// The lanes that a vehicle may be in, closed ones being less probable.
  Result<PoseMatch> try_match_pose(const VehiclePose& pose, const Covariance& covariance, Scratch& scratch,
                                   const MatchOptions& options = {}) const {
    PoseMatch match;
    auto lanes = detail::list<LaneMatch>([&](auto out, auto capacity, auto count, auto error) {
      return mapd_view_match_pose(get(), pose, covariance.data(), &options, scratch.get(), out, capacity, count,
                                  &match.none, error);
    });
    if (!lanes) return lanes.error();
    match.lanes = *std::move(lanes);
    return match;
  }
#if MAPD_EXCEPTIONS
  std::vector<OverlayEntry> entries() const { return try_entries().value(); }
  std::vector<Restriction> restrictions() const { return try_restrictions().value(); }
  std::vector<Restriction> restrictions_at(PositionOnLane place) const { return try_restrictions_at(place).value(); }
  std::vector<Restriction> restrictions_along(span<const RouteStep> steps, std::uint8_t vehicle,
                                              Scratch& scratch) const {
    return try_restrictions_along(steps, vehicle, scratch).value();
  }
  std::vector<PathRestriction> restrictions_on_path(const Path& path, std::uint8_t vehicle) const {
    return try_restrictions_on_path(path, vehicle).value();
  }
  Permission allows(PositionOnLane place, std::uint8_t vehicle) const { return try_allows(place, vehicle).value(); }
  SpeedToday speed_rule_at(PositionOnLane place, std::uint8_t vehicle) const {
    return try_speed_rule_at(place, vehicle).value();
  }
  OvertakingToday overtaking_rule_at(PositionOnLane place, std::uint8_t vehicle) const {
    return try_overtaking_rule_at(place, vehicle).value();
  }
  SpeedToday speed_on_path(const Path& path, double along, std::uint8_t vehicle) const {
    return try_speed_on_path(path, along, vehicle).value();
  }
  std::vector<PathSpeedToday> speeds_on_path(const Path& path, std::uint8_t vehicle) const {
    return try_speeds_on_path(path, vehicle).value();
  }
  PathTime travel_time_on_path(const Path& path, double from, double to, std::uint8_t vehicle) const {
    return try_travel_time_on_path(path, from, to, vehicle).value();
  }
  std::vector<PathSegment> segments_on_path(const Path& path, std::uint8_t vehicle, Scratch& scratch) const {
    return try_segments_on_path(path, vehicle, scratch).value();
  }
  std::optional<std::uint32_t> signal_out_of_service(SignalId signal) const {
    return try_signal_out_of_service(signal).value();
  }
  std::optional<Route> route(span<const PositionOnLane> places, Cost cost, Scratch& scratch) const {
    return try_route(places, cost, scratch).value();
  }
  std::vector<ReachedPiece> reachable(PositionOnLane from, double limit, Cost cost, Scratch& scratch) const {
    return try_reachable(from, limit, cost, scratch).value();
  }
  std::vector<CorridorStation> corridor(const Path& path, double from, double length, double step,
                                        std::uint8_t vehicle, Scratch& scratch) const {
    return try_corridor(path, from, length, step, vehicle, scratch).value();
  }
  std::vector<SignalAhead> signals_ahead(PositionOnLane from, double distance, std::uint8_t vehicle,
                                         Scratch& scratch) const {
    return try_signals_ahead(from, distance, vehicle, scratch).value();
  }
  PoseMatch match_pose(const VehiclePose& pose, const Covariance& covariance, Scratch& scratch,
                       const MatchOptions& options = {}) const {
    return try_match_pose(pose, covariance, scratch, options).value();
  }
#endif
};

}  // namespace mapd
