//! Questions that the page asks, and their answers as JSON.

use crate::drawing::Drawing;
use crate::paint::Paint;
use crate::place::{PlanPoint, pick};
use crate::sheet::{Kind, Link, Sheet, Words};
use crate::{find, scene, way};
use mapd_query::Bounds;
use mapd_query::Map;
use mapd_query::document::SourcePosition;
use mapd_query::view::View;
use serde::Serialize;

/// Parts that are left out and listed at most.
const MOST_LISTED: usize = 5000;

/// A question about a map, with what is laid over it.
#[derive(Clone, Debug, PartialEq)]
pub enum Question<'a> {
    /// What the map is: its name, extent, numbers of things and paints.
    Map,
    /// What lies at x and y `[m]`: [`PlanPoint`].
    Place([f64; 2]),
    /// What lies at a latitude and longitude `[deg]`: [`PlanPoint`].
    Geodetic([f64; 2]),
    /// What can be chosen at x and y within a radius `[m]`: links.
    Pick([f64; 2], f64),
    /// What is known of a thing: [`Sheet`].
    Sheet(Link),
    /// What has this name: [`Words`].
    Find(&'a str),
    /// The way from place to place `[m]`: [`crate::Way`].
    Way([f64; 2], [f64; 2]),
    /// What is left out.
    LeftOut,
}

/// What a map is.
#[derive(Serialize)]
struct Overview<'a> {
    name: &'a str,
    generation: u64,
    content: String,
    projection: &'a str,
    /// Smallest and largest x, y, z `[m]`.
    bounds: [[f64; 3]; 2],
    /// What drawings are relative to `[m]`.
    middle: [f64; 3],
    road_length: f64,
    roads: usize,
    junctions: usize,
    lanes: usize,
    signals: usize,
    objects: usize,
    left_out: usize,
    paints: Vec<&'static str>,
}

#[derive(Serialize)]
struct LeftOut<'a> {
    name: Words,
    rule: &'a str,
    message: &'a str,
    line: u32,
    column: u32,
    file: Option<&'a str>,
    has_place: bool,
}

/// What is wrong with a question.
#[derive(Serialize)]
struct Failure<'a> {
    error: &'a str,
}

/// What a question is answered with.
pub struct Answer {
    /// JSON: an object with `error` if there is no answer.
    pub json: String,
    /// What the page draws, if the answer has a drawing.
    pub drawing: Option<Drawing>,
}

impl Question<'_> {
    /// The answer, with what is laid over the map.
    pub fn answer(&self, view: View<'_>) -> Answer {
        let (map, mut drawing) = (view.map(), None);
        let json = match self {
            Self::Map => json(&overview(map)),
            Self::Place([x, y]) => result(PlanPoint::at(map, *x, *y)),
            Self::Geodetic([latitude, longitude]) => {
                result(PlanPoint::at_geodetic(map, *latitude, *longitude))
            }
            Self::Pick([x, y], radius) => result(pick(map, *x, *y, *radius)),
            Self::Sheet(link) => {
                drawing = Some(way::highlight(map, *link));
                json(&Sheet::of(view, *link))
            }
            Self::Find(text) => json(&find::find(map, text)),
            Self::Way(from, to) => match way::way(view, *from, *to) {
                Ok(found) => {
                    drawing = Some(found.drawing);
                    json(&found.way)
                }
                Err(error) => json(&Failure { error: &error }),
            },
            Self::LeftOut => json(&left_out(map)),
        };
        Answer { json, drawing }
    }
}

fn json<T: Serialize>(value: &T) -> String {
    serde_json::to_string(value).unwrap_or_else(|error| error.to_string())
}

fn result<T: Serialize, E: ToString>(answer: Result<T, E>) -> String {
    match answer {
        Ok(answer) => json(&answer),
        Err(error) => json(&Failure { error: &error.to_string() }),
    }
}

fn overview(map: Map<'_>) -> Overview<'_> {
    let Bounds { low, high } = map.bounds();
    Overview {
        name: map.name(),
        generation: map.generation(),
        content: map.content_hash().iter().map(|byte| format!("{byte:02x}")).collect(),
        projection: map.projection(),
        bounds: [low.to_array(), high.to_array()],
        middle: scene::middle(map).to_array(),
        road_length: map.road_length(),
        roads: map.roads().count(),
        junctions: map.junctions().count(),
        lanes: map.lanes().count(),
        signals: map.signals().len(),
        objects: map.objects().count(),
        left_out: map.quarantined().len(),
        paints: Paint::ALL.iter().map(|paint| paint.name()).collect(),
    }
}

fn left_out(map: Map<'_>) -> Vec<LeftOut<'_>> {
    let parts = map.quarantined().enumerate().take(MOST_LISTED);
    let listed = parts.map(|(number, part)| {
        let SourcePosition { line, column } = part.source_position();
        let link = Link { kind: Kind::Quarantine, row: number as u32 };
        LeftOut {
            name: Words { text: format!("{} {}", part.kind().name(), part.id()), link: Some(link) },
            rule: part.rule(),
            message: part.message(),
            line,
            column,
            file: part.source_file(),
            has_place: part.extent().is_some(),
        }
    });
    listed.collect()
}
