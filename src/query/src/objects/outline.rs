//! Outlines of objects.

use super::placement::ObjectPlacement;
use glam::DVec3;
use mapd_archive::{
    ArchivedObjectOutlineRow, ArchivedObjectPointRow, LaneType, NONE, OutlineFill, outline_flags,
};

/// An outline of an object where it stands (OpenDRIVE 1.8.1, 13.2).
#[derive(Clone, Copy)]
pub struct ObjectOutline<'a> {
    placement: ObjectPlacement<'a>,
    row: &'a ArchivedObjectOutlineRow,
}

impl<'a> ObjectOutline<'a> {
    pub(super) fn new(placement: ObjectPlacement<'a>, row: &'a ArchivedObjectOutlineRow) -> Self {
        Self { placement, row }
    }

    /// OpenDRIVE's id of the outline within its object, if it has one.
    pub fn id(&self) -> Option<u32> {
        Some(self.row.id()).filter(|id| *id != NONE)
    }

    /// Whether it is an outer outline, not that of a hole.
    pub fn is_outer(&self) -> bool {
        self.row.flags() & outline_flags::OUTER != 0
    }

    /// Whether it encloses an area: the last corner leads back to the first.
    pub fn is_closed(&self) -> bool {
        self.row.flags() & outline_flags::CLOSED != 0
    }

    /// What fills it.
    pub fn fill(&self) -> OutlineFill {
        OutlineFill::from_code(self.row.fill())
    }

    /// Lane type that the area stands for; `None` if not given.
    pub fn lane_type(&self) -> LaneType {
        LaneType::from_code(self.row.lane_type())
    }

    /// Number of corners.
    pub fn len(&self) -> usize {
        self.points().len()
    }

    /// Whether it has no corners (a damaged archive).
    pub fn is_empty(&self) -> bool {
        self.points().is_empty()
    }

    pub(super) fn points(&self) -> &'a [ArchivedObjectPointRow] {
        self.row.points().of(self.placement.object().map.tables().object_points)
    }

    /// Corners in order, at the object's foot: inertial `[m]`.
    pub fn positions(
        &self,
    ) -> impl ExactSizeIterator<Item = DVec3> + DoubleEndedIterator + use<'a> {
        let (origin, axes) = (self.placement.position(), self.placement.attitude());
        self.points().iter().map(move |p| origin + axes.to_parent(local(p)))
    }

    /// The object's height at each corner `[m]`, above the corner along the object's own axis.
    pub fn heights(&self) -> impl ExactSizeIterator<Item = f64> + use<'a> {
        self.points().iter().map(|p| f64::from(p.height()))
    }
}

pub(super) fn local(p: &ArchivedObjectPointRow) -> DVec3 {
    DVec3::new(f64::from(p.u()), f64::from(p.v()), f64::from(p.z()))
}
