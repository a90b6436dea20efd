//! A slow, literal reader of lane links: a small DOM and the standard's words, sharing nothing with the compiler.

use quick_xml::events::{BytesStart, Event};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// An XML element.
#[derive(Debug, Default)]
pub struct Element {
    /// Local name.
    pub name: String,
    /// Attributes by name.
    pub attributes: HashMap<String, String>,
    /// Child elements.
    pub children: Vec<Element>,
}

impl Element {
    /// Reads a document as far as it is well-formed.
    pub fn parse(text: &str) -> Self {
        let mut reader = quick_xml::Reader::from_str(text);
        let mut open = vec![Self::default()];
        loop {
            match reader.read_event() {
                Ok(Event::Start(tag)) => open.push(Self::from_tag(&tag)),
                Ok(Event::Empty(tag)) => {
                    open.last_mut().expect("a parent").children.push(Self::from_tag(&tag))
                }
                Ok(Event::End(_)) => {
                    let done = open.pop().expect("an element");
                    open.last_mut().expect("a parent").children.push(done);
                }
                Ok(Event::Eof) | Err(_) => break,
                Ok(_) => {}
            }
        }
        open.swap_remove(0).children.into_iter().next().unwrap_or_default()
    }

    fn from_tag(tag: &BytesStart<'_>) -> Self {
        let attributes = tag.attributes().flatten().map(|a| {
            let value = quick_xml::escape::unescape(&a.value).map(|v| v.into_owned());
            (a.key.local_name().as_ref().to_owned(), value.unwrap_or_default())
        });
        Self {
            name: tag.local_name().as_ref().to_owned(),
            attributes: attributes.collect(),
            children: Vec::new(),
        }
    }

    /// An attribute; none where it is absent or empty.
    pub fn get(&self, name: &str) -> Option<&str> {
        self.attributes.get(name).map(String::as_str).filter(|v| !v.is_empty())
    }

    /// Children of a name.
    pub fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Element> {
        self.children.iter().filter(move |child| child.name == name)
    }

    /// First child of a name.
    pub fn child(&self, name: &str) -> Option<&Element> {
        self.children.iter().find(|child| child.name == name)
    }
}

/// A lane travelled in one direction: road id, section, lane number, towards +s.
pub type Node = (String, usize, i32, bool);

struct Document<'a> {
    roads: HashMap<&'a str, &'a Element>,
    junctions: HashMap<&'a str, &'a Element>,
}

/// Each node with the nodes that are entered from it over ends of sections.
pub fn successors(document: &Element) -> BTreeMap<Node, BTreeSet<Node>> {
    let by_id = |name| document.all(name).filter_map(|e| Some((e.get("id")?, e))).collect();
    let all = Document { roads: by_id("road"), junctions: by_id("junction") };
    let mut out = BTreeMap::new();
    for (id, road) in &all.roads {
        for (number, section) in sections(road).iter().enumerate() {
            for lane in lanes(section) {
                for forward in ways(road, lane) {
                    let to = all.leave(id, road, number, lane, forward);
                    out.insert(((*id).to_owned(), number, id_of(lane), forward), to);
                }
            }
        }
    }
    out
}

fn sections(road: &Element) -> Vec<&Element> {
    let layer = road.all("lanes").find(|lanes| lanes.get("layer") != Some("temporary"));
    layer.map(|lanes| lanes.all("laneSection").collect()).unwrap_or_default()
}

fn lanes(section: &Element) -> Vec<&Element> {
    ["left", "center", "right"]
        .iter()
        .flat_map(|side| section.all(side))
        .flat_map(|side| side.all("lane"))
        .filter(|lane| id_of(lane) != 0)
        .collect()
}

fn id_of(lane: &Element) -> i32 {
    lane.get("id").and_then(|id| id.parse().ok()).unwrap_or(0)
}

/// Directions in which a lane is travelled: towards +s?
fn ways(road: &Element, lane: &Element) -> Vec<bool> {
    let standard = (id_of(lane) < 0) != (road.get("rule") == Some("LHT"));
    if lane.get("direction") == Some("both") || lane.get("type") == Some("bidirectional") {
        vec![true, false]
    } else if matches!(lane.get("type"), Some("sidewalk" | "walking")) {
        // The graph's own word, not the standard's: pedestrians may go both ways.
        vec![true, false]
    } else if lane.get("direction") == Some("reversed") {
        vec![!standard]
    } else {
        vec![standard]
    }
}

fn links(lane: &Element, forward: bool) -> Vec<i32> {
    let name = if forward { "successor" } else { "predecessor" };
    let all = lane.all("link").flat_map(|link| link.all(name));
    all.filter_map(|link| link.get("id")?.parse().ok()).collect()
}

fn road_link(road: &Element, at_end: bool) -> Option<&Element> {
    road.child("link")?.child(if at_end { "successor" } else { "predecessor" })
}

impl Document<'_> {
    fn leave(
        &self,
        id: &str,
        road: &Element,
        section: usize,
        lane: &Element,
        forward: bool,
    ) -> BTreeSet<Node> {
        let mut out = BTreeSet::new();
        let count = sections(road).len();
        let inside = if forward { section + 1 < count } else { section > 0 };
        if inside {
            let next = if forward { section + 1 } else { section - 1 };
            for to in links(lane, forward) {
                self.enter(id, next, to, forward, &mut out);
            }
            return out;
        }
        let Some(link) = road_link(road, forward) else { return out };
        let Some(target) = link.get("elementId") else { return out };
        if link.get("elementType") != Some("junction") {
            if link.get("elementS").is_some() {
                return out;
            }
            for to in links(lane, forward) {
                self.enter_end(target, link.get("contactPoint"), to, &mut out);
            }
            return out;
        }
        let Some(junction) = self.junctions.get(target) else { return out };
        if junction.get("type") == Some("direct") {
            self.leave_directly(id, junction, id_of(lane), forward, &mut out);
            return out;
        }
        let here = |at_end| {
            let link = road_link(road, at_end);
            link.is_some_and(|link| {
                link.get("elementType") == Some("junction") && link.get("elementId") == Some(target)
            })
        };
        for connection in junction.all("connection").filter(|c| c.get("incomingRoad") == Some(id)) {
            let connecting = connection.get("linkedRoad").or(connection.get("connectingRoad"));
            let Some(connecting) = connecting else { continue };
            let contact = connection.get("contactPoint");
            if here(true) && here(false) {
                let own =
                    self.roads.get(connecting).and_then(|c| road_link(c, contact == Some("end")));
                let end = if forward { "end" } else { "start" };
                let named = own.is_some_and(|own| {
                    own.get("elementId") == Some(id) && own.get("contactPoint") == Some(end)
                });
                if !named {
                    continue;
                }
            }
            if connection.child("laneLink").is_none() {
                self.enter_end(connecting, contact, id_of(lane), &mut out);
            }
            for link in connection.all("laneLink") {
                if link.get("from").and_then(|from| from.parse().ok()) == Some(id_of(lane))
                    && let Some(to) = link.get("to").and_then(|to| to.parse().ok())
                {
                    self.enter_end(connecting, contact, to, &mut out);
                }
            }
        }
        out
    }

    /// At a direct junction, links lead from either road into the other, as their lanes travel.
    fn leave_directly(
        &self,
        id: &str,
        junction: &Element,
        lane: i32,
        forward: bool,
        out: &mut BTreeSet<Node>,
    ) {
        let number = |link: &Element, name| link.get(name).and_then(|id: &str| id.parse().ok());
        let own_end = if forward { "end" } else { "start" };
        for connection in junction.all("connection") {
            let linked = connection.get("linkedRoad").or(connection.get("connectingRoad"));
            let (incoming, contact) =
                (connection.get("incomingRoad"), connection.get("contactPoint"));
            let (Some(incoming), Some(linked)) = (incoming, linked) else { continue };
            let links: Vec<(i32, i32)> = connection
                .all("laneLink")
                .filter_map(|link| Some((number(link, "from")?, number(link, "to")?)))
                .collect();
            let pairs = if links.is_empty() { vec![(lane, lane)] } else { links };
            for (from, to) in pairs {
                if incoming == id && from == lane {
                    self.enter_end(linked, contact, to, out);
                }
                if linked == id && to == lane && contact == Some(own_end) {
                    let names = |at_end| {
                        let link = road_link(self.roads.get(incoming)?, at_end)?;
                        (link.get("elementId") == junction.get("id")).then_some(())
                    };
                    for (at_end, end) in [(false, "start"), (true, "end")] {
                        if names(at_end).is_some() {
                            self.enter_end(incoming, Some(end), from, out);
                        }
                    }
                }
            }
        }
    }

    fn enter_end(&self, road: &str, contact: Option<&str>, lane: i32, out: &mut BTreeSet<Node>) {
        let count = self.roads.get(road).map_or(0, |road| sections(road).len());
        match contact {
            Some("start") if count > 0 => self.enter(road, 0, lane, true, out),
            Some("end") if count > 0 => self.enter(road, count - 1, lane, false, out),
            _ => {}
        }
    }

    fn enter(&self, id: &str, section: usize, lane: i32, forward: bool, out: &mut BTreeSet<Node>) {
        let Some(road) = self.roads.get(id) else { return };
        let sections = sections(road);
        let Some(section_element) = sections.get(section) else { return };
        let found = lanes(section_element).into_iter().find(|other| id_of(other) == lane);
        if found.is_some_and(|found| ways(road, found).contains(&forward)) {
            out.insert((id.to_owned(), section, lane, forward));
        }
    }
}
