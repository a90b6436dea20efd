//! One page over HTTP: enough of it for `GET /metrics`, and no more.
//!
//! A server of the usual kind would bring an asynchronous runtime for a page that is read every 15 seconds. One thread, which
//! nothing else waits for, has all connections side by side: none waits for another, and none blocks.

use crate::http::{self, Door, HEADERS, LONGEST_HEAD};
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use std::fmt;
use std::io::{self, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::os::unix::net::UnixStream;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How long a request and its answer may take in all.
const PATIENCE: Duration = Duration::from_secs(2);

/// Connections at a time; one more takes the place of the one that came first.
const MOST_CONNECTIONS: usize = 64;

/// Pause where connections cannot be taken.
const PAUSE: Duration = Duration::from_millis(100);

const CONTENT_TYPE: &str = "application/openmetrics-text; version=1.0.0; charset=utf-8";

/// Makes the page.
type Text<'a> = &'a dyn Fn() -> Result<String, fmt::Error>;

/// Serves the page until it is dropped.
pub(crate) struct Page {
    /// Closed to end the thread.
    stop: Option<UnixStream>,
    thread: Option<JoinHandle<()>>,
}

impl Page {
    /// Begins to listen.
    ///
    /// Errors: no thread can be had.
    pub(crate) fn serve(
        listener: TcpListener,
        is_open: bool,
        text: impl Fn() -> Result<String, fmt::Error> + Send + 'static,
    ) -> io::Result<Self> {
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        tracing::info!(%address, "metrics at http://{address}/metrics");
        let door = Door { port: address.port(), is_open };
        let (stop, stopped) = UnixStream::pair()?;
        let builder = std::thread::Builder::new().name("metrics".to_owned());
        let thread = builder.spawn(move || listen(&stopped, &listener, door, &text))?;
        Ok(Self { stop: Some(stop), thread: Some(thread) })
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        self.stop = None;
        if let Some(thread) = self.thread.take() {
            // A panic there has been printed.
            let _ = thread.join();
        }
    }
}

fn listen(stopped: &UnixStream, listener: &TcpListener, door: Door, text: Text<'_>) {
    // In the order in which they came.
    let mut connections: Vec<Connection> = Vec::new();
    loop {
        let mut waits =
            vec![PollFd::new(stopped, PollFlags::IN), PollFd::new(listener, PollFlags::IN)];
        waits.extend(connections.iter().map(|one| PollFd::new(&one.stream, one.waits_for())));
        let now = Instant::now();
        let left = connections.first().map(|one| one.until.saturating_duration_since(now));
        let left = left.and_then(|left| Timespec::try_from(left).ok());
        match poll(&mut waits, left.as_ref()) {
            Ok(_) => {}
            Err(rustix::io::Errno::INTR) => continue,
            // Cannot happen with descriptors of our own; the maps are served on without metrics.
            Err(_) => return,
        }
        let is_ready: Vec<bool> = waits.iter().map(|wait| !wait.revents().is_empty()).collect();
        let [is_stopped, is_asked, ready @ ..] = is_ready.as_slice() else { return };
        if *is_stopped {
            return;
        }
        let mut ready = ready.iter();
        let now = Instant::now();
        connections.retain_mut(|one| {
            let is_ready = ready.next().is_some_and(|ready| *ready);
            // A client that closes the connection, sends nothing within the time limit, or sends too much gets no answer.
            now < one.until && (!is_ready || one.go_on(door, text).is_ok_and(|is_done| !is_done))
        });
        if *is_asked {
            take(listener, &mut connections, door, text);
        }
    }
}

/// Accepts all waiting connections.
fn take(listener: &TcpListener, connections: &mut Vec<Connection>, door: Door, text: Text<'_>) {
    loop {
        match listener.accept() {
            Ok((stream, _)) => {
                let Ok(mut one) = Connection::new(stream) else { continue };
                // A client whose request has arrived with the connection is answered before it takes another one's place.
                if !one.go_on(door, text).is_ok_and(|is_done| !is_done) {
                    continue;
                }
                if connections.len() >= MOST_CONNECTIONS {
                    connections.remove(0);
                }
                connections.push(one);
            }
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => return,
            Err(error) if error.kind() == io::ErrorKind::ConnectionAborted => {}
            // As without descriptors that are left.
            Err(_) => return std::thread::sleep(PAUSE),
        }
    }
}

/// A client's connection, from request to answer.
struct Connection {
    stream: TcpStream,
    until: Instant,
    head: Vec<u8>,
    /// What is still to be written, once the request is known.
    answer: Option<Vec<u8>>,
    written: usize,
}

impl Connection {
    fn new(stream: TcpStream) -> io::Result<Self> {
        stream.set_nonblocking(true)?;
        let until = Instant::now() + PATIENCE;
        Ok(Self { stream, until, head: Vec::new(), answer: None, written: 0 })
    }

    fn waits_for(&self) -> PollFlags {
        if self.answer.is_some() { PollFlags::OUT } else { PollFlags::IN }
    }

    /// Reads and writes what can be; whether the answer has been written.
    ///
    /// Errors: the client has closed the connection, or its request is too long.
    fn go_on(&mut self, door: Door, text: Text<'_>) -> io::Result<bool> {
        match self.read().and_then(|()| self.write(door, text)) {
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => Ok(false),
            other => other.map(|()| true),
        }
    }

    /// Reads up to the empty line; the request has no body.
    fn read(&mut self) -> io::Result<()> {
        let mut buffer = [0; 1024];
        while self.answer.is_none() && !http::is_whole(&self.head) {
            if self.head.len() > LONGEST_HEAD {
                return Err(io::ErrorKind::InvalidData.into());
            }
            match self.stream.read(&mut buffer) {
                Ok(0) => return Err(io::ErrorKind::UnexpectedEof.into()),
                Ok(count) => {
                    self.head.extend_from_slice(buffer.get(..count).unwrap_or_default());
                }
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    fn write(&mut self, door: Door, text: Text<'_>) -> io::Result<()> {
        let answer = self.answer.get_or_insert_with(|| answer(&self.head, door, text));
        while let Some(left) = answer.get(self.written..).filter(|left| !left.is_empty()) {
            match self.stream.write(left) {
                Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
                Ok(count) => self.written += count,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

/// The answer to a request.
fn answer(head: &[u8], door: Door, text: Text<'_>) -> Vec<u8> {
    let head = String::from_utf8_lossy(head);
    let (status, more, body) = match http::understood(&head, door) {
        Ok(asked) if asked.path == "/metrics" => match text() {
            Ok(text) => ("200 OK", String::new(), text),
            Err(_) => ("500 Internal Server Error", String::new(), String::new()),
        },
        Ok(_) => ("404 Not Found", String::new(), "the metrics are at /metrics\n".to_owned()),
        Err(refusal) => (refusal.status, refusal.more, format!("{}\n", refusal.message)),
    };
    let kind = if status.starts_with("200") { CONTENT_TYPE } else { "text/plain" };
    let length = body.len();
    let body = if head.starts_with("HEAD ") { "" } else { body.as_str() };
    format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\n{more}{HEADERS}Content-Length: {length}\r\n\r\n{body}"
    )
    .into_bytes()
}
