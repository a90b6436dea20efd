// The C++ interface: each call without exceptions, handles that move and copy, ids that compare and hash, errors as values. Built with and
// without exceptions. `surface ARCHIVE OTHER_ARCHIVE`.
#include <mapd.hpp>

#include <cmath>
#include <cstdio>
#include <unordered_set>

namespace {

int failures = 0;

void check(bool holds, const char* what, int line) {
  if (holds) return;
  std::fprintf(stderr, "line %d: %s\n", line, what);
  ++failures;
}

#define CHECK(...) check((__VA_ARGS__), #__VA_ARGS__, __LINE__)

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  auto opened = mapd::Snapshot::try_open(argv[1]);
  auto other = mapd::Snapshot::try_open(argv[2]);
  CHECK(opened && other);
  if (!opened || !other) return 1;
  const mapd::Snapshot map = *std::move(opened);
  mapd::Snapshot copy = map;
  mapd::Snapshot moved = std::move(copy);
  copy = moved;
  CHECK(copy.get() != nullptr && copy.get() != map.get() && moved.try_verify().code == MAPD_CODE_OK);
  mapd::Scratch scratch;

  CHECK(mapd::Snapshot::try_open("/nowhere").code() == MAPD_CODE_FILE);
  CHECK(!mapd::Snapshot::try_open("/nowhere").error().message.empty());
  CHECK(mapd::Client::try_connect("town", 0.0, "nobody-here_").code() == MAPD_CODE_NO_DAEMON);

  const auto hit = map.try_nearest_lane({50.0, -1.75});
  CHECK(hit && *hit);
  if (!hit || !*hit) return 1;
  const mapd::LaneId lane = (*hit)->lane;
  CHECK(map.try_nearest_lane({NAN, 0.0}).code() == MAPD_CODE_NOT_FINITE);
  CHECK(map.try_nearest_lane({1e9, 1e9}) && !*map.try_nearest_lane({1e9, 1e9}));
  CHECK((*other).try_lane(lane).code() == MAPD_CODE_FOREIGN_ID);
  CHECK(*map.try_covers({50.0, -1.75}) && !*map.try_covers({1e9, 0.0}));

  const mapd_point points[] = {mapd::Point(50.0, -1.75), mapd::Point(1e9, 1e9)};
  mapd::Nearest answers[2];
  CHECK(map.try_nearest_lanes(points, answers, scratch).code == MAPD_CODE_OK);
  CHECK(answers[0].lane == lane && !mapd::is_some(answers[1].lane));
  CHECK(map.try_nearest_lanes(points, mapd::span<mapd::Nearest>(answers, 1), scratch).code == MAPD_CODE_TOO_SMALL);

  const auto key = map.try_key(lane);
  CHECK(key && *map.try_lane_by_key(*key) == lane);
  const auto lanes = map.try_lanes();
  CHECK(lanes && lanes->size() > 16);  // more than a list begins with
  std::unordered_set<mapd::LaneId> all(lanes->begin(), lanes->end());
  CHECK(all.size() == lanes->size() && all.count(lane) == 1);
  const auto waypoints = map.try_waypoints(lane, 0.5);
  CHECK(waypoints && waypoints->size() > 16);
  CHECK(map.try_waypoints(lane, 0.0).code() == MAPD_CODE_NOT_FINITE);

  const mapd::Cost cost{MAPD_COST_LENGTH, MAPD_VEHICLE_CLASS_PASSENGER_CAR, 20.0};
  const mapd::PositionOnLane places[] = {{lane, 10.0}, {lane, 40.0}};
  const auto route = map.try_route(places, cost, scratch);
  CHECK(route && *route && !(*route)->steps.empty());
  CHECK(route && *route && std::fabs(*map.try_steps_length((*route)->steps) - (*route)->sum.length) < 1e-9);
  const auto ahead = map.try_lane_sequences(places[0], 100.0, MAPD_VEHICLE_CLASS_PASSENGER_CAR, true, scratch);
  CHECK(ahead && !ahead->sequences.empty() && ahead->sequences[0][0] == lane);
  CHECK(mapd::word(MAPD_WORDS_LANE_TYPE, map.try_lane(lane)->kind) == "driving");

#if MAPD_EXCEPTIONS
  CHECK(map.nearest_lane({50.0, -1.75})->lane == lane && map.key(lane) == *key);
  try {
    other->lane(lane);
    CHECK(false);
  } catch (const mapd::Exception& error) {
    CHECK(error.code() == MAPD_CODE_FOREIGN_ID);
  }
#endif

  // A snapshot that was moved from is closed.
  mapd::Snapshot kept = std::move(moved);
  CHECK(moved.try_lane(lane).code() == MAPD_CODE_NULL_POINTER && kept.try_lane(lane));
  std::printf("%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
