// A node with a timer, as ROS 2 has them, without ROS: where am I, how fast may I go, what is ahead within 100 m?
//
// what_is_ahead MAP X Y HEADING [CYCLES]: a cycle each 100 ms, one by default.
#include <mapd.hpp>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

namespace {

/// Calls back once a period, as `create_wall_timer` does: a cycle that takes longer puts none off for ever.
class Timer {
 public:
  explicit Timer(std::chrono::milliseconds period) : period_(period), next_(std::chrono::steady_clock::now()) {}

  template <class Callback>
  void spin(int cycles, Callback callback) {
    for (int cycle = 0; cycle < cycles; ++cycle) {
      std::this_thread::sleep_until(next_);
      next_ += period_;
      callback();
    }
  }

 private:
  std::chrono::milliseconds period_;
  std::chrono::steady_clock::time_point next_;
};

/// The node: made once, asked in each cycle.
class Planner {
 public:
  explicit Planner(const std::string& map) : client_(mapd::Client::connect(map, 30.0)), map_(client_.snapshot()) {}

  void cycle(double x, double y, double heading) {
    map_ = client_.refresh();  // a newer map, if there is one; what was taken from the old one stays good while it is held
    mapd::NearestOptions options;
    options.types = mapd_lane_types_routable();
    options.heading = heading;
    options.heading_tolerance = 1.0;
    const auto here = map_.nearest_lane({x, y}, options);
    if (!here) {
      std::printf("off the road\n");
      return;
    }
    const auto limit = map_.speed_rule_at(here->lane, here->position.s);
    std::printf("lane %s, s = %.2f m, %.2f m left of its centre", map_.key(here->lane).c_str(), here->position.s,
                here->position.offset);
    if (limit.has_max) std::printf(", limit %.1f m/s", limit.max);
    std::printf("\n");

    const mapd::PositionOnLane place{here->lane, here->position.s};
    if (const auto junction = map_.next_junction(place, 100.0, MAPD_VEHICLE_CLASS_PASSENGER_CAR)) {
      const std::string id(mapd::view(map_.junction(junction->junction).id));
      std::printf("junction %s in %.1f m\n", id.c_str(), junction->distance);
    }
    for (const auto& ahead : map_.signals_ahead(place, 100.0, MAPD_VEHICLE_CLASS_PASSENGER_CAR, scratch_)) {
      const auto signal = map_.signal(ahead.signal);
      const std::string what(mapd::word(MAPD_WORDS_CLASS, signal.class_code));
      const std::string id(mapd::view(signal.id));
      std::printf("%s %s in %.1f m\n", what.c_str(), id.c_str(), ahead.distance);
    }
  }

 private:
  mapd::Client client_;
  mapd::Snapshot map_;
  mapd::Scratch scratch_;
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5 && argc != 6) {
    std::fprintf(stderr, "usage: what_is_ahead MAP X Y HEADING [CYCLES]\n");
    return 1;
  }
  Planner planner(argv[1]);
  const double x = std::stod(argv[2]), y = std::stod(argv[3]), heading = std::stod(argv[4]);
  Timer(std::chrono::milliseconds(100)).spin(argc == 6 ? std::stoi(argv[5]) : 1, [&] { planner.cycle(x, y, heading); });
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
