//! Progress of long work, on terminals only.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use mapd_compiler::Progress;
use std::io::IsTerminal;
use std::path::Path;

/// A bar on stderr, or nothing where stderr is not a terminal.
pub(crate) struct Bar(ProgressBar);

impl Bar {
    /// A bar for work on a file.
    pub(crate) fn new(path: &Path) -> Self {
        let size = std::fs::metadata(path).map(|m| m.len()).unwrap_or(0);
        if !std::io::stderr().is_terminal() || size == 0 {
            return Self(ProgressBar::hidden());
        }
        let bar = ProgressBar::with_draw_target(Some(size), ProgressDrawTarget::stderr());
        let template = "{msg} [{bar:30}] {bytes}/{total_bytes} {bytes_per_sec} {eta}";
        bar.set_style(
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()),
        );
        Self(bar)
    }

    pub(crate) fn show(&self, progress: Progress) {
        match progress {
            Progress::Reading { bytes, roads } => {
                self.0.set_position(bytes);
                self.0.set_message(format!("reading, {roads} roads"));
            }
            Progress::Linking { roads } => self.0.set_message(format!("linking {roads} roads")),
            Progress::Graph { nodes } => self.0.set_message(format!("graph of {nodes} nodes")),
            Progress::Sampling { lanes } => self.0.set_message(format!("sampling {lanes} lanes")),
            Progress::Indexing { segments } => {
                self.0.set_message(format!("indexing {segments} points"))
            }
        }
    }

    pub(crate) fn finish(&self) {
        self.0.finish_and_clear();
    }
}
