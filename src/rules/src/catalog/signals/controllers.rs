//! Controllers and stations.

use crate::example::Example::{Document, Header as In};
use crate::rule::Check::{Controller, Header};
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr as xodr;

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.signal.controller.valid_for_signals",
        "A controller controls at least one signal.",
        Controller(controls),
        [
            Document(r#"<road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><signals><signal id="1" s="5" t="-4" zOffset="2" dynamic="yes" orientation="+" country="OpenDRIVE" type="1000001" subtype="-1" hOffset="0" pitch="0" roll="0"/></signals></road><controller id="8"><control signalId="1"/></controller>"#),
            Document(r#"<road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road><controller id="8"/>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:defaultRegulations.only_speed_priority",
        "Default regulations are about speed and priority.",
        Header(regulations),
        [
            In(r#"<defaultRegulations><roadRegulations type="town"><semantics><speed type="maximum" value="50" unit="km/h"/></semantics></roadRegulations></defaultRegulations>"#),
            In(r#"<defaultRegulations><roadRegulations type="town"><semantics><warning/></semantics></roadRegulations></defaultRegulations>"#),
        ],
    )
    .since(8),
];

fn controls(controller: &xodr::Controller, sink: &mut Sink<'_>) {
    if controller.control.is_empty() {
        sink.add(controller.span, "at least one signal", "none");
    }
}

fn regulations(header: &xodr::Header, sink: &mut Sink<'_>) {
    let Some(all) = &header.default_regulations else { return };
    let of_roads = all.road_regulations.iter().filter_map(|r| r.semantics.as_deref());
    let of_signals = all.signal_regulations.iter().filter_map(|r| r.semantics.as_deref());
    for semantics in of_roads.chain(of_signals) {
        let has_other = !(semantics.lane.is_empty()
            && semantics.prohibited.is_empty()
            && semantics.warning.is_empty()
            && semantics.routing.is_empty()
            && semantics.streetname.is_empty()
            && semantics.parking.is_empty()
            && semantics.tourist.is_empty()
            && semantics.supplementary_time.is_empty()
            && semantics.supplementary_allows.is_empty()
            && semantics.supplementary_prohibits.is_empty()
            && semantics.supplementary_distance.is_empty()
            && semantics.supplementary_environment.is_empty()
            && semantics.supplementary_explanatory.is_empty());
        if has_other {
            let part = "defaultRegulations/semantics";
            sink.add_within(part, semantics.span, "speed and priority alone", "others");
        }
    }
}
