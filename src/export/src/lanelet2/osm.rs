//! The file: OpenStreetMap's XML as Lanelet2 reads it.

use super::model::{Edge, Ends, Lines, Member, Model};
use super::report::Report;
use super::tags::{self, Tag, number};
use crate::earth;
use crate::{Progress, Result};
use mapd_client::geodesy::Projector;
use mapd_client::glam::DVec3;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, Event};
use std::io::Write;

/// Digits behind the point of latitudes and longitudes: a hundredth of a millimetre.
const DEGREE_DIGITS: usize = 10;
/// Digits behind the point of lengths `[m]`.
const METRE_DIGITS: usize = 4;

/// Numbers of the file's elements: lanelets, what lies across lanes, rules, areas, lines, points, one kind behind the other.
struct Ids {
    extra_lanelets: u64,
    rules: u64,
    areas: u64,
    extra_lines: u64,
    borders: u64,
    points: u64,
}

struct File<'w, 'p> {
    xml: Writer<&'w mut dyn Write>,
    projector: &'p Projector,
}

/// Writes a map.
///
/// Errors: a point outside the area of the map's projection; what writing gives.
pub(super) fn write(
    model: &Model<'_>,
    projector: &Projector,
    report: &mut Report,
    progress: &mut dyn FnMut(Progress),
    out: &mut dyn Write,
) -> Result<()> {
    let lines = Lines::of(model);
    let lanelets = model.network.lanelets.len() as u64;
    let extra_lanelets = 1 + lanelets;
    let rules = extra_lanelets + model.crossings.len() as u64;
    let areas = rules + model.rules.len() as u64;
    let extra_lines = areas + model.areas.len() as u64;
    let borders = extra_lines + model.lines.len() as u64;
    let points = borders + lines.used.len() as u64;
    let ids = Ids { extra_lanelets, rules, areas, extra_lines, borders, points };
    let mut file = File { xml: Writer::new_with_indent(out, b' ', 1), projector };
    file.xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    file.begin("osm", &[("version", "0.6"), ("generator", "mapd")])?;
    file.empty("MetaInfo", &[("format_version", "1")])?;
    progress(Progress { doing: "points", done: 0 });
    let ways = file.nodes(model, &lines, &ids)?;
    progress(Progress { doing: "lines", done: 0 });
    file.ways(model, &lines, &ids, &ways)?;
    progress(Progress { doing: "lanelets", done: 0 });
    file.relations(model, &lines, &ids, report)?;
    file.xml.write_event(Event::End(BytesEnd::new("osm")))?;
    Ok(writeln!(file.xml.get_mut())?)
}

/// First and one behind the last of the points that only one line has.
struct Own {
    from: u64,
    to: u64,
}

impl File<'_, '_> {
    fn begin(&mut self, name: &str, attributes: &[(&str, &str)]) -> Result<()> {
        let start = BytesStart::new(name).with_attributes(attributes.iter().copied());
        Ok(self.xml.write_event(Event::Start(start))?)
    }

    fn end(&mut self, name: &str) -> Result<()> {
        Ok(self.xml.write_event(Event::End(BytesEnd::new(name)))?)
    }

    fn empty(&mut self, name: &str, attributes: &[(&str, &str)]) -> Result<()> {
        let start = BytesStart::new(name).with_attributes(attributes.iter().copied());
        Ok(self.xml.write_event(Event::Empty(start))?)
    }

    fn tags(&mut self, tags: &[Tag<'_>]) -> Result<()> {
        tags.iter().try_for_each(|(name, value)| self.empty("tag", &[("k", name), ("v", value)]))
    }

    /// A point: where it is on Earth, how high, and where it is in the map's own frame.
    fn node(&mut self, id: u64, point: DVec3) -> Result<()> {
        let place = earth::place(self.projector, point)?;
        let latitude = number(place.latitude, DEGREE_DIGITS);
        let longitude = number(place.longitude, DEGREE_DIGITS);
        let id = id.to_string();
        self.begin(
            "node",
            &[("id", &id), ("version", "1"), ("lat", &latitude), ("lon", &longitude)],
        )?;
        self.tags(&[
            ("ele", number(place.altitude, METRE_DIGITS).into()),
            ("local_x", number(point.x, METRE_DIGITS).into()),
            ("local_y", number(point.y, METRE_DIGITS).into()),
        ])?;
        self.end("node")
    }

    /// All points: those that lines share, then those of each line alone. Returns which these are: of borders, then of other lines.
    fn nodes(&mut self, model: &Model<'_>, lines: &Lines, ids: &Ids) -> Result<Vec<Own>> {
        for (number, corner) in lines.points.iter().enumerate() {
            self.node(ids.points + number as u64, model.network.joints.place(*corner))?;
        }
        let (mut ways, mut next) = (Vec::new(), ids.points + lines.points.len() as u64);
        for line in &lines.used {
            let from = next;
            let points = model.points(line);
            for point in points.get(1..points.len().saturating_sub(1)).unwrap_or(&[]) {
                self.node(next, *point)?;
                next += 1;
            }
            ways.push(Own { from, to: next });
        }
        for line in &model.lines {
            let from = next;
            for point in &line.points {
                self.node(next, *point)?;
                next += 1;
            }
            ways.push(Own { from, to: next });
        }
        Ok(ways)
    }

    fn way(&mut self, id: u64, points: impl Iterator<Item = u64>, tags: &[Tag<'_>]) -> Result<()> {
        self.begin("way", &[("id", &id.to_string()), ("version", "1")])?;
        for point in points {
            self.empty("nd", &[("ref", &point.to_string())])?;
        }
        self.tags(tags)?;
        self.end("way")
    }

    fn ways(&mut self, model: &Model<'_>, lines: &Lines, ids: &Ids, own: &[Own]) -> Result<()> {
        let others = model.lines.iter().zip(own.get(lines.used.len()..).unwrap_or(&[]));
        let point = |corner| {
            lines.number_of_point(model.network.joints.point(corner)).map(|at| ids.points + at)
        };
        for ((number, line), own) in lines.used.iter().enumerate().zip(own) {
            let Some(stretch) = model.network.stretches.all.get(line.stretch as usize) else {
                continue;
            };
            let end = |cut| point(stretch.corner(line.border, cut));
            let points =
                end(line.piece).into_iter().chain(own.from..own.to).chain(end(line.piece + 1));
            let tags = tags::border(&model.network, stretch, line.border, line.piece);
            self.way(ids.borders + number as u64, points, &tags)?;
        }
        for (number, (line, own)) in others.enumerate() {
            let [before, after] = match line.ends {
                Ends::Own => [None; 2],
                Ends::Ring => [None, (own.from < own.to).then_some(own.from)],
                Ends::Corners(corners) => corners.map(point),
            };
            let points = before.into_iter().chain(own.from..own.to).chain(after);
            self.way(ids.extra_lines + number as u64, points, &line.tags)?;
        }
        Ok(())
    }

    fn relation(&mut self, id: u64, members: &[(&str, u64, &str)], tags: &[Tag<'_>]) -> Result<()> {
        self.begin("relation", &[("id", &id.to_string()), ("version", "1")])?;
        for (kind, id, role) in members {
            self.empty("member", &[("type", kind), ("ref", &id.to_string()), ("role", role)])?;
        }
        self.tags(tags)?;
        self.end("relation")
    }

    fn relations(
        &mut self,
        model: &Model<'_>,
        lines: &Lines,
        ids: &Ids,
        report: &mut Report,
    ) -> Result<()> {
        let rules = model.rules_of_lanelets();
        for (number, lanelet) in model.network.lanelets.iter().enumerate() {
            let Some(stretch) = model.network.stretches.all.get(lanelet.stretch as usize) else {
                continue;
            };
            let [left, right] = if lanelet.lane.is_forward() {
                lanelet.borders
            } else {
                let [left, right] = lanelet.borders;
                [right, left]
            };
            let mut members = Vec::new();
            for (border, role) in [(left, "left"), (right, "right")] {
                let line = lines.number_of_border(stretch.corner(border, lanelet.piece));
                members.extend(line.map(|line| ("way", ids.borders + line, role)));
            }
            let own = rules.get(number).into_iter().flatten();
            members.extend(
                own.map(|rule| ("relation", ids.rules + *rule as u64, "regulatory_element")),
            );
            let tags = tags::lanelet(lanelet, stretch, report);
            self.relation(1 + number as u64, &members, &tags)?;
        }
        for (number, crossing) in model.crossings.iter().enumerate() {
            let line = |at: usize| ids.extra_lines + at as u64;
            let mut members =
                vec![("way", line(crossing.left), "left"), ("way", line(crossing.right), "right")];
            let own = crossing.rule.map(|rule| ids.rules + rule as u64);
            members.extend(own.map(|rule| ("relation", rule, "regulatory_element")));
            self.relation(ids.extra_lanelets + number as u64, &members, &crossing.tags)?;
        }
        for (number, rule) in model.rules.iter().enumerate() {
            let member = |(role, member): &(&'static str, Member)| match member {
                Member::Line(at) => ("way", ids.extra_lines + *at as u64, *role),
                Member::Lanelet(at) => ("relation", 1 + u64::from(*at), *role),
                Member::Crossing(at) => ("relation", ids.extra_lanelets + *at as u64, *role),
            };
            let members: Vec<_> = rule.members.iter().map(member).collect();
            self.relation(ids.rules + number as u64, &members, &rule.tags)?;
        }
        for (number, area) in model.areas.iter().enumerate() {
            let line = |at: usize| ids.extra_lines + at as u64;
            let outer = area.outer.iter().filter_map(|edge| match edge {
                Edge::Line(at) => Some(line(*at)),
                Edge::Border(border) => {
                    let number = lines.number_of_border(model.corner(border)?)?;
                    Some(ids.borders + number)
                }
            });
            let outer = outer.map(|id| ("way", id, "outer"));
            let inner = area.inner.iter().map(|at| ("way", line(*at), "inner"));
            let members: Vec<_> = outer.chain(inner).collect();
            self.relation(ids.areas + number as u64, &members, &area.tags)?;
        }
        Ok(())
    }
}
