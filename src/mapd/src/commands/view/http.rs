//! Just enough of HTTP for one page: `GET` of the page, of an archive, of what is laid over it, and of events.

use super::served::Served;
use crate::http::{self, Door, HEADERS, LONGEST_HEAD};
use crate::places::{Place, Places, Stage};
use mapd_web::page;
use std::io::{self, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// How long a request may take to arrive, and a piece of an answer to be taken.
const PATIENCE: Duration = Duration::from_secs(10);
/// Connections at a time. One more takes the place of another: nobody can keep others out.
const MOST_CONNECTIONS: usize = 64;
/// From one sign of life to the next where nothing happens.
const SIGN_OF_LIFE: Duration = Duration::from_secs(15);
/// Pause where connections cannot be taken.
const PAUSE: Duration = Duration::from_millis(100);

/// The maps, and who may look.
pub(super) struct Server {
    maps: Vec<Served>,
    door: Door,
}

impl Server {
    pub(super) fn new(maps: Vec<Served>, door: Door) -> Self {
        Self { maps, door }
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
    pub(super) fn serve(self: &Arc<Self>, listener: &TcpListener) -> ! {
        // Of users nothing is known.
        let places = Places::new(MOST_CONNECTIONS, MOST_CONNECTIONS, Stage::Takes);
        loop {
            let Ok((stream, _)) = listener.accept() else {
                std::thread::sleep(PAUSE);
                continue;
            };
            let stream = Arc::new(stream);
            let Ok(place) = places.take(0, stream.clone()) else {
                // The buffer of a connection that is new has room for it. Who hangs up needs no answer.
                let _ =
                    refuse(&stream, "503 Service Unavailable", "", "too many connections", false);
                continue;
            };
            // Who listens has lost its place, perhaps.
            self.maps.iter().for_each(Served::wake);
            let server = self.clone();
            let answer = move || {
                // Who hangs up needs no answer.
                let _ = server.answer(&stream, &place);
            };
            // Without a thread the connection is closed.
            if std::thread::Builder::new().name("answer".to_owned()).spawn(answer).is_err() {
                std::thread::sleep(PAUSE);
            }
        }
    }

    fn answer(&self, stream: &TcpStream, place: &Place) -> io::Result<()> {
        stream.set_write_timeout(Some(PATIENCE))?;
        let head = read_head(stream)?;
        place.go_on(Stage::IsAnswered)?;
        let (asked, is_head) = match http::understood(&head, self.door) {
            Ok(asked) => (Ok(asked.path), asked.is_head),
            Err(refusal) => (Err(refusal), head.starts_with("HEAD ")),
        };
        let reply = Reply { stream, is_head, place };
        let path = match asked {
            Ok(path) => path,
            Err(refusal) => return reply.refuse(refusal.status, &refusal.more, refusal.message),
        };
        let numbered = |prefix: &str| {
            let number = path.strip_prefix(prefix)?.parse::<usize>().ok()?;
            self.maps.get(number)
        };
        if path == "/" {
            self.page(reply)
        } else if let Some(map) = numbered("/map/") {
            archive(map, reply)
        } else if let Some(map) = numbered("/overlay/") {
            overlay(map, reply)
        } else if let Some(map) = numbered("/findings/") {
            findings(map, reply)
        } else if let Some(map) = numbered("/events/") {
            events(map, reply)
        } else if let Some(map) = numbered("/status/") {
            status(map, reply)
        } else {
            reply.refuse("404 Not Found", "", "the page is at /")
        }
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

    fn page(&self, reply: Reply<'_>) -> io::Result<()> {
        let names = self.names();
        let mut body = Vec::new();
        page::write(page::Content::Served(&names), "mapd", &mut body)?;
        reply.whole("text/html; charset=utf-8", "", &body)
    }
}

/// Reads up to the empty line.
///
/// Errors: the peer has closed the connection, does not send it in time, or sends too much.
fn read_head(mut stream: &TcpStream) -> io::Result<String> {
    let until = Instant::now() + PATIENCE;
    let (mut head, mut buffer) = (Vec::new(), [0; 1024]);
    while !http::is_whole(&head) {
        let left = until.saturating_duration_since(Instant::now());
        if left.is_zero() || head.len() > LONGEST_HEAD {
            return Err(io::ErrorKind::InvalidData.into());
        }
        stream.set_read_timeout(Some(left))?;
        match stream.read(&mut buffer)? {
            0 => return Err(io::ErrorKind::UnexpectedEof.into()),
            count => head.extend_from_slice(buffer.get(..count).unwrap_or_default()),
        }
    }
    Ok(String::from_utf8_lossy(&head).into_owned())
}

/// Where an answer goes.
#[derive(Clone, Copy)]
struct Reply<'a> {
    stream: &'a TcpStream,
    /// Whether the body is left out.
    is_head: bool,
    place: &'a Place,
}

impl Reply<'_> {
    /// Begins an answer whose body follows. `more`: further lines of its head.
    fn begin(mut self, kind: &str, more: &str) -> io::Result<()> {
        self.place.go_on(Stage::Takes)?;
        write!(self.stream, "HTTP/1.1 200 OK\r\nContent-Type: {kind}\r\n{HEADERS}{more}\r\n")
    }

    fn whole(mut self, kind: &str, more: &str, body: &[u8]) -> io::Result<()> {
        self.begin(kind, &format!("Content-Length: {}\r\n{more}", body.len()))?;
        if self.is_head { Ok(()) } else { self.stream.write_all(body) }
    }

    fn refuse(self, status: &str, more: &str, message: &str) -> io::Result<()> {
        self.place.go_on(Stage::Takes)?;
        refuse(self.stream, status, more, message, self.is_head)
    }
}

fn refuse(
    mut stream: &TcpStream,
    status: &str,
    more: &str,
    message: &str,
    is_head: bool,
) -> io::Result<()> {
    let body = format!("{message}\n");
    let length = body.len();
    let body = if is_head { "" } else { body.as_str() };
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: text/plain\r\n{HEADERS}{more}Content-Length: {length}\r\n\r\n{body}"
    )
}

/// The archive that is served now.
fn archive(map: &Served, reply: Reply<'_>) -> io::Result<()> {
    let snapshot = map.snapshot();
    let more = format!("Mapd-Generation: {}\r\n", snapshot.generation());
    reply.whole("application/octet-stream", &more, snapshot.bytes())
}

/// What is laid over it now; nothing where nothing is.
fn overlay(map: &Served, reply: Reply<'_>) -> io::Result<()> {
    let snapshot = map.snapshot();
    let more = format!("Mapd-Revision: {}\r\n", snapshot.overlay_revision());
    reply.whole("application/octet-stream", &more, snapshot.overlay_bytes())
}

/// What was found in the map's file; nothing where that is not known.
fn findings(map: &Served, reply: Reply<'_>) -> io::Result<()> {
    reply.whole("application/json", "", map.findings().json().as_bytes())
}

/// What is known of who serves and reads the map now.
fn status(map: &Served, reply: Reply<'_>) -> io::Result<()> {
    match map.status() {
        Ok(status) => reply.whole("application/json", "", status.as_bytes()),
        Err(error) => reply.refuse("503 Service Unavailable", "", &error.to_string()),
    }
}

/// An event for each generation and overlay, from those that are served now on, until the peer closes the connection or loses its place.
fn events(map: &Served, reply: Reply<'_>) -> io::Result<()> {
    reply.begin("text/event-stream", "")?;
    let Reply { mut stream, is_head, place } = reply;
    if is_head {
        return Ok(());
    }
    place.go_on(Stage::Listens)?;
    let mut told = None;
    while !place.is_lost() {
        let now = match told {
            None => map.version(),
            Some(told) => map.other_than(told, SIGN_OF_LIFE, || !place.is_lost()),
        };
        match told == Some(now) {
            true => stream.write_all(b":\n\n")?,
            false => write!(stream, "data: {} {}\n\n", now.generation, now.overlay)?,
        }
        stream.flush()?;
        told = Some(now);
    }
    Ok(())
}
