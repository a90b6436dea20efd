//! Daemon and clients as processes: boot, reloads, events, kills, oversight, trust.

// Archives that a daemon is given: what it is told besides holds or is refused, and what they are without is told.
mod archives;
// `mapd doctor`: each trouble is named with what to do about it, and a sound domain has none.
mod doctor;
// What a client hears of its map and daemon, and the error of a wait that ends without a map.
mod events;
// The program on the README's first screen, word for word, works at boot in any order of starting.
mod first_screen;
// Generations that readers hold after others have taken their place.
mod held;
// Files that are not what their names say: pipes that nobody writes to, folders, devices that never end, other maps' archives.
mod hostile_files;
// What commands print as JSON is what the published schemas say: every field is there, and no other.
mod json_schemas;
// `mapd compile` killed at each system call of its writing.
mod killed_writers;
// Limits of a process: a daemon that may open too few files, a client likewise, files that may not grow, memory that is not there.
mod limits;
// `--lock-memory`: what is served is kept from swap, one generation of it, and a limit that is too low is said at once.
mod locked;
// What attaching does to the process that attaches: nothing but what it says.
mod manners;
// One daemon with many maps.
mod many_maps;
// Readers that write nothing: what attaching takes, swaps under many of them, and daemons that end.
mod observers;
// Records and segments that are not what a daemon makes: an observer says so, and neither hangs nor crashes.
mod observers_hostile;
// What is laid over a served map: readers see it, it outlives the daemon, and comes with each new generation at once.
mod overlays;
// `mapd overlay NAME apply --watch`: what a fetcher writes is laid over the map for as long as it says so.
mod overlays_followed;
// Signed entries of overlays: what the trusted key signed is laid over the map and kept, everything else is refused with its reason.
mod overlays_signed;
// Overlays and new generations: readers have what belongs together, under swaps, stages, and changes of the overlay in between.
mod overlays_swapped;
// What is wrong with entries: refused whole, with the entry and the field, or the limit; what is served stays.
mod overlays_wrong;
// What a daemon shows while it runs: logs, metrics, the service manager's socket, proofs of what is served.
mod oversight;
// What changes geometry is a patch: compiled with the map and swapped in as a generation.
mod patches;
// Daemon and clients as processes: any order of starting, crashes, restarts, one name twice.
mod processes;
// What processes on board propose: taken as the policy says, told in the audit log.
mod proposals;
// Daemon and client of different ages: a client reads archives with a table more, and with one less, than its release knows.
mod releases;
// Many reloads under clients that ask without pause.
mod reload_storm;
// What goes bad in shared memory is found whatever it is, and a reload repairs it.
mod repairs;
// A daemon in service: maps change under readers, and whatever goes wrong has a clear outcome and leaves the served map as it is.
mod service;
// A daemon in trouble that is not its own: no room, too many clients, clients that dawdle, signals at the wrong moment.
mod service_trouble;
// A map that is shared with a group: its members read, and can do no more.
mod shared;
// Readers that are stopped, at any moment, while generations and daemons change, and go on.
mod stopped;
// What another user puts into /dev/shm: it changes nothing, and stops nobody who does not need its name.
mod strangers;
// Many threads read while generations change under them: every answer belongs to the generation it was asked of.
mod threads;
// Signed archives: what is signed by the trusted key is served and queried, everything else is refused with its reason.
mod trust;
// `mapd view`: who is answered what.
mod view;
