//! A road whose lanes have as many records as a map asks for.

use std::fmt::Write as _;

/// Length of a geometry `[m]`.
const STEP: f64 = 10.0;
/// Curvatures of a bend and of the way back `[1/m]`.
const BENDS: [f64; 4] = [0.01, -0.01, -0.01, 0.01];

/// A map of one road of so many arcs that wind along x, with a lane on either side; where `varied`, the right one has a width
/// record for each geometry, which begins elsewhere.
pub fn long_lane(geometries: usize, varied: bool) -> String {
    let length = STEP * geometries as f64;
    let (mut plan, mut x, mut y, mut hdg) = (String::new(), 0.0_f64, 0.0_f64, 0.0_f64);
    for i in 0..geometries {
        let k = BENDS[i % BENDS.len()];
        let s = STEP * i as f64;
        // Writing to a string cannot fail.
        let _ = writeln!(
            plan,
            r#"<geometry s="{s:?}" x="{x:?}" y="{y:?}" hdg="{hdg:?}" length="{STEP:?}"><arc curvature="{k:?}"/></geometry>"#
        );
        let end = hdg + k * STEP;
        x += (end.sin() - hdg.sin()) / k;
        y -= (end.cos() - hdg.cos()) / k;
        hdg = end;
    }
    let widths: String = (0..if varied { geometries } else { 1 })
        .map(|i| {
            let s = if i == 0 { 0.0 } else { STEP * (i as f64 + 0.25) };
            let b = if i % 2 == 0 { 0.02 } else { -0.02 };
            format!(r#"<width sOffset="{s:?}" a="{:?}" b="{b:?}" c="0" d="0"/>"#, 3.0 - b)
        })
        .collect();
    let lane = |id: i32, widths: &str| {
        format!(r#"<lane id="{id}" type="driving" level="false">{widths}</lane>"#)
    };
    let plain = r#"<width sOffset="0" a="3" b="0" c="0" d="0"/>"#;
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="{length:?}" junction="-1"><planView>{plan}</planView><lanes><laneSection s="0"><left>{}</left><center><lane id="0" type="none" level="false"/></center><right>{}</right></laneSection></lanes></road></OpenDRIVE>"#,
        lane(1, plain),
        lane(-1, &widths),
    )
}

/// A map of one straight road with so many lanes on either side, each of which has so many records that begin where none of
/// another does. Where `close`, widths close and open again between some of them, and a lane on the right has borders.
pub fn many_lanes(lanes: usize, records: usize, close: bool) -> String {
    let lane = |side: i32, number: usize| {
        let is_border = close && side < 0 && number == 2;
        let (name, own) = if is_border { ("border", -7.0) } else { ("width", 3.0) };
        let begin = |record: usize| match record {
            0 => 0.0,
            _ => STEP * (record as f64 + number as f64 / (lanes + 1) as f64),
        };
        let rows: String = (0..records)
            .map(|record| {
                let s = begin(record);
                // Falls from 0.4 m to below 0, and comes back from there in another record.
                let (a, b, c) = match (record + number) % 7 {
                    3 if close && !is_border => (0.4, -0.11, 0.004),
                    4 if close && !is_border => (-0.2, 0.1, 0.0),
                    _ => (own, 0.0001 * f64::from(side), 0.0),
                };
                format!(r#"<{name} sOffset="{s:?}" a="{a:?}" b="{b:?}" c="{c:?}" d="0"/>"#)
            })
            .collect();
        let id = side * number as i32;
        format!(r#"<lane id="{id}" type="driving" level="false">{rows}</lane>"#)
    };
    let left: String = (1..=lanes).rev().map(|number| lane(1, number)).collect();
    let right: String = (1..=lanes).map(|number| lane(-1, number)).collect();
    let length = STEP * (records + 1) as f64;
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="{length:?}" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="{length:?}"><line/></geometry></planView><lanes><laneOffset s="0" a="0.1" b="0" c="0.0001" d="-0.000001"/><laneSection s="0"><left>{left}</left><center><lane id="0" type="none" level="false"/></center><right>{right}</right></laneSection></lanes></road></OpenDRIVE>"#
    )
}
