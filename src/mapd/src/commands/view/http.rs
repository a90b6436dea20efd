//! Just enough of HTTP for one page: `GET` of the page, of an archive, of what is laid over it, and of events.
//!
//! A page of somebody else that knows the port must not read maps. It is kept out by the names that a request may have for this
//! machine (a name of its own that leads here is refused), and by browsers themselves, because nothing here allows another origin.

use super::served::Served;
use anyhow::Result;
use mapd_web::page;
use std::io::{self, Read, Write};
use std::net::{IpAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

/// How long a request may take to arrive, and a piece of an answer to be taken.
const PATIENCE: Duration = Duration::from_secs(10);
/// Connections at a time; further ones are told to try again later.
const MOST_CONNECTIONS: usize = 64;
/// Longest head of a request \[bytes\].
const LONGEST_HEAD: usize = 8 << 10;
/// From one sign of life to the next where nothing happens.
const SIGN_OF_LIFE: Duration = Duration::from_secs(15);
/// Pause where connections cannot be taken.
const PAUSE: Duration = Duration::from_millis(100);

const HEADERS: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\nX-Frame-Options: DENY\r\nConnection: close\r\n";

/// The maps, and who may look.
pub(super) struct Server {
    maps: Vec<Served>,
    port: u16,
    is_open: bool,
    connections: AtomicUsize,
}

impl Server {
    pub(super) fn new(maps: Vec<Served>, port: u16, is_open: bool) -> Self {
        Self { maps, port, is_open, connections: AtomicUsize::new(0) }
    }

    /// Begins to follow live maps.
    ///
    /// Errors: no thread can be had.
    pub(super) fn follow(self: &Arc<Self>) -> io::Result<()> {
        for number in 0..self.maps.len() {
            let server = self.clone();
            let follow = move || server.maps.get(number).into_iter().for_each(Served::follow);
            std::thread::Builder::new().name("follow".to_owned()).spawn(follow)?;
        }
        Ok(())
    }

    /// Answers for ever.
    ///
    /// Errors: no thread can be had.
    pub(super) fn serve(self: &Arc<Self>, listener: &TcpListener) -> Result<()> {
        loop {
            let Ok((stream, _)) = listener.accept() else {
                std::thread::sleep(PAUSE);
                continue;
            };
            let server = self.clone();
            let answer = move || {
                // Who hangs up needs no answer.
                let _ = server.answer(stream);
            };
            std::thread::Builder::new().name("answer".to_owned()).spawn(answer)?;
        }
    }

    fn answer(&self, mut stream: TcpStream) -> io::Result<()> {
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_write_timeout(Some(PATIENCE))?;
        let _place = ConnectionSlot(&self.connections);
        if self.connections.fetch_add(1, Ordering::Relaxed) >= MOST_CONNECTIONS {
            return refuse(&mut stream, "503 Service Unavailable", "too many connections");
        }
        let head = read_head(&mut stream)?;
        let mut words = head.split(' ');
        let (method, path) = (words.next(), words.next().unwrap_or_default());
        if method != Some("GET") {
            return refuse(&mut stream, "405 Method Not Allowed", "only GET");
        }
        if !self.is_for_us(host(&head)) {
            let message = "this name is not this machine's; --open allows its addresses";
            return refuse(&mut stream, "403 Forbidden", message);
        }
        // What is asked beyond the path is for the page.
        let path = path.split_once('?').map_or(path, |(path, _)| path);
        let numbered = |prefix: &str| {
            let number = path.strip_prefix(prefix)?.parse::<usize>().ok()?;
            self.maps.get(number)
        };
        if path == "/" {
            self.page(&mut stream)
        } else if let Some(map) = numbered("/map/") {
            archive(map, &mut stream)
        } else if let Some(map) = numbered("/overlay/") {
            overlay(map, &mut stream)
        } else if let Some(map) = numbered("/findings/") {
            findings(map, &mut stream)
        } else if let Some(map) = numbered("/events/") {
            events(map, &mut stream)
        } else if let Some(map) = numbered("/status/") {
            status(map, &mut stream)
        } else {
            refuse(&mut stream, "404 Not Found", "the page is at /")
        }
    }

    /// Whether a `Host` names this machine and port: by an address of its own, or as `localhost`.
    fn is_for_us(&self, host: Option<&str>) -> bool {
        let Some((name, port)) = host.and_then(|host| host.rsplit_once(':')) else { return false };
        let name = name.trim_start_matches('[').trim_end_matches(']');
        let address = name.parse::<IpAddr>();
        let is_named = name.eq_ignore_ascii_case("localhost")
            || address.is_ok_and(|address| self.is_open || address.is_loopback());
        is_named && port.parse() == Ok(self.port)
    }

    /// What the page calls the maps: those of the same name as they were named in full.
    fn names(&self) -> Vec<String> {
        let is_alone =
            |name: &String| self.maps.iter().filter(|map| map.name() == *name).count() == 1;
        let name = |map: &Served| {
            Some(map.name()).filter(is_alone).unwrap_or_else(|| map.source().to_string())
        };
        self.maps.iter().map(name).collect()
    }

    fn page(&self, stream: &mut TcpStream) -> io::Result<()> {
        let names = self.names();
        let mut body = Vec::new();
        page::write(page::Content::Served(&names), "mapd", &mut body)?;
        ok(stream, "text/html; charset=utf-8", &format!("Content-Length: {}\r\n", body.len()))?;
        stream.write_all(&body)
    }
}

/// A connection's place, which is free again when it ends.
struct ConnectionSlot<'a>(&'a AtomicUsize);

impl Drop for ConnectionSlot<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Reads up to the empty line.
///
/// Errors: the peer has closed the connection, sends nothing in time, or too much.
fn read_head(stream: &mut TcpStream) -> io::Result<String> {
    let (mut head, mut buffer) = (Vec::new(), [0; 1024]);
    while !head.windows(4).any(|end| end == b"\r\n\r\n") {
        if head.len() > LONGEST_HEAD {
            return Err(io::ErrorKind::InvalidData.into());
        }
        match stream.read(&mut buffer)? {
            0 => return Err(io::ErrorKind::UnexpectedEof.into()),
            count => head.extend_from_slice(buffer.get(..count).unwrap_or_default()),
        }
    }
    Ok(String::from_utf8_lossy(&head).into_owned())
}

/// The value of the only `Host`.
fn host(head: &str) -> Option<&str> {
    let fields = head.lines().skip(1).filter_map(|line| line.split_once(':'));
    let mut hosts = fields.filter(|(name, _)| name.eq_ignore_ascii_case("host"));
    match (hosts.next(), hosts.next()) {
        (Some((_, host)), None) => Some(host.trim()),
        _ => None,
    }
}

fn ok(stream: &mut TcpStream, kind: &str, more: &str) -> io::Result<()> {
    write!(stream, "HTTP/1.1 200 OK\r\nContent-Type: {kind}\r\n{HEADERS}{more}\r\n")
}

fn refuse(stream: &mut TcpStream, status: &str, message: &str) -> io::Result<()> {
    let length = message.len() + 1;
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: text/plain\r\n{HEADERS}Content-Length: {length}\r\n\r\n{message}\n"
    )
}

/// The archive that is served now.
fn archive(map: &Served, stream: &mut TcpStream) -> io::Result<()> {
    let snapshot = map.snapshot();
    let (bytes, generation) = (snapshot.bytes(), snapshot.generation());
    let more = format!("Content-Length: {}\r\nMapd-Generation: {generation}\r\n", bytes.len());
    ok(stream, "application/octet-stream", &more)?;
    stream.write_all(bytes)
}

/// What is laid over it now; nothing where nothing is.
fn overlay(map: &Served, stream: &mut TcpStream) -> io::Result<()> {
    let snapshot = map.snapshot();
    let (bytes, revision) = (snapshot.overlay_bytes(), snapshot.overlay_revision());
    let more = format!("Content-Length: {}\r\nMapd-Revision: {revision}\r\n", bytes.len());
    ok(stream, "application/octet-stream", &more)?;
    stream.write_all(bytes)
}

/// What was found in the map's file; nothing where that is not known.
fn findings(map: &Served, stream: &mut TcpStream) -> io::Result<()> {
    let json = map.findings().json();
    ok(stream, "application/json", &format!("Content-Length: {}\r\n", json.len()))?;
    stream.write_all(json.as_bytes())
}

/// What is known of who serves and reads the map now.
fn status(map: &Served, stream: &mut TcpStream) -> io::Result<()> {
    match map.status() {
        Ok(status) => {
            let length = format!("Content-Length: {}\r\n", status.len());
            ok(stream, "application/json", &length)?;
            stream.write_all(status.as_bytes())
        }
        Err(error) => refuse(stream, "503 Service Unavailable", &error.to_string()),
    }
}

/// An event for each generation and overlay, from those that are served now on, until the peer closes the connection.
fn events(map: &Served, stream: &mut TcpStream) -> io::Result<()> {
    ok(stream, "text/event-stream", "")?;
    let mut told = None;
    loop {
        let now = match told {
            None => map.version(),
            Some(told) => map.other_than(told, SIGN_OF_LIFE),
        };
        match told == Some(now) {
            true => stream.write_all(b":\n\n")?,
            false => write!(stream, "data: {} {}\n\n", now.generation, now.overlay)?,
        }
        stream.flush()?;
        told = Some(now);
    }
}
