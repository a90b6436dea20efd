//! The thread that prepares maps, one after the other, while the daemon serves.

use super::desk::Desk;
use super::orders::{Job, Order, Orders};
use super::prepare::Preparer;
use super::settings::MapSettings;
use crate::control::{Board, CacheStatus};
use crate::joining::join_soon;
use std::io;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{Sender, channel};
use std::thread::JoinHandle;

/// Prepares maps in a thread of its own. Dropping it ends what it is at.
pub(crate) struct Worker {
    jobs: Option<Sender<Job>>,
    preparer: Preparer,
    thread: Option<JoinHandle<()>>,
}

impl Worker {
    /// Errors: no thread can be had.
    pub(crate) fn start(
        preparer: Preparer,
        maps: Vec<MapSettings>,
        board: Arc<Board>,
        desk: Arc<Desk>,
        orders: Orders,
    ) -> io::Result<Self> {
        let (jobs, received) = channel::<Job>();
        let own = preparer.clone();
        let work = move || {
            for job in received {
                let Some(map) = maps.iter().find(|map| map.name == job.change.map) else {
                    continue;
                };
                if own.cancelled.load(Ordering::Relaxed) {
                    return;
                }
                let prepared = own.prepare(map, job.anew);
                if let Some(cache) = &own.cache {
                    board.cache(CacheStatus::of(cache));
                }
                if let Ok(prepared) = &prepared {
                    desk.place_on_next(&map.name, prepared);
                }
                orders.give(Order::Prepared(Box::new(job), prepared));
            }
        };
        let thread = std::thread::Builder::new().name("prepare".to_owned()).spawn(work)?;
        Ok(Self { jobs: Some(jobs), preparer, thread: Some(thread) })
    }

    /// Has a map prepared, after those that wait already.
    pub(crate) fn prepare(&self, job: Job) {
        if let Some(jobs) = &self.jobs {
            // Fails only if the thread has panicked; the client that waits for the outcome is then told that there is none.
            let _ = jobs.send(job);
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.preparer.cancelled.store(true, Ordering::Relaxed);
        self.jobs = None;
        join_soon(self.thread.take());
    }
}
