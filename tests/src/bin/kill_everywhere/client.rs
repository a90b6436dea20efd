//! The client as victim, while one daemon serves all the time.

use crate::holder::Stage;
use crate::{Plan, Tally, trace};
use std::time::Duration;

/// After the last kill the daemon has this long to clean up. It does so about once a second; what may belong to a process
/// that is just leaving it lets lie for ten.
const CLEAN_UP: Duration = Duration::from_secs(30);

pub(crate) fn kill_everywhere(plan: &Plan) -> Result<Tally, Box<dyn std::error::Error>> {
    let stage = Stage::new()?;
    let daemon = stage.place.serve(&[&stage.archive.display().to_string()]);
    stage.fresh()?;
    let before = stage.left().len();
    let log = tempfile::NamedTempFile::new()?;
    let whole = trace::logging(&stage.client(), log.path()).status()?;
    if !whole.success() {
        return Err("the client fails even where nobody kills it".into());
    }
    let calls = trace::calls(&std::fs::read_to_string(log.path())?);
    let mut tally = Tally::default();
    for call in calls.iter().step_by(plan.step) {
        trace::killing(&stage.client(), call).output()?;
        tally.kills += 1;
        match stage.fresh() {
            Ok(taken) => tally.worst_ms = tally.worst_ms.max(taken.as_millis()),
            Err(error) => tally.bad.push(format!("{call:?}: {error}")),
        }
    }
    // What the killed ones left goes away while the daemon serves.
    let start = std::time::Instant::now();
    while stage.left().len() > before && start.elapsed() < CLEAN_UP {
        std::thread::sleep(Duration::from_millis(100));
    }
    let left = stage.left();
    if left.len() > before {
        tally.bad.push(format!("{} files instead of {before}: {left:?}", left.len()));
    }
    let code = daemon.stop();
    if code != 0 || !stage.left().is_empty() {
        tally.bad.push(format!("the daemon ended with {code} and left {:?}", stage.left()));
    }
    Ok(tally)
}
