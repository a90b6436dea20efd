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
