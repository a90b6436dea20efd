//! Signals, controllers and groups as written.

use super::semantics::{SemanticsEntry, meant};
use super::speeds::{self, is_of_speed};
use super::{ElementContext, ElementPath, assumed_unit, lanes, orientation};
use crate::draft::{Draft, Position, SignalReference, WrittenSignal, between};
use mapd_archive::{
    AnnotationOwner, BoardGroupRow, Class, ControlRow, ControllerRow, DisplayAreaRow, LaneRangeRow,
    NONE, SignalBoardRow, SignalDependencyRow, SignalLinkRow, SignalRow, SignalSemanticsRow,
    signal_flags, signal_values,
};
use mapd_ontology::{ClassGroup, Meaning, SignalCode};
use mapd_xodr::{
    self as xodr, BoardSign, Controller, Finding, LaneValidity, Road, Span, Text as _, Value as _,
    VmsGroup,
};

/// Boards on boards that are followed at most.
const DEEPEST_BOARD: usize = 8;

/// What a signal and a sign on a board have in common.
struct Common<'a> {
    span: Span,
    texts: [&'a str; 8],
    value: Option<f64>,
    unit: Option<xodr::Unit>,
    size: [Option<f64>; 3],
    angles: [Option<f64>; 3],
    orientation: Option<xodr::Orientation>,
    dynamic: bool,
    flags: u8,
    validity: &'a [LaneValidity],
    dependency: &'a [xodr::SignalDependency],
    reference: &'a [xodr::SignalLink],
    semantics: Option<&'a xodr::Semantics>,
    static_board: &'a [xodr::StaticBoard],
    vms_board: &'a [xodr::VmsBoard],
    inertial: Option<&'a xodr::PositionInertial>,
    on_road: Option<&'a xodr::PositionRoad>,
}

macro_rules! common {
    ($signal:expr) => {{
        let signal = $signal;
        let flag = |set: Option<bool>, bit| if set == Some(true) { bit } else { 0 };
        Common {
            span: signal.span,
            texts: [
                signal.id.text(),
                signal.name.text(),
                signal.r#type.text(),
                signal.subtype.text(),
                signal.country.text(),
                signal.country_revision.text(),
                signal.text.text(),
                signal.unit.value().map_or("", xodr::Unit::name),
            ],
            value: signal.value.value(),
            unit: signal.unit.value(),
            size: [signal.width.value(), signal.height.value(), signal.length.value()],
            angles: [signal.h_offset.value(), signal.pitch.value(), signal.roll.value()],
            orientation: signal.orientation.value(),
            dynamic: signal.dynamic.value() == Some(true),
            flags: flag(signal.temporary.value(), signal_flags::TEMPORARY)
                | flag(signal.invalidated.value(), signal_flags::INVALIDATED),
            validity: &signal.validity,
            dependency: &signal.dependency,
            reference: &signal.reference,
            semantics: signal.semantics.as_deref(),
            static_board: &signal.static_board,
            vms_board: &signal.vms_board,
            inertial: signal.position_inertial.as_deref(),
            on_road: signal.position_road.as_deref(),
        }
    }};
}

/// What a signal stands on.
#[derive(Clone, Copy)]
struct Stand {
    /// Row of the road.
    road: u32,
    /// Row of the signal that carries it, [`NONE`] of one that stands by itself.
    carrier: u32,
    /// s, t and height above the road `[m]`.
    at: [f64; 3],
}

impl Draft {
    /// Appends a road's signals and references to signals.
    pub(crate) fn signals(
        &mut self,
        road: &Road,
        number: u32,
        path: &str,
        findings: &mut Vec<Finding>,
    ) {
        let Some(signals) = road.signals.as_deref() else { return };
        for signal in &signals.signal {
            let mut part = ElementContext {
                span: signal.span,
                path: ElementPath::new(path, "signals/signal"),
                findings,
            };
            let (s, t) =
                (part.need_along(signal.s.value(), "s"), part.need_along(signal.t.value(), "t"));
            let (Some(s), Some(t)) = (s, t) else { continue };
            let z = signal.z_offset.value().unwrap_or(0.0);
            let stand = Stand { road: number, carrier: NONE, at: [s, t, z] };
            let carrier = self.signal(&common!(signal), stand, None, &mut part);
            let boards = Stand { carrier, ..stand };
            self.boards(&common!(signal), boards, DEEPEST_BOARD, &mut part);
        }
        for reference in &signals.signal_reference {
            let path = ElementPath::new(path, "signals/signalReference");
            let mut part = ElementContext { span: reference.span, path, findings };
            let (s, t) = (
                part.need_along(reference.s.value(), "s"),
                part.need_along(reference.t.value(), "t"),
            );
            let id = part.need(reference.id.as_ref(), "id");
            let (Some(s), Some(t), Some(_)) = (s, t, id) else { continue };
            let id = self.strings.add(reference.id.text());
            self.signals.references.push(SignalReference {
                road: number,
                id,
                s,
                t,
                orientation: orientation(reference.orientation.value()).code(),
                validity: lanes(&reference.validity).into(),
                span: reference.span,
            });
        }
    }

    /// Appends a signal or a sign on a board; returns its row.
    fn signal(
        &mut self,
        signal: &Common<'_>,
        stand: Stand,
        on_carrier: Option<(f64, f64)>,
        part: &mut ElementContext<'_>,
    ) -> u32 {
        let Stand { road, carrier, at: [s, t, z_offset] } = stand;
        let number = self.rows.signals.len() as u32;
        self.owners.add(signal.span, AnnotationOwner::Signal, number);
        let [_, name, r#type, subtype, country, _, _, unit] = signal.texts;
        let code = SignalCode { country, r#type, subtype, name, value: signal.value, unit };
        let stated = signal.semantics.map(meant).unwrap_or_default();
        let (meaning, is_unreadable) = self.meaning(&code, signal.unit, &stated);
        let mut own =
            ElementContext { span: signal.span, path: part.path, findings: part.findings };
        if is_unreadable {
            speeds::unknown(speeds::NO_UNIT, &mut own);
        }
        speeds::sign(&meaning, &mut own);
        // Of a value that is written, a rule says that its unit is missing.
        let is_written = signal.value.is_some_and(|value| value > 0.0);
        if let Some(unit) = meaning.assumed_unit.filter(|_| !is_written) {
            assumed_unit(unit, &mut own);
        }
        let [id, name, r#type, subtype, country, country_revision, text, unit] =
            signal.texts.map(|text| self.strings.add(text));
        let [width, height, length] = signal.size.map(|size| size.unwrap_or(-1.0));
        let [h_offset, pitch, roll] = signal.angles.map(|angle| angle.unwrap_or(0.0));
        let light = meaning.light.unwrap_or_default();
        let bit = |there: bool, bit| if there { bit } else { 0 };
        let mut row: SignalRow = bytemuck::Zeroable::zeroed();
        (row.s, row.t, row.z_offset, row.h_offset) = (s, t, z_offset, h_offset);
        (row.pitch, row.roll) = (pitch, roll);
        (row.width, row.height, row.length) = (width, height, length);
        (row.written_value, row.value) =
            (signal.value.unwrap_or(0.0), meaning.value.unwrap_or(0.0));
        (row.id, row.name, row.r#type, row.subtype) = (id, name, r#type, subtype);
        (row.country, row.country_revision, row.text, row.unit) =
            (country, country_revision, text, unit);
        (row.road, row.carrier) = (road, carrier);
        // What a board of signs depends on and refers to is its carrier's.
        let boards = signal.static_board.iter();
        let dependencies = boards.clone().flat_map(|board| &board.dependency);
        row.dependencies = self.dependencies(signal.dependency.iter().chain(dependencies));
        let links = boards.flat_map(|board| &board.reference);
        row.links = self.links_of(signal.reference.iter().chain(links), number);
        row.semantics = self.semantics(&stated);
        row.class = meaning.class.code();
        row.orientation = orientation(signal.orientation).code();
        row.dynamic = u8::from(signal.dynamic);
        (row.bulbs, row.phases, row.arrows) = (light.bulbs, light.phases, light.arrows);
        row.has_value = bit(signal.value.is_some(), signal_values::WRITTEN)
            | bit(meaning.value.is_some(), signal_values::MEANT)
            | bit(meaning.assumed_unit.is_some(), signal_values::UNIT_ASSUMED)
            | bit(is_unreadable, signal_values::UNREADABLE);
        row.flags = signal.flags;
        let position = position(signal, &mut |id| self.strings.add(id));
        if let Position::Inertial(place) = &position {
            let far = part.too_far([place[0], place[1]]);
            part.findings.extend(far);
        }
        row.position = match position {
            Position::Track => 0,
            Position::Road(..) => 1,
            Position::Inertial(_) => 2,
        };
        if let Some(standing) = signal.on_road.map(|p| (p.pitch.value(), p.roll.value())) {
            (row.pitch, row.roll) = (standing.0.unwrap_or(0.0), standing.1.unwrap_or(0.0));
        }
        if let Some(standing) = signal.inertial.map(|p| (p.pitch.value(), p.roll.value())) {
            (row.pitch, row.roll) = (standing.0.unwrap_or(0.0), standing.1.unwrap_or(0.0));
        }
        self.rows.signals.push(row);
        let (validity, on_carrier) = (lanes(signal.validity).into(), on_carrier.map(Box::new));
        self.signals.signals.push(WrittenSignal {
            span: signal.span,
            validity,
            position,
            on_carrier,
        });
        number
    }

    /// What a signal means, and whether it is about a speed that it states in what is no unit of speed.
    fn meaning(
        &mut self,
        code: &SignalCode<'_>,
        unit: Option<xodr::Unit>,
        stated: &[SemanticsEntry],
    ) -> (Meaning, bool) {
        let mut meaning = self.meaning_of(code, stated);
        if meaning.class.group() != ClassGroup::Speed {
            return (meaning, false);
        }
        let mut is_unreadable =
            meaning.value.is_none() && stated.iter().any(|one| one.is_unreadable);
        if !is_of_speed(unit.map(xodr::Unit::name)) {
            meaning = self.meaning_of(&SignalCode { unit: "", ..*code }, stated);
            // A number that is no code, beside a unit that cannot be its own.
            if meaning.assumed_unit.is_some() {
                meaning = Meaning { value: None, assumed_unit: None, ..meaning };
                is_unreadable = true;
            }
        }
        (meaning, is_unreadable)
    }

    /// What a signal means: by its own words first, then by its code.
    fn meaning_of(&mut self, code: &SignalCode<'_>, stated: &[SemanticsEntry]) -> Meaning {
        let by_code = self.signals.meaning(code);
        let own = stated.iter().map(|one| one.meaning(&self.signals.ontology));
        match own.into_iter().find(|meaning| meaning.class != Class::Unknown) {
            // A light's lamps follow from its code, where that is known.
            Some(own) if own.class != by_code.class => own,
            Some(own) if own.value.is_some() => {
                Meaning { value: own.value, assumed_unit: own.assumed_unit, ..by_code }
            }
            Some(_) => by_code,
            None => by_code,
        }
    }

    /// Appends the signs and boards that a signal carries.
    fn boards(
        &mut self,
        signal: &Common<'_>,
        stand: Stand,
        deep: usize,
        part: &mut ElementContext<'_>,
    ) {
        let before = self.rows.signal_boards.len();
        for board in signal.vms_board {
            self.vms_board(board, stand.carrier);
        }
        let range = between(before, self.rows.signal_boards.len());
        if let Some(row) = self.rows.signals.get_mut(stand.carrier as usize) {
            row.boards = range;
        }
        let Some(deeper) = deep.checked_sub(1) else { return };
        for (board, sign) in
            signal.static_board.iter().flat_map(|b| b.sign.iter().map(move |s| (b, s)))
        {
            let sign: &BoardSign = sign;
            let shift = (sign.v.value().unwrap_or(0.0), sign.z.value().unwrap_or(0.0));
            let row = self.signal(&common!(sign), stand, Some(shift), part);
            // A sign is for the lanes that its board is for, unless it says otherwise.
            if let Some(written) = self.signals.signals.last_mut()
                && written.validity.is_empty()
            {
                written.validity = lanes(&board.validity).into();
            }
            self.boards(&common!(sign), Stand { carrier: row, ..stand }, deeper, part);
        }
    }

    /// Appends a variable message board with its display areas.
    fn vms_board(&mut self, board: &xodr::VmsBoard, carrier: u32) {
        let number = self.rows.signal_boards.len() as u32;
        let display = board.display_type.value().map_or("", xodr::DisplayType::name);
        let display = self.strings.add(display);
        let before = self.rows.display_areas.len();
        self.rows.display_areas.extend(board.display_area.iter().map(|area| DisplayAreaRow {
            width: size(area.width.text()),
            height: size(area.height.text()),
            v: area.v.value().unwrap_or(0.0),
            z: area.z.value().unwrap_or(0.0),
            board: number,
            index: area.index.value().unwrap_or(-1),
        }));
        let areas = between(before, self.rows.display_areas.len());
        let before = self.rows.lane_ranges.len();
        let ranges = lanes(&board.validity).into_iter();
        self.rows.lane_ranges.extend(ranges.map(|(from, to)| LaneRangeRow { from, to }));
        let validities = between(before, self.rows.lane_ranges.len());
        let dependencies = self.dependencies(board.dependency.iter());
        let links = self.links_of(board.reference.iter(), carrier);
        self.rows.signal_boards.push(SignalBoardRow {
            width: board.display_width.value().unwrap_or(-1.0),
            height: board.display_height.value().unwrap_or(-1.0),
            v: board.v.value().unwrap_or(0.0),
            z: board.z.value().unwrap_or(0.0),
            signal: carrier,
            display,
            areas,
            validities,
            dependencies,
            links,
        });
    }

    fn dependencies<'a>(
        &mut self,
        written: impl Iterator<Item = &'a xodr::SignalDependency>,
    ) -> mapd_archive::Range {
        let before = self.rows.signal_dependencies.len();
        for dependency in written {
            let id = self.strings.add(dependency.id.text());
            let r#type = self.strings.add(dependency.r#type.text());
            self.rows.signal_dependencies.push(SignalDependencyRow { signal: NONE, id, r#type });
        }
        between(before, self.rows.signal_dependencies.len())
    }

    fn links_of<'a>(
        &mut self,
        written: impl Iterator<Item = &'a xodr::SignalLink>,
        owner: u32,
    ) -> mapd_archive::Range {
        let before = self.rows.signal_links.len();
        for link in written {
            let signal = xodr::ReferenceElementType::Signal;
            let row = SignalLinkRow {
                signal: NONE,
                object: NONE,
                owner,
                id: self.strings.add(link.element_id.text()),
                r#type: self.strings.add(link.r#type.text()),
                kind: u8::from(link.element_type.value() == Some(signal)),
                reserved: [0; 3],
            };
            self.rows.signal_links.push(row);
        }
        between(before, self.rows.signal_links.len())
    }

    fn semantics(&mut self, stated: &[SemanticsEntry]) -> mapd_archive::Range {
        let before = self.rows.signal_semantics.len();
        for one in stated {
            let row = SignalSemanticsRow {
                written_value: one.value.unwrap_or(0.0),
                element: self.strings.add(one.element),
                kind: self.strings.add(one.kind),
                unit: self.strings.add(one.unit),
                class: one.meaning(&self.signals.ontology).class.code(),
                reserved: [0; 2],
            };
            self.rows.signal_semantics.push(row);
        }
        between(before, self.rows.signal_semantics.len())
    }

    /// Appends a controller. Its signals are resolved later.
    pub(crate) fn controller(&mut self, controller: &Controller) {
        let id = self.strings.add(controller.id.text());
        let row = ControllerRow {
            id,
            name: self.strings.add(controller.name.text()),
            sequence: rank(controller.sequence.value()),
            controls: mapd_archive::Range::default(),
            line: 0,
            column: 0,
        };
        let controls = controller.control.iter().map(|control| ControlRow {
            signal: NONE,
            id: self.strings.add(control.signal_id.text()),
            r#type: self.strings.add(control.r#type.text()),
        });
        let controls = controls.collect();
        self.signals.controllers.push((row, controls, controller.span));
    }

    /// Appends a group of boards.
    pub(crate) fn board_group(&mut self, group: &VmsGroup) {
        let name = self.strings.add(group.id.text());
        for board in &group.vms_board_reference {
            let row = BoardGroupRow {
                group: name,
                signal: NONE,
                id: self.strings.add(board.signal_id.text()),
                board: board.vms_index.value().unwrap_or(-1),
                rank: board.group_index.value().unwrap_or(-1),
            };
            self.signals.board_groups.push(row);
        }
    }
}

fn position(signal: &Common<'_>, add: &mut dyn FnMut(&str) -> u32) -> Position {
    if let Some(p) = signal.inertial
        && let (Some(x), Some(y), Some(z)) = (p.x.value(), p.y.value(), p.z.value())
    {
        return Position::Inertial(Box::new([x, y, z, p.hdg.value().unwrap_or(0.0)]));
    }
    if let Some(p) = signal.on_road
        && let (Some(s), Some(t)) = (p.s.value(), p.t.value())
    {
        let (z, h) = (p.z_offset.value().unwrap_or(0.0), p.h_offset.value().unwrap_or(0.0));
        return Position::Road(Box::new((add(p.road_id.text()), [s, t, z, h])));
    }
    Position::Track
}

/// A size `[m]` that the schema has as text; −1 where it is no number.
fn size(text: &str) -> f64 {
    text.trim().parse().ok().filter(|size: &f64| size.is_finite() && *size >= 0.0).unwrap_or(-1.0)
}

fn rank(sequence: Option<u32>) -> i32 {
    sequence.and_then(|rank| i32::try_from(rank).ok()).unwrap_or(-1)
}
