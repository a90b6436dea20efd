//! The stream of top-level elements, read ahead on all cores.
//!
//! One thread, that of the caller, cuts the text into batches and takes what was made of them in order; the pool's threads
//! read, check and lower them. Items and findings are the same, in the same order, as those of a reader without any of this.

use super::part::{Lowered, Plan};
use mapd_xodr::{Context, Cutter, Delivered, Item, ReadBatch, Reader, RestOfDocument};
use std::collections::VecDeque;
use std::io;
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, sync_channel};
use std::time::Duration;

/// Batches that wait or are being read, beyond one for each thread: so many that no thread waits for text.
const AHEAD: usize = 2;
/// How long a thread of the pool waits for a batch before it looks again for work of others.
const PATIENCE: Duration = Duration::from_micros(100);

/// What comes next.
pub(crate) enum Next {
    /// A top-level element.
    Item(Item),
    /// What a batch was lowered to, before the first of its elements.
    Part(Box<Lowered>),
    /// An element of that batch.
    Lowered,
}

/// A batch that was read.
struct FinishedBatch {
    read: ReadBatch,
    /// What it was lowered to, if it was.
    lowered: Option<Box<Lowered>>,
}

/// Top-level elements, one after the other.
pub(crate) struct Stream<'a> {
    pub(crate) reader: Reader<'a>,
    ahead: Option<Ahead<'a>>,
    is_parallel: bool,
    batch_bytes: Option<usize>,
}

/// What is read ahead.
struct Ahead<'a> {
    context: Context,
    cutter: Cutter<'a>,
    reading: VecDeque<Receiver<FinishedBatch>>,
    /// Whether no more batches come.
    is_cut: bool,
}

impl<'a> Stream<'a> {
    /// With one thread in the pool, nothing is read ahead.
    pub(crate) fn new(reader: Reader<'a>, batch_bytes: Option<usize>) -> Self {
        Self { reader, ahead: None, is_parallel: rayon::current_num_threads() > 1, batch_bytes }
    }

    /// As [`Reader::next`]; batches are lowered as `plan` says, if it does.
    pub(crate) fn next(&mut self, plan: &dyn Fn() -> Option<Plan>) -> io::Result<Option<Next>> {
        loop {
            match self.reader.delivered() {
                Some(Delivered::Item(item)) => return Ok(Some(Next::Item(item))),
                Some(Delivered::Taken) => return Ok(Some(Next::Lowered)),
                None => {}
            }
            let Some(ahead) = &mut self.ahead else {
                let item = self.reader.next()?;
                // The version is settled now; what comes is roads.
                if self.is_parallel && matches!(item, Some(Item::Header(_))) {
                    let bytes = self.batch_bytes;
                    self.ahead = self.reader.split().map(|rest| Ahead::new(rest, bytes));
                }
                return Ok(item.map(Next::Item));
            };
            match ahead.next(&self.reader, plan)? {
                Some(FinishedBatch { read, lowered }) => match self.reader.accept(read) {
                    Ok(room) => {
                        ahead.cutter.give_back(room);
                        if let Some(lowered) = lowered {
                            return Ok(Some(Next::Part(lowered)));
                        }
                    }
                    Err(batch) => self.alone(Some(batch))?,
                },
                None => self.alone(None)?,
            }
        }
    }

    /// Reads on without reading ahead.
    fn alone(&mut self, batch: Option<mapd_xodr::Batch>) -> io::Result<()> {
        let Some(mut ahead) = self.ahead.take() else { return Ok(()) };
        self.is_parallel = false;
        let mut batches: Vec<_> = batch.into_iter().collect();
        while let Some(reading) = ahead.reading.pop_front() {
            batches.push(wait(&reading)?.read.into_batch());
        }
        self.reader.go_on(batches, ahead.cutter);
        Ok(())
    }
}

impl<'a> Ahead<'a> {
    fn new(
        RestOfDocument { context, cutter }: RestOfDocument<'a>,
        batch_bytes: Option<usize>,
    ) -> Self {
        let cutter = match batch_bytes {
            Some(bytes) => cutter.with_batch_bytes(bytes),
            None => cutter,
        };
        Self { context, cutter, reading: VecDeque::new(), is_cut: false }
    }

    /// The next batch; none behind the last.
    fn next(
        &mut self,
        reader: &Reader<'_>,
        plan: &dyn Fn() -> Option<Plan>,
    ) -> io::Result<Option<FinishedBatch>> {
        while !self.is_cut && self.reading.len() < rayon::current_num_threads() + AHEAD {
            let Some(batch) = self.cutter.next() else {
                self.is_cut = true;
                break;
            };
            let (done, reading) = sync_channel(1);
            let (context, plan) = (reader.context(&self.context), plan());
            rayon::spawn_fifo(move || {
                let finished = match plan {
                    Some(plan) => {
                        let (read, lowered) = plan.read(&context, batch);
                        FinishedBatch { read, lowered: Some(Box::new(lowered)) }
                    }
                    None => FinishedBatch { read: context.read(batch), lowered: None },
                };
                // Nobody waits for it where reading has failed.
                let _ = done.send(finished);
            });
            self.reading.push_back(reading);
        }
        self.reading.pop_front().map(|reading| wait(&reading)).transpose()
    }
}

/// Waits for a batch; a thread of the pool does other work meanwhile, which may be reading that batch.
fn wait(reading: &Receiver<FinishedBatch>) -> io::Result<FinishedBatch> {
    let lost = || io::Error::other("a thread that read the document ended early");
    if rayon::current_thread_index().is_none() {
        return reading.recv().map_err(|_| lost());
    }
    loop {
        match reading.try_recv() {
            Ok(made) => return Ok(made),
            Err(TryRecvError::Disconnected) => return Err(lost()),
            Err(TryRecvError::Empty) => {}
        }
        if rayon::yield_now() == Some(rayon::Yield::Executed) {
            continue;
        }
        match reading.recv_timeout(PATIENCE) {
            Ok(made) => return Ok(made),
            Err(RecvTimeoutError::Disconnected) => return Err(lost()),
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}
