//! Codes of road marks.

use crate::codes::codes;

codes! {
    /// Kind of a road mark (OpenDRIVE 1.8.1, 11.10; e_roadMarkType). Of two lines the one nearer to lane 0 is named first.
    RoadMarkKind {
        /// Not given, or not a word of the standard.
        NotGiven = 0, "";
        /// `none`: no mark
        None = 1, "none";
        /// `solid`
        Solid = 2, "solid";
        /// `broken`
        Broken = 3, "broken";
        /// `solid solid`
        SolidSolid = 4, "solid solid";
        /// `solid broken`
        SolidBroken = 5, "solid broken";
        /// `broken solid`
        BrokenSolid = 6, "broken solid";
        /// `broken broken`
        BrokenBroken = 7, "broken broken";
        /// `botts dots`
        BottsDots = 8, "botts dots";
        /// `grass`: an edge of grass
        Grass = 9, "grass";
        /// `curb`
        Curb = 10, "curb";
        /// `custom`: as the lines say
        Custom = 11, "custom";
        /// `edge`: the drivable area's end
        Edge = 12, "edge";
    }
}

codes! {
    /// Colour of a road mark (e_roadMarkColor).
    RoadMarkColor {
        /// Not given, or not a word of the standard.
        NotGiven = 0, "";
        /// `standard`: white, as it is used there
        Standard = 1, "standard";
        /// `blue`
        Blue = 2, "blue";
        /// `green`
        Green = 3, "green";
        /// `red`
        Red = 4, "red";
        /// `white`
        White = 5, "white";
        /// `yellow`
        Yellow = 6, "yellow";
        /// `black`
        Black = 7, "black";
        /// `orange`
        Orange = 8, "orange";
        /// `violet`
        Violet = 9, "violet";
    }
}

codes! {
    /// Visual weight of a road mark (e_roadMarkWeight).
    RoadMarkWeight {
        /// Not given, or not a word of the standard.
        NotGiven = 0, "";
        /// `standard`
        Standard = 1, "standard";
        /// `bold`
        Bold = 2, "bold";
    }
}

codes! {
    /// Lane changes that a mark allows, by lane number (e_road_lanes_laneSection_lcr_lane_roadMark_laneChange).
    MarkLaneChange {
        /// Not given, or not a word of the standard.
        NotGiven = 0, "";
        /// `increase`: to higher lane numbers
        Increase = 1, "increase";
        /// `decrease`: to lower lane numbers
        Decrease = 2, "decrease";
        /// `both`
        Both = 3, "both";
        /// `none`
        None = 4, "none";
    }
}

codes! {
    /// Who may cross a line of a mark, seen from inside (e_roadMarkRule).
    RoadMarkRule {
        /// Not given, or not a word of the standard.
        NotGiven = 0, "";
        /// `no passing`
        NoPassing = 1, "no passing";
        /// `caution`
        Caution = 2, "caution";
        /// `none`
        None = 3, "none";
    }
}
