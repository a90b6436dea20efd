//! Which part of the document a place is in.

use mapd_xodr::source::Places;
use mapd_xodr::{Item, Junction, Objects, Road, Span};

/// Kinds of parts that can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum PartKind {
    /// A road with all that is along it.
    Road,
    /// A junction; its roads stay, without connections.
    Junction,
    /// A connection of a junction.
    Connection,
    /// An object, tunnel, bridge or reference to an object.
    Object,
    /// A signal or a reference to one.
    Signal,
    /// A controller.
    Controller,
    /// A junction group, station or group of boards.
    Other,
    /// A lane link of a connection.
    LaneLink,
}

impl PartKind {
    /// The element's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Road => "road",
            Self::Junction => "junction",
            Self::Connection => "connection",
            Self::Object => "object",
            Self::Signal => "signal",
            Self::Controller => "controller",
            Self::Other => "group",
            Self::LaneLink => "laneLink",
        }
    }

    /// As the archive has it.
    pub(crate) fn code(self) -> u8 {
        self as u8
    }
}

/// A part by the start of its tag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unit {
    pub(crate) kind: PartKind,
    pub(crate) start: u64,
    /// Start of the part that it is in: a connection for a lane link, the top-level element for others, its own for these.
    pub(crate) owner: u64,
}

/// From where on places are in a part. There are millions, so that what nearly always lies close before is kept as a distance.
#[derive(Clone, Copy)]
struct Begin {
    place: u64,
    /// How far before it the owner starts `[bytes]`; or the rank in [`Units::far`].
    owner: u32,
    kind: PartKind,
    start: Start,
}

/// Where the part starts that a place begins or goes on with.
#[derive(Clone, Copy)]
enum Start {
    /// At the place.
    Here,
    /// Where its owner does: it is the owner.
    AtOwner,
    /// As [`Units::far`] says, as it does of the owner.
    Far,
}

/// Where each part begins, in the order of the document.
#[derive(Default)]
pub(crate) struct Units {
    begins: Vec<Begin>,
    /// Parts that [`Begin`] has no room for: their owner is in another file or more than 4 GiB before, or they go on behind a part of theirs.
    far: Vec<Unit>,
    /// Whether some places do not ascend: those of included files.
    is_unsorted: bool,
}

impl Units {
    /// From a place on, places are in a part.
    fn begin(&mut self, place: u64, unit: Unit) {
        let start = match unit.start {
            start if start == place => Some(Start::Here),
            start if start == unit.owner => Some(Start::AtOwner),
            _ => None,
        };
        let distance = place.checked_sub(unit.owner).and_then(|bytes| u32::try_from(bytes).ok());
        let (start, owner) = start.zip(distance).unwrap_or_else(|| {
            self.far.push(unit);
            (Start::Far, self.far.len() as u32 - 1)
        });
        self.begins.push(Begin { place, owner, kind: unit.kind, start });
    }

    /// The part that places are in from there on.
    fn unit(&self, begin: Begin) -> Option<Unit> {
        let owner = begin.place.wrapping_sub(begin.owner.into());
        let start = match begin.start {
            Start::Here => begin.place,
            Start::AtOwner => owner,
            Start::Far => return self.far.get(begin.owner as usize).copied(),
        };
        Some(Unit { kind: begin.kind, start, owner })
    }

    /// The part that a place is in; none before the first.
    pub(crate) fn of(&mut self, place: u64) -> Option<Unit> {
        if std::mem::take(&mut self.is_unsorted) {
            self.begins.sort_by_key(|begin| begin.place);
        }
        let after = self.begins.partition_point(|begin| begin.place <= place);
        self.unit(*self.begins.get(after.checked_sub(1)?)?)
    }

    /// The part that a part is in; none for a top-level element.
    pub(crate) fn around(&mut self, unit: Unit) -> Option<Unit> {
        self.of(unit.owner).filter(|owner| *owner != unit)
    }

    /// Takes the places of the parts of the elements that come next.
    pub(crate) fn append(&mut self, next: Self) {
        let (far, before) = (self.far.len() as u32, self.begins.len());
        self.is_unsorted |= next.is_unsorted;
        self.far.extend(next.far);
        self.begins.extend(next.begins.into_iter().map(|begin| match begin.start {
            Start::Far => Begin { owner: begin.owner.saturating_add(far), ..begin },
            Start::Here | Start::AtOwner => begin,
        }));
        self.joined(before);
    }

    /// Takes the places of a top-level element's parts.
    pub(crate) fn add(&mut self, item: &Item) {
        let before = self.begins.len();
        match item {
            Item::Header(_) => {}
            Item::Road(road) => self.road(road),
            Item::Junction(junction) => self.junction(junction),
            Item::Controller(controller) => self.top(PartKind::Controller, controller.span),
            Item::JunctionGroup(group) => self.top(PartKind::Other, group.span),
            Item::Station(station) => self.top(PartKind::Other, station.span),
            Item::VmsGroup(group) => self.top(PartKind::Other, group.span),
        }
        self.unite(before);
        self.joined(before);
    }

    /// Notes whether the places from a rank on, which ascend, go on behind those before: to sort all for each element would take the
    /// square of their number.
    fn joined(&mut self, before: usize) {
        let pair = before.checked_sub(1).and_then(|last| self.begins.get(last..=before));
        self.is_unsorted |= pair.is_some_and(|pair| pair[0].place > pair[1].place);
    }

    /// Leaves out of one element's places, which are the last ones, those that say what the one before them in the same file
    /// says already.
    fn unite(&mut self, before: usize) {
        let Some(own) = self.begins.get_mut(before..) else { return };
        own.sort_by_key(|begin| begin.place);
        let mut kept = before;
        for at in before..self.begins.len() {
            let begin = self.begins[at];
            let last = self.begins[before..kept].last().copied();
            let goes_on = last.is_some_and(|last| {
                self.unit(last) == self.unit(begin)
                    && Places::file_of(last.place) == Places::file_of(begin.place)
            });
            if !goes_on {
                self.begins[kept] = begin;
                kept += 1;
            }
        }
        self.begins.truncate(kept);
    }

    fn top(&mut self, kind: PartKind, span: Span) {
        self.part(kind, span, span);
    }

    /// A part within an element.
    fn part(&mut self, kind: PartKind, span: Span, owner: Span) {
        let unit = Unit { kind, start: span.start, owner: owner.start };
        self.begin(span.start, unit);
    }

    /// From here on, a place is in the element itself again.
    fn back(&mut self, kind: PartKind, span: Span, owner: Span) {
        let unit = Unit { kind, start: owner.start, owner: owner.start };
        self.begin(span.start, unit);
    }

    fn road(&mut self, road: &Road) {
        let (kind, own) = (PartKind::Road, road.span);
        self.top(kind, own);
        if let Some(objects) = &road.objects {
            self.objects(objects, kind, own);
        }
        if let Some(signals) = &road.signals {
            self.back(kind, signals.span, own);
            signals.signal.iter().for_each(|s| self.part(PartKind::Signal, s.span, own));
            signals.signal_reference.iter().for_each(|s| self.part(PartKind::Signal, s.span, own));
        }
        // What may stand behind objects and signals, in any order.
        let link = road.link.iter().map(|link| link.span);
        let rest = link
            .chain(road.r#type.iter().map(|record| record.span))
            .chain(road.plan_view.iter().map(|plan_view| plan_view.span))
            .chain(road.elevation_profile.iter().map(|profile| profile.span))
            .chain(road.lateral_profile.iter().map(|profile| profile.span))
            .chain(road.lanes.iter().map(|lanes| lanes.span))
            .chain(road.surface.iter().map(|surface| surface.span))
            .chain(road.railroad.iter().map(|railroad| railroad.span));
        rest.for_each(|span| self.back(kind, span, own));
    }

    fn objects(&mut self, objects: &Objects, kind: PartKind, own: Span) {
        self.back(kind, objects.span, own);
        let parts = objects
            .object
            .iter()
            .map(|object| object.span)
            .chain(objects.object_reference.iter().map(|object| object.span))
            .chain(objects.tunnel.iter().map(|tunnel| tunnel.span))
            .chain(objects.bridge.iter().map(|bridge| bridge.span));
        parts.for_each(|span| self.part(PartKind::Object, span, own));
    }

    fn junction(&mut self, junction: &Junction) {
        let (kind, own) = (PartKind::Junction, junction.span);
        self.top(kind, own);
        for connection in &junction.connection {
            self.part(PartKind::Connection, connection.span, own);
            for link in &connection.lane_link {
                self.part(PartKind::LaneLink, link.span, connection.span);
            }
            // What else a connection has may stand behind its lane links.
            let (start, owner) = (connection.span.start, own.start);
            let unit = Unit { kind: PartKind::Connection, start, owner };
            let ends = [&connection.predecessor, &connection.successor].into_iter().flatten();
            ends.for_each(|end| self.begin(end.span.start, unit));
        }
        let rest = junction
            .road_section
            .iter()
            .map(|section| section.span)
            .chain(junction.cross_path.iter().map(|path| path.span))
            .chain(junction.priority.iter().map(|priority| priority.span))
            .chain(junction.controller.iter().map(|controller| controller.span))
            .chain(junction.surface.iter().map(|surface| surface.span))
            .chain(junction.plan_view.iter().map(|plan_view| plan_view.span))
            .chain(junction.boundary.iter().map(|boundary| boundary.span))
            .chain(junction.elevation_grid.iter().map(|grid| grid.span));
        rest.for_each(|span| self.back(kind, span, own));
        if let Some(objects) = &junction.objects {
            self.objects(objects, kind, own);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Maps have millions of places: a begin took 32 bytes.
    #[test]
    fn parts_are_told_as_they_were_entered() {
        assert_eq!(size_of::<Begin>(), 16);
        let unit = |kind, start, owner| Unit { kind, start, owner };
        let beyond_32_bits = 200 + (1 << 33);
        let included = Places::start(1, 5);
        let entered = [
            (100, unit(PartKind::Road, 100, 100)),
            (110, unit(PartKind::Signal, 110, 100)),
            (120, unit(PartKind::Road, 100, 100)),
            (200, unit(PartKind::Junction, 200, 200)),
            (210, unit(PartKind::Connection, 210, 200)),
            (220, unit(PartKind::LaneLink, 220, 210)),
            (230, unit(PartKind::Connection, 210, 200)),
            (beyond_32_bits, unit(PartKind::Object, beyond_32_bits, 200)),
            (included, unit(PartKind::Object, included, 200)),
            (included + 9, unit(PartKind::Junction, 200, 200)),
        ];
        for cut in 0..=entered.len() {
            let (mut whole, mut next) = (Units::default(), Units::default());
            let (before, behind) = entered.split_at(cut);
            before.iter().for_each(|(place, unit)| whole.begin(*place, *unit));
            behind.iter().for_each(|(place, unit)| next.begin(*place, *unit));
            whole.append(next);
            assert_eq!(whole.of(99), None);
            for (place, unit) in entered {
                assert_eq!([whole.of(place), whole.of(place + 1)], [Some(unit); 2], "{place}");
            }
        }
    }
}
