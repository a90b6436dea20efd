/* Questions about lanes. */
#include "c.h"

typedef mapd_code lane_list(const mapd_snapshot *, mapd_lane_id, mapd_lane_id *, size_t, size_t *, mapd_error *);

static void add_lanes(struct numbers *out, lane_list *list, mapd_lane_id lane) {
  static mapd_lane_id all[MOST];
  size_t count;
  must(list(map, lane, all, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_u(out, lane_bits(all[i]));
}

static void edges(mapd_lane_id lane, double s, struct numbers *out) {
  mapd_lane_edges edges;
  mapd_waypoint waypoint;
  mapd_lane_bounds bounds;
  mapd_lane_facts facts;
  mapd_speed_rule rule;
  mapd_road_mark mark;
  double length;
  must(mapd_lane_edges_at(map, lane, s, &edges, &error));
  add_f(out, edges.inner);
  add_f(out, edges.outer);
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
  add_u(out, signal_bits(rule.signal));
  const int marked = is(mapd_lane_road_mark_at(map, lane, s, &mark, &error));
  add_u(out, (uint64_t)marked);
  if (marked) {
    add_u(out, mark.kind);
    add_u(out, mark.color);
    add_f(out, mark.width_or_default);
  }
}

static void at(mapd_lane_id lane, double s, struct numbers *out) {
  mapd_speed_rule rule;
  double width, limit = 0.0;
  uint8_t allowed;
  must(mapd_lane_width_at(map, lane, s, &width, &error));
  add_f(out, width);
  add_u(out, (uint64_t)is(mapd_lane_recorded_speed_limit_at(map, lane, s, &limit, &error)));
  add_f(out, limit);
  must(mapd_lane_speed_rule_at(map, lane, s, &rule, &error));
  add_u(out, rule.has_max);
  add_f(out, rule.max);
  must(mapd_lane_allows_at(map, lane, s, CAR, &allowed, &error));
  add_u(out, allowed);
  static mapd_speed_stretch stretches[MOST];
  size_t count;
  must(mapd_lane_speed_rules(map, lane, stretches, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, stretches[i].s_low);
    add_f(out, stretches[i].s_high);
    add_u(out, stretches[i].rule.has_max);
    add_f(out, stretches[i].rule.max);
    add_u(out, stretches[i].has_lowest);
    add_f(out, stretches[i].lowest);
  }
}

static void facts(mapd_lane_id lane, struct numbers *out) {
  char key[1024];
  size_t length;
  mapd_lane_facts facts;
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
}

static void movement(mapd_lane_id lane, struct numbers *out) {
  size_t count;
  uint8_t turn;
  static mapd_right_of_way ways[MOST];
  static mapd_lane_signal lights[MOST];
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

void lanes(const char *kind, const uint64_t *q, struct numbers *out) {
  const mapd_lane_id lane = lane_of(q[0]);
  size_t count;
  if (strcmp(kind, "pose") == 0) {
    mapd_pose pose;
    must(mapd_lane_pose_at(map, lane, as_f(q[1]), as_f(q[2]), &pose, &error));
    add_pose(out, pose);
  } else if (strcmp(kind, "position") == 0) {
    const mapd_point point = {as_f(q[1]), as_f(q[2]), 0.0, 0};
    mapd_lane_position found;
    must(mapd_lane_position_of(map, lane, point, &found, &error));
    add_nearest(out, lane, found);
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
    const mapd_position_on_lane place = {lane, as_f(q[1])};
    must(mapd_signals_ahead(map, place, as_f(q[2]), CAR, scratch, all, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      add_signal(out, all[i].signal);
      add_u(out, lane_bits(all[i].lane));
      add_f(out, all[i].distance);
      add_f(out, all[i].s);
    }
  } else if (strcmp(kind, "sequences") == 0) {
    static mapd_reached_piece pieces[MOST];
    static mapd_reach_link links[MOST];
    static mapd_lane_id all[MOST];
    size_t link_count;
    const mapd_position_on_lane place = {lane, as_f(q[1])};
    must(mapd_lane_sequences(map, place, as_f(q[2]), CAR, 1, scratch, pieces, MOST, &count, links, MOST, &link_count,
                             &error));
    add_u(out, count);
    add_u(out, link_count);
    while (is(mapd_next_sequence(scratch, all, MOST, &count, &error))) {
      add_u(out, count);
      for (size_t i = 0; i < count; ++i) add_u(out, lane_bits(all[i]));
    }
  } else if (strcmp(kind, "junction") == 0) {
    const mapd_position_on_lane place = {lane, as_f(q[1])};
    mapd_next_junction next;
    const int found = is(mapd_next_junction_of(map, place, as_f(q[2]), CAR, &next, &error));
    add_u(out, (uint64_t)found);
    if (found) {
      add_u(out, junction_bits(next.junction));
      add_f(out, next.distance);
    }
  } else if (strcmp(kind, "at") == 0) {
    at(lane, as_f(q[1]), out);
  } else if (strcmp(kind, "edges") == 0) {
    edges(lane, as_f(q[1]), out);
  } else if (strcmp(kind, "movement") == 0) {
    movement(lane, out);
  } else {
    facts(lane, out);
  }
}
