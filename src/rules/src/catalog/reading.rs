//! What reading finds: entries for the ids that the reader has, which it grades by the version of the document.
//!
//! Findings of reading stand for ASAM's `xml.valid_schema`. What the schema forbids is an error in the profiles `strict` and `asam`; in the default
//! profile, only where something cannot be built without it.

use crate::example::Example::{
    self, Document, File, Header, Junction, Lane, Lanes, Objects, PlanView, Road, Words,
};
use crate::rule::Check::Reading;
use crate::rule::Rule;
use mapd_xodr::{Severity, rule_ids as ids};

const SOUND: Example = Header("");

/// What is wrong with the file, so that it cannot be read on.
const fn unreadable(id: &'static str, meaning: &'static str, invalid: Example) -> Rule {
    let because = "the rest of the document cannot be read";
    Rule::error(id, [meaning, because], Reading, [SOUND, invalid]).fixed()
}

/// What is wrong with something that a part may be built from. Whether it can be built without is for the compiler to say.
const fn needed(id: &'static str, meaning: &'static str, invalid: Example) -> Rule {
    let because =
        "it is built from what is missing or unreadable, as listed below; all else is a warning";
    Rule::error(id, [meaning, because], Reading, [SOUND, invalid])
}

/// What the schema forbids, and nothing is built from.
const fn forbidden(id: &'static str, meaning: &'static str, invalid: Example) -> Rule {
    Rule::warning(id, meaning, Reading, [SOUND, invalid])
}

const fn warning(id: &'static str, meaning: &'static str, invalid: Example) -> Rule {
    Rule::warning(id, meaning, Reading, [SOUND, invalid]).strict(Severity::Warning)
}

const fn info(id: &'static str, meaning: &'static str, invalid: Example) -> Rule {
    Rule::info(id, meaning, Reading, [SOUND, invalid])
}

pub(super) static RULES: &[&[Rule]] = &[&[
    unreadable(
        ids::XML,
        "A document is well-formed XML to its end.",
        File(r#"<OpenDRIVE><header revMajor="1" revMinor="8"></OpenDRIVE>"#),
    ),
    unreadable(
        ids::LIMIT,
        "A document is within the limits of reading; reading.md lists them.",
        Words("elements nested deeper than --max-depth"),
    ),
    unreadable(
        ids::ENCODING,
        "A document is in a supported encoding, and in the one that it states (warning).",
        File(
            r#"<?xml version="1.0" encoding="x-none"?><OpenDRIVE><header revMajor="1" revMinor="8"/></OpenDRIVE>"#,
        ),
    ),
    unreadable(
        ids::COMPRESSION,
        "A compressed document can be decompressed.",
        Words("a file that ends within its gzip stream"),
    ),
    unreadable(
        ids::INCLUDE,
        "An included file can be read and is in the folder that files may be included from.",
        Document(r#"<include file="../beside.xodr"/>"#),
    ),
    unreadable(
        ids::ROOT,
        "The root element is OpenDRIVE.",
        File(r#"<Map><header revMajor="1" revMinor="8"/></Map>"#),
    ),
    warning(
        ids::BEFORE_DECLARATION,
        "There is nothing before the XML declaration.",
        File(
            " <?xml version=\"1.0\"?><OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/></OpenDRIVE>",
        ),
    ),
    warning(
        ids::NAMESPACE,
        "The root is in no namespace, or in one of OpenDRIVE's.",
        File(r#"<OpenDRIVE xmlns="urn:another"><header revMajor="1" revMinor="8"/></OpenDRIVE>"#),
    ),
    forbidden(ids::HEADER, "There is a header.", File("<OpenDRIVE></OpenDRIVE>")),
    forbidden(
        ids::VERSION,
        "The header states a version, and mapd knows it (otherwise a warning in every profile).",
        File(r#"<OpenDRIVE><header revMajor="1" revMinor="x"/></OpenDRIVE>"#),
    ),
    needed(
        ids::MISSING,
        "Required attributes are present.",
        Lanes(r#"<laneSection><center><lane id="0" type="none"/></center></laneSection>"#),
    ),
    needed(ids::ELEMENT, "Required elements are present.", PlanView("")),
    forbidden(
        ids::OCCURRENCE,
        "An element occurs as often as the schema allows.",
        Header("<geoReference>a</geoReference><geoReference>b</geoReference>"),
    ),
    needed(
        ids::CHOICE,
        "Of elements that exclude each other, exactly one is present.",
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><line/><arc curvature="0.1"/></geometry>"#,
        ),
    ),
    warning(
        ids::ORDER,
        "Elements are in the schema's order.",
        Document(
            r#"<junction id="7" name=""/><road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road>"#,
        ),
    ),
    warning(
        ids::UNKNOWN_ATTRIBUTE,
        "Attributes are defined by the standard; others are kept as text.",
        Lane(r#"<speed sOffset="0" max="50" unit="km/h" least="30"/>"#),
    ),
    warning(
        ids::UNKNOWN_ELEMENT,
        "Elements are defined by the standard; others are kept as text.",
        Document("<street/>"),
    ),
    warning(
        ids::OTHER_VERSION,
        "Elements, attributes and words belong to the file's version; those that later versions removed are information.",
        File(
            r#"<OpenDRIVE><header revMajor="1" revMinor="4"/><road id="1" length="9" junction="-1" rule="RHT"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road></OpenDRIVE>"#,
        ),
    ),
    info(
        ids::DEPRECATED,
        "Elements, attributes and words are not deprecated in the file's version.",
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><poly3 a="0" b="0" c="0" d="0"/></geometry>"#,
        ),
    ),
    warning(
        ids::VARIANT,
        "Elements and attributes fit the kind of junction, connection or segment that contains them.",
        Junction(r#"<junction id="9" name="" mainRoad="1"/>"#),
    ),
    warning(ids::TEXT, "There is no text where only elements are allowed.", Road("<link>1</link>")),
    warning(
        ids::NOT_KEPT,
        "An element outside the standard is small enough to be kept.",
        Words("an element of another vendor's with more text than the limits allow"),
    ),
    needed(
        ids::VALUE,
        "A value can be read as its type.",
        PlanView(r#"<geometry s="0" x="east" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    needed(
        ids::FINITE,
        "A number is finite.",
        PlanView(r#"<geometry s="0" x="INF" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    needed(
        ids::RANGE,
        "A number is within its range.",
        Document(
            r#"<road id="1" length="-1" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road>"#,
        ),
    ),
    warning(
        ids::LEXICAL,
        "A value is written as the schema defines.",
        PlanView(r#"<geometry s="0" x="0,5" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    info(
        ids::SPACE,
        "No white space surrounds a value.",
        PlanView(r#"<geometry s="0" x=" 0" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    needed(
        ids::EMPTY,
        "An attribute is not empty; for an optional one, this is a warning.",
        PlanView(r#"<geometry s="0" x="" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    forbidden(
        ids::ENUMERATION,
        "A word is one of those that the standard lists.",
        Objects(r#"<object id="1" type="lamppost" s="10" t="4" zOffset="0" orientation="none"/>"#),
    ),
]];
