//! Publishing: a generation is filled and proved, waits, and is sent.

use super::error::ServeError;
use super::greeter::greeting_meanwhile;
use super::loan::{Filled, PublishMeta, fill_file, fill_loan, locate_loan};
use super::locked::LockedPages;
use super::memory;
use super::notice::Notice;
use super::overlays::{OverlayBytes, OverlayFile};
use super::reserve::reserving;
use super::segment::Segment;
use super::served_map::{Current, Keeper, MapPublisher};
use super::server::Server;
use crate::clock::unix_ns;
use mapd_transport::{
    AttachGuard, Chunk64, GenerationInfo, SHARED_MEMORY_FOLDER, SegmentLocation, chunks_for,
    remove_staged, write_staged,
};
use std::error::Error;
use std::fs::File;
use std::io;
use std::os::unix::fs::FileExt;

/// A generation that is filled and has not been sent. Fields are dropped in the order they are written; dropped under the
/// attach lock.
pub(crate) struct Staged {
    filled: FilledSegment,
    keeper: Keeper,
}

/// A generation that is filled, without what its segment goes with.
struct FilledSegment {
    /// What subscribers get, if there may be any.
    sample: Option<Filled>,
    info: GenerationInfo,
    place: SegmentLocation,
    locked: Option<LockedPages>,
    kept: Option<File>,
}

impl Staged {
    /// What is said about it.
    pub(crate) fn info(&self) -> &GenerationInfo {
        &self.filled.info
    }
}

impl Server {
    /// Publishes the next generation of a map and returns its number. `fill` is given exactly `length` zeroed bytes in
    /// shared memory, writes the map, and says what it is. Readers keep the generation before for as long as they hold it.
    /// What was staged is given up: its number is lower.
    ///
    /// Newcomers are greeted meanwhile, by a thread that ends with the call.
    ///
    /// Errors: the name cannot be used, another daemon serves it, too little memory, `fill` fails, iceoryx2 refuses.
    /// After an error what was served before is still served; a map that was not, is not.
    pub fn publish(
        &mut self,
        map: &str,
        length: usize,
        fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn Error + Send + Sync>>,
    ) -> Result<u64, ServeError> {
        self.publish_under(map, length, fill, None)
    }

    /// As [`Server::publish`], with the overlay that was made for this generation: readers get both at once. Without one, nothing is laid over it.
    ///
    /// Errors: as [`Server::publish`].
    pub fn publish_under(
        &mut self,
        map: &str,
        length: usize,
        fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn Error + Send + Sync>>,
        overlay: Option<&OverlayBytes>,
    ) -> Result<u64, ServeError> {
        let known = self.maps.contains_key(map);
        let published = self
            .fill_next(map, length, fill)
            .and_then(|staged| self.send(map, staged, overlay))
            .map_err(|error| self.naming_held(memory::or_shortage(error)));
        if published.is_err() && !known {
            self.withdraw(map);
        }
        published
    }

    /// As [`Server::publish`], but leaves it at that: clients see the generation as pending until [`Server::activate`].
    /// Replaces what was staged before.
    ///
    /// Errors: as [`Server::publish`].
    pub fn stage(
        &mut self,
        map: &str,
        length: usize,
        fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn Error + Send + Sync>>,
    ) -> Result<u64, ServeError> {
        let known = self.maps.contains_key(map);
        let filled = self.fill_next(map, length, fill);
        let staged = match filled.map_err(|error| self.naming_held(memory::or_shortage(error))) {
            Ok(staged) => staged,
            Err(error) => {
                if !known {
                    self.withdraw(map);
                }
                return Err(error);
            }
        };
        let info = *staged.info();
        self.staged.insert(map.to_owned(), staged);
        // What clients cannot see is not pending.
        if let Err(error) = write_staged(&self.domain, map, &info, self.share) {
            self.give_up_staged(map);
            if !known {
                self.withdraw(map);
            }
            return Err(ServeError::io(self.domain.root())(error));
        }
        Ok(info.generation)
    }

    /// Serves what is staged, and returns its number: everything that takes time has been done before.
    ///
    /// Errors: [`ServeError::NothingStaged`]; iceoryx2 refuses, and what was served before is still served.
    pub fn activate(&mut self, map: &str) -> Result<u64, ServeError> {
        self.activate_under(map, None)
    }

    /// As [`Server::activate`], with the overlay that was made for it.
    ///
    /// Errors: as [`Server::activate`].
    pub fn activate_under(
        &mut self,
        map: &str,
        overlay: Option<&OverlayBytes>,
    ) -> Result<u64, ServeError> {
        if !self.staged.contains_key(map) {
            return Err(ServeError::NothingStaged { map: map.to_owned() });
        }
        // Without room it stays staged, under its number.
        memory::check_queue()?;
        let Some(staged) = self.staged.remove(map) else {
            return Err(ServeError::NothingStaged { map: map.to_owned() });
        };
        let sent = self.send(map, staged, overlay).map_err(memory::or_shortage);
        self.tell_if_failed("removing the record", remove_staged(&self.domain, map));
        sent
    }

    /// Copies the bytes of what is staged.
    ///
    /// Errors: nothing is, or less than these.
    pub fn read_staged(&self, map: &str, bytes: &mut [u8]) -> io::Result<()> {
        let staged = self.staged.get(map);
        if let Some(Staged { keeper: Keeper::Daemon(own), .. }) = staged {
            return own.file().read_exact_at(bytes, 0);
        }
        let sample = staged.and_then(|staged| staged.filled.sample.as_ref());
        let chunks = sample.map_or(&[][..], |sample| sample.payload());
        if size_of_val(chunks) < bytes.len() {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        for (own, chunk) in bytes.chunks_mut(size_of::<Chunk64>()).zip(chunks) {
            own.iter_mut().zip(chunk.0).for_each(|(own, byte)| *own = byte);
        }
        Ok(())
    }

    /// Gives up what is staged, if anything is.
    pub fn give_up_staged(&mut self, map: &str) {
        if self.staged.contains_key(map) {
            let exclusive = self.exclusive();
            self.unstage(map, exclusive.as_ref());
        }
    }

    pub(super) fn unstage(&mut self, map: &str, _exclusive: Option<&AttachGuard>) {
        if let Some(staged) = self.staged.remove(map) {
            drop(staged);
            self.tell_if_failed("removing the record", remove_staged(&self.domain, map));
        }
    }

    /// A publisher of its own, with the map in its sample.
    fn fill_next(
        &mut self,
        map: &str,
        length: usize,
        fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn Error + Send + Sync>>,
    ) -> Result<Staged, ServeError> {
        if length == 0 {
            return Err(ServeError::Empty { map: map.to_owned() });
        }
        if self.staged.contains_key(map) {
            // Before there is need for its memory.
            let exclusive = self.exclusive();
            self.unstage(map, exclusive.as_ref());
        }
        self.let_go();
        memory::check(map, length as u64)?;
        self.claim(map)?;
        let Some(ports) = self.maps.get(map) else {
            return Err(ServeError::iceoryx("publishing")("map not claimed"));
        };
        let keeper = {
            let exclusive = self.exclusive();
            // Again, for what has been created since.
            memory::check(map, length as u64)?;
            reserving(|| ports.create_keeper(&self.domain, length, exclusive.as_ref()))?
        };
        let filled =
            greeting_meanwhile(&self.maps, &self.lock, || self.fill(map, length, &keeper, fill));
        match filled {
            Ok(filled) => Ok(Staged { filled, keeper }),
            Err(error) => {
                let exclusive = self.exclusive();
                // Unlinks the segment, under the lock.
                drop(keeper);
                drop(exclusive);
                Err(error)
            }
        }
    }

    /// Reserves, loans and fills. Without the attach lock, for it takes as long as `fill` does.
    fn fill(
        &self,
        map: &str,
        length: usize,
        keeper: &Keeper,
        fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn Error + Send + Sync>>,
    ) -> Result<FilledSegment, ServeError> {
        let io = || ServeError::io(SHARED_MEMORY_FOLDER);
        let found;
        let segment = match keeper {
            Keeper::Publisher(publisher) => {
                found = Segment::of(&self.domain, publisher, &self.segment_type).map_err(io())?;
                &found
            }
            Keeper::Daemon(own) => own.segment(),
        };
        segment.reserve().map_err(|error| memory::refused(map, length as u64, &error))?;
        let locked = self.lock_memory.then(|| segment.lock()).transpose();
        let locked = locked.map_err(|error| memory::not_locked(map, length as u64, &error))?;
        let next = |meta| {
            let notify = |notice: &Notice| (self.notify)(notice);
            let generation = self.generations.next(&self.domain, map, &notify)?;
            Ok(info(generation, length, &meta))
        };
        let (sample, info, place) = match keeper {
            Keeper::Publisher(publisher) => {
                let (sample, place) = fill_sample(map, length, publisher, segment, fill, next)?;
                let info = *sample.user_header();
                (Some(sample), info, place)
            }
            Keeper::Daemon(own) => {
                let info = fill_file(map, own.file(), length, fill, next)?;
                (None, info, segment.whole().map_err(io())?)
            }
        };
        // Nothing has been written through it meanwhile, and nothing will be. It gives the group its right to read, too.
        segment.protect(self.share).map_err(io())?;
        // Without it, the readers of the generation cannot be counted later.
        Ok(FilledSegment { sample, info, place, locked, kept: segment.keep().ok() })
    }

    /// Serves a generation instead of the one before.
    fn send(
        &mut self,
        map: &str,
        staged: Staged,
        overlay: Option<&OverlayBytes>,
    ) -> Result<u64, ServeError> {
        let io = ServeError::io(self.domain.root());
        let overlay =
            overlay.map(|overlay| OverlayFile::write(&self.domain, map, overlay, self.share));
        let overlay = overlay.transpose().map_err(io)?;
        let exclusive = self.exclusive();
        let Staged { filled, keeper } = staged;
        let FilledSegment { mut sample, mut info, mut place, locked, kept } = filled;
        place.overlay = overlay.as_ref().map(|file| file.place);
        info.published_unix_ns = unix_ns();
        if let Some(sample) = &mut sample {
            *sample.user_header_mut() = info;
        }
        // Newcomers since it was made cost a queue each.
        memory::check_queue()?;
        let Some(ports) = self.maps.get_mut(map) else {
            return Err(ServeError::iceoryx("sending")("map not claimed"));
        };
        // What can fail comes first; then subscribers have it, then observers; only then the segment before may go.
        let prepared =
            ports.record.prepare(&info, &place).map_err(ServeError::io(self.domain.root()))?;
        if let Some(sample) = sample {
            reserving(|| sample.send()).map_err(ServeError::iceoryx("sending"))?;
        }
        ports.record.hold(prepared);
        ports.replace(Current { keeper, info, kept, place, overlay }, locked, exclusive.as_ref());
        drop(exclusive);
        if let Some(ports) = self.maps.get(map) {
            self.tell_if_failed("announcing a generation", ports.announce());
        }
        Ok(info.generation)
    }
}

/// Loans a sample and has it filled; it, and where it lies in its publisher's segment.
///
/// Errors: iceoryx2 refuses; it is not found there; `fill` or `header` fails.
fn fill_sample(
    map: &str,
    length: usize,
    publisher: &MapPublisher,
    segment: &Segment,
    fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn Error + Send + Sync>>,
    header: impl FnOnce(PublishMeta) -> Result<GenerationInfo, ServeError>,
) -> Result<(Filled, SegmentLocation), ServeError> {
    let mut loan =
        publisher.loan_slice_uninit(chunks_for(length)).map_err(ServeError::iceoryx("loaning"))?;
    let place = locate_loan(&mut loan, |mark| segment.place_of(mark))
        .unwrap_or_else(|| Err(io::ErrorKind::UnexpectedEof.into()))
        .map_err(ServeError::io(SHARED_MEMORY_FOLDER))?;
    Ok((fill_loan(map, loan, length, fill, header)?, place))
}

fn info(generation: u64, length: usize, meta: &PublishMeta) -> GenerationInfo {
    GenerationInfo {
        generation,
        length: length as u64,
        published_unix_ns: unix_ns(),
        daemon_pid: u64::from(std::process::id()),
        layout_id: meta.layout_id,
        content_hash: meta.content_hash,
        input_hash: meta.input_hash,
    }
}
