//! Crossings.

use super::kind;
use crate::example::Example::Junction as In;
use crate::place::{number, text};
use crate::rule::Check::Junction;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{self as xodr, JunctionType as Kind};
use std::collections::BTreeSet;

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.crossing.only_one_high_prio",
        "One road of a crossing has priority.",
        Junction(one_high),
        [
            In(r#"<junction id="9" name="" type="crossing"><roadSection id="0" roadId="1" sStart="1" sEnd="2"/><roadSection id="1" roadId="3" sStart="1" sEnd="2"/><priority high="1" low="3"/></junction>"#),
            In(r#"<junction id="9" name="" type="crossing"><roadSection id="0" roadId="1" sStart="1" sEnd="2"/><roadSection id="1" roadId="3" sStart="1" sEnd="2"/><priority high="1" low="3"/><priority high="3" low="2"/></junction>"#),
        ],
    )
    .since(8),
    Rule::warning(
        "mapd:xodr:1.5.0:junction.stretches",
        "A range of a road that belongs to a junction ends after its start.",
        Junction(stretches),
        [
            In(r#"<junction id="9" name="" type="crossing"><roadSection id="0" roadId="1" sStart="1" sEnd="2"/><roadSection id="1" roadId="3" sStart="1" sEnd="2"/></junction>"#),
            In(r#"<junction id="9" name="" type="crossing"><roadSection id="0" roadId="1" sStart="2" sEnd="1"/><roadSection id="1" roadId="3" sStart="1" sEnd="2"/></junction>"#),
        ],
    ),
];

fn one_high(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) != Kind::Crossing {
        return;
    }
    let mut high = BTreeSet::new();
    for priority in &junction.priority {
        high.insert(text(&priority.high));
        if high.len() > 1 {
            sink.add_within(
                "priority",
                priority.span,
                "one road with priority",
                text(&priority.high),
            );
            return;
        }
    }
}

fn stretches(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    let own = (kind(junction) == Kind::Virtual).then_some((
        &junction.s_start,
        &junction.s_end,
        junction.span,
    ));
    let sections = junction.road_section.iter().map(|s| (&s.s_start, &s.s_end, s.span));
    for (start, end, span) in sections.chain(own) {
        let (start, end) = (number(start), number(end));
        if end < start {
            sink.add(span, format_args!("an end behind {start}"), end);
        }
    }
}
