#ifndef MAPD_H
#define MAPD_H 
#include <stddef.h>
#include <stdint.h>
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
enum {
  MAPD_LANE_TYPE_NONE = 0,
  MAPD_LANE_TYPE_DRIVING = 1,
  MAPD_LANE_TYPE_STOP = 2,
  MAPD_LANE_TYPE_SHOULDER = 3,
  MAPD_LANE_TYPE_BIKING = 4,
  MAPD_LANE_TYPE_SIDEWALK = 5,
  MAPD_LANE_TYPE_WALKING = 6,
  MAPD_LANE_TYPE_BORDER = 7,
  MAPD_LANE_TYPE_RESTRICTED = 8,
  MAPD_LANE_TYPE_PARKING = 9,
  MAPD_LANE_TYPE_CURB = 10,
  MAPD_LANE_TYPE_BIDIRECTIONAL = 11,
  MAPD_LANE_TYPE_MEDIAN = 12,
  MAPD_LANE_TYPE_SPECIAL1 = 13,
  MAPD_LANE_TYPE_SPECIAL2 = 14,
  MAPD_LANE_TYPE_SPECIAL3 = 15,
  MAPD_LANE_TYPE_ROAD_WORKS = 16,
  MAPD_LANE_TYPE_TRAM = 17,
  MAPD_LANE_TYPE_RAIL = 18,
  MAPD_LANE_TYPE_ENTRY = 19,
  MAPD_LANE_TYPE_EXIT = 20,
  MAPD_LANE_TYPE_OFF_RAMP = 21,
  MAPD_LANE_TYPE_ON_RAMP = 22,
  MAPD_LANE_TYPE_CONNECTING_RAMP = 23,
  MAPD_LANE_TYPE_BUS = 24,
  MAPD_LANE_TYPE_TAXI = 25,
  MAPD_LANE_TYPE_HOV = 26,
  MAPD_LANE_TYPE_MWY_ENTRY = 27,
  MAPD_LANE_TYPE_MWY_EXIT = 28,
  MAPD_LANE_TYPE_SHARED = 29,
  MAPD_LANE_TYPE_SLIP_LANE = 30,
};
enum {
  MAPD_CLASS_NONE = 0,
  MAPD_CLASS_TRAFFIC_LIGHT = 10,
  MAPD_CLASS_PEDESTRIAN_LIGHT = 11,
  MAPD_CLASS_BICYCLE_LIGHT = 12,
  MAPD_CLASS_PUBLIC_TRANSPORT_LIGHT = 13,
  MAPD_CLASS_LANE_LIGHT = 14,
  MAPD_CLASS_WARNING_LIGHT = 15,
  MAPD_CLASS_LEVEL_CROSSING_LIGHT = 16,
  MAPD_CLASS_STOP = 20,
  MAPD_CLASS_YIELD = 21,
  MAPD_CLASS_PRIORITY_ROAD = 22,
  MAPD_CLASS_END_OF_PRIORITY_ROAD = 23,
  MAPD_CLASS_PRIORITY_AT_NEXT_JUNCTION = 24,
  MAPD_CLASS_YIELD_TO_ONCOMING = 25,
  MAPD_CLASS_PRIORITY_OVER_ONCOMING = 26,
  MAPD_CLASS_LEVEL_CROSSING = 27,
  MAPD_CLASS_ROUNDABOUT = 28,
  MAPD_CLASS_PRIORITY_TO_THE_RIGHT = 29,
  MAPD_CLASS_SPEED_LIMIT = 30,
  MAPD_CLASS_END_OF_SPEED_LIMIT = 31,
  MAPD_CLASS_SPEED_LIMIT_ZONE = 32,
  MAPD_CLASS_END_OF_SPEED_LIMIT_ZONE = 33,
  MAPD_CLASS_MINIMUM_SPEED = 34,
  MAPD_CLASS_END_OF_MINIMUM_SPEED = 35,
  MAPD_CLASS_ADVISORY_SPEED = 36,
  MAPD_CLASS_END_OF_ADVISORY_SPEED = 37,
  MAPD_CLASS_END_OF_RESTRICTIONS = 38,
  MAPD_CLASS_NO_OVERTAKING = 40,
  MAPD_CLASS_END_OF_NO_OVERTAKING = 41,
  MAPD_CLASS_NO_OVERTAKING_BY_TRUCKS = 42,
  MAPD_CLASS_END_OF_NO_OVERTAKING_BY_TRUCKS = 43,
  MAPD_CLASS_NO_ENTRY = 50,
  MAPD_CLASS_CLOSED_TO_VEHICLES = 51,
  MAPD_CLASS_CLOSED_TO_SOME = 52,
  MAPD_CLASS_MAXIMUM_WEIGHT = 53,
  MAPD_CLASS_MAXIMUM_HEIGHT = 54,
  MAPD_CLASS_MAXIMUM_WIDTH = 55,
  MAPD_CLASS_MAXIMUM_LENGTH = 56,
  MAPD_CLASS_NO_PARKING = 57,
  MAPD_CLASS_NO_STOPPING = 58,
  MAPD_CLASS_NO_LEFT_TURN = 59,
  MAPD_CLASS_NO_RIGHT_TURN = 60,
  MAPD_CLASS_NO_UTURN = 61,
  MAPD_CLASS_NO_TURN_ON_RED = 62,
  MAPD_CLASS_TURN_ON_RED = 63,
  MAPD_CLASS_NO_STRAIGHT_ON = 64,
  MAPD_CLASS_MINIMUM_DISTANCE = 65,
  MAPD_CLASS_MANDATORY_DIRECTION = 70,
  MAPD_CLASS_PASS_ON_SIDE = 71,
  MAPD_CLASS_ONE_WAY = 72,
  MAPD_CLASS_LANE_ASSIGNMENT = 73,
  MAPD_CLASS_BICYCLE_PATH = 74,
  MAPD_CLASS_FOOTPATH = 75,
  MAPD_CLASS_SHARED_PATH = 76,
  MAPD_CLASS_BUS_LANE = 77,
  MAPD_CLASS_MOTORWAY = 78,
  MAPD_CLASS_END_OF_MOTORWAY = 79,
  MAPD_CLASS_EXPRESSWAY = 80,
  MAPD_CLASS_END_OF_EXPRESSWAY = 81,
  MAPD_CLASS_TOWN = 82,
  MAPD_CLASS_END_OF_TOWN = 83,
  MAPD_CLASS_LIVING_STREET = 84,
  MAPD_CLASS_END_OF_LIVING_STREET = 85,
  MAPD_CLASS_PEDESTRIAN_ZONE = 86,
  MAPD_CLASS_PARKING_SIGN = 87,
  MAPD_CLASS_BUS_STOP = 88,
  MAPD_CLASS_PEDESTRIAN_CROSSING = 89,
  MAPD_CLASS_WARNING = 100,
  MAPD_CLASS_WARNING_ROAD_WORKS = 101,
  MAPD_CLASS_WARNING_CURVE = 102,
  MAPD_CLASS_WARNING_JUNCTION = 103,
  MAPD_CLASS_WARNING_TRAFFIC_LIGHT = 104,
  MAPD_CLASS_WARNING_PEDESTRIANS = 105,
  MAPD_CLASS_WARNING_BICYCLES = 106,
  MAPD_CLASS_WARNING_ANIMALS = 107,
  MAPD_CLASS_WARNING_LEVEL_CROSSING = 108,
  MAPD_CLASS_WARNING_NARROWING = 109,
  MAPD_CLASS_WARNING_SLIPPERY = 110,
  MAPD_CLASS_WARNING_SLOPE = 111,
  MAPD_CLASS_WARNING_ONCOMING = 112,
  MAPD_CLASS_WARNING_YIELD = 113,
  MAPD_CLASS_WARNING_CONGESTION = 114,
  MAPD_CLASS_GUIDE_SIGN = 120,
  MAPD_CLASS_INFORMATION_SIGN = 121,
  MAPD_CLASS_SUPPLEMENTARY_PLATE = 122,
  MAPD_CLASS_BOARD = 123,
  MAPD_CLASS_VARIABLE_MESSAGE_BOARD = 124,
  MAPD_CLASS_STREET_NAME = 125,
  MAPD_CLASS_DELINEATOR = 126,
  MAPD_CLASS_TRAFFIC_BARRIER_SIGN = 127,
  MAPD_CLASS_CROSSWALK = 140,
  MAPD_CLASS_STOP_LINE = 141,
  MAPD_CLASS_WAITING_LINE = 142,
  MAPD_CLASS_ARROW = 143,
  MAPD_CLASS_MARKING = 144,
  MAPD_CLASS_RESTRICTED_AREA = 145,
  MAPD_CLASS_BICYCLE_CROSSING = 146,
  MAPD_CLASS_SPEED_MARKING = 147,
  MAPD_CLASS_LANE_LINE = 148,
  MAPD_CLASS_PARKING_SPACE = 200,
  MAPD_CLASS_BARRIER = 201,
  MAPD_CLASS_RAILING = 202,
  MAPD_CLASS_SOUND_BARRIER = 203,
  MAPD_CLASS_POLE = 204,
  MAPD_CLASS_STREET_LAMP = 205,
  MAPD_CLASS_GANTRY = 206,
  MAPD_CLASS_TREE = 207,
  MAPD_CLASS_VEGETATION = 208,
  MAPD_CLASS_BUILDING = 209,
  MAPD_CLASS_BRIDGE = 210,
  MAPD_CLASS_TUNNEL = 211,
  MAPD_CLASS_OBSTACLE = 212,
  MAPD_CLASS_TRAFFIC_CONE = 213,
  MAPD_CLASS_TRAFFIC_ISLAND = 214,
  MAPD_CLASS_PATCH = 215,
  MAPD_CLASS_SURFACE = 216,
  MAPD_CLASS_VEHICLE = 217,
  MAPD_CLASS_PERSON = 218,
  MAPD_CLASS_WIND = 219,
  MAPD_CLASS_SIGN = 220,
  MAPD_CLASS_STREET_FURNITURE = 221,
  MAPD_CLASS_STATION = 222,
  MAPD_CLASS_PLATFORM = 223,
  MAPD_CLASS_GUARD_RAIL = 224,
};
enum {
  MAPD_VEHICLE_CLASS_PASSENGER_CAR = 0,
  MAPD_VEHICLE_CLASS_TRUCK = 1,
  MAPD_VEHICLE_CLASS_BUS = 2,
  MAPD_VEHICLE_CLASS_TAXI = 3,
  MAPD_VEHICLE_CLASS_MOTORCYCLE = 4,
  MAPD_VEHICLE_CLASS_EMERGENCY = 5,
  MAPD_VEHICLE_CLASS_DELIVERY = 6,
  MAPD_VEHICLE_CLASS_HOV = 7,
  MAPD_VEHICLE_CLASS_AUTONOMOUS = 8,
  MAPD_VEHICLE_CLASS_THROUGH = 9,
  MAPD_VEHICLE_CLASS_SIMULATOR = 10,
  MAPD_VEHICLE_CLASS_BICYCLE = 11,
  MAPD_VEHICLE_CLASS_PEDESTRIAN = 12,
  MAPD_VEHICLE_CLASS_TRAM = 13,
  MAPD_VEHICLE_CLASS_TRAIN = 14,
};
enum {
  MAPD_CONTACT_POINT_NONE = 0,
  MAPD_CONTACT_POINT_START = 1,
  MAPD_CONTACT_POINT_END = 2,
};
enum {
  MAPD_EDGE_KIND_WITHIN = 0,
  MAPD_EDGE_KIND_SECTION = 1,
  MAPD_EDGE_KIND_ROAD = 2,
  MAPD_EDGE_KIND_CONNECTION = 3,
  MAPD_EDGE_KIND_IMPLIED = 4,
  MAPD_EDGE_KIND_VIRTUAL = 5,
  MAPD_EDGE_KIND_CROSS_PATH = 6,
};
enum {
  MAPD_CONFLICT_KIND_CROSS = 0,
  MAPD_CONFLICT_KIND_MERGE = 1,
  MAPD_CONFLICT_KIND_OVERLAP = 2,
  MAPD_CONFLICT_KIND_CROSSING = 3,
};
enum {
  MAPD_ORIENTATION_BOTH = 0,
  MAPD_ORIENTATION_ALONG = 1,
  MAPD_ORIENTATION_AGAINST = 2,
};
enum {
  MAPD_SIGNAL_POSITION_TRACK = 0,
  MAPD_SIGNAL_POSITION_ROAD = 1,
  MAPD_SIGNAL_POSITION_INERTIAL = 2,
};
enum {
  MAPD_LANE_METHOD_VALIDITY = 0,
  MAPD_LANE_METHOD_ORIENTATION = 1,
  MAPD_LANE_METHOD_TRACK = 2,
  MAPD_LANE_METHOD_NEAREST = 3,
  MAPD_LANE_METHOD_ORIENTATION_GUESS = 4,
};
enum {
  MAPD_RELATION_YIELDS = 0,
  MAPD_RELATION_PRIORITY = 1,
  MAPD_RELATION_LIGHTS = 2,
  MAPD_RELATION_OPEN = 3,
};
enum {
  MAPD_RELATION_REASON_NONE = 0,
  MAPD_RELATION_REASON_LIGHTS = 1,
  MAPD_RELATION_REASON_STOP_SIGN = 2,
  MAPD_RELATION_REASON_YIELD_SIGN = 3,
  MAPD_RELATION_REASON_PRIORITY_ROAD = 4,
  MAPD_RELATION_REASON_JUNCTION_PRIORITY = 5,
  MAPD_RELATION_REASON_TURN = 6,
  MAPD_RELATION_REASON_FROM_THE_RIGHT = 7,
};
enum {
  MAPD_OBJECT_SHAPE_POINT = 0,
  MAPD_OBJECT_SHAPE_BOX = 1,
  MAPD_OBJECT_SHAPE_CYLINDER = 2,
  MAPD_OBJECT_SHAPE_OUTLINES = 3,
};
enum {
  MAPD_ROAD_MARK_KIND_NOT_GIVEN = 0,
  MAPD_ROAD_MARK_KIND_NONE = 1,
  MAPD_ROAD_MARK_KIND_SOLID = 2,
  MAPD_ROAD_MARK_KIND_BROKEN = 3,
  MAPD_ROAD_MARK_KIND_SOLID_SOLID = 4,
  MAPD_ROAD_MARK_KIND_SOLID_BROKEN = 5,
  MAPD_ROAD_MARK_KIND_BROKEN_SOLID = 6,
  MAPD_ROAD_MARK_KIND_BROKEN_BROKEN = 7,
  MAPD_ROAD_MARK_KIND_BOTTS_DOTS = 8,
  MAPD_ROAD_MARK_KIND_GRASS = 9,
  MAPD_ROAD_MARK_KIND_CURB = 10,
  MAPD_ROAD_MARK_KIND_CUSTOM = 11,
  MAPD_ROAD_MARK_KIND_EDGE = 12,
};
enum {
  MAPD_ROAD_MARK_COLOR_NOT_GIVEN = 0,
  MAPD_ROAD_MARK_COLOR_STANDARD = 1,
  MAPD_ROAD_MARK_COLOR_BLUE = 2,
  MAPD_ROAD_MARK_COLOR_GREEN = 3,
  MAPD_ROAD_MARK_COLOR_RED = 4,
  MAPD_ROAD_MARK_COLOR_WHITE = 5,
  MAPD_ROAD_MARK_COLOR_YELLOW = 6,
  MAPD_ROAD_MARK_COLOR_BLACK = 7,
  MAPD_ROAD_MARK_COLOR_ORANGE = 8,
  MAPD_ROAD_MARK_COLOR_VIOLET = 9,
};
enum {
  MAPD_ROAD_MARK_WEIGHT_NOT_GIVEN = 0,
  MAPD_ROAD_MARK_WEIGHT_STANDARD = 1,
  MAPD_ROAD_MARK_WEIGHT_BOLD = 2,
};
enum {
  MAPD_MARK_LANE_CHANGE_NOT_GIVEN = 0,
  MAPD_MARK_LANE_CHANGE_INCREASE = 1,
  MAPD_MARK_LANE_CHANGE_DECREASE = 2,
  MAPD_MARK_LANE_CHANGE_BOTH = 3,
  MAPD_MARK_LANE_CHANGE_NONE = 4,
};
enum {
  MAPD_ROAD_TYPE_NONE = 0,
  MAPD_ROAD_TYPE_RURAL = 1,
  MAPD_ROAD_TYPE_MOTORWAY = 2,
  MAPD_ROAD_TYPE_TOWN = 3,
  MAPD_ROAD_TYPE_LOW_SPEED = 4,
  MAPD_ROAD_TYPE_PEDESTRIAN = 5,
  MAPD_ROAD_TYPE_BICYCLE = 6,
  MAPD_ROAD_TYPE_TOWN_EXPRESSWAY = 7,
  MAPD_ROAD_TYPE_TOWN_COLLECTOR = 8,
  MAPD_ROAD_TYPE_TOWN_ARTERIAL = 9,
  MAPD_ROAD_TYPE_TOWN_PRIVATE = 10,
  MAPD_ROAD_TYPE_TOWN_LOCAL = 11,
  MAPD_ROAD_TYPE_TOWN_PLAY_STREET = 12,
  MAPD_ROAD_TYPE_STATED_UNKNOWN = 13,
};
enum {
  MAPD_STRUCTURE_KIND_BRIDGE = 0,
  MAPD_STRUCTURE_KIND_TUNNEL = 1,
};
enum {
  MAPD_OVERLAY_KIND_CLOSED = 0,
  MAPD_OVERLAY_KIND_OPEN = 1,
  MAPD_OVERLAY_KIND_SPEED = 2,
  MAPD_OVERLAY_KIND_NO_OVERTAKING = 3,
  MAPD_OVERLAY_KIND_WET = 4,
  MAPD_OVERLAY_KIND_ICY = 5,
  MAPD_OVERLAY_KIND_SIGNAL_OFF = 6,
  MAPD_OVERLAY_KIND_WARNING = 7,
  MAPD_OVERLAY_KIND_SNOW = 8,
  MAPD_OVERLAY_KIND_ROUGH = 9,
};
enum {
  MAPD_QUARANTINED_KIND_ROAD = 0,
  MAPD_QUARANTINED_KIND_JUNCTION = 1,
  MAPD_QUARANTINED_KIND_CONNECTION = 2,
  MAPD_QUARANTINED_KIND_OBJECT = 3,
  MAPD_QUARANTINED_KIND_SIGNAL = 4,
  MAPD_QUARANTINED_KIND_CONTROLLER = 5,
  MAPD_QUARANTINED_KIND_OTHER = 6,
  MAPD_QUARANTINED_KIND_LANE_LINK = 7,
};
enum {
  MAPD_JUNCTION_GROUP_KIND_NONE = 0,
  MAPD_JUNCTION_GROUP_KIND_ROUNDABOUT = 1,
  MAPD_JUNCTION_GROUP_KIND_OTHER = 2,
  MAPD_JUNCTION_GROUP_KIND_COMPLEX_JUNCTION = 3,
  MAPD_JUNCTION_GROUP_KIND_HIGHWAY_INTERCHANGE = 4,
};
#define MAPD_MESSAGE_SIZE 504
#define MAPD_NO_ROW UINT32_MAX
#define MAPD_CLAMPED_NO 0
#define MAPD_CLAMPED_BEFORE 1
#define MAPD_CLAMPED_AFTER 2
#define MAPD_EVENT_GENERATION 1
#define MAPD_EVENT_PENDING 2
#define MAPD_EVENT_DAEMON_GONE 3
#define MAPD_EVENT_DAEMON_BACK 4
#define MAPD_EVENT_OTHER 255
#define MAPD_ROAD_LINK_NONE 0
#define MAPD_ROAD_LINK_ROAD 1
#define MAPD_ROAD_LINK_JUNCTION 2
#define MAPD_ROAD_LINK_UNRESOLVED 3
#define MAPD_BESIDE_LEFT 0
#define MAPD_BESIDE_RIGHT 1
#define MAPD_BESIDE_INNER 2
#define MAPD_BESIDE_OPPOSITE 3
#define MAPD_BESIDE_LEFT_OF_REFERENCE_LINE 4
#define MAPD_BESIDE_RIGHT_OF_REFERENCE_LINE 5
#define MAPD_TRACKED_LANE 0
#define MAPD_TRACKED_NO_LANE 1
#define MAPD_TRACKED_UNKNOWN 2
#define MAPD_PAINTED_YES 1
#define MAPD_PAINTED_NO 0
#define MAPD_PAINTED_UNKNOWN 2
#define MAPD_LINE_CENTER 0
#define MAPD_LINE_LEFT 1
#define MAPD_LINE_RIGHT 2
#define MAPD_LINE_BORDER 3
#define MAPD_COST_LENGTH 0
#define MAPD_COST_TIME 1
#define MAPD_ENTER_START 0
#define MAPD_ENTER_AHEAD 1
#define MAPD_ENTER_LEFT 2
#define MAPD_ENTER_RIGHT 3
#define MAPD_PATH_FACT_JUNCTION 0
#define MAPD_PATH_FACT_SIGNAL 1
#define MAPD_PATH_FACT_LINE 2
#define MAPD_PATH_FACT_ROAD_TYPE 3
#define MAPD_PATH_FACT_LANE_TYPE 4
#define MAPD_PATH_FACT_STRUCTURE 5
#define MAPD_PATH_FACT_HOLE 6
#define MAPD_PATH_FACT_COUNTRY 7
#define MAPD_PATH_FACT_ACCESS 8
#define MAPD_PATH_FACT_OTHER 255
#define MAPD_PATH_CHANGE_MOVED 0
#define MAPD_PATH_CHANGE_REPLACED 1
#define MAPD_PATH_CHANGE_GONE 2
#define MAPD_PATH_EDGE_LANE 0
#define MAPD_PATH_EDGE_KERB 1
#define MAPD_PATH_EDGE_ROAD_END 2
#define MAPD_CORRIDOR_EDGES_DRIVEN 0
#define MAPD_CORRIDOR_EDGES_OPEN 1
#define MAPD_YIELDS_YIELDS 0
#define MAPD_YIELDS_PRIORITY 1
#define MAPD_YIELDS_LIGHTS 2
#define MAPD_YIELDS_UNKNOWN 3
#define MAPD_DIRECTION_EITHER 0
#define MAPD_DIRECTION_FORWARD 1
#define MAPD_DIRECTION_BACKWARD 2
#define MAPD_SPEED_ORIGIN_SIGNAL 0
#define MAPD_SPEED_ORIGIN_LANE 1
#define MAPD_SPEED_ORIGIN_ROAD_TYPE 2
#define MAPD_SPEED_ORIGIN_DEFAULT 3
#define MAPD_SPEED_ORIGIN_NONE 4
#define MAPD_SPEED_ORIGIN_ENTRY 5
#define MAPD_SPEED_ORIGIN_DEPENDS 6
#define MAPD_SPEED_ORIGIN_OVERLAY 7
#define MAPD_LANE_SIGNALS_ALL 0
#define MAPD_LANE_SIGNALS_LIGHTS 1
#define MAPD_LANE_SIGNALS_STOP_LINES 2
#define MAPD_LANE_SIGNALS_CROSSWALKS 3
#define MAPD_TURN_LEFT 1
#define MAPD_TURN_STRAIGHT 2
#define MAPD_TURN_RIGHT 4
#define MAPD_TURN_BACK 8
#define MAPD_BASIS_WRITTEN 0
#define MAPD_BASIS_RULE 1
#define MAPD_BASIS_UNKNOWN 2
#define MAPD_LANE_LINES_TO_STOP_AT 0
#define MAPD_LANE_LINES_CROSSINGS 1
#define MAPD_LANE_LINES_MOVEMENT_CROSSINGS 2
#define MAPD_SIGNAL_LINKS_DEPENDENCIES 0
#define MAPD_SIGNAL_LINKS_BELONGINGS 1
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
enum mapd_code : int32_t
#else
enum
#endif
{
  MAPD_CODE_OK = 0,
  MAPD_CODE_NONE = 1,
  MAPD_CODE_TOO_SMALL = 2,
  MAPD_CODE_NULL_POINTER = 10,
  MAPD_CODE_ARGUMENT = 11,
  MAPD_CODE_NOT_FINITE = 12,
  MAPD_CODE_FOREIGN_ID = 13,
  MAPD_CODE_CORRUPT = 14,
  MAPD_CODE_NO_DAEMON = 20,
  MAPD_CODE_NO_SUCH_MAP = 21,
  MAPD_CODE_NO_GENERATION = 22,
  MAPD_CODE_SUPERSEDED = 23,
  MAPD_CODE_WRONG_TRANSPORT = 24,
  MAPD_CODE_TOO_MANY_SUBSCRIBERS = 25,
  MAPD_CODE_TOO_MANY_PINNED = 26,
  MAPD_CODE_PERMISSION_DENIED = 27,
  MAPD_CODE_STUCK = 28,
  MAPD_CODE_BUSY = 29,
  MAPD_CODE_NO_ROOM = 30,
  MAPD_CODE_TRANSPORT = 31,
  MAPD_CODE_NAME = 32,
  MAPD_CODE_REFUSED = 33,
  MAPD_CODE_LATE = 34,
  MAPD_CODE_NO_DESCRIPTORS = 35,
  MAPD_CODE_NOT_AN_ARCHIVE = 40,
  MAPD_CODE_NOT_PROVEN = 41,
  MAPD_CODE_FILE = 42,
  MAPD_CODE_NOT_TRUSTED = 43,
  MAPD_CODE_NO_PROJECTION = 50,
  MAPD_CODE_OUTSIDE = 51,
  MAPD_CODE_NO_PLACE_ON_EARTH = 52,
  MAPD_CODE_OTHER = 98,
  MAPD_CODE_PANIC = 99,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum mapd_code mapd_code;
#else
typedef int32_t mapd_code;
#endif
#endif
typedef struct mapd_client mapd_client;
typedef struct mapd_events mapd_events;
typedef struct mapd_path mapd_path;
typedef struct mapd_projector mapd_projector;
typedef struct mapd_scratch mapd_scratch;
typedef struct mapd_snapshot mapd_snapshot;
typedef struct mapd_tracker mapd_tracker;
typedef struct mapd_view mapd_view;
typedef struct mapd_error {
  mapd_code code;
  uint32_t length;
  char message[MAPD_MESSAGE_SIZE];
} mapd_error;
typedef struct mapd_generation {
  uint64_t generation;
  uint64_t length;
} mapd_generation;
typedef struct mapd_event {
  uint32_t kind;
  uint32_t pid;
  uint64_t generation;
} mapd_event;
typedef struct mapd_text {
  const char *data;
  size_t size;
} mapd_text;
typedef struct mapd_vec3 {
  double x;
  double y;
  double z;
} mapd_vec3;
typedef struct mapd_map_facts {
  uint64_t generation;
  uint8_t content_hash[32];
  uint8_t source_hash[32];
  struct mapd_text name;
  struct mapd_text geo_reference;
  struct mapd_text projection;
  struct mapd_vec3 header_offset;
  double header_heading;
  struct mapd_vec3 low;
  struct mapd_vec3 high;
  double road_length;
  uint64_t content;
  uint32_t roads;
  uint32_t junctions;
  uint32_t signals;
  uint32_t objects;
  uint16_t revision_major;
  uint16_t revision_minor;
} mapd_map_facts;
typedef struct mapd_geodetic_bounds {
  double south;
  double north;
  double west;
  double east;
} mapd_geodetic_bounds;
typedef struct mapd_road_id {
  uint32_t row;
  uint32_t tile;
  uint64_t content;
} mapd_road_id;
typedef struct mapd_junction_id {
  uint32_t row;
  uint32_t tile;
  uint64_t content;
} mapd_junction_id;
typedef struct mapd_signal_id {
  uint32_t row;
  uint32_t tile;
  uint64_t content;
} mapd_signal_id;
typedef struct mapd_object_id {
  uint32_t row;
  uint32_t tile;
  uint64_t content;
} mapd_object_id;
typedef struct mapd_lane_id {
  uint32_t row;
  uint32_t tile;
  uint64_t content;
} mapd_lane_id;
typedef struct mapd_lane_position {
  double s;
  double t;
  double offset;
  double offset_of_reference_line;
  double distance;
  double z;
  double heading;
  double heading_of_reference_line;
  uint8_t clamped;
} mapd_lane_position;
typedef struct mapd_nearest {
  struct mapd_lane_id lane;
  struct mapd_lane_position position;
} mapd_nearest;
typedef struct mapd_nearest_options {
  size_t size;
  double radius;
  uint64_t types;
  double z_tolerance;
  double heading;
  double heading_tolerance;
  uint8_t has_z_tolerance;
  uint8_t has_heading;
  uint8_t has_heading_tolerance;
  uint8_t has_vehicle;
  uint8_t vehicle;
  const struct mapd_nearest *hint;
} mapd_nearest_options;
typedef struct mapd_point {
  double x;
  double y;
  double z;
  uint64_t has_z;
} mapd_point;
typedef struct mapd_vec2 {
  double x;
  double y;
} mapd_vec2;
typedef struct mapd_region {
  struct mapd_vec2 low;
  struct mapd_vec2 high;
} mapd_region;
typedef struct mapd_road_link {
  struct mapd_road_id road;
  struct mapd_junction_id junction;
  uint8_t kind;
  uint8_t contact;
} mapd_road_link;
typedef struct mapd_road_facts {
  struct mapd_road_id road;
  struct mapd_junction_id junction;
  struct mapd_text id;
  struct mapd_text name;
  double length;
  double reference_end;
  struct mapd_road_link predecessor;
  struct mapd_road_link successor;
  uint32_t sections;
  uint32_t line;
  uint32_t column;
  uint8_t is_left_hand_traffic;
} mapd_road_facts;
typedef struct mapd_track {
  double s;
  double t;
  double h;
} mapd_track;
typedef struct mapd_pose {
  struct mapd_vec3 position;
  double heading;
  double curvature;
  double slope;
  double superelevation;
  uint8_t clamped;
} mapd_pose;
typedef struct mapd_track_position {
  double s;
  double t;
  double h;
  double distance;
  uint8_t has_h;
  uint8_t clamped;
  uint8_t exact;
} mapd_track_position;
typedef struct mapd_lane_facts {
  struct mapd_lane_id lane;
  struct mapd_road_id road;
  struct mapd_junction_id junction;
  double s_start;
  double s_end;
  int32_t number;
  uint32_t section;
  uint8_t kind;
  uint8_t is_drivable;
  uint8_t is_forward;
  uint8_t is_bidirectional;
  uint8_t is_temporary;
  uint8_t continues;
} mapd_lane_facts;
typedef struct mapd_waypoint {
  double s;
  struct mapd_vec3 position;
  double heading;
  double width;
  uint8_t clamped;
} mapd_waypoint;
typedef struct mapd_lane_edges {
  double inner;
  double outer;
} mapd_lane_edges;
typedef struct mapd_lane_bounds {
  struct mapd_vec3 left;
  struct mapd_vec3 right;
} mapd_lane_bounds;
typedef struct mapd_overtaking_rule {
  struct mapd_signal_id all;
  struct mapd_signal_id trucks;
} mapd_overtaking_rule;
typedef struct mapd_vehicle_outline {
  double front;
  double back;
  double left;
  double right;
} mapd_vehicle_outline;
typedef struct mapd_match_options {
  size_t size;
  uint64_t types;
  double z_tolerance;
  double drive_deviation;
  double none;
  double closed;
  double unexpected;
  const struct mapd_lane_id *expected;
  size_t expected_count;
  uint8_t has_z_tolerance;
  uint8_t has_vehicle;
  uint8_t vehicle;
  struct mapd_vehicle_outline outline;
} mapd_match_options;
typedef struct mapd_trace_options {
  size_t size;
  double deviation;
  double heading_deviation;
  double change_interval;
  uint64_t types;
  uint8_t vehicle;
} mapd_trace_options;
typedef struct mapd_vehicle_pose {
  struct mapd_point position;
  double heading;
} mapd_vehicle_pose;
typedef struct mapd_lane_match {
  struct mapd_lane_id lane;
  struct mapd_lane_position position;
  double probability;
  double mahalanobis;
  double heading_difference;
  uint8_t forward;
} mapd_lane_match;
typedef struct mapd_trace_fix {
  double time;
  struct mapd_point position;
  double heading;
  uint8_t has_heading;
} mapd_trace_fix;
typedef struct mapd_trace_match {
  struct mapd_lane_id lane;
  struct mapd_lane_position position;
  double probability;
  uint8_t forward;
} mapd_trace_match;
typedef struct mapd_tracker_options {
  size_t size;
  const struct mapd_match_options *matching;
  double change_interval;
  double correlation_time;
  double memory;
  double enough;
} mapd_tracker_options;
typedef struct mapd_tracker_fix {
  double time;
  struct mapd_vehicle_pose pose;
  double covariance[9];
  double odometer;
  uint8_t has_odometer;
} mapd_tracker_fix;
typedef struct mapd_tracked {
  struct mapd_lane_match found;
  uint8_t state;
} mapd_tracked;
typedef struct mapd_material {
  double s;
  struct mapd_text surface;
  double friction;
  double roughness;
} mapd_material;
typedef struct mapd_ground {
  double z;
  struct mapd_vec3 normal;
  struct mapd_lane_id lane;
  double s;
  double t;
  struct mapd_material material;
  uint32_t level;
  uint32_t levels;
  uint8_t has_material;
} mapd_ground;
typedef struct mapd_stance {
  double z;
  double roll;
  double pitch;
  double wheels[4];
  uint8_t has_wheel[4];
} mapd_stance;
typedef struct mapd_mark_filter {
  size_t size;
  double radius;
  uint64_t kinds;
  uint64_t types;
  uint8_t objects;
} mapd_mark_filter;
typedef struct mapd_near_mark {
  struct mapd_lane_id lane;
  double s;
  struct mapd_vec2 place;
  double distance;
  double width;
  uint8_t left_of_reference_line;
  uint8_t kind;
  uint8_t color;
  uint8_t painted;
} mapd_near_mark;
typedef struct mapd_line_point {
  double s;
  struct mapd_vec3 position;
} mapd_line_point;
typedef struct mapd_node_id {
  uint32_t row;
  uint32_t tile;
  uint64_t content;
} mapd_node_id;
typedef struct mapd_node_facts {
  struct mapd_node_id node;
  struct mapd_lane_id lane;
  double s_low;
  double s_high;
  double length;
  double travel_time;
  struct mapd_node_id left;
  struct mapd_node_id right;
  struct mapd_node_id change_left;
  struct mapd_node_id change_right;
  uint32_t component;
  uint32_t access;
  uint8_t is_forward;
} mapd_node_facts;
typedef struct mapd_edge {
  struct mapd_node_id target;
  uint8_t kind;
  uint8_t closes_loop;
  uint32_t line;
  uint32_t column;
} mapd_edge;
typedef struct mapd_conflict {
  struct mapd_lane_id other;
  double s_low;
  double s_high;
  double other_low;
  double other_high;
  uint8_t kind;
} mapd_conflict;
typedef struct mapd_position_on_lane {
  struct mapd_lane_id lane;
  double s;
} mapd_position_on_lane;
typedef struct mapd_cost {
  uint32_t by;
  uint32_t vehicle;
  double lane_change;
  const double *factors;
  size_t factor_count;
} mapd_cost;
typedef struct mapd_route_sum {
  double cost;
  double length;
  double travel_time;
  double assumed_time;
  uint32_t lane_changes;
  uint32_t start;
  uint32_t goal;
} mapd_route_sum;
typedef struct mapd_route_step {
  struct mapd_lane_id lane;
  double s_from;
  double s_to;
  double s_latest;
  uint8_t forward;
  uint8_t enter;
} mapd_route_step;
typedef struct mapd_reached {
  struct mapd_node_id node;
  double cost;
} mapd_reached;
typedef struct mapd_reached_piece {
  struct mapd_lane_id lane;
  double s_from;
  double s_to;
  double cost;
  uint32_t lane_changes;
  uint8_t forward;
} mapd_reached_piece;
typedef struct mapd_reach_link {
  size_t from;
  size_t to;
  uint8_t enter;
} mapd_reach_link;
typedef struct mapd_next_junction {
  struct mapd_junction_id junction;
  double distance;
} mapd_next_junction;
typedef struct mapd_path_options {
  size_t size;
  double broken_gap;
  double broken_kink;
  double change_length;
  double shortest_change;
  double change_delay;
  uint8_t vehicle;
} mapd_path_options;
typedef struct mapd_path_point {
  double along;
  struct mapd_vec3 position;
  double heading;
  double curvature;
  double curvature_rate;
  double grade;
  double superelevation;
  double left;
  double right;
  struct mapd_lane_id lane;
  double s;
  uint8_t forward;
  uint8_t clamped;
} mapd_path_point;
typedef struct mapd_path_position {
  double along;
  double d;
  double distance;
  double heading;
  struct mapd_lane_id lane;
  double s;
  uint8_t clamped;
} mapd_path_position;
typedef struct mapd_speed_rule {
  double max;
  struct mapd_signal_id signal;
  uint8_t has_max;
  uint8_t origin;
} mapd_speed_rule;
typedef struct mapd_path_joint {
  double along;
  double gap;
  double kink;
  uint8_t enter;
  uint8_t broken;
  uint8_t is_short;
} mapd_path_joint;
typedef struct mapd_path_lane {
  struct mapd_lane_id lane;
  double along_from;
  double along_to;
  double s_from;
  double s_to;
  size_t step;
  uint8_t forward;
} mapd_path_lane;
typedef struct mapd_lane_line_at {
  struct mapd_signal_id signal;
  struct mapd_object_id object;
  struct mapd_lane_id lane;
  double s;
  double distance;
  uint16_t class_code;
} mapd_lane_line_at;
typedef struct mapd_path_fact {
  double along_from;
  double along_to;
  struct mapd_lane_id lane;
  struct mapd_junction_id junction;
  struct mapd_signal_id signal;
  struct mapd_lane_line_at line;
  struct mapd_vec3 left;
  struct mapd_vec3 right;
  uint32_t number;
  uint8_t code;
  uint8_t kind;
  uint8_t governs;
} mapd_path_fact;
typedef struct mapd_path_speed {
  double along_from;
  double along_to;
  struct mapd_speed_rule rule;
} mapd_path_speed;
typedef struct mapd_path_time {
  double time;
  double unlimited;
} mapd_path_time;
typedef struct mapd_path_segment {
  double along_from;
  double along_to;
  struct mapd_lane_id lane;
  double last_change;
  double lane_end;
  uint32_t changes;
  uint8_t forward;
  uint8_t driven;
} mapd_path_segment;
typedef struct mapd_path_change {
  double along_from;
  double along_to;
  double distance;
  uint32_t kind;
} mapd_path_change;
typedef struct mapd_lane_change {
  size_t step;
  double from;
  double until;
  uint8_t left;
} mapd_lane_change;
typedef struct mapd_edge_mark {
  uint8_t kind;
  uint8_t color;
  uint8_t may_cross;
  uint8_t edge;
} mapd_edge_mark;
typedef struct mapd_corridor_station {
  double along;
  struct mapd_lane_id lane;
  double s;
  struct mapd_vec3 left;
  struct mapd_vec3 right;
  struct mapd_vec3 outer_left;
  struct mapd_vec3 outer_right;
  struct mapd_speed_rule speed;
  struct mapd_edge_mark left_mark;
  struct mapd_edge_mark right_mark;
  struct mapd_edge_mark outer_left_mark;
  struct mapd_edge_mark outer_right_mark;
} mapd_corridor_station;
typedef struct mapd_corridor_surface {
  struct mapd_vec3 position;
  struct mapd_vec3 normal;
  double friction;
  double roughness;
} mapd_corridor_surface;
typedef struct mapd_path_conflict {
  double along_from;
  double along_to;
  struct mapd_lane_id other;
  double other_s_from;
  double other_s_to;
  double wait;
  uint32_t lanes_from;
  uint32_t lanes_to;
  uint8_t kind;
  uint8_t yields;
  uint8_t reason;
} mapd_path_conflict;
typedef struct mapd_conflict_lane {
  double along_from;
  double along_to;
  struct mapd_lane_id other;
  double other_s_from;
  double other_s_to;
  double wait;
  uint8_t kind;
  uint8_t yields;
  uint8_t reason;
  uint8_t relation;
  uint8_t equal_roads;
} mapd_conflict_lane;
typedef struct mapd_conflict_approach {
  struct mapd_lane_id lane;
  double s_from;
  double s_to;
  double distance_from;
  double distance_to;
  uint8_t forward;
} mapd_conflict_approach;
typedef struct mapd_path_crossing {
  double along_from;
  double along_to;
  double wait;
  struct mapd_lane_line_at line;
  uint8_t yields;
} mapd_path_crossing;
typedef struct mapd_overlay_entry {
  struct mapd_text id;
  struct mapd_text source;
  struct mapd_text text;
  double value;
  double confidence;
  uint64_t vehicles;
  uint32_t number;
  uint8_t kind;
  uint8_t holds;
} mapd_overlay_entry;
typedef struct mapd_restriction {
  struct mapd_lane_id lane;
  double s_from;
  double s_to;
  uint32_t entry;
} mapd_restriction;
typedef struct mapd_permission {
  struct mapd_restriction restriction;
  uint8_t is_allowed;
} mapd_permission;
typedef struct mapd_speed_today {
  double max;
  struct mapd_speed_rule map;
  struct mapd_restriction restriction;
  uint8_t has_max;
} mapd_speed_today;
typedef struct mapd_overtaking_today {
  struct mapd_overtaking_rule map;
  struct mapd_restriction restriction;
  uint8_t is_forbidden;
} mapd_overtaking_today;
typedef struct mapd_path_restriction {
  double along_from;
  double along_to;
  struct mapd_restriction restriction;
} mapd_path_restriction;
typedef struct mapd_path_speed_today {
  double along_from;
  double along_to;
  struct mapd_speed_today today;
} mapd_path_speed_today;
typedef struct mapd_signal_ahead {
  struct mapd_signal_id signal;
  struct mapd_lane_id lane;
  double distance;
  double s;
} mapd_signal_ahead;
typedef struct mapd_decision {
  uint8_t is_accepted;
  uint32_t agree;
  uint32_t needed;
} mapd_decision;
typedef struct mapd_route_end {
  struct mapd_lane_id lane;
  double s;
  double cost;
  uint8_t direction;
} mapd_route_end;
typedef struct mapd_route_request {
  size_t size;
  const struct mapd_route_end *starts;
  size_t start_count;
  const struct mapd_route_end *goals;
  size_t goal_count;
  const struct mapd_lane_id *avoid;
  size_t avoid_count;
  struct mapd_cost cost;
  double turn_left;
  double turn_right;
  double turn_back;
} mapd_route_request;
typedef struct mapd_alternative_options {
  size_t size;
  size_t count;
  double share;
  double longest;
} mapd_alternative_options;
typedef struct mapd_junction_facts {
  struct mapd_junction_id junction;
  struct mapd_text id;
  struct mapd_text name;
  size_t connections;
} mapd_junction_facts;
typedef struct mapd_connection {
  struct mapd_text id;
  struct mapd_road_id incoming_road;
  struct mapd_road_id connecting_road;
  uint8_t contact;
} mapd_connection;
typedef struct mapd_signal_facts {
  struct mapd_signal_id signal;
  struct mapd_road_id road;
  struct mapd_signal_id carrier;
  struct mapd_text id;
  struct mapd_text name;
  struct mapd_text country;
  struct mapd_text country_revision;
  struct mapd_text kind;
  struct mapd_text subtype;
  struct mapd_text text;
  struct mapd_text unit;
  double written_value;
  double value;
  struct mapd_vec3 position;
  double facing;
  double pitch;
  double roll;
  double s;
  double t;
  double width;
  double height;
  double length;
  uint16_t class_code;
  uint8_t orientation;
  uint8_t position_source;
  uint8_t has_written_value;
  uint8_t has_value;
  uint8_t is_dynamic;
  uint8_t is_temporary;
  uint8_t is_invalidated;
  uint8_t bulbs;
  uint8_t phases;
  uint8_t arrows;
} mapd_signal_facts;
typedef struct mapd_lane_signal {
  struct mapd_signal_id signal;
  struct mapd_lane_id lane;
  double s;
  double t;
  double distance;
  uint16_t class_code;
  uint8_t method;
  uint8_t is_for_forward;
  uint8_t is_for_backward;
} mapd_lane_signal;
typedef struct mapd_speed_stretch {
  double s_low;
  double s_high;
  struct mapd_speed_rule rule;
  double lowest;
  uint8_t has_lowest;
} mapd_speed_stretch;
typedef struct mapd_near_signal {
  struct mapd_signal_id signal;
  double distance;
} mapd_near_signal;
typedef struct mapd_right_of_way {
  struct mapd_lane_id other;
  uint8_t relation;
  uint8_t reason;
  uint8_t basis;
} mapd_right_of_way;
typedef struct mapd_object_facts {
  struct mapd_object_id object;
  struct mapd_road_id road;
  struct mapd_junction_id junction;
  struct mapd_text id;
  struct mapd_text name;
  struct mapd_text kind;
  struct mapd_text subtype;
  double s;
  double t;
  double z_offset;
  double valid_length;
  uint32_t placements;
  uint16_t class_code;
  uint8_t shape;
  uint8_t orientation;
  uint8_t is_dynamic;
  uint8_t is_repeated;
  uint8_t is_temporary;
  uint8_t is_invalidated;
  uint8_t is_clamped;
  uint8_t is_parking_space;
  uint8_t has_value;
  double value;
  struct mapd_text assumed_unit;
  struct mapd_text parking_access;
  struct mapd_text parking_restrictions;
} mapd_object_facts;
typedef struct mapd_placement_id {
  struct mapd_object_id object;
  uint32_t copy;
} mapd_placement_id;
typedef struct mapd_placement_facts {
  struct mapd_placement_id place;
  struct mapd_vec3 position;
  double heading;
  double pitch;
  double roll;
  double length;
  double width;
  double height;
  double radius;
  double s;
  double t;
  uint8_t is_swept;
} mapd_placement_facts;
typedef struct mapd_object_lane {
  struct mapd_object_id object;
  struct mapd_lane_id lane;
  double s_low;
  double s_high;
  double distance;
  uint8_t method;
} mapd_object_lane;
typedef struct mapd_near_object {
  struct mapd_placement_id place;
  double distance;
} mapd_near_object;
typedef struct mapd_class_set {
  uint64_t words[4];
} mapd_class_set;
typedef struct mapd_landmark {
  struct mapd_signal_id signal;
  struct mapd_placement_id place;
  uint16_t class_code;
  struct mapd_vec3 position;
  double heading;
  double pitch;
  double roll;
  double length;
  double width;
  double height;
  double distance;
} mapd_landmark;
typedef struct mapd_sensor {
  struct mapd_vec2 position;
  double heading;
  double range;
  double field_of_view;
} mapd_sensor;
typedef struct mapd_landmark_in_view {
  struct mapd_landmark landmark;
  double bearing;
  double facing;
} mapd_landmark_in_view;
typedef struct mapd_road_mark {
  double s;
  double s_end;
  double width;
  double width_or_default;
  double height;
  uint8_t kind;
  uint8_t color;
  uint8_t weight;
  uint8_t lane_change;
} mapd_road_mark;
typedef struct mapd_boundary_segment {
  struct mapd_lane_id lane;
  double s_from;
  double s_to;
  struct mapd_vec3 from;
  struct mapd_vec3 to;
} mapd_boundary_segment;
typedef struct mapd_road_mark_segment {
  struct mapd_boundary_segment segment;
  double width;
  uint8_t kind;
  uint8_t color;
} mapd_road_mark_segment;
typedef struct mapd_mark_point {
  struct mapd_vec3 position;
  struct mapd_lane_id lane;
  double s;
  double width;
  uint8_t kind;
  uint8_t color;
  uint8_t is_outline;
  struct mapd_placement_id place;
} mapd_mark_point;
typedef struct mapd_surface {
  struct mapd_vec3 position;
  struct mapd_vec3 normal;
  struct mapd_lane_id lane;
  struct mapd_material material;
  uint8_t has_material;
  uint8_t clamped;
} mapd_surface;
typedef struct mapd_lane_height {
  double inner;
  double outer;
} mapd_lane_height;
typedef struct mapd_grid_height {
  double z;
  double by_x;
  double by_y;
} mapd_grid_height;
typedef struct mapd_structure {
  struct mapd_text id;
  struct mapd_text name;
  struct mapd_text type_name;
  struct mapd_road_id road;
  double s_from;
  double s_to;
  double lighting;
  double daylight;
  int32_t lane_from;
  int32_t lane_to;
  uint8_t has_lanes;
  uint8_t kind;
} mapd_structure;
typedef struct mapd_object_reference {
  struct mapd_text id;
  struct mapd_object_id object;
  struct mapd_road_id road;
  double s;
  double t;
  double z_offset;
  double valid_length;
  uint8_t orientation;
} mapd_object_reference;
typedef struct mapd_quarantined {
  struct mapd_text id;
  struct mapd_text owner;
  struct mapd_text rule;
  struct mapd_text message;
  struct mapd_text file;
  struct mapd_region extent;
  double length;
  uint32_t line;
  uint32_t column;
  uint8_t kind;
  uint8_t owner_kind;
  uint8_t is_reference_line;
  uint8_t has_extent;
} mapd_quarantined;
typedef struct mapd_junction_group {
  struct mapd_text id;
  struct mapd_text name;
  uint8_t kind;
} mapd_junction_group;
typedef struct mapd_controller {
  struct mapd_text id;
  struct mapd_text name;
  int32_t sequence;
} mapd_controller;
typedef struct mapd_signal_link {
  struct mapd_text id;
  struct mapd_text kind;
  struct mapd_signal_id signal;
  struct mapd_object_id object;
  uint8_t is_object;
} mapd_signal_link;
typedef struct mapd_geodetic {
  double latitude;
  double longitude;
  double altitude;
} mapd_geodetic;
#ifdef __cplusplus
extern "C" {
#endif
mapd_code mapd_scratch_new(struct mapd_scratch **out, struct mapd_error *error);
void mapd_scratch_close(struct mapd_scratch **scratch);
mapd_code mapd_client_connect(const char *map,
                              const char *prefix,
                              double wait_s,
                              struct mapd_client **out,
                              struct mapd_error *error);
void mapd_client_close(struct mapd_client **client);
mapd_code mapd_client_snapshot(const struct mapd_client *client_handle,
                               struct mapd_snapshot **out,
                               struct mapd_error *error);
mapd_code mapd_client_refresh(const struct mapd_client *client_handle,
                              struct mapd_snapshot **out,
                              struct mapd_error *error);
mapd_code mapd_client_wait_next(const struct mapd_client *client_handle,
                                double wait_s,
                                struct mapd_snapshot **out,
                                struct mapd_error *error);
mapd_code mapd_client_wait_change(const struct mapd_client *client_handle,
                                  double wait_s,
                                  uint8_t *out,
                                  struct mapd_error *error);
mapd_code mapd_client_require(const struct mapd_client *client_handle,
                              uint64_t generation,
                              double wait_s,
                              struct mapd_snapshot **out,
                              struct mapd_error *error);
mapd_code mapd_client_pending(const struct mapd_client *client_handle,
                              struct mapd_generation *out,
                              struct mapd_error *error);
mapd_code mapd_client_served_by(const struct mapd_client *client_handle,
                                uint32_t *pid,
                                struct mapd_error *error);
mapd_code mapd_client_heartbeat_age(const struct mapd_client *client_handle,
                                    double *age_s,
                                    struct mapd_error *error);
mapd_code mapd_client_set_populate(const struct mapd_client *client_handle,
                                   uint8_t populate,
                                   struct mapd_error *error);
mapd_code mapd_client_generation(const struct mapd_client *client_handle, uint64_t *out, struct mapd_error *error);
mapd_code mapd_events_new(const struct mapd_client *client,
                          struct mapd_events **out,
                          struct mapd_error *error);
void mapd_events_close(struct mapd_events **events);
mapd_code mapd_events_next(struct mapd_events *events,
                           double wait_s,
                           struct mapd_event *out,
                           struct mapd_error *error);
mapd_code mapd_snapshot_open(const char *path, struct mapd_snapshot **out, struct mapd_error *error);
mapd_code mapd_snapshot_open_trusted(const char *path,
                                     const char *key,
                                     struct mapd_snapshot **out,
                                     struct mapd_error *error);
mapd_code mapd_snapshot_from_bytes(const uint8_t *bytes,
                                   size_t size,
                                   struct mapd_snapshot **out,
                                   struct mapd_error *error);
mapd_code mapd_snapshot_clone(const struct mapd_snapshot *snapshot,
                              struct mapd_snapshot **out,
                              struct mapd_error *error);
void mapd_snapshot_close(struct mapd_snapshot **snapshot);
mapd_code mapd_snapshot_with_overlay(const struct mapd_snapshot *snapshot,
                                     const uint8_t *bytes,
                                     size_t size,
                                     struct mapd_snapshot **out,
                                     struct mapd_error *error);
mapd_code mapd_snapshot_overlay_revision(const struct mapd_snapshot *snapshot, uint64_t *out, struct mapd_error *error);
mapd_code mapd_snapshot_verify(const struct mapd_snapshot *snapshot, struct mapd_error *error);
mapd_code mapd_snapshot_populate(const struct mapd_snapshot *snapshot,
                                 struct mapd_error *error);
mapd_code mapd_map_facts_of(const struct mapd_snapshot *snapshot, struct mapd_map_facts *out, struct mapd_error *error);
mapd_code mapd_map_geodetic_bounds(const struct mapd_snapshot *snapshot,
                                   struct mapd_geodetic_bounds *out,
                                   struct mapd_error *error);
mapd_code mapd_road_by_id(const struct mapd_snapshot *snapshot,
                          const char *id,
                          struct mapd_road_id *out,
                          struct mapd_error *error);
mapd_code mapd_junction_by_id(const struct mapd_snapshot *snapshot,
                              const char *id,
                              struct mapd_junction_id *out,
                              struct mapd_error *error);
mapd_code mapd_signal_by_id(const struct mapd_snapshot *snapshot,
                            const char *id,
                            struct mapd_signal_id *out,
                            struct mapd_error *error);
mapd_code mapd_object_by_id(const struct mapd_snapshot *snapshot,
                            const char *id,
                            struct mapd_object_id *out,
                            struct mapd_error *error);
mapd_code mapd_lane_by_key(const struct mapd_snapshot *snapshot,
                           const char *key,
                           struct mapd_lane_id *out,
                           struct mapd_error *error);
mapd_code mapd_lane_key(const struct mapd_snapshot *snapshot,
                        struct mapd_lane_id lane,
                        char *out,
                        size_t capacity,
                        size_t *length,
                        struct mapd_error *error);
mapd_code mapd_road_name_id(const struct mapd_snapshot *snapshot,
                            struct mapd_road_id road,
                            struct mapd_text *out,
                            struct mapd_error *error);
mapd_code mapd_roads(const struct mapd_snapshot *snapshot,
                     struct mapd_road_id *out,
                     size_t capacity,
                     size_t *count,
                     struct mapd_error *error);
mapd_code mapd_junctions(const struct mapd_snapshot *snapshot,
                         struct mapd_junction_id *out,
                         size_t capacity,
                         size_t *count,
                         struct mapd_error *error);
mapd_code mapd_lanes(const struct mapd_snapshot *snapshot,
                     struct mapd_lane_id *out,
                     size_t capacity,
                     size_t *count,
                     struct mapd_error *error);
mapd_code mapd_signals(const struct mapd_snapshot *snapshot,
                       struct mapd_signal_id *out,
                       size_t capacity,
                       size_t *count,
                       struct mapd_error *error);
mapd_code mapd_objects(const struct mapd_snapshot *snapshot,
                       struct mapd_object_id *out,
                       size_t capacity,
                       size_t *count,
                       struct mapd_error *error);
mapd_code mapd_nearest_options_init(struct mapd_nearest_options *options, size_t size, struct mapd_error *error);
uint64_t mapd_lane_types_drivable(void);
uint64_t mapd_lane_types_routable(void);
mapd_code mapd_nearest_lane(const struct mapd_snapshot *snapshot,
                            struct mapd_point point,
                            const struct mapd_nearest_options *options,
                            struct mapd_nearest *out,
                            struct mapd_error *error);
mapd_code mapd_nearest_lane_batch(const struct mapd_snapshot *snapshot,
                                  const struct mapd_point *points,
                                  size_t count,
                                  const struct mapd_nearest_options *options,
                                  struct mapd_scratch *scratch,
                                  struct mapd_nearest *out,
                                  struct mapd_error *error);
mapd_code mapd_lanes_near(const struct mapd_snapshot *snapshot,
                          struct mapd_point point,
                          const struct mapd_nearest_options *options,
                          struct mapd_scratch *scratch,
                          struct mapd_nearest *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_covers(const struct mapd_snapshot *snapshot,
                      struct mapd_point point,
                      double z_tolerance,
                      uint8_t *out,
                      struct mapd_error *error);
mapd_code mapd_lanes_in(const struct mapd_snapshot *snapshot,
                        struct mapd_region region,
                        uint64_t types,
                        struct mapd_scratch *scratch,
                        struct mapd_lane_id *out,
                        size_t capacity,
                        size_t *count,
                        struct mapd_error *error);
mapd_code mapd_road_facts_of(const struct mapd_snapshot *snapshot,
                             struct mapd_road_id road,
                             struct mapd_road_facts *out,
                             struct mapd_error *error);
mapd_code mapd_road_to_inertial(const struct mapd_snapshot *snapshot,
                                struct mapd_road_id road,
                                struct mapd_track track,
                                struct mapd_pose *out,
                                struct mapd_error *error);
mapd_code mapd_road_to_track(const struct mapd_snapshot *snapshot,
                             struct mapd_road_id road,
                             struct mapd_point point,
                             struct mapd_track_position *out,
                             struct mapd_error *error);
mapd_code mapd_road_to_inertial_batch(const struct mapd_snapshot *snapshot,
                                      struct mapd_road_id road,
                                      const struct mapd_track *tracks,
                                      size_t count,
                                      struct mapd_pose *out,
                                      struct mapd_error *error);
mapd_code mapd_road_to_track_batch(const struct mapd_snapshot *snapshot,
                                   struct mapd_road_id road,
                                   const struct mapd_point *points,
                                   size_t count,
                                   struct mapd_track_position *out,
                                   struct mapd_error *error);
mapd_code mapd_road_elevation_at(const struct mapd_snapshot *snapshot,
                                 struct mapd_road_id road,
                                 double s,
                                 double *out,
                                 struct mapd_error *error);
mapd_code mapd_road_superelevation_at(const struct mapd_snapshot *snapshot,
                                      struct mapd_road_id road,
                                      double s,
                                      double *out,
                                      struct mapd_error *error);
mapd_code mapd_road_lane_offset_at(const struct mapd_snapshot *snapshot,
                                   struct mapd_road_id road,
                                   double s,
                                   double *out,
                                   struct mapd_error *error);
mapd_code mapd_road_lane_at(const struct mapd_snapshot *snapshot,
                            struct mapd_road_id road,
                            double s,
                            double t,
                            struct mapd_lane_id *out,
                            struct mapd_error *error);
mapd_code mapd_road_lane_numbered(const struct mapd_snapshot *snapshot,
                                  struct mapd_road_id road,
                                  double s,
                                  int32_t number,
                                  struct mapd_lane_id *out,
                                  struct mapd_error *error);
mapd_code mapd_road_section_lanes(const struct mapd_snapshot *snapshot,
                                  struct mapd_road_id road,
                                  uint32_t section,
                                  struct mapd_lane_id *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);
mapd_code mapd_lane_facts_of(const struct mapd_snapshot *snapshot,
                             struct mapd_lane_id lane,
                             struct mapd_lane_facts *out,
                             struct mapd_error *error);
mapd_code mapd_lane_position_of(const struct mapd_snapshot *snapshot,
                                struct mapd_lane_id lane,
                                struct mapd_point point,
                                struct mapd_lane_position *out,
                                struct mapd_error *error);
mapd_code mapd_lane_pose_at(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            double s,
                            double offset,
                            struct mapd_pose *out,
                            struct mapd_error *error);
mapd_code mapd_lane_pose_of_reference_line(const struct mapd_snapshot *snapshot,
                                           struct mapd_lane_id lane,
                                           double s,
                                           double offset,
                                           struct mapd_pose *out,
                                           struct mapd_error *error);
mapd_code mapd_lane_waypoint_at(const struct mapd_snapshot *snapshot,
                                struct mapd_lane_id lane,
                                double s,
                                struct mapd_waypoint *out,
                                struct mapd_error *error);
mapd_code mapd_lane_waypoints(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              double step,
                              struct mapd_waypoint *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);
mapd_code mapd_lane_edges_at(const struct mapd_snapshot *snapshot,
                             struct mapd_lane_id lane,
                             double s,
                             struct mapd_lane_edges *out,
                             struct mapd_error *error);
mapd_code mapd_lane_bounds_at(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              double s,
                              struct mapd_lane_bounds *out,
                              struct mapd_error *error);
mapd_code mapd_lane_width_at(const struct mapd_snapshot *snapshot,
                             struct mapd_lane_id lane,
                             double s,
                             double *out,
                             struct mapd_error *error);
mapd_code mapd_lane_recorded_speed_limit_at(const struct mapd_snapshot *snapshot,
                                            struct mapd_lane_id lane,
                                            double s,
                                            double *out,
                                            struct mapd_error *error);
mapd_code mapd_lane_length_between(const struct mapd_snapshot *snapshot,
                                   struct mapd_lane_id lane,
                                   double a,
                                   double b,
                                   double *out,
                                   struct mapd_error *error);
mapd_code mapd_lane_time_between(const struct mapd_snapshot *snapshot,
                                 struct mapd_lane_id lane,
                                 double a,
                                 double b,
                                 double *out,
                                 struct mapd_error *error);
mapd_code mapd_lane_overtaking_rule_at(const struct mapd_snapshot *snapshot,
                                       struct mapd_lane_id lane,
                                       double s,
                                       struct mapd_overtaking_rule *out,
                                       struct mapd_error *error);
mapd_code mapd_lane_beside(const struct mapd_snapshot *snapshot,
                           struct mapd_lane_id lane,
                           uint32_t side,
                           struct mapd_lane_id *out,
                           struct mapd_error *error);
mapd_code mapd_lane_successors(const struct mapd_snapshot *snapshot,
                               struct mapd_lane_id lane,
                               struct mapd_lane_id *out,
                               size_t capacity,
                               size_t *count,
                               struct mapd_error *error);
mapd_code mapd_lane_predecessors(const struct mapd_snapshot *snapshot,
                                 struct mapd_lane_id lane,
                                 struct mapd_lane_id *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_match_options_init(struct mapd_match_options *options, size_t size, struct mapd_error *error);
mapd_code mapd_trace_options_init(struct mapd_trace_options *options, size_t size, struct mapd_error *error);
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
mapd_code mapd_match_trace(const struct mapd_snapshot *snapshot,
                           const struct mapd_trace_fix *fixes,
                           size_t count,
                           const struct mapd_trace_options *options,
                           struct mapd_scratch *scratch,
                           struct mapd_trace_match *out,
                           struct mapd_error *error);
mapd_code mapd_tracker_new(struct mapd_tracker **out, struct mapd_error *error);
void mapd_tracker_close(struct mapd_tracker **tracker);
mapd_code mapd_tracker_options_init(struct mapd_tracker_options *options, size_t size, struct mapd_error *error);
mapd_code mapd_tracker_update(struct mapd_tracker *tracker,
                              const struct mapd_snapshot *snapshot,
                              const struct mapd_tracker_fix *fix,
                              const struct mapd_tracker_options *options,
                              struct mapd_tracked *out,
                              struct mapd_error *error);
mapd_code mapd_tracker_hypotheses(const struct mapd_tracker *tracker,
                                  struct mapd_lane_match *out,
                                  size_t capacity,
                                  size_t *count,
                                  double *none,
                                  struct mapd_error *error);
mapd_code mapd_tracker_probability_in(struct mapd_tracker *tracker,
                                      const struct mapd_lane_id *lanes,
                                      size_t lane_count,
                                      double *out,
                                      struct mapd_error *error);
mapd_code mapd_tracker_reset(struct mapd_tracker *tracker, struct mapd_error *error);
mapd_code mapd_ground_at(const struct mapd_snapshot *snapshot,
                         struct mapd_point point,
                         const struct mapd_lane_id *expected,
                         size_t expected_count,
                         struct mapd_scratch *scratch,
                         struct mapd_ground *out,
                         struct mapd_error *error);
mapd_code mapd_ground_at_batch(const struct mapd_snapshot *snapshot,
                               const struct mapd_point *points,
                               size_t count,
                               const struct mapd_lane_id *expected,
                               size_t expected_count,
                               struct mapd_scratch *scratch,
                               struct mapd_ground *out,
                               struct mapd_error *error);
mapd_code mapd_stance_at(const struct mapd_snapshot *snapshot,
                         struct mapd_vehicle_pose pose,
                         const struct mapd_vec2 *wheels,
                         const struct mapd_lane_id *expected,
                         size_t expected_count,
                         struct mapd_scratch *scratch,
                         struct mapd_stance *out,
                         struct mapd_error *error);
mapd_code mapd_mark_filter_init(struct mapd_mark_filter *filter, size_t size, struct mapd_error *error);
mapd_code mapd_nearest_mark(const struct mapd_snapshot *snapshot,
                            struct mapd_vec2 point,
                            const struct mapd_mark_filter *filter,
                            struct mapd_near_mark *out,
                            struct mapd_error *error);
mapd_code mapd_nearest_mark_batch(const struct mapd_snapshot *snapshot,
                                  const struct mapd_vec2 *points,
                                  size_t count,
                                  const struct mapd_mark_filter *filter,
                                  struct mapd_near_mark *out,
                                  struct mapd_error *error);
mapd_code mapd_lane_line(const struct mapd_snapshot *snapshot,
                         struct mapd_lane_id lane,
                         uint32_t line,
                         struct mapd_line_point *out,
                         size_t capacity,
                         size_t *count,
                         struct mapd_error *error);
mapd_code mapd_node_count(const struct mapd_snapshot *snapshot, size_t *out, struct mapd_error *error);
mapd_code mapd_node_facts_of(const struct mapd_snapshot *snapshot,
                             struct mapd_node_id node,
                             struct mapd_node_facts *out,
                             struct mapd_error *error);
mapd_code mapd_node_edges(const struct mapd_snapshot *snapshot,
                          struct mapd_node_id node,
                          struct mapd_edge *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_node_predecessors(const struct mapd_snapshot *snapshot,
                                 struct mapd_node_id node,
                                 struct mapd_node_id *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_lane_nodes(const struct mapd_snapshot *snapshot,
                          struct mapd_lane_id lane,
                          struct mapd_node_id *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_lane_node_at(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            double s,
                            uint8_t forward,
                            struct mapd_node_id *out,
                            struct mapd_error *error);
mapd_code mapd_lane_allows_at(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              double s,
                              uint8_t vehicle,
                              uint8_t *out,
                              struct mapd_error *error);
mapd_code mapd_lane_conflicts(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              struct mapd_conflict *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);
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
mapd_code mapd_reachable(const struct mapd_snapshot *snapshot,
                         struct mapd_position_on_lane from,
                         double limit,
                         struct mapd_cost cost,
                         struct mapd_scratch *scratch,
                         struct mapd_reached *out,
                         size_t capacity,
                         size_t *count,
                         struct mapd_error *error);
mapd_code mapd_reachable_to(const struct mapd_snapshot *snapshot,
                            struct mapd_position_on_lane to,
                            double limit,
                            struct mapd_cost cost,
                            struct mapd_scratch *scratch,
                            struct mapd_reached *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
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
mapd_code mapd_next_sequence(struct mapd_scratch *scratch,
                             struct mapd_lane_id *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);
mapd_code mapd_next_junction_of(const struct mapd_snapshot *snapshot,
                                struct mapd_position_on_lane from,
                                double distance,
                                uint8_t vehicle,
                                struct mapd_next_junction *out,
                                struct mapd_error *error);
mapd_code mapd_path_options_init(struct mapd_path_options *options, size_t size, struct mapd_error *error);
mapd_code mapd_path_new(const struct mapd_snapshot *snapshot,
                        const struct mapd_route_step *steps,
                        size_t step_count,
                        const struct mapd_path_options *options,
                        struct mapd_path **out,
                        struct mapd_error *error);
void mapd_path_close(struct mapd_path **path);
mapd_code mapd_path_length(const struct mapd_path *path, double *out, struct mapd_error *error);
mapd_code mapd_path_at(const struct mapd_path *path,
                       double along,
                       struct mapd_path_point *out,
                       struct mapd_error *error);
mapd_code mapd_path_project(const struct mapd_path *path,
                            struct mapd_vec2 point,
                            const double *hint,
                            struct mapd_path_position *out,
                            struct mapd_error *error);
mapd_code mapd_path_speed_at(const struct mapd_path *path,
                             double along,
                             struct mapd_speed_rule *out,
                             struct mapd_error *error);
mapd_code mapd_path_joints(const struct mapd_path *path,
                           struct mapd_path_joint *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);
mapd_code mapd_path_lanes(const struct mapd_path *path,
                          struct mapd_path_lane *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_path_along_of(const struct mapd_path *path,
                             struct mapd_lane_id lane,
                             double s,
                             double *out,
                             struct mapd_error *error);
mapd_code mapd_path_is_broken(const struct mapd_path *path, uint8_t *out, struct mapd_error *error);
mapd_code mapd_path_at_batch(const struct mapd_path *path,
                             const double *along,
                             size_t count,
                             struct mapd_path_point *out,
                             struct mapd_error *error);
mapd_code mapd_path_project_batch(const struct mapd_path *path,
                                  const struct mapd_vec2 *points,
                                  size_t count,
                                  struct mapd_path_position *out,
                                  struct mapd_error *error);
mapd_code mapd_path_facts(const struct mapd_path *path,
                          struct mapd_scratch *scratch,
                          struct mapd_path_fact *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_path_speeds(const struct mapd_path *path,
                           struct mapd_scratch *scratch,
                           struct mapd_path_speed *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);
mapd_code mapd_path_travel_time(const struct mapd_path *path,
                                double from,
                                double to,
                                struct mapd_path_time *out,
                                struct mapd_error *error);
mapd_code mapd_country(const struct mapd_snapshot *snapshot,
                       uint32_t number,
                       struct mapd_text *out,
                       struct mapd_error *error);
mapd_code mapd_path_segments(const struct mapd_path *path,
                             uint8_t vehicle,
                             struct mapd_scratch *scratch,
                             struct mapd_path_segment *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);
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
mapd_code mapd_next_lane_change(const struct mapd_snapshot *snapshot,
                                const struct mapd_route_step *steps,
                                size_t step_count,
                                size_t at,
                                struct mapd_position_on_lane place,
                                struct mapd_scratch *scratch,
                                struct mapd_lane_change *out,
                                struct mapd_error *error);
mapd_code mapd_steps_length(const struct mapd_snapshot *snapshot,
                            const struct mapd_route_step *steps,
                            size_t step_count,
                            double *out,
                            struct mapd_error *error);
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
mapd_code mapd_path_corridor_surface(const struct mapd_path *path,
                                     double from,
                                     double length,
                                     double step,
                                     struct mapd_scratch *scratch,
                                     struct mapd_corridor_surface *out,
                                     size_t capacity,
                                     size_t *count,
                                     struct mapd_error *error);
mapd_code mapd_corridor_outline(const struct mapd_corridor_station *stations,
                                size_t station_count,
                                uint32_t edges,
                                struct mapd_scratch *scratch,
                                struct mapd_vec2 *out,
                                size_t capacity,
                                size_t *count,
                                uint8_t *is_simple,
                                struct mapd_error *error);
mapd_code mapd_path_conflicts(const struct mapd_path *path,
                              struct mapd_scratch *scratch,
                              struct mapd_path_conflict *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_conflict_lane *lanes,
                              size_t lane_capacity,
                              size_t *lane_count,
                              struct mapd_error *error);
mapd_code mapd_path_conflict_yields_by(const struct mapd_conflict_lane *lanes,
                                       size_t lane_count,
                                       const char *country,
                                       uint8_t *yields,
                                       uint8_t *basis,
                                       struct mapd_error *error);
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
mapd_code mapd_path_crossings(const struct mapd_path *path,
                              struct mapd_scratch *scratch,
                              struct mapd_path_crossing *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);
mapd_code mapd_view_new(const struct mapd_snapshot *snapshot,
                        double at_s,
                        struct mapd_view **out,
                        struct mapd_error *error);
void mapd_view_close(struct mapd_view **view);
mapd_code mapd_view_entries(const struct mapd_view *view,
                            struct mapd_overlay_entry *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_view_restrictions(const struct mapd_view *view,
                                 struct mapd_restriction *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_view_restrictions_at(const struct mapd_view *view,
                                    struct mapd_lane_id lane,
                                    double s,
                                    struct mapd_restriction *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);
mapd_code mapd_view_restrictions_along(const struct mapd_view *view,
                                       const struct mapd_route_step *steps,
                                       size_t step_count,
                                       uint8_t vehicle,
                                       struct mapd_scratch *scratch,
                                       struct mapd_restriction *out,
                                       size_t capacity,
                                       size_t *count,
                                       struct mapd_error *error);
mapd_code mapd_view_allows(const struct mapd_view *view,
                           struct mapd_lane_id lane,
                           double s,
                           uint8_t vehicle,
                           struct mapd_permission *out,
                           struct mapd_error *error);
mapd_code mapd_view_speed_rule_at(const struct mapd_view *view,
                                  struct mapd_lane_id lane,
                                  double s,
                                  uint8_t vehicle,
                                  struct mapd_speed_today *out,
                                  struct mapd_error *error);
mapd_code mapd_view_overtaking_rule_at(const struct mapd_view *view,
                                       struct mapd_lane_id lane,
                                       double s,
                                       uint8_t vehicle,
                                       struct mapd_overtaking_today *out,
                                       struct mapd_error *error);
mapd_code mapd_view_signal_out_of_service(const struct mapd_view *view,
                                          struct mapd_signal_id signal,
                                          uint32_t *out,
                                          struct mapd_error *error);
mapd_code mapd_view_restrictions_on_path(const struct mapd_view *view,
                                         const struct mapd_path *path,
                                         uint8_t vehicle,
                                         struct mapd_path_restriction *out,
                                         size_t capacity,
                                         size_t *count,
                                         struct mapd_error *error);
mapd_code mapd_view_speed_on_path(const struct mapd_view *view,
                                  const struct mapd_path *path,
                                  double along,
                                  uint8_t vehicle,
                                  struct mapd_speed_today *out,
                                  struct mapd_error *error);
mapd_code mapd_view_speeds_on_path(const struct mapd_view *view,
                                   const struct mapd_path *path,
                                   uint8_t vehicle,
                                   struct mapd_path_speed_today *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);
mapd_code mapd_view_travel_time_on_path(const struct mapd_view *view,
                                        const struct mapd_path *path,
                                        double from,
                                        double to,
                                        uint8_t vehicle,
                                        struct mapd_path_time *out,
                                        struct mapd_error *error);
mapd_code mapd_view_segments_on_path(const struct mapd_view *view,
                                     const struct mapd_path *path,
                                     uint8_t vehicle,
                                     struct mapd_scratch *scratch,
                                     struct mapd_path_segment *out,
                                     size_t capacity,
                                     size_t *count,
                                     struct mapd_error *error);
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
mapd_code mapd_view_crossings(const struct mapd_view *view,
                              const struct mapd_path *path,
                              struct mapd_scratch *scratch,
                              struct mapd_path_crossing *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);
mapd_code mapd_view_facts(const struct mapd_view *view,
                          const struct mapd_path *path,
                          struct mapd_scratch *scratch,
                          struct mapd_path_fact *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
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
mapd_code mapd_view_reachable(const struct mapd_view *view,
                              struct mapd_position_on_lane from,
                              double limit,
                              struct mapd_cost cost,
                              struct mapd_scratch *scratch,
                              struct mapd_reached_piece *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);
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
mapd_code mapd_view_signals_ahead(const struct mapd_view *view,
                                  struct mapd_position_on_lane from,
                                  double distance,
                                  uint8_t vehicle,
                                  struct mapd_scratch *scratch,
                                  struct mapd_signal_ahead *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);
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
mapd_code mapd_propose(const char *map,
                       const char *prefix,
                       const char *source,
                       const char *entry,
                       double wait_s,
                       struct mapd_decision *out,
                       struct mapd_error *error);
mapd_code mapd_route_request_init(struct mapd_route_request *request, size_t size, struct mapd_error *error);
mapd_code mapd_alternative_options_init(struct mapd_alternative_options *options,
                                        size_t size,
                                        struct mapd_error *error);
mapd_code mapd_find_route(const struct mapd_snapshot *snapshot,
                          const struct mapd_route_request *request,
                          struct mapd_scratch *scratch,
                          struct mapd_route_sum *sum,
                          struct mapd_route_step *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_view_find_route(const struct mapd_view *view,
                               const struct mapd_route_request *request,
                               struct mapd_scratch *scratch,
                               struct mapd_route_sum *sum,
                               struct mapd_route_step *out,
                               size_t capacity,
                               size_t *count,
                               struct mapd_error *error);
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
mapd_code mapd_junction_facts_of(const struct mapd_snapshot *snapshot,
                                 struct mapd_junction_id junction,
                                 struct mapd_junction_facts *out,
                                 struct mapd_error *error);
mapd_code mapd_junction_connections(const struct mapd_snapshot *snapshot,
                                    struct mapd_junction_id junction,
                                    struct mapd_connection *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);
mapd_code mapd_signal_facts_of(const struct mapd_snapshot *snapshot,
                               struct mapd_signal_id signal,
                               struct mapd_signal_facts *out,
                               struct mapd_error *error);
mapd_code mapd_lane_signals(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            uint32_t which,
                            struct mapd_lane_signal *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_lane_speed_rule_at(const struct mapd_snapshot *snapshot,
                                  struct mapd_lane_id lane,
                                  double s,
                                  struct mapd_speed_rule *out,
                                  struct mapd_error *error);
mapd_code mapd_lane_speed_rules(const struct mapd_snapshot *snapshot,
                                struct mapd_lane_id lane,
                                struct mapd_speed_stretch *out,
                                size_t capacity,
                                size_t *count,
                                struct mapd_error *error);
mapd_code mapd_signals_near(const struct mapd_snapshot *snapshot,
                            struct mapd_vec2 point,
                            double radius,
                            struct mapd_scratch *scratch,
                            struct mapd_near_signal *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_signals_in(const struct mapd_snapshot *snapshot,
                          struct mapd_region region,
                          struct mapd_scratch *scratch,
                          struct mapd_signal_id *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_signals_ahead(const struct mapd_snapshot *snapshot,
                             struct mapd_position_on_lane from,
                             double distance,
                             uint8_t vehicle,
                             struct mapd_scratch *scratch,
                             struct mapd_signal_ahead *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);
mapd_code mapd_signals_along(const struct mapd_snapshot *snapshot,
                             const struct mapd_route_step *steps,
                             size_t step_count,
                             struct mapd_scratch *scratch,
                             struct mapd_signal_ahead *out,
                             size_t capacity,
                             size_t *count,
                             struct mapd_error *error);
mapd_code mapd_lines_along(const struct mapd_snapshot *snapshot,
                           const struct mapd_route_step *steps,
                           size_t step_count,
                           struct mapd_scratch *scratch,
                           struct mapd_lane_line_at *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);
mapd_code mapd_lane_turn(const struct mapd_snapshot *snapshot,
                         struct mapd_lane_id lane,
                         uint8_t *out,
                         struct mapd_error *error);
mapd_code mapd_lane_entries(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            struct mapd_lane_id *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_lane_movement_lanes(const struct mapd_snapshot *snapshot,
                                   struct mapd_lane_id lane,
                                   struct mapd_lane_id *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);
mapd_code mapd_lane_movement_lights(const struct mapd_snapshot *snapshot,
                                    struct mapd_lane_id lane,
                                    struct mapd_lane_signal *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);
mapd_code mapd_lane_movement_stop(const struct mapd_snapshot *snapshot,
                                  struct mapd_lane_id lane,
                                  struct mapd_lane_line_at *out,
                                  struct mapd_error *error);
mapd_code mapd_lane_lines(const struct mapd_snapshot *snapshot,
                          struct mapd_lane_id lane,
                          uint32_t which,
                          struct mapd_lane_line_at *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_lane_right_of_way(const struct mapd_snapshot *snapshot,
                                 struct mapd_lane_id lane,
                                 struct mapd_right_of_way *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_lane_right_of_way_by(const struct mapd_snapshot *snapshot,
                                    struct mapd_lane_id lane,
                                    const char *country,
                                    struct mapd_right_of_way *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);
mapd_code mapd_signal_movements(const struct mapd_snapshot *snapshot,
                                struct mapd_signal_id signal,
                                struct mapd_lane_id *out,
                                size_t capacity,
                                size_t *count,
                                struct mapd_error *error);
mapd_code mapd_object_facts_of(const struct mapd_snapshot *snapshot,
                               struct mapd_object_id object,
                               struct mapd_object_facts *out,
                               struct mapd_error *error);
mapd_code mapd_object_placements(const struct mapd_snapshot *snapshot,
                                 struct mapd_object_id object,
                                 struct mapd_placement_facts *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_placement_facts_of(const struct mapd_snapshot *snapshot,
                                  struct mapd_placement_id place,
                                  struct mapd_placement_facts *out,
                                  struct mapd_error *error);
mapd_code mapd_placement_footprint(const struct mapd_snapshot *snapshot,
                                   struct mapd_placement_id place,
                                   struct mapd_scratch *scratch,
                                   struct mapd_vec3 *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);
mapd_code mapd_object_lanes(const struct mapd_snapshot *snapshot,
                            struct mapd_object_id object,
                            struct mapd_object_lane *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_lane_objects(const struct mapd_snapshot *snapshot,
                            struct mapd_lane_id lane,
                            struct mapd_object_lane *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_objects_near(const struct mapd_snapshot *snapshot,
                            struct mapd_vec2 point,
                            double radius,
                            struct mapd_scratch *scratch,
                            struct mapd_near_object *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_objects_in(const struct mapd_snapshot *snapshot,
                          struct mapd_region region,
                          struct mapd_scratch *scratch,
                          struct mapd_placement_id *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
struct mapd_class_set mapd_class_set_landmarks(void);
mapd_code mapd_landmarks_near(const struct mapd_snapshot *snapshot,
                              struct mapd_vec2 point,
                              double radius,
                              const struct mapd_class_set *classes,
                              struct mapd_scratch *scratch,
                              struct mapd_landmark *out,
                              size_t capacity,
                              size_t *count,
                              struct mapd_error *error);
mapd_code mapd_landmarks_in(const struct mapd_snapshot *snapshot,
                            struct mapd_region region,
                            const struct mapd_class_set *classes,
                            struct mapd_scratch *scratch,
                            struct mapd_landmark *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_landmarks_in_view(const struct mapd_snapshot *snapshot,
                                 struct mapd_sensor sensor,
                                 const struct mapd_class_set *classes,
                                 struct mapd_scratch *scratch,
                                 struct mapd_landmark_in_view *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_lane_road_marks(const struct mapd_snapshot *snapshot,
                               struct mapd_lane_id lane,
                               struct mapd_road_mark *out,
                               size_t capacity,
                               size_t *count,
                               struct mapd_error *error);
mapd_code mapd_lane_road_mark_at(const struct mapd_snapshot *snapshot,
                                 struct mapd_lane_id lane,
                                 double s,
                                 struct mapd_road_mark *out,
                                 struct mapd_error *error);
mapd_code mapd_boundary_segments(const struct mapd_snapshot *snapshot,
                                 struct mapd_region region,
                                 uint64_t types,
                                 struct mapd_scratch *scratch,
                                 struct mapd_boundary_segment *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_road_mark_segments(const struct mapd_snapshot *snapshot,
                                  struct mapd_region region,
                                  uint64_t types,
                                  struct mapd_scratch *scratch,
                                  struct mapd_road_mark_segment *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);
mapd_code mapd_mark_points(const struct mapd_snapshot *snapshot,
                           struct mapd_region region,
                           double spacing,
                           const struct mapd_mark_filter *filter,
                           struct mapd_scratch *scratch,
                           struct mapd_mark_point *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);
mapd_code mapd_road_surface_at(const struct mapd_snapshot *snapshot,
                               struct mapd_road_id road,
                               double s,
                               double t,
                               struct mapd_surface *out,
                               struct mapd_error *error);
mapd_code mapd_lane_height_at(const struct mapd_snapshot *snapshot,
                              struct mapd_lane_id lane,
                              double s,
                              struct mapd_lane_height *out,
                              struct mapd_error *error);
mapd_code mapd_lane_material_at(const struct mapd_snapshot *snapshot,
                                struct mapd_lane_id lane,
                                double s,
                                struct mapd_material *out,
                                struct mapd_error *error);
mapd_code mapd_junction_grid_height_at(const struct mapd_snapshot *snapshot,
                                       struct mapd_junction_id junction,
                                       struct mapd_vec2 point,
                                       struct mapd_grid_height *out,
                                       struct mapd_error *error);
mapd_code mapd_structures(const struct mapd_snapshot *snapshot,
                          struct mapd_structure *out,
                          size_t capacity,
                          size_t *count,
                          struct mapd_error *error);
mapd_code mapd_object_references(const struct mapd_snapshot *snapshot,
                                 struct mapd_object_reference *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_quarantined_parts(const struct mapd_snapshot *snapshot,
                                 struct mapd_quarantined *out,
                                 size_t capacity,
                                 size_t *count,
                                 struct mapd_error *error);
mapd_code mapd_quarantined_near(const struct mapd_snapshot *snapshot,
                                struct mapd_vec2 point,
                                double radius,
                                struct mapd_quarantined *out,
                                size_t capacity,
                                size_t *count,
                                struct mapd_error *error);
mapd_code mapd_left_out(const struct mapd_snapshot *snapshot,
                        uint8_t kind,
                        const char *id,
                        struct mapd_quarantined *out,
                        struct mapd_error *error);
mapd_code mapd_junction_groups(const struct mapd_snapshot *snapshot,
                               struct mapd_junction_group *out,
                               size_t capacity,
                               size_t *count,
                               struct mapd_error *error);
mapd_code mapd_junction_group_members(const struct mapd_snapshot *snapshot,
                                      uint32_t number,
                                      struct mapd_junction_id *out,
                                      size_t capacity,
                                      size_t *count,
                                      struct mapd_error *error);
mapd_code mapd_junction_group_ring(const struct mapd_snapshot *snapshot,
                                   uint32_t number,
                                   struct mapd_lane_id *out,
                                   size_t capacity,
                                   size_t *count,
                                   struct mapd_error *error);
mapd_code mapd_controllers(const struct mapd_snapshot *snapshot,
                           struct mapd_controller *out,
                           size_t capacity,
                           size_t *count,
                           struct mapd_error *error);
mapd_code mapd_controller_signals(const struct mapd_snapshot *snapshot,
                                  uint32_t number,
                                  struct mapd_signal_id *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);
mapd_code mapd_signal_controllers(const struct mapd_snapshot *snapshot,
                                  struct mapd_signal_id signal,
                                  uint32_t *out,
                                  size_t capacity,
                                  size_t *count,
                                  struct mapd_error *error);
mapd_code mapd_junction_controllers(const struct mapd_snapshot *snapshot,
                                    struct mapd_junction_id junction,
                                    uint32_t *out,
                                    size_t capacity,
                                    size_t *count,
                                    struct mapd_error *error);
mapd_code mapd_signal_links(const struct mapd_snapshot *snapshot,
                            struct mapd_signal_id signal,
                            uint32_t which,
                            struct mapd_signal_link *out,
                            size_t capacity,
                            size_t *count,
                            struct mapd_error *error);
mapd_code mapd_projector_new(const struct mapd_snapshot *snapshot,
                             struct mapd_projector **out,
                             struct mapd_error *error);
mapd_code mapd_projector_of_file(const struct mapd_snapshot *snapshot,
                                 struct mapd_projector **out,
                                 struct mapd_error *error);
void mapd_projector_close(struct mapd_projector **projector);
mapd_code mapd_to_geodetic(const struct mapd_projector *projector,
                           struct mapd_vec3 point,
                           struct mapd_geodetic *out,
                           struct mapd_error *error);
mapd_code mapd_from_geodetic(const struct mapd_projector *projector,
                             struct mapd_geodetic place,
                             struct mapd_vec3 *out,
                             struct mapd_error *error);
mapd_code mapd_to_geodetic_batch(const struct mapd_projector *projector,
                                 const struct mapd_vec3 *points,
                                 size_t count,
                                 struct mapd_geodetic *out,
                                 struct mapd_error *error);
mapd_code mapd_from_geodetic_batch(const struct mapd_projector *projector,
                                   const struct mapd_geodetic *places,
                                   size_t count,
                                   struct mapd_vec3 *out,
                                   struct mapd_error *error);
mapd_code mapd_north_at_batch(const struct mapd_projector *projector,
                              const struct mapd_vec3 *points,
                              size_t count,
                              double *out,
                              struct mapd_error *error);
mapd_code mapd_to_enu_batch(const struct mapd_projector *projector,
                            struct mapd_vec3 origin,
                            const struct mapd_vec3 *points,
                            size_t count,
                            struct mapd_vec3 *out,
                            struct mapd_error *error);
mapd_code mapd_from_enu_batch(const struct mapd_projector *projector,
                              struct mapd_vec3 origin,
                              const struct mapd_vec3 *places,
                              size_t count,
                              struct mapd_vec3 *out,
                              struct mapd_error *error);
mapd_code mapd_nearest_lane_geodetic(const struct mapd_snapshot *snapshot,
                                     const struct mapd_projector *projector,
                                     struct mapd_geodetic place,
                                     uint8_t has_altitude,
                                     const struct mapd_nearest_options *options,
                                     struct mapd_nearest *out,
                                     struct mapd_error *error);
mapd_code mapd_word(uint32_t vocabulary,
                    uint16_t code,
                    struct mapd_text *out,
                    struct mapd_error *error);
struct mapd_text mapd_version(void);
#ifdef __cplusplus
}
#endif
#endif
