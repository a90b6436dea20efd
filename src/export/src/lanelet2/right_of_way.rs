//! Who gives way to whom in junctions, as far as the file says so.

use super::model::{Member, Model, Rule};
use mapd_client::rules::YieldsTo;
use mapd_client::vocabulary::{Class, LaneType};

/// Adds a rule for each lane of a junction that gives way to others. What only a rule of the road would say is not written: Lanelet2 has
/// rules of the road of its own.
pub(super) fn add(model: &mut Model<'_>) {
    let all = (0..).zip(&model.network.lanelets);
    // A lane's first lanelet stands for all of it.
    let lanes: Vec<_> = all
        .filter(|(number, one)| model.network.lanelets_of(&one.lane).first() == Some(number))
        .map(|(number, one)| (number, one.lane))
        .filter(|(_, lane)| lane.road().junction().is_some() && lane.kind() != LaneType::Sidewalk)
        .collect();
    for (lanelet, lane) in lanes {
        let mut members = vec![("yield", Member::Lanelet(lanelet))];
        for YieldsTo { lane: other, .. } in lane.yields_to() {
            let first = model.network.lanelets_of(&other).first().copied();
            let member = first.map(|first| ("right_of_way", Member::Lanelet(first)));
            members.extend(member.filter(|member| !members.contains(member)));
        }
        if members.len() == 1 {
            continue;
        }
        let is_marked = |class| matches!(class, Class::StopLine | Class::WaitingLine);
        if let Some(stop) = lane.movement_stop().filter(|stop| is_marked(stop.class)) {
            let line = model.stop_line(&stop);
            members.extend(line.map(|line| ("ref_line", Member::Line(line))));
        }
        let lanelets = members.iter().filter_map(|(_, member)| match member {
            Member::Lanelet(lanelet) => Some(*lanelet),
            _ => None,
        });
        let lanelets = lanelets.collect();
        let tags = vec![("type", "regulatory_element".into()), ("subtype", "right_of_way".into())];
        model.rules.push(Rule { tags, members, lanelets });
    }
}
