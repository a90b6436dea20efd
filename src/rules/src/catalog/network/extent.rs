//! Where the map lies.

use crate::example::Example::PlanView;
use crate::network::Network;
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;

/// Beyond this, a 32-bit number has no millimetres: its 24 bits reach from 65,536 m to 1/256 m.
const FAR: Tolerance = Tolerance { name: "coordinate", value: 65_536.0, unit: "m" };

/// Coordinates that no place on Earth has in metres are told by their order of magnitude `[m]`.
const BEYOND: f64 = 1e9;

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
    // Of each axis the end that is farther out.
    let farther = |[low, high]: [f64; 2]| if low.abs() > high.abs() { low } else { high };
    let far = |road: &crate::network::RoadFacts| {
        let [low_x, low_y, high_x, high_y] = road.bounds;
        let at = [farther([low_x, high_x]), farther([low_y, high_y])];
        let is_far = at.iter().any(|value| value.is_finite() && value.abs() > FAR.value);
        is_far.then(|| (road.id, at.map(rounded)))
    };
    if let Some((id, [x, y])) = network.roads.iter().find_map(far) {
        let (span, id) = (network.header.unwrap_or_default(), network.name(id));
        let found = format_args!("road {id} that reaches ({x}, {y})");
        let expected = format_args!("coordinates below {} m and an offset", FAR.value);
        sink.add_at(|| "OpenDRIVE/header".to_owned(), sink.severity, span, expected, found);
    }
}

/// Whole metres; of what is far beyond the Earth, the order of magnitude.
fn rounded(value: f64) -> String {
    if value.abs() < BEYOND { format!("{value:.0}") } else { format!("{value:.0e}") }
}
