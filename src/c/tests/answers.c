/* Answers the questions of a file in C and compares bit by bit. `answers ARCHIVE ANSWERS`. */
#define _GNU_SOURCE
#include "answers.h"
#include <mapd.h>

enum { MOST = 1 << 16 };
static mapd_snapshot *map;
static mapd_scratch *scratch;
static mapd_projector *projector;
static mapd_error error;
static const uint8_t CAR = MAPD_VEHICLE_CLASS_PASSENGER_CAR;

static void must(mapd_code code) {
  if (code == MAPD_CODE_OK) return;
  fprintf(stderr, "code %d: %s\n", (int)code, error.message);
  exit(EXIT_FAILURE);
}

/* Whether there is an answer. */
static int is(mapd_code code) {
  if (code != MAPD_CODE_NONE) must(code);
  return code == MAPD_CODE_OK;
}

#define ID(kind)                                                                                \
  static uint64_t kind##_bits(mapd_##kind##_id id) {                                            \
    return id.row == MAPD_NO_ROW ? MAPD_NO_ROW : (uint64_t)id.content << 32 | id.row;           \
  }
ID(lane)
ID(signal)
ID(object)
ID(node)
ID(junction)

static mapd_lane_id lane_of(uint64_t bits) {
  const mapd_lane_id id = {(uint32_t)bits, (uint32_t)(bits >> 32)};
  return id;
}

static mapd_road_id road_of(uint64_t bits) {
  const mapd_road_id id = {(uint32_t)bits, (uint32_t)(bits >> 32)};
  return id;
}

static void add_v(struct numbers *out, mapd_vec3 v) {
  add_f(out, v.x);
  add_f(out, v.y);
  add_f(out, v.z);
}

static void add_nearest(struct numbers *out, mapd_nearest one) {
  const mapd_lane_position p = one.position;
  add_u(out, lane_bits(one.lane));
  add_f(out, p.s);
  add_f(out, p.t);
  add_f(out, p.offset);
  add_f(out, p.offset_of_reference_line);
  add_f(out, p.distance);
  add_f(out, p.z);
  add_f(out, p.heading);
  add_f(out, p.heading_of_reference_line);
  add_u(out, p.clamped);
}

static void add_pose(struct numbers *out, mapd_pose pose) {
  add_v(out, pose.position);
  add_f(out, pose.heading);
  add_f(out, pose.curvature);
  add_f(out, pose.slope);
  add_f(out, pose.superelevation);
  add_u(out, pose.clamped);
}

typedef mapd_code lane_list(const mapd_snapshot *, mapd_lane_id, mapd_lane_id *, size_t, size_t *, mapd_error *);

static void add_lanes(struct numbers *out, lane_list *list, mapd_lane_id lane) {
  static mapd_lane_id all[MOST];
  size_t count;
  must(list(map, lane, all, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_u(out, lane_bits(all[i]));
}

static void points(const char *kind, const uint64_t *q, struct numbers *out) {
  size_t count;
  if (strcmp(kind, "nearest") == 0 || strcmp(kind, "near") == 0) {
    const mapd_point point = {as_f(q[0]), as_f(q[1]), as_f(q[2]), q[3]};
    mapd_nearest_options options;
    must(mapd_nearest_options_init(&options, sizeof options, &error));
    options.radius = as_f(q[4]);
    if (strcmp(kind, "nearest") == 0) {
      mapd_nearest hit, batch;
      const int found = is(mapd_nearest_lane(map, point, &options, &hit, &error));
      must(mapd_nearest_lane_batch(map, &point, 1, &options, &batch, &error));
      if ((batch.lane.row != MAPD_NO_ROW) != found) abort();
      add_u(out, (uint64_t)found);
      if (found) add_nearest(out, hit);
    } else {
      static mapd_nearest all[MOST];
      must(mapd_lanes_near(map, point, &options, scratch, all, MOST, &count, &error));
      add_u(out, count);
      for (size_t i = 0; i < count; ++i) add_nearest(out, all[i]);
    }
  } else if (strcmp(kind, "objects") == 0) {
    static mapd_near_object all[MOST];
    const mapd_vec2 at = {as_f(q[0]), as_f(q[1])};
    must(mapd_objects_near(map, at, as_f(q[2]), scratch, all, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      add_u(out, object_bits(all[i].place.object));
      add_u(out, all[i].place.copy);
      add_f(out, all[i].distance);
    }
  } else {
    static mapd_landmark all[MOST];
    const mapd_vec2 at = {as_f(q[0]), as_f(q[1])};
    must(mapd_landmarks_near(map, at, as_f(q[2]), NULL, scratch, all, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      const mapd_landmark *one = &all[i];
      add_u(out, signal_bits(one->signal));
      add_u(out, object_bits(one->place.object));
      add_u(out, one->class_code);
      add_v(out, one->position);
      add_f(out, one->heading);
      add_f(out, one->length);
      add_f(out, one->width);
      add_f(out, one->height);
      add_f(out, one->distance);
    }
  }
}

static void roads(const char *kind, const uint64_t *q, struct numbers *out) {
  const mapd_road_id road = road_of(q[0]);
  if (strcmp(kind, "track") == 0) {
    const mapd_point point = {as_f(q[1]), as_f(q[2]), as_f(q[3]), q[4]};
    mapd_track_position track;
    must(mapd_road_to_track(map, road, point, &track, &error));
    add_f(out, track.s);
    add_f(out, track.t);
    add_u(out, track.has_h);
    add_f(out, track.h);
    add_f(out, track.distance);
    add_u(out, track.clamped);
    add_u(out, track.exact);
  } else if (strcmp(kind, "inertial") == 0) {
    const mapd_track track = {as_f(q[1]), as_f(q[2]), as_f(q[3])};
    mapd_pose pose;
    must(mapd_road_to_inertial(map, road, track, &pose, &error));
    add_pose(out, pose);
  } else {
    mapd_surface surface;
    must(mapd_road_surface_at(map, road, as_f(q[1]), as_f(q[2]), &surface, &error));
    add_v(out, surface.position);
    add_v(out, surface.normal);
    add_u(out, lane_bits(surface.lane));
    add_u(out, surface.has_material);
    add_f(out, surface.material.friction);
    add_u(out, surface.clamped);
  }
}

static void at(mapd_lane_id lane, double s, struct numbers *out) {
  mapd_lane_edges edges;
  mapd_waypoint waypoint;
  mapd_lane_bounds bounds;
  mapd_lane_facts facts;
  mapd_speed_rule rule;
  mapd_road_mark mark;
  double width, limit = 0.0, length;
  must(mapd_lane_edges_at(map, lane, s, &edges, &error));
  must(mapd_lane_width_at(map, lane, s, &width, &error));
  add_f(out, edges.inner);
  add_f(out, edges.outer);
  add_f(out, width);
  add_u(out, (uint64_t)is(mapd_lane_speed_limit_at(map, lane, s, &limit, &error)));
  add_f(out, limit);
  must(mapd_lane_waypoint_at(map, lane, s, &waypoint, &error));
  add_f(out, waypoint.s);
  add_v(out, waypoint.position);
  add_f(out, waypoint.heading);
  add_f(out, waypoint.width);
  must(mapd_lane_bounds_at(map, lane, s, &bounds, &error));
  must(mapd_lane_facts_of(map, lane, &facts, &error));
  must(mapd_lane_length_between(map, lane, s, facts.s_end, &length, &error));
  add_v(out, bounds.left);
  add_v(out, bounds.right);
  add_f(out, length);
  must(mapd_lane_speed_rule_at(map, lane, s, &rule, &error));
  add_u(out, rule.has_max);
  add_f(out, rule.max);
  add_u(out, signal_bits(rule.signal));
  const int marked = is(mapd_lane_road_mark_at(map, lane, s, &mark, &error));
  add_u(out, (uint64_t)marked);
  if (marked) {
    add_u(out, mark.kind);
    add_u(out, mark.color);
    add_f(out, mark.width_or_default);
  }
}

static void facts(mapd_lane_id lane, struct numbers *out) {
  char key[1024];
  size_t length, count;
  mapd_lane_facts facts;
  uint8_t turn;
  static mapd_right_of_way ways[MOST];
  static mapd_lane_signal lights[MOST];
  const uint32_t sides[] = {MAPD_BESIDE_LEFT, MAPD_BESIDE_RIGHT, MAPD_BESIDE_OPPOSITE};
  must(mapd_lane_key(map, lane, key, sizeof key, &length, &error));
  must(mapd_lane_facts_of(map, lane, &facts, &error));
  add_u(out, hash_of(key, length));
  add_u(out, (uint32_t)facts.number);
  add_u(out, facts.kind);
  add_u(out, facts.is_forward);
  add_f(out, facts.s_start);
  add_f(out, facts.s_end);
  for (size_t i = 0; i < 3; ++i) {
    mapd_lane_id beside;
    const int there = is(mapd_lane_beside(map, lane, sides[i], &beside, &error));
    add_u(out, there ? lane_bits(beside) : MAPD_NO_ROW);
  }
  add_lanes(out, mapd_lane_successors, lane);
  add_lanes(out, mapd_lane_predecessors, lane);
  add_lanes(out, mapd_lane_entries, lane);
  add_lanes(out, mapd_lane_movement_lanes, lane);
  must(mapd_lane_turn(map, lane, &turn, &error));
  add_u(out, turn);
  must(mapd_lane_right_of_way(map, lane, ways, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, lane_bits(ways[i].other));
    add_u(out, ways[i].relation);
    add_u(out, ways[i].reason);
  }
  must(mapd_lane_movement_lights(map, lane, lights, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, signal_bits(lights[i].signal));
    add_u(out, lane_bits(lights[i].lane));
  }
}

static void lanes(const char *kind, const uint64_t *q, struct numbers *out) {
  const mapd_lane_id lane = lane_of(q[0]);
  size_t count;
  if (strcmp(kind, "pose") == 0) {
    mapd_pose pose;
    must(mapd_lane_pose_at(map, lane, as_f(q[1]), as_f(q[2]), &pose, &error));
    add_pose(out, pose);
  } else if (strcmp(kind, "position") == 0) {
    const mapd_point point = {as_f(q[1]), as_f(q[2]), 0.0, 0};
    mapd_nearest found;
    found.lane = lane;
    must(mapd_lane_position_of(map, lane, point, &found.position, &error));
    add_nearest(out, found);
  } else if (strcmp(kind, "line") == 0) {
    static mapd_line_point all[MOST];
    must(mapd_lane_line(map, lane, MAPD_LINE_CENTER, all, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      add_f(out, all[i].s);
      add_v(out, all[i].position);
    }
  } else if (strcmp(kind, "ahead") == 0) {
    static mapd_signal_ahead all[MOST];
    const mapd_lane_place place = {lane, as_f(q[1])};
    must(mapd_signals_ahead(map, place, as_f(q[2]), CAR, scratch, all, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      add_u(out, signal_bits(all[i].signal));
      add_u(out, lane_bits(all[i].lane));
      add_f(out, all[i].distance);
      add_f(out, all[i].s);
    }
  } else if (strcmp(kind, "sequences") == 0) {
    static mapd_lane_id all[MOST];
    static size_t ends[MOST];
    size_t ends_count, i = 0;
    const mapd_lane_place place = {lane, as_f(q[1])};
    must(mapd_lane_sequences(map, place, as_f(q[2]), CAR, 1, scratch, all, MOST, &count, ends, MOST, &ends_count, NULL,
                             &error));
    add_u(out, ends_count);
    for (size_t k = 0; k < ends_count; ++k) {
      add_u(out, ends[k] - i);
      for (; i < ends[k]; ++i) add_u(out, lane_bits(all[i]));
    }
  } else if (strcmp(kind, "junction") == 0) {
    const mapd_lane_place place = {lane, as_f(q[1])};
    mapd_next_junction next;
    const int found = is(mapd_next_junction_of(map, place, as_f(q[2]), CAR, &next, &error));
    add_u(out, (uint64_t)found);
    if (found) {
      add_u(out, junction_bits(next.junction));
      add_f(out, next.distance);
    }
  } else if (strcmp(kind, "at") == 0) {
    at(lane, as_f(q[1]), out);
  } else {
    facts(lane, out);
  }
}

static void routes(const char *kind, const uint64_t *q, struct numbers *out) {
  size_t count;
  mapd_cost cost = {MAPD_COST_LENGTH, CAR, 20.0};
  const mapd_lane_place from = {lane_of(q[0]), as_f(q[1])};
  if (strcmp(kind, "reachable") == 0) {
    static mapd_reached all[MOST];
    must(mapd_reachable(map, from, as_f(q[2]), cost, scratch, all, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      add_u(out, node_bits(all[i].node));
      add_f(out, all[i].cost);
    }
    return;
  }
  static mapd_route_step steps[MOST];
  static mapd_lane_line_at lines[MOST];
  const mapd_lane_place places[] = {from, {lane_of(q[2]), as_f(q[3])}};
  mapd_route_sum sum;
  if (q[4] == 1) {
    cost.by = MAPD_COST_TIME;
    cost.lane_change = 2.0;
  }
  const int found = is(mapd_route(map, places, 2, cost, scratch, &sum, steps, MOST, &count, &error));
  add_u(out, (uint64_t)found);
  if (!found) return;
  add_f(out, sum.cost);
  add_f(out, sum.length);
  add_f(out, sum.travel_time);
  add_u(out, sum.lane_changes);
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, lane_bits(steps[i].lane));
    add_u(out, steps[i].forward);
    add_u(out, steps[i].enter);
    add_f(out, steps[i].s_from);
    add_f(out, steps[i].s_to);
    add_f(out, steps[i].s_latest);
  }
  size_t line_count;
  must(mapd_lines_along(map, steps, count, scratch, lines, MOST, &line_count, &error));
  add_u(out, line_count);
  for (size_t i = 0; i < line_count; ++i) {
    add_u(out, signal_bits(lines[i].signal));
    add_u(out, object_bits(lines[i].object));
    add_u(out, lane_bits(lines[i].lane));
    add_f(out, lines[i].s);
    add_f(out, lines[i].distance);
    add_u(out, lines[i].class_code);
  }
}

static void geodetic(const uint64_t *q, struct numbers *out) {
  const mapd_vec3 point = {as_f(q[0]), as_f(q[1]), as_f(q[2])};
  mapd_geodetic place;
  const int there = projector != NULL && mapd_to_geodetic(projector, point, &place, &error) == MAPD_CODE_OK;
  add_u(out, (uint64_t)there);
  if (there) {
    add_f(out, place.latitude);
    add_f(out, place.longitude);
    add_f(out, place.altitude);
  }
}

/* Whether a kind stands among words with blanks around each. */
static int one_of(const char *kind, const char *all) {
  char word[32];
  snprintf(word, sizeof word, " %s ", kind);
  return strstr(all, word) != NULL;
}

int main(int argc, char **argv) {
  if (argc != 3) return EXIT_FAILURE;
  must(mapd_snapshot_open(argv[1], &map, &error));
  must(mapd_scratch_new(&scratch, &error));
  if (mapd_projector_new(map, &projector, &error) != MAPD_CODE_OK) projector = NULL;
  FILE *file = fopen(argv[2], "r");
  if (!file) return EXIT_FAILURE;
  char *line = NULL, *kind = NULL;
  size_t room = 0, asked = 0, wrong = 0;
  struct numbers question = {0}, answer = {0}, found = {0};
  while (read_line(file, &line, &room, &kind, &question, &answer)) {
    found.count = 0;
    if (one_of(kind, " nearest near objects landmarks ")) {
      points(kind, question.all, &found);
    } else if (one_of(kind, " track inertial surface ")) {
      roads(kind, question.all, &found);
    } else if (one_of(kind, " route reachable ")) {
      routes(kind, question.all, &found);
    } else if (strcmp(kind, "geodetic") == 0) {
      geodetic(question.all, &found);
    } else if (one_of(kind, " pose position at lane line ahead sequences junction ")) {
      lanes(kind, question.all, &found);
    } else {
      fprintf(stderr, "no kind %s\n", kind);
      return EXIT_FAILURE;
    }
    ++asked;
    if (!same(&answer, &found) && wrong++ < 5) fprintf(stderr, "question %zu, %s: another answer\n", asked, kind);
  }
  fclose(file);
  free(line);
  free(question.all);
  free(answer.all);
  free(found.all);
  mapd_projector_close(&projector);
  mapd_scratch_close(&scratch);
  mapd_snapshot_close(&map);
  printf("%zu questions, %zu other answers\n", asked, wrong);
  return asked > 0 && wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
