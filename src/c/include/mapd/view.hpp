/// A map under what is laid over it; `mapd.h` documents units, signs and errors of each.
#pragma once

#include "path.hpp"

#include <chrono>

namespace mapd {

/// A map under its overlay at a moment: closures, temporary limits, warnings. It keeps its snapshot; several threads may use it at once.
class View : public ViewQueries {
 public:
  using ViewQueries::ViewQueries;

  /// A moment in seconds since 1970-01-01 00:00 UTC.
  static double seconds(std::chrono::system_clock::time_point at) noexcept {
    return std::chrono::duration<double>(at.time_since_epoch()).count();
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
  PoseMatch match_pose(const VehiclePose& pose, const Covariance& covariance, Scratch& scratch,
                       const MatchOptions& options = {}) const {
    return try_match_pose(pose, covariance, scratch, options).value();
  }
#endif
};

}  // namespace mapd
