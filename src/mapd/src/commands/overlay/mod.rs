//! `mapd overlay`: what is laid over a map that is served.

mod feed;
mod follow;

use crate::args::{DomainArgs, Seconds, not_negative};
use crate::clock::since_epoch;
use crate::control::{AskError, ListedEntry, OverlayAction, OverlayReport, Request, Response, ask};
use crate::exit::{Exit, UsageError, explained};
use crate::printable::printable;
use anyhow::{Context, Result, bail};
use clap::{Args, Subcommand};
use feed::matched;
use mapd_client::{Attach, Client, TrustError, read_signature};
use mapd_overlay::{FeedFinding, Moment, WIDEST_TOLERANCE, WZDX_TOLERANCE};
use serde_json::{Value, json};
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Longest wait for the daemon, where nothing else is said.
const ANSWER: Duration = Duration::from_secs(60);

/// Longest document that is sent \[bytes\]: longer ones no daemon takes.
const LONGEST: usize = 5 << 20;

/// Longest file that is read \[bytes\]: of a feed of a whole state, what fits the map is sent.
const LONGEST_FILE: u64 = 64 << 20;

/// What is laid over which map. Its options may stand behind what is done, too.
#[derive(Args)]
#[command(mut_arg("prefix", |arg| arg.global(true)), mut_arg("owner", |arg| arg.global(true)))]
pub(crate) struct OverlayCommand {
    /// The map
    name: String,
    #[command(subcommand)]
    action: Action,
    /// Longest wait for the daemon [s]
    #[arg(long, value_name = "S", default_value_t = Seconds(ANSWER), global = true)]
    wait: Seconds,
    #[command(flatten)]
    domain: DomainArgs,
}

#[derive(Subcommand)]
enum Action {
    /// Take over the entries of a JSON file, or of stdin (-); those of the same id are replaced. All of them, or none. Of a WZDx
    /// feed, those that the map has a place for; the others are told
    Apply {
        /// The file (schemas/overlay.schema.json, or a WZDx 4.2 feed of work zones), or - for stdin; its signature, if there is one, is in FILE.minisig
        file: PathBuf,
        /// Of a feed, how far beside its lines lanes may lie [m]
        #[arg(long, value_name = "M", default_value_t = WZDX_TOLERANCE, value_parser = tolerance)]
        tolerance: f64,
        /// Replace all earlier entries of this feed with these [default for WZDx: the file's name]
        #[arg(long, value_name = "NAME", conflicts_with = "watch")]
        feed: Option<String>,
        /// Go on: apply the file, or each file of a folder, whenever it changes; what it has no more is removed
        #[arg(long)]
        watch: bool,
        /// Print JSON: what `list --json` prints, and findings of a feed
        #[arg(long, conflicts_with = "watch")]
        json: bool,
    },
    /// List the entries, and which of them hold
    List {
        #[command(flatten)]
        how: How,
    },
    /// Show an entry
    Show {
        /// Its id
        id: String,
        #[command(flatten)]
        how: How,
    },
    /// Remove entries: all of these, or none
    Remove {
        /// Their ids
        #[arg(required = true)]
        ids: Vec<String>,
        /// Print JSON: what is left, as `list --json` does
        #[arg(long)]
        json: bool,
    },
    /// Remove all entries
    Clear {
        /// Print JSON: what is left, as `list --json` does
        #[arg(long)]
        json: bool,
    },
}

#[derive(Args)]
struct How {
    /// As JSON
    #[arg(long)]
    json: bool,
    /// Which hold at this moment, as 2026-05-04T07:00:00Z or seconds since 1970 [default: now]
    #[arg(long, value_name = "TIME")]
    at: Option<Moment>,
}

impl How {
    fn moment(&self) -> Moment {
        self.at.unwrap_or_else(now)
    }
}

fn now() -> Moment {
    Moment { unix_seconds: since_epoch().as_secs_f64() }
}

fn print(value: &Value, out: &mut dyn Write) -> Result<()> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    Ok(writeln!(out)?)
}

impl OverlayCommand {
    /// Asks the daemon.
    ///
    /// Errors: what was given is wrong (usage); no daemon, no answer, no such map.
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        match &self.action {
            Action::Apply { file, tolerance, watch: true, .. } => {
                follow::follow(&self, file, *tolerance, out)?;
            }
            Action::Apply { file, tolerance, feed, json, .. } => {
                let applied = self.apply(file, *tolerance, feed.as_deref(), Vec::new())?;
                match json {
                    true => print(&applied.as_json(), out)?,
                    false => self.tell(file, &applied, out)?,
                }
                if !applied.is_whole {
                    return Ok(Exit::Quarantined);
                }
            }
            Action::List { how } => {
                let report = self.ask(OverlayAction::List)?;
                if how.json {
                    print(&as_json(&report, how.moment()), out)?;
                } else if report.entries.is_empty() {
                    writeln!(out, "{}: no entries", self.name)?;
                } else {
                    for one in &report.entries {
                        line(one, how.moment(), out)?;
                    }
                }
            }
            Action::Show { id, how } => {
                let mut report = self.ask(OverlayAction::List)?;
                report.entries.retain(|one| one.entry.id == *id);
                let Some(one) = report.entries.first() else {
                    bail!(UsageError(format!("there is no entry {id:?}")));
                };
                print(&entry_as_json(one, how.moment()), out)?;
            }
            Action::Remove { ids, json } => {
                let report = self.ask(OverlayAction::Remove { ids: ids.clone() })?;
                match json {
                    true => print(&as_json(&report, now()), out)?,
                    false => writeln!(out, "{}: {} entries", self.name, report.entries.len())?,
                }
            }
            Action::Clear { json } => {
                let report = self.ask(OverlayAction::Clear)?;
                match json {
                    true => print(&as_json(&report, now()), out)?,
                    false => writeln!(out, "{}: no entries", self.name)?,
                }
            }
        }
        Ok(Exit::Done)
    }

    /// Applies a file; as a feed of this name, what it has no more is removed, and what feeds said that have ended. A WZDx feed is a whole state, so it always has a name.
    fn apply(
        &self,
        file: &Path,
        tolerance: f64,
        feed: Option<&str>,
        ended: Vec<String>,
    ) -> Result<Applied> {
        // First the signature: where both are replaced meanwhile, an older one with a newer file is wrong, and told.
        let mut signature = signature(file)?;
        let mut document = read_document(file)?;
        let (mut findings, mut unread) = (None, Vec::new());
        let mut feed = feed.map(str::to_owned);
        if mapd_overlay::is_feed(&document) {
            let wrong = |error| UsageError(format!("{}: {}", file.display(), explained(&error)));
            let (domain, own) = (self.domain.domain()?, Attach::Observer);
            let client = Client::connect_as(own, &domain, &self.name, self.wait.0)?;
            let fits = matched(client.snapshot().map(), &document, tolerance).map_err(wrong)?;
            (document, findings) = (fits.document.to_json(), Some(fits.findings));
            (signature, unread) = (None, fits.unread);
            feed = feed.or_else(|| Some(file.file_name()?.to_string_lossy().into_owned()));
        }
        if document.len() > LONGEST {
            let found = document.len();
            bail!(UsageError(format!(
                "{}: {found} bytes of entries; at most {LONGEST} are taken, whatever --overlay-bytes says",
                file.display()
            )));
        }
        let is_whole = unread.is_empty();
        let apply = OverlayAction::Apply { document, feed, unread, ended, signature };
        Ok(Applied { report: self.ask(apply)?, findings, is_whole })
    }

    /// Says what has been applied, and what could not be placed.
    fn tell(
        &self,
        file: &Path,
        Applied { report, findings, .. }: &Applied,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        writeln!(out, "{}: {} entries", self.name, report.entries.len())?;
        for FeedFinding { place, why } in findings.iter().flatten() {
            writeln!(out, "{}", printable(&format!("{}: {place}: {why}", file.display())))?;
        }
        for one in report.entries.iter().filter(|_| findings.is_none()) {
            if let Some(why) = &one.part {
                writeln!(out, "entry {:?}, not all of it: {}", one.entry.id, printable(why))?;
            }
        }
        Ok(())
    }

    fn ask(&self, action: OverlayAction) -> Result<OverlayReport> {
        let domain = self.domain.domain()?;
        mapd_transport::check_map_name(&self.name)?;
        let request = Request::Overlay { map: self.name.clone(), action };
        match ask(&domain, &self.name, &request, self.wait.0)? {
            Response::Overlay(report) => Ok(report),
            Response::Wrong { reason } => {
                bail!(UsageError(format!("map {:?}: {reason}; nothing is changed", self.name)))
            }
            Response::Refused { reason } => bail!("map {:?}: {reason}", self.name),
            _ => bail!(AskError::Unexpected { map: self.name.clone() }),
        }
    }
}

/// A tolerance that places of a feed may have.
fn tolerance(text: &str) -> Result<f64, String> {
    not_negative(text).and_then(|metres| match metres {
        metres if metres <= WIDEST_TOLERANCE => Ok(metres),
        _ => Err(format!("expected at most {WIDEST_TOLERANCE} m")),
    })
}

/// The signature beside a file, if there is one: whether it must be there is the daemon's to say. What stdin says has none.
fn signature(file: &Path) -> Result<Option<String>> {
    if file == Path::new("-") {
        return Ok(None);
    }
    match read_signature(file) {
        Ok(signature) => Ok(Some(signature)),
        Err(TrustError::Unsigned { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
            Ok(None)
        }
        Err(error) => Err(error.into()),
    }
}

/// A document: UTF-8, of bounded length.
pub(super) fn read_document(file: &Path) -> Result<String> {
    let mut text = String::new();
    let reading = || format!("reading {}", file.display());
    let read = if file == Path::new("-") {
        io::stdin().lock().take(LONGEST_FILE + 1).read_to_string(&mut text)
    } else {
        File::open(file).and_then(|file| file.take(LONGEST_FILE + 1).read_to_string(&mut text))
    };
    match read {
        Err(error) if error.kind() == io::ErrorKind::InvalidData => {
            bail!(UsageError(format!("{}: not UTF-8 text", file.display())))
        }
        Ok(length) if length as u64 > LONGEST_FILE => {
            bail!(UsageError(format!("{}: longer than {LONGEST_FILE} bytes", file.display())))
        }
        read => read.with_context(reading)?,
    };
    Ok(text)
}

/// Whether an entry holds at a moment, in a word.
fn state(one: &ListedEntry, at: Moment) -> &'static str {
    match one.entry.until {
        Some(until) if until <= at => "ended",
        _ if one.unplaced.is_some() => "unplaced",
        _ if one.entry.holds(at) => "active",
        _ => "waiting",
    }
}

fn entry_as_json(one: &ListedEntry, at: Moment) -> Value {
    let mut value = json!(one.entry);
    value["state"] = json!(state(one, at));
    if let Some(why) = &one.unplaced {
        value["why"] = json!(why);
    }
    if let Some(why) = &one.part {
        value["part"] = json!(why);
    }
    value
}

fn as_json(report: &OverlayReport, at: Moment) -> Value {
    let entries: Vec<Value> = report.entries.iter().map(|one| entry_as_json(one, at)).collect();
    json!({ "revision": report.revision, "entries": entries })
}

/// What is laid over the map after a file was applied.
struct Applied {
    report: OverlayReport,
    /// What of a feed could not be placed; none for entries.
    findings: Option<Vec<FeedFinding>>,
    /// Whether all of a feed could be read.
    is_whole: bool,
}

impl Applied {
    fn as_json(&self) -> Value {
        let mut value = as_json(&self.report, now());
        if let Some(findings) = &self.findings {
            let told = |one: &FeedFinding| json!({ "place": one.place, "why": one.why });
            value["findings"] = findings.iter().map(told).collect();
        }
        value
    }
}

fn line(one: &ListedEntry, at: Moment, out: &mut dyn Write) -> io::Result<()> {
    let entry = &one.entry;
    let value = entry.value.map(|value| format!(" {value} m/s")).unwrap_or_default();
    let id = printable(&entry.id);
    write!(out, "{:10} {:9} {id}{value}", state(one, at), entry.kind.name())?;
    if let Some(until) = entry.until {
        write!(out, ", until {until}")?;
    }
    for (what, said) in [("from", &entry.source), ("says", &entry.text)] {
        if !said.is_empty() {
            write!(out, ", {what} {said:?}")?;
        }
    }
    match (&one.unplaced, &one.part) {
        (Some(why), _) => writeln!(out, ": {}", printable(why)),
        (None, Some(why)) => writeln!(out, ", not all of it: {}", printable(why)),
        (None, None) => writeln!(out),
    }
}
