//! Signals: meanings, places, lanes, movements, boards, controllers.

use super::line::{Fine, Lines};
use super::{at, keys, road_id};
use mapd_client::Map;
use mapd_query::signals::{LaneSignal, Signal, SignalBoard, SignalLink};

pub(super) fn facts(map: Map<'_>, lines: &mut Lines) {
    for signal in map.signals() {
        of_signal(map, signal, lines);
        meaning(signal, lines);
        signal.dependencies().for_each(|link| of_link("depends on", &link, lines));
        signal.links().for_each(|link| of_link("belongs to", &link, lines));
        signal.boards().for_each(|board| of_board(board, lines));
    }
    for place in map.signal_places() {
        lines
            .about(format_args!("signal place {:?}", place.signal().map(|signal| signal.id())))
            .with("road", road_id(place.road()))
            .with("s", place.s())
            .with("t", place.t())
            .word("orientation", place.orientation().name())
            .with("reference", place.is_reference());
        place.lanes().for_each(|one| of_lane_signal("signal for", one, lines));
    }
    for lane in map.lanes() {
        lane.signals().for_each(|one| of_lane_signal("signal of lane", one, lines));
        lane.movement_lights().for_each(|one| of_lane_signal("light of movement", one, lines));
        for entry in lane.entry_signals() {
            lines
                .about(format_args!("signal at entry of {}", lane.key()))
                .with("signal", entry.signal.signal().id())
                .with("distance", entry.distance);
        }
    }
    for member in map.board_groups() {
        let board = member.board().and_then(|board| board.carrier()).map(|signal| signal.id());
        lines
            .about(format_args!("board of group {:?}", member.group()))
            .with("id", member.id())
            .with("board", board)
            .with("rank", member.rank())
            .with("signal", member.signal().map(|signal| signal.id()));
    }
    for controller in map.controllers() {
        let junctions: Vec<_> = controller.junctions().map(|junction| junction.id()).collect();
        lines
            .about(format_args!("controller {:?}", controller.id()))
            .with("name", controller.name())
            .with("sequence", controller.sequence())
            .with("signals", controller.signals().map(|signal| signal.id()).collect::<Vec<_>>())
            .with("junctions", junctions);
    }
}

fn of_signal(map: Map<'_>, signal: Signal<'_>, lines: &mut Lines) {
    lines
        .about(format_args!("signal {:?}", signal.id()))
        .with("name", signal.name())
        .with("by_id", map.signal_by_id(signal.id()).map(|signal| signal.id()))
        .with("code", signal.code())
        .with("text", signal.shown_text())
        .with("road", road_id(signal.road()))
        .with("track", signal.track())
        .with("place", signal.position())
        .word("placed_by", signal.position_source().name())
        .with("angles", [signal.facing(), signal.pitch(), signal.roll()].map(Fine))
        .with("size", signal.size())
        .word("orientation", signal.orientation().name())
        .with("carrier", signal.carrier().map(|carrier| carrier.id()))
        .with("flags", [signal.is_dynamic(), signal.is_temporary(), signal.is_invalidated()])
        .with("controllers", signal.controllers().map(|one| one.id()).collect::<Vec<_>>())
        .with("movements", keys(signal.movements()))
        .word("at", at(signal.source_position()));
}

fn meaning(signal: Signal<'_>, lines: &mut Lines) {
    let written = signal.written_value();
    lines
        .about(format_args!("means {}", signal.class().name()))
        .with("value", signal.value())
        .with("unit_assumed", signal.is_unit_assumed())
        .with("written", written.map(|written| written.value))
        .with("unit", written.map(|written| written.unit))
        .with("light", signal.light().map(|light| [light.bulbs, light.phases, light.arrows]));
    for one in signal.semantics() {
        lines
            .about(format_args!("semantics {}", one.class.name()))
            .with("element", one.element)
            .with("kind", one.kind)
            .with("value", one.value)
            .with("unit", one.unit);
    }
}

fn of_link(what: &str, link: &SignalLink<'_>, lines: &mut Lines) {
    lines
        .about(format_args!("{what} {:?}", link.id))
        .with("kind", link.kind)
        .with("object", link.is_object)
        .with("signal", link.signal.map(|signal| signal.id()))
        .with("found", link.object.map(|object| object.id()));
}

fn of_board(board: SignalBoard<'_>, lines: &mut Lines) {
    lines
        .about(format_args!("board {:?}", board.display_type()))
        .with("carrier", board.carrier().map(|signal| signal.id()))
        .with("offset", board.offset())
        .with("place", board.position())
        .with("size", board.size())
        .with("lanes", board.validities().collect::<Vec<_>>());
    board.dependencies().for_each(|link| of_link("board depends on", &link, lines));
    board.links().for_each(|link| of_link("board belongs to", &link, lines));
    for area in board.areas() {
        lines
            .about("display area")
            .with("index", area.index())
            .with("board", area.board().map(|board| board.display_type()))
            .with("offset", area.offset())
            .with("place", area.position())
            .with("size", area.size());
    }
}

fn of_lane_signal(what: &str, one: LaneSignal<'_>, lines: &mut Lines) {
    let lane = one.lane();
    lines
        .about(format_args!("{what} {:?}", lane.map(|lane| lane.key().to_string())))
        .with("signal", one.signal().id())
        .with("s", lane.map(|lane| one.s_on(&lane)))
        .word("method", one.method().name())
        .with("distance", one.distance())
        .with("for", [one.is_for(true), one.is_for(false)])
        .with("light", one.is_vehicle_light());
}
