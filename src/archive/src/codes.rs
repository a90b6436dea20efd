//! Codes that stand in the tables' `u8` fields. Decoding is total: what is not known decodes as such.

/// Stands for "none" where a `u32` names a row.
pub const NONE: u32 = u32::MAX;

/// Bits of a lane's `flags`.
pub mod lane_flags {
    /// Travels towards +s (else towards −s).
    pub const FORWARD: u8 = 1;
    /// `lane/@level` is true.
    pub const LEVEL: u8 = 2;
    /// The lane's `widths` hold the outer border's t instead of widths.
    pub const BORDER: u8 = 4;
    /// May be travelled in both directions.
    pub const BOTH: u8 = 8;
    /// Is only for walking: pedestrians walk both ways, whatever the traffic rule says.
    pub const WALKED: u8 = 16;
    /// Is of the temporary layer (1.9).
    pub const TEMPORARY: u8 = 32;
    /// Has nodes in both directions.
    pub const TWO_WAY: u8 = BOTH | WALKED;
}

macro_rules! codes {
    ($(#[$doc:meta])* $name:ident { $($(#[$vdoc:meta])* $variant:ident = $code:literal, $text:literal;)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[repr(u8)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$vdoc])* $variant = $code,)*
            /// A code or name that this version does not know.
            Unknown = 255,
        }

        impl $name {
            /// All known values, by code.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The value of a code; unknown codes give `Unknown`.
            pub const fn from_code(code: u8) -> Self {
                match code { $($code => Self::$variant,)* _ => Self::Unknown }
            }

            /// The code.
            pub const fn code(self) -> u8 {
                self as u8
            }

            /// The value of a name as OpenDRIVE writes it; unknown names give `Unknown`.
            pub fn from_name(name: &str) -> Self {
                match name { $($text => Self::$variant,)* _ => Self::Unknown }
            }

            /// The name as OpenDRIVE writes it.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $text,)* Self::Unknown => "unknown" }
            }
        }

        #[cfg(feature = "serde")]
        impl serde::Serialize for $name {
            /// As its name.
            fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                to.serialize_str(self.name())
            }
        }

        #[cfg(feature = "serde")]
        impl<'de> serde::Deserialize<'de> for $name {
            /// From its name; one that this version does not know is an error.
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let name = String::deserialize(from)?;
                match Self::from_name(&name) {
                    Self::Unknown if name != Self::Unknown.name() => {
                        let what = stringify!($name);
                        Err(serde::de::Error::custom(format_args!("expected a {what}, found {name:?}")))
                    }
                    known => Ok(known),
                }
            }
        }
    };
}

codes! {
    /// Kind of what a road's `link` names.
    LinkKind {
        /// No link.
        None = 0, "none";
        /// A road.
        Road = 1, "road";
        /// A junction.
        Junction = 2, "junction";
        /// A road that the map does not have.
        UnresolvedRoad = 3, "unresolved road";
        /// A junction that the map does not have.
        UnresolvedJunction = 4, "unresolved junction";
    }
}

codes! {
    /// End of a road that a link touches.
    ContactPoint {
        /// Not given.
        None = 0, "none";
        /// s = 0.
        Start = 1, "start";
        /// s = length.
        End = 2, "end";
    }
}

codes! {
    /// What a speed record says.
    SpeedKind {
        /// Nothing.
        None = 0, "none";
        /// A limit.
        Value = 1, "value";
        /// No limit.
        NoLimit = 2, "no limit";
        /// Undefined.
        Undefined = 3, "undefined";
        /// A limit that is stated and unknown: negative, in no unit of speed, or without a number.
        Unreadable = 4, "unreadable";
    }
}

codes! {
    /// Type of a road (OpenDRIVE 1.8.1, 10.4; e_roadType).
    RoadType {
        /// Not given.
        None = 0, "none";
        /// `rural`
        Rural = 1, "rural";
        /// `motorway`
        Motorway = 2, "motorway";
        /// `town`
        Town = 3, "town";
        /// `lowSpeed`
        LowSpeed = 4, "lowSpeed";
        /// `pedestrian`
        Pedestrian = 5, "pedestrian";
        /// `bicycle`
        Bicycle = 6, "bicycle";
        /// `townExpressway`
        TownExpressway = 7, "townExpressway";
        /// `townCollector`
        TownCollector = 8, "townCollector";
        /// `townArterial`
        TownArterial = 9, "townArterial";
        /// `townPrivate`
        TownPrivate = 10, "townPrivate";
        /// `townLocal`
        TownLocal = 11, "townLocal";
        /// `townPlayStreet`
        TownPlayStreet = 12, "townPlayStreet";
        /// `unknown`, as the file says
        StatedUnknown = 13, "unknown";
    }
}

codes! {
    /// Type of a lane: all of OpenDRIVE 1.4 to 1.9 (1.8.1, 11.7.1; e_laneType).
    LaneType {
        /// `none`
        None = 0, "none";
        /// `driving`
        Driving = 1, "driving";
        /// `stop`
        Stop = 2, "stop";
        /// `shoulder`
        Shoulder = 3, "shoulder";
        /// `biking`
        Biking = 4, "biking";
        /// `sidewalk`
        Sidewalk = 5, "sidewalk";
        /// `walking`
        Walking = 6, "walking";
        /// `border`
        Border = 7, "border";
        /// `restricted`
        Restricted = 8, "restricted";
        /// `parking`
        Parking = 9, "parking";
        /// `curb`
        Curb = 10, "curb";
        /// `bidirectional`
        Bidirectional = 11, "bidirectional";
        /// `median`
        Median = 12, "median";
        /// `special1`
        Special1 = 13, "special1";
        /// `special2`
        Special2 = 14, "special2";
        /// `special3`
        Special3 = 15, "special3";
        /// `roadWorks`
        RoadWorks = 16, "roadWorks";
        /// `tram`
        Tram = 17, "tram";
        /// `rail`
        Rail = 18, "rail";
        /// `entry`
        Entry = 19, "entry";
        /// `exit`
        Exit = 20, "exit";
        /// `offRamp`
        OffRamp = 21, "offRamp";
        /// `onRamp`
        OnRamp = 22, "onRamp";
        /// `connectingRamp`
        ConnectingRamp = 23, "connectingRamp";
        /// `bus`
        Bus = 24, "bus";
        /// `taxi`
        Taxi = 25, "taxi";
        /// `HOV`
        Hov = 26, "HOV";
        /// `mwyEntry`
        MwyEntry = 27, "mwyEntry";
        /// `mwyExit`
        MwyExit = 28, "mwyExit";
        /// `shared`
        Shared = 29, "shared";
        /// `slipLane`
        SlipLane = 30, "slipLane";
    }
}

impl LaneType {
    /// Whether motor vehicles travel on it (OpenDRIVE 1.9, annex on smoothness; older types of the same sense included).
    pub const fn is_drivable(self) -> bool {
        use LaneType::*;
        matches!(
            self,
            Driving
                | Entry
                | Exit
                | OnRamp
                | OffRamp
                | ConnectingRamp
                | SlipLane
                | Border
                | Stop
                | Restricted
                | Hov
                | Bidirectional
                | Bus
                | Taxi
                | MwyEntry
                | MwyExit
                | RoadWorks
        )
    }
}

codes! {
    /// Kind of a part that is not in the map as its document has it.
    QuarantinedKind {
        /// A road.
        Road = 0, "road";
        /// A junction.
        Junction = 1, "junction";
        /// A connection of a junction.
        Connection = 2, "connection";
        /// An object, tunnel or bridge, or a reference to an object.
        Object = 3, "object";
        /// A signal, or a reference to one.
        Signal = 4, "signal";
        /// A controller.
        Controller = 5, "controller";
        /// A junction group, station or group of boards.
        Other = 6, "group";
        /// A lane link of a connection.
        LaneLink = 7, "laneLink";
    }
}

codes! {
    /// How a map's georeference is written.
    GeoReferenceForm {
        /// There is none, or it is empty.
        Absent = 0, "absent";
        /// PROJ parameters, as OpenDRIVE wants them.
        Proj = 1, "proj";
        /// PROJ parameters without a projection, such as `+lat_0=49 +lon_0=8`.
        Parameters = 2, "parameters";
        /// A code of EPSG's.
        Epsg = 3, "epsg";
        /// Well-known text 1.
        Wkt1 = 4, "wkt1";
        /// Well-known text 2.
        Wkt2 = 5, "wkt2";
        /// None of these.
        Other = 6, "other";
    }
}

pub(crate) use codes;
