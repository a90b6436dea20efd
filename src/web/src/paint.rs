//! What stands out by its colour. The page has the colours, by these names.

use mapd_query::view::OverlayKind;
use mapd_query::vocabulary::{LaneType, RoadMarkColor};

macro_rules! paints {
    ($($(#[$doc:meta])* $name:ident = $text:literal,)*) => {
        /// What something is drawn as.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        pub enum Paint {
            $($(#[$doc])* $name,)*
        }

        impl Paint {
            /// All, by number.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// The name.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$name => $text,)* }
            }
        }
    };
}

paints! {
    /// Lanes without a use.
    NoLane = "none",
    /// Lanes whose type stands for nothing here.
    OtherLane = "other lane",
    /// Shoulders, borders, curbs.
    Edge = "edge",
    /// Medians, and what is restricted.
    Green = "median",
    /// Sidewalks.
    Walking = "walking",
    /// Bicycle lanes.
    Biking = "biking",
    /// Parking.
    Parking = "parking",
    /// Rails and trams.
    Rail = "rail",
    /// Lanes for buses, taxis, high occupancy.
    Bus = "bus",
    /// Road works.
    Works = "road works",
    /// Lanes for driving.
    Driving = "driving",
    /// Borders of lanes.
    Border = "border",
    /// Borders of lanes within junctions, of which many cross each other.
    JunctionBorder = "border in junction",
    /// Reference lines.
    Reference = "reference line",
    /// Triangles that point where traffic goes.
    Direction = "direction",
    /// White marks.
    White = "white mark",
    /// Yellow marks.
    Yellow = "yellow mark",
    /// Blue marks.
    Blue = "blue mark",
    /// Green marks.
    GreenMark = "green mark",
    /// Red marks.
    Red = "red mark",
    /// Black marks.
    Black = "black mark",
    /// Orange marks.
    Orange = "orange mark",
    /// Violet marks.
    Violet = "violet mark",
    /// Areas of objects.
    Object = "object",
    /// Outlines of objects.
    ObjectLine = "object outline",
    /// Crosswalks.
    Crosswalk = "crosswalk",
    /// Outlines of crosswalks.
    CrosswalkLine = "crosswalk outline",
    /// Lines at which traffic stops or gives way.
    StopLine = "stop line",
    /// What is left out.
    Quarantine = "left out",
    /// Outlines of what is left out.
    QuarantineLine = "left out outline",
    /// Stretches on which lanes meet others.
    Conflict = "conflict",
    /// Boxes of the index.
    IndexBox = "index box",
    /// The lane that was chosen.
    Chosen = "chosen",
    /// Lanes that it leads to.
    Next = "next",
    /// Lanes that lead to it.
    Before = "before",
    /// Lanes that it gives way to, or that a light is for.
    Other = "other",
    /// The driven line of a route.
    Route = "route",
    /// The room along a route.
    Corridor = "corridor",
    /// Edges of that room.
    CorridorLine = "corridor edge",
    /// Lanes that an overlay closes now.
    Closed = "closed",
    /// Lanes that it opens.
    Opened = "opened",
    /// Lanes on which it states a speed.
    Slower = "slower",
    /// Lanes of which it says something else.
    Told = "told",
}

impl From<LaneType> for Paint {
    fn from(kind: LaneType) -> Self {
        match kind {
            LaneType::None => Self::NoLane,
            LaneType::Driving
            | LaneType::Bidirectional
            | LaneType::Stop
            | LaneType::Entry
            | LaneType::Exit
            | LaneType::OnRamp
            | LaneType::OffRamp
            | LaneType::ConnectingRamp
            | LaneType::SlipLane
            | LaneType::MwyEntry
            | LaneType::MwyExit => Self::Driving,
            LaneType::Bus | LaneType::Taxi | LaneType::Hov => Self::Bus,
            LaneType::Biking => Self::Biking,
            LaneType::Sidewalk | LaneType::Walking => Self::Walking,
            LaneType::Shoulder | LaneType::Border | LaneType::Curb => Self::Edge,
            LaneType::Parking => Self::Parking,
            LaneType::Rail | LaneType::Tram => Self::Rail,
            LaneType::Median | LaneType::Restricted => Self::Green,
            LaneType::RoadWorks => Self::Works,
            _ => Self::OtherLane,
        }
    }
}

impl From<OverlayKind> for Paint {
    fn from(kind: OverlayKind) -> Self {
        match kind {
            OverlayKind::Closed => Self::Closed,
            OverlayKind::Open => Self::Opened,
            OverlayKind::Speed => Self::Slower,
            _ => Self::Told,
        }
    }
}

impl From<RoadMarkColor> for Paint {
    fn from(color: RoadMarkColor) -> Self {
        match color {
            RoadMarkColor::Blue => Self::Blue,
            RoadMarkColor::Green => Self::GreenMark,
            RoadMarkColor::Red => Self::Red,
            RoadMarkColor::Yellow => Self::Yellow,
            RoadMarkColor::Black => Self::Black,
            RoadMarkColor::Orange => Self::Orange,
            RoadMarkColor::Violet => Self::Violet,
            _ => Self::White,
        }
    }
}
