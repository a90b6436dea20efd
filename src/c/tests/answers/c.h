/* What the parts of the C program share: see main.c. */
#ifndef MAPD_TEST_ANSWERS_C_H
#define MAPD_TEST_ANSWERS_C_H

#include "numbers.h"
#include <mapd.h>

/* Entries of the longest list. */
enum { MOST = 1 << 16 };
#define CAR ((uint8_t)MAPD_VEHICLE_CLASS_PASSENGER_CAR)

extern mapd_snapshot *map;
/* The same under an overlay. */
extern mapd_snapshot *under;
extern mapd_scratch *scratch;
extern mapd_projector *projector;
extern mapd_error error;
/* What the map's ids are bound to. Files have its lower half above the row, as the number of an id. */
extern uint64_t content;

/* Ends the program unless the call did what it should. */
void must(mapd_code code);
/* Whether there is an answer. */
int is(mapd_code code);

#define ID(kind)                                                                              \
  static inline uint64_t kind##_bits(mapd_##kind##_id id) {                                   \
    if (id.row == MAPD_NO_ROW) return MAPD_NO_ROW;                                            \
    return id.content == content && id.tile == 0 ? content << 32 | id.row : 0;                \
  }
ID(lane)
ID(signal)
ID(object)
ID(junction)
ID(node)
#undef ID

static inline mapd_lane_id lane_of(uint64_t bits) {
  const mapd_lane_id id = {(uint32_t)bits, 0, content};
  return id;
}

static inline mapd_point point_of(const uint64_t *q) {
  const mapd_point point = {as_f(q[0]), as_f(q[1]), as_f(q[2]), q[3]};
  return point;
}

static inline uint64_t text_hash(mapd_text text) { return hash_of(text.data, text.size); }

void add_v(struct numbers *out, mapd_vec3 v);
void add_nearest(struct numbers *out, mapd_lane_id lane, mapd_lane_position position);
void add_pose(struct numbers *out, mapd_pose pose);
/* The hash of a signal's id, and of an object's. */
void add_signal(struct numbers *out, mapd_signal_id signal);
void add_object(struct numbers *out, mapd_object_id object);

void points(const char *kind, const uint64_t *q, struct numbers *out);
void roads(const char *kind, const uint64_t *q, struct numbers *out);
void geodetic(const uint64_t *q, struct numbers *out);
void parts(const char *kind, const uint64_t *q, struct numbers *out);
void lanes(const char *kind, const uint64_t *q, struct numbers *out);
void routes(const char *kind, const uint64_t *q, struct numbers *out);
void reachable(const uint64_t *q, struct numbers *out);
void ground(const uint64_t *q, struct numbers *out);
void mark(const uint64_t *q, struct numbers *out);
void match(const uint64_t *q, struct numbers *out);
void trace(const uint64_t *q, size_t count, struct numbers *out);
void along(const uint64_t *q, const mapd_route_step *steps, size_t step_count, struct numbers *out);
void room(const uint64_t *q, const mapd_route_step *steps, size_t step_count, struct numbers *out);
void comes(const uint64_t *q, struct numbers *out);
void request(const uint64_t *q, struct numbers *out);
void today(const uint64_t *q, struct numbers *out);
void tracker(const uint64_t *q, size_t count, struct numbers *out);
void stance(const uint64_t *q, struct numbers *out);
void sees(const uint64_t *q, struct numbers *out);
void paint(const uint64_t *q, struct numbers *out);
void add_reached(struct numbers *out, const mapd_reached *all, size_t count);
void add_steps(struct numbers *out, const mapd_route_step *steps, size_t count);

#endif
