/* Questions about what a path comes by, and ways from and to it. */
#include "c.h"

enum { CHANGE = 15 };
static const char *const YIELDS[] = {"yields", "priority", "lights", "unknown"};
static const char *const EDGES[] = {"lane", "kerb", "end"};

static uint64_t word_hash(uint32_t vocabulary, uint16_t code) {
  mapd_text text;
  must(mapd_word(vocabulary, code, &text, &error));
  return text_hash(text);
}

static void add_line(struct numbers *out, const mapd_lane_line_at *line) {
  add_u(out, signal_bits(line->signal));
  add_u(out, object_bits(line->object));
  add_u(out, lane_bits(line->lane));
  add_f(out, line->s);
  add_u(out, word_hash(MAPD_WORDS_CLASS, line->class_code));
}

void add_steps(struct numbers *out, const mapd_route_step *steps, size_t count) {
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, lane_bits(steps[i].lane));
    add_u(out, steps[i].forward);
    add_u(out, steps[i].enter);
    add_f(out, steps[i].s_from);
    add_f(out, steps[i].s_to);
    add_f(out, steps[i].s_latest);
  }
}

static void add_fact(struct numbers *out, const mapd_path_fact *fact) {
  mapd_junction_facts junction;
  mapd_text country;
  uint64_t classes = 0;
  add_f(out, fact->along_from);
  add_f(out, fact->along_to);
  add_u(out, lane_bits(fact->lane));
  add_u(out, fact->kind);
  switch (fact->kind) {
    case MAPD_PATH_FACT_JUNCTION:
      must(mapd_junction_facts_of(map, fact->junction, &junction, &error));
      add_u(out, text_hash(junction.id));
      add_u(out, fact->code);
      break;
    case MAPD_PATH_FACT_SIGNAL:
      add_u(out, signal_bits(fact->signal));
      add_u(out, fact->governs);
      break;
    case MAPD_PATH_FACT_LINE:
      add_line(out, &fact->line);
      add_v(out, fact->left);
      add_v(out, fact->right);
      break;
    case MAPD_PATH_FACT_ROAD_TYPE:
      add_u(out, word_hash(MAPD_WORDS_ROAD_TYPE, fact->code));
      break;
    case MAPD_PATH_FACT_LANE_TYPE:
      add_u(out, word_hash(MAPD_WORDS_LANE_TYPE, fact->code));
      break;
    case MAPD_PATH_FACT_STRUCTURE:
      add_u(out, word_hash(MAPD_WORDS_STRUCTURE_KIND, fact->code));
      add_u(out, fact->number);
      break;
    case MAPD_PATH_FACT_COUNTRY:
      must(mapd_country(map, fact->number, &country, &error));
      add_u(out, text_hash(country));
      break;
    case MAPD_PATH_FACT_ACCESS:
      for (uint16_t code = 0; code < 16; ++code)
        if (fact->number & 1u << code) classes += word_hash(MAPD_WORDS_VEHICLE_CLASS, code);
      add_u(out, classes);
      break;
    default:
      add_u(out, fact->number);
  }
}

static void add_approaches(struct numbers *out, const mapd_path *path, double reach) {
  static mapd_path_conflict conflicts[MOST];
  static mapd_conflict_lane lanes[MOST];
  static mapd_conflict_approach approaches[MOST];
  size_t count, lane_count, found = 0;
  must(mapd_path_conflicts(path, scratch, conflicts, MOST, &count, lanes, MOST, &lane_count, &error));
  if (count > 0) {
    const size_t own = conflicts[0].lanes_to - conflicts[0].lanes_from;
    must(mapd_conflict_approaches(map, lanes + conflicts[0].lanes_from, own, reach, CAR, scratch, approaches, MOST, &found, &error));
  }
  add_u(out, found);
  for (size_t i = 0; i < found; ++i) {
    add_u(out, lane_bits(approaches[i].lane));
    add_f(out, approaches[i].s_from);
    add_f(out, approaches[i].s_to);
    add_f(out, approaches[i].distance_from);
    add_f(out, approaches[i].distance_to);
    add_u(out, approaches[i].forward);
  }
}

static void add_rebased(struct numbers *out, const mapd_path *path) {
  static mapd_route_step steps[MOST];
  static mapd_path_change changes[MOST];
  const mapd_cost by_length = {MAPD_COST_LENGTH, CAR, 20.0, NULL, 0};
  mapd_route_sum sum = {0};
  size_t count, change_count;
  const int found = is(mapd_path_rebase(path, map, by_length, scratch, &sum, steps, MOST, &count, changes, MOST, &change_count,
                                        &error));
  add_u(out, (uint64_t)found);
  add_f(out, sum.cost);
  add_steps(out, steps, count);
  add_u(out, change_count);
}

static void add_joints(struct numbers *out, const mapd_route_step *steps, size_t step_count) {
  static mapd_path_joint joints[MOST];
  mapd_path *path = NULL;
  mapd_path_options options;
  double length;
  size_t count;
  must(mapd_path_options_init(&options, sizeof options, &error));
  options.change_length = CHANGE;
  must(mapd_path_new(map, steps, step_count, &options, &path, &error));
  must(mapd_path_length(path, &length, &error));
  must(mapd_path_joints(path, joints, MOST, &count, &error));
  add_f(out, length);
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, joints[i].along);
    add_f(out, joints[i].gap);
    add_f(out, joints[i].kink);
    add_u(out, joints[i].enter);
    add_u(out, joints[i].broken);
    add_u(out, joints[i].is_short);
  }
  mapd_path_close(&path);
}

void along(const uint64_t *q, const mapd_route_step *steps, size_t step_count, struct numbers *out) {
  static mapd_path_fact facts[MOST];
  static mapd_path_speed speeds[MOST];
  static mapd_path_segment segments[MOST];
  static mapd_route_step part[MOST];
  static mapd_path_crossing crossings[MOST];
  mapd_path *path = NULL;
  mapd_path_time time;
  size_t count;
  must(mapd_path_new(map, steps, step_count, NULL, &path, &error));
  must(mapd_path_facts(path, scratch, facts, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_fact(out, &facts[i]);
  must(mapd_path_speeds(path, scratch, speeds, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, speeds[i].along_from);
    add_f(out, speeds[i].along_to);
    add_u(out, speeds[i].rule.has_max);
    add_f(out, speeds[i].rule.max);
    add_u(out, signal_bits(speeds[i].rule.signal));
  }
  must(mapd_path_travel_time(path, as_f(q[5]), as_f(q[6]), &time, &error));
  add_f(out, time.time);
  add_f(out, time.unlimited);
  must(mapd_path_segments(path, CAR, scratch, segments, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, segments[i].along_from);
    add_f(out, segments[i].along_to);
    add_u(out, lane_bits(segments[i].lane));
    add_f(out, segments[i].last_change);
    add_f(out, segments[i].lane_end);
    add_u(out, segments[i].changes);
    add_u(out, segments[i].forward);
    add_u(out, segments[i].driven);
  }
  const mapd_code cut = mapd_path_steps_between(path, steps, step_count, as_f(q[5]), as_f(q[6]), scratch, part, MOST, &count,
                                                &error);
  if (cut != MAPD_CODE_ARGUMENT) must(cut);
  add_steps(out, part, cut == MAPD_CODE_OK ? count : 0);
  must(mapd_path_crossings(path, scratch, crossings, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, crossings[i].along_from);
    add_f(out, crossings[i].along_to);
    add_f(out, crossings[i].wait);
    add_line(out, &crossings[i].line);
    add_u(out, hash_of(YIELDS[crossings[i].yields], strlen(YIELDS[crossings[i].yields])));
  }
  add_approaches(out, path, as_f(q[7]));
  add_rebased(out, path);
  mapd_path_close(&path);
  add_joints(out, steps, step_count);
}

static void add_edge(struct numbers *out, uint8_t edge) { add_u(out, hash_of(EDGES[edge], strlen(EDGES[edge]))); }

void room(const uint64_t *q, const mapd_route_step *steps, size_t step_count, struct numbers *out) {
  static mapd_corridor_station stations[MOST];
  static mapd_corridor_surface surface[MOST];
  static mapd_vec2 points[MOST];
  mapd_path *path = NULL;
  double length;
  size_t count, surface_count;
  must(mapd_path_new(map, steps, step_count, NULL, &path, &error));
  must(mapd_path_length(path, &length, &error));
  const double step = as_f(q[5]);
  must(mapd_path_corridor(path, 0.0, length, step, CAR, scratch, stations, MOST, &count, &error));
  must(mapd_path_corridor_surface(path, 0.0, length, step, scratch, surface, MOST, &surface_count, &error));
  if (surface_count != count) abort();
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    const mapd_corridor_station *own = &stations[i];
    const mapd_edge_mark outer[] = {own->outer_left_mark, own->outer_right_mark};
    add_f(out, own->s);
    add_u(out, own->speed.has_max);
    add_f(out, own->speed.max);
    add_edge(out, own->left_mark.edge);
    add_edge(out, own->right_mark.edge);
    for (size_t k = 0; k < 2; ++k) {
      add_u(out, outer[k].kind);
      add_u(out, outer[k].color);
      add_u(out, outer[k].may_cross);
      add_edge(out, outer[k].edge);
    }
    add_v(out, surface[i].position);
    add_v(out, surface[i].normal);
    add_f(out, surface[i].friction);
    add_f(out, surface[i].roughness);
  }
  const uint32_t edges[] = {MAPD_CORRIDOR_EDGES_DRIVEN, MAPD_CORRIDOR_EDGES_OPEN};
  for (size_t k = 0; k < 2; ++k) {
    uint8_t is_simple;
    size_t point_count;
    must(mapd_corridor_outline(stations, count, edges[k], scratch, points, MOST, &point_count, &is_simple, &error));
    add_u(out, is_simple);
    add_u(out, point_count);
    for (size_t i = 0; i < point_count; ++i) {
      add_f(out, points[i].x);
      add_f(out, points[i].y);
    }
  }
  mapd_path_close(&path);
}

void comes(const uint64_t *q, struct numbers *out) {
  static mapd_reached all[MOST];
  const mapd_cost cost = {MAPD_COST_LENGTH, CAR, 20.0, NULL, 0};
  const mapd_position_on_lane to = {lane_of(q[0]), as_f(q[1])};
  size_t count;
  must(mapd_reachable_to(map, to, as_f(q[2]), cost, scratch, all, MOST, &count, &error));
  add_reached(out, all, count);
}
