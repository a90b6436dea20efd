//! What signals and objects mean.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

use crate::classes::classes;

classes! {
    /// What has no meaning of its own.
    Other {
        /// Stated to have no meaning.
        None = 0, "none";
    }
    /// Traffic lights, by whom they are for.
    Light {
        /// Light for vehicles.
        TrafficLight = 10, "traffic_light";
        /// Light for people on foot, or for people on foot and on bicycles.
        PedestrianLight = 11, "pedestrian_light";
        /// Light for bicycles.
        BicycleLight = 12, "bicycle_light";
        /// Light for trams and buses.
        PublicTransportLight = 13, "public_transport_light";
        /// Light that opens and closes a lane.
        LaneLight = 14, "lane_light";
        /// Light that warns and does not stop traffic.
        WarningLight = 15, "warning_light";
        /// Light of a level crossing.
        LevelCrossingLight = 16, "level_crossing_light";
    }
    /// Signs that say who goes first.
    RightOfWay {
        /// Stop and give way.
        Stop = 20, "stop";
        /// Give way.
        Yield = 21, "yield";
        /// The road has priority until it ends.
        PriorityRoad = 22, "priority_road";
        /// The road no longer has priority.
        EndOfPriorityRoad = 23, "end_of_priority_road";
        /// Priority at the next junction.
        PriorityAtNextJunction = 24, "priority_at_next_junction";
        /// Give way to oncoming traffic.
        YieldToOncoming = 25, "yield_to_oncoming";
        /// Priority over oncoming traffic.
        PriorityOverOncoming = 26, "priority_over_oncoming";
        /// Give way to trains.
        LevelCrossing = 27, "level_crossing";
        /// Roundabout.
        Roundabout = 28, "roundabout";
        /// Traffic from the right goes first.
        PriorityToTheRight = 29, "priority_to_the_right";
    }
    /// Signs about speed; the value is a speed.
    Speed {
        /// Not faster.
        SpeedLimit = 30, "speed_limit";
        /// End of a speed limit.
        EndOfSpeedLimit = 31, "end_of_speed_limit";
        /// Not faster in a zone.
        SpeedLimitZone = 32, "speed_limit_zone";
        /// End of such a zone.
        EndOfSpeedLimitZone = 33, "end_of_speed_limit_zone";
        /// Not slower.
        MinimumSpeed = 34, "minimum_speed";
        /// End of a minimum speed.
        EndOfMinimumSpeed = 35, "end_of_minimum_speed";
        /// Speed that is advised.
        AdvisorySpeed = 36, "advisory_speed";
        /// End of an advised speed.
        EndOfAdvisorySpeed = 37, "end_of_advisory_speed";
        /// End of all limits of speed and bans on overtaking.
        EndOfRestrictions = 38, "end_of_restrictions";
    }
    /// Signs that forbid.
    Ban {
        /// No overtaking.
        NoOvertaking = 40, "no_overtaking";
        /// End of a ban on overtaking.
        EndOfNoOvertaking = 41, "end_of_no_overtaking";
        /// No overtaking by trucks.
        NoOvertakingByTrucks = 42, "no_overtaking_by_trucks";
        /// End of a ban on overtaking by trucks.
        EndOfNoOvertakingByTrucks = 43, "end_of_no_overtaking_by_trucks";
        /// No entry.
        NoEntry = 50, "no_entry";
        /// Closed to all vehicles.
        ClosedToVehicles = 51, "closed_to_vehicles";
        /// Closed to some: trucks, bicycles, people on foot, …
        ClosedToSome = 52, "closed_to_some";
        /// Closed to heavier vehicles; the value is a mass.
        MaximumWeight = 53, "maximum_weight";
        /// Closed to higher vehicles; the value is a length.
        MaximumHeight = 54, "maximum_height";
        /// Closed to wider vehicles; the value is a length.
        MaximumWidth = 55, "maximum_width";
        /// Closed to longer vehicles; the value is a length.
        MaximumLength = 56, "maximum_length";
        /// No parking.
        NoParking = 57, "no_parking";
        /// No stopping.
        NoStopping = 58, "no_stopping";
        /// No turn to the left.
        NoLeftTurn = 59, "no_left_turn";
        /// No turn to the right.
        NoRightTurn = 60, "no_right_turn";
        /// No turning round.
        NoUTurn = 61, "no_u_turn";
        /// No turn while the light is red.
        NoTurnOnRed = 62, "no_turn_on_red";
        /// A turn while the light is red is allowed.
        TurnOnRed = 63, "turn_on_red";
        /// No going straight on.
        NoStraightOn = 64, "no_straight_on";
        /// Distance to the vehicle ahead; the value is a length.
        MinimumDistance = 65, "minimum_distance";
    }
    /// Signs that say where to go, and for whom a way is.
    Direction {
        /// Direction that must be taken.
        MandatoryDirection = 70, "mandatory_direction";
        /// Side on which to pass.
        PassOnSide = 71, "pass_on_side";
        /// One-way road.
        OneWay = 72, "one_way";
        /// Which lane leads where; lanes that begin, end or merge.
        LaneAssignment = 73, "lane_assignment";
        /// Way for bicycles.
        BicyclePath = 74, "bicycle_path";
        /// Way for people on foot.
        Footpath = 75, "footpath";
        /// Way for people on foot and on bicycles.
        SharedPath = 76, "shared_path";
        /// Lane for buses.
        BusLane = 77, "bus_lane";
        /// Motorway begins.
        Motorway = 78, "motorway";
        /// Motorway ends.
        EndOfMotorway = 79, "end_of_motorway";
        /// Road for motor vehicles only begins.
        Expressway = 80, "expressway";
        /// Road for motor vehicles only ends.
        EndOfExpressway = 81, "end_of_expressway";
        /// Built-up area begins.
        Town = 82, "town";
        /// Built-up area ends.
        EndOfTown = 83, "end_of_town";
        /// Living street begins.
        LivingStreet = 84, "living_street";
        /// Living street ends.
        EndOfLivingStreet = 85, "end_of_living_street";
        /// Pedestrian zone, its beginning or end.
        PedestrianZone = 86, "pedestrian_zone";
        /// Parking is allowed.
        ParkingSign = 87, "parking_sign";
        /// Stop of buses or trams; taxi rank.
        BusStop = 88, "bus_stop";
        /// Sign of a pedestrian crossing.
        PedestrianCrossing = 89, "pedestrian_crossing";
    }
    /// Signs that warn.
    Warning {
        /// Danger without a class of its own.
        Warning = 100, "warning";
        /// Road works.
        WarningRoadWorks = 101, "warning_road_works";
        /// Curve.
        WarningCurve = 102, "warning_curve";
        /// Junction.
        WarningJunction = 103, "warning_junction";
        /// Traffic light ahead.
        WarningTrafficLight = 104, "warning_traffic_light";
        /// People on foot, a crosswalk or children.
        WarningPedestrians = 105, "warning_pedestrians";
        /// Bicycles.
        WarningBicycles = 106, "warning_bicycles";
        /// Animals.
        WarningAnimals = 107, "warning_animals";
        /// Level crossing ahead.
        WarningLevelCrossing = 108, "warning_level_crossing";
        /// The road narrows.
        WarningNarrowing = 109, "warning_narrowing";
        /// Slippery road.
        WarningSlippery = 110, "warning_slippery";
        /// Slope.
        WarningSlope = 111, "warning_slope";
        /// Oncoming traffic.
        WarningOncoming = 112, "warning_oncoming";
        /// Stop or yield sign ahead.
        WarningYield = 113, "warning_yield";
        /// Congestion.
        WarningCongestion = 114, "warning_congestion";
    }
    /// Signs that inform, and what carries them.
    Information {
        /// Destinations, exits, road numbers, distances.
        GuideSign = 120, "guide_sign";
        /// Other information.
        InformationSign = 121, "information_sign";
        /// Plate that narrows or explains the sign above it.
        SupplementaryPlate = 122, "supplementary_plate";
        /// Board that carries signs.
        Board = 123, "board";
        /// Board whose signs change.
        VariableMessageBoard = 124, "variable_message_board";
        /// Name of a street.
        StreetName = 125, "street_name";
        /// Post, plate or beacon that marks the way.
        Delineator = 126, "delineator";
        /// Plate that closes a way: barrier boards, barrier lights.
        TrafficBarrierSign = 127, "traffic_barrier_sign";
    }
    /// Markings on the surface.
    Marking {
        /// Crosswalk.
        Crosswalk = 140, "crosswalk";
        /// Line at which to stop.
        StopLine = 141, "stop_line";
        /// Line at which to give way.
        WaitingLine = 142, "waiting_line";
        /// Arrow.
        Arrow = 143, "arrow";
        /// Other marking.
        Marking = 144, "marking";
        /// Striped area that must not be driven on.
        RestrictedArea = 145, "restricted_area";
        /// Crossing for bicycles.
        BicycleCrossing = 146, "bicycle_crossing";
        /// Number on the surface; the value is a speed.
        SpeedMarking = 147, "speed_marking";
        /// Line along or between lanes.
        LaneLine = 148, "lane_line";
    }
    /// Things beside, on and above the road.
    Object {
        /// Parking space.
        ParkingSpace = 200, "parking_space";
        /// Barrier: guard rail, wall, fence, bollard, kerb.
        Barrier = 201, "barrier";
        /// Railing.
        Railing = 202, "railing";
        /// Sound barrier.
        SoundBarrier = 203, "sound_barrier";
        /// Pole, post.
        Pole = 204, "pole";
        /// Street lamp.
        StreetLamp = 205, "street_lamp";
        /// Gantry.
        Gantry = 206, "gantry";
        /// Tree.
        Tree = 207, "tree";
        /// Vegetation.
        Vegetation = 208, "vegetation";
        /// Building, wall of a house.
        Building = 209, "building";
        /// Bridge.
        Bridge = 210, "bridge";
        /// Tunnel.
        Tunnel = 211, "tunnel";
        /// Obstacle without a class of its own.
        Obstacle = 212, "obstacle";
        /// Traffic cone, warning light on a stand.
        TrafficCone = 213, "traffic_cone";
        /// Traffic island.
        TrafficIsland = 214, "traffic_island";
        /// Patch or damage of the surface.
        Patch = 215, "patch";
        /// Part of the surface: manhole, gully, rail.
        Surface = 216, "surface";
        /// Vehicle.
        Vehicle = 217, "vehicle";
        /// Person.
        Person = 218, "person";
        /// Source of wind.
        Wind = 219, "wind";
        /// Sign that is written as an object.
        Sign = 220, "sign";
        /// Bench, bin, hydrant, shelter.
        StreetFurniture = 221, "street_furniture";
        /// Station.
        Station = 222, "station";
        /// Platform.
        Platform = 223, "platform";
        /// Guard rail.
        GuardRail = 224, "guard_rail";
    }
}
