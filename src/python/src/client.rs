//! Attaching to a served map and following it.
#![allow(unsafe_code)]

use crate::batch::{fields, result};
use crate::errors::{client as client_error, raise};
use crate::held::Held;
use crate::map::Map;
use mapd_client::{AttachError, ClientError, Domain, MapEvent};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Longest time between two looks for Python's signals, such as Ctrl-C, while waiting.
const SLICE: Duration = Duration::from_millis(100);
/// The same while connecting, which must be able to end within one.
const CONNECTING: Duration = Duration::from_secs(1);

/// A connection, which a forked process leaves alone: it is its parent's.
struct Connection {
    client: Option<mapd_client::Client>,
    process: u32,
}

impl Connection {
    /// The client; it is there until this is dropped.
    fn client(&self) -> &mapd_client::Client {
        self.client.as_ref().expect("taken when dropped only")
    }

    fn check(&self) -> PyResult<()> {
        if std::process::id() == self.process {
            return Ok(());
        }
        Err(raise(
            "ForkedError",
            "the connection belongs to the process that was forked; connect in this one",
        ))
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        if std::process::id() != self.process {
            std::mem::forget(self.client.take());
        }
    }
}

/// A time to wait in slices; infinity is for as long as it takes.
fn patience(timeout: f64) -> PyResult<Duration> {
    if timeout == f64::INFINITY { Ok(Duration::MAX) } else { seconds(timeout) }
}

/// A time to wait that ends.
pub(crate) fn seconds(timeout: f64) -> PyResult<Duration> {
    Duration::try_from_secs_f64(timeout).map_err(|_| {
        PyValueError::new_err(format!("expected a timeout in seconds, found {timeout}"))
    })
}

/// Runs in slices, so that Python's signals are heeded. `step` is given the time that it may take, and answers none where it
/// was too short.
fn wait<T: Send>(
    py: Python<'_>,
    timeout: Duration,
    step: impl Fn(Duration) -> Result<Option<T>, ClientError> + Sync,
) -> PyResult<Option<T>> {
    let begun = Instant::now();
    loop {
        let left = timeout.saturating_sub(begun.elapsed());
        let found = py.detach(|| step(left.min(SLICE))).map_err(client_error)?;
        py.check_signals()?;
        if found.is_some() || left <= SLICE {
            return Ok(found);
        }
    }
}

/// Connects in slices, as [`wait`] waits: what fails before its slice is up fails for another reason.
fn connect(
    py: Python<'_>,
    domain: &Domain,
    name: &str,
    timeout: Duration,
) -> PyResult<mapd_client::Client> {
    let begun = Instant::now();
    loop {
        let left = timeout.saturating_sub(begun.elapsed());
        let (slice, asked) = (left.min(CONNECTING), Instant::now());
        let found = py.detach(|| mapd_client::Client::connect_in(domain, name, slice));
        py.check_signals()?;
        match found {
            Err(_) if left > slice && asked.elapsed() >= slice => {}
            found => return found.map_err(client_error),
        }
    }
}

/// A connection to one served map. Threads may share it; a forked process connects again.
///
/// Connects in the domain of `prefix` (else of the environment variable MAPD_PREFIX) and pins the newest generation. Daemon and client may
/// start in any order; `timeout` is in seconds, `math.inf` for as long as it takes. `with` closes it. The environment variable MAPD_OWNER names the
/// user whose daemon is trusted, whatever the prefix.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Client {
    name: String,
    connection: Mutex<Option<Arc<Connection>>>,
}

impl Client {
    fn connection(&self) -> PyResult<Arc<Connection>> {
        let connection = self.connection.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let connection = connection
            .ok_or_else(|| raise("ClosedError", "the client is closed; connect again"))?;
        connection.check()?;
        Ok(connection)
    }

    fn is_closed(&self) -> bool {
        self.connection.lock().unwrap_or_else(PoisonError::into_inner).is_none()
    }
}

#[pymethods]
impl Client {
    #[new]
    #[pyo3(signature = (name, *, timeout = 5.0, prefix = None))]
    fn new(py: Python<'_>, name: String, timeout: f64, prefix: Option<&str>) -> PyResult<Self> {
        let deadline = patience(timeout)?;
        let domain = Domain::from_env_or(prefix);
        let domain = domain.map_err(|error| client_error(AttachError::from(error).into()))?;
        let client = connect(py, &domain, &name, deadline)?;
        let connection = Connection { client: Some(client), process: std::process::id() };
        Ok(Self { name, connection: Mutex::new(Some(Arc::new(connection))) })
    }

    /// Name of the map.
    #[getter]
    fn name(&self) -> &str {
        &self.name
    }

    /// Whether it was closed.
    #[getter]
    fn closed(&self) -> bool {
        self.is_closed()
    }

    /// The newest generation that this client has seen. Does not look for a newer one.
    fn map(&self) -> PyResult<Map> {
        Ok(Map::new(self.connection()?.client().snapshot()))
    }

    /// Looks for a newer generation without waiting and returns the newest.
    fn refresh(&self, py: Python<'_>) -> PyResult<Map> {
        let connection = self.connection()?;
        py.detach(|| connection.client().refresh()).map(Map::new).map_err(client_error)
    }

    /// Waits [s] for a generation newer than the newest that this client has seen; NoGenerationError if none comes.
    #[pyo3(signature = (timeout = 5.0))]
    fn wait(&self, py: Python<'_>, timeout: f64) -> PyResult<Map> {
        let (connection, timeout) = (self.connection()?, patience(timeout)?);
        let seen = connection.client().snapshot().generation();
        let next = wait(py, timeout, |slice| match connection.client().wait_next(slice) {
            Err(ClientError::Attach(AttachError::NoGeneration { .. })) => Ok(None),
            other => other.map(Some),
        })?;
        next.map(Map::new).ok_or_else(|| {
            client_error(ClientError::Attach(AttachError::NoGeneration {
                map: self.name.clone(),
                newer_than: seen,
                daemon_alive: connection.client().served_by().is_some(),
            }))
        })
    }

    /// Waits [s] for the generation of this number; SupersededError if a newer one is served already.
    #[pyo3(signature = (generation, timeout = 5.0))]
    fn require(&self, py: Python<'_>, generation: u64, timeout: f64) -> PyResult<Map> {
        let (connection, timeout) = (self.connection()?, patience(timeout)?);
        let found =
            wait(py, timeout, |slice| match connection.client().require(generation, slice) {
                Err(ClientError::Attach(AttachError::NoGeneration { .. })) => Ok(None),
                other => other.map(Some),
            })?;
        found.map(Map::new).ok_or_else(|| {
            client_error(ClientError::Attach(AttachError::NoGeneration {
                map: self.name.clone(),
                newer_than: generation.saturating_sub(1),
                daemon_alive: connection.client().served_by().is_some(),
            }))
        })
    }

    /// Waits [s] for another generation or another overlay. Returns whether one has come; map() then returns it.
    #[pyo3(signature = (timeout = 5.0))]
    fn wait_change(&self, py: Python<'_>, timeout: f64) -> PyResult<bool> {
        let (connection, timeout) = (self.connection()?, patience(timeout)?);
        let pair = || {
            let snapshot = connection.client().snapshot();
            (snapshot.generation(), snapshot.overlay_revision())
        };
        // Other threads may have looked between two slices: what counts is what was seen before the first.
        let before = pair();
        let changed = wait(py, timeout, |slice| {
            let has_changed = connection.client().wait_change(slice)?;
            Ok((has_changed || pair() != before).then_some(()))
        })?;
        Ok(changed.is_some())
    }

    /// The generation that is staged and waits to be activated.
    #[getter]
    fn pending(&self) -> PyResult<Option<u64>> {
        Ok(self.connection()?.client().pending().map(|info| info.generation))
    }

    /// Process id of the daemon that serves the map now; None if none does.
    #[getter]
    fn served_by(&self) -> PyResult<Option<u32>> {
        Ok(self.connection()?.client().served_by())
    }

    /// Time since the daemon's last heartbeat [s], of which it writes one about once a second; None if the map is no longer served.
    #[getter]
    fn heartbeat_age(&self) -> PyResult<Option<f64>> {
        Ok(self.connection()?.client().heartbeat_age().map(|age| age.as_secs_f64()))
    }

    /// Maps every page of this and later generations before they are returned.
    fn populate(&self, py: Python<'_>) -> PyResult<()> {
        let connection = self.connection()?;
        py.detach(|| connection.client().set_populate(true));
        Ok(())
    }

    /// Follows the map from now on.
    fn events(&self) -> PyResult<Events> {
        let connection = self.connection()?;
        // SAFETY: the client lies in the connection's heap block, which is shared and never moves. `Followed` keeps the connection
        // and drops the events, which borrow it, first; nobody takes the one without the other.
        let client: &'static mapd_client::Client =
            unsafe { &*std::ptr::from_ref(connection.client()) };
        let followed = Followed { events: client.events(), connection };
        Ok(Events { followed: Mutex::new(followed) })
    }

    /// Closes the connection. Maps stay readable.
    fn close(&self) {
        drop(self.connection.lock().unwrap_or_else(PoisonError::into_inner).take());
    }

    fn __enter__(this: Bound<'_, Self>) -> Bound<'_, Self> {
        this
    }

    fn __exit__(
        &self,
        _kind: &Bound<'_, PyAny>,
        _error: &Bound<'_, PyAny>,
        _trace: &Bound<'_, PyAny>,
    ) -> bool {
        self.close();
        false
    }

    fn __repr__(&self) -> String {
        let state = match self.connection() {
            Ok(connection) => format!("generation {}", connection.client().snapshot().generation()),
            Err(_) if self.is_closed() => "closed".to_owned(),
            Err(_) => "of another process".to_owned(),
        };
        format!("<mapd.Client {:?} {state}>", self.name)
    }
}

/// Events with the client that they borrow; declared first, dropped first.
struct Followed {
    events: mapd_client::Events<'static>,
    connection: Arc<Connection>,
}

/// Events of a map; an iterator that waits for them.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Events {
    followed: Mutex<Followed>,
}

#[pymethods]
impl Events {
    /// The next event; None if there is none within the timeout [s].
    #[pyo3(signature = (timeout = 5.0))]
    fn wait<'py>(&self, py: Python<'py>, timeout: f64) -> PyResult<Option<Bound<'py, PyAny>>> {
        let timeout = patience(timeout)?;
        self.next_within(py, timeout)
    }

    fn __iter__(this: Bound<'_, Self>) -> Bound<'_, Self> {
        this
    }

    fn __next__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        loop {
            if let Some(event) = self.next_within(py, Duration::from_secs(3600))? {
                return Ok(event);
            }
        }
    }
}

impl Events {
    fn next_within<'py>(
        &self,
        py: Python<'py>,
        timeout: Duration,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let lock = || self.followed.lock().unwrap_or_else(PoisonError::into_inner);
        // Never waits for another thread with the interpreter locked: that thread may need it.
        py.detach(|| lock().connection.check())?;
        let event = wait(py, timeout, |slice| lock().events.next(slice))?;
        let Some(event) = event else { return Ok(None) };
        Ok(Some(match event {
            MapEvent::Generation(snapshot) => {
                result(py, "Generation", &fields!(py, map = Map::new(snapshot)))?
            }
            MapEvent::Pending { generation } => {
                result(py, "Pending", &fields!(py, generation = generation))?
            }
            MapEvent::DaemonGone => result(py, "DaemonGone", &fields!(py,))?,
            MapEvent::DaemonBack { pid } => result(py, "DaemonBack", &fields!(py, pid = pid))?,
            _ => result(py, "OtherEvent", &fields!(py,))?,
        }))
    }
}

impl Map {
    fn new(snapshot: mapd_client::Snapshot) -> Self {
        Self::of(Arc::new(Held::new(snapshot)))
    }
}
