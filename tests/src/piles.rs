//! Piles: kinds of file that may be made large of one thing, or of two things that meet each other, and as small as anybody likes. What compiling them costs
//! must grow with their bytes and those of the archive (`benches/gates/piles.rs`).

use std::f64::consts::PI;
use std::fmt::{Display, Write as _};

/// A kind of file.
pub struct Pile {
    /// What there is much of.
    pub name: &'static str,
    /// How much of it shows in a moment how its costs grow.
    pub small: usize,
    /// A map of so much of it.
    pub text: fn(usize) -> String,
}

/// All kinds.
pub const PILES: &[Pile] = &[
    // Lines of roads and lanes.
    pile("geometries", 400, |n| {
        let plan = each(n, |i| {
            format!(r#"<geometry s="{i}" x="{i}" y="0" hdg="0" length="1"><line/></geometry>"#)
        });
        map(&Road { length: n as f64, plan: &plan, ..ROAD }.text(1))
    }),
    pile("geometries, lanes", 40, |n| {
        let plan = each(n, |i| {
            format!(r#"<geometry s="{i}" x="{i}" y="0" hdg="0" length="1"><line/></geometry>"#)
        });
        map(&Road { length: n as f64, plan: &plan, lanes: &right(n), ..ROAD }.text(1))
    }),
    pile("spirals on one another", 50, |n| {
        let plan = r#"<geometry s="0" x="0" y="0" hdg="0" length="50"><spiral curvStart="-0.5" curvEnd="0.5"/></geometry>"#;
        map(&each(n, |i| Road { length: 50.0, plan, ..ROAD }.text(i)))
    }),
    pile("elevations", 400, |n| {
        let profiles = elevations(n, |i| i);
        map(&Road { length: n as f64, profiles: &profiles, ..ROAD }.text(1))
    }),
    pile("elevations at one place", 400, |n| {
        map(&Road { profiles: &elevations(n, |_| 5), ..ROAD }.text(1))
    }),
    pile("elevations, lanes", 40, |n| {
        let profiles = elevations(n, |i| i);
        map(&Road { length: n as f64, profiles: &profiles, lanes: &right(n), ..ROAD }.text(1))
    }),
    pile("superelevations", 400, |n| {
        map(&Road { length: n as f64, profiles: &superelevations(n), ..ROAD }.text(1))
    }),
    pile("superelevations, lanes", 40, |n| {
        let (profiles, lanes) = (superelevations(n), right(n));
        map(&Road { length: n as f64, profiles: &profiles, lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("shapes across", 400, |n| {
        let shapes = each(n, |i| cubic("shape", &format!(r#"s="0" t="{i}""#), 0.0));
        let profiles = format!("<lateralProfile>{shapes}</lateralProfile>");
        map(&Road { profiles: &profiles, ..ROAD }.text(1))
    }),
    pile("shapes along", 400, |n| {
        map(&Road { length: n as f64, profiles: &shapes(n), ..ROAD }.text(1))
    }),
    pile("shapes along, lanes", 60, |n| {
        let (profiles, lanes) = (shapes(n), right(n));
        map(&Road { length: n as f64, profiles: &profiles, lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("lane offsets", 400, |n| {
        let lanes = format!("{}{}", offsets(n), right(1));
        map(&Road { length: n as f64, lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("lane offsets, lanes", 40, |n| {
        let lanes = format!("{}{}", offsets(n), right(n));
        map(&Road { length: n as f64, lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("widths", 400, |n| {
        let widths = each(n, |i| cubic("width", &format!(r#"sOffset="{i}""#), 3.5));
        let lane = format!(r#"<lane id="-1" type="driving">{widths}</lane>"#);
        map(&Road { length: n as f64, lanes: &section(0.0, &lane), ..ROAD }.text(1))
    }),
    pile("lanes with as many widths", 12, |n| {
        let widths = each(n, |i| cubic("width", &format!(r#"sOffset="{i}""#), 3.5));
        let lanes = each(n, |i| format!(r#"<lane id="-{}" type="driving">{widths}</lane>"#, i + 1));
        map(&Road { length: n as f64, lanes: &section(0.0, &lanes), ..ROAD }.text(1))
    }),
    pile("lanes of no width", 200, |n| {
        let lanes = each(n, |i| {
            let width = cubic("width", r#"sOffset="0""#, 0.0);
            format!(r#"<lane id="-{}" type="driving">{width}</lane>"#, i + 1)
        });
        map(&Road { lanes: &section(0.0, &lanes), ..ROAD }.text(1))
    }),
    pile("lanes", 200, |n| map(&Road { lanes: &right(n), ..ROAD }.text(1))),
    pile("sections", 400, |n| {
        let lanes = each(n, |i| section(i as f64, &lane(1, "")));
        map(&Road { length: n as f64, lanes: &lanes, ..ROAD }.text(1))
    }),
    // What is said of lanes.
    pile("speeds of road types", 400, |n| {
        map(&Road { length: n as f64, types: &types(n), ..ROAD }.text(1))
    }),
    pile("speeds of road types, lanes", 20, |n| {
        let (types, lanes) = (types(n), right(n));
        map(&Road { length: n as f64, types: &types, lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("speeds of a lane", 1000, |n| {
        let speeds = each(n, |i| format!(r#"<speed sOffset="{i}" max="{}"/>"#, 10 + i % 2));
        map(&Road { length: n as f64, lanes: &section(0.0, &lane(1, &speeds)), ..ROAD }.text(1))
    }),
    pile("default speeds", 400, |n| {
        let rule = r#"<roadRegulation type="town"><semantics><speed type="maximum" value="50" unit="km/h"/></semantics></roadRegulation>"#;
        let regulations = format!("<defaultRegulations>{}</defaultRegulations>", rule.repeat(n));
        map(&Road { types: &types(n), length: n as f64, ..ROAD }.text(1))
            .replace("</header>", &format!("{regulations}</header>"))
    }),
    pile("access records", 200, |n| {
        let lanes = section(0.0, &lane(1, &accesses(n, 1.0)));
        map(&Road { length: n as f64, lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("access records at one place", 400, |n| {
        map(&Road { lanes: &section(0.0, &lane(1, &accesses(n, 0.0))), ..ROAD }.text(1))
    }),
    pile("access records, lanes", 25, |n| {
        let lanes = each(n, |i| {
            lane(i + 1, if i == 0 { accesses(n, 1.0) } else { String::new() }.as_str())
        });
        map(&Road { length: n as f64, lanes: &section(0.0, &lanes), ..ROAD }.text(1))
    }),
    pile("road marks", 400, |n| {
        let lanes = section(0.0, &lane(1, &marks(n)));
        map(&Road { length: n as f64, lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("road marks on the centre, lanes", 60, |n| {
        let center = format!(r#"<center><lane id="0" type="none">{}</lane></center>"#, marks(n));
        let lanes = right(n).replace(CENTER, &center);
        map(&Road { length: n as f64, lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("lines of a road mark", 400, |n| {
        let lines = each(n, |i| {
            let t = i as f64 / 1000.0;
            format!(
                r#"<line length="0.5" space="0.5" tOffset="{t}" sOffset="0" rule="none" width="0.1"/>"#
            )
        });
        let mark = format!(
            r#"<roadMark sOffset="0" type="broken" weight="standard" color="standard" width="0.1"><type name="many" width="0.1">{lines}</type></roadMark>"#
        );
        map(&Road { lanes: &section(0.0, &lane(1, &mark)), ..ROAD }.text(1))
    }),
    pile("materials and heights of a lane", 200, |n| {
        let rows = each(n, |i| {
            format!(
                r#"<material sOffset="{i}" friction="0.8"/><height sOffset="{i}" inner="0" outer="0"/>"#
            )
        });
        map(&Road { length: n as f64, lanes: &section(0.0, &lane(1, &rows)), ..ROAD }.text(1))
    }),
    // Links.
    pile("roads in a chain", 200, |n| {
        let lane = lane(1, r#"<link><predecessor id="-1"/><successor id="-1"/></link>"#);
        map(&each(n, |i| {
            let before = i.checked_sub(1).map(|before| road_link("predecessor", before, "end"));
            let next = (i + 1 < n).then(|| road_link("successor", i + 1, "start"));
            let link = before.unwrap_or_default() + &next.unwrap_or_default();
            let lanes = section(0.0, &lane);
            Road {
                at: [10.0 * i as f64, 0.0, 0.0],
                length: 10.0,
                link: &link,
                lanes: &lanes,
                ..ROAD
            }
            .text(i)
        }))
    }),
    pile("lanes that lead to each of the next section", 10, |n| {
        let next = each(n, |i| format!(r#"<successor id="-{}"/>"#, i + 1));
        let lanes = each(n, |i| lane(i + 1, &format!("<link>{next}</link>")));
        let lanes = section(0.0, &lanes) + &right(n).replace(r#"s="0""#, r#"s="50""#);
        map(&Road { lanes: &lanes, ..ROAD }.text(1))
    }),
    pile("sections of one side", 60, |n| {
        let left = format!("<left>{}</left>", lane(-1, "").replace("--", ""));
        let others = each(n.min(MOST_SECTIONS), |i| {
            let s = 1.0 + i as f64;
            format!(r#"<laneSection s="{s}" singleSide="true">{left}{CENTER}</laneSection>"#)
        });
        let lanes = right(20) + &others;
        map(&Road { length: n as f64 + 2.0, lanes: &lanes, ..ROAD }.text(1))
    }),
    // Junctions.
    pile("connections", 100, |n| {
        let roads = each(n, |i| connecting(format!("c{i}")));
        map(&(incoming(1) + &roads + &junction(&each(n, |i| connection(i, format!("c{i}"))))))
    }),
    pile("connections of one road", 200, |n| {
        map(&(incoming(1) + &connecting("c") + &junction(&each(n, |i| connection(i, "c")))))
    }),
    pile("connections without links, lanes", 20, |n| {
        let bare = |i| {
            format!(
                r#"<connection id="{i}" incomingRoad="in" connectingRoad="c" contactPoint="start"/>"#
            )
        };
        let roads = incoming(n) + &connecting("c").replace(&right(1), &right(n));
        map(&(roads + &junction(&each(n, bare))))
    }),
    pile("lane links alike", 400, |n| {
        let link = r#"<laneLink from="-1" to="-1"/>"#;
        let links = connection(0, "c").replace(link, &link.repeat(n));
        map(&(incoming(1) + &connecting("c") + &junction(&links)))
    }),
    pile("lane links of each lane to each", 10, |n| {
        let links =
            each(n, |i| each(n, |k| format!(r#"<laneLink from="-{}" to="-{}"/>"#, i + 1, k + 1)));
        let links = connection(0, "c").replace(r#"<laneLink from="-1" to="-1"/>"#, &links);
        let roads = incoming(n) + &connecting("c").replace(&right(1), &right(n));
        map(&(roads + &junction(&links)))
    }),
    pile("roads of a junction that lead to each other", 8, |n| {
        let roads = each(n, |i| {
            let link = road_link("predecessor", format!("c{}", (i + n - 1) % n), "end")
                + &road_link("successor", format!("c{}", (i + 1) % n), "start");
            Road { length: 10.0, junction: "J", link: &link, ..ROAD }.text(format!("c{i}"))
        });
        let connections = each(n, |i| {
            each(n, |k| {
                connection(i * n + k, format!("c{k}"))
                    .replace(r#"incomingRoad="in""#, &format!(r#"incomingRoad="c{i}""#))
            })
        });
        map(&(roads + &junction(&connections)))
    }),
    pile("connecting roads that cross each other", 40, |n| map(&crossing(n, ""))),
    pile("priorities between crossing roads", 200, |n| {
        map(&crossing(
            20,
            &each(n, |i| priority(format!("c{}", i % 20), format!("c{}", (7 * i + 1) % 20))),
        ))
    }),
    pile("priorities in a chain", 200, |n| {
        map(&(metre() + &junction(&each(n, |i| priority(i, i + 1)))))
    }),
    pile("priorities in a chain, the last above the first", 200, |n| {
        map(&(metre() + &junction(&each(n, |i| priority(i, (i + 1) % n)))))
    }),
    pile("priorities in a chain over roads", 20, |n| {
        map(&crossing(n, &each(n, |i| priority(format!("c{i}"), format!("c{}", i + 1)))))
    }),
    pile("priorities over all roads", 200, |n| {
        map(&(metre() + &junction(&each(n, |i| priority("high", i) + &priority(i, "low")))))
    }),
    pile("junctions of one id", 400, |n| {
        map(&(metre() + &r#"<junction id="J" name=""/>"#.repeat(n)))
    }),
    pile("junction groups", 400, |n| {
        let group = |i| {
            format!(
                r#"<junctionGroup id="{i}" name="" type="roundabout"><junctionReference junction="J"/></junctionGroup>"#
            )
        };
        map(&(metre() + r#"<junction id="J" name=""/>"# + &each(n, group)))
    }),
    pile("paths across", 100, |n| {
        let paths = each(n, |i| {
            format!(
                r#"<crossPath id="{i}" crossingRoad="1" roadAtStart="1" roadAtEnd="2"><startLaneLink s="5" from="-1" to="-1"/><endLaneLink s="5" from="-1" to="-1"/></crossPath>"#
            )
        });
        let roads = Road { lanes: &right(2), ..ROAD }.text(1)
            + &Road { at: [0.0, 30.0, 0.0], ..ROAD }.text(2);
        map(&(roads + &format!(r#"<junction id="J" name="" type="crossing">{paths}</junction>"#)))
    }),
    pile("connections of a virtual junction, lanes", 25, |n| {
        let roads = each(n, |i| {
            let s = 1.0 + i as f64;
            let link = format!(
                r#"<predecessor elementType="road" elementId="main" elementS="{s}" elementDir="+"/>"#
            );
            Road { at: [s, 0.0, 0.0], length: 5.0, junction: "V", link: &link, ..ROAD }
                .text(format!("v{i}"))
        });
        let main = Road { length: n as f64 + 2.0, lanes: &right(n), ..ROAD }.text("main");
        let connections = each(n, |i| {
            connection(i, format!("v{i}")).replace(r#"incomingRoad="in""#, r#"incomingRoad="main""#)
        });
        let end = n + 2;
        map(&format!(
            r#"{main}{roads}<junction id="V" name="" type="virtual" mainRoad="main" sStart="0" sEnd="{end}" orientation="+">{connections}</junction>"#
        ))
    }),
    // Roads over one another.
    pile("roads that cross in a grid", 10, |n| {
        let length = 5.0 * n as f64;
        map(&each(n, |i| {
            let apart = 5.0 * i as f64;
            Road { at: [0.0, apart, 0.0], length, ..ROAD }.text(format!("h{i}"))
                + &Road { at: [apart, 0.0, PI / 2.0], length, ..ROAD }.text(format!("v{i}"))
        }))
    }),
    pile("roads at one place", 100, |n| map(&each(n, |i| ROAD.text(i)))),
    pile("roads of one id", 200, |n| {
        map(&each(n, |i| Road { at: [200.0 * i as f64, 0.0, 0.0], ..ROAD }.text(1)))
    }),
    // Objects.
    pile("objects at one place", 200, |n| objects(1, &each(n, |i| pole(i, "")))),
    pile("objects of one id", 200, |n| objects(1, &each(n, |_| pole("o", "")))),
    pile("corners", 400, |n| {
        objects(1, &object("building", &outline(n, |i| [i * 7919 % 1000, i * 104_729 % 1000])))
    }),
    pile("corners and markings", 100, |n| {
        let markings = each(n, |i| {
            let last = n - 1 - i;
            format!(
                r#"<marking side="front" weight="standard" width="0.1" color="white" zOffset="0" spaceLength="0.1" lineLength="0.2" startOffset="0" stopOffset="0"><cornerReference id="{i}"/><cornerReference id="{last}"/></marking>"#
            )
        });
        let inside = format!("{}<markings>{markings}</markings>", outline(n, |i| [i % 7, i % 5]));
        objects(1, &object("crosswalk", &inside))
    }),
    pile("corners of a border, borders", 60, |n| {
        let border = |i| {
            let corners = each(n, |k| format!(r#"<cornerReference id="{k}"/>"#));
            let corners = if i == 0 { corners } else { String::new() };
            format!(
                r#"<border type="curb" width="0.1" outlineId="0" useCompleteOutline="{}">{corners}</border>"#,
                i != 0
            )
        };
        let borders = format!("<borders>{}</borders>", each(n, border));
        objects(1, &object("trafficIsland", &(outline(n, |i| [i % 7, i % 5]) + &borders)))
    }),
    pile("outlines with borders", 60, |n| {
        let outlines = each(n, |i| {
            format!(
                r#"<outline id="{i}" closed="true"><cornerLocal u="0" v="0" z="0" height="1"/><cornerLocal u="1" v="0" z="0" height="1"/><cornerLocal u="1" v="1" z="0" height="1"/></outline>"#
            )
        });
        let borders = each(n, |i| {
            format!(
                r#"<border type="curb" width="0.1" outlineId="{}" useCompleteOutline="true"/>"#,
                n - 1 - i
            )
        });
        objects(
            1,
            &object(
                "trafficIsland",
                &format!("<outlines>{outlines}</outlines><borders>{borders}</borders>"),
            ),
        )
    }),
    pile("vertices of a skeleton", 200, |n| {
        let vertices = each(n, |i| {
            format!(r#"<vertexLocal id="{i}" u="{}" v="{}" z="0" radius="0.1"/>"#, i % 7, i % 5)
        });
        objects(
            1,
            &object(
                "barrier",
                &format!(r#"<skeleton><polyline id="0">{vertices}</polyline></skeleton>"#),
            ),
        )
    }),
    pile("repeats", 100, |n| objects(1, &pole(0, &repeat(10.0).repeat(n)))),
    pile("repeats of many objects", 4, |n| objects(1, &each(n, |i| pole(i, &repeat(0.1))))),
    pile("repeats of many corners", 60, |n| {
        let inside = repeat(100.0 / n as f64) + &outline(n, |i| [i % 7, i % 5]);
        objects(1, &object("building", &inside))
    }),
    pile("objects for all lanes", 30, |n| {
        let validity = format!(r#"<validity fromLane="-{n}" toLane="-1"/>"#);
        objects(n, &each(n, |i| pole(i, &validity)))
    }),
    pile("validities of an object, lanes", 60, |n| {
        let validity = format!(r#"<validity fromLane="-{n}" toLane="-1"/>"#);
        objects(n, &pole(0, &validity.repeat(n)))
    }),
    pile("crosswalks over all lanes", 30, |n| {
        let width = 7 * n;
        objects(
            n,
            &each(n, |i| {
                let s = 90.0 * i as f64 / n as f64;
                format!(
                    r#"<object id="{i}" s="{s}" t="0" zOffset="0" type="crosswalk" name="" hdg="0" height="1" length="3" width="{width}" orientation="none"/>"#
                )
            }),
        )
    }),
    pile("references to an object", 200, |n| {
        let references = each(n, |i| {
            let s = 100.0 * i as f64 / n as f64;
            format!(r#"<objectReference id="0" s="{s}" t="0" zOffset="0" orientation="none"/>"#)
        });
        objects(1, &(pole(0, "") + &references))
    }),
    pile("references to an object of many corners", 60, |n| {
        let references = each(n, |i| {
            let s = 100.0 * i as f64 / n as f64;
            format!(r#"<objectReference id="0" s="{s}" t="0" zOffset="0" orientation="none"/>"#)
        });
        objects(1, &(object("building", &outline(n, |i| [i % 7, i % 5])) + &references))
    }),
    pile("parking spaces", 100, |n| {
        objects(
            1,
            &each(n, |i| {
                let s = 100.0 * i as f64 / n as f64;
                format!(
                    r#"<object id="{i}" s="{s}" t="-4" zOffset="0" type="parkingSpace" name="" hdg="0" height="0" length="5" width="2.5" orientation="none"><parkingSpace access="all"/></object>"#
                )
            }),
        )
    }),
    pile("bridges", 200, |n| objects(1, &each(n, |i| bridge(i, 0.0)))),
    pile("bridges, lanes", 60, |n| objects(n, &each(n, |i| bridge(i, 90.0 * i as f64 / n as f64)))),
    // Signals.
    pile("signals at one place", 100, |n| signals(1, &each(n, |i| signal(i, "")))),
    pile("signals, lanes", 30, |n| signals(n, &each(n, |i| signal(i, "")))),
    pile("signals along, lanes", 30, |n| {
        signals(
            n,
            &each(n, |i| {
                signal(i, "")
                    .replace(r#"s="50""#, &format!(r#"s="{}""#, 100.0 * i as f64 / n as f64))
            }),
        )
    }),
    pile("references to a signal", 200, |n| signals(1, &(signal("s", "") + &signal_references(n)))),
    pile("references to a signal, lanes", 30, |n| {
        signals(n, &(signal("s", "") + &signal_references(n)))
    }),
    pile("validities of a signal, lanes", 60, |n| {
        let validity = format!(r#"<validity fromLane="-{n}" toLane="-1"/>"#);
        signals(n, &signal("s", &validity.repeat(n)))
    }),
    pile("dependencies in a circle", 100, |n| {
        signals(
            1,
            &each(n, |i| {
                let next = (i + 1) % n;
                signal(
                    i,
                    &format!(
                        r#"<dependency id="{next}" type="x"/><reference elementType="signal" elementId="{next}"/>"#
                    ),
                )
            }),
        )
    }),
    pile("dependencies, each back to the first", 100, |n| {
        signals(
            1,
            &each(n, |i| {
                signal(
                    i,
                    &format!(
                        r#"<dependency id="{}" type="x"/><dependency id="0" type="x"/>"#,
                        i + 1
                    ),
                )
            }),
        )
    }),
    pile("signs of a board", 100, |n| {
        let signs = each(n, |i| {
            format!(
                r#"<sign id="b{i}" v="0" z="0" type="274" subtype="50" country="DE" value="50" height="1" width="1" zOffset="0"/>"#
            )
        });
        signals(1, &signal("s", &format!("<staticBoard>{signs}</staticBoard>")))
    }),
    pile("zones without an end", 60, |n| {
        // A road with a zone, one without, and one that both lead to, again and again.
        map(&each(n, |i| {
            let at = |x: f64, y: f64| [x, 50.0 * i as f64 + y, 0.0];
            let zone = r#"<signals><signal id="z" s="50" t="-4" zOffset="2" dynamic="no" orientation="+" type="274.1" subtype="-1" country="DE" value="30" unit="km/h"/></signals>"#;
            let zone = zone.replace(r#"id="z""#, &format!(r#"id="z{i}""#));
            let into = format!(r#"<successor elementType="junction" elementId="j{i}"/>"#);
            let junction = format!("j{i}");
            let way = |from: char| {
                let link = road_link("predecessor", format!("{from}{i}"), "end")
                    + &road_link("successor", format!("o{i}"), "start");
                let lanes = section(
                    0.0,
                    &lane(1, r#"<link><predecessor id="-1"/><successor id="-1"/></link>"#),
                );
                Road {
                    at: at(100.0, 0.0),
                    length: 10.0,
                    junction: &junction,
                    link: &link,
                    lanes: &lanes,
                    ..ROAD
                }
                .text(format!("w{from}{i}"))
            };
            let out = format!(r#"<predecessor elementType="junction" elementId="j{i}"/>"#);
            let joined = |from: char| {
                format!(
                    r#"<connection id="{from}" incomingRoad="{from}{i}" connectingRoad="w{from}{i}" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#
                )
            };
            Road { at: at(0.0, 0.0), link: &into, inside: &zone, ..ROAD }.text(format!("a{i}"))
                + &Road { at: at(0.0, 0.0), link: &into, ..ROAD }.text(format!("b{i}"))
                + &way('a')
                + &way('b')
                + &Road { at: at(110.0, 0.0), link: &out, ..ROAD }.text(format!("o{i}"))
                + &format!(
                    r#"<junction id="j{i}" name="">{}{}</junction>"#,
                    joined('a'),
                    joined('b')
                )
        }))
    }),
    pile("priorities of all over all", 12, |n| {
        let all = each(n, |i| each(n, |k| priority(i, k)));
        map(&(metre() + &junction(&all)))
    }),
    pile("direct junctions' roads", 100, |n| {
        let roads = each(n, |i| Road { at: [0.0, 10.0 * i as f64, 0.0], ..ROAD }.text(i));
        let connections = each(n, |i| {
            let linked = (i + 1) % n;
            format!(
                r#"<connection id="{i}" incomingRoad="{i}" linkedRoad="{linked}" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#
            )
        });
        map(&(roads
            + &format!(r#"<junction id="D" name="" type="direct">{connections}</junction>"#)))
    }),
    pile("geometries that are no curves", 200, |n| {
        let plan = each(n, |i| {
            format!(
                r#"<geometry s="{i}" x="{i}" y="0" hdg="0" length="1"><arc curvature="nan"/></geometry>"#
            )
        });
        map(&Road { length: n as f64, plan: &plan, ..ROAD }.text(1))
    }),
    pile("controllers", 400, |n| {
        map(&(metre()
            + &each(n, |i| {
                format!(
                    r#"<controller id="{i}" name=""><control signalId="s{i}" type=""/></controller>"#
                )
            })))
    }),
    pile("controllers of one signal", 200, |n| {
        let controllers = each(n, |i| {
            format!(r#"<controller id="{i}" name=""><control signalId="s" type=""/></controller>"#)
        });
        let road =
            Road { inside: &format!("<signals>{}</signals>", signal("s", "")), ..ROAD }.text(1);
        map(&(road + &controllers))
    }),
    // Other things.
    pile("gridded surfaces of a road", 400, |n| {
        let crg = r#"<CRG file="a.crg" sStart="0" sEnd="100" orientation="same" mode="attached" sOffset="0" tOffset="0" zOffset="0" zScale="1" hOffset="0"/>"#;
        map(&Road { inside: &format!("<surface>{}</surface>", crg.repeat(n)), ..ROAD }.text(1))
    }),
    pile("switches", 200, |n| {
        let switches = each(n, |i| {
            format!(
                r#"<switch name="" id="{i}" position="dynamic"><mainTrack id="1" s="5" dir="+"/><sideTrack id="1" s="5" dir="+"/></switch>"#
            )
        });
        map(&Road { inside: &format!("<railroad>{switches}</railroad>"), ..ROAD }.text(1))
    }),
    pile("user data", 400, |n| map(&(metre() + &r#"<userData code="a" value="b"/>"#.repeat(n)))),
    pile("unknown elements", 1000, |n| map(&(metre() + &r#"<other a="1"/>"#.repeat(n)))),
    pile("comments", 2000, |n| map(&(metre() + &"<!-- -->".repeat(n)))),
    pile("references to characters", 1000, |n| {
        let name = format!(r#"name="{}""#, "&lt;".repeat(n));
        map(&metre().replace(r#"name="""#, &name))
    }),
];

const fn pile(name: &'static str, small: usize, text: fn(usize) -> String) -> Pile {
    Pile { name, small, text }
}

/// Sections that only say what lies on one side: beyond, a road is too large.
const MOST_SECTIONS: usize = 800;

fn map(content: &str) -> String {
    format!(r#"<OpenDRIVE><header revMajor="1" revMinor="8"></header>{content}</OpenDRIVE>"#)
}

/// So many of what is made of each number.
fn each(n: usize, one: impl Fn(usize) -> String) -> String {
    (0..n).map(one).collect()
}

/// A road, as elements; those that are empty have their usual content.
#[derive(Clone, Copy)]
struct Road<'a> {
    /// x, y and heading of its start.
    at: [f64; 3],
    length: f64,
    junction: &'a str,
    link: &'a str,
    types: &'a str,
    plan: &'a str,
    profiles: &'a str,
    lanes: &'a str,
    inside: &'a str,
}

/// 100 m along x with one lane.
const ROAD: Road<'_> = Road {
    at: [0.0; 3],
    length: 100.0,
    junction: "-1",
    link: "",
    types: "",
    plan: "",
    profiles: "",
    lanes: "",
    inside: "",
};

impl Road<'_> {
    fn text(&self, id: impl Display) -> String {
        let Self { at: [x, y, hdg], length, junction, link, types, plan, profiles, lanes, inside } =
            *self;
        let line = format!(
            r#"<geometry s="0" x="{x}" y="{y}" hdg="{hdg}" length="{length}"><line/></geometry>"#
        );
        let one = right(1);
        fn or<'a>(own: &'a str, usual: &'a str) -> &'a str {
            if own.is_empty() { usual } else { own }
        }
        format!(
            r#"<road name="" id="{id}" length="{length}" junction="{junction}"><link>{link}</link>{types}<planView>{}</planView>{profiles}<lanes>{}</lanes>{inside}</road>"#,
            or(plan, &line),
            or(lanes, &one),
        )
    }
}

fn metre() -> String {
    Road { length: 1.0, ..ROAD }.text(1)
}

const CENTER: &str = r#"<center><lane id="0" type="none"/></center>"#;

/// A lane to the right, 3.5 m wide.
fn lane(number: impl Display, inside: &str) -> String {
    let (links, rest) = inside
        .split_once("</link>")
        .map_or(("", inside), |(_, rest)| (&inside[..inside.len() - rest.len()], rest));
    let width = cubic("width", r#"sOffset="0""#, 3.5);
    format!(r#"<lane id="-{number}" type="driving">{links}{width}{rest}</lane>"#)
}

fn section(s: f64, lanes: &str) -> String {
    format!(r#"<laneSection s="{s}">{CENTER}<right>{lanes}</right></laneSection>"#)
}

/// A section of so many lanes to the right.
fn right(n: usize) -> String {
    section(0.0, &each(n, |i| lane(i + 1, "")))
}

fn cubic(name: &str, at: &str, a: f64) -> String {
    format!(r#"<{name} {at} a="{a}" b="0" c="0" d="0"/>"#)
}

/// A metre apart, by turns 0 and something.
fn steps(name: &str, n: usize, height: f64) -> String {
    each(n, |i| cubic(name, &format!(r#"s="{i}""#), height * (i % 2) as f64))
}

fn elevations(n: usize, s: impl Fn(usize) -> usize) -> String {
    let rows = each(n, |i| {
        let at = s(i);
        cubic("elevation", &format!(r#"s="{at}""#), (i % 2) as f64)
    });
    format!("<elevationProfile>{rows}</elevationProfile>")
}

fn superelevations(n: usize) -> String {
    format!("<lateralProfile>{}</lateralProfile>", steps("superelevation", n, 0.01))
}

fn shapes(n: usize) -> String {
    let rows = each(n, |i| cubic("shape", &format!(r#"s="{i}" t="-10""#), 0.1 * (i % 2) as f64));
    format!("<lateralProfile>{rows}</lateralProfile>")
}

fn offsets(n: usize) -> String {
    steps("laneOffset", n, 0.01)
}

fn types(n: usize) -> String {
    each(n, |i| {
        let max = 50 + i % 2;
        format!(r#"<type s="{i}" type="town"><speed max="{max}" unit="km/h"/></type>"#)
    })
}

/// Records so far apart that allow one class after the other.
fn accesses(n: usize, apart: f64) -> String {
    const CLASSES: [&str; 4] = ["bus", "truck", "taxi", "bicycle"];
    each(n, |i| {
        let (s, class) = (apart * i as f64, CLASSES[i % CLASSES.len()]);
        format!(r#"<access sOffset="{s}" rule="allow" restriction="{class}"/>"#)
    })
}

fn marks(n: usize) -> String {
    each(n, |i| {
        let change = ["none", "both"][i % 2];
        format!(
            r#"<roadMark sOffset="{i}" type="solid" weight="standard" color="standard" width="0.1" laneChange="{change}"/>"#
        )
    })
}

fn road_link(end: &str, id: impl Display, contact: &str) -> String {
    format!(r#"<{end} elementType="road" elementId="{id}" contactPoint="{contact}"/>"#)
}

/// The road that leads into junction J, with so many lanes.
fn incoming(lanes: usize) -> String {
    let link = r#"<successor elementType="junction" elementId="J"/>"#;
    Road { link, lanes: &right(lanes), ..ROAD }.text("in")
}

/// A road of junction J behind that.
fn connecting(id: impl Display) -> String {
    let link = road_link("predecessor", "in", "end");
    Road { at: [100.0, 0.0, 0.0], length: 10.0, junction: "J", link: &link, ..ROAD }.text(id)
}

fn connection(id: impl Display, to: impl Display) -> String {
    format!(
        r#"<connection id="{id}" incomingRoad="in" connectingRoad="{to}" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#
    )
}

fn junction(content: &str) -> String {
    format!(r#"<junction id="J" name="">{content}</junction>"#)
}

fn priority(high: impl Display, low: impl Display) -> String {
    format!(r#"<priority high="{high}" low="{low}"/>"#)
}

/// Ways through the middle of junction J, from all around, and what else the junction says.
fn crossing(n: usize, content: &str) -> String {
    let (mut roads, mut connections) = (String::new(), String::new());
    for i in 0..n {
        let hdg = PI * i as f64 / n as f64;
        let at = |away: f64| [-away * hdg.cos(), -away * hdg.sin(), hdg];
        let into = r#"<successor elementType="junction" elementId="J"/>"#;
        roads += &Road { at: at(100.0), length: 50.0, link: into, ..ROAD }.text(format!("i{i}"));
        let from = road_link("predecessor", format!("i{i}"), "end");
        roads += &Road { at: at(50.0), junction: "J", link: &from, ..ROAD }.text(format!("c{i}"));
        // Writing to a string cannot fail.
        let _ = write!(
            connections,
            r#"<connection id="{i}" incomingRoad="i{i}" connectingRoad="c{i}" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#
        );
    }
    roads + &junction(&(connections + content))
}

/// A road of so many lanes with these objects.
fn objects(lanes: usize, objects: &str) -> String {
    let inside = format!("<objects>{objects}</objects>");
    map(&Road { lanes: &right(lanes), inside: &inside, ..ROAD }.text(1))
}

fn pole(id: impl Display, inside: &str) -> String {
    format!(
        r#"<object id="{id}" s="50" t="0" zOffset="0" type="pole" name="" hdg="0" height="1" radius="0.2" orientation="none">{inside}</object>"#
    )
}

/// Object 0 in the middle of the road.
fn object(kind: &str, inside: &str) -> String {
    format!(
        r#"<object id="0" s="50" t="0" zOffset="0" type="{kind}" name="" hdg="0" orientation="none">{inside}</object>"#
    )
}

/// An outline with so many corners.
fn outline(n: usize, corner: impl Fn(usize) -> [usize; 2]) -> String {
    let corners = each(n, |i| {
        let [u, v] = corner(i);
        format!(r#"<cornerLocal u="{u}" v="{v}" z="0" height="1" id="{i}"/>"#)
    });
    format!(r#"<outlines><outline id="0" closed="true">{corners}</outline></outlines>"#)
}

/// All along the road, so far apart.
fn repeat(distance: f64) -> String {
    format!(
        r#"<repeat s="0" length="100" distance="{distance}" tStart="0" tEnd="0" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/>"#
    )
}

fn bridge(id: usize, s: f64) -> String {
    format!(r#"<bridge id="{id}" s="{s}" length="10" type="concrete" name=""/>"#)
}

/// A road of so many lanes with these signals.
fn signals(lanes: usize, signals: &str) -> String {
    let inside = format!("<signals>{signals}</signals>");
    map(&Road { lanes: &right(lanes), inside: &inside, ..ROAD }.text(1))
}

fn signal(id: impl Display, inside: &str) -> String {
    format!(
        r#"<signal id="{id}" s="50" t="-4" zOffset="2" name="" dynamic="no" orientation="+" type="274" subtype="50" country="DE" value="50" unit="km/h">{inside}</signal>"#
    )
}

/// So many references to signal s, all along the road.
fn signal_references(n: usize) -> String {
    each(n, |i| {
        let s = 100.0 * i as f64 / n as f64;
        format!(r#"<signalReference id="s" s="{s}" t="0" orientation="+"/>"#)
    })
}
