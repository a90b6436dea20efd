//! The tables of `schemas/ontology`.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// Name of a file and its text.
pub(crate) const TABLES: &[(&str, &str)] = &[
    (
        "cn.toml",
        r##"# China: signs of GB 5768.2-2009 and -2022, as tools write them: the sign's kind in romanised Chinese (jing warning, jin ban,
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
"##,
    ),
    (
        "de.toml",
        r##"# Germany: numbers of the road traffic regulations (StVO, annexes 1 to 4) and of the catalogue of signs (VzKat).

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
"##,
    ),
    (
        "lights.toml",
        r##"# What traffic lights can show. A mapping names one of these by `light`.
#
# bulbs   the lamps: red yellow green
# phases  what they show: red red_yellow yellow green flashing_red flashing_yellow flashing_green off

[[light]]
name = "three"
doc = "Three lamps, red and yellow together before green."
bulbs = ["red", "yellow", "green"]
phases = ["red", "red_yellow", "green", "yellow", "flashing_yellow", "off"]

[[light]]
name = "three_direct"
doc = "Three lamps, from red straight to green."
bulbs = ["red", "yellow", "green"]
phases = ["red", "green", "yellow", "flashing_red", "flashing_yellow", "off"]

[[light]]
name = "red_green"
doc = "Two lamps, as for people on foot."
bulbs = ["red", "green"]
phases = ["red", "green", "off"]

[[light]]
name = "walk"
doc = "Two lamps, the second phase flashes before red."
bulbs = ["red", "green"]
phases = ["red", "green", "flashing_red", "flashing_green", "off"]

[[light]]
name = "red_yellow"
doc = "Two lamps that stop traffic now and then."
bulbs = ["red", "yellow"]
phases = ["red", "yellow", "off"]

[[light]]
name = "yellow_green"
doc = "Two lamps beside a light that stops traffic."
bulbs = ["yellow", "green"]
phases = ["yellow", "green", "off"]

[[light]]
name = "red"
doc = "One red lamp."
bulbs = ["red"]
phases = ["red", "flashing_red", "off"]

[[light]]
name = "yellow"
doc = "One yellow lamp."
bulbs = ["yellow"]
phases = ["yellow", "flashing_yellow", "off"]

[[light]]
name = "green"
doc = "One green lamp."
bulbs = ["green"]
phases = ["green", "flashing_green", "off"]

[[light]]
name = "two_red"
doc = "Red lamps that flash in turn, as at level crossings."
bulbs = ["red"]
phases = ["flashing_red", "off"]
"##,
    ),
    (
        "opendrive.toml",
        r##"# The generic catalogue: signals whose country is `OpenDRIVE` or not given, and the object types of OpenDRIVE 1.4 to 1.9.
#
# Lights and markings have numbers from 1000001 on. Signs take Germany's numbers, as the standard's own examples and most
# exports do: what is not found here is looked up in `base`.

name = "opendrive"
doc = "Generic catalogue of OpenDRIVE"
countries = ["OpenDRIVE", "", "-1", "none", "ZZ"]
base = "de"
unit = "km/h"

signals = [
  { type = "1000001", class = "traffic_light", light = "three" },
  { type = "1000002", class = "pedestrian_light", light = "red_green" },
  { type = "1000003", class = "crosswalk" },
  { type = "1000004", class = "bicycle_crossing" },
  { type = "1000005", class = "marking" },
  { type = "1000006", class = "marking" },
  { type = "1000007", class = "pedestrian_light", light = "red_green" },
  # Single lamps: several of them side by side make a light, each with its own signal.
  { type = "1000008", class = "traffic_light", light = "yellow" },
  { type = "1000009", subtype = "10", class = "traffic_light", light = "red_yellow" },
  { type = "1000009", subtype = "20", class = "traffic_light", light = "yellow_green" },
  { type = "1000009", subtype = "30", class = "traffic_light", light = "red_green" },
  { type = "1000009", class = "traffic_light", light = "red_yellow" },
  { type = "1000010", subtype = "10", class = "traffic_light", light = "yellow_green", arrows = ["left"] },
  { type = "1000010", subtype = "20", class = "traffic_light", light = "yellow_green", arrows = ["right"] },
  { type = "1000010", class = "traffic_light", light = "yellow_green" },
  { type = "1000011", subtype = "10", class = "traffic_light", light = "three", arrows = ["left"] },
  { type = "1000011", subtype = "20", class = "traffic_light", light = "three", arrows = ["right"] },
  { type = "1000011", subtype = "30", class = "traffic_light", light = "three", arrows = ["straight"] },
  { type = "1000011", subtype = "40", class = "traffic_light", light = "three", arrows = ["left", "straight"] },
  { type = "1000011", subtype = "50", class = "traffic_light", light = "three", arrows = ["straight", "right"] },
  { type = "1000011", class = "traffic_light", light = "three" },
  { type = "1000012", subtype = "10", class = "traffic_light", light = "green", arrows = ["left"] },
  { type = "1000012", subtype = "20", class = "traffic_light", light = "green", arrows = ["right"] },
  { type = "1000012", subtype = "30", class = "traffic_light", light = "green", arrows = ["straight"] },
  { type = "1000012", class = "traffic_light", light = "green" },
  { type = "1000013", class = "bicycle_light", light = "three" },
  { type = "1000014", class = "public_transport_light", light = "three" },
  { type = "1000015", class = "pedestrian_light", light = "red_green" },
  { type = "1000016", class = "bicycle_light", light = "three" },
  { type = "1000017", class = "lane_light", light = "red_green" },
  { type = "1000018", class = "lane_light", light = "three" },
  { type = "1000019", class = "level_crossing_light", light = "red_yellow" },
  { type = "1000020", class = "traffic_light", light = "red" },
  { type = "multiBoard", class = "board" },
  { type = "staticBoard", class = "board" },
  { type = "vmsBoard", class = "variable_message_board" },
]

objects = [
  { type = "barrier", name = "*guard*rail*", class = "guard_rail" },
  { type = "barrier", subtype = "guardRail", class = "guard_rail" },
  { type = "barrier", subtype = "wall", class = "barrier" },
  { type = "barrier", class = "barrier" },
  { type = "bike", class = "vehicle" },
  { type = "bridge", class = "bridge" },
  { type = "building", subtype = "busStop", class = "street_furniture" },
  { type = "building", class = "building" },
  { type = "bus", class = "vehicle" },
  { type = "car", class = "vehicle" },
  { type = "crosswalk", class = "crosswalk" },
  { type = "gantry", class = "gantry" },
  { type = "motorbike", class = "vehicle" },
  { type = "obstacle", name = "*cone*", class = "traffic_cone" },
  { type = "obstacle", subtype = "trafficCone", class = "traffic_cone" },
  { type = "obstacle", class = "obstacle" },
  { type = "parkingSpace", class = "parking_space" },
  { type = "patch", class = "patch" },
  { type = "pedestrian", class = "person" },
  { type = "pole", subtype = "streetLamp", class = "street_lamp" },
  { type = "pole", name = "*lamp*", class = "street_lamp" },
  { type = "pole", name = "*guide*post*", class = "delineator" },
  { type = "pole", class = "pole" },
  { type = "railing", class = "railing" },
  { type = "roadMark", subtype = "signalLines", class = "stop_line" },
  { type = "roadMark", subtype = "arrowStraight*", class = "arrow" },
  { type = "roadMark", subtype = "arrow*", class = "arrow" },
  { type = "roadMark", subtype = "stopLine", class = "stop_line" },
  { type = "roadMark", subtype = "waitingLine", class = "waiting_line" },
  { type = "roadMark", subtype = "yieldLine", class = "waiting_line" },
  { type = "roadMark", subtype = "restrictedArea", class = "restricted_area" },
  { type = "roadMark", name = "*stop*line*", class = "stop_line" },
  { type = "roadMark", name = "*arrow*", class = "arrow" },
  { type = "roadMark", name = "striped*", class = "restricted_area" },
  { type = "roadMark", class = "marking" },
  { type = "roadSurface", subtype = "patch", class = "patch" },
  { type = "roadSurface", subtype = "damage", class = "patch" },
  { type = "roadSurface", class = "surface" },
  { type = "soundBarrier", class = "sound_barrier" },
  { type = "streetLamp", class = "street_lamp" },
  { type = "trafficIsland", class = "traffic_island" },
  { type = "trailer", class = "vehicle" },
  { type = "train", class = "vehicle" },
  { type = "tram", class = "vehicle" },
  { type = "tree", class = "tree" },
  { type = "truck", class = "vehicle" },
  { type = "tunnel", class = "tunnel" },
  { type = "van", class = "vehicle" },
  { type = "vegetation", subtype = "tree", class = "tree" },
  { type = "vegetation", class = "vegetation" },
  { type = "wind", class = "wind" },
]
"##,
    ),
    (
        "se.toml",
        r##"# Sweden: letters and numbers of the road sign regulation (Vägmärkesförordningen 2007:90), letter as type, number as subtype.

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
"##,
    ),
    (
        "semantics.toml",
        r##"# Signals that say themselves what they mean: `signal/semantics` of OpenDRIVE 1.8 and 1.9 (14.5). It is asked first, whatever
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
"##,
    ),
    (
        "us.toml",
        r##"# United States: codes of the Manual on Uniform Traffic Control Devices (MUTCD 2009 and 2023).

name = "us"
doc = "United States, MUTCD"
countries = ["US", "USA", "United States"]
unit = "mph"
base = "opendrive"

signals = [
  { type = "R1-1", class = "stop" },
  { type = "R1-2", class = "yield" },
  { type = "R1-2a*", class = "yield_to_oncoming" },
  { type = "R1-3*", class = "supplementary_plate" },
  { type = "R1-4", class = "stop" },
  { type = "R1-5*", class = "stop_line" },
  { type = "R1-6*", class = "pedestrian_crossing" },
  { type = "R1-9*", class = "pedestrian_crossing" },
  { type = "R1-10*", class = "supplementary_plate" },
  { type = "R2-1", class = "speed_limit", value = "written subtype" },
  { type = "R2-2*", class = "speed_limit", value = "written subtype" },
  { type = "R2-3*", class = "speed_limit", value = "written subtype" },
  { type = "R2-4", class = "minimum_speed", value = "written subtype" },
  { type = "R2-4*", class = "minimum_speed", value = "written subtype" },
  { type = "R2-5*", class = "warning" },
  { type = "R2-10*", class = "information_sign" },
  { type = "R2-12", class = "end_of_speed_limit" },
  { type = "R3-1", class = "no_right_turn" },
  { type = "R3-2", class = "no_left_turn" },
  { type = "R3-3", class = "closed_to_some" },
  { type = "R3-4", class = "no_u_turn" },
  { type = "R3-5*", class = "mandatory_direction" },
  { type = "R3-6*", class = "lane_assignment" },
  { type = "R3-7*", class = "lane_assignment" },
  { type = "R3-8*", class = "lane_assignment" },
  { type = "R3-9*", class = "lane_assignment" },
  { type = "R3-17*", class = "bicycle_path" },
  { type = "R3-18", class = "no_left_turn" },
  { type = "R3-27", class = "no_straight_on" },
  { type = "R4-1", class = "no_overtaking" },
  { type = "R4-2", class = "end_of_no_overtaking" },
  { type = "R4-3", class = "lane_assignment" },
  { type = "R4-7*", class = "pass_on_side" },
  { type = "R4-8*", class = "pass_on_side" },
  { type = "R5-1", class = "no_entry" },
  { type = "R5-1a", class = "no_entry" },
  { type = "R5-1b", class = "no_entry" },
  { type = "R5-2*", class = "closed_to_some" },
  { type = "R5-3", class = "closed_to_some" },
  { type = "R5-6", class = "closed_to_some" },
  { type = "R6-1", class = "one_way" },
  { type = "R6-2", class = "one_way" },
  { type = "R6-4*", class = "roundabout" },
  { type = "R6-5*", class = "roundabout" },
  { type = "R7-*", class = "no_parking" },
  { type = "R7-4", class = "no_stopping" },
  { type = "R8-3*", class = "no_parking" },
  { type = "R9-*", class = "pedestrian_crossing" },
  { type = "R10-6*", class = "stop_line" },
  { type = "R10-11*", class = "no_turn_on_red" },
  { type = "R10-12*", class = "information_sign" },
  { type = "R11-2", class = "closed_to_vehicles" },
  { type = "R12-1", class = "maximum_weight", value = "written", unit = "t" },
  { type = "R15-1", class = "level_crossing" },
  { type = "W1-*", class = "warning_curve" },
  { type = "W2-*", class = "warning_junction" },
  { type = "W3-1", class = "warning_yield" },
  { type = "W3-2", class = "warning_yield" },
  { type = "W3-3", class = "warning_traffic_light" },
  { type = "W3-5*", class = "warning" },
  { type = "W4-*", class = "lane_assignment" },
  { type = "W5-*", class = "warning_narrowing" },
  { type = "W6-3", class = "warning_oncoming" },
  { type = "W7-1*", class = "warning_slope" },
  { type = "W8-5*", class = "warning_slippery" },
  { type = "W8-*", class = "warning" },
  { type = "W9-*", class = "lane_assignment" },
  { type = "W10-*", class = "warning_level_crossing" },
  { type = "W11-1", class = "warning_bicycles" },
  { type = "W11-2", class = "warning_pedestrians" },
  { type = "W11-3", class = "warning_animals" },
  { type = "W11-*", class = "warning" },
  { type = "W13-1*", class = "advisory_speed", value = "written subtype" },
  { type = "W14-3", class = "no_overtaking" },
  { type = "W16-*", class = "supplementary_plate" },
  { type = "W20-*", class = "warning_road_works" },
  { type = "W21-*", class = "warning_road_works" },
  { type = "S1-1", class = "warning_pedestrians" },
  { type = "S5-1", class = "speed_limit", value = "written subtype" },
  { type = "D3-1*", class = "street_name" },
  { type = "D*", class = "guide_sign" },
  { type = "E*", class = "guide_sign" },
  { type = "M*", class = "guide_sign" },
  { type = "I*", class = "information_sign" },
  { type = "1000001", class = "traffic_light", light = "three_direct" },
  { type = "1000002", class = "pedestrian_light", light = "walk" },
  { type = "1000011", subtype = "10", class = "traffic_light", light = "three_direct", arrows = ["left"] },
  { type = "1000011", subtype = "20", class = "traffic_light", light = "three_direct", arrows = ["right"] },
  { type = "1000011", subtype = "30", class = "traffic_light", light = "three_direct", arrows = ["straight"] },
]
"##,
    ),
    (
        "vendors.toml",
        r##"# What vendors put into names and own types. Read for every country; an entry that names a type or a name counts before the
# country's own entry for the type alone.
#
# RoadRunner, and through it CARLA: signs are models such as Sign_Stop, Signal_3Light_Post01; stop lines and crosswalks are
# objects without type whose name is that of the asset. VTD: names of .flt models, Sg and the German number, SgRM for
# markings. SUMO (netconvert): only types of the generic catalogue. Blender add-on and esmini: country_type-value.

name = "vendors"
doc = "Names used by RoadRunner, CARLA, VTD, SUMO, esmini and others"
countries = ["*"]
unit = "km/h"

[[section]]
doc = "VTD"
signals = [
  { name = "SgRMArrow*", class = "arrow" },
  { name = "SgRMHoldingline*", class = "stop_line" },
  { name = "SgRMStopline*", class = "stop_line" },
  { name = "SgRMWaitingline*", class = "waiting_line" },
  { name = "SgRMCrosswalk*", class = "crosswalk" },
  { name = "SgRMBicycleCross*", class = "bicycle_crossing" },
  { name = "SgRM*", class = "marking" },
  { type = "332", name = "Arrow_NoParking*", class = "no_parking" },
  { type = "332", name = "BRT_*", class = "bus_lane" },
  { type = "332", name = "Rhombus_*", class = "warning_pedestrians" },
]
objects = [
  { name = "SgRMHoldingline*", class = "stop_line" },
  { name = "SgRMCrosswalk*", class = "crosswalk" },
  { type = "guide-post", class = "delineator" },
  { type = "rail-pole", class = "pole" },
  { name = "RoadSignPole*", type = "pole", class = "pole" },
]

[[section]]
doc = "RoadRunner and CARLA"
signals = [
  { name = "Sign_Stop*", class = "stop" },
  { name = "Sign_Yield*", class = "yield" },
  { name = "Signal_3Light*", class = "traffic_light", light = "three_direct" },
  { name = "Signal_5Light*", class = "traffic_light", light = "three_direct", arrows = ["left", "straight"] },
  { name = "Signal_Pedestrian*", class = "pedestrian_light", light = "walk" },
  { name = "Speed_*", class = "speed_limit", value = "name", unit = "mph" },
  { name = "*_Signs_SpeedLimit*", class = "speed_limit", value = "name", unit = "mph" },
  { name = "*_Signs_RoadWorkAhead*", class = "warning_road_works" },
  { name = "*_Signs_*ReverseCurve*", class = "warning_curve" },
  { name = "*Sign_RoadWork*", class = "warning_road_works" },
]
objects = [
  { name = "StopLine*", class = "stop_line" },
  { name = "Stop_Line*", class = "stop_line" },
  { name = "Stencil_STOP*", class = "marking" },
  { name = "Arrow*", class = "arrow" },
  { name = "Stencil_Arrow*", class = "arrow" },
  { name = "ChevronRegion*", class = "restricted_area" },
  { name = "CrosshatchRegion*", class = "restricted_area" },
  { name = "StopSign*", class = "sign" },
  { name = "OriginReference", class = "none" },
  { name = "*Crosswalk*", class = "crosswalk" },
  { name = "Solid*", class = "lane_line" },
  { name = "Dashed*", class = "lane_line" },
  { name = "Broken*", class = "lane_line" },
  { name = "SignPost*", class = "pole" },
  { name = "Sign_Post*", class = "pole" },
  { name = "SignalPost*", class = "pole" },
  { name = "Signal_Post*", class = "pole" },
  { name = "Speed_*", class = "sign" },
  { name = "Sign_*", class = "sign" },
  { name = "StripedRegion*", class = "restricted_area" },
  { name = "TrafficCone*", class = "traffic_cone" },
  { name = "GuardRail*", class = "guard_rail" },
]

[[section]]
doc = "esmini"
signals = [
  { name = "de_274-*", class = "speed_limit", value = "name" },
]

[[section]]
doc = "Old words for object types"
objects = [
  { type = "roadmark", name = "StripedRegion*", class = "restricted_area" },
  { type = "lamp", class = "street_lamp" },
  { type = "parking", class = "parking_space" },
  { type = "pedestrianCrossing", class = "crosswalk" },
  { type = "stopLine", class = "stop_line" },
  { type = "stopline", class = "stop_line" },
  { type = "guardRail", class = "guard_rail" },
  { type = "fence", class = "barrier" },
  { type = "wall", class = "barrier" },
  { type = "bush", class = "vegetation" },
  { type = "busStop", class = "street_furniture" },
  { type = "trafficSign", class = "sign" },
  { type = "trafficLight", class = "traffic_light" },
]
"##,
    ),
];
