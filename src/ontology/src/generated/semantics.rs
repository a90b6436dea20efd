//! `semantics.toml`.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// The file.
pub(super) const TEXT: &str = r##"# Signals that say themselves what they mean: `signal/semantics` of OpenDRIVE 1.8 and 1.9 (14.5). It is asked first, whatever
# the country. type = element name, subtype = its `type`.

name = "semantics"
doc = "Semantics of OpenDRIVE 1.8 and 1.9"
countries = ["semantics"]
unit = "m/s"

signals = [
  { type = "speed", subtype = "maximum", class = "speed_limit", value = "written" },
  { type = "speed", subtype = "maximumEnd", class = "end_of_speed_limit", value = "written" },
  { type = "speed", subtype = "minimum", class = "minimum_speed", value = "written" },
  { type = "speed", subtype = "minimumEnd", class = "end_of_minimum_speed", value = "written" },
  { type = "speed", subtype = "recommended", class = "advisory_speed", value = "written" },
  { type = "speed", subtype = "recommendedEnd", class = "end_of_advisory_speed", value = "written" },
  { type = "speed", subtype = "zone", class = "speed_limit_zone", value = "written" },
  { type = "speed", subtype = "zoneEnd", class = "end_of_speed_limit_zone", value = "written" },
  { type = "lane", subtype = "noOvertakeCars", class = "no_overtaking" },
  { type = "lane", subtype = "noOvertakeCarsEnd", class = "end_of_no_overtaking" },
  { type = "lane", subtype = "noOvertakeTrucks", class = "no_overtaking_by_trucks" },
  { type = "lane", subtype = "noOvertakeTrucksEnd", class = "end_of_no_overtaking_by_trucks" },
  { type = "lane", subtype = "priorityOverOncoming", class = "priority_over_oncoming" },
  { type = "lane", subtype = "roundabout", class = "roundabout" },
  { type = "lane", subtype = "yieldForOncoming", class = "yield_to_oncoming" },
  { type = "lane", class = "lane_assignment" },
  { type = "priority", subtype = "4way", class = "stop" },
  { type = "priority", subtype = "keepClearLine", class = "restricted_area" },
  { type = "priority", subtype = "noParkingLine", class = "no_parking" },
  { type = "priority", subtype = "noTurnOnRed", class = "no_turn_on_red" },
  { type = "priority", subtype = "priorityRoad", class = "priority_road" },
  { type = "priority", subtype = "priorityRoadEnd", class = "end_of_priority_road" },
  { type = "priority", subtype = "priorityToTheRightRule", class = "priority_to_the_right" },
  { type = "priority", subtype = "stop", class = "stop" },
  { type = "priority", subtype = "stopLine", class = "stop_line" },
  { type = "priority", subtype = "turnOnRedAllowed", class = "turn_on_red" },
  { type = "priority", subtype = "trafficLight", class = "traffic_light", light = "three" },
  { type = "priority", subtype = "waitingLine", class = "waiting_line" },
  { type = "priority", subtype = "yield", class = "yield" },
  { type = "prohibited", class = "closed_to_some" },
  { type = "warning", class = "warning" },
  { type = "routing", class = "guide_sign" },
  { type = "streetname", class = "street_name" },
  { type = "parking", class = "parking_sign" },
  { type = "tourist", class = "information_sign" },
  { type = "supplementary*", class = "supplementary_plate" },
]
"##;
