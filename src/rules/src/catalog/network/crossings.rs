//! Crossings, seen with the roads that cross.

use crate::catalog::junctions::kind;
use crate::example::Example::Document;
use crate::network::Network;
use crate::place::text;
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::{PartOf, Sink};
use mapd_xodr::JunctionType as Kind;
use std::ops::Range;

/// How far roads may overlap beyond the stretches.
const BEYOND: Tolerance = Tolerance { name: "overlap beyond the stretch", value: 0.5, unit: "m" };

/// Two roads that cross at a right angle, and the stretch of the first.
macro_rules! cross {
    ($start:literal, $end:literal) => {
        Document(concat!(
            r#"<road id="1" length="100" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="100" junction="-1"><planView><geometry s="0" x="50" y="-50" hdg="1.5707963267948966" length="100"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="rail"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9" name="" type="crossing"><roadSection id="0" roadId="1" sStart=""#, $start, r#"" sEnd=""#, $end, r#""/><roadSection id="1" roadId="2" sStart="46" sEnd="51"/></junction>"#
        ))
    };
}

pub(super) static RULES: &[Rule] = &[Rule::warning(
    "asam.net:xodr:1.8.0:junctions.crossing.s_start_end_coverage",
    "The road sections of a crossing cover the overlap of its roads.",
    All(cover),
    [cross!("49", "54"), cross!("49", "51")],
)
.within(&[BEYOND])];

/// Road sections of one junction that are compared with each other; two roads cross in a crossing, seldom more.
const SECTIONS: usize = 16;

fn cover(network: &Network, sink: &mut Sink<'_>) {
    for junction in
        network.junctions_as_written().filter(|junction| kind(junction) == Kind::Crossing)
    {
        let sections = &junction.road_section;
        if sections.len() > SECTIONS {
            let part = PartOf::junction(text(&junction.id), "roadSection");
            let expected = format_args!("at most {SECTIONS} road sections that are compared");
            sink.add_in(part, junction.span, expected, sections.len());
        }
        let sections = sections.get(..SECTIONS.min(sections.len())).unwrap_or_default();
        for section in sections {
            let Some(road) = network.road(text(&section.road_id)) else { continue };
            // What is missing is told of as such.
            let (Some(from), Some(to)) = (section.s_start, section.s_end) else { continue };
            let (from, to) = (from.value, to.value);
            let others = sections.iter().filter(|other| other.road_id != section.road_id);
            for other in others {
                let Some(other) = network.road(text(&other.road_id)) else { continue };
                let Some(Range { start, end }) = network.overlap_along(road, other) else {
                    continue;
                };
                if start < from - BEYOND.value || end > to + BEYOND.value {
                    let part = PartOf::junction(text(&junction.id), "roadSection");
                    let road = network.name(road.id);
                    let expected =
                        format_args!("a stretch of road {road} from {start:.2} to {end:.2}");
                    sink.add_in(part, section.span, expected, format_args!("{from} to {to}"));
                }
            }
        }
    }
}
