/// Values, results and handles of mapd for C++17: see `mapd.hpp`.
#pragma once

#include "../mapd.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define MAPD_EXCEPTIONS 1
#include <stdexcept>
#else
#define MAPD_EXCEPTIONS 0
#endif

namespace mapd {

using Vec2 = mapd_vec2;
using Vec3 = mapd_vec3;
using Region = mapd_region;
using Track = mapd_track;
using Pose = mapd_pose;
using TrackPosition = mapd_track_position;
using LanePosition = mapd_lane_position;
using RoadId = mapd_road_id;
using LaneId = mapd_lane_id;
using JunctionId = mapd_junction_id;
using NodeId = mapd_node_id;
using SignalId = mapd_signal_id;
using ObjectId = mapd_object_id;
using PlacementId = mapd_placement_id;
using Generation = mapd_generation;
using Decision = mapd_decision;
using Event = mapd_event;
using MapFacts = mapd_map_facts;
using GeodeticBounds = mapd_geodetic_bounds;
using Nearest = mapd_nearest;
using RoadFacts = mapd_road_facts;
using LaneFacts = mapd_lane_facts;
using LaneEdges = mapd_lane_edges;
using LaneBounds = mapd_lane_bounds;
using Waypoint = mapd_waypoint;
using LinePoint = mapd_line_point;
using NodeFacts = mapd_node_facts;
using Edge = mapd_edge;
using Conflict = mapd_conflict;
using PositionOnLane = mapd_position_on_lane;
using RouteStep = mapd_route_step;
using RouteSum = mapd_route_sum;
using Reached = mapd_reached;
using NextJunction = mapd_next_junction;
using LaneChange = mapd_lane_change;
using JunctionFacts = mapd_junction_facts;
using Connection = mapd_connection;
using SignalFacts = mapd_signal_facts;
using LaneSignal = mapd_lane_signal;
using NearSignal = mapd_near_signal;
using SpeedRule = mapd_speed_rule;
using SpeedStretch = mapd_speed_stretch;
using SignalAhead = mapd_signal_ahead;
using LaneLine = mapd_lane_line_at;
using RightOfWay = mapd_right_of_way;
using ObjectFacts = mapd_object_facts;
using PlacementFacts = mapd_placement_facts;
using NearObject = mapd_near_object;
using ObjectLane = mapd_object_lane;
using ClassSet = mapd_class_set;
using Landmark = mapd_landmark;
using RoadMark = mapd_road_mark;
using BoundarySegment = mapd_boundary_segment;
using RoadMarkSegment = mapd_road_mark_segment;
using Material = mapd_material;
using Surface = mapd_surface;
using LaneHeight = mapd_lane_height;
using GridHeight = mapd_grid_height;
using Geodetic = mapd_geodetic;
using PathPoint = mapd_path_point;
using PathPosition = mapd_path_position;
using PathJoint = mapd_path_joint;
using PathLane = mapd_path_lane;
using CorridorStation = mapd_corridor_station;
using PathConflict = mapd_path_conflict;
using ConflictLane = mapd_conflict_lane;
using ConflictApproach = mapd_conflict_approach;
using PathCrossing = mapd_path_crossing;
using PathFact = mapd_path_fact;
using PathSpeed = mapd_path_speed;
using PathTime = mapd_path_time;
using PathSegment = mapd_path_segment;
using PathChange = mapd_path_change;
using CorridorSurface = mapd_corridor_surface;
using OverlayEntry = mapd_overlay_entry;
using Restriction = mapd_restriction;
using PathRestriction = mapd_path_restriction;
using PathSpeedToday = mapd_path_speed_today;
using Permission = mapd_permission;
using SpeedToday = mapd_speed_today;
using OvertakingToday = mapd_overtaking_today;
using ReachedPiece = mapd_reached_piece;
using ReachLink = mapd_reach_link;
using Ground = mapd_ground;
using NearMark = mapd_near_mark;
using VehiclePose = mapd_vehicle_pose;
using LaneMatch = mapd_lane_match;
using TraceFix = mapd_trace_fix;
using TraceMatch = mapd_trace_match;
using Tracked = mapd_tracked;
using Stance = mapd_stance;
using Sensor = mapd_sensor;
using LandmarkInView = mapd_landmark_in_view;
using MarkPoint = mapd_mark_point;
using OvertakingRule = mapd_overtaking_rule;
using Structure = mapd_structure;
using ObjectReference = mapd_object_reference;
using Quarantined = mapd_quarantined;
using JunctionGroup = mapd_junction_group;
using Controller = mapd_controller;
using SignalLink = mapd_signal_link;

/// For ever.
inline constexpr double forever = std::numeric_limits<double>::infinity();
/// Every lane type.
inline constexpr std::uint64_t all_lane_types = UINT64_MAX;

/// Entries side by side.
template <class T>
class span {
 public:
  constexpr span() noexcept = default;
  constexpr span(T* data, std::size_t size) noexcept : data_(data), size_(size) {}
  /// Of whatever has `data()` and `size()`, such as a vector.
  template <class C, class = decltype(static_cast<T*>(std::declval<C&>().data()))>
  constexpr span(C&& all) noexcept : data_(all.data()), size_(all.size()) {}
  template <std::size_t N>
  constexpr span(T (&all)[N]) noexcept : data_(all), size_(N) {}

  constexpr T* data() const noexcept { return data_; }
  constexpr std::size_t size() const noexcept { return size_; }
  constexpr bool empty() const noexcept { return size_ == 0; }
  constexpr T* begin() const noexcept { return data_; }
  constexpr T* end() const noexcept { return data_ + size_; }
  constexpr T& operator[](std::size_t i) const noexcept { return data_[i]; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

/// A point that is asked about, with or without z [m].
struct Point : mapd_point {
  constexpr Point(double east, double north) noexcept : mapd_point{east, north, 0.0, 0} {}
  constexpr Point(double east, double north, double up) noexcept : mapd_point{east, north, up, 1} {}
  constexpr Point(Vec2 at) noexcept : Point(at.x, at.y) {}
  constexpr Point(Vec3 at) noexcept : Point(at.x, at.y, at.z) {}
};

/// What counts as a match: see `mapd_nearest_options`.
struct NearestOptions {
  double radius = 10.0;
  std::uint64_t types = all_lane_types;
  std::optional<double> z_tolerance = std::nullopt;
  std::optional<double> heading = std::nullopt;
  std::optional<double> heading_tolerance = std::nullopt;
  std::optional<std::uint8_t> vehicle = std::nullopt;
  /// The answer for a point nearby; it has to outlive the call.
  const Nearest* hint = nullptr;

  mapd_nearest_options c() const noexcept {
    mapd_nearest_options out{};
    out.size = sizeof out;
    out.radius = radius;
    out.types = types;
    set(z_tolerance, out.z_tolerance, out.has_z_tolerance);
    set(heading, out.heading, out.has_heading);
    set(heading_tolerance, out.heading_tolerance, out.has_heading_tolerance);
    set(vehicle, out.vehicle, out.has_vehicle);
    out.hint = hint;
    return out;
  }

 private:
  template <class T>
  static void set(const std::optional<T>& from, T& to, std::uint8_t& has) noexcept {
    if (!from) return;
    to = *from;
    has = 1;
  }
};

/// Which road marks count: see `mapd_mark_filter`.
struct MarkFilter : mapd_mark_filter {
  MarkFilter() noexcept { mapd_mark_filter_init(this, sizeof(mapd_mark_filter), nullptr); }
};

/// How hypotheses are weighed: see `mapd_match_options`.
struct MatchOptions : mapd_match_options {
  MatchOptions() noexcept { mapd_match_options_init(this, sizeof(mapd_match_options), nullptr); }
};

/// How a trace is matched: see `mapd_trace_options`.
struct TraceOptions : mapd_trace_options {
  TraceOptions() noexcept { mapd_trace_options_init(this, sizeof(mapd_trace_options), nullptr); }
};

/// What a route keeps small, by a MAPD_COST_…, and for whom; factors for each lane, by the row of its id, have to outlive the call.
struct Cost : mapd_cost {
  constexpr Cost(std::uint32_t by_what, std::uint32_t who, double of_a_lane_change, span<const double> of_lanes = {}) noexcept
      : mapd_cost{by_what, who, of_a_lane_change, of_lanes.data(), of_lanes.size()} {}
};

/// A start or goal: see `mapd_route_end`.
struct RouteEnd : mapd_route_end {
  constexpr RouteEnd(PositionOnLane place, std::uint8_t which_way = MAPD_DIRECTION_EITHER, double to_be_there = 0.0) noexcept
      : mapd_route_end{place.lane, place.s, to_be_there, which_way} {}
};

/// What is asked of a search: see `mapd_route_request`. Lists have to outlive the call.
struct RouteRequest : mapd_route_request {
  RouteRequest(span<const RouteEnd> from, span<const RouteEnd> to, const mapd_cost& of_ways, span<const LaneId> not_over = {}) noexcept {
    mapd_route_request_init(this, sizeof(mapd_route_request), nullptr);
    starts = from.data();
    start_count = from.size();
    goals = to.data();
    goal_count = to.size();
    avoid = not_over.data();
    avoid_count = not_over.size();
    cost = of_ways;
  }
};

/// Which alternatives are wanted: see `mapd_alternative_options`.
struct AlternativeOptions : mapd_alternative_options {
  AlternativeOptions() noexcept { mapd_alternative_options_init(this, sizeof(mapd_alternative_options), nullptr); }
};

/// How a path is built: see `mapd_path_options`.
struct PathOptions : mapd_path_options {
  PathOptions() noexcept { mapd_path_options_init(this, sizeof(mapd_path_options), nullptr); }
};

/// How a running drive is matched: see `mapd_tracker_options`.
struct TrackerOptions : mapd_tracker_options {
  TrackerOptions() noexcept { mapd_tracker_options_init(this, sizeof(mapd_tracker_options), nullptr); }
};

/// What is known of a vehicle at a moment, without an odometer unless one is given: see `mapd_tracker_fix`.
struct TrackerFix : mapd_tracker_fix {
  TrackerFix(double at, const VehiclePose& measured, const std::array<double, 9>& deviations,
             std::optional<double> way = std::nullopt) noexcept
      : mapd_tracker_fix{at, measured, {}, way.value_or(0.0), way ? std::uint8_t{1} : std::uint8_t{0}} {
    for (std::size_t i = 0; i < deviations.size(); ++i) covariance[i] = deviations[i];
  }
};

/// A covariance of (x, y, heading), row by row [m², m·rad, rad²].
using Covariance = std::array<double, 9>;

/// Lanes that a vehicle may be in, and the probability that it is in none.
struct PoseMatch {
  std::vector<LaneMatch> lanes;
  double none = 0.0;
};

/// The lanes that many vehicles may be in: those of pose k are `lanes[ends[k - 1]]` to `lanes[ends[k]]`, of the first from 0 on.
struct PoseMatches {
  std::vector<LaneMatch> lanes;
  std::vector<std::size_t> ends;
  std::vector<double> none;
};

/// Why a call failed.
struct Error {
  mapd_code code = MAPD_CODE_OK;
  std::string message;
};

#if MAPD_EXCEPTIONS
/// What `f` throws where `try_f` returns an error.
class Exception : public std::runtime_error {
 public:
  explicit Exception(const Error& error) : std::runtime_error(error.message), code_(error.code) {}
  mapd_code code() const noexcept { return code_; }

 private:
  mapd_code code_;
};
#endif

/// A value, or why there is none.
template <class T>
class Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Error error) : error_(std::move(error)) {}

  explicit operator bool() const noexcept { return value_.has_value(); }
  bool has_value() const noexcept { return value_.has_value(); }
  /// The value; there has to be one.
  T& operator*() & noexcept { return *value_; }
  const T& operator*() const& noexcept { return *value_; }
  T&& operator*() && noexcept { return std::move(*value_); }
  T* operator->() noexcept { return &*value_; }
  const T* operator->() const noexcept { return &*value_; }
  /// Why there is none; `MAPD_CODE_OK` where there is one.
  const Error& error() const noexcept { return error_; }
  mapd_code code() const noexcept { return error_.code; }
#if MAPD_EXCEPTIONS
  /// The value, or an exception.
  T value() && {
    if (!value_) throw Exception(error_);
    return std::move(*value_);
  }
#endif

 private:
  std::optional<T> value_;
  Error error_;
};

/// A text of an answer's.
inline std::string_view view(mapd_text text) noexcept { return {text.data, text.size}; }

/// Whether an id names something.
template <class Id>
constexpr bool is_some(const Id& id) noexcept {
  return id.row != MAPD_NO_ROW;
}

namespace detail {

inline Error failed(mapd_code code, const mapd_error& error) { return {code, std::string(error.message, error.length)}; }

template <class T, class F>
Result<T> value(F call) {
  T out{};
  mapd_error error;
  const mapd_code code = call(&out, &error);
  if (code != MAPD_CODE_OK) return failed(code, error);
  return out;
}

template <class T, class F>
Result<std::optional<T>> optional(F call) {
  T out{};
  mapd_error error;
  const mapd_code code = call(&out, &error);
  if (code == MAPD_CODE_OK) return std::optional<T>(out);
  if (code == MAPD_CODE_NONE) return std::optional<T>();
  return failed(code, error);
}

/// A list, or none where there is nothing to list: an unknown country, a section that the road does not have.
template <class T, class F>
Result<std::optional<std::vector<T>>> optional_list(F call) {
  std::vector<T> out(16);
  mapd_error error;
  for (;;) {
    std::size_t count = 0;
    const mapd_code code = call(out.data(), out.size(), &count, &error);
    if (code == MAPD_CODE_TOO_SMALL) {
      out.resize(count);
      continue;
    }
    if (code == MAPD_CODE_NONE) return std::optional<std::vector<T>>();
    if (code != MAPD_CODE_OK) return failed(code, error);
    out.resize(count);
    return std::optional<std::vector<T>>(std::move(out));
  }
}

template <class T, class F>
Result<std::vector<T>> list(F call) {
  auto found = optional_list<T>(call);
  if (!found) return found.error();
  return (*std::move(found)).value_or(std::vector<T>());
}

/// As `list`, into the caller's vector: asks once if its memory suffices.
template <class T, class F>
Error list_into(std::vector<T>& out, F call) {
  mapd_error error;
  out.resize(out.capacity() > 16 ? out.capacity() : 16);
  for (;;) {
    std::size_t count = 0;
    const mapd_code code = call(out.data(), out.size(), &count, &error);
    if (code != MAPD_CODE_OK && code != MAPD_CODE_TOO_SMALL && code != MAPD_CODE_NONE) {
      out.clear();
      return failed(code, error);
    }
    out.resize(count);
    if (code != MAPD_CODE_TOO_SMALL) return {};
  }
}

/// A boolean answer, which C has as 1 or 0.
template <class F>
Result<bool> boolean(F call) {
  const auto found = value<std::uint8_t>(call);
  if (!found) return found.error();
  return *found != 0;
}

/// A text that an answer points to.
template <class F>
Result<std::string_view> text(F call) {
  const auto found = value<mapd_text>(call);
  if (!found) return found.error();
  return view(*found);
}

/// A text that an answer points to, if there is one.
template <class F>
Result<std::optional<std::string_view>> optional_text(F call) {
  const auto found = optional<mapd_text>(call);
  if (!found) return found.error();
  return *found ? std::optional(view(**found)) : std::nullopt;
}

/// A boolean as C has it.
constexpr std::uint8_t to_byte(bool is) noexcept { return is ? 1 : 0; }

/// What a batch came to: nothing, or why it failed.
template <class Q, class A, class F>
Error batch(span<Q> questions, span<A> answers, F call) {
  if (answers.size() < questions.size()) return {MAPD_CODE_TOO_SMALL, "expected as many answers as questions"};
  mapd_error error;
  const mapd_code code = call(questions.data(), questions.size(), answers.data(), &error);
  return code == MAPD_CODE_OK ? Error{} : failed(code, error);
}

/// A route and its steps, if there is one. Searching twice costs more than room for most routes.
template <class R, class F>
Result<std::optional<R>> route(F call) {
  R out;
  mapd_error error;
  out.steps.resize(512);
  for (;;) {
    std::size_t count = 0;
    const mapd_code code = call(&out.sum, out.steps.data(), out.steps.size(), &count, &error);
    if (code == MAPD_CODE_NONE) return std::optional<R>();
    if (code != MAPD_CODE_OK && code != MAPD_CODE_TOO_SMALL) return failed(code, error);
    out.steps.resize(count);
    if (code == MAPD_CODE_OK) return std::optional<R>(std::move(out));
  }
}

/// Routes: their sums, where their steps end, and these.
template <class R, class F>
Result<std::vector<R>> routes(F call) {
  std::vector<RouteSum> sums(32);
  std::vector<std::size_t> ends(sums.size());
  std::vector<RouteStep> steps(256);
  mapd_error error;
  for (;;) {
    std::size_t count = 0, step_count = 0;
    const mapd_code code = call(sums.data(), ends.data(), sums.size(), &count, steps.data(), steps.size(), &step_count, &error);
    if (code == MAPD_CODE_TOO_SMALL) {
      sums.resize(count > sums.size() ? count : sums.size());
      ends.resize(sums.size());
      steps.resize(step_count > steps.size() ? step_count : steps.size());
      continue;
    }
    if (code != MAPD_CODE_OK) return failed(code, error);
    std::vector<R> out(count);
    std::size_t from = 0;
    for (std::size_t i = 0; i < count; from = ends[i++]) {
      out[i].sum = sums[i];
      out[i].steps.assign(steps.data() + from, steps.data() + ends[i]);
    }
    return out;
  }
}

/// An answer of two lists, `R`'s members `first` and `second`.
template <class R, class A, class B, class F>
Result<R> two_lists(std::vector<A> R::*first, std::vector<B> R::*second, F call) {
  R out;
  std::vector<A>& one = out.*first;
  std::vector<B>& other = out.*second;
  one.resize(64);
  other.resize(64);
  mapd_error error;
  for (;;) {
    std::size_t count = 0, other_count = 0;
    const mapd_code code = call(one.data(), one.size(), &count, other.data(), other.size(), &other_count, &error);
    if (code != MAPD_CODE_OK && code != MAPD_CODE_TOO_SMALL) return failed(code, error);
    one.resize(count);
    other.resize(other_count);
    if (code == MAPD_CODE_OK) return out;
  }
}

/// Pieces that are reached, and links.
template <class R, class F>
Result<R> reach(F call) {
  return two_lists(&R::pieces, &R::links, call);
}

/// Conflicts, and their lanes.
template <class R, class F>
Result<R> conflicts(F call) {
  return two_lists(&R::conflicts, &R::lanes, call);
}

#if MAPD_EXCEPTIONS
inline void must(const Error& error) {
  if (error.code != MAPD_CODE_OK) throw Exception(error);
}
#endif

template <class T, class F>
Result<T> handle(F call) {
  typename T::Raw* raw = nullptr;
  mapd_error error;
  const mapd_code code = call(&raw, &error);
  if (code != MAPD_CODE_OK) return failed(code, error);
  return T(raw);
}

/// Owns a handle of C.
template <class R, void (*close)(R**)>
class Owner {
 public:
  using Raw = R;
  Owner() noexcept = default;
  explicit Owner(R* raw) noexcept : raw_(raw) {}
  Owner(Owner&& other) noexcept : raw_(std::exchange(other.raw_, nullptr)) {}
  Owner& operator=(Owner&& other) noexcept {
    std::swap(raw_, other.raw_);
    return *this;
  }
  Owner(const Owner&) = delete;
  Owner& operator=(const Owner&) = delete;
  ~Owner() { close(&raw_); }
  /// The handle, for calls of C; null once it was moved from.
  R* get() const noexcept { return raw_; }

 private:
  R* raw_ = nullptr;
};

}  // namespace detail

/// Memory of searches and lists, to be used again. It belongs to one thread at a time and to no map.
class Scratch : public detail::Owner<mapd_scratch, mapd_scratch_close> {
 public:
  Scratch() : Owner(make()) {}

 private:
  static mapd_scratch* make() noexcept {
    mapd_scratch* raw = nullptr;
    mapd_scratch_new(&raw, nullptr);
    return raw;
  }
};

/// A route: what it comes to, and its lanes.
struct Route {
  RouteSum sum{};
  std::vector<RouteStep> steps;
};

/// Pieces of lanes that can be reached, and how one goes on from each to others.
struct Reach {
  std::vector<ReachedPiece> pieces;
  std::vector<ReachLink> links;
};

/// Where other traffic meets a path, in ascending S: a range of conflicts, each of some of the lanes.
struct PathConflicts {
  std::vector<PathConflict> conflicts;
  std::vector<ConflictLane> lanes;

  std::size_t size() const noexcept { return conflicts.size(); }
  bool empty() const noexcept { return conflicts.empty(); }
  auto begin() const noexcept { return conflicts.begin(); }
  auto end() const noexcept { return conflicts.end(); }
  const PathConflict& operator[](std::size_t i) const noexcept { return conflicts[i]; }
  /// The lanes of one of the conflicts.
  span<const ConflictLane> lanes_of(const PathConflict& one) const noexcept {
    return {lanes.data() + one.lanes_from, one.lanes_to - one.lanes_from};
  }
};

/// The way of a path on another snapshot, if there is one, and what has changed.
struct Rebased {
  std::optional<Route> route;
  std::vector<PathChange> changes;
};

/// The room of a corridor as one polygon [m], and whether no two of its sides meet but neighbours.
struct Outline {
  std::vector<Vec2> points;
  bool is_simple = false;
};

}  // namespace mapd
