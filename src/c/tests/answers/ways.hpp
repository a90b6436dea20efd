/// Questions about paths, what is laid over a map, and drives: for main.cpp.
#pragma once

#include "cpp.hpp"

#include <fstream>
#include <iterator>

namespace {

constexpr const char* edges[] = {"lane", "kerb", "end"};
constexpr double change_length = 15.0;

inline std::vector<std::uint8_t> bytes_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void line(const mapd::LaneLine& line, Numbers& a) {
  a.id(line.signal).id(line.object).id(line.lane).f(line.s).word(MAPD_WORDS_CLASS, line.class_code);
}

inline void fact(const mapd::Snapshot& map, const mapd::PathFact& fact, Numbers& a) {
  a.all(fact.along_from, fact.along_to).id(fact.lane).u(fact.kind);
  switch (fact.kind) {
    case MAPD_PATH_FACT_JUNCTION:
      a.text(mapd::view(map.junction(fact.junction).id)).u(fact.code);
      break;
    case MAPD_PATH_FACT_SIGNAL:
      a.id(fact.signal).u(fact.governs);
      break;
    case MAPD_PATH_FACT_LINE:
      line(fact.line, a);
      a.v(fact.left).v(fact.right);
      break;
    case MAPD_PATH_FACT_ROAD_TYPE:
      a.word(MAPD_WORDS_ROAD_TYPE, fact.code);
      break;
    case MAPD_PATH_FACT_LANE_TYPE:
      a.word(MAPD_WORDS_LANE_TYPE, fact.code);
      break;
    case MAPD_PATH_FACT_STRUCTURE:
      a.word(MAPD_WORDS_STRUCTURE_KIND, fact.code).u(fact.number);
      break;
    case MAPD_PATH_FACT_COUNTRY:
      a.text(map.country(fact.number).value_or(std::string_view()));
      break;
    case MAPD_PATH_FACT_ACCESS: {
      std::uint64_t classes = 0;
      for (std::uint16_t code = 0; code < 16; ++code) {
        const auto word = mapd::word(MAPD_WORDS_VEHICLE_CLASS, code);
        if (fact.number & 1u << code) classes += hash_of(word.data(), word.size());
      }
      a.u(classes);
      break;
    }
    default:
      a.u(fact.number);
  }
}

inline void who_meets(const mapd::Snapshot& map, const mapd::Path& path, double reach, Numbers& a,
                      mapd::Scratch& scratch) {
  const auto crossings = path.crossings(scratch);
  a.u(crossings.size());
  for (const auto& one : crossings) {
    a.all(one.along_from, one.along_to, one.wait);
    line(one.line, a);
    a.text(yields[one.yields]);
  }
  const auto conflicts = path.conflicts(scratch);
  std::vector<mapd::ConflictApproach> approaches;
  if (!conflicts.empty()) approaches = map.approaches(conflicts.lanes_of(conflicts[0]), reach, car, scratch);
  a.u(approaches.size());
  for (const auto& one : approaches) {
    a.id(one.lane).all(one.s_from, one.s_to, one.distance_from, one.distance_to).u(one.forward);
  }
}

inline void answer_along(const mapd::Snapshot& map, const mapd::Route& route, Question& q, Numbers& a,
                         mapd::Scratch& scratch) {
  const double from = q.f(), to = q.f(), reach = q.f();
  const auto path = map.path(route.steps);
  const auto facts = path.facts(scratch);
  a.u(facts.size());
  for (const auto& one : facts) fact(map, one, a);
  const auto speeds = path.speeds(scratch);
  a.u(speeds.size());
  for (const auto& one : speeds) {
    a.all(one.along_from, one.along_to).limit(one.rule.max, one.rule.has_max).id(one.rule.signal);
  }
  const auto time = path.travel_time(from, to);
  a.all(time.time, time.unlimited);
  const auto segments = path.segments(car, scratch);
  a.u(segments.size());
  for (const auto& one : segments) {
    a.all(one.along_from, one.along_to).id(one.lane).all(one.last_change, one.lane_end);
    a.u(one.changes).u(one.forward).u(one.driven);
  }
  const auto part = path.try_steps_between(route.steps, from, to, scratch);
  a.steps(part ? *part : std::vector<mapd::RouteStep>());
  who_meets(map, path, reach, a, scratch);
  const auto rebased = path.rebase(map, {MAPD_COST_LENGTH, car, 20.0}, scratch);
  a.u(rebased.route.has_value()).f(rebased.route ? rebased.route->sum.cost : 0.0);
  a.steps(rebased.route ? rebased.route->steps : std::vector<mapd::RouteStep>()).u(rebased.changes.size());
  mapd::PathOptions options;
  options.change_length = change_length;
  const auto curved = map.path(route.steps, options);
  const auto joints = curved.joints();
  a.f(curved.length()).u(joints.size());
  for (const auto& one : joints) a.all(one.along, one.gap, one.kink).u(one.enter).u(one.broken).u(one.is_short);
}

inline void answer_room(const mapd::Path& path, double step, Numbers& a, mapd::Scratch& scratch) {
  const auto stations = path.corridor(0.0, path.length(), step, car, scratch);
  const auto surface = path.corridor_surface(0.0, path.length(), step, scratch);
  a.u(stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const auto& own = stations[i];
    a.f(own.s).limit(own.speed.max, own.speed.has_max).text(edges[own.left_mark.edge]).text(edges[own.right_mark.edge]);
    for (const auto& mark : {own.outer_left_mark, own.outer_right_mark}) {
      a.u(mark.kind).u(mark.color).u(mark.may_cross).text(edges[mark.edge]);
    }
    a.v(surface.at(i).position).v(surface.at(i).normal).all(surface.at(i).friction, surface.at(i).roughness);
  }
  for (const auto kind : {MAPD_CORRIDOR_EDGES_DRIVEN, MAPD_CORRIDOR_EDGES_OPEN}) {
    const auto outline = mapd::outline(stations, kind, scratch);
    a.u(outline.is_simple).u(outline.points.size());
    for (const auto& point : outline.points) a.all(point.x, point.y);
  }
}

inline void restriction(const mapd::Restriction& one, Numbers& a) {
  a.u(one.entry);
  if (one.entry != MAPD_NO_ROW) a.id(one.lane).all(one.s_from, one.s_to);
}

inline void restrictions(const std::vector<mapd::Restriction>& all, Numbers& a) {
  a.u(all.size());
  for (const auto& one : all) restriction(one, a);
}

inline void on_path(const mapd::View& view, const mapd::Path& path, Numbers& a, mapd::Scratch& scratch) {
  const auto met = view.restrictions_on_path(path, car);
  a.u(met.size());
  for (const auto& one : met) {
    a.all(one.along_from, one.along_to);
    restriction(one.restriction, a);
  }
  const auto speed = view.speed_on_path(path, 0.5 * path.length(), car);
  a.limit(speed.max, speed.has_max);
  restriction(speed.restriction, a);
  const auto stations = view.corridor(path, 0.0, path.length(), path.length() / 4.0, car, scratch);
  a.u(stations.size());
  for (const auto& own : stations) {
    a.v(own.outer_left).v(own.outer_right).u(own.left_mark.may_cross).limit(own.speed.max, own.speed.has_max);
    a.u(own.speed.origin == MAPD_SPEED_ORIGIN_OVERLAY);
  }
  const auto speeds = view.speeds_on_path(path, car);
  a.u(speeds.size());
  for (const auto& one : speeds) {
    a.all(one.along_from, one.along_to).limit(one.today.max, one.today.has_max);
    restriction(one.today.restriction, a);
  }
  const auto time = view.travel_time_on_path(path, 0.0, path.length(), car);
  a.all(time.time, time.unlimited);
  const auto segments = view.segments_on_path(path, car, scratch);
  a.u(segments.size());
  for (const auto& one : segments) {
    a.all(one.along_from, one.along_to).id(one.lane).u(one.changes).f(one.last_change);
  }
}

inline void answer_today(const mapd::Snapshot& under, Question& q, Numbers& a, mapd::Scratch& scratch) {
  const auto view = under.view(q.f());
  const auto from = q.place(), to = q.place();
  const double limit = q.f();
  const auto signal = q.id<mapd::SignalId>();
  const auto entries = view.entries();
  a.u(entries.size());
  for (const auto& one : entries) {
    a.text(mapd::view(one.id)).word(MAPD_WORDS_OVERLAY_KIND, one.kind).text(mapd::view(one.source));
    a.all(one.value, one.confidence).u(one.vehicles >> MAPD_VEHICLE_CLASS_PEDESTRIAN & 1).u(one.holds);
  }
  a.u(view.restrictions().size());
  const auto permission = view.allows(from, car);
  a.u(permission.is_allowed);
  restriction(permission.restriction, a);
  const auto speed = view.speed_rule_at(from, car);
  a.limit(speed.max, speed.has_max).limit(speed.map.max, speed.map.has_max);
  restriction(speed.restriction, a);
  restrictions(view.restrictions_at(from), a);
  a.u(mapd::is_some(signal) ? view.signal_out_of_service(signal).value_or(MAPD_NO_ROW) : MAPD_NO_ROW);
  const mapd::PositionOnLane places[] = {from, to};
  const mapd::Cost cost{MAPD_COST_LENGTH, car, 20.0};
  const auto route = view.route(places, cost, scratch);
  const auto steps = route ? route->steps : std::vector<mapd::RouteStep>();
  a.u(route.has_value()).f(route ? route->sum.cost : 0.0).steps(steps);
  restrictions(view.restrictions_along(steps, car, scratch), a);
  const auto path = under.try_path(steps);
  a.u(path.has_value());
  if (path) on_path(view, *path, a, scratch);
  const auto reached = view.reachable(from, limit, cost, scratch);
  a.u(reached.size());
  for (const auto& one : reached) a.id(one.lane).u(one.forward).all(one.s_from, one.s_to, one.cost);
  const auto ahead = view.signals_ahead(from, limit, car, scratch);
  a.u(ahead.size());
  for (const auto& one : ahead) a.id(one.signal).id(one.lane).all(one.distance, one.s);
  const mapd::Vec2 at = q.xy();
  mapd::MatchOptions options;
  options.has_vehicle = 1;
  options.vehicle = car;
  const auto found = view.match_pose({mapd::Point(at), q.f()}, {0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.01}, scratch, options);
  a.f(found.none).u(found.lanes.size());
  for (const auto& one : found.lanes) a.id(one.lane).u(one.forward).f(one.probability);
}

inline void answer_request(const mapd::Snapshot& map, Question& q, Numbers& a, mapd::Scratch& scratch) {
  std::vector<mapd::RouteEnd> ends;
  for (int i = 0; i < 4; ++i) {
    const auto place = q.place();
    const double cost = q.f();
    ends.emplace_back(place, static_cast<std::uint8_t>(q.u()), cost);
  }
  const mapd::LaneId avoid[] = {q.id()};
  const mapd::Cost length{MAPD_COST_LENGTH, car, 20.0};
  mapd::RouteRequest request({ends.data(), 2}, {ends.data() + 2, 2}, length, avoid);
  request.turn_left = q.f();
  request.turn_right = 0.5 * request.turn_left;
  request.turn_back = 90.0;
  const double limit = q.f();
  const auto route = map.find_route(request, scratch);
  a.u(route.has_value());
  if (route) a.all(route->sum.cost, route->sum.length).u(route->sum.start).u(route->sum.goal).steps(route->steps);
  const auto routes = map.alternatives(request, scratch);
  a.u(routes.size());
  for (const auto& one : routes) a.f(one.sum.cost).steps(one.steps);
  for (const bool to : {false, true}) {
    const auto reach = map.reach(request, limit, to, scratch);
    a.u(reach.pieces.size());
    auto link = reach.links.begin();
    for (std::size_t i = 0; i < reach.pieces.size(); ++i) {
      const auto& one = reach.pieces[i];
      auto end = link;
      while (end != reach.links.end() && end->from == i) ++end;
      a.id(one.lane).u(one.forward).all(one.cost, one.s_from, one.s_to).u(one.lane_changes);
      a.u(static_cast<std::uint64_t>(end - link));
      for (; link != end; ++link) a.u(link->to).u(link->enter);
    }
  }
}

inline void answer_tracker(const mapd::Snapshot& map, Question& q, Numbers& a) {
  const mapd::LaneId lane = q.id();
  mapd::Tracker tracker;
  while (q.more()) {
    const double time = q.f();
    const mapd::Point at(q.xy());
    const double heading = q.f();
    const bool has_odometer = q.u() == 1;
    const double odometer = q.f();
    const mapd::TrackerFix fix(time, {at, heading}, {0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.02},
                               has_odometer ? std::optional(odometer) : std::nullopt);
    const auto tracked = tracker.update(map, fix);
    a.u(tracked.state);
    if (tracked.state == MAPD_TRACKED_LANE) {
      a.u(tracked.found.forward).f(tracked.found.probability).place(tracked.found.lane, tracked.found.position);
    }
    const auto known = tracker.hypotheses();
    a.f(known.none).u(known.lanes.size()).f(tracker.probability_in(mapd::span<const mapd::LaneId>(&lane, 1)));
  }
}

}  // namespace
