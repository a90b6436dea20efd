//! One pinned generation, and facts about its map.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::list::{close, entries, get, hand_out, put, put_some};
use crate::point::mapd_vec3;
use crate::text::{given, mapd_text};
use mapd_client::document::{HeaderOffset, Revision};
use mapd_client::raw::AlignedBytes;
use mapd_client::{Bounds, ClientError, Map, Snapshot, TrustedKey};
use std::ffi::c_char;

/// One generation of a map, pinned: readable as long as the handle is open, even if daemon, client and file are gone. Several threads may
/// use it at once.
pub struct mapd_snapshot(pub(crate) Snapshot);

/// Facts about a map.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_map_facts {
    /// Number of the generation; 0 for a file.
    pub generation: u64,
    /// BLAKE3 of the archive's body.
    pub content_hash: [u8; 32],
    /// BLAKE3 of the OpenDRIVE bytes that it was compiled from.
    pub source_hash: [u8; 32],
    /// Name in the file's header.
    pub name: mapd_text,
    /// `geoReference` as written; empty if there is none.
    pub geo_reference: mapd_text,
    /// The georeference as PROJ parameters; empty if there is none that can be used.
    pub projection: mapd_text,
    /// The header's offset as it is applied: shift \[m\].
    pub header_offset: mapd_vec3,
    /// The header's offset as it is applied: turn \[rad\].
    pub header_heading: f64,
    /// Smallest inertial coordinates of all lanes \[m\].
    pub low: mapd_vec3,
    /// Largest inertial coordinates of all lanes \[m\].
    pub high: mapd_vec3,
    /// Sum of the roads' lengths \[m\].
    pub road_length: f64,
    /// First eight bytes of the content's hash, as in every id.
    pub content: u64,
    /// Number of roads.
    pub roads: u32,
    /// Number of junctions.
    pub junctions: u32,
    /// Number of signals.
    pub signals: u32,
    /// Number of objects.
    pub objects: u32,
    /// OpenDRIVE's version: major; 0 where the file has none.
    pub revision_major: u16,
    /// OpenDRIVE's version: minor.
    pub revision_minor: u16,
}

/// Latitudes and longitudes of a map's bounds on WGS 84 \[deg\].
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_geodetic_bounds {
    /// Smallest latitude.
    pub south: f64,
    /// Largest latitude.
    pub north: f64,
    /// Western longitude.
    pub west: f64,
    /// Eastern longitude; it passes 180 where the map crosses the antimeridian.
    pub east: f64,
}

/// What ids are bound to: the first eight bytes of the content's hash.
fn content_of(hash: &[u8; 32]) -> u64 {
    let [a, b, c, d, e, f, g, h, ..] = *hash;
    u64::from_le_bytes([a, b, c, d, e, f, g, h])
}

/// A copy that lies as archives and overlays need it.
fn aligned(bytes: &[u8]) -> AlignedBytes {
    let mut own = AlignedBytes::with_capacity(bytes.len());
    own.extend_from_slice(bytes);
    own
}

/// The map of a handle.
///
/// # Safety
///
/// `snapshot` is null or a snapshot that is open for `'a`.
#[inline]
pub(crate) unsafe fn map_of<'a>(snapshot: *const mapd_snapshot) -> Result<Map<'a>, Failure> {
    unsafe { Ok(get(snapshot, "a snapshot")?.0.map()) }
}

/// Opens a `.mapd` file in place. Close the snapshot with `mapd_snapshot_close`.
///
/// Errors: `MAPD_CODE_FILE`, `MAPD_CODE_NOT_AN_ARCHIVE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_open(
    path: *const c_char,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let path = given(path, "the path")?;
            hand_out(out, mapd_snapshot(Snapshot::open(path)?))
        })
    }
}

/// As `mapd_snapshot_open`, if the file is signed with the key in the file `key` (minisign); the signature is next to the archive. Reads the
/// whole file.
///
/// Errors: as `mapd_snapshot_open`; `MAPD_CODE_NOT_TRUSTED`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_open_trusted(
    path: *const c_char,
    key: *const c_char,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (path, key) = (given(path, "the path")?, given(key, "the key's path")?);
            let key = TrustedKey::open(key).map_err(ClientError::from)?;
            hand_out(out, mapd_snapshot(Snapshot::open_trusted(path, &key)?))
        })
    }
}

/// As `mapd_snapshot_open`, of an archive in memory: `size` bytes, which are copied.
///
/// Errors: `MAPD_CODE_NOT_AN_ARCHIVE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_from_bytes(
    bytes: *const u8,
    size: usize,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let own = aligned(entries(bytes, size, "the archive")?);
            hand_out(out, mapd_snapshot(Snapshot::from_bytes(own)?))
        })
    }
}

/// Another handle of the same snapshot, to be closed by itself: for another thread or owner.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_clone(
    snapshot: *const mapd_snapshot,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || hand_out(out, mapd_snapshot(get(snapshot, "a snapshot")?.0.clone())))
    }
}

/// Closes a snapshot and sets the handle to null. Null, or a handle that is null, is fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_close(snapshot: *mut *mut mapd_snapshot) {
    unsafe { close(snapshot) }
}

/// The same map with an overlay that was made elsewhere: `size` bytes that the crate mapd-overlay encoded for this map; they are copied. A client's snapshots
/// have the daemon's overlay without this call. Close it with `mapd_snapshot_close`.
///
/// Errors: `MAPD_CODE_NOT_AN_ARCHIVE` for bytes that are not an overlay; `MAPD_CODE_FOREIGN_ID` for an overlay of another map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_with_overlay(
    snapshot: *const mapd_snapshot,
    bytes: *const u8,
    size: usize,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let own = aligned(entries(bytes, size, "the overlay")?);
            hand_out(out, mapd_snapshot(get(snapshot, "a snapshot")?.0.with_overlay(own)?))
        })
    }
}

/// Revision of the map's overlay, which rises with each change; 0 without an overlay. `mapd_view_new` applies the overlay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_overlay_revision(
    snapshot: *const mapd_snapshot,
    out: *mut u64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, get(snapshot, "a snapshot")?.0.overlay_revision())) }
}

/// Verifies the whole archive, its content hash included. Linear in its size; attaching and opening do not do this.
///
/// Errors: `MAPD_CODE_NOT_PROVEN`, with the first fault that is found.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_verify(
    snapshot: *const mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get(snapshot, "a snapshot")?.0.verify()?;
            Ok(mapd_code::OK)
        })
    }
}

/// Maps every page of the archive into this process now, so that no query waits for the kernel. Linear in the archive's size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_snapshot_populate(
    snapshot: *const mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get(snapshot, "a snapshot")?.0.populate();
            Ok(mapd_code::OK)
        })
    }
}

/// Facts about the map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_map_facts_of(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_map_facts,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let map = map_of(snapshot)?;
            let Bounds { low, high } = map.bounds();
            let HeaderOffset { shift, heading } = map.header_offset();
            let (tables, hash) = (map.tables(), map.content_hash());
            let Revision { major, minor } = map.revision();
            put(
                out,
                mapd_map_facts {
                    generation: map.generation(),
                    content_hash: hash,
                    source_hash: map.source_hash(),
                    name: map.name().into(),
                    geo_reference: map.geo_reference().into(),
                    projection: map.projection().into(),
                    header_offset: shift.into(),
                    header_heading: heading,
                    low: low.into(),
                    high: high.into(),
                    road_length: map.road_length(),
                    roads: tables.roads.len() as u32,
                    junctions: tables.junctions.len() as u32,
                    signals: tables.signals.len() as u32,
                    objects: tables.objects.len() as u32,
                    revision_major: major,
                    revision_minor: minor,
                    content: content_of(&hash),
                },
            )
        })
    }
}

/// Latitudes and longitudes of the map's bounds, rounded to 1e-9 degrees. `MAPD_CODE_NONE` without a usable georeference.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_map_geodetic_bounds(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_geodetic_bounds,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let bounds = map_of(snapshot)?.geodetic_bounds();
            let of = |[south, north, west, east]: [f64; 4]| mapd_geodetic_bounds {
                south,
                north,
                west,
                east,
            };
            put_some(out, bounds.map(of))
        })
    }
}
