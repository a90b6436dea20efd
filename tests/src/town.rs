//! A generated town: a grid of crossroads, streets of two lanes with sidewalks between them.
//!
//! ```text
//!      ┼───┼───┼     each ┼ is a junction: one connecting road for every way from one arm to another
//!      │   │   │     each ─ and │ is a road: sidewalk, lane, lane, sidewalk
//!      ┼───┼───┼
//! ```

use std::fmt::Write;

/// Distance between crossroads `[m]`.
const SPACING: f64 = 100.0;
/// Distance from a crossroads' middle at which streets end `[m]`; also the radius of turns.
const REACH: f64 = 12.0;
/// Width of a driving lane `[m]`.
const LANE: f64 = 3.5;
/// Width of a sidewalk `[m]`.
const SIDEWALK: f64 = 2.0;
/// Connecting roads have ids from this times their junction's: four arms need twelve.
const ROADS_PER_JUNCTION: usize = 100;
/// Ids of junctions start here.
const JUNCTION_IDS: usize = 1000;

/// Direction in quarter turns from east, counter-clockwise.
type Quarter = usize;

/// Unit vector of a direction.
fn unit(quarter: Quarter) -> (f64, f64) {
    [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][quarter % 4]
}

/// A street that meets a crossroads.
#[derive(Clone, Copy)]
struct Arm {
    /// Direction from the crossroads into the street.
    out: Quarter,
    road: usize,
    /// Whether the street begins at this crossroads.
    begins: bool,
}

/// OpenDRIVE text of a town with so many crossroads eastwards and northwards.
pub fn town(columns: usize, rows: usize) -> String {
    let mut out = String::new();
    let mut arms: Vec<Vec<Arm>> = vec![Vec::new(); columns * rows];
    let mut streets = String::new();
    let mut road = 1;
    for row in 0..rows {
        for column in 0..columns {
            let here = row * columns + column;
            for (quarter, present, there) in
                [(0, column + 1 < columns, here + 1), (1, row + 1 < rows, here + columns)]
            {
                if present {
                    street(&mut streets, road, middle(columns, here), quarter, (here, there));
                    arms[here].push(Arm { out: quarter, road, begins: true });
                    arms[there].push(Arm { out: quarter + 2, road, begins: false });
                    road += 1;
                }
            }
        }
    }
    let mut connecting = String::new();
    let mut junctions = String::new();
    for (number, arms) in arms.iter().enumerate() {
        crossroads(&mut connecting, &mut junctions, number, middle(columns, number), arms);
    }
    let (east, north) = ((columns - 1) as f64 * SPACING, (rows - 1) as f64 * SPACING);
    let _ = writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    let _ = writeln!(out, "<!-- Written by the generator in tests/src/town.rs. -->\n<OpenDRIVE>");
    let _ = writeln!(
        out,
        "  <header revMajor=\"1\" revMinor=\"7\" name=\"town\" version=\"1\" date=\"2026-01-01T00:00:00\" north=\"{north}\" south=\"0\" east=\"{east}\" west=\"0\" vendor=\"mapd\"/>"
    );
    out + &streets + &connecting + &junctions + "</OpenDRIVE>\n"
}

fn middle(columns: usize, number: usize) -> (f64, f64) {
    ((number % columns) as f64 * SPACING, (number / columns) as f64 * SPACING)
}

fn heading(quarter: Quarter) -> f64 {
    (quarter % 4) as f64 * std::f64::consts::FRAC_PI_2
}

fn street(
    out: &mut String,
    road: usize,
    (x, y): (f64, f64),
    quarter: Quarter,
    (from, to): (usize, usize),
) {
    let (dx, dy) = unit(quarter);
    let length = SPACING - 2.0 * REACH;
    let (from, to) = (JUNCTION_IDS + from, JUNCTION_IDS + to);
    let _ = writeln!(
        out,
        "  <road name=\"Street {road}\" length=\"{length}\" id=\"{road}\" junction=\"-1\" rule=\"RHT\">"
    );
    let _ = writeln!(
        out,
        "    <link><predecessor elementType=\"junction\" elementId=\"{from}\"/><successor elementType=\"junction\" elementId=\"{to}\"/></link>"
    );
    let _ =
        writeln!(out, "    <type s=\"0\" type=\"town\"><speed max=\"50\" unit=\"km/h\"/></type>");
    geometry(out, (x + dx * REACH, y + dy * REACH), quarter, length, "<line/>");
    let _ = writeln!(out, "    <lanes><laneSection s=\"0\">");
    let _ = writeln!(
        out,
        "      <left>{}{}</left>",
        lane(2, "sidewalk", SIDEWALK, ""),
        lane(1, "driving", LANE, "")
    );
    let _ = writeln!(out, "      <center><lane id=\"0\" type=\"none\" level=\"false\"/></center>");
    let _ = writeln!(
        out,
        "      <right>{}{}</right>",
        lane(-1, "driving", LANE, ""),
        lane(-2, "sidewalk", SIDEWALK, "")
    );
    let _ = writeln!(out, "    </laneSection></lanes>\n  </road>");
}

fn geometry(out: &mut String, (x, y): (f64, f64), quarter: Quarter, length: f64, shape: &str) {
    let hdg = heading(quarter);
    let _ = writeln!(
        out,
        "    <planView><geometry s=\"0\" x=\"{x}\" y=\"{y}\" hdg=\"{hdg}\" length=\"{length}\">{shape}</geometry></planView>"
    );
}

fn lane(id: i32, kind: &str, width: f64, link: &str) -> String {
    format!(
        "<lane id=\"{id}\" type=\"{kind}\" level=\"false\">{link}<width sOffset=\"0\" a=\"{width}\" b=\"0\" c=\"0\" d=\"0\"/></lane>"
    )
}

fn crossroads(
    roads: &mut String,
    junctions: &mut String,
    number: usize,
    (x, y): (f64, f64),
    arms: &[Arm],
) {
    let id = JUNCTION_IDS + number;
    let _ = writeln!(junctions, "  <junction name=\"Crossing {number}\" id=\"{id}\">");
    let mut connection = 0;
    for from in arms {
        for to in arms.iter().filter(|to| to.out != from.out) {
            let road = ROADS_PER_JUNCTION * id + connection;
            // Into the crossing on the lane that ends here, out of it on the one that begins here.
            let (lane_in, end_in) = if from.begins { (1, "start") } else { (-1, "end") };
            let (lane_out, end_out) = if to.begins { (-1, "start") } else { (1, "end") };
            let into = from.out + 2;
            let (dx, dy) = unit(from.out);
            let quarter_circle = REACH * std::f64::consts::FRAC_PI_2;
            let (length, shape) = match (to.out + 4 - into % 4) % 4 {
                0 => (2.0 * REACH, "<line/>".to_owned()),
                1 => (quarter_circle, format!("<arc curvature=\"{}\"/>", 1.0 / REACH)),
                _ => (quarter_circle, format!("<arc curvature=\"{}\"/>", -1.0 / REACH)),
            };
            let _ = writeln!(
                roads,
                "  <road name=\"\" length=\"{length}\" id=\"{road}\" junction=\"{id}\" rule=\"RHT\">"
            );
            let _ = writeln!(
                roads,
                "    <link><predecessor elementType=\"road\" elementId=\"{}\" contactPoint=\"{end_in}\"/><successor elementType=\"road\" elementId=\"{}\" contactPoint=\"{end_out}\"/></link>",
                from.road, to.road
            );
            geometry(roads, (x + dx * REACH, y + dy * REACH), into, length, &shape);
            let link = format!(
                "<link><predecessor id=\"{lane_in}\"/><successor id=\"{lane_out}\"/></link>"
            );
            let _ = writeln!(
                roads,
                "    <lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\" level=\"false\"/></center><right>{}</right></laneSection></lanes>\n  </road>",
                lane(-1, "driving", LANE, &link)
            );
            let _ = writeln!(
                junctions,
                "    <connection id=\"{connection}\" incomingRoad=\"{}\" connectingRoad=\"{road}\" contactPoint=\"start\"><laneLink from=\"{lane_in}\" to=\"-1\"/></connection>",
                from.road
            );
            connection += 1;
        }
    }
    let _ = writeln!(junctions, "  </junction>");
}
