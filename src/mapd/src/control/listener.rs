//! The daemon's side of the sockets.

use super::message::{Request, Response};
use super::{LONGEST_LINE, socket_path};
use mapd_client::Domain;
use rustix::event::{PollFd, PollFlags, poll};
use std::fmt;
use std::fs::{self, Permissions};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

/// Mode of a socket: the daemon's user alone.
const SOCKET_MODE: u32 = 0o600;

/// How long who asks may take to say what, and to take the answer.
const PATIENCE: Duration = Duration::from_secs(2);

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
            while let Ok((stream, _)) = listener.accept() {
                connect(stream, &busy, answer);
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
        let reason = format!("{MOST_CONNECTIONS} requests are being answered already");
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
    let mut line = String::new();
    BufReader::new(stream.take(LONGEST_LINE)).read_line(&mut line)?;
    if line.is_empty() {
        return Ok(());
    }
    let response = match serde_json::from_str(&line) {
        Ok(request) => answer(request),
        Err(error) => {
            Response::Refused { reason: format!("the request is not understood: {error}") }
        }
    };
    reply(stream, &response)
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
