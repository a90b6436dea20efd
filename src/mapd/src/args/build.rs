//! How a map is built.

use super::{FrameArgs, JudgingArgs, OntologyArgs, finite};
use crate::exit::UsageError;
use anyhow::{Context, Result};
use clap::{Args, ValueEnum, ValueHint};
use mapd_compiler::{CompileOptions, CyclePolicy, Extra, MarkReading, OffsetSign, ReadOptions};
use mapd_transport::read_regular;
use mapd_xodr::{LONGEST_PATCH, Patch, PatchedId};
use std::path::PathBuf;
use std::sync::Arc;

/// How a map is built.
#[derive(Args)]
pub(crate) struct BuildArgs {
    /// Largest distance of a lane's centre line from its polyline [m]
    #[arg(long, value_name = "M", default_value_t = CompileOptions::default().index_tolerance, value_parser = finite)]
    index_tolerance: f64,

    /// Largest distance of a lane's border from its polyline [m]
    #[arg(long, value_name = "M", default_value_t = CompileOptions::default().bound_tolerance, value_parser = finite)]
    bound_tolerance: f64,

    /// Largest distance at which an object or signal is attached to its nearest lane [m]
    #[arg(long, value_name = "M", default_value_t = CompileOptions::default().lane_reach, value_parser = finite)]
    lane_reach: f64,

    /// Landmarks for routing, 0 to 32: more make long routes faster and archives larger
    #[arg(long, value_name = "N", default_value_t = CompileOptions::default().landmarks, value_parser = clap::value_parser!(u8).range(0..=32))]
    landmarks: u8,

    /// Which cycles of the lane graph are errors
    #[arg(long, value_enum, default_value_t = Cycles::Illegal)]
    cycles: Cycles,

    /// Sign of the header's offset
    #[arg(long, value_enum, default_value_t = Sign::Auto)]
    offset_sign: Sign,

    /// How road marks without a laneChange are read
    #[arg(long, value_enum, default_value_t = Marks::Standard)]
    marks: Marks,

    /// Data to leave out of the archive; nothing else depends on it
    #[arg(long, value_name = "KIND", value_enum, value_delimiter = ',')]
    without: Vec<WithoutKind>,

    /// OpenDRIVE roads and junctions that take the place of the map's of the same ids, or are new (docs/overlay.md); of one map
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    patch: Option<PathBuf>,

    /// Road or junction to leave out, as road:ID or junction:ID; of one map
    #[arg(long, value_name = "ID")]
    remove: Vec<PatchedId>,

    #[command(flatten)]
    frame: FrameArgs,

    #[command(flatten)]
    ontology: OntologyArgs,
}

/// As [`Extra`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct WithoutKind(Extra);

impl ValueEnum for WithoutKind {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [WithoutKind; Extra::ALL.len()] = {
            let mut all = [WithoutKind(Extra::UserData); Extra::ALL.len()];
            let mut i = 0;
            while i < all.len() {
                all[i] = WithoutKind(Extra::ALL[i]);
                i += 1;
            }
            all
        };
        &ALL
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        Some(clap::builder::PossibleValue::new(self.0.name()))
    }
}

/// As [`OffsetSign`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Sign {
    /// As written, unless the file is known to have the opposite sign, or is possible only with it
    Auto,
    /// As written: added, as in the standard
    Standard,
    /// Negated: subtracted, as netconvert of Eclipse SUMO writes it
    Negated,
}

/// As [`MarkReading`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Marks {
    /// Lanes may be changed across them, as in the standard
    Standard,
    /// By their type: not across a solid line from its own side
    Type,
}

/// As [`CyclePolicy`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Cycles {
    /// Those that no network may have: within a junction, or of at most 1 m
    Illegal,
    /// All
    All,
    /// None: forbidden cycles are warnings, others information
    Report,
}

impl BuildArgs {
    fn compile(&self) -> CompileOptions {
        CompileOptions {
            index_tolerance: self.index_tolerance,
            bound_tolerance: self.bound_tolerance,
            lane_reach: self.lane_reach,
            landmarks: self.landmarks,
            cycles: match self.cycles {
                Cycles::Illegal => CyclePolicy::Illegal,
                Cycles::All => CyclePolicy::All,
                Cycles::Report => CyclePolicy::Report,
            },
            offset_sign: match self.offset_sign {
                Sign::Auto => OffsetSign::Auto,
                Sign::Standard => OffsetSign::Standard,
                Sign::Negated => OffsetSign::Negated,
            },
            marks: match self.marks {
                Marks::Standard => MarkReading::Standard,
                Marks::Type => MarkReading::Type,
            },
            crs: self.frame.crs.clone(),
            without: self.without.iter().map(|kind| kind.0).collect(),
        }
    }
}

impl BuildArgs {
    /// How a document is read, by these options and the rules that apply.
    pub(crate) fn reading(&self, judging: &JudgingArgs) -> Result<ReadOptions> {
        let mut reading = self.ontology.apply(judging.apply(ReadOptions::default())?)?;
        reading.patch = self.patched()?.map(Arc::new);
        Ok(reading)
    }

    /// Whether one map is meant, whose roads and junctions are changed.
    pub(crate) fn is_patched(&self) -> bool {
        self.patch.is_some() || !self.remove.is_empty()
    }

    fn patched(&self) -> Result<Option<Patch>> {
        if !self.is_patched() {
            return Ok(None);
        }
        let patch = Patch::removing(self.remove.clone());
        let Some(file) = &self.patch else { return Ok(Some(patch)) };
        let reading = || format!("patch {}", file.display());
        let text = read_regular(file, LONGEST_PATCH).with_context(reading)?;
        let patch = patch.with_document(file.clone(), text.into_bytes());
        Ok(Some(patch.map_err(|error| UsageError(error.to_string()))?))
    }

    /// How a map is built, by these options.
    pub(crate) fn validated(&self) -> Result<CompileOptions> {
        let options = self.compile();
        options.validate().map_err(|error| UsageError(error.to_string()))?;
        Ok(options)
    }
}
