//! What a call came to.

use crate::list::put_raw;
use mapd_client::geodesy::{DefinitionError, GeodeticError, ProjectionError};
use mapd_client::{AttachError, ClientError, QueryError};
use std::any::Any;
use std::borrow::Cow;
use std::ffi::c_char;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What a call came to. Codes below `MAPD_CODE_NULL_POINTER` are no errors.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum mapd_code {
    /// Done.
    OK = 0,
    /// There is no such thing: no lane near enough, no road of this id, nothing before the deadline. What was to be written is as before.
    NONE = 1,
    /// The buffer is too small: it holds as many entries as it has room for, and the count says how many there are.
    TOO_SMALL = 2,
    /// A pointer that is needed is null; a handle was closed, or never made.
    NULL_POINTER = 10,
    /// An argument cannot be used: text that is not UTF-8, an unknown code, an id that names nothing, a misaligned pointer, options of another size.
    ARGUMENT = 11,
    /// A number that is not finite.
    NOT_FINITE = 12,
    /// The id belongs to another map content: look it up again by its key or name in this snapshot.
    FOREIGN_ID = 13,
    /// The archive is damaged at this place.
    CORRUPT = 14,
    /// No daemon is running in the domain.
    NO_DAEMON = 20,
    /// Daemons are running, but none serves this map.
    NO_SUCH_MAP = 21,
    /// No (newer) generation came before the deadline.
    NO_GENERATION = 22,
    /// The generation that was asked for is no longer served.
    SUPERSEDED = 23,
    /// The daemon speaks another revision of the transport.
    WRONG_TRANSPORT = 24,
    /// All places for clients of this map are taken.
    TOO_MANY_SUBSCRIBERS = 25,
    /// This client holds as many generations as it can: close old snapshots.
    TOO_MANY_PINNED = 26,
    /// The daemon's files belong to another user.
    PERMISSION_DENIED = 27,
    /// A file that a killed process left is in the way.
    STUCK = 28,
    /// The daemon did not release its lock in time.
    BUSY = 29,
    /// Shared memory is full.
    NO_ROOM = 30,
    /// A file of the domain cannot be used, or shared memory failed.
    TRANSPORT = 31,
    /// The domain's prefix or the map's name cannot be used.
    NAME = 32,
    /// The daemon refuses what was proposed: the message has its reason.
    REFUSED = 33,
    /// The daemon did not decide in time.
    LATE = 34,
    /// This process may open no more files: close some, or raise its limit.
    NO_DESCRIPTORS = 35,
    /// The bytes are no archive that this library reads.
    NOT_AN_ARCHIVE = 40,
    /// The archive does not prove.
    NOT_PROVEN = 41,
    /// The file cannot be read.
    FILE = 42,
    /// The archive is not signed by the trusted key, or not what was signed.
    NOT_TRUSTED = 43,
    /// The map has no georeference that can be used.
    NO_PROJECTION = 50,
    /// The place lies outside the area of the map's projection.
    OUTSIDE = 51,
    /// A latitude or longitude that there is not.
    NO_PLACE_ON_EARTH = 52,
    /// Something that this library has no code for.
    OTHER = 98,
    /// A bug in mapd: the message says where. Nothing else is known of what the call did.
    PANIC = 99,
}

/// Bytes of a message, its terminating 0 included. Longer ones are cut.
pub const MAPD_MESSAGE_SIZE: usize = 504;

/// Why a call failed. It is the caller's; a call that ends with an error writes it, any other leaves it as it was.
#[repr(C)]
pub struct mapd_error {
    /// What the call returned.
    pub code: mapd_code,
    /// Length of the message in bytes.
    pub length: u32,
    /// The message for people, UTF-8, terminated by 0.
    pub message: [c_char; MAPD_MESSAGE_SIZE],
}

/// An error on its way to the caller. A pointer, so that what comes to no error passes in registers.
pub(crate) struct Failure(Box<(mapd_code, Cow<'static, str>)>);

/// What a call's body comes to.
pub(crate) type Outcome = Result<mapd_code, Failure>;

impl Failure {
    #[cold]
    pub(crate) fn new(code: mapd_code, message: impl Into<Cow<'static, str>>) -> Self {
        Self(Box::new((code, message.into())))
    }

    /// The same of one of several questions, by its number from 0.
    #[cold]
    pub(crate) fn of_entry(self, number: usize) -> Self {
        let (code, message) = *self.0;
        Self::new(code, format!("entry {number}: {message}"))
    }

    pub(crate) fn code(&self) -> mapd_code {
        self.0.0
    }

    // By value and never inlined, like the next two: a reference to the name would lie on the stack in every call that does not fail.
    #[cold]
    #[inline(never)]
    pub(crate) fn null(what: &'static str) -> Self {
        Self::new(
            mapd_code::NULL_POINTER,
            format!("expected a pointer to {what}, found null; a handle is null once it is closed"),
        )
    }

    #[cold]
    #[inline(never)]
    pub(crate) fn misaligned(what: &'static str) -> Self {
        Self::argument(format!("the pointer to {what} is not aligned"))
    }

    #[cold]
    #[inline(never)]
    pub(crate) fn too_many(count: usize) -> Self {
        Self::argument(format!("no memory holds {count} entries"))
    }

    #[cold]
    pub(crate) fn argument(message: impl Into<Cow<'static, str>>) -> Self {
        Self::new(mapd_code::ARGUMENT, message)
    }
}

impl From<QueryError> for Failure {
    #[cold]
    fn from(error: QueryError) -> Self {
        let code = match error {
            QueryError::ForeignId => mapd_code::FOREIGN_ID,
            QueryError::Corrupt => mapd_code::CORRUPT,
            QueryError::NotFinite | QueryError::NotFiniteAt(_) => mapd_code::NOT_FINITE,
            QueryError::Option(_) | QueryError::NoId => mapd_code::ARGUMENT,
            _ => mapd_code::OTHER,
        };
        Self::new(code, error.to_string())
    }
}

impl From<ClientError> for Failure {
    #[cold]
    fn from(error: ClientError) -> Self {
        let code = match &error {
            ClientError::Attach(error) => attach_code(error),
            ClientError::Open { .. } => mapd_code::NOT_AN_ARCHIVE,
            ClientError::Verify { .. } => mapd_code::NOT_PROVEN,
            ClientError::File { .. } => mapd_code::FILE,
            ClientError::Trust(_) => mapd_code::NOT_TRUSTED,
            _ => mapd_code::OTHER,
        };
        Self::new(code, error.to_string())
    }
}

fn attach_code(error: &AttachError) -> mapd_code {
    match error {
        AttachError::Domain(_) | AttachError::MapName { .. } => mapd_code::NAME,
        AttachError::NoDaemon { .. } => mapd_code::NO_DAEMON,
        AttachError::NoSuchMap { .. } => mapd_code::NO_SUCH_MAP,
        AttachError::NoGeneration { .. } => mapd_code::NO_GENERATION,
        AttachError::Superseded { .. } => mapd_code::SUPERSEDED,
        AttachError::WrongTransport { .. } => mapd_code::WRONG_TRANSPORT,
        AttachError::TooManySubscribers { .. } => mapd_code::TOO_MANY_SUBSCRIBERS,
        AttachError::TooManyPinned { .. } => mapd_code::TOO_MANY_PINNED,
        AttachError::PermissionDenied { .. }
        | AttachError::OnlyObservers { .. }
        | AttachError::NoSubscribers { .. }
        | AttachError::UnknownOwner { .. }
        | AttachError::NotShared { .. } => mapd_code::PERMISSION_DENIED,
        AttachError::Stuck { .. } => mapd_code::STUCK,
        AttachError::Busy { .. } => mapd_code::BUSY,
        AttachError::OtherContent { .. } => mapd_code::FOREIGN_ID,
        AttachError::NoRoom { .. } | AttachError::LockLimit { .. } => mapd_code::NO_ROOM,
        AttachError::NoDescriptors { .. } => mapd_code::NO_DESCRIPTORS,
        AttachError::Record { .. } | AttachError::Io { .. } | AttachError::Iceoryx(_) => {
            mapd_code::TRANSPORT
        }
        _ => mapd_code::OTHER,
    }
}

impl From<DefinitionError> for Failure {
    #[cold]
    fn from(error: DefinitionError) -> Self {
        Self::new(mapd_code::NO_PROJECTION, error.to_string())
    }
}

impl From<ProjectionError> for Failure {
    #[cold]
    fn from(error: ProjectionError) -> Self {
        let code = match error {
            ProjectionError::NotFinite => mapd_code::NOT_FINITE,
            ProjectionError::OutOfRange => mapd_code::NO_PLACE_ON_EARTH,
            // What is newer is as good as outside: there is no answer for the place.
            _ => mapd_code::OUTSIDE,
        };
        Self::new(code, error.to_string())
    }
}

impl From<GeodeticError> for Failure {
    #[cold]
    fn from(error: GeodeticError) -> Self {
        match error {
            GeodeticError::Projection(error) => error.into(),
            GeodeticError::Query(error) => error.into(),
            _ => Self::new(mapd_code::OUTSIDE, error.to_string()),
        }
    }
}

/// Runs a call's body: no panic leaves it, and an error is written where the caller wants it.
///
/// # Safety
///
/// `error` is null or valid for writes.
#[inline]
pub(crate) unsafe fn answer(error: *mut mapd_error, body: impl FnOnce() -> Outcome) -> mapd_code {
    // A body that panics has at most left its answer unwritten and a scratch with entries of no meaning, which the next query clears.
    // An error is written inside, so that all that comes out is a code, in a register.
    let told = AssertUnwindSafe(|| match body() {
        Ok(code) => code,
        // SAFETY: as promised above.
        Err(failure) => unsafe { tell(error, failure) },
    });
    match catch_unwind(told) {
        Ok(code) => code,
        // SAFETY: as promised above.
        Err(panic) => unsafe { tell_panic(error, &*panic) },
    }
}

/// Writes where a bug in mapd is.
///
/// # Safety
///
/// `error` is null or valid for writes.
#[cold]
#[inline(never)]
unsafe fn tell_panic(error: *mut mapd_error, panic: &(dyn Any + Send)) -> mapd_code {
    let said = panic.downcast_ref::<&str>().copied();
    let said = said.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    let message = format!("a bug in mapd, please report it: {}", said.unwrap_or("panic"));
    // SAFETY: as promised above.
    unsafe { tell(error, Failure::new(mapd_code::PANIC, message)) }
}

/// Writes an error where the caller wants it.
///
/// # Safety
///
/// `error` is null or valid for writes.
#[cold]
#[inline(never)]
unsafe fn tell(error: *mut mapd_error, failure: Failure) -> mapd_code {
    let (code, text) = *failure.0;
    let mut end = text.len().min(MAPD_MESSAGE_SIZE - 1);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    let mut message = [0; MAPD_MESSAGE_SIZE];
    // A 0 within would end the message for C.
    for (to, from) in message.iter_mut().zip(text.as_bytes()[..end].iter()) {
        *to = (if *from == 0 { b' ' } else { *from }) as c_char;
    }
    let written = mapd_error { code, length: end as u32, message };
    // SAFETY: as promised above. A misaligned one is left alone: the code says what there is to say.
    let _ = unsafe { put_raw(error, written) };
    code
}
