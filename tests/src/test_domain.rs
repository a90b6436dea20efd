//! Daemons and clients as processes, each test in a domain of its own.

use mapd::control::{MapState, ReloadReport, Request, Response, ask};
use mapd::serve::{PublishMeta, Server, StopSignal};
use mapd_client::Domain;
use mapd_transport::AttachLock;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

/// Longest wait for anything that should take milliseconds; generous because machines may be busy.
pub const PATIENCE: Duration = Duration::from_secs(20);

/// Time between two looks of [`until`].
const LOOK: Duration = Duration::from_millis(5);

/// What `look` finds, as soon as it finds it.
///
/// Panics if it does not within [`PATIENCE`].
pub fn until<T>(what: &str, mut look: impl FnMut() -> Option<T>) -> T {
    let until = Instant::now() + PATIENCE;
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(Instant::now() < until, "{what} does not come");
        std::thread::sleep(LOOK);
    }
}

/// Has a server of the test's own serve an archive; the number of the generation.
///
/// Panics if it cannot.
pub fn publish(server: &mut Server, map: &str, archive: &[u8]) -> u64 {
    let fill = |loan: &mut [u8]| {
        loan.copy_from_slice(archive);
        let content_hash = mapd_archive::open(loan)?.header.content_hash;
        Ok(PublishMeta { layout_id: [0; 32], content_hash, input_hash: [0; 32] })
    };
    server.publish(map, archive.len(), fill).expect("publishes")
}

/// Requests a stop when dropped, so that a server in another thread ends also where a test fails.
pub struct StopAtEnd<'a>(pub &'a StopSignal);

impl Drop for StopAtEnd<'_> {
    fn drop(&mut self) {
        self.0.request();
    }
}

/// The process that compiles a file for a daemon, stopped (SIGSTOP) before it has ended: see [`slow`].
pub struct HeldCompiler(u32);

impl HeldCompiler {
    /// Finds it, and stops it.
    ///
    /// Panics if nobody compiles the file within [`PATIENCE`].
    pub fn of(file: &Path) -> Self {
        let name = file.as_os_str().as_encoded_bytes();
        let found = until(&format!("a compiler of {}", file.display()), || {
            std::fs::read_dir("/proc").expect("processes").flatten().find_map(|entry| {
                let line = std::fs::read(entry.path().join("cmdline")).ok()?;
                let words: Vec<&[u8]> = line.split(|byte| *byte == 0).collect();
                let is_it = words.contains(&name) && words.contains(&b"--child".as_slice());
                is_it.then(|| entry.file_name().to_string_lossy().parse().expect("a number"))
            })
        });
        let held = Self(found);
        held.signal("STOP");
        held
    }

    /// Lets it go on.
    pub fn go_on(&self) {
        self.signal("CONT");
    }

    /// SIGKILL.
    pub fn kill(&self) {
        self.signal("KILL");
    }

    fn signal(&self, name: &str) {
        let status = Command::new("kill").args([&format!("-{name}"), &self.0.to_string()]).status();
        assert!(status.expect("kill runs").success(), "it has ended");
    }
}

/// The text of a map, so long that its compiler is found before it has ended: see [`HeldCompiler`].
pub fn slow(map: &[u8]) -> Vec<u8> {
    /// Enough for a tenth of a second, on any machine that is known.
    const LINES: usize = 1 << 18;
    let text = String::from_utf8_lossy(map);
    let (head, end) = text.rsplit_once("</OpenDRIVE>").expect("a map");
    let line = format!("<!-- {} -->\n", "x".repeat(87));
    [head, &line.repeat(LINES), "</OpenDRIVE>", end].concat().into_bytes()
}

/// A domain of its own for each test; everything of it is removed at the end.
pub struct TestDomain {
    prefix: String,
    program: PathBuf,
    /// The cache of its daemons.
    cache: PathBuf,
}

impl TestDomain {
    /// `program` is the `mapd` to run: `env!("CARGO_BIN_EXE_mapd_under_test")` in a test.
    pub fn new(program: impl AsRef<Path>) -> Self {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let prefix = format!("mt{}x{number}_", std::process::id());
        let cache = std::env::temp_dir().join(format!("{prefix}cache"));
        Self { prefix, program: program.as_ref().to_owned(), cache }
    }

    /// The cache of its daemons, which is made by the first.
    pub fn cache(&self) -> &Path {
        &self.cache
    }

    /// Where its daemons and clients meet.
    pub fn domain(&self) -> Domain {
        Domain::new(&self.prefix).expect("a prefix")
    }

    /// The program, in this domain, all streams piped but stdin.
    pub fn command(&self) -> Command {
        self.command_of(&self.program)
    }

    /// Another program, likewise.
    pub fn command_of(&self, program: impl AsRef<Path>) -> Command {
        let mut command = Command::new(program.as_ref());
        command
            .env("MAPD_PREFIX", &self.prefix)
            .env("MAPD_CACHE", &self.cache)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    /// Starts a daemon and returns once it serves.
    pub fn serve(&self, args: &[&str]) -> Daemon {
        let mut daemon = self.start(args);
        daemon.wait_until_serving();
        daemon
    }

    /// Starts a daemon and does not wait.
    pub fn start(&self, args: &[&str]) -> Daemon {
        let mut command = self.command();
        command.arg("--load").args(args);
        self.spawn(command)
    }

    /// Starts a daemon by a command of the caller's own, and does not wait.
    pub fn spawn(&self, mut command: Command) -> Daemon {
        Daemon(command.spawn().expect("the daemon starts"))
    }

    /// Asks the daemon that serves a map; `None` if none answers.
    pub fn ask(&self, map: &str, request: &Request) -> Option<Response> {
        ask(&self.domain(), map, request, PATIENCE).ok()
    }

    /// What the daemon that serves a map says about it. A map is served a moment before its daemon listens.
    pub fn state(&self, map: &str) -> MapState {
        let start = Instant::now();
        loop {
            match self.ask(map, &Request::Status) {
                Some(Response::Status(status)) => {
                    return status.maps.into_iter().find(|m| m.name == map).expect("the map");
                }
                None if start.elapsed() < PATIENCE => std::thread::sleep(Duration::from_millis(1)),
                other => panic!("no status: {other:?}"),
            }
        }
    }

    /// Has a map reloaded; what came of it.
    pub fn reload(&self, map: &str) -> ReloadReport {
        self.change(map, &Request::Reload { map: map.to_owned(), stage: false })
    }

    /// Asks for a map that nobody serves; the error.
    pub fn change_refused(&self, map: &str) -> String {
        let output = self.command().args(["reload", map]).output().expect("ends");
        assert!(!output.status.success());
        String::from_utf8_lossy(&output.stderr).into_owned()
    }

    /// Has a map changed; what came of it.
    pub fn change(&self, map: &str, request: &Request) -> ReloadReport {
        match self.ask(map, request) {
            Some(Response::Done(report)) => report,
            other => panic!("no outcome: {other:?}"),
        }
    }

    /// `mapd query` with these rows on stdin.
    pub fn query(&self, source: &str, kind: &str, csv: &str) -> Output {
        let mut child = self
            .command()
            .args(["query", source, kind])
            .stdin(Stdio::piped())
            .spawn()
            .expect("starts");
        child.stdin.take().expect("stdin").write_all(csv.as_bytes()).expect("a query is written");
        child.wait_with_output().expect("a query ends")
    }

    /// Files in shared memory that belong to this domain, the root folder left out.
    pub fn segments(&self) -> Vec<PathBuf> {
        let entries = std::fs::read_dir("/dev/shm").expect("shared memory");
        let own = |path: &PathBuf| {
            path.file_name().is_some_and(|n| n.to_string_lossy().starts_with(&self.prefix))
        };
        entries
            .flatten()
            .map(|entry| entry.path())
            .filter(own)
            .filter(|path| path.is_file())
            .collect()
    }
}

impl Drop for TestDomain {
    fn drop(&mut self) {
        for path in self.segments() {
            let _ = std::fs::remove_file(path);
        }
        let _ = std::fs::remove_dir_all(self.domain().root());
        let _ = std::fs::remove_dir_all(&self.cache);
    }
}

/// A daemon; killed when dropped.
pub struct Daemon(Child);

impl Daemon {
    /// Process id.
    pub fn id(&self) -> u32 {
        self.0.id()
    }

    /// Sends it a signal by the name that `kill` knows.
    pub fn signal(&self, name: &str) {
        let status = Command::new("kill")
            .args([&format!("-{name}"), &self.0.id().to_string()])
            .status()
            .expect("kill runs");
        assert!(status.success());
    }

    /// Stops it (SIGSTOP) at a moment when it holds none of the locks that clients take on their way in: what they meet then is a daemon that is stopped, always.
    pub fn pause(&self, place: &TestDomain) {
        let lock = AttachLock::open(&place.domain()).expect("the daemon's lock");
        let until = Instant::now() + PATIENCE;
        loop {
            self.signal("STOP");
            while !self.is_stopped() {
                assert!(Instant::now() < until, "the daemon does not stop");
                std::thread::sleep(Duration::from_millis(1));
            }
            if lock.exclusive(Instant::now()).expect("the lock can be asked").is_some() {
                return;
            }
            assert!(Instant::now() < until, "the daemon keeps the lock");
            self.signal("CONT");
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// Whether each of its threads is stopped.
    fn is_stopped(&self) -> bool {
        let threads = std::fs::read_dir(format!("/proc/{}/task", self.id())).expect("threads");
        // A state follows the name, which ends with the last bracket. A thread that has ended meanwhile runs no more.
        threads.flatten().all(|thread| match std::fs::read_to_string(thread.path().join("stat")) {
            Ok(stat) => stat.rsplit(')').next().is_some_and(|rest| rest.starts_with(" T")),
            Err(_) => true,
        })
    }

    /// Reads its messages until it says that it serves.
    pub fn wait_until_serving(&mut self) {
        if let Err(text) = self.wait_for_serving() {
            panic!("the daemon ended without serving: {text}");
        }
    }

    /// Reads its messages until it says that it serves; gives what it said.
    ///
    /// Errors: it ended before; what it said.
    pub fn wait_for_serving(&mut self) -> Result<String, String> {
        let stderr = self.0.stderr.take().expect("stderr");
        let mut lines = BufReader::new(stderr);
        let mut text = String::new();
        while lines.read_line(&mut text).expect("stderr can be read") > 0 {
            if text.lines().last().is_some_and(|line| line.contains("serving")) {
                // Whatever follows is not needed, but must not block the daemon.
                std::thread::spawn(move || std::io::copy(&mut lines, &mut std::io::sink()));
                return Ok(text);
            }
        }
        Err(text)
    }

    /// SIGKILL.
    pub fn kill(mut self) {
        self.0.kill().expect("killed");
        self.0.wait().expect("waited for");
    }

    /// SIGTERM; the exit code.
    pub fn stop(mut self) -> i32 {
        self.signal("TERM");
        self.0.wait().expect("waited for").code().expect("an exit code")
    }
}

impl Drop for Daemon {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}
