//! Examples of rules: snippets, and the documents that they stand for.

use crate::rule::Minor;

/// A snippet of a document, by the place where it belongs. What it does not say is filled in by a sound template.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Example {
    /// All of a file.
    File(&'static str),
    /// Top-level elements behind the header.
    Document(&'static str),
    /// Children of the header, in a document with one road.
    Header(&'static str),
    /// Children of a road of 100 m; reference line and lanes are there unless the snippet has its own.
    Road(&'static str),
    /// Children of `planView`.
    PlanView(&'static str),
    /// Children of `lanes`.
    Lanes(&'static str),
    /// Children of `laneSection`, of a section of 100 m.
    Section(&'static str),
    /// Children of lane -1, a driving lane; a width is there unless the snippet has a width or border.
    Lane(&'static str),
    /// Elements along the road of 100 m with lanes from 2 to -2: within `objects`.
    Objects(&'static str),
    /// Elements along the road of 100 m with lanes from 2 to -2: within `signals`.
    Signals(&'static str),
    /// Elements beside three roads in a row: 1 leads into junction 9, where road 2 leads on to road 3.
    Junction(&'static str),
    /// No snippet: a document that is too large to print, or options, in words.
    Words(&'static str),
}

const LINE: &str =
    r#"<planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView>"#;

const LANES: &str = r#"<lanes><laneSection s="0">
<left><lane id="2" type="shoulder"><width sOffset="0" a="2" b="0" c="0" d="0"/></lane>
<lane id="1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></left>
<center><lane id="0" type="none"/></center>
<right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="shoulder"><width sOffset="0" a="2" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#;

/// Three roads in a row with one driving lane each; the middle one belongs to junction 9.
const ROW: &str = r#"<road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link>
<planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center>
<right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="20" junction="9"><link><predecessor elementType="road" elementId="1" contactPoint="end"/>
<successor elementType="road" elementId="3" contactPoint="start"/></link>
<planView><geometry s="0" x="50" y="0" hdg="0" length="20"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center>
<right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="3" length="50" junction="-1"><link><predecessor elementType="junction" elementId="9"/></link>
<planView><geometry s="0" x="70" y="0" hdg="0" length="50"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center>
<right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#;

impl Example {
    /// The snippet as it is written in the catalog.
    pub fn snippet(&self) -> &'static str {
        match self {
            Self::File(text)
            | Self::Document(text)
            | Self::Header(text)
            | Self::Road(text)
            | Self::PlanView(text)
            | Self::Lanes(text)
            | Self::Section(text)
            | Self::Lane(text)
            | Self::Objects(text)
            | Self::Signals(text)
            | Self::Junction(text)
            | Self::Words(text) => text,
        }
    }

    /// Where the snippet belongs, in words.
    pub fn place(&self) -> &'static str {
        match self {
            Self::File(_) => "file",
            Self::Document(_) => "document",
            Self::Header(_) => "header",
            Self::Road(_) => "road",
            Self::PlanView(_) => "planView",
            Self::Lanes(_) => "lanes",
            Self::Section(_) => "laneSection",
            Self::Lane(_) => "lane",
            Self::Objects(_) => "objects",
            Self::Signals(_) => "signals",
            Self::Junction(_) => "document with a junction",
            Self::Words(_) => "words",
        }
    }

    /// The whole document, of a version; none where the example is words.
    pub fn document(&self, minor: Minor) -> Option<String> {
        let text = self.snippet();
        let mut header = "";
        let body = match self {
            Self::Words(_) => return None,
            Self::File(_) => return Some(text.to_owned()),
            Self::Document(_) => text.to_owned(),
            Self::Header(_) => {
                header = text;
                road("")
            }
            Self::Road(_) => road(text),
            Self::PlanView(_) => road(&format!("<planView>{text}</planView>")),
            Self::Lanes(_) => road(&format!("<lanes>{text}</lanes>")),
            Self::Section(_) => section(text),
            Self::Lane(_) => {
                let width = if text.contains("<width") || text.contains("<border") {
                    ""
                } else {
                    r#"<width sOffset="0" a="3" b="0" c="0" d="0"/>"#
                };
                section(&format!(
                    r#"<center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">{width}{text}</lane></right>"#
                ))
            }
            Self::Objects(_) => road(&format!("<objects>{text}</objects>")),
            Self::Signals(_) => road(&format!("<signals>{text}</signals>")),
            Self::Junction(_) => format!("{ROW}{text}"),
        };
        Some(format!(
            "<OpenDRIVE><header revMajor=\"1\" revMinor=\"{minor}\">{header}</header>\n{body}</OpenDRIVE>"
        ))
    }
}

fn road(text: &str) -> String {
    let line = if text.contains("<planView") { "" } else { LINE };
    let lanes = if text.contains("<lanes") { "" } else { LANES };
    // Links and types stand before the reference line, all else that examples have behind it.
    let split = [
        "<planView",
        "<elevationProfile",
        "<lateralProfile",
        "<lanes",
        "<objects",
        "<signals",
        "<surface>",
        "<railroad",
    ]
    .iter()
    .filter_map(|tag| text.find(tag))
    .min()
    .unwrap_or(text.len());
    let (before, rest) = text.split_at(split);
    let split = ["<objects", "<signals", "<surface>", "<railroad"]
        .iter()
        .filter_map(|tag| rest.find(tag))
        .min()
        .unwrap_or(rest.len());
    let (middle, after) = rest.split_at(split);
    format!(
        r#"<road id="1" length="100" junction="-1">{before}{line}{middle}{lanes}{after}</road>"#
    )
}

fn section(text: &str) -> String {
    road(&format!(r#"<lanes><laneSection s="0">{text}</laneSection></lanes>"#))
}
