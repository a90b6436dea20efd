//! The surface of a junction.

use crate::example::Example::Junction as In;
use crate::place::text;
use crate::rule::Check::Junction;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr as xodr;

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.geometry.only_one_line_element",
        "The reference line of a junction is one straight line.",
        Junction(one_line),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><planView><geometry s="0" x="45" y="0" hdg="0" length="30"><line/></geometry></planView></junction>"#),
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><planView><geometry s="0" x="45" y="0" hdg="0" length="30"><arc curvature="0.01"/></geometry></planView></junction>"#),
        ],
    )
    .since(8),
    Rule::warning(
        "mapd:xodr:1.8.0:junction.grid_values",
        "The heights of an elevation grid are numbers.",
        Junction(grid_values),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><planView><geometry s="0" x="45" y="0" hdg="0" length="30"><line/></geometry></planView><elevationGrid sStart="0" gridSpacing="30"><elevation left="0 1" center="0" right="0 1"/><elevation left="0 1" center="0" right="0 1"/></elevationGrid></junction>"#),
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><planView><geometry s="0" x="45" y="0" hdg="0" length="30"><line/></geometry></planView><elevationGrid sStart="0" gridSpacing="30"><elevation left="0 one" center="0" right="0 1"/><elevation left="0 1" center="0" right="0 1"/></elevationGrid></junction>"#),
        ],
    )
    .since(8),
];

fn one_line(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    let Some(plan_view) = &junction.plan_view else { return };
    let is_line = matches!(&plan_view.geometry[..], [geometry] if geometry.line.is_some());
    if !is_line {
        let count = plan_view.geometry.len();
        let found = format_args!("{count} geometries, or a curve");
        sink.add_within("planView", plan_view.span, "one line", found);
    }
}

fn grid_values(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    for row in junction.elevation_grid.iter().flat_map(|grid| &grid.elevation) {
        for (name, list) in [("left", &row.left), ("center", &row.center), ("right", &row.right)] {
            for word in text(list).split_ascii_whitespace() {
                if !word.parse::<f64>().is_ok_and(f64::is_finite) {
                    let expected = format_args!("numbers in @{name}");
                    sink.add_within("elevationGrid/elevation", row.span, expected, word);
                }
            }
        }
    }
}
