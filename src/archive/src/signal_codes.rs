//! Codes of the tables of signals.

use crate::codes::codes;

/// Bits of a signal's `flags`.
pub mod signal_flags {
    /// Stands for a limited time (1.9).
    pub const TEMPORARY: u8 = 1;
    /// No longer holds (1.9).
    pub const INVALIDATED: u8 = 2;
    /// Its s was moved to the road's end.
    pub const CLAMPED: u8 = 4;
}

/// Bits of a signal's `has_value`.
pub mod signal_values {
    /// A value is written.
    pub const WRITTEN: u8 = 1;
    /// The class has a value.
    pub const MEANT: u8 = 2;
    /// The unit of that value is not written: it is that of the table that maps the sign, or the SI unit.
    pub const UNIT_ASSUMED: u8 = 4;
    /// The class is about a speed, and the stated unit is none of speed: the speed is unknown.
    pub const UNREADABLE: u8 = 8;
}

codes! {
    /// Direction of travel that a signal or object is for (OpenDRIVE 1.8.1, 13 and 14; e_orientation).
    Orientation {
        /// Both, or not given.
        Both = 0, "none";
        /// Along s.
        Along = 1, "+";
        /// Against s.
        Against = 2, "-";
    }
}

codes! {
    /// Where a signal's place in space comes from.
    SignalPosition {
        /// s, t and zOffset.
        Track = 0, "s and t";
        /// `positionRoad`.
        Road = 1, "positionRoad";
        /// `positionInertial`.
        Inertial = 2, "positionInertial";
    }
}

codes! {
    /// How a signal or object and a lane belong together.
    LaneMethod {
        /// `validity` names the lane.
        Validity = 0, "validity";
        /// No validity: all lanes that travel the way the signal is for.
        Orientation = 1, "orientation";
        /// The signal's s and t, or the object's area, lie on the lane.
        Track = 2, "s and t";
        /// No lane lies nearer that travels that way.
        Nearest = 3, "nearest";
        /// A guess: the validity names lane 0 alone, no reference names others, and the lane travels the way the signal is for.
        OrientationGuess = 4, "orientation guess";
    }
}

/// Stands for a relation where no rule of junctions applies: between lanes from one entry, and where roads cross.
pub const NO_RELATION: u8 = 4;

codes! {
    /// Who goes first where two lanes of a junction conflict.
    Relation {
        /// The lane yields.
        Yields = 0, "yields";
        /// The lane has priority.
        Priority = 1, "priority";
        /// Lights decide.
        Lights = 2, "lights";
        /// Nothing in the map decides.
        Open = 3, "open";
    }
}

codes! {
    /// Why one lane goes first.
    RelationReason {
        /// Nothing in the map decides.
        None = 0, "none";
        /// Both are under lights that do not switch together.
        Lights = 1, "lights";
        /// A stop sign at the entry.
        StopSign = 2, "stop sign";
        /// A yield sign at the entry.
        YieldSign = 3, "yield sign";
        /// A sign of a priority road at the entry.
        PriorityRoad = 4, "priority road";
        /// `junction/priority`.
        JunctionPriority = 5, "junction priority";
        /// Who turns across oncoming traffic yields.
        Turn = 6, "turn across oncoming traffic";
        /// Traffic from the right has priority.
        FromTheRight = 7, "from the right";
    }
}

impl Orientation {
    /// Whether what is written so is for traffic that travels towards +s, or for that towards −s.
    #[inline]
    pub const fn is_for(self, forward: bool) -> bool {
        match self {
            Self::Along => forward,
            Self::Against => !forward,
            _ => true,
        }
    }

    /// The same direction, seen from a road whose s runs the other way.
    pub const fn turned(self) -> Self {
        match self {
            Self::Along => Self::Against,
            Self::Against => Self::Along,
            same => same,
        }
    }
}
