/* Says which lane a position is on, from a map that another process serves.
 *
 * which_lane MAP X Y, for example which_lane town 50 -1.75 */
#include <mapd.h>
#include <stdio.h>
#include <stdlib.h>

static int failed(const mapd_error *error) {
  fprintf(stderr, "%s\n", error->message);
  return EXIT_FAILURE;
}

int main(int argc, char **argv) {
  mapd_client *client = NULL;
  mapd_snapshot *snapshot = NULL;
  mapd_error error;
  if (argc != 4) {
    fprintf(stderr, "usage: which_lane MAP X Y\n");
    return EXIT_FAILURE;
  }
  const mapd_point point = {.x = atof(argv[2]), .y = atof(argv[3]), .z = 0.0, .has_z = 0};

  /* Waits up to two seconds for daemon and map; nothing is copied, the archive is read where it lies. */
  if (mapd_client_connect(argv[1], NULL, 2.0, &client, &error) != MAPD_CODE_OK) return failed(&error);
  if (mapd_client_snapshot(client, &snapshot, &error) != MAPD_CODE_OK) return failed(&error);

  mapd_nearest hit;
  switch (mapd_nearest_lane(snapshot, point, NULL, &hit, &error)) {
    case MAPD_CODE_OK: {
      char key[256];
      mapd_lane_facts lane;
      mapd_text kind;
      mapd_lane_id next[16];
      size_t count = 0;
      if (mapd_lane_key(snapshot, hit.lane, key, sizeof key, NULL, &error) != MAPD_CODE_OK) return failed(&error);
      if (mapd_lane_facts_of(snapshot, hit.lane, &lane, &error) != MAPD_CODE_OK) return failed(&error);
      if (mapd_word(MAPD_WORDS_LANE_TYPE, lane.kind, &kind, &error) != MAPD_CODE_OK) return failed(&error);
      printf("lane %s (%.*s)\n", key, (int)kind.size, kind.data);
      printf("s = %.3f m, %.3f m from its centre, %.3f m outside\n", hit.position.s, hit.position.offset,
             hit.position.distance);
      if (mapd_lane_successors(snapshot, hit.lane, next, 16, &count, &error) != MAPD_CODE_OK) return failed(&error);
      for (size_t i = 0; i < count; ++i) {
        if (mapd_lane_key(snapshot, next[i], key, sizeof key, NULL, &error) != MAPD_CODE_OK) return failed(&error);
        printf("leads to %s\n", key);
      }
      break;
    }
    case MAPD_CODE_NONE:
      printf("no lane within 10 m\n");
      break;
    default:
      return failed(&error);
  }
  mapd_snapshot_close(&snapshot);
  mapd_client_close(&client);
  return EXIT_SUCCESS;
}
