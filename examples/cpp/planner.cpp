// A planner's cycle: wait for the map, find the lane, find a route, and ask it as a path: where am I, what is the room, what lies ahead, until
// when must I change lanes, who has to give way and where. When the map is swapped, the path is found again on the new one. Says word for word
// what the Rust example of this name says.
//
// planner MAP X Y ROAD S LANE [GENERATIONS]: from a point to a place; ends after so many generations (default 1).
#include <mapd.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

namespace {

// How long the map may take to come [s].
constexpr double patience = 30.0;
// The room that is asked for [m].
constexpr double horizon = 150.0;
// Deviations of x, y [m] and heading [rad]: one that large says that the heading is not known.
constexpr double deviation = 0.5, heading_deviation = 10.0;
// What drives, by time; a change of lane counts as 2 s.
constexpr std::uint8_t car = MAPD_VEHICLE_CLASS_PASSENGER_CAR;
constexpr mapd::Cost by_time{MAPD_COST_TIME, car, 2.0};
constexpr const char* yields[] = {"yields", "priority", "lights", "unknown"};

/// What is asked for, and what is kept from cycle to cycle: memory, and the way to the goal.
class Planner {
 public:
  Planner(mapd::Vec2 start, std::string road, double s, int lane)
      : start_(start), road_(std::move(road)), s_(s), lane_(lane) {}

  /// The route from the most probable lane that leads to the goal.
  void find(const mapd::Snapshot& map) {
    const auto road = map.road_by_id(road_);
    const auto goal = road ? map.lane_numbered(*road, s_, lane_) : std::nullopt;
    if (!goal) throw std::runtime_error("no such goal");
    mapd::MatchOptions options;
    options.has_vehicle = 1;
    options.vehicle = car;
    const double position = deviation * deviation, turn = heading_deviation * heading_deviation;
    const mapd::Covariance covariance{position, 0, 0, 0, position, 0, 0, 0, turn};
    const auto match = map.match_pose({mapd::Point(start_), 0.0}, covariance, scratch_, options);
    for (const auto& one : match.lanes) {
      const mapd::PositionOnLane places[] = {{one.lane, one.position.s}, {*goal, s_}};
      if (auto route = map.route(places, by_time, scratch_)) {
        path_ = map.path(route->steps);
        return;
      }
    }
    throw std::runtime_error("no way there");
  }

  /// The route along the same lanes on another map, or anew where none is left. The path keeps the old one.
  void find_again(const mapd::Snapshot& map) {
    const auto found = path_->rebase(map, by_time, scratch_);
    std::printf("another map: %zu stretches of the path have changed\n", found.changes.size());
    for (const auto& one : found.changes) {
      std::printf("S = %.1f to %.1f m: ", one.along_from, one.along_to);
      switch (one.kind) {
        case MAPD_PATH_CHANGE_MOVED: std::printf("moved by %.2f m\n", one.distance); break;
        case MAPD_PATH_CHANGE_REPLACED: std::printf("another lane, %.2f m beside\n", one.distance); break;
        default: std::printf("gone\n");
      }
    }
    if (found.route) {
      path_ = map.path(found.route->steps);
    } else {
      find(map);
    }
  }

  /// What a planner asks in each cycle.
  void look_along(const mapd::Snapshot& map) {
    const mapd::Path& path = *path_;
    const double length = path.length();
    std::printf("%.1f m, %.1f s, %zu joints\n", length, path.travel_time(0.0, length).time, path.joints().size());

    const auto own = path.project(start_);
    std::printf("at S = %.2f m, %.2f m left of the line\n", own.along, own.d);
    const auto room = path.corridor(own.along, horizon, 1.0, car, scratch_);
    double narrowest = INFINITY;
    for (const auto& one : room) {
      const double x = one.left.x - one.right.x, y = one.left.y - one.right.y, z = one.left.z - one.right.z;
      narrowest = std::min(narrowest, std::sqrt(x * x + y * y + z * z));
    }
    std::printf("the lane is at least %.2f m wide over %zu stations\n", narrowest, room.size());
    if (const auto rule = path.speed_at(own.along); rule && rule->has_max) std::printf("limit %.1f m/s\n", rule->max);

    for (const auto& one : path.facts(scratch_)) {
      if (one.along_from < own.along || one.kind != MAPD_PATH_FACT_SIGNAL || !one.governs) continue;
      const auto signal = map.signal(one.signal);
      const std::string name(mapd::word(MAPD_WORDS_CLASS, signal.class_code)), id(mapd::view(signal.id));
      std::printf("S = %.1f m: signal %s, %s\n", one.along_from, id.c_str(), name.c_str());
    }
    for (const auto& one : path.segments(car, scratch_)) {
      if (!one.driven || one.changes == 0) continue;
      std::printf("lane %s: %u changes left, the next until S = %.1f m\n", map.key(one.lane).c_str(), one.changes,
                  one.last_change);
    }
    for (const auto& one : path.conflicts(scratch_)) {
      if (one.yields == MAPD_YIELDS_PRIORITY) continue;
      std::printf("S = %.1f m: lane %s, %s; wait at %.1f m\n", one.along_from, map.key(one.other).c_str(),
                  yields[one.yields], one.wait);
    }
  }

 private:
  mapd::Vec2 start_;
  std::string road_;
  double s_;
  int lane_;
  mapd::Scratch scratch_;
  std::optional<mapd::Path> path_;
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 7 && argc != 8) {
    std::fprintf(stderr, "usage: planner MAP X Y ROAD S LANE [GENERATIONS]\n");
    return 1;
  }
  Planner planner({std::stod(argv[2]), std::stod(argv[3])}, argv[4], std::stod(argv[5]), std::stoi(argv[6]));
  const int generations = argc == 8 ? std::stoi(argv[7]) : 1;
  const auto client = mapd::Client::connect(argv[1], patience);
  auto map = client.snapshot();
  planner.find(map);
  planner.look_along(map);
  for (int number = 1; number < generations; ++number) {
    map = client.wait_next(patience);
    planner.find_again(map);
    planner.look_along(map);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
