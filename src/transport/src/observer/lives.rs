//! The protocol around the record's page, searched exhaustively: daemons that publish, lay overlays, end or are killed between any two steps, their
//! successors, and a reader. `model.rs` shows that a slot is read whole; here it is read at once, and everything else is in question: files that are gone,
//! wake-ups that are lost, pages that are removed.
//!
//! A reader changes nothing that anybody sees. So one reader stands for any number of them, and a state is that of the daemons, of the files, and of it.
//! From each state every next step is taken: the daemon's, its kill, the reader's, its look after 100 ms, and the cleaning up of another daemon of the domain, if there is one.
//! The daemon's steps are lists ([`Order`]), and each list in a wrong order must be found ([`wrong_orders_are_found`]). `tests/tests/service/stopped.rs` watches the real daemon's.

use std::collections::{BTreeSet, HashSet};

/// A step of a daemon. A kill comes before or after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Step {
    /// Removes what killed daemons left of segments and overlays.
    Sweep,
    /// Goes on with the page that has the name, or makes one, all of it before it has the name.
    Page,
    /// Makes a page under the name, whatever was there: no daemon does.
    NewPage,
    /// Where its page has lost the name, makes another that says the same, all of it before it has the name.
    Mend,
    /// Closes the page that it has left so: writes there that nothing is served, stores the sequence, wakes who sleeps on it.
    Leave,
    /// Makes a segment, and its overlay, without their bytes.
    Create,
    /// Makes a segment without its bytes, over which nothing lies.
    CreateBare,
    /// Makes another overlay of the same generation, likewise.
    CreateOverlay,
    /// Takes the overlay away: nothing lies over the same generation.
    CreateNothing,
    /// Writes the bytes.
    Fill,
    /// Writes the slot that does not hold.
    Write,
    /// Writes there that nothing is served.
    WriteNothing,
    /// Stores the sequence.
    Store,
    /// Wakes who sleeps on the page.
    Wake,
    /// Removes what the slot before named and this one does not.
    Drop,
    /// Removes the page.
    Unlink,
    /// Removes what was served.
    DropAll,
}

use Step::*;

/// Which steps, in which order.
#[derive(Clone, Copy)]
struct Order {
    start: &'static [Step],
    publish: &'static [Step],
    publish_bare: &'static [Step],
    lay: &'static [Step],
    lay_nothing: &'static [Step],
    close: &'static [Step],
    /// A reader sleeps only if the sequence is still the one that it has read.
    compares: bool,
    /// A reader that may have been left looks which page has the name.
    moves: bool,
    /// Once, at any moment, somebody removes the page by hand, or puts something else under its name.
    robbed: bool,
}

const RIGHT: Order = Order {
    start: &[Sweep, Page],
    publish: &[Create, Fill, Mend, Leave, Write, Store, Wake, Drop],
    publish_bare: &[CreateBare, Fill, Mend, Leave, Write, Store, Wake, Drop],
    lay: &[CreateOverlay, Fill, Mend, Leave, Write, Store, Wake, Drop],
    lay_nothing: &[CreateNothing, Mend, Leave, Write, Store, Wake, Drop],
    close: &[WriteNothing, Store, Wake, Unlink, DropAll],
    compares: true,
    moves: true,
    robbed: false,
};

/// What a daemon does in its life, one after the other.
#[derive(Clone, Copy, Debug)]
enum Work {
    Publish,
    PublishBare,
    Lay,
    LayNothing,
    Close,
}

/// A file: of a generation, or of an overlay. One bit. That nothing lies over a generation has a bit, too, which is of no file.
type File = u32;

/// What a slot says: a generation's segment and its overlay.
type Slot = Option<(File, File)>;

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct PageState {
    sequence: u8,
    slots: [Slot; 2],
    /// The life that last stored the sequence.
    by: usize,
    /// The life that writes it.
    of: usize,
}

impl PageState {
    fn says(&self) -> Slot {
        self.slots[self.sequence as usize % 2]
    }
}

/// What a reader does next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Reading {
    /// Looks whether its page may have been left, and reads it.
    Look,
    /// Opens the segment that it read of.
    Segment(u8, (File, File)),
    /// Has this segment, and reads the page again: what lies over it?
    Again(File),
    /// Opens the overlay that it then read of.
    Overlay(u8, (File, File)),
    /// The file was gone: reads the sequence again.
    Gone(u8),
    /// Goes to sleep, unless the sequence has changed.
    Sleep(u8),
    /// Sleeps on its page.
    Asleep(u8),
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct Reader {
    page: Option<usize>,
    doing: Reading,
    /// What it has.
    has: Slot,
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct World {
    /// The page under the name.
    named: Option<usize>,
    pages: Vec<PageState>,
    /// Files that are there, with those that are filled.
    files: File,
    filled: File,
    /// The last one that was made; the next is greater.
    made: File,
    /// Those that are of generations.
    segments: File,
    /// Those that are none: nothing lies over a generation.
    nothing: File,
    /// The daemon that lives, or the one that is next if `killed`.
    life: usize,
    /// Work and step that it does next.
    work: usize,
    step: usize,
    /// What it is about to say, and its page.
    next: Slot,
    own: usize,
    /// The page that it has left, and has not closed yet.
    left: Option<usize>,
    /// Whether the page has been taken away by hand.
    robbed: bool,
    /// Lives that were killed, a bit each.
    killed: u8,
    /// Something was published, and neither its daemon nor a successor took it back, nor another daemon of the domain.
    served: bool,
    reader: Reader,
}

/// What goes wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Wrong {
    /// A reader has a file that is not filled.
    Unfilled,
    /// A file is gone under the sequence that names it, and its daemon was not killed.
    GoneTooEarly,
    /// A newcomer finds nothing where a generation was published and nobody took it back.
    NothingServed,
    /// A reader went back.
    Back,
    /// A page is removed while somebody sleeps on what it said before.
    AsleepOnRemoved,
    /// A daemon serves, and a reader learns of it only 100 ms later.
    Late,
    /// The same, only after seconds, by the heartbeat's age.
    VeryLate,
    /// Never.
    Never,
}

/// What a reader may look at besides what wakes it.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Patience {
    None,
    /// It looks again after 100 ms.
    Look,
    /// The page's heart has not beaten for 3 s.
    Silence,
}

struct Search<'a> {
    order: Order,
    lives: &'a [&'a [Work]],
    /// Another daemon of the domain serves other maps.
    is_beside_another: bool,
    seen: HashSet<World>,
    found: BTreeSet<Wrong>,
    /// Found all of these, the search ends.
    until: Option<&'a [Wrong]>,
}

impl Search<'_> {
    fn steps(&self, world: &World) -> Option<&'static [Step]> {
        match world.work.checked_sub(1) {
            None => Some(self.order.start),
            Some(i) => Some(match self.lives.get(world.life)?.get(i)? {
                Work::Publish => self.order.publish,
                Work::PublishBare => self.order.publish_bare,
                Work::Lay => self.order.lay,
                Work::LayNothing => self.order.lay_nothing,
                Work::Close => self.order.close,
            }),
        }
    }

    /// Whether the daemon of this moment has ended in order.
    fn is_closed(&self, world: &World) -> bool {
        let ends =
            self.lives.get(world.life).is_some_and(|work| matches!(work.last(), Some(Work::Close)));
        ends && self.steps(world).is_none()
    }

    fn run(&mut self) {
        let reader = Reader { page: None, doing: Reading::Look, has: None };
        let mut open = vec![World {
            named: None,
            pages: Vec::new(),
            files: 0,
            filled: 0,
            made: 1,
            segments: 0,
            nothing: 0,
            life: 0,
            work: 0,
            step: 0,
            next: None,
            own: 0,
            left: None,
            robbed: false,
            killed: 0,
            served: false,
            reader,
        }];
        while let Some(world) = open.pop() {
            if !self.seen.insert(world.clone()) {
                continue;
            }
            self.judge(&world);
            if self.until.is_some_and(|until| until.iter().all(|wrong| self.found.contains(wrong)))
            {
                return;
            }
            let is_last = world.life + 1 == self.lives.len();
            if let Some(steps) = self.steps(&world) {
                let mut next = world.clone();
                self.daemon(&mut next, steps[world.step]);
                open.push(next);
                if !is_last {
                    let mut next = world.clone();
                    next.killed |= 1 << next.life;
                    self.succeed(&mut next);
                    open.push(next);
                }
            } else if !is_last {
                // It has ended in order, or serves until it is killed.
                let mut next = world.clone();
                if !self.is_closed(&world) {
                    next.killed |= 1 << next.life;
                }
                self.succeed(&mut next);
                open.push(next);
            }
            if self.is_beside_another && Self::is_dead(&world) {
                let mut next = world.clone();
                next.files &= !next.segments;
                next.filled &= next.files;
                next.served = false;
                open.push(next);
            }
            if self.order.robbed && !world.robbed && world.named.is_some() {
                let mut next = world.clone();
                (next.named, next.robbed, next.served) = (None, true, false);
                open.push(next);
            }
            let asleep = matches!(world.reader.doing, Reading::Asleep(_));
            let all = [Patience::None, Patience::Look, Patience::Silence];
            for patience in if asleep { &all[1..] } else { &all[..1] } {
                let mut next = world.clone();
                self.read(&mut next, *patience);
                open.push(next);
            }
        }
    }

    /// Whether the last daemon was killed, and its successor, if there is one, has done nothing yet. Only then is there anything that another daemon removes: segments,
    /// whose processes are dead.
    fn is_dead(world: &World) -> bool {
        let (killed, begun) =
            (world.killed >> world.life.saturating_sub(1) & 1, world.work + world.step);
        world.life > 0 && killed == 1 && begun == 0
    }

    fn succeed(&self, world: &mut World) {
        (world.life, world.work, world.step, world.next) = (world.life + 1, 0, 0, None);
        world.left = None;
    }

    fn daemon(&mut self, world: &mut World, step: Step) {
        world.step += 1;
        if world.step == self.steps(world).map_or(0, <[Step]>::len) {
            (world.work, world.step) = (world.work + 1, 0);
        }
        let life = world.life;
        let make = |world: &mut World| {
            world.made <<= 1;
            world.files |= world.made;
            world.made
        };
        let make_nothing = |world: &mut World| {
            world.made <<= 1;
            world.nothing |= world.made;
            world.made
        };
        match step {
            Sweep => {
                (world.files, world.filled) = (0, 0);
                world.served = false;
            }
            Page if world.named.is_some() => {
                world.own = world.named.unwrap_or(0);
                world.pages[world.own].of = life;
            }
            Page | NewPage => {
                world.pages.push(PageState { sequence: 0, slots: [None; 2], by: life, of: life });
                world.own = world.pages.len() - 1;
                world.named = Some(world.own);
            }
            Mend if world.named != Some(world.own) => {
                let page = &mut world.pages[world.own];
                // Its heart does not beat any more.
                page.of = usize::MAX;
                // What a killed daemon said is still its word.
                let (said, sequence, by) = (page.says(), page.sequence + 1, page.by);
                let mut slots = [None; 2];
                slots[sequence as usize % 2] = said;
                world.pages.push(PageState { sequence, slots, by, of: life });
                world.left = Some(world.own);
                world.own = world.pages.len() - 1;
                world.named = Some(world.own);
                world.served = said.is_some() && by == life;
            }
            Mend => {}
            Leave => {
                let Some(left) = world.left.take() else { return };
                let page = &mut world.pages[left];
                page.sequence += 1;
                (page.slots[page.sequence as usize % 2], page.by) = (None, life);
                if let (Reading::Asleep(_), true) =
                    (world.reader.doing, world.reader.page == Some(left))
                {
                    world.reader.doing = Reading::Look;
                }
            }
            Create => {
                let segment = make(world);
                world.segments |= segment;
                world.next = Some((segment, make(world)));
            }
            CreateBare => {
                let segment = make(world);
                world.segments |= segment;
                world.next = Some((segment, make_nothing(world)));
            }
            CreateOverlay | CreateNothing => {
                let segment = world.pages[world.own].says().map_or(0, |(segment, _)| segment);
                let over = if step == CreateOverlay { make(world) } else { make_nothing(world) };
                world.next = Some((segment, over));
            }
            Fill => {
                let (segment, overlay) = world.next.expect("made");
                world.filled |= segment | overlay;
            }
            Write | WriteNothing => {
                let said = if step == Write { world.next } else { None };
                let page = &mut world.pages[world.own];
                page.slots[(page.sequence as usize + 1) % 2] = said;
            }
            Store => {
                let page = &mut world.pages[world.own];
                page.sequence += 1;
                page.by = life;
                // One that was taken away meanwhile is made anew by the next publication.
                let is_found = !world.robbed || world.named == Some(world.own);
                world.served = page.says().is_some() && is_found;
            }
            Wake => {
                if let (Reading::Asleep(_), Some(page)) = (world.reader.doing, world.reader.page)
                    && page == world.own
                {
                    world.reader.doing = Reading::Look;
                }
            }
            Drop => {
                let (segment, overlay) = world.next.expect("made");
                world.files &= segment | overlay;
            }
            Unlink => {
                world.named = None;
                let page = &world.pages[world.own];
                if let (Reading::Asleep(sequence), Some(own)) =
                    (world.reader.doing, world.reader.page)
                    && own == world.own
                    && sequence != page.sequence
                {
                    self.found.insert(Wrong::AsleepOnRemoved);
                }
            }
            DropAll => world.files = 0,
        }
    }

    /// The reader's next step. With patience, what it does once it has slept so long.
    fn read(&mut self, world: &mut World, patience: Patience) {
        match world.reader.doing {
            Reading::Look => self.look(world, Patience::None),
            Reading::Asleep(_) if patience > Patience::None => self.look(world, patience),
            Reading::Asleep(_) => {}
            Reading::Segment(sequence, files) => {
                let there = self.open(world, files.0);
                world.reader.doing =
                    if there { Reading::Again(files.0) } else { Reading::Gone(sequence) };
            }
            Reading::Again(segment) => {
                self.find_page(world, Patience::None);
                let page = world.reader.page.map(|page| &world.pages[page]);
                let said = page.and_then(|page| Some((page.sequence, page.says()?)));
                world.reader.doing = match said {
                    Some((sequence, files)) if files.0 == segment => {
                        Reading::Overlay(sequence, files)
                    }
                    // Another generation: it tries that one.
                    Some(_) => Reading::Look,
                    // Nothing is served any more: it has the segment, with what it knew to lie over it.
                    None => {
                        let known = world.reader.has.filter(|has| has.0 == segment);
                        self.have(world, known.unwrap_or((segment, 0)));
                        Reading::Look
                    }
                };
            }
            Reading::Overlay(sequence, files) => {
                if !self.open(world, files.1) {
                    world.reader.doing = Reading::Gone(sequence);
                    return;
                }
                self.have(world, files);
                world.reader.doing = Reading::Look;
            }
            Reading::Gone(sequence) => {
                let page = &world.pages[world.reader.page.expect("read")];
                // With the same sequence, there is nothing to be had before it changes.
                world.reader.doing = if page.sequence == sequence {
                    if world.killed >> page.by & 1 == 0 {
                        self.found.insert(Wrong::GoneTooEarly);
                    }
                    Reading::Sleep(sequence)
                } else {
                    Reading::Look
                };
            }
            Reading::Sleep(sequence) => {
                let page = &world.pages[world.reader.page.expect("read")];
                let changed = self.order.compares && page.sequence != sequence;
                world.reader.doing =
                    if changed { Reading::Look } else { Reading::Asleep(sequence) };
            }
        }
    }

    fn have(&mut self, world: &mut World, files: (File, File)) {
        if world.reader.has.is_some_and(|has| has > files) {
            self.found.insert(Wrong::Back);
        }
        world.reader.has = Some(files);
    }

    /// The reader's page: the one that it has, unless that may have been left and another has the name.
    fn find_page(&self, world: &mut World, patience: Patience) {
        if let Some(page) = world.reader.page {
            let state = &world.pages[page];
            let is_closed = state.says().is_none();
            let is_silent =
                patience == Patience::Silence && (state.of != world.life || self.is_closed(world));
            if self.order.moves && (is_closed || is_silent) && world.named != Some(page) {
                world.reader.page = None;
            }
        }
        world.reader.page = world.reader.page.or(world.named);
    }

    fn look(&mut self, world: &mut World, patience: Patience) {
        self.find_page(world, patience);
        world.reader.doing = match world.reader.page.map(|page| &world.pages[page]) {
            // It tries again after a pause.
            None => Reading::Look,
            Some(page) => match page.says() {
                Some(files) if Some(files) != world.reader.has => {
                    Reading::Segment(page.sequence, files)
                }
                _ => Reading::Sleep(page.sequence),
            },
        };
    }

    fn open(&mut self, world: &World, file: File) -> bool {
        if world.nothing & file != 0 {
            return true;
        }
        let there = world.files & file != 0;
        if there && world.filled & file == 0 {
            self.found.insert(Wrong::Unfilled);
        }
        there
    }
}

impl Search<'_> {
    /// What must hold in this state.
    fn judge(&mut self, world: &World) {
        let whole = world.files & world.filled | world.nothing;
        let named = world.named.and_then(|page| world.pages[page].says());
        if world.served && named.is_none_or(|(a, b)| whole & a == 0 || whole & b == 0) {
            self.found.insert(Wrong::NothingServed);
        }
        let is_last = world.life + 1 == self.lives.len();
        if !is_last || self.steps(world).is_some() || named.is_none() {
            return;
        }
        // The daemon serves and does nothing more: what does the reader need to have it?
        let mut rest = world.clone();
        let needs = [
            (Patience::None, None),
            (Patience::Look, Some(Wrong::Late)),
            (Patience::Silence, Some(Wrong::VeryLate)),
        ];
        for (patience, wrong) in needs {
            self.read(&mut rest, patience);
            while !matches!(rest.reader.doing, Reading::Asleep(_)) {
                self.read(&mut rest, Patience::None);
            }
            if rest.reader.has == named {
                self.found.extend(wrong);
                return;
            }
        }
        self.found.insert(Wrong::Never);
    }
}

/// What goes wrong, and in how many states it was looked for; with `until`, only until all of that is found.
fn found(
    order: Order,
    lives: &[&[Work]],
    is_beside_another: bool,
    until: Option<&[Wrong]>,
) -> (BTreeSet<Wrong>, usize) {
    let (seen, found) = (HashSet::new(), BTreeSet::new());
    let mut search = Search { order, lives, is_beside_another, seen, found, until };
    search.run();
    (search.found, search.seen.len())
}

/// Daemons that serve until they are killed, the last one for good.
const KILLED: [&[Work]; 3] = [
    &[Work::Publish, Work::Lay, Work::Publish],
    &[Work::Publish, Work::Lay],
    &[Work::Publish, Work::Publish],
];

/// Daemons that end, if they are not killed before.
const ENDED: [&[Work]; 3] = [
    &[Work::Publish, Work::Publish, Work::Publish, Work::Close],
    &[Work::Publish, Work::Lay, Work::Close],
    &[Work::Publish],
];

/// Readers are woken by whatever is published, whoever was killed where, and never find less than was promised. Only who waits beyond a daemon's end, on a page that
/// was removed, has to look again.
#[test]
fn whatever_is_killed_readers_go_on() {
    check(&KILLED, &[]);
    check(&ENDED, &[Wrong::Late]);
    let between: [&[Work]; 4] = [
        &[Work::Publish, Work::Close],
        &[Work::Publish, Work::Lay, Work::Publish],
        &[Work::Publish, Work::Lay, Work::Close],
        &[Work::Publish],
    ];
    check(&between, &[Wrong::Late]);
    let bare: [&[Work]; 3] = [
        &[Work::PublishBare, Work::Lay, Work::LayNothing, Work::Publish],
        &[Work::Publish, Work::LayNothing],
        &[Work::PublishBare, Work::Lay],
    ];
    check(&bare, &[]);
}

/// Searches all of it, beside another daemon, which may also do nothing; exactly this goes wrong.
fn check(lives: &[&[Work]], expected: &[Wrong]) {
    let (found, states) = found(RIGHT, lives, true, None);
    assert_eq!(found.into_iter().collect::<Vec<_>>(), expected, "{lives:?}");
    assert!(states > 10_000, "{states} states are not all of them");
}

/// Nothing goes wrong without another daemon, either, nor where a starting daemon has its page before it sweeps.
#[test]
fn other_ways_that_are_right() {
    let (alone, without) = found(RIGHT, &KILLED, false, None);
    let (beside, with) = found(RIGHT, &KILLED, true, None);
    let (paged, _) = found(Order { start: &[Page, Sweep], ..RIGHT }, &KILLED, true, None);
    let all = [alone, beside, paged];
    assert!(all.iter().all(|wrong| wrong.is_empty()), "{all:?}");
    assert!(with > without, "another daemon changes nothing");
}

/// Where the page is taken away by hand, readers have the next generation at once, whoever waited where; if the daemon is killed before it has
/// told them, once they look at the page and its heartbeat.
#[test]
fn a_page_that_lost_its_name_is_made_anew() {
    let robbed = Order { robbed: true, ..RIGHT };
    let one: [&[Work]; 1] = [&[Work::Publish, Work::Lay, Work::Publish, Work::PublishBare]];
    let killed: [&[Work]; 2] = [one[0], &[Work::Publish, Work::Lay]];
    for (lives, expected) in [(&one[..], &[][..]), (&killed, &[Wrong::Late, Wrong::VeryLate])] {
        let (found, states) = found(robbed, lives, true, None);
        assert_eq!(found.into_iter().collect::<Vec<_>>(), expected, "{lives:?}");
        assert!(states > 500, "{states} states are not all of them");
    }
}

/// What is wrong, the order, whose lives, and at least what is found.
type Case = (&'static str, Order, [&'static [Work]; 3], &'static [Wrong]);

#[test]
fn wrong_orders_are_found() {
    let publish = |publish| Order { publish, ..RIGHT };
    let close = |close| Order { close, ..RIGHT };
    let cases: [Case; 18] = [
        (
            "the segment goes before the sequence is stored",
            publish(&[Create, Fill, Write, Drop, Store, Wake]),
            KILLED,
            &[Wrong::GoneTooEarly, Wrong::NothingServed],
        ),
        (
            "the overlay does",
            Order { lay: &[CreateOverlay, Fill, Write, Drop, Store, Wake], ..RIGHT },
            KILLED,
            &[Wrong::GoneTooEarly, Wrong::NothingServed],
        ),
        (
            "woken before it is stored",
            publish(&[Create, Fill, Write, Wake, Store, Drop]),
            KILLED,
            &[Wrong::Late],
        ),
        ("nobody is woken", publish(&[Create, Fill, Write, Store, Drop]), KILLED, &[Wrong::Late]),
        (
            "nobody is woken by an overlay",
            Order { lay: &[CreateOverlay, Fill, Write, Store, Drop], ..RIGHT },
            [&[Work::Publish], &[Work::Publish], &[Work::Publish, Work::Lay]],
            &[Wrong::Late],
        ),
        (
            "stored before it is written",
            publish(&[Create, Fill, Store, Write, Wake, Drop]),
            ENDED,
            &[Wrong::GoneTooEarly],
        ),
        (
            "filled after the record names it",
            publish(&[Create, Write, Store, Wake, Fill, Drop]),
            KILLED,
            &[Wrong::Unfilled, Wrong::NothingServed],
        ),
        ("removed without being closed", close(&[Unlink, DropAll]), ENDED, &[Wrong::VeryLate]),
        (
            "closed after it is removed",
            close(&[Unlink, WriteNothing, Store, Wake, DropAll]),
            ENDED,
            &[Wrong::VeryLate, Wrong::NothingServed],
        ),
        (
            "closed, and nobody is woken",
            close(&[WriteNothing, Store, Unlink, DropAll]),
            ENDED,
            &[Wrong::AsleepOnRemoved],
        ),
        (
            "what was served goes before the record is closed",
            close(&[DropAll, WriteNothing, Store, Wake, Unlink]),
            ENDED,
            &[Wrong::GoneTooEarly, Wrong::NothingServed],
        ),
        (
            "a page that lost its name is left without being closed",
            Order {
                robbed: true,
                publish: &[Create, Fill, Mend, Write, Store, Wake, Drop],
                ..RIGHT
            },
            [&[Work::Publish], &[Work::Publish], &[Work::Publish, Work::Publish]],
            &[Wrong::VeryLate],
        ),
        (
            "a page is made anew only after what the one before named has gone",
            Order {
                robbed: true,
                publish: &[Create, Fill, Drop, Mend, Leave, Write, Store, Wake],
                ..RIGHT
            },
            KILLED,
            &[Wrong::GoneTooEarly, Wrong::NothingServed],
        ),
        (
            "a successor makes a page of its own",
            Order { start: &[Sweep, NewPage], ..RIGHT },
            KILLED,
            &[Wrong::VeryLate],
        ),
        (
            "a reader sleeps without comparing",
            Order { compares: false, ..RIGHT },
            KILLED,
            &[Wrong::Late],
        ),
        (
            "a publication stores thrice, and says the one before in between",
            publish(&[Create, Fill, Write, Store, Store, Store, Wake]),
            KILLED,
            &[Wrong::Back],
        ),
        (
            "a successor makes a page of its own, and readers stay on theirs",
            Order { start: &[Sweep, NewPage], moves: false, ..RIGHT },
            KILLED,
            &[Wrong::Never],
        ),
        (
            "readers stay on a page that is removed",
            Order { moves: false, ..RIGHT },
            ENDED,
            &[Wrong::Never],
        ),
    ];
    for (name, order, lives, expected) in cases {
        let (found, _) = found(order, &lives, false, Some(expected));
        assert!(expected.iter().all(|wrong| found.contains(wrong)), "{name}: {found:?}");
    }
}
