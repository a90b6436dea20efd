//! `opendrive.toml`.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// The file.
pub(super) const TEXT: &str = r##"# The generic catalogue: signals whose country is `OpenDRIVE` or not given, and the object types of OpenDRIVE 1.4 to 1.9.
#
# Lights and markings have numbers from 1000001 on. Signs take Germany's numbers, as the standard's own examples and most
# exports do: what is not found here is looked up in `base`.
#
# A value without a unit is in SI units, as the standard says (OpenDRIVE 1.6, 2.3.2): no country is named whose signs would say
# otherwise.

name = "opendrive"
doc = "Generic catalogue of OpenDRIVE"
countries = ["OpenDRIVE", "", "-1", "none", "ZZ"]
base = "de"
unit = "SI"

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
"##;
