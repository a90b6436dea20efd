//! The file's own frame, of a map that was compiled into another.

use crate::extents::{Bounds, HeaderOffset};
use crate::map::Map;
use glam::DVec3;
use mapd_archive::{ArchivedFileFrameRow, string};

/// The frame of the OpenDRIVE file and the way from it into the map's (docs/coordinates.md).
#[derive(Clone, Copy)]
pub struct FileFrame<'a> {
    map: Map<'a>,
    row: &'a ArchivedFileFrameRow,
}

impl<'a> Map<'a> {
    /// The file's own frame, where the map was compiled into another one (`--crs`); none where the map's is the file's.
    pub fn file_frame(&self) -> Option<FileFrame<'a>> {
        Some(FileFrame { map: *self, row: self.tables().file_frames.first()? })
    }

    /// Smallest and largest latitude, then western and eastern longitude of the map's bounds on WGS 84 `[deg]`, rounded to
    /// 1e-9 degrees. The eastern longitude passes 180 where the map crosses the antimeridian. None without a usable
    /// georeference, or where the map lies outside its area.
    pub fn geodetic_bounds(&self) -> Option<[f64; 4]> {
        let row = self.tables().map.first().filter(|row| row.has_geodetic_bounds() == 1)?;
        Some([row.south(), row.north(), row.west(), row.east()])
    }
}

impl<'a> FileFrame<'a> {
    /// The target frame as it was asked for, such as `utm` or `epsg:25832`.
    pub fn target(&self) -> &'a str {
        string(self.map.tables(), self.row.target())
    }

    /// The file's georeference as PROJ parameters, only such as were understood.
    pub fn projection(&self) -> &'a str {
        string(self.map.tables(), self.row.projection())
    }

    /// The header's offset as it was applied before the transformation: shift `[m]` and turn `[rad]`.
    pub fn offset(&self) -> HeaderOffset {
        let r = self.row;
        let shift = DVec3::new(r.offset_x(), r.offset_y(), r.offset_z());
        HeaderOffset { shift, heading: r.offset_hdg() }
    }

    /// Smallest and largest coordinates of all lanes in the file's frame `[m]`.
    pub fn bounds(&self) -> Bounds {
        let r = self.row;
        Bounds {
            low: DVec3::new(r.min_x(), r.min_y(), r.min_z()),
            high: DVec3::new(r.max_x(), r.max_y(), r.max_z()),
        }
    }

    /// Bound on the distance of a point of a reference line from the exact image of that point of the file `[m]`. A point
    /// beside the line at t lies farther off by t times what [`Self::scale_min`] and [`Self::scale_max`] differ from 1, as widths stay as written.
    pub fn error(&self) -> f64 {
        self.row.error()
    }

    /// z of the map minus z as written `[m]`: the header's offset, the origin's height, and the datum's shift at the map's
    /// middle.
    pub fn height_shift(&self) -> f64 {
        self.row.height_shift()
    }

    /// Bound on the difference between [`Self::height_shift`] and that of any place of the map `[m]`: 0 but where a datum is
    /// shifted.
    pub fn height_error(&self) -> f64 {
        self.row.height_error()
    }

    /// Smallest distance in the map per distance in the file, along any direction at any reference line.
    pub fn scale_min(&self) -> f64 {
        self.row.scale_min()
    }

    /// Largest distance in the map per distance in the file, along any direction at any reference line.
    pub fn scale_max(&self) -> f64 {
        self.row.scale_max()
    }
}
