/* Questions about what is laid over a map. */
#include "c.h"

static void add_restriction(struct numbers *out, const mapd_restriction *one) {
  if (one->entry == MAPD_NO_ROW) {
    add_u(out, MAPD_NO_ROW);
    return;
  }
  add_u(out, one->entry);
  add_u(out, lane_bits(one->lane));
  add_f(out, one->s_from);
  add_f(out, one->s_to);
}

static void add_restrictions(struct numbers *out, const mapd_restriction *all, size_t count) {
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_restriction(out, &all[i]);
}

static void add_entries(struct numbers *out, const mapd_view *view) {
  static mapd_overlay_entry entries[MOST];
  size_t count;
  must(mapd_view_entries(view, entries, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    mapd_text kind;
    if (entries[i].number != i) abort();
    must(mapd_word(MAPD_WORDS_OVERLAY_KIND, entries[i].kind, &kind, &error));
    add_u(out, text_hash(entries[i].id));
    add_u(out, text_hash(kind));
    add_u(out, text_hash(entries[i].source));
    add_f(out, entries[i].value);
    add_f(out, entries[i].confidence);
    add_u(out, entries[i].vehicles >> MAPD_VEHICLE_CLASS_PEDESTRIAN & 1);
    add_u(out, entries[i].holds);
  }
}

static void add_on_path(struct numbers *out, const mapd_view *view, const mapd_path *path) {
  static mapd_path_restriction met[MOST];
  static mapd_corridor_station stations[MOST];
  mapd_speed_today speed;
  double length;
  size_t count;
  must(mapd_path_length(path, &length, &error));
  must(mapd_view_restrictions_on_path(view, path, CAR, met, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, met[i].along_from);
    add_f(out, met[i].along_to);
    add_restriction(out, &met[i].restriction);
  }
  must(mapd_view_speed_on_path(view, path, 0.5 * length, CAR, &speed, &error));
  add_u(out, speed.has_max);
  add_f(out, speed.max);
  add_restriction(out, &speed.restriction);
  must(mapd_view_corridor(view, path, 0.0, length, length / 4.0, CAR, scratch, stations, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_v(out, stations[i].outer_left);
    add_v(out, stations[i].outer_right);
    add_u(out, stations[i].left_mark.may_cross);
    add_u(out, stations[i].speed.has_max);
    add_f(out, stations[i].speed.max);
    add_u(out, stations[i].speed.origin == MAPD_SPEED_ORIGIN_OVERLAY);
  }
  static mapd_path_speed_today speeds[MOST];
  static mapd_path_segment segments[MOST];
  mapd_path_time time;
  must(mapd_view_speeds_on_path(view, path, CAR, speeds, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, speeds[i].along_from);
    add_f(out, speeds[i].along_to);
    add_u(out, speeds[i].today.has_max);
    add_f(out, speeds[i].today.max);
    add_restriction(out, &speeds[i].today.restriction);
  }
  must(mapd_view_travel_time_on_path(view, path, 0.0, length, CAR, &time, &error));
  add_f(out, time.time);
  add_f(out, time.unlimited);
  must(mapd_view_segments_on_path(view, path, CAR, scratch, segments, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, segments[i].along_from);
    add_f(out, segments[i].along_to);
    add_u(out, lane_bits(segments[i].lane));
    add_u(out, segments[i].changes);
    add_f(out, segments[i].last_change);
  }
}

static void add_ahead(struct numbers *out, const mapd_view *view, mapd_position_on_lane from, double limit) {
  static mapd_reached_piece reached[MOST];
  static mapd_signal_ahead ahead[MOST];
  const mapd_cost cost = {MAPD_COST_LENGTH, CAR, 20.0, NULL, 0};
  size_t count;
  must(mapd_view_reachable(view, from, limit, cost, scratch, reached, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, lane_bits(reached[i].lane));
    add_u(out, reached[i].forward);
    add_f(out, reached[i].s_from);
    add_f(out, reached[i].s_to);
    add_f(out, reached[i].cost);
  }
  must(mapd_view_signals_ahead(view, from, limit, CAR, scratch, ahead, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, signal_bits(ahead[i].signal));
    add_u(out, lane_bits(ahead[i].lane));
    add_f(out, ahead[i].distance);
    add_f(out, ahead[i].s);
  }
}

static void add_matches(struct numbers *out, const mapd_view *view, const uint64_t *q) {
  static mapd_lane_match matches[MOST];
  const mapd_vehicle_pose pose = {{as_f(q[7]), as_f(q[8]), 0.0, 0}, as_f(q[9])};
  const double covariance[9] = {0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.01};
  mapd_match_options options;
  double none;
  size_t count;
  must(mapd_match_options_init(&options, sizeof options, &error));
  options.has_vehicle = 1;
  options.vehicle = CAR;
  must(mapd_view_match_pose(view, pose, covariance, &options, scratch, matches, MOST, &count, &none, &error));
  add_f(out, none);
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, lane_bits(matches[i].lane));
    add_u(out, matches[i].forward);
    add_f(out, matches[i].probability);
  }
}

void today(const uint64_t *q, struct numbers *out) {
  static mapd_restriction all[MOST];
  static mapd_route_step steps[MOST];
  const mapd_position_on_lane from = {lane_of(q[1]), as_f(q[2])}, to = {lane_of(q[3]), as_f(q[4])};
  const mapd_position_on_lane places[] = {from, to};
  const mapd_cost cost = {MAPD_COST_LENGTH, CAR, 20.0, NULL, 0};
  mapd_view *view = NULL;
  mapd_path *path = NULL;
  mapd_permission permission;
  mapd_speed_today speed;
  mapd_route_sum sum = {0};
  size_t count;
  uint32_t off = MAPD_NO_ROW;
  must(mapd_view_new(under, as_f(q[0]), &view, &error));
  add_entries(out, view);
  must(mapd_view_restrictions(view, all, MOST, &count, &error));
  add_u(out, count);
  must(mapd_view_allows(view, from.lane, from.s, CAR, &permission, &error));
  add_u(out, permission.is_allowed);
  add_restriction(out, &permission.restriction);
  must(mapd_view_speed_rule_at(view, from.lane, from.s, CAR, &speed, &error));
  add_u(out, speed.has_max);
  add_f(out, speed.max);
  add_u(out, speed.map.has_max);
  add_f(out, speed.map.max);
  add_restriction(out, &speed.restriction);
  must(mapd_view_restrictions_at(view, from.lane, from.s, all, MOST, &count, &error));
  add_restrictions(out, all, count);
  if (q[6] != MAPD_NO_ROW) {
    const mapd_signal_id signal = {(uint32_t)q[6], 0, content};
    is(mapd_view_signal_out_of_service(view, signal, &off, &error));
  }
  add_u(out, off);
  const int found = is(mapd_view_route(view, places, 2, cost, scratch, &sum, steps, MOST, &count, &error));
  add_u(out, (uint64_t)found);
  add_f(out, sum.cost);
  add_steps(out, steps, count);
  size_t along_count;
  must(mapd_view_restrictions_along(view, steps, count, CAR, scratch, all, MOST, &along_count, &error));
  add_restrictions(out, all, along_count);
  const int is_path = found && mapd_path_new(under, steps, count, NULL, &path, &error) == MAPD_CODE_OK;
  add_u(out, (uint64_t)is_path);
  if (is_path) add_on_path(out, view, path);
  mapd_path_close(&path);
  add_ahead(out, view, from, as_f(q[5]));
  add_matches(out, view, q);
  mapd_view_close(&view);
}
