// A localiser's cycle: which lanes may the vehicle be in, how high is the ground, where is the next road mark? Says word for word what the
// Rust example of this name says.
//
// localiser MAP X Y HEADING [DEVIATION]: by a pose with these standard deviations [m], 0.1 rad (default 0.5 m).
#include <mapd.hpp>

#include <cstdio>
#include <string>

namespace {

// How long the map may take to come [s].
constexpr double patience = 30.0;
// Standard deviation of the heading [rad].
constexpr double heading_deviation = 0.1;

void localise(const mapd::Snapshot& map, mapd::Vec2 at, double heading, double deviation, mapd::Scratch& scratch) {
  const double position = deviation * deviation, turn = heading_deviation * heading_deviation;
  const mapd::Covariance covariance{position, 0, 0, 0, position, 0, 0, 0, turn};
  const auto match = map.match_pose({mapd::Point(at), heading}, covariance, scratch);
  for (const auto& one : match.lanes) {
    std::printf("%.3f lane %s %s, s = %.2f m, %.2f m left of its centre\n", one.probability, map.key(one.lane).c_str(),
                one.forward ? "along" : "against", one.position.s, one.position.offset);
  }
  std::printf("%.3f no lane\n", match.none);
  if (const auto ground = map.ground_at(at, scratch)) {
    std::printf("ground at %.2f m, level %u of %u\n", ground->z, ground->level, ground->levels);
  }
  if (const auto mark = map.nearest_mark(at)) {
    const std::string kind(mapd::word(MAPD_WORDS_ROAD_MARK_KIND, mark->kind));
    std::printf("mark %s in %.2f m\n", kind.c_str(), mark->distance);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5 && argc != 6) {
    std::fprintf(stderr, "usage: localiser MAP X Y HEADING [DEVIATION]\n");
    return 1;
  }
  const auto client = mapd::Client::connect(argv[1], patience);
  mapd::Scratch scratch;
  localise(client.snapshot(), {std::stod(argv[2]), std::stod(argv[3])}, std::stod(argv[4]),
           argc == 6 ? std::stod(argv[5]) : 0.5, scratch);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
