//! Where the page paints: layer by layer and pixel by pixel, nothing beside what the map has there, and no hole in it.

use crate::{browser, town_with_everything, under_works};
use mapd_tests::browser::Browser;
use mapd_tests::maps::open;
use mapd_tests::{carried, shared};
use mapd_web::{Drawing, Layer};
use serde_json::{Value, json};
use std::time::UNIX_EPOCH;

/// How far beside what is drawn a pixel may be painted `[px]`: edges are smooth, and single precision rounds.
const BESIDE: i64 = 2;
/// Half the width of the piece of ground that is looked at `[m]`: so near that every layer is drawn.
const AROUND: f64 = 20.0;
/// From place to place along a line, and across it, where pixels are marked `[px]`.
const STEP: f64 = 0.4;
/// Width of the thinnest line of any layer, as the page's `painter.js` has it `[px]`.
const THINNEST: f64 = 2.0;
/// Periods of dashes that are shorter are no dashes on the screen `[px]`, as in `shaders.js`.
const SHORTEST_PERIOD: f64 = 4.0;
/// Radius of a signal's picture: metres, least and most `[px]`, and how far its stroke reaches beyond, as in `painter.js` and `shaders.js`.
const SIGN: (f64, f64, f64, f64) = (0.8, 3.4, 12.0, 1.9);

/// Pixels of the screen, from its lower left corner.
#[derive(Clone)]
struct Pixels {
    width: i64,
    height: i64,
    marked: Vec<bool>,
}

impl Pixels {
    fn new(width: i64, height: i64) -> Self {
        Self { width, height, marked: vec![false; (width * height) as usize] }
    }

    fn index(&self, x: i64, y: i64) -> Option<usize> {
        let is_inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        is_inside.then_some((y * self.width + x) as usize)
    }

    fn mark(&mut self, [x, y]: [f64; 2]) {
        if let Some(i) = self.index(x.floor() as i64, y.floor() as i64) {
            self.marked[i] = true;
        }
    }

    /// Whether some pixel, or every pixel, of those at most so far away is marked. None lies outside of the screen.
    fn around(&self, (x, y): (i64, i64), reach: i64, all: bool) -> bool {
        let mut near = (-reach..=reach)
            .flat_map(|dx| (-reach..=reach).map(move |dy| (x + dx, y + dy)))
            .filter_map(|(x, y)| self.index(x, y))
            .map(|i| self.marked[i]);
        if all { near.all(|one| one) } else { near.any(|one| one) }
    }

    /// The places of those that are marked, but not among others.
    fn places_beside<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = (i64, i64)> + 'a {
        let pairs = self.marked.iter().zip(&other.marked).enumerate();
        let own = pairs.filter(|(_, (one, other))| **one && !**other);
        own.map(|(i, _)| (i as i64 % self.width, i as i64 / self.width))
    }
}

/// What a drawing has on the screen.
struct Expected {
    /// Pixels that something of it touches.
    touched: Pixels,
    /// Pixels whose middles lie in its areas.
    areas: Pixels,
    /// Pixels that middles of its lines pass, without gaps and ends of dashes.
    lines: Pixels,
}

/// What is seen of a layer where the middle of the screen and the pixels a metre are these.
fn expected(drawing: &Drawing, layer: Layer, like: &Pixels, [x, y, scale]: [f64; 3]) -> Expected {
    let none = Pixels::new(like.width, like.height);
    let mut seen = Expected { touched: none.clone(), areas: none.clone(), lines: none };
    let (width, height) = (like.width as f64, like.height as f64);
    let pixel = |place: [f32; 2]| {
        let [at_x, at_y] = place.map(f64::from);
        [0.5 * width + (at_x - x) * scale, 0.5 * height + (at_y - y) * scale]
    };
    let is_near = |places: &[[f64; 2]]| {
        let size = [width, height];
        (0..2).all(|i| {
            let values = places.iter().map(|place| place[i]);
            let (low, high) =
                (values.clone().fold(f64::MAX, f64::min), values.fold(f64::MIN, f64::max));
            -20.0 < high && low < size[i] + 20.0
        })
    };
    for corners in drawing.triangles.chunks_exact(3) {
        let corners: [[f64; 2]; 3] =
            [0, 1, 2].map(|i| pixel(drawing.corners[corners[i] as usize].place));
        if is_near(&corners) {
            triangle(corners, &mut seen);
        }
    }
    for stroke in &drawing.strokes {
        let (from, to) = (pixel(stroke.from), pixel(stroke.to));
        if !is_near(&[from, to]) {
            continue;
        }
        if layer == Layer::Signals {
            sign(from, scale, &mut seen);
            continue;
        }
        let dashes = [stroke.along, stroke.dash, stroke.gap].map(|part| f64::from(part) * scale);
        line([from, to], dashes, f64::from(stroke.width) * scale, &mut seen);
    }
    seen
}

fn triangle([a, b, c]: [[f64; 2]; 3], seen: &mut Expected) {
    let cross = |[ax, ay]: [f64; 2], [bx, by]: [f64; 2], [px, py]: [f64; 2]| {
        (bx - ax) * (py - ay) - (by - ay) * (px - ax)
    };
    let range = |i: usize, most: i64| {
        let values = [a[i], b[i], c[i]];
        let (low, high) = (
            values.into_iter().fold(f64::MAX, f64::min),
            values.into_iter().fold(f64::MIN, f64::max),
        );
        (low.floor() as i64).max(0)..=(high.ceil() as i64).min(most - 1)
    };
    for y in range(1, seen.areas.height) {
        for x in range(0, seen.areas.width) {
            let middle = [x as f64 + 0.5, y as f64 + 0.5];
            let sides = [cross(a, b, middle), cross(b, c, middle), cross(c, a, middle)];
            if sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0) {
                seen.areas.mark(middle);
                seen.touched.mark(middle);
            }
        }
    }
    // Slivers hold no pixel's middle.
    for [from, to] in [[a, b], [b, c], [c, a]] {
        along(from, to, |at, _| seen.touched.mark(at));
    }
}

/// Places along a line, each with its distance from the beginning `[px]`.
fn along(from: [f64; 2], to: [f64; 2], mut visit: impl FnMut([f64; 2], f64)) {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy);
    let count = (length / STEP).ceil().max(1.0) as usize;
    for i in 0..=count {
        let share = i as f64 / count as f64;
        visit([from[0] + dx * share, from[1] + dy * share], length * share);
    }
}

fn line([from, to]: [[f64; 2]; 2], [before, dash, gap]: [f64; 3], width: f64, seen: &mut Expected) {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy).max(f64::MIN_POSITIVE);
    let across = [-dy / length, dx / length];
    let half = 0.5 * width.max(THINNEST);
    let is_broken = gap > 0.0 && dash + gap >= SHORTEST_PERIOD;
    // Lines that are drawn through have round ends.
    for end in [from, to].into_iter().filter(|_| gap == 0.0) {
        circle(end, half, &mut seen.touched);
    }
    along(from, to, |at, far| {
        let phase = (before + far) % (dash + gap);
        if is_broken && phase > dash {
            return;
        }
        along([-half, 0.0], [half, 0.0], |[beside, _], _| {
            seen.touched.mark([at[0] + beside * across[0], at[1] + beside * across[1]]);
        });
        let is_sure = phase > 1.0 && dash - phase > 1.0;
        if gap == 0.0 || is_broken && is_sure {
            seen.lines.mark(at);
        }
    });
}

/// A signal's picture, which lies within a circle and covers its middle.
fn sign(at: [f64; 2], scale: f64, seen: &mut Expected) {
    let (metres, least, most, reach) = SIGN;
    circle(at, mapd_geometry::clamp(metres * scale, least, most) * reach, &mut seen.touched);
    seen.lines.mark(at);
}

fn circle([x, y]: [f64; 2], radius: f64, pixels: &mut Pixels) {
    let far = radius.ceil() as i64;
    for (dx, dy) in (-far..=far).flat_map(|dx| (-far..=far).map(move |dy| (dx as f64, dy as f64))) {
        if dx.hypot(dy) <= radius {
            pixels.mark([x + dx, y + dy]);
        }
    }
}

/// Which pixels are painted if only this layer is shown, and the middle of the screen and the pixels a metre.
fn painted(browser: &mut Browser, layer: &str) -> (Pixels, [f64; 3]) {
    let shown = json!([layer]);
    // Runs of pixels that are background, painted, background, and so on.
    let answer = browser.evaluate(&format!(
        "(() => {{ viewer.shown = new Set({shown}); viewer.painter.changes++; viewer.paint();
        const {{ gl, canvas, back }} = viewer.painter, all = new Uint8Array(4 * canvas.width * canvas.height), runs = [];
        gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
        const [r, g, b] = back.map(value => Math.round(value * 255));
        let is = false, length = 0;
        for (let i = 0; i < all.length; i += 4) {{
            const painted = Math.abs(all[i] - r) > 2 || Math.abs(all[i + 1] - g) > 2 || Math.abs(all[i + 2] - b) > 2;
            if (painted !== is) {{ runs.push(length); length = 0; is = painted; }}
            length++;
        }}
        runs.push(length);
        const {{ x, y, scale }} = viewer.camera;
        return [[canvas.width, canvas.height], [x, y, scale], runs]; }})()"
    ));
    let number = |value: &Value| value.as_f64().expect("a number");
    let [width, height] = [0, 1].map(|i| number(&answer[0][i]) as i64);
    let mut pixels = Pixels { marked: Vec::new(), ..Pixels::new(width, height) };
    for (i, run) in answer[2].as_array().expect("runs").iter().enumerate() {
        let end = pixels.marked.len() + number(run) as usize;
        pixels.marked.resize(end, i % 2 == 1);
    }
    assert_eq!(pixels.marked.len(), (width * height) as usize);
    (pixels, [0, 1, 2].map(|i| number(&answer[1][i])))
}

/// Compares what is painted of a layer around some of its places; whether there was anything.
fn check(browser: &mut Browser, drawing: &Drawing, layer: Layer, name: &str) -> bool {
    let ends = drawing.strokes.iter().map(|stroke| stroke.from);
    let places: Vec<[f32; 2]> =
        ends.chain(drawing.corners.iter().map(|corner| corner.place)).collect();
    let mut count = 0;
    for [x, y] in [1, 3].iter().filter_map(|quarter| places.get(places.len() * quarter / 4)) {
        let fit = format!(
            "viewer.show([{x} - {AROUND}, {y} - {AROUND}, {x} + {AROUND}, {y} + {AROUND}])"
        );
        browser.evaluate(&fit);
        let (found, camera) = painted(browser, name);
        let seen = expected(drawing, layer, &found, camera);
        let at = |place: (i64, i64)| format!("{name} around {x}, {y}: pixel {place:?}");
        for place in found.places_beside(&seen.touched) {
            assert!(seen.touched.around(place, BESIDE, false), "{}: nothing is there", at(place));
        }
        for place in seen.areas.places_beside(&found) {
            assert!(!seen.areas.around(place, 1, true), "{}: a hole in an area", at(place));
        }
        for place in seen.lines.places_beside(&found) {
            assert!(found.around(place, 1, false), "{}: a line is interrupted", at(place));
        }
        count += found.marked.iter().filter(|one| **one).count();
    }
    assert_eq!(count > 0, !drawing.strokes.is_empty() || !drawing.triangles.is_empty(), "{name}");
    count > 0
}

#[test]
fn every_layer_is_painted_where_the_map_has_it() {
    let real = shared("maps").map(|folder| folder.join("esmini/soderleden.xodr"));
    let mut snapshots = vec![under_works(town_with_everything()), open(&carried("marks.xodr"))];
    snapshots.extend(real.map(|path| open(&path)));
    let mut painted = Vec::new();
    for snapshot in snapshots {
        let Some(mut browser) = browser(&snapshot) else { return };
        // Whether edges are smooth would depend on how fast the first pictures are.
        browser.evaluate("viewer.painter.frames.samples = 0");
        let names = browser.evaluate("LAYERS");
        for (layer, name) in Layer::ALL.iter().zip(names.as_array().expect("names")) {
            let drawing = layer.draw(snapshot.view(UNIX_EPOCH));
            if check(&mut browser, &drawing, *layer, name.as_str().expect("a name")) {
                painted.push(format!("{layer:?}"));
            }
        }
        assert_eq!(browser.complaints, [""; 0]);
    }
    for layer in Layer::ALL {
        assert!(painted.contains(&format!("{layer:?}")), "{layer:?} of no map");
    }
}
