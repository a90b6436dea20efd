//! How a SOURCE is opened.

use super::{DomainArgs, FrameArgs, OntologyArgs, Seconds, ThreadsArg, TrustArgs};
use crate::progress::{Manner, Meter};
use crate::report;
use crate::source::{self, Attaching, Compiling, Opened, Source};
use crate::trust::{NotSignable, signable};
use anyhow::Result;
use clap::{Args, ValueEnum};
use mapd_client::{Attach, Client, Domain, Snapshot, TrustedKey};
use mapd_compiler::Compilation;
use std::path::Path;
use std::time::Duration;

/// An opened SOURCE.
pub(crate) struct OpenedSource {
    /// The map.
    pub(crate) snapshot: Snapshot,
    /// What compiling it has found; none of an archive or a live map.
    pub(crate) compilation: Option<Box<Compilation>>,
}

impl OpenedSource {
    /// A map that was not compiled just now.
    pub(crate) fn compiled_before(snapshot: Snapshot) -> Self {
        Self { snapshot, compilation: None }
    }
}

/// How a SOURCE is opened.
#[derive(Args)]
pub(crate) struct Opening {
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
pub(crate) struct AttachArgs {
    /// For shm:NAME: how to attach
    #[arg(long, value_enum, value_name = "HOW", default_value_t = How::Observer)]
    attach: How,
}

/// Where live maps are.
#[derive(Args)]
pub(crate) struct Live {
    #[command(flatten)]
    domain: DomainArgs,

    /// For shm:NAME: longest wait for daemon and map [s]
    #[arg(long, value_name = "S", default_value_t = Seconds(source::WAIT))]
    wait: Seconds,
}

impl AttachArgs {
    /// How.
    pub(crate) fn get(&self) -> Attach {
        self.attach.into()
    }
}

impl Live {
    /// Domain, and longest wait.
    ///
    /// Errors: no such domain.
    pub(crate) fn get(&self) -> Result<(Domain, Duration)> {
        Ok((self.domain.domain()?, self.wait.0))
    }

    /// As [`Live::get`], but for a file, which is read wherever daemons are: what is named for them is not looked at.
    ///
    /// Errors: the source is no file, and there is no such domain.
    pub(crate) fn get_for(&self, source: Option<&Source>) -> Result<(Domain, Duration)> {
        match source.and_then(Source::file) {
            Some(_) => Ok((Domain::new(mapd_transport::DEFAULT_PREFIX)?, self.wait.0)),
            None => self.get(),
        }
    }
}

impl Opening {
    /// Opens a SOURCE; prints why there is no map where there is none.
    ///
    /// Errors: files that cannot be read, archives that this release cannot read, no such live map; options that do not go
    /// with the source.
    pub(crate) fn open(&self, source: &Source) -> Result<Option<Snapshot>> {
        Ok(self.open_with_findings(source, Manner::Bar)?.map(|opened| opened.snapshot))
    }

    /// As [`Opening::open`], of an OpenDRIVE file also what was found in it; says how far compiling is.
    ///
    /// Errors: as [`Opening::open`].
    pub(crate) fn open_with_findings(
        &self,
        source: &Source,
        manner: Manner,
    ) -> Result<Option<OpenedSource>> {
        let (domain, wait) = self.live.get_for(Some(source))?;
        let reading = self.ontology.for_source(source.is_compiled())?;
        let options = self.frame.source(source)?;
        let compiling = Compiling { reading: &reading, options: &options };
        let live = Attaching { domain: &domain, attach: self.attach.get(), wait };
        open_or_report(source, compiling, self.trust.key()?, live, manner)
    }
}

impl Opening {
    /// Where live maps are.
    ///
    /// Errors: no such domain.
    pub(crate) fn domain(&self) -> Result<Domain> {
        Ok(self.live.get()?.0)
    }

    /// Attaches to a live map, to follow it.
    ///
    /// Errors: no such live map; a key, which no live map can be proved with.
    pub(crate) fn connect(&self, name: &str) -> Result<Client> {
        if self.trust.key()?.is_some() {
            return Err(
                NotSignable::Live { name: Source::Live(name.to_owned()).to_string() }.into()
            );
        }
        let (domain, wait) = self.live.get()?;
        Ok(Client::connect_as(self.attach.get(), &domain, name, wait)?)
    }
}

/// How a live map is attached to, as an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum How {
    /// Map the archive and write nothing
    Observer,
    /// Take part in iceoryx2, as one of at most 64
    Subscriber,
}

impl From<How> for Attach {
    fn from(how: How) -> Self {
        match how {
            How::Observer => Self::Observer,
            How::Subscriber => Self::Subscriber,
        }
    }
}

/// Opens a SOURCE for a command that needs a map; prints why there is none. With a key, only an archive that it has signed.
fn open_or_report(
    source: &Source,
    compiling: Compiling<'_>,
    key: Option<TrustedKey>,
    live: Attaching<'_>,
    manner: Manner,
) -> Result<Option<OpenedSource>> {
    if let Some(key) = key {
        let Some(file) = source.file() else {
            return Err(NotSignable::Live { name: source.to_string() }.into());
        };
        signable(file)?;
        let snapshot = Snapshot::open_trusted(file, &key)?;
        return Ok(Some(OpenedSource::compiled_before(snapshot)));
    }
    if !source.is_compiled() {
        ThreadsArg::default().start(None)?;
    }
    let bar = Meter::of_file(source.file().unwrap_or(Path::new("")), manner);
    let opened = source::open(source, compiling, live, &mut |p| bar.show(p))?;
    bar.finish();
    Ok(match opened {
        Opened::Map(snapshot, compilation) => Some(OpenedSource { snapshot, compilation }),
        Opened::Rejected(compiled) => {
            report::print(&source.to_string(), &compiled);
            None
        }
    })
}
