//! `de.toml`.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// The file.
pub(super) const TEXT: &str = r##"# Germany: numbers of the road traffic regulations (StVO, annexes 1 to 4) and of the catalogue of signs (VzKat).

name = "de"
doc = "Germany, StVO"
countries = ["DE", "DEU", "GER", "Germany", "Deutschland"]
unit = "km/h"

# Until 2016 the catalogue counted speeds by subtypes 50 to 63; since then the subtype is the speed itself. Both count only
# where no value is written.
[tables.speed]
50 = 5
51 = 10
52 = 20
53 = 30
54 = 40
55 = 50
56 = 60
57 = 70
58 = 80
59 = 90
60 = 100
61 = 110
62 = 120
63 = 130
5 = 5
10 = 10
20 = 20
30 = 30
40 = 40
70 = 70
80 = 80
90 = 90
100 = 100
110 = 110
120 = 120
130 = 130

[[section]]
doc = "Warnings (StVO annex 1)"
signals = [
  { type = "101", subtype = "10", class = "warning_animals" },
  { type = "101", subtype = "15", class = "warning_animals" },
  { type = "101", subtype = "51", class = "warning_slippery" },
  { type = "101", class = "warning" },
  { type = "102", class = "warning_junction" },
  { type = "103", class = "warning_curve" },
  { type = "105", class = "warning_curve" },
  { type = "108", class = "warning_slope" },
  { type = "110", class = "warning_slope" },
  { type = "112", class = "warning" },
  { type = "113", class = "warning_slippery" },
  { type = "114", class = "warning_slippery" },
  { type = "115", class = "warning" },
  { type = "116", class = "warning" },
  { type = "117", class = "warning" },
  { type = "120", class = "warning_narrowing" },
  { type = "121", class = "warning_narrowing" },
  { type = "123", class = "warning_road_works" },
  { type = "124", class = "warning_congestion" },
  { type = "125", class = "warning_oncoming" },
  { type = "131", class = "warning_traffic_light" },
  { type = "133", class = "warning_pedestrians" },
  { type = "134", class = "warning_pedestrians" },
  { type = "136", class = "warning_pedestrians" },
  { type = "138", class = "warning_bicycles" },
  { type = "140", class = "warning_animals" },
  { type = "142", class = "warning_animals" },
  { type = "145", class = "warning" },
  { type = "150", class = "warning_level_crossing" },
  { type = "151", class = "warning_level_crossing" },
  { type = "156", class = "warning_level_crossing" },
  { type = "157", class = "warning_level_crossing" },
  { type = "159", class = "warning_level_crossing" },
  { type = "162", class = "warning_level_crossing" },
]

[[section]]
doc = "Regulations (StVO annex 2)"
signals = [
  { type = "201", class = "level_crossing" },
  { type = "205", class = "yield" },
  { type = "206", class = "stop" },
  { type = "208", class = "yield_to_oncoming" },
  { type = "209", class = "mandatory_direction" },
  { type = "211", class = "mandatory_direction" },
  { type = "214", class = "mandatory_direction" },
  { type = "215", class = "roundabout" },
  { type = "220", class = "one_way" },
  { type = "222", class = "pass_on_side" },
  { type = "223", class = "lane_assignment" },
  { type = "223.*", class = "lane_assignment" },
  { type = "224", class = "bus_stop" },
  { type = "229", class = "bus_stop" },
  { type = "230", class = "no_parking" },
  { type = "237", class = "bicycle_path" },
  { type = "238", class = "bicycle_path" },
  { type = "239", class = "footpath" },
  { type = "240", class = "shared_path" },
  { type = "241", class = "shared_path" },
  { type = "242", class = "pedestrian_zone" },
  { type = "242.*", class = "pedestrian_zone" },
  { type = "243", class = "pedestrian_zone" },
  { type = "244", class = "bicycle_path" },
  { type = "244.*", class = "bicycle_path" },
  { type = "245", class = "bus_lane" },
  { type = "250", class = "closed_to_vehicles" },
  { type = "251", class = "closed_to_some" },
  { type = "253", class = "closed_to_some" },
  { type = "254", class = "closed_to_some" },
  { type = "255", class = "closed_to_some" },
  { type = "257", class = "closed_to_some" },
  { type = "258", class = "closed_to_some" },
  { type = "259", class = "closed_to_some" },
  { type = "260", class = "closed_to_some" },
  { type = "261", class = "closed_to_some" },
  { type = "262", class = "maximum_weight", value = "written", unit = "t" },
  { type = "263", class = "maximum_weight", value = "written", unit = "t" },
  { type = "264", class = "maximum_width", value = "written", unit = "m" },
  { type = "265", class = "maximum_height", value = "written", unit = "m" },
  { type = "266", class = "maximum_length", value = "written", unit = "m" },
  { type = "267", class = "no_entry" },
  { type = "268", class = "closed_to_some" },
  { type = "269", class = "closed_to_some" },
  { type = "270", class = "closed_to_some" },
  { type = "270.*", class = "closed_to_some" },
  { type = "272", class = "no_u_turn" },
  { type = "273", class = "minimum_distance", value = "written", unit = "m" },
  { type = "274", class = "speed_limit", value = "written subtype:speed" },
  { type = "274.1", subtype = "20", class = "speed_limit_zone", value = "20" },
  { type = "274.1", class = "speed_limit_zone", value = "written 30" },
  { type = "274.2", class = "end_of_speed_limit_zone" },
  { type = "275", class = "minimum_speed", value = "written subtype:speed" },
  { type = "276", class = "no_overtaking" },
  { type = "277", class = "no_overtaking_by_trucks" },
  { type = "277.1", class = "no_overtaking" },
  { type = "278", class = "end_of_speed_limit", value = "written subtype:speed" },
  { type = "279", class = "end_of_minimum_speed", value = "written subtype:speed" },
  { type = "280", class = "end_of_no_overtaking" },
  { type = "281", class = "end_of_no_overtaking_by_trucks" },
  { type = "281.1", class = "end_of_no_overtaking" },
  { type = "282", class = "end_of_restrictions" },
  { type = "283", class = "no_stopping" },
  { type = "286", class = "no_parking" },
  { type = "290", class = "no_parking" },
  { type = "290.*", class = "no_parking" },
  { type = "293", class = "crosswalk" },
  { type = "294", class = "stop_line" },
  { type = "295", class = "lane_line" },
  { type = "296", class = "lane_line" },
  { type = "297", class = "arrow" },
  { type = "297.1", class = "arrow" },
  { type = "298", class = "restricted_area" },
  { type = "299", class = "no_parking" },
]

[[section]]
doc = "Directions (StVO annex 3)"
signals = [
  { type = "301", class = "priority_at_next_junction" },
  { type = "306", class = "priority_road" },
  { type = "307", class = "end_of_priority_road" },
  { type = "308", class = "priority_over_oncoming" },
  { type = "310", class = "town" },
  { type = "311", class = "end_of_town" },
  { type = "314", class = "parking_sign" },
  { type = "314.*", class = "parking_sign" },
  { type = "315", class = "parking_sign" },
  { type = "316", class = "parking_sign" },
  { type = "317", class = "parking_sign" },
  { type = "318", class = "parking_sign" },
  { type = "325", class = "living_street" },
  { type = "325.1", class = "living_street" },
  { type = "325.2", class = "end_of_living_street" },
  { type = "326", class = "end_of_living_street" },
  { type = "327", class = "information_sign" },
  { type = "328", class = "information_sign" },
  { type = "330", class = "motorway" },
  { type = "330.1", class = "motorway" },
  { type = "330.2", class = "end_of_motorway" },
  { type = "331", class = "expressway" },
  { type = "331.1", class = "expressway" },
  { type = "331.2", class = "end_of_expressway" },
  { type = "332", class = "guide_sign" },
  { type = "332.1", class = "guide_sign" },
  { type = "333", class = "guide_sign" },
  { type = "333.1", class = "guide_sign" },
  { type = "334", class = "end_of_motorway" },
  { type = "336", class = "end_of_expressway" },
  { type = "340", class = "lane_line" },
  { type = "341", class = "waiting_line" },
  { type = "342", class = "waiting_line" },
  { type = "350", class = "pedestrian_crossing" },
  { type = "350.*", class = "information_sign" },
  { type = "353", class = "one_way" },
  { type = "354", class = "information_sign" },
  { type = "355", class = "information_sign" },
  { type = "356", class = "information_sign" },
  { type = "357", class = "information_sign" },
  { type = "358", class = "information_sign" },
  { type = "363", class = "information_sign" },
  { type = "365", class = "information_sign" },
  { type = "380", class = "advisory_speed", value = "written subtype:speed" },
  { type = "381", class = "end_of_advisory_speed", value = "written subtype:speed" },
  { type = "385", class = "guide_sign" },
  { type = "386", class = "information_sign" },
  { type = "386.*", class = "information_sign" },
  { type = "390", class = "information_sign" },
  { type = "391", class = "information_sign" },
  { type = "392", class = "information_sign" },
  { type = "393", class = "information_sign" },
  { type = "394", class = "information_sign" },
  { type = "401", class = "guide_sign" },
  { type = "405", class = "guide_sign" },
  { type = "406", class = "guide_sign" },
  { type = "410", class = "guide_sign" },
  { type = "41?", class = "guide_sign" },
  { type = "42?", class = "guide_sign" },
  { type = "43?", class = "guide_sign" },
  { type = "434.*", class = "guide_sign" },
  { type = "437", class = "street_name" },
  { type = "44?", class = "guide_sign" },
  { type = "45?", class = "guide_sign" },
  { type = "46?", class = "guide_sign" },
  { type = "467", class = "guide_sign" },
  { type = "500", class = "lane_assignment" },
  { type = "50?", class = "lane_assignment" },
  { type = "51?", class = "lane_assignment" },
  { type = "52?", class = "lane_assignment" },
  { type = "53?", class = "lane_assignment" },
  { type = "54?", class = "lane_assignment" },
  { type = "55?", class = "lane_assignment" },
  { type = "590", class = "guide_sign" },
]

[[section]]
doc = "Equipment (StVO annex 4) and supplementary plates"
signals = [
  { type = "600", class = "traffic_barrier_sign" },
  { type = "605", class = "delineator" },
  { type = "610", class = "traffic_cone" },
  { type = "615", class = "traffic_barrier_sign" },
  { type = "616", class = "traffic_barrier_sign" },
  { type = "620", class = "delineator" },
  { type = "625", class = "delineator" },
  { type = "626", class = "delineator" },
  { type = "627", class = "delineator" },
  { type = "628", class = "delineator" },
  { type = "629", class = "delineator" },
  { type = "630", class = "delineator" },
  { type = "720", class = "turn_on_red" },
  { type = "10??", class = "supplementary_plate" },
]
"##;
