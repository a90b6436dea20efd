//! What reading finds: entries for the ids that the reader has, which it grades by the version of the document.
//!
//! Findings of reading stand for ASAM's `xml.valid_schema`, and are as bad in every profile.

use crate::example::Example::{
    self, Document, File, Header, Junction, Lane, Lanes, Objects, PlanView, Road, Words,
};
use crate::rule::Check::Reading;
use crate::rule::Rule;
use mapd_xodr::{Severity, rule_ids as ids};

const SOUND: Example = Header("");

/// What is wrong with the file, so that it cannot be read on.
const fn unreadable(id: &'static str, meaning: &'static str, invalid: Example) -> Rule {
    let because = "what follows or is missing cannot be read";
    Rule::error(id, [meaning, because], Reading, [SOUND, invalid]).fixed()
}

/// What is wrong with one place. Whether a part can be built without it is for the compiler to say.
const fn error(id: &'static str, meaning: &'static str, invalid: Example) -> Rule {
    Rule::error(id, [meaning, ""], Reading, [SOUND, invalid])
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
        "A document keeps to the limits of reading; reading.md lists them.",
        Words("elements nested deeper than --max-depth"),
    ),
    unreadable(
        ids::ENCODING,
        "A document is in an encoding that is read, and in no other than it says (warning).",
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
        "A file that is included can be read, and lies in the folder that files may be included from.",
        Document(r#"<include file="../beside.xodr"/>"#),
    ),
    unreadable(
        ids::ROOT,
        "The root is OpenDRIVE.",
        File(r#"<Map><header revMajor="1" revMinor="8"/></Map>"#),
    ),
    warning(
        ids::BEFORE_DECLARATION,
        "Nothing stands before the XML declaration.",
        File(
            " <?xml version=\"1.0\"?><OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/></OpenDRIVE>",
        ),
    ),
    warning(
        ids::NAMESPACE,
        "The root stands in no namespace, or in one of OpenDRIVE's.",
        File(r#"<OpenDRIVE xmlns="urn:another"><header revMajor="1" revMinor="8"/></OpenDRIVE>"#),
    ),
    error(ids::HEADER, "There is a header.", File("<OpenDRIVE></OpenDRIVE>")),
    error(
        ids::VERSION,
        "The header states a version, which is one that is known (warning).",
        File(r#"<OpenDRIVE><header revMajor="1" revMinor="x"/></OpenDRIVE>"#),
    ),
    error(
        ids::MISSING,
        "Required attributes are there.",
        Lanes(r#"<laneSection><center><lane id="0" type="none"/></center></laneSection>"#),
    ),
    error(ids::ELEMENT, "Required elements are there.", PlanView("")),
    error(
        ids::OCCURRENCE,
        "An element occurs as often as it may.",
        Header("<geoReference>a</geoReference><geoReference>b</geoReference>"),
    ),
    error(
        ids::CHOICE,
        "Of elements that exclude each other there is one.",
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><line/><arc curvature="0.1"/></geometry>"#,
        ),
    ),
    warning(
        ids::ORDER,
        "Elements stand in the schema's order.",
        Document(
            r#"<junction id="7" name=""/><road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road>"#,
        ),
    ),
    warning(
        ids::UNKNOWN_ATTRIBUTE,
        "Attributes are the standard's; others are kept as text.",
        Lane(r#"<speed sOffset="0" max="50" unit="km/h" least="30"/>"#),
    ),
    warning(
        ids::UNKNOWN_ELEMENT,
        "Elements are the standard's; others are kept as text.",
        Document("<street/>"),
    ),
    warning(
        ids::OTHER_VERSION,
        "Elements, attributes and words are those of the file's version; what later versions dropped is information.",
        File(
            r#"<OpenDRIVE><header revMajor="1" revMinor="4"/><road id="1" length="9" junction="-1" rule="RHT"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road></OpenDRIVE>"#,
        ),
    ),
    info(
        ids::DEPRECATED,
        "Elements, attributes and words are none that the file's version deprecates.",
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><poly3 a="0" b="0" c="0" d="0"/></geometry>"#,
        ),
    ),
    warning(
        ids::VARIANT,
        "Elements and attributes are those of the kind of junction, connection or segment that they stand in.",
        Junction(r#"<junction id="9" name="" mainRoad="1"/>"#),
    ),
    warning(ids::TEXT, "No text stands where only elements may.", Road("<link>1</link>")),
    warning(
        ids::NOT_KEPT,
        "An element beyond the standard's own is small enough to be kept.",
        Words("an element of another vendor's with more text than the limits allow"),
    ),
    error(
        ids::VALUE,
        "A value can be read as its type.",
        PlanView(r#"<geometry s="0" x="east" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    error(
        ids::FINITE,
        "A number is finite.",
        PlanView(r#"<geometry s="0" x="INF" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    error(
        ids::RANGE,
        "A number is within its range.",
        PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="-1"><line/></geometry>"#),
    ),
    warning(
        ids::LEXICAL,
        "A value is written as the schema has it.",
        PlanView(r#"<geometry s="0" x="0,5" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    info(
        ids::SPACE,
        "No white space surrounds a value.",
        PlanView(r#"<geometry s="0" x=" 0" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    error(
        ids::EMPTY,
        "An attribute that is there has a value; of one that need not be there it is a warning.",
        PlanView(r#"<geometry s="0" x="" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    error(
        ids::ENUMERATION,
        "A word is one of the standard's.",
        Objects(r#"<object id="1" type="lamppost" s="10" t="4" zOffset="0" orientation="none"/>"#),
    ),
]];
