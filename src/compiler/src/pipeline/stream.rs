//! The stream of top-level elements, read ahead on all cores.
//!
//! The pool's threads cut the text into batches, one thread at a time, and each reads, checks and lowers what it has cut. One thread,
//! that of the caller, takes what was made of them in order. Items and findings are the same, in the same order, as those of a reader
//! without any of this.

use super::in_order::lock;
use super::part::{Lowered, Plan};
use mapd_xodr::{Context, Cutter, Delivered, Item, ReadBatch, Reader, RestOfDocument};
use rayon::ScopeFifo;
use std::collections::VecDeque;
use std::io;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, TryRecvError, channel, sync_channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Batches that wait or are being read, beyond one for each thread: so many that no thread waits for the one that takes them.
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
pub(crate) struct Stream<'a, 's> {
    pub(crate) reader: Reader<'a>,
    ahead: Option<Ahead<'a>>,
    is_parallel: bool,
    batch_bytes: Option<usize>,
    /// Where the text is cut.
    scope: &'s ScopeFifo<'a>,
    between: Between,
}

/// What threads do between two batches.
pub(super) type Between = Arc<dyn Fn() + Send + Sync>;

/// A batch that is being read; none behind the last.
type Reading = Receiver<Option<FinishedBatch>>;

/// What is read ahead.
struct Ahead<'a> {
    context: Context,
    shared: Arc<Shared<'a>>,
    /// Batches in the order of the document.
    cut: (Sender<Reading>, Receiver<Reading>),
    /// Number of batches that may be cut or are, and have not been taken.
    ordered: usize,
}

/// What all have who cut.
struct Shared<'a> {
    /// None when the document is read on without batches.
    cutter: Mutex<Option<Cutter<'a>>>,
    orders: Mutex<Orders>,
    between: Between,
}

/// What there is to cut.
#[derive(Default)]
struct Orders {
    /// How each of the next batches is read.
    plans: VecDeque<(Context, Option<Plan>)>,
    /// Threads that cut and read.
    threads: usize,
    /// Room of batches that are done with.
    rooms: Vec<Vec<u8>>,
}

impl<'a, 's> Stream<'a, 's> {
    /// With one thread in the pool, nothing is read ahead. The text is cut within `scope`; threads do what is to be done `between` two batches.
    pub(crate) fn new(
        reader: Reader<'a>,
        batch_bytes: Option<usize>,
        scope: &'s ScopeFifo<'a>,
        between: Between,
    ) -> Self {
        let is_parallel = rayon::current_num_threads() > 1;
        Self { reader, ahead: None, is_parallel, batch_bytes, scope, between }
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
                    let between = Arc::clone(&self.between);
                    self.ahead = self.reader.split().map(|rest| Ahead::new(rest, bytes, between));
                }
                return Ok(item.map(Next::Item));
            };
            match ahead.next(&self.reader, plan, self.scope)? {
                Some(FinishedBatch { read, lowered }) => match self.reader.accept(read) {
                    Ok(room) => {
                        lock(&ahead.shared.orders).rooms.push(room);
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
        let Some(ahead) = self.ahead.take() else { return Ok(()) };
        self.is_parallel = false;
        let mut batches: Vec<_> = batch.into_iter().collect();
        // Whoever cuts comes to an end first; from then on nobody does.
        let Some(cutter) = lock(&ahead.shared.cutter).take() else { return Err(lost()) };
        while let Ok(reading) = ahead.cut.1.try_recv() {
            batches.extend(wait(&reading)?.map(|batch| batch.read.into_batch()));
        }
        self.reader.go_on(batches, cutter);
        Ok(())
    }
}

impl<'a> Ahead<'a> {
    fn new(
        RestOfDocument { context, cutter }: RestOfDocument<'a>,
        batch_bytes: Option<usize>,
        between: Between,
    ) -> Self {
        let cutter = match batch_bytes {
            Some(bytes) => cutter.with_batch_bytes(bytes),
            None => cutter,
        };
        let shared = Shared { cutter: Mutex::new(Some(cutter)), orders: Mutex::default(), between };
        Self { context, shared: Arc::new(shared), cut: channel(), ordered: 0 }
    }

    /// The next batch; none behind the last.
    fn next(
        &mut self,
        reader: &Reader<'_>,
        plan: &dyn Fn() -> Option<Plan>,
        scope: &ScopeFifo<'a>,
    ) -> io::Result<Option<FinishedBatch>> {
        let threads = rayon::current_num_threads();
        let more = (threads + AHEAD).saturating_sub(self.ordered);
        self.ordered += more;
        let plans: Vec<_> = (0..more).map(|_| (reader.context(&self.context), plan())).collect();
        let idle = {
            let mut orders = lock(&self.shared.orders);
            orders.plans.extend(plans);
            let idle = orders.plans.len().min(threads.saturating_sub(orders.threads));
            orders.threads += idle;
            idle
        };
        for _ in 0..idle {
            let (shared, cut) = (Arc::clone(&self.shared), self.cut.0.clone());
            scope.spawn_fifo(move |scope| read_one(shared, cut, scope));
        }
        let batch = wait(&wait(&self.cut.1)?)?;
        self.ordered -= 1;
        Ok(batch)
    }
}

/// Cuts the next batch and reads it, and so on while there is what to cut.
fn read_one<'a>(shared: Arc<Shared<'a>>, cut: Sender<Reading>, scope: &ScopeFifo<'a>) {
    // Held until the batch is cut, so that batches come in their order.
    let mut held = lock(&shared.cutter);
    let order = {
        let mut orders = lock(&shared.orders);
        let order = held.as_mut().and_then(|cutter| {
            orders.rooms.drain(..).for_each(|room| cutter.give_back(room));
            Some((cutter, orders.plans.pop_front()?))
        });
        if order.is_none() {
            orders.threads -= 1;
        }
        order
    };
    let Some((cutter, (context, plan))) = order else { return };
    // Before it is cut: who waits hears of a thread that ends early. Nobody waits where reading has failed.
    let (done, reading) = sync_channel(1);
    let _ = cut.send(reading);
    let batch = cutter.next();
    drop(held);
    let finished = batch.map(|batch| match plan {
        Some(plan) => {
            let (read, lowered) = plan.read(&context, batch);
            FinishedBatch { read, lowered: Some(Box::new(lowered)) }
        }
        None => FinishedBatch { read: context.read(batch), lowered: None },
    });
    let _ = done.send(finished);
    // Else it is left to those for whom all others wait.
    (shared.between)();
    scope.spawn_fifo(move |scope| read_one(shared, cut, scope));
}

fn lost() -> io::Error {
    io::Error::other("a thread that read the document ended early")
}

/// Waits for what another thread makes; a thread of the pool does other work meanwhile, which may be just that.
fn wait<T>(reading: &Receiver<T>) -> io::Result<T> {
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
