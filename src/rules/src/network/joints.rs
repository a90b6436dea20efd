//! Where lanes go on: the section that touches an end of a section, and the lanes that links name there.

use super::{
    Contact, LaneFacts, LinkTarget, NONE, Name, Network, RoadFacts, SectionFacts, Station,
};

/// A section that touches another one.
#[derive(Clone, Copy, Debug)]
pub struct Neighbor<'a> {
    /// Its road.
    pub road: &'a RoadFacts,
    /// The section.
    pub section: &'a SectionFacts,
    /// Which end of it touches.
    pub end: Contact,
}

/// A lane's link, resolved as far as it can be.
#[derive(Clone, Copy, Debug)]
pub struct LaneJoint<'a> {
    /// The road, section and lane that has the link.
    pub road: &'a RoadFacts,
    /// The section.
    pub section: &'a SectionFacts,
    /// Rank of the section in its road.
    pub rank: usize,
    /// The lane.
    pub lane: &'a LaneFacts,
    /// Rank of the lane among all lanes.
    pub lane_rank: usize,
    /// The end of the section.
    pub end: Contact,
    /// The link.
    pub link: &'a super::LaneLinkFacts,
    /// What touches there.
    pub neighbor: Option<Neighbor<'a>>,
    network: &'a Network,
}

impl<'a> LaneJoint<'a> {
    /// The lane that is named. It is looked for: what needs no look at the lanes beyond is to be asked first.
    pub fn target(&self) -> Option<&'a LaneFacts> {
        self.network.lane(self.neighbor?.section, self.link.id)
    }
}

impl Contact {
    /// Both ends.
    pub const BOTH: [Self; 2] = [Self::Start, Self::End];

    /// Its word in messages and in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::End => "end",
        }
    }

    /// The other end.
    pub fn other(self) -> Self {
        match self {
            Self::Start => Self::End,
            Self::End => Self::Start,
        }
    }
}

/// An end of a road.
#[derive(Clone, Copy)]
pub struct RoadEnd<'a> {
    /// The road.
    pub road: &'a RoadFacts,
    /// Which of its ends.
    pub end: Contact,
}

impl<'a> RoadEnd<'a> {
    /// The end of a road, where both are known.
    pub fn of(road: Option<&'a RoadFacts>, end: Option<Contact>) -> Option<Self> {
        Some(Self { road: road?, end: end? })
    }
}

/// Foot of a point on a reference line.
#[derive(Clone, Copy, Debug)]
pub struct Foot {
    /// Along the line `[m]`.
    pub s: f64,
    /// Beside it `[m]`, positive to the left.
    pub t: f64,
    /// Of the point from the foot `[m]`.
    pub distance: f64,
}

impl Network {
    /// The cross-section at an end of a road.
    pub fn station_of(&self, road: &RoadFacts, end: Contact) -> Option<Station> {
        let stations = self.stations_of(road);
        match end {
            Contact::Start => stations.first(),
            Contact::End => stations.last(),
        }
    }

    /// The road that a road's end is linked to, and which end of that touches: the one that is written, else the nearer one.
    /// None for links to junctions and into the middle of roads.
    pub fn linked_road(&self, road: &RoadFacts, end: Contact) -> Option<RoadEnd<'_>> {
        let linked = self.linked.get(road.rank as usize)?[end as usize];
        let road = self.roads.get(linked as usize / 2)?;
        Some(RoadEnd { road, end: Contact::BOTH[linked as usize % 2] })
    }

    /// Finds what each road's ends are linked to.
    pub(super) fn link_roads(&mut self) {
        let find = |road: &RoadFacts| {
            Contact::BOTH.map(|end| match self.find_linked(road, end) {
                Some((rank, contact)) => rank.saturating_mul(2).saturating_add(contact as u32),
                None => NONE,
            })
        };
        self.linked = self.roads.iter().map(find).collect();
    }

    fn find_linked(&self, road: &RoadFacts, end: Contact) -> Option<(u32, Contact)> {
        let link = road.link(end)?;
        let LinkTarget::Road(id) = link.target else { return None };
        if link.s.is_some() {
            return None;
        }
        let target = self.road_named(id)?;
        let nearer = || {
            let own = self.station_of(road, end)?;
            let [start, last] = Contact::BOTH.map(|end| {
                self.station_of(target, end)
                    .map_or(f64::INFINITY, |s| mapd_geometry::hypot(s.x - own.x, s.y - own.y))
            });
            Some(if start <= last { Contact::Start } else { Contact::End })
        };
        Some((target.rank, link.contact.or_else(nearer)?))
    }

    /// What touches an end of a section, given by its rank in its road, on the side of a lane.
    pub fn neighbor<'a>(
        &'a self,
        road: &'a RoadFacts,
        rank: usize,
        end: Contact,
        lane: i32,
    ) -> Option<Neighbor<'a>> {
        let sections = self.sections_of(road);
        let next = sections.get(rank).and_then(|own| own.next(rank, end, lane));
        if let Some(section) = next.and_then(|next| sections.get(next)) {
            return Some(Neighbor { road, section, end: end.other() });
        }
        let RoadEnd { road: target, end: contact } = self.linked_road(road, end)?;
        let is_turned = end == contact;
        let section =
            self.section_at(target, contact, if is_turned { lane.saturating_neg() } else { lane })?;
        Some(Neighbor { road: target, section, end: contact })
    }

    /// Shows every link of every lane.
    pub fn each_lane_joint<'a>(&'a self, mut show: impl FnMut(&LaneJoint<'a>)) {
        for road in self.roads.iter().filter(|road| road.has_lane_links) {
            for (rank, section) in self.sections_of(road).iter().enumerate() {
                // Lanes stand by falling id: those to the left come first.
                let (mut side, mut neighbors) = (0, [None; 2]);
                for (lane_rank, lane) in section.lane_ranks().zip(self.lanes_of(section)) {
                    let own_side = if lane.id < 0 { -1 } else { 1 };
                    if side != own_side {
                        side = own_side;
                        neighbors = Contact::BOTH.map(|end| self.neighbor(road, rank, end, side));
                    }
                    for end in Contact::BOTH {
                        let neighbor = neighbors[end as usize];
                        for link in self.links_of(lane, end) {
                            let network = self;
                            show(&LaneJoint {
                                road,
                                section,
                                rank,
                                lane,
                                lane_rank,
                                end,
                                link,
                                neighbor,
                                network,
                            });
                        }
                    }
                }
            }
        }
    }

    /// Links of a lane at an end of its section.
    pub fn links_of(&self, lane: &LaneFacts, end: Contact) -> &[super::LaneLinkFacts] {
        let [first, after] = [lane.links[end as usize], lane.links[end as usize + 1]];
        super::rows(&self.lane_links, &(first..after))
    }

    /// The end of a road that touches a junction: the one whose link names it. Where both do, the one that the connecting
    /// road names.
    pub fn end_at_junction(
        &self,
        road: &RoadFacts,
        junction: Name,
        connecting: Option<RoadEnd<'_>>,
    ) -> Option<Contact> {
        let target = Some(LinkTarget::Junction(junction));
        match Contact::BOTH.map(|end| road.link(end).map(|link| link.target) == target) {
            [true, false] => Some(Contact::Start),
            [false, true] => Some(Contact::End),
            [false, false] => None,
            [true, true] => {
                let RoadEnd { road: connecting, end } = connecting?;
                let link = connecting.link(end)?;
                (link.target == LinkTarget::Road(road.id)).then_some(link.contact).flatten()
            }
        }
    }

    /// Whether a lane's traffic goes along s; none where it goes both ways.
    pub fn goes_along(road: &RoadFacts, lane: &LaneFacts) -> Option<bool> {
        use mapd_xodr::{LaneDirection, LaneType};
        let along = (lane.id < 0) != road.is_left_hand;
        match lane.direction {
            LaneDirection::Both => None,
            _ if lane.kind == LaneType::Bidirectional => None,
            LaneDirection::Reversed => Some(!along),
            _ => Some(along),
        }
    }

    /// Foot of a point on a road's reference line, straight between cross-sections; none where the road has none.
    pub fn project(&self, road: &RoadFacts, [x, y]: [f64; 2]) -> Option<Foot> {
        let stations = self.stations_of(road);
        let mut best: Option<Foot> = None;
        for [a, b] in stations.pairs() {
            let (dx, dy) = (b.x - a.x, b.y - a.y);
            let square = dx * dx + dy * dy;
            if square <= 0.0 {
                continue;
            }
            let part = ((x - a.x) * dx + (y - a.y) * dy) / square;
            let part = mapd_geometry::clamp(part, 0.0, 1.0);
            let (px, py) = (x - (a.x + part * dx), y - (a.y + part * dy));
            let distance = mapd_geometry::hypot(px, py);
            if best.is_none_or(|best| distance < best.distance) {
                let t = (dx * py - dy * px) / square.sqrt();
                best = Some(Foot { s: a.s + part * (b.s - a.s), t, distance });
            }
        }
        best
    }

    /// Inner and outer border of a lane at `s`, linear between the section's ends: t `[m]`.
    pub fn borders_over(section: &SectionFacts, lane: &LaneFacts, s: f64) -> [f64; 2] {
        let length = section.s_end(lane.id) - section.s;
        let part = if length > 0.0 {
            mapd_geometry::clamp((s - section.s) / length, 0.0, 1.0)
        } else {
            0.0
        };
        [lane.inner, lane.outer].map(|[start, end]| start + part * (end - start))
    }
}
