//! Skeletons of objects.

use crate::example::Example::Objects as In;
use crate::place::{ObjectIn, number};
use crate::rule::Check::Object;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{self as xodr, Polyline};

/// How far vertices may reach beyond the box.
const BEYOND: Tolerance = Tolerance { name: "reach beyond the box", value: 0.01, unit: "m" };

/// An object of 4 by 4 by 3 m with a skeleton.
macro_rules! skeleton {
    ($vertices:literal) => {
        In(concat!(
            r#"<object id="1" type="pole" s="50" t="0" zOffset="0" orientation="none" length="4" width="4" height="3"><skeleton><polyline id="1">"#,
            $vertices, "</polyline></skeleton></object>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.8.0:road.object.skeleton.use_radius_or_width_length",
        "Either all vertices of a polyline have a radius, or none.",
        Object(radii),
        [
            skeleton!(r#"<vertexLocal id="1" u="0" v="0" z="0" radius="0.1"/><vertexLocal id="2" u="0" v="0" z="3" radius="0.1"/>"#),
            skeleton!(r#"<vertexLocal id="1" u="0" v="0" z="0" radius="0.1"/><vertexLocal id="2" u="0" v="0" z="3"/>"#),
        ],
    ),
    Rule::info(
        "asam.net:xodr:1.8.0:road.object.skeleton.points_inside_box",
        "The vertices of a skeleton are inside the object's box.",
        Object(inside),
        [
            skeleton!(r#"<vertexLocal id="1" u="0" v="0" z="0" radius="0.1"/><vertexLocal id="2" u="0" v="0" z="3" radius="0.1"/>"#),
            skeleton!(r#"<vertexLocal id="1" u="0" v="0" z="0" radius="0.1"/><vertexLocal id="2" u="0" v="0" z="4" radius="0.1"/>"#),
        ],
    )
    .within(&[BEYOND]),
    Rule::info(
        "asam.net:xodr:1.9.0:road.object.skeleton.points_boundary_inside_box",
        "A part of a skeleton's tubes is inside the object's box.",
        Object(partly_inside),
        [
            skeleton!(r#"<vertexLocal id="1" u="0" v="0" z="0" radius="0.1"/><vertexLocal id="2" u="0" v="0" z="3" radius="0.1"/>"#),
            skeleton!(r#"<vertexLocal id="1" u="9" v="0" z="0" radius="0.1"/><vertexLocal id="2" u="9" v="0" z="3" radius="0.1"/>"#),
        ],
    ),
];

const PART: &str = "skeleton/polyline";

fn polylines(object: &xodr::Object) -> impl Iterator<Item = &Polyline> {
    object.skeleton.iter().flat_map(|skeleton| &skeleton.polyline)
}

fn radii(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for line in polylines(of.object) {
        let local = line.vertex_local.iter().map(|vertex| vertex.radius.is_some());
        let road = line.vertex_road.iter().map(|vertex| vertex.radius.is_some());
        let has: Vec<bool> = local.chain(road).collect();
        if has.contains(&true) && has.contains(&false) {
            sink.add_within(PART, line.span, "a radius of all vertices or none", "one of some");
        }
    }
}

/// By how much a point is outside of the object's box, in each direction `[m]`; none where the box has no size.
fn outside(object: &xodr::Object, [u, v, z]: [f64; 3]) -> Option<[f64; 3]> {
    let radius = number(&object.radius);
    let (length, width) = if radius > 0.0 {
        (2.0 * radius, 2.0 * radius)
    } else {
        (number(&object.length), number(&object.width))
    };
    let height = number(&object.height);
    let beyond_top = if height > 0.0 { z - height } else { 0.0 };
    (length > 0.0 && width > 0.0)
        .then(|| [u.abs() - length / 2.0, v.abs() - width / 2.0, beyond_top.max(-z)])
}

fn inside(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for vertex in polylines(of.object).flat_map(|line| &line.vertex_local) {
        let point = [number(&vertex.u), number(&vertex.v), number(&vertex.z)];
        let Some(beyond) = outside(of.object, point) else { continue };
        if beyond.into_iter().any(|beyond| beyond > BEYOND.value) {
            let found = format_args!("one at {point:?}");
            sink.add_within(PART, vertex.span, "vertices within the object's box", found);
            return;
        }
    }
}

fn partly_inside(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let vertices: Vec<_> = polylines(of.object).flat_map(|line| &line.vertex_local).collect();
    let Some(first) = vertices.first() else { return };
    let is_near = |vertex: &&xodr::VertexLocal| {
        let point = [number(&vertex.u), number(&vertex.v), number(&vertex.z)];
        let radius = number(&vertex.radius);
        outside(of.object, point).is_none_or(|beyond| beyond.into_iter().all(|b| b <= radius))
    };
    // A tube may pass through the box without a vertex there: then its ends are on both sides of it.
    let crosses = vertices.windows(2).any(|pair| {
        let product = |a: &Option<xodr::Attribute<f64>>, b| number(a) * number(b);
        product(&pair[0].u, &pair[1].u) < 0.0 || product(&pair[0].v, &pair[1].v) < 0.0
    });
    if !vertices.iter().any(is_near) && !crosses {
        sink.add_within(PART, first.span, "some of the tubes within the object's box", "none");
    }
}
