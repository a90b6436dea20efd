//! Codes of the lane graph's tables.

use crate::codes::{LaneType, codes};

/// Bits of a node's `flags`.
pub mod node_flags {
    /// Travels towards +s (else towards −s).
    pub const FORWARD: u8 = 1;
    /// A change to the node on the left is allowed.
    pub const CHANGE_LEFT: u8 = 2;
    /// A change to the node on the right is allowed.
    pub const CHANGE_RIGHT: u8 = 4;
}

/// Bits of an edge's `flags`.
pub mod edge_flags {
    /// Closes a loop: without these edges the graph has no cycle.
    pub const CLOSES_LOOP: u8 = 1;
}

codes! {
    /// Where an edge of the lane graph comes from.
    EdgeKind {
        /// Two pieces of one lane.
        Within = 0, "within a lane";
        /// A lane link inside a road.
        Section = 1, "inside a road";
        /// A lane link over a road's end.
        Road = 2, "over a road's end";
        /// A lane link of a connection.
        Connection = 3, "connection";
        /// A connection without lane links: lanes keep their numbers (OpenDRIVE 1.4).
        Implied = 4, "implied by a connection";
        /// A place inside a road where a virtual junction attaches.
        Virtual = 5, "virtual junction";
        /// An end of a path across a road (OpenDRIVE 1.8, `crossPath`).
        CrossPath = 6, "crossing path";
    }
}

codes! {
    /// How two lanes of a junction conflict.
    ConflictKind {
        /// Their ways cross.
        Cross = 0, "cross";
        /// They lead into the same lane.
        Merge = 1, "merge";
        /// Their areas meet without crossing or merging.
        Overlap = 2, "overlap";
        /// Their roads cross on a junction of type `crossing` (1.8).
        Crossing = 3, "crossing";
    }
}

codes! {
    /// Who travels (OpenDRIVE 1.8.1, 11.8.1; e_accessRestrictionType, and what lane types add).
    VehicleClass {
        /// `passengerCar`
        PassengerCar = 0, "passengerCar";
        /// `truck`
        Truck = 1, "truck";
        /// `bus`
        Bus = 2, "bus";
        /// `taxi`
        Taxi = 3, "taxi";
        /// `motorcycle`
        Motorcycle = 4, "motorcycle";
        /// `emergency`
        Emergency = 5, "emergency";
        /// `delivery`
        Delivery = 6, "delivery";
        /// `HOV`: a car with several people in it.
        Hov = 7, "HOV";
        /// `autonomousTraffic`
        Autonomous = 8, "autonomousTraffic";
        /// `throughTraffic`: a car that neither starts nor ends nearby.
        Through = 9, "throughTraffic";
        /// `simulator`
        Simulator = 10, "simulator";
        /// `bicycle`
        Bicycle = 11, "bicycle";
        /// `pedestrian`
        Pedestrian = 12, "pedestrian";
        /// Trams.
        Tram = 13, "tram";
        /// Trains.
        Train = 14, "train";
    }
}

impl VehicleClass {
    /// Classes that drive on driving lanes with a motor; landmarks hold for them.
    pub const MOTOR: u16 = 0x07ff;

    /// The class's bit in a node's `access`.
    pub const fn bit(self) -> u16 {
        match self {
            Self::Unknown => 0,
            known => 1 << (known as u8),
        }
    }

    /// Classes that may use a lane of a type where no access record says otherwise (OpenDRIVE 1.8.1, 11.7.1).
    pub const fn of_lane_type(kind: LaneType) -> u16 {
        use LaneType::*;
        let emergency = Self::Emergency.bit();
        match kind {
            Driving | Entry | Exit | OnRamp | OffRamp | ConnectingRamp | SlipLane
            | Bidirectional | RoadWorks | MwyEntry | MwyExit => Self::MOTOR | Self::Bicycle.bit(),
            Bus => Self::Bus.bit() | emergency,
            Taxi => Self::Taxi.bit() | emergency,
            Hov => Self::Hov.bit() | Self::Bus.bit() | Self::Motorcycle.bit() | emergency,
            Stop | Shoulder | Border | Restricted => emergency,
            Biking => Self::Bicycle.bit(),
            Sidewalk | Walking => Self::Pedestrian.bit(),
            Shared => Self::Bicycle.bit() | Self::Pedestrian.bit(),
            Tram => Self::Tram.bit(),
            Rail => Self::Train.bit(),
            _ => 0,
        }
    }
}
