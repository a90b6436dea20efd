// A client of a running service in C++: attach, swap, overlay, end. `service_cpp MAP DAEMON_PID SWAP` ends with the daemon killed.
//
// SWAP is a command that has the daemon serve another content under the same name. What no handle may keep is `attach.cpp`'s.
#include <mapd.hpp>

#include <signal.h>
#include <sys/resource.h>
#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace {

/// How long anything that must happen may take [s].
constexpr double patience = 60.0;
constexpr std::uint8_t car = MAPD_VEHICLE_CLASS_PASSENGER_CAR;
int failures = 0;

#define CHECK(condition)                                                            \
  do {                                                                              \
    if (!(condition)) {                                                             \
      std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);          \
      ++failures;                                                                   \
    }                                                                               \
  } while (0)

/// Whether a call throws this code.
template <class F>
bool throws(mapd_code code, F call) {
  try {
    call();
  } catch (const mapd::Exception& error) {
    return error.code() == code && error.what()[0] != '\0';
  }
  return false;
}

mapd::LaneId lane_at(const mapd::Snapshot& map) {
  const auto hit = map.nearest_lane({50.0, -1.75});
  return hit ? hit->lane : mapd::LaneId{};
}

/// The name of the road that a lane is of.
std::string street(const mapd::Snapshot& map) {
  return std::string(mapd::view(map.road(map.lane(lane_at(map)).road).name));
}

void what_is_not_served_is_refused(const std::string& name) {
  CHECK(throws(MAPD_CODE_NO_SUCH_MAP, [] { mapd::Client::connect("village", 0.2); }));
  CHECK(throws(MAPD_CODE_NO_DAEMON, [&] { mapd::Client::connect(name, 0.2, "mapdcnobody_"); }));
  CHECK(throws(MAPD_CODE_ARGUMENT, [&] { mapd::Client::connect(name, -1.0); }));
}

/// A client takes no place of the map's, but needs a file descriptor at a time.
void without_descriptors_the_code_says_so(const std::string& name) {
  rlimit usual{};
  CHECK(::getrlimit(RLIMIT_NOFILE, &usual) == 0);
  const rlimit none{0, usual.rlim_max};
  CHECK(::setrlimit(RLIMIT_NOFILE, &none) == 0);
  const auto client = mapd::Client::try_connect(name, 0.2);
  CHECK(::setrlimit(RLIMIT_NOFILE, &usual) == 0);
  CHECK(client.code() == MAPD_CODE_NO_DESCRIPTORS && client.error().message.find("file descriptors") != std::string::npos);
}

/// What is proposed is laid over the map: a waiting client is told, views name the entry, and what was held before is as it was.
void overlays_come(const std::string& name) {
  const auto client = mapd::Client::connect(name, patience);
  const auto before = client.snapshot();
  const mapd::PositionOnLane place{lane_at(before), 15.0};
  const auto now = [] { return std::chrono::system_clock::now(); };
  CHECK(before.view(now()).allows(place, car).is_allowed == 1);
  CHECK(!client.wait_change(0.0));
  const auto decision = mapd::propose(
      name, "tests", R"({"id":"cones","kind":"closed","lanes":[{"road":"1","s":[10,20],"lane":-1}]})", patience);
  CHECK(decision.is_accepted == 1);
  CHECK(client.wait_change(patience));
  const auto after = client.snapshot();
  CHECK(after.overlay_revision() > before.overlay_revision());
  const auto today = after.view(now());
  CHECK(today.entries().size() == 1 && mapd::view(today.entries()[0].id) == "proposed/tests/cones");
  CHECK(today.allows(place, car).is_allowed == 0);
  CHECK(today.allows({place.lane, 25.0}, car).is_allowed == 1);
  CHECK(before.view(now()).allows(place, car).is_allowed == 1);
}

/// Threads ask while another content comes; what is held stays, and its ids are refused by the new one.
void swaps_are_seen(const std::string& name, const char* swap) {
  const auto client = mapd::Client::connect(name, patience);
  const auto before = client.snapshot();
  auto events = client.events();
  CHECK(!events.next(0.0));
  CHECK(throws(MAPD_CODE_NO_GENERATION, [&] { client.wait_next(0.0); }));
  const auto lane = lane_at(before);
  const auto name_before = street(before);
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 200; ++k) wrong += lane_at(before) == lane && mapd::is_some(lane_at(client.refresh())) ? 0 : 1;
    });
  }
  CHECK(std::system(swap) == 0);
  for (auto& thread : threads) thread.join();
  CHECK(wrong == 0);
  const auto event = events.next(patience);
  CHECK(event && event->kind == MAPD_EVENT_GENERATION);
  const auto after = client.refresh();
  CHECK(event && event->generation == client.generation() && after.facts().generation == client.generation());
  CHECK(street(before) == name_before && street(after) != name_before);
  CHECK(throws(MAPD_CODE_FOREIGN_ID, [&] { after.lane(lane); }));
  const auto again = after.lane_by_key(before.key(lane));
  CHECK(again && after.key(*again) == before.key(lane));
  CHECK(throws(MAPD_CODE_SUPERSEDED, [&] { client.require(before.facts().generation, 1.0); }));
}

/// What is held outlives its client and the daemon.
void the_end_is_seen(const std::string& name, pid_t daemon) {
  std::optional<mapd::Snapshot> held;
  {
    const auto client = mapd::Client::connect(name, patience);
    auto events = client.events();
    held = client.snapshot();
    CHECK(client.served_by() == static_cast<std::uint32_t>(daemon));
    const auto age = client.heartbeat_age();
    CHECK(age && *age >= 0.0 && *age < patience);
    CHECK(::kill(daemon, SIGKILL) == 0);
    const auto event = events.next(patience);
    CHECK(event && event->kind == MAPD_EVENT_DAEMON_GONE);
    CHECK(!client.served_by());
    CHECK(throws(MAPD_CODE_NO_GENERATION, [&] { client.wait_next(0.0); }));
    CHECK(client.refresh().facts().generation == held->facts().generation);
  }
  CHECK(mapd::is_some(lane_at(*held)));
  held->verify();
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) return EXIT_FAILURE;
  const std::string name = argv[1];
  CHECK(mapd::Client::connect(name, patience).generation() >= 1);
  what_is_not_served_is_refused(name);
  without_descriptors_the_code_says_so(name);
  overlays_come(name);
  swaps_are_seen(name, argv[3]);
  the_end_is_seen(name, static_cast<pid_t>(std::atoi(argv[2])));
  std::printf("service in C++: %d failures\n", failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return EXIT_FAILURE;
}
