//! Ids of the rules that reading itself applies.

/// The XML is not well-formed, or ends too early.
pub const XML: &str = "mapd:xml.well_formed";
/// The document is larger or deeper than the limits allow.
pub const LIMIT: &str = "mapd:xml.limit";
/// The encoding is not read.
pub const ENCODING: &str = "mapd:xml.encoding";
/// Something stands before the XML declaration.
pub const BEFORE_DECLARATION: &str = "mapd:xml.before_declaration";
/// The root is not `OpenDRIVE`.
pub const ROOT: &str = "asam.net:xodr:1.0.0:xml.root_tag_is_opendrive";
/// A required attribute is missing.
pub const MISSING: &str = "mapd:structure.missing_attribute";
/// A required element is missing.
pub const ELEMENT: &str = "mapd:structure.missing_element";
/// A value cannot be read as its type.
pub const VALUE: &str = "mapd:value.type";
/// A number is not finite.
pub const FINITE: &str = "mapd:value.finite";
/// White space surrounds a value.
pub const SPACE: &str = "mapd:value.space";
/// An attribute is present but empty.
pub const EMPTY: &str = "mapd:value.empty";
/// A word that the standard does not know.
pub const ENUMERATION: &str = "mapd:value.enumeration";
/// The version is missing or unknown.
pub const VERSION: &str = "asam.net:xodr:1.0.0:xml.fileheader_to_specify_version";
/// Lanes of another layer are not read yet.
pub const LAYER: &str = "mapd:structure.lane_layer";
