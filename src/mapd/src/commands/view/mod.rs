//! `mapd view`: maps in a browser, served live.

mod http;
mod served;

use crate::args::Opening;
use crate::exit::{Exit, UsageError};
use crate::http::Door;
use crate::source::Source;
use anyhow::{Context, Result, bail};
use clap::Args;
use http::Server;
use served::Served;
use std::io::Write;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::sync::Arc;

pub(crate) const HELP: &str = "Prints the address of the page, and serves it until it is ended. Other machines are refused unless --open lets them look: everyone who can reach the port sees the maps.";

/// Which maps to show, and at which address.
#[derive(Args)]
pub(crate) struct ViewCommand {
    /// .xodr, .mapd or shm:NAME
    #[arg(required = true)]
    sources: Vec<Source>,
    /// Port to listen at; 0: any that is free
    #[arg(long, default_value_t = 0)]
    port: u16,
    /// Let other machines look, too: listen at all addresses of this machine
    #[arg(long)]
    open: bool,
    #[command(flatten)]
    opening: Opening,
}

impl ViewCommand {
    /// Serves until it is ended.
    ///
    /// Errors: a source cannot be opened; the port is taken.
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let mut maps = Vec::new();
        for source in &self.sources {
            if maps.iter().any(|map: &Served| map.source() == source) {
                bail!(UsageError(format!("{source} is named twice")));
            }
            match Served::open(source, &self.opening)? {
                Some(map) => maps.push(map),
                None => return Ok(Exit::Rejected),
            }
        }
        let address = if self.open { Ipv4Addr::UNSPECIFIED } else { Ipv4Addr::LOCALHOST };
        let address = SocketAddr::from((address, self.port));
        let listener =
            TcpListener::bind(address).with_context(|| format!("listening at {address}"))?;
        let port = listener.local_addr()?.port();
        writeln!(out, "http://127.0.0.1:{port}/")?;
        out.flush()?;
        let server = Arc::new(Server::new(maps, Door { port, is_open: self.open }));
        server.follow()?;
        server.serve(&listener)
    }
}
