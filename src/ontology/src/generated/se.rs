//! `se.toml`.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// The file.
pub(super) const TEXT: &str = r##"# Sweden: letters and numbers of the road sign regulation (Vägmärkesförordningen 2007:90), letter as type, number as subtype.

name = "se"
doc = "Sweden, VMF 2007:90"
countries = ["SE", "SWE", "Sweden"]
unit = "km/h"
base = "opendrive"

# The catalogue numbers the plates of C31 by tens: C31-5 says 50.
[tables.tens]
3 = 30
4 = 40
5 = 50
6 = 60
7 = 70
8 = 80
9 = 90
10 = 100
11 = 110
12 = 120

[[section]]
doc = "Signs"
signals = [
  { type = "a", subtype = "1", class = "warning_curve" },
  { type = "a", subtype = "5", class = "warning_narrowing" },
  { type = "a", subtype = "10", class = "warning_slippery" },
  { type = "a", subtype = "13", class = "warning_pedestrians" },
  { type = "a", subtype = "15", class = "warning_pedestrians" },
  { type = "a", subtype = "16", class = "warning_bicycles" },
  { type = "a", subtype = "19", class = "warning_animals" },
  { type = "a", subtype = "20", class = "warning_road_works" },
  { type = "a", subtype = "22", class = "warning_traffic_light" },
  { type = "a", subtype = "25", class = "warning_oncoming" },
  { type = "a", subtype = "28", class = "warning_junction" },
  { type = "a", subtype = "34", class = "warning_congestion" },
  { type = "a", subtype = "35", class = "warning_level_crossing" },
  { type = "a", class = "warning" },
  { type = "b", subtype = "1", class = "yield" },
  { type = "b", subtype = "2", class = "stop" },
  { type = "b", subtype = "3", class = "pedestrian_crossing" },
  { type = "b", subtype = "4", class = "priority_road" },
  { type = "b", subtype = "5", class = "end_of_priority_road" },
  { type = "b", subtype = "6", class = "yield_to_oncoming" },
  { type = "b", subtype = "7", class = "priority_over_oncoming" },
  { type = "c", subtype = "1", class = "no_entry" },
  { type = "c", subtype = "2", class = "closed_to_vehicles" },
  { type = "c", subtype = "27", class = "no_overtaking" },
  { type = "c", subtype = "28", class = "end_of_no_overtaking" },
  { type = "c", subtype = "29", class = "no_overtaking_by_trucks" },
  { type = "c", subtype = "30", class = "end_of_no_overtaking_by_trucks" },
  { type = "c", subtype = "31", class = "speed_limit", value = "written:tens" },
  { type = "c", subtype = "32", class = "end_of_speed_limit", value = "written:tens" },
  { type = "c", subtype = "35", class = "no_parking" },
  { type = "c", subtype = "39", class = "no_stopping" },
  { type = "c", class = "closed_to_some" },
  { type = "d", subtype = "1", class = "mandatory_direction" },
  { type = "d", subtype = "2", class = "pass_on_side" },
  { type = "d", subtype = "3", class = "roundabout" },
  { type = "d", subtype = "4", class = "bicycle_path" },
  { type = "d", subtype = "5", class = "footpath" },
  { type = "d", subtype = "10", class = "bus_lane" },
  { type = "e", subtype = "1", class = "motorway" },
  { type = "e", subtype = "2", class = "end_of_motorway" },
  { type = "e", subtype = "3", class = "expressway" },
  { type = "e", subtype = "4", class = "end_of_expressway" },
  { type = "e", subtype = "5", class = "town" },
  { type = "e", subtype = "6", class = "end_of_town" },
  { type = "e", subtype = "11", class = "advisory_speed", value = "written" },
  { type = "e", subtype = "16", class = "one_way" },
  { type = "e", subtype = "19", class = "parking_sign" },
  { type = "e", class = "information_sign" },
  { type = "f", class = "guide_sign" },
  { type = "t", class = "supplementary_plate" },
]
"##;
