//! Everything that is known of a thing, as a sheet of facts with links to others.

mod lane;
mod other;

use mapd_query::compiling::ByRow as _;
use mapd_query::objects::Object;
use mapd_query::signals::Signal;
use mapd_query::view::{OverlayEntry, View};
use mapd_query::vocabulary::QuarantinedKind;
use mapd_query::{Junction, Lane, Road};
use serde::Serialize;

/// What a sheet can be about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[repr(u8)]
pub enum Kind {
    /// A lane, by its row.
    Lane,
    /// A road.
    Road,
    /// A junction.
    Junction,
    /// A signal.
    Signal,
    /// An object.
    Object,
    /// A part that is left out.
    Quarantine,
}

impl Kind {
    /// All, by number.
    pub const ALL: &[Self] =
        &[Self::Lane, Self::Road, Self::Junction, Self::Signal, Self::Object, Self::Quarantine];
}

/// A thing of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Link {
    /// What it is.
    pub kind: Kind,
    /// Its row in the archive's table.
    pub row: u32,
}

/// A text, and the thing that it names.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Words {
    /// What is read.
    pub text: String,
    /// What it leads to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub link: Option<Link>,
}

/// One fact.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fact {
    /// Its name.
    pub name: &'static str,
    /// What is known.
    pub values: Vec<Words>,
}

/// What is known of a thing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sheet {
    /// The thing.
    pub about: Link,
    /// Its name.
    pub title: String,
    /// The facts.
    pub facts: Vec<Fact>,
    /// Smallest x and y and largest x and y of where it lies `[m]`, if that is known.
    pub bounds: Option<[f64; 4]>,
}

impl Sheet {
    /// The sheet of a thing; none where the map has no such thing.
    pub fn of(view: View<'_>, about: Link) -> Option<Self> {
        let map = view.map();
        match about.kind {
            Kind::Lane => map.lane_by_row(about.row).map(|lane| lane::sheet(view, &lane)),
            Kind::Road => map.road_by_row(about.row).map(|road| other::road(&road)),
            Kind::Junction => map.junction_by_row(about.row).map(|one| other::junction(&one)),
            Kind::Signal => {
                map.signals().nth(about.row as usize).map(|one| other::signal(view, &one))
            }
            Kind::Object => map.objects().nth(about.row as usize).map(|one| other::object(&one)),
            Kind::Quarantine => {
                map.quarantined().nth(about.row as usize).map(|one| other::quarantine(&one, about))
            }
        }
    }

    fn new(about: Link, title: String) -> Self {
        Self { about, title, facts: Vec::new(), bounds: None }
    }

    /// Adds a fact; one of which nothing is known is left out.
    fn add(&mut self, name: &'static str, values: impl IntoIterator<Item = Words>) {
        let values: Vec<Words> = values.into_iter().filter(|one| !one.text.is_empty()).collect();
        if !values.is_empty() {
            self.facts.push(Fact { name, values });
        }
    }

    fn say(&mut self, name: &'static str, text: impl Into<String>) {
        self.add(name, [Words { text: text.into(), link: None }]);
    }

    fn reach(&mut self, point: mapd_query::glam::DVec3) {
        let [a, b, c, d] = self.bounds.unwrap_or([point.x, point.y, point.x, point.y]);
        self.bounds = Some([a.min(point.x), b.min(point.y), c.max(point.x), d.max(point.y)]);
    }
}

/// A length, to a centimetre.
fn metres(length: f64) -> String {
    format!("{length:.2} m")
}

/// A speed as roads have it.
fn speed(speed: f64) -> String {
    if speed.is_infinite() {
        return "no limit".to_owned();
    }
    let per_hour = 3.6 * speed;
    format!("{} km/h ({speed:.2} m/s)", (per_hour * 10.0).round() / 10.0)
}

impl From<&Lane<'_>> for Words {
    fn from(lane: &Lane<'_>) -> Self {
        let link = Link { kind: Kind::Lane, row: lane.lane_id().row() };
        Self { text: lane.key().to_string(), link: Some(link) }
    }
}

impl From<&Road<'_>> for Words {
    fn from(road: &Road<'_>) -> Self {
        let link = Link { kind: Kind::Road, row: road.road_id().row() };
        let (id, name) = (road.id(), road.name());
        let text = if name.is_empty() { id.to_owned() } else { format!("{id} “{name}”") };
        Self { text, link: Some(link) }
    }
}

impl From<&Junction<'_>> for Words {
    fn from(junction: &Junction<'_>) -> Self {
        let link = Link { kind: Kind::Junction, row: junction.junction_id().row() };
        let (id, name) = (junction.id(), junction.name());
        let text = if name.is_empty() { id.to_owned() } else { format!("{id} “{name}”") };
        Self { text, link: Some(link) }
    }
}

impl From<&Signal<'_>> for Words {
    fn from(signal: &Signal<'_>) -> Self {
        let link = Link { kind: Kind::Signal, row: signal.signal_id().row() };
        Self { text: format!("{} {}", signal.id(), signal.class().name()), link: Some(link) }
    }
}

impl From<&Object<'_>> for Words {
    fn from(object: &Object<'_>) -> Self {
        let link = Link { kind: Kind::Object, row: object.object_id().row() };
        Self { text: format!("{} {}", object.id(), object.class().name()), link: Some(link) }
    }
}

impl From<OverlayEntry<'_>> for Words {
    fn from(entry: OverlayEntry<'_>) -> Self {
        let mut text = format!("{}: {}", entry.id(), entry.kind().name());
        if let Some(value) = entry.value() {
            text += &format!(" {}", speed(value));
        }
        for (before, said) in [("“", entry.text()), ("from “", entry.source())] {
            if !said.is_empty() {
                text += &format!(", {before}{said}”");
            }
        }
        Self { text, link: None }
    }
}

impl Words {
    /// With more words behind.
    fn with(mut self, more: &str) -> Self {
        self.text.push_str(more);
        self
    }

    fn part(number: usize, kind: QuarantinedKind, id: &str) -> Self {
        let link = Link { kind: Kind::Quarantine, row: number as u32 };
        Self { text: format!("{} {id}", kind.name()), link: Some(link) }
    }
}
