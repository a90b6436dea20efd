//! Elements beyond the standard's own: kept as text, checked where the standard says something of them.

use crate::cursor::{Cursor, Markup, Name, NextChild, Open};
use crate::extension::{Extension, ExtensionKind};
use crate::finding::Severity;
use crate::generated::schema_additional_data as additional;
use crate::limits::ELEMENT_BYTES;
use crate::markup::Text;
use crate::rule_ids;
use crate::schema::{DATA_QUALITY, ElementSchema, INCLUDE, Kind, USER_DATA, alike};
use crate::well_formed::{Faults, duplicates};

/// Namespaces that OpenDRIVE has had.
pub(crate) const NAMESPACES: [&str; 5] = [
    "http://www.opendrive.org",
    "http://code.asam.net/simulation/standard/opendrive_schema",
    "https://code.asam.net/simulation/standard/opendrive_schema",
    "http://www.vires.com",
    "www.vires.com",
];

/// Whether a namespace is one of OpenDRIVE's; with or without a slash at its end.
pub(crate) fn is_opendrive(namespace: &[u8]) -> bool {
    let namespace = namespace.strip_suffix(b"/").unwrap_or(namespace);
    namespace.is_empty() || NAMESPACES.iter().any(|known| known.as_bytes() == namespace)
}

impl Cursor<'_> {
    /// Whether the start tag puts its element into a namespace that is not the root's.
    #[cold]
    pub(crate) fn is_redeclared(&self) -> bool {
        let key = match self.prefix.strip_suffix(b":") {
            Some(prefix) => [b"xmlns:", prefix].concat(),
            None => b"xmlns".to_vec(),
        };
        let declared = self.tag.attributes.iter().find(|raw| self.bytes(raw.name) == key);
        declared.is_some_and(|raw| {
            let namespace = self.bytes(raw.value);
            namespace != self.namespace && !is_opendrive(namespace)
        })
    }

    /// Reads an element that the schema does not have here, up to its end. None where it was an include that is read now.
    #[cold]
    pub(crate) fn other_child(&mut self, open: &mut Open) -> Option<Extension> {
        let span = self.tag.span;
        let full = self.bytes((1, 1 + self.tag.name as u32));
        let local = full.strip_prefix(self.prefix.as_slice()).filter(|name| !name.contains(&b':'));
        let foreign = local.is_none() || (self.tag.declares && self.is_redeclared());
        let known = match local {
            Some(b"userData") => Some((ExtensionKind::UserData, USER_DATA, &additional::USER_DATA)),
            Some(b"include") => Some((ExtensionKind::Include, INCLUDE, &additional::INCLUDE)),
            Some(b"dataQuality") => {
                Some((ExtensionKind::DataQuality, DATA_QUALITY, &additional::DATA_QUALITY))
            }
            _ => None,
        };
        // Within another extension nothing is kept a second time.
        let outermost = !self.within_extension;
        if outermost {
            self.within_extension = true;
            self.window.hold();
        }
        let kind = match known.filter(|_| !foreign && !open.schema.any) {
            Some((kind, rank, schema)) => {
                self.pending = match rank {
                    USER_DATA => "userData",
                    INCLUDE => "include",
                    _ => "dataQuality",
                };
                self.check_additional(open, rank, self.pending);
                let file = (rank == INCLUDE).then(|| self.attribute_text("file"));
                self.check_only(schema);
                if let Some(file) = file
                    && !self.over
                {
                    let text = self.kept(span);
                    self.within_extension = false;
                    if self.enter_include(&file, span) {
                        return None;
                    }
                    return Some(Extension { kind, text, span });
                }
                kind
            }
            None => {
                if !foreign && !open.schema.any {
                    let full = self.bytes((1, 1 + self.tag.name as u32));
                    let name = String::from_utf8_lossy(full).into_owned();
                    let message = format!(
                        "expected no element {name}, which the standard does not have here, found it; kept as text"
                    );
                    self.add(rule_ids::UNKNOWN_ELEMENT, Severity::Warning, span, &name, message);
                }
                self.skip();
                if foreign { ExtensionKind::Foreign } else { ExtensionKind::Unknown }
            }
        };
        if !outermost {
            return Some(Extension { kind, text: Box::default(), span });
        }
        self.within_extension = false;
        let text = self.kept(span);
        self.spend(text.len() + ELEMENT_BYTES);
        Some(Extension { kind, text, span })
    }

    /// The text that was held.
    fn kept(&mut self, span: crate::finding::Span) -> Box<str> {
        match self.window.release() {
            Some(bytes) if bytes.len() <= self.limits.extension_bytes => {
                // Of the standard library's two ways to the same text, the checked one is quick.
                match std::str::from_utf8(bytes) {
                    Ok(text) => text.into(),
                    Err(_) => String::from_utf8_lossy(bytes).into(),
                }
            }
            _ => {
                let message = format!(
                    "expected at most {} bytes in an element beyond the standard's own, found more; its text is not kept",
                    self.limits.extension_bytes
                );
                self.add(rule_ids::NOT_KEPT, Severity::Warning, span, "", message);
                Box::default()
            }
        }
    }

    /// Says where userData, include or dataQuality stands where the version has none.
    fn check_additional(&mut self, open: &Open, rank: usize, name: &str) {
        let versions = open.schema.additional[rank];
        if versions & alike(self.version as u8) == 0 {
            let (standard, span) = (self.standard(), self.tag.span);
            let message = format!("expected no {name} here in {standard}, found it; kept");
            self.add(rule_ids::OTHER_VERSION, Severity::Warning, span, name, message);
        }
    }

    /// Checks an element and what is inside without keeping values.
    fn check_only(&mut self, schema: &'static ElementSchema) {
        let mut open = self.open(schema);
        while self.next_attribute(&mut open).is_some() {
            self.check_value();
        }
        self.finish_attributes(&mut open);
        loop {
            match self.next_child(&mut open) {
                NextChild::Child(slot) => {
                    if let Some(child) = schema.children.get(slot) {
                        self.check_only(child.element);
                    }
                }
                NextChild::Extension(_) => {}
                NextChild::End => return,
            }
        }
    }

    /// Reads a value for nothing but its findings.
    fn check_value(&mut self) {
        match self.schema.kind {
            Kind::Double => drop(self.double()),
            Kind::Int => drop(self.int()),
            Kind::Uint => drop(self.uint()),
            Kind::Text => drop(self.text()),
            Kind::Country => drop(self.country()),
            Kind::SpeedLimit | Kind::LaneSpeedLimit => drop(self.speed_limit()),
            Kind::PositionOrEnd => drop(self.position_or_end()),
            Kind::Boolean | Kind::YesNo | Kind::XsBoolean => drop(self.boolean()),
            Kind::Words(list) => drop(self.word_of(list)),
        }
    }

    /// Passes over the element whose start tag has been read, up to its end.
    pub(crate) fn skip(&mut self) {
        let depth = self.frames.len();
        loop {
            self.check_names();
            if !self.tag.empty {
                let at = self.names.len();
                let name = self.window.token().get(1..1 + self.tag.name).unwrap_or_default();
                self.names.extend_from_slice(name);
                self.push_frame(Name::Other(at, self.tag.name), at);
                if self.names.len() > self.limits.tag_bytes {
                    let most = self.limits.tag_bytes;
                    let message = format!(
                        "expected at most {most} bytes in the names of nested elements, found more"
                    );
                    self.refuse(rule_ids::LIMIT, self.tag.span.start, message);
                    return;
                }
            }
            while self.frames.len() > depth {
                match self.markup(Text::Any) {
                    Markup::Start => break,
                    Markup::End => self.pop_frame(),
                    Markup::Over => return,
                }
            }
            if self.frames.len() == depth {
                return;
            }
        }
    }

    /// Finds attributes of one name in a tag that no schema is asked about.
    fn check_names(&mut self) {
        if self.tag.attributes.len() < 2 {
            return;
        }
        let start = self.tag.span.start;
        let names: Vec<(&[u8], u64)> = self
            .tag
            .attributes
            .iter()
            .map(|raw| (self.bytes(raw.name), start + u64::from(raw.name.0)))
            .collect();
        let mut faults = Faults::default();
        duplicates(&names, &mut faults);
        self.faults(faults);
    }
}
