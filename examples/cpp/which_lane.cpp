// Says which lane a position is on, from a map that another process serves.
//
// which_lane MAP X Y, for example which_lane town 50 -1.75
#include <mapd.hpp>

#include <cstdio>
#include <string>

int main(int argc, char** argv) try {
  if (argc != 4) {
    std::fprintf(stderr, "usage: which_lane MAP X Y\n");
    return 1;
  }
  const mapd::Point point(std::stod(argv[2]), std::stod(argv[3]));

  // Waits up to two seconds for daemon and map; nothing is copied, the archive is read where it lies.
  const auto client = mapd::Client::connect(argv[1], 2.0);
  const auto map = client.snapshot();

  const auto hit = map.nearest_lane(point);
  if (!hit) {
    std::printf("no lane within 10 m\n");
    return 0;
  }
  const std::string kind(mapd::word(MAPD_WORDS_LANE_TYPE, map.lane(hit->lane).kind));
  std::printf("lane %s (%s)\n", map.key(hit->lane).c_str(), kind.c_str());
  std::printf("s = %.3f m, %.3f m from its centre, %.3f m outside\n", hit->position.s, hit->position.offset,
              hit->position.distance);
  for (const auto next : map.successors(hit->lane)) std::printf("leads to %s\n", map.key(next).c_str());
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
