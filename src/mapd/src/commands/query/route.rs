//! `mapd query … route`.

use super::holes::{Holes, exit};
use super::kinds::{LaneColumns, lane_in, number, text};
use super::row::Row;
use crate::args::{not_negative, vehicle};
use clap::{Args, ValueEnum, value_parser};
use mapd_client::Map;
use mapd_overlay::Moment;
use mapd_query::LaneId;
use mapd_query::glam::DVec2;
use mapd_query::route::{
    AlternativeOptions, Enter, PositionOnLane, Route, RouteCost, RouteRequest, RouteScratch,
    RouteStep, Routes, ShortestLength, ShortestTime,
};
use mapd_query::view::View;
use mapd_query::vocabulary::{RoadRules, VehicleClass};

/// What a route is to keep small.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RouteBy {
    /// Metres along lanes.
    Length,
    /// Seconds, at recorded speed limits, else at assumed speeds.
    Time,
}

/// How routes are found.
#[derive(Args, Clone, Debug)]
pub struct RouteArgs {
    /// route, and all that goes along one: quantity to minimise
    #[arg(long, value_enum, default_value_t = RouteBy::Length)]
    by: RouteBy,
    /// route: so many routes, the cheapest first: a row for each that drives at least 30 % of its length elsewhere than those before it and costs at most half as much again
    #[arg(long, value_name = "COUNT", default_value_t = 1, value_parser = value_parser!(u8).range(1..=32))]
    alternatives: u8,
    /// route, and all that goes along one: lane that is not entered, as a key such as 12:0:-1; may be given several times
    #[arg(long, value_name = "LANE")]
    avoid: Vec<String>,
    /// route, and all that goes along one: cost of a lane change, in metres or seconds [default: 20 m, 2 s]
    #[arg(long, value_name = "COST", value_parser = not_negative)]
    lane_change: Option<f64>,
    /// route, all that goes along one, speed, signals: kind of vehicle, in the words of access/restriction; if given, nearest: only places that it may use, match: others are less likely
    #[arg(long, value_name = "CLASS", default_value = VehicleClass::PassengerCar.name(), value_parser = vehicle)]
    pub(super) vehicle: VehicleClass,
    /// shm:NAME: heed what is laid over the map (route, all that goes along one, speed, signals)
    #[arg(long)]
    pub(super) overlay: bool,
    /// --overlay: as it is at this moment, as 2026-05-04T07:00:00Z or seconds since 1970 [default: now]
    #[arg(long, value_name = "TIME", requires = "overlay")]
    pub(super) at: Option<Moment>,
    /// conflicts: country whose traffic rules decide who yields if the file does not, such as DE
    #[arg(long, value_name = "COUNTRY", value_parser = rules)]
    rules: Option<&'static RoadRules>,
    /// path, corridor: distance between stations [m]
    #[arg(long, value_name = "M", default_value_t = STEP, value_parser = step)]
    step: f64,
}

/// From station to station by default `[m]`.
const STEP: f64 = 1.0;

fn step(text: &str) -> Result<f64, String> {
    let step = text.parse::<f64>().ok().filter(|step| step.is_finite() && *step > 0.0);
    step.ok_or_else(|| "expected a positive finite number of metres".to_owned())
}

fn rules(country: &str) -> Result<&'static RoadRules, String> {
    RoadRules::of(country).ok_or_else(|| {
        let known: Vec<&str> = RoadRules::ALL.iter().map(|own| own.country).collect();
        format!("no rules of this country are known; expected one of {}", known.join(", "))
    })
}

impl Default for RouteArgs {
    fn default() -> Self {
        Self {
            by: RouteBy::Length,
            lane_change: None,
            alternatives: 1,
            avoid: Vec::new(),
            vehicle: VehicleClass::PassengerCar,
            overlay: false,
            at: None,
            rules: None,
            step: STEP,
        }
    }
}

/// Finds routes one after the other.
pub(crate) struct Router<'a> {
    args: &'a RouteArgs,
    view: View<'a>,
    scratch: RouteScratch,
    routes: Routes,
    steps: Vec<RouteStep>,
    /// Lanes that are not entered.
    avoid: Vec<LaneId>,
}

impl<'a> Router<'a> {
    /// Errors: there is no lane of a key that is to be avoided.
    pub(crate) fn new(args: &'a RouteArgs, view: View<'a>) -> Result<Self, String> {
        let lane = |key: &String| {
            let parsed = key.parse().map_err(|error| format!("--avoid {key}: {error}"))?;
            let lane = view.map().lane_by_key(&parsed);
            lane.map(|lane| lane.lane_id()).ok_or_else(|| format!("--avoid {key}: no such lane"))
        };
        Ok(Self {
            args,
            view,
            scratch: RouteScratch::default(),
            routes: Routes::default(),
            steps: Vec::new(),
            avoid: args.avoid.iter().map(lane).collect::<Result<_, _>>()?,
        })
    }

    /// The map, under what is laid over it if that is heeded.
    pub(super) fn view(&self) -> View<'a> {
        self.view
    }

    /// Who travels.
    pub(crate) fn vehicle(&self) -> VehicleClass {
        self.args.vehicle
    }

    /// By whose rules of the road to say who yields.
    pub(super) fn rules(&self) -> Option<&'static RoadRules> {
        self.args.rules
    }

    /// Where the steps of the last answer end.
    pub(super) fn ends(&self, map: Map<'_>) -> impl Iterator<Item = DVec2> {
        self.steps.iter().filter_map(move |step| exit(&map.lane(step.lane).ok()?))
    }

    /// The steps of the last route.
    pub(super) fn steps(&self) -> &[RouteStep] {
        &self.steps
    }

    /// From station to station `[m]`.
    pub(super) fn step(&self) -> f64 {
        self.args.step
    }

    /// Finds the route of a row; its steps are then [`Self::steps`].
    pub(super) fn find(
        &mut self,
        holes: &Holes<'_>,
        map: Map<'_>,
        row: &Row<'_>,
    ) -> Result<Route, String> {
        self.steps.clear();
        let place = |road, s, lane| {
            let (lane, s) = lane_in(holes, map, row, LaneColumns { road, s, lane })?;
            Ok::<_, String>(PositionOnLane { lane: lane.lane_id(), s })
        };
        let from = place("from_road", "from_s", "from_lane")?;
        let to = place("to_road", "to_s", "to_lane")?;
        let found = match self.args.by {
            RouteBy::Length => {
                let default = ShortestLength::default().lane_change;
                let lane_change = self.args.lane_change.unwrap_or(default);
                self.search((from, to), &ShortestLength { lane_change })
            }
            RouteBy::Time => {
                let default = ShortestTime::default().lane_change;
                let lane_change = self.args.lane_change.unwrap_or(default);
                self.search((from, to), &ShortestTime { lane_change })
            }
        };
        let vehicle = self.args.vehicle;
        let route = found?;
        route.ok_or_else(|| {
            let lost = match map.quarantined().len() {
                0 => String::new(),
                1 => "; one part of the map is left out".to_owned(),
                more => format!("; {more} parts of the map are left out"),
            };
            format!("no way for {}{lost}", vehicle.name())
        })
    }

    /// The route between two places, and its alternatives.
    fn search(
        &mut self,
        (from, to): (PositionOnLane, PositionOnLane),
        cost: &impl RouteCost,
    ) -> Result<Option<Route>, String> {
        let Self { args, view, scratch, routes, steps, avoid } = self;
        let (starts, goals) = ([from.into()], [to.into()]);
        let vehicle = args.vehicle;
        let request = RouteRequest { starts: &starts, goals: &goals, vehicle, cost, avoid };
        let options = AlternativeOptions {
            count: usize::from(args.alternatives),
            ..AlternativeOptions::default()
        };
        view.alternatives(&request, &options, scratch, routes).map_err(|e| e.to_string())?;
        let best = routes.iter().next();
        steps.extend(best.iter().flat_map(|(_, steps)| steps.iter()));
        Ok(best.map(|(route, _)| *route))
    }

    /// Answers one row.
    pub(crate) fn answer(
        &mut self,
        holes: &Holes<'_>,
        map: Map<'_>,
        row: &Row<'_>,
        out: &mut Vec<String>,
    ) -> Result<(), String> {
        self.find(holes, map, row)?;
        for (route, steps) in self.routes.iter() {
            out.push(number(route.length));
            out.push(route.lane_changes.to_string());
            out.push(lanes(map, steps)?);
        }
        Ok(())
    }
}

/// Keys of a route's lanes.
fn lanes(map: Map<'_>, steps: &[RouteStep]) -> Result<String, String> {
    let mut keys: Vec<String> = Vec::new();
    let mut last = None;
    for step in steps {
        let lane = map.lane(step.lane).map_err(text)?;
        let (key, section) = (lane.key().to_string(), lane.section().section_id());
        // Stretches of one lane beside a section of the other side are one lane; a ring's lane may follow itself.
        let goes_on = step.enter == Enter::Ahead && last.is_some_and(|last| last != section);
        if !(goes_on && keys.last() == Some(&key)) {
            keys.push(key);
        }
        last = Some(section);
    }
    Ok(keys.join(";"))
}
