//! How a document is read, and what shapes the output.

use crate::quarantine::Policy;
use crate::without::Without;
use mapd_geodesy::Target;
use mapd_xodr::{Limits, Patch};
use std::path::PathBuf;
use std::sync::Arc;
use thiserror::Error;

/// Default of [`CompileOptions::index_tolerance`] `[m]`.
const INDEX_TOLERANCE: f64 = 0.05;
/// Default of [`CompileOptions::bound_tolerance`] `[m]`.
const BOUND_TOLERANCE: f64 = 0.01;
/// Default of [`CompileOptions::lane_reach`] `[m]`: wider than half of any road with its verge.
const LANE_REACH: f64 = 30.0;
/// Reaches that make sense `[m]`: beyond, everything belongs to something.
const REACHES: std::ops::RangeInclusive<f64> = 0.0..=1000.0;
/// Default of [`CompileOptions::landmarks`].
const LANDMARKS: u8 = 16;
/// Landmarks that a search looks at.
pub(crate) const MOST_LANDMARKS: u8 = 32;
/// Tolerances that make sense `[m]`: below, single precision has no room; above, an index stops to be one.
const TOLERANCES: std::ops::RangeInclusive<f64> = 1e-3..=1.0;

/// What shapes the output; part of the archive's provenance.
#[derive(Clone, Debug, PartialEq)]
pub struct CompileOptions {
    /// Largest distance of a lane's centre line from its polyline `[m]`. Default 0.05.
    pub index_tolerance: f64,
    /// Largest distance of a lane's border from its polyline `[m]`. Default 0.01.
    pub bound_tolerance: f64,
    /// Largest distance in plan view of an object or signal from the lane that it belongs to because it is the nearest `[m]`.
    /// What names its lanes or stands on them belongs to these whatever the distance. Default 30.
    pub lane_reach: f64,
    /// Which cycles of the lane graph are errors. Default: those that no road network may have.
    pub cycles: CyclePolicy,
    /// Number of landmarks; more than 32 count as 32. More make routing over long ways faster and the archive larger.
    /// Default 16.
    pub landmarks: u8,
    /// Sign of the header's offset. Default: as written, unless only the other sign makes sense.
    pub offset_sign: OffsetSign,
    /// Frame that x, y and z are transformed into; s and t stay as written (docs/coordinates.md). Default: none, they stay
    /// those of the file.
    pub crs: Option<Target>,
    /// What is left out of the archive. Default: nothing.
    pub without: Without,
    /// How road marks without `laneChange` are read. Default: as the standard has it.
    pub marks: MarkReading,
}

/// Sign with which the header's offset is applied.
///
/// By the standard a point of the file lies at its turned coordinates plus the offset; netconvert of Eclipse SUMO writes the
/// offset that it has added itself, which must be subtracted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum OffsetSign {
    /// As written, unless the file is known to be, or can only be, one of the other sign.
    #[default]
    Auto,
    /// As written.
    Standard,
    /// Turned.
    Negated,
}

/// Which cycles of the lane graph are errors.
///
/// Lawful networks have cycles (blocks, roundabouts, ring roads); a cycle within the connecting roads of one junction,
/// or one of at most 1 m, is none of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum CyclePolicy {
    /// Cycles within a junction and cycles without length are errors; others are condensed.
    #[default]
    Illegal,
    /// Every cycle is an error: the graph must be acyclic, as that of a corridor is.
    All,
    /// No cycle is an error: forbidden ones are warnings, others information.
    Report,
}

/// How road marks without `laneChange` are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum MarkReading {
    /// As the standard has it: lanes may be changed to both sides.
    #[default]
    Standard,
    /// By their type: nobody crosses a solid line from its own side.
    Type,
}

/// What shapes rows while a document is read.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Lowering {
    pub(crate) without: Without,
    pub(crate) marks: MarkReading,
}

/// An option outside its range.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{name} must lie between {low} and {high} m, found {found}")]
pub struct OptionsError {
    name: &'static str,
    low: f64,
    high: f64,
    found: f64,
}

impl Default for CompileOptions {
    fn default() -> Self {
        Self {
            index_tolerance: INDEX_TOLERANCE,
            bound_tolerance: BOUND_TOLERANCE,
            lane_reach: LANE_REACH,
            cycles: CyclePolicy::default(),
            landmarks: LANDMARKS,
            offset_sign: OffsetSign::default(),
            crs: None,
            without: Without::default(),
            marks: MarkReading::default(),
        }
    }
}

impl CompileOptions {
    /// What of these shapes rows while the document is read.
    pub(crate) fn lowering(&self) -> Lowering {
        Lowering { without: self.without, marks: self.marks }
    }

    /// Refuses numbers out of range.
    pub fn validate(&self) -> Result<(), OptionsError> {
        let all = [
            ("index tolerance", self.index_tolerance, TOLERANCES),
            ("bound tolerance", self.bound_tolerance, TOLERANCES),
            ("lane reach", self.lane_reach, REACHES),
        ];
        match all.into_iter().find(|(_, value, range)| !range.contains(value)) {
            Some((name, found, range)) => {
                Err(OptionsError { name, low: *range.start(), high: *range.end(), found })
            }
            None => Ok(()),
        }
    }

    /// First bytes of the BLAKE3 of all options, as the header carries them.
    pub fn hash(&self) -> [u8; 8] {
        let mut hasher = blake3::Hasher::new();
        hasher.update(&self.index_tolerance.to_le_bytes());
        hasher.update(&self.bound_tolerance.to_le_bytes());
        hasher.update(&self.lane_reach.to_le_bytes());
        hasher.update(&[self.cycles as u8, self.landmarks.min(MOST_LANDMARKS)]);
        hasher.update(&[self.offset_sign as u8]);
        if !self.without.is_empty() {
            hasher.update(b"without");
            hasher.update(&self.without.bytes());
        }
        if self.marks != MarkReading::default() {
            hasher.update(b"marks by type");
        }
        if let Some(target) = &self.crs {
            hasher.update(target.text().as_bytes());
        }
        let mut out = [0; 8];
        out.copy_from_slice(&hasher.finalize().as_bytes()[..8]);
        out
    }
}

/// How a document is read and how its errors are handled. But for a patch, it never changes the tables of a map without errors.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// Bounds on what the document may ask for.
    pub limits: Limits,
    /// The folder that files may be included from; none: nothing is included, and a map that wants to is rejected.
    pub include_folder: Option<PathBuf>,
    /// Which rules apply, and how bad their findings are.
    pub rules: mapd_rules::Settings,
    /// How a map with errors is handled.
    pub policy: Policy,
    /// What signals and objects mean.
    pub ontology: mapd_ontology::Ontology,
    /// Bytes of text that a thread reads, checks and lowers at once, at least; none: 256 KiB in the first 8 MiB, then 512 KiB. It does not show in the archive.
    pub batch_bytes: Option<usize>,
    /// Roads and junctions that take the place of the document's; none: it is read as it is.
    pub patch: Option<Arc<Patch>>,
}

impl ReadOptions {
    /// First bytes of the BLAKE3 of all that shapes an archive, as its header carries them.
    pub fn hash(&self, options: &CompileOptions) -> [u8; 8] {
        let tables = self.ontology.user_texts();
        let plain = self.rules == mapd_rules::Settings::default();
        if plain && self.policy == Policy::default() && tables.is_empty() && self.patch.is_none() {
            return options.hash();
        }
        let mut hasher = blake3::Hasher::new();
        hasher.update(&options.hash());
        // Both are plain values with names, the same in every build of one version.
        hasher.update(format!("{:?} {:?}", self.rules, self.policy).as_bytes());
        for text in tables {
            hasher.update(blake3::hash(text.as_bytes()).as_bytes());
        }
        for part in self.patch.iter().flat_map(|patch| patch.bytes()) {
            hasher.update(b"patch").update(blake3::hash(&part).as_bytes());
        }
        let mut out = [0; 8];
        out.copy_from_slice(&hasher.finalize().as_bytes()[..8]);
        out
    }
}
