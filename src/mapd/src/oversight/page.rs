//! One page over HTTP: enough of it for `GET /metrics`, and no more.
//!
//! A server of the usual kind would bring an asynchronous runtime for a page that is read every 15 seconds. Requests are
//! answered one after the other, each within a deadline, in a thread that nothing else waits for.

use rustix::event::{PollFd, PollFlags, poll};
use std::fmt;
use std::io::{self, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::os::unix::net::UnixStream;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How long a request may take in all.
const PATIENCE: Duration = Duration::from_secs(2);

/// Pause where connections cannot be taken.
const PAUSE: Duration = Duration::from_millis(100);

/// Longest head of a request \[bytes\].
const LONGEST_HEAD: usize = 8 << 10;

const CONTENT_TYPE: &str = "application/openmetrics-text; version=1.0.0; charset=utf-8";

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
        text: impl Fn() -> Result<String, fmt::Error> + Send + 'static,
    ) -> io::Result<Self> {
        listener.set_nonblocking(true)?;
        tracing::info!(address = %listener.local_addr()?, "metrics at http://{}/metrics", listener.local_addr()?);
        let (stop, stopped) = UnixStream::pair()?;
        let builder = std::thread::Builder::new().name("metrics".to_owned());
        let thread = builder.spawn(move || listen(&stopped, &listener, &text))?;
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

fn listen(
    stopped: &UnixStream,
    listener: &TcpListener,
    text: &dyn Fn() -> Result<String, fmt::Error>,
) {
    loop {
        let mut waits = [PollFd::new(listener, PollFlags::IN), PollFd::new(stopped, PollFlags::IN)];
        match poll(&mut waits, None) {
            Ok(_) => {}
            Err(rustix::io::Errno::INTR) => continue,
            // Cannot happen with descriptors of our own; the maps are served on without metrics.
            Err(_) => return,
        }
        if !waits[1].revents().is_empty() {
            return;
        }
        match listener.accept() {
            // Whoever hangs up or says nothing has no answer.
            Ok((stream, _)) => drop(answer(stream, text)),
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => {}
            // As without descriptors that are left.
            Err(_) => std::thread::sleep(PAUSE),
        }
    }
}

fn answer(mut stream: TcpStream, text: &dyn Fn() -> Result<String, fmt::Error>) -> io::Result<()> {
    stream.set_nonblocking(false)?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let head = read_head(&mut stream)?;
    let mut words = head.split(' ');
    let (method, path) = (words.next(), words.next());
    // What is asked beyond the path chooses nothing here.
    let path = path.map(|path| path.split_once('?').map_or(path, |(path, _)| path));
    let (status, body) = match (method, path) {
        (Some("GET" | "HEAD"), Some("/metrics")) => match text() {
            Ok(text) => ("200 OK", text),
            Err(_) => ("500 Internal Server Error", String::new()),
        },
        (Some("GET" | "HEAD"), Some(_)) => {
            ("404 Not Found", "the metrics are at /metrics\n".to_owned())
        }
        _ => ("405 Method Not Allowed", String::new()),
    };
    let length = body.len();
    let body = if method == Some("HEAD") { "" } else { body.as_str() };
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {CONTENT_TYPE}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n{body}"
    )
}

/// Reads up to the empty line; the request has no body.
fn read_head(stream: &mut TcpStream) -> io::Result<String> {
    let until = Instant::now() + PATIENCE;
    let mut head = Vec::new();
    let mut buffer = [0; 1024];
    while !head.windows(4).any(|end| end == b"\r\n\r\n") {
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
