//! Places on Earth: what a conversion costs over the metric twin of a query, per projection; the bound is a microsecond.

use mapd_benches::{Random, best, print};
use mapd_client::glam::DVec3;
use mapd_geodesy::{Geodetic, Offset, Projector, Reference};
use std::hint::black_box;
use std::process::ExitCode;

/// Conversions of each kind in a run, and runs of which the best counts.
const CONVERSIONS: usize = 20_000;
const RUNS: usize = 9;
/// Most that a conversion may cost `[ns]`.
const BOUND: f64 = 1_000.0;

/// Name, georeference, latitude and longitude of the middle.
const SETS: [(&str, &str, f64, f64); 10] = [
    ("utm", "+proj=utm +zone=32 +datum=WGS84", 48.0, 11.0),
    ("tmerc", "+proj=tmerc +lat_0=48 +lon_0=11 +k=1", 48.0, 11.0),
    ("topocentric", "+proj=topocentric +lat_0=48 +lon_0=11 +h_0=500", 48.0, 11.0),
    ("merc", "+proj=merc +lat_ts=45 +lon_0=10 +datum=WGS84", 48.0, 11.0),
    ("lcc", "epsg:2154", 46.5, 3.0),
    ("aeqd", "+proj=aeqd +lat_0=48.1 +lon_0=11.6 +datum=WGS84", 48.0, 11.0),
    ("stere", "+proj=stere +lat_0=52.2 +lon_0=19.1 +k=0.9996 +datum=WGS84", 52.0, 19.0),
    ("utm, three parameters", "+proj=utm +zone=32 +ellps=intl +towgs84=-87,-98,-121", 48.0, 11.0),
    ("tmerc, seven parameters", "epsg:31468", 48.0, 11.0),
    ("somerc, three parameters", "epsg:2056", 47.0, 8.0),
];

fn main() -> ExitCode {
    let mut exceeded = false;
    for (name, text, latitude, longitude) in SETS {
        let definition = Reference::read(text).expect(name).definition.expect(name);
        let projector = Projector::new(&definition, Offset::default()).expect(name);
        let mut random = Random(7);
        let places: Vec<Geodetic> = (0..CONVERSIONS)
            .map(|_| Geodetic {
                latitude: latitude + 0.2 * (random.unit() - 0.5),
                longitude: longitude + 0.2 * (random.unit() - 0.5),
                altitude: 500.0 * random.unit(),
            })
            .collect();
        let points: Vec<DVec3> =
            places.iter().map(|place| projector.from_geodetic(*place).expect(name)).collect();
        let each = |time: std::time::Duration| time.as_secs_f64() * 1e9 / CONVERSIONS as f64;
        let from = each(best(RUNS, || {
            for place in &places {
                let _ = black_box(projector.from_geodetic(*place));
            }
        }));
        let to = each(best(RUNS, || {
            for point in &points {
                let _ = black_box(projector.to_geodetic(*point));
            }
        }));
        let over = from.max(to) > BOUND;
        print(&format!(
            "{name}: {from:.0} ns to the map, {to:.0} ns to Earth, at most {BOUND}{}",
            if over { ": EXCEEDED" } else { "" }
        ));
        exceeded |= over;
    }
    if exceeded { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
