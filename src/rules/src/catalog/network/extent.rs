//! Where the map lies.

use crate::example::Example::PlanView;
use crate::network::Network;
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;

/// Beyond this, a 32-bit number has no millimetres: its 24 bits reach from 65,536 m to 1/256 m.
const FAR: Tolerance = Tolerance { name: "coordinate", value: 65_536.0, unit: "m" };

pub(super) static RULES: &[Rule] = &[Rule::info(
    "asam.net:xodr:1.7.0:header.offset.centered_coords",
    "Coordinates are near the origin; the header's offset contains the large part.",
    All(centered),
    [
        PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry>"#),
        PlanView(
            r#"<geometry s="0" x="690000" y="5330000" hdg="0" length="100"><line/></geometry>"#,
        ),
    ],
)
.within(&[FAR])
.advisory()];

fn centered(network: &Network, sink: &mut Sink<'_>) {
    let far = |road: &&crate::network::RoadFacts| {
        road.bounds.iter().any(|value| value.is_finite() && value.abs() > FAR.value)
    };
    if let Some(road) = network.roads.iter().find(far) {
        let (span, id) = (network.header.unwrap_or_default(), network.name(road.id));
        let found = format_args!("road {id} at ({:.0}, {:.0})", road.bounds[0], road.bounds[1]);
        let expected = format_args!("coordinates below {} m and an offset", FAR.value);
        sink.add_at(|| "OpenDRIVE/header".to_owned(), sink.severity, span, expected, found);
    }
}
