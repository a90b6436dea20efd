//! Roads that lie over one another at one height.

use crate::example::Example::Document;
use crate::network::{CLEARANCE, Network, Overlap, RoadFacts, TOUCH};
use crate::rule::Check::Overlaps as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::{PartOf, Sink};

/// Overlaps up to this depth are touches.
const DEPTH: Tolerance = Tolerance { name: "depth of an overlap", value: TOUCH, unit: "m" };
/// Roads that are farther apart in height pass over one another.
const HEIGHT: Tolerance = Tolerance { name: "difference of heights", value: CLEARANCE, unit: "m" };

/// Two roads that cross, with the junctions that they belong to and the height of the second.
macro_rules! cross {
    ($first:literal, $second:literal, $z:literal) => {
        Document(concat!(
            r#"<road id="1" length="100" junction=""#, $first, r#""><planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="100" junction=""#, $second, r#""><planView><geometry s="0" x="50" y="-50" hdg="1.5707963267948966" length="100"><line/></geometry></planView><elevationProfile><elevation s="0" a=""#, $z, r#"" b="0" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road><junction id="8" name=""/><junction id="9" name=""/>"#
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.4.0:road.no_overlap_outside_junction",
        "Roads outside junctions do not overlap at the same height.",
        All(outside),
        [cross!("-1", "-1", "6"), cross!("-1", "-1", "0")],
    )
    .also(&["mapd:xodr:1.4.0:geometry.overlap"])
    .within(&[DEPTH, HEIGHT]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.overlap_inside_junction",
        "A road within a junction overlaps only roads of that junction.",
        All(inside),
        [cross!("9", "9", "0"), cross!("9", "-1", "0")],
    )
    .within(&[DEPTH, HEIGHT]),
    Rule::warning(
        "asam.net:xodr:1.4.0:junctions.no_overlap",
        "The roads of two junctions do not overlap at the same height.",
        All(junctions),
        [cross!("9", "9", "0"), cross!("8", "9", "0")],
    )
    .within(&[DEPTH, HEIGHT]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.no_overlap_self",
        "A road does not overlap itself at the same height.",
        All(itself),
        [
            Document(r#"<road id="1" length="200" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="200"><arc curvature="0.01"/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#),
            Document(r#"<road id="1" length="400" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="400"><arc curvature="0.03"/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#),
        ],
    )
    .within(&[DEPTH, HEIGHT]),
];

/// Adds a finding for each pair of roads that overlap and are of a kind, at the later of the two.
fn tell(
    network: &Network,
    sink: &mut Sink<'_>,
    is_of_kind: impl Fn(&Overlap, &RoadFacts, &RoadFacts) -> bool,
) {
    for overlap in network.overlaps() {
        let (Some(a), Some(b)) = (network.roads.get(overlap.a), network.roads.get(overlap.b))
        else {
            continue;
        };
        if is_of_kind(overlap, a, b) {
            let found = format_args!(
                "s = {:.1} of this road {:.2} m deep in s = {:.1} of road {}",
                overlap.s_b,
                overlap.depth,
                overlap.s_a,
                network.name(a.id)
            );
            sink.add_in(
                PartOf::road(network.name(b.id), ""),
                b.span,
                "roads apart from one another",
                found,
            );
        }
    }
}

fn outside(network: &Network, sink: &mut Sink<'_>) {
    tell(network, sink, |o, a, b| o.a != o.b && a.junction.is_none() && b.junction.is_none());
}

fn inside(network: &Network, sink: &mut Sink<'_>) {
    tell(network, sink, |_, a, b| a.junction.is_some() != b.junction.is_some());
}

fn junctions(network: &Network, sink: &mut Sink<'_>) {
    tell(network, sink, |o, a, b| o.a != o.b && a.junction.is_some() && b.junction.is_some());
}

fn itself(network: &Network, sink: &mut Sink<'_>) {
    tell(network, sink, |overlap, _, _| overlap.a == overlap.b);
}
