//! Access restrictions.

use crate::example::Example::Lane as OfLane;
use crate::place::{LaneIn, number, value};
use crate::rule::Check::Lane;
use crate::rule::Rule;
use crate::sink::Sink;

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
)];

fn no_mix(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    for pair in of.lane.access.windows(2) {
        let (a, b) = (value(&pair[0].rule), value(&pair[1].rule));
        if number(&pair[0].s_offset) == number(&pair[1].s_offset)
            && a.is_some()
            && b.is_some()
            && a != b
        {
            sink.add_within("access", pair[1].span, "either allow or deny at one place", "both");
        }
    }
}
