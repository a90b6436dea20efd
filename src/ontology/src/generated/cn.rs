//! `cn.toml`.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// The file.
pub(super) const TEXT: &str = r##"# China: signs of GB 5768.2-2009 and -2022, as tools write them: the sign's kind in romanised Chinese (jing warning, jin ban,
# shi instruction, lu guidance), its number as subtype.

name = "cn"
doc = "China, GB 5768.2"
countries = ["CN", "CHN", "China"]
unit = "km/h"
base = "opendrive"

signals = [
  { type = "jin", subtype = "1", class = "stop" },
  { type = "jin", subtype = "2", class = "yield" },
  { type = "jin", subtype = "3", class = "yield_to_oncoming" },
  { type = "jin", subtype = "4", class = "closed_to_vehicles" },
  { type = "jin", subtype = "5", class = "no_entry" },
  { type = "jin", subtype = "6", class = "closed_to_some" },
  { type = "jin", subtype = "22", class = "no_left_turn" },
  { type = "jin", subtype = "23", class = "no_right_turn" },
  { type = "jin", subtype = "24", class = "no_straight_on" },
  { type = "jin", subtype = "28", class = "no_u_turn" },
  { type = "jin", subtype = "29", class = "no_u_turn" },
  { type = "jin", subtype = "30", class = "no_overtaking" },
  { type = "jin", subtype = "31", class = "end_of_no_overtaking" },
  { type = "jin", subtype = "32", class = "no_stopping" },
  { type = "jin", subtype = "33", class = "no_parking" },
  { type = "jin", subtype = "35", class = "maximum_width", value = "written", unit = "m" },
  { type = "jin", subtype = "36", class = "maximum_height", value = "written", unit = "m" },
  { type = "jin", subtype = "37", class = "maximum_weight", value = "written", unit = "t" },
  { type = "jin", subtype = "38", class = "speed_limit", value = "written" },
  { type = "jin", subtype = "39", class = "end_of_speed_limit", value = "written" },
  { type = "jin", name = "speed_highest*", class = "speed_limit", value = "written" },
  { type = "jin", class = "closed_to_some" },
  { type = "shi", subtype = "1", class = "mandatory_direction" },
  { type = "shi", subtype = "11", class = "roundabout" },
  { type = "shi", subtype = "13", class = "one_way" },
  { type = "shi", name = "speed_lowest*", class = "minimum_speed", value = "written" },
  { type = "shi", subtype = "16", class = "minimum_speed", value = "written" },
  { type = "shi", subtype = "17", class = "priority_at_next_junction" },
  { type = "shi", subtype = "18", class = "priority_over_oncoming" },
  { type = "shi", subtype = "19", class = "pedestrian_crossing" },
  { type = "shi", class = "mandatory_direction" },
  { type = "jing", subtype = "1", class = "warning_junction" },
  { type = "jing", subtype = "2", class = "warning_curve" },
  { type = "jing", subtype = "9", class = "warning_pedestrians" },
  { type = "jing", subtype = "12", class = "warning_traffic_light" },
  { type = "jing", subtype = "35", class = "warning_road_works" },
  { type = "jing", class = "warning" },
  { type = "lu", class = "guide_sign" },
  { type = "1000001", class = "traffic_light", light = "three_direct" },
  { type = "1000002", class = "pedestrian_light", light = "walk" },
]
"##;
