//! The stream of top-level elements, read ahead on all cores.
//!
//! One thread, that of the caller, cuts the text into batches and takes what was read of them in order; the pool's threads
//! read them. Items and findings are the same, in the same order, as those of a reader without any of this.

use mapd_xodr::{Context, Cutter, Item, ReadBatch, Reader};
use std::collections::VecDeque;
use std::io;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TryRecvError, sync_channel};
use std::time::Duration;

/// Batches that wait or are being read, beyond one for each thread: so many that no thread waits for text.
const AHEAD: usize = 2;
/// How long a thread of the pool waits for a batch before it looks again for work of others.
const PATIENCE: Duration = Duration::from_micros(100);

/// Top-level elements, one after the other.
pub(crate) struct Stream<'a> {
    pub(crate) reader: Reader<'a>,
    ahead: Option<Ahead<'a>>,
    is_parallel: bool,
}

/// What is read ahead.
struct Ahead<'a> {
    context: Context,
    cutter: Cutter<'a>,
    reading: VecDeque<Receiver<ReadBatch>>,
    /// Whether no more batches come.
    is_cut: bool,
}

impl<'a> Stream<'a> {
    /// With one thread in the pool, nothing is read ahead.
    pub(crate) fn new(reader: Reader<'a>) -> Self {
        Self { reader, ahead: None, is_parallel: rayon::current_num_threads() > 1 }
    }

    /// As [`Reader::next`].
    pub(crate) fn next(&mut self) -> io::Result<Option<Item>> {
        loop {
            if let Some(item) = self.reader.accepted() {
                return Ok(Some(item));
            }
            let Some(ahead) = &mut self.ahead else {
                let item = self.reader.next()?;
                // The version is settled now; what comes is roads.
                if self.is_parallel && matches!(item, Some(Item::Header(_))) {
                    self.ahead = self.reader.split().map(Ahead::new);
                }
                return Ok(item);
            };
            match ahead.next()? {
                Some(read) => {
                    let Err(batch) = self.reader.accept(read) else { continue };
                    self.alone(Some(batch))?;
                }
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
            batches.push(wait(&reading)?.into_batch());
        }
        self.reader.go_on(batches, ahead.cutter);
        Ok(())
    }
}

impl<'a> Ahead<'a> {
    fn new((context, cutter): (Context, Cutter<'a>)) -> Self {
        Self { context, cutter, reading: VecDeque::new(), is_cut: false }
    }

    /// The next batch; none behind the last.
    fn next(&mut self) -> io::Result<Option<ReadBatch>> {
        while !self.is_cut && self.reading.len() < rayon::current_num_threads() + AHEAD {
            let Some(batch) = self.cutter.next() else {
                self.is_cut = true;
                break;
            };
            let (done, reading) = sync_channel(1);
            let context = self.context.clone();
            rayon::spawn_fifo(move || read(&context, batch, &done));
            self.reading.push_back(reading);
        }
        self.reading.pop_front().map(|reading| wait(&reading)).transpose()
    }
}

fn read(context: &Context, batch: mapd_xodr::Batch, done: &SyncSender<ReadBatch>) {
    // Nobody waits for it where reading has failed.
    let _ = done.send(context.read(batch));
}

/// Waits for a batch; a thread of the pool does other work meanwhile, which may be reading that batch.
fn wait(reading: &Receiver<ReadBatch>) -> io::Result<ReadBatch> {
    let lost = || io::Error::other("a thread that read the document ended early");
    if rayon::current_thread_index().is_none() {
        return reading.recv().map_err(|_| lost());
    }
    loop {
        match reading.try_recv() {
            Ok(read) => return Ok(read),
            Err(TryRecvError::Disconnected) => return Err(lost()),
            Err(TryRecvError::Empty) => {}
        }
        if rayon::yield_now() == Some(rayon::Yield::Executed) {
            continue;
        }
        match reading.recv_timeout(PATIENCE) {
            Ok(read) => return Ok(read),
            Err(RecvTimeoutError::Disconnected) => return Err(lost()),
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}
