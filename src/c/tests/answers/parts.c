/* Questions about parts of the map, one by one and in lists. */
#include "c.h"

static void add_lanes(struct numbers *out, const mapd_lane_id *all, size_t count) {
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_u(out, lane_bits(all[i]));
}

/* A text of the map, terminated by 0: as calls take ids. The next call overwrites it. */
static const char *terminated(mapd_text text) {
  static char copy[4096];
  if (text.size >= sizeof copy) abort();
  memcpy(copy, text.data, text.size);
  copy[text.size] = '\0';
  return copy;
}

static void road(const uint64_t *q, struct numbers *out) {
  static mapd_lane_id lanes[MOST];
  const mapd_road_id road = {(uint32_t)q[0], 0, content};
  const double s = as_f(q[1]), t = as_f(q[2]);
  mapd_text id;
  mapd_lane_id lane;
  double number;
  size_t count;
  must(mapd_road_name_id(map, road, &id, &error));
  add_u(out, text_hash(id));
  must(mapd_road_elevation_at(map, road, s, &number, &error));
  add_f(out, number);
  must(mapd_road_superelevation_at(map, road, s, &number, &error));
  add_f(out, number);
  must(mapd_road_lane_offset_at(map, road, s, &number, &error));
  add_f(out, number);
  add_u(out, is(mapd_road_lane_at(map, road, s, t, &lane, &error)) ? lane_bits(lane) : MAPD_NO_ROW);
  must(mapd_road_section_lanes(map, road, 0, lanes, MOST, &count, &error));
  add_lanes(out, lanes, count);
}

static void region(const uint64_t *q, struct numbers *out) {
  static mapd_lane_id lanes[MOST];
  static mapd_signal_id signals[MOST];
  static mapd_placement_id objects[MOST];
  static mapd_landmark landmarks[MOST];
  static mapd_boundary_segment bounds[MOST];
  static mapd_road_mark_segment marks[MOST];
  const mapd_region region = {{as_f(q[0]), as_f(q[1])}, {as_f(q[2]), as_f(q[3])}};
  size_t count;
  must(mapd_lanes_in(map, region, UINT64_MAX, scratch, lanes, MOST, &count, &error));
  add_lanes(out, lanes, count);
  must(mapd_signals_in(map, region, scratch, signals, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_u(out, signal_bits(signals[i]));
  must(mapd_objects_in(map, region, scratch, objects, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, object_bits(objects[i].object));
    add_u(out, objects[i].copy);
  }
  must(mapd_landmarks_in(map, region, NULL, scratch, landmarks, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_v(out, landmarks[i].position);
    add_f(out, landmarks[i].distance);
  }
  must(mapd_boundary_segments(map, region, UINT64_MAX, scratch, bounds, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, lane_bits(bounds[i].lane));
    add_f(out, bounds[i].s_from);
    add_f(out, bounds[i].s_to);
    add_v(out, bounds[i].from);
    add_v(out, bounds[i].to);
  }
  must(mapd_road_mark_segments(map, region, UINT64_MAX, scratch, marks, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, lane_bits(marks[i].segment.lane));
    add_f(out, marks[i].segment.s_from);
    add_f(out, marks[i].width);
    add_u(out, marks[i].kind);
    add_u(out, marks[i].color);
  }
}

static void add_line(struct numbers *out, const mapd_lane_line_at *line) {
  add_u(out, lane_bits(line->lane));
  add_f(out, line->s);
  add_u(out, line->class_code);
}

static void details(const uint64_t *q, struct numbers *out) {
  static mapd_road_mark marks[MOST];
  static mapd_object_lane objects[MOST];
  static mapd_lane_line_at lines[MOST];
  static mapd_node_id nodes[MOST];
  static const uint32_t kinds[] = {MAPD_LANE_LINES_TO_STOP_AT, MAPD_LANE_LINES_CROSSINGS, MAPD_LANE_LINES_MOVEMENT_CROSSINGS};
  const mapd_lane_id lane = lane_of(q[0]);
  const double s = as_f(q[1]);
  mapd_lane_facts facts;
  mapd_pose pose;
  mapd_overtaking_rule rule;
  mapd_lane_height height;
  mapd_material material;
  mapd_node_id node;
  double time;
  size_t count;
  must(mapd_lane_facts_of(map, lane, &facts, &error));
  must(mapd_lane_pose_of_reference_line(map, lane, s, 0.5, &pose, &error));
  add_pose(out, pose);
  must(mapd_lane_time_between(map, lane, s, facts.s_end, &time, &error));
  add_f(out, time);
  must(mapd_lane_overtaking_rule_at(map, lane, s, &rule, &error));
  add_u(out, signal_bits(rule.all));
  add_u(out, signal_bits(rule.trucks));
  must(mapd_lane_height_at(map, lane, s, &height, &error));
  add_f(out, height.inner);
  add_f(out, height.outer);
  const int has_material = is(mapd_lane_material_at(map, lane, s, &material, &error));
  add_u(out, (uint64_t)has_material);
  add_f(out, has_material ? material.friction : -1.0);
  must(mapd_lane_road_marks(map, lane, marks, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_f(out, marks[i].s);
    add_f(out, marks[i].s_end);
    add_f(out, marks[i].width_or_default);
    add_u(out, marks[i].kind);
    add_u(out, marks[i].color);
  }
  must(mapd_lane_objects(map, lane, objects, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, object_bits(objects[i].object));
    add_f(out, objects[i].s_low);
    add_f(out, objects[i].s_high);
    add_f(out, objects[i].distance);
  }
  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k) {
    must(mapd_lane_lines(map, lane, kinds[k], lines, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) add_line(out, &lines[i]);
  }
  const int stops = is(mapd_lane_movement_stop(map, lane, lines, &error));
  add_u(out, (uint64_t)stops);
  if (stops) add_line(out, lines);
  const int has_node = is(mapd_lane_node_at(map, lane, s, facts.is_forward, &node, &error));
  add_u(out, has_node ? node_bits(node) : MAPD_NO_ROW);
  count = 0;
  if (has_node) must(mapd_node_predecessors(map, node, nodes, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_u(out, node_bits(nodes[i]));
}

static void sign(const uint64_t *q, struct numbers *out) {
  static mapd_signal_link links[MOST];
  static mapd_lane_id movements[MOST];
  static uint32_t controllers[MOST];
  static const uint32_t kinds[] = {MAPD_SIGNAL_LINKS_DEPENDENCIES, MAPD_SIGNAL_LINKS_BELONGINGS};
  const mapd_signal_id signal = {(uint32_t)q[0], 0, content};
  mapd_signal_facts facts;
  mapd_signal_id same_name;
  size_t count;
  if (mapd_signals(map, NULL, 0, &count, &error) != MAPD_CODE_TOO_SMALL) abort();
  add_u(out, count);
  must(mapd_signal_facts_of(map, signal, &facts, &error));
  if (is(mapd_signal_by_id(map, terminated(facts.id), &same_name, &error))) {
    add_signal(out, same_name);
  } else {
    add_u(out, MAPD_NO_ROW);
  }
  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k) {
    must(mapd_signal_links(map, signal, kinds[k], links, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      add_u(out, text_hash(links[i].id));
      add_u(out, text_hash(links[i].kind));
      add_u(out, signal_bits(links[i].signal));
      add_u(out, object_bits(links[i].object));
      add_u(out, links[i].is_object);
    }
  }
  must(mapd_signal_movements(map, signal, movements, MOST, &count, &error));
  add_lanes(out, movements, count);
  must(mapd_signal_controllers(map, signal, controllers, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) add_u(out, controllers[i]);
}

static void thing(const uint64_t *q, struct numbers *out) {
  static mapd_object_lane lanes[MOST];
  static mapd_placement_facts placements[MOST];
  static mapd_vec3 corners[MOST];
  const mapd_object_id object = {(uint32_t)q[0], 0, content};
  mapd_object_facts facts;
  mapd_object_id same_name;
  size_t count, corner_count;
  if (mapd_objects(map, NULL, 0, &count, &error) != MAPD_CODE_TOO_SMALL) abort();
  add_u(out, count);
  must(mapd_object_facts_of(map, object, &facts, &error));
  add_u(out, is(mapd_object_by_id(map, terminated(facts.id), &same_name, &error)) ? object_bits(same_name) : MAPD_NO_ROW);
  must(mapd_object_lanes(map, object, lanes, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, lane_bits(lanes[i].lane));
    add_f(out, lanes[i].s_low);
    add_f(out, lanes[i].distance);
  }
  must(mapd_object_placements(map, object, placements, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    mapd_placement_facts place;
    must(mapd_placement_facts_of(map, placements[i].place, &place, &error));
    must(mapd_placement_footprint(map, placements[i].place, scratch, corners, MOST, &corner_count, &error));
    add_v(out, place.position);
    add_f(out, place.heading);
    add_f(out, place.length);
    add_f(out, place.height);
    add_u(out, corner_count);
    for (size_t k = 0; k < corner_count; ++k) add_v(out, corners[k]);
  }
}

static void earth(const uint64_t *q, struct numbers *out) {
  const mapd_geodetic place = {as_f(q[0]), as_f(q[1]), as_f(q[2])};
  mapd_vec3 point;
  must(mapd_from_geodetic(projector, place, &point, &error));
  add_v(out, point);
}

static void junctions(struct numbers *out) {
  static mapd_junction_id all[MOST];
  static mapd_connection connections[MOST];
  static uint32_t controllers[MOST];
  size_t count, own;
  must(mapd_junctions(map, all, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    mapd_junction_facts facts;
    mapd_junction_id same_name;
    must(mapd_junction_facts_of(map, all[i], &facts, &error));
    add_u(out, junction_bits(all[i]));
    add_u(out, text_hash(facts.id));
    const int found = is(mapd_junction_by_id(map, terminated(facts.id), &same_name, &error));
    add_u(out, found ? junction_bits(same_name) : MAPD_NO_ROW);
    must(mapd_junction_connections(map, all[i], connections, MOST, &own, &error));
    add_u(out, own);
    for (size_t k = 0; k < own; ++k) {
      add_u(out, text_hash(connections[k].id));
      add_u(out, connections[k].contact);
    }
    must(mapd_junction_controllers(map, all[i], controllers, MOST, &own, &error));
    add_u(out, own);
    for (size_t k = 0; k < own; ++k) add_u(out, controllers[k]);
  }
}

static void junction_groups(struct numbers *out) {
  static mapd_junction_group all[MOST];
  static mapd_junction_id members[MOST];
  static mapd_lane_id ring[MOST];
  size_t count, own;
  must(mapd_junction_groups(map, all, MOST, &count, &error));
  add_u(out, count);
  for (uint32_t i = 0; i < count; ++i) {
    add_u(out, text_hash(all[i].id));
    add_u(out, all[i].kind);
    must(mapd_junction_group_members(map, i, members, MOST, &own, &error));
    add_u(out, own);
    must(mapd_junction_group_ring(map, i, ring, MOST, &own, &error));
    add_lanes(out, ring, own);
  }
}

static void whole(struct numbers *out) {
  static mapd_controller controllers[MOST];
  static mapd_structure structures[MOST];
  static mapd_object_reference references[MOST];
  static mapd_quarantined quarantined[MOST];
  mapd_geodetic_bounds bounds;
  size_t count;
  must(mapd_node_count(map, &count, &error));
  add_u(out, count);
  junctions(out);
  must(mapd_controllers(map, controllers, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, text_hash(controllers[i].id));
    add_u(out, text_hash(controllers[i].name));
  }
  junction_groups(out);
  must(mapd_structures(map, structures, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, text_hash(structures[i].id));
    add_f(out, structures[i].s_from);
    add_f(out, structures[i].s_to);
    add_u(out, structures[i].kind);
  }
  must(mapd_object_references(map, references, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, text_hash(references[i].id));
    add_f(out, references[i].s);
    add_f(out, references[i].t);
  }
  must(mapd_quarantined_parts(map, quarantined, MOST, &count, &error));
  add_u(out, count);
  const int is_placed = is(mapd_map_geodetic_bounds(map, &bounds, &error));
  add_u(out, (uint64_t)is_placed);
  if (is_placed) {
    add_f(out, bounds.south);
    add_f(out, bounds.north);
    add_f(out, bounds.west);
    add_f(out, bounds.east);
  }
}

void parts(const char *kind, const uint64_t *q, struct numbers *out) {
  if (strcmp(kind, "road") == 0) {
    road(q, out);
  } else if (strcmp(kind, "region") == 0) {
    region(q, out);
  } else if (strcmp(kind, "details") == 0) {
    details(q, out);
  } else if (strcmp(kind, "sign") == 0) {
    sign(q, out);
  } else if (strcmp(kind, "thing") == 0) {
    thing(q, out);
  } else if (strcmp(kind, "earth") == 0) {
    earth(q, out);
  } else {
    whole(out);
  }
}
