//! Words of the standard's enumerations.

macro_rules! words {
    ($(#[$doc:meta])* $name:ident { $($variant:ident = $text:literal,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $name {
            $(#[doc = concat!("`", $text, "`")] $variant,)*
            /// A word that the standard does not know.
            Other,
        }

        impl $name {
            /// All known words.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The value of a word, exactly as OpenDRIVE writes it.
            pub fn from_name(name: &str) -> Self {
                match name { $($text => Self::$variant,)* _ => Self::Other }
            }

            /// The word; empty for `Other`.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $text,)* Self::Other => "" }
            }
        }
    };
}

words! {
    /// Type of a lane in OpenDRIVE 1.4 to 1.9 (e_laneType).
    LaneKind {
        None = "none", Driving = "driving", Stop = "stop", Shoulder = "shoulder", Biking = "biking",
        Sidewalk = "sidewalk", Walking = "walking", Border = "border", Restricted = "restricted",
        Parking = "parking", Curb = "curb", Bidirectional = "bidirectional", Median = "median",
        Special1 = "special1", Special2 = "special2", Special3 = "special3", RoadWorks = "roadWorks",
        Tram = "tram", Rail = "rail", Entry = "entry", Exit = "exit", OffRamp = "offRamp", OnRamp = "onRamp",
        ConnectingRamp = "connectingRamp", Bus = "bus", Taxi = "taxi", Hov = "HOV", MwyEntry = "mwyEntry",
        MwyExit = "mwyExit", Shared = "shared", SlipLane = "slipLane",
    }
}

words! {
    /// Type of a road (e_roadType).
    RoadTypeKind {
        Unknown = "unknown", Rural = "rural", Motorway = "motorway", Town = "town", LowSpeed = "lowSpeed",
        Pedestrian = "pedestrian", Bicycle = "bicycle", TownExpressway = "townExpressway",
        TownCollector = "townCollector", TownArterial = "townArterial", TownPrivate = "townPrivate",
        TownLocal = "townLocal", TownPlayStreet = "townPlayStreet",
    }
}
