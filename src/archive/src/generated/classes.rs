//! What signals and objects mean.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// What a signal or object means (`docs/ontology.md`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u16)]
#[non_exhaustive]
pub enum Class {
    /// Stated to have no meaning.
    None = 0,
    /// Light for vehicles.
    TrafficLight = 10,
    /// Light for people on foot, or for people on foot and on bicycles.
    PedestrianLight = 11,
    /// Light for bicycles.
    BicycleLight = 12,
    /// Light for trams and buses.
    PublicTransportLight = 13,
    /// Light that opens and closes a lane.
    LaneLight = 14,
    /// Light that warns and does not stop traffic.
    WarningLight = 15,
    /// Light of a level crossing.
    LevelCrossingLight = 16,
    /// Stop and give way.
    Stop = 20,
    /// Give way.
    Yield = 21,
    /// The road has priority until it ends.
    PriorityRoad = 22,
    /// The road no longer has priority.
    EndOfPriorityRoad = 23,
    /// Priority at the next junction.
    PriorityAtNextJunction = 24,
    /// Give way to oncoming traffic.
    YieldToOncoming = 25,
    /// Priority over oncoming traffic.
    PriorityOverOncoming = 26,
    /// Give way to trains.
    LevelCrossing = 27,
    /// Roundabout.
    Roundabout = 28,
    /// Traffic from the right goes first.
    PriorityToTheRight = 29,
    /// Not faster.
    SpeedLimit = 30,
    /// End of a speed limit.
    EndOfSpeedLimit = 31,
    /// Not faster in a zone.
    SpeedLimitZone = 32,
    /// End of such a zone.
    EndOfSpeedLimitZone = 33,
    /// Not slower.
    MinimumSpeed = 34,
    /// End of a minimum speed.
    EndOfMinimumSpeed = 35,
    /// Speed that is advised.
    AdvisorySpeed = 36,
    /// End of an advised speed.
    EndOfAdvisorySpeed = 37,
    /// End of all limits of speed and bans on overtaking.
    EndOfRestrictions = 38,
    /// No overtaking.
    NoOvertaking = 40,
    /// End of a ban on overtaking.
    EndOfNoOvertaking = 41,
    /// No overtaking by trucks.
    NoOvertakingByTrucks = 42,
    /// End of a ban on overtaking by trucks.
    EndOfNoOvertakingByTrucks = 43,
    /// No entry.
    NoEntry = 50,
    /// Closed to all vehicles.
    ClosedToVehicles = 51,
    /// Closed to some: trucks, bicycles, people on foot, …
    ClosedToSome = 52,
    /// Closed to heavier vehicles; the value is a mass.
    MaximumWeight = 53,
    /// Closed to higher vehicles; the value is a length.
    MaximumHeight = 54,
    /// Closed to wider vehicles; the value is a length.
    MaximumWidth = 55,
    /// Closed to longer vehicles; the value is a length.
    MaximumLength = 56,
    /// No parking.
    NoParking = 57,
    /// No stopping.
    NoStopping = 58,
    /// No turn to the left.
    NoLeftTurn = 59,
    /// No turn to the right.
    NoRightTurn = 60,
    /// No turning round.
    NoUTurn = 61,
    /// No turn while the light is red.
    NoTurnOnRed = 62,
    /// A turn while the light is red is allowed.
    TurnOnRed = 63,
    /// No going straight on.
    NoStraightOn = 64,
    /// Distance to the vehicle ahead; the value is a length.
    MinimumDistance = 65,
    /// Direction that must be taken.
    MandatoryDirection = 70,
    /// Side on which to pass.
    PassOnSide = 71,
    /// One-way road.
    OneWay = 72,
    /// Which lane leads where; lanes that begin, end or merge.
    LaneAssignment = 73,
    /// Way for bicycles.
    BicyclePath = 74,
    /// Way for people on foot.
    Footpath = 75,
    /// Way for people on foot and on bicycles.
    SharedPath = 76,
    /// Lane for buses.
    BusLane = 77,
    /// Motorway begins.
    Motorway = 78,
    /// Motorway ends.
    EndOfMotorway = 79,
    /// Road for motor vehicles only begins.
    Expressway = 80,
    /// Road for motor vehicles only ends.
    EndOfExpressway = 81,
    /// Built-up area begins.
    Town = 82,
    /// Built-up area ends.
    EndOfTown = 83,
    /// Living street begins.
    LivingStreet = 84,
    /// Living street ends.
    EndOfLivingStreet = 85,
    /// Pedestrian zone, its beginning or end.
    PedestrianZone = 86,
    /// Parking is allowed.
    ParkingSign = 87,
    /// Stop of buses or trams; taxi rank.
    BusStop = 88,
    /// Sign of a pedestrian crossing.
    PedestrianCrossing = 89,
    /// Danger without a class of its own.
    Warning = 100,
    /// Road works.
    WarningRoadWorks = 101,
    /// Curve.
    WarningCurve = 102,
    /// Junction.
    WarningJunction = 103,
    /// Traffic light ahead.
    WarningTrafficLight = 104,
    /// People on foot, a crosswalk or children.
    WarningPedestrians = 105,
    /// Bicycles.
    WarningBicycles = 106,
    /// Animals.
    WarningAnimals = 107,
    /// Level crossing ahead.
    WarningLevelCrossing = 108,
    /// The road narrows.
    WarningNarrowing = 109,
    /// Slippery road.
    WarningSlippery = 110,
    /// Slope.
    WarningSlope = 111,
    /// Oncoming traffic.
    WarningOncoming = 112,
    /// Stop or yield sign ahead.
    WarningYield = 113,
    /// Congestion.
    WarningCongestion = 114,
    /// Destinations, exits, road numbers, distances.
    GuideSign = 120,
    /// Other information.
    InformationSign = 121,
    /// Plate that narrows or explains the sign above it.
    SupplementaryPlate = 122,
    /// Board that carries signs.
    Board = 123,
    /// Board whose signs change.
    VariableMessageBoard = 124,
    /// Name of a street.
    StreetName = 125,
    /// Post, plate or beacon that marks the way.
    Delineator = 126,
    /// Plate that closes a way: barrier boards, barrier lights.
    TrafficBarrierSign = 127,
    /// Crosswalk.
    Crosswalk = 140,
    /// Line at which to stop.
    StopLine = 141,
    /// Line at which to give way.
    WaitingLine = 142,
    /// Arrow.
    Arrow = 143,
    /// Other marking.
    Marking = 144,
    /// Striped area that must not be driven on.
    RestrictedArea = 145,
    /// Crossing for bicycles.
    BicycleCrossing = 146,
    /// Number on the surface; the value is a speed.
    SpeedMarking = 147,
    /// Line along or between lanes.
    LaneLine = 148,
    /// Parking space.
    ParkingSpace = 200,
    /// Barrier: guard rail, wall, fence, bollard, kerb.
    Barrier = 201,
    /// Railing.
    Railing = 202,
    /// Sound barrier.
    SoundBarrier = 203,
    /// Pole, post.
    Pole = 204,
    /// Street lamp.
    StreetLamp = 205,
    /// Gantry.
    Gantry = 206,
    /// Tree.
    Tree = 207,
    /// Vegetation.
    Vegetation = 208,
    /// Building, wall of a house.
    Building = 209,
    /// Bridge.
    Bridge = 210,
    /// Tunnel.
    Tunnel = 211,
    /// Obstacle without a class of its own.
    Obstacle = 212,
    /// Traffic cone, warning light on a stand.
    TrafficCone = 213,
    /// Traffic island.
    TrafficIsland = 214,
    /// Patch or damage of the surface.
    Patch = 215,
    /// Part of the surface: manhole, gully, rail.
    Surface = 216,
    /// Vehicle.
    Vehicle = 217,
    /// Person.
    Person = 218,
    /// Source of wind.
    Wind = 219,
    /// Sign that is written as an object.
    Sign = 220,
    /// Bench, bin, hydrant, shelter.
    StreetFurniture = 221,
    /// Station.
    Station = 222,
    /// Platform.
    Platform = 223,
    /// Guard rail.
    GuardRail = 224,
    /// A code that no table maps.
    Unknown = 65535,
}

/// Kind of classes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ClassGroup {
    /// What has no meaning of its own.
    Other,
    /// Traffic lights, by whom they are for.
    Light,
    /// Signs that say who goes first.
    RightOfWay,
    /// Signs about speed; the value is a speed.
    Speed,
    /// Signs that forbid.
    Ban,
    /// Signs that say where to go, and for whom a way is.
    Direction,
    /// Signs that warn.
    Warning,
    /// Signs that inform, and what carries them.
    Information,
    /// Markings on the surface.
    Marking,
    /// Things beside, on and above the road.
    Object,
    /// Not known.
    Unknown,
}

impl Class {
    /// All classes, by code.
    pub const ALL: &[Self] = &[
        Self::None,
        Self::TrafficLight,
        Self::PedestrianLight,
        Self::BicycleLight,
        Self::PublicTransportLight,
        Self::LaneLight,
        Self::WarningLight,
        Self::LevelCrossingLight,
        Self::Stop,
        Self::Yield,
        Self::PriorityRoad,
        Self::EndOfPriorityRoad,
        Self::PriorityAtNextJunction,
        Self::YieldToOncoming,
        Self::PriorityOverOncoming,
        Self::LevelCrossing,
        Self::Roundabout,
        Self::PriorityToTheRight,
        Self::SpeedLimit,
        Self::EndOfSpeedLimit,
        Self::SpeedLimitZone,
        Self::EndOfSpeedLimitZone,
        Self::MinimumSpeed,
        Self::EndOfMinimumSpeed,
        Self::AdvisorySpeed,
        Self::EndOfAdvisorySpeed,
        Self::EndOfRestrictions,
        Self::NoOvertaking,
        Self::EndOfNoOvertaking,
        Self::NoOvertakingByTrucks,
        Self::EndOfNoOvertakingByTrucks,
        Self::NoEntry,
        Self::ClosedToVehicles,
        Self::ClosedToSome,
        Self::MaximumWeight,
        Self::MaximumHeight,
        Self::MaximumWidth,
        Self::MaximumLength,
        Self::NoParking,
        Self::NoStopping,
        Self::NoLeftTurn,
        Self::NoRightTurn,
        Self::NoUTurn,
        Self::NoTurnOnRed,
        Self::TurnOnRed,
        Self::NoStraightOn,
        Self::MinimumDistance,
        Self::MandatoryDirection,
        Self::PassOnSide,
        Self::OneWay,
        Self::LaneAssignment,
        Self::BicyclePath,
        Self::Footpath,
        Self::SharedPath,
        Self::BusLane,
        Self::Motorway,
        Self::EndOfMotorway,
        Self::Expressway,
        Self::EndOfExpressway,
        Self::Town,
        Self::EndOfTown,
        Self::LivingStreet,
        Self::EndOfLivingStreet,
        Self::PedestrianZone,
        Self::ParkingSign,
        Self::BusStop,
        Self::PedestrianCrossing,
        Self::Warning,
        Self::WarningRoadWorks,
        Self::WarningCurve,
        Self::WarningJunction,
        Self::WarningTrafficLight,
        Self::WarningPedestrians,
        Self::WarningBicycles,
        Self::WarningAnimals,
        Self::WarningLevelCrossing,
        Self::WarningNarrowing,
        Self::WarningSlippery,
        Self::WarningSlope,
        Self::WarningOncoming,
        Self::WarningYield,
        Self::WarningCongestion,
        Self::GuideSign,
        Self::InformationSign,
        Self::SupplementaryPlate,
        Self::Board,
        Self::VariableMessageBoard,
        Self::StreetName,
        Self::Delineator,
        Self::TrafficBarrierSign,
        Self::Crosswalk,
        Self::StopLine,
        Self::WaitingLine,
        Self::Arrow,
        Self::Marking,
        Self::RestrictedArea,
        Self::BicycleCrossing,
        Self::SpeedMarking,
        Self::LaneLine,
        Self::ParkingSpace,
        Self::Barrier,
        Self::Railing,
        Self::SoundBarrier,
        Self::Pole,
        Self::StreetLamp,
        Self::Gantry,
        Self::Tree,
        Self::Vegetation,
        Self::Building,
        Self::Bridge,
        Self::Tunnel,
        Self::Obstacle,
        Self::TrafficCone,
        Self::TrafficIsland,
        Self::Patch,
        Self::Surface,
        Self::Vehicle,
        Self::Person,
        Self::Wind,
        Self::Sign,
        Self::StreetFurniture,
        Self::Station,
        Self::Platform,
        Self::GuardRail,
    ];

    /// The class of a code; codes that this version does not know give `Unknown`.
    pub const fn from_code(code: u16) -> Self {
        match code {
            0 => Self::None,
            10 => Self::TrafficLight,
            11 => Self::PedestrianLight,
            12 => Self::BicycleLight,
            13 => Self::PublicTransportLight,
            14 => Self::LaneLight,
            15 => Self::WarningLight,
            16 => Self::LevelCrossingLight,
            20 => Self::Stop,
            21 => Self::Yield,
            22 => Self::PriorityRoad,
            23 => Self::EndOfPriorityRoad,
            24 => Self::PriorityAtNextJunction,
            25 => Self::YieldToOncoming,
            26 => Self::PriorityOverOncoming,
            27 => Self::LevelCrossing,
            28 => Self::Roundabout,
            29 => Self::PriorityToTheRight,
            30 => Self::SpeedLimit,
            31 => Self::EndOfSpeedLimit,
            32 => Self::SpeedLimitZone,
            33 => Self::EndOfSpeedLimitZone,
            34 => Self::MinimumSpeed,
            35 => Self::EndOfMinimumSpeed,
            36 => Self::AdvisorySpeed,
            37 => Self::EndOfAdvisorySpeed,
            38 => Self::EndOfRestrictions,
            40 => Self::NoOvertaking,
            41 => Self::EndOfNoOvertaking,
            42 => Self::NoOvertakingByTrucks,
            43 => Self::EndOfNoOvertakingByTrucks,
            50 => Self::NoEntry,
            51 => Self::ClosedToVehicles,
            52 => Self::ClosedToSome,
            53 => Self::MaximumWeight,
            54 => Self::MaximumHeight,
            55 => Self::MaximumWidth,
            56 => Self::MaximumLength,
            57 => Self::NoParking,
            58 => Self::NoStopping,
            59 => Self::NoLeftTurn,
            60 => Self::NoRightTurn,
            61 => Self::NoUTurn,
            62 => Self::NoTurnOnRed,
            63 => Self::TurnOnRed,
            64 => Self::NoStraightOn,
            65 => Self::MinimumDistance,
            70 => Self::MandatoryDirection,
            71 => Self::PassOnSide,
            72 => Self::OneWay,
            73 => Self::LaneAssignment,
            74 => Self::BicyclePath,
            75 => Self::Footpath,
            76 => Self::SharedPath,
            77 => Self::BusLane,
            78 => Self::Motorway,
            79 => Self::EndOfMotorway,
            80 => Self::Expressway,
            81 => Self::EndOfExpressway,
            82 => Self::Town,
            83 => Self::EndOfTown,
            84 => Self::LivingStreet,
            85 => Self::EndOfLivingStreet,
            86 => Self::PedestrianZone,
            87 => Self::ParkingSign,
            88 => Self::BusStop,
            89 => Self::PedestrianCrossing,
            100 => Self::Warning,
            101 => Self::WarningRoadWorks,
            102 => Self::WarningCurve,
            103 => Self::WarningJunction,
            104 => Self::WarningTrafficLight,
            105 => Self::WarningPedestrians,
            106 => Self::WarningBicycles,
            107 => Self::WarningAnimals,
            108 => Self::WarningLevelCrossing,
            109 => Self::WarningNarrowing,
            110 => Self::WarningSlippery,
            111 => Self::WarningSlope,
            112 => Self::WarningOncoming,
            113 => Self::WarningYield,
            114 => Self::WarningCongestion,
            120 => Self::GuideSign,
            121 => Self::InformationSign,
            122 => Self::SupplementaryPlate,
            123 => Self::Board,
            124 => Self::VariableMessageBoard,
            125 => Self::StreetName,
            126 => Self::Delineator,
            127 => Self::TrafficBarrierSign,
            140 => Self::Crosswalk,
            141 => Self::StopLine,
            142 => Self::WaitingLine,
            143 => Self::Arrow,
            144 => Self::Marking,
            145 => Self::RestrictedArea,
            146 => Self::BicycleCrossing,
            147 => Self::SpeedMarking,
            148 => Self::LaneLine,
            200 => Self::ParkingSpace,
            201 => Self::Barrier,
            202 => Self::Railing,
            203 => Self::SoundBarrier,
            204 => Self::Pole,
            205 => Self::StreetLamp,
            206 => Self::Gantry,
            207 => Self::Tree,
            208 => Self::Vegetation,
            209 => Self::Building,
            210 => Self::Bridge,
            211 => Self::Tunnel,
            212 => Self::Obstacle,
            213 => Self::TrafficCone,
            214 => Self::TrafficIsland,
            215 => Self::Patch,
            216 => Self::Surface,
            217 => Self::Vehicle,
            218 => Self::Person,
            219 => Self::Wind,
            220 => Self::Sign,
            221 => Self::StreetFurniture,
            222 => Self::Station,
            223 => Self::Platform,
            224 => Self::GuardRail,
            _ => Self::Unknown,
        }
    }

    /// The code.
    pub const fn code(self) -> u16 {
        self as u16
    }

    /// The class of a name; names that this version does not know give `Unknown`.
    pub fn from_name(name: &str) -> Self {
        match name {
            "none" => Self::None,
            "traffic_light" => Self::TrafficLight,
            "pedestrian_light" => Self::PedestrianLight,
            "bicycle_light" => Self::BicycleLight,
            "public_transport_light" => Self::PublicTransportLight,
            "lane_light" => Self::LaneLight,
            "warning_light" => Self::WarningLight,
            "level_crossing_light" => Self::LevelCrossingLight,
            "stop" => Self::Stop,
            "yield" => Self::Yield,
            "priority_road" => Self::PriorityRoad,
            "end_of_priority_road" => Self::EndOfPriorityRoad,
            "priority_at_next_junction" => Self::PriorityAtNextJunction,
            "yield_to_oncoming" => Self::YieldToOncoming,
            "priority_over_oncoming" => Self::PriorityOverOncoming,
            "level_crossing" => Self::LevelCrossing,
            "roundabout" => Self::Roundabout,
            "priority_to_the_right" => Self::PriorityToTheRight,
            "speed_limit" => Self::SpeedLimit,
            "end_of_speed_limit" => Self::EndOfSpeedLimit,
            "speed_limit_zone" => Self::SpeedLimitZone,
            "end_of_speed_limit_zone" => Self::EndOfSpeedLimitZone,
            "minimum_speed" => Self::MinimumSpeed,
            "end_of_minimum_speed" => Self::EndOfMinimumSpeed,
            "advisory_speed" => Self::AdvisorySpeed,
            "end_of_advisory_speed" => Self::EndOfAdvisorySpeed,
            "end_of_restrictions" => Self::EndOfRestrictions,
            "no_overtaking" => Self::NoOvertaking,
            "end_of_no_overtaking" => Self::EndOfNoOvertaking,
            "no_overtaking_by_trucks" => Self::NoOvertakingByTrucks,
            "end_of_no_overtaking_by_trucks" => Self::EndOfNoOvertakingByTrucks,
            "no_entry" => Self::NoEntry,
            "closed_to_vehicles" => Self::ClosedToVehicles,
            "closed_to_some" => Self::ClosedToSome,
            "maximum_weight" => Self::MaximumWeight,
            "maximum_height" => Self::MaximumHeight,
            "maximum_width" => Self::MaximumWidth,
            "maximum_length" => Self::MaximumLength,
            "no_parking" => Self::NoParking,
            "no_stopping" => Self::NoStopping,
            "no_left_turn" => Self::NoLeftTurn,
            "no_right_turn" => Self::NoRightTurn,
            "no_u_turn" => Self::NoUTurn,
            "no_turn_on_red" => Self::NoTurnOnRed,
            "turn_on_red" => Self::TurnOnRed,
            "no_straight_on" => Self::NoStraightOn,
            "minimum_distance" => Self::MinimumDistance,
            "mandatory_direction" => Self::MandatoryDirection,
            "pass_on_side" => Self::PassOnSide,
            "one_way" => Self::OneWay,
            "lane_assignment" => Self::LaneAssignment,
            "bicycle_path" => Self::BicyclePath,
            "footpath" => Self::Footpath,
            "shared_path" => Self::SharedPath,
            "bus_lane" => Self::BusLane,
            "motorway" => Self::Motorway,
            "end_of_motorway" => Self::EndOfMotorway,
            "expressway" => Self::Expressway,
            "end_of_expressway" => Self::EndOfExpressway,
            "town" => Self::Town,
            "end_of_town" => Self::EndOfTown,
            "living_street" => Self::LivingStreet,
            "end_of_living_street" => Self::EndOfLivingStreet,
            "pedestrian_zone" => Self::PedestrianZone,
            "parking_sign" => Self::ParkingSign,
            "bus_stop" => Self::BusStop,
            "pedestrian_crossing" => Self::PedestrianCrossing,
            "warning" => Self::Warning,
            "warning_road_works" => Self::WarningRoadWorks,
            "warning_curve" => Self::WarningCurve,
            "warning_junction" => Self::WarningJunction,
            "warning_traffic_light" => Self::WarningTrafficLight,
            "warning_pedestrians" => Self::WarningPedestrians,
            "warning_bicycles" => Self::WarningBicycles,
            "warning_animals" => Self::WarningAnimals,
            "warning_level_crossing" => Self::WarningLevelCrossing,
            "warning_narrowing" => Self::WarningNarrowing,
            "warning_slippery" => Self::WarningSlippery,
            "warning_slope" => Self::WarningSlope,
            "warning_oncoming" => Self::WarningOncoming,
            "warning_yield" => Self::WarningYield,
            "warning_congestion" => Self::WarningCongestion,
            "guide_sign" => Self::GuideSign,
            "information_sign" => Self::InformationSign,
            "supplementary_plate" => Self::SupplementaryPlate,
            "board" => Self::Board,
            "variable_message_board" => Self::VariableMessageBoard,
            "street_name" => Self::StreetName,
            "delineator" => Self::Delineator,
            "traffic_barrier_sign" => Self::TrafficBarrierSign,
            "crosswalk" => Self::Crosswalk,
            "stop_line" => Self::StopLine,
            "waiting_line" => Self::WaitingLine,
            "arrow" => Self::Arrow,
            "marking" => Self::Marking,
            "restricted_area" => Self::RestrictedArea,
            "bicycle_crossing" => Self::BicycleCrossing,
            "speed_marking" => Self::SpeedMarking,
            "lane_line" => Self::LaneLine,
            "parking_space" => Self::ParkingSpace,
            "barrier" => Self::Barrier,
            "railing" => Self::Railing,
            "sound_barrier" => Self::SoundBarrier,
            "pole" => Self::Pole,
            "street_lamp" => Self::StreetLamp,
            "gantry" => Self::Gantry,
            "tree" => Self::Tree,
            "vegetation" => Self::Vegetation,
            "building" => Self::Building,
            "bridge" => Self::Bridge,
            "tunnel" => Self::Tunnel,
            "obstacle" => Self::Obstacle,
            "traffic_cone" => Self::TrafficCone,
            "traffic_island" => Self::TrafficIsland,
            "patch" => Self::Patch,
            "surface" => Self::Surface,
            "vehicle" => Self::Vehicle,
            "person" => Self::Person,
            "wind" => Self::Wind,
            "sign" => Self::Sign,
            "street_furniture" => Self::StreetFurniture,
            "station" => Self::Station,
            "platform" => Self::Platform,
            "guard_rail" => Self::GuardRail,
            _ => Self::Unknown,
        }
    }

    /// The name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::TrafficLight => "traffic_light",
            Self::PedestrianLight => "pedestrian_light",
            Self::BicycleLight => "bicycle_light",
            Self::PublicTransportLight => "public_transport_light",
            Self::LaneLight => "lane_light",
            Self::WarningLight => "warning_light",
            Self::LevelCrossingLight => "level_crossing_light",
            Self::Stop => "stop",
            Self::Yield => "yield",
            Self::PriorityRoad => "priority_road",
            Self::EndOfPriorityRoad => "end_of_priority_road",
            Self::PriorityAtNextJunction => "priority_at_next_junction",
            Self::YieldToOncoming => "yield_to_oncoming",
            Self::PriorityOverOncoming => "priority_over_oncoming",
            Self::LevelCrossing => "level_crossing",
            Self::Roundabout => "roundabout",
            Self::PriorityToTheRight => "priority_to_the_right",
            Self::SpeedLimit => "speed_limit",
            Self::EndOfSpeedLimit => "end_of_speed_limit",
            Self::SpeedLimitZone => "speed_limit_zone",
            Self::EndOfSpeedLimitZone => "end_of_speed_limit_zone",
            Self::MinimumSpeed => "minimum_speed",
            Self::EndOfMinimumSpeed => "end_of_minimum_speed",
            Self::AdvisorySpeed => "advisory_speed",
            Self::EndOfAdvisorySpeed => "end_of_advisory_speed",
            Self::EndOfRestrictions => "end_of_restrictions",
            Self::NoOvertaking => "no_overtaking",
            Self::EndOfNoOvertaking => "end_of_no_overtaking",
            Self::NoOvertakingByTrucks => "no_overtaking_by_trucks",
            Self::EndOfNoOvertakingByTrucks => "end_of_no_overtaking_by_trucks",
            Self::NoEntry => "no_entry",
            Self::ClosedToVehicles => "closed_to_vehicles",
            Self::ClosedToSome => "closed_to_some",
            Self::MaximumWeight => "maximum_weight",
            Self::MaximumHeight => "maximum_height",
            Self::MaximumWidth => "maximum_width",
            Self::MaximumLength => "maximum_length",
            Self::NoParking => "no_parking",
            Self::NoStopping => "no_stopping",
            Self::NoLeftTurn => "no_left_turn",
            Self::NoRightTurn => "no_right_turn",
            Self::NoUTurn => "no_u_turn",
            Self::NoTurnOnRed => "no_turn_on_red",
            Self::TurnOnRed => "turn_on_red",
            Self::NoStraightOn => "no_straight_on",
            Self::MinimumDistance => "minimum_distance",
            Self::MandatoryDirection => "mandatory_direction",
            Self::PassOnSide => "pass_on_side",
            Self::OneWay => "one_way",
            Self::LaneAssignment => "lane_assignment",
            Self::BicyclePath => "bicycle_path",
            Self::Footpath => "footpath",
            Self::SharedPath => "shared_path",
            Self::BusLane => "bus_lane",
            Self::Motorway => "motorway",
            Self::EndOfMotorway => "end_of_motorway",
            Self::Expressway => "expressway",
            Self::EndOfExpressway => "end_of_expressway",
            Self::Town => "town",
            Self::EndOfTown => "end_of_town",
            Self::LivingStreet => "living_street",
            Self::EndOfLivingStreet => "end_of_living_street",
            Self::PedestrianZone => "pedestrian_zone",
            Self::ParkingSign => "parking_sign",
            Self::BusStop => "bus_stop",
            Self::PedestrianCrossing => "pedestrian_crossing",
            Self::Warning => "warning",
            Self::WarningRoadWorks => "warning_road_works",
            Self::WarningCurve => "warning_curve",
            Self::WarningJunction => "warning_junction",
            Self::WarningTrafficLight => "warning_traffic_light",
            Self::WarningPedestrians => "warning_pedestrians",
            Self::WarningBicycles => "warning_bicycles",
            Self::WarningAnimals => "warning_animals",
            Self::WarningLevelCrossing => "warning_level_crossing",
            Self::WarningNarrowing => "warning_narrowing",
            Self::WarningSlippery => "warning_slippery",
            Self::WarningSlope => "warning_slope",
            Self::WarningOncoming => "warning_oncoming",
            Self::WarningYield => "warning_yield",
            Self::WarningCongestion => "warning_congestion",
            Self::GuideSign => "guide_sign",
            Self::InformationSign => "information_sign",
            Self::SupplementaryPlate => "supplementary_plate",
            Self::Board => "board",
            Self::VariableMessageBoard => "variable_message_board",
            Self::StreetName => "street_name",
            Self::Delineator => "delineator",
            Self::TrafficBarrierSign => "traffic_barrier_sign",
            Self::Crosswalk => "crosswalk",
            Self::StopLine => "stop_line",
            Self::WaitingLine => "waiting_line",
            Self::Arrow => "arrow",
            Self::Marking => "marking",
            Self::RestrictedArea => "restricted_area",
            Self::BicycleCrossing => "bicycle_crossing",
            Self::SpeedMarking => "speed_marking",
            Self::LaneLine => "lane_line",
            Self::ParkingSpace => "parking_space",
            Self::Barrier => "barrier",
            Self::Railing => "railing",
            Self::SoundBarrier => "sound_barrier",
            Self::Pole => "pole",
            Self::StreetLamp => "street_lamp",
            Self::Gantry => "gantry",
            Self::Tree => "tree",
            Self::Vegetation => "vegetation",
            Self::Building => "building",
            Self::Bridge => "bridge",
            Self::Tunnel => "tunnel",
            Self::Obstacle => "obstacle",
            Self::TrafficCone => "traffic_cone",
            Self::TrafficIsland => "traffic_island",
            Self::Patch => "patch",
            Self::Surface => "surface",
            Self::Vehicle => "vehicle",
            Self::Person => "person",
            Self::Wind => "wind",
            Self::Sign => "sign",
            Self::StreetFurniture => "street_furniture",
            Self::Station => "station",
            Self::Platform => "platform",
            Self::GuardRail => "guard_rail",
            Self::Unknown => "unknown",
        }
    }

    /// The kind of class.
    pub const fn group(self) -> ClassGroup {
        match self {
            Self::None => ClassGroup::Other,
            Self::TrafficLight
            | Self::PedestrianLight
            | Self::BicycleLight
            | Self::PublicTransportLight
            | Self::LaneLight
            | Self::WarningLight
            | Self::LevelCrossingLight => ClassGroup::Light,
            Self::Stop
            | Self::Yield
            | Self::PriorityRoad
            | Self::EndOfPriorityRoad
            | Self::PriorityAtNextJunction
            | Self::YieldToOncoming
            | Self::PriorityOverOncoming
            | Self::LevelCrossing
            | Self::Roundabout
            | Self::PriorityToTheRight => ClassGroup::RightOfWay,
            Self::SpeedLimit
            | Self::EndOfSpeedLimit
            | Self::SpeedLimitZone
            | Self::EndOfSpeedLimitZone
            | Self::MinimumSpeed
            | Self::EndOfMinimumSpeed
            | Self::AdvisorySpeed
            | Self::EndOfAdvisorySpeed
            | Self::EndOfRestrictions => ClassGroup::Speed,
            Self::NoOvertaking
            | Self::EndOfNoOvertaking
            | Self::NoOvertakingByTrucks
            | Self::EndOfNoOvertakingByTrucks
            | Self::NoEntry
            | Self::ClosedToVehicles
            | Self::ClosedToSome
            | Self::MaximumWeight
            | Self::MaximumHeight
            | Self::MaximumWidth
            | Self::MaximumLength
            | Self::NoParking
            | Self::NoStopping
            | Self::NoLeftTurn
            | Self::NoRightTurn
            | Self::NoUTurn
            | Self::NoTurnOnRed
            | Self::TurnOnRed
            | Self::NoStraightOn
            | Self::MinimumDistance => ClassGroup::Ban,
            Self::MandatoryDirection
            | Self::PassOnSide
            | Self::OneWay
            | Self::LaneAssignment
            | Self::BicyclePath
            | Self::Footpath
            | Self::SharedPath
            | Self::BusLane
            | Self::Motorway
            | Self::EndOfMotorway
            | Self::Expressway
            | Self::EndOfExpressway
            | Self::Town
            | Self::EndOfTown
            | Self::LivingStreet
            | Self::EndOfLivingStreet
            | Self::PedestrianZone
            | Self::ParkingSign
            | Self::BusStop
            | Self::PedestrianCrossing => ClassGroup::Direction,
            Self::Warning
            | Self::WarningRoadWorks
            | Self::WarningCurve
            | Self::WarningJunction
            | Self::WarningTrafficLight
            | Self::WarningPedestrians
            | Self::WarningBicycles
            | Self::WarningAnimals
            | Self::WarningLevelCrossing
            | Self::WarningNarrowing
            | Self::WarningSlippery
            | Self::WarningSlope
            | Self::WarningOncoming
            | Self::WarningYield
            | Self::WarningCongestion => ClassGroup::Warning,
            Self::GuideSign
            | Self::InformationSign
            | Self::SupplementaryPlate
            | Self::Board
            | Self::VariableMessageBoard
            | Self::StreetName
            | Self::Delineator
            | Self::TrafficBarrierSign => ClassGroup::Information,
            Self::Crosswalk
            | Self::StopLine
            | Self::WaitingLine
            | Self::Arrow
            | Self::Marking
            | Self::RestrictedArea
            | Self::BicycleCrossing
            | Self::SpeedMarking
            | Self::LaneLine => ClassGroup::Marking,
            Self::ParkingSpace
            | Self::Barrier
            | Self::Railing
            | Self::SoundBarrier
            | Self::Pole
            | Self::StreetLamp
            | Self::Gantry
            | Self::Tree
            | Self::Vegetation
            | Self::Building
            | Self::Bridge
            | Self::Tunnel
            | Self::Obstacle
            | Self::TrafficCone
            | Self::TrafficIsland
            | Self::Patch
            | Self::Surface
            | Self::Vehicle
            | Self::Person
            | Self::Wind
            | Self::Sign
            | Self::StreetFurniture
            | Self::Station
            | Self::Platform
            | Self::GuardRail => ClassGroup::Object,
            Self::Unknown => ClassGroup::Unknown,
        }
    }
}
