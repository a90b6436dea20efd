//! The daemon's side of the sockets.

use super::message::{Request, Response};
use super::socket_path;
use mapd_client::Domain;
use rustix::event::{PollFd, PollFlags, poll};
use std::fmt;
use std::fs::{self, Permissions};
use std::io::{self, Read, Write};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Mode of a socket: the daemon's user alone.
const SOCKET_MODE: u32 = 0o600;

/// How long who asks may take in all to say what, and then to take the answer.
const PATIENCE: Duration = Duration::from_secs(2);

/// Longest request: a document of overlay entries as text in JSON \[bytes\].
const LONGEST_REQUEST: usize = 16 << 20;

/// Pause where connections cannot be taken, as without descriptors that are left.
const PAUSE: Duration = Duration::from_millis(100);

/// Requests that are answered at a time; who comes later is refused.
const MOST_CONNECTIONS: usize = 32;

/// Answers a request; called in a thread of its own, and may take as long as what is asked for takes.
type Answer = dyn Fn(Request) -> Response + Send + Sync;

/// Listens on the sockets of a daemon's maps, in a thread of its own. Dropping it removes them: do so while the maps are
/// still claimed, or a successor's would be removed.
pub struct ControlListener {
    paths: Vec<PathBuf>,
    /// Closed to end the thread.
    stop: Option<UnixStream>,
    thread: Option<JoinHandle<()>>,
}

impl ControlListener {
    /// Begins to listen. Only for maps that this process has claimed: what a killed daemon left under a socket's name is
    /// removed.
    ///
    /// Errors: a socket cannot be made.
    pub fn start(
        domain: &Domain,
        maps: &[String],
        answer: impl Fn(Request) -> Response + Send + Sync + 'static,
    ) -> io::Result<Self> {
        let (stop, stopped) = UnixStream::pair()?;
        // From here on, dropping it removes what has been made.
        let mut made = Self { paths: Vec::new(), stop: Some(stop), thread: None };
        let mut listeners = Vec::new();
        for map in maps {
            let path = socket_path(domain, map);
            match fs::remove_file(&path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                _ => {}
            }
            let listener = UnixListener::bind(&path)?;
            made.paths.push(path.clone());
            fs::set_permissions(&path, Permissions::from_mode(SOCKET_MODE))?;
            listener.set_nonblocking(true)?;
            listeners.push(listener);
        }
        let answer: Arc<Answer> = Arc::new(answer);
        let builder = std::thread::Builder::new().name("control".to_owned());
        made.thread = Some(builder.spawn(move || listen(&stopped, &listeners, &answer))?);
        Ok(made)
    }
}

impl Drop for ControlListener {
    fn drop(&mut self) {
        for path in &self.paths {
            // A name that stays refuses connections, and the next daemon replaces it.
            let _ = fs::remove_file(path);
        }
        self.stop = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

fn listen(stopped: &UnixStream, listeners: &[UnixListener], answer: &Arc<Answer>) {
    let busy = Arc::new(AtomicUsize::new(0));
    loop {
        let mut waits: Vec<PollFd<'_>> =
            listeners.iter().map(|listener| PollFd::new(listener, PollFlags::IN)).collect();
        waits.push(PollFd::new(stopped, PollFlags::IN));
        match poll(&mut waits, None) {
            Ok(_) => {}
            Err(rustix::io::Errno::INTR) => continue,
            // Cannot happen with descriptors of our own; the maps are served on without control.
            Err(_) => return,
        }
        if waits.last().is_some_and(|stop| !stop.revents().is_empty()) {
            return;
        }
        for listener in listeners {
            loop {
                match listener.accept() {
                    Ok((stream, _)) => connect(stream, &busy, answer),
                    Err(error) if error.kind() == io::ErrorKind::WouldBlock => break,
                    Err(error) => {
                        tracing::debug!(%error, "a request cannot be taken: {error}");
                        std::thread::sleep(PAUSE);
                        break;
                    }
                }
            }
        }
    }
}

/// Hands a connection to a thread, if there are not too many.
fn connect(stream: UnixStream, busy: &Arc<AtomicUsize>, answer: &Arc<Answer>) {
    /// Counts a connection as long as it lives.
    struct Busy(Arc<AtomicUsize>);
    impl Drop for Busy {
        fn drop(&mut self) {
            self.0.fetch_sub(1, Ordering::Relaxed);
        }
    }
    let refused = busy.fetch_add(1, Ordering::Relaxed) >= MOST_CONNECTIONS;
    let (busy, answer) = (Busy(busy.clone()), answer.clone());
    if refused {
        let reason = format!("the daemon is already answering {MOST_CONNECTIONS} requests");
        // Who is refused and has gone needs no answer.
        let _ = prepare(&stream).and_then(|()| reply(&stream, &Response::Refused { reason }));
        return;
    }
    let work = move || {
        let _busy = busy;
        // Who has gone needs no answer.
        let _ = serve(&stream, &*answer);
    };
    // Without a thread the connection is closed: the daemon goes on.
    let _ = std::thread::Builder::new().name("request".to_owned()).spawn(work);
}

fn prepare(stream: &UnixStream) -> io::Result<()> {
    stream.set_nonblocking(false)?;
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))
}

fn serve(stream: &UnixStream, answer: &Answer) -> io::Result<()> {
    prepare(stream)?;
    let line = read_request(stream)?;
    if line.is_empty() {
        return Ok(());
    }
    let response = match serde_json::from_slice(&line) {
        Ok(request) => answer(request),
        Err(error) => {
            Response::Refused { reason: format!("the request is not understood: {error}") }
        }
    };
    reply(stream, &response)
}

/// Reads up to the end of a line, within [`PATIENCE`] in all.
fn read_request(mut stream: &UnixStream) -> io::Result<Vec<u8>> {
    let until = Instant::now() + PATIENCE;
    let mut line = Vec::new();
    let mut buffer = [0; 16 << 10];
    let mut is_whole = false;
    while !is_whole {
        let left = until.saturating_duration_since(Instant::now());
        if left.is_zero() || line.len() > LONGEST_REQUEST {
            return Err(io::ErrorKind::InvalidData.into());
        }
        stream.set_read_timeout(Some(left))?;
        match stream.read(&mut buffer)? {
            0 => break,
            count => {
                let read = buffer.get(..count).unwrap_or_default();
                is_whole = read.contains(&b'\n');
                line.extend_from_slice(read);
            }
        }
    }
    Ok(line)
}

fn reply(mut stream: &UnixStream, response: &Response) -> io::Result<()> {
    let mut line = serde_json::to_vec(response)?;
    line.push(b'\n');
    stream.write_all(&line)
}

impl fmt::Debug for ControlListener {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ControlListener").field("paths", &self.paths).finish_non_exhaustive()
    }
}
