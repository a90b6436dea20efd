//! Writes a generated map to stdout: the town or the quarter that the project carries, or straight roads beside each other, to see how costs grow.
//!
//! ```text
//! make_map town > examples/maps/town.xodr
//! make_map quarter > examples/maps/quarter.xodr
//! make_map straight 200000 5 > large.xodr      roads, and lanes of each
//! ```

use std::io::{BufWriter, Result, Write, stdout};

/// Length of a straight road `[m]`, and the distance between two `[m]` beside the widths of their lanes.
const LENGTH: usize = 100;
const GAP: usize = 5;
/// Width of its lanes `[m]`.
const WIDTH: usize = 3;

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let out = &mut BufWriter::new(stdout().lock());
    match args.as_slice() {
        ["town"] => out.write_all(mapd_tests::town::town(3, 3).as_bytes())?,
        ["quarter"] => out.write_all(mapd_tests::quarter::quarter().as_bytes())?,
        ["straight", roads, lanes] => match (roads.parse(), lanes.parse()) {
            (Ok(roads), Ok(lanes)) => straight(out, roads, lanes)?,
            _ => usage(),
        },
        _ => usage(),
    }
    out.flush()
}

fn usage() -> ! {
    let _ = writeln!(
        std::io::stderr(),
        "usage: make_map town | make_map quarter | make_map straight ROADS LANES"
    );
    std::process::exit(2)
}

/// Roads with driving lanes to their right.
fn straight(out: &mut impl Write, roads: usize, lanes: usize) -> Result<()> {
    writeln!(out, r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>"#)?;
    for road in 0..roads {
        let y = road * (lanes * WIDTH + GAP);
        writeln!(out, r#"<road id="{road}" length="{LENGTH}" junction="-1"><planView>"#)?;
        writeln!(out, r#"<geometry s="0" x="0" y="{y}" hdg="0" length="{LENGTH}"><line/>"#)?;
        write!(out, r#"</geometry></planView><lanes><laneSection s="0"><center>"#)?;
        writeln!(out, r#"<lane id="0" type="none"/></center><right>"#)?;
        for lane in 1..=lanes {
            write!(out, r#"<lane id="-{lane}" type="driving">"#)?;
            writeln!(out, r#"<width sOffset="0" a="{WIDTH}" b="0" c="0" d="0"/></lane>"#)?;
        }
        writeln!(out, "</right></laneSection></lanes></road>")?;
    }
    writeln!(out, "</OpenDRIVE>")
}
