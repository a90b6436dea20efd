//! Places for connections: so many at a time, and so many of one user. Who says nothing keeps nobody out.
//!
//! One connection more takes the place of an idle one, which is closed: the oldest of those that have not sent their request yet, then of
//! those that wait for the server less. A user beyond its share loses a place of its own; otherwise the user with the most does.

use rustix::net::Shutdown;
use std::cmp::Reverse;
use std::io;
use std::os::fd::AsFd;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What a connection is at; in this order it loses its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Stage {
    /// Its request has not arrived.
    Asks,
    /// It is told what happens, for as long as it likes.
    Listens,
    /// It takes its answer, as slowly as it likes.
    Takes,
    /// Its answer is made.
    IsAnswered,
}

/// All places of a server.
pub(crate) struct Places {
    /// Connections at a time.
    most: usize,
    /// Connections of one user at a time.
    share: usize,
    /// The last stage in which a connection may lose its place.
    idle: Stage,
    /// In the order in which they came.
    taken: Mutex<Vec<Taken>>,
}

struct Taken {
    user: u32,
    stage: Stage,
    connection: Arc<dyn AsFd + Send + Sync>,
    is_lost: Arc<AtomicBool>,
}

/// The place of a connection; free again when dropped.
pub(crate) struct Place {
    places: Arc<Places>,
    is_lost: Arc<AtomicBool>,
}

/// Why there is no place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Full {
    /// The user has its share, and all of these are answered.
    OfUser,
    /// So many are answered.
    OfAll,
}

impl Places {
    pub(crate) fn new(most: usize, share: usize, idle: Stage) -> Arc<Self> {
        Arc::new(Self { most, share, idle, taken: Mutex::default() })
    }

    /// A place for a connection of a user whose request is about to come. Where another lost it, that one is closed.
    ///
    /// Errors: there is none, not even one of somebody idle.
    pub(crate) fn take(
        self: &Arc<Self>,
        user: u32,
        connection: Arc<dyn AsFd + Send + Sync>,
    ) -> Result<Place, Full> {
        let mut taken = self.lock();
        let of = |taken: &[Taken], user| taken.iter().filter(|one| one.user == user).count();
        let own = of(&taken, user);
        if own >= self.share || taken.len() >= self.most {
            let may_lose =
                |one: &Taken| one.stage <= self.idle && (own < self.share || one.user == user);
            // Its own are all of one user.
            let held = |user| if own < self.share { of(&taken, user) } else { own };
            let order = |one: &Taken| (Reverse(held(one.user)), one.stage);
            let idle = taken.iter().enumerate().filter(|(_, one)| may_lose(one));
            // The first of those that are equal, which is the oldest.
            let Some((at, _)) = idle.min_by_key(|(_, one)| order(one)) else {
                return Err(if own >= self.share { Full::OfUser } else { Full::OfAll });
            };
            let lost = taken.remove(at);
            lost.is_lost.store(true, Ordering::Relaxed);
            // Its thread is told by the end of the stream.
            let _ = rustix::net::shutdown(lost.connection.as_fd(), Shutdown::Both);
        }
        let is_lost = Arc::<AtomicBool>::default();
        taken.push(Taken { user, stage: Stage::Asks, connection, is_lost: is_lost.clone() });
        Ok(Place { places: self.clone(), is_lost })
    }

    fn lock(&self) -> MutexGuard<'_, Vec<Taken>> {
        self.taken.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Place {
    /// Goes on to another stage.
    ///
    /// Errors: the place has been lost: what has been read meanwhile may be cut off.
    pub(crate) fn go_on(&self, stage: Stage) -> io::Result<()> {
        let mut taken = self.places.lock();
        match taken.iter_mut().find(|one| Arc::ptr_eq(&one.is_lost, &self.is_lost)) {
            Some(one) => one.stage = stage,
            None => return Err(io::ErrorKind::ConnectionAborted.into()),
        }
        Ok(())
    }

    /// Whether it has been lost to another connection.
    pub(crate) fn is_lost(&self) -> bool {
        self.is_lost.load(Ordering::Relaxed)
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        self.places.lock().retain(|one| !Arc::ptr_eq(&one.is_lost, &self.is_lost));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;
    use std::os::unix::net::UnixStream;

    /// Connections of a server with four places, of which a user may have three: user and stage of each. Then one of another user comes, or of
    /// the same; whose place it gets, if any.
    fn check(there: &[(u32, Stage)], user: u32, expected: Result<Option<usize>, Full>) {
        let places = Places::new(4, 3, Stage::Listens);
        let mut ends = Vec::new();
        let mut held = Vec::new();
        for (user, stage) in there {
            let (own, other) = UnixStream::pair().expect("a pair");
            let place = places.take(*user, Arc::new(own)).expect("a place");
            place.go_on(*stage).expect("has it");
            held.push(place);
            ends.push(other);
        }
        let (own, _other) = UnixStream::pair().expect("a pair");
        let taken = places.take(user, Arc::new(own));
        let lost: Vec<usize> = (0..held.len()).filter(|i| held[*i].is_lost()).collect();
        let is_as_expected = match &taken {
            Ok(_) => expected == Ok(lost.first().copied()) && lost.len() <= 1,
            Err(full) => expected == Err(*full) && lost.is_empty(),
        };
        assert!(is_as_expected, "{there:?}, {user}: {lost:?} {:?}", taken.as_ref().err());
        for at in lost {
            assert_eq!(ends[at].read(&mut [0]).expect("the end"), 0);
            assert!(held[at].go_on(Stage::IsAnswered).is_err());
        }
        drop((taken, held));
        assert_eq!(places.lock().len(), 0);
    }

    #[test]
    fn an_idle_connection_makes_room_and_one_that_is_answered_does_not() {
        use Stage::{Asks, IsAnswered, Listens};
        check(&[], 7, Ok(None));
        check(&[(7, Asks); 2], 7, Ok(None));
        // Beyond its share a user loses a place of its own, the oldest that is idle.
        check(&[(7, Asks); 3], 7, Ok(Some(0)));
        check(&[(7, IsAnswered), (7, Listens), (7, Asks)], 7, Ok(Some(2)));
        check(&[(7, IsAnswered), (7, Listens), (7, IsAnswered)], 7, Ok(Some(1)));
        check(&[(7, IsAnswered); 3], 7, Err(Full::OfUser));
        check(
            &[(8, Asks), (7, IsAnswered), (7, IsAnswered), (7, IsAnswered)],
            7,
            Err(Full::OfUser),
        );
        // Another finds room all the same.
        check(&[(7, IsAnswered); 3], 8, Ok(None));
        check(&[(8, Asks), (7, Asks), (7, Asks), (7, Asks)], 9, Ok(Some(1)));
        check(&[(8, Asks), (7, IsAnswered), (7, IsAnswered), (7, Listens)], 9, Ok(Some(3)));
        check(&[(8, Asks), (7, IsAnswered), (7, IsAnswered), (9, Asks)], 6, Ok(Some(0)));
        let full = [(8, IsAnswered), (7, IsAnswered), (7, IsAnswered), (9, IsAnswered)];
        check(&full, 6, Err(Full::OfAll));
    }
}
