//! Types of a road.

use crate::example::Example::Road as In;
use crate::place::{RoadIn, text};
use crate::rule::Check::Road;
use crate::rule::Rule;
use crate::sink::Sink;

pub(super) static RULES: &[Rule] = &[Rule::warning(
    "asam.net:xodr:1.7.0:road.type.only_alpha_2_country_codes",
    "A country is a two-letter code of ISO 3166-1.",
    Road(country),
    [
        In(r#"<type s="0" type="town" country="DE"/>"#),
        In(r#"<type s="0" type="town" country="DEU"/>"#),
    ],
)
.since(7)];

fn country(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for record in &of.road.r#type {
        let country = text(&record.country);
        let is_code = country.len() == 2 && country.bytes().all(|byte| byte.is_ascii_uppercase());
        if !country.is_empty() && !is_code {
            sink.add_within("type", record.span, "a country's code of two letters", country);
        }
    }
}
