//! Access restrictions.

use crate::example::Example::Lane as OfLane;
use crate::place::{LaneIn, number, value};
use crate::rule::Check::Lane;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;

/// Records so near to one another are of one place, as in ASAM's checker.
const SAME_PLACE: Tolerance =
    Tolerance { name: "difference of sOffset of one place", value: 1e-6, unit: "m" };

pub(super) static RULES: &[Rule] = &[Rule::warning(
    "asam.net:xodr:1.7.0:road.lane.access.no_mix_of_deny_or_allow",
    "Access restrictions of one place either all allow or all deny.",
    Lane(no_mix),
    [
        OfLane(
            r#"<access sOffset="0" rule="deny"><restriction type="bus"/></access><access sOffset="0" rule="deny"><restriction type="taxi"/></access>"#,
        ),
        OfLane(
            r#"<access sOffset="0" rule="deny"><restriction type="bus"/></access><access sOffset="0" rule="allow"><restriction type="taxi"/></access>"#,
        ),
    ],
)
.within(&[SAME_PLACE])];

fn no_mix(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    if of.lane.access.len() < 2 {
        return;
    }
    // Those of one place stand beside one another, whatever their order in the file.
    let records = of.lane.access.iter().enumerate();
    let rules = records.filter_map(|(at, access)| {
        Some((number(&access.s_offset), at, value(&access.rule)?, access.span))
    });
    let mut rules: Vec<_> = rules.collect();
    rules.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    for pair in rules.windows(2) {
        let [a, b] = pair else { continue };
        if b.0 - a.0 <= SAME_PLACE.value && a.2 != b.2 {
            let (_, _, _, span) = if a.1 > b.1 { a } else { b };
            sink.add_within("access", *span, "either allow or deny at one place", "both");
        }
    }
}
