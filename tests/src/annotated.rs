//! Maps that say more of their parts than anything is built from.

use std::fmt::Write as _;

/// User data with something inside.
pub const NESTED: &str = r#"<userData code="vendor" value="v"><a b="1"><c/></a></userData>"#;

/// A road of 10 m along x, so many metres up, with lane −1; more in its start tag, in the road and in the lane.
pub fn road(id: &str, y: f64, more: &str, inside: &str, lane: &str) -> String {
    format!(
        r#"<road id="{id}" length="10" {more}><planView><geometry s="0" x="0" y="{y:?}" hdg="0" length="10"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false"><width sOffset="0" a="3" b="0" c="0" d="0"/>{lane}</lane></right></laneSection></lanes>{inside}</road>
"#
    )
}

/// A document of version 1.`minor` with more in its header and behind it.
pub fn document(minor: u8, header: &str, inside: &str) -> String {
    format!(
        "<OpenDRIVE><header revMajor=\"1\" revMinor=\"{minor}\">{header}</header>\n{inside}</OpenDRIVE>"
    )
}

/// A roundabout of two junctions, 10 m in radius, of which road 5 is an exit: roads 1 and 2 lead from one junction to the other,
/// 3, 4 and 6 lie within.
pub fn roundabout(group: &str) -> String {
    const RADIUS: f64 = 10.0;
    let arc = |id: &str, junction: &str, from: f64, to: f64, link: &str| {
        let (from, to) = (from.to_radians(), to.to_radians());
        let (x, y, heading) = (RADIUS * from.cos(), RADIUS * from.sin(), from + 90f64.to_radians());
        let length = RADIUS * (to - from);
        let lane = match junction {
            "-1" => "",
            _ => r#"<link><predecessor id="-1"/><successor id="-1"/></link>"#,
        };
        format!(
            r#"<road id="{id}" length="{length:?}" junction="{junction}"><link>{link}</link><planView><geometry s="0" x="{x:?}" y="{y:?}" hdg="{heading:?}" length="{length:?}"><arc curvature="0.1"/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false">{lane}<width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
"#
        )
    };
    let to_road = |side: &str, id: &str, contact: &str| {
        format!(r#"<{side} elementType="road" elementId="{id}" contactPoint="{contact}"/>"#)
    };
    let to_junction =
        |side: &str, id: &str| format!(r#"<{side} elementType="junction" elementId="{id}"/>"#);
    let between = |before: &str, behind: &str| {
        to_junction("predecessor", before) + &to_junction("successor", behind)
    };
    let within = |before: &str, behind: &str| {
        to_road("predecessor", before, "end") + &to_road("successor", behind, "start")
    };
    let mut out = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/>\n".to_owned();
    out += &arc("1", "-1", 20.0, 160.0, &between("A", "B"));
    out += &arc("2", "-1", 200.0, 340.0, &between("B", "A"));
    out += &arc("3", "B", 160.0, 200.0, &within("1", "2"));
    out += &arc("4", "A", 340.0, 380.0, &within("2", "1"));
    // The exit leaves the ring where road 3 does.
    let at = 160f64.to_radians();
    let (x, y, heading) = (RADIUS * at.cos(), RADIUS * at.sin(), at + 90f64.to_radians());
    let exit = |id: &str, junction: &str, from: f64, link: &str, lane: &str| {
        let (x, y) = (x + from * heading.cos(), y + from * heading.sin());
        format!(
            r#"<road id="{id}" length="5" junction="{junction}"><link>{link}</link><planView><geometry s="0" x="{x:?}" y="{y:?}" hdg="{heading:?}" length="5"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false">{lane}<width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
"#
        )
    };
    let lane = r#"<link><predecessor id="-1"/><successor id="-1"/></link>"#;
    out += &exit("6", "B", 0.0, &within("1", "5"), lane);
    out += &exit("5", "-1", 5.0, &to_junction("predecessor", "B"), "");
    let connection = |id: &str, from: &str, over: &str| {
        format!(
            r#"<connection id="{id}" incomingRoad="{from}" connectingRoad="{over}" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#
        )
    };
    let _ = write!(
        out,
        "<junction id=\"A\" name=\"\">{}</junction>\n<junction id=\"B\" name=\"\">{}{}</junction>\n",
        connection("0", "2", "4"),
        connection("0", "1", "3"),
        connection("1", "1", "6")
    );
    out + group + "</OpenDRIVE>"
}
