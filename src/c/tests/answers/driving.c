/* Questions about routes and paths. */
#include "c.h"

static const char *const YIELDS[] = {"yields", "priority", "lights", "unknown"};

/* A route by length or time. 0: none. */
static int route(const uint64_t *q, mapd_route_sum *sum, mapd_route_step *steps, size_t *count) {
  const mapd_position_on_lane places[] = {{lane_of(q[0]), as_f(q[1])}, {lane_of(q[2]), as_f(q[3])}};
  const mapd_cost by_length = {MAPD_COST_LENGTH, CAR, 20.0, NULL, 0}, by_time = {MAPD_COST_TIME, CAR, 2.0, NULL, 0};
  mapd_cost cost = q[4] == 1 ? by_time : by_length;
  static double factors[] = {1.0, 1.0, 1.0};
  mapd_route_sum weighed;
  const int found = is(mapd_route(map, places, 2, cost, scratch, sum, steps, MOST, count, &error));
  cost.factors = factors;
  cost.factor_count = 3;
  if (is(mapd_route(map, places, 2, cost, scratch, &weighed, steps, MOST, count, &error)) != found) abort();
  if (found && weighed.cost != sum->cost) abort();
  return found;
}

static void add_sum(struct numbers *out, const mapd_route_sum *sum, const mapd_route_step *steps, size_t count) {
  add_f(out, sum->cost);
  add_f(out, sum->length);
  add_f(out, sum->travel_time);
  add_f(out, sum->assumed_time);
  add_u(out, sum->lane_changes);
  add_steps(out, steps, count);
}

static void add_lines(struct numbers *out, const mapd_route_step *steps, size_t step_count) {
  static mapd_lane_line_at lines[MOST];
  size_t count;
  must(mapd_lines_along(map, steps, step_count, scratch, lines, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, signal_bits(lines[i].signal));
    add_u(out, object_bits(lines[i].object));
    add_u(out, lane_bits(lines[i].lane));
    add_f(out, lines[i].s);
    add_f(out, lines[i].distance);
    add_u(out, lines[i].class_code);
  }
}

static void add_point(struct numbers *out, const mapd_path *path, double along) {
  mapd_path_point at, batch;
  must(mapd_path_at(path, along, &at, &error));
  must(mapd_path_at_batch(path, &along, 1, &batch, &error));
  if (batch.position.x != at.position.x) abort();
  add_f(out, at.along);
  add_v(out, at.position);
  add_f(out, at.heading);
  add_f(out, at.curvature);
  add_f(out, at.curvature_rate);
  add_f(out, at.grade);
  add_f(out, at.superelevation);
  add_f(out, at.left);
  add_f(out, at.right);
  add_f(out, at.s);
  add_u(out, lane_bits(at.lane));
  add_u(out, at.clamped);
}

static void add_projected(struct numbers *out, const mapd_path *path, mapd_vec2 point) {
  mapd_path_position at, batch;
  must(mapd_path_project(path, point, NULL, &at, &error));
  must(mapd_path_project_batch(path, &point, 1, &batch, &error));
  if (batch.along != at.along) abort();
  add_f(out, at.along);
  add_f(out, at.d);
  add_f(out, at.distance);
  add_f(out, at.heading);
  add_f(out, at.s);
  add_u(out, lane_bits(at.lane));
  add_u(out, at.clamped);
}

static void add_mark(struct numbers *out, mapd_edge_mark mark) {
  add_u(out, mark.kind);
  add_u(out, mark.color);
  add_u(out, mark.may_cross);
}

static void add_room(struct numbers *out, const mapd_path *path, double length, double step) {
  static mapd_corridor_station room[MOST];
  size_t count;
  must(mapd_path_corridor(path, 0.0, length, step, CAR, scratch, room, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, room[i].along);
    add_u(out, lane_bits(room[i].lane));
    add_v(out, room[i].left);
    add_v(out, room[i].right);
    add_v(out, room[i].outer_left);
    add_v(out, room[i].outer_right);
    add_mark(out, room[i].left_mark);
    add_mark(out, room[i].right_mark);
  }
}

static void add_conflicts(struct numbers *out, const mapd_path *path) {
  static mapd_path_conflict all[MOST];
  static mapd_conflict_lane lanes[MOST];
  size_t count, lane_count;
  must(mapd_path_conflicts(path, scratch, all, MOST, &count, lanes, MOST, &lane_count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    mapd_text kind, reason;
    must(mapd_word(MAPD_WORDS_CONFLICT_KIND, all[i].kind, &kind, &error));
    must(mapd_word(MAPD_WORDS_RELATION_REASON, all[i].reason, &reason, &error));
    add_f(out, all[i].along_from);
    add_f(out, all[i].along_to);
    add_u(out, lane_bits(all[i].other));
    add_f(out, all[i].other_s_from);
    add_f(out, all[i].other_s_to);
    add_f(out, all[i].wait);
    add_u(out, text_hash(kind));
    add_u(out, hash_of(YIELDS[all[i].yields], strlen(YIELDS[all[i].yields])));
    add_u(out, text_hash(reason));
    add_u(out, all[i].lanes_to - all[i].lanes_from);
    for (size_t k = all[i].lanes_from; k < all[i].lanes_to; ++k) {
      add_u(out, lane_bits(lanes[k].other));
      add_f(out, lanes[k].along_from);
      add_f(out, lanes[k].along_to);
    }
  }
}

static void add_path(struct numbers *out, const uint64_t *q, const mapd_route_step *steps, size_t step_count) {
  static mapd_path_lane lanes[MOST];
  mapd_path *path = NULL;
  mapd_speed_rule rule = {0};
  const double along = as_f(q[5]), step = as_f(q[8]);
  const mapd_vec2 point = {as_f(q[6]), as_f(q[7])};
  double length;
  uint8_t broken;
  size_t count;
  must(mapd_path_new(map, steps, step_count, NULL, &path, &error));
  must(mapd_path_length(path, &length, &error));
  add_f(out, length);
  must(mapd_path_is_broken(path, &broken, &error));
  add_u(out, broken);
  must(mapd_path_lanes(path, lanes, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_u(out, lane_bits(lanes[i].lane));
  add_point(out, path, along);
  add_projected(out, path, point);
  is(mapd_path_speed_at(path, along, &rule, &error));
  add_u(out, rule.has_max);
  add_f(out, rule.max);
  add_room(out, path, length, step);
  add_conflicts(out, path);
  mapd_path_close(&path);
}

void routes(const char *kind, const uint64_t *q, struct numbers *out) {
  static mapd_route_step steps[MOST];
  mapd_route_sum sum;
  size_t count;
  const int found = route(q, &sum, steps, &count);
  if (strcmp(kind, "route") == 0) {
    add_u(out, (uint64_t)found);
    if (found) add_sum(out, &sum, steps, count);
  } else if (strcmp(kind, "lines") == 0) {
    add_lines(out, steps, count);
  } else if (strcmp(kind, "along") == 0) {
    along(q, steps, count, out);
  } else if (strcmp(kind, "room") == 0) {
    room(q, steps, count, out);
  } else {
    add_path(out, q, steps, count);
  }
}

void reachable(const uint64_t *q, struct numbers *out) {
  static mapd_reached all[MOST];
  const mapd_cost cost = {MAPD_COST_LENGTH, CAR, 20.0, NULL, 0};
  const mapd_position_on_lane from = {lane_of(q[0]), as_f(q[1])};
  size_t count;
  must(mapd_reachable(map, from, as_f(q[2]), cost, scratch, all, MOST, &count, &error));
  add_reached(out, all, count);
}

void add_reached(struct numbers *out, const mapd_reached *all, size_t count) {
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    mapd_node_facts node;
    must(mapd_node_facts_of(map, all[i].node, &node, &error));
    add_u(out, lane_bits(node.lane));
    add_u(out, node.is_forward);
    add_f(out, node.s_low);
    add_f(out, node.s_high);
    add_f(out, all[i].cost);
  }
}
