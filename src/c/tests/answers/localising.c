/* What a localiser asks. */
#include "c.h"

void ground(const uint64_t *q, struct numbers *out) {
  mapd_ground at, batch;
  const mapd_point point = point_of(q);
  const mapd_lane_id expected = lane_of(q[4]);
  const size_t count = expected.row != MAPD_NO_ROW;
  const int found = is(mapd_ground_at(map, point, &expected, count, scratch, &at, &error));
  must(mapd_ground_at_batch(map, &point, 1, &expected, count, scratch, &batch, &error));
  if ((batch.lane.row != MAPD_NO_ROW) != found || (found && batch.lane.row != at.lane.row)) abort();
  add_u(out, (uint64_t)found);
  if (!found) return;
  add_f(out, at.z);
  add_v(out, at.normal);
  add_f(out, at.s);
  add_f(out, at.t);
  add_u(out, lane_bits(at.lane));
  add_u(out, at.level);
  add_u(out, at.levels);
}

void mark(const uint64_t *q, struct numbers *out) {
  mapd_near_mark at, batch;
  const mapd_vec2 point = {as_f(q[0]), as_f(q[1])};
  const int found = is(mapd_nearest_mark(map, point, NULL, &at, &error));
  must(mapd_nearest_mark_batch(map, &point, 1, NULL, &batch, &error));
  if ((batch.lane.row != MAPD_NO_ROW) != found) abort();
  add_u(out, (uint64_t)found);
  if (!found) return;
  add_u(out, lane_bits(at.lane));
  add_f(out, at.s);
  add_f(out, at.place.x);
  add_f(out, at.place.y);
  add_f(out, at.distance);
  add_f(out, at.width);
  add_u(out, at.left_of_reference_line);
  add_u(out, at.kind);
  add_u(out, at.color);
  add_u(out, at.painted);
}

void match(const uint64_t *q, struct numbers *out) {
  static mapd_lane_match all[MOST];
  const mapd_vehicle_pose pose = {point_of(q), as_f(q[4])};
  double covariance[9], none;
  size_t count;
  for (size_t i = 0; i < 9; ++i) covariance[i] = as_f(q[5 + i]);
  must(mapd_match_pose(map, pose, covariance, NULL, scratch, all, MOST, &count, &none, &error));
  mapd_lane_match first;
  size_t batch_count, end;
  double batch_none;
  const mapd_code batch = mapd_match_pose_batch(map, &pose, 1, covariance, 1, NULL, scratch, &first, 1, &batch_count, &end,
                                                &batch_none, &error);
  if (batch != (count > 1 ? MAPD_CODE_TOO_SMALL : MAPD_CODE_OK) || batch_count != count || end != count) abort();
  if (batch_none != none || (count > 0 && first.probability != all[0].probability)) abort();
  add_f(out, none);
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    add_u(out, all[i].forward);
    add_f(out, all[i].probability);
    add_f(out, all[i].mahalanobis);
    add_f(out, all[i].heading_difference);
    add_nearest(out, all[i].lane, all[i].position);
  }
}

void trace(const uint64_t *q, size_t count, struct numbers *out) {
  enum { PARTS = 5, FIXES = 64 };
  mapd_trace_fix fixes[FIXES] = {0};
  mapd_trace_match found[FIXES];
  const size_t fix_count = count / PARTS;
  if (fix_count > FIXES) abort();
  for (size_t i = 0; i < fix_count; ++i, q += PARTS) {
    const mapd_trace_fix fix = {as_f(q[0]), {as_f(q[1]), as_f(q[2]), 0.0, 0}, as_f(q[4]), (uint8_t)q[3]};
    fixes[i] = fix;
  }
  must(mapd_match_trace(map, fixes, fix_count, NULL, scratch, found, &error));
  for (size_t i = 0; i < fix_count; ++i) {
    const int is_on = found[i].lane.row != MAPD_NO_ROW;
    add_u(out, found[i].forward);
    add_f(out, found[i].probability);
    add_u(out, (uint64_t)is_on);
    if (is_on) add_nearest(out, found[i].lane, found[i].position);
  }
}
