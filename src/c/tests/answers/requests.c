/* Questions about routes by request. */
#include "c.h"

static void add_reach(struct numbers *out, const mapd_route_request *request, double limit, uint8_t to) {
  static mapd_reached_piece pieces[MOST];
  static mapd_reach_link links[MOST];
  size_t count, link_count, k = 0;
  must(mapd_reach(map, request, limit, to, scratch, pieces, MOST, &count, links, MOST, &link_count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; ++i) {
    size_t own = k;
    while (own < link_count && links[own].from == i) ++own;
    add_u(out, lane_bits(pieces[i].lane));
    add_u(out, pieces[i].forward);
    add_f(out, pieces[i].cost);
    add_f(out, pieces[i].s_from);
    add_f(out, pieces[i].s_to);
    add_u(out, pieces[i].lane_changes);
    add_u(out, own - k);
    for (; k < own; ++k) {
      add_u(out, links[k].to);
      add_u(out, links[k].enter);
    }
  }
}

void request(const uint64_t *q, struct numbers *out) {
  enum { ROUTES = 32 };
  static mapd_route_step steps[MOST];
  mapd_route_end ends[4];
  mapd_route_request request;
  mapd_route_sum sum, sums[ROUTES];
  size_t count, step_count, to[ROUTES], from = 0;
  for (size_t i = 0; i < 4; ++i, q += 4) {
    const mapd_route_end end = {lane_of(q[0]), as_f(q[1]), as_f(q[2]), (uint8_t)q[3]};
    ends[i] = end;
  }
  const mapd_lane_id avoid = lane_of(q[0]);
  must(mapd_route_request_init(&request, sizeof request, &error));
  request.starts = ends;
  request.goals = ends + 2;
  request.start_count = request.goal_count = 2;
  request.avoid = &avoid;
  request.avoid_count = 1;
  request.turn_left = as_f(q[1]);
  request.turn_right = 0.5 * as_f(q[1]);
  request.turn_back = 90.0;
  const int found = is(mapd_find_route(map, &request, scratch, &sum, steps, MOST, &count, &error));
  add_u(out, (uint64_t)found);
  if (found) {
    add_f(out, sum.cost);
    add_f(out, sum.length);
    add_u(out, sum.start);
    add_u(out, sum.goal);
    add_steps(out, steps, count);
  }
  /* A view of a map over which nothing is laid says the same. */
  mapd_view *view = NULL;
  mapd_route_sum today;
  must(mapd_view_new(map, 0.0, &view, &error));
  if (is(mapd_view_find_route(view, &request, scratch, &today, steps, MOST, &step_count, &error)) != found) abort();
  if (found && (today.cost != sum.cost || step_count != count)) abort();
  mapd_view_close(&view);
  must(mapd_alternatives(map, &request, NULL, scratch, sums, to, ROUTES, &count, steps, MOST, &step_count, &error));
  add_u(out, count);
  for (size_t i = 0; i < count; from = to[i++]) {
    add_f(out, sums[i].cost);
    add_steps(out, steps + from, to[i] - from);
  }
  add_reach(out, &request, as_f(q[2]), 0);
  add_reach(out, &request, as_f(q[2]), 1);
}
