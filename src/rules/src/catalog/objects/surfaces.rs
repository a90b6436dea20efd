//! Surface data of objects.

use crate::example::Example::{Objects as In, Road as InRoad};
use crate::place::{ObjectIn, RoadIn, number, text, value};
use crate::rule::Check::{Object, Road};
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{self as xodr, CrgMode};

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.surface.only_for_angular_boxes",
        "Only objects with length and width and without outlines have surface data.",
        Object(angular),
        [
            In(r#"<object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object>"#),
            In(r#"<object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" radius="1" height="0"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.surface.repeat_discretely_not_continously",
        "Objects with surface data are repeated at distances.",
        Object(discrete),
        [
            In(r#"<object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><repeat s="10" length="20" distance="5" tStart="0" tEnd="0" heightStart="0" heightEnd="0" zOffsetStart="0" zOffsetEnd="0"/><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object>"#),
            In(r#"<object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><repeat s="10" length="20" distance="0" tStart="0" tEnd="0" heightStart="0" heightEnd="0" zOffsetStart="0" zOffsetEnd="0"/><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.surface.crg_hidden_on_object_overlap",
        "Surface data of an object do not cover surface data of the road below, unless those are attached.",
        Road(hidden),
        [
            InRoad(r#"<objects><object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object></objects><surface><CRG file="b.crg" sStart="0" sEnd="50" orientation="same" mode="genuine" purpose="elevation"/></surface>"#),
            InRoad(r#"<objects><object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><surface><CRG file="a.crg" hideRoadSurfaceCRG="true" zScale="1"/></surface></object></objects><surface><CRG file="b.crg" sStart="0" sEnd="50" orientation="same" mode="genuine" purpose="elevation"/></surface>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.surface.no_bounding_box_overlap",
        "Objects with surface data do not overlap.",
        Road(overlap),
        [
            In(r#"<object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object><object id="2" type="patch" s="20" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object>"#),
            In(r#"<object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object><object id="2" type="patch" s="11" t="0" zOffset="0" orientation="none" length="2" width="2" height="0"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object>"#),
        ],
    ),
    Rule::info(
        "asam.net:xodr:1.9.0:road.object.surface.avoid_skewed_crg_surfacees",
        "An object that is perpendicular to the road is smaller than the vertical radius of the road there.",
        Object(skewed),
        [
            InRoad(r#"<elevationProfile><elevation s="0" a="0" b="0" c="0.01" d="0"/></elevationProfile><objects><object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0" perpToRoad="true"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object></objects>"#),
            InRoad(r#"<elevationProfile><elevation s="0" a="0" b="0" c="0.3" d="0"/></elevationProfile><objects><object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2" height="0" perpToRoad="true"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object></objects>"#),
        ],
    )
    .advisory(),
];

fn is_surface(object: &xodr::Object) -> bool {
    object.surface.as_ref().is_some_and(|surface| surface.crg.is_some())
}

fn angular(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let object = of.object;
    let has_size = number(&object.length) > 0.0 && number(&object.width) > 0.0;
    let has_outline = object.outlines.is_some() || object.outline.is_some();
    if is_surface(object) && (!has_size || has_outline || number(&object.radius) > 0.0) {
        sink.add_within("surface", object.span, "length and width and no outline", "another shape");
    }
}

fn discrete(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    for repeat in of.object.repeat.iter().filter(|_| is_surface(of.object)) {
        if value(&repeat.distance) == Some(0.0) {
            sink.add_within("repeat", repeat.span, "a distance above 0 between surfaces", 0);
        }
    }
}

fn hidden(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let own = of.road.surface.iter().flat_map(|surface| &surface.crg);
    let own: Vec<_> = own.filter(|crg| value(&crg.mode) != Some(CrgMode::Attached)).collect();
    for object in of.road.objects.iter().flat_map(|objects| &objects.object) {
        let Some(crg) = object.surface.as_ref().and_then(|surface| surface.crg.as_ref()) else {
            continue;
        };
        let (s, half) = (number(&object.s), number(&object.length) / 2.0);
        let overlaps = |crg: &&&xodr::RoadCrg| {
            number(&crg.s_start) < s + half && s - half < number(&crg.s_end)
        };
        if value(&crg.hide_road_surface_crg) == Some(true) && own.iter().any(|crg| overlaps(&crg)) {
            sink.add_within(
                "objects/object/surface/CRG",
                crg.span,
                "the road's surface data not hidden",
                "them hidden",
            );
        }
    }
}

fn overlap(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let objects = of.road.objects.iter().flat_map(|objects| &objects.object);
    let mut boxes: Vec<_> = objects
        .filter(|object| is_surface(object))
        .map(|object| {
            // Turned boxes lie within the circle about them.
            let (length, width) = (number(&object.length) / 2.0, number(&object.width) / 2.0);
            let (cos, sin) = mapd_geometry::cos_sin(number(&object.hdg));
            let half_s = (length * cos).abs() + (width * sin).abs();
            let half_t = (length * sin).abs() + (width * cos).abs();
            (number(&object.s), half_s, number(&object.t), half_t, object)
        })
        .collect();
    boxes.sort_by(|a, b| (a.0 - a.1).total_cmp(&(b.0 - b.1)));
    for pair in boxes.windows(2) {
        let (a, b) = (&pair[0], &pair[1]);
        if b.0 - b.1 < a.0 + a.1 && (a.2 - b.2).abs() < a.3 + b.3 {
            let other = text(&a.4.id);
            let found = format_args!("an overlap with object {other}");
            sink.add_within("objects/object", b.4.span, "surfaces apart from one another", found);
        }
    }
}

fn skewed(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let object = of.object;
    let Some(road) = of.road.filter(|_| is_surface(object)) else { return };
    if value(&object.perp_to_road) != Some(true) {
        return;
    }
    let s = number(&object.s);
    let elevations = road.elevation_profile.iter().flat_map(|profile| &profile.elevation);
    let record = elevations.map(|e| crate::profile::record!(e, s)).rfind(|r| r.s <= s);
    let bend = record.map_or(0.0, |record| record.cubic.second_derivative(s - record.s).abs());
    let size = number(&object.length).max(number(&object.width));
    if size * bend > 1.0 {
        let radius = 1.0 / bend;
        let expected =
            format_args!("an object below {radius:.2} m, the radius of the road's height");
        sink.add(object.span, expected, format_args!("{size} m"));
    }
}
