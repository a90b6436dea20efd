//! The group that a daemon shares its maps with.

use mapd_transport::{Share, group_id};
use serde::Deserialize;
use std::str::FromStr;

/// `group:NAME`, a name or a number; or `private`.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(try_from = "String")]
pub(crate) struct ShareWith(pub(crate) Share);

impl FromStr for ShareWith {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let share = match text.strip_prefix("group:") {
            Some(group) => Share::Group(group_id(group).map_err(|error| error.to_string())?),
            None if text == "private" => Share::Private,
            None => return Err(format!("expected private or group:NAME, found {text:?}")),
        };
        Ok(Self(share))
    }
}

impl TryFrom<String> for ShareWith {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}
