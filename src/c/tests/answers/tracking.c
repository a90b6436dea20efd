/* What who drives asks: the lane from fix to fix, how the vehicle stands, what its sensors see. */
#include "c.h"

void tracker(const uint64_t *q, size_t count, struct numbers *out) {
  enum { PARTS = 6 };
  const mapd_lane_id lane = lane_of(*q++);
  mapd_tracker *tracker = NULL;
  must(mapd_tracker_new(&tracker, &error));
  for (size_t i = 0; i + 1 < count; i += PARTS, q += PARTS) {
    const mapd_tracker_fix fix = {as_f(q[0]),
                                  {{as_f(q[1]), as_f(q[2]), 0.0, 0}, as_f(q[3])},
                                  {0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.02},
                                  as_f(q[5]),
                                  (uint8_t)q[4]};
    static mapd_lane_match all[MOST];
    mapd_tracked tracked;
    double none, within;
    size_t found;
    must(mapd_tracker_update(tracker, map, &fix, NULL, &tracked, &error));
    add_u(out, tracked.state);
    if (tracked.state == MAPD_TRACKED_LANE) {
      add_u(out, tracked.found.forward);
      add_f(out, tracked.found.probability);
      add_nearest(out, tracked.found.lane, tracked.found.position);
    }
    must(mapd_tracker_hypotheses(tracker, all, MOST, &found, &none, &error));
    must(mapd_tracker_probability_in(tracker, &lane, 1, &within, &error));
    add_f(out, none);
    add_u(out, found);
    add_f(out, within);
  }
  must(mapd_tracker_reset(tracker, &error));
  mapd_tracker_close(&tracker);
}

void stance(const uint64_t *q, struct numbers *out) {
  const mapd_vehicle_pose pose = {point_of(q), as_f(q[4])};
  const mapd_lane_id expected = lane_of(q[5]);
  const mapd_vec2 wheels[] = {{2.0, 0.8}, {2.0, -0.8}, {-1.0, 0.8}, {-1.0, -0.8}};
  mapd_stance own;
  const int found = is(mapd_stance_at(map, pose, wheels, &expected, expected.row != MAPD_NO_ROW, scratch, &own, &error));
  add_u(out, (uint64_t)found);
  if (!found) return;
  add_f(out, own.z);
  add_f(out, own.roll);
  add_f(out, own.pitch);
  for (size_t i = 0; i < 4; ++i) {
    add_u(out, own.has_wheel[i]);
    add_f(out, own.wheels[i]);
  }
}

void sees(const uint64_t *q, struct numbers *out) {
  static mapd_landmark_in_view all[MOST];
  const mapd_sensor sensor = {{as_f(q[0]), as_f(q[1])}, as_f(q[2]), as_f(q[3]), as_f(q[4])};
  size_t count;
  must(mapd_landmarks_in_view(map, sensor, NULL, scratch, all, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, signal_bits(all[i].landmark.signal));
    add_u(out, object_bits(all[i].landmark.place.object));
    add_u(out, all[i].landmark.place.copy);
    add_f(out, all[i].landmark.distance);
    add_f(out, all[i].bearing);
    add_f(out, all[i].facing);
  }
}

void paint(const uint64_t *q, struct numbers *out) {
  static mapd_mark_point all[MOST];
  const mapd_region region = {{as_f(q[0]), as_f(q[1])}, {as_f(q[2]), as_f(q[3])}};
  size_t count;
  must(mapd_mark_points(map, region, as_f(q[4]), NULL, scratch, all, MOST, &count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_v(out, all[i].position);
    add_u(out, lane_bits(all[i].lane));
    add_u(out, object_bits(all[i].place.object));
    add_u(out, all[i].place.copy);
    add_u(out, all[i].is_outline);
    add_f(out, all[i].s);
    add_f(out, all[i].width);
    add_u(out, all[i].kind);
    add_u(out, all[i].color);
  }
}
