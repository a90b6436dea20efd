// Answers the questions of a file in C++ and compares bit by bit. `answers ARCHIVE ANSWERS OVERLAY`.
#include "ways.hpp"

#include <string>
#include <unordered_map>

namespace {

class Answerer {
 public:
  Answerer(const char* archive, const char* overlay)
      : map_(mapd::Snapshot::open(archive)), under_(map_.with_overlay(bytes_of(overlay))) {
    content = map_.facts().content;
    if (auto projector = map_.try_projector()) projector_.emplace(*std::move(projector));
  }

  /// Answers a question; false for a kind that there is not.
  bool answer(const std::string& kind, Question q, Numbers& a) {
    const auto found = kinds().find(kind);
    if (found == kinds().end()) return false;
    (this->*found->second)(q, a);
    return true;
  }

 private:
  using Ask = void (Answerer::*)(Question&, Numbers&);

  static const std::unordered_map<std::string, Ask>& kinds() {
    static const std::unordered_map<std::string, Ask> all = {
        {"nearest", &Answerer::nearest},     {"near", &Answerer::near},         {"objects", &Answerer::objects},
        {"landmarks", &Answerer::landmarks}, {"around", &Answerer::around},     {"track", &Answerer::track},
        {"geodetic", &Answerer::geodetic},   {"inertial", &Answerer::inertial}, {"surface", &Answerer::surface},
        {"pose", &Answerer::pose},           {"position", &Answerer::position}, {"edges", &Answerer::edges},
        {"at", &Answerer::at},               {"lane", &Answerer::lane},         {"movement", &Answerer::movement},
        {"line", &Answerer::line},           {"ahead", &Answerer::ahead},       {"sequences", &Answerer::sequences},
        {"junction", &Answerer::junction},   {"route", &Answerer::route},       {"lines", &Answerer::lines},
        {"path", &Answerer::path},           {"reachable", &Answerer::reachable}, {"ground", &Answerer::ground},
        {"mark", &Answerer::mark},           {"match", &Answerer::match},       {"trace", &Answerer::trace},
        {"along", &Answerer::along},         {"room", &Answerer::room},         {"comes", &Answerer::comes},
        {"today", &Answerer::today},         {"tracker", &Answerer::tracker},   {"stance", &Answerer::stance},
        {"sees", &Answerer::sees},           {"paint", &Answerer::paint},       {"request", &Answerer::request},
        {"road", &Answerer::road},           {"region", &Answerer::region},     {"details", &Answerer::details},
        {"sign", &Answerer::sign},           {"thing", &Answerer::thing},       {"earth", &Answerer::earth},
        {"whole", &Answerer::whole},
    };
    return all;
  }

  void nearest(Question& q, Numbers& a) {
    const mapd::Point point = q.point();
    mapd::NearestOptions options;
    options.radius = q.f();
    const auto hit = map_.nearest_lane(point, options);
    a.u(hit.has_value());
    if (hit) a.place(hit->lane, hit->position);
  }
  void near(Question& q, Numbers& a) {
    const mapd::Point point = q.point();
    mapd::NearestOptions options;
    options.radius = q.f();
    const auto all = map_.lanes_near(point, scratch_, options);
    a.u(all.size());
    for (const auto& one : all) a.place(one.lane, one.position);
  }
  void objects(Question& q, Numbers& a) {
    const mapd::Vec2 at = q.xy();
    const auto all = map_.objects_near(at, q.f(), scratch_);
    a.u(all.size());
    for (const auto& one : all) a.id(one.place.object).u(one.place.copy).f(one.distance);
  }
  void landmarks(Question& q, Numbers& a) {
    const mapd::Vec2 at = q.xy();
    const auto all = map_.landmarks_near(at, q.f(), nullptr, scratch_);
    a.u(all.size());
    for (const auto& one : all) {
      a.id(one.signal).id(one.place.object).u(one.class_code).v(one.position);
      a.all(one.heading, one.length, one.width, one.height, one.distance);
    }
  }
  void around(Question& q, Numbers& a) {
    const mapd::Vec2 at = q.xy();
    const double radius = q.f();
    const auto signals = map_.signals_near(at, radius, scratch_);
    a.u(signals.size());
    for (const auto& one : signals) a.text(mapd::view(map_.signal(one.signal).id)).f(one.distance);
    const auto objects = map_.objects_near(at, radius, scratch_);
    a.u(objects.size());
    for (const auto& one : objects) a.text(mapd::view(map_.object(one.place.object).id)).f(one.distance);
  }
  void track(Question& q, Numbers& a) {
    const auto road = q.id<mapd::RoadId>();
    const auto at = map_.to_track(road, q.point());
    a.all(at.s, at.t).u(at.has_h).all(at.h, at.distance).u(at.clamped).u(at.exact);
  }
  void geodetic(Question& q, Numbers& a) {
    const mapd::Vec2 at = q.xy();
    const mapd::Vec3 point{at.x, at.y, q.f()};
    const auto place = projector_ ? projector_->try_to_geodetic(point) : mapd::Result<mapd::Geodetic>(mapd::Error{});
    a.u(place.has_value());
    if (place) a.all(place->latitude, place->longitude, place->altitude);
  }
  void inertial(Question& q, Numbers& a) {
    const auto road = q.id<mapd::RoadId>();
    const double s = q.f(), t = q.f(), h = q.f();
    a.pose(map_.to_inertial(road, {s, t, h}));
  }
  void surface(Question& q, Numbers& a) {
    const auto road = q.id<mapd::RoadId>();
    const double s = q.f(), t = q.f();
    const auto found = map_.surface_at(road, s, t);
    a.v(found.position).v(found.normal).id(found.lane).u(found.has_material);
    a.f(found.material.friction).u(found.clamped);
  }

  void pose(Question& q, Numbers& a) {
    const auto at = q.place();
    a.pose(map_.pose_at(at.lane, at.s, q.f()));
  }
  void position(Question& q, Numbers& a) {
    const auto lane = q.id();
    a.place(lane, map_.position_of(lane, q.xy()));
  }
  void edges(Question& q, Numbers& a) {
    const auto at = q.place();
    const auto edges = map_.edges_at(at.lane, at.s);
    const auto waypoint = map_.waypoint_at(at.lane, at.s);
    const auto bounds = map_.bounds_at(at.lane, at.s);
    a.all(edges.inner, edges.outer, waypoint.s).v(waypoint.position).all(waypoint.heading, waypoint.width);
    a.v(bounds.left).v(bounds.right).f(map_.length_between(at.lane, at.s, map_.lane(at.lane).s_end));
    a.id(map_.speed_rule_at(at.lane, at.s).signal);
    const auto mark = map_.road_mark_at(at.lane, at.s);
    a.u(mark.has_value());
    if (mark) a.u(mark->kind).u(mark->color).f(mark->width_or_default);
  }
  void at(Question& q, Numbers& a) {
    const auto at = q.place();
    const auto rule = map_.speed_rule_at(at.lane, at.s);
    a.f(map_.width_at(at.lane, at.s)).option(map_.recorded_speed_limit_at(at.lane, at.s));
    a.u(rule.has_max).f(rule.max).u(map_.allows_at(at.lane, at.s, car));
    const auto stretches = map_.speed_rules(at.lane);
    a.u(stretches.size());
    for (const auto& own : stretches) {
      a.f(own.s_low).f(own.s_high).u(own.rule.has_max).f(own.rule.max).u(own.has_lowest).f(own.lowest);
    }
  }
  void lane(Question& q, Numbers& a) {
    const auto lane = q.id();
    const auto facts = map_.lane(lane);
    a.text(map_.key(lane)).u(static_cast<std::uint32_t>(facts.number)).u(facts.kind).u(facts.is_forward);
    a.all(facts.s_start, facts.s_end);
    for (const auto side : {MAPD_BESIDE_LEFT, MAPD_BESIDE_RIGHT, MAPD_BESIDE_OPPOSITE}) a.id(map_.beside(lane, side));
    a.ids(map_.successors(lane)).ids(map_.predecessors(lane));
  }
  void movement(Question& q, Numbers& a) {
    const auto lane = q.id();
    a.ids(map_.entries(lane)).ids(map_.movement_lanes(lane)).u(map_.turn(lane));
    const auto ways = map_.right_of_way(lane);
    a.u(ways.size());
    for (const auto& one : ways) a.id(one.other).u(one.relation).u(one.reason);
    const auto lights = map_.movement_lights(lane);
    a.u(lights.size());
    for (const auto& one : lights) a.id(one.signal).id(one.lane);
  }
  void line(Question& q, Numbers& a) {
    const auto all = map_.line(q.id(), MAPD_LINE_CENTER);
    a.u(all.size());
    for (const auto& one : all) a.f(one.s).v(one.position);
  }
  void ahead(Question& q, Numbers& a) {
    const auto from = q.place();
    const auto all = map_.signals_ahead(from, q.f(), car, scratch_);
    a.u(all.size());
    for (const auto& one : all) {
      a.text(mapd::view(map_.signal(one.signal).id)).id(one.lane).all(one.distance, one.s);
    }
  }
  void sequences(Question& q, Numbers& a) {
    const auto from = q.place();
    const auto all = map_.lane_sequences(from, q.f(), car, true, scratch_);
    a.u(all.pieces.size()).u(all.links.size());
    while (const auto one = map_.next_sequence(scratch_)) a.ids(*one);
  }
  void junction(Question& q, Numbers& a) {
    const auto from = q.place();
    const auto next = map_.next_junction(from, q.f(), car);
    a.u(next.has_value());
    if (next) a.id(next->junction).f(next->distance);
  }

  std::optional<mapd::Route> found_route(Question& q) {
    const auto from = q.place(), to = q.place();
    const mapd::PositionOnLane places[] = {from, to};
    const bool by_time = q.u() == 1;
    const mapd::Cost length{MAPD_COST_LENGTH, car, 20.0}, time{MAPD_COST_TIME, car, 2.0};
    return map_.route(places, by_time ? time : length, scratch_);
  }
  void route(Question& q, Numbers& a) {
    const auto route = found_route(q);
    a.u(route.has_value());
    if (!route) return;
    a.all(route->sum.cost, route->sum.length, route->sum.travel_time, route->sum.assumed_time).u(route->sum.lane_changes);
    a.steps(route->steps);
  }
  void lines(Question& q, Numbers& a) {
    const auto route = found_route(q);
    const auto all = map_.lines_along(route->steps, scratch_);
    a.u(all.size());
    for (const auto& one : all) {
      a.id(one.signal).id(one.object).id(one.lane).all(one.s, one.distance).u(one.class_code);
    }
  }
  void path(Question& q, Numbers& a) {
    const auto route = found_route(q);
    const double along = q.f();
    const auto point = q.xy();
    const double step = q.f();
    const auto path = map_.path(route->steps);
    a.f(path.length()).u(path.is_broken());
    const auto lanes = path.lanes();
    a.u(lanes.size());
    for (const auto& one : lanes) a.id(one.lane);
    const auto at = path.at(along);
    a.f(at.along).v(at.position).all(at.heading, at.curvature, at.curvature_rate, at.grade, at.superelevation);
    a.all(at.left, at.right, at.s).id(at.lane).u(at.clamped);
    const auto own = path.project(point);
    a.all(own.along, own.d, own.distance, own.heading, own.s).id(own.lane).u(own.clamped);
    const auto rule = path.speed_at(along);
    a.option(rule && rule->has_max ? std::optional(rule->max) : std::nullopt);
    const auto room = path.corridor(0.0, path.length(), step, car, scratch_);
    a.u(room.size());
    for (const auto& one : room) {
      a.f(one.along).id(one.lane).v(one.left).v(one.right).v(one.outer_left).v(one.outer_right);
      for (const auto& mark : {one.left_mark, one.right_mark}) a.u(mark.kind).u(mark.color).u(mark.may_cross);
    }
    const auto conflicts = path.conflicts(scratch_);
    a.u(conflicts.size());
    for (const auto& one : conflicts) {
      a.all(one.along_from, one.along_to).id(one.other).all(one.other_s_from, one.other_s_to, one.wait);
      a.text(mapd::word(MAPD_WORDS_CONFLICT_KIND, one.kind)).text(yields[one.yields]);
      a.text(mapd::word(MAPD_WORDS_RELATION_REASON, one.reason));
      const auto meeting = conflicts.lanes_of(one);
      a.u(meeting.size());
      for (const auto& lane : meeting) a.id(lane.other).all(lane.along_from, lane.along_to);
    }
  }
  void reachable(Question& q, Numbers& a) {
    const auto from = q.place();
    nodes(map_.reachable(from, q.f(), {MAPD_COST_LENGTH, car, 20.0}, scratch_), a);
  }

  void ground(Question& q, Numbers& a) {
    const mapd::Point point = q.point();
    const auto expected = q.some();
    const auto found = map_.ground_at(point, scratch_, expected);
    const mapd_point all[] = {point};
    mapd::Ground batch[1];
    map_.ground_below(all, batch, scratch_, expected);
    if (mapd::is_some(batch[0].lane) != found.has_value() || (found && batch[0].lane != found->lane)) std::abort();
    a.u(found.has_value());
    if (found) a.f(found->z).v(found->normal).all(found->s, found->t).id(found->lane).u(found->level).u(found->levels);
  }
  void mark(Question& q, Numbers& a) {
    const auto found = map_.nearest_mark(q.xy());
    a.u(found.has_value());
    if (!found) return;
    a.id(found->lane).all(found->s, found->place.x, found->place.y, found->distance, found->width);
    a.u(found->left_of_reference_line).u(found->kind).u(found->color).u(found->painted);
  }
  void match(Question& q, Numbers& a) {
    const mapd::Point point = q.point();
    const double heading = q.f();
    mapd::Covariance covariance;
    for (double& one : covariance) one = q.f();
    const auto found = map_.match_pose({point, heading}, covariance, scratch_);
    a.f(found.none).u(found.lanes.size());
    for (const auto& one : found.lanes) {
      a.u(one.forward).all(one.probability, one.mahalanobis, one.heading_difference).place(one.lane, one.position);
    }
  }
  void trace(Question& q, Numbers& a) {
    std::vector<mapd::TraceFix> fixes;
    while (q.more()) {
      const double time = q.f();
      const mapd::Point at(q.xy());
      const auto has_heading = static_cast<std::uint8_t>(q.u());
      fixes.push_back({time, at, q.f(), has_heading});
    }
    std::vector<mapd::TraceMatch> found(fixes.size());
    map_.match_trace(fixes, found, scratch_);
    for (const auto& one : found) {
      a.u(one.forward).f(one.probability).u(mapd::is_some(one.lane));
      if (mapd::is_some(one.lane)) a.place(one.lane, one.position);
    }
  }

  void along(Question& q, Numbers& a) {
    const auto route = found_route(q);
    answer_along(map_, *route, q, a, scratch_);
  }
  void room(Question& q, Numbers& a) {
    const auto route = found_route(q);
    answer_room(map_.path(route->steps), q.f(), a, scratch_);
  }
  void comes(Question& q, Numbers& a) {
    const auto to = q.place();
    nodes(map_.reachable_to(to, q.f(), {MAPD_COST_LENGTH, car, 20.0}, scratch_), a);
  }
  void request(Question& q, Numbers& a) { answer_request(map_, q, a, scratch_); }
  void today(Question& q, Numbers& a) { answer_today(under_, q, a, scratch_); }
  void tracker(Question& q, Numbers& a) { answer_tracker(map_, q, a); }
  void stance(Question& q, Numbers& a) {
    const mapd::Point position = q.point();
    const double heading = q.f();
    const auto own = map_.stance_at({position, heading}, {{{2.0, 0.8}, {2.0, -0.8}, {-1.0, 0.8}, {-1.0, -0.8}}}, scratch_, q.some());
    a.u(own.has_value());
    if (!own) return;
    a.all(own->z, own->roll, own->pitch);
    for (std::size_t i = 0; i < 4; ++i) a.u(own->has_wheel[i]).f(own->wheels[i]);
  }
  void sees(Question& q, Numbers& a) {
    const mapd::Vec2 at = q.xy();
    const double heading = q.f(), range = q.f(), angle = q.f();
    const auto all = map_.landmarks_in_view({at, heading, range, angle}, nullptr, scratch_);
    a.u(all.size());
    for (const auto& one : all) {
      a.id(one.landmark.signal).id(one.landmark.place.object).u(one.landmark.place.copy);
      a.all(one.landmark.distance, one.bearing, one.facing);
    }
  }
  void paint(Question& q, Numbers& a) {
    const mapd::Vec2 low = q.xy(), high = q.xy();
    const auto all = map_.mark_points({low, high}, q.f(), scratch_);
    a.u(all.size());
    for (const auto& one : all) {
      a.v(one.position).id(one.lane).id(one.place.object).u(one.place.copy).u(one.is_outline);
      a.all(one.s, one.width).u(one.kind).u(one.color);
    }
  }
  void nodes(const std::vector<mapd::Reached>& all, Numbers& a) {
    a.u(all.size());
    for (const auto& one : all) {
      const auto node = map_.node(one.node);
      a.id(node.lane).u(node.is_forward).all(node.s_low, node.s_high, one.cost);
    }
  }

  mapd::Snapshot map_;
  /// The same under an overlay.
  mapd::Snapshot under_;
  void road(Question& q, Numbers& a) {
    const auto road = q.id<mapd::RoadId>();
    const double s = q.f(), t = q.f();
    a.text(map_.road_name_id(road)).f(map_.elevation_at(road, s)).f(map_.superelevation_at(road, s));
    a.f(map_.lane_offset_at(road, s)).id(map_.lane_at(road, s, t)).ids(map_.section_lanes(road, 0));
  }
  void region(Question& q, Numbers& a) {
    const mapd::Vec2 low = q.xy(), high = q.xy();
    const mapd::Region region{low, high};
    a.ids(map_.lanes_in(region, mapd::all_lane_types, scratch_)).ids(map_.signals_in(region, scratch_));
    const auto objects = map_.objects_in(region, scratch_);
    a.u(objects.size());
    for (const auto& one : objects) a.id(one.object).u(one.copy);
    const auto landmarks = map_.landmarks_in(region, nullptr, scratch_);
    a.u(landmarks.size());
    for (const auto& one : landmarks) a.v(one.position).f(one.distance);
    const auto bounds = map_.boundary_segments(region, mapd::all_lane_types, scratch_);
    a.u(bounds.size());
    for (const auto& one : bounds) a.id(one.lane).all(one.s_from, one.s_to).v(one.from).v(one.to);
    const auto marks = map_.road_mark_segments(region, mapd::all_lane_types, scratch_);
    a.u(marks.size());
    for (const auto& one : marks) a.id(one.segment.lane).all(one.segment.s_from, one.width).u(one.kind).u(one.color);
  }
  void details(Question& q, Numbers& a) {
    const auto [lane, s] = q.place();
    const auto facts = map_.lane(lane);
    a.pose(map_.pose_of_reference_line(lane, s, 0.5)).f(map_.time_between(lane, s, facts.s_end));
    const auto rule = map_.overtaking_rule_at(lane, s);
    const auto height = map_.height_at(lane, s);
    const auto material = map_.material_at(lane, s);
    a.id(rule.all).id(rule.trucks).all(height.inner, height.outer);
    a.u(material.has_value()).f(material ? material->friction : -1.0);
    const auto marks = map_.road_marks(lane);
    a.u(marks.size());
    for (const auto& one : marks) a.all(one.s, one.s_end, one.width_or_default).u(one.kind).u(one.color);
    const auto objects = map_.lane_objects(lane);
    a.u(objects.size());
    for (const auto& one : objects) a.id(one.object).all(one.s_low, one.s_high, one.distance);
    const auto line = [&](const mapd::LaneLine& one) { a.id(one.lane).f(one.s).u(one.class_code); };
    for (const std::uint32_t which : {MAPD_LANE_LINES_TO_STOP_AT, MAPD_LANE_LINES_CROSSINGS, MAPD_LANE_LINES_MOVEMENT_CROSSINGS}) {
      const auto lines = map_.lane_lines(lane, which);
      a.u(lines.size());
      for (const auto& one : lines) line(one);
    }
    const auto stop = map_.movement_stop(lane);
    a.u(stop.has_value());
    if (stop) line(*stop);
    const auto node = map_.node_at(lane, s, facts.is_forward != 0);
    a.id(node).ids(node ? map_.node_predecessors(*node) : std::vector<mapd::NodeId>());
  }
  void sign(Question& q, Numbers& a) {
    const auto signal = q.id<mapd::SignalId>();
    const std::string id(mapd::view(map_.signal(signal).id));
    const auto same = map_.signal_by_id(id);
    a.u(map_.signals().size());
    if (same) a.text(mapd::view(map_.signal(*same).id)); else a.u(MAPD_NO_ROW);
    for (const std::uint32_t which : {MAPD_SIGNAL_LINKS_DEPENDENCIES, MAPD_SIGNAL_LINKS_BELONGINGS}) {
      const auto links = map_.signal_links(signal, which);
      a.u(links.size());
      for (const auto& one : links) a.text(mapd::view(one.id)).text(mapd::view(one.kind)).id(one.signal).id(one.object).u(one.is_object);
    }
    const auto controllers = map_.signal_controllers(signal);
    a.ids(map_.signal_movements(signal)).u(controllers.size());
    for (const std::uint32_t one : controllers) a.u(one);
  }
  void thing(Question& q, Numbers& a) {
    const auto object = q.id<mapd::ObjectId>();
    a.u(map_.objects().size()).id(map_.object_by_id(std::string(mapd::view(map_.object(object).id))));
    const auto lanes = map_.object_lanes(object);
    a.u(lanes.size());
    for (const auto& one : lanes) a.id(one.lane).all(one.s_low, one.distance);
    const auto placements = map_.placements(object);
    a.u(placements.size());
    for (const auto& one : placements) {
      const auto place = map_.placement(one.place);
      const auto corners = map_.footprint(one.place, scratch_);
      a.v(place.position).all(place.heading, place.length, place.height).u(corners.size());
      for (const auto& corner : corners) a.v(corner);
    }
  }
  void earth(Question& q, Numbers& a) {
    const double latitude = q.f(), longitude = q.f(), altitude = q.f();
    a.v(projector_->from_geodetic({latitude, longitude, altitude}));
  }
  void whole(Question&, Numbers& a) {
    a.u(map_.node_count());
    const auto junctions = map_.junctions();
    a.u(junctions.size());
    for (const auto& junction : junctions) {
      const auto facts = map_.junction(junction);
      const auto connections = map_.connections(junction);
      a.id(junction).text(mapd::view(facts.id)).id(map_.junction_by_id(std::string(mapd::view(facts.id)))).u(connections.size());
      for (const auto& one : connections) a.text(mapd::view(one.id)).u(one.contact);
      const auto controllers = map_.junction_controllers(junction);
      a.u(controllers.size());
      for (const std::uint32_t one : controllers) a.u(one);
    }
    const auto controllers = map_.controllers();
    a.u(controllers.size());
    for (const auto& one : controllers) a.text(mapd::view(one.id)).text(mapd::view(one.name));
    const auto groups = map_.junction_groups();
    a.u(groups.size());
    for (std::uint32_t number = 0; number < groups.size(); ++number) {
      a.text(mapd::view(groups[number].id)).u(groups[number].kind);
      a.u(map_.junction_group_members(number).size()).ids(map_.junction_group_ring(number));
    }
    const auto structures = map_.structures();
    a.u(structures.size());
    for (const auto& one : structures) a.text(mapd::view(one.id)).all(one.s_from, one.s_to).u(one.kind);
    const auto references = map_.object_references();
    a.u(references.size());
    for (const auto& one : references) a.text(mapd::view(one.id)).all(one.s, one.t);
    a.u(map_.quarantined_parts().size());
    const auto bounds = map_.geodetic_bounds();
    a.u(bounds.has_value());
    if (bounds) a.all(bounds->south, bounds->north, bounds->west, bounds->east);
  }

  mapd::Scratch scratch_;
  std::optional<mapd::Projector> projector_;
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) return 1;
  Answerer answerer(argv[1], argv[3]);
  std::FILE* file = std::fopen(argv[2], "r");
  if (!file) return 1;
  char *line = nullptr, *kind = nullptr;
  std::size_t room = 0, asked = 0, wrong = 0;
  numbers question{}, answer{};
  Numbers found;
  while (read_line(file, &line, &room, &kind, &question, &answer)) {
    found.own.count = 0;
    if (!answerer.answer(kind, Question(question), found)) {
      std::fprintf(stderr, "no kind %s\n", kind);
      return 1;
    }
    ++asked;
    if (!same(&answer, &found.own) && wrong++ < 5) std::fprintf(stderr, "question %zu, %s: another answer\n", asked, kind);
  }
  std::fclose(file);
  std::free(line);
  std::free(question.all);
  std::free(answer.all);
  std::free(found.own.all);
  std::printf("%zu questions, %zu other answers\n", asked, wrong);
  return asked > 0 && wrong == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
