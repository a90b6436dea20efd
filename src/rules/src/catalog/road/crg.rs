//! Surface data in OpenCRG files.

use crate::example::Example::Road as In;
use crate::place::{RoadIn, number, value};
use crate::rule::Check::Road;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{CrgMode, CrgPurpose, Direction, RoadCrg};

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.crg.attach_vs_friction",
        "Friction is not used with the mode attached.",
        Road(attached_friction),
        [
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="genuine" purpose="friction"/></surface>"#),
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="attached" purpose="friction"/></surface>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.crg.friction_no_z_offset_scale",
        "Friction has neither zOffset nor zScale.",
        Road(friction_z),
        [
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="genuine" purpose="friction"/></surface>"#),
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="genuine" purpose="friction" zOffset="0.1"/></surface>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.crg.h_offset_only_genuine_global",
        "hOffset is only for the modes genuine and global.",
        Road(h_offset),
        [
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="genuine" purpose="elevation" hOffset="0.1"/></surface>"#),
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="attached" purpose="elevation" hOffset="0.1"/></surface>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.crg.no_opposite",
        "The orientation opposite is only for the modes attached and attached0.",
        Road(opposite),
        [
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="opposite" mode="attached" purpose="elevation"/></surface>"#),
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="opposite" mode="genuine" purpose="elevation"/></surface>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.crg.only_on_per_s",
        "Each place has at most one file for each purpose.",
        Road(one_per_place),
        [
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="50" orientation="same" mode="genuine" purpose="elevation"/><CRG file="b.crg" sStart="50" sEnd="100" orientation="same" mode="genuine" purpose="elevation"/></surface>"#),
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="60" orientation="same" mode="genuine" purpose="elevation"/><CRG file="b.crg" sStart="50" sEnd="100" orientation="same" mode="genuine" purpose="elevation"/></surface>"#),
        ],
    )
    .advisory(),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.crg.s_t_offset_no_global",
        "sOffset and tOffset are not for the mode global.",
        Road(offsets),
        [
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="genuine" purpose="elevation" sOffset="1" tOffset="1"/></surface>"#),
            In(r#"<surface><CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="global" purpose="elevation" sOffset="1" tOffset="1"/></surface>"#),
        ],
    ),
];

const PART: &str = "surface/CRG";

fn all<'a>(of: &RoadIn<'a>) -> impl Iterator<Item = &'a RoadCrg> + use<'a> {
    of.road.surface.iter().flat_map(|surface| &surface.crg)
}

fn attached_friction(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for crg in all(of) {
        if value(&crg.mode) == Some(CrgMode::Attached)
            && value(&crg.purpose) == Some(CrgPurpose::Friction)
        {
            sink.add_within(PART, crg.span, "another mode than attached for friction", "attached");
        }
    }
}

fn friction_z(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for crg in all(of).filter(|crg| value(&crg.purpose) == Some(CrgPurpose::Friction)) {
        for (name, given) in [("zOffset", &crg.z_offset), ("zScale", &crg.z_scale)] {
            if given.is_some() {
                sink.add_within(PART, crg.span, format_args!("no {name} for friction"), "one");
            }
        }
    }
}

fn h_offset(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for crg in all(of).filter(|crg| crg.h_offset.is_some()) {
        if let Some(mode) =
            value(&crg.mode).filter(|m| !matches!(m, CrgMode::Genuine | CrgMode::Global))
        {
            sink.add_within(
                PART,
                crg.span,
                "no hOffset",
                format_args!("one in the mode {}", mode.name()),
            );
        }
    }
}

fn opposite(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for crg in all(of).filter(|crg| value(&crg.orientation) == Some(Direction::Opposite)) {
        if let Some(mode) =
            value(&crg.mode).filter(|m| !matches!(m, CrgMode::Attached | CrgMode::Attached0))
        {
            let mode = mode.name();
            let found = format_args!("opposite in the mode {mode}");
            sink.add_within(PART, crg.span, "the orientation same", found);
        }
    }
}

fn one_per_place(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let all: Vec<&RoadCrg> = all(of).collect();
    for (rank, crg) in all.iter().enumerate() {
        let overlaps = |other: &&&RoadCrg| {
            value(&other.purpose) == value(&crg.purpose)
                && number(&other.s_start) < number(&crg.s_end)
                && number(&crg.s_start) < number(&other.s_end)
        };
        if all[..rank].iter().any(|other| overlaps(&other)) {
            sink.add_within(
                PART,
                crg.span,
                "one file for a place and purpose",
                "another; the last is used",
            );
        }
    }
}

fn offsets(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for crg in all(of).filter(|crg| value(&crg.mode) == Some(CrgMode::Global)) {
        for (name, given) in [("sOffset", &crg.s_offset), ("tOffset", &crg.t_offset)] {
            if given.is_some() {
                sink.add_within(
                    PART,
                    crg.span,
                    format_args!("no {name} in the mode global"),
                    "one",
                );
            }
        }
    }
}
