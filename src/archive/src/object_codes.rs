//! Codes and bits in the tables of objects.

use crate::codes::codes;

/// Bits of an object's `flags`.
pub mod object_flags {
    /// `object/@dynamic` is yes.
    pub const DYNAMIC: u8 = 1;
    /// `object/@perpToRoad` is true.
    pub const PERPENDICULAR: u8 = 2;
    /// `object/@temporary` is true.
    pub const TEMPORARY: u8 = 4;
    /// `object/@invalidated` is true.
    pub const INVALIDATED: u8 = 8;
    /// s lies beyond the road; the object stands at its end.
    pub const CLAMPED: u8 = 16;
}

/// Bits of an outline's `flags`.
pub mod outline_flags {
    /// An outer outline, not one of a hole.
    pub const OUTER: u8 = 1;
    /// The last corner leads back to the first.
    pub const CLOSED: u8 = 2;
}

/// Bits of a copy's `flags`.
pub mod copy_flags {
    /// The object without gaps along a stretch of road, not an instance of it.
    pub const SWEPT: u8 = 1;
}

codes! {
    /// What an object's extent is made of.
    ObjectShape {
        /// No extent is written.
        Point = 0, "point";
        /// Length, width and height.
        Box = 1, "box";
        /// Radius and height.
        Cylinder = 2, "cylinder";
        /// Outlines.
        Outlines = 3, "outlines";
    }
}

codes! {
    /// What fills an outline (OpenDRIVE 1.8.1, e_outlineFillType).
    OutlineFill {
        /// Not given.
        None = 0, "";
        /// `grass`
        Grass = 1, "grass";
        /// `concrete`
        Concrete = 2, "concrete";
        /// `cobble`
        Cobble = 3, "cobble";
        /// `asphalt`
        Asphalt = 4, "asphalt";
        /// `pavement`
        Pavement = 5, "pavement";
        /// `gravel`
        Gravel = 6, "gravel";
        /// `soil`
        Soil = 7, "soil";
        /// `paint`
        Paint = 8, "paint";
    }
}

codes! {
    /// Side of an object (OpenDRIVE 1.8.1, e_sideType).
    ObjectSide {
        /// Not given.
        None = 0, "";
        /// `left`
        Left = 1, "left";
        /// `right`
        Right = 2, "right";
        /// `front`
        Front = 3, "front";
        /// `rear`
        Rear = 4, "rear";
    }
}

codes! {
    /// What carries or covers a stretch of road.
    StructureKind {
        /// A bridge.
        Bridge = 0, "bridge";
        /// A tunnel.
        Tunnel = 1, "tunnel";
    }
}

codes! {
    /// State of a railway switch (OpenDRIVE 1.8.1, e_road_railroad_switch_position).
    SwitchPosition {
        /// Not given.
        None = 0, "";
        /// `dynamic`
        Dynamic = 1, "dynamic";
        /// `straight`
        Straight = 2, "straight";
        /// `turn`
        Turn = 3, "turn";
    }
}

codes! {
    /// Side of a road that a platform is on (OpenDRIVE 1.8.1, e_station_platform_segment_side).
    PlatformSide {
        /// Not given.
        None = 0, "";
        /// `left`
        Left = 1, "left";
        /// `right`
        Right = 2, "right";
    }
}
