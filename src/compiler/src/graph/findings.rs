//! What is wrong with lane links, put into words.

use crate::draft::Draft;
use crate::findings::finding;
use mapd_archive::Rows;
use mapd_rules::catalog::building;
use mapd_rules::{Rule, Settings};
use mapd_xodr::{Finding, Severity, Span};

/// Problems of one kind that are named one by one where they are no errors; more are counted. Errors are all named: each says
/// which part to leave out, and a number would be in no part.
const NAMED: usize = 100;

/// Something wrong with a lane link.
pub(crate) enum Problem {
    /// The link names a lane that the section does not have. A `laneLink` of a connection is a part of its own, which is
    /// left out; a lane's own link is not.
    MissingLane { from: u32, section: u32, number: i32, span: Span, is_lane_link: bool },
    /// The link leads into a lane that travels the other way.
    Direction { from: u32, lane: u32, span: Span },
    /// The link names a place that no road of the map has.
    NoPlace { path: &'static str, message: String, span: Span },
}

/// What is wrong with lane links, in the order in which it was found.
#[derive(Default)]
pub(crate) struct Problems(Vec<Problem>);

impl Problems {
    pub(crate) fn add(&mut self, problem: Problem) {
        self.0.push(problem);
    }

    /// Adds those that were found behind these.
    pub(crate) fn append(&mut self, mut others: Self) {
        self.0.append(&mut others.0);
    }

    /// Findings in file order; of each kind the first ones by name, the rest as a number.
    pub(crate) fn report(
        mut self,
        draft: &Draft,
        settings: &Settings,
        findings: &mut Vec<Finding>,
    ) {
        self.0.sort_by_key(|problem| problem.span().start);
        // A link against the traffic is the rule for lanes that end.
        for (rule, severity, what) in [
            (&building::MISSING_LANE, Severity::Error, "links name lanes that are not there"),
            (&building::MISSING_LANE, Severity::Warning, "links name lanes that are not there"),
            (
                &building::DIRECTION,
                Severity::Warning,
                "links lead into lanes that travel the other way",
            ),
            (&building::NO_PLACE, Severity::Warning, "links name places that no road has"),
        ] {
            let of_kind =
                || self.0.iter().filter(|p| (p.rule().id, p.severity()) == (rule.id, severity));
            let is_error = settings.severity_of(rule, severity) == Some(Severity::Error);
            let named = if is_error { usize::MAX } else { NAMED };
            for problem in of_kind().take(named) {
                let (path, message) = problem.text(draft);
                let span = problem.span();
                findings.push(finding(rule, severity, span, path, message, ""));
            }
            if let Some(more) = of_kind().count().checked_sub(named).filter(|more| *more > 0) {
                let path = "OpenDRIVE".to_owned();
                let message = format!("{more} more {what}");
                findings.push(finding(rule, severity, Span::default(), path, message, ""));
            }
        }
    }
}

impl Problem {
    fn span(&self) -> Span {
        match *self {
            Self::MissingLane { span, .. }
            | Self::Direction { span, .. }
            | Self::NoPlace { span, .. } => span,
        }
    }

    fn severity(&self) -> Severity {
        match self {
            Self::MissingLane { is_lane_link: true, .. } => Severity::Error,
            _ => Severity::Warning,
        }
    }

    fn rule(&self) -> &'static Rule {
        match self {
            Self::MissingLane { .. } => &building::MISSING_LANE,
            Self::Direction { .. } => &building::DIRECTION,
            Self::NoPlace { .. } => &building::NO_PLACE,
        }
    }

    fn text(&self, draft: &Draft) -> (String, String) {
        match *self {
            Self::NoPlace { path, ref message, .. } => (path.to_owned(), message.clone()),
            Self::MissingLane { from, section, number, .. } => {
                let place = section_text(draft, section);
                let message =
                    format!("expected a lane {number} in {place}, found none; not linked");
                (node_path(draft, from), message)
            }
            Self::Direction { from, lane, .. } => {
                let message = format!(
                    "expected a link to a lane that travels on, found {}, which travels the other way; not linked",
                    lane_text(draft, lane)
                );
                (node_path(draft, from), message)
            }
        }
    }
}

/// Path of the lane of a node.
fn node_path(draft: &Draft, node: u32) -> String {
    let lane = draft.rows.lane_nodes.get(node as usize).map_or(u32::MAX, |node| node.lane);
    let Some((road, section, number)) = place_of(&draft.rows, lane) else {
        return "OpenDRIVE/junction/connection/laneLink".to_owned();
    };
    let s = draft.rows.sections.get(section as usize).map_or(0.0, |section| section.s_start);
    let road = road_id(draft, road);
    format!("OpenDRIVE/road[@id={road}]/lanes/laneSection[@s={s}]/lane[@id={number}]")
}

fn lane_text(draft: &Draft, lane: u32) -> String {
    let Some((_, section, number)) = place_of(&draft.rows, lane) else { return String::new() };
    format!("lane {number} of {}", section_text(draft, section))
}

fn section_text(draft: &Draft, section: u32) -> String {
    let Some(row) = draft.rows.sections.get(section as usize) else { return String::new() };
    format!("road {:?}, section at s = {}", road_id(draft, row.road), row.s_start)
}

fn road_id(draft: &Draft, road: u32) -> String {
    let id = draft.rows.roads.get(road as usize).map_or(0, |road| road.id);
    String::from_utf8_lossy(draft.strings.bytes_of(id)).into_owned()
}

/// Road, section and number of a lane.
fn place_of(rows: &Rows, lane: u32) -> Option<(u32, u32, i32)> {
    let row = rows.lanes.get(lane as usize)?;
    let section = rows.sections.get(row.section as usize)?;
    Some((section.road, row.section, row.number))
}
