//! Ids of the rules that reading itself applies.

/// The XML is not well-formed, or ends too early.
pub const XML: &str = "mapd:xml.well_formed";
/// The document is larger or deeper than the limits allow.
pub const LIMIT: &str = "mapd:xml.limit";
/// The encoding is not read, or the bytes are none of it.
pub const ENCODING: &str = "mapd:xml.encoding";
/// The compressed input is damaged.
pub const COMPRESSION: &str = "mapd:xml.compression";
/// Something stands before the XML declaration.
pub const BEFORE_DECLARATION: &str = "mapd:xml.before_declaration";
/// A file cannot be included.
pub const INCLUDE: &str = "mapd:xml.include";
/// The root is not `OpenDRIVE`.
pub const ROOT: &str = "asam.net:xodr:1.0.0:xml.root_tag_is_opendrive";
/// The root stands in a namespace that is none of OpenDRIVE's.
pub const NAMESPACE: &str = "mapd:xml.namespace";
/// There is no header.
pub const HEADER: &str = "asam.net:xodr:1.0.0:xml.fileheader_is_present";
/// The version is missing, no number, or unknown.
pub const VERSION: &str = "asam.net:xodr:1.0.0:xml.version_is_defined";

/// A required attribute is missing.
pub const MISSING: &str = "mapd:structure.missing_attribute";
/// A required element is missing.
pub const ELEMENT: &str = "mapd:structure.missing_element";
/// An element occurs more or less often than it may.
pub const OCCURRENCE: &str = "mapd:structure.occurrence";
/// Of several elements, one must be chosen.
pub const CHOICE: &str = "mapd:structure.choice";
/// Elements stand in another order than the schema's.
pub const ORDER: &str = "mapd:structure.order";
/// An attribute that the standard does not have in this element.
pub const UNKNOWN_ATTRIBUTE: &str = "mapd:structure.unknown_attribute";
/// An element that the standard does not have in this place.
pub const UNKNOWN_ELEMENT: &str = "mapd:structure.unknown_element";
/// An element, attribute or word of another version than the file's.
pub const OTHER_VERSION: &str = "mapd:structure.other_version";
/// An element, attribute or word that the file's version deprecates.
pub const DEPRECATED: &str = "mapd:structure.deprecated";
/// An element or attribute of another kind of junction, connection or segment.
pub const VARIANT: &str = "mapd:structure.variant";
/// Text where only elements may stand.
pub const TEXT: &str = "mapd:structure.text";
/// An element beyond the standard's own is too large to be kept.
pub const NOT_KEPT: &str = "mapd:structure.not_kept";

/// A value cannot be read as its type.
pub const VALUE: &str = "mapd:value.type";
/// A number is not finite.
pub const FINITE: &str = "mapd:value.finite";
/// A number is outside its range.
pub const RANGE: &str = "mapd:value.range";
/// A value is written in an unusual way.
pub const LEXICAL: &str = "mapd:value.lexical";
/// White space surrounds a value.
pub const SPACE: &str = "mapd:value.space";
/// An attribute is present but empty.
pub const EMPTY: &str = "mapd:value.empty";
/// A word that the standard does not know.
pub const ENUMERATION: &str = "mapd:value.enumeration";

/// Rules whose findings leave the document readable, whatever their severity: structure and values. Whether something can
/// be built without what they concern is for the reader of the document to say.
pub fn is_structural(rule: &str) -> bool {
    rule.starts_with("mapd:structure.")
        || rule.starts_with("mapd:value.")
        || matches!(rule, HEADER | VERSION | NAMESPACE | BEFORE_DECLARATION)
}

/// The id under which ASAM's checker reports what a rule finds; none where it has no such rule.
pub fn asam(rule: &str) -> Option<&'static str> {
    match rule {
        XML => Some("asam.net:xodr:1.0.0:xml.valid_xml_document"),
        ROOT => Some(ROOT),
        HEADER => Some(HEADER),
        VERSION => Some(VERSION),
        MISSING | ELEMENT | OCCURRENCE | CHOICE | ORDER | UNKNOWN_ATTRIBUTE | UNKNOWN_ELEMENT
        | OTHER_VERSION | VARIANT | TEXT | VALUE | RANGE | ENUMERATION => {
            Some("asam.net:xodr:1.0.0:xml.valid_schema")
        }
        _ => None,
    }
}
