//! What must hold after every kill.

use mapd_client::glam::DVec2;
use mapd_client::{Attach, AttachError, Client, ClientError, NearestOptions, Snapshot};
use mapd_tests::stage::{ATTACH_DEADLINE, Checked, Stage};
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Longest time until what a killed client held has been given back: some rounds of the daemon.
const SETTLE: Duration = Duration::from_secs(20);

/// Wait that makes a client its listener: nothing is to come.
const LISTENS: Duration = Duration::from_millis(50);

/// A point in the middle of a lane of `one_road`.
const POINT: DVec2 = DVec2::new(10.0, -1.5);

/// Clients of this process, one of each kind, which live through everything.
pub(crate) struct Witness([Follower; 2]);

/// A client, and a snapshot that it holds.
struct Follower {
    client: Client,
    held: Snapshot,
    lane: String,
}

impl Witness {
    pub(crate) fn new(stage: &Stage) -> Checked<Self> {
        let of = |attach| Follower::new(stage, attach);
        Ok(Self([of(Attach::Subscriber)?, of(Attach::Observer)?]))
    }

    /// The held snapshots are whole and answer as ever.
    pub(crate) fn still_reads(&self) -> Checked<()> {
        self.0.iter().try_for_each(Follower::still_reads)
    }

    /// A newer generation arrives, has the same content, and both are right; then only the newer one is held.
    pub(crate) fn follows(&mut self) -> Checked<()> {
        self.0.iter_mut().try_for_each(Follower::follows)
    }

    /// Takes the newest generation that has come, if one has; it is whole and answers as ever.
    pub(crate) fn keeps_up(&mut self) -> Checked<()> {
        self.0.iter_mut().try_for_each(Follower::keeps_up)
    }
}

impl Follower {
    fn new(stage: &Stage, attach: Attach) -> Checked<Self> {
        let client = stage.client(attach, ATTACH_DEADLINE);
        let client = client.map_err(|error| format!("the witness, {attach:?}: {error}"))?;
        // Once it waits, it holds a listener, too. From the start, or its files would look like what a killed process left.
        let held = match client.wait_next(LISTENS) {
            Ok(newer) => newer,
            Err(_) => client.snapshot(),
        };
        let lane = answer(&held)?;
        Ok(Self { client, held, lane })
    }

    fn still_reads(&self) -> Checked<()> {
        self.held.verify().map_err(|error| format!("the held snapshot: {error}"))?;
        match answer(&self.held)? {
            lane if lane == self.lane => Ok(()),
            lane => Err(format!("the held snapshot answers {lane} instead of {}", self.lane)),
        }
    }

    fn follows(&mut self) -> Checked<()> {
        let attach = self.client.attachment();
        let next = self.client.wait_next(ATTACH_DEADLINE).map_err(|error| {
            format!("the witness, {attach:?}, does not get the next generation: {error}")
        })?;
        if next.generation() <= self.held.generation() {
            return Err("the generation did not rise".to_owned());
        }
        self.still_reads()?;
        self.held = next;
        self.still_reads()
    }

    fn keeps_up(&mut self) -> Checked<()> {
        self.held = self.client.refresh().map_err(|error| format!("the witness: {error}"))?;
        self.still_reads()
    }
}

fn answer(snapshot: &Snapshot) -> Checked<String> {
    let map = snapshot.map();
    let hit = map.nearest_lane(POINT, &NearestOptions::default());
    let lane = hit.map_err(|error| error.to_string())?.ok_or("no lane")?.lane;
    Ok(map.lane(lane).map_err(|error| error.to_string())?.key().to_string())
}

/// What a daemon leaves that was killed: an observer finds a whole generation, or that there is none. Never anything damaged.
pub(crate) fn is_found_whole_or_not(stage: &Stage) -> Checked<()> {
    match stage.client(Attach::Observer, Duration::ZERO) {
        Ok(client) => {
            let found = client.snapshot();
            found.verify().map_err(|error| format!("what a killed daemon left: {error}"))?;
            answer(&found).map(|_| ())
        }
        Err(ClientError::Attach(
            AttachError::NoDaemon { .. } | AttachError::NoGeneration { .. },
        )) => Ok(()),
        Err(error) => Err(format!("what a killed daemon left: {error}")),
    }
}

/// Nothing of the domain is left.
pub(crate) fn nothing_left(stage: &Stage) -> Checked<()> {
    let left = stage.files();
    if left.is_empty() { Ok(()) } else { Err(format!("left behind: {left:?}")) }
}

/// No more files are left than there were, by kind, after the daemon has had the time to clean up.
pub(crate) fn settles(stage: &Stage, before: &BTreeSet<PathBuf>) -> Checked<()> {
    let until = Instant::now() + SETTLE;
    loop {
        let now = stage.files();
        if now.len() <= before.len() {
            return Ok(());
        }
        if Instant::now() >= until {
            let new: Vec<_> = now.difference(before).collect();
            return Err(format!("not given back: {new:?}"));
        }
        std::thread::sleep(Duration::from_millis(50));
    }
}
