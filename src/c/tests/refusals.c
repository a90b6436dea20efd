/* What the C interface refuses, and what it says: every answer is a code, nothing crashes. `refusals ARCHIVE OTHER_ARCHIVE`. */
#include <math.h>
#include <mapd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;
static int checks = 0;
static mapd_error error;

/* A call, its code, and with an error its message. */
#define EXPECT(wanted, call)                                                                            \
  do {                                                                                                  \
    memset(&error, 0, sizeof error);                                                                    \
    const mapd_code found_ = (call);                                                                    \
    ++checks;                                                                                           \
    if (found_ != (wanted) || !is_told(found_)) {                                                       \
      fprintf(stderr, "%s:%d: %s: expected %d, found %d %s\n", __FILE__, __LINE__, #call, (int)(wanted), \
              (int)found_, error.message);                                                              \
      ++failures;                                                                                       \
    }                                                                                                   \
  } while (0)

static int is_told(mapd_code found) {
  if (found < MAPD_CODE_NULL_POINTER) return error.length == 0;
  return error.code == found && error.length > 0 && strlen(error.message) == error.length;
}

int main(int argc, char **argv) {
  if (argc != 3) return EXIT_FAILURE;
  mapd_snapshot *map = NULL, *other = NULL, *second = NULL, *laid = NULL;
  mapd_scratch *scratch = NULL;
  mapd_client *client = NULL;
  mapd_events *events = NULL;
  mapd_projector *projector = NULL;

  /* Opening. */
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_snapshot_open(NULL, &map, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_snapshot_open(argv[1], NULL, &error));
  EXPECT(MAPD_CODE_FILE, mapd_snapshot_open("/nowhere/nothing.mapd", &map, &error));
  EXPECT(MAPD_CODE_NOT_AN_ARCHIVE, mapd_snapshot_open(argv[0], &map, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_snapshot_open("\xff\xfe", &map, &error));
  EXPECT(MAPD_CODE_OK, mapd_snapshot_open(argv[1], &map, &error));
  EXPECT(MAPD_CODE_OK, mapd_snapshot_open(argv[2], &other, NULL));
  EXPECT(MAPD_CODE_OK, mapd_snapshot_clone(map, &second, &error));
  EXPECT(MAPD_CODE_OK, mapd_snapshot_verify(second, &error));
  EXPECT(MAPD_CODE_OK, mapd_scratch_new(&scratch, &error));

  /* Nobody serves here. */
  EXPECT(MAPD_CODE_NO_DAEMON, mapd_client_connect("town", "nobody-here_", 0.0, &client, &error));
  EXPECT(MAPD_CODE_NAME, mapd_client_connect("town", "no/prefix", 0.0, &client, &error));
  EXPECT(MAPD_CODE_NAME, mapd_client_connect("no/name", "nobody-here_", 0.0, &client, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_client_connect("town", NULL, -1.0, &client, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_client_connect("town", NULL, NAN, &client, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_client_snapshot(client, &second, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_events_new(client, &events, &error));
  mapd_event event;
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_events_next(events, 0.0, &event, &error));

  /* Points. */
  mapd_nearest hit;
  mapd_point point = {50.0, -1.75, 0.0, 0};
  EXPECT(MAPD_CODE_OK, mapd_nearest_lane(map, point, NULL, &hit, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_nearest_lane(NULL, point, NULL, &hit, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_nearest_lane(map, point, NULL, NULL, &error));
  if (mapd_nearest_lane(map, point, NULL, NULL, NULL) != MAPD_CODE_NULL_POINTER) ++failures;
  const mapd_point nan_point = {NAN, 0.0, 0.0, 0}, far_off = {1e9, 1e9, 0.0, 0};
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_nearest_lane(map, nan_point, NULL, &hit, &error));
  EXPECT(MAPD_CODE_NONE, mapd_nearest_lane(map, far_off, NULL, &hit, &error));
  mapd_nearest_options options;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_nearest_options_init(&options, 3, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_nearest_options_init(NULL, sizeof options, &error));
  EXPECT(MAPD_CODE_OK, mapd_nearest_options_init(&options, sizeof options, &error));
  options.size = 1;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_nearest_lane(map, point, &options, &hit, &error));
  EXPECT(MAPD_CODE_OK, mapd_nearest_options_init(&options, sizeof options, &error));
  options.radius = INFINITY;
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_nearest_lane(map, point, &options, &hit, &error));
  options.radius = 10.0;
  mapd_nearest hint = hit;
  hint.lane.content ^= 1; /* of another map: ignored */
  hint.position.clamped = 77;
  options.hint = &hint;
  EXPECT(MAPD_CODE_OK, mapd_nearest_lane(map, point, &options, &hit, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_nearest_lane_batch(map, NULL, 2, NULL, scratch, &hit, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_nearest_lane_batch(map, &point, 1, NULL, scratch, NULL, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_nearest_lane_batch(map, &point, SIZE_MAX / 4, NULL, scratch, &hit, &error));
  EXPECT(MAPD_CODE_OK, mapd_nearest_lane_batch(map, NULL, 0, NULL, scratch, NULL, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_nearest_lane_batch(map, &point, 1, NULL, NULL, &hit, &error));
  /* Some points have z, others have none. */
  const mapd_point mixed[] = {{50.0, -1.75, 0.0, 1}, {1e9, 1e9, 0.0, 0}, {50.0, -1.75, NAN, 1}};
  mapd_nearest hits[3];
  EXPECT(MAPD_CODE_OK, mapd_nearest_lane_batch(map, mixed, 2, NULL, scratch, hits, &error));
  if (hits[0].lane.row != hit.lane.row || hits[1].lane.row != MAPD_NO_ROW) ++failures;
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_nearest_lane_batch(map, mixed, 3, NULL, scratch, hits, &error));
  EXPECT(MAPD_CODE_ARGUMENT,
         mapd_nearest_lane(map, point, NULL, (mapd_nearest *)((char *)&options + 1), &error));

  /* Ids. */
  mapd_lane_facts lane;
  EXPECT(MAPD_CODE_OK, mapd_lane_facts_of(map, hit.lane, &lane, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_lane_facts_of(other, hit.lane, &lane, &error));
  mapd_lane_id wrong = hit.lane;
  wrong.row = MAPD_NO_ROW - 1;
  EXPECT(MAPD_CODE_CORRUPT, mapd_lane_facts_of(map, wrong, &lane, &error));
  /* What names nothing is told from what another map has, with this map's content and as batches write it. */
  double width = 0.0;
  wrong.row = MAPD_NO_ROW;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_lane_width_at(map, wrong, 0.0, &width, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_lane_width_at(map, hits[1].lane, 0.0, &width, &error));
  if (strstr(error.message, "names nothing") == NULL) ++failures;
  wrong.row = hit.lane.row;
  wrong.content = 0;
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_lane_facts_of(map, wrong, &lane, &error));
  EXPECT(MAPD_CODE_NONE, mapd_lane_by_key(map, "nothing:0:-1", &wrong, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_lane_by_key(map, "no key", &wrong, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_lane_by_key(map, NULL, &wrong, &error));
  double number = 0.0;
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_lane_width_at(map, hit.lane, NAN, &number, &error));
  mapd_waypoint waypoint;
  size_t count = 0;
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_lane_waypoints(map, hit.lane, 0.0, &waypoint, 1, &count, &error));
  /* A step that gives too many is refused before any is looked at, and those that only count are not looked at either. */
  EXPECT(MAPD_CODE_ARGUMENT, mapd_lane_waypoints(map, hit.lane, 1e-9, NULL, 0, &count, &error));
  if (strstr(error.message, "step") == NULL) ++failures;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_lane_beside(map, hit.lane, 99, &wrong, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_lane_signals(map, hit.lane, 99, NULL, 0, &count, &error));

  /* Buffers: what fits is written, and nothing behind it. */
  EXPECT(MAPD_CODE_TOO_SMALL, mapd_lane_waypoints(map, hit.lane, 1.0, &waypoint, 1, &count, &error));
  EXPECT(MAPD_CODE_TOO_SMALL, mapd_lane_waypoints(map, hit.lane, 1.0, NULL, 0, &count, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_lane_waypoints(map, hit.lane, 1.0, NULL, 3, &count, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_lane_waypoints(map, hit.lane, 1.0, &waypoint, 1, NULL, &error));
  mapd_waypoint *exact = malloc(count * sizeof *exact);
  EXPECT(MAPD_CODE_OK, mapd_lane_waypoints(map, hit.lane, 1.0, exact, count, &count, &error));
  free(exact);
  char key[64];
  size_t length = 0;
  EXPECT(MAPD_CODE_OK, mapd_lane_key(map, hit.lane, key, sizeof key, &length, &error));
  char *small = malloc(length);
  EXPECT(MAPD_CODE_TOO_SMALL, mapd_lane_key(map, hit.lane, small, length, &length, &error));
  if (strncmp(small, key, length - 1) != 0 || small[length - 1] != '\0') ++failures;
  free(small);
  EXPECT(MAPD_CODE_TOO_SMALL, mapd_lane_key(map, hit.lane, NULL, 0, &length, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_lane_key(map, hit.lane, NULL, 5, &length, &error));

  /* Routes. */
  const mapd_cost by_length = {MAPD_COST_LENGTH, MAPD_VEHICLE_CLASS_PASSENGER_CAR, 20.0, NULL, 0};
  mapd_cost wrong_cost = by_length;
  mapd_position_on_lane places[2] = {{hit.lane, hit.position.s}, {hit.lane, NAN}};
  mapd_route_step steps[64];
  mapd_route_sum sum;
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_route(map, places, 2, by_length, scratch, &sum, steps, 64, &count, &error));
  places[1].s = hit.position.s + 1.0;
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_route(map, places, 2, by_length, NULL, &sum, steps, 64, &count, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_route(other, places, 2, by_length, scratch, &sum, steps, 64, &count, &error));
  EXPECT(MAPD_CODE_NONE, mapd_route(map, places, 1, by_length, scratch, &sum, steps, 64, &count, &error));
  EXPECT(MAPD_CODE_OK, mapd_route(map, places, 2, by_length, scratch, NULL, steps, 64, &count, &error));
  wrong_cost.by = 9;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_route(map, places, 2, wrong_cost, scratch, &sum, steps, 64, &count, &error));
  wrong_cost = by_length;
  wrong_cost.vehicle = 300;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_route(map, places, 2, wrong_cost, scratch, &sum, steps, 64, &count, &error));
  wrong_cost = by_length;
  wrong_cost.factor_count = 3;
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_route(map, places, 2, wrong_cost, scratch, &sum, steps, 64, &count, &error));
  mapd_lane_line_at lines[4];
  EXPECT(MAPD_CODE_OK, mapd_route(map, places, 2, by_length, scratch, NULL, steps, 64, &count, &error));
  EXPECT(MAPD_CODE_OK, mapd_lines_along(map, steps, count, scratch, lines, 4, &length, &error));
  steps[0].enter = 200;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_lines_along(map, steps, count, scratch, lines, 4, &length, &error));

  /* Paths. */
  mapd_path *path = NULL;
  mapd_path_point at[2];
  mapd_path_position foot;
  mapd_corridor_station station;
  mapd_path_conflict conflict;
  mapd_conflict_lane met;
  size_t met_count;
  const double places_along[] = {0.5, NAN};
  const mapd_vec2 nan_place = {NAN, 0.0};
  steps[0].enter = MAPD_ENTER_START;
  const size_t step_count = count;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_new(map, steps, 0, NULL, &path, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_path_new(other, steps, count, NULL, &path, &error));
  EXPECT(MAPD_CODE_OK, mapd_path_new(map, steps, count, NULL, &path, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_path_at(path, NAN, at, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_path_at_batch(path, places_along, 2, at, &error));
  if (strncmp(error.message, "entry 1:", 8) != 0 || at[0].along != 0.5) ++failures;
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_path_at_batch(path, NULL, 2, at, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_path_at_batch(path, places_along, 2, NULL, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_path_project(path, nan_place, NULL, &foot, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_path_project_batch(path, &nan_place, 1, &foot, &error));
  EXPECT(MAPD_CODE_NONE, mapd_path_along_of(path, wrong, 1.0, &number, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_corridor(path, 0.0, 1.0, 0.0, 0, scratch, &station, 1, &count, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_corridor(path, 0.0, 1.0, 1e-9, 0, scratch, &station, 1, &count, &error));
  EXPECT(MAPD_CODE_TOO_SMALL, mapd_path_corridor(path, 0.0, 1e9, 0.5, 0, scratch, &station, 1, &count, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_corridor(path, 0.0, 1.0, 0.5, 200, scratch, &station, 1, &count, &error));
  EXPECT(MAPD_CODE_TOO_SMALL, mapd_path_corridor(path, 0.0, 1.0, 0.5, 0, scratch, &station, 1, &count, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_path_conflicts(path, NULL, &conflict, 1, &count, &met, 1, &met_count, &error));
  EXPECT(MAPD_CODE_OK, mapd_path_conflicts(path, scratch, &conflict, 1, &count, &met, 1, &met_count, &error));
  mapd_path_close(&path);
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_path_length(path, &number, &error));

  mapd_path_options path_options;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_options_init(&path_options, 1, &error));
  EXPECT(MAPD_CODE_OK, mapd_path_options_init(&path_options, sizeof path_options, &error));
  path_options.change_length = -1.0;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_new(map, steps, step_count, &path_options, &path, &error));
  path_options.change_length = 40.0;
  path_options.shortest_change = -1.0;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_new(map, steps, step_count, &path_options, &path, &error));
  path_options.shortest_change = 10.0;
  path_options.change_delay = -1.0;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_new(map, steps, step_count, &path_options, &path, &error));
  path_options.change_delay = 0.0;
  path_options.vehicle = 200;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_new(map, steps, step_count, &path_options, &path, &error));
  EXPECT(MAPD_CODE_OK, mapd_path_new(map, steps, step_count, NULL, &path, &error));
  mapd_path_fact fact;
  mapd_route_step part[64];
  mapd_path_change change;
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_path_facts(path, NULL, &fact, 1, &count, &error));
  EXPECT(MAPD_CODE_OK, mapd_path_steps_between(path, steps, step_count, 0.25, 0.5, scratch, part, 64, &count, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_path_steps_between(path, steps, step_count, NAN, 0.5, scratch, part, 64, &count, &error));
  mapd_path_time time;
  mapd_text country;
  EXPECT(MAPD_CODE_OK, mapd_path_travel_time(path, 0.25, 0.5, &time, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_path_travel_time(path, NAN, 0.5, &time, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_travel_time(path, 0.5, 0.25, &time, &error));
  EXPECT(MAPD_CODE_NONE, mapd_country(map, MAPD_NO_ROW, &country, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_path_steps_between(path, steps, 0, 0.25, 0.5, scratch, part, 64, &count, &error));
  EXPECT(MAPD_CODE_NULL_POINTER,
         mapd_path_rebase(path, NULL, by_length, scratch, &sum, part, 64, &count, &change, 1, &length, &error));
  const mapd_conflict_lane nan_lane = {0.0, 1.0, hit.lane, NAN, 1.0, 0.0, 0, 0, 0, 0, 0};
  mapd_conflict_approach approach;
  uint8_t who;
  EXPECT(MAPD_CODE_NOT_FINITE,
         mapd_conflict_approaches(map, &nan_lane, 1, 10.0, 0, scratch, &approach, 1, &count, &error));
  EXPECT(MAPD_CODE_NULL_POINTER,
         mapd_conflict_approaches(map, NULL, 1, 10.0, 0, scratch, &approach, 1, &count, &error));
  EXPECT(MAPD_CODE_NONE, mapd_path_conflict_yields_by(&nan_lane, 1, "XX", &who, NULL, &error));
  EXPECT(MAPD_CODE_OK, mapd_path_conflict_yields_by(&nan_lane, 1, "de", &who, NULL, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_corridor_outline(&station, 1, 9, scratch, NULL, 0, &count, NULL, &error));

  /* What is laid over the map. */
  mapd_view *view = NULL;
  mapd_permission permission;
  mapd_speed_today speed;
  mapd_overtaking_today overtaking;
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_view_new(map, NAN, &view, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_view_new(map, 1e300, &view, &error));
  EXPECT(MAPD_CODE_NOT_AN_ARCHIVE, mapd_snapshot_with_overlay(map, (const uint8_t *)"no overlay", 10, &laid, &error));
  EXPECT(MAPD_CODE_NOT_AN_ARCHIVE, mapd_snapshot_with_overlay(map, NULL, 0, &laid, &error));
  EXPECT(MAPD_CODE_NOT_AN_ARCHIVE, mapd_snapshot_from_bytes((const uint8_t *)"no archive", 10, &laid, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_snapshot_from_bytes(NULL, 10, &laid, &error));
  EXPECT(MAPD_CODE_OK, mapd_view_new(map, -1.5, &view, &error));
  EXPECT(MAPD_CODE_OK, mapd_view_allows(view, hit.lane, 1.0, 0, &permission, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_view_allows(view, hit.lane, NAN, 0, &permission, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_view_allows(view, hit.lane, 1.0, 200, &permission, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_view_speed_rule_at(view, wrong, 1.0, 0, &speed, &error));
  EXPECT(MAPD_CODE_OK, mapd_view_overtaking_rule_at(view, hit.lane, 1.0, 0, &overtaking, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_view_overtaking_rule_at(view, hit.lane, NAN, 0, &overtaking, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_view_overtaking_rule_at(view, wrong, 1.0, 0, &overtaking, &error));
  mapd_view_close(&view);
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_view_allows(view, hit.lane, 1.0, 0, &permission, &error));
  EXPECT(MAPD_CODE_OK, mapd_view_new(other, 0.0, &view, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_view_speed_on_path(view, path, 0.0, 0, &speed, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_view_speeds_on_path(view, path, 0, NULL, 0, &count, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_view_segments_on_path(view, path, 0, scratch, NULL, 0, &count, &error));
  EXPECT(MAPD_CODE_FOREIGN_ID, mapd_view_travel_time_on_path(view, path, 0.0, 1.0, 0, &time, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_view_travel_time_on_path(view, path, NAN, 1.0, 0, &time, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_view_speeds_on_path(view, path, 200, NULL, 0, &count, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_view_segments_on_path(view, path, 0, NULL, NULL, 0, &count, &error));
  mapd_view_close(&view);
  mapd_path_close(&path);

  /* Ground, marks and matches. */
  mapd_ground ground[2];
  mapd_near_mark mark;
  mapd_mark_filter filter;
  mapd_lane_match match;
  mapd_match_options match_options;
  mapd_trace_match traced[2];
  const mapd_point two[] = {point, nan_point};
  const mapd_vec2 here = {50.0, -1.75};
  const mapd_vehicle_pose pose = {point, 0.0}, nan_pose = {point, NAN};
  const double covariance[9] = {0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1}, skew[9] = {0.1, 1, 0, 0, 0.1, 0, 0, 0, 0.1};
  const mapd_trace_fix fixes[] = {{1.0, point, 0.0, 0}, {0.0, point, 0.0, 0}};
  EXPECT(MAPD_CODE_OK, mapd_ground_at(map, point, NULL, 0, scratch, ground, &error));
  EXPECT(MAPD_CODE_NONE, mapd_ground_at(map, far_off, NULL, 0, scratch, ground, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_ground_at_batch(map, two, 2, NULL, 0, scratch, ground, &error));
  if (strncmp(error.message, "entry 1:", 8) != 0 || ground[0].lane.row != hit.lane.row) ++failures;
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_ground_at_batch(map, two, 2, NULL, 0, NULL, ground, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_mark_filter_init(&filter, 1, &error));
  EXPECT(MAPD_CODE_OK, mapd_mark_filter_init(&filter, sizeof filter, &error));
  filter.kinds = 0;
  EXPECT(MAPD_CODE_NONE, mapd_nearest_mark(map, here, &filter, &mark, &error));
  filter.size = 8;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_nearest_mark(map, here, &filter, &mark, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_nearest_mark_batch(map, &nan_place, 1, NULL, &mark, &error));
  EXPECT(MAPD_CODE_TOO_SMALL, mapd_match_pose(map, pose, covariance, NULL, scratch, &match, 1, &count, NULL, &error));
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_match_pose(map, nan_pose, covariance, NULL, scratch, &match, 1, &count, NULL, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_match_pose(map, pose, skew, NULL, scratch, &match, 1, &count, NULL, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_match_pose(map, pose, NULL, NULL, scratch, &match, 1, &count, NULL, &error));
  EXPECT(MAPD_CODE_OK, mapd_match_options_init(&match_options, sizeof match_options, &error));
  match_options.expected_count = 2;
  EXPECT(MAPD_CODE_NULL_POINTER,
         mapd_match_pose(map, pose, covariance, &match_options, scratch, &match, 1, &count, NULL, &error));
  match_options.expected_count = 0;
  match_options.none = 0.0;
  EXPECT(MAPD_CODE_ARGUMENT,
         mapd_match_pose(map, pose, covariance, &match_options, scratch, &match, 1, &count, NULL, &error));
  match_options.none = 0.01;
  match_options.outline.front = -1.0;
  EXPECT(MAPD_CODE_ARGUMENT,
         mapd_match_pose(map, pose, covariance, &match_options, scratch, &match, 1, &count, NULL, &error));
  if (strstr(error.message, "outline.front") == NULL) ++failures;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_match_trace(map, fixes, 2, NULL, scratch, traced, &error));
  EXPECT(MAPD_CODE_OK, mapd_match_trace(map, fixes, 1, NULL, scratch, traced, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_match_trace(map, fixes, 1, NULL, scratch, NULL, &error));

  mapd_tracker *tracker = NULL;
  mapd_tracker_options tracker_options;
  mapd_tracked tracked;
  const mapd_tracker_fix fix = {1.0, pose, {0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1}, 0.0, 0};
  mapd_tracker_fix wrong_fix = fix;
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_tracker_update(tracker, map, &fix, NULL, &tracked, &error));
  EXPECT(MAPD_CODE_OK, mapd_tracker_new(&tracker, &error));
  EXPECT(MAPD_CODE_OK, mapd_tracker_update(tracker, map, &fix, NULL, &tracked, &error));
  wrong_fix.time = 0.5;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_tracker_update(tracker, map, &wrong_fix, NULL, &tracked, &error));
  wrong_fix.time = NAN;
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_tracker_update(tracker, map, &wrong_fix, NULL, &tracked, &error));
  EXPECT(MAPD_CODE_OK, mapd_tracker_options_init(&tracker_options, sizeof tracker_options, &error));
  tracker_options.enough = 2.0;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_tracker_update(tracker, map, &fix, &tracker_options, &tracked, &error));
  tracker_options.size = 1;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_tracker_update(tracker, map, &fix, &tracker_options, &tracked, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_tracker_update(tracker, map, &fix, NULL, NULL, &error));
  mapd_tracker_close(&tracker);
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_tracker_reset(tracker, &error));
  const mapd_sensor blind = {here, NAN, 10.0, 1.0};
  mapd_landmark_in_view seen;
  mapd_stance stance;
  EXPECT(MAPD_CODE_NOT_FINITE, mapd_landmarks_in_view(map, blind, NULL, scratch, &seen, 1, &count, &error));
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_stance_at(map, pose, NULL, NULL, 0, scratch, &stance, &error));
  EXPECT(MAPD_CODE_ARGUMENT, mapd_controller_signals(map, 1000000, NULL, 0, &count, &error));

  /* Words. */
  mapd_text text;
  EXPECT(MAPD_CODE_ARGUMENT, mapd_word(99, 0, &text, &error));
  EXPECT(MAPD_CODE_OK, mapd_word(MAPD_WORDS_LANE_TYPE, 60000, &text, &error));

  /* A map without georeference. */
  const mapd_code projected = mapd_projector_new(map, &projector, &error);
  if (projected != MAPD_CODE_OK && projected != MAPD_CODE_NO_PROJECTION) ++failures;
  mapd_projector_close(&projector);

  /* From memory that is freed; and what was made from a snapshot outlives it. */
  FILE *file = fopen(argv[1], "rb");
  if (!file || fseek(file, 0, SEEK_END) != 0) return EXIT_FAILURE;
  const size_t size = (size_t)ftell(file);
  uint8_t *bytes = malloc(size);
  rewind(file);
  if (!bytes || fread(bytes, 1, size, file) != size) return EXIT_FAILURE;
  fclose(file);
  EXPECT(MAPD_CODE_OK, mapd_snapshot_from_bytes(bytes, size, &laid, &error));
  free(bytes);
  steps[0].enter = MAPD_ENTER_START;
  EXPECT(MAPD_CODE_OK, mapd_path_new(laid, steps, step_count, NULL, &path, &error));
  EXPECT(MAPD_CODE_OK, mapd_view_new(laid, 0.0, &view, &error));
  const mapd_code of_laid = mapd_projector_new(laid, &projector, &error);
  mapd_snapshot_close(&laid);
  EXPECT(MAPD_CODE_OK, mapd_path_at(path, 0.5, at, &error));
  EXPECT(MAPD_CODE_OK, mapd_path_corridor(path, 0.0, 0.0, 0.5, 0, scratch, &station, 1, &count, &error));
  EXPECT(MAPD_CODE_OK, mapd_view_allows(view, hit.lane, 1.0, 0, &permission, &error));
  mapd_geodetic place;
  if (of_laid == MAPD_CODE_OK && mapd_to_geodetic(projector, at[0].position, &place, &error) != MAPD_CODE_OK) ++failures;
  mapd_projector_close(&projector);
  mapd_view_close(&view);
  mapd_path_close(&path);

  /* After closing. */
  mapd_snapshot_close(&map);
  if (map != NULL) ++failures;
  mapd_snapshot_close(&map);
  mapd_snapshot_close(NULL);
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_nearest_lane(map, point, NULL, &hit, &error));
  EXPECT(MAPD_CODE_OK, mapd_nearest_lane(second, point, NULL, &hit, &error));
  mapd_snapshot_close(&second);
  mapd_snapshot_close(&other);
  mapd_scratch_close(&scratch);
  EXPECT(MAPD_CODE_NULL_POINTER, mapd_snapshot_verify(other, &error));

  printf("%d checks, %d failures\n", checks, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
