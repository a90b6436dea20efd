//! Enumerations.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/words.toml; change that file instead.

use super::schema_words::*;
use crate::attribute::enumeration;

enumeration! {
    /// Who may or may not use a lane (`e_accessRestrictionType`).
    AccessRestrictionType: ACCESS_RESTRICTION_TYPE {
        Simulator = "simulator",
        AutonomousTraffic = "autonomousTraffic",
        Pedestrian = "pedestrian",
        PassengerCar = "passengerCar",
        Bus = "bus",
        Delivery = "delivery",
        Emergency = "emergency",
        Taxi = "taxi",
        ThroughTraffic = "throughTraffic",
        Truck = "truck",
        Bicycle = "bicycle",
        Motorcycle = "motorcycle",
        None = "none",
        Trucks = "trucks",
        Hov = "HOV",
    } words { Simulator AutonomousTraffic AutonomousTraffic Pedestrian PassengerCar Bus Delivery Emergency Taxi ThroughTraffic Truck Bicycle Motorcycle None Trucks Hov }
}

enumeration! {
    /// Kind of border (`e_borderType`).
    BorderType: BORDER_TYPE {
        Concrete = "concrete",
        Curb = "curb",
        Paint = "paint",
    } words { Concrete Curb Paint }
}

enumeration! {
    /// Material of a bridge (`e_bridgeType`).
    BridgeType: BRIDGE_TYPE {
        Concrete = "concrete",
        Steel = "steel",
        Brick = "brick",
        Wood = "wood",
    } words { Concrete Steel Brick Wood }
}

enumeration! {
    /// Kind of connection (`e_connection_type`).
    ConnectionType: CONNECTION_TYPE {
        Default = "default",
        Virtual = "virtual",
    } words { Default Virtual }
}

enumeration! {
    /// End of a road (`e_contactPoint`).
    ContactPoint: CONTACT_POINT {
        Start = "start",
        End = "end",
    } words { Start End }
}

enumeration! {
    /// Names of countries of older versions (`e_countryCode`).
    CountryCode: COUNTRY_CODE {
        OpenDRIVE = "OpenDRIVE",
        Austria = "Austria",
        Brazil = "Brazil",
        China = "China",
        France = "France",
        Germany = "Germany",
        Italy = "Italy",
        Switzerland = "Switzerland",
        Usa = "USA",
    } words { OpenDRIVE Austria Brazil China France Germany Italy Switzerland Usa }
}

enumeration! {
    /// Names of countries, the list of deprecated ones (`e_countryCode_deprecated`).
    CountryCodeDeprecated: COUNTRY_CODE_DEPRECATED {
        OpenDRIVE = "OpenDRIVE",
        Austria = "Austria",
        Brazil = "Brazil",
        China = "China",
        France = "France",
        Germany = "Germany",
        Italy = "Italy",
        Switzerland = "Switzerland",
        Usa = "USA",
    } words { OpenDRIVE Austria Brazil China France Germany Italy Switzerland Usa }
}

enumeration! {
    /// What was done to raw data (`e_dataQuality_RawData_PostProcessing`).
    PostProcessing: POST_PROCESSING {
        Raw = "raw",
        Cleaned = "cleaned",
        Processed = "processed",
        Fused = "fused",
    } words { Raw Cleaned Processed Fused }
}

enumeration! {
    /// Source of raw data (`e_dataQuality_RawData_Source`).
    RawDataSource: RAW_DATA_SOURCE {
        Sensor = "sensor",
        Cadaster = "cadaster",
        Custom = "custom",
    } words { Sensor Cadaster Custom }
}

enumeration! {
    /// Direction relative to another (`e_direction`).
    Direction: DIRECTION {
        Same = "same",
        Opposite = "opposite",
    } words { Same Opposite }
}

enumeration! {
    /// Direction along a road (`e_elementDir`).
    ElementDir: ELEMENT_DIR {
        Plus = "+",
        Minus = "-",
    } words { Plus Minus }
}

enumeration! {
    /// Kind of junction group (`e_junctionGroup_type`).
    JunctionGroupType: JUNCTION_GROUP_TYPE {
        Roundabout = "roundabout",
        Unknown = "unknown",
        ComplexJunction = "complexJunction",
        HighwayInterchange = "highwayInterchange",
    } words { Roundabout Unknown ComplexJunction HighwayInterchange }
}

enumeration! {
    /// Kind of boundary segment (`e_junction_segment_type`).
    SegmentType: SEGMENT_TYPE {
        Joint = "joint",
        Lane = "lane",
    } words { Joint Lane }
}

enumeration! {
    /// How surface data of a junction are applied, in 1.7 (`e_junction_surface_CRG_mode`).
    JunctionCrgMode: JUNCTION_CRG_MODE {
        Global = "global",
    } words { Global }
}

enumeration! {
    /// Kind of junction (`e_junction_type`).
    JunctionType: JUNCTION_TYPE {
        Default = "default",
        Virtual = "virtual",
        Direct = "direct",
        Crossing = "crossing",
    } words { Default Virtual Direct Crossing }
}

enumeration! {
    /// Side on which a lane is advisory (`e_laneAdvisory`).
    LaneAdvisory: LANE_ADVISORY {
        Both = "both",
        Inner = "inner",
        None = "none",
        Outer = "outer",
    } words { Both Inner None Outer }
}

enumeration! {
    /// Type of lane (`e_laneType`).
    LaneType: LANE_TYPE {
        Shoulder = "shoulder",
        Border = "border",
        Driving = "driving",
        Stop = "stop",
        None = "none",
        Restricted = "restricted",
        Parking = "parking",
        Median = "median",
        Biking = "biking",
        Shared = "shared",
        Sidewalk = "sidewalk",
        Curb = "curb",
        Exit = "exit",
        Entry = "entry",
        OnRamp = "onRamp",
        OffRamp = "offRamp",
        ConnectingRamp = "connectingRamp",
        Bidirectional = "bidirectional",
        Special1 = "special1",
        Special2 = "special2",
        Special3 = "special3",
        RoadWorks = "roadWorks",
        Tram = "tram",
        Rail = "rail",
        Bus = "bus",
        Taxi = "taxi",
        Hov = "HOV",
        MwyEntry = "mwyEntry",
        MwyExit = "mwyExit",
        Walking = "walking",
        SlipLane = "slipLane",
    } words { Shoulder Border Driving Stop None Restricted Parking Median Biking Shared Sidewalk Curb Exit Entry OnRamp OffRamp ConnectingRamp Bidirectional Special1 Special2 Special3 RoadWorks Tram Rail Bus Taxi Hov MwyEntry MwyExit Walking SlipLane }
}

enumeration! {
    /// Direction of travel relative to the rule of the road (`e_lane_direction`).
    LaneDirection: LANE_DIRECTION {
        Both = "both",
        Reversed = "reversed",
        Standard = "standard",
    } words { Both Reversed Standard }
}

enumeration! {
    /// Layer of lanes (`e_layerType`).
    LayerType: LAYER_TYPE {
        Temporary = "temporary",
        Permanent = "permanent",
    } words { Temporary Permanent }
}

enumeration! {
    /// Words for speed limits (`e_maxSpeedString`).
    MaxSpeedString: MAX_SPEED_STRING {
        NoLimit = "no limit",
        Undefined = "undefined",
    } words { NoLimit Undefined }
}

enumeration! {
    /// Type of object (`e_objectType`).
    ObjectType: OBJECT_TYPE {
        None = "none",
        Obstacle = "obstacle",
        Car = "car",
        Pole = "pole",
        Tree = "tree",
        Vegetation = "vegetation",
        Barrier = "barrier",
        Building = "building",
        ParkingSpace = "parkingSpace",
        Patch = "patch",
        Railing = "railing",
        TrafficIsland = "trafficIsland",
        Crosswalk = "crosswalk",
        StreetLamp = "streetLamp",
        Gantry = "gantry",
        SoundBarrier = "soundBarrier",
        Truck = "truck",
        Van = "van",
        Bus = "bus",
        Trailer = "trailer",
        Bike = "bike",
        Motorbike = "motorbike",
        Tram = "tram",
        Train = "train",
        Pedestrian = "pedestrian",
        Wind = "wind",
        RoadMark = "roadMark",
        RoadSurface = "roadSurface",
    } words { None Obstacle Car Pole Tree Vegetation Barrier Building ParkingSpace Patch Railing TrafficIsland Crosswalk StreetLamp Gantry SoundBarrier Truck Van Bus Trailer Bike Motorbike Tram Train Pedestrian Wind RoadMark RoadSurface }
}

enumeration! {
    /// Direction of travel that something is for (`e_orientation`).
    Orientation: ORIENTATION {
        Plus = "+",
        Minus = "-",
        None = "none",
    } words { Plus Minus None }
}

enumeration! {
    /// What fills an outline (`e_outlineFillType`).
    OutlineFillType: OUTLINE_FILL_TYPE {
        Grass = "grass",
        Concrete = "concrete",
        Cobble = "cobble",
        Asphalt = "asphalt",
        Pavement = "pavement",
        Gravel = "gravel",
        Soil = "soil",
        Paint = "paint",
    } words { Grass Concrete Cobble Asphalt Pavement Gravel Soil Paint }
}

enumeration! {
    /// Range of a curve parameter (`e_paramPoly3_pRange`).
    ParamPoly3Range: PARAM_POLY3_RANGE {
        ArcLength = "arcLength",
        Normalized = "normalized",
    } words { ArcLength Normalized }
}

enumeration! {
    /// Category of persons (`e_personCategory`).
    PersonCategory: PERSON_CATEGORY {
        Pedestrian = "pedestrian",
    } words { Pedestrian }
}

enumeration! {
    /// Color of a mark (`e_roadMarkColor`).
    RoadMarkColor: ROAD_MARK_COLOR {
        Standard = "standard",
        Blue = "blue",
        Green = "green",
        Red = "red",
        White = "white",
        Yellow = "yellow",
        Black = "black",
        Orange = "orange",
        Violet = "violet",
    } words { Standard Blue Green Red White Yellow Black Orange Violet }
}

enumeration! {
    /// Passing rule (`e_roadMarkRule`).
    RoadMarkRule: ROAD_MARK_RULE {
        NoPassing = "no passing",
        Caution = "caution",
        None = "none",
    } words { NoPassing Caution None }
}

enumeration! {
    /// Kind of mark (`e_roadMarkType`).
    RoadMarkType: ROAD_MARK_TYPE {
        None = "none",
        Solid = "solid",
        Broken = "broken",
        SolidSolid = "solid solid",
        SolidBroken = "solid broken",
        BrokenSolid = "broken solid",
        BrokenBroken = "broken broken",
        BottsDots = "botts dots",
        Grass = "grass",
        Curb = "curb",
        Custom = "custom",
        Edge = "edge",
    } words { None Solid Broken SolidSolid SolidBroken BrokenSolid BrokenBroken BottsDots Grass Curb Custom Edge }
}

enumeration! {
    /// Visual weight of a mark (`e_roadMarkWeight`).
    RoadMarkWeight: ROAD_MARK_WEIGHT {
        Standard = "standard",
        Bold = "bold",
    } words { Standard Bold }
}

enumeration! {
    /// Type of road (`e_roadType`).
    RoadType: ROAD_TYPE {
        Unknown = "unknown",
        Rural = "rural",
        Motorway = "motorway",
        Town = "town",
        LowSpeed = "lowSpeed",
        Pedestrian = "pedestrian",
        Bicycle = "bicycle",
        TownExpressway = "townExpressway",
        TownCollector = "townCollector",
        TownArterial = "townArterial",
        TownPrivate = "townPrivate",
        TownLocal = "townLocal",
        TownPlayStreet = "townPlayStreet",
    } words { Unknown Rural Motorway Town LowSpeed Pedestrian Bicycle TownExpressway TownCollector TownArterial TownPrivate TownLocal TownPlayStreet }
}

enumeration! {
    /// Lane changes that are allowed (`e_road_lanes_laneSection_lcr_lane_roadMark_laneChange`).
    LaneChange: LANE_CHANGE {
        Increase = "increase",
        Decrease = "decrease",
        Both = "both",
        None = "none",
    } words { Increase Decrease Both None }
}

enumeration! {
    /// Whether access is allowed or denied (`e_road_lanes_laneSection_lr_lane_access_rule`).
    AccessRule: ACCESS_RULE {
        Allow = "allow",
        Deny = "deny",
    } words { Allow Deny }
}

enumeration! {
    /// Side of a crossfall (`e_road_lateralProfile_crossfall_side`).
    CrossfallSide: CROSSFALL_SIDE {
        Left = "left",
        Right = "right",
        Both = "both",
    } words { Left Right Both }
}

enumeration! {
    /// What a road is linked to (`e_road_link_elementType`).
    ElementType: ELEMENT_TYPE {
        Road = "road",
        Junction = "junction",
    } words { Road Junction }
}

enumeration! {
    /// Side of a neighbor (`e_road_link_neighbor_side`).
    NeighborSide: NEIGHBOR_SIDE {
        Left = "left",
        Right = "right",
    } words { Left Right }
}

enumeration! {
    /// Who may park (`e_road_objects_object_parkingSpace_access`).
    ParkingSpaceAccess: PARKING_SPACE_ACCESS {
        All = "all",
        Car = "car",
        Women = "women",
        Handicapped = "handicapped",
        Bus = "bus",
        Truck = "truck",
        Electric = "electric",
        Residents = "residents",
    } words { All Car Women Handicapped Bus Truck Electric Residents }
}

enumeration! {
    /// State of a switch (`e_road_railroad_switch_position`).
    SwitchPosition: SWITCH_POSITION {
        Dynamic = "dynamic",
        Straight = "straight",
        Turn = "turn",
    } words { Dynamic Straight Turn }
}

enumeration! {
    /// Technology of a display (`e_road_signals_displayType`).
    DisplayType: DISPLAY_TYPE {
        Led = "LED",
        MonochromGraphic = "monochromGraphic",
        RotatingPrismHorizontal = "rotatingPrismHorizontal",
        RotatingPrismVertical = "rotatingPrismVertical",
        SimpleMatrix = "simpleMatrix",
        Other = "other",
    } words { Led MonochromGraphic RotatingPrismHorizontal RotatingPrismVertical SimpleMatrix Other }
}

enumeration! {
    /// What a signal refers to (`e_road_signals_signal_reference_elementType`).
    ReferenceElementType: REFERENCE_ELEMENT_TYPE {
        Object = "object",
        Signal = "signal",
    } words { Object Signal }
}

enumeration! {
    /// How surface data are applied (`e_road_surface_CRG_mode`).
    CrgMode: CRG_MODE {
        Attached = "attached",
        Attached0 = "attached0",
        Genuine = "genuine",
        Global = "global",
    } words { Attached Attached0 Genuine Global }
}

enumeration! {
    /// What surface data describe (`e_road_surface_CRG_purpose`).
    CrgPurpose: CRG_PURPOSE {
        Elevation = "elevation",
        Friction = "friction",
    } words { Elevation Friction }
}

enumeration! {
    /// Side of an object (`e_sideType`).
    SideType: SIDE_TYPE {
        Left = "left",
        Right = "right",
        Front = "front",
        Rear = "rear",
    } words { Left Right Front Rear }
}

enumeration! {
    /// Meaning for lanes (`e_signals_semantics_lane`).
    LaneSemanticsType: LANE_SEMANTICS_TYPE {
        NoOvertakeCars = "noOvertakeCars",
        NoOvertakeCarsEnd = "noOvertakeCarsEnd",
        NoOvertakeTrucks = "noOvertakeTrucks",
        NoOvertakeTrucksEnd = "noOvertakeTrucksEnd",
        PriorityOverOncoming = "priorityOverOncoming",
        Roundabout = "roundabout",
        YieldForOncoming = "yieldForOncoming",
        Other = "other",
    } words { NoOvertakeCars NoOvertakeCarsEnd NoOvertakeTrucks NoOvertakeTrucksEnd PriorityOverOncoming Roundabout YieldForOncoming Other }
}

enumeration! {
    /// Meaning for priority (`e_signals_semantics_priority`).
    PrioritySemanticsType: PRIORITY_SEMANTICS_TYPE {
        FourWay = "4way",
        KeepClearLine = "keepClearLine",
        NoParkingLine = "noParkingLine",
        NoTurnOnRed = "noTurnOnRed",
        PriorityRoad = "priorityRoad",
        PriorityRoadEnd = "priorityRoadEnd",
        PriorityToTheRightRule = "priorityToTheRightRule",
        Stop = "stop",
        StopLine = "stopLine",
        TurnOnRedAllowed = "turnOnRedAllowed",
        TrafficLight = "trafficLight",
        WaitingLine = "waitingLine",
        Yield = "yield",
    } words { FourWay KeepClearLine NoParkingLine NoTurnOnRed PriorityRoad PriorityRoadEnd PriorityToTheRightRule Stop StopLine TurnOnRedAllowed TrafficLight WaitingLine Yield }
}

enumeration! {
    /// Kind of speed (`e_signals_semantics_speed`).
    SpeedSemanticsKind: SPEED_SEMANTICS_KIND {
        Maximum = "maximum",
        MaximumEnd = "maximumEnd",
        Minimum = "minimum",
        MinimumEnd = "minimumEnd",
        Recommended = "recommended",
        RecommendedEnd = "recommendedEnd",
        Zone = "zone",
        ZoneEnd = "zoneEnd",
    } words { Maximum MaximumEnd Minimum MinimumEnd Recommended RecommendedEnd Zone ZoneEnd }
}

enumeration! {
    /// Kind of distance (`e_signals_semantics_supplementaryDistance`).
    DistanceSemanticsType: DISTANCE_SEMANTICS_TYPE {
        For = "for",
        In = "in",
    } words { For In }
}

enumeration! {
    /// Kind of weather (`e_signals_semantics_supplementaryEnvironment`).
    EnvironmentSemanticsType: ENVIRONMENT_SEMANTICS_TYPE {
        Fog = "fog",
        Rain = "rain",
        Snow = "snow",
    } words { Fog Rain Snow }
}

enumeration! {
    /// Kind of time (`e_signals_semantics_supplementaryTime`).
    TimeSemanticsType: TIME_SEMANTICS_TYPE {
        Day = "day",
        Time = "time",
    } words { Day Time }
}

enumeration! {
    /// Side of a platform (`e_station_platform_segment_side`).
    PlatformSide: PLATFORM_SIDE {
        Left = "left",
        Right = "right",
    } words { Left Right }
}

enumeration! {
    /// Size of a station (`e_station_type`).
    StationType: STATION_TYPE {
        Small = "small",
        Medium = "medium",
        Large = "large",
    } words { Small Medium Large }
}

enumeration! {
    /// How heights of a strip are meant (`e_strip_mode`).
    StripMode: STRIP_MODE {
        Independent = "independent",
        Relative = "relative",
    } words { Independent Relative }
}

enumeration! {
    /// Side on which traffic drives (`e_trafficRule`).
    TrafficRule: TRAFFIC_RULE {
        Rht = "RHT",
        Lht = "LHT",
    } words { Rht Lht }
}

enumeration! {
    /// Kind of tunnel (`e_tunnelType`).
    TunnelType: TUNNEL_TYPE {
        Standard = "standard",
        Underpass = "underpass",
    } words { Standard Underpass }
}

enumeration! {
    /// Unit of a value (`e_unit`).
    Unit: UNIT {
        M = "m",
        Km = "km",
        Ft = "ft",
        Mile = "mile",
        MetersPerSecond = "m/s",
        MilesPerHour = "mph",
        KilometersPerHour = "km/h",
        Kg = "kg",
        T = "t",
        Percent = "%",
    } words { M Km Ft Mile MetersPerSecond MilesPerHour KilometersPerHour Kg T Percent }
}

enumeration! {
    /// Unit of a distance (`e_unitDistance`).
    UnitDistance: UNIT_DISTANCE {
        M = "m",
        Km = "km",
        Ft = "ft",
        Mile = "mile",
    } words { M Km Ft Mile }
}

enumeration! {
    /// Unit of a mass (`e_unitMass`).
    UnitMass: UNIT_MASS {
        Kg = "kg",
        T = "t",
    } words { Kg T }
}

enumeration! {
    /// Unit of a slope (`e_unitSlope`).
    UnitSlope: UNIT_SLOPE {
        Percent = "%",
    } words { Percent }
}

enumeration! {
    /// Unit of a speed (`e_unitSpeed`).
    UnitSpeed: UNIT_SPEED {
        M = "m",
        MetersPerSecond = "m/s",
        Km = "km",
        MilesPerHour = "mph",
        Ft = "ft",
        KilometersPerHour = "km/h",
        Mile = "mile",
        Kg = "kg",
        T = "t",
        Percent = "%",
    } words { M MetersPerSecond Km MilesPerHour Ft KilometersPerHour Mile Kg T Percent }
}

enumeration! {
    /// Category of vehicles (`e_vehicleCategory`).
    VehicleCategory: VEHICLE_CATEGORY {
        Bicycle = "bicycle",
        Car = "car",
        SemiTrailer = "semiTrailer",
        Trailer = "trailer",
        Train = "train",
        Tram = "tram",
        Van = "van",
        Bus = "bus",
        HeavyTruck = "heavyTruck",
        MicroMobilityDevice = "microMobilityDevice",
        Motorcycle = "motorcycle",
        Other = "other",
        LandVehicle = "landVehicle",
        SemiTractor = "semiTractor",
        StandupScooter = "standupScooter",
        WorkMachine = "workMachine",
    } words { Bicycle Car SemiTrailer Trailer Train Tram Van Bus HeavyTruck MicroMobilityDevice Motorcycle Other LandVehicle SemiTractor StandupScooter WorkMachine }
}

enumeration! {
    /// Side of a parking space (`parkingSpacemarkingSide`).
    ParkingSpaceMarkingSide: PARKING_SPACE_MARKING_SIDE {
        Front = "front",
        Rear = "rear",
        Left = "left",
        Right = "right",
    } words { Front Rear Left Right }
}

enumeration! {
    /// Yes or no (`t_bool`).
    Bool: BOOL {
        True = "true",
        False = "false",
    } words { True False }
}

enumeration! {
    /// End of a road instead of a distance (`t_grEqZeroOrContactPoint`).
    RoadEnd: ROAD_END {
        Start = "start",
        End = "end",
    } words { Start End }
}

enumeration! {
    /// Words instead of a speed limit (`t_maxSpeed`).
    MaxSpeedWord: MAX_SPEED_WORD {
        NoLimit = "no limit",
        Undefined = "undefined",
    } words { NoLimit Undefined }
}

enumeration! {
    /// Yes or no, in other words (`t_yesNo`).
    YesNo: YES_NO {
        Yes = "yes",
        No = "no",
    } words { Yes No }
}
