//! What is left out, and the document without it.

use super::{Cause, PartKind, QuarantinedContent, QuarantinedPart, Treatment, Unit};
use mapd_rules::line::ReferenceLine;
use mapd_xodr::{Connection, Item, Junction, Objects, Road, Signals, Span, Text as _, Value as _};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Reach around an object or signal whose size is not told `[m]`.
const SIZE: f64 = 1.0;

/// A part that is left out.
struct Excluded {
    treatment: Treatment,
    cause: Cause,
}

/// The road or junction that a part belongs to; of what stands for itself, that.
#[derive(Clone, Copy)]
struct Owner<'a> {
    kind: PartKind,
    id: &'a str,
}

/// A part of the document, as it is named where it is left out.
struct Named<'a> {
    kind: PartKind,
    /// The start tag.
    span: Span,
    id: &'a str,
    owner: Owner<'a>,
}

/// Where a part is.
#[derive(Default)]
struct Located {
    /// Smallest x, smallest y, largest x, largest y `[m]`; none where it cannot be told.
    extent: Option<[f64; 4]>,
    /// Of a road `[m]`, else 0.
    length: f64,
}

impl Located {
    /// Around something of no length.
    fn around(extent: Option<[f64; 4]>) -> Self {
        Self { extent, length: 0.0 }
    }
}

/// Parts that are left out, by the start of their tags.
#[derive(Default)]
pub(crate) struct Exclusions {
    parts: BTreeMap<u64, Excluded>,
    /// Starts of top-level elements that have such a part within.
    owners: BTreeSet<u64>,
    /// Errors of the whole document, by place and rule; none where they are not all known.
    errors: Option<Arc<BTreeSet<(u64, &'static str)>>>,
}

impl Exclusions {
    /// Takes the errors of the document as it is written.
    pub(crate) fn with_errors(errors: Option<BTreeSet<(u64, &'static str)>>) -> Self {
        Self { errors: errors.map(Arc::new), ..Self::default() }
    }

    /// Errors of the whole document.
    pub(crate) fn errors(&self) -> Option<Arc<BTreeSet<(u64, &'static str)>>> {
        self.errors.clone()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// Leaves out a part of the top-level element that begins at `top`, or does so more thoroughly. False where nothing more
    /// can be done about it.
    pub(crate) fn add(
        &mut self,
        unit: Unit,
        top: u64,
        cause: Cause,
        keep_reference_lines: bool,
    ) -> bool {
        let treatment = match self.parts.get(&unit.start).map(|part| part.treatment) {
            None if keep_reference_lines && unit.kind == PartKind::Road => Treatment::ReferenceLine,
            None | Some(Treatment::ReferenceLine) => Treatment::Dropped,
            Some(Treatment::Dropped) => return false,
        };
        self.owners.insert(top);
        // The first reason stays: it is the one that the file's author has to mend.
        let cause = self.parts.remove(&unit.start).map_or(cause, |part| part.cause);
        self.parts.insert(unit.start, Excluded { treatment, cause });
        true
    }

    /// Whether the road that begins here is kept as its reference line alone.
    pub(crate) fn is_bare(&self, start: u64) -> bool {
        self.parts.get(&start).is_some_and(|part| part.treatment == Treatment::ReferenceLine)
    }

    /// Whether the part that begins here is left out.
    pub(crate) fn dropped(&self, start: u64) -> bool {
        self.parts.get(&start).is_some_and(|part| part.treatment == Treatment::Dropped)
    }

    /// The element without what is left out of it; none where that is all of it. What is left out is told.
    pub(crate) fn filter(&self, item: Item, out: &mut Vec<QuarantinedPart>) -> Option<Item> {
        match item {
            Item::Road(road) => self.road(*road, out).map(|road| Item::Road(Box::new(road))),
            Item::Junction(junction) => {
                self.junction(*junction, out).map(|junction| Item::Junction(Box::new(junction)))
            }
            Item::Controller(c) => self
                .top(PartKind::Controller, c.span, c.id.text(), out)
                .then_some(Item::Controller(c)),
            Item::JunctionGroup(g) => self
                .top(PartKind::Other, g.span, g.id.text(), out)
                .then_some(Item::JunctionGroup(g)),
            Item::Station(s) => {
                self.top(PartKind::Other, s.span, s.id.text(), out).then_some(Item::Station(s))
            }
            Item::VmsGroup(g) => {
                self.top(PartKind::Other, g.span, g.id.text(), out).then_some(Item::VmsGroup(g))
            }
            header @ Item::Header(_) => Some(header),
        }
    }

    /// Tells a part that is left out.
    fn tell(
        &self,
        named: Named<'_>,
        place: impl FnOnce() -> Located,
        out: &mut Vec<QuarantinedPart>,
    ) -> Option<Treatment> {
        let Named { kind, span, id, owner } = named;
        let part = self.parts.get(&{ span.start })?;
        let Located { extent, length } = place();
        out.push(QuarantinedPart {
            kind,
            id: id.to_owned(),
            owner: owner.id.to_owned(),
            owner_kind: owner.kind,
            treatment: part.treatment,
            extent,
            length,
            rule: part.cause.rule,
            message: part.cause.message.clone(),
            line: part.cause.line,
            column: part.cause.column,
            file: part.cause.file.clone(),
            contents: Vec::new(),
        });
        Some(part.treatment)
    }

    /// Whether an element without parts of its own stays.
    fn top(&self, kind: PartKind, span: Span, id: &str, out: &mut Vec<QuarantinedPart>) -> bool {
        let named = Named { kind, span, id, owner: Owner { kind, id } };
        self.tell(named, Located::default, out).is_none()
    }

    fn road(&self, mut road: Road, out: &mut Vec<QuarantinedPart>) -> Option<Road> {
        if !self.owners.contains(&{ road.span.start }) {
            return Some(road);
        }
        let id = road.id.text().to_owned();
        let own = Owner { kind: PartKind::Road, id: &id };
        let place = || Located {
            extent: mapd_rules::extent(&road),
            length: road.length.value().unwrap_or(0.0),
        };
        let named = Named { kind: PartKind::Road, span: road.span, id: &id, owner: own };
        if let Some(treatment) = self.tell(named, place, out) {
            let objects = road.objects.iter().flat_map(|all| objects_in(all));
            note_contents(out, objects.chain(road.signals.iter().flat_map(|all| signals_in(all))));
            return if treatment == Treatment::Dropped { None } else { bare(road) };
        }
        let line = ReferenceLine::new(road.plan_view.as_deref());
        if let Some(objects) = &mut road.objects {
            self.objects(objects, own, Some(&line), out);
        }
        if let Some(signals) = &mut road.signals {
            self.signals(signals, own, &line, out);
        }
        Some(road)
    }

    fn objects(
        &self,
        objects: &mut Objects,
        owner: Owner<'_>,
        line: Option<&ReferenceLine>,
        out: &mut Vec<QuarantinedPart>,
    ) {
        let kind = PartKind::Object;
        objects.object.retain(|o| {
            let size =
                [o.length.value(), o.width.value(), o.radius.value().map(|radius| 2.0 * radius)];
            let size = size.into_iter().flatten().fold(0.0, f64::max);
            let place = || Located::around(around(line, o.s.value(), o.t.value(), size));
            let named = Named { kind, span: o.span, id: o.id.text(), owner };
            self.tell(named, place, out).is_none()
        });
        objects.object_reference.retain(|o| {
            let place = || Located::around(around(line, o.s.value(), o.t.value(), 0.0));
            let named = Named { kind, span: o.span, id: o.id.text(), owner };
            self.tell(named, place, out).is_none()
        });
        objects.tunnel.retain(|o| {
            let place = || Located::around(around(line, o.s.value(), None, 0.0));
            let named = Named { kind, span: o.span, id: o.id.text(), owner };
            self.tell(named, place, out).is_none()
        });
        objects.bridge.retain(|o| {
            let place = || Located::around(around(line, o.s.value(), None, 0.0));
            let named = Named { kind, span: o.span, id: o.id.text(), owner };
            self.tell(named, place, out).is_none()
        });
    }

    fn signals(
        &self,
        signals: &mut Signals,
        owner: Owner<'_>,
        line: &ReferenceLine,
        out: &mut Vec<QuarantinedPart>,
    ) {
        let kind = PartKind::Signal;
        signals.signal.retain(|s| {
            let place = || Located::around(around(Some(line), s.s.value(), s.t.value(), 0.0));
            let named = Named { kind, span: s.span, id: s.id.text(), owner };
            self.tell(named, place, out).is_none()
        });
        signals.signal_reference.retain(|s| {
            let place = || Located::around(around(Some(line), s.s.value(), s.t.value(), 0.0));
            let named = Named { kind, span: s.span, id: s.id.text(), owner };
            self.tell(named, place, out).is_none()
        });
    }

    fn junction(&self, mut junction: Junction, out: &mut Vec<QuarantinedPart>) -> Option<Junction> {
        if !self.owners.contains(&{ junction.span.start }) {
            return Some(junction);
        }
        let id = junction.id.text().to_owned();
        if !self.top(PartKind::Junction, junction.span, &id, out) {
            note_contents(out, junction.objects.iter().flat_map(|all| objects_in(all)));
            return None;
        }
        let own = Owner { kind: PartKind::Junction, id: &id };
        junction.connection.retain_mut(|c| {
            let kind = PartKind::Connection;
            let named = Named { kind, span: c.span, id: c.id.text(), owner: own };
            self.tell(named, Located::default, out).is_none() && self.lane_links(c, own, out)
        });
        if let Some(objects) = &mut junction.objects {
            self.objects(objects, own, None, out);
        }
        Some(junction)
    }
}

/// Objects, tunnels and bridges with their ids.
fn objects_in(objects: &Objects) -> impl Iterator<Item = QuarantinedContent> + '_ {
    let ids = objects.object.iter().map(|o| o.id.text());
    let ids = ids.chain(objects.tunnel.iter().map(|o| o.id.text()));
    let ids = ids.chain(objects.bridge.iter().map(|o| o.id.text()));
    ids.map(|id| QuarantinedContent { kind: PartKind::Object, id: id.to_owned() })
}

/// Signals with their ids.
fn signals_in(signals: &Signals) -> impl Iterator<Item = QuarantinedContent> + '_ {
    let ids = signals.signal.iter().map(|signal| signal.id.text());
    ids.map(|id| QuarantinedContent { kind: PartKind::Signal, id: id.to_owned() })
}

/// Notes what is missing with the part that was told last.
fn note_contents(out: &mut [QuarantinedPart], contents: impl Iterator<Item = QuarantinedContent>) {
    if let Some(part) = out.last_mut() {
        part.contents.extend(contents.filter(|content| !content.id.is_empty()));
    }
}

impl Exclusions {
    /// Leaves out lane links of a connection. False where none is left: then the connection goes, for without any it would
    /// join lanes of equal numbers, which it does not say.
    fn lane_links(
        &self,
        connection: &mut Connection,
        junction: Owner<'_>,
        out: &mut Vec<QuarantinedPart>,
    ) -> bool {
        let is_left_out = |span: Span| self.parts.contains_key(&{ span.start });
        let id = connection.id.text().to_owned();
        if let Some(first) = connection.lane_link.first()
            && connection.lane_link.iter().all(|link| is_left_out(link.span))
        {
            let kind = PartKind::Connection;
            let named = Named { kind, span: first.span, id: &id, owner: junction };
            self.tell(named, Located::default, out);
            return false;
        }
        connection.lane_link.retain(|link| {
            let lane = |number: Option<i32>| number.map_or("?".to_owned(), |n| n.to_string());
            !is_left_out(link.span) || {
                let own = format!("{id}:{}:{}", lane(link.from.value()), lane(link.to.value()));
                let kind = PartKind::LaneLink;
                let named = Named { kind, span: link.span, id: &own, owner: junction };
                self.tell(named, Located::default, out).is_none()
            }
        });
        true
    }
}

/// The road as its reference line alone: its first section without lanes, for a road has one. None where there is none.
fn bare(mut road: Road) -> Option<Road> {
    road.lanes.truncate(1);
    let lanes = road.lanes.first_mut()?;
    lanes.lane_offset.clear();
    lanes.lane_section.truncate(1);
    let section = lanes.lane_section.first_mut()?;
    (section.left, section.right) = (None, None);
    if let Some(center) = &mut section.center {
        center.lane.truncate(1);
        for lane in &mut center.lane {
            lane.link = None;
        }
    }
    Some(Road {
        link: None,
        r#type: Vec::new(),
        elevation_profile: None,
        lateral_profile: None,
        objects: None,
        signals: None,
        surface: None,
        railroad: None,
        ..road
    })
}

/// The box about a place along a road `[m]`: at t, or as far as the road's middle.
fn around(
    line: Option<&ReferenceLine>,
    s: Option<f64>,
    t: Option<f64>,
    size: f64,
) -> Option<[f64; 4]> {
    let point = line?.at(s?)?;
    let t = t.unwrap_or(0.0);
    let (x, y) = (point.x - t * point.sin, point.y + t * point.cos);
    let reach = size.max(SIZE);
    Some([x - reach, y - reach, x + reach, y + reach])
}
