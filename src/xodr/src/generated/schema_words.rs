//! The words of enumerations.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/words.toml; change that file instead.

use crate::schema::{V1_4, V1_5, V1_6, V1_7, V1_8, V1_9, WordList, between, from, word};

pub(crate) static ACCESS_RESTRICTION_TYPE: WordList = WordList {
    name: "e_accessRestrictionType",
    words: &[
        word("simulator"),
        word("autonomous traffic").only(between(V1_4, V1_4)),
        word("autonomousTraffic").only(from(V1_5)),
        word("pedestrian"),
        word("passengerCar").only(from(V1_5)),
        word("bus").only(from(V1_5)),
        word("delivery").only(from(V1_5)),
        word("emergency").only(from(V1_5)),
        word("taxi").only(from(V1_5)),
        word("throughTraffic").only(from(V1_5)),
        word("truck").only(from(V1_5)),
        word("bicycle").only(from(V1_5)),
        word("motorcycle").only(from(V1_5)),
        word("none"),
        word("trucks").only(from(V1_5)),
        word("HOV").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static BORDER_TYPE: WordList = WordList {
    name: "e_borderType",
    words: &[
        word("concrete").only(from(V1_5)),
        word("curb").only(from(V1_5)),
        word("paint").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static BRIDGE_TYPE: WordList = WordList {
    name: "e_bridgeType",
    words: &[word("concrete"), word("steel"), word("brick"), word("wood")],
    synonyms: &[],
};

pub(crate) static CONNECTION_TYPE: WordList = WordList {
    name: "e_connection_type",
    words: &[word("default").only(from(V1_5)), word("virtual").only(from(V1_5))],
    synonyms: &[],
};

pub(crate) static CONTACT_POINT: WordList =
    WordList { name: "e_contactPoint", words: &[word("start"), word("end")], synonyms: &[] };

pub(crate) static COUNTRY_CODE: WordList = WordList {
    name: "e_countryCode",
    words: &[
        word("OpenDRIVE").only(from(V1_5)),
        word("Austria").only(from(V1_5)),
        word("Brazil").only(from(V1_5)),
        word("China").only(from(V1_5)),
        word("France").only(from(V1_5)),
        word("Germany").only(from(V1_5)),
        word("Italy").only(from(V1_5)),
        word("Switzerland").only(from(V1_5)),
        word("USA").only(from(V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static COUNTRY_CODE_DEPRECATED: WordList = WordList {
    name: "e_countryCode_deprecated",
    words: &[
        word("OpenDRIVE").only(from(V1_5)),
        word("Austria").only(from(V1_5)),
        word("Brazil").only(from(V1_5)),
        word("China").only(from(V1_5)),
        word("France").only(from(V1_5)),
        word("Germany").only(from(V1_5)),
        word("Italy").only(from(V1_5)),
        word("Switzerland").only(from(V1_5)),
        word("USA").only(from(V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static POST_PROCESSING: WordList = WordList {
    name: "e_dataQuality_RawData_PostProcessing",
    words: &[
        word("raw").only(from(V1_5)),
        word("cleaned").only(from(V1_5)),
        word("processed").only(from(V1_5)),
        word("fused").only(from(V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static RAW_DATA_SOURCE: WordList = WordList {
    name: "e_dataQuality_RawData_Source",
    words: &[
        word("sensor").only(from(V1_5)),
        word("cadaster").only(from(V1_5)),
        word("custom").only(from(V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static DIRECTION: WordList =
    WordList { name: "e_direction", words: &[word("same"), word("opposite")], synonyms: &[] };

pub(crate) static ELEMENT_DIR: WordList =
    WordList { name: "e_elementDir", words: &[word("+"), word("-")], synonyms: &[] };

pub(crate) static JUNCTION_GROUP_TYPE: WordList = WordList {
    name: "e_junctionGroup_type",
    words: &[
        word("roundabout"),
        word("unknown"),
        word("complexJunction").only(from(V1_8)),
        word("highwayInterchange").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static SEGMENT_TYPE: WordList = WordList {
    name: "e_junction_segment_type",
    words: &[word("joint").only(from(V1_8)), word("lane").only(from(V1_8))],
    synonyms: &[],
};

pub(crate) static JUNCTION_CRG_MODE: WordList = WordList {
    name: "e_junction_surface_CRG_mode",
    words: &[word("global").only(between(V1_7, V1_7))],
    synonyms: &[],
};

pub(crate) static JUNCTION_TYPE: WordList = WordList {
    name: "e_junction_type",
    words: &[
        word("default").only(from(V1_5)),
        word("virtual").only(from(V1_5)),
        word("direct").only(from(V1_7)),
        word("crossing").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static LANE_ADVISORY: WordList = WordList {
    name: "e_laneAdvisory",
    words: &[
        word("both").only(from(V1_8)),
        word("inner").only(from(V1_8)),
        word("none").only(from(V1_8)),
        word("outer").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static LANE_TYPE: WordList = WordList {
    name: "e_laneType",
    words: &[
        word("shoulder"),
        word("border"),
        word("driving"),
        word("stop"),
        word("none"),
        word("restricted"),
        word("parking"),
        word("median"),
        word("biking"),
        word("shared").only(from(V1_8)),
        word("sidewalk"),
        word("curb").only(from(V1_6)),
        word("exit"),
        word("entry"),
        word("onRamp"),
        word("offRamp"),
        word("connectingRamp").only(from(V1_5)),
        word("bidirectional"),
        word("special1").deprecated(from(V1_8)),
        word("special2").deprecated(from(V1_8)),
        word("special3").deprecated(from(V1_8)),
        word("roadWorks"),
        word("tram"),
        word("rail"),
        word("bus").only(from(V1_5)),
        word("taxi").only(from(V1_5)),
        word("HOV").only(from(V1_5)),
        word("mwyEntry").only(from(V1_5)).deprecated(from(V1_6)),
        word("mwyExit").only(from(V1_5)).deprecated(from(V1_6)),
        word("walking").only(from(V1_8)),
        word("slipLane").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static LANE_DIRECTION: WordList = WordList {
    name: "e_lane_direction",
    words: &[
        word("both").only(from(V1_8)),
        word("reversed").only(from(V1_8)),
        word("standard").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static LAYER_TYPE: WordList = WordList {
    name: "e_layerType",
    words: &[word("temporary").only(from(V1_9)), word("permanent").only(from(V1_9))],
    synonyms: &[],
};

pub(crate) static MAX_SPEED_STRING: WordList = WordList {
    name: "e_maxSpeedString",
    words: &[word("no limit").only(from(V1_5)), word("undefined").only(from(V1_5))],
    synonyms: &[],
};

pub(crate) static OBJECT_TYPE: WordList = WordList {
    name: "e_objectType",
    words: &[
        word("none").only(from(V1_5)),
        word("obstacle").only(from(V1_5)),
        word("car").only(from(V1_5)).deprecated(from(V1_6)),
        word("pole").only(from(V1_5)),
        word("tree").only(from(V1_5)),
        word("vegetation").only(from(V1_5)),
        word("barrier").only(from(V1_5)),
        word("building").only(from(V1_5)),
        word("parkingSpace").only(from(V1_5)),
        word("patch").only(from(V1_5)),
        word("railing").only(from(V1_5)),
        word("trafficIsland").only(from(V1_5)),
        word("crosswalk").only(from(V1_5)),
        word("streetLamp").only(from(V1_5)),
        word("gantry").only(from(V1_5)),
        word("soundBarrier").only(from(V1_5)),
        word("truck").only(between(V1_5, V1_5)),
        word("van").only(from(V1_5)).deprecated(between(V1_6, V1_7)),
        word("bus").only(from(V1_5)).deprecated(from(V1_6)),
        word("trailer").only(from(V1_5)).deprecated(from(V1_6)),
        word("bike").only(from(V1_5)).deprecated(from(V1_6)),
        word("motorbike").only(from(V1_5)).deprecated(from(V1_6)),
        word("tram").only(from(V1_5)).deprecated(from(V1_6)),
        word("train").only(from(V1_5)).deprecated(from(V1_6)),
        word("pedestrian").only(from(V1_5)).deprecated(from(V1_6)),
        word("wind").only(from(V1_5)).deprecated(from(V1_6)),
        word("roadMark").only(from(V1_6)),
        word("roadSurface").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static ORIENTATION: WordList =
    WordList { name: "e_orientation", words: &[word("+"), word("-"), word("none")], synonyms: &[] };

pub(crate) static OUTLINE_FILL_TYPE: WordList = WordList {
    name: "e_outlineFillType",
    words: &[
        word("grass").only(from(V1_5)),
        word("concrete").only(from(V1_5)),
        word("cobble").only(from(V1_5)),
        word("asphalt").only(from(V1_5)),
        word("pavement").only(from(V1_5)),
        word("gravel").only(from(V1_5)),
        word("soil").only(from(V1_5)),
        word("paint").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static PARAM_POLY3_RANGE: WordList = WordList {
    name: "e_paramPoly3_pRange",
    words: &[word("arcLength"), word("normalized")],
    synonyms: &[],
};

pub(crate) static PERSON_CATEGORY: WordList = WordList {
    name: "e_personCategory",
    words: &[word("pedestrian").only(from(V1_9))],
    synonyms: &[],
};

pub(crate) static ROAD_MARK_COLOR: WordList = WordList {
    name: "e_roadMarkColor",
    words: &[
        word("standard"),
        word("blue"),
        word("green"),
        word("red"),
        word("white"),
        word("yellow"),
        word("black").only(from(V1_8)),
        word("orange").only(from(V1_5)),
        word("violet").only(from(V1_7)),
    ],
    synonyms: &[],
};

pub(crate) static ROAD_MARK_RULE: WordList = WordList {
    name: "e_roadMarkRule",
    words: &[word("no passing"), word("caution"), word("none")],
    synonyms: &[],
};

pub(crate) static ROAD_MARK_TYPE: WordList = WordList {
    name: "e_roadMarkType",
    words: &[
        word("none"),
        word("solid"),
        word("broken"),
        word("solid solid"),
        word("solid broken"),
        word("broken solid"),
        word("broken broken"),
        word("botts dots"),
        word("grass"),
        word("curb"),
        word("custom").only(from(V1_5)),
        word("edge").only(from(V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static ROAD_MARK_WEIGHT: WordList =
    WordList { name: "e_roadMarkWeight", words: &[word("standard"), word("bold")], synonyms: &[] };

pub(crate) static ROAD_TYPE: WordList = WordList {
    name: "e_roadType",
    words: &[
        word("unknown"),
        word("rural"),
        word("motorway"),
        word("town"),
        word("lowSpeed"),
        word("pedestrian"),
        word("bicycle"),
        word("townExpressway").only(from(V1_5)),
        word("townCollector").only(from(V1_5)),
        word("townArterial").only(from(V1_5)),
        word("townPrivate").only(from(V1_5)),
        word("townLocal").only(from(V1_5)),
        word("townPlayStreet").only(from(V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static LANE_CHANGE: WordList = WordList {
    name: "e_road_lanes_laneSection_lcr_lane_roadMark_laneChange",
    words: &[word("increase"), word("decrease"), word("both"), word("none")],
    synonyms: &[],
};

pub(crate) static ACCESS_RULE: WordList = WordList {
    name: "e_road_lanes_laneSection_lr_lane_access_rule",
    words: &[word("allow").only(from(V1_5)), word("deny").only(from(V1_5))],
    synonyms: &[],
};

pub(crate) static CROSSFALL_SIDE: WordList = WordList {
    name: "e_road_lateralProfile_crossfall_side",
    words: &[
        word("left").only(between(V1_4, V1_5)),
        word("right").only(between(V1_4, V1_5)),
        word("both").only(between(V1_4, V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static ELEMENT_TYPE: WordList = WordList {
    name: "e_road_link_elementType",
    words: &[word("road"), word("junction")],
    synonyms: &[],
};

pub(crate) static NEIGHBOR_SIDE: WordList = WordList {
    name: "e_road_link_neighbor_side",
    words: &[word("left").only(between(V1_4, V1_5)), word("right").only(between(V1_4, V1_5))],
    synonyms: &[],
};

pub(crate) static PARKING_SPACE_ACCESS: WordList = WordList {
    name: "e_road_objects_object_parkingSpace_access",
    words: &[
        word("all"),
        word("car"),
        word("women"),
        word("handicapped"),
        word("bus"),
        word("truck"),
        word("electric"),
        word("residents"),
    ],
    synonyms: &[],
};

pub(crate) static SWITCH_POSITION: WordList = WordList {
    name: "e_road_railroad_switch_position",
    words: &[word("dynamic"), word("straight"), word("turn")],
    synonyms: &[],
};

pub(crate) static DISPLAY_TYPE: WordList = WordList {
    name: "e_road_signals_displayType",
    words: &[
        word("LED").only(from(V1_8)),
        word("monochromGraphic").only(from(V1_8)),
        word("rotatingPrismHorizontal").only(from(V1_8)),
        word("rotatingPrismVertical").only(from(V1_8)),
        word("simpleMatrix").only(from(V1_8)),
        word("other").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static REFERENCE_ELEMENT_TYPE: WordList = WordList {
    name: "e_road_signals_signal_reference_elementType",
    words: &[word("object").only(from(V1_5)), word("signal").only(from(V1_5))],
    synonyms: &[],
};

pub(crate) static CRG_MODE: WordList = WordList {
    name: "e_road_surface_CRG_mode",
    words: &[word("attached"), word("attached0"), word("genuine"), word("global").only(from(V1_5))],
    synonyms: &[],
};

pub(crate) static CRG_PURPOSE: WordList = WordList {
    name: "e_road_surface_CRG_purpose",
    words: &[word("elevation"), word("friction")],
    synonyms: &[],
};

pub(crate) static SIDE_TYPE: WordList = WordList {
    name: "e_sideType",
    words: &[
        word("left").only(from(V1_5)),
        word("right").only(from(V1_5)),
        word("front").only(from(V1_5)),
        word("rear").only(from(V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static LANE_SEMANTICS_TYPE: WordList = WordList {
    name: "e_signals_semantics_lane",
    words: &[
        word("noOvertakeCars").only(from(V1_8)),
        word("noOvertakeCarsEnd").only(from(V1_8)),
        word("noOvertakeTrucks").only(from(V1_8)),
        word("noOvertakeTrucksEnd").only(from(V1_8)),
        word("priorityOverOncoming").only(from(V1_8)),
        word("roundabout").only(from(V1_8)),
        word("yieldForOncoming").only(from(V1_8)),
        word("other").only(from(V1_9)),
    ],
    synonyms: &[],
};

pub(crate) static PRIORITY_SEMANTICS_TYPE: WordList = WordList {
    name: "e_signals_semantics_priority",
    words: &[
        word("4way").only(from(V1_8)),
        word("keepClearLine").only(from(V1_8)),
        word("noParkingLine").only(from(V1_8)),
        word("noTurnOnRed").only(from(V1_8)),
        word("priorityRoad").only(from(V1_8)),
        word("priorityRoadEnd").only(from(V1_8)),
        word("priorityToTheRightRule").only(from(V1_8)),
        word("stop").only(from(V1_8)),
        word("stopLine").only(from(V1_8)),
        word("turnOnRedAllowed").only(from(V1_8)),
        word("trafficLight").only(from(V1_8)),
        word("waitingLine").only(from(V1_8)),
        word("yield").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static SPEED_SEMANTICS_KIND: WordList = WordList {
    name: "e_signals_semantics_speed",
    words: &[
        word("maximum").only(from(V1_8)),
        word("maximumEnd").only(from(V1_8)),
        word("minimum").only(from(V1_8)),
        word("minimumEnd").only(from(V1_8)),
        word("recommended").only(from(V1_8)),
        word("recommendedEnd").only(from(V1_8)),
        word("zone").only(from(V1_8)),
        word("zoneEnd").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static DISTANCE_SEMANTICS_TYPE: WordList = WordList {
    name: "e_signals_semantics_supplementaryDistance",
    words: &[word("for").only(from(V1_8)), word("in").only(from(V1_8))],
    synonyms: &[],
};

pub(crate) static ENVIRONMENT_SEMANTICS_TYPE: WordList = WordList {
    name: "e_signals_semantics_supplementaryEnvironment",
    words: &[
        word("fog").only(from(V1_8)),
        word("rain").only(from(V1_8)),
        word("snow").only(from(V1_8)),
    ],
    synonyms: &[],
};

pub(crate) static TIME_SEMANTICS_TYPE: WordList = WordList {
    name: "e_signals_semantics_supplementaryTime",
    words: &[word("day").only(from(V1_8)), word("time").only(from(V1_8))],
    synonyms: &[],
};

pub(crate) static PLATFORM_SIDE: WordList = WordList {
    name: "e_station_platform_segment_side",
    words: &[word("left").only(from(V1_5)), word("right").only(from(V1_5))],
    synonyms: &[],
};

pub(crate) static STATION_TYPE: WordList = WordList {
    name: "e_station_type",
    words: &[word("small"), word("medium"), word("large")],
    synonyms: &[],
};

pub(crate) static STRIP_MODE: WordList = WordList {
    name: "e_strip_mode",
    words: &[word("independent").only(from(V1_8)), word("relative").only(from(V1_8))],
    synonyms: &[],
};

pub(crate) static TRAFFIC_RULE: WordList = WordList {
    name: "e_trafficRule",
    words: &[word("RHT").only(from(V1_5)), word("LHT").only(from(V1_5))],
    synonyms: &[],
};

pub(crate) static TUNNEL_TYPE: WordList =
    WordList { name: "e_tunnelType", words: &[word("standard"), word("underpass")], synonyms: &[] };

pub(crate) static UNIT: WordList = WordList {
    name: "e_unit",
    words: &[
        word("m"),
        word("km"),
        word("ft"),
        word("mile"),
        word("m/s"),
        word("mph"),
        word("km/h"),
        word("kg"),
        word("t"),
        word("%"),
    ],
    synonyms: &[("km/h", "km/h"), ("kmh", "km/h"), ("kph", "km/h"), ("m/s", "m/s"), ("mph", "mph")],
};

pub(crate) static UNIT_DISTANCE: WordList = WordList {
    name: "e_unitDistance",
    words: &[
        word("m").only(from(V1_5)),
        word("km").only(from(V1_5)),
        word("ft").only(from(V1_5)),
        word("mile").only(from(V1_5)),
    ],
    synonyms: &[],
};

pub(crate) static UNIT_MASS: WordList = WordList {
    name: "e_unitMass",
    words: &[word("kg").only(from(V1_5)), word("t").only(from(V1_5))],
    synonyms: &[],
};

pub(crate) static UNIT_SLOPE: WordList =
    WordList { name: "e_unitSlope", words: &[word("%").only(from(V1_5))], synonyms: &[] };

pub(crate) static UNIT_SPEED: WordList = WordList {
    name: "e_unitSpeed",
    words: &[
        word("m").only(between(V1_4, V1_4)),
        word("m/s"),
        word("km").only(between(V1_4, V1_4)),
        word("mph"),
        word("ft").only(between(V1_4, V1_4)),
        word("km/h"),
        word("mile").only(between(V1_4, V1_4)),
        word("kg").only(between(V1_4, V1_4)),
        word("t").only(between(V1_4, V1_4)),
        word("%").only(between(V1_4, V1_4)),
    ],
    synonyms: &[("km/h", "km/h"), ("kmh", "km/h"), ("kph", "km/h"), ("m/s", "m/s"), ("mph", "mph")],
};

pub(crate) static VEHICLE_CATEGORY: WordList = WordList {
    name: "e_vehicleCategory",
    words: &[
        word("bicycle").only(from(V1_9)),
        word("car").only(from(V1_9)),
        word("semiTrailer").only(from(V1_9)),
        word("trailer").only(from(V1_9)),
        word("train").only(from(V1_9)),
        word("tram").only(from(V1_9)),
        word("van").only(from(V1_9)),
        word("bus").only(from(V1_9)),
        word("heavyTruck").only(from(V1_9)),
        word("microMobilityDevice").only(from(V1_9)),
        word("motorcycle").only(from(V1_9)),
        word("other").only(from(V1_9)),
        word("landVehicle").only(from(V1_9)),
        word("semiTractor").only(from(V1_9)),
        word("standupScooter").only(from(V1_9)),
        word("workMachine").only(from(V1_9)),
    ],
    synonyms: &[],
};

pub(crate) static PARKING_SPACE_MARKING_SIDE: WordList = WordList {
    name: "parkingSpacemarkingSide",
    words: &[
        word("front").only(between(V1_4, V1_4)),
        word("rear").only(between(V1_4, V1_4)),
        word("left").only(between(V1_4, V1_4)),
        word("right").only(between(V1_4, V1_4)),
    ],
    synonyms: &[],
};

pub(crate) static BOOL: WordList =
    WordList { name: "t_bool", words: &[word("true"), word("false")], synonyms: &[] };

pub(crate) static ROAD_END: WordList = WordList {
    name: "t_grEqZeroOrContactPoint",
    words: &[word("start").only(from(V1_8)), word("end").only(from(V1_8))],
    synonyms: &[],
};

pub(crate) static MAX_SPEED_WORD: WordList =
    WordList { name: "t_maxSpeed", words: &[word("no limit"), word("undefined")], synonyms: &[] };

pub(crate) static YES_NO: WordList =
    WordList { name: "t_yesNo", words: &[word("yes"), word("no")], synonyms: &[] };
