/// The lane of a vehicle that drives; `mapd.h` documents units, signs and errors of each.
#pragma once

#include "queries.hpp"

namespace mapd {

/// A running filter over poses. It belongs to one thread at a time and to no map.
class Tracker : public detail::Owner<mapd_tracker, mapd_tracker_close> {
 public:
  Tracker() : Owner(make()) {}

  /// Takes the next fix: the lane of the vehicle, none, or unknown (`state`).
  Result<Tracked> try_update(const Queries& map, const TrackerFix& fix, const TrackerOptions& options = {}) {
    return detail::value<Tracked>(
        [&](auto... out) { return mapd_tracker_update(get(), map.get(), &fix, &options, out...); });
  }
  /// The lanes that the vehicle may be in, the most probable one first.
  Result<PoseMatch> try_hypotheses() const {
    PoseMatch match;
    auto lanes = detail::list<LaneMatch>([&](auto out, auto capacity, auto count, auto error) {
      return mapd_tracker_hypotheses(get(), out, capacity, count, &match.none, error);
    });
    if (!lanes) return lanes.error();
    match.lanes = *std::move(lanes);
    return match;
  }
  /// Probability that the vehicle is in one of these lanes.
  Result<double> try_probability_in(span<const LaneId> lanes) {
    return detail::value<double>(
        [&](auto... out) { return mapd_tracker_probability_in(get(), lanes.data(), lanes.size(), out...); });
  }
  /// Forgets everything.
  void reset() noexcept { mapd_tracker_reset(get(), nullptr); }
#if MAPD_EXCEPTIONS
  Tracked update(const Queries& map, const TrackerFix& fix, const TrackerOptions& options = {}) {
    return try_update(map, fix, options).value();
  }
  PoseMatch hypotheses() const { return try_hypotheses().value(); }
  double probability_in(span<const LaneId> lanes) { return try_probability_in(lanes).value(); }
#endif

 private:
  static mapd_tracker* make() noexcept {
    mapd_tracker* raw = nullptr;
    mapd_tracker_new(&raw, nullptr);
    return raw;
  }
};

}  // namespace mapd
