//! The borrowed map.

use crate::error::QueryError;
use crate::extents::{Bounds, HeaderOffset, Revision};
use crate::ids::{JunctionId, LaneId, LaneSectionId, ONLY_TILE, RoadId};
use crate::junction::Junction;
use crate::key::{LaneKey, LaneLayer};
use crate::lane::Lane;
use crate::road::Road;
use crate::section::LaneSection;
use glam::{DVec2, DVec3};
use mapd_archive::{Archive, ArchivedMapRow, GeoReferenceForm, Tables, string};

/// A view of an opened archive. `Copy`, two words, valid as long as the archive is borrowed.
#[derive(Clone, Copy)]
pub struct Map<'a> {
    pub(crate) archive: &'a Archive<'a>,
    pub(crate) generation: u64,
}

impl<'a> Map<'a> {
    /// A view of an archive that was opened elsewhere. `generation` is what it was published as, 0 for a file.
    pub fn new(archive: &'a Archive<'a>, generation: u64) -> Self {
        Self { archive, generation }
    }

    /// The tables themselves, for what no query answers.
    #[inline]
    pub fn tables(&self) -> &'a Tables<'a> {
        &self.archive.tables
    }

    /// What the map was published as; rises with every swap. 0 for a map opened from a file.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// BLAKE3 of the archive's body.
    pub fn content_hash(&self) -> [u8; 32] {
        self.archive.header.content_hash
    }

    /// BLAKE3 of the OpenDRIVE bytes that the map was compiled from.
    pub fn source_hash(&self) -> [u8; 32] {
        self.archive.header.provenance.input_hash
    }

    /// Ties ids to this content.
    #[inline]
    pub(crate) fn content(&self) -> u64 {
        let [a, b, c, d, e, f, g, h, ..] = self.archive.header.content_hash;
        u64::from_le_bytes([a, b, c, d, e, f, g, h])
    }

    fn row(&self) -> Option<&'a ArchivedMapRow> {
        self.tables().map.first()
    }

    /// Name in the file's header.
    pub fn name(&self) -> &'a str {
        self.row().map_or("", |row| string(self.tables(), row.name()))
    }

    /// The version of OpenDRIVE that the file states.
    pub fn revision(&self) -> Revision {
        let revision =
            |row: &ArchivedMapRow| Revision { major: row.rev_major(), minor: row.rev_minor() };
        self.row().map(revision).unwrap_or_default()
    }

    /// Text of `geoReference` as written; empty if there is none.
    pub fn geo_reference(&self) -> &'a str {
        self.row().map_or("", |row| string(self.tables(), row.geo_reference()))
    }

    /// How `geoReference` is written.
    pub fn geo_reference_form(&self) -> GeoReferenceForm {
        let code = self.row().map_or(0, |row| row.geo_reference_form());
        GeoReferenceForm::from_code(code)
    }

    /// The georeference as PROJ parameters, only such as were understood when the map was compiled; empty if there is none
    /// that can be used.
    pub fn projection(&self) -> &'a str {
        self.row().map_or("", |row| string(self.tables(), row.projection()))
    }

    /// The header's offset as it is applied: where a point of the map lies in the plane of [`Map::projection`].
    pub fn header_offset(&self) -> HeaderOffset {
        self.row().map_or_else(HeaderOffset::default, |row| HeaderOffset {
            shift: DVec3::new(row.offset_x(), row.offset_y(), row.offset_z()),
            heading: row.offset_hdg(),
        })
    }

    /// Whether the sign of the header's offset was turned, because the file's tool writes it so or an option said so.
    pub fn offset_is_negated(&self) -> bool {
        self.row().is_some_and(|row| row.offset_sign() == 1)
    }

    /// The box around all lanes, within the polylines' tolerance.
    pub fn bounds(&self) -> Bounds {
        self.row().map_or_else(Bounds::default, |r| Bounds {
            low: DVec3::new(r.min_x(), r.min_y(), r.min_z()),
            high: DVec3::new(r.max_x(), r.max_y(), r.max_z()),
        })
    }

    /// Sum of the roads' lengths `[m]`.
    pub fn road_length(&self) -> f64 {
        self.row().map_or(0.0, |row| row.road_length())
    }

    /// Local origin `[m]`: what stored geometry is relative to.
    pub fn local_origin(&self) -> DVec2 {
        self.origin()
    }

    #[inline]
    pub(crate) fn origin(&self) -> DVec2 {
        self.row().map_or(DVec2::ZERO, |row| DVec2::new(row.origin_x(), row.origin_y()))
    }

    /// Largest distance of a lane's centre line from its polyline `[m]`.
    pub(crate) fn index_tolerance(&self) -> f64 {
        self.row().map_or(f64::INFINITY, |row| row.index_tolerance())
    }

    #[inline]
    pub(crate) fn known(&self, content: u64, tile: u32) -> Result<(), QueryError> {
        let own = content == self.content() && tile == ONLY_TILE;
        if own { Ok(()) } else { Err(QueryError::ForeignId) }
    }

    /// As [`Self::known`], of an id with this row.
    #[inline]
    pub(crate) fn known_id(&self, row: u32, content: u64, tile: u32) -> Result<(), QueryError> {
        self.known(content, tile).map_err(|error| error.of_row(row))
    }

    /// The road of an id.
    ///
    /// Errors: an id of another map content, or that names nothing; a damaged archive.
    #[inline]
    pub fn road(&self, id: RoadId) -> Result<Road<'a>, QueryError> {
        self.known_id(id.row, id.content, id.tile)?;
        Road::new(*self, id.row).ok_or_else(|| QueryError::Corrupt.of_row(id.row))
    }

    /// The lane section of an id.
    ///
    /// Errors: an id of another map content, or that names nothing; a damaged archive.
    pub fn section(&self, id: LaneSectionId) -> Result<LaneSection<'a>, QueryError> {
        self.known_id(id.row, id.content, id.tile)?;
        LaneSection::new(*self, id.row).ok_or_else(|| QueryError::Corrupt.of_row(id.row))
    }

    /// The lane of an id.
    ///
    /// Errors: an id of another map content, or that names nothing; a damaged archive.
    #[inline]
    pub fn lane(&self, id: LaneId) -> Result<Lane<'a>, QueryError> {
        self.known_id(id.row, id.content, id.tile)?;
        Lane::new(*self, id.row).ok_or_else(|| QueryError::Corrupt.of_row(id.row))
    }

    /// The junction of an id.
    ///
    /// Errors: an id of another map content, or that names nothing; a damaged archive.
    pub fn junction(&self, id: JunctionId) -> Result<Junction<'a>, QueryError> {
        self.known_id(id.row, id.content, id.tile)?;
        Junction::new(*self, id.row).ok_or_else(|| QueryError::Corrupt.of_row(id.row))
    }

    /// All roads in file order.
    pub fn roads(&self) -> impl Iterator<Item = Road<'a>> + use<'a> {
        let map = *self;
        (0..map.tables().roads.len() as u32).filter_map(move |row| Road::new(map, row))
    }

    /// All junctions in file order.
    pub fn junctions(&self) -> impl Iterator<Item = Junction<'a>> + use<'a> {
        let map = *self;
        (0..map.tables().junctions.len() as u32).filter_map(move |row| Junction::new(map, row))
    }

    /// All lanes, lane 0 of each section left out.
    pub fn lanes(&self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        let map = *self;
        (0..map.tables().lanes.len() as u32)
            .filter_map(move |row| Lane::new(map, row))
            .filter(|lane| lane.number() != 0 && !lane.is_temporary())
    }

    /// The road with OpenDRIVE's id, compared byte by byte.
    pub fn road_by_id(&self, id: &str) -> Option<Road<'a>> {
        let name = |row: u32| Road::new(*self, row).map(|road| road.id());
        Road::new(*self, find(self.tables().roads_by_id, id, name)?)
    }

    /// The junction with OpenDRIVE's id, compared byte by byte.
    pub fn junction_by_id(&self, id: &str) -> Option<Junction<'a>> {
        let name = |row: u32| Junction::new(*self, row).map(|junction| junction.id());
        Junction::new(*self, find(self.tables().junctions_by_id, id, name)?)
    }

    /// The lane with this name; of one in several pieces (see [`Lane::continues`]) the first.
    pub fn lane_by_key(&self, key: &LaneKey<'_>) -> Option<Lane<'a>> {
        let road = self.road_by_id(&key.road)?;
        let section = match key.layer {
            LaneLayer::Permanent => road.section(key.section),
            LaneLayer::Temporary => road.temporary_sections().nth(key.section as usize),
        };
        section?.lane(key.lane).filter(|lane| !lane.continues())
    }
}

/// Row with an id, from rows in byte order of their ids.
pub(crate) fn find<'a>(
    rows: &[u32],
    id: &str,
    name: impl Fn(u32) -> Option<&'a str>,
) -> Option<u32> {
    let at =
        rows.binary_search_by(|row| name(*row).unwrap_or("").as_bytes().cmp(id.as_bytes())).ok()?;
    rows.get(at).copied()
}
