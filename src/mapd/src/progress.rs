//! How far long work is: a bar where stderr is a terminal, else a line every few seconds, or nothing.

use crate::printable::{printable, printable_lines};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use mapd_compiler::Progress;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, IsTerminal, Write as _};
use std::os::unix::fs::FileExt;
use std::path::Path;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// First bytes of a gzip file.
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// How progress is shown.
#[derive(Clone, Copy, Debug)]
pub enum Manner {
    /// Not at all.
    Silent,
    /// By a bar on terminals, else not at all.
    Bar,
    /// By a bar on terminals, else by a line each time this has passed.
    Lines(Duration),
}

/// Shows how far work is.
pub struct Meter {
    /// Hidden where there is no terminal; of work on a number that is not known, words and the time so far.
    bar: ProgressBar,
    lines: Option<Mutex<Lines>>,
}

impl Meter {
    /// Of work on a file.
    pub fn of_file(path: &Path, manner: Manner) -> Self {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        Self::new(&name, decoded_bytes(path), manner)
    }

    /// Of work on so many bytes; 0: on a number that is not known.
    pub fn new(name: &str, total: u64, manner: Manner) -> Self {
        let name = &*printable(name);
        let is_terminal = io::stderr().is_terminal();
        let lines = match manner {
            Manner::Lines(interval) if !is_terminal => {
                Some(Mutex::new(Lines::new(name, total, interval)))
            }
            _ => None,
        };
        if !is_terminal || matches!(manner, Manner::Silent) {
            return Self { bar: ProgressBar::hidden(), lines };
        }
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr());
        let template = match total {
            0 => "{msg} {elapsed}",
            _ => "{msg} [{bar:30}] {bytes}/{total_bytes} {bytes_per_sec} {eta}",
        };
        bar.set_style(
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()),
        );
        Self { bar, lines }
    }

    /// Shows a compilation's progress.
    pub fn show(&self, progress: Progress) {
        match progress {
            Progress::Reading { bytes, roads } => {
                self.read(bytes, || format!("reading, {roads} roads"));
            }
            Progress::Linking { roads } => self.stage(|| format!("linking {roads} roads")),
            Progress::Graph { nodes } => self.stage(|| format!("graph of {nodes} nodes")),
            Progress::Sampling { lanes } => self.stage(|| format!("sampling {lanes} lanes")),
            Progress::Indexing { bytes } => {
                self.stage(|| format!("indexing {} of points", amount(bytes as f64)));
            }
        }
    }

    /// Shows how much has been read, and what was made of it.
    pub(crate) fn read(&self, bytes: u64, made: impl Fn() -> String) {
        if !self.bar.is_hidden() {
            self.bar.set_position(bytes);
            self.bar.set_message(made());
        }
        self.line(|lines, now| lines.read(now, bytes, made));
    }

    /// Shows what is being done.
    pub fn stage(&self, doing: impl Fn() -> String) {
        if !self.bar.is_hidden() {
            self.bar.set_message(doing());
        }
        self.line(|lines, now| lines.stage(now, &doing()));
    }

    /// Says something else at once, in lines, on stderr.
    pub(crate) fn say(&self, text: &str) {
        // A closed stderr is nobody's loss.
        let text = printable_lines(text);
        self.bar.suspend(|| drop(io::stderr().lock().write_all(text.as_bytes())));
    }

    /// Ends it.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    fn line(&self, say: impl FnOnce(&mut Lines, Duration) -> Option<String>) {
        let Some(lines) = &self.lines else { return };
        // One that panicked has left times and numbers, which serve as well.
        let mut lines = lines.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let now = lines.begun.elapsed();
        if let Some(line) = say(&mut lines, now) {
            let _ = writeln!(io::stderr(), "{line}");
        }
    }
}

/// Lines of progress. Times are since the beginning.
struct Lines {
    name: String,
    total: u64,
    interval: Duration,
    begun: Instant,
    /// When the next line is due.
    due: Duration,
    /// When reading began, which it does again where parts are left out.
    reading_since: Duration,
    bytes: u64,
}

impl Lines {
    fn new(name: &str, total: u64, interval: Duration) -> Self {
        Self {
            name: name.to_owned(),
            total,
            interval,
            begun: Instant::now(),
            due: interval,
            reading_since: Duration::ZERO,
            bytes: 0,
        }
    }

    fn is_due(&mut self, now: Duration) -> bool {
        let is_due = now >= self.due;
        if is_due {
            self.due = now + self.interval;
        }
        is_due
    }

    /// A line, if one is due: bytes, percent, what was made of them, bytes per second, time left.
    fn read(&mut self, now: Duration, bytes: u64, made: impl Fn() -> String) -> Option<String> {
        if bytes < self.bytes {
            self.reading_since = now;
        }
        self.bytes = bytes;
        if !self.is_due(now) {
            return None;
        }
        let mut line = format!("{}: {}", self.name, amount(bytes as f64));
        let seconds = now.saturating_sub(self.reading_since).as_secs_f64();
        let rate = if seconds > 0.0 { bytes as f64 / seconds } else { 0.0 };
        // Bytes of included files, or of a file that grows, are not in the sum.
        let total = self.total.max(bytes);
        if self.total > 0 {
            let share = 100.0 * bytes as f64 / total as f64;
            let _ = write!(line, " of {} ({share:.0} %)", amount(total as f64));
        }
        let _ = write!(line, ", {}, {}/s", made(), amount(rate));
        if self.total > 0 && rate > 0.0 {
            let _ = write!(line, ", {:.0} s left", (total - bytes) as f64 / rate);
        }
        Some(line)
    }

    /// A line, if one is due: what is being done, and how long it has taken so far.
    fn stage(&mut self, now: Duration, doing: &str) -> Option<String> {
        self.is_due(now)
            .then(|| format!("{}: {doing}, {:.0} s so far", self.name, now.as_secs_f64()))
    }
}

/// Bytes as people read them.
fn amount(bytes: f64) -> String {
    let units = [(1e9, "GB"), (1e6, "MB")];
    let (unit, name) = units.into_iter().find(|(unit, _)| bytes >= *unit).unwrap_or((1e3, "kB"));
    format!("{:.1} {name}", bytes / unit)
}

/// Bytes of a file, or of what it holds if it is compressed (as gzip's last field has them: of the last member, modulo 4 GiB);
/// 0 if that is not known.
pub(crate) fn decoded_bytes(path: &Path) -> u64 {
    // Pipes are opened once, by who reads them.
    let Some(length) = std::fs::metadata(path).ok().filter(|m| m.is_file()).map(|m| m.len()) else {
        return 0;
    };
    let Ok(file) = File::open(path) else { return length };
    let (mut first, mut last) = ([0; 2], [0; 4]);
    let is_gzip = file.read_exact_at(&mut first, 0).is_ok() && first == GZIP;
    if is_gzip && file.read_exact_at(&mut last, length.saturating_sub(4)).is_ok() {
        return u64::from(u32::from_le_bytes(last)).max(length);
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_at_most_each_interval() {
        let mut lines = Lines::new("a.xodr", 10_000_000, Duration::from_secs(5));
        let mut read = |seconds, bytes| {
            lines.read(Duration::from_secs(seconds), bytes, || "3 roads".to_owned())
        };
        assert_eq!(read(1, 1_000_000), None);
        let line = "a.xodr: 2.5 MB of 10.0 MB (25 %), 3 roads, 500.0 kB/s, 15 s left";
        assert_eq!(read(5, 2_500_000).as_deref(), Some(line));
        assert_eq!(read(9, 5_000_000), None);
        // Read again from the start, without some part.
        assert_eq!(
            read(10, 0).as_deref(),
            Some("a.xodr: 0.0 kB of 10.0 MB (0 %), 3 roads, 0.0 kB/s")
        );
        let line = "a.xodr: 20.0 MB of 20.0 MB (100 %), 3 roads, 2.0 MB/s, 0 s left";
        assert_eq!(read(20, 20_000_000).as_deref(), Some(line), "more than expected");
        let stage = lines.stage(Duration::from_secs(30), "indexing");
        assert_eq!(stage.as_deref(), Some("a.xodr: indexing, 30 s so far"));
    }

    #[test]
    fn of_pipes_the_size_is_not_known() {
        let mut lines = Lines::new("pipe", 0, Duration::ZERO);
        let line = lines.read(Duration::from_secs(2), 1_000_000, || "3 roads".to_owned());
        assert_eq!(line.as_deref(), Some("pipe: 1.0 MB, 3 roads, 500.0 kB/s"));
        assert_eq!(decoded_bytes(Path::new("/dev/null")), 0);
    }
}
