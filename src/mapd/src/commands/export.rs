//! `mapd export`: a map drawn or converted, by `mapd-export`.

use crate::args::{OpenedSource, Opening, ProgressArgs};
use crate::draft;
use crate::exit::{Exit, UsageError};
use crate::findings;
use crate::progress::Meter;
use crate::same_file::is_same_file;
use crate::source::{Source, say_without_overlay};
use anyhow::{Result, bail};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use mapd_client::Snapshot;
use mapd_export::{
    ExportError, Findings, Format, Layer, LeftOut, Options, Origin, RouteEnds, write,
};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What to write of which map.
#[derive(Args)]
pub(crate) struct ExportCommand {
    /// .xodr, .mapd or shm:NAME
    source: Source,
    /// Output format
    #[arg(long, value_parser = one_of(Format::ALL, Format::name, Format::about))]
    format: Format,
    /// File to write [default: stdout]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// svg: also the boxes of the spatial index
    #[arg(long)]
    index_boxes: bool,
    /// svg: also the driven line of a passenger car's shortest route
    #[arg(long, value_name = "ROAD,S,LANE:ROAD,S,LANE", allow_hyphen_values = true)]
    route: Option<RouteEnds>,
    /// geojson, flatgeobuf: layers to write [default: all]
    #[arg(long, value_name = "LAYER,…", value_delimiter = ',', value_parser = one_of(&Layer::ALL, Layer::name, Layer::about))]
    layers: Vec<Layer>,
    /// geojson, lanelet2: where the point 0, 0 of a map without a georeference is to lie [deg]
    #[arg(long, value_name = "LAT,LON", allow_hyphen_values = true)]
    origin: Option<Origin>,
    /// lanelet2: also what Autoware reads and Lanelet2's own loader refuses
    #[arg(long)]
    autoware: bool,
    /// lanelet2: CSV file that lists what is not in OUT as it is in the map
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    #[command(flatten)]
    progress: ProgressArgs,
    #[command(flatten)]
    opening: Opening,
}

/// An option that only some formats have.
struct OptionOfFormats {
    name: &'static str,
    is_given: bool,
    formats: &'static [Format],
}

impl ExportCommand {
    /// Writes the map.
    ///
    /// Errors: wrong usage, such as an option that the format does not have; the source cannot be opened; as [`write`]; a file cannot be written.
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let output = self.output.as_deref();
        let is_source = |file: &Path| self.source.file().is_some_and(|own| is_same_file(file, own));
        if let Some(output) = output.filter(|file| is_source(file)) {
            bail!(UsageError(format!("{} would overwrite its source", output.display())));
        }
        let is_other = |report: &Path| {
            is_source(report) || output.is_some_and(|output| is_same_file(report, output))
        };
        if self.report.as_deref().is_some_and(is_other) {
            let message = "the report would overwrite the map; name another file with --report";
            bail!(UsageError(message.to_owned()));
        }
        self.check_format()?;
        let manner = self.progress.manner();
        let opened = self.opening.open_with_findings(&self.source, manner)?;
        let Some(OpenedSource { snapshot, compilation }) = opened else {
            return Ok(Exit::Rejected);
        };
        if self.format == Format::Lanelet2 {
            say_without_overlay(&snapshot, "mapd");
        }
        let title = self.source.title();
        let findings = match self.format {
            Format::Html => findings::of(&snapshot, compilation.as_deref()),
            _ => Findings::UNKNOWN,
        };
        let Self { index_boxes, route, layers, origin, autoware, .. } = self;
        let options = Options { index_boxes, route, layers, origin, autoware, title, findings };
        let name = output.map_or_else(|| self.format.name().into(), Path::to_string_lossy);
        let meter = Meter::new(&name, 0, manner);
        let to = |out: &mut dyn Write| to_writer(&snapshot, self.format, &options, &meter, out);
        let left_out = match output {
            Some(path) => draft::write_by(path, to)?,
            None => to(out)?,
        };
        meter.finish();
        tell(&left_out, self.report.as_deref())?;
        Ok(Exit::Done)
    }

    /// The options that only some formats have.
    fn options_of_formats(&self) -> [OptionOfFormats; 6] {
        use Format::{FlatGeobuf, GeoJson, Lanelet2, Svg};
        let one = |name, is_given, formats| OptionOfFormats { name, is_given, formats };
        [
            one("--index-boxes", self.index_boxes, &[Svg]),
            one("--route", self.route.is_some(), &[Svg]),
            one("--layers", !self.layers.is_empty(), &[GeoJson, FlatGeobuf]),
            one("--origin", self.origin.is_some(), &[GeoJson, Lanelet2]),
            one("--autoware", self.autoware, &[Lanelet2]),
            one("--report", self.report.is_some(), &[Lanelet2]),
        ]
    }

    /// Errors: an option that the format does not have.
    fn check_format(&self) -> Result<()> {
        let unfit = |one: &OptionOfFormats| one.is_given && !one.formats.contains(&self.format);
        let Some(option) = self.options_of_formats().into_iter().find(unfit) else { return Ok(()) };
        let formats: Vec<&str> = option.formats.iter().map(|format| format.name()).collect();
        bail!(UsageError(format!(
            "{} goes with --format {}, not with {}",
            option.name,
            formats.join(" or "),
            self.format.name()
        )))
    }
}

/// Writes a map, and shows how far that is.
///
/// Errors: as [`write`].
fn to_writer(
    snapshot: &Snapshot,
    format: Format,
    options: &Options,
    meter: &Meter,
    out: &mut dyn Write,
) -> Result<LeftOut> {
    let mut show = |progress: mapd_export::Progress| {
        meter.stage(|| match progress.done {
            0 => format!("writing {}", progress.doing),
            done => format!("writing {}, {done} so far", progress.doing),
        });
    };
    write(snapshot, format, options, &mut show, out).map_err(|error| match error {
        // As itself, so that a closed pipe is known as one.
        ExportError::Io(error) => error.into(),
        other => other.into(),
    })
}

/// Says on stderr what the format cannot hold, and writes Lanelet2's report to a file where there is one.
///
/// Errors: the file cannot be written.
fn tell(left_out: &LeftOut, file: Option<&Path>) -> Result<()> {
    // A closed stderr is nobody's loss.
    if left_out.features > 0 {
        let _ = writeln!(
            io::stderr(),
            "mapd: {} features without a place are left out: this format cannot hold them",
            left_out.features
        );
    }
    let Some(report) = &left_out.report else { return Ok(()) };
    let _ = report.summary(&mut io::stderr());
    match file {
        Some(path) => draft::write_by(path, |out| Ok(report.write(out)?)),
        None => Ok(()),
    }
}

/// Takes one of these, by its name.
fn one_of<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    name: fn(T) -> &'static str,
    about: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let values = all.iter().map(|one| PossibleValue::new(name(*one)).help(about(*one)));
    PossibleValuesParser::new(values.collect::<Vec<_>>()).try_map(move |text| {
        let named = all.iter().copied().find(|one| name(*one) == text);
        named.ok_or_else(|| format!("{text:?} is none of them"))
    })
}
