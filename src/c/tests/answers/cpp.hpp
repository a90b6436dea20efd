/// What the parts of the C++ program share: numbers of answers and questions.
#pragma once

#include "numbers.h"

#include <mapd.hpp>

namespace {

constexpr std::uint8_t car = MAPD_VEHICLE_CLASS_PASSENGER_CAR;
/// What the map's ids are bound to. Files have its lower half above the row, as the number of an id.
std::uint64_t content = 0;
constexpr const char* yields[] = {"yields", "priority", "lights", "unknown"};

/// Numbers of an answer.
class Numbers {
 public:
  Numbers& f(double value) {
    add_f(&own, value);
    return *this;
  }
  Numbers& u(std::uint64_t value) {
    add_u(&own, value);
    return *this;
  }
  template <class... F>
  Numbers& all(F... values) {
    (f(values), ...);
    return *this;
  }
  template <class Id>
  Numbers& id(Id id) {
    return u(!mapd::is_some(id) ? MAPD_NO_ROW : id.content == content && id.tile == 0 ? content << 32 | id.row : 0);
  }
  template <class Id>
  Numbers& id(const std::optional<Id>& some) {
    return some ? id(*some) : u(MAPD_NO_ROW);
  }
  Numbers& v(mapd::Vec3 at) { return all(at.x, at.y, at.z); }
  Numbers& text(std::string_view text) { return u(hash_of(text.data(), text.size())); }
  Numbers& option(std::optional<double> value) { return u(value.has_value()).f(value.value_or(0.0)); }
  Numbers& place(mapd::LaneId lane, const mapd::LanePosition& p) {
    id(lane).all(p.s, p.t, p.offset, p.offset_of_reference_line, p.distance, p.z, p.heading);
    return f(p.heading_of_reference_line).u(p.clamped);
  }
  Numbers& pose(const mapd::Pose& pose) {
    return v(pose.position).all(pose.heading, pose.curvature, pose.slope, pose.superelevation).u(pose.clamped);
  }
  template <class Id>
  Numbers& ids(const std::vector<Id>& ids) {
    u(ids.size());
    for (const Id& one : ids) id(one);
    return *this;
  }

  Numbers& word(std::uint32_t vocabulary, std::uint16_t code) { return text(mapd::word(vocabulary, code)); }
  Numbers& steps(const std::vector<mapd::RouteStep>& steps) {
    u(steps.size());
    for (const auto& one : steps) id(one.lane).u(one.forward).u(one.enter).all(one.s_from, one.s_to, one.s_latest);
    return *this;
  }
  Numbers& limit(double max, std::uint8_t has_max) { return u(has_max).f(max); }

  numbers own{};
};

/// Numbers of a question, taken one after another.
class Question {
 public:
  explicit Question(const numbers& all) : at_(all.all), end_(all.all + all.count) {}
  bool more() const { return at_ < end_; }
  std::uint64_t u() { return *at_++; }
  double f() { return as_f(u()); }
  mapd::Vec2 xy() {
    const double x = f();
    return {x, f()};
  }
  template <class Id = mapd::LaneId>
  Id id() {
    const std::uint64_t bits = u();
    return {static_cast<std::uint32_t>(bits), 0, content};
  }
  mapd::PositionOnLane place() {
    const mapd::LaneId lane = id();
    return {lane, f()};
  }
  /// One lane, or none.
  std::vector<mapd::LaneId> some() {
    const mapd::LaneId lane = id();
    if (lane.row == MAPD_NO_ROW) return {};
    return {lane};
  }
  /// x, y, z, and whether z counts.
  mapd::Point point() {
    const mapd::Vec2 at = xy();
    const double z = f();
    return u() == 1 ? mapd::Point(at.x, at.y, z) : mapd::Point(at);
  }

 private:
  const std::uint64_t* at_;
  const std::uint64_t* end_;
};

}  // namespace
