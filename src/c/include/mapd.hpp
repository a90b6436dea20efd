/// mapd for C++17: attach to a served map, or open a .mapd file, and query its lanes in place.
///
/// On top of `mapd.h`, which documents units, signs and errors of each call. `try_f` returns a `Result`; `f` throws an `Exception` instead and is
/// there where the program is built with exceptions. Ids, facts and answers are the plain structs of C: doubles side by side, so that
/// `Eigen::Map<const Eigen::Vector3d>(&pose.position.x)` and the like work.
///
/// Threads: `Client`, `Snapshot`, `View`, `Path` and `Projector` may be used by several threads at once; a `Scratch`, a `Tracker` and `Events` by one at a time. A text that an
/// answer points to (`view`) is there as long as a snapshot of that content is.
#pragma once

#include "mapd/base.hpp"
#include "mapd/path.hpp"
#include "mapd/queries.hpp"
#include "mapd/tracker.hpp"
#include "mapd/view.hpp"

namespace mapd {

/// One generation of a map, pinned: readable as long as any copy is held, whatever becomes of daemon, client and file.
class Snapshot : public Queries {
 public:
  using Queries::Queries;
  Snapshot(Snapshot&&) noexcept = default;
  Snapshot& operator=(Snapshot&&) noexcept = default;
  Snapshot(const Snapshot& other) : Queries(copy(other.get())) {}
  Snapshot& operator=(const Snapshot& other) {
    Queries::operator=(Snapshot(other));
    return *this;
  }

  /// Opens a `.mapd` file in place.
  static Result<Snapshot> try_open(const std::string& path) {
    return detail::handle<Snapshot>([&](auto... out) { return mapd_snapshot_open(path.c_str(), out...); });
  }
  /// The same, if the file is signed with the key in the file `key` (minisign); the signature is next to the archive.
  static Result<Snapshot> try_open_trusted(const std::string& path, const std::string& key) {
    return detail::handle<Snapshot>(
        [&](auto... out) { return mapd_snapshot_open_trusted(path.c_str(), key.c_str(), out...); });
  }
  /// An archive in memory, which is copied.
  static Result<Snapshot> try_from_bytes(span<const std::uint8_t> bytes) {
    return detail::handle<Snapshot>([&](auto... out) { return mapd_snapshot_from_bytes(bytes.data(), bytes.size(), out...); });
  }
#if MAPD_EXCEPTIONS
  static Snapshot from_bytes(span<const std::uint8_t> bytes) { return try_from_bytes(bytes).value(); }
  static Snapshot open(const std::string& path) { return try_open(path).value(); }
  static Snapshot open_trusted(const std::string& path, const std::string& key) {
    return try_open_trusted(path, key).value();
  }
#endif

  /// The same map under an overlay that the crate mapd-overlay encoded for it.
  Result<Snapshot> try_with_overlay(span<const std::uint8_t> bytes) const {
    return detail::handle<Snapshot>(
        [&](auto... out) { return mapd_snapshot_with_overlay(get(), bytes.data(), bytes.size(), out...); });
  }
#if MAPD_EXCEPTIONS
  Snapshot with_overlay(span<const std::uint8_t> bytes) const { return try_with_overlay(bytes).value(); }
#endif

  /// Proves the whole archive.
  Error try_verify() const {
    mapd_error error;
    const mapd_code code = mapd_snapshot_verify(get(), &error);
    return code == MAPD_CODE_OK ? Error{} : detail::failed(code, error);
  }
  /// Maps every page of the archive into this process now, so that no query waits for the kernel.
  Error try_populate() const {
    mapd_error error;
    const mapd_code code = mapd_snapshot_populate(get(), &error);
    return code == MAPD_CODE_OK ? Error{} : detail::failed(code, error);
  }
#if MAPD_EXCEPTIONS
  void verify() const {
    detail::must(try_verify());
  }
  void populate() const { detail::must(try_populate()); }
#endif

  /// The lane's stable name.
  Result<std::string> try_key(LaneId lane) const {
    std::string out(32, '\0');
    mapd_error error;
    for (;;) {
      std::size_t length = 0;
      const mapd_code code = mapd_lane_key(get(), lane, out.data(), out.size() + 1, &length, &error);
      out.resize(length);
      if (code == MAPD_CODE_OK) return out;
      if (code != MAPD_CODE_TOO_SMALL) return detail::failed(code, error);
    }
  }
#if MAPD_EXCEPTIONS
  std::string key(LaneId lane) const { return try_key(lane).value(); }
#endif

  /// The lanes that a vehicle may be in by a measured pose, the most probable first.
  Result<PoseMatch> try_match_pose(const VehiclePose& pose, const Covariance& covariance, Scratch& scratch,
                                   const MatchOptions& options = {}) const {
    PoseMatch match;
    auto lanes = detail::list<LaneMatch>([&](auto out, auto capacity, auto count, auto error) {
      return mapd_match_pose(get(), pose, covariance.data(), &options, scratch.get(), out, capacity, count, &match.none,
                             error);
    });
    if (!lanes) return lanes.error();
    match.lanes = *std::move(lanes);
    return match;
  }
  /// The same of many poses; there is one covariance for all of them, or one for each.
  Result<PoseMatches> try_match_poses(span<const VehiclePose> poses, span<const Covariance> covariances,
                                      Scratch& scratch, const MatchOptions& options = {}) const {
    PoseMatches match;
    match.ends.resize(poses.size());
    match.none.resize(poses.size());
    const double* numbers = covariances.empty() ? nullptr : covariances[0].data();
    auto lanes = detail::list<LaneMatch>([&](auto out, auto capacity, auto count, auto error) {
      return mapd_match_pose_batch(get(), poses.data(), poses.size(), numbers, covariances.size(), &options,
                                   scratch.get(), out, capacity, count, match.ends.data(), match.none.data(), error);
    });
    if (!lanes) return lanes.error();
    match.lanes = *std::move(lanes);
    return match;
  }
#if MAPD_EXCEPTIONS
  PoseMatches match_poses(span<const VehiclePose> poses, span<const Covariance> covariances, Scratch& scratch,
                          const MatchOptions& options = {}) const {
    return try_match_poses(poses, covariances, scratch, options).value();
  }
  PoseMatch match_pose(const VehiclePose& pose, const Covariance& covariance, Scratch& scratch,
                       const MatchOptions& options = {}) const {
    return try_match_pose(pose, covariance, scratch, options).value();
  }
#endif

  /// How a vehicle stands on the ground below its four wheels.
  Result<std::optional<Stance>> try_stance_at(const VehiclePose& pose, const std::array<Vec2, 4>& wheels, Scratch& scratch, span<const LaneId> expected = {}) const {
    return detail::optional<Stance>([&](auto... out) { return mapd_stance_at(get(), pose, wheels.data(), expected.data(), expected.size(), scratch.get(), out...); });
  }
  /// Whether a point lies on a lane; a point with z only on one within the tolerance [m], if any is given.
  Result<bool> try_covers(Point point, std::optional<double> z_tolerance = std::nullopt) const {
    std::uint8_t out = 0;
    mapd_error error;
    const mapd_code code = mapd_covers(get(), point, z_tolerance.value_or(-1.0), &out, &error);
    if (code != MAPD_CODE_OK) return detail::failed(code, error);
    return out != 0;
  }
#if MAPD_EXCEPTIONS
  std::optional<Stance> stance_at(const VehiclePose& pose, const std::array<Vec2, 4>& wheels, Scratch& scratch, span<const LaneId> expected = {}) const { return try_stance_at(pose, wheels, scratch, expected).value(); }
  bool covers(Point point, std::optional<double> z_tolerance = std::nullopt) const {
    return try_covers(point, z_tolerance).value();
  }
#endif

  /// The path along a route's steps.
  Result<Path> try_path(span<const RouteStep> steps, const PathOptions& options = {}) const {
    return detail::handle<Path>(
        [&](auto... out) { return mapd_path_new(get(), steps.data(), steps.size(), &options, out...); });
  }
  /// The map under what is laid over it, at a moment.
  Result<View> try_view(std::chrono::system_clock::time_point at) const { return try_view(View::seconds(at)); }
  /// The same at a moment in seconds since 1970-01-01 00:00 UTC.
  Result<View> try_view(double at_s) const {
    return detail::handle<View>([&](auto... out) { return mapd_view_new(get(), at_s, out...); });
  }
#if MAPD_EXCEPTIONS
  Path path(span<const RouteStep> steps, const PathOptions& options = {}) const {
    return try_path(steps, options).value();
  }
  View view(std::chrono::system_clock::time_point at) const { return try_view(at).value(); }
  View view(double at_s) const { return try_view(at_s).value(); }
#endif

  /// The next of these sequences, by the same scratch; none after the last one.
  Result<std::optional<std::vector<LaneId>>> try_next_sequence(Scratch& scratch) const {
    std::vector<LaneId> lanes(64);
    mapd_error error;
    for (;;) {
      std::size_t count = 0;
      const mapd_code code = mapd_next_sequence(scratch.get(), lanes.data(), lanes.size(), &count, &error);
      if (code == MAPD_CODE_NONE) return std::optional<std::vector<LaneId>>();
      if (code != MAPD_CODE_OK && code != MAPD_CODE_TOO_SMALL) return detail::failed(code, error);
      lanes.resize(count);
      if (code == MAPD_CODE_OK) return std::optional<std::vector<LaneId>>(std::move(lanes));
    }
  }
#if MAPD_EXCEPTIONS
  std::optional<std::vector<LaneId>> next_sequence(Scratch& scratch) const { return try_next_sequence(scratch).value(); }
#endif

  /// What converts between this map's inertial frame and WGS 84.
  Result<Projector> try_projector() const {
    return detail::handle<Projector>([&](auto... out) { return mapd_projector_new(get(), out...); });
  }
  /// The same of the file's own frame, of a map that was compiled into another one.
  Result<Projector> try_file_projector() const {
    return detail::handle<Projector>([&](auto... out) { return mapd_projector_of_file(get(), out...); });
  }
#if MAPD_EXCEPTIONS
  Projector projector() const { return try_projector().value(); }
  Projector file_projector() const { return try_file_projector().value(); }
#endif

 private:
  static mapd_snapshot* copy(const mapd_snapshot* other) noexcept {
    mapd_snapshot* raw = nullptr;
    mapd_snapshot_clone(other, &raw, nullptr);
    return raw;
  }
};

/// A follower of a map. It belongs to one thread at a time and keeps its client.
class Events : public detail::Owner<mapd_events, mapd_events_close> {
 public:
  using Owner::Owner;

  /// The next event; waits at most `wait_s` [s]. None: no event.
  Result<std::optional<Event>> try_next(double wait_s) {
    return detail::optional<Event>([&](auto... out) { return mapd_events_next(get(), wait_s, out...); });
  }
#if MAPD_EXCEPTIONS
  std::optional<Event> next(double wait_s) { return try_next(wait_s).value(); }
#endif
};

/// A connection to one served map.
class Client : public detail::Owner<mapd_client, mapd_client_close> {
 public:
  using Owner::Owner;

  /// Connects to the map of this name, whichever side starts first; waits at most `wait_s` [s]. Without a prefix: the one of MAPD_PREFIX, else the
  /// default one. MAPD_OWNER names the user whose daemon is trusted, whatever the prefix.
  static Result<Client> try_connect(const std::string& map, double wait_s, const char* prefix = nullptr) {
    return detail::handle<Client>(
        [&](auto... out) { return mapd_client_connect(map.c_str(), prefix, wait_s, out...); });
  }
  /// The newest generation that this client has seen. Does not look for a newer one.
  Result<Snapshot> try_snapshot() const {
    return detail::handle<Snapshot>([&](auto... out) { return mapd_client_snapshot(get(), out...); });
  }
  /// Looks for a newer generation without waiting and returns the newest.
  Result<Snapshot> try_refresh() const {
    return detail::handle<Snapshot>([&](auto... out) { return mapd_client_refresh(get(), out...); });
  }
  /// Waits at most `wait_s` [s] for a generation newer than the newest that this client has seen.
  Result<Snapshot> try_wait_next(double wait_s) const {
    return detail::handle<Snapshot>([&](auto... out) { return mapd_client_wait_next(get(), wait_s, out...); });
  }
  /// Waits at most `wait_s` [s] for another generation or another overlay. Returns whether one has come.
  Result<bool> try_wait_change(double wait_s) const {
    const auto found =
        detail::value<std::uint8_t>([&](auto... out) { return mapd_client_wait_change(get(), wait_s, out...); });
    if (!found) return found.error();
    return *found != 0;
  }
  /// Waits at most `wait_s` [s] for the generation with this number.
  Result<Snapshot> try_require(std::uint64_t generation, double wait_s) const {
    return detail::handle<Snapshot>([&](auto... out) { return mapd_client_require(get(), generation, wait_s, out...); });
  }
  /// Number of the newest generation that this client has seen.
  Result<std::uint64_t> try_generation() const {
    return detail::value<std::uint64_t>([&](auto... out) { return mapd_client_generation(get(), out...); });
  }
  /// The generation that is staged, if any.
  Result<std::optional<Generation>> try_pending() const {
    return detail::optional<Generation>([&](auto... out) { return mapd_client_pending(get(), out...); });
  }
  /// The process that serves the map now, if any.
  Result<std::optional<std::uint32_t>> try_served_by() const {
    return detail::optional<std::uint32_t>([&](auto... out) { return mapd_client_served_by(get(), out...); });
  }
  /// Time since the heartbeat of the daemon that serves the map [s], of which there is about one a second; none if it is no longer served.
  Result<std::optional<double>> try_heartbeat_age() const {
    return detail::optional<double>([&](auto... out) { return mapd_client_heartbeat_age(get(), out...); });
  }
  /// Whether generations are mapped page by page before they are handed out, so that no query waits for the kernel.
  Error try_set_populate(bool populate) const {
    mapd_error error;
    const mapd_code code = mapd_client_set_populate(get(), populate ? 1 : 0, &error);
    return code == MAPD_CODE_OK ? Error{} : detail::failed(code, error);
  }
  /// Follows the map from now on.
  Result<Events> try_events() const {
    return detail::handle<Events>([&](auto... out) { return mapd_events_new(get(), out...); });
  }
#if MAPD_EXCEPTIONS
  static Client connect(const std::string& map, double wait_s, const char* prefix = nullptr) {
    return try_connect(map, wait_s, prefix).value();
  }
  Snapshot snapshot() const { return try_snapshot().value(); }
  Snapshot refresh() const { return try_refresh().value(); }
  Snapshot wait_next(double wait_s) const { return try_wait_next(wait_s).value(); }
  bool wait_change(double wait_s) const { return try_wait_change(wait_s).value(); }
  Snapshot require(std::uint64_t generation, double wait_s) const { return try_require(generation, wait_s).value(); }
  std::uint64_t generation() const { return try_generation().value(); }
  std::optional<Generation> pending() const { return try_pending().value(); }
  std::optional<std::uint32_t> served_by() const { return try_served_by().value(); }
  std::optional<double> heartbeat_age() const { return try_heartbeat_age().value(); }
  void set_populate(bool populate) const { detail::must(try_set_populate(populate)); }
  Events events() const { return try_events().value(); }
#endif
};

/// Proposes an entry of an overlay (JSON) to the daemon that serves a map, and waits at most `wait_s` [s] for its decision; `source` is what this
/// process calls itself. A refusal is an error, whose message is the reason.
inline Result<Decision> try_propose(const std::string& map, const std::string& source, const std::string& entry, double wait_s,
                                    const char* prefix = nullptr) {
  return detail::value<Decision>([&](auto... out) {
    return mapd_propose(map.c_str(), prefix, source.c_str(), entry.c_str(), wait_s, out...);
  });
}
#if MAPD_EXCEPTIONS
inline Decision propose(const std::string& map, const std::string& source, const std::string& entry, double wait_s,
                        const char* prefix = nullptr) {
  return try_propose(map, source, entry, wait_s, prefix).value();
}
#endif

/// The word of a code; vocabulary is a MAPD_WORDS_…. Empty for an unknown vocabulary.
inline std::string_view word(std::uint32_t vocabulary, std::uint16_t code) noexcept {
  mapd_text out{"", 0};
  mapd_word(vocabulary, code, &out, nullptr);
  return view(out);
}

/// The release of the library, such as `0.1.0`.
inline std::string_view version() noexcept { return view(mapd_version()); }

/// Bits of the lane types that the lane graph opens to motor vehicles, for `NearestOptions::types`.
inline std::uint64_t lane_types_drivable() noexcept { return mapd_lane_types_drivable(); }
/// Bits of the lane types that routes lead over.
inline std::uint64_t lane_types_routable() noexcept { return mapd_lane_types_routable(); }

/// The classes that localisers use.
inline ClassSet class_set_landmarks() noexcept { return mapd_class_set_landmarks(); }

}  // namespace mapd

// Ids compare and hash.
#define MAPD_ID(Id)                                                                                                  \
  constexpr bool operator==(const Id& a, const Id& b) noexcept {                                                     \
    return a.row == b.row && a.tile == b.tile && a.content == b.content;                                             \
  }                                                                                                                  \
  constexpr bool operator!=(const Id& a, const Id& b) noexcept { return !(a == b); }                                \
  template <>                                                                                                        \
  struct std::hash<Id> {                                                                                             \
    std::size_t operator()(const Id& id) const noexcept {                                                            \
      return std::hash<std::uint64_t>()(id.content ^ (std::uint64_t{id.tile} << 32 | id.row));                       \
    }                                                                                                                \
  };
MAPD_ID(mapd_road_id)
MAPD_ID(mapd_lane_id)
MAPD_ID(mapd_junction_id)
MAPD_ID(mapd_node_id)
MAPD_ID(mapd_signal_id)
MAPD_ID(mapd_object_id)
#undef MAPD_ID
constexpr bool operator==(const mapd_placement_id& a, const mapd_placement_id& b) noexcept {
  return a.object == b.object && a.copy == b.copy;
}
constexpr bool operator!=(const mapd_placement_id& a, const mapd_placement_id& b) noexcept { return !(a == b); }
template <>
struct std::hash<mapd_placement_id> {
  std::size_t operator()(const mapd_placement_id& id) const noexcept {
    // The object's hash has row and content; an odd factor spreads its copies.
    return std::hash<mapd_object_id>()(id.object) ^ std::hash<std::uint64_t>()(id.copy * 0x9e3779b97f4a7c15U);
  }
};
