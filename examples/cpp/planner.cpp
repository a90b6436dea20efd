// A planner's cycle: wait for the map, find the lane, find a route, and ask it as a path: where am I, what is the room, who has to
// give way and where, how fast. Follows the map when it is swapped. Says what the Rust example of this name says of a path without
// signals and changes of lane; after a swap it finds its route anew.
//
// planner MAP X Y ROAD S LANE [GENERATIONS]: from a point to a place; ends after so many generations (default 1).
#include <mapd.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace {

// How long the map may take to come [s].
constexpr double patience = 30.0;
// The room that is asked for [m].
constexpr double horizon = 150.0;
constexpr std::uint8_t car = MAPD_VEHICLE_CLASS_PASSENGER_CAR;
constexpr const char* yields[] = {"yields", "priority", "lights", "open", "unknown"};

/// What is asked for, and the memory that is kept from cycle to cycle.
class Planner {
 public:
  Planner(mapd::Vec2 start, std::string road, double s, int lane)
      : start_(start), road_(std::move(road)), s_(s), lane_(lane) {}

  void plan(const mapd::Snapshot& map) {
    mapd::NearestOptions options;
    options.types = mapd_lane_types_drivable();
    const auto here = map.nearest_lane(start_, options);
    if (!here) throw std::runtime_error("no lane is near");
    const auto road = map.road_by_id(road_);
    const auto goal = road ? map.lane_numbered(*road, s_, lane_) : std::nullopt;
    if (!goal) throw std::runtime_error("no such goal");
    const mapd::PositionOnLane places[] = {{here->lane, here->position.s}, {*goal, s_}};
    const auto route = map.route(places, {MAPD_COST_TIME, car, 2.0}, scratch_);
    if (!route) throw std::runtime_error("no way there");
    const auto path = map.path(route->steps);
    std::printf("%.1f m, %.1f s, %zu joints\n", path.length(), route->sum.travel_time, path.joints().size());

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
  for (int number = 1; number <= generations; ++number) {
    planner.plan(map);
    // Ids belong to one content; everything is found again on the new one.
    if (number < generations) map = client.wait_next(patience);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
