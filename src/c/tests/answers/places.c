/* Questions about places and roads. */
#include "c.h"

static mapd_road_id road_of(uint64_t bits) {
  const mapd_road_id id = {(uint32_t)bits, 0, content};
  return id;
}

void points(const char *kind, const uint64_t *q, struct numbers *out) {
  size_t count;
  if (strcmp(kind, "nearest") == 0 || strcmp(kind, "near") == 0) {
    const mapd_point point = point_of(q);
    mapd_nearest_options options;
    must(mapd_nearest_options_init(&options, sizeof options, &error));
    options.radius = as_f(q[4]);
    if (strcmp(kind, "nearest") == 0) {
      mapd_nearest hit, batch;
      const int found = is(mapd_nearest_lane(map, point, &options, &hit, &error));
      must(mapd_nearest_lane_batch(map, &point, 1, &options, scratch, &batch, &error));
      if ((batch.lane.row != MAPD_NO_ROW) != found) abort();
      if (found && (batch.lane.row != hit.lane.row || memcmp(&batch.position.s, &hit.position.s, 7 * sizeof(double)) != 0)) abort();
      add_u(out, (uint64_t)found);
      if (found) add_nearest(out, hit.lane, hit.position);
    } else {
      static mapd_nearest all[MOST];
      must(mapd_lanes_near(map, point, &options, scratch, all, MOST, &count, &error));
      add_u(out, count);
      for (size_t i = 0; i < count; ++i) add_nearest(out, all[i].lane, all[i].position);
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
  } else if (strcmp(kind, "around") == 0) {
    static mapd_near_signal signals[MOST];
    static mapd_near_object objects[MOST];
    const mapd_vec2 at = {as_f(q[0]), as_f(q[1])};
    must(mapd_signals_near(map, at, as_f(q[2]), scratch, signals, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      add_signal(out, signals[i].signal);
      add_f(out, signals[i].distance);
    }
    must(mapd_objects_near(map, at, as_f(q[2]), scratch, objects, MOST, &count, &error));
    add_u(out, count);
    for (size_t i = 0; i < count; ++i) {
      add_object(out, objects[i].place.object);
      add_f(out, objects[i].distance);
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

void roads(const char *kind, const uint64_t *q, struct numbers *out) {
  const mapd_road_id road = road_of(q[0]);
  if (strcmp(kind, "track") == 0) {
    const mapd_point point = {as_f(q[1]), as_f(q[2]), as_f(q[3]), q[4]};
    mapd_track_position track;
    mapd_track_position batch;
    must(mapd_road_to_track(map, road, point, &track, &error));
    must(mapd_road_to_track_batch(map, road, &point, 1, &batch, &error));
    if (batch.s != track.s) abort();
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
    mapd_pose batch;
    must(mapd_road_to_inertial(map, road, track, &pose, &error));
    must(mapd_road_to_inertial_batch(map, road, &track, 1, &batch, &error));
    if (batch.position.x != pose.position.x) abort();
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

void geodetic(const uint64_t *q, struct numbers *out) {
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
