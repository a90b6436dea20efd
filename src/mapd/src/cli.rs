//! The command line.

use crate::change::ChangeArgs;
use crate::compile::{self, CompileCommand};
use crate::compile_args::CompileArguments;
use crate::control::Request;
use crate::daemon::{self, DaemonArgs};
use crate::exit::Exit;
use crate::judging::JudgingArgs;
use crate::number::{Seconds, finite, not_negative};
use crate::ontology_args::OntologyArgs;
use crate::oversight::OversightArgs;
use crate::progress::ProgressArgs;
use crate::query::{self, Kind};
use crate::same_file::is_same_file;
use crate::size::Size;
use crate::threads::ThreadsArg;
use crate::trust::{TrustArgs, is_distrust};
use crate::{bench, check, doctor, export, inspect, sign, source, status};
use anyhow::{Context, Result, bail};
use clap::{ArgMatches, Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};
use mapd_client::{Domain, LaneType, LaneTypes, NearestOptions, Snapshot};
use mapd_compiler::{CompileOptions, CyclePolicy, Extra, OffsetSign, ReadOptions, Target};
use std::io::{self, BufWriter, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;

/// Compile OpenDRIVE maps once and serve them to every process from shared memory.
///
/// `mapd --load map.xodr` compiles and checks the map, publishes it under the name `map` and serves until SIGINT or
/// SIGTERM. Other processes read it in place: with the crate mapd-client, or here with `mapd query shm:map …`.
#[derive(Parser)]
#[command(version, args_conflicts_with_subcommands = true, after_help = EXIT_CODES)]
struct Cli {
    #[command(flatten)]
    daemon: DaemonArgs,

    #[command(flatten)]
    options: Options,

    #[command(flatten)]
    judging: JudgingArgs,

    #[command(flatten)]
    trust: TrustArgs,

    #[command(flatten)]
    oversight: OversightArgs,

    #[command(flatten)]
    domain: DomainArgs,

    #[command(subcommand)]
    command: Option<Command>,
}

/// Name of the command that compiles.
const COMPILE: &str = "compile";

const EXIT_CODES: &str = "Exit codes: 0 done and accepted, 3 accepted with quarantined parts, 4 map rejected, 2 wrong usage, 1 the environment failed.";

#[derive(Args)]
pub(crate) struct Options {
    /// Largest distance of a lane's centre line from its polyline [m]
    #[arg(long, value_name = "M", default_value_t = CompileOptions::default().index_tolerance, value_parser = finite)]
    index_tolerance: f64,

    /// Largest distance of a lane's border from its polyline [m]
    #[arg(long, value_name = "M", default_value_t = CompileOptions::default().bound_tolerance, value_parser = finite)]
    bound_tolerance: f64,

    /// Largest distance of an object or signal from a lane that it belongs to as the nearest [m]
    #[arg(long, value_name = "M", default_value_t = CompileOptions::default().lane_reach, value_parser = finite)]
    lane_reach: f64,

    /// Landmarks for routing, 0 to 32: more are faster over long ways and larger
    #[arg(long, value_name = "N", default_value_t = CompileOptions::default().landmarks, value_parser = clap::value_parser!(u8).range(0..=32))]
    landmarks: u8,

    /// Which cycles of the lane graph are errors
    #[arg(long, value_enum, default_value_t = Cycles::Illegal)]
    cycles: Cycles,

    /// Sign of the header's offset
    #[arg(long, value_enum, default_value_t = Sign::Auto)]
    offset_sign: Sign,

    /// What is left out of the archive: nothing else in it depends on these
    #[arg(long, value_name = "KIND", value_enum, value_delimiter = ',')]
    without: Vec<WithoutKind>,

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

#[derive(Args)]
struct FrameArgs {
    /// Frame that x, y and z are transformed into: an EPSG code, PROJ parameters, `utm` (the zone of the map's middle) or
    /// enu:LAT,LON[,ALT] (east and north of that place); s and t stay as written [default: the file's own frame]
    #[arg(long, value_name = "CRS")]
    crs: Option<Target>,
}

impl FrameArgs {
    /// Options for a SOURCE that is compiled if it is an OpenDRIVE file.
    ///
    /// Errors: a frame is asked for, but the source is compiled already.
    fn source(&self, source: &str) -> Result<CompileOptions> {
        if self.crs.is_some() && source::is_compiled(source) {
            let message = format!(
                "--crs transforms OpenDRIVE files only; {source} keeps the frame it was compiled into"
            );
            return Err(UsageError(message).into());
        }
        Ok(CompileOptions { crs: self.crs.clone(), ..CompileOptions::default() })
    }
}

/// As [`OffsetSign`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Sign {
    /// As written, unless the file is known to be, or can only be, one of the other sign
    Auto,
    /// As written: added, as the standard has it
    Standard,
    /// Turned: subtracted, as netconvert of Eclipse SUMO writes it
    Negated,
}

/// As [`CyclePolicy`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Cycles {
    /// Those that no network may have: within a junction, or without length
    Illegal,
    /// All
    All,
    /// None: forbidden ones are warnings, the others information
    Report,
}

#[derive(Args)]
pub(crate) struct DomainArgs {
    /// Prefix of everything in shared memory; daemons and clients meet where it is equal (letters and digits, one _ at the end) [default: mapd_]
    #[arg(long, env = "MAPD_PREFIX", value_name = "PREFIX")]
    prefix: Option<String>,
}

/// How a SOURCE is opened.
#[derive(Args)]
struct Opening {
    #[command(flatten)]
    frame: FrameArgs,

    #[command(flatten)]
    ontology: OntologyArgs,

    #[command(flatten)]
    trust: TrustArgs,

    #[command(flatten)]
    live: Live,

    #[command(flatten)]
    attach: AttachArgs,
}

/// How live maps are attached to.
#[derive(Args)]
struct AttachArgs {
    /// shm:NAME: how to attach; a subscriber takes part in iceoryx2, an observer writes nothing
    #[arg(long, value_enum, value_name = "HOW", default_value_t = source::How::Observer)]
    attach: source::How,
}

/// Where live maps are.
#[derive(Args)]
struct Live {
    #[command(flatten)]
    domain: DomainArgs,

    /// shm:NAME: longest wait for daemon and map [s]
    #[arg(long, value_name = "S", default_value_t = Seconds(source::WAIT))]
    wait: Seconds,
}

impl Live {
    fn get(&self) -> Result<(Domain, Duration)> {
        Ok((self.domain.domain()?, self.wait.0))
    }
}

impl Opening {
    /// Opens a SOURCE; prints why there is no map where there is none.
    fn open(&self, source: &str) -> Result<Option<Snapshot>> {
        let (domain, wait) = self.live.get()?;
        let reading = self.ontology.for_source(source::is_compiled(source))?;
        let options = self.frame.source(source)?;
        let compiling = (&reading, &options);
        source::open_or_report(
            source,
            compiling,
            self.trust.key()?,
            (&domain, self.attach.attach.into(), wait),
        )
    }
}

#[derive(Subcommand)]
enum Command {
    /// Compile OpenDRIVE files into archives
    #[command(name = COMPILE, after_help = compile::HELP)]
    Compile(Box<CompileCommand>),
    /// Say everything that is wrong with an OpenDRIVE file, without building the map
    #[command(after_help = CHECK_HELP)]
    Check {
        /// OpenDRIVE file (.xodr or .xodrz)
        file: PathBuf,
        /// How findings are written
        #[arg(long, value_enum, default_value_t = check::Format::Text)]
        format: check::Format,
        #[command(flatten)]
        frame: FrameArgs,
        #[command(flatten)]
        reading: Box<check::ReadArgs>,
        #[command(flatten)]
        threads: ThreadsArg,
        #[command(flatten)]
        progress: ProgressArgs,
    },
    /// Show what a map holds
    Inspect {
        /// .xodr, .mapd or shm:NAME
        source: String,
        /// As JSON
        #[arg(long)]
        json: bool,
        /// Prove the content hash and every row first
        #[arg(long)]
        verify: bool,
        #[command(flatten)]
        opening: Opening,
    },
    /// Answer questions: CSV with a header row from stdin to stdout
    #[command(after_help = QUERY_HELP)]
    Query {
        /// .xodr, .mapd or shm:NAME
        source: String,
        /// What is asked
        #[arg(value_enum)]
        kind: Kind,
        /// nearest: largest distance from a lane's area; nearest-marks: from a mark [m]
        #[arg(long, value_name = "M", default_value_t = NearestOptions::default().radius, value_parser = not_negative)]
        radius: f64,
        /// nearest, match, nearest-marks: lane types that count, separated by commas, or `drivable` [default: all]
        #[arg(long, value_name = "TYPES", value_delimiter = ',')]
        types: Vec<String>,
        /// nearest, match: largest difference in z [m], where the input has z
        #[arg(long, value_name = "M", value_parser = not_negative)]
        z_tolerance: Option<f64>,
        /// nearest: largest difference from the lane's driving direction [rad], where the input has hdg
        #[arg(long, value_name = "RAD", value_parser = not_negative)]
        heading_tolerance: Option<f64>,
        #[command(flatten)]
        route: query::RouteArgs,
        /// How answers are written
        #[arg(long, value_enum, default_value_t = query::Format::Csv)]
        format: query::Format,
        #[command(flatten)]
        opening: Opening,
    },
    /// Say which lanes a recorded trace was driven in: CSV with a header row from stdin to stdout
    #[command(after_help = MATCH_HELP)]
    Match {
        /// .xodr, .mapd or shm:NAME
        source: String,
        #[command(flatten)]
        trace: query::trace::TraceArgs,
        #[command(flatten)]
        opening: Opening,
    },
    /// Draw or convert a map
    Export {
        /// .xodr, .mapd or shm:NAME
        source: String,
        /// What to write
        #[arg(long, value_enum)]
        format: export::Format,
        /// File to write [default: stdout]
        #[arg(short, long, value_name = "OUT")]
        output: Option<PathBuf>,
        /// svg: also the boxes of the spatial index
        #[arg(long)]
        index_boxes: bool,
        /// svg: also the driven line of the shortest way of a passenger car
        #[arg(long, value_name = "ROAD,S,LANE:ROAD,S,LANE", allow_hyphen_values = true)]
        route: Option<export::RouteEnds>,
        /// geojson, flatgeobuf: layers that are written [default: all]
        #[arg(long, value_name = "LAYER,…", value_enum, value_delimiter = ',')]
        layers: Vec<export::Layer>,
        #[command(flatten)]
        opening: Opening,
    },
    /// List the maps that are served
    Status {
        /// As JSON: also sources, counts, memory, what is staged, what became of the last reload
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        domain: DomainArgs,
    },
    /// Measure attaching and querying on this machine, beside open and mmap of the same bytes
    Bench {
        #[command(flatten)]
        bench: bench::BenchArgs,
        #[command(flatten)]
        live: Live,
        #[command(flatten)]
        attach: AttachArgs,
    },
    /// Examine this machine and what is served: memory, limits, stale files, versions, rights, attaching
    #[command(after_help = "Ends with 0 where nothing is a problem, else with 1.")]
    Doctor {
        #[command(flatten)]
        doctor: doctor::DoctorArgs,
        #[command(flatten)]
        live: Live,
    },
    /// Sign archives with Ed25519, in minisign's format; --trust then refuses all others
    Sign(sign::SignArgs),
    #[command(name = bench::SUBCOMMAND, hide = true)]
    BenchClient {
        #[command(flatten)]
        client: bench::ClientArgs,
        #[command(flatten)]
        domain: DomainArgs,
    },
    /// Have the daemon compile a map's file again and serve it; what is served stays if that fails
    Reload {
        #[command(flatten)]
        change: ChangeArgs,
        /// Leave it for `mapd activate`; clients see it as pending
        #[arg(long)]
        stage: bool,
    },
    /// Have the daemon serve the generation before again, under a new number
    Rollback {
        #[command(flatten)]
        change: ChangeArgs,
        /// Leave it for `mapd activate`; clients see it as pending
        #[arg(long)]
        stage: bool,
    },
    /// Have the daemon serve what is staged
    Activate {
        #[command(flatten)]
        change: ChangeArgs,
    },
}

const CHECK_HELP: &str = "\
An error says that the file violates the standard; parts are left out only for errors that say so, because what they are
built from is missing or unusable. Ends with 0 where the map would be accepted, with 3 where parts of it would be left
out, with 4 where it would be rejected.";

const MATCH_HELP: &str = "\
In: time [s] and x,y[,z] or lat,lon[,alt], in the order of time; hdg where it is known. Out: lane,s,offset (from the lane's centre, positive to
the left of the reference line) and the probability of the lane given the whole trace; lane is empty where the trace is on none.

  mapd match map.xodr --deviation 2 < trace.csv";

const QUERY_HELP: &str = "\
Columns:
  inertial    road_id,s,t[,h]      x,y,z,hdg (h = 0 is the plane rolled by superelevation)
  surface     road_id,s,t          x,y,z,nx,ny,nz,friction,roughness: point and normal of the surface, the lane's material
  lane        road_id,s,lane_id    width,t_inner,t_outer,x,y,z,hdg of the lane's centre on that plane
  nearest     x,y[,z][,hdg] or lat,lon[,alt][,hdg]
                                   lane,road_id,lane_id,s,t,offset,distance
  match       x,y,hdg,sx,sy,shdg[,z]
                                   a row for each lane that the pose may be in, by standard deviations of x, y and hdg, and one
                                   with an empty lane for none: lane,direction (+ along s, - against it),probability,s,offset,
                                   heading_difference
  ground      x,y[,z]              z,nx,ny,nz of the surface there,lane,material,level (0 the lowest; the one nearest to z)
  nearest-marks  x,y               distance,side (where the mark lies, looking along the reference line),kind,color,lane,s,
                                   painted (1, or 0 in a gap) of the nearest road mark
  geodetic    x,y[,z]              lat,lon,alt
  from-geodetic  lat,lon[,alt]     x,y,z
  track       road_id,x,y[,z]      s,t,h (h only with z)
  successors  road_id,s,lane_id    successors in driving direction, joined by ;
  route       from_road,from_s,from_lane,to_road,to_s,to_lane
                                   length,lane_changes,lanes (keys in driving order, joined by ;)
  objects     x,y,radius           a row for each place of an object, the nearest first:
                                   id,class,distance,road_id,s,t,x,y,z,value
  landmarks   x,y,radius[,classes] a row for each signal or object that localisers use, or of these classes (joined by ;):
                                   id,class,distance,road_id,s,t,x,y,z,hdg,length,width,height,kind (signal or object)
  signals     road_id,s,lane_id,distance
                                   a row for each signal ahead, the nearest first, none where there is none:
                                   id,class,distance,road_id,s,t,x,y,z,state_machine,method,value (state_machine:
                                   lamps:phases[:movements]; method: how it came to the lane; value in m/s, m or kg)
  annotations owner[,id]           a row for each thing that the file says of it besides: kind,path,name,value,text,file,line,column;
                                   owner is document, road, section (id road:section), lane (a key), junction, object, signal,
                                   controller, junction-group or station
  visibility  road_id,s,lane_id    forward,back,left,right: how far one sees, empty where not given
  lane-rule   road_id,s,lane_id    rule in words
  junction-groups  junction_id     a row for each group of the junction: group,name,type,junctions,ring (joined by ;)
Metres and radians; latitudes and longitudes on WGS 84 in degrees. A row that has no answer says why in the column `error`; the command still ends with 0.

  printf 'x,y\\n12.5,-3\\n' | mapd query map.xodr nearest";

impl Options {
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
            crs: self.frame.crs.clone(),
            without: self.without.iter().map(|kind| kind.0).collect(),
        }
    }
}

impl Options {
    /// How a document is read, by these options and the rules that apply.
    pub(crate) fn reading(&self, judging: &JudgingArgs) -> Result<ReadOptions> {
        self.ontology.apply(judging.apply(ReadOptions::default())?)
    }

    /// How a map is built, by these options.
    pub(crate) fn validated(&self) -> Result<CompileOptions> {
        let options = self.compile();
        options.validate().map_err(|error| UsageError(error.to_string()))?;
        Ok(options)
    }
}

impl DomainArgs {
    pub(crate) fn domain(&self) -> Result<Domain> {
        let domain = match &self.prefix {
            Some(prefix) => Domain::new(prefix),
            None => Domain::from_env(),
        };
        domain.map_err(|error| UsageError(error.to_string()).into())
    }
}

/// The command line itself: commands, options and their help, to be looked at or completed.
pub fn command() -> clap::Command {
    Cli::command()
}

/// Runs the program with the process's arguments.
pub fn run() -> ExitCode {
    crate::allocator::give_back();
    survive_file_limits();
    match execute(&command().get_matches()) {
        Ok(exit) => exit.into(),
        // The reader of our output has gone: nobody is left to be told.
        Err(error) if is_broken_pipe(&error) => Exit::Done.into(),
        Err(error) => {
            let _ = writeln!(io::stderr(), "mapd: {error:#}");
            let exit = match error {
                error if error.is::<UsageError>() => Exit::Usage,
                error if is_distrust(&error) => Exit::Rejected,
                _ => Exit::Environment,
            };
            exit.into()
        }
    }
}

/// Has a write beyond the limit of file sizes (`ulimit -f`) fail with an error, as one to a full disk does; without a handler
/// SIGXFSZ ends the process.
fn survive_file_limits() {
    // Where it cannot be had, all is as it would be without.
    let _ = signal_hook::flag::register(libc::SIGXFSZ, Arc::default());
}

/// Address space that must be left at the start where it is limited \[bytes\]: with less, the C library ends a thread that it
/// cannot register by SIGABRT.
const LEAST_ROOM: usize = 16 << 20;

/// Looks for room to work in where the address space is limited (`ulimit -v`).
///
/// Errors: there is none.
fn check_room() -> Result<()> {
    if rustix::process::getrlimit(rustix::process::Resource::As).current.is_some() {
        let room = memmap2::MmapMut::map_anon(LEAST_ROOM);
        drop(room.with_context(|| {
            format!(
                "{} of address space are not left; raise the limit (`ulimit -v`)",
                Size(LEAST_ROOM as u64)
            )
        })?);
    }
    Ok(())
}

/// Wrong usage that only shows while running.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub(crate) struct UsageError(pub(crate) String);

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        let io = cause.downcast_ref::<io::Error>();
        io.is_some_and(|e| e.kind() == io::ErrorKind::BrokenPipe)
            || matches!(cause.downcast_ref::<csv::Error>().map(csv::Error::kind), Some(csv::ErrorKind::Io(e)) if e.kind() == io::ErrorKind::BrokenPipe)
    })
}

fn execute(matches: &ArgMatches) -> Result<Exit> {
    let cli = Cli::from_arg_matches(matches)?;
    check_room()?;
    let out = &mut BufWriter::new(io::stdout().lock());
    let Some(command) = cli.command else {
        if !cli.daemon.is_wanted() {
            Cli::command().print_help()?;
            return Ok(Exit::Usage);
        }
        let domain = cli.domain.prefix.is_some().then(|| cli.domain.domain()).transpose()?;
        let options = CompileArguments::of(matches);
        cli.oversight.log.init();
        let settings = cli.daemon.settings(&options, domain)?;
        let key = cli.trust.or(settings.trust.as_ref()).key()?;
        let oversight = cli.oversight.or(&settings.oversight);
        return daemon::run(settings, key, &oversight);
    };
    let exit = match command {
        Command::Compile(command) => {
            let matches = matches.subcommand_matches(COMPILE).unwrap_or(matches);
            compile::run(*command, matches, out)?
        }
        Command::Check { file, format, frame, reading, threads, progress } => {
            threads.start(None)?;
            let manner = progress.manner();
            let options = CompileOptions { crs: frame.crs, ..CompileOptions::default() };
            check::run(&file, format, (&reading, &options), manner, out)?.verdict.into()
        }
        Command::Inspect { source, json, verify, opening } => match opening.open(&source)? {
            Some(snapshot) => {
                inspect::run(&source, &snapshot, json, verify, out)?;
                Exit::Done
            }
            None => Exit::Rejected,
        },
        Command::Query {
            source,
            kind,
            radius,
            types,
            z_tolerance,
            heading_tolerance,
            route,
            format,
            opening,
        } => {
            let types = lane_types(&types)?;
            let options = NearestOptions {
                radius,
                types,
                z_tolerance,
                heading_tolerance,
                ..NearestOptions::default()
            };
            match opening.open(&source)? {
                Some(snapshot) => {
                    let document =
                        if source::is_compiled(&source) { "the document" } else { &*source };
                    query::run(
                        (snapshot.map(), document),
                        kind,
                        (&options, &route, format),
                        io::stdin().lock(),
                        &mut *out,
                    )
                    .map_err(usage_of)?;
                    Exit::Done
                }
                None => Exit::Rejected,
            }
        }
        Command::Match { source, trace, opening } => {
            let options = trace.options(lane_types(&trace.types)?);
            let Some(snapshot) = opening.open(&source)? else { return Ok(Exit::Rejected) };
            query::trace::run(snapshot.map(), &options, io::stdin().lock(), &mut *out)
                .map_err(usage_of)?;
            Exit::Done
        }
        Command::Export { source, format, output, index_boxes, route, layers, opening } => {
            let is_source = |output: &&PathBuf| is_same_file(output, source.as_ref());
            if let Some(output) = output.as_ref().filter(is_source) {
                let message = format!("{} would overwrite its source", output.display());
                bail!(UsageError(message));
            }
            match opening.open(&source)? {
                Some(snapshot) => {
                    let options = export::Options { index_boxes, route, layers };
                    let map = snapshot.map();
                    let left_out = export::run(map, format, &options, output.as_deref(), out)?;
                    if left_out > 0 {
                        // A closed stderr is nobody's loss.
                        let _ = writeln!(
                            io::stderr(),
                            "mapd: {left_out} features without a place are left out: this format cannot hold them"
                        );
                    }
                    Exit::Done
                }
                None => Exit::Rejected,
            }
        }
        Command::Status { json, domain } => {
            status::run(&domain.domain()?, json, out)?;
            Exit::Done
        }
        Command::Bench { bench, live, attach } => {
            let (domain, wait) = live.get()?;
            bench::run(&bench, (&domain, attach.attach.into(), wait), out)?;
            Exit::Done
        }
        Command::Doctor { doctor, live } => {
            let (domain, wait) = live.get()?;
            doctor::run(&doctor, (&domain, wait), out)?
        }
        Command::Sign(sign) => {
            sign::run(&sign, out)?;
            Exit::Done
        }
        Command::BenchClient { client, domain } => {
            bench::run_client(&client, &domain.domain()?, out)?;
            Exit::Done
        }
        Command::Reload { change, stage } => {
            change.ask(|map| Request::Reload { map, stage }, out)?
        }
        Command::Rollback { change, stage } => {
            change.ask(|map| Request::Rollback { map, stage }, out)?
        }
        Command::Activate { change } => change.ask(|map| Request::Activate { map }, out)?,
    };
    out.flush()?;
    Ok(exit)
}

/// What is wrong with how a query is asked is wrong usage.
fn usage_of(error: query::QueryRunError) -> anyhow::Error {
    match error {
        query::QueryRunError::Columns { .. } | query::QueryRunError::Options(_) => {
            UsageError(error.to_string()).into()
        }
        other => anyhow::Error::new(other),
    }
}

/// The set of lane types that names stand for.
fn lane_types(names: &[String]) -> Result<LaneTypes> {
    if names.is_empty() {
        return Ok(LaneTypes::ALL);
    }
    let mut set = LaneTypes::NONE;
    for name in names {
        if name == "drivable" {
            set = LaneType::ALL
                .iter()
                .filter(|kind| kind.is_drivable())
                .fold(set, |set, kind| set.with(*kind));
            continue;
        }
        match LaneType::from_name(name) {
            LaneType::Unknown => {
                let known: Vec<&str> = LaneType::ALL.iter().map(|kind| kind.name()).collect();
                bail!(UsageError(format!(
                    "unknown lane type {name:?}; known are drivable, {}",
                    known.join(", ")
                )));
            }
            kind => set = set.with(kind),
        }
    }
    Ok(set)
}
