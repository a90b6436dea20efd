//! Codes in the tables of what files say besides.

use crate::codes::codes;

codes! {
    /// What an annotation is.
    AnnotationKind {
        /// `userData`: data of an application.
        UserData = 0, "user-data";
        /// `dataQuality`: an attribute of it, or the element.
        DataQuality = 1, "data-quality";
        /// An `include` that was not followed.
        Include = 2, "include";
        /// An element that the standard does not have in its place.
        UnknownElement = 3, "unknown-element";
        /// An element of another namespace.
        ForeignElement = 4, "foreign-element";
        /// An attribute, or the text of an element, of which nothing is built.
        Attribute = 5, "attribute";
        /// The owner itself, or an element in it, stands in an included file.
        SourceFile = 6, "source-file";
    }
}

codes! {
    /// What an annotation belongs to: the innermost part around it that has a row.
    AnnotationOwner {
        /// The document: what stands outside of all others, as in the header.
        Document = 0, "document";
        /// A road.
        Road = 1, "road";
        /// A lane section.
        Section = 2, "section";
        /// A lane.
        Lane = 3, "lane";
        /// A junction.
        Junction = 4, "junction";
        /// A connection of a junction.
        Connection = 5, "connection";
        /// An object.
        Object = 6, "object";
        /// A signal.
        Signal = 7, "signal";
        /// A controller.
        Controller = 8, "controller";
        /// A junction group.
        JunctionGroup = 9, "junction-group";
        /// A station.
        Station = 10, "station";
    }
}

codes! {
    /// Kind of a junction group (OpenDRIVE 1.8.1, 12.14; e_junctionGroup_type).
    JunctionGroupKind {
        /// Not given.
        None = 0, "";
        /// `roundabout`
        Roundabout = 1, "roundabout";
        /// `unknown`
        Other = 2, "unknown";
        /// `complexJunction`
        ComplexJunction = 3, "complexJunction";
        /// `highwayInterchange`
        HighwayInterchange = 4, "highwayInterchange";
    }
}
