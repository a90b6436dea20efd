//! One map of a server: its services, its publisher, its claim.

use super::error::ServeError;
use super::held::{Dropped, HeldGeneration, MOST};
use super::locked::LockedPages;
use super::memory;
use super::notice::Notice;
use super::overlays::{OverlayFile, remove_left};
use super::own_segment::OwnSegment;
use super::reserve::reserving;
use super::services::MapServices;
use iceoryx2::port::listener::Listener;
use iceoryx2::port::notifier::Notifier;
use iceoryx2::port::publisher::Publisher;
use iceoryx2::port::update_connections::UpdateConnections;
use iceoryx2::prelude::{AllocationStrategy, Node};
use mapd_transport::{
    AttachGuard, Chunk64, Claim, Domain, GenerationInfo, RecordWriter, SHARED_MEMORY_FOLDER,
    SegmentLocation, Share, TransportService, chunks_for,
};
use std::fs::File;
use std::sync::{Mutex, MutexGuard, PoisonError};

pub(crate) type MapPublisher = Publisher<TransportService, [Chunk64], GenerationInfo>;

/// What a generation's segment goes with.
pub(crate) enum Keeper {
    /// The publisher that has sent it, or will.
    Publisher(MapPublisher),
    /// Nobody subscribes.
    Daemon(OwnSegment),
}

/// What is served.
pub(crate) struct Current {
    pub(crate) keeper: Keeper,
    pub(crate) info: GenerationInfo,
    /// To look after its segment once it is not served any more.
    pub(crate) kept: Option<File>,
    /// Where its bytes lie.
    pub(crate) place: SegmentLocation,
    /// What is laid over it.
    pub(crate) overlay: Option<OverlayFile>,
}

/// The map that is served, and the group that may read it.
pub(crate) struct MapOf<'a> {
    pub(crate) domain: &'a Domain,
    pub(crate) map: &'a str,
    pub(crate) share: Share,
}

/// The services and ports of a map. Fields are dropped in the order they are written.
pub(crate) struct MapPorts {
    current: Option<Current>,
    /// Generations before that readers hold.
    dropped: Mutex<Vec<Dropped>>,
    /// Pages of the current generation, where they are to stay in memory.
    locked: Option<LockedPages>,
    /// What subscribers meet; none where there are none.
    pub(crate) subscribing: Option<Subscribing>,
    /// Where observers look.
    pub(crate) record: RecordWriter,
    claim: Claim,
}

/// What a map's subscribers meet. Fields are dropped in the order they are written.
pub(crate) struct Subscribing {
    pub(crate) woken: Listener<TransportService>,
    changed: Notifier<TransportService>,
    services: MapServices,
}

impl Subscribing {
    /// Opens or creates the services of a claimed map, and what the daemon needs of them.
    ///
    /// Errors: iceoryx2 refuses.
    fn open(
        domain: &Domain,
        map: &str,
        node: &Node<TransportService>,
        exclusive: Option<&AttachGuard>,
    ) -> Result<Self, ServeError> {
        let services = MapServices::open_or_create(domain, node, map, exclusive)?;
        let woken = services.wake.listener_builder().create();
        let woken = woken.map_err(ServeError::iceoryx("creating a listener"))?;
        let changed = services.changed.notifier_builder().create();
        let changed = changed.map_err(ServeError::iceoryx("creating a notifier"))?;
        Ok(Self { woken, changed, services })
    }

    /// A publisher for one sample of exactly `chunks` chunks. Connects to every subscriber, but sends nothing.
    ///
    /// Errors: iceoryx2 refuses.
    fn create_publisher(&self, chunks: usize) -> Result<MapPublisher, ServeError> {
        self.services
            .map
            .publisher_builder()
            .initial_max_slice_len(chunks)
            .allocation_strategy(AllocationStrategy::Static)
            .max_loaned_samples(1)
            // One sample is all there ever is. iceoryx2 would reserve one for each that subscribers could hold, each as
            // large as the map.
            .override_sample_preallocation(|_| 1)
            .create()
            .map_err(ServeError::iceoryx("creating a publisher"))
    }
}

impl MapPorts {
    /// Opens or creates the services of a claimed map, if there is a node. Opens those that clients of a killed daemon still hold.
    ///
    /// Errors: iceoryx2 refuses; the claim is given up.
    pub(crate) fn create(
        of: &MapOf<'_>,
        node: Option<&Node<TransportService>>,
        claim: Claim,
        exclusive: Option<&AttachGuard>,
    ) -> Result<Self, ServeError> {
        let MapOf { domain, map, share } = of;
        remove_left(domain, map);
        let record = match RecordWriter::open(domain, map, *share) {
            Ok(record) => record,
            Err(error) => {
                claim.release();
                return Err(ServeError::io(domain.root())(error));
            }
        };
        let subscribing = node.map(|node| Subscribing::open(domain, map, node, exclusive));
        match subscribing.transpose() {
            Ok(subscribing) => Ok(Self {
                current: None,
                dropped: Mutex::default(),
                locked: None,
                subscribing,
                record,
                claim,
            }),
            Err(error) => {
                // It has served nothing; what cannot be removed is the next daemon's.
                let _ = record.close();
                claim.release();
                Err(error)
            }
        }
    }

    /// What the segment of a generation of so many bytes is to go with. Sends nothing.
    ///
    /// Errors: iceoryx2, or the system, refuses.
    pub(crate) fn create_keeper(
        &self,
        domain: &Domain,
        length: usize,
        exclusive: Option<&AttachGuard>,
    ) -> Result<Keeper, ServeError> {
        match &self.subscribing {
            Some(subscribing) => {
                subscribing.create_publisher(chunks_for(length)).map(Keeper::Publisher)
            }
            None => OwnSegment::create(domain, length, exclusive)
                .map(Keeper::Daemon)
                .map_err(ServeError::io(SHARED_MEMORY_FOLDER)),
        }
    }

    /// Makes a generation that was sent the current one and drops the one before: readers keep what they hold.
    pub(crate) fn replace(
        &mut self,
        current: Current,
        locked: Option<LockedPages>,
        _exclusive: Option<&AttachGuard>,
    ) {
        let before = self.current.replace(current);
        self.locked = locked;
        // Its segment's name goes here.
        let dropped = before.and_then(|Current { info, kept, .. }| Some((kept?, info.generation)));
        if let Some((kept, generation)) = dropped
            && self.dropped().len() < MOST
        {
            self.dropped().push(Dropped::new(kept, generation));
        }
        self.let_go();
    }

    /// Releases the memory of generations that have no readers any more.
    pub(crate) fn let_go(&self) {
        self.dropped().retain(Dropped::is_held);
    }

    fn dropped(&self) -> MutexGuard<'_, Vec<Dropped>> {
        self.dropped.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Generations before that readers hold, as when last looked.
    pub(crate) fn held(&self, map: &str) -> Vec<HeldGeneration> {
        let held = |dropped: &Dropped| HeldGeneration {
            map: map.to_owned(),
            generation: dropped.generation,
            bytes: dropped.bytes(),
        };
        self.dropped().iter().map(held).collect()
    }

    /// Has the record name another overlay with what is served, and then removes the one before.
    ///
    /// Errors: nothing is served; what cannot be said.
    pub(crate) fn lay(&mut self, overlay: Option<OverlayFile>) -> std::io::Result<()> {
        let Some(current) = &mut self.current else {
            return Err(std::io::Error::other("nothing is served"));
        };
        let overlay_place = overlay.as_ref().map(|file| file.place);
        let laid = SegmentLocation { overlay: overlay_place, ..current.place.clone() };
        let prepared = self.record.prepare(&current.info, &laid)?;
        self.record.hold(prepared);
        (current.place, current.overlay) = (laid, overlay);
        Ok(())
    }

    /// Tells those who wait.
    ///
    /// Errors: iceoryx2 refuses; clients that wait poll from time to time.
    pub(crate) fn announce(&self) -> Result<(), ServeError> {
        match &self.subscribing {
            Some(subscribing) => subscribing
                .changed
                .notify()
                .map(|_| ())
                .map_err(ServeError::iceoryx("announcing a generation")),
            None => Ok(()),
        }
    }

    /// What is served.
    pub(crate) fn info(&self) -> Option<&GenerationInfo> {
        self.current.as_ref().map(|current| &current.info)
    }

    /// Takes the wake-ups that have come, so that the next one is seen.
    pub(crate) fn take_wake_ups(&self) {
        if let Some(subscribing) = &self.subscribing {
            // Fails only when interrupted by a signal; then the wait set reports the same wake-up again.
            let _ = subscribing.woken.try_wait(|_| {});
        }
    }

    /// Gives the generation to newcomers.
    pub(crate) fn greet(&self, map: &str, notify: &dyn Fn(&Notice)) {
        let Some(Current { keeper: Keeper::Publisher(publisher), .. }) = &self.current else {
            return;
        };
        // A newcomer costs a queue.
        let greeted = memory::check_queue().map_err(|error| error.to_string()).and_then(|()| {
            reserving(|| publisher.update_connections()).map_err(|error| format!("{error:?}"))
        });
        if let Err(error) = greeted {
            notify(&Notice::Unconnected { map: map.to_owned(), error });
        }
    }

    /// Tells observers that the map is not served any more, closes the ports, then gives up the claim.
    ///
    /// Errors: the record cannot be removed; it says that nothing is served.
    pub(crate) fn close(self) -> std::io::Result<()> {
        let Self { current, dropped, locked, subscribing, record, claim } = self;
        let closed = record.close();
        drop((current, dropped, locked, subscribing));
        claim.release();
        closed
    }
}
