/* mapd for C: attach to a served map, or open a .mapd file, and query its lanes in place. Made from the sources of the crate mapd-c by cbindgen.
 *
 * Every function that can fail returns a mapd_code and takes an optional mapd_error of the caller's, which it writes only on an error.
 * A handle is closed with the function that takes its address and sets it to null. Lists go into the caller's buffer: capacity goes in, the number
 * of all entries comes out, and MAPD_CODE_TOO_SMALL says that only as many as there was room for were written; the buffer may be null where the
 * capacity is 0.
 *
 * Threads: a client, a snapshot, a view, a path and a projector may be used by several threads at once; a scratch, a tracker and events by one at
 * a time.
 * Lengths are metres, angles radians, times seconds, speeds metres per second; t is positive to the left of the reference line. A uint8_t that
 * answers yes or no is 1 or 0. docs/cpp.md begins with examples. */

#ifndef MAPD_H
#define MAPD_H

#include <stddef.h>
#include <stdint.h>
/* `vocabulary` of mapd_word. */
enum {
  MAPD_WORDS_LANE_TYPE = 1,
  MAPD_WORDS_CLASS = 2,
  MAPD_WORDS_VEHICLE_CLASS = 3,
  MAPD_WORDS_CONTACT_POINT = 4,
  MAPD_WORDS_EDGE_KIND = 5,
  MAPD_WORDS_CONFLICT_KIND = 6,
  MAPD_WORDS_ORIENTATION = 7,
  MAPD_WORDS_SIGNAL_POSITION = 8,
  MAPD_WORDS_LANE_METHOD = 9,
  MAPD_WORDS_RELATION = 10,
  MAPD_WORDS_RELATION_REASON = 11,
  MAPD_WORDS_OBJECT_SHAPE = 12,
  MAPD_WORDS_ROAD_MARK_KIND = 13,
  MAPD_WORDS_ROAD_MARK_COLOR = 14,
  MAPD_WORDS_ROAD_MARK_WEIGHT = 15,
  MAPD_WORDS_MARK_LANE_CHANGE = 16,
  MAPD_WORDS_ROAD_TYPE = 17,
  MAPD_WORDS_STRUCTURE_KIND = 18,
  MAPD_WORDS_OVERLAY_KIND = 19,
  MAPD_WORDS_QUARANTINED_KIND = 20,
  MAPD_WORDS_JUNCTION_GROUP_KIND = 21,
};

/* MAPD_LANE_TYPE_…: codes, with the words of mapd_word. */
enum {
  MAPD_LANE_TYPE_NONE = 0, /* none */
  MAPD_LANE_TYPE_DRIVING = 1, /* driving */
  MAPD_LANE_TYPE_STOP = 2, /* stop */
  MAPD_LANE_TYPE_SHOULDER = 3, /* shoulder */
  MAPD_LANE_TYPE_BIKING = 4, /* biking */
  MAPD_LANE_TYPE_SIDEWALK = 5, /* sidewalk */
  MAPD_LANE_TYPE_WALKING = 6, /* walking */
  MAPD_LANE_TYPE_BORDER = 7, /* border */
  MAPD_LANE_TYPE_RESTRICTED = 8, /* restricted */
  MAPD_LANE_TYPE_PARKING = 9, /* parking */
  MAPD_LANE_TYPE_CURB = 10, /* curb */
  MAPD_LANE_TYPE_BIDIRECTIONAL = 11, /* bidirectional */
  MAPD_LANE_TYPE_MEDIAN = 12, /* median */
  MAPD_LANE_TYPE_SPECIAL1 = 13, /* special1 */
  MAPD_LANE_TYPE_SPECIAL2 = 14, /* special2 */
  MAPD_LANE_TYPE_SPECIAL3 = 15, /* special3 */
  MAPD_LANE_TYPE_ROAD_WORKS = 16, /* roadWorks */
  MAPD_LANE_TYPE_TRAM = 17, /* tram */
  MAPD_LANE_TYPE_RAIL = 18, /* rail */
  MAPD_LANE_TYPE_ENTRY = 19, /* entry */
  MAPD_LANE_TYPE_EXIT = 20, /* exit */
  MAPD_LANE_TYPE_OFF_RAMP = 21, /* offRamp */
  MAPD_LANE_TYPE_ON_RAMP = 22, /* onRamp */
  MAPD_LANE_TYPE_CONNECTING_RAMP = 23, /* connectingRamp */
  MAPD_LANE_TYPE_BUS = 24, /* bus */
  MAPD_LANE_TYPE_TAXI = 25, /* taxi */
  MAPD_LANE_TYPE_HOV = 26, /* HOV */
  MAPD_LANE_TYPE_MWY_ENTRY = 27, /* mwyEntry */
  MAPD_LANE_TYPE_MWY_EXIT = 28, /* mwyExit */
  MAPD_LANE_TYPE_SHARED = 29, /* shared */
  MAPD_LANE_TYPE_SLIP_LANE = 30, /* slipLane */
};

/* MAPD_CLASS_…: codes, with the words of mapd_word. */
enum {
  MAPD_CLASS_NONE = 0, /* none */
  MAPD_CLASS_TRAFFIC_LIGHT = 10, /* traffic_light */
  MAPD_CLASS_PEDESTRIAN_LIGHT = 11, /* pedestrian_light */
  MAPD_CLASS_BICYCLE_LIGHT = 12, /* bicycle_light */
  MAPD_CLASS_PUBLIC_TRANSPORT_LIGHT = 13, /* public_transport_light */
  MAPD_CLASS_LANE_LIGHT = 14, /* lane_light */
  MAPD_CLASS_WARNING_LIGHT = 15, /* warning_light */
  MAPD_CLASS_LEVEL_CROSSING_LIGHT = 16, /* level_crossing_light */
  MAPD_CLASS_STOP = 20, /* stop */
  MAPD_CLASS_YIELD = 21, /* yield */
  MAPD_CLASS_PRIORITY_ROAD = 22, /* priority_road */
  MAPD_CLASS_END_OF_PRIORITY_ROAD = 23, /* end_of_priority_road */
  MAPD_CLASS_PRIORITY_AT_NEXT_JUNCTION = 24, /* priority_at_next_junction */
  MAPD_CLASS_YIELD_TO_ONCOMING = 25, /* yield_to_oncoming */
  MAPD_CLASS_PRIORITY_OVER_ONCOMING = 26, /* priority_over_oncoming */
  MAPD_CLASS_LEVEL_CROSSING = 27, /* level_crossing */
  MAPD_CLASS_ROUNDABOUT = 28, /* roundabout */
  MAPD_CLASS_PRIORITY_TO_THE_RIGHT = 29, /* priority_to_the_right */
  MAPD_CLASS_SPEED_LIMIT = 30, /* speed_limit */
  MAPD_CLASS_END_OF_SPEED_LIMIT = 31, /* end_of_speed_limit */
  MAPD_CLASS_SPEED_LIMIT_ZONE = 32, /* speed_limit_zone */
  MAPD_CLASS_END_OF_SPEED_LIMIT_ZONE = 33, /* end_of_speed_limit_zone */
  MAPD_CLASS_MINIMUM_SPEED = 34, /* minimum_speed */
  MAPD_CLASS_END_OF_MINIMUM_SPEED = 35, /* end_of_minimum_speed */
  MAPD_CLASS_ADVISORY_SPEED = 36, /* advisory_speed */
  MAPD_CLASS_END_OF_ADVISORY_SPEED = 37, /* end_of_advisory_speed */
  MAPD_CLASS_END_OF_RESTRICTIONS = 38, /* end_of_restrictions */
  MAPD_CLASS_NO_OVERTAKING = 40, /* no_overtaking */
  MAPD_CLASS_END_OF_NO_OVERTAKING = 41, /* end_of_no_overtaking */
  MAPD_CLASS_NO_OVERTAKING_BY_TRUCKS = 42, /* no_overtaking_by_trucks */
  MAPD_CLASS_END_OF_NO_OVERTAKING_BY_TRUCKS = 43, /* end_of_no_overtaking_by_trucks */
  MAPD_CLASS_NO_ENTRY = 50, /* no_entry */
  MAPD_CLASS_CLOSED_TO_VEHICLES = 51, /* closed_to_vehicles */
  MAPD_CLASS_CLOSED_TO_SOME = 52, /* closed_to_some */
  MAPD_CLASS_MAXIMUM_WEIGHT = 53, /* maximum_weight */
  MAPD_CLASS_MAXIMUM_HEIGHT = 54, /* maximum_height */
  MAPD_CLASS_MAXIMUM_WIDTH = 55, /* maximum_width */
  MAPD_CLASS_MAXIMUM_LENGTH = 56, /* maximum_length */
  MAPD_CLASS_NO_PARKING = 57, /* no_parking */
  MAPD_CLASS_NO_STOPPING = 58, /* no_stopping */
  MAPD_CLASS_NO_LEFT_TURN = 59, /* no_left_turn */
  MAPD_CLASS_NO_RIGHT_TURN = 60, /* no_right_turn */
  MAPD_CLASS_NO_UTURN = 61, /* no_u_turn */
  MAPD_CLASS_NO_TURN_ON_RED = 62, /* no_turn_on_red */
  MAPD_CLASS_TURN_ON_RED = 63, /* turn_on_red */
  MAPD_CLASS_NO_STRAIGHT_ON = 64, /* no_straight_on */
  MAPD_CLASS_MINIMUM_DISTANCE = 65, /* minimum_distance */
  MAPD_CLASS_MANDATORY_DIRECTION = 70, /* mandatory_direction */
  MAPD_CLASS_PASS_ON_SIDE = 71, /* pass_on_side */
  MAPD_CLASS_ONE_WAY = 72, /* one_way */
  MAPD_CLASS_LANE_ASSIGNMENT = 73, /* lane_assignment */
  MAPD_CLASS_BICYCLE_PATH = 74, /* bicycle_path */
  MAPD_CLASS_FOOTPATH = 75, /* footpath */
  MAPD_CLASS_SHARED_PATH = 76, /* shared_path */
  MAPD_CLASS_BUS_LANE = 77, /* bus_lane */
  MAPD_CLASS_MOTORWAY = 78, /* motorway */
  MAPD_CLASS_END_OF_MOTORWAY = 79, /* end_of_motorway */
  MAPD_CLASS_EXPRESSWAY = 80, /* expressway */
  MAPD_CLASS_END_OF_EXPRESSWAY = 81, /* end_of_expressway */
  MAPD_CLASS_TOWN = 82, /* town */
  MAPD_CLASS_END_OF_TOWN = 83, /* end_of_town */
  MAPD_CLASS_LIVING_STREET = 84, /* living_street */
  MAPD_CLASS_END_OF_LIVING_STREET = 85, /* end_of_living_street */
  MAPD_CLASS_PEDESTRIAN_ZONE = 86, /* pedestrian_zone */
  MAPD_CLASS_PARKING_SIGN = 87, /* parking_sign */
  MAPD_CLASS_BUS_STOP = 88, /* bus_stop */
  MAPD_CLASS_PEDESTRIAN_CROSSING = 89, /* pedestrian_crossing */
  MAPD_CLASS_WARNING = 100, /* warning */
  MAPD_CLASS_WARNING_ROAD_WORKS = 101, /* warning_road_works */
  MAPD_CLASS_WARNING_CURVE = 102, /* warning_curve */
  MAPD_CLASS_WARNING_JUNCTION = 103, /* warning_junction */
  MAPD_CLASS_WARNING_TRAFFIC_LIGHT = 104, /* warning_traffic_light */
  MAPD_CLASS_WARNING_PEDESTRIANS = 105, /* warning_pedestrians */
  MAPD_CLASS_WARNING_BICYCLES = 106, /* warning_bicycles */
  MAPD_CLASS_WARNING_ANIMALS = 107, /* warning_animals */
  MAPD_CLASS_WARNING_LEVEL_CROSSING = 108, /* warning_level_crossing */
  MAPD_CLASS_WARNING_NARROWING = 109, /* warning_narrowing */
  MAPD_CLASS_WARNING_SLIPPERY = 110, /* warning_slippery */
  MAPD_CLASS_WARNING_SLOPE = 111, /* warning_slope */
  MAPD_CLASS_WARNING_ONCOMING = 112, /* warning_oncoming */
  MAPD_CLASS_WARNING_YIELD = 113, /* warning_yield */
  MAPD_CLASS_WARNING_CONGESTION = 114, /* warning_congestion */
  MAPD_CLASS_GUIDE_SIGN = 120, /* guide_sign */
  MAPD_CLASS_INFORMATION_SIGN = 121, /* information_sign */
  MAPD_CLASS_SUPPLEMENTARY_PLATE = 122, /* supplementary_plate */
  MAPD_CLASS_BOARD = 123, /* board */
  MAPD_CLASS_VARIABLE_MESSAGE_BOARD = 124, /* variable_message_board */
  MAPD_CLASS_STREET_NAME = 125, /* street_name */
  MAPD_CLASS_DELINEATOR = 126, /* delineator */
  MAPD_CLASS_TRAFFIC_BARRIER_SIGN = 127, /* traffic_barrier_sign */
  MAPD_CLASS_CROSSWALK = 140, /* crosswalk */
  MAPD_CLASS_STOP_LINE = 141, /* stop_line */
  MAPD_CLASS_WAITING_LINE = 142, /* waiting_line */
  MAPD_CLASS_ARROW = 143, /* arrow */
  MAPD_CLASS_MARKING = 144, /* marking */
  MAPD_CLASS_RESTRICTED_AREA = 145, /* restricted_area */
  MAPD_CLASS_BICYCLE_CROSSING = 146, /* bicycle_crossing */
  MAPD_CLASS_SPEED_MARKING = 147, /* speed_marking */
  MAPD_CLASS_LANE_LINE = 148, /* lane_line */
  MAPD_CLASS_PARKING_SPACE = 200, /* parking_space */
  MAPD_CLASS_BARRIER = 201, /* barrier */
  MAPD_CLASS_RAILING = 202, /* railing */
  MAPD_CLASS_SOUND_BARRIER = 203, /* sound_barrier */
  MAPD_CLASS_POLE = 204, /* pole */
  MAPD_CLASS_STREET_LAMP = 205, /* street_lamp */
  MAPD_CLASS_GANTRY = 206, /* gantry */
  MAPD_CLASS_TREE = 207, /* tree */
  MAPD_CLASS_VEGETATION = 208, /* vegetation */
  MAPD_CLASS_BUILDING = 209, /* building */
  MAPD_CLASS_BRIDGE = 210, /* bridge */
  MAPD_CLASS_TUNNEL = 211, /* tunnel */
  MAPD_CLASS_OBSTACLE = 212, /* obstacle */
  MAPD_CLASS_TRAFFIC_CONE = 213, /* traffic_cone */
  MAPD_CLASS_TRAFFIC_ISLAND = 214, /* traffic_island */
  MAPD_CLASS_PATCH = 215, /* patch */
  MAPD_CLASS_SURFACE = 216, /* surface */
  MAPD_CLASS_VEHICLE = 217, /* vehicle */
  MAPD_CLASS_PERSON = 218, /* person */
  MAPD_CLASS_WIND = 219, /* wind */
  MAPD_CLASS_SIGN = 220, /* sign */
  MAPD_CLASS_STREET_FURNITURE = 221, /* street_furniture */
  MAPD_CLASS_STATION = 222, /* station */
  MAPD_CLASS_PLATFORM = 223, /* platform */
  MAPD_CLASS_GUARD_RAIL = 224, /* guard_rail */
};

/* MAPD_VEHICLE_CLASS_…: codes, with the words of mapd_word. */
enum {
  MAPD_VEHICLE_CLASS_PASSENGER_CAR = 0, /* passengerCar */
  MAPD_VEHICLE_CLASS_TRUCK = 1, /* truck */
  MAPD_VEHICLE_CLASS_BUS = 2, /* bus */
  MAPD_VEHICLE_CLASS_TAXI = 3, /* taxi */
  MAPD_VEHICLE_CLASS_MOTORCYCLE = 4, /* motorcycle */
  MAPD_VEHICLE_CLASS_EMERGENCY = 5, /* emergency */
  MAPD_VEHICLE_CLASS_DELIVERY = 6, /* delivery */
  MAPD_VEHICLE_CLASS_HOV = 7, /* HOV */
  MAPD_VEHICLE_CLASS_AUTONOMOUS = 8, /* autonomousTraffic */
  MAPD_VEHICLE_CLASS_THROUGH = 9, /* throughTraffic */
  MAPD_VEHICLE_CLASS_SIMULATOR = 10, /* simulator */
  MAPD_VEHICLE_CLASS_BICYCLE = 11, /* bicycle */
  MAPD_VEHICLE_CLASS_PEDESTRIAN = 12, /* pedestrian */
  MAPD_VEHICLE_CLASS_TRAM = 13, /* tram */
  MAPD_VEHICLE_CLASS_TRAIN = 14, /* train */
};

/* MAPD_CONTACT_POINT_…: codes, with the words of mapd_word. */
enum {
  MAPD_CONTACT_POINT_NONE = 0, /* none */
  MAPD_CONTACT_POINT_START = 1, /* start */
  MAPD_CONTACT_POINT_END = 2, /* end */
};

/* MAPD_EDGE_KIND_…: codes, with the words of mapd_word. */
enum {
  MAPD_EDGE_KIND_WITHIN = 0, /* within a lane */
  MAPD_EDGE_KIND_SECTION = 1, /* inside a road */
  MAPD_EDGE_KIND_ROAD = 2, /* over a road's end */
  MAPD_EDGE_KIND_CONNECTION = 3, /* connection */
  MAPD_EDGE_KIND_IMPLIED = 4, /* implied by a connection */
  MAPD_EDGE_KIND_VIRTUAL = 5, /* virtual junction */
  MAPD_EDGE_KIND_CROSS_PATH = 6, /* crossing path */
};

/* MAPD_CONFLICT_KIND_…: codes, with the words of mapd_word. */
enum {
  MAPD_CONFLICT_KIND_CROSS = 0, /* cross */
  MAPD_CONFLICT_KIND_MERGE = 1, /* merge */
  MAPD_CONFLICT_KIND_OVERLAP = 2, /* overlap */
  MAPD_CONFLICT_KIND_CROSSING = 3, /* crossing */
};

/* MAPD_ORIENTATION_…: codes, with the words of mapd_word. */
enum {
  MAPD_ORIENTATION_BOTH = 0, /* none */
  MAPD_ORIENTATION_ALONG = 1, /* + */
  MAPD_ORIENTATION_AGAINST = 2, /* - */
};

/* MAPD_SIGNAL_POSITION_…: codes, with the words of mapd_word. */
enum {
  MAPD_SIGNAL_POSITION_TRACK = 0, /* s and t */
  MAPD_SIGNAL_POSITION_ROAD = 1, /* positionRoad */
  MAPD_SIGNAL_POSITION_INERTIAL = 2, /* positionInertial */
};

/* MAPD_LANE_METHOD_…: codes, with the words of mapd_word. */
enum {
  MAPD_LANE_METHOD_VALIDITY = 0, /* validity */
  MAPD_LANE_METHOD_ORIENTATION = 1, /* orientation */
  MAPD_LANE_METHOD_TRACK = 2, /* s and t */
  MAPD_LANE_METHOD_NEAREST = 3, /* nearest */
  MAPD_LANE_METHOD_ORIENTATION_GUESS = 4, /* orientation guess */
};

/* MAPD_RELATION_…: codes, with the words of mapd_word. */
enum {
  MAPD_RELATION_YIELDS = 0, /* yields */
  MAPD_RELATION_PRIORITY = 1, /* priority */
  MAPD_RELATION_LIGHTS = 2, /* lights */
  MAPD_RELATION_OPEN = 3, /* open */
};

/* MAPD_RELATION_REASON_…: codes, with the words of mapd_word. */
enum {
  MAPD_RELATION_REASON_NONE = 0, /* none */
  MAPD_RELATION_REASON_LIGHTS = 1, /* lights */
  MAPD_RELATION_REASON_STOP_SIGN = 2, /* stop sign */
  MAPD_RELATION_REASON_YIELD_SIGN = 3, /* yield sign */
  MAPD_RELATION_REASON_PRIORITY_ROAD = 4, /* priority road */
  MAPD_RELATION_REASON_JUNCTION_PRIORITY = 5, /* junction priority */
  MAPD_RELATION_REASON_TURN = 6, /* turn across oncoming traffic */
  MAPD_RELATION_REASON_FROM_THE_RIGHT = 7, /* from the right */
};

/* MAPD_OBJECT_SHAPE_…: codes, with the words of mapd_word. */
enum {
  MAPD_OBJECT_SHAPE_POINT = 0, /* point */
  MAPD_OBJECT_SHAPE_BOX = 1, /* box */
  MAPD_OBJECT_SHAPE_CYLINDER = 2, /* cylinder */
  MAPD_OBJECT_SHAPE_OUTLINES = 3, /* outlines */
};

/* MAPD_ROAD_MARK_KIND_…: codes, with the words of mapd_word. */
enum {
  MAPD_ROAD_MARK_KIND_NOT_GIVEN = 0, /*  */
  MAPD_ROAD_MARK_KIND_NONE = 1, /* none */
  MAPD_ROAD_MARK_KIND_SOLID = 2, /* solid */
  MAPD_ROAD_MARK_KIND_BROKEN = 3, /* broken */
  MAPD_ROAD_MARK_KIND_SOLID_SOLID = 4, /* solid solid */
  MAPD_ROAD_MARK_KIND_SOLID_BROKEN = 5, /* solid broken */
  MAPD_ROAD_MARK_KIND_BROKEN_SOLID = 6, /* broken solid */
  MAPD_ROAD_MARK_KIND_BROKEN_BROKEN = 7, /* broken broken */
  MAPD_ROAD_MARK_KIND_BOTTS_DOTS = 8, /* botts dots */
  MAPD_ROAD_MARK_KIND_GRASS = 9, /* grass */
  MAPD_ROAD_MARK_KIND_CURB = 10, /* curb */
  MAPD_ROAD_MARK_KIND_CUSTOM = 11, /* custom */
  MAPD_ROAD_MARK_KIND_EDGE = 12, /* edge */
};

/* MAPD_ROAD_MARK_COLOR_…: codes, with the words of mapd_word. */
enum {
  MAPD_ROAD_MARK_COLOR_NOT_GIVEN = 0, /*  */
  MAPD_ROAD_MARK_COLOR_STANDARD = 1, /* standard */
  MAPD_ROAD_MARK_COLOR_BLUE = 2, /* blue */
  MAPD_ROAD_MARK_COLOR_GREEN = 3, /* green */
  MAPD_ROAD_MARK_COLOR_RED = 4, /* red */
  MAPD_ROAD_MARK_COLOR_WHITE = 5, /* white */
  MAPD_ROAD_MARK_COLOR_YELLOW = 6, /* yellow */
  MAPD_ROAD_MARK_COLOR_BLACK = 7, /* black */
  MAPD_ROAD_MARK_COLOR_ORANGE = 8, /* orange */
  MAPD_ROAD_MARK_COLOR_VIOLET = 9, /* violet */
};

/* MAPD_ROAD_MARK_WEIGHT_…: codes, with the words of mapd_word. */
enum {
  MAPD_ROAD_MARK_WEIGHT_NOT_GIVEN = 0, /*  */
  MAPD_ROAD_MARK_WEIGHT_STANDARD = 1, /* standard */
  MAPD_ROAD_MARK_WEIGHT_BOLD = 2, /* bold */
};

/* MAPD_MARK_LANE_CHANGE_…: codes, with the words of mapd_word. */
enum {
  MAPD_MARK_LANE_CHANGE_NOT_GIVEN = 0, /*  */
  MAPD_MARK_LANE_CHANGE_INCREASE = 1, /* increase */
  MAPD_MARK_LANE_CHANGE_DECREASE = 2, /* decrease */
  MAPD_MARK_LANE_CHANGE_BOTH = 3, /* both */
  MAPD_MARK_LANE_CHANGE_NONE = 4, /* none */
};

/* MAPD_ROAD_TYPE_…: codes, with the words of mapd_word. */
enum {
  MAPD_ROAD_TYPE_NONE = 0, /* none */
  MAPD_ROAD_TYPE_RURAL = 1, /* rural */
  MAPD_ROAD_TYPE_MOTORWAY = 2, /* motorway */
  MAPD_ROAD_TYPE_TOWN = 3, /* town */
  MAPD_ROAD_TYPE_LOW_SPEED = 4, /* lowSpeed */
  MAPD_ROAD_TYPE_PEDESTRIAN = 5, /* pedestrian */
  MAPD_ROAD_TYPE_BICYCLE = 6, /* bicycle */
  MAPD_ROAD_TYPE_TOWN_EXPRESSWAY = 7, /* townExpressway */
  MAPD_ROAD_TYPE_TOWN_COLLECTOR = 8, /* townCollector */
  MAPD_ROAD_TYPE_TOWN_ARTERIAL = 9, /* townArterial */
  MAPD_ROAD_TYPE_TOWN_PRIVATE = 10, /* townPrivate */
  MAPD_ROAD_TYPE_TOWN_LOCAL = 11, /* townLocal */
  MAPD_ROAD_TYPE_TOWN_PLAY_STREET = 12, /* townPlayStreet */
  MAPD_ROAD_TYPE_STATED_UNKNOWN = 13, /* unknown */
};

/* MAPD_STRUCTURE_KIND_…: codes, with the words of mapd_word. */
enum {
  MAPD_STRUCTURE_KIND_BRIDGE = 0, /* bridge */
  MAPD_STRUCTURE_KIND_TUNNEL = 1, /* tunnel */
};

/* MAPD_OVERLAY_KIND_…: codes, with the words of mapd_word. */
enum {
  MAPD_OVERLAY_KIND_CLOSED = 0, /* closed */
  MAPD_OVERLAY_KIND_OPEN = 1, /* open */
  MAPD_OVERLAY_KIND_SPEED = 2, /* speed */
  MAPD_OVERLAY_KIND_NO_OVERTAKING = 3, /* no-overtaking */
  MAPD_OVERLAY_KIND_WET = 4, /* wet */
  MAPD_OVERLAY_KIND_ICY = 5, /* icy */
  MAPD_OVERLAY_KIND_SIGNAL_OFF = 6, /* signal-off */
  MAPD_OVERLAY_KIND_WARNING = 7, /* warning */
  MAPD_OVERLAY_KIND_SNOW = 8, /* snow */
  MAPD_OVERLAY_KIND_ROUGH = 9, /* rough */
};

/* MAPD_QUARANTINED_KIND_…: codes, with the words of mapd_word. */
enum {
  MAPD_QUARANTINED_KIND_ROAD = 0, /* road */
  MAPD_QUARANTINED_KIND_JUNCTION = 1, /* junction */
  MAPD_QUARANTINED_KIND_CONNECTION = 2, /* connection */
  MAPD_QUARANTINED_KIND_OBJECT = 3, /* object */
  MAPD_QUARANTINED_KIND_SIGNAL = 4, /* signal */
  MAPD_QUARANTINED_KIND_CONTROLLER = 5, /* controller */
  MAPD_QUARANTINED_KIND_OTHER = 6, /* group */
  MAPD_QUARANTINED_KIND_LANE_LINK = 7, /* laneLink */
};

/* MAPD_JUNCTION_GROUP_KIND_…: codes, with the words of mapd_word. */
enum {
  MAPD_JUNCTION_GROUP_KIND_NONE = 0, /*  */
  MAPD_JUNCTION_GROUP_KIND_ROUNDABOUT = 1, /* roundabout */
  MAPD_JUNCTION_GROUP_KIND_OTHER = 2, /* unknown */
  MAPD_JUNCTION_GROUP_KIND_COMPLEX_JUNCTION = 3, /* complexJunction */
  MAPD_JUNCTION_GROUP_KIND_HIGHWAY_INTERCHANGE = 4, /* highwayInterchange */
};


/*
 Bytes of a message, its terminating 0 included. Longer ones are cut.
 */
#define MAPD_MESSAGE_SIZE 504

/*
 Row of an id that names nothing.
 */
#define MAPD_NO_ROW UINT32_MAX

/*
 `clamped` of a place: it was not moved.
 */
#define MAPD_CLAMPED_NO 0

/*
 `clamped` of a place: it lay before the beginning of the line and was moved there.
 */
#define MAPD_CLAMPED_BEFORE 1

/*
 `clamped` of a place: it lay after the end of the line and was moved there.
 */
#define MAPD_CLAMPED_AFTER 2

/*
 `kind` of an event: a newer generation is served; `mapd_client_snapshot` gives it from now on.
 */
#define MAPD_EVENT_GENERATION 1

/*
 `kind` of an event: a generation waits to be activated, see `mapd_client_pending`.
 */
#define MAPD_EVENT_PENDING 2

/*
 `kind` of an event: the daemon has ended. Snapshots stay readable; new subscribers cannot attach.
 */
#define MAPD_EVENT_DAEMON_GONE 3

/*
 `kind` of an event: a daemon serves the map again, or another daemon has replaced the one before.
 */
#define MAPD_EVENT_DAEMON_BACK 4

/*
 `kind` of an event that this release does not know.
 */
#define MAPD_EVENT_OTHER 255

/*
 `kind` of a road link: nothing is written.
 */
#define MAPD_ROAD_LINK_NONE 0

/*
 `kind` of a road link: a road.
 */
#define MAPD_ROAD_LINK_ROAD 1

/*
 `kind` of a road link: a junction.
 */
#define MAPD_ROAD_LINK_JUNCTION 2

/*
 `kind` of a road link: something that the map does not have.
 */
#define MAPD_ROAD_LINK_UNRESOLVED 3

/*
 `side` of `mapd_lane_beside`: to the left of the lane's traffic, whichever way that lane is travelled itself.
 */
#define MAPD_BESIDE_LEFT 0

/*
 `side` of `mapd_lane_beside`: to the right of the lane's traffic.
 */
#define MAPD_BESIDE_RIGHT 1

/*
 `side` of `mapd_lane_beside`: towards lane 0, lane 0 included.
 */
#define MAPD_BESIDE_INNER 2

/*
 `side` of `mapd_lane_beside`: the nearest one that is travelled the other way.
 */
#define MAPD_BESIDE_OPPOSITE 3

/*
 `side` of `mapd_lane_beside`: to the left of the reference line's direction; lane 0 is skipped.
 */
#define MAPD_BESIDE_LEFT_OF_REFERENCE_LINE 4

/*
 `side` of `mapd_lane_beside`: to the right of the reference line's direction; lane 0 is skipped.
 */
#define MAPD_BESIDE_RIGHT_OF_REFERENCE_LINE 5

/*
 `state` of a tracked vehicle: it is in the lane.
 */
#define MAPD_TRACKED_LANE 0

/*
 `state` of a tracked vehicle: it is in no lane, or across them.
 */
#define MAPD_TRACKED_NO_LANE 1

/*
 `state` of a tracked vehicle: unknown.
 */
#define MAPD_TRACKED_UNKNOWN 2

/*
 `painted` of a road mark: there is paint.
 */
#define MAPD_PAINTED_YES 1

/*
 `painted` of a road mark: there is a gap.
 */
#define MAPD_PAINTED_NO 0

/*
 `painted` of a road mark: its kind has gaps, and the file does not say which.
 */
#define MAPD_PAINTED_UNKNOWN 2

/*
 `line` of `mapd_lane_line`: the centre line. Empty for lane 0.
 */
#define MAPD_LINE_CENTER 0

/*
 `line` of `mapd_lane_line`: the border on the left of the lane's traffic.
 */
#define MAPD_LINE_LEFT 1

/*
 `line` of `mapd_lane_line`: the border on the right of the lane's traffic.
 */
#define MAPD_LINE_RIGHT 2

/*
 `line` of `mapd_lane_line`: the border away from lane 0; for lane 0 the shifted reference line.
 */
#define MAPD_LINE_BORDER 3

/*
 `by` of a cost: metres along centre lines.
 */
#define MAPD_COST_LENGTH 0

/*
 `by` of a cost: seconds at the speed limits.
 */
#define MAPD_COST_TIME 1

/*
 `enter` of a step: the route starts on its lane.
 */
#define MAPD_ENTER_START 0

/*
 `enter` of a step: from behind, over the end of another lane.
 */
#define MAPD_ENTER_AHEAD 1

/*
 `enter` of a step: by a change of lane to the left, in driving direction.
 */
#define MAPD_ENTER_LEFT 2

/*
 `enter` of a step: by a change of lane to the right, in driving direction.
 */
#define MAPD_ENTER_RIGHT 3

/*
 `kind` of a fact: a junction, from where the path enters it to where it leaves it; `junction`, and in `code` where the movement leads, a `MAPD_TURN_…`.
 */
#define MAPD_PATH_FACT_JUNCTION 0

/*
 `kind` of a fact: a signal for the driven lane; `signal`, `governs`.
 */
#define MAPD_PATH_FACT_SIGNAL 1

/*
 `kind` of a fact: a stop line, crosswalk or bicycle crossing; `line`, `left`, `right`.
 */
#define MAPD_PATH_FACT_LINE 2

/*
 `kind` of a fact: the road's type, where the file gives one; `code` is a `MAPD_ROAD_TYPE_…`.
 */
#define MAPD_PATH_FACT_ROAD_TYPE 3

/*
 `kind` of a fact: type of the driven lane; `code` is a `MAPD_LANE_TYPE_…`.
 */
#define MAPD_PATH_FACT_LANE_TYPE 4

/*
 `kind` of a fact: a bridge or tunnel; `number` among `mapd_structures`, `code` a `MAPD_STRUCTURE_KIND_…`.
 */
#define MAPD_PATH_FACT_STRUCTURE 5

/*
 `kind` of a fact: a part of the document near the path that is left out of the map; `number` among `mapd_quarantined_parts`.
 */
#define MAPD_PATH_FACT_HOLE 6

/*
 `kind` of a fact: the country whose rules hold, where the file gives one; `number` for `mapd_country`.
 */
#define MAPD_PATH_FACT_COUNTRY 7

/*
 `kind` of a fact: who may use the driven lane in its driven direction; in `number` the bit `1 << MAPD_VEHICLE_CLASS_…` of each class.
 */
#define MAPD_PATH_FACT_ACCESS 8

/*
 `kind` of a fact that this release has no word for.
 */
#define MAPD_PATH_FACT_OTHER 255

/*
 `kind` of a path's change: its lane has the same key and has moved, by at most `distance` where it was looked at.
 */
#define MAPD_PATH_CHANGE_MOVED 0

/*
 `kind` of a path's change: a lane with another key lies there, at most `distance` away where it was looked at.
 */
#define MAPD_PATH_CHANGE_REPLACED 1

/*
 `kind` of a path's change: no lane lies there for the vehicle and its direction.
 */
#define MAPD_PATH_CHANGE_GONE 2

/*
 `edge` of an edge: another lane of the road lies beyond, of whatever type, on the same level.
 */
#define MAPD_PATH_EDGE_LANE 0

/*
 `edge` of an edge: a kerb, by its mark, by the lane beyond, or by a step of 3 cm or more.
 */
#define MAPD_PATH_EDGE_KERB 1

/*
 `edge` of an edge: the road has no lane beyond. In a junction, that of another road may lie there.
 */
#define MAPD_PATH_EDGE_ROAD_END 2

/*
 `edges` of an outline: those of the driven lane.
 */
#define MAPD_CORRIDOR_EDGES_DRIVEN 0

/*
 `edges` of an outline: those of all lanes beside it that have its direction and are open to the vehicle.
 */
#define MAPD_CORRIDOR_EDGES_OPEN 1

/*
 `yields` of a conflict: the vehicle on the path gives way.
 */
#define MAPD_YIELDS_YIELDS 0

/*
 `yields` of a conflict: the other gives way.
 */
#define MAPD_YIELDS_PRIORITY 1

/*
 `yields` of a conflict: lights decide.
 */
#define MAPD_YIELDS_LIGHTS 2

/*
 `yields` of a conflict: the file does not say. A rule of the road may; the reason names it.
 */
#define MAPD_YIELDS_UNKNOWN 3

/*
 `direction` of a start or goal: either way.
 */
#define MAPD_DIRECTION_EITHER 0

/*
 `direction` of a start or goal: towards +s.
 */
#define MAPD_DIRECTION_FORWARD 1

/*
 `direction` of a start or goal: towards −s.
 */
#define MAPD_DIRECTION_BACKWARD 2

/*
 `origin` of a speed rule: a sign.
 */
#define MAPD_SPEED_ORIGIN_SIGNAL 0

/*
 `origin` of a speed rule: the lane's own record.
 */
#define MAPD_SPEED_ORIGIN_LANE 1

/*
 `origin` of a speed rule: the road's type.
 */
#define MAPD_SPEED_ORIGIN_ROAD_TYPE 2

/*
 `origin` of a speed rule: the header's regulations for the road's type.
 */
#define MAPD_SPEED_ORIGIN_DEFAULT 3

/*
 `origin` of a speed rule: nothing in the map.
 */
#define MAPD_SPEED_ORIGIN_NONE 4

/*
 `origin` of a speed rule: what holds where the junction is entered.
 */
#define MAPD_SPEED_ORIGIN_ENTRY 5

/*
 `origin` of a speed rule: what holds where the junction is entered, which is not the same on all lanes that lead to the place.
 */
#define MAPD_SPEED_ORIGIN_DEPENDS 6

/*
 `origin` of a speed rule: an entry of today's overlay, in what a view says.
 */
#define MAPD_SPEED_ORIGIN_OVERLAY 7

/*
 `which` of `mapd_lane_signals`: all that are for the lane.
 */
#define MAPD_LANE_SIGNALS_ALL 0

/*
 `which` of `mapd_lane_signals`: lights.
 */
#define MAPD_LANE_SIGNALS_LIGHTS 1

/*
 `which` of `mapd_lane_signals`: lines at which the lane's traffic stops or gives way.
 */
#define MAPD_LANE_SIGNALS_STOP_LINES 2

/*
 `which` of `mapd_lane_signals`: crosswalks that are written as signals.
 */
#define MAPD_LANE_SIGNALS_CROSSWALKS 3

/*
 `turn` of a movement: to the left.
 */
#define MAPD_TURN_LEFT 1

/*
 `turn` of a movement: straight on.
 */
#define MAPD_TURN_STRAIGHT 2

/*
 `turn` of a movement: to the right.
 */
#define MAPD_TURN_RIGHT 4

/*
 `turn` of a movement: back.
 */
#define MAPD_TURN_BACK 8

/*
 `basis` of a right of way: the file says so, by signs, lights or `junction/priority`.
 */
#define MAPD_BASIS_WRITTEN 0

/*
 `basis` of a right of way: a rule of the road says so, of a country that the caller names.
 */
#define MAPD_BASIS_RULE 1

/*
 `basis` of a right of way: nothing decides.
 */
#define MAPD_BASIS_UNKNOWN 2

/*
 `which` of `mapd_lane_lines`: lines at which the lane's traffic stops or gives way.
 */
#define MAPD_LANE_LINES_TO_STOP_AT 0

/*
 `which` of `mapd_lane_lines`: crosswalks and bicycle crossings over the lane.
 */
#define MAPD_LANE_LINES_CROSSINGS 1

/*
 `which` of `mapd_lane_lines`: crosswalks and bicycle crossings that the movement through this lane of a junction passes.
 */
#define MAPD_LANE_LINES_MOVEMENT_CROSSINGS 2

/*
 `which` of `mapd_signal_links`: signals that it controls or depends on.
 */
#define MAPD_SIGNAL_LINKS_DEPENDENCIES 0

/*
 `which` of `mapd_signal_links`: objects and signals that belong to it, such as the pole that it hangs from.
 */
#define MAPD_SIGNAL_LINKS_BELONGINGS 1

/*
 What a call came to. Codes below `MAPD_CODE_NULL_POINTER` are no errors.
 */
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
enum mapd_code : int32_t
#else
enum
#endif
{
  /*
   Done.
   */
  MAPD_CODE_OK = 0,
  /*
   There is no such thing: no lane near enough, no road of this id, nothing before the deadline. What was to be written is as before.
   */
  MAPD_CODE_NONE = 1,
  /*
   The buffer is too small: it holds as many entries as it has room for, and the count says how many there are.
   */
  MAPD_CODE_TOO_SMALL = 2,
  /*
   A pointer that is needed is null; a handle was closed, or never made.
   */
  MAPD_CODE_NULL_POINTER = 10,
  /*
   An argument cannot be used: text that is not UTF-8, an unknown code, an id that names nothing, a misaligned pointer, options of another size.
   */
  MAPD_CODE_ARGUMENT = 11,
  /*
   A number that is not finite.
   */
  MAPD_CODE_NOT_FINITE = 12,
  /*
   The id belongs to another map content: look it up again by its key or name in this snapshot.
   */
  MAPD_CODE_FOREIGN_ID = 13,
  /*
   The archive is damaged at this place.
   */
  MAPD_CODE_CORRUPT = 14,
  /*
   No daemon is running in the domain.
   */
  MAPD_CODE_NO_DAEMON = 20,
  /*
   Daemons are running, but none serves this map.
   */
  MAPD_CODE_NO_SUCH_MAP = 21,
  /*
   No (newer) generation came before the deadline.
   */
  MAPD_CODE_NO_GENERATION = 22,
  /*
   The generation that was asked for is no longer served.
   */
  MAPD_CODE_SUPERSEDED = 23,
  /*
   The daemon speaks another revision of the transport.
   */
  MAPD_CODE_WRONG_TRANSPORT = 24,
  /*
   All places for clients of this map are taken.
   */
  MAPD_CODE_TOO_MANY_SUBSCRIBERS = 25,
  /*
   This client holds as many generations as it can: close old snapshots.
   */
  MAPD_CODE_TOO_MANY_PINNED = 26,
  /*
   The daemon's files belong to another user.
   */
  MAPD_CODE_PERMISSION_DENIED = 27,
  /*
   A file that a killed process left is in the way.
   */
  MAPD_CODE_STUCK = 28,
  /*
   The daemon did not release its lock in time.
   */
  MAPD_CODE_BUSY = 29,
  /*
   Shared memory is full.
   */
  MAPD_CODE_NO_ROOM = 30,
  /*
   A file of the domain cannot be used, or shared memory failed.
   */
  MAPD_CODE_TRANSPORT = 31,
  /*
   The domain's prefix or the map's name cannot be used.
   */
  MAPD_CODE_NAME = 32,
  /*
   The daemon refuses what was proposed: the message has its reason.
   */
  MAPD_CODE_REFUSED = 33,
  /*
   The daemon did not decide in time.
   */
  MAPD_CODE_LATE = 34,
  /*
   This process may open no more files: close some, or raise its limit.
   */
  MAPD_CODE_NO_DESCRIPTORS = 35,
  /*
   The bytes are no archive that this library reads.
   */
  MAPD_CODE_NOT_AN_ARCHIVE = 40,
  /*
   The archive does not prove.
   */
  MAPD_CODE_NOT_PROVEN = 41,
  /*
   The file cannot be read.
   */
  MAPD_CODE_FILE = 42,
  /*
   The archive is not signed by the trusted key, or not what was signed.
   */
  MAPD_CODE_NOT_TRUSTED = 43,
  /*
   The map has no georeference that can be used.
   */
  MAPD_CODE_NO_PROJECTION = 50,
  /*
   The place lies outside the area of the map's projection.
   */
  MAPD_CODE_OUTSIDE = 51,
  /*
   A latitude or longitude that there is not.
   */
  MAPD_CODE_NO_PLACE_ON_EARTH = 52,
  /*
   Something that this library has no code for.
   */
  MAPD_CODE_OTHER = 98,
  /*
   A bug in mapd: the message says where. Nothing else is known of what the call did.
   */
  MAPD_CODE_PANIC = 99,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum mapd_code mapd_code;
#else
typedef int32_t mapd_code;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/*
 A connection to one served map. Several threads may use it at once.
 */
typedef struct mapd_client mapd_client;

/*
 A follower of a map. It belongs to one thread at a time and keeps its client.
 */
typedef struct mapd_events mapd_events;

/*
 A route as one line. It keeps its snapshot; several threads may use it at once.
 */
typedef struct mapd_path mapd_path;

/*
 Converts between a map's inertial frame and WGS 84. Several threads may use it at once. It is made from a snapshot and needs it no longer.
 */
typedef struct mapd_projector mapd_projector;

/*
 Memory of searches and lists, to be used again: it grows with the largest answer and is then enough. It belongs to one thread
 at a time and to no map.
 */
typedef struct mapd_scratch mapd_scratch;

/*
 One generation of a map, pinned: readable as long as the handle is open, even if daemon, client and file are gone. Several threads may
 use it at once.
 */
typedef struct mapd_snapshot mapd_snapshot;

/*
 A running filter over poses. All its memory is taken when it is made. It belongs to one thread at a time and to no map.
 */
typedef struct mapd_tracker mapd_tracker;

/*
 A map under its overlay at a moment. It keeps its snapshot; several threads may use it at once.
 */
typedef struct mapd_view mapd_view;

/*
 Why a call failed. It is the caller's; a call that ends with an error writes it, any other leaves it as it was.
 */
typedef struct mapd_error {
  /*
   What the call returned.
   */
  mapd_code code;
  /*
   Length of the message in bytes.
   */
  uint32_t length;
  /*
   The message for people, UTF-8, terminated by 0.
   */
  char message[MAPD_MESSAGE_SIZE];
} mapd_error;

/*
 A generation of a map in shared memory.
 */
typedef struct mapd_generation {
  /*
   Its number; rises with every swap.
   */
  uint64_t generation;
  /*
   Length of its archive in bytes.
   */
  uint64_t length;
} mapd_generation;

/*
 An event of a map or its daemon.
 */
typedef struct mapd_event {
  /*
   A `MAPD_EVENT_…`.
   */
  uint32_t kind;
  /*
   Of `DAEMON_BACK`: its process id, in its own process namespace; 0 if it is not known.
   */
  uint32_t pid;
  /*
   Of `GENERATION` and `PENDING`: the number.
   */
  uint64_t generation;
} mapd_event;

/*
 A text in the snapshot: UTF-8, not terminated by 0. It is valid as long as a handle of the snapshot's content is open: the snapshot
 itself, its clones and what was made from it.
 */
typedef struct mapd_text {
  /*
   Its first byte; never null.
   */
  const char *data;
  /*
   Its length in bytes.
   */
  size_t size;
} mapd_text;

/*
 A place or direction in space, inertial [m].
 */
typedef struct mapd_vec3 {
  /*
   East [m].
   */
  double x;
  /*
   North [m].
   */
  double y;
  /*
   Up [m].
   */
  double z;
} mapd_vec3;

/*
 Facts about a map.
 */
typedef struct mapd_map_facts {
  /*
   Number of the generation; 0 for a file.
   */
  uint64_t generation;
  /*
   BLAKE3 of the archive's body.
   */
  uint8_t content_hash[32];
  /*
   BLAKE3 of the OpenDRIVE bytes that it was compiled from.
   */
  uint8_t source_hash[32];
  /*
   Name in the file's header.
   */
  struct mapd_text name;
  /*
   `geoReference` as written; empty if there is none.
   */
  struct mapd_text geo_reference;
  /*
   The georeference as PROJ parameters; empty if there is none that can be used.
   */
  struct mapd_text projection;
  /*
   The header's offset as it is applied: shift [m].
   */
  struct mapd_vec3 header_offset;
  /*
   The header's offset as it is applied: turn [rad].
   */
  double header_heading;
  /*
   Smallest inertial coordinates of all lanes [m].
   */
  struct mapd_vec3 low;
  /*
   Largest inertial coordinates of all lanes [m].
   */
  struct mapd_vec3 high;
  /*
   Sum of the roads' lengths [m].
   */
  double road_length;
  /*
   First eight bytes of the content's hash, as in every id.
   */
  uint64_t content;
  /*
   Number of roads.
   */
  uint32_t roads;
  /*
   Number of junctions.
   */
  uint32_t junctions;
  /*
   Number of signals.
   */
  uint32_t signals;
  /*
   Number of objects.
   */
  uint32_t objects;
  /*
   OpenDRIVE's version: major; 0 where the file has none.
   */
  uint16_t revision_major;
  /*
   OpenDRIVE's version: minor.
   */
  uint16_t revision_minor;
} mapd_map_facts;

/*
 Latitudes and longitudes of a map's bounds on WGS 84 [deg].
 */
typedef struct mapd_geodetic_bounds {
  /*
   Smallest latitude.
   */
  double south;
  /*
   Largest latitude.
   */
  double north;
  /*
   Western longitude.
   */
  double west;
  /*
   Eastern longitude; it passes 180 where the map crosses the antimeridian.
   */
  double east;
} mapd_geodetic_bounds;

/*
 A road. Bound to the map content that it came from, and refused by any other; a row of `MAPD_NO_ROW` names nothing.
 */
typedef struct mapd_road_id {
  /*
   Row in the archive's table.
   */
  uint32_t row;
  /*
   The tile of a set of maps: 0.
   */
  uint32_t tile;
  /*
   First eight bytes of the content's hash.
   */
  uint64_t content;
} mapd_road_id;

/*
 A junction; as `mapd_road_id` otherwise.
 */
typedef struct mapd_junction_id {
  /*
   Row in the archive's table.
   */
  uint32_t row;
  /*
   The tile of a set of maps: 0.
   */
  uint32_t tile;
  /*
   First eight bytes of the content's hash.
   */
  uint64_t content;
} mapd_junction_id;

/*
 A signal; as `mapd_road_id` otherwise.
 */
typedef struct mapd_signal_id {
  /*
   Row in the archive's table.
   */
  uint32_t row;
  /*
   The tile of a set of maps: 0.
   */
  uint32_t tile;
  /*
   First eight bytes of the content's hash.
   */
  uint64_t content;
} mapd_signal_id;

/*
 An object; as `mapd_road_id` otherwise.
 */
typedef struct mapd_object_id {
  /*
   Row in the archive's table.
   */
  uint32_t row;
  /*
   The tile of a set of maps: 0.
   */
  uint32_t tile;
  /*
   First eight bytes of the content's hash.
   */
  uint64_t content;
} mapd_object_id;

/*
 A lane of a section; as `mapd_road_id` otherwise. What may leave the process is the lane's key: `mapd_lane_key`.
 */
typedef struct mapd_lane_id {
  /*
   Row in the archive's table.
   */
  uint32_t row;
  /*
   The tile of a set of maps: 0.
   */
  uint32_t tile;
  /*
   First eight bytes of the content's hash.
   */
  uint64_t content;
} mapd_lane_id;

/*
 A point in a lane's own coordinates. Left, right and ahead are those of the lane's traffic unless a name says `of_reference_line`.
 */
typedef struct mapd_lane_position {
  /*
   Along the road's reference line [m], within the lane's section.
   */
  double s;
  /*
   Lateral on the road [m], positive to the left of the reference line.
   */
  double t;
  /*
   From the lane's centre [m], positive to the left as its traffic goes.
   */
  double offset;
  /*
   From the lane's centre [m], positive to the left of the reference line.
   */
  double offset_of_reference_line;
  /*
   Plan-view distance from the lane's area [m]; 0 inside.
   */
  double distance;
  /*
   Height of the plane h = 0 at (s, t) [m].
   */
  double z;
  /*
   The way the lane's traffic goes at s and this offset [rad], in (−π, π]: the heading of `mapd_lane_pose_at`.
   */
  double heading;
  /*
   Heading of the reference line at s [rad], in (−π, π].
   */
  double heading_of_reference_line;
  /*
   Whether the point lies before or after the lane's section in the direction of s.
   */
  uint8_t clamped;
} mapd_lane_position;

/*
 The nearest lane and the point in its coordinates.
 */
typedef struct mapd_nearest {
  /*
   The lane; of a point of a batch that has none, a row of `MAPD_NO_ROW`.
   */
  struct mapd_lane_id lane;
  /*
   The point's place with respect to it.
   */
  struct mapd_lane_position position;
} mapd_nearest;

/*
 What counts as a match. Set it with `mapd_nearest_options_init`, then change what should differ.
 */
typedef struct mapd_nearest_options {
  /*
   Size of this struct as the caller knows it: later releases may append to it.
   */
  size_t size;
  /*
   Largest plan-view distance from the lane's area [m]. Default 10.
   */
  double radius;
  /*
   Lane types that count: the bit of each is `1 << code`; `UINT64_MAX`, the default, is all. See `mapd_lane_types_drivable` and `mapd_lane_types_routable`.
   */
  uint64_t types;
  /*
   Largest difference between the point's z and the lane's [m]; counts only with `has_z_tolerance` and a point that has z.
   */
  double z_tolerance;
  /*
   Heading of travel [rad]; counts only with `has_heading`. Breaks ties, and excludes places by `heading_tolerance`.
   */
  double heading;
  /*
   Largest difference between `heading` and the lane's driving direction [rad]; counts only with `has_heading_tolerance`.
   */
  double heading_tolerance;
  /*
   Not 0: `z_tolerance` counts. Default 0.
   */
  uint8_t has_z_tolerance;
  /*
   Not 0: `heading` counts. Default 0.
   */
  uint8_t has_heading;
  /*
   Not 0: `heading_tolerance` counts. Default 0.
   */
  uint8_t has_heading_tolerance;
  /*
   Not 0: `vehicle` counts. Default 0.
   */
  uint8_t has_vehicle;
  /*
   Only places that this class of vehicles may use count, in either direction: a `MAPD_VEHICLE_CLASS_…`.
   */
  uint8_t vehicle;
  /*
   The answer for a point nearby, such as the one before on a trajectory: it makes the search cheaper and never changes its answer.
   Default null.
   */
  const struct mapd_nearest *hint;
} mapd_nearest_options;

/*
 A point that is asked about.
 */
typedef struct mapd_point {
  /*
   East [m].
   */
  double x;
  /*
   North [m].
   */
  double y;
  /*
   Up [m]; counts only with `has_z`.
   */
  double z;
  /*
   Not 0: z is known.
   */
  uint64_t has_z;
} mapd_point;

/*
 A place in plan view, inertial [m].
 */
typedef struct mapd_vec2 {
  /*
   East [m].
   */
  double x;
  /*
   North [m].
   */
  double y;
} mapd_vec2;

/*
 A rectangle along the axes, inertial [m], edges included.
 */
typedef struct mapd_region {
  /*
   Smallest x and y.
   */
  struct mapd_vec2 low;
  /*
   Largest x and y.
   */
  struct mapd_vec2 high;
} mapd_region;

/*
 What a road is linked to at one of its ends.
 */
typedef struct mapd_road_link {
  /*
   The road, of a link to one.
   */
  struct mapd_road_id road;
  /*
   The junction, of a link to one.
   */
  struct mapd_junction_id junction;
  /*
   A `MAPD_ROAD_LINK_…`.
   */
  uint8_t kind;
  /*
   Which end of the road is touched: a `MAPD_CONTACT_POINT_…`.
   */
  uint8_t contact;
} mapd_road_link;

/*
 A road.
 */
typedef struct mapd_road_facts {
  /*
   The road itself.
   */
  struct mapd_road_id road;
  /*
   The junction that this is a connecting road of, if any.
   */
  struct mapd_junction_id junction;
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   OpenDRIVE's name.
   */
  struct mapd_text name;
  /*
   Length of the reference line as written [m].
   */
  double length;
  /*
   Largest s that the reference line reaches [m].
   */
  double reference_end;
  /*
   What lies at s = 0.
   */
  struct mapd_road_link predecessor;
  /*
   What lies at s = length.
   */
  struct mapd_road_link successor;
  /*
   Number of lane sections.
   */
  uint32_t sections;
  /*
   Line of the start tag in the file, from 1.
   */
  uint32_t line;
  /*
   Column of the start tag in the file, from 1.
   */
  uint32_t column;
  /*
   1: traffic keeps to the left.
   */
  uint8_t is_left_hand_traffic;
} mapd_road_facts;

/*
 Track coordinates of a road (OpenDRIVE 1.8.1, 8.3).
 */
typedef struct mapd_track {
  /*
   Along the reference line [m].
   */
  double s;
  /*
   Lateral [m], positive to the left of the reference line.
   */
  double t;
  /*
   Upwards [m], perpendicular to the plane rolled by superelevation.
   */
  double h;
} mapd_track;

/*
 A place on or beside a road or lane, with the frame there: of a road ahead is the way its reference line runs, of a lane the way its
 traffic goes.
 */
typedef struct mapd_pose {
  /*
   Inertial position [m].
   */
  struct mapd_vec3 position;
  /*
   Direction ahead [rad], in (−π, π], counter-clockwise from x: of a road that of its reference line, of a lane its own.
   */
  double heading;
  /*
   Curvature of the line that runs this way [1/m], positive to the left.
   */
  double curvature;
  /*
   Metres upwards per metre of s ahead.
   */
  double slope;
  /*
   Superelevation [rad], positive lifts the left side.
   */
  double superelevation;
  /*
   Whether s lay outside and was moved to the nearer end.
   */
  uint8_t clamped;
} mapd_pose;

/*
 Foot of a point on a road's reference line.
 */
typedef struct mapd_track_position {
  /*
   Along the reference line [m].
   */
  double s;
  /*
   Lateral [m], positive to the left.
   */
  double t;
  /*
   Upwards [m]; 0 without `has_h`.
   */
  double h;
  /*
   Plan-view distance from the reference line [m].
   */
  double distance;
  /*
   1: the point had a z, and h is known.
   */
  uint8_t has_h;
  /*
   Whether the foot is an end of the road and the point lies beyond it.
   */
  uint8_t clamped;
  /*
   1: (s, t, h) is the point; 0 beyond an end of the road and in the wedge beside a kink of its line.
   */
  uint8_t exact;
} mapd_track_position;

/*
 A lane.
 */
typedef struct mapd_lane_facts {
  /*
   The lane itself.
   */
  struct mapd_lane_id lane;
  /*
   Its road.
   */
  struct mapd_road_id road;
  /*
   The junction that its road is a connecting road of, if any.
   */
  struct mapd_junction_id junction;
  /*
   Start of its section on the road [m].
   */
  double s_start;
  /*
   End of its section on the road [m].
   */
  double s_end;
  /*
   OpenDRIVE's lane number: positive left of lane 0, negative right.
   */
  int32_t number;
  /*
   Number of its section in the road, from 0.
   */
  uint32_t section;
  /*
   Its type: a `MAPD_LANE_TYPE_…`.
   */
  uint8_t kind;
  /*
   1: motor vehicles travel on lanes of this type.
   */
  uint8_t is_drivable;
  /*
   1: vehicles travel towards +s. Left, right and ahead of a lane are those of this direction.
   */
  uint8_t is_forward;
  /*
   1: it may be travelled in both directions.
   */
  uint8_t is_bidirectional;
  /*
   1: it is of the temporary layer.
   */
  uint8_t is_temporary;
  /*
   1: it is the same as its namesake in the section before.
   */
  uint8_t continues;
} mapd_lane_facts;

/*
 A place on a lane's centre line.
 */
typedef struct mapd_waypoint {
  /*
   On the road's reference line [m].
   */
  double s;
  /*
   Inertial position on the plane h = 0 [m].
   */
  struct mapd_vec3 position;
  /*
   Heading of the centre line in driving direction [rad], in (−π, π].
   */
  double heading;
  /*
   Width of the lane [m].
   */
  double width;
  /*
   Whether s lay outside the lane's section and was moved to its nearer end.
   */
  uint8_t clamped;
} mapd_waypoint;

/*
 Both edges of a lane at s, as lateral coordinates [m].
 */
typedef struct mapd_lane_edges {
  /*
   t of the edge nearer to lane 0.
   */
  double inner;
  /*
   t of the edge away from lane 0.
   */
  double outer;
} mapd_lane_edges;

/*
 Both edges of a lane at s, inertial [m], on the plane h = 0.
 */
typedef struct mapd_lane_bounds {
  /*
   On the left of the lane's traffic.
   */
  struct mapd_vec3 left;
  /*
   On the right of the lane's traffic.
   */
  struct mapd_vec3 right;
} mapd_lane_bounds;

/*
 Which signs forbid overtaking at a place.
 */
typedef struct mapd_overtaking_rule {
  /*
   The sign that forbids it to all motor vehicles, if one does.
   */
  struct mapd_signal_id all;
  /*
   The sign that forbids it to trucks, if one does.
   */
  struct mapd_signal_id trucks;
} mapd_overtaking_rule;

/*
 Plan view of a vehicle: a rectangle around the place of its pose, along its heading. Each size is in [0, 100].
 */
typedef struct mapd_vehicle_outline {
  /*
   How far it reaches from the pose's place ahead [m].
   */
  double front;
  /*
   How far behind it [m].
   */
  double back;
  /*
   How far to the left [m].
   */
  double left;
  /*
   How far to the right [m].
   */
  double right;
} mapd_vehicle_outline;

/*
 How hypotheses are weighed. Set it with `mapd_match_options_init`, then change what should differ.
 */
typedef struct mapd_match_options {
  /*
   Size of this struct as the caller knows it: later releases may append to it.
   */
  size_t size;
  /*
   Lane types that are hypotheses, as in `mapd_nearest_options`. Default all.
   */
  uint64_t types;
  /*
   Largest difference between the pose's z and the lane's [m]; counts only with `has_z_tolerance` and a pose that has z.
   */
  double z_tolerance;
  /*
   Standard deviation of a driver's heading from the lane's direction [rad], not negative. Default 0.1.
   */
  double drive_deviation;
  /*
   Prior of `none`, where a lane has 1; positive. Default 0.01.
   */
  double none;
  /*
   Share of the prior that lanes have which the vehicle may not use, in (0, 1]. Default 0.05.
   */
  double closed;
  /*
   Share of the prior that lanes have which are not expected, in (0, 1]. Default 0.05.
   */
  double unexpected;
  /*
   Lanes that are expected, such as those of a route. Default null, which expects nothing.
   */
  const struct mapd_lane_id *expected;
  /*
   How many there are.
   */
  size_t expected_count;
  /*
   Not 0: `z_tolerance` counts. Default 0.
   */
  uint8_t has_z_tolerance;
  /*
   Not 0: `vehicle` counts. Default 0.
   */
  uint8_t has_vehicle;
  /*
   The class of the vehicle: a `MAPD_VEHICLE_CLASS_…`.
   */
  uint8_t vehicle;
  /*
   Plan view of the vehicle: a lane's weight is then the share of the vehicle that lies in it. Default zeros, which count as no outline.
   */
  struct mapd_vehicle_outline outline;
} mapd_match_options;

/*
 How a trace is matched. Set it with `mapd_trace_options_init`, then change what should differ.
 */
typedef struct mapd_trace_options {
  /*
   Size of this struct as the caller knows it: later releases may append to it.
   */
  size_t size;
  /*
   Standard deviation of x and of y [m], positive. Default 1.
   */
  double deviation;
  /*
   Standard deviation of headings [rad], of fixes that have one. Default 0.1.
   */
  double heading_deviation;
  /*
   Mean time between changes of lane [s], positive. Default 30.
   */
  double change_interval;
  /*
   Lane types that count, as in `mapd_nearest_options`. Default those that motor vehicles travel on.
   */
  uint64_t types;
  /*
   The class of the vehicle: a `MAPD_VEHICLE_CLASS_…`. Default a passenger car.
   */
  uint8_t vehicle;
} mapd_trace_options;

/*
 What somebody measured: where a vehicle is and which way it heads.
 */
typedef struct mapd_vehicle_pose {
  /*
   Place, inertial [m]; z only if known.
   */
  struct mapd_point position;
  /*
   Heading [rad], counter-clockwise from x; any turn of it.
   */
  double heading;
} mapd_vehicle_pose;

/*
 A lane that a vehicle may be in, in one of its directions.
 */
typedef struct mapd_lane_match {
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   The pose's place with respect to it.
   */
  struct mapd_lane_position position;
  /*
   Probability among all hypotheses.
   */
  double probability;
  /*
   Mahalanobis distance of the pose from the lane's centre line at the pose's s, headed as that line is driven.
   */
  double mahalanobis;
  /*
   The given heading less the driving direction at the pose's s and offset [rad], in (−π, π].
   */
  double heading_difference;
  /*
   1: the vehicle travels towards +s.
   */
  uint8_t forward;
} mapd_lane_match;

/*
 A place of a trace.
 */
typedef struct mapd_trace_fix {
  /*
   When [s]; does not fall along the trace.
   */
  double time;
  /*
   Where, inertial [m].
   */
  struct mapd_point position;
  /*
   Which way it heads [rad]; counts only with `has_heading`.
   */
  double heading;
  /*
   Not 0: the heading is known.
   */
  uint8_t has_heading;
} mapd_trace_fix;

/*
 Where a fix of a trace was.
 */
typedef struct mapd_trace_match {
  /*
   The lane; a row of `MAPD_NO_ROW` where the trace is on no lane.
   */
  struct mapd_lane_id lane;
  /*
   The place with respect to it; zeros where there is none.
   */
  struct mapd_lane_position position;
  /*
   Probability of this, given the whole trace.
   */
  double probability;
  /*
   1: it travels towards +s.
   */
  uint8_t forward;
} mapd_trace_match;

/*
 How a running drive is matched. Set it with `mapd_tracker_options_init`, then change what should differ.
 */
typedef struct mapd_tracker_options {
  /*
   Size of this struct as the caller knows it: later releases may append to it.
   */
  size_t size;
  /*
   How fixes are weighed. The priors of lanes (`vehicle`, `expected`) weigh the lanes of the first fix, and then the ways at forks. Default null:
   the default of `mapd_match_options` with the types that motor vehicles travel on.
   */
  const struct mapd_match_options *matching;
  /*
   Mean time between changes of lane [s], positive. Default 30.
   */
  double change_interval;
  /*
   Time over which errors of fixes are alike [s], not negative: fixes nearer to each other count for less. Default 0.
   */
  double correlation_time;
  /*
   Time without a fix [s], after which the tracker begins anew; positive. Default 30.
   */
  double memory;
  /*
   Probability from which a lane, or none, is the answer; in (0, 1]. Default 0.5.
   */
  double enough;
} mapd_tracker_options;

/*
 What is known of a vehicle at a moment.
 */
typedef struct mapd_tracker_fix {
  /*
   When [s]; does not fall from fix to fix.
   */
  double time;
  /*
   Where it is measured to be.
   */
  struct mapd_vehicle_pose pose;
  /*
   Covariance of (x, y, heading), row by row [m², m·rad, rad²], as for `mapd_match_pose`.
   */
  double covariance[9];
  /*
   Way driven since any beginning [m]; it falls while a vehicle reverses. Counts only with `has_odometer`; else the straight way from the last
   fix counts.
   */
  double odometer;
  /*
   Not 0: `odometer` counts.
   */
  uint8_t has_odometer;
} mapd_tracker_fix;

/*
 Where a tracked vehicle is.
 */
typedef struct mapd_tracked {
  /*
   The lane, of `MAPD_TRACKED_LANE`; else one with the row `MAPD_NO_ROW`, and zeros.
   */
  struct mapd_lane_match found;
  /*
   A `MAPD_TRACKED_…`.
   */
  uint8_t state;
} mapd_tracked;

/*
 What a lane is made of.
 */
typedef struct mapd_material {
  /*
   Start on the road [m].
   */
  double s;
  /*
   Surface code as written; its meaning is the map maker's.
   */
  struct mapd_text surface;
  /*
   Friction coefficient; negative where not given.
   */
  double friction;
  /*
   Roughness as written; negative where not given.
   */
  double roughness;
} mapd_material;

/*
 The ground at a place.
 */
typedef struct mapd_ground {
  /*
   Height of the surface at the place [m].
   */
  double z;
  /*
   Unit normal of the surface, upwards.
   */
  struct mapd_vec3 normal;
  /*
   The lane that holds the place; of a place of a batch that has none, a row of `MAPD_NO_ROW`.
   */
  struct mapd_lane_id lane;
  /*
   Along its road [m].
   */
  double s;
  /*
   Lateral on its road [m].
   */
  double t;
  /*
   What the lane is made of; counts only with `has_material`.
   */
  struct mapd_material material;
  /*
   Which level this is, the lowest one 0.
   */
  uint32_t level;
  /*
   How many levels of lanes there are at the place.
   */
  uint32_t levels;
  /*
   1: the map says what the lane is made of.
   */
  uint8_t has_material;
} mapd_ground;

/*
 How a vehicle stands.
 */
typedef struct mapd_stance {
  /*
   Height of the ground's plane below the vehicle's reference point [m].
   */
  double z;
  /*
   Roll [rad]; positive lifts the left side (ISO 8855).
   */
  double roll;
  /*
   Pitch [rad]; positive lowers the front (ISO 8855).
   */
  double pitch;
  /*
   Height of the ground below each wheel [m], in the order given; counts only with `has_wheel`.
   */
  double wheels[4];
  /*
   1: there is ground below the wheel.
   */
  uint8_t has_wheel[4];
} mapd_stance;

/*
 Which road marks count. Set it with `mapd_mark_filter_init`, then change what should differ.
 */
typedef struct mapd_mark_filter {
  /*
   Size of this struct as the caller knows it: later releases may append to it.
   */
  size_t size;
  /*
   Largest distance in plan view [m]. Default 5.
   */
  double radius;
  /*
   Kinds that count: the bit of each is `1 << code`; `UINT64_MAX`, the default, is all. The kind `none` never counts.
   */
  uint64_t kinds;
  /*
   Types of lanes whose borders count, on either side, as in `mapd_nearest_options`. Default all.
   */
  uint64_t types;
  /*
   0: what is painted as an object does not count in `mapd_mark_points`. Default 1.
   */
  uint8_t objects;
} mapd_mark_filter;

/*
 The place of a road mark that is nearest to a point.
 */
typedef struct mapd_near_mark {
  /*
   The lane on whose outer border the mark lies, lane 0 for marks of the centre; of a point of a batch that has none, a row of `MAPD_NO_ROW`.
   */
  struct mapd_lane_id lane;
  /*
   Where, on the road [m].
   */
  double s;
  /*
   The nearest place of the middle of the mark's line, inertial [m].
   */
  struct mapd_vec2 place;
  /*
   How far away that is in plan view [m].
   */
  double distance;
  /*
   Width of the line [m], the default one where it has none of its own.
   */
  double width;
  /*
   1: the mark is to the left of the point, looking along the road's reference line.
   */
  uint8_t left_of_reference_line;
  /*
   A `MAPD_ROAD_MARK_KIND_…`.
   */
  uint8_t kind;
  /*
   A `MAPD_ROAD_MARK_COLOR_…`: the line's own, or the mark's.
   */
  uint8_t color;
  /*
   Whether there is paint at this s: a `MAPD_PAINTED_…`.
   */
  uint8_t painted;
} mapd_near_mark;

/*
 A point of a polyline.
 */
typedef struct mapd_line_point {
  /*
   On the road [m]. Points of equal s are both sides of a jump.
   */
  double s;
  /*
   Inertial position [m].
   */
  struct mapd_vec3 position;
} mapd_line_point;

/*
 A node of the lane graph: a lane, or a piece of one, travelled in one direction; as `mapd_road_id` otherwise.
 */
typedef struct mapd_node_id {
  /*
   Row in the archive's table.
   */
  uint32_t row;
  /*
   The tile of a set of maps: 0.
   */
  uint32_t tile;
  /*
   First eight bytes of the content's hash.
   */
  uint64_t content;
} mapd_node_id;

/*
 A node of the lane graph.
 */
typedef struct mapd_node_facts {
  /*
   The node itself.
   */
  struct mapd_node_id node;
  /*
   Its lane.
   */
  struct mapd_lane_id lane;
  /*
   Smaller s of both ends on the road [m].
   */
  double s_low;
  /*
   Larger s of both ends on the road [m].
   */
  double s_high;
  /*
   Length of the centre line in plan view [m].
   */
  double length;
  /*
   Time to pass it at the speed limit [s].
   */
  double travel_time;
  /*
   The node beside it to the left that travels the same way, if any.
   */
  struct mapd_node_id left;
  /*
   The node beside it to the right that travels the same way, if any.
   */
  struct mapd_node_id right;
  /*
   Where a change of lane to the left leads, if the road marks allow one.
   */
  struct mapd_node_id change_left;
  /*
   Where a change of lane to the right leads, if the road marks allow one.
   */
  struct mapd_node_id change_right;
  /*
   Strongly connected component, in topological order.
   */
  uint32_t component;
  /*
   Classes of vehicles that may use it: the bit of each is `1 << code` of its `MAPD_VEHICLE_CLASS_…`.
   */
  uint32_t access;
  /*
   1: it travels towards +s.
   */
  uint8_t is_forward;
} mapd_node_facts;

/*
 An edge of the lane graph: from one node into the next, in driving direction.
 */
typedef struct mapd_edge {
  /*
   The node that is entered.
   */
  struct mapd_node_id target;
  /*
   Where it comes from: a `MAPD_EDGE_KIND_…`.
   */
  uint8_t kind;
  /*
   1: it closes a loop; the graph without such edges has no cycle.
   */
  uint8_t closes_loop;
  /*
   Line of the link in the file, from 1; 0 where no link is needed.
   */
  uint32_t line;
  /*
   Column of the link in the file, from 1.
   */
  uint32_t column;
} mapd_edge;

/*
 A place where two lanes of a junction meet.
 */
typedef struct mapd_conflict {
  /*
   The lane that is met.
   */
  struct mapd_lane_id other;
  /*
   The common area on the lane itself: smaller s [m].
   */
  double s_low;
  /*
   The common area on the lane itself: larger s [m].
   */
  double s_high;
  /*
   The common area on the other lane: smaller s [m].
   */
  double other_low;
  /*
   The common area on the other lane: larger s [m].
   */
  double other_high;
  /*
   How the two meet: a `MAPD_CONFLICT_KIND_…`.
   */
  uint8_t kind;
} mapd_conflict;

/*
 A place on a lane.
 */
typedef struct mapd_position_on_lane {
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   On the road [m]; outside the lane's section its nearer end counts.
   */
  double s;
} mapd_position_on_lane;

/*
 What a route keeps small, and for whom.
 */
typedef struct mapd_cost {
  /*
   A `MAPD_COST_…`.
   */
  uint32_t by;
  /*
   Who travels: a `MAPD_VEHICLE_CLASS_…`.
   */
  uint32_t vehicle;
  /*
   What a change of lane costs, in the cost's unit; usual are 20 m and 2 s. One that is negative or no number closes the way.
   */
  double lane_change;
  /*
   A factor for each lane, by the row of its id: 1 changes nothing, infinity closes the lane, as does what is negative or no number. Lanes beyond
   the last have the factor 1. Null: none.
   */
  const double *factors;
  /*
   How many factors there are.
   */
  size_t factor_count;
} mapd_cost;

/*
 What a route comes to.
 */
typedef struct mapd_route_sum {
  /*
   What the cost adds up to.
   */
  double cost;
  /*
   Length along the lanes' centre lines [m].
   */
  double length;
  /*
   What the graph counts as time [s], as `mapd_lane_time_between`, under an overlay at the speeds that entries state. The time at the limits that hold on the way is
   `mapd_path_travel_time`.
   */
  double travel_time;
  /*
   What of it is at speeds that are assumed, because no limit is recorded or there is none [s].
   */
  double assumed_time;
  /*
   Number of lane changes.
   */
  uint32_t lane_changes;
  /*
   Of a request, number of the start from which it leads; else 0.
   */
  uint32_t start;
  /*
   Of a request, number of the goal to which it leads; else 0.
   */
  uint32_t goal;
} mapd_route_sum;

/*
 A lane of a route. A lane that is only changed from is driven for no length.
 */
typedef struct mapd_route_step {
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   s on the road at which the route enters it [m]; of a change, the first place where it may happen.
   */
  double s_from;
  /*
   s on the road at which the route leaves it [m].
   */
  double s_to;
  /*
   Of a change, the last place where it may happen, else `s_from` [m].
   */
  double s_latest;
  /*
   1: it is travelled towards +s.
   */
  uint8_t forward;
  /*
   How it is entered: a `MAPD_ENTER_…`.
   */
  uint8_t enter;
} mapd_route_step;

/*
 A node that can be reached.
 */
typedef struct mapd_reached {
  /*
   The node.
   */
  struct mapd_node_id node;
  /*
   Least cost up to its beginning.
   */
  double cost;
} mapd_reached;

/*
 A node, or a piece of one where an overlay cuts it, that can be reached.
 */
typedef struct mapd_reached_piece {
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   Smaller end on the road [m].
   */
  double s_from;
  /*
   Larger end on the road [m].
   */
  double s_to;
  /*
   Least cost up to its beginning; of those beside the start, of the lane changes to them.
   */
  double cost;
  /*
   Changes of lane on this way.
   */
  uint32_t lane_changes;
  /*
   1: it is travelled towards +s.
   */
  uint8_t forward;
} mapd_reached_piece;

/*
 How one goes on from one piece that is reached to another.
 */
typedef struct mapd_reach_link {
  /*
   Number of the one.
   */
  size_t from;
  /*
   Number of the other.
   */
  size_t to;
  /*
   How it is entered: a `MAPD_ENTER_…`.
   */
  uint8_t enter;
} mapd_reach_link;

/*
 The next junction on a lane's way.
 */
typedef struct mapd_next_junction {
  /*
   The junction.
   */
  struct mapd_junction_id junction;
  /*
   Distance to its first connecting road, along centre lines [m].
   */
  double distance;
} mapd_next_junction;

/*
 How a path is built. Set it with `mapd_path_options_init`, then change what should differ.
 */
typedef struct mapd_path_options {
  /*
   Size of this struct as the caller knows it: later releases may append to it.
   */
  size_t size;
  /*
   A joint with a larger gap is broken [m]; not negative, infinite for never. Default 0.1.
   */
  double broken_gap;
  /*
   A joint with a larger kink is broken [rad]; as above. Default 0.3.
   */
  double broken_kink;
  /*
   Length of S over which a change of lane is one smooth curve [m], for each lane that is changed to, over lanes that follow as far as it is allowed; 0, the default: the line jumps.
   */
  double change_length;
  /*
   How short a change may be that is a curve, where less is allowed [m]; what has even less room jumps, and its joint is broken. 0, the default: no shorter than its length.
   */
  double shortest_change;
  /*
   How far behind the first place where it can be a change begins that is a curve [m], as far as there is room; infinite for as late as can be. Default 0.
   */
  double change_delay;
  /*
   The class of the vehicle: a `MAPD_VEHICLE_CLASS_…`. A change does not go on over lanes that it may not use. Default a passenger car.
   */
  uint8_t vehicle;
} mapd_path_options;

/*
 A position on a path, as seen by a vehicle that drives along it.
 */
typedef struct mapd_path_point {
  /*
   S [m].
   */
  double along;
  /*
   Inertial position on the plane h = 0 [m].
   */
  struct mapd_vec3 position;
  /*
   Heading of the driven line [rad], in (−π, π].
   */
  double heading;
  /*
   Curvature of the driven line in plan view [1/m], positive to the left.
   */
  double curvature;
  /*
   Its change along the line [1/m²].
   */
  double curvature_rate;
  /*
   Metres upwards per metre of S.
   */
  double grade;
  /*
   Superelevation [rad]; positive lifts the driver's left side.
   */
  double superelevation;
  /*
   Distance to the driven lane's left edge [m].
   */
  double left;
  /*
   Distance to the driven lane's right edge [m].
   */
  double right;
  /*
   The driven lane.
   */
  struct mapd_lane_id lane;
  /*
   s on its road [m].
   */
  double s;
  /*
   1: it is driven towards +s.
   */
  uint8_t forward;
  /*
   Whether S lay outside the path and was moved to its nearer end.
   */
  uint8_t clamped;
} mapd_path_point;

/*
 A point in a path's coordinates.
 */
typedef struct mapd_path_position {
  /*
   S of the foot: the nearest point of the driven line in plan view [m].
   */
  double along;
  /*
   Offset to the left of the driven line there [m].
   */
  double d;
  /*
   Plan-view distance from the driven line [m].
   */
  double distance;
  /*
   Heading of the driven line at the foot [rad], in (−π, π].
   */
  double heading;
  /*
   The driven lane there.
   */
  struct mapd_lane_id lane;
  /*
   s on its road [m].
   */
  double s;
  /*
   Whether the point lies before the path's start or after its end.
   */
  uint8_t clamped;
} mapd_path_position;

/*
 The speed limit at a place.
 */
typedef struct mapd_speed_rule {
  /*
   Limit [m/s], infinite where there is none; counts only with `has_max`.
   */
  double max;
  /*
   The sign, if one says so.
   */
  struct mapd_signal_id signal;
  /*
   1: the map says something.
   */
  uint8_t has_max;
  /*
   Who says so: a `MAPD_SPEED_ORIGIN_…`.
   */
  uint8_t origin;
} mapd_speed_rule;

/*
 A place where the driven line is not continuous, or changes lanes.
 */
typedef struct mapd_path_joint {
  /*
   S [m].
   */
  double along;
  /*
   How far apart the line's two sides lie in plan view [m].
   */
  double gap;
  /*
   By how much the line turns there [rad], positive to the left, in (−π, π].
   */
  double kink;
  /*
   How the lane behind it is entered: a `MAPD_ENTER_…`.
   */
  uint8_t enter;
  /*
   1: gap or kink are larger than the options allow. A change of lane that jumps breaks nothing by its gap, unless the options say how short it may be.
   */
  uint8_t broken;
  /*
   1: a change of lane that jumps because there is no room for the curve that the options ask for.
   */
  uint8_t is_short;
} mapd_path_joint;

/*
 A lane of a path and what of it is driven.
 */
typedef struct mapd_path_lane {
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   S where it is entered [m].
   */
  double along_from;
  /*
   S where it is left [m].
   */
  double along_to;
  /*
   s on its road where it is entered [m].
   */
  double s_from;
  /*
   s on its road where it is left [m].
   */
  double s_to;
  /*
   Number of the route's step.
   */
  size_t step;
  /*
   1: it is travelled towards +s.
   */
  uint8_t forward;
} mapd_path_lane;

/*
 A stop line or crosswalk on a lane.
 */
typedef struct mapd_lane_line_at {
  /*
   The signal that says so; one of `signal` and `object` names something.
   */
  struct mapd_signal_id signal;
  /*
   The object that says so.
   */
  struct mapd_object_id object;
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   Where the lane's traffic meets it first, on the road [m].
   */
  double s;
  /*
   Of a line ahead: distance along the lanes' centre lines from the route's start [m]; else 0.
   */
  double distance;
  /*
   What it is: a `MAPD_CLASS_…`.
   */
  uint16_t class_code;
} mapd_lane_line_at;

/*
 Something that a path comes by. What the kind does not name is not there: ids with the row `MAPD_NO_ROW`, zeros.
 */
typedef struct mapd_path_fact {
  /*
   S of its beginning [m].
   */
  double along_from;
  /*
   S of its end [m]; that of its beginning for what has a place alone.
   */
  double along_to;
  /*
   The driven lane at its beginning.
   */
  struct mapd_lane_id lane;
  /*
   The junction.
   */
  struct mapd_junction_id junction;
  /*
   The signal.
   */
  struct mapd_signal_id signal;
  /*
   The line.
   */
  struct mapd_lane_line_at line;
  /*
   Of a line its left end on the driven lane, inertial [m].
   */
  struct mapd_vec3 left;
  /*
   Of a line its right end.
   */
  struct mapd_vec3 right;
  /*
   What the kind says, such as the number in a list of the map; else `MAPD_NO_ROW`.
   */
  uint32_t number;
  /*
   What the kind says.
   */
  uint8_t code;
  /*
   What it is: a `MAPD_PATH_FACT_…`.
   */
  uint8_t kind;
  /*
   Of a signal, 1: it is for what the path does; a light with arrows is for some of the turns at the next junction only.
   */
  uint8_t governs;
} mapd_path_fact;

/*
 A stretch of a path on which one speed limit holds.
 */
typedef struct mapd_path_speed {
  /*
   S of its beginning [m].
   */
  double along_from;
  /*
   S of its end [m].
   */
  double along_to;
  /*
   What holds there.
   */
  struct mapd_speed_rule rule;
} mapd_path_speed;

/*
 How long a path or a part of it takes at the speed limits.
 */
typedef struct mapd_path_time {
  /*
   Time where a limit is known and above 0 [s].
   */
  double time;
  /*
   Length of the rest, where no limit is known or there is none [m]: its time is the caller's to say.
   */
  double unlimited;
} mapd_path_time;

/*
 A lane from which the goal of a path is reached along the path's own roads by allowed changes of lane.
 */
typedef struct mapd_path_segment {
  /*
   S of the beginning of the stretch over which this holds [m].
   */
  double along_from;
  /*
   S of its end [m].
   */
  double along_to;
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   The largest S at which one can still be on this lane, with the lanes that it leads on to, and come to the goal: the last place for
   its next change [m]. The path's end where no change is needed.
   */
  double last_change;
  /*
   S at which it leads on along the path no more [m]; the path's end where it does to the end.
   */
  double lane_end;
  /*
   Changes of lane that are left to the goal, at least.
   */
  uint32_t changes;
  /*
   1: it is travelled towards +s.
   */
  uint8_t forward;
  /*
   1: the path drives on it on this stretch.
   */
  uint8_t driven;
} mapd_path_segment;

/*
 What has become of a stretch of a path on another version of its map.
 */
typedef struct mapd_path_change {
  /*
   S of its beginning on the old path [m].
   */
  double along_from;
  /*
   S of its end on the old path [m].
   */
  double along_to;
  /*
   How far away its lane lies now [m]; 0 for one that is gone.
   */
  double distance;
  /*
   A `MAPD_PATH_CHANGE_…`.
   */
  uint32_t kind;
} mapd_path_change;

/*
 The next change of lane on a route.
 */
typedef struct mapd_lane_change {
  /*
   Number of the step that is entered by it.
   */
  size_t step;
  /*
   Distance along the route to the first place where it may happen [m].
   */
  double from;
  /*
   Distance along the route to the last place where it may happen [m].
   */
  double until;
  /*
   1: it goes to the left.
   */
  uint8_t left;
} mapd_lane_change;

/*
 What lies on an edge of a lane.
 */
typedef struct mapd_edge_mark {
  /*
   A `MAPD_ROAD_MARK_KIND_…`; none where there is none.
   */
  uint8_t kind;
  /*
   A `MAPD_ROAD_MARK_COLOR_…`.
   */
  uint8_t color;
  /*
   1: a change of lane over this edge is allowed, into a lane of its direction that the vehicle may use.
   */
  uint8_t may_cross;
  /*
   What lies beyond: a `MAPD_PATH_EDGE_…`.
   */
  uint8_t edge;
} mapd_edge_mark;

/*
 The room at one station of a path. Left and right are as seen by the driver; edges lie on the plane h = 0.
 */
typedef struct mapd_corridor_station {
  /*
   S [m].
   */
  double along;
  /*
   The driven lane.
   */
  struct mapd_lane_id lane;
  /*
   s on its road [m].
   */
  double s;
  /*
   Left edge of the driven lane [m].
   */
  struct mapd_vec3 left;
  /*
   Right edge of the driven lane [m].
   */
  struct mapd_vec3 right;
  /*
   Left edge of the leftmost lane beside it that has its direction and is open to the vehicle [m].
   */
  struct mapd_vec3 outer_left;
  /*
   Right edge of the rightmost such lane [m].
   */
  struct mapd_vec3 outer_right;
  /*
   The speed limit, as `mapd_path_speed_at` has it; in what a view says today's.
   */
  struct mapd_speed_rule speed;
  /*
   What lies on the left edge of the driven lane.
   */
  struct mapd_edge_mark left_mark;
  /*
   What lies on its right edge.
   */
  struct mapd_edge_mark right_mark;
  /*
   What lies on the left edge of the leftmost lane.
   */
  struct mapd_edge_mark outer_left_mark;
  /*
   What lies on the right edge of the rightmost lane.
   */
  struct mapd_edge_mark outer_right_mark;
} mapd_corridor_station;

/*
 The road's surface at one station of a path.
 */
typedef struct mapd_corridor_surface {
  /*
   Inertial position of the lane's middle on the surface [m].
   */
  struct mapd_vec3 position;
  /*
   Unit normal, upwards.
   */
  struct mapd_vec3 normal;
  /*
   Friction coefficient; negative where not given.
   */
  double friction;
  /*
   Roughness as written; negative where not given.
   */
  double roughness;
} mapd_corridor_surface;

/*
 A place where the traffic of other lanes meets a path: of one lane, or of several that lead into each other.
 */
typedef struct mapd_path_conflict {
  /*
   S of the first common place [m], as of `mapd_conflict_lane`.
   */
  double along_from;
  /*
   S of the last common place [m].
   */
  double along_to;
  /*
   The other lane, of several the one that meets the path first.
   */
  struct mapd_lane_id other;
  /*
   The smaller s of the common place on its road [m].
   */
  double other_s_from;
  /*
   The larger s of the common place on its road [m].
   */
  double other_s_to;
  /*
   S at which to wait [m]: the earliest of its lanes.
   */
  double wait;
  /*
   Number of its first lane in the list of lanes.
   */
  uint32_t lanes_from;
  /*
   Number of the one behind its last lane.
   */
  uint32_t lanes_to;
  /*
   How they meet, a `MAPD_CONFLICT_KIND_…`: merging where one lane merges, else crossing where one crosses.
   */
  uint8_t kind;
  /*
   Who goes first, by what the file says, a `MAPD_YIELDS_…`: `MAPD_YIELDS_YIELDS` where the path yields to one lane, else `MAPD_YIELDS_UNKNOWN` where the file does not
   say of one, else `MAPD_YIELDS_LIGHTS` where they decide about one.
   */
  uint8_t yields;
  /*
   Why, a `MAPD_RELATION_REASON_…`: of the first lane of which that is said.
   */
  uint8_t reason;
} mapd_path_conflict;

/*
 A lane whose traffic meets a path.
 */
typedef struct mapd_conflict_lane {
  /*
   S of the first common place [m]; too early by up to half a metre.
   */
  double along_from;
  /*
   S of the last common place [m]; too late by up to half a metre.
   */
  double along_to;
  /*
   The other lane.
   */
  struct mapd_lane_id other;
  /*
   The smaller s of the common place on its road [m].
   */
  double other_s_from;
  /*
   The larger s of the common place on its road [m].
   */
  double other_s_to;
  /*
   S at which to wait [m]: the line to stop at on the path, else the last place before the common one.
   */
  double wait;
  /*
   How the two meet: a `MAPD_CONFLICT_KIND_…`.
   */
  uint8_t kind;
  /*
   Who goes first, by what the file says: a `MAPD_YIELDS_…`.
   */
  uint8_t yields;
  /*
   Why: a `MAPD_RELATION_REASON_…`; what a rule of the road would say where `yields` is `MAPD_YIELDS_UNKNOWN`.
   */
  uint8_t reason;
  /*
   Who goes first in the map's own terms, a `MAPD_RELATION_…`: as `yields`, and where a rule of the road would have to say, what right-before-left
   and the rule of turns say.
   */
  uint8_t relation;
  /*
   1: both come by equal roads, as far as the file says (of one type, with one speed limit, and no motorway), and neither joins a road on which the
   other goes straight on, as a ramp does.
   */
  uint8_t equal_roads;
} mapd_conflict_lane;

/*
 A lane, or a piece of one, on which traffic comes towards a conflict.
 */
typedef struct mapd_conflict_approach {
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   s on its road where the part within the distance begins, in driving direction [m].
   */
  double s_from;
  /*
   s where it ends [m].
   */
  double s_to;
  /*
   Distance of its beginning from the conflict's first place along the centre lines [m].
   */
  double distance_from;
  /*
   Distance of its end [m].
   */
  double distance_to;
  /*
   1: it is travelled towards +s.
   */
  uint8_t forward;
} mapd_conflict_approach;

/*
 A crosswalk or bicycle crossing over a path.
 */
typedef struct mapd_path_crossing {
  /*
   S of its first place [m].
   */
  double along_from;
  /*
   S of its last place [m]; that of the first one where the file gives a place alone.
   */
  double along_to;
  /*
   S at which to wait [m]: the last line to stop at on the path, up to 30 m before, else where it begins.
   */
  double wait;
  /*
   The crossing, on the driven lane.
   */
  struct mapd_lane_line_at line;
  /*
   `MAPD_YIELDS_LIGHTS` where a light for vehicles stands on the path up to 30 m before it, else `MAPD_YIELDS_UNKNOWN`: a rule of the road decides,
   nearly everywhere in favour of who crosses.
   */
  uint8_t yields;
} mapd_path_crossing;

/*
 Something that an overlay says.
 */
typedef struct mapd_overlay_entry {
  /*
   Its name, which no other entry has.
   */
  struct mapd_text id;
  /*
   Who says so; empty where that is not said.
   */
  struct mapd_text source;
  /*
   What is said, for people; may be empty.
   */
  struct mapd_text text;
  /*
   Of a speed, the limit [m/s]; of other kinds negative.
   */
  double value;
  /*
   How sure the source is, from 0 to 1.
   */
  double confidence;
  /*
   Classes of vehicles that are concerned: the bit of each is `1 << code`, of a `MAPD_VEHICLE_CLASS_…`.
   */
  uint64_t vehicles;
  /*
   Its place among the overlay's entries, from 0.
   */
  uint32_t number;
  /*
   What it says: a `MAPD_OVERLAY_KIND_…`.
   */
  uint8_t kind;
  /*
   1: it holds at the view's moment.
   */
  uint8_t holds;
} mapd_overlay_entry;

/*
 An entry that holds on a stretch of a lane.
 */
typedef struct mapd_restriction {
  /*
   The lane; a row of `MAPD_NO_ROW` where there is no restriction.
   */
  struct mapd_lane_id lane;
  /*
   Smaller end of the stretch on the road [m]: at least the part of it on which the same entries hold.
   */
  double s_from;
  /*
   Larger end [m].
   */
  double s_to;
  /*
   Number of the entry, see `mapd_view_entries`; `MAPD_NO_ROW` where there is no restriction.
   */
  uint32_t entry;
} mapd_restriction;

/*
 Whether a class of vehicles may use a lane at a place.
 */
typedef struct mapd_permission {
  /*
   The entry that decides so; none where the map does.
   */
  struct mapd_restriction restriction;
  /*
   1: it may.
   */
  uint8_t is_allowed;
} mapd_permission;

/*
 The speed limit at a place, with what is said of it today.
 */
typedef struct mapd_speed_today {
  /*
   Limit [m/s], infinite where there is none; counts only with `has_max`.
   */
  double max;
  /*
   What the map says.
   */
  struct mapd_speed_rule map;
  /*
   The entry that says otherwise; none where the map's limit holds.
   */
  struct mapd_restriction restriction;
  /*
   1: somebody says something.
   */
  uint8_t has_max;
} mapd_speed_today;

/*
 Whether a class of vehicles may overtake at a place, with what is said of it today.
 */
typedef struct mapd_overtaking_today {
  /*
   The map's signs.
   */
  struct mapd_overtaking_rule map;
  /*
   The first entry that forbids it to the class; none where none does.
   */
  struct mapd_restriction restriction;
  /*
   1: a sign or an entry forbids it to the class. Of signs, those for all count for motor vehicles, those for trucks for `MAPD_VEHICLE_CLASS_TRUCK`.
   */
  uint8_t is_forbidden;
} mapd_overtaking_today;

/*
 An entry that holds on a stretch of a path.
 */
typedef struct mapd_path_restriction {
  /*
   S of the beginning of what is driven of it [m].
   */
  double along_from;
  /*
   S of its end [m].
   */
  double along_to;
  /*
   The entry, on the lane that is driven there.
   */
  struct mapd_restriction restriction;
} mapd_path_restriction;

/*
 A stretch of a path on which one speed limit holds today.
 */
typedef struct mapd_path_speed_today {
  /*
   S of its beginning [m].
   */
  double along_from;
  /*
   S of its end [m].
   */
  double along_to;
  /*
   What holds there. Where an entry states it, the stretch is on one lane.
   */
  struct mapd_speed_today today;
} mapd_path_speed_today;

/*
 A signal ahead.
 */
typedef struct mapd_signal_ahead {
  /*
   The signal.
   */
  struct mapd_signal_id signal;
  /*
   The lane on which it counts.
   */
  struct mapd_lane_id lane;
  /*
   Distance along the lanes' centre lines [m].
   */
  double distance;
  /*
   Its place on that lane's road [m].
   */
  double s;
} mapd_signal_ahead;

/*
 What becomes of a proposal that is not refused.
 */
typedef struct mapd_decision {
  /*
   1: it is laid over the map, and readers see it. 0: others must say the same first.
   */
  uint8_t is_accepted;
  /*
   Where it is not: sources that have said so, with this one.
   */
  uint32_t agree;
  /*
   Where it is not: sources that must.
   */
  uint32_t needed;
} mapd_decision;

/*
 A start or goal.
 */
typedef struct mapd_route_end {
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   On the road [m].
   */
  double s;
  /*
   What it costs to start or end there, beside the way. One that is negative, infinite or no number closes it.
   */
  double cost;
  /*
   The way in which the lane is travelled there: a `MAPD_DIRECTION_…`.
   */
  uint8_t direction;
} mapd_route_end;

/*
 What is asked of a search: from any of some starts to any of some goals. Set it with `mapd_route_request_init`, then fill it in.
 */
typedef struct mapd_route_request {
  /*
   Size of this struct as the caller knows it: later releases may append to it.
   */
  size_t size;
  /*
   Where the way may begin. Their lanes may be closed to the vehicle.
   */
  const struct mapd_route_end *starts;
  /*
   How many starts there are.
   */
  size_t start_count;
  /*
   Where it may end.
   */
  const struct mapd_route_end *goals;
  /*
   How many goals there are.
   */
  size_t goal_count;
  /*
   Lanes that are not entered; a start may lie on one. Default null.
   */
  const struct mapd_lane_id *avoid;
  /*
   How many lanes to avoid there are.
   */
  size_t avoid_count;
  /*
   What ways cost, and who travels. Default metres, a passenger car and 20 m for a change of lane.
   */
  struct mapd_cost cost;
  /*
   What a turn to the left at a junction costs beside it, in its unit. Default 0.
   */
  double turn_left;
  /*
   What a turn to the right costs. Default 0.
   */
  double turn_right;
  /*
   What a turn back costs. Default 0.
   */
  double turn_back;
} mapd_route_request;

/*
 Which alternatives are wanted. Set it with `mapd_alternative_options_init`, then change what should differ.
 */
typedef struct mapd_alternative_options {
  /*
   Size of this struct as the caller knows it: later releases may append to it.
   */
  size_t size;
  /*
   Routes, the best one among them: 1 to 32. Default 3.
   */
  size_t count;
  /*
   Share of its length that each drives on other sections of road, or the other way, than any one of those before it, 0 to 1. 0 for the k best
   routes, which may differ by a change of lane. Default 0.3.
   */
  double share;
  /*
   How many times the cheapest one's cost a route may cost, at least 1. Default 1.5.
   */
  double longest;
} mapd_alternative_options;

/*
 A junction.
 */
typedef struct mapd_junction_facts {
  /*
   The junction itself.
   */
  struct mapd_junction_id junction;
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   OpenDRIVE's name.
   */
  struct mapd_text name;
  /*
   Number of connections.
   */
  size_t connections;
} mapd_junction_facts;

/*
 A connection of a junction, as written.
 */
typedef struct mapd_connection {
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   Road that leads into the junction, where the map has it.
   */
  struct mapd_road_id incoming_road;
  /*
   Connecting road, or the linked road of a direct junction, where the map has it.
   */
  struct mapd_road_id connecting_road;
  /*
   End of the connecting road that touches the incoming one: a `MAPD_CONTACT_POINT_…`.
   */
  uint8_t contact;
} mapd_connection;

/*
 A traffic sign, light or marking.
 */
typedef struct mapd_signal_facts {
  /*
   The signal itself.
   */
  struct mapd_signal_id signal;
  /*
   The road that it is written in.
   */
  struct mapd_road_id road;
  /*
   Of a sign on a board: the signal that carries the board.
   */
  struct mapd_signal_id carrier;
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   OpenDRIVE's name.
   */
  struct mapd_text name;
  /*
   Code as written: country.
   */
  struct mapd_text country;
  /*
   Code as written: its revision.
   */
  struct mapd_text country_revision;
  /*
   Code as written: type.
   */
  struct mapd_text kind;
  /*
   Code as written: subtype.
   */
  struct mapd_text subtype;
  /*
   Text shown.
   */
  struct mapd_text text;
  /*
   Unit as written; counts only with `has_written_value`.
   */
  struct mapd_text unit;
  /*
   Value as written; counts only with `has_written_value`.
   */
  double written_value;
  /*
   What the class means by its value: [m/s], [m] or [kg]; counts only with `has_value`.
   */
  double value;
  /*
   Where it stands, inertial [m].
   */
  struct mapd_vec3 position;
  /*
   Direction of the face's normal in plan view [rad], in (−π, π].
   */
  double facing;
  /*
   Pitch of what stands there [rad].
   */
  double pitch;
  /*
   Roll of what stands there [rad].
   */
  double roll;
  /*
   As written [m].
   */
  double s;
  /*
   As written [m].
   */
  double t;
  /*
   Width [m]; negative where not given.
   */
  double width;
  /*
   Height [m]; negative where not given.
   */
  double height;
  /*
   Length [m]; negative where not given.
   */
  double length;
  /*
   What it means: a `MAPD_CLASS_…`.
   */
  uint16_t class_code;
  /*
   Direction of travel that it is for, on its own road: a `MAPD_ORIENTATION_…`.
   */
  uint8_t orientation;
  /*
   Where the place in space comes from: a `MAPD_SIGNAL_POSITION_…`.
   */
  uint8_t position_source;
  /*
   1: `written_value` and `unit` are there.
   */
  uint8_t has_written_value;
  /*
   1: `value` is there.
   */
  uint8_t has_value;
  /*
   1: its state changes.
   */
  uint8_t is_dynamic;
  /*
   1: it stands for a limited time.
   */
  uint8_t is_temporary;
  /*
   1: it no longer holds.
   */
  uint8_t is_invalidated;
  /*
   Of a light its lamps: 1 red, 2 yellow, 4 green; 0 for what is no light.
   */
  uint8_t bulbs;
  /*
   Of a light its phases: 1 red, 2 red and yellow, 4 yellow, 8 green, 16, 32, 64 flashing red, yellow, green, 128 off.
   */
  uint8_t phases;
  /*
   Of a light the movements that it is for, 0 all: 1 left, 2 straight on, 4 right, 8 back.
   */
  uint8_t arrows;
} mapd_signal_facts;

/*
 A signal that is for a lane.
 */
typedef struct mapd_lane_signal {
  /*
   The signal.
   */
  struct mapd_signal_id signal;
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   Where it counts on the lane's road, within the lane's section [m].
   */
  double s;
  /*
   Where it counts, lateral on its road [m].
   */
  double t;
  /*
   Distance of that place from the lane's area in plan view [m].
   */
  double distance;
  /*
   What it means: a `MAPD_CLASS_…`.
   */
  uint16_t class_code;
  /*
   How signal and lane belong together: a `MAPD_LANE_METHOD_…`.
   */
  uint8_t method;
  /*
   1: it is for traffic that travels towards +s.
   */
  uint8_t is_for_forward;
  /*
   1: it is for traffic that travels towards −s.
   */
  uint8_t is_for_backward;
} mapd_lane_signal;

/*
 A stretch of a lane on which one speed limit holds.
 */
typedef struct mapd_speed_stretch {
  /*
   Its smaller s on the road [m].
   */
  double s_low;
  /*
   Its larger s [m].
   */
  double s_high;
  /*
   What holds there.
   */
  struct mapd_speed_rule rule;
  /*
   The limit, or where it depends on the way the lowest that may hold [m/s], infinite where there is none; counts only with `has_lowest`.
   */
  double lowest;
  /*
   1: something is known.
   */
  uint8_t has_lowest;
} mapd_speed_stretch;

/*
 A signal near a point.
 */
typedef struct mapd_near_signal {
  /*
   The signal.
   */
  struct mapd_signal_id signal;
  /*
   Plan-view distance of the point from where it stands [m].
   */
  double distance;
} mapd_near_signal;

/*
 Who goes first where a lane of a junction meets another.
 */
typedef struct mapd_right_of_way {
  /*
   The other lane.
   */
  struct mapd_lane_id other;
  /*
   Who goes first: a `MAPD_RELATION_…`.
   */
  uint8_t relation;
  /*
   Why: a `MAPD_RELATION_REASON_…`; where nothing is written, which rule of the road would have to say.
   */
  uint8_t reason;
  /*
   What that rests on: a `MAPD_BASIS_…`.
   */
  uint8_t basis;
} mapd_right_of_way;

/*
 An object.
 */
typedef struct mapd_object_facts {
  /*
   The object itself.
   */
  struct mapd_object_id object;
  /*
   The road that it is written in, if any.
   */
  struct mapd_road_id road;
  /*
   The junction that it is written in, if any.
   */
  struct mapd_junction_id junction;
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   Name for people.
   */
  struct mapd_text name;
  /*
   `type` as written.
   */
  struct mapd_text kind;
  /*
   `subtype` as written.
   */
  struct mapd_text subtype;
  /*
   As written [m].
   */
  double s;
  /*
   As written [m].
   */
  double t;
  /*
   Height of the origin above the reference line at s [m].
   */
  double z_offset;
  /*
   Length along s over which it holds [m]; 0 if not given.
   */
  double valid_length;
  /*
   Number of places where it stands.
   */
  uint32_t placements;
  /*
   What it means: a `MAPD_CLASS_…`.
   */
  uint16_t class_code;
  /*
   What its extent is made of: a `MAPD_OBJECT_SHAPE_…`.
   */
  uint8_t shape;
  /*
   Direction of travel that it is for: a `MAPD_ORIENTATION_…`.
   */
  uint8_t orientation;
  /*
   1: its state may change.
   */
  uint8_t is_dynamic;
  /*
   1: it is repeated, and stands at the copies alone.
   */
  uint8_t is_repeated;
  /*
   1: it stands for a limited time.
   */
  uint8_t is_temporary;
  /*
   1: it is written to hold no longer.
   */
  uint8_t is_invalidated;
  /*
   1: its s lies beyond the road, so that it stands beside its end.
   */
  uint8_t is_clamped;
  /*
   1: it is a parking space.
   */
  uint8_t is_parking_space;
  /*
   1: `value` is there.
   */
  uint8_t has_value;
  /*
   What its class means by its value: [m/s], [m] or [kg]; counts only with `has_value`.
   */
  double value;
  /*
   Unit in which the number of its value is read, such as `km/h`: objects state none. Empty without a value.
   */
  struct mapd_text assumed_unit;
  /*
   Of a parking space who may park, as written: all, car, women, handicapped, bus, truck, electric, residents.
   */
  struct mapd_text parking_access;
  /*
   Of a parking space its restrictions in words.
   */
  struct mapd_text parking_restrictions;
} mapd_object_facts;

/*
 A place of an object.
 */
typedef struct mapd_placement_id {
  /*
   The object.
   */
  struct mapd_object_id object;
  /*
   Which of its copies, from 0; `MAPD_NO_ROW` for an object that is not repeated.
   */
  uint32_t copy;
} mapd_placement_id;

/*
 An object where it stands.
 */
typedef struct mapd_placement_facts {
  /*
   Names the place.
   */
  struct mapd_placement_id place;
  /*
   Inertial position of the origin [m].
   */
  struct mapd_vec3 position;
  /*
   Inertial heading of the u axis [rad], in (−π, π].
   */
  double heading;
  /*
   Pitch [rad]; positive lowers the front.
   */
  double pitch;
  /*
   Roll [rad]; positive lifts the left side.
   */
  double roll;
  /*
   Along its own u axis [m]; 0 if not given.
   */
  double length;
  /*
   Along its own v axis [m]; 0 if not given.
   */
  double width;
  /*
   Height [m]; 0 if none is given.
   */
  double height;
  /*
   Radius [m]; 0 if not given.
   */
  double radius;
  /*
   On the object's road [m].
   */
  double s;
  /*
   On the object's road [m], positive to the left.
   */
  double t;
  /*
   1: it is the object without gaps along a stretch of road.
   */
  uint8_t is_swept;
} mapd_placement_facts;

/*
 An object's belonging to a lane.
 */
typedef struct mapd_object_lane {
  /*
   The object.
   */
  struct mapd_object_id object;
  /*
   The lane.
   */
  struct mapd_lane_id lane;
  /*
   From where on the road it lies on the lane, or beside it [m].
   */
  double s_low;
  /*
   To where [m].
   */
  double s_high;
  /*
   Distance of the object from the lane's area in plan view [m]; 0 on it.
   */
  double distance;
  /*
   How the object came to the lane: a `MAPD_LANE_METHOD_…`.
   */
  uint8_t method;
} mapd_object_lane;

/*
 An object near a point.
 */
typedef struct mapd_near_object {
  /*
   Where it stands.
   */
  struct mapd_placement_id place;
  /*
   Plan-view distance of the point from what it covers [m]; 0 on it.
   */
  double distance;
} mapd_near_object;

/*
 A set of classes of signals and objects: the bit of each is that of its code.
 */
typedef struct mapd_class_set {
  /*
   The lowest bits first; the highest one stands for unknown classes.
   */
  uint64_t words[4];
} mapd_class_set;

/*
 A thing that localisers find again.
 */
typedef struct mapd_landmark {
  /*
   The signal that it is; one of `signal` and `place` names something.
   */
  struct mapd_signal_id signal;
  /*
   The place of an object that it is.
   */
  struct mapd_placement_id place;
  /*
   What it means: a `MAPD_CLASS_…`.
   */
  uint16_t class_code;
  /*
   Where it stands, inertial [m].
   */
  struct mapd_vec3 position;
  /*
   Of a signal the direction of its face's normal, of an object that of its u axis [rad], in (−π, π].
   */
  double heading;
  /*
   Pitch [rad]; positive lowers the front.
   */
  double pitch;
  /*
   Roll [rad]; positive lifts the left side.
   */
  double roll;
  /*
   Length [m]; 0 where not given.
   */
  double length;
  /*
   Width [m]; 0 where not given.
   */
  double width;
  /*
   Height [m]; 0 where not given.
   */
  double height;
  /*
   Plan-view distance from the point that was asked about [m]; 0 where none was.
   */
  double distance;
} mapd_landmark;

/*
 A sensor that looks for landmarks.
 */
typedef struct mapd_sensor {
  /*
   Where it is, inertial [m].
   */
  struct mapd_vec2 position;
  /*
   Where it looks [rad], counter-clockwise from x.
   */
  double heading;
  /*
   How far it sees in plan view [m].
   */
  double range;
  /*
   Angle that it sees, half of it to either side [rad]; 2π and more is all round.
   */
  double field_of_view;
} mapd_sensor;

/*
 A landmark as a sensor sees it.
 */
typedef struct mapd_landmark_in_view {
  /*
   The landmark; its distance is the range from the sensor.
   */
  struct mapd_landmark landmark;
  /*
   Direction of where it stands from the sensor's heading [rad], positive to the left, in (−π, π].
   */
  double bearing;
  /*
   How far it is turned away from the sensor [rad], counter-clockwise, in (−π, π]: 0 looks at the sensor. Of an object that of its u axis.
   */
  double facing;
} mapd_landmark_in_view;

/*
 A road mark on a lane's outer border, for lane 0 on its own line.
 */
typedef struct mapd_road_mark {
  /*
   Where it begins: s on the road [m], not before the lane's section.
   */
  double s;
  /*
   Where the lane's next mark or the section's end takes over [m].
   */
  double s_end;
  /*
   Width [m]; negative where not given; of marks of two lines, that of each.
   */
  double width;
  /*
   Width [m]; where the file gives none 0.12 m, for bold marks 0.25 m; 0 for the kind `none`.
   */
  double width_or_default;
  /*
   Height above the road [m]; negative where not given.
   */
  double height;
  /*
   A `MAPD_ROAD_MARK_KIND_…`.
   */
  uint8_t kind;
  /*
   A `MAPD_ROAD_MARK_COLOR_…`.
   */
  uint8_t color;
  /*
   A `MAPD_ROAD_MARK_WEIGHT_…`.
   */
  uint8_t weight;
  /*
   Which lane changes it says it allows: a `MAPD_MARK_LANE_CHANGE_…`.
   */
  uint8_t lane_change;
} mapd_road_mark;

/*
 A straight piece of a lane's border.
 */
typedef struct mapd_boundary_segment {
  /*
   The lane whose outer border it is; lane 0 for the line between left and right lanes.
   */
  struct mapd_lane_id lane;
  /*
   s of the first end [m].
   */
  double s_from;
  /*
   s of the second end [m].
   */
  double s_to;
  /*
   First end, inertial [m].
   */
  struct mapd_vec3 from;
  /*
   Second end, inertial [m].
   */
  struct mapd_vec3 to;
} mapd_boundary_segment;

/*
 A straight piece of a road mark's course.
 */
typedef struct mapd_road_mark_segment {
  /*
   The piece of the lane's border.
   */
  struct mapd_boundary_segment segment;
  /*
   The mark's width [m], or the default one.
   */
  double width;
  /*
   A `MAPD_ROAD_MARK_KIND_…`.
   */
  uint8_t kind;
  /*
   A `MAPD_ROAD_MARK_COLOR_…`.
   */
  uint8_t color;
} mapd_road_mark_segment;

/*
 A painted place.
 */
typedef struct mapd_mark_point {
  /*
   In the middle of the line, of a road mark on the plane h = 0, inertial [m].
   */
  struct mapd_vec3 position;
  /*
   The lane on whose outer border the mark lies, lane 0 for marks of the centre; of an object a row of `MAPD_NO_ROW`.
   */
  struct mapd_lane_id lane;
  /*
   Along the road [m]; of an object that of its origin.
   */
  double s;
  /*
   Width of the line [m]; 0 of an outline, and where an object's line gives none.
   */
  double width;
  /*
   A `MAPD_ROAD_MARK_KIND_…`; of an object broken or solid, or a curb.
   */
  uint8_t kind;
  /*
   A `MAPD_ROAD_MARK_COLOR_…`: the line's own, or the mark's.
   */
  uint8_t color;
  /*
   1: on the outline of an object that is painted as a whole, and for which the file gives no lines.
   */
  uint8_t is_outline;
  /*
   The place of the object that it belongs to; its object's row is `MAPD_NO_ROW` for a mark of a lane.
   */
  struct mapd_placement_id place;
} mapd_mark_point;

/*
 A point of the road's surface.
 */
typedef struct mapd_surface {
  /*
   Inertial position [m].
   */
  struct mapd_vec3 position;
  /*
   Unit normal, upwards.
   */
  struct mapd_vec3 normal;
  /*
   The lane there, if any.
   */
  struct mapd_lane_id lane;
  /*
   What the lane is made of; counts only with `has_material`.
   */
  struct mapd_material material;
  /*
   1: the map says what the lane is made of.
   */
  uint8_t has_material;
  /*
   Whether s lay outside the road and was moved to its nearer end.
   */
  uint8_t clamped;
} mapd_surface;

/*
 What a lane lies above the road's surface [m].
 */
typedef struct mapd_lane_height {
  /*
   At the edge nearer to lane 0.
   */
  double inner;
  /*
   At the edge away from lane 0.
   */
  double outer;
} mapd_lane_height;

/*
 Height of a junction's elevation grid.
 */
typedef struct mapd_grid_height {
  /*
   Inertial [m].
   */
  double z;
  /*
   Slope by x.
   */
  double by_x;
  /*
   Slope by y.
   */
  double by_y;
} mapd_grid_height;

/*
 A bridge or tunnel.
 */
typedef struct mapd_structure {
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   OpenDRIVE's name.
   */
  struct mapd_text name;
  /*
   Type as written, such as concrete or underpass.
   */
  struct mapd_text type_name;
  /*
   The road.
   */
  struct mapd_road_id road;
  /*
   Where it begins on the road [m].
   */
  double s_from;
  /*
   Where it ends [m].
   */
  double s_to;
  /*
   Degree of artificial light in a tunnel, 0 to 1; negative where not given.
   */
  double lighting;
  /*
   Degree of daylight in a tunnel, 0 to 1; negative where not given.
   */
  double daylight;
  /*
   Smallest number of the lanes that it is written to hold for; counts only with `has_lanes`, else it holds for all.
   */
  int32_t lane_from;
  /*
   Largest number of those lanes. Of several ranges this is the whole from the first to the last.
   */
  int32_t lane_to;
  /*
   1: it holds for some lanes only.
   */
  uint8_t has_lanes;
  /*
   A `MAPD_STRUCTURE_KIND_…`.
   */
  uint8_t kind;
} mapd_structure;

/*
 An object of another road that concerns a road too.
 */
typedef struct mapd_object_reference {
  /*
   Id of the object as written.
   */
  struct mapd_text id;
  /*
   The object; one that names nothing where the map has none of this id.
   */
  struct mapd_object_id object;
  /*
   The road that refers to it.
   */
  struct mapd_road_id road;
  /*
   s on the referring road [m].
   */
  double s;
  /*
   t on the referring road [m].
   */
  double t;
  /*
   Height above the referring road's reference line [m].
   */
  double z_offset;
  /*
   Length along s over which it holds [m]; 0 where not given.
   */
  double valid_length;
  /*
   Direction of travel on the referring road that it is for: a `MAPD_ORIENTATION_…`.
   */
  uint8_t orientation;
} mapd_object_reference;

/*
 A part of the document that is not in the map as written.
 */
typedef struct mapd_quarantined {
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   Id of the road or junction that it belongs to; its own for a road or junction.
   */
  struct mapd_text owner;
  /*
   Id of the rule whose finding is the reason.
   */
  struct mapd_text rule;
  /*
   What the finding says.
   */
  struct mapd_text message;
  /*
   Name of the included file that the finding stands in; empty for the document itself.
   */
  struct mapd_text file;
  /*
   The rectangle around it; counts only with `has_extent`.
   */
  struct mapd_region extent;
  /*
   Length of a road as written [m]; 0 for other parts.
   */
  double length;
  /*
   Place of the finding in its file: line, from 1.
   */
  uint32_t line;
  /*
   Place of the finding in its file: column, from 1.
   */
  uint32_t column;
  /*
   What it is: a `MAPD_QUARANTINED_KIND_…`.
   */
  uint8_t kind;
  /*
   What the owner is.
   */
  uint8_t owner_kind;
  /*
   1: it is a road that is in the map as its bare reference line.
   */
  uint8_t is_reference_line;
  /*
   1: its place is known.
   */
  uint8_t has_extent;
} mapd_quarantined;

/*
 Junctions that belong together: a roundabout, an interchange.
 */
typedef struct mapd_junction_group {
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   OpenDRIVE's name.
   */
  struct mapd_text name;
  /*
   What the group is: a `MAPD_JUNCTION_GROUP_KIND_…`.
   */
  uint8_t kind;
} mapd_junction_group;

/*
 A group of signals that switch together.
 */
typedef struct mapd_controller {
  /*
   OpenDRIVE's id, verbatim.
   */
  struct mapd_text id;
  /*
   OpenDRIVE's name.
   */
  struct mapd_text name;
  /*
   Its rank; negative where not given.
   */
  int32_t sequence;
} mapd_controller;

/*
 Something that a signal names.
 */
typedef struct mapd_signal_link {
  /*
   Id as written.
   */
  struct mapd_text id;
  /*
   Type as written.
   */
  struct mapd_text kind;
  /*
   The signal, where it is one and the map has it.
   */
  struct mapd_signal_id signal;
  /*
   The object, where it is one and the map has it.
   */
  struct mapd_object_id object;
  /*
   1: an object is named.
   */
  uint8_t is_object;
} mapd_signal_link;

/*
 A place on Earth, on the ellipsoid of WGS 84.
 */
typedef struct mapd_geodetic {
  /*
   Latitude [deg], positive to the north.
   */
  double latitude;
  /*
   Longitude [deg], positive to the east, −180 to 180.
   */
  double longitude;
  /*
   Altitude [m]: the map's z with the header's offset. No geoid is applied.
   */
  double altitude;
} mapd_geodetic;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/*
 Makes a scratch. Close it with `mapd_scratch_close`.
 */
mapd_code mapd_scratch_new(struct mapd_scratch **out, struct mapd_error *error);

/*
 Closes a scratch and sets the handle to null. Null, or a handle that is null, is fine.
 */
void mapd_scratch_close(struct mapd_scratch **scratch);

/*
 Connects to the map of this name, whichever side starts first, and pins its newest generation. Waits at most `wait_s` [s];
 infinity waits without a limit. `prefix` names the domain; null: the one of the environment variable MAPD_PREFIX, else the default one.
 `MAPD_OWNER` names the user whose daemon is trusted, whatever the prefix; without it, this process's own.
 Close the client with `mapd_client_close`.

 Errors: the codes of attaching, what was missing when the wait ended; `MAPD_CODE_NAME`; `MAPD_CODE_NOT_AN_ARCHIVE`.
 */
mapd_code mapd_client_connect(const char *map,
                              const char *prefix,
                              double wait_s,
                              struct mapd_client **out,
                              struct mapd_error *error);

/*
 Closes a client and sets the handle to null. Snapshots and events that came from it stay valid. Null, or a handle that is null,
 is fine.
 */
void mapd_client_close(struct mapd_client **client);

/*
 The newest generation that this client has seen. Does not look for a newer one. Close it with `mapd_snapshot_close`.
 */
mapd_code mapd_client_snapshot(const struct mapd_client *client_handle,
                               struct mapd_snapshot **out,
                               struct mapd_error *error);

/*
 Looks for a newer generation without waiting and returns the newest. Close it with `mapd_snapshot_close`.

 Errors: the transport failed, or the new archive cannot be read; the old snapshot stays valid.
 */
mapd_code mapd_client_refresh(const struct mapd_client *client_handle,
                              struct mapd_snapshot **out,
                              struct mapd_error *error);

/*
 Waits at most `wait_s` [s] for a generation newer than the newest that this client has seen. Close it with `mapd_snapshot_close`.

 Errors: `MAPD_CODE_NO_GENERATION` if none came in time; as `mapd_client_refresh`.
 */
mapd_code mapd_client_wait_next(const struct mapd_client *client_handle,
                                double wait_s,
                                struct mapd_snapshot **out,
                                struct mapd_error *error);

/*
 Waits at most `wait_s` [s] for another generation, or for another overlay over the one that is served: `out` gets 1 if one has come. Then
 `mapd_client_snapshot` has it.

 Errors: as `mapd_client_refresh`.
 */
mapd_code mapd_client_wait_change(const struct mapd_client *client_handle,
                                  double wait_s,
                                  uint8_t *out,
                                  struct mapd_error *error);

/*
 Waits at most `wait_s` [s] for the generation of this number: processes that must change over together agree on the number of a staged
 generation, see `mapd_client_pending`, and each requires it. Close it with `mapd_snapshot_close`.

 Errors: `MAPD_CODE_SUPERSEDED` if a newer one is served already; as `mapd_client_wait_next`.
 */
mapd_code mapd_client_require(const struct mapd_client *client_handle,
                              uint64_t generation,
                              double wait_s,
                              struct mapd_snapshot **out,
                              struct mapd_error *error);

/*
 The generation that is staged: verified, in shared memory, and served once `mapd activate` is called. `MAPD_CODE_NONE` if there
 is none.
 */
mapd_code mapd_client_pending(const struct mapd_client *client_handle,
                              struct mapd_generation *out,
                              struct mapd_error *error);

/*
 Process id of the daemon that serves the map, in its own process namespace; 0 if it is not known. `MAPD_CODE_NONE` if no daemon serves it.
 */
mapd_code mapd_client_served_by(const struct mapd_client *client_handle,
                                uint32_t *pid,
                                struct mapd_error *error);

/*
 Time since the daemon's last heartbeat [s]. A daemon that serves the map writes one about once a second. If the age exceeds a few seconds, the daemon
 was killed, is stopped or gets no processor time, and the snapshot may be out of date. The clock is the monotonic one, which stops while the
 machine sleeps. `MAPD_CODE_NONE` if the map is no longer served.
 */
mapd_code mapd_client_heartbeat_age(const struct mapd_client *client_handle,
                                    double *age_s,
                                    struct mapd_error *error);

/*
 Sets whether all pages of a generation are mapped before it is returned, starting with the current one, so that no query waits
 for the kernel: as `mapd_snapshot_populate`. 0: no, the default.
 */
mapd_code mapd_client_set_populate(const struct mapd_client *client_handle,
                                   uint8_t populate,
                                   struct mapd_error *error);

/*
 Number of the newest generation that this client has seen.
 */
mapd_code mapd_client_generation(const struct mapd_client *client_handle, uint64_t *out, struct mapd_error *error);

/*
 Follows the map from now on. Each follower sees every event; a change that is undone between two calls gives no event. Close it
 with `mapd_events_close`.
 */
mapd_code mapd_events_new(const struct mapd_client *client,
                          struct mapd_events **out,
                          struct mapd_error *error);

/*
 Closes a follower and sets the handle to null. Null, or a handle that is null, is fine.
 */
void mapd_events_close(struct mapd_events **events);

/*
 The next event; waits at most `wait_s` [s]. `MAPD_CODE_NONE`: no event.

 Errors: the transport failed, or the new archive cannot be read; the old snapshot stays valid, and the next call continues.
 */
mapd_code mapd_events_next(struct mapd_events *events,
                           double wait_s,
                           struct mapd_event *out,
                           struct mapd_error *error);

/*
 Opens a `.mapd` file in place. Close the snapshot with `mapd_snapshot_close`.

 Errors: `MAPD_CODE_FILE`, `MAPD_CODE_NOT_AN_ARCHIVE`.
 */
mapd_code mapd_snapshot_open(const char *path, struct mapd_snapshot **out, struct mapd_error *error);

/*
 As `mapd_snapshot_open`, if the file is signed with the key in the file `key` (minisign); the signature is next to the archive. Reads the
 whole file.

 Errors: as `mapd_snapshot_open`; `MAPD_CODE_NOT_TRUSTED`.
 */
mapd_code mapd_snapshot_open_trusted(const char *path,
                                     const char *key,
                                     struct mapd_snapshot **out,
                                     struct mapd_error *error);

/*
 As `mapd_snapshot_open`, of an archive in memory: `size` bytes, which are copied.

 Errors: `MAPD_CODE_NOT_AN_ARCHIVE`.
 */
mapd_code mapd_snapshot_from_bytes(const uint8_t *bytes,
                                   size_t size,
                                   struct mapd_snapshot **out,
                                   struct mapd_error *error);

/*
 Another handle of the same snapshot, to be closed by itself: for another thread or owner.
 */
mapd_code mapd_snapshot_clone(const struct mapd_snapshot *snapshot,
                              struct mapd_snapshot **out,
                              struct mapd_error *error);

/*
 Closes a snapshot and sets the handle to null. Null, or a handle that is null, is fine.
 */
void mapd_snapshot_close(struct mapd_snapshot **snapshot);

/*
 The same map with an overlay that was made elsewhere: `size` bytes that the crate mapd-overlay encoded for this map; they are copied. A client's snapshots
 have the daemon's overlay without this call. Close it with `mapd_snapshot_close`.

 Errors: `MAPD_CODE_NOT_AN_ARCHIVE` for bytes that are not an overlay; `MAPD_CODE_FOREIGN_ID` for an overlay of another map.
 */
mapd_code mapd_snapshot_with_overlay(const struct mapd_snapshot *snapshot,
                                     const uint8_t *bytes,
                                     size_t size,
                                     struct mapd_snapshot **out,
                                     struct mapd_error *error);

/*
 Revision of the map's overlay, which rises with each change; 0 without an overlay. `mapd_view_new` applies the overlay.
 */
mapd_code mapd_snapshot_overlay_revision(const struct mapd_snapshot *snapshot, uint64_t *out, struct mapd_error *error);

/*
 Verifies the whole archive, its content hash included. Linear in its size; attaching and opening do not do this.

 Errors: `MAPD_CODE_NOT_PROVEN`, with the first fault that is found.
 */
mapd_code mapd_snapshot_verify(const struct mapd_snapshot *snapshot, struct mapd_error *error);

/*
 Maps every page of the archive into this process now, so that no query waits for the kernel. Linear in the archive's size.
 */
mapd_code mapd_snapshot_populate(const struct mapd_snapshot *snapshot,
                                 struct mapd_error *error);

/*
 Facts about the map.
 */
mapd_code mapd_map_facts_of(const struct mapd_snapshot *snapshot, struct mapd_map_facts *out, struct mapd_error *error);

/*
 Latitudes and longitudes of the map's bounds, rounded to 1e-9 degrees. `MAPD_CODE_NONE` without a usable georeference.
 */
mapd_code mapd_map_geodetic_bounds(const struct mapd_snapshot *snapshot,
                                   struct mapd_geodetic_bounds *out,
                                   struct mapd_error *error);

/*
 The road with OpenDRIVE's id, compared byte by byte. `MAPD_CODE_NONE` if there is none.
 */
mapd_code mapd_road_by_id(const struct mapd_snapshot *snapshot,
                          const char *id,
                          struct mapd_road_id *out,
                          struct mapd_error *error);

/*
 The junction with OpenDRIVE's id, compared byte by byte. `MAPD_CODE_NONE` if there is none.
 */
mapd_code mapd_junction_by_id(const struct mapd_snapshot *snapshot,
                              const char *id,
                              struct mapd_junction_id *out,
                              struct mapd_error *error);

/*
 A signal with OpenDRIVE's id, compared byte by byte; of several with one id any. `MAPD_CODE_NONE` if there is none.
 */
mapd_code mapd_signal_by_id(const struct mapd_snapshot *snapshot,
                            const char *id,
                            struct mapd_signal_id *out,
                            struct mapd_error *error);

/*
 The object with OpenDRIVE's id, compared byte by byte; of several the first. `MAPD_CODE_NONE` if there is none.
 */
mapd_code mapd_object_by_id(const struct mapd_snapshot *snapshot,
                            const char *id,
                            struct mapd_object_id *out,
                            struct mapd_error *error);

/*
 The lane with a key such as `12:0:-1`; of one in several pieces the first. `MAPD_CODE_NONE` if there is none.

 Errors: `MAPD_CODE_ARGUMENT` for a text that is no key.
 */
mapd_code mapd_lane_by_key(const struct mapd_snapshot *snapshot,
                           const char *key,
                           struct mapd_lane_id *out,
                           struct mapd_error *error);

/*
 The lane's stable name, `road:section:lane`, terminated by 0. `length`: without that; may be null. With `MAPD_CODE_TOO_SMALL` the buffer holds
 the beginning.
 */
mapd_code mapd_lane_key(const struct mapd_snapshot *snapshot,
                        struct mapd_lane_id lane,
                        char *out,
                        size_t capacity,
                        size_t *length,
                        struct mapd_error *error);

/*
 OpenDRIVE's id of a road, verbatim.
 */
mapd_code mapd_road_name_id(const struct mapd_snapshot *snapshot,
                            struct mapd_road_id road,
                            struct mapd_text *out,
                            struct mapd_error *error);

/*
 All roads in file order.
 */
mapd_code mapd_roads(const struct mapd_snapshot *snapshot,
                     struct mapd_road_id *out,
                     size_t capacity,
                     size_t *count,
                     struct mapd_error *error);

/*
 All junctions in file order.
 */
mapd_code mapd_junctions(const struct mapd_snapshot *snapshot,
                         struct mapd_junction_id *out,
                         size_t capacity,
                         size_t *count,
                         struct mapd_error *error);

/*
 All lanes, those of the number 0 and of the temporary layer left out.
 */
mapd_code mapd_lanes(const struct mapd_snapshot *snapshot,
                     struct mapd_lane_id *out,
                     size_t capacity,
                     size_t *count,
                     struct mapd_error *error);

/*
 All signals in file order, signs on boards behind what carries them.
 */
mapd_code mapd_signals(const struct mapd_snapshot *snapshot,
                       struct mapd_signal_id *out,
                       size_t capacity,
                       size_t *count,
                       struct mapd_error *error);

/*
 All objects: those of roads in the order of the roads, then those of junctions.
 */
mapd_code mapd_objects(const struct mapd_snapshot *snapshot,
                       struct mapd_object_id *out,
                       size_t capacity,
                       size_t *count,
                       struct mapd_error *error);

/*
 Sets options to their defaults. `size` is `sizeof(mapd_nearest_options)`.
 */
mapd_code mapd_nearest_options_init(struct mapd_nearest_options *options, size_t size, struct mapd_error *error);

/*
 Bits of the lane types that are built for motor vehicles, whoever may use them.
 */
uint64_t mapd_lane_types_drivable(void);

/*
 Bits of the lane types that routes lead over: those that the lane graph opens to motor vehicles where no access record says otherwise.
 */
uint64_t mapd_lane_types_routable(void);

/*
 The lane whose area is nearest to a point in plan view, within the options' radius; distance 0 inside. Ties go by heading difference, z
 difference, lanes without width last, |offset|, then key. `options`: null is the default. `MAPD_CODE_NONE` if nothing is near enough.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_nearest_lane(const struct mapd_snapshot *snapshot,
                            struct mapd_point point,
                            const struct mapd_nearest_options *options,
                            struct mapd_nearest *out,
                            struct mapd_error *error);

/*
 As `mapd_nearest_lane`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW`
 and a position of zeros. Points near each other, in whatever order, cost a fraction of single calls.

 Errors: as `mapd_nearest_lane`, with the number of the point; what `out` holds then has no meaning.
 */
mapd_code mapd_nearest_lane_batch(const struct mapd_snapshot *snapshot,
                                  const struct mapd_point *points,
                                  size_t count,
                                  const struct mapd_nearest_options *options,
                                  struct mapd_scratch *scratch,
                                  struct mapd_nearest *out,
                                  struct mapd_error *error);

/*
 Every lane whose area lies within the options' radius of a point, nearest first, each once.

 Errors: as `mapd_nearest_lane`.
 */
mapd_code mapd_lanes_near(const struct mapd_snapshot *snapshot,
                          struct mapd_point point,
                          const struct mapd_nearest_options *options,
                          struct mapd_scratch *scratch,
                          struct mapd_nearest *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 Whether a point lies on a lane, edges included, in plan view: 1 or 0. A point with z only on one within `z_tolerance` [m], where
 that is not negative.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_covers(const struct mapd_snapshot *snapshot,
                      struct mapd_point point,
                      double z_tolerance,
                      uint8_t *out,
                      struct mapd_error *error);

/*
 Every lane of these types whose area meets a rectangle in plan view, in the order of their rows.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lanes_in(const struct mapd_snapshot *snapshot,
                        struct mapd_region region,
                        uint64_t types,
                        struct mapd_scratch *scratch,
                        struct mapd_lane_id *out,
                        size_t capacity,
                        size_t *count,
                        struct mapd_error *error);

/*
 What a road is.
 */
mapd_code mapd_road_facts_of(const struct mapd_snapshot *snapshot,
                             struct mapd_road_id road,
                             struct mapd_road_facts *out,
                             struct mapd_error *error);

/*
 Inertial pose of a track position: (x, y, e) + t along the rolled lateral axis + h along its normal. s beyond the reference line
 is moved to its end and flagged.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_to_inertial(const struct mapd_snapshot *snapshot,
                                struct mapd_road_id road,
                                struct mapd_track track,
                                struct mapd_pose *out,
                                struct mapd_error *error);

/*
 Track position of a point: the foot on the nearest place of the whole reference line. Without z in plan view.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_to_track(const struct mapd_snapshot *snapshot,
                             struct mapd_road_id road,
                             struct mapd_point point,
                             struct mapd_track_position *out,
                             struct mapd_error *error);

/*
 As `mapd_road_to_inertial`, of `count` track positions; `out` has room for as many.

 Errors: as `mapd_road_to_inertial`; the answers before the entry that has one are written.
 */
mapd_code mapd_road_to_inertial_batch(const struct mapd_snapshot *snapshot,
                                      struct mapd_road_id road,
                                      const struct mapd_track *tracks,
                                      size_t count,
                                      struct mapd_pose *out,
                                      struct mapd_error *error);

/*
 As `mapd_road_to_track`, of `count` points; `out` has room for as many.

 Errors: as `mapd_road_to_track`; the answers before the point that has one are written.
 */
mapd_code mapd_road_to_track_batch(const struct mapd_snapshot *snapshot,
                                   struct mapd_road_id road,
                                   const struct mapd_point *points,
                                   size_t count,
                                   struct mapd_track_position *out,
                                   struct mapd_error *error);

/*
 Elevation of the reference line at s [m]. s outside the road counts as its nearer end.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_elevation_at(const struct mapd_snapshot *snapshot,
                                 struct mapd_road_id road,
                                 double s,
                                 double *out,
                                 struct mapd_error *error);

/*
 Superelevation at s [rad]; positive lifts the left side. s outside the road counts as its nearer end.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_superelevation_at(const struct mapd_snapshot *snapshot,
                                      struct mapd_road_id road,
                                      double s,
                                      double *out,
                                      struct mapd_error *error);

/*
 Lane offset at s [m]; positive to the left. s outside the road counts as its nearer end.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_lane_offset_at(const struct mapd_snapshot *snapshot,
                                   struct mapd_road_id road,
                                   double s,
                                   double *out,
                                   struct mapd_error *error);

/*
 The lane that covers (s, t); on a shared edge the one nearer to lane 0. `MAPD_CODE_NONE` beside all lanes.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_lane_at(const struct mapd_snapshot *snapshot,
                            struct mapd_road_id road,
                            double s,
                            double t,
                            struct mapd_lane_id *out,
                            struct mapd_error *error);

/*
 The lane with OpenDRIVE's number at s; at a boundary of two sections that of the later one. `MAPD_CODE_NONE` if there is none.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_lane_numbered(const struct mapd_snapshot *snapshot,
                                  struct mapd_road_id road,
                                  double s,
                                  int32_t number,
                                  struct mapd_lane_id *out,
                                  struct mapd_error *error);

/*
 Lanes of a section of the road, by the section's number from 0, from left to right, lane 0 among them. `MAPD_CODE_NONE` for a section
 that there is not.
 */
mapd_code mapd_road_section_lanes(const struct mapd_snapshot *snapshot,
                                  struct mapd_road_id road,
                                  uint32_t section,
                                  struct mapd_lane_id *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);

/*
 What a lane is.
 */
mapd_code mapd_lane_facts_of(const struct mapd_snapshot *snapshot,
                             struct mapd_lane_id lane,
                             struct mapd_lane_facts *out,
                             struct mapd_error *error);

/*
 A point in the lane's coordinates: exact foot on the reference line within the lane's section, distance from the lane's area.

 Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_CORRUPT` for lane 0, which has no area.
 */
mapd_code mapd_lane_position_of(const struct mapd_snapshot *snapshot,
                                struct mapd_lane_id lane,
                                struct mapd_point point,
                                struct mapd_lane_position *out,
                                struct mapd_error *error);

/*
 Pose at s as the lane's traffic has it, `offset` [m] to its left of the lane's centre, on the plane h = 0. Heading and curvature are those of the
 line that keeps this offset, in driving direction; slope and superelevation are the road's. s outside the lane's section is moved to its nearer end and flagged.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_pose_at(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            double s,
                            double offset,
                            struct mapd_pose *out,
                            struct mapd_error *error);

/*
 As `mapd_lane_pose_at`, in the road's frame: heading and curvature are those of the reference line, ahead is the way s rises, and `offset` counts to the left of that.
 */
mapd_code mapd_lane_pose_of_reference_line(const struct mapd_snapshot *snapshot,
                                           struct mapd_lane_id lane,
                                           double s,
                                           double offset,
                                           struct mapd_pose *out,
                                           struct mapd_error *error);

/*
 The centre line's exact place at s, with its own direction: that of `mapd_lane_pose_at` at offset 0. s outside the lane's section is moved to its nearer end and flagged.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_waypoint_at(const struct mapd_snapshot *snapshot,
                                struct mapd_lane_id lane,
                                double s,
                                struct mapd_waypoint *out,
                                struct mapd_error *error);

/*
 Waypoints in driving direction, `step` [m] of s apart, from where the lane is entered to where it is left; both ends are among them.

 Errors: `MAPD_CODE_NOT_FINITE` for a step that is not a positive finite number; `MAPD_CODE_ARGUMENT` for one that gives more than a million.
 */
mapd_code mapd_lane_waypoints(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              double step,
                              struct mapd_waypoint *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);

/*
 Both edges at s, as lateral coordinates. s outside the lane's section counts as its nearer end.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_edges_at(const struct mapd_snapshot *snapshot,
                             struct mapd_lane_id lane,
                             double s,
                             struct mapd_lane_edges *out,
                             struct mapd_error *error);

/*
 Both edges at s, inertial. s outside the lane's section counts as its nearer end.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_bounds_at(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              double s,
                              struct mapd_lane_bounds *out,
                              struct mapd_error *error);

/*
 Width at s [m], never negative. s outside the lane's section counts as its nearer end.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_width_at(const struct mapd_snapshot *snapshot,
                             struct mapd_lane_id lane,
                             double s,
                             double *out,
                             struct mapd_error *error);

/*
 The speed limit that is recorded at s [m/s]: in the lane's own record, else in that of the road's type; infinite where the file says `no limit`. What holds may be
 another: `mapd_lane_speed_rule_at`. `MAPD_CODE_NONE` where the file says nothing or states a limit that cannot be read.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_recorded_speed_limit_at(const struct mapd_snapshot *snapshot,
                                            struct mapd_lane_id lane,
                                            double s,
                                            double *out,
                                            struct mapd_error *error);

/*
 Length of the centre line in plan view between two places on the road [m]. s outside the lane's section counts as its nearer end.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_length_between(const struct mapd_snapshot *snapshot,
                                   struct mapd_lane_id lane,
                                   double a,
                                   double b,
                                   double *out,
                                   struct mapd_error *error);

/*
 What a route by time counts for the centre line between two places on the road [s]: its length at `mapd_lane_recorded_speed_limit_at`, at 50 km/h where no limit is recorded,
 at 130 km/h where there is none. The time at the limits of a way is `mapd_path_travel_time`. s outside the lane's section counts as its nearer end.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_time_between(const struct mapd_snapshot *snapshot,
                                 struct mapd_lane_id lane,
                                 double a,
                                 double b,
                                 double *out,
                                 struct mapd_error *error);

/*
 Which signs forbid overtaking at s. A sign holds from its place on, in driving direction, until another one ends it, over lanes that lead on alone, and
 not beyond a junction. What road marks forbid is `change_left` and `change_right` of `mapd_node_facts`.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_overtaking_rule_at(const struct mapd_snapshot *snapshot,
                                       struct mapd_lane_id lane,
                                       double s,
                                       struct mapd_overtaking_rule *out,
                                       struct mapd_error *error);

/*
 The lane beside this one; `side` is a `MAPD_BESIDE_…`. `MAPD_CODE_NONE` if there is none. One that shares the direction and may be
 changed to is `change_left` or `change_right` of `mapd_node_facts`.

 Errors: `MAPD_CODE_ARGUMENT` for an unknown side.
 */
mapd_code mapd_lane_beside(const struct mapd_snapshot *snapshot,
                           struct mapd_lane_id lane,
                           uint32_t side,
                           struct mapd_lane_id *out,
                           struct mapd_error *error);

/*
 Lanes entered from this one in its own driving direction, in order of road id, section and lane.
 */
mapd_code mapd_lane_successors(const struct mapd_snapshot *snapshot,
                               struct mapd_lane_id lane,
                               struct mapd_lane_id *out,
                               size_t capacity,
                               size_t *count,
                               struct mapd_error *error);

/*
 Lanes from which this one is entered in its own driving direction, in order of road id, section and lane.
 */
mapd_code mapd_lane_predecessors(const struct mapd_snapshot *snapshot,
                                 struct mapd_lane_id lane,
                                 struct mapd_lane_id *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 Sets options to their defaults. `size` is `sizeof(mapd_match_options)`.
 */
mapd_code mapd_match_options_init(struct mapd_match_options *options, size_t size, struct mapd_error *error);

/*
 Sets options to their defaults. `size` is `sizeof(mapd_trace_options)`.
 */
mapd_code mapd_trace_options_init(struct mapd_trace_options *options, size_t size, struct mapd_error *error);

/*
 The lanes that a vehicle may be in by a measured pose, the most probable first. `covariance` has nine entries, row by row: that of
 (x, y, heading) in [m²], [m·rad] and [rad²]; a heading that is not known has a large one. `options`: null is the default. `none`: the
 probability that it is in no lane; null is fine. docs/localisation.md has the model.

 Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for a covariance that is not symmetric and positive semi-definite, and for
 options out of their domain.
 */
mapd_code mapd_match_pose(const struct mapd_snapshot *snapshot,
                          struct mapd_vehicle_pose pose,
                          const double *covariance,
                          const struct mapd_match_options *options,
                          struct mapd_scratch *scratch,
                          struct mapd_lane_match *out,
                          size_t capacity,
                          size_t *count,
                          double *none,
                          struct mapd_error *error);

/*
 As `mapd_match_pose`, of `pose_count` poses. There is one covariance of nine entries for all of them, or one for each. `out` gets the lanes of all
 poses one behind the other; `ends` and `none` have room for an entry for each pose: where its lanes end in `out`, and the probability that it is
 in none. Null for either is fine.

 Errors: as `mapd_match_pose`, by the number of the first pose that has one.
 */
mapd_code mapd_match_pose_batch(const struct mapd_snapshot *snapshot,
                                const struct mapd_vehicle_pose *poses,
                                size_t pose_count,
                                const double *covariances,
                                size_t covariance_count,
                                const struct mapd_match_options *options,
                                struct mapd_scratch *scratch,
                                struct mapd_lane_match *out,
                                size_t capacity,
                                size_t *count,
                                size_t *ends,
                                double *none,
                                struct mapd_error *error);

/*
 The lanes of a trace: the most probable way through all its fixes. `out` has room for `count` answers, one for each fix. `options`: null
 is the default.

 Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for times that fall and for options out of their domain.
 */
mapd_code mapd_match_trace(const struct mapd_snapshot *snapshot,
                           const struct mapd_trace_fix *fixes,
                           size_t count,
                           const struct mapd_trace_options *options,
                           struct mapd_scratch *scratch,
                           struct mapd_trace_match *out,
                           struct mapd_error *error);

/*
 Makes a tracker that has seen nothing. Close it with `mapd_tracker_close`.
 */
mapd_code mapd_tracker_new(struct mapd_tracker **out, struct mapd_error *error);

/*
 Closes a tracker and sets the handle to null. Null, or a handle that is null, is fine.
 */
void mapd_tracker_close(struct mapd_tracker **tracker);

/*
 Sets options to their defaults. `size` is `sizeof(mapd_tracker_options)`.
 */
mapd_code mapd_tracker_options_init(struct mapd_tracker_options *options, size_t size, struct mapd_error *error);

/*
 Takes the next fix. The first one, one after `memory` without any, and the first on a map of other content begin anew. `options`: null is the default.

 Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for a covariance that is not symmetric and positive semi-definite, a time before that of the
 last fix, and options out of their domain. The tracker stays as it was.
 */
mapd_code mapd_tracker_update(struct mapd_tracker *tracker,
                              const struct mapd_snapshot *snapshot,
                              const struct mapd_tracker_fix *fix,
                              const struct mapd_tracker_options *options,
                              struct mapd_tracked *out,
                              struct mapd_error *error);

/*
 The lanes that the vehicle may be in, the most probable one first; at most 32. `none`: the probability that it is in none, or across them; null is
 fine.
 */
mapd_code mapd_tracker_hypotheses(const struct mapd_tracker *tracker,
                                  struct mapd_lane_match *out,
                                  size_t capacity,
                                  size_t *count,
                                  double *none,
                                  struct mapd_error *error);

/*
 Probability that the vehicle is in one of these lanes, such as those of its route: when it has left them, this falls.
 */
mapd_code mapd_tracker_probability_in(struct mapd_tracker *tracker,
                                      const struct mapd_lane_id *lanes,
                                      size_t lane_count,
                                      double *out,
                                      struct mapd_error *error);

/*
 Has the tracker forget everything.
 */
mapd_code mapd_tracker_reset(struct mapd_tracker *tracker, struct mapd_error *error);

/*
 The ground at a place, on the level whose height is nearest to the point's z. A point without z is on the lowest level with one of `expected_count` lanes, such as the one
 that the vehicle was in and those that it can reach from there; with none of them, on the lowest one. Heights more than 2 m apart are levels of
 their own. `expected`: null with a count of 0 is fine. `MAPD_CODE_NONE` beside all lanes.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_ground_at(const struct mapd_snapshot *snapshot,
                         struct mapd_point point,
                         const struct mapd_lane_id *expected,
                         size_t expected_count,
                         struct mapd_scratch *scratch,
                         struct mapd_ground *out,
                         struct mapd_error *error);

/*
 As `mapd_ground_at`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW`.

 Errors: as `mapd_ground_at`; the answers before the point that has one are written.
 */
mapd_code mapd_ground_at_batch(const struct mapd_snapshot *snapshot,
                               const struct mapd_point *points,
                               size_t count,
                               const struct mapd_lane_id *expected,
                               size_t expected_count,
                               struct mapd_scratch *scratch,
                               struct mapd_ground *out,
                               struct mapd_error *error);

/*
 How a vehicle stands at a pose: the plane through the ground below its wheels, nearest to all four. `wheels` are four places where they touch the
 ground, from the reference point ahead (x) and to the left (y) [m]; the pose's z, if known, decides on which level, then the expected lanes, as in `mapd_ground_at`. Pitch and roll follow heading, in
 this order. `MAPD_CODE_NONE` with ground below fewer than three wheels, or wheels in a line.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_stance_at(const struct mapd_snapshot *snapshot,
                         struct mapd_vehicle_pose pose,
                         const struct mapd_vec2 *wheels,
                         const struct mapd_lane_id *expected,
                         size_t expected_count,
                         struct mapd_scratch *scratch,
                         struct mapd_stance *out,
                         struct mapd_error *error);

/*
 Sets a filter to its defaults. `size` is `sizeof(mapd_mark_filter)`.
 */
mapd_code mapd_mark_filter_init(struct mapd_mark_filter *filter, size_t size, struct mapd_error *error);

/*
 The road mark that is nearest to a point, on the exact course of each of its lines. Lines count along their whole length, gaps included.
 `filter`: null is the default. `MAPD_CODE_NONE` if none is near enough.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_nearest_mark(const struct mapd_snapshot *snapshot,
                            struct mapd_vec2 point,
                            const struct mapd_mark_filter *filter,
                            struct mapd_near_mark *out,
                            struct mapd_error *error);

/*
 As `mapd_nearest_mark`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW`.

 Errors: as `mapd_nearest_mark`; the answers before the point that has one are written.
 */
mapd_code mapd_nearest_mark_batch(const struct mapd_snapshot *snapshot,
                                  const struct mapd_vec2 *points,
                                  size_t count,
                                  const struct mapd_mark_filter *filter,
                                  struct mapd_near_mark *out,
                                  struct mapd_error *error);

/*
 Points of a lane's centre line or of one of its borders, in ascending s: a polyline of bounded error, as it is stored. `line` is
 a `MAPD_LINE_…`.

 Errors: `MAPD_CODE_ARGUMENT` for an unknown line.
 */
mapd_code mapd_lane_line(const struct mapd_snapshot *snapshot,
                         struct mapd_lane_id lane,
                         uint32_t line,
                         struct mapd_line_point *out,
                         size_t capacity,
                         size_t *count,
                         struct mapd_error *error);

/*
 Number of nodes of the lane graph; their rows count from 0.
 */
mapd_code mapd_node_count(const struct mapd_snapshot *snapshot, size_t *out, struct mapd_error *error);

/*
 What a node is.
 */
mapd_code mapd_node_facts_of(const struct mapd_snapshot *snapshot,
                             struct mapd_node_id node,
                             struct mapd_node_facts *out,
                             struct mapd_error *error);

/*
 Edges that leave a node, by road id, section and lane of their targets.
 */
mapd_code mapd_node_edges(const struct mapd_snapshot *snapshot,
                          struct mapd_node_id node,
                          struct mapd_edge *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 Nodes from which a node is entered.
 */
mapd_code mapd_node_predecessors(const struct mapd_snapshot *snapshot,
                                 struct mapd_node_id node,
                                 struct mapd_node_id *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 A lane's nodes in driving order; of a lane travelled both ways then those of the other way.
 */
mapd_code mapd_lane_nodes(const struct mapd_snapshot *snapshot,
                          struct mapd_lane_id lane,
                          struct mapd_node_id *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 The node that holds s, towards +s (`forward` not 0) or −s; at a cut the later one in that direction. s outside the lane's section
 counts as its nearer end. `MAPD_CODE_NONE` where the lane is not travelled that way.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_node_at(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            double s,
                            uint8_t forward,
                            struct mapd_node_id *out,
                            struct mapd_error *error);

/*
 Whether a class of vehicles may use the lane at s in its own direction: 1 or 0. `vehicle` is a `MAPD_VEHICLE_CLASS_…`.

 Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_lane_allows_at(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              double s,
                              uint8_t vehicle,
                              uint8_t *out,
                              struct mapd_error *error);

/*
 Lanes of the same junction whose areas meet this one's.
 */
mapd_code mapd_lane_conflicts(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              struct mapd_conflict *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);

/*
 The cheapest way through `place_count` places, two or more, in their order, in driving direction and by allowed lane changes only. `sum`: what
 it comes to; null is fine. Fewer than two places, or no way: `MAPD_CODE_NONE`, and the count is 0.

 The lane of the start may be any; every other one must be open to the vehicle. Each leg is the cheapest by itself.

 Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown cost or class.
 */
mapd_code mapd_route(const struct mapd_snapshot *snapshot,
                     const struct mapd_position_on_lane *places,
                     size_t place_count,
                     struct mapd_cost cost,
                     struct mapd_scratch *scratch,
                     struct mapd_route_sum *sum,
                     struct mapd_route_step *out,
                     size_t capacity,
                     size_t *count,
                     struct mapd_error *error);

/*
 Every node whose beginning can be reached within a cost, nearest first; the start's own node and those beside it come first of all.

 Errors: as `mapd_route`.
 */
mapd_code mapd_reachable(const struct mapd_snapshot *snapshot,
                         struct mapd_position_on_lane from,
                         double limit,
                         struct mapd_cost cost,
                         struct mapd_scratch *scratch,
                         struct mapd_reached *out,
                         size_t capacity,
                         size_t *count,
                         struct mapd_error *error);

/*
 Every node from whose beginning a place can be reached within a cost, nearest first: who can come here. The place's own node and those beside it
 come with what is to be driven on them.

 Errors: as `mapd_route`.
 */
mapd_code mapd_reachable_to(const struct mapd_snapshot *snapshot,
                            struct mapd_position_on_lane to,
                            double limit,
                            struct mapd_cost cost,
                            struct mapd_scratch *scratch,
                            struct mapd_reached *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 All sequences of lanes that a vehicle can follow from a place without changing lanes (`ahead` not 0), or on which it can have come there,
 until each is `distance` [m] long or ends: what they have in common, as `mapd_reach` writes it, each piece of a lane once. `mapd_next_sequence` tells them one
 by one. The lane of the place may be any; every other one must be open to the vehicle.

 Errors: as `mapd_route`.
 */
mapd_code mapd_lane_sequences(const struct mapd_snapshot *snapshot,
                              struct mapd_position_on_lane from,
                              double distance,
                              uint8_t vehicle,
                              uint8_t ahead,
                              struct mapd_scratch *scratch,
                              struct mapd_reached_piece *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_reach_link *links,
                              size_t link_capacity,
                              size_t *link_count,
                              struct mapd_error *error);

/*
 The next of the sequences that the last `mapd_lane_sequences` with this scratch found: its lanes, from the one of the place on, in the direction in which it is
 followed. `MAPD_CODE_NONE` after the last one. After `MAPD_CODE_TOO_SMALL` the next call tells the same one. Their number doubles with each fork; one of more than 65,536
 pieces of lanes ends there.

 Errors: null where something is needed.
 */
mapd_code mapd_next_sequence(struct mapd_scratch *scratch,
                             struct mapd_lane_id *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);

/*
 The next junction ahead of a place within a distance [m], following the lanes as long as there is but one way on, or all ways lead into one
 junction. On a connecting road the distance is 0. `MAPD_CODE_NONE` if there is none.

 Errors: as `mapd_route`.
 */
mapd_code mapd_next_junction_of(const struct mapd_snapshot *snapshot,
                                struct mapd_position_on_lane from,
                                double distance,
                                uint8_t vehicle,
                                struct mapd_next_junction *out,
                                struct mapd_error *error);

/*
 Sets options to their defaults. `size` is `sizeof(mapd_path_options)`.
 */
mapd_code mapd_path_options_init(struct mapd_path_options *options, size_t size, struct mapd_error *error);

/*
 The path along a route's steps. `options`: null is the default. Close it with `mapd_path_close`.

 Errors: steps that do not follow each other, go backwards, or none, and options out of their domain: `MAPD_CODE_ARGUMENT`;
 `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_path_new(const struct mapd_snapshot *snapshot,
                        const struct mapd_route_step *steps,
                        size_t step_count,
                        const struct mapd_path_options *options,
                        struct mapd_path **out,
                        struct mapd_error *error);

/*
 Closes a path and sets the handle to null. Null, or a handle that is null, is fine.
 */
void mapd_path_close(struct mapd_path **path);

/*
 Length: the largest S [m].
 */
mapd_code mapd_path_length(const struct mapd_path *path, double *out, struct mapd_error *error);

/*
 The place at S, `along` [m]. S outside the path is moved to its nearer end and flagged.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_path_at(const struct mapd_path *path,
                       double along,
                       struct mapd_path_point *out,
                       struct mapd_error *error);

/*
 A point in the path's coordinates. `hint`: null, or S of a point nearby such as the one before: the search begins there.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_path_project(const struct mapd_path *path,
                            struct mapd_vec2 point,
                            const double *hint,
                            struct mapd_path_position *out,
                            struct mapd_error *error);

/*
 The speed limit at S, `along` [m]; in a junction that which comes in on the path. `MAPD_CODE_NONE` where the path has none.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_path_speed_at(const struct mapd_path *path,
                             double along,
                             struct mapd_speed_rule *out,
                             struct mapd_error *error);

/*
 Gaps, overlaps and kinks of more than rounding, and changes of lane, in ascending S.
 */
mapd_code mapd_path_joints(const struct mapd_path *path,
                           struct mapd_path_joint *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);

/*
 The lanes that are driven on, in ascending S; one that is only changed from is not among them.
 */
mapd_code mapd_path_lanes(const struct mapd_path *path,
                          struct mapd_path_lane *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 S of a place on one of the path's lanes [m]: the first where it is driven over several times. `MAPD_CODE_NONE` for one that the path does
 not pass.
 */
mapd_code mapd_path_along_of(const struct mapd_path *path,
                             struct mapd_lane_id lane,
                             double s,
                             double *out,
                             struct mapd_error *error);

/*
 Whether some joint is broken, 1 or 0: a gap of more than 0.1 m or a kink of more than 0.3 rad.
 */
mapd_code mapd_path_is_broken(const struct mapd_path *path, uint8_t *out, struct mapd_error *error);

/*
 As `mapd_path_at`, of `count` places; `out` has room for as many.

 Errors: as `mapd_path_at`; the answers before the place that has one are written.
 */
mapd_code mapd_path_at_batch(const struct mapd_path *path,
                             const double *along,
                             size_t count,
                             struct mapd_path_point *out,
                             struct mapd_error *error);

/*
 As `mapd_path_project` without a hint, of `count` points; `out` has room for as many.

 Errors: as `mapd_path_project`; the answers before the point that has one are written.
 */
mapd_code mapd_path_project_batch(const struct mapd_path *path,
                                  const struct mapd_vec2 *points,
                                  size_t count,
                                  struct mapd_path_position *out,
                                  struct mapd_error *error);

/*
 What the path comes by, in ascending S: junctions with the turn, signals, stop lines and crossings, types of roads and lanes, countries, who may use the lane, bridges
 and tunnels, and holes of the map. What goes on over several lanes stands once. Speed limits are `mapd_path_speeds`.
 */
mapd_code mapd_path_facts(const struct mapd_path *path,
                          struct mapd_scratch *scratch,
                          struct mapd_path_fact *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 The speed limits along the path, in ascending S without gaps.
 */
mapd_code mapd_path_speeds(const struct mapd_path *path,
                           struct mapd_scratch *scratch,
                           struct mapd_path_speed *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);

/*
 How long a vehicle takes from S, `from`, to S, `to` [m], at the speed limits. S outside the path is moved to its nearer end.

 Errors: `MAPD_CODE_ARGUMENT` where `from` is more than `to`; `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_path_travel_time(const struct mapd_path *path,
                                double from,
                                double to,
                                struct mapd_path_time *out,
                                struct mapd_error *error);

/*
 A country of a path's fact, as the file writes it: two or three letters, or a name in older versions. `MAPD_CODE_NONE` for a number that is not one of the
 map's.
 */
mapd_code mapd_country(const struct mapd_snapshot *snapshot,
                       uint32_t number,
                       struct mapd_text *out,
                       struct mapd_error *error);

/*
 On every stretch of the path the lanes from which its goal is reached along the same roads, from left to right as the driver sees them. Stretches are
 in ascending S and cover the path; on each it is the same who may go where. `vehicle` is a `MAPD_VEHICLE_CLASS_…`.

 Errors: `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_path_segments(const struct mapd_path *path,
                             uint8_t vehicle,
                             struct mapd_scratch *scratch,
                             struct mapd_path_segment *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);

/*
 The steps over lanes that follow each other, as `mapd_lane_sequences` lists them, from s [m] on the first to s on the last; each in its own
 driving direction, one for both directions in that which links ask for.

 Errors, by the number of the lane: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for one that does not follow the lane before.
 */
mapd_code mapd_steps_of_lanes(const struct mapd_snapshot *snapshot,
                              const struct mapd_lane_id *lanes,
                              size_t lane_count,
                              double s_from,
                              double s_to,
                              struct mapd_scratch *scratch,
                              struct mapd_route_step *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);

/*
 The part of a path's steps from S, `from`, to S, `to` [m]: what a new path over it is made of. `steps` are those that the path was made from.

 Errors: `MAPD_CODE_ARGUMENT` for steps that are not the path's, and where `from` is not less than `to`; `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_path_steps_between(const struct mapd_path *path,
                                  const struct mapd_route_step *steps,
                                  size_t step_count,
                                  double from,
                                  double to,
                                  struct mapd_scratch *scratch,
                                  struct mapd_route_step *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);

/*
 The way of a path on another snapshot, such as the next version of its map: its lanes are found by key, and where there is none or it lies elsewhere
 by their place. `out` gets the steps of the new route, for `mapd_path_new`, and `sum` what it comes to; null is fine. `changes` gets what has changed and where,
 in ascending S of the old path: nothing for a map on which all is the same. `MAPD_CODE_NONE` if no way leads along what is left of the path;
 `changes` are written nevertheless.

 Errors: `MAPD_CODE_CORRUPT`; `MAPD_CODE_ARGUMENT` for an unknown cost or class.
 */
mapd_code mapd_path_rebase(const struct mapd_path *path,
                           const struct mapd_snapshot *snapshot,
                           struct mapd_cost cost,
                           struct mapd_scratch *scratch,
                           struct mapd_route_sum *sum,
                           struct mapd_route_step *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_path_change *changes,
                           size_t changes_capacity,
                           size_t *changes_count,
                           struct mapd_error *error);

/*
 The next change of lane on a route, seen from a place on step number `at`. `MAPD_CODE_NONE` if the route needs no more.

 Errors: as `mapd_route`.
 */
mapd_code mapd_next_lane_change(const struct mapd_snapshot *snapshot,
                                const struct mapd_route_step *steps,
                                size_t step_count,
                                size_t at,
                                struct mapd_position_on_lane place,
                                struct mapd_scratch *scratch,
                                struct mapd_lane_change *out,
                                struct mapd_error *error);

/*
 The length of a route's steps along centre lines [m].

 Errors: as `mapd_route`.
 */
mapd_code mapd_steps_length(const struct mapd_snapshot *snapshot,
                            const struct mapd_route_step *steps,
                            size_t step_count,
                            double *out,
                            struct mapd_error *error);

/*
 The room along the path from S, `from` [m], on: a station every `step` [m] and one at the end, `length` [m] on or where the path ends.
 `vehicle` is a `MAPD_VEHICLE_CLASS_…`.

 Errors: `MAPD_CODE_NOT_FINITE` of `from` and `length`; `MAPD_CODE_ARGUMENT` for a step that is not positive or gives more than a million stations,
 and for an unknown class.
 */
mapd_code mapd_path_corridor(const struct mapd_path *path,
                             double from,
                             double length,
                             double step,
                             uint8_t vehicle,
                             struct mapd_scratch *scratch,
                             struct mapd_corridor_station *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);

/*
 The road's surface at the stations that `mapd_path_corridor` has for the same numbers.

 Errors: as `mapd_path_corridor`; `MAPD_CODE_CORRUPT`.
 */
mapd_code mapd_path_corridor_surface(const struct mapd_path *path,
                                     double from,
                                     double length,
                                     double step,
                                     struct mapd_scratch *scratch,
                                     struct mapd_corridor_surface *out,
                                     size_t capacity,
                                     size_t *count,
                                     struct mapd_error *error);

/*
 The room of stations as one polygon in plan view: along the right edges, then back along the left ones, counter-clockwise where it is simple and
 driven forwards, without the first point again at its end. `edges` is a `MAPD_CORRIDOR_EDGES_…`. `is_simple`: 1 where no two of its sides meet
 but neighbours in their common end; null is fine.

 Errors: `MAPD_CODE_ARGUMENT` for unknown edges.
 */
mapd_code mapd_corridor_outline(const struct mapd_corridor_station *stations,
                                size_t station_count,
                                uint32_t edges,
                                struct mapd_scratch *scratch,
                                struct mapd_vec2 *out,
                                size_t capacity,
                                size_t *count,
                                uint8_t *is_simple,
                                struct mapd_error *error);

/*
 Where other traffic meets the path, in ascending S: on lanes of junctions and others that the map knows to conflict, where lanes merge into
 one, and on roads that lie at the same place. What the path itself drives just before or behind is left out. Lanes that lead into each other are one conflict where what
 they have in common with the path touches; `lanes` gets all lanes, those of a conflict behind each other, and `lane_count` their number.

 Errors: `MAPD_CODE_TOO_SMALL` where either list is.
 */
mapd_code mapd_path_conflicts(const struct mapd_path *path,
                              struct mapd_scratch *scratch,
                              struct mapd_path_conflict *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_conflict_lane *lanes,
                              size_t lane_capacity,
                              size_t *lane_count,
                              struct mapd_error *error);

/*
 Who goes first at a conflict by what the file says, else by the rules of a country, by its two letters of ISO 3166-1 such as `DE`. That they hold
 there is for the caller to know. `lanes` are those of the conflict, from its `lanes_from` to its `lanes_to`: who yields to one yields. `yields` gets a `MAPD_YIELDS_…`, `basis` what that rests on, a `MAPD_BASIS_…`; null is fine. `MAPD_CODE_NONE`
 for a country whose rules are not known.
 */
mapd_code mapd_path_conflict_yields_by(const struct mapd_conflict_lane *lanes,
                                       size_t lane_count,
                                       const char *country,
                                       uint8_t *yields,
                                       uint8_t *basis,
                                       struct mapd_error *error);

/*
 The lanes on which traffic comes to a conflict of a path, back to a distance [m] from its first place on the other lanes, each by the shortest way,
 nearest first. `lanes` are those of the conflict, from its `lanes_from` to its `lanes_to`; those come first that none of the others leads to. Changes of lane are not among
 the ways. `vehicle`, a `MAPD_VEHICLE_CLASS_…`, is the class of who comes, not of who drives the path: lanes that are closed to it bring none, the other lanes neither.

 Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_conflict_approaches(const struct mapd_snapshot *snapshot,
                                   const struct mapd_conflict_lane *lanes,
                                   size_t lane_count,
                                   double distance,
                                   uint8_t vehicle,
                                   struct mapd_scratch *scratch,
                                   struct mapd_conflict_approach *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);

/*
 Crosswalks and bicycle crossings over the path, in ascending S, whether the file writes them as signals or as objects.
 */
mapd_code mapd_path_crossings(const struct mapd_path *path,
                              struct mapd_scratch *scratch,
                              struct mapd_path_crossing *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);

/*
 The snapshot's map under its overlay at a moment, `at_s` [s] since 1970-01-01 00:00 UTC; where nothing is laid over it, the map. It is cheap: make one
 for each cycle. Close it with `mapd_view_close`.

 Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for a moment that no clock has.
 */
mapd_code mapd_view_new(const struct mapd_snapshot *snapshot,
                        double at_s,
                        struct mapd_view **out,
                        struct mapd_error *error);

/*
 Closes a view and sets the handle to null. Null, or a handle that is null, is fine.
 */
void mapd_view_close(struct mapd_view **view);

/*
 Everything that the overlay says, whether it holds now or not, in the order in which it was given: entry k has the number k.
 */
mapd_code mapd_view_entries(const struct mapd_view *view,
                            struct mapd_overlay_entry *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 What holds now, wherever it does: each entry once for each piece of a lane, for each way in which that is travelled.
 */
mapd_code mapd_view_restrictions(const struct mapd_view *view,
                                 struct mapd_restriction *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 Entries that hold now at s of a lane, in its direction of travel, for any class of vehicles, in the order of the overlay.

 Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_view_restrictions_at(const struct mapd_view *view,
                                    struct mapd_lane_id lane,
                                    double s,
                                    struct mapd_restriction *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);

/*
 What holds now along a route or any list of steps, in its order: each entry once for each stretch on which it holds that a step drives over. `vehicle` is a
 `MAPD_VEHICLE_CLASS_…`.

 Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_view_restrictions_along(const struct mapd_view *view,
                                       const struct mapd_route_step *steps,
                                       size_t step_count,
                                       uint8_t vehicle,
                                       struct mapd_scratch *scratch,
                                       struct mapd_restriction *out,
                                       size_t capacity,
                                       size_t *count,
                                       struct mapd_error *error);

/*
 Whether a class of vehicles may use a lane at s, in its own direction: as `mapd_lane_allows_at`, unless an entry closes or opens it. What one entry
 closes no other opens.

 Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_view_allows(const struct mapd_view *view,
                           struct mapd_lane_id lane,
                           double s,
                           uint8_t vehicle,
                           struct mapd_permission *out,
                           struct mapd_error *error);

/*
 The speed limit at s of a lane for a class of vehicles: the lowest that an entry states, else as `mapd_lane_speed_rule_at`.

 Errors: as `mapd_view_allows`.
 */
mapd_code mapd_view_speed_rule_at(const struct mapd_view *view,
                                  struct mapd_lane_id lane,
                                  double s,
                                  uint8_t vehicle,
                                  struct mapd_speed_today *out,
                                  struct mapd_error *error);

/*
 Whether a class of vehicles may overtake at s of a lane: what signs forbid, as `mapd_lane_overtaking_rule_at`, and entries.

 Errors: as `mapd_view_allows`.
 */
mapd_code mapd_view_overtaking_rule_at(const struct mapd_view *view,
                                       struct mapd_lane_id lane,
                                       double s,
                                       uint8_t vehicle,
                                       struct mapd_overtaking_today *out,
                                       struct mapd_error *error);

/*
 The number of the entry by which a signal is out of service now. `MAPD_CODE_NONE` for one that is in service.

 Errors: `MAPD_CODE_FOREIGN_ID`.
 */
mapd_code mapd_view_signal_out_of_service(const struct mapd_view *view,
                                          struct mapd_signal_id signal,
                                          uint32_t *out,
                                          struct mapd_error *error);

/*
 What holds now for a class of vehicles along a path, in ascending S: each entry once for each stretch of a driven lane. The path itself is the map's: a
 lane that is closed stays where it is.

 Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_view_restrictions_on_path(const struct mapd_view *view,
                                         const struct mapd_path *path,
                                         uint8_t vehicle,
                                         struct mapd_path_restriction *out,
                                         size_t capacity,
                                         size_t *count,
                                         struct mapd_error *error);

/*
 The speed limit at S of a path, `along` [m], for a class of vehicles: the lowest that an entry states, else as `mapd_path_speed_at`.

 Errors: as `mapd_view_allows`; `MAPD_CODE_FOREIGN_ID` for a path on another map.
 */
mapd_code mapd_view_speed_on_path(const struct mapd_view *view,
                                  const struct mapd_path *path,
                                  double along,
                                  uint8_t vehicle,
                                  struct mapd_speed_today *out,
                                  struct mapd_error *error);

/*
 The speed limits along a path for a class of vehicles, in ascending S without gaps, each place as `mapd_view_speed_on_path` has it. `vehicle` is a
 `MAPD_VEHICLE_CLASS_…`.

 Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_view_speeds_on_path(const struct mapd_view *view,
                                   const struct mapd_path *path,
                                   uint8_t vehicle,
                                   struct mapd_path_speed_today *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);

/*
 As `mapd_path_travel_time` for a class of vehicles, at the limits of `mapd_view_speeds_on_path`. What is closed takes as long as if it were open:
 `mapd_view_restrictions_on_path` tells of it.

 Errors: as `mapd_path_travel_time`; `MAPD_CODE_FOREIGN_ID` for a path on another map; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_view_travel_time_on_path(const struct mapd_view *view,
                                        const struct mapd_path *path,
                                        double from,
                                        double to,
                                        uint8_t vehicle,
                                        struct mapd_path_time *out,
                                        struct mapd_error *error);

/*
 As `mapd_path_segments`, with the overlay's current entries applied: a lane that is closed is not entered, so that before it a change of lane is due; one that is
 opened may be.

 Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_view_segments_on_path(const struct mapd_view *view,
                                     const struct mapd_path *path,
                                     uint8_t vehicle,
                                     struct mapd_scratch *scratch,
                                     struct mapd_path_segment *out,
                                     size_t capacity,
                                     size_t *count,
                                     struct mapd_error *error);

/*
 As `mapd_path_conflicts`, with lights that are out of service now left out: where they would decide, signs do, then priorities of the file, then rules of the road.

 Errors: as `mapd_path_conflicts`; `MAPD_CODE_FOREIGN_ID` for a path on another map.
 */
mapd_code mapd_view_conflicts(const struct mapd_view *view,
                              const struct mapd_path *path,
                              struct mapd_scratch *scratch,
                              struct mapd_path_conflict *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_conflict_lane *lanes,
                              size_t lane_capacity,
                              size_t *lane_count,
                              struct mapd_error *error);

/*
 As `mapd_path_crossings`, with lights that are out of service now left out.

 Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map.
 */
mapd_code mapd_view_crossings(const struct mapd_view *view,
                              const struct mapd_path *path,
                              struct mapd_scratch *scratch,
                              struct mapd_path_crossing *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);

/*
 As `mapd_path_facts`, with today's permissions; a light that is out of service now governs nothing.

 Errors: `MAPD_CODE_FOREIGN_ID` for a path on another map.
 */
mapd_code mapd_view_facts(const struct mapd_view *view,
                          const struct mapd_path *path,
                          struct mapd_scratch *scratch,
                          struct mapd_path_fact *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 As `mapd_route`, with the overlay's current entries applied: closed stretches are not entered, opened ones may be, and times are those of today's speeds. The lane of the
 start may be closed.

 Errors: as `mapd_route`.
 */
mapd_code mapd_view_route(const struct mapd_view *view,
                          const struct mapd_position_on_lane *places,
                          size_t place_count,
                          struct mapd_cost cost,
                          struct mapd_scratch *scratch,
                          struct mapd_route_sum *sum,
                          struct mapd_route_step *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 As `mapd_reachable`, with the overlay's current entries applied. If the overlay cuts a node, the answer lists its pieces one by one.

 Errors: as `mapd_reachable`.
 */
mapd_code mapd_view_reachable(const struct mapd_view *view,
                              struct mapd_position_on_lane from,
                              double limit,
                              struct mapd_cost cost,
                              struct mapd_scratch *scratch,
                              struct mapd_reached_piece *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);

/*
 As `mapd_path_corridor`, with the overlay's current entries applied: beside the path a lane that is closed cannot be changed to and adds no room, and one that is opened
 may and does; the speeds are today's, with the origin `MAPD_SPEED_ORIGIN_OVERLAY` where an entry states them.

 Errors: as `mapd_path_corridor`; `MAPD_CODE_FOREIGN_ID` for a path on another map.
 */
mapd_code mapd_view_corridor(const struct mapd_view *view,
                             const struct mapd_path *path,
                             double from,
                             double length,
                             double step,
                             uint8_t vehicle,
                             struct mapd_scratch *scratch,
                             struct mapd_corridor_station *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);

/*
 As `mapd_signals_ahead`, with the overlay's current entries applied: ways through closed lanes are not followed. Signals that are out of service are among them;
 `mapd_view_signal_out_of_service` tells which are.

 Errors: as `mapd_signals_ahead`.
 */
mapd_code mapd_view_signals_ahead(const struct mapd_view *view,
                                  struct mapd_position_on_lane from,
                                  double distance,
                                  uint8_t vehicle,
                                  struct mapd_scratch *scratch,
                                  struct mapd_signal_ahead *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);

/*
 As `mapd_match_pose`, with the overlay's current entries applied: a lane that is closed to the options' vehicle, without one to passenger cars, has the prior of closed ones.

 Errors: as `mapd_match_pose`.
 */
mapd_code mapd_view_match_pose(const struct mapd_view *view,
                               struct mapd_vehicle_pose pose,
                               const double *covariance,
                               const struct mapd_match_options *options,
                               struct mapd_scratch *scratch,
                               struct mapd_lane_match *out,
                               size_t capacity,
                               size_t *count,
                               double *none,
                               struct mapd_error *error);

/*
 Proposes an entry of an overlay to the daemon that serves a map, and waits at most `wait_s` [s] for its decision. `prefix` as for
 `mapd_client_connect`. `source` is what the process calls itself: the daemon's policy names it. `entry` is JSON by
 schemas/overlay.schema.json; one of the same id is replaced, and so goes on to hold.

 Errors: `MAPD_CODE_REFUSED`, with the daemon's reason as the message; `MAPD_CODE_NO_DAEMON` if none takes proposals
 (`--overlay-from`); `MAPD_CODE_PERMISSION_DENIED`; `MAPD_CODE_LATE`, and it may still be taken; `MAPD_CODE_ARGUMENT` for a longer entry than
 64 KiB; `MAPD_CODE_TRANSPORT`.
 */
mapd_code mapd_propose(const char *map,
                       const char *prefix,
                       const char *source,
                       const char *entry,
                       double wait_s,
                       struct mapd_decision *out,
                       struct mapd_error *error);

/*
 Sets a request to its defaults: no starts and no goals. `size` is `sizeof(mapd_route_request)`.
 */
mapd_code mapd_route_request_init(struct mapd_route_request *request, size_t size, struct mapd_error *error);

/*
 Sets options to their defaults. `size` is `sizeof(mapd_alternative_options)`.
 */
mapd_code mapd_alternative_options_init(struct mapd_alternative_options *options,
                                        size_t size,
                                        struct mapd_error *error);

/*
 The cheapest way from any start of a request to any of its goals, in driving direction and by allowed lane changes only. `sum`: what it comes to, and from
 which start to which goal it leads; null is fine. `MAPD_CODE_NONE` if there is no way, and the count is 0.

 Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`, by the number of the start, goal or lane; `MAPD_CODE_ARGUMENT` for an unknown cost, class or
 direction.
 */
mapd_code mapd_find_route(const struct mapd_snapshot *snapshot,
                          const struct mapd_route_request *request,
                          struct mapd_scratch *scratch,
                          struct mapd_route_sum *sum,
                          struct mapd_route_step *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 As `mapd_find_route`, heeding what holds now.

 Errors: as `mapd_find_route`.
 */
mapd_code mapd_view_find_route(const struct mapd_view *view,
                               const struct mapd_route_request *request,
                               struct mapd_scratch *scratch,
                               struct mapd_route_sum *sum,
                               struct mapd_route_step *out,
                               size_t capacity,
                               size_t *count,
                               struct mapd_error *error);

/*
 The cheapest route of a request and alternatives to it, cheapest first. `sums` and `ends` have room for `capacity` routes each: what each comes to, and
 where its steps end in `out`. `options`: null is the default.

 Errors: as `mapd_find_route`; `MAPD_CODE_ARGUMENT` for options out of their domain.
 */
mapd_code mapd_alternatives(const struct mapd_snapshot *snapshot,
                            const struct mapd_route_request *request,
                            const struct mapd_alternative_options *options,
                            struct mapd_scratch *scratch,
                            struct mapd_route_sum *sums,
                            size_t *ends,
                            size_t capacity,
                            size_t *count,
                            struct mapd_route_step *out,
                            size_t step_capacity,
                            size_t *step_count,
                            struct mapd_error *error);

/*
 As `mapd_alternatives`, heeding what holds now.

 Errors: as `mapd_alternatives`.
 */
mapd_code mapd_view_alternatives(const struct mapd_view *view,
                                 const struct mapd_route_request *request,
                                 const struct mapd_alternative_options *options,
                                 struct mapd_scratch *scratch,
                                 struct mapd_route_sum *sums,
                                 size_t *ends,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_route_step *out,
                                 size_t step_capacity,
                                 size_t *step_count,
                                 struct mapd_error *error);

/*
 What can be reached from a request's starts within a cost, nearest first, with the ways on; with `to` not 0 from where its goals can be reached, and the
 ways back. What lies beyond the limit is not among the links.

 Errors: as `mapd_find_route`.
 */
mapd_code mapd_reach(const struct mapd_snapshot *snapshot,
                     const struct mapd_route_request *request,
                     double limit,
                     uint8_t to,
                     struct mapd_scratch *scratch,
                     struct mapd_reached_piece *out,
                     size_t capacity,
                     size_t *count,
                     struct mapd_reach_link *links,
                     size_t link_capacity,
                     size_t *link_count,
                     struct mapd_error *error);

/*
 As `mapd_reach`, heeding what holds now. Where the overlay cuts a node, each piece is told of by itself.

 Errors: as `mapd_reach`.
 */
mapd_code mapd_view_reach(const struct mapd_view *view,
                          const struct mapd_route_request *request,
                          double limit,
                          uint8_t to,
                          struct mapd_scratch *scratch,
                          struct mapd_reached_piece *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_reach_link *links,
                          size_t link_capacity,
                          size_t *link_count,
                          struct mapd_error *error);

/*
 What a junction is.
 */
mapd_code mapd_junction_facts_of(const struct mapd_snapshot *snapshot,
                                 struct mapd_junction_id junction,
                                 struct mapd_junction_facts *out,
                                 struct mapd_error *error);

/*
 Connections of a junction in file order.
 */
mapd_code mapd_junction_connections(const struct mapd_snapshot *snapshot,
                                    struct mapd_junction_id junction,
                                    struct mapd_connection *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);

/*
 What a signal is.
 */
mapd_code mapd_signal_facts_of(const struct mapd_snapshot *snapshot,
                               struct mapd_signal_id signal,
                               struct mapd_signal_facts *out,
                               struct mapd_error *error);

/*
 Signals that are for a lane, ascending in s; `which` is a `MAPD_LANE_SIGNALS_…`.

 Errors: `MAPD_CODE_ARGUMENT` for an unknown `which`.
 */
mapd_code mapd_lane_signals(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            uint32_t which,
                            struct mapd_lane_signal *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 The speed limit at s: sign before lane before road type before the header's regulations.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_speed_rule_at(const struct mapd_snapshot *snapshot,
                                  struct mapd_lane_id lane,
                                  double s,
                                  struct mapd_speed_rule *out,
                                  struct mapd_error *error);

/*
 The speed limits along the lane, in ascending s without gaps, each as `mapd_lane_speed_rule_at` has it between the ends of its stretch; where the limit depends on the way, with
 the lowest that may hold.
 */
mapd_code mapd_lane_speed_rules(const struct mapd_snapshot *snapshot,
                                struct mapd_lane_id lane,
                                struct mapd_speed_stretch *out,
                                size_t capacity,
                                size_t *count,
                                struct mapd_error *error);

/*
 Every signal that stands as near to a point as `radius` [m] in plan view, nearest first, whatever lanes it is for.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_signals_near(const struct mapd_snapshot *snapshot,
                            struct mapd_vec2 point,
                            double radius,
                            struct mapd_scratch *scratch,
                            struct mapd_near_signal *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 Every signal that stands in a rectangle in plan view, in the order of their rows.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_signals_in(const struct mapd_snapshot *snapshot,
                          struct mapd_region region,
                          struct mapd_scratch *scratch,
                          struct mapd_signal_id *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 Signals for traffic that goes on from a place without changing lanes, up to a distance [m] along any way, the nearest first. `vehicle` is a
 `MAPD_VEHICLE_CLASS_…`.

 Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
 */
mapd_code mapd_signals_ahead(const struct mapd_snapshot *snapshot,
                             struct mapd_position_on_lane from,
                             double distance,
                             uint8_t vehicle,
                             struct mapd_scratch *scratch,
                             struct mapd_signal_ahead *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);

/*
 Signals along a route, with distances from its start.

 Errors: as `mapd_signals_ahead`.
 */
mapd_code mapd_signals_along(const struct mapd_snapshot *snapshot,
                             const struct mapd_route_step *steps,
                             size_t step_count,
                             struct mapd_scratch *scratch,
                             struct mapd_signal_ahead *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);

/*
 Stop lines, lines to give way at, crosswalks and bicycle crossings along a route, nearest first, whether the file writes them as signals
 or as objects; one over several lanes stands once for each that is driven on.

 Errors: as `mapd_signals_ahead`.
 */
mapd_code mapd_lines_along(const struct mapd_snapshot *snapshot,
                           const struct mapd_route_step *steps,
                           size_t step_count,
                           struct mapd_scratch *scratch,
                           struct mapd_lane_line_at *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);

/*
 Where the movement through this lane of a junction leads: a `MAPD_TURN_…`.
 */
mapd_code mapd_lane_turn(const struct mapd_snapshot *snapshot,
                         struct mapd_lane_id lane,
                         uint8_t *out,
                         struct mapd_error *error);

/*
 Lanes from which the junction is entered on the way through this one.
 */
mapd_code mapd_lane_entries(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            struct mapd_lane_id *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 Lanes of the junction that the movement through this one goes over, first to last; itself where it is in no junction.
 */
mapd_code mapd_lane_movement_lanes(const struct mapd_snapshot *snapshot,
                                   struct mapd_lane_id lane,
                                   struct mapd_lane_id *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);

/*
 Lights that govern the movement through this lane of a junction.
 */
mapd_code mapd_lane_movement_lights(const struct mapd_snapshot *snapshot,
                                    struct mapd_lane_id lane,
                                    struct mapd_lane_signal *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);

/*
 Where the movement through this lane of a junction stops: at the marked line nearest to the junction, up to 30 m before it or on the movement's
 first lane; without one at its light. `MAPD_CODE_NONE` where neither is known.
 */
mapd_code mapd_lane_movement_stop(const struct mapd_snapshot *snapshot,
                                  struct mapd_lane_id lane,
                                  struct mapd_lane_line_at *out,
                                  struct mapd_error *error);

/*
 Lines on a lane, or that its movement passes; `which` is a `MAPD_LANE_LINES_…`.

 Errors: `MAPD_CODE_ARGUMENT` for an unknown `which`.
 */
mapd_code mapd_lane_lines(const struct mapd_snapshot *snapshot,
                          struct mapd_lane_id lane,
                          uint32_t which,
                          struct mapd_lane_line_at *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 Who goes first where this lane of a junction meets others, by what the file says: unknown where a rule of the road would have to say.
 */
mapd_code mapd_lane_right_of_way(const struct mapd_snapshot *snapshot,
                                 struct mapd_lane_id lane,
                                 struct mapd_right_of_way *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 As `mapd_lane_right_of_way` by what the file says, else by the rules of a country, by its two letters of ISO 3166-1 such as `DE`: that they hold there is
 for the caller to know. Where neither says, the relation is unknown. `MAPD_CODE_NONE` for a country whose rules are not known.
 */
mapd_code mapd_lane_right_of_way_by(const struct mapd_snapshot *snapshot,
                                    struct mapd_lane_id lane,
                                    const char *country,
                                    struct mapd_right_of_way *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);

/*
 First lanes of the movements through junctions that a light governs; none of what is no light. Looks at all places of signals of the map.
 */
mapd_code mapd_signal_movements(const struct mapd_snapshot *snapshot,
                                struct mapd_signal_id signal,
                                struct mapd_lane_id *out,
                                size_t capacity,
                                size_t *count,
                                struct mapd_error *error);

/*
 What an object is.
 */
mapd_code mapd_object_facts_of(const struct mapd_snapshot *snapshot,
                               struct mapd_object_id object,
                               struct mapd_object_facts *out,
                               struct mapd_error *error);

/*
 Every place where an object stands: its own, or those of its copies.
 */
mapd_code mapd_object_placements(const struct mapd_snapshot *snapshot,
                                 struct mapd_object_id object,
                                 struct mapd_placement_facts *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 An object where it stands.
 */
mapd_code mapd_placement_facts_of(const struct mapd_snapshot *snapshot,
                                  struct mapd_placement_id place,
                                  struct mapd_placement_facts *out,
                                  struct mapd_error *error);

/*
 Corners of the area that an object covers, at its foot, inertial [m].
 */
mapd_code mapd_placement_footprint(const struct mapd_snapshot *snapshot,
                                   struct mapd_placement_id place,
                                   struct mapd_scratch *scratch,
                                   struct mapd_vec3 *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);

/*
 Lanes that an object belongs to, nearer ones first.
 */
mapd_code mapd_object_lanes(const struct mapd_snapshot *snapshot,
                            struct mapd_object_id object,
                            struct mapd_object_lane *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 Objects that belong to a lane, in ascending s: crosswalks, stop lines, parking spaces, what stands beside it.
 */
mapd_code mapd_lane_objects(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            struct mapd_object_lane *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 Every place of an object whose area comes as near to a point as `radius` [m] in plan view, nearest first.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_objects_near(const struct mapd_snapshot *snapshot,
                            struct mapd_vec2 point,
                            double radius,
                            struct mapd_scratch *scratch,
                            struct mapd_near_object *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 Every place of an object whose area meets a rectangle in plan view, in the order of their rows.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_objects_in(const struct mapd_snapshot *snapshot,
                          struct mapd_region region,
                          struct mapd_scratch *scratch,
                          struct mapd_placement_id *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 The classes that localisers use.
 */
struct mapd_class_set mapd_class_set_landmarks(void);

/*
 Signals and places of objects of these classes as near to a point as `radius` [m] in plan view, nearest first; objects that move are left out.
 `classes`: null is what localisers use.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_landmarks_near(const struct mapd_snapshot *snapshot,
                              struct mapd_vec2 point,
                              double radius,
                              const struct mapd_class_set *classes,
                              struct mapd_scratch *scratch,
                              struct mapd_landmark *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);

/*
 As `mapd_landmarks_near`, in a rectangle: signals by row, then places of objects whose area meets it.
 */
mapd_code mapd_landmarks_in(const struct mapd_snapshot *snapshot,
                            struct mapd_region region,
                            const struct mapd_class_set *classes,
                            struct mapd_scratch *scratch,
                            struct mapd_landmark *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 What a sensor sees of the signals and places of objects of these classes, nearest first; objects that move are left out. Signals are seen from the front
 only, objects from all sides. What stands in between hides nothing. `classes`: null is what localisers use.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_landmarks_in_view(const struct mapd_snapshot *snapshot,
                                 struct mapd_sensor sensor,
                                 const struct mapd_class_set *classes,
                                 struct mapd_scratch *scratch,
                                 struct mapd_landmark_in_view *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 A lane's road marks in ascending s, those that hold somewhere in its section. The kind `none` is among them.
 */
mapd_code mapd_lane_road_marks(const struct mapd_snapshot *snapshot,
                               struct mapd_lane_id lane,
                               struct mapd_road_mark *out,
                               size_t capacity,
                               size_t *count,
                               struct mapd_error *error);

/*
 The road mark that holds at s; at a boundary the later one. `MAPD_CODE_NONE` before the first and beyond the section.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_road_mark_at(const struct mapd_snapshot *snapshot,
                                 struct mapd_lane_id lane,
                                 double s,
                                 struct mapd_road_mark *out,
                                 struct mapd_error *error);

/*
 Every piece of the borders of lanes of these types that meets a rectangle in plan view, each once, in the order of their lanes and of s.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_boundary_segments(const struct mapd_snapshot *snapshot,
                                 struct mapd_region region,
                                 uint64_t types,
                                 struct mapd_scratch *scratch,
                                 struct mapd_boundary_segment *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 Every piece of the road marks of lanes of these types that meets a rectangle in plan view, along the borders, without sway.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_mark_segments(const struct mapd_snapshot *snapshot,
                                  struct mapd_region region,
                                  uint64_t types,
                                  struct mapd_scratch *scratch,
                                  struct mapd_road_mark_segment *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);

/*
 Points along all paint and kerbs in a rectangle, at every multiple of `spacing` [m] of their road's s, of lines along objects from their beginning; 1 cm at
 least: the same ones whatever rectangle they are asked for by. Gaps of broken lines have none; where the file does not say which places are gaps, all
 have. Of the filter kinds, lane types and `objects` count; null is the default. In no particular order.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_mark_points(const struct mapd_snapshot *snapshot,
                           struct mapd_region region,
                           double spacing,
                           const struct mapd_mark_filter *filter,
                           struct mapd_scratch *scratch,
                           struct mapd_mark_point *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);

/*
 The surface at (s, t), with lateral shape, crossfall or cross-section surface, lane heights, and in a junction its elevation grid. s beyond
 the reference line is moved to its end and flagged.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_road_surface_at(const struct mapd_snapshot *snapshot,
                               struct mapd_road_id road,
                               double s,
                               double t,
                               struct mapd_surface *out,
                               struct mapd_error *error);

/*
 What a lane lies above the road's surface at s.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_height_at(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              double s,
                              struct mapd_lane_height *out,
                              struct mapd_error *error);

/*
 What a lane is made of at s. `MAPD_CODE_NONE` where the map does not say.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_lane_material_at(const struct mapd_snapshot *snapshot,
                                struct mapd_lane_id lane,
                                double s,
                                struct mapd_material *out,
                                struct mapd_error *error);

/*
 Height of a junction's elevation grid at a point in plan view, its edge held beyond it. `MAPD_CODE_NONE` without a grid.

 Errors: `MAPD_CODE_NOT_FINITE`.
 */
mapd_code mapd_junction_grid_height_at(const struct mapd_snapshot *snapshot,
                                       struct mapd_junction_id junction,
                                       struct mapd_vec2 point,
                                       struct mapd_grid_height *out,
                                       struct mapd_error *error);

/*
 All bridges and tunnels, by road.
 */
mapd_code mapd_structures(const struct mapd_snapshot *snapshot,
                          struct mapd_structure *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);

/*
 All references to objects of other roads, by referring road.
 */
mapd_code mapd_object_references(const struct mapd_snapshot *snapshot,
                                 struct mapd_object_reference *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 Parts of the document that are not in the map as written, in the order of the document. None of a map that was accepted whole.
 */
mapd_code mapd_quarantined_parts(const struct mapd_snapshot *snapshot,
                                 struct mapd_quarantined *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);

/*
 Those whose extent comes as near to a point as `radius` [m] in plan view: an answer about that place may lack them.
 */
mapd_code mapd_quarantined_near(const struct mapd_snapshot *snapshot,
                                struct mapd_vec2 point,
                                double radius,
                                struct mapd_quarantined *out,
                                size_t capacity,
                                size_t *count,
                                struct mapd_error *error);

/*
 Why the map has no part of this kind and id, or has a road without its lanes; `kind` is a `MAPD_QUARANTINED_KIND_…`. `MAPD_CODE_NONE` where the document
 has no such part, or the map has it.
 */
mapd_code mapd_left_out(const struct mapd_snapshot *snapshot,
                        uint8_t kind,
                        const char *id,
                        struct mapd_quarantined *out,
                        struct mapd_error *error);

/*
 All groups of junctions in file order: group k has the number k.
 */
mapd_code mapd_junction_groups(const struct mapd_snapshot *snapshot,
                               struct mapd_junction_group *out,
                               size_t capacity,
                               size_t *count,
                               struct mapd_error *error);

/*
 Junctions of a group in file order, by its number; those that the map does not have are left out.

 Errors: `MAPD_CODE_ARGUMENT` for a number that there is not.
 */
mapd_code mapd_junction_group_members(const struct mapd_snapshot *snapshot,
                                      uint32_t number,
                                      struct mapd_junction_id *out,
                                      size_t capacity,
                                      size_t *count,
                                      struct mapd_error *error);

/*
 Lanes of a roundabout's ring, by its group's number; none of other groups.

 Errors: `MAPD_CODE_ARGUMENT` for a number that there is not.
 */
mapd_code mapd_junction_group_ring(const struct mapd_snapshot *snapshot,
                                   uint32_t number,
                                   struct mapd_lane_id *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);

/*
 All controllers in file order: controller k has the number k.
 */
mapd_code mapd_controllers(const struct mapd_snapshot *snapshot,
                           struct mapd_controller *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);

/*
 Signals of a controller that the map has, in file order, by its number.

 Errors: `MAPD_CODE_ARGUMENT` for a number that there is not.
 */
mapd_code mapd_controller_signals(const struct mapd_snapshot *snapshot,
                                  uint32_t number,
                                  struct mapd_signal_id *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);

/*
 Numbers of the controllers that switch a signal.
 */
mapd_code mapd_signal_controllers(const struct mapd_snapshot *snapshot,
                                  struct mapd_signal_id signal,
                                  uint32_t *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);

/*
 Numbers of the controllers of a junction's synchronisation group, in file order; those that the map does not have are left out.
 */
mapd_code mapd_junction_controllers(const struct mapd_snapshot *snapshot,
                                    struct mapd_junction_id junction,
                                    uint32_t *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);

/*
 What a signal names; `which` is a `MAPD_SIGNAL_LINKS_…`.

 Errors: `MAPD_CODE_ARGUMENT` for an unknown `which`.
 */
mapd_code mapd_signal_links(const struct mapd_snapshot *snapshot,
                            struct mapd_signal_id signal,
                            uint32_t which,
                            struct mapd_signal_link *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);

/*
 What converts between this map's inertial frame and WGS 84. Close it with `mapd_projector_close`.

 Errors: `MAPD_CODE_NO_PROJECTION`.
 */
mapd_code mapd_projector_new(const struct mapd_snapshot *snapshot,
                             struct mapd_projector **out,
                             struct mapd_error *error);

/*
 What converts between the file's own frame and WGS 84, of a map that was compiled into another frame; else as `mapd_projector_new`.

 Errors: `MAPD_CODE_NO_PROJECTION`.
 */
mapd_code mapd_projector_of_file(const struct mapd_snapshot *snapshot,
                                 struct mapd_projector **out,
                                 struct mapd_error *error);

/*
 Closes a projector and sets the handle to null. Null, or a handle that is null, is fine.
 */
void mapd_projector_close(struct mapd_projector **projector);

/*
 Where a point of the map lies on Earth.

 Errors: `MAPD_CODE_NOT_FINITE`, `MAPD_CODE_OUTSIDE`.
 */
mapd_code mapd_to_geodetic(const struct mapd_projector *projector,
                           struct mapd_vec3 point,
                           struct mapd_geodetic *out,
                           struct mapd_error *error);

/*
 The point of the map at a place on Earth.

 Errors: `MAPD_CODE_NOT_FINITE`, `MAPD_CODE_NO_PLACE_ON_EARTH`, `MAPD_CODE_OUTSIDE`.
 */
mapd_code mapd_from_geodetic(const struct mapd_projector *projector,
                             struct mapd_geodetic place,
                             struct mapd_vec3 *out,
                             struct mapd_error *error);

/*
 As `mapd_to_geodetic`, of `count` points; `out` has room for as many.

 Errors: as `mapd_to_geodetic`, of the first point that has one; the answers before it are written.
 */
mapd_code mapd_to_geodetic_batch(const struct mapd_projector *projector,
                                 const struct mapd_vec3 *points,
                                 size_t count,
                                 struct mapd_geodetic *out,
                                 struct mapd_error *error);

/*
 As `mapd_from_geodetic`, of `count` places; `out` has room for as many.

 Errors: as `mapd_from_geodetic`, of the first place that has one; the answers before it are written.
 */
mapd_code mapd_from_geodetic_batch(const struct mapd_projector *projector,
                                   const struct mapd_geodetic *places,
                                   size_t count,
                                   struct mapd_vec3 *out,
                                   struct mapd_error *error);

/*
 Heading of true north at each of `count` points of the map [rad], counter-clockwise from x, in (−π, π]. A heading that a receiver gives clockwise
 from true north is this minus that one. `out` has room for as many.

 Errors: as `mapd_to_geodetic`, of the first point that has one; the answers before it are written.
 */
mapd_code mapd_north_at_batch(const struct mapd_projector *projector,
                              const struct mapd_vec3 *points,
                              size_t count,
                              double *out,
                              struct mapd_error *error);

/*
 East, north and up [m] of each of `count` points of the map, from `origin`, a point of the map: the topocentric frame, in the plane that touches
 the Earth there. `out` has room for as many.

 Errors: as `mapd_to_geodetic`, of the origin or the first point that has one; the answers before it are written.
 */
mapd_code mapd_to_enu_batch(const struct mapd_projector *projector,
                            struct mapd_vec3 origin,
                            const struct mapd_vec3 *points,
                            size_t count,
                            struct mapd_vec3 *out,
                            struct mapd_error *error);

/*
 The points of the map at each of `count` easts, norths and ups [m] from `origin`, a point of the map. `out` has room for as many.

 Errors: as `mapd_to_enu_batch`.
 */
mapd_code mapd_from_enu_batch(const struct mapd_projector *projector,
                              struct mapd_vec3 origin,
                              const struct mapd_vec3 *places,
                              size_t count,
                              struct mapd_vec3 *out,
                              struct mapd_error *error);

/*
 As `mapd_nearest_lane`, from a place on Earth through a projector of this map. The altitude counts where `has_altitude` is not 0.
 `MAPD_CODE_NONE` if no lane is within the radius.

 Errors: as `mapd_from_geodetic`.
 */
mapd_code mapd_nearest_lane_geodetic(const struct mapd_snapshot *snapshot,
                                     const struct mapd_projector *projector,
                                     struct mapd_geodetic place,
                                     uint8_t has_altitude,
                                     const struct mapd_nearest_options *options,
                                     struct mapd_nearest *out,
                                     struct mapd_error *error);

/*
 The word of a code, as OpenDRIVE or the vocabulary of classes has it; `unknown` for a code that this release does not know. `vocabulary`
 is a `MAPD_WORDS_…`. The text is there for ever.

 Errors: `MAPD_CODE_ARGUMENT` for an unknown vocabulary.
 */
mapd_code mapd_word(uint32_t vocabulary,
                    uint16_t code,
                    struct mapd_text *out,
                    struct mapd_error *error);

/*
 The release of the library, such as `0.1.0`. The text is there for ever.
 */
struct mapd_text mapd_version(void);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* MAPD_H */
