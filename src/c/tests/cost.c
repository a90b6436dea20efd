/* What a call costs in C: as `examples/cost.rs`, whose sum this prints too. `cost ARCHIVE KIND COUNT`. */
#include <mapd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state = 1;
static mapd_error error;

static double between(double low, double high) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return low + (high - low) * ((double)(state >> 11) / (double)(UINT64_C(1) << 53));
}

static void must(mapd_code code) {
  if (code == MAPD_CODE_OK || code == MAPD_CODE_NONE) return;
  fprintf(stderr, "%s\n", error.message);
  exit(EXIT_FAILURE);
}

int main(int argc, char **argv) {
  if (argc != 4) return EXIT_FAILURE;
  const char *kind = argv[2];
  mapd_snapshot *map = NULL;
  mapd_map_facts facts;
  mapd_lane_id *lanes;
  mapd_lane_facts lane;
  mapd_road_facts road;
  mapd_nearest_options options;
  size_t count;
  double sum = 0.0;
  must(mapd_snapshot_open(argv[1], &map, &error));
  must(mapd_map_facts_of(map, &facts, &error));
  mapd_lanes(map, NULL, 0, &count, NULL);
  lanes = malloc(count * sizeof *lanes);
  if (!lanes) return EXIT_FAILURE;
  must(mapd_lanes(map, lanes, count, &count, &error));
  must(mapd_lane_facts_of(map, lanes[0], &lane, &error));
  must(mapd_road_facts_of(map, lane.road, &road, &error));
  must(mapd_nearest_options_init(&options, sizeof options, &error));
  /* Looked up once: what the loop does besides its call is to be as little as in Rust. */
  const int is_nearest = strcmp(kind, "nearest") == 0, is_position = strncmp(kind, "position", 8) == 0, is_track = strncmp(kind, "track", 5) == 0;
  for (long i = atol(argv[3]); i > 0; --i) {
    const double x = between(facts.low.x, facts.high.x);
    const mapd_point point = {x, between(facts.low.y, facts.high.y), 0.0, 0};
    if (is_nearest) {
      mapd_nearest hit;
      const mapd_code code = mapd_nearest_lane(map, point, &options, &hit, &error);
      if (code == MAPD_CODE_OK) sum += hit.position.s;
      else must(code);
    } else if (is_position) {
      mapd_lane_position found;
      must(mapd_lane_position_of(map, lane.lane, point, &found, &error));
      sum += found.offset;
    } else if (is_track) {
      mapd_track_position found;
      must(mapd_road_to_track(map, lane.road, point, &found, &error));
      sum += found.t;
    } else {
      const mapd_track track = {between(0.0, road.length), 1.0, 0.0};
      mapd_pose pose;
      must(mapd_road_to_inertial(map, lane.road, track, &pose, &error));
      sum += pose.position.x;
    }
  }
  printf("%.6f\n", sum);
  free(lanes);
  mapd_snapshot_close(&map);
  return EXIT_SUCCESS;
}
