//! What signals and objects mean.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

use crate::classes::classes;

classes! {
    /// No meaning.
    Other {
        /// Stated to have no meaning.
        None = 0, "none", false;
    }
    /// Traffic lights, by road user.
    Light {
        /// Light for vehicles.
        TrafficLight = 10, "traffic_light", true;
        /// Light for people on foot, or for people on foot and on bicycles.
        PedestrianLight = 11, "pedestrian_light", true;
        /// Light for bicycles.
        BicycleLight = 12, "bicycle_light", true;
        /// Light for trams and buses.
        PublicTransportLight = 13, "public_transport_light", true;
        /// Light that opens and closes a lane.
        LaneLight = 14, "lane_light", true;
        /// Light that warns and does not stop traffic.
        WarningLight = 15, "warning_light", true;
        /// Light of a level crossing.
        LevelCrossingLight = 16, "level_crossing_light", true;
    }
    /// Signs about right of way.
    RightOfWay {
        /// Stop and give way.
        Stop = 20, "stop", true;
        /// Give way.
        Yield = 21, "yield", true;
        /// The road has priority until it ends.
        PriorityRoad = 22, "priority_road", true;
        /// The road no longer has priority.
        EndOfPriorityRoad = 23, "end_of_priority_road", true;
        /// Priority at the next junction.
        PriorityAtNextJunction = 24, "priority_at_next_junction", true;
        /// Give way to oncoming traffic.
        YieldToOncoming = 25, "yield_to_oncoming", true;
        /// Priority over oncoming traffic.
        PriorityOverOncoming = 26, "priority_over_oncoming", true;
        /// Give way to trains.
        LevelCrossing = 27, "level_crossing", true;
        /// Roundabout.
        Roundabout = 28, "roundabout", true;
        /// Traffic from the right goes first.
        PriorityToTheRight = 29, "priority_to_the_right", true;
    }
    /// Signs about speed; the value is a speed.
    Speed {
        /// Not faster.
        SpeedLimit = 30, "speed_limit", true;
        /// End of a speed limit.
        EndOfSpeedLimit = 31, "end_of_speed_limit", true;
        /// Not faster in a zone.
        SpeedLimitZone = 32, "speed_limit_zone", true;
        /// End of such a zone.
        EndOfSpeedLimitZone = 33, "end_of_speed_limit_zone", true;
        /// Not slower.
        MinimumSpeed = 34, "minimum_speed", true;
        /// End of a minimum speed.
        EndOfMinimumSpeed = 35, "end_of_minimum_speed", true;
        /// Speed that is advised.
        AdvisorySpeed = 36, "advisory_speed", true;
        /// End of an advised speed.
        EndOfAdvisorySpeed = 37, "end_of_advisory_speed", true;
        /// End of all limits of speed and bans on overtaking.
        EndOfRestrictions = 38, "end_of_restrictions", true;
    }
    /// Prohibitory signs.
    Ban {
        /// No overtaking.
        NoOvertaking = 40, "no_overtaking", true;
        /// End of a ban on overtaking.
        EndOfNoOvertaking = 41, "end_of_no_overtaking", true;
        /// No overtaking by trucks.
        NoOvertakingByTrucks = 42, "no_overtaking_by_trucks", true;
        /// End of a ban on overtaking by trucks.
        EndOfNoOvertakingByTrucks = 43, "end_of_no_overtaking_by_trucks", true;
        /// No entry.
        NoEntry = 50, "no_entry", true;
        /// Closed to all vehicles.
        ClosedToVehicles = 51, "closed_to_vehicles", true;
        /// Closed to some: trucks, bicycles, people on foot, …
        ClosedToSome = 52, "closed_to_some", true;
        /// Closed to heavier vehicles; the value is a mass.
        MaximumWeight = 53, "maximum_weight", true;
        /// Closed to higher vehicles; the value is a length.
        MaximumHeight = 54, "maximum_height", true;
        /// Closed to wider vehicles; the value is a length.
        MaximumWidth = 55, "maximum_width", true;
        /// Closed to longer vehicles; the value is a length.
        MaximumLength = 56, "maximum_length", true;
        /// No parking.
        NoParking = 57, "no_parking", true;
        /// No stopping.
        NoStopping = 58, "no_stopping", true;
        /// No turn to the left.
        NoLeftTurn = 59, "no_left_turn", true;
        /// No turn to the right.
        NoRightTurn = 60, "no_right_turn", true;
        /// No turning round.
        NoUTurn = 61, "no_u_turn", true;
        /// No turn while the light is red.
        NoTurnOnRed = 62, "no_turn_on_red", true;
        /// A turn while the light is red is allowed.
        TurnOnRed = 63, "turn_on_red", true;
        /// No going straight on.
        NoStraightOn = 64, "no_straight_on", true;
        /// Distance to the vehicle ahead; the value is a length.
        MinimumDistance = 65, "minimum_distance", true;
    }
    /// Signs about directions and reserved ways.
    Direction {
        /// Direction that must be taken.
        MandatoryDirection = 70, "mandatory_direction", true;
        /// Side on which to pass.
        PassOnSide = 71, "pass_on_side", true;
        /// One-way road.
        OneWay = 72, "one_way", true;
        /// Which lane leads where; lanes that begin, end or merge.
        LaneAssignment = 73, "lane_assignment", true;
        /// Way for bicycles.
        BicyclePath = 74, "bicycle_path", true;
        /// Way for people on foot.
        Footpath = 75, "footpath", true;
        /// Way for people on foot and on bicycles.
        SharedPath = 76, "shared_path", true;
        /// Lane for buses.
        BusLane = 77, "bus_lane", true;
        /// Motorway begins.
        Motorway = 78, "motorway", true;
        /// Motorway ends.
        EndOfMotorway = 79, "end_of_motorway", true;
        /// Road for motor vehicles only begins.
        Expressway = 80, "expressway", true;
        /// Road for motor vehicles only ends.
        EndOfExpressway = 81, "end_of_expressway", true;
        /// Built-up area begins.
        Town = 82, "town", true;
        /// Built-up area ends.
        EndOfTown = 83, "end_of_town", true;
        /// Living street begins.
        LivingStreet = 84, "living_street", true;
        /// Living street ends.
        EndOfLivingStreet = 85, "end_of_living_street", true;
        /// Pedestrian zone, its beginning or end.
        PedestrianZone = 86, "pedestrian_zone", true;
        /// Parking is allowed.
        ParkingSign = 87, "parking_sign", true;
        /// Stop of buses or trams; taxi rank.
        BusStop = 88, "bus_stop", true;
        /// Sign of a pedestrian crossing.
        PedestrianCrossing = 89, "pedestrian_crossing", true;
    }
    /// Warning signs.
    Warning {
        /// Danger without a class of its own.
        Warning = 100, "warning", true;
        /// Road works.
        WarningRoadWorks = 101, "warning_road_works", true;
        /// Curve.
        WarningCurve = 102, "warning_curve", true;
        /// Junction.
        WarningJunction = 103, "warning_junction", true;
        /// Traffic light ahead.
        WarningTrafficLight = 104, "warning_traffic_light", true;
        /// People on foot, a crosswalk or children.
        WarningPedestrians = 105, "warning_pedestrians", true;
        /// Bicycles.
        WarningBicycles = 106, "warning_bicycles", true;
        /// Animals.
        WarningAnimals = 107, "warning_animals", true;
        /// Level crossing ahead.
        WarningLevelCrossing = 108, "warning_level_crossing", true;
        /// The road narrows.
        WarningNarrowing = 109, "warning_narrowing", true;
        /// Slippery road.
        WarningSlippery = 110, "warning_slippery", true;
        /// Slope.
        WarningSlope = 111, "warning_slope", true;
        /// Oncoming traffic.
        WarningOncoming = 112, "warning_oncoming", true;
        /// Stop or yield sign ahead.
        WarningYield = 113, "warning_yield", true;
        /// Congestion.
        WarningCongestion = 114, "warning_congestion", true;
    }
    /// Informative signs and their carriers.
    Information {
        /// Destinations, exits, road numbers, distances.
        GuideSign = 120, "guide_sign", true;
        /// Other information.
        InformationSign = 121, "information_sign", true;
        /// Plate that narrows or explains the sign above it.
        SupplementaryPlate = 122, "supplementary_plate", true;
        /// Board that carries signs.
        Board = 123, "board", true;
        /// Board whose signs change.
        VariableMessageBoard = 124, "variable_message_board", true;
        /// Name of a street.
        StreetName = 125, "street_name", true;
        /// Post, plate or beacon that marks the way.
        Delineator = 126, "delineator", true;
        /// Plate that closes a way: barrier boards, barrier lights.
        TrafficBarrierSign = 127, "traffic_barrier_sign", true;
    }
    /// Markings on the surface.
    Marking {
        /// Crosswalk.
        Crosswalk = 140, "crosswalk", true;
        /// Line at which to stop.
        StopLine = 141, "stop_line", true;
        /// Line at which to give way.
        WaitingLine = 142, "waiting_line", true;
        /// Arrow.
        Arrow = 143, "arrow", true;
        /// Other marking.
        Marking = 144, "marking", false;
        /// Striped area that must not be driven on.
        RestrictedArea = 145, "restricted_area", true;
        /// Crossing for bicycles.
        BicycleCrossing = 146, "bicycle_crossing", true;
        /// Number on the surface; the value is a speed.
        SpeedMarking = 147, "speed_marking", true;
        /// Line along or between lanes.
        LaneLine = 148, "lane_line", false;
    }
    /// Objects next to, on and above the road.
    Object {
        /// Parking space.
        ParkingSpace = 200, "parking_space", false;
        /// Barrier: guard rail, wall, fence, bollard, kerb.
        Barrier = 201, "barrier", true;
        /// Railing.
        Railing = 202, "railing", true;
        /// Sound barrier.
        SoundBarrier = 203, "sound_barrier", true;
        /// Pole, post.
        Pole = 204, "pole", true;
        /// Street lamp.
        StreetLamp = 205, "street_lamp", true;
        /// Gantry.
        Gantry = 206, "gantry", true;
        /// Tree.
        Tree = 207, "tree", true;
        /// Vegetation.
        Vegetation = 208, "vegetation", false;
        /// Building, wall of a house.
        Building = 209, "building", true;
        /// Bridge.
        Bridge = 210, "bridge", false;
        /// Tunnel.
        Tunnel = 211, "tunnel", false;
        /// Obstacle without a class of its own.
        Obstacle = 212, "obstacle", false;
        /// Traffic cone, warning light on a stand.
        TrafficCone = 213, "traffic_cone", false;
        /// Traffic island.
        TrafficIsland = 214, "traffic_island", false;
        /// Patch or damage of the surface.
        Patch = 215, "patch", false;
        /// Part of the surface: manhole, gully, rail.
        Surface = 216, "surface", false;
        /// Vehicle.
        Vehicle = 217, "vehicle", false;
        /// Person.
        Person = 218, "person", false;
        /// Source of wind.
        Wind = 219, "wind", false;
        /// Sign that is written as an object.
        Sign = 220, "sign", true;
        /// Bench, bin, hydrant, shelter.
        StreetFurniture = 221, "street_furniture", false;
        /// Station.
        Station = 222, "station", false;
        /// Platform.
        Platform = 223, "platform", false;
        /// Guard rail.
        GuardRail = 224, "guard_rail", true;
    }
}
