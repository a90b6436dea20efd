// The C++ interface: each call without exceptions, handles that move and copy, ids that compare and hash, errors as values. Built with and
// without exceptions. `surface ARCHIVE OTHER_ARCHIVE ARCHIVE_ON_EARTH ARCHIVE_WITH_GRID`: the third
// is of a map with a projection, the last of examples/maps/surfaces.xodr, whose junction has a grid of elevations.
#include <mapd.hpp>

#include <cmath>
#include <cstdio>
#include <type_traits>
#include <unordered_set>

namespace {

// Numbers that belong together are doubles side by side: what `Eigen::Map<const Eigen::Vector3d>(&pose.position.x)` relies on.
template <class T>
constexpr bool is_plain = std::is_trivially_copyable_v<T> && std::is_standard_layout_v<T> && alignof(T) == alignof(double);
static_assert(is_plain<mapd::Vec2> && sizeof(mapd::Vec2) == 2 * sizeof(double));
static_assert(offsetof(mapd::Vec2, x) == 0 && offsetof(mapd::Vec2, y) == sizeof(double));
static_assert(is_plain<mapd::Vec3> && sizeof(mapd::Vec3) == 3 * sizeof(double));
static_assert(offsetof(mapd::Vec3, x) == 0 && offsetof(mapd::Vec3, y) == sizeof(double) && offsetof(mapd::Vec3, z) == 2 * sizeof(double));
static_assert(is_plain<mapd::Track> && sizeof(mapd::Track) == 3 * sizeof(double));
static_assert(offsetof(mapd::Track, s) == 0 && offsetof(mapd::Track, t) == sizeof(double) && offsetof(mapd::Track, h) == 2 * sizeof(double));
static_assert(is_plain<mapd::Pose> && std::is_same_v<decltype(mapd::Pose::position), mapd::Vec3>);
static_assert(is_plain<mapd::Geodetic> && sizeof(mapd::Geodetic) == 3 * sizeof(double));
static_assert(std::is_same_v<mapd::Covariance, std::array<double, 9>> && sizeof(mapd::Covariance) == 9 * sizeof(double));

int failures = 0;

void check(bool holds, const char* what, int line) {
  if (holds) return;
  std::fprintf(stderr, "line %d: %s\n", line, what);
  ++failures;
}

#define CHECK(...) check((__VA_ARGS__), #__VA_ARGS__, __LINE__)

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 1;
  auto opened = mapd::Snapshot::try_open(argv[1]);
  auto other = mapd::Snapshot::try_open(argv[2]);
  auto placed = mapd::Snapshot::try_open(argv[3]);
  auto grid = mapd::Snapshot::try_open(argv[4]);
  CHECK(opened && other && placed && grid);
  if (!opened || !other || !placed || !grid) return 1;
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

  // A list into a vector of the caller's: its memory grows where it must, then stays, and C is asked once.
  {
    const auto all = map.try_lanes();
    CHECK(all && all->size() > 16);
    std::vector<mapd::LaneId> lanes;
    CHECK(map.try_lanes(lanes).code == MAPD_CODE_OK && all && lanes == *all);
    const mapd::LaneId* memory = lanes.data();
    CHECK(map.try_successors(lane, lanes).code == MAPD_CODE_OK && lanes.size() < 16 && lanes.data() == memory);
    CHECK(map.try_lanes(lanes).code == MAPD_CODE_OK && all && lanes == *all && lanes.data() == memory);
    int asked = 0;
    const auto counted = [&](auto... rest) { return ++asked, mapd_lanes(map.get(), rest...); };
    CHECK(mapd::detail::list_into(lanes, counted).code == MAPD_CODE_OK && asked == 1);
    CHECK(map.try_successors({}, lanes).code == MAPD_CODE_FOREIGN_ID && lanes.empty());
  }
  CHECK(map.try_nearest_lane({NAN, 0.0}).code() == MAPD_CODE_NOT_FINITE);
  CHECK(map.try_nearest_lane({1e9, 1e9}) && !*map.try_nearest_lane({1e9, 1e9}));
  CHECK((*other).try_lane(lane).code() == MAPD_CODE_FOREIGN_ID);
  CHECK(*map.try_covers({50.0, -1.75}) && !*map.try_covers({1e9, 0.0}));

  const mapd_point points[] = {mapd::Point(50.0, -1.75), mapd::Point(1e9, 1e9)};
  mapd::Nearest answers[2];
  CHECK(map.try_nearest_lanes(points, answers, scratch).code == MAPD_CODE_OK);
  CHECK(answers[0].lane == lane && !mapd::is_some(answers[1].lane));
  CHECK(map.try_nearest_lanes(points, mapd::span<mapd::Nearest>(answers, 1), scratch).code == MAPD_CODE_TOO_SMALL);

  // Two thirds of the vehicle on the right of the line, one on the left; nothing is known of its heading, so that both ways count.
  mapd::MatchOptions of_vehicle;
  of_vehicle.outline = {2.0, 1.0, 0.6, 1.2};
  const auto shared = map.try_match_pose({mapd::Point(50.0, 0.0), 0.0}, {0, 0, 0, 0, 0, 0, 0, 0, 1e6}, scratch, of_vehicle);
  CHECK(shared && shared->lanes.size() > 1);
  CHECK(std::abs(shared->lanes[0].probability / shared->lanes[1].probability - 2.0) < 1e-3);

  const auto key = map.try_key(lane);
  CHECK(key && *map.try_lane_by_key(*key) == lane);
  const auto lanes = map.try_lanes();
  CHECK(lanes && lanes->size() > 16);  // more than a list begins with
  std::unordered_set<mapd::LaneId> all(lanes->begin(), lanes->end());
  CHECK(all.size() == lanes->size() && all.count(lane) == 1);
  const mapd::Region everywhere{{-1e6, -1e6}, {1e6, 1e6}};
  const auto places_of_objects = other->try_objects_in(everywhere, scratch);
  CHECK(places_of_objects && places_of_objects->size() > 1);
  const std::unordered_set<mapd::PlacementId> placed_once(places_of_objects->begin(), places_of_objects->end());
  CHECK(placed_once.size() == places_of_objects->size());
  CHECK((*places_of_objects)[0] == (*places_of_objects)[0] && (*places_of_objects)[0] != (*places_of_objects)[1]);
  const auto waypoints = map.try_waypoints(lane, 0.5);
  CHECK(waypoints && waypoints->size() > 16);
  CHECK(map.try_waypoints(lane, 0.0).code() == MAPD_CODE_NOT_FINITE);
  CHECK(map.try_waypoints(lane, 1e-9).code() == MAPD_CODE_ARGUMENT);
  CHECK(map.try_width_at(answers[1].lane, 0.0).code() == MAPD_CODE_ARGUMENT);

  const mapd::Cost cost{MAPD_COST_LENGTH, MAPD_VEHICLE_CLASS_PASSENGER_CAR, 20.0};
  const mapd::PositionOnLane places[] = {{lane, 10.0}, {lane, 40.0}};
  const auto route = map.try_route(places, cost, scratch);
  CHECK(route && *route && !(*route)->steps.empty());
  CHECK(route && *route && std::fabs(*map.try_steps_length((*route)->steps) - (*route)->sum.length) < 1e-9);
  const auto ahead = map.try_lane_sequences(places[0], 100.0, MAPD_VEHICLE_CLASS_PASSENGER_CAR, true, scratch);
  CHECK(ahead && !ahead->pieces.empty() && ahead->pieces[0].lane == lane);
  const auto first = map.try_next_sequence(scratch);
  CHECK(first && *first && (**first)[0] == lane);
  CHECK(mapd::word(MAPD_WORDS_LANE_TYPE, map.try_lane(lane)->kind) == "driving");

  const mapd::NearestOptions drivable{10.0, mapd::lane_types_routable()};
  CHECK((mapd::lane_types_drivable() | mapd::lane_types_routable()) != mapd::lane_types_routable());
  CHECK(drivable.types != 0 && (*map.try_nearest_lane({50.0, -1.75}, drivable))->lane == lane);
  CHECK(!mapd::version().empty() && mapd::version().find('.') != std::string_view::npos);
  CHECK(map.try_populate().code == MAPD_CODE_OK);
  CHECK(mapd::Snapshot::try_open_trusted(argv[1], "/nowhere").code() == MAPD_CODE_NOT_TRUSTED);
  const mapd::RoadId road = map.try_lane(lane)->road;
  CHECK(*map.try_road_name_id(road) == mapd::view(map.try_road(road)->id) && *map.try_road_by_id("1") == road);
  const mapd::ClassSet landmarks = mapd::class_set_landmarks();
  const auto usual = other->try_landmarks_near({0.0, 0.0}, 1e6, nullptr, scratch);
  const auto named = other->try_landmarks_near({0.0, 0.0}, 1e6, &landmarks, scratch);
  CHECK(usual && named && !usual->empty() && usual->size() == named->size());
  const mapd::LaneId own[] = {lane};
  const auto steps = map.try_steps_of_lanes(own, 10.0, 40.0, scratch);
  CHECK(steps && steps->size() == 1 && (*steps)[0].lane == lane && std::fabs(*map.try_steps_length(*steps) - 30.0) < 1e-6);
  const auto on_it = map.try_path(*steps);
  const auto time = on_it->try_travel_time(0.0, 10.0);
  CHECK(time && time->time >= 0.0 && time->unlimited >= 0.0 && map.try_country(MAPD_NO_ROW) && !*map.try_country(MAPD_NO_ROW));
  const auto change = map.try_next_lane_change(*steps, 0, places[0], scratch);
  CHECK(change && !*change);
  const auto along = map.try_signals_along(*steps, scratch);
  CHECK(along && along->size() <= map.try_signals()->size());
  const auto rules = map.try_right_of_way_by(lane, "DE");
  CHECK(rules && *rules && (*rules)->size() == map.try_right_of_way(lane)->size());
  // A country whose rules are not known is not one by whose rules nobody is to be yielded to.
  for (const char* country : {"DEU", "XX", ""}) {
    const auto unknown = map.try_right_of_way_by(lane, country);
    CHECK(unknown && !*unknown);
  }
  CHECK(*map.try_overlay_revision() == 0);
  const auto near = map.try_quarantined_near({50.0, -1.75}, 10.0);
  CHECK(near && near->size() <= map.try_quarantined_parts()->size());
  const auto left_out = map.try_left_out(0, "nowhere");
  CHECK(left_out && !*left_out);
  CHECK(mapd::TraceOptions().size == sizeof(mapd_trace_options));
  CHECK(mapd::AlternativeOptions().size == sizeof(mapd_alternative_options));
  const auto projector = placed->try_projector();
  CHECK(projector && placed->try_file_projector());
  if (projector) {
    const mapd::Vec3 of_map[] = {{5.0, -1.75, 0.0}, {10.0, 2.0, 1.0}};
    mapd::Geodetic on_earth[2];
    CHECK(projector->try_to_geodetic(of_map, on_earth).code == MAPD_CODE_OK);
    for (int i = 0; i < 2; ++i) {
      const auto one = projector->try_to_geodetic(of_map[i]);
      CHECK(one && one->latitude == on_earth[i].latitude && one->longitude == on_earth[i].longitude);
    }
    const auto found = placed->try_nearest_lane_geodetic(*projector, on_earth[0], false);
    const auto same = placed->try_nearest_lane({of_map[0].x, of_map[0].y});
    CHECK(found && same && found->has_value() == same->has_value());
    if (*found && *same) CHECK((*found)->lane == (*same)->lane);
    const mapd::Vec3 none[] = {of_map[0], {NAN, 0.0, 0.0}};
    CHECK(projector->try_to_geodetic(none, on_earth).code == MAPD_CODE_NOT_FINITE);
    mapd::Vec3 there[2], back[2];
    double north[2];
    CHECK(projector->try_to_geodetic(of_map, on_earth).code == MAPD_CODE_OK);
    CHECK(projector->try_from_geodetic(on_earth, there).code == MAPD_CODE_OK && std::abs(there[1].x - of_map[1].x) < 1e-6);
    CHECK(projector->try_north_at(of_map, north).code == MAPD_CODE_OK && std::abs(north[0] - 1.570796) < 0.06);
    CHECK(projector->try_to_enu(of_map[0], of_map, there).code == MAPD_CODE_OK && std::abs(there[0].x) < 1e-6);
    CHECK(projector->try_from_enu(of_map[0], there, back).code == MAPD_CODE_OK && std::abs(back[1].y - of_map[1].y) < 1e-6);
    CHECK(projector->try_to_enu(none[1], of_map, there).code == MAPD_CODE_NOT_FINITE);
  }

  // What was made from a snapshot outlives it, and a snapshot from memory that memory.
  std::optional<mapd::Path> path;
  std::optional<mapd::View> view;
  std::optional<mapd::Projector> placer;
  {
    std::vector<std::uint8_t> bytes;
    if (std::FILE* file = std::fopen(argv[3], "rb")) {
      for (int byte; (byte = std::fgetc(file)) != EOF;) bytes.push_back(static_cast<std::uint8_t>(byte));
      std::fclose(file);
    }
    CHECK(mapd::Snapshot::try_from_bytes({}).code() == MAPD_CODE_NOT_AN_ARCHIVE);
    auto held = mapd::Snapshot::try_from_bytes(bytes);
    CHECK(held.has_value());
    if (!held) return 1;
    bytes = {};
    const auto there = held->try_nearest_lane({5.0, -1.75});
    CHECK(there && *there);
    if (!there || !*there) return 1;
    const mapd::LaneId only[] = {(*there)->lane};
    auto built = held->try_path(*held->try_steps_of_lanes(only, 1.0, 9.0, scratch));
    auto today = held->try_view(0.0);
    auto projected = held->try_projector();
    CHECK(built && today && projected);
    if (!built || !today || !projected) return 1;
    path.emplace(*std::move(built));
    view.emplace(*std::move(today));
    placer.emplace(*std::move(projected));
  }
  const auto start = path->try_at(0.0);
  CHECK(start && placer->try_to_geodetic(start->position) && view->try_allows({start->lane, start->s}, MAPD_VEHICLE_CLASS_PASSENGER_CAR));

#if MAPD_EXCEPTIONS
  map.populate();
  CHECK(map.road_name_id(road) == "1");
  CHECK(map.nearest_lane({50.0, -1.75})->lane == lane && map.key(lane) == *key);
  try {
    other->lane(lane);
    CHECK(false);
  } catch (const mapd::Exception& error) {
    CHECK(error.code() == MAPD_CODE_FOREIGN_ID);
  }
#endif

  // Heights as the file writes them, at the grid's first two stations and to the left of the first.
  const auto junction = (*grid).try_junction_by_id("grid");
  CHECK(junction && *junction);
  if (!junction || !*junction) return 1;
  const auto height = [&](double x, double y) { return (*grid).try_grid_height_at(**junction, {x, y}); };
  const auto is = [&](double x, double y, double z) {
    const auto found = height(x, y);
    return found && *found && std::abs((*found)->z - z) < 1e-9;
  };
  CHECK(is(-22.0, 0.0, 10.0) && is(-16.5, 0.0, 10.0437) && is(-22.0, 5.5, 10.1));
  CHECK(height(NAN, 0.0).code() == MAPD_CODE_NOT_FINITE);
  CHECK(map.try_grid_height_at(**junction, {0.0, 0.0}).code() == MAPD_CODE_FOREIGN_ID);

  // A snapshot that was moved from is closed.
  mapd::Snapshot kept = std::move(moved);
  CHECK(moved.try_lane(lane).code() == MAPD_CODE_NULL_POINTER && kept.try_lane(lane));
  std::printf("%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
