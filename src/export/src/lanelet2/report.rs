//! What became of a map where Lanelet2 cannot have it as it is.

use mapd_client::glam::DVec3;
use std::collections::BTreeMap;
use std::io::Write;

/// Something that is not in the file as it is in the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Entry {
    /// Ends of lanes that follow each other were put together.
    Snapped {
        /// How far they were apart `[m]`.
        distance: f64,
    },
    /// A short section became part of its neighbours.
    Merged {
        /// Its length `[m]`.
        length: f64,
    },
    /// A lane does not follow another one as it does in the map.
    Lost {
        /// How far their ends are apart, where it is known `[m]`.
        distance: Option<f64>,
    },
    /// A lane follows another one, which it does not in the map: their borders meet.
    Extra,
    /// A piece of a lane is left out: it has no width to speak of.
    Narrow,
    /// Where a lane's outer border crosses itself is cut out, so that Lanelet2 finds which way it runs.
    Cut {
        /// How far it reached from what is left `[m]`.
        distance: f64,
    },
    /// Lanelet2 takes one border of a lane to run the other way.
    Turned,
}

/// What is not in a Lanelet2 file as it is in the map, lane by lane.
#[derive(Default)]
pub struct Report {
    lines: Vec<Line>,
    /// What Lanelet2 has no words for, and how often it occurs.
    unsaid: BTreeMap<&'static str, usize>,
}

struct Line {
    entry: Entry,
    from: String,
    to: String,
    place: DVec3,
}

/// What the summary says of entries.
const SUMMARY: &[(&str, &str)] = &[
    ("snapped", "pairs of ends of lanes that follow each other put together"),
    ("merged", "short sections made part of their neighbours"),
    ("lost", "times a lane does not follow another one as it does in the map"),
    (
        "extra",
        "times a lane follows another one because their borders meet, not because the map says so",
    ),
    ("narrow", "lanes with a piece left out that has no width"),
    ("cut", "borders that cross themselves in narrow turns cut"),
    ("turned", "lanelets of which Lanelet2 takes a border to run the wrong way"),
];

impl Entry {
    fn name(self) -> &'static str {
        match self {
            Self::Snapped { .. } => "snapped",
            Self::Merged { .. } => "merged",
            Self::Lost { .. } => "lost",
            Self::Extra => "extra",
            Self::Narrow => "narrow",
            Self::Cut { .. } => "cut",
            Self::Turned => "turned",
        }
    }

    fn metres(self) -> Option<f64> {
        match self {
            Self::Snapped { distance } => Some(distance),
            Self::Cut { distance } => Some(distance),
            Self::Merged { length } => Some(length),
            Self::Lost { distance } => distance,
            Self::Extra | Self::Narrow | Self::Turned => None,
        }
    }
}

impl Report {
    /// Adds what became of two lanes, or of one, at a place in the map `[m]`.
    pub(super) fn add(&mut self, entry: Entry, from: String, to: String, place: DVec3) {
        self.lines.push(Line { entry, from, to, place });
    }

    /// Counts something that Lanelet2 has no words for.
    pub(super) fn unsaid(&mut self, what: &'static str) {
        self.unsaid_times(what, 1);
    }

    /// Counts something that it has no words for, which occurs so often.
    pub(super) fn unsaid_times(&mut self, what: &'static str, count: usize) {
        if count > 0 {
            *self.unsaid.entry(what).or_default() += count;
        }
    }

    /// Says in a few lines how much of what there is.
    ///
    /// Errors: what writing gives.
    pub fn summary(&self, out: &mut dyn Write) -> std::io::Result<()> {
        for (name, text) in SUMMARY {
            let of_kind = self.lines.iter().filter(|line| line.entry.name() == *name);
            let (mut count, mut most) = (0, 0.0_f64);
            for line in of_kind {
                count += 1;
                most = most.max(line.entry.metres().unwrap_or(0.0));
            }
            match (count, most > 0.0) {
                (0, _) => {}
                (_, true) => writeln!(out, "mapd: lanelet2: {count} {text} (at most {most:.3} m)")?,
                (_, false) => writeln!(out, "mapd: lanelet2: {count} {text}")?,
            }
        }
        for (what, count) in &self.unsaid {
            writeln!(out, "mapd: lanelet2: not said: {what} ({count})")?;
        }
        Ok(())
    }

    /// Writes all of it as CSV: what, lane, other lane, x and y `[m]`, metres, count.
    ///
    /// Errors: what writing gives.
    pub fn write(&self, out: &mut dyn Write) -> std::io::Result<()> {
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record(["what", "lane", "other", "x", "y", "metres", "count"])?;
        for line in &self.lines {
            let metres =
                line.entry.metres().map_or_else(String::new, |metres| format!("{metres:.4}"));
            let [x, y] = [line.place.x, line.place.y].map(|value| format!("{value:.3}"));
            csv.write_record([line.entry.name(), &line.from, &line.to, &x, &y, &metres, "1"])?;
        }
        for (what, count) in &self.unsaid {
            csv.write_record([what, "", "", "", "", "", &count.to_string()])?;
        }
        csv.flush()
    }
}
