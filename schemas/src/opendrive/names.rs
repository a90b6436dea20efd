//! Names in Rust from names in the standard.

/// The field of an attribute or child: `aU` → `a_u`, `CRG` → `crg`, `type` → `r#type`.
pub fn field(name: &str) -> String {
    let snake = snake(name);
    if matches!(snake.as_str(), "type") { format!("r#{snake}") } else { snake }
}

/// `paramPoly3` → `param_poly3`.
pub(crate) fn snake(name: &str) -> String {
    let mut out = String::new();
    let mut before_lower = false;
    for c in name.chars() {
        if c.is_ascii_uppercase() && before_lower {
            out.push('_');
        }
        before_lower = !c.is_ascii_uppercase();
        out.push(c.to_ascii_lowercase());
    }
    out
}

/// `LaneSection` → `LANE_SECTION`.
pub(crate) fn constant(name: &str) -> String {
    snake(name).to_ascii_uppercase()
}

/// `no passing` → `NoPassing`, `+` → `Plus`, `HOV` → `Hov`.
pub(crate) fn variant(word: &str) -> String {
    match word {
        "+" => return "Plus".to_owned(),
        "-" => return "Minus".to_owned(),
        "%" => return "Percent".to_owned(),
        "4way" => return "FourWay".to_owned(),
        "m/s" => return "MetersPerSecond".to_owned(),
        "km/h" => return "KilometersPerHour".to_owned(),
        "mph" => return "MilesPerHour".to_owned(),
        _ => {}
    }
    let mut out = String::new();
    let mut upper_next = true;
    let all_upper = word.chars().all(|c| c.is_ascii_uppercase());
    for c in word.chars() {
        if !c.is_ascii_alphanumeric() {
            upper_next = true;
        } else if upper_next {
            out.push(c.to_ascii_uppercase());
            upper_next = false;
        } else if all_upper {
            out.push(c.to_ascii_lowercase());
        } else {
            out.push(c);
        }
    }
    out
}
