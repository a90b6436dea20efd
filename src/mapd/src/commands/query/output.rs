//! How answers are written: CSV, or one JSON array with an object for each row.

use clap::{Args, ValueEnum};
use std::io::{self, Write};

/// How answers are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A header row and a row for each answer.
    #[default]
    Csv,
    /// An array with an object for each answer: numbers as numbers, empty values as null.
    Json,
}

/// In which format a command writes its answers.
#[derive(Args)]
pub(in crate::commands) struct FormatArgs {
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    format: Format,
    /// Print JSON: as --format json
    #[arg(long, conflicts_with = "format")]
    json: bool,
}

impl FormatArgs {
    /// The format that is wanted.
    pub(in crate::commands) fn get(&self) -> Format {
        if self.json { Format::Json } else { self.format }
    }
}

/// Columns that hold numbers; what any other one holds is text, also where it looks like a number.
const NUMBERS: &[&str] = &[
    "x",
    "y",
    "z",
    "h",
    "hdg",
    "s",
    "t",
    "S",
    "d",
    "nx",
    "ny",
    "nz",
    "lat",
    "lon",
    "alt",
    "friction",
    "roughness",
    "width",
    "height",
    "t_inner",
    "t_outer",
    "lane_id",
    "offset",
    "distance",
    "radius",
    "length",
    "exact",
    "from_s",
    "from_lane",
    "to_s",
    "to_lane",
    "lane_changes",
    "curvature",
    "left",
    "right",
    "forward",
    "back",
    "speed",
    "left_x",
    "left_y",
    "right_x",
    "right_y",
    "left_may_cross",
    "right_may_cross",
    "heading_difference",
    "mahalanobis",
    "S_from",
    "S_to",
    "other_s_from",
    "other_s_to",
    "wait_S",
    "line",
    "column",
    "probability",
    "level",
    "painted",
    "time",
    "sx",
    "sy",
    "shdg",
];

pub(in crate::commands) enum Output<W: Write> {
    Csv(Box<csv::Writer<W>>),
    Json { out: W, columns: Vec<String>, rows: usize },
}

impl<W: Write> Output<W> {
    pub(in crate::commands) fn new(format: Format, out: W) -> Self {
        match format {
            Format::Csv => Self::Csv(Box::new(csv::Writer::from_writer(out))),
            Format::Json => Self::Json { out, columns: Vec::new(), rows: 0 },
        }
    }

    /// Names the columns.
    pub(in crate::commands) fn head<'r>(
        &mut self,
        names: impl Iterator<Item = &'r str>,
    ) -> Result<(), csv::Error> {
        match self {
            Self::Csv(writer) => writer.write_record(names),
            Self::Json { out, columns, .. } => {
                *columns = names.map(str::to_owned).collect();
                Ok(out.write_all(b"[")?)
            }
        }
    }

    /// Writes a row.
    pub(in crate::commands) fn row<'r>(
        &mut self,
        values: impl Iterator<Item = &'r str>,
    ) -> Result<(), csv::Error> {
        match self {
            Self::Csv(writer) => writer.write_record(values),
            Self::Json { out, columns, rows } => {
                out.write_all(if *rows == 0 { b"\n{" } else { b",\n{" })?;
                *rows += 1;
                for (i, (name, value)) in columns.iter().zip(values).enumerate() {
                    let comma = if i == 0 { "" } else { "," };
                    write!(out, "{comma}{}:{}", quoted(name), json(name, value))?;
                }
                Ok(out.write_all(b"}")?)
            }
        }
    }

    pub(in crate::commands) fn finish(self) -> io::Result<()> {
        match self {
            Self::Csv(mut writer) => writer.flush(),
            Self::Json { mut out, .. } => {
                out.write_all(b"\n]\n")?;
                out.flush()
            }
        }
    }
}

/// A value as JSON: a number where it is one, null where it is empty.
fn json(name: &str, value: &str) -> String {
    if value.is_empty() {
        return "null".to_owned();
    }
    let is_number = NUMBERS.contains(&name) && value.parse::<f64>().is_ok_and(f64::is_finite);
    match serde_json::from_str::<serde_json::Number>(value) {
        Ok(_) if is_number => value.to_owned(),
        _ => quoted(value),
    }
}

fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
