//! The daemon's side of the sockets.

use super::message::{Request, Response};
use super::socket_path;
use crate::places::{Full, Place, Places, Stage};
use mapd_client::Domain;
use mapd_client::overlay::Decision;
use mapd_transport::{LONGEST_PROPOSAL, Share, proposals_socket};
use rustix::event::{PollFd, PollFlags, poll};
use std::fmt;
use std::fs::{self, Permissions};
use std::io::{self, Read, Write};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Mode of a socket: the daemon's user alone.
const SOCKET_MODE: u32 = 0o600;

/// Mode of a socket for proposals where maps are shared with a group.
const SHARED_MODE: u32 = 0o660;

/// How long a client may take in all to send its request, and then to read the answer.
const PATIENCE: Duration = Duration::from_secs(2);

/// Longest request: a document of overlay entries as text in JSON \[bytes\].
const LONGEST_REQUEST: usize = 16 << 20;

/// Pause where connections cannot be taken, as without descriptors that are left.
const PAUSE: Duration = Duration::from_millis(100);

/// Connections at a time.
const MOST_CONNECTIONS: usize = 128;

/// Connections of one user at a time. One more takes the place of the oldest that has sent nothing yet; if all of them are answered, it is refused.
const MOST_OF_A_USER: usize = MOST_CONNECTIONS / 4;

/// What is done with connections, by the number of their socket.
trait Service: Send + Sync {
    /// Serves one, in a thread of its own; may take as long as what is asked for takes.
    fn serve(&self, socket: usize, client: &Client<'_>) -> io::Result<()>;
    /// Answers one that is too many, quickly.
    fn refuse(&self, stream: &UnixStream, reason: String) -> io::Result<()>;
}

/// A process that has connected.
struct Client<'a> {
    stream: &'a UnixStream,
    /// Its user, as the kernel knows it.
    user: u32,
    place: Place,
}

/// Listens on the sockets of a daemon's maps, in a thread of its own. Dropping it removes them: do so while the maps are
/// still claimed, or a successor's would be removed.
pub struct ControlListener {
    paths: Vec<PathBuf>,
    /// Closed to end the thread.
    stop: Option<UnixStream>,
    thread: Option<JoinHandle<()>>,
}

impl ControlListener {
    /// Begins to listen for requests. Only for maps that this process has claimed: what a killed daemon left under a socket's name is
    /// removed.
    ///
    /// Errors: a socket cannot be made.
    pub fn start(
        domain: &Domain,
        maps: &[String],
        answer: impl Fn(Request) -> Response + Send + Sync + 'static,
    ) -> io::Result<Self> {
        let paths = maps.iter().map(|map| socket_path(domain, map)).collect();
        Self::listen_on(paths, Share::Private, Arc::new(Requests(answer)))
    }

    /// Begins to listen for proposals, of members of the group that the maps are shared with too. `decide` gets the map's number among these, the user of the
    /// process, and what it says.
    ///
    /// Errors: a socket cannot be made.
    pub fn start_for_proposals(
        domain: &Domain,
        maps: &[String],
        share: Share,
        decide: impl Fn(usize, u32, &[u8]) -> Decision + Send + Sync + 'static,
    ) -> io::Result<Self> {
        let paths = maps.iter().map(|map| proposals_socket(domain, map)).collect();
        Self::listen_on(paths, share, Arc::new(Proposals(decide)))
    }

    fn listen_on(paths: Vec<PathBuf>, share: Share, service: Arc<dyn Service>) -> io::Result<Self> {
        let (stop, stopped) = UnixStream::pair()?;
        // From here on, dropping it removes what has been made.
        let mut made = Self { paths: Vec::new(), stop: Some(stop), thread: None };
        let mut listeners = Vec::new();
        for path in paths {
            match fs::remove_file(&path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                _ => {}
            }
            let listener = UnixListener::bind(&path)?;
            made.paths.push(path.clone());
            let mut mode = SOCKET_MODE;
            if let Share::Group(group) = share {
                // The group first: no moment at which another one has the rights.
                std::os::unix::fs::chown(&path, None, Some(group))?;
                mode = SHARED_MODE;
            }
            fs::set_permissions(&path, Permissions::from_mode(mode))?;
            listener.set_nonblocking(true)?;
            listeners.push(listener);
        }
        let builder = std::thread::Builder::new().name("control".to_owned());
        made.thread = Some(builder.spawn(move || listen(&stopped, &listeners, &service))?);
        Ok(made)
    }
}

/// Requests of the operator.
struct Requests<F>(F);

impl<F: Fn(Request) -> Response + Send + Sync> Service for Requests<F> {
    fn serve(&self, _: usize, client: &Client<'_>) -> io::Result<()> {
        let stream = client.stream;
        let line = read(stream, LONGEST_REQUEST, true)?;
        client.place.go_on(Stage::IsAnswered)?;
        if line.is_empty() {
            return Ok(());
        }
        let response = match serde_json::from_slice(&line) {
            Ok(request) => self.0(request),
            Err(error) => {
                Response::Refused { reason: format!("the request is not understood: {error}") }
            }
        };
        reply(stream, &response)
    }

    fn refuse(&self, stream: &UnixStream, reason: String) -> io::Result<()> {
        reply(stream, &Response::Refused { reason })
    }
}

/// Proposals of processes on board.
struct Proposals<F>(F);

impl<F: Fn(usize, u32, &[u8]) -> Decision + Send + Sync> Service for Proposals<F> {
    fn serve(&self, socket: usize, client: &Client<'_>) -> io::Result<()> {
        let mut stream = client.stream;
        let text = read(stream, LONGEST_PROPOSAL, false);
        // What has been read of one that loses its place is not all that was to be said.
        client.place.go_on(Stage::IsAnswered)?;
        let decision = match text {
            Ok(text) => self.0(socket, client.user, &text),
            Err(error) if error.kind() == io::ErrorKind::InvalidData => Decision::Refused {
                reason: format!(
                    "expected at most {LONGEST_PROPOSAL} bytes within {} s",
                    PATIENCE.as_secs()
                ),
            },
            Err(error) => return Err(error),
        };
        stream.write_all(decision.line().as_bytes())
    }

    fn refuse(&self, mut stream: &UnixStream, reason: String) -> io::Result<()> {
        stream.write_all(Decision::Refused { reason }.line().as_bytes())
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

fn listen(stopped: &UnixStream, listeners: &[UnixListener], service: &Arc<dyn Service>) {
    let places = Places::new(MOST_CONNECTIONS, MOST_OF_A_USER, Stage::Asks);
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
        for (socket, listener) in listeners.iter().enumerate() {
            loop {
                match listener.accept() {
                    Ok((stream, _)) => connect(stream, socket, &places, service),
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

/// Hands a connection to a thread, if there is a place for it.
fn connect(stream: UnixStream, socket: usize, places: &Arc<Places>, service: &Arc<dyn Service>) {
    let Ok(peer) = rustix::net::sockopt::socket_peercred(&stream) else { return };
    let (user, stream, service) = (peer.uid.as_raw(), Arc::new(stream), service.clone());
    let place = match places.take(user, stream.clone()) {
        Ok(place) => place,
        Err(full) => {
            let reason = match full {
                Full::OfUser => format!(
                    "the daemon is already answering {MOST_OF_A_USER} requests of user {user}"
                ),
                Full::OfAll => {
                    format!("the daemon is already answering {MOST_CONNECTIONS} requests")
                }
            };
            // A client that is refused and has closed the socket needs no answer.
            let _ = prepare(&stream).and_then(|()| service.refuse(&stream, reason));
            return;
        }
    };
    let work = move || {
        let client = Client { stream: &stream, user, place };
        // A client that has closed the socket needs no answer.
        let _ = prepare(&stream).and_then(|()| service.serve(socket, &client));
    };
    // Without a thread the connection is closed: the daemon goes on.
    let _ = std::thread::Builder::new().name("request".to_owned()).spawn(work);
}

fn prepare(stream: &UnixStream) -> io::Result<()> {
    stream.set_nonblocking(false)?;
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))
}

/// Reads up to the end of a line, or of all that is sent, within [`PATIENCE`] in all.
///
/// Errors: what the system says; invalid data if it is too long, or takes too long.
fn read(mut stream: &UnixStream, most: usize, one_line: bool) -> io::Result<Vec<u8>> {
    let until = Instant::now() + PATIENCE;
    let mut line = Vec::new();
    let mut buffer = [0; 16 << 10];
    let mut is_whole = false;
    while !is_whole {
        let left = until.saturating_duration_since(Instant::now());
        if left.is_zero() || line.len() > most {
            return Err(io::ErrorKind::InvalidData.into());
        }
        stream.set_read_timeout(Some(left))?;
        match stream.read(&mut buffer)? {
            0 => break,
            count => {
                let read = buffer.get(..count).unwrap_or_default();
                is_whole = one_line && read.contains(&b'\n');
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
