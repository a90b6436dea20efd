//! `lights.toml`.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

/// The file.
pub(super) const TEXT: &str = r##"# What traffic lights can show. A mapping names one of these by `light`.
#
# bulbs   the lamps: red yellow green
# phases  what they show: red red_yellow yellow green flashing_red flashing_yellow flashing_green off

[[light]]
name = "three"
doc = "Three lamps, red and yellow together before green."
bulbs = ["red", "yellow", "green"]
phases = ["red", "red_yellow", "green", "yellow", "flashing_yellow", "off"]

[[light]]
name = "three_direct"
doc = "Three lamps, from red straight to green."
bulbs = ["red", "yellow", "green"]
phases = ["red", "green", "yellow", "flashing_red", "flashing_yellow", "off"]

[[light]]
name = "red_green"
doc = "Two lamps, as for people on foot."
bulbs = ["red", "green"]
phases = ["red", "green", "off"]

[[light]]
name = "walk"
doc = "Two lamps, the second phase flashes before red."
bulbs = ["red", "green"]
phases = ["red", "green", "flashing_red", "flashing_green", "off"]

[[light]]
name = "red_yellow"
doc = "Two lamps that stop traffic now and then."
bulbs = ["red", "yellow"]
phases = ["red", "yellow", "off"]

[[light]]
name = "yellow_green"
doc = "Two lamps beside a light that stops traffic."
bulbs = ["yellow", "green"]
phases = ["yellow", "green", "off"]

[[light]]
name = "red"
doc = "One red lamp."
bulbs = ["red"]
phases = ["red", "flashing_red", "off"]

[[light]]
name = "yellow"
doc = "One yellow lamp."
bulbs = ["yellow"]
phases = ["yellow", "flashing_yellow", "off"]

[[light]]
name = "green"
doc = "One green lamp."
bulbs = ["green"]
phases = ["green", "flashing_green", "off"]

[[light]]
name = "two_red"
doc = "Red lamps that flash in turn, as at level crossings."
bulbs = ["red"]
phases = ["flashing_red", "off"]
"##;
