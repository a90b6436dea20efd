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
    "Access restrictions at one place either all allow or all deny.",
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
    // Those of one place stand beside one another: records are sorted.
    let rules = of.lane.access.iter();
    let rules = rules.filter_map(|a| Some((number(&a.s_offset), value(&a.rule)?, a.span)));
    let rules: Vec<_> = rules.collect();
    for pair in rules.windows(2) {
        let [a, b] = pair else { continue };
        if b.0 - a.0 <= SAME_PLACE.value && a.1 != b.1 {
            // The one that stands behind the other in the file.
            let span = if a.2.start > b.2.start { a.2 } else { b.2 };
            sink.add_within("access", span, "either allow or deny at one place", "both");
        }
    }
}
