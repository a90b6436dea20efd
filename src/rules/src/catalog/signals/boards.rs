//! Boards of several signs.

use crate::example::Example::{Document, Signals as In};
use crate::place::{SignalIn, text, value};
use crate::rule::Check::{Signal, VmsGroup};
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr as xodr;

/// A signal with boards.
macro_rules! board {
    ($attributes:literal, $boards:literal) => {
        In(concat!(
            r#"<signal id="1" s="10" t="-4" zOffset="2" orientation="+" country="DE" hOffset="0" pitch="0" roll="0" subtype="-1" "#,
            $attributes, ">", $boards, "</signal>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.8.0:road.signal.boards.multi_board_have_sub_boards",
        "A multi board has a static board and a variable message board.",
        Signal(sub_boards),
        [
            board!(
                r#"type="multiBoard" dynamic="yes""#,
                r#"<staticBoard><sign id="2" dynamic="no" orientation="+" type="274" subtype="50" v="0" z="0"/></staticBoard><vmsBoard displayType="LED" displayWidth="1" displayHeight="1" v="0" z="0"><displayArea index="0" v="0" z="0" width="1" height="1"/></vmsBoard>"#
            ),
            board!(
                r#"type="multiBoard" dynamic="yes""#,
                r#"<staticBoard><sign id="2" dynamic="no" orientation="+" type="274" subtype="50" v="0" z="0"/></staticBoard>"#
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:road.signal.boards.multi_board_use_correct_type",
        "A signal with a static board and a variable message board is of the type multiBoard.",
        Signal(multi_type),
        [
            board!(
                r#"type="multiBoard" dynamic="yes""#,
                r#"<staticBoard><sign id="2" dynamic="no" orientation="+" type="274" subtype="50" v="0" z="0"/></staticBoard><vmsBoard displayType="LED" displayWidth="1" displayHeight="1" v="0" z="0"><displayArea index="0" v="0" z="0" width="1" height="1"/></vmsBoard>"#
            ),
            board!(
                r#"type="staticBoard" dynamic="yes""#,
                r#"<staticBoard><sign id="2" dynamic="no" orientation="+" type="274" subtype="50" v="0" z="0"/></staticBoard><vmsBoard displayType="LED" displayWidth="1" displayHeight="1" v="0" z="0"><displayArea index="0" v="0" z="0" width="1" height="1"/></vmsBoard>"#
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:road.signal.boards.multi_board_use_dynamic_true",
        "A multi board is dynamic.",
        Signal(dynamic),
        [
            board!(
                r#"type="multiBoard" dynamic="yes""#,
                r#"<staticBoard><sign id="2" dynamic="no" orientation="+" type="274" subtype="50" v="0" z="0"/></staticBoard><vmsBoard displayType="LED" displayWidth="1" displayHeight="1" v="0" z="0"><displayArea index="0" v="0" z="0" width="1" height="1"/></vmsBoard>"#
            ),
            board!(
                r#"type="multiBoard" dynamic="no""#,
                r#"<staticBoard><sign id="2" dynamic="no" orientation="+" type="274" subtype="50" v="0" z="0"/></staticBoard><vmsBoard displayType="LED" displayWidth="1" displayHeight="1" v="0" z="0"><displayArea index="0" v="0" z="0" width="1" height="1"/></vmsBoard>"#
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:road.signal.boards.static_board_use_correct_type",
        "A signal with only a static board is of the type staticBoard.",
        Signal(static_type),
        [
            board!(
                r#"type="staticBoard" dynamic="no""#,
                r#"<staticBoard><sign id="2" dynamic="no" orientation="+" type="274" subtype="50" v="0" z="0"/></staticBoard>"#
            ),
            board!(
                r#"type="274" dynamic="no""#,
                r#"<staticBoard><sign id="2" dynamic="no" orientation="+" type="274" subtype="50" v="0" z="0"/></staticBoard>"#
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.signal.gantry.vmsgroup_at_least_one_reference",
        "A group of boards refers to at least one board.",
        VmsGroup(references),
        [
            Document(
                r#"<road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><signals><signal id="1" s="5" t="-4" zOffset="2" dynamic="yes" orientation="+" country="DE" type="vmsBoard" subtype="-1" hOffset="0" pitch="0" roll="0"/></signals></road><vmsGroup id="8"><vmsBoardReference signalId="1" vmsIndex="0" groupIndex="0"/></vmsGroup>"#,
            ),
            Document(
                r#"<road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road><vmsGroup id="8"/>"#,
            ),
        ],
    ),
];

const MULTI: &str = "multiBoard";

fn sub_boards(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    let signal = of.signal;
    if text(&signal.r#type) == MULTI
        && (signal.static_board.is_empty() || signal.vms_board.is_empty())
    {
        sink.add(signal.span, "a static board and one with variable messages", "not both");
    }
}

fn multi_type(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    let signal = of.signal;
    let is_multi = !signal.static_board.is_empty() && !signal.vms_board.is_empty();
    if is_multi && text(&signal.r#type) != MULTI {
        sink.add(signal.span, "the type multiBoard", text(&signal.r#type));
    }
}

fn dynamic(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    if text(&of.signal.r#type) == MULTI && value(&of.signal.dynamic) != Some(true) {
        sink.add(of.signal.span, "dynamic=\"yes\" of a multi board", "another");
    }
}

fn static_type(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    let signal = of.signal;
    let is_static = !signal.static_board.is_empty() && signal.vms_board.is_empty();
    if is_static && !matches!(text(&signal.r#type), "staticBoard" | MULTI) {
        sink.add(signal.span, "the type staticBoard", text(&signal.r#type));
    }
}

fn references(group: &xodr::VmsGroup, sink: &mut Sink<'_>) {
    if group.vms_board_reference.is_empty() {
        sink.add(group.span, "at least one vmsBoardReference", "none");
    }
}
