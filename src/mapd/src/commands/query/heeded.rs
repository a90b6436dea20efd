//! Which kinds heed which options: one that would change nothing is refused, for whoever gives it expects that it does.

use super::Kind;
use crate::exit::UsageError;
use clap::ArgMatches;
use clap::parser::ValueSource;

/// Whether a kind heeds an option.
type Heeds = fn(Kind) -> bool;

/// The options that only some kinds heed, by the names of their fields.
const OPTIONS: [(&str, Heeds); 13] = [
    ("radius", |kind| matches!(kind, Kind::Nearest | Kind::NearestMarks)),
    ("types", |kind| matches!(kind, Kind::Nearest | Kind::Match | Kind::NearestMarks)),
    ("z_tolerance", |kind| matches!(kind, Kind::Nearest | Kind::Match)),
    ("heading_tolerance", |kind| kind == Kind::Nearest),
    ("outline", |kind| kind == Kind::Match),
    ("by", goes_along_a_route),
    ("alternatives", |kind| kind == Kind::Route),
    ("avoid", goes_along_a_route),
    ("lane_change", goes_along_a_route),
    ("vehicle", |kind| depends_on_who_travels(kind) || matches!(kind, Kind::Nearest | Kind::Match)),
    ("overlay", depends_on_who_travels),
    ("rules", |kind| kind == Kind::Conflicts),
    ("step", |kind| matches!(kind, Kind::Path | Kind::Corridor)),
];

fn goes_along_a_route(kind: Kind) -> bool {
    matches!(kind, Kind::Route | Kind::Path | Kind::Corridor | Kind::Project | Kind::Conflicts)
}

/// And on what is laid over the map, which is about traffic.
fn depends_on_who_travels(kind: Kind) -> bool {
    goes_along_a_route(kind) || matches!(kind, Kind::Speed | Kind::Signals)
}

/// Whether an option is given, by the name of its field.
pub(super) fn is_given(matches: &ArgMatches, name: &str) -> bool {
    matches.value_source(name) == Some(ValueSource::CommandLine)
}

/// Errors: an option is given that the kind does not heed.
pub(super) fn check(kind: Kind, matches: &ArgMatches) -> Result<(), UsageError> {
    match OPTIONS.iter().find(|(name, heeds)| is_given(matches, name) && !heeds(kind)) {
        Some((name, _)) => {
            let (kind, option) = (kind.name(), name.replace('_', "-"));
            Err(UsageError(format!("{kind} does not heed --{option}")))
        }
        None => Ok(()),
    }
}
