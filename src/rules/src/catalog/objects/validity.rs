//! Lanes for which something holds.

use crate::example::Example::{Objects as In, Road as InRoad, Signals};
use crate::place::{ObjectIn, RoadIn, SignalIn, is_left_hand, value};
use crate::rule::Check::{Object, Road, Signal};
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{Attribute, LaneValidity, Orientation, Road as OfRoad};

/// An object with a validity; the examples differ in its lanes.
macro_rules! object {
    ($orientation:literal, $from:literal, $to:literal) => {
        In(concat!(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation=""#,
            $orientation,
            r#""><validity fromLane=""#,
            $from,
            r#"" toLane=""#,
            $to,
            r#""/></object>"#
        ))
    };
}

/// The same in a road with traffic on the left: links stand before, so does the document's rule.
macro_rules! left_hand {
    ($element:literal) => {
        crate::example::Example::Document(concat!(
            r#"<road id="1" length="100" junction="-1" rule="LHT"><planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView>
<lanes><laneSection s="0"><left><lane id="1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#,
            $element,
            "</road>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.validty.from_lower_equal_to",
        "An object's validity goes from the lower lane to the higher one.",
        Object(object_order),
        [object!("none", "-2", "-1"), object!("none", "-1", "-2")],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.reference.from_lower_equal_to",
        "The validity of a reference to an object goes from the lower lane to the higher one.",
        Road(reference_order),
        [
            In(r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"/><objectReference id="1" s="10" t="0" orientation="none"><validity fromLane="-2" toLane="-1"/></objectReference>"#),
            In(r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"/><objectReference id="1" s="10" t="0" orientation="none"><validity fromLane="-1" toLane="-2"/></objectReference>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.tunnels.from_lower_equal_to",
        "A tunnel's validity goes from the lower lane to the higher one.",
        Road(tunnel_order),
        [
            In(r#"<tunnel id="1" s="10" length="5" type="standard"><validity fromLane="-2" toLane="-1"/></tunnel>"#),
            In(r#"<tunnel id="1" s="10" length="5" type="standard"><validity fromLane="-1" toLane="-2"/></tunnel>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.bridges.from_lower_equal_to",
        "A bridge's validity goes from the lower lane to the higher one.",
        Road(bridge_order),
        [
            In(r#"<bridge id="1" s="10" length="5" type="concrete"><validity fromLane="-2" toLane="-1"/></bridge>"#),
            In(r#"<bridge id="1" s="10" length="5" type="concrete"><validity fromLane="-1" toLane="-2"/></bridge>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.signal.reference.from_lower_equal_to",
        "The validity of a signal or of a reference to one goes from the lower lane to the higher one.",
        Road(signal_order),
        [
            Signals(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><validity fromLane="-2" toLane="-1"/></signal>"#),
            Signals(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><validity fromLane="-1" toLane="-2"/></signal>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:ref.validity_lanes",
        "A validity names lanes that the road has.",
        Road(known_lanes),
        [object!("none", "-2", "-1"), object!("none", "-9", "-7")],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.validty.right_hand_traffic_lane_ids",
        "With traffic on the right, an object for the direction + holds for lanes below 0, one for - above 0.",
        Object(object_right),
        [object!("+", "-2", "-1"), object!("+", "1", "2")],
    )
    .also(&["asam.net:xodr:1.7.0:road.object.validty.check_parent_orientation"]),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.validty.left_hand_traffic_lane_ids",
        "With traffic on the left, an object for the direction + holds for lanes above 0, one for - below 0.",
        Object(object_left),
        [
            left_hand!(r#"<objects><object id="1" type="pole" s="10" t="4" zOffset="0" orientation="+"><validity fromLane="1" toLane="1"/></object></objects>"#),
            left_hand!(r#"<objects><object id="1" type="pole" s="10" t="4" zOffset="0" orientation="+"><validity fromLane="-1" toLane="-1"/></object></objects>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.signal.validity.right_hand_traffic_lane_ids",
        "With traffic on the right, a signal for the direction + holds for lanes below 0, one for - above 0.",
        Signal(signal_right),
        [
            Signals(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><validity fromLane="-2" toLane="-1"/></signal>"#),
            Signals(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><validity fromLane="1" toLane="2"/></signal>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.signal.validity.left_hand_traffic_lane_ids",
        "With traffic on the left, a signal for the direction + holds for lanes above 0, one for - below 0.",
        Signal(signal_left),
        [
            left_hand!(r#"<signals><signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><validity fromLane="1" toLane="1"/></signal></signals>"#),
            left_hand!(r#"<signals><signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><validity fromLane="-1" toLane="-1"/></signal></signals>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.signal.reference.right_hand_traffic_lane_ids",
        "With traffic on the right, a reference to a signal for the direction + holds for lanes below 0, one for - above 0.",
        Road(reference_right),
        [
            InRoad(r#"<signals><signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/><signalReference id="1" s="20" t="0" orientation="+"><validity fromLane="-2" toLane="-1"/></signalReference></signals>"#),
            InRoad(r#"<signals><signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/><signalReference id="1" s="20" t="0" orientation="+"><validity fromLane="1" toLane="2"/></signalReference></signals>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.signal.reference.left_hand_traffic_lane_ids",
        "With traffic on the left, a reference to a signal for the direction + holds for lanes above 0, one for - below 0.",
        Road(reference_left),
        [
            left_hand!(r#"<signals><signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/><signalReference id="1" s="20" t="0" orientation="+"><validity fromLane="1" toLane="1"/></signalReference></signals>"#),
            left_hand!(r#"<signals><signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/><signalReference id="1" s="20" t="0" orientation="+"><validity fromLane="-1" toLane="-1"/></signalReference></signals>"#),
        ],
    ),
];

fn order(part: &str, list: &[LaneValidity], sink: &mut Sink<'_>) {
    for validity in list {
        if let (Some(from), Some(to)) = (value(&validity.from_lane), value(&validity.to_lane))
            && from > to
        {
            let found = format_args!("{from}; the two are swapped");
            sink.add_within(part, validity.span, format_args!("fromLane of at most {to}"), found);
        }
    }
}

fn object_order(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    order("validity", &of.object.validity, sink);
}

fn reference_order(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for reference in of.road.objects.iter().flat_map(|objects| &objects.object_reference) {
        order("objects/objectReference/validity", &reference.validity, sink);
    }
}

fn tunnel_order(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for tunnel in of.road.objects.iter().flat_map(|objects| &objects.tunnel) {
        order("objects/tunnel/validity", &tunnel.validity, sink);
    }
}

fn bridge_order(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for bridge in of.road.objects.iter().flat_map(|objects| &objects.bridge) {
        order("objects/bridge/validity", &bridge.validity, sink);
    }
}

fn signal_order(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let Some(signals) = &of.road.signals else { return };
    for signal in &signals.signal {
        order("signals/signal/validity", &signal.validity, sink);
    }
    for reference in &signals.signal_reference {
        order("signals/signalReference/validity", &reference.validity, sink);
    }
}

fn known_lanes(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let ids = of.sections().flat_map(|section| section.lanes()).filter_map(|lane| value(&lane.id));
    let (low, high) = ids.fold((0, 0), |(low, high), id| (id.min(low), id.max(high)));
    let mut look = |part: &str, list: &[LaneValidity]| {
        for validity in list {
            if let (Some(from), Some(to)) = (value(&validity.from_lane), value(&validity.to_lane))
                && (from.max(to) < low || from.min(to) > high)
            {
                let expected = format_args!("lanes from {low} to {high}, which the road has");
                sink.add_within(part, validity.span, expected, format_args!("{from} to {to}"));
            }
        }
    };
    if let Some(objects) = &of.road.objects {
        objects.object.iter().for_each(|o| look("objects/object/validity", &o.validity));
        objects
            .object_reference
            .iter()
            .for_each(|o| look("objects/objectReference/validity", &o.validity));
        objects.tunnel.iter().for_each(|o| look("objects/tunnel/validity", &o.validity));
        objects.bridge.iter().for_each(|o| look("objects/bridge/validity", &o.validity));
    }
    if let Some(signals) = &of.road.signals {
        signals.signal.iter().for_each(|s| look("signals/signal/validity", &s.validity));
        signals
            .signal_reference
            .iter()
            .for_each(|s| look("signals/signalReference/validity", &s.validity));
    }
}

/// Lanes for which something holds have the sign of its direction of travel, on roads with traffic on that hand.
fn direction(
    part: &str,
    road: &OfRoad,
    is_left: bool,
    orientation: &Option<Attribute<Orientation>>,
    list: &[LaneValidity],
    sink: &mut Sink<'_>,
) {
    if is_left_hand(road) != is_left {
        return;
    }
    let is_along = match value(orientation) {
        Some(Orientation::Plus) => true,
        Some(Orientation::Minus) => false,
        _ => return,
    };
    let (sign, side) = if is_along == is_left { (1, "above 0") } else { (-1, "below 0") };
    for validity in list {
        if let (Some(from), Some(to)) = (value(&validity.from_lane), value(&validity.to_lane))
            && (from.signum() == -sign || to.signum() == -sign)
        {
            let word = if is_along { '+' } else { '-' };
            let expected = format_args!("lanes {side} for the direction {word}");
            sink.add_within(part, validity.span, expected, format_args!("{from} to {to}"));
        }
    }
}

fn object_right(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if let Some(road) = of.road {
        direction("validity", road, false, &of.object.orientation, &of.object.validity, sink);
    }
}

fn object_left(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if let Some(road) = of.road {
        direction("validity", road, true, &of.object.orientation, &of.object.validity, sink);
    }
}

fn signal_right(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    direction("validity", of.road, false, &of.signal.orientation, &of.signal.validity, sink);
}

fn signal_left(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    direction("validity", of.road, true, &of.signal.orientation, &of.signal.validity, sink);
}

fn references(of: &RoadIn<'_>, is_left: bool, sink: &mut Sink<'_>) {
    for reference in of.road.signals.iter().flat_map(|signals| &signals.signal_reference) {
        let part = "signals/signalReference/validity";
        direction(part, of.road, is_left, &reference.orientation, &reference.validity, sink);
    }
}

fn reference_right(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    references(of, false, sink);
}

fn reference_left(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    references(of, true, sink);
}
