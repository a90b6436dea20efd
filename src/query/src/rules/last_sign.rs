//! The last sign about something before a place: what signs say holds from their place on.

use crate::lane::Lane;
use crate::signals::LaneSignal;

/// Lanes that are followed back at most to find a sign; a damaged archive might lead round in a circle.
const MOST_LANES: usize = 4096;

/// The sign that holds at s of those that begin something; none if the last one before s ends it.
///
/// A sign holds from its place on, in driving direction, until another one ends or replaces it, over lanes that lead on
/// alone, and not beyond a junction.
pub(super) fn sign_before<'a>(
    lane: &Lane<'a>,
    s: f64,
    begins: impl Fn(&LaneSignal<'_>) -> bool,
    ends: impl Fn(&LaneSignal<'_>) -> bool,
) -> Option<LaneSignal<'a>> {
    let (mut lane, mut until) = (*lane, Some(s));
    for _ in 0..MOST_LANES {
        let forward = lane.is_forward();
        let passed = |one: &LaneSignal<'a>| match until {
            None => true,
            Some(s) if forward => one.s_on(&lane) <= s,
            Some(s) => one.s_on(&lane) >= s,
        };
        let speaks = lane.signals().filter(|one| {
            let about = !one.signal().is_invalidated() && (begins(one) || ends(one));
            one.is_for(forward) && about && passed(one)
        });
        // In ascending s: the last one passed is the last or the first.
        let last = if forward { speaks.last() } else { first(speaks, &begins) };
        if let Some(last) = last {
            return Some(last).filter(&begins);
        }
        let map = lane.map;
        let mut before = lane.predecessors().filter_map(|id| Lane::new(map, id.row()));
        let next = before.next().filter(|_| before.next().is_none())?;
        // A lane of a junction leads on from many; a sign before it does not reach beyond it.
        let in_junction = |lane: &Lane<'a>| lane.road().junction_row().is_some();
        if in_junction(&next) || in_junction(&lane) {
            return None;
        }
        (lane, until) = (next, None);
    }
    None
}

/// Of signs at one place, the one that begins something.
fn first<'a>(
    mut signs: impl Iterator<Item = LaneSignal<'a>>,
    begins: impl Fn(&LaneSignal<'_>) -> bool,
) -> Option<LaneSignal<'a>> {
    let found = signs.next()?;
    let same = signs.take_while(|one| one.place().s() == found.place().s());
    Some(same.fold(found, |best, one| if begins(&best) { best } else { one }))
}
