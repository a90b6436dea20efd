//! `vendors.toml`.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// The file.
pub(super) const TEXT: &str = r##"# What vendors put into names and own types. Read for every country; an entry that names a type or a name counts before the
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
  { name = "Speed_#*", class = "speed_limit", value = "name", unit = "km/h" },
  { name = "StopLine*", class = "stop_line" },
  { name = "Stop_Line*", class = "stop_line" },
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
  # CARLA's signs, of which 30, 40, 60 and 90 occur, state no unit. Its Town04 has 22 that say 90 on roads whose own limits end at
  # 65 mph: 90 km/h are 56 mph and fit, 90 mph would exceed each of them. What is read so is told for each sign.
  { name = "Speed_#*", class = "speed_limit", value = "name", unit = "km/h" },
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
"##;
