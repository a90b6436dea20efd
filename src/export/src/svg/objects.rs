//! What objects cover.

use super::{Paper, escape, points};
use mapd_client::Map;
use mapd_client::glam::DVec3;
use mapd_client::objects::ObjectPlacement;
use mapd_client::vocabulary::ObjectShape;
use std::io::{Result, Write};

/// Radius of the mark of an object without extent `[m]`.
const MARK: f64 = 0.3;

/// Writes every place of every object.
pub(super) fn write(map: Map<'_>, paper: Paper, out: &mut dyn Write) -> Result<()> {
    let mut corners = Vec::new();
    for place in map.objects().flat_map(|object| object.placements()) {
        self::place(&place, &mut corners, paper, out)?;
    }
    Ok(())
}

fn place(
    place: &ObjectPlacement<'_>,
    corners: &mut Vec<DVec3>,
    paper: Paper,
    out: &mut dyn Write,
) -> Result<()> {
    let object = place.object();
    let title = format!(
        "<title>{} {} {}</title>",
        escape(object.id()),
        object.class().name(),
        escape(object.name())
    );
    match place.shape() {
        ObjectShape::Outlines => {
            for outline in place.outlines() {
                let class = if outline.is_closed() { "object" } else { "object line" };
                write!(out, "<path class=\"{class}\" d=\"")?;
                points(outline.positions(), paper, 'M', out)?;
                writeln!(out, "{}\">{title}</path>", if outline.is_closed() { "z" } else { "" })?;
            }
            Ok(())
        }
        ObjectShape::Box => {
            place.footprint(corners);
            write!(out, "<path class=\"object\" d=\"")?;
            points(corners.iter().copied(), paper, 'M', out)?;
            writeln!(out, "z\">{title}</path>")
        }
        shape => {
            let at = paper.at(place.position().truncate());
            let radius = if shape == ObjectShape::Cylinder { place.radius() } else { MARK };
            writeln!(
                out,
                "<circle class=\"object\" cx=\"{:.3}\" cy=\"{:.3}\" r=\"{radius:.3}\">{title}</circle>",
                at.x, at.y
            )
        }
    }
}
