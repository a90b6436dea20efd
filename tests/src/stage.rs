//! A domain of its own with one map, where daemons and clients are processes that may be killed.

use crate::test_domain::TestDomain;
use mapd_client::{Attach, Client, ClientError, Domain};
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::collections::BTreeSet;
use std::io::{self, BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Output, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Longest wait for a daemon to serve or to end, which takes some milliseconds; machines may be busy.
pub const DAEMON_PATIENCE: Duration = Duration::from_secs(60);

/// Deadline of a fresh client, and of a request to a daemon, which needs some milliseconds.
pub const ATTACH_DEADLINE: Duration = Duration::from_secs(20);

/// What a process may need besides waiting: to be started on a busy machine, to open the map, to answer.
const PROCESS_SLACK: Duration = Duration::from_secs(20);

/// Pause between two looks at a child.
const PAUSE: Duration = Duration::from_micros(500);

/// A failed check, in words.
pub type Checked<T> = Result<T, String>;

/// A domain of its own with one map.
pub struct Stage {
    place: TestDomain,
    map: PathBuf,
    question: String,
    answer: String,
}

impl Stage {
    /// A domain for `map`, to be served by the program `mapd`, with the right answer to `question` (CSV for
    /// `mapd query … nearest`), had from the file.
    ///
    /// Errors: the file cannot be queried.
    pub fn new(mapd: &Path, map: &Path, question: &str) -> Checked<Self> {
        let (map, question) = (map.to_owned(), question.to_owned());
        let stage = Self { place: TestDomain::new(mapd), map, question, answer: String::new() };
        let output = stage.ask(&stage.map.display().to_string(), DAEMON_PATIENCE)?;
        if !output.status.success() {
            return Err(format!("from the file: {}", stderr_of(&output)));
        }
        Ok(Self { answer: stdout_of(&output), ..stage })
    }

    /// The domain.
    pub fn domain(&self) -> Domain {
        self.place.domain()
    }

    /// Name of the map.
    pub fn name(&self) -> String {
        self.map.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// What a client asks.
    pub fn question(&self) -> &str {
        &self.question
    }

    /// Removes the cache of its daemons, as anyone may at any time.
    pub fn forget_cache(&self) {
        let _ = std::fs::remove_dir_all(self.place.cache());
    }

    /// The program in this domain.
    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = self.place.command();
        command.args(args).stdout(Stdio::null());
        command
    }

    /// Changes the map's file, but not what a client is answered. Only for a file of the caller's own.
    ///
    /// Errors: the file cannot be replaced.
    pub fn touch_map(&self) -> Checked<()> {
        let mut text = std::fs::read(&self.map).map_err(text)?;
        text.push(b'\n');
        let new = self.map.with_extension("new");
        std::fs::write(&new, text)
            .and_then(|()| std::fs::rename(&new, &self.map))
            .map_err(self::text)
    }

    /// What a daemon is asked to do with the map, such as `reload`.
    pub fn ask_command(&self, what: &[&str]) -> Command {
        let mut command = self.command(what);
        let wait = ATTACH_DEADLINE.as_secs_f64().to_string();
        command.arg(self.name()).args(["--wait", &wait]);
        command
    }

    /// A daemon that is to serve the map.
    pub fn daemon_command(&self) -> Command {
        self.command(&["--load", &self.map.display().to_string()])
    }

    /// A client that attaches in this way, asks, and detaches.
    pub fn client_command(&self, attach: Attach) -> Command {
        let wait = ATTACH_DEADLINE.as_secs_f64().to_string();
        let map = format!("shm:{}", self.name());
        self.command(&["query", &map, "nearest", "--wait", &wait, "--attach", option(attach)])
    }

    /// Starts a daemon and waits until it serves.
    ///
    /// Errors: it ended, or did not serve in time; with what it said.
    pub fn serve(&self) -> Checked<Daemon> {
        let mut daemon = Daemon::spawn(self.daemon_command())?;
        daemon.wait_for("serving")?;
        Ok(daemon)
    }

    /// Asks the served map by fresh processes, an observer and a subscriber. The time that the slower one took, if both answers are
    /// that of the file.
    ///
    /// Errors: no answer in time; another answer.
    pub fn fresh_client(&self) -> Checked<Duration> {
        let mut longest = Duration::ZERO;
        for attach in [Attach::Observer, Attach::Subscriber] {
            let start = Instant::now();
            let output = self.ask_as(attach, &format!("shm:{}", self.name()), ATTACH_DEADLINE)?;
            if !output.status.success() {
                let said = stderr_of(&output);
                return Err(format!("a fresh client, {attach:?}: {}: {said}", output.status));
            }
            let (answer, right) = (stdout_of(&output), &self.answer);
            if answer != *right {
                return Err(format!("a fresh client answers {answer:?} instead of {right:?}"));
            }
            longest = longest.max(start.elapsed());
        }
        Ok(longest)
    }

    /// A client within this process, attached in this way.
    ///
    /// Errors: as [`Client::connect_as`].
    pub fn client(&self, attach: Attach, wait: Duration) -> Result<Client, ClientError> {
        Client::connect_as(attach, &self.domain(), &self.name(), wait)
    }

    /// All files of the domain: in shared memory and, recursively, in its root folder.
    pub fn files(&self) -> BTreeSet<PathBuf> {
        let (mut found, domain) = (BTreeSet::new(), self.domain());
        for entry in std::fs::read_dir("/dev/shm").into_iter().flatten().flatten() {
            if entry.file_name().to_string_lossy().starts_with(domain.prefix()) {
                collect(&entry.path(), &mut found);
            }
        }
        found
    }

    fn ask(&self, source: &str, wait: Duration) -> Checked<Output> {
        self.ask_as(Attach::default(), source, wait)
    }

    fn ask_as(&self, attach: Attach, source: &str, wait: Duration) -> Checked<Output> {
        let wait_text = wait.as_secs_f64().to_string();
        let args = ["query", source, "nearest", "--wait", &wait_text, "--attach", option(attach)];
        let mut command = self.command(&args);
        let mut child =
            command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().map_err(text)?;
        if let Some(mut stdin) = child.stdin.take() {
            // A process that ends early says so by its exit code.
            let _ = stdin.write_all(self.question.as_bytes());
        }
        match wait_for_end(&mut child, wait + PROCESS_SLACK)? {
            Some(_) => child.wait_with_output().map_err(text),
            None => {
                let _ = child.kill();
                let _ = child.wait();
                Err(format!("a client hangs: no end {:?} after its deadline", PROCESS_SLACK))
            }
        }
    }
}

/// The value of `--attach`.
fn option(attach: Attach) -> &'static str {
    match attach {
        Attach::Subscriber => "subscriber",
        _ => "observer",
    }
}

/// A daemon. Dropping it kills it.
pub struct Daemon {
    child: Child,
    lines: Receiver<String>,
    said: Vec<String>,
}

impl Daemon {
    /// Starts a program, listening to its standard error.
    ///
    /// Errors: it cannot be started.
    pub fn spawn(mut command: Command) -> Checked<Self> {
        let mut child = command.stderr(Stdio::piped()).spawn().map_err(text)?;
        let (sender, lines) = channel();
        if let Some(stderr) = child.stderr.take() {
            std::thread::spawn(move || {
                for line in BufReader::new(stderr).lines().map_while(io::Result::ok) {
                    if sender.send(line).is_err() {
                        return;
                    }
                }
            });
        }
        Ok(Self { child, lines, said: Vec::new() })
    }

    /// Its process.
    pub fn pid(&self) -> Pid {
        Pid::from_raw(self.child.id() as i32)
    }

    /// Waits until it says a line with this word.
    ///
    /// Errors: it does not within [`DAEMON_PATIENCE`], or ends before; with what it said.
    pub fn wait_for(&mut self, word: &str) -> Checked<()> {
        let until = Instant::now() + DAEMON_PATIENCE;
        loop {
            match self.lines.recv_timeout(until.saturating_duration_since(Instant::now())) {
                Ok(line) => {
                    let found = line.contains(word);
                    self.said.push(line);
                    if found {
                        return Ok(());
                    }
                }
                Err(RecvTimeoutError::Timeout) => {
                    return Err(format!("a daemon does not say {word:?} in time: {:?}", self.said));
                }
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(format!("a daemon ended: {:?}", self.said));
                }
            }
        }
    }

    /// Whether it still runs.
    pub fn is_running(&mut self) -> bool {
        matches!(self.child.try_wait(), Ok(None))
    }

    /// SIGTERM, and a wait for the end.
    ///
    /// Errors: it does not end in time, or badly.
    pub fn stop(mut self) -> Checked<()> {
        kill(self.pid(), Signal::SIGTERM).map_err(text)?;
        match wait_for_end(&mut self.child, DAEMON_PATIENCE)? {
            Some(status) if status.success() => Ok(()),
            Some(status) => Err(format!("a stopped daemon ends with {status}: {:?}", self.rest())),
            None => Err(format!("a stopped daemon does not end: {:?}", self.rest())),
        }
    }

    /// SIGKILL.
    pub fn kill(self) {}

    /// Waits for its end; what it said, as one text.
    ///
    /// Errors: it does not end within [`DAEMON_PATIENCE`].
    pub fn end(mut self) -> Checked<(ExitStatus, String)> {
        match wait_for_end(&mut self.child, DAEMON_PATIENCE)? {
            Some(status) => Ok((status, self.rest().join("\n"))),
            None => Err(format!("does not end: {:?}", self.said)),
        }
    }

    fn rest(&mut self) -> &[String] {
        self.said.extend(self.lines.try_iter());
        while let Ok(line) = self.lines.recv_timeout(Duration::from_millis(50)) {
            self.said.push(line);
        }
        &self.said
    }
}

impl Drop for Daemon {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Waits until a child ends; `None` if it does not in time.
fn wait_for_end(child: &mut Child, patience: Duration) -> Checked<Option<ExitStatus>> {
    let until = Instant::now() + patience;
    loop {
        match child.try_wait().map_err(text)? {
            Some(status) => return Ok(Some(status)),
            None if Instant::now() >= until => return Ok(None),
            None => std::thread::sleep(PAUSE),
        }
    }
}

fn collect(path: &Path, into: &mut BTreeSet<PathBuf>) {
    into.insert(path.to_owned());
    for entry in std::fs::read_dir(path).into_iter().flatten().flatten() {
        collect(&entry.path(), into);
    }
}

fn stdout_of(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn stderr_of(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn text(error: impl std::fmt::Display) -> String {
    error.to_string()
}
