//! The server.

use super::cleanup;
use super::doorbell::Doorbell;
use super::error::ServeError;
use super::generations::Generations;
use super::greeter::{GreetUntil, greet_until, greeting_meanwhile};
use super::memory;
use super::notice::Notice;
use super::orphans;
use super::own_segment;
use super::publishing::Staged;
use super::reserve::reserving;
use super::segment::SegmentType;
use super::served_map::{MapOf, MapPorts};
use super::sharing::check_owner_is_us;
use super::stop::StopSignal;
use super::strangers::Strangers;
use iceoryx2::prelude::{Node, NodeBuilder, NodeName, SignalHandlingMode};
use mapd_transport::{
    AttachGuard, AttachLock, Claim, DAEMON_NODE, Domain, ForeignFile, GenerationInfo, Presence,
    Share, Sharing, TransportService, check_map_name, check_owner, foreign_node_counter,
    iceoryx2_config, prepare_node_counter, remove_staged, silence_iceoryx2, unfinished_segments,
};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::fmt;
use std::fs::DirBuilder;
use std::io;
use std::os::unix::fs::DirBuilderExt;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Mode of the root folder: the daemon's user alone.
const ROOT_MODE: u32 = 0o700;

/// How long the server waits for the attach lock before it goes on without. Clients hold it for about a millisecond;
/// only one that was stopped holds it longer.
const LOCK_PATIENCE: Duration = Duration::from_secs(2);

/// The same, once it has failed, until the lock can be had again.
const PATIENCE_LOST: Duration = Duration::from_millis(20);

/// How long a round waits for the attach lock at most: no client can attach meanwhile.
const ROUND_PATIENCE: Duration = Duration::from_millis(100);

/// Rounds without the attach lock after which the operator is told.
const ROUNDS_BEFORE_NOTICE: u32 = 10;

/// What a server says about one of its maps.
#[derive(Clone, Debug)]
pub struct ServedMap {
    /// Name.
    pub name: String,
    /// What is served; `None` between [`Server::claim`] and the first publication.
    pub info: Option<GenerationInfo>,
    /// What waits for [`Server::activate`].
    pub staged: Option<GenerationInfo>,
}

/// Serves maps, one generation each. Dropping it removes everything of its own from shared memory; clients keep what they
/// hold.
pub struct Server {
    /// Dropped by hand, before the node.
    pub(super) maps: BTreeMap<String, MapPorts>,
    /// Generations that are ready to be sent, by map. Dropped by hand, before the maps.
    pub(super) staged: BTreeMap<String, Staged>,
    node: Option<Node<TransportService>>,
    /// Why there is no node: this is where subscribers need a file of the daemon's.
    in_the_way: Option<ForeignFile>,
    /// Files of other users that have been told of.
    strangers: RefCell<Strangers>,
    presence: Option<Presence>,
    pub(super) lock: AttachLock,
    pub(super) domain: Domain,
    pub(super) notify: Box<dyn Fn(&Notice)>,
    pub(super) generations: Generations,
    pub(super) lock_memory: bool,
    pub(super) share: Share,
    pub(super) sharing: Option<Sharing>,
    pub(super) segment_type: SegmentType,
    patience: Cell<Duration>,
    next_round: Instant,
    rounds_missed: Cell<u32>,
}

impl Server {
    /// Enters a domain, and cleans up after killed processes.
    ///
    /// Where another user holds a name that subscribers need, it serves observers alone: [`Server::without_subscribers`].
    ///
    /// Errors: the domain belongs to another user, or cannot be written; shared memory is full; iceoryx2 refuses; a killed
    /// process left an unfinished file that cannot be removed because a stopped process holds the attach lock.
    pub fn start(domain: &Domain) -> Result<Self, ServeError> {
        Self::start_with(domain, |_| {})
    }

    /// As [`Server::start`], telling `notify` what happens on the way and later.
    ///
    /// Errors: as [`Server::start`].
    pub fn start_with(
        domain: &Domain,
        notify: impl Fn(&Notice) + 'static,
    ) -> Result<Self, ServeError> {
        check_owner_is_us(domain)?;
        silence_iceoryx2();
        let config = iceoryx2_config(domain)?;
        memory::check_overhead()?;
        let (lock, exclusive) = enter(domain).map_err(memory::or_shortage)?;
        let alone = exclusive.is_some() && Presence::is_deserted(domain);
        let strangers = RefCell::<Strangers>::default();
        match &exclusive {
            Some(guard) => {
                if alone {
                    cleanup::wipe(domain, guard);
                }
                cleanup::sweep(domain, guard, &notify, &mut strangers.borrow_mut());
                own_segment::remove_left(domain, guard);
            }
            None => {
                notify(&Notice::LockHeld { lock: lock.path().to_owned() });
                if let Some(file) = unfinished_segments(domain).into_iter().next() {
                    return Err(ServeError::Wedged { file });
                }
            }
        }
        let presence = Presence::enter(domain).map_err(ServeError::io(domain.root()))?;
        // From here on, dropping it leaves nothing behind.
        let mut server = Self {
            maps: BTreeMap::new(),
            staged: BTreeMap::new(),
            node: None,
            in_the_way: None,
            strangers,
            presence: Some(presence),
            lock,
            domain: domain.clone(),
            notify: Box::new(notify),
            generations: Generations::default(),
            lock_memory: false,
            share: Share::default(),
            sharing: None,
            segment_type: SegmentType::default(),
            patience: Cell::new(LOCK_PATIENCE),
            next_round: Instant::now(),
            rounds_missed: Cell::new(0),
        };
        // What has the name once stays: nobody else can remove the daemon's, and no daemon while this one is present.
        if let Err(error) = prepare_node_counter(domain) {
            let Some(in_the_way) = foreign_node_counter(domain) else {
                return Err(memory::or_shortage(error.into()));
            };
            (server.notify)(&Notice::WithoutSubscribers { file: in_the_way.clone() });
            server.in_the_way = Some(in_the_way);
            return Ok(server);
        }
        let name = NodeName::new(DAEMON_NODE).map_err(ServeError::iceoryx("naming a node"))?;
        let builder = NodeBuilder::new()
            .name(&name)
            .config(&config)
            .signal_handling_mode(SignalHandlingMode::Disabled);
        let node = reserving(|| builder.create::<TransportService>())
            .map_err(ServeError::iceoryx("creating a node"))
            .map_err(memory::or_shortage)?;
        server.node = Some(node);
        if let (Some(guard), Some(node)) = (&exclusive, &server.node) {
            server.clean(guard);
            orphans::remove(domain, node, guard, &server.notify);
        }
        drop(exclusive);
        Ok(server)
    }

    /// What another user has put where subscribers need a file of the daemon's, so that this server serves observers alone; none as a rule.
    pub fn without_subscribers(&self) -> Option<&ForeignFile> {
        self.in_the_way.as_ref()
    }

    /// Cleans up after killed processes.
    fn clean(&self, exclusive: &AttachGuard) {
        let strangers = &mut self.strangers.borrow_mut();
        cleanup::clean(&self.domain, self.node.as_ref(), exclusive, &self.notify, strangers);
    }

    /// Keeps the last number of each map's generations in a folder that outlives the domain, so that they rise also after
    /// everybody has left it. What cannot be written there is told, and does not keep anything from being served.
    pub fn keep_generations_in(&mut self, folder: impl Into<PathBuf>) {
        self.generations.keep_in(folder.into());
    }

    /// Whether pages of what is published from now on are kept in memory (mlock(2)) until a newer generation is served. A
    /// generation whose pages cannot be locked is refused with [`ServeError::NotLocked`].
    pub fn lock_memory(&mut self, lock: bool) {
        self.lock_memory = lock;
    }

    /// Claims a map before its first generation is ready, so that a second daemon fails at once and clients know that the
    /// map is coming. [`Server::publish`] does so by itself.
    ///
    /// Errors: the name cannot be used; another daemon serves the map; iceoryx2 refuses.
    pub fn claim(&mut self, map: &str) -> Result<(), ServeError> {
        self.claim_all([map])
    }

    /// As [`Server::claim`], of several maps: what killed daemons left of their services is looked for once, at the end,
    /// which takes as long as there are services in the domain.
    ///
    /// Errors: as [`Server::claim`]; maps before the one that cannot be claimed stay claimed.
    pub fn claim_all<'a>(
        &mut self,
        maps: impl IntoIterator<Item = &'a str>,
    ) -> Result<(), ServeError> {
        let mut is_new = false;
        for map in maps {
            check_map_name(map)?;
            if !self.maps.contains_key(map) {
                self.claim_new(map).map_err(memory::or_shortage)?;
                is_new = true;
            }
        }
        if is_new
            && let Some(guard) = self.exclusive()
            && let Some(node) = &self.node
        {
            // Of services that were half made and have been made anew.
            orphans::remove(&self.domain, node, &guard, &self.notify);
        }
        Ok(())
    }

    fn claim_new(&mut self, map: &str) -> Result<(), ServeError> {
        let claim = Claim::acquire(&self.domain, map)?;
        // A killed daemon's word is out of date. What it served last is still told to observers, until there is something newer.
        self.tell_if_failed("removing an old record", remove_staged(&self.domain, map));
        let exclusive = self.exclusive();
        if let Err(error) = memory::check_overhead() {
            claim.release();
            return Err(error);
        }
        let ports = reserving(|| {
            let of = MapOf { domain: &self.domain, map, share: self.share };
            MapPorts::create(&of, self.node.as_ref(), claim, exclusive.as_ref())
        })?;
        self.maps.insert(map.to_owned(), ports);
        Ok(())
    }

    /// Serves until `stop` is set: greets newcomers at once, and cleans up after killed clients about once a second. May
    /// be called again afterwards.
    ///
    /// Errors: the wait fails.
    pub fn run(&mut self, stop: &StopSignal) -> Result<(), ServeError> {
        self.serve(GreetUntil { stop, door: None })
    }

    /// As [`Server::run`], but returns as well when the bell is rung, at once, so that the caller may publish something and
    /// call again.
    ///
    /// Errors: the wait fails.
    pub fn run_until(&mut self, stop: &StopSignal, door: &Doorbell) -> Result<(), ServeError> {
        self.serve(GreetUntil { stop, door: Some(door) })
    }

    /// Does something that waits for clients of this server, and greets them meanwhile.
    ///
    /// Errors: no socket pair can be had.
    pub fn meanwhile<T>(&self, work: impl FnOnce() -> T) -> Result<T, ServeError> {
        greeting_meanwhile(&self.maps, &self.lock, || Ok(work()))
    }

    fn serve(&mut self, until: GreetUntil<'_>) -> Result<(), ServeError> {
        let mut next_round = self.next_round;
        let mut missed = self.rounds_missed.get();
        let served =
            greet_until(until, &mut next_round, &self.maps, &self.lock, &self.notify, &mut || {
                self.round(&mut missed)
            });
        self.rounds_missed.set(missed);
        self.next_round = next_round;
        served
    }

    /// Cleans up and connects new clients, unless a client is attaching now.
    fn round(&self, missed: &mut u32) -> Result<(), ServeError> {
        self.let_go();
        // A process that is stopped while it holds the lock costs newcomers little: once it is known, hardly any wait.
        let patience = if *missed == 0 { ROUND_PATIENCE } else { PATIENCE_LOST };
        let Some(exclusive) = self.lock.exclusive(Instant::now() + patience)? else {
            *missed += 1;
            if *missed == ROUNDS_BEFORE_NOTICE {
                (self.notify)(&Notice::LockHeld { lock: self.lock.path().to_owned() });
            }
            return Ok(());
        };
        *missed = 0;
        self.clean(&exclusive);
        for (name, ports) in &self.maps {
            ports.greet(name, &self.notify);
        }
        Ok(())
    }

    /// The maps served, by name.
    pub fn maps(&self) -> Vec<ServedMap> {
        let map = |(name, ports): (&String, &MapPorts)| ServedMap {
            name: name.clone(),
            info: ports.info().copied(),
            staged: self.staged.get(name).map(|staged| *staged.info()),
        };
        self.maps.iter().map(map).collect()
    }

    /// Stops serving a map. Clients keep what they hold.
    pub fn withdraw(&mut self, map: &str) {
        let exclusive = self.exclusive();
        self.unstage(map, exclusive.as_ref());
        if let Some(ports) = self.maps.remove(map) {
            self.tell_if_failed("removing the record", ports.close());
        }
        drop(exclusive);
    }

    /// The attach lock, or none if a stopped process holds it: then the server goes on without, as long as nothing else
    /// creates or cleans up at the same moment.
    pub(super) fn exclusive(&self) -> Option<AttachGuard> {
        match self.lock.exclusive(Instant::now() + self.patience.get()) {
            Ok(Some(guard)) => {
                self.patience.set(LOCK_PATIENCE);
                Some(guard)
            }
            Ok(None) => {
                self.patience.set(PATIENCE_LOST);
                (self.notify)(&Notice::LockHeld { lock: self.lock.path().to_owned() });
                None
            }
            Err(error) => {
                (self.notify)(&Notice::Failed {
                    what: "locking".to_owned(),
                    error: error.to_string(),
                });
                None
            }
        }
    }

    pub(super) fn tell_if_failed<T, E: fmt::Display>(&self, what: &str, result: Result<T, E>) {
        if let Err(error) = result {
            (self.notify)(&Notice::Failed { what: what.to_owned(), error: error.to_string() });
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let exclusive = self.exclusive();
        if let Some(guard) = &exclusive {
            self.clean(guard);
        }
        for name in self.staged.keys().cloned().collect::<Vec<_>>() {
            self.unstage(&name, exclusive.as_ref());
        }
        for ports in std::mem::take(&mut self.maps).into_values() {
            self.tell_if_failed("removing the record", ports.close());
        }
        drop(self.node.take());
        self.end_sharing(exclusive.as_ref());
        drop(self.presence.take());
        if let Some(guard) = &exclusive
            && Presence::is_deserted(&self.domain)
        {
            cleanup::wipe_all(&self.domain, &self.generations.only_here(&self.domain), guard);
        }
    }
}

impl fmt::Debug for Server {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Server")
            .field("domain", &self.domain)
            .field("maps", &self.maps())
            .finish_non_exhaustive()
    }
}

/// Makes the root folder and takes the attach lock exclusively. `None`: a stopped process holds it.
fn enter(domain: &Domain) -> Result<(AttachLock, Option<AttachGuard>), ServeError> {
    let until = Instant::now() + LOCK_PATIENCE;
    loop {
        match DirBuilder::new().mode(ROOT_MODE).create(domain.root()) {
            Err(error) if error.kind() != io::ErrorKind::AlreadyExists => {
                return Err(ServeError::io(domain.root())(error));
            }
            _ => {}
        }
        check_owner(domain)?;
        let lock = match AttachLock::create(domain) {
            Ok(lock) => lock,
            // A daemon that ends has just removed the folder.
            Err(error) if error.kind() == io::ErrorKind::NotFound && Instant::now() < until => {
                continue;
            }
            Err(error) => return Err(ServeError::io(domain.root())(error)),
        };
        let exclusive = lock.exclusive(until)?;
        if let Err(error) = Presence::prepare(domain) {
            if error.kind() == io::ErrorKind::NotFound && Instant::now() < until {
                continue;
            }
            return Err(ServeError::io(domain.root())(error));
        }
        if exclusive.is_none() || lock.is_current() {
            // Between the first look and the lock the folder of a daemon that ended may have become a stranger's.
            check_owner(domain)?;
            return Ok((lock, exclusive));
        }
    }
}
