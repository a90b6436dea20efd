//! Colours of the page: what has to be told apart differs for people who see all colours, and for those who lack one kind of cones.

/// Least difference of two colours that are to be told apart: CIEDE2000, in which 1 is just visible side by side.
const TOLD_APART: f64 = 8.0;

/// The page's colours: a line is `"name": ["#light", "#dark", opacity],`.
const COLORS: &str =
    include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../src/web/page/colors.js"));

/// Lanes over which the others are drawn.
const LANES: [&str; 11] = [
    "none",
    "driving",
    "bus",
    "biking",
    "walking",
    "parking",
    "edge",
    "median",
    "rail",
    "road works",
    "other lane",
];

/// What is selected: drawn over lanes and over what an overlay says.
const SELECTED: [&str; 4] = ["chosen", "next", "before", "other"];
/// What an overlay says.
const TODAY: [&str; 4] = ["closed", "opened", "slower", "told"];

/// How the cones' answers change, in linear RGB: all there, and without the long, the middle and the short ones (Machado, Oliveira and Fernandes 2009,
/// severity 1).
const SIGHTS: [(&str, [[f64; 3]; 3]); 4] = [
    ("all cones", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    (
        "protanopia",
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
    ),
    (
        "deuteranopia",
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
    ),
    (
        "tritanopia",
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ),
];

type Triple = [f64; 3];

/// Red, green and blue of a theme (0 light, 1 dark), and the opacity.
fn color(name: &str, theme: usize) -> (Triple, f64) {
    let line = format!("\"{name}\": [");
    let line = COLORS.lines().find_map(|one| one.trim().strip_prefix(&line));
    let line = line.unwrap_or_else(|| panic!("no colour {name}"));
    let parts: Vec<_> = line.trim_end_matches("],").split(", ").collect();
    let hex = parts[theme].trim_matches(['"', '#']);
    let rgb = [0, 2, 4].map(|at| f64::from(u8::from_str_radix(&hex[at..at + 2], 16).expect("hex")));
    (rgb.map(|value| value / 255.0), parts[2].parse().expect("an opacity"))
}

/// A colour as the page draws it over another one.
fn over((top, opacity): (Triple, f64), below: Triple) -> Triple {
    std::array::from_fn(|i| top[i] * opacity + below[i] * (1.0 - opacity))
}

/// A colour of a screen as it is seen, in CIELAB under D65.
fn lab(rgb: Triple, sight: &[[f64; 3]; 3]) -> Triple {
    let of = |matrix: &[[f64; 3]; 3], v: Triple| {
        matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    };
    let linear =
        rgb.map(|v| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) });
    let seen = of(sight, linear).map(|v| mapd_geometry::clamp(v, 0.0, 1.0));
    const XYZ: [[f64; 3]; 3] = [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ];
    let [x, y, z] = of(&XYZ, seen);
    let [x, y, z] = [x / 0.95047, y, z / 1.08883].map(|t: f64| {
        if t > 216.0 / 24389.0 { t.cbrt() } else { (24389.0 / 27.0 * t + 16.0) / 116.0 }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// CIEDE2000.
fn difference([l1, a1, b1]: Triple, [l2, a2, b2]: Triple) -> f64 {
    let seventh = |c: f64| (c.powi(7) / (c.powi(7) + 25f64.powi(7))).sqrt();
    let wide = 1.0 + 0.5 * (1.0 - seventh((a1.hypot(b1) + a2.hypot(b2)) / 2.0));
    let (a1, a2) = (a1 * wide, a2 * wide);
    let (c1, c2) = (a1.hypot(b1), a2.hypot(b2));
    let hue = |a: f64, b: f64| b.atan2(a).to_degrees().rem_euclid(360.0);
    let (h1, h2) = (hue(a1, b1), hue(a2, b2));
    let apart = match h2 - h1 {
        _ if c1 * c2 == 0.0 => 0.0,
        d if d > 180.0 => d - 360.0,
        d if d < -180.0 => d + 360.0,
        d => d,
    };
    let middle = match h1 + h2 {
        sum if c1 * c2 == 0.0 => sum,
        sum if (h1 - h2).abs() <= 180.0 => sum / 2.0,
        sum if sum < 360.0 => (sum + 360.0) / 2.0,
        sum => (sum - 360.0) / 2.0,
    };
    let (light, chroma) = ((l1 + l2) / 2.0 - 50.0, (c1 + c2) / 2.0);
    let cosine = |factor: f64, shift: f64| (factor * middle + shift).to_radians().cos();
    let turn = 1.0 - 0.17 * cosine(1.0, -30.0) + 0.24 * cosine(2.0, 0.0) + 0.32 * cosine(3.0, 6.0)
        - 0.2 * cosine(4.0, -63.0);
    let l = (l2 - l1) / (1.0 + 0.015 * light.powi(2) / (20.0 + light.powi(2)).sqrt());
    let c = (c2 - c1) / (1.0 + 0.045 * chroma);
    let h =
        2.0 * (c1 * c2).sqrt() * (apart / 2.0).to_radians().sin() / (1.0 + 0.015 * chroma * turn);
    let twist = 60.0 * (-((middle - 275.0) / 25.0).powi(2)).exp();
    let both = -twist.to_radians().sin() * 2.0 * seventh(chroma);
    (l * l + c * c + h * h + both * c * h).sqrt()
}

/// Pairs of the data that Sharma, Wu and Dalal (2005) publish for implementers.
#[test]
fn differences_are_those_of_the_published_pairs() {
    for (one, other, expected) in [
        ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
        ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
        ([50.0, 2.5, 0.0], [50.0, 0.0, -2.5], 4.3065),
        ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
        ([2.0776, 0.0795, -1.1350], [0.9033, -0.0636, -0.5514], 0.9082),
    ] {
        let found = difference(one, other);
        assert!((found - expected).abs() < 5e-5, "{one:?} {other:?}: {found}, not {expected}");
    }
}

/// Names with the colours that they have over all that they are drawn over, lanes themselves among them.
fn appearances(theme: usize) -> Vec<(&'static str, Triple)> {
    let plain = |name: &'static str| (name, color(name, theme).0);
    let lanes = LANES.map(plain);
    let over_all = |name: &'static str, below: &[(&str, Triple)]| {
        let top = color(name, theme);
        below.iter().map(|(_, below)| (name, over(top, *below))).collect::<Vec<_>>()
    };
    let of_overlay: Vec<_> = TODAY.iter().flat_map(|name| over_all(name, &lanes)).collect();
    let below: Vec<_> = lanes.iter().chain(&of_overlay).copied().collect();
    let selected = SELECTED.iter().flat_map(|name| over_all(name, &below));
    let mut all: Vec<_> = selected.chain(over_all("route", &below)).collect();
    all.extend(below);
    // An opaque colour is the same over everything.
    all.sort_by(|a, b| a.0.cmp(b.0).then(a.1.partial_cmp(&b.1).expect("numbers")));
    all.dedup();
    all
}

#[test]
fn what_must_be_told_apart_is_without_seeing_all_colours() {
    let mut bad = Vec::new();
    for (theme, (sight, matrix)) in
        [0, 1].into_iter().flat_map(|theme| SIGHTS.map(|one| (theme, one)))
    {
        let seen: Vec<_> =
            appearances(theme).into_iter().map(|(name, rgb)| (name, lab(rgb, &matrix))).collect();
        for (i, (one, first)) in seen.iter().enumerate() {
            // Lanes differ from each other in lightness, and have names in the legend: they are not held to this.
            let others = seen[i + 1..].iter().filter(|(other, _)| {
                other != one && !(LANES.contains(one) && LANES.contains(other))
            });
            for (other, second) in others {
                let found = difference(*first, *second);
                if found < TOLD_APART {
                    bad.push(format!("{sight}, theme {theme}: {one} and {other}: {found:.1}"));
                }
            }
        }
    }
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

#[test]
fn a_drawing_has_the_colours_of_the_light_page() {
    let sheet =
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../src/export/src/svg/style.rs"));
    for name in TODAY {
        let rgb = color(name, 0).0.map(|value| format!("{:02x}", (value * 255.0).round() as u8));
        let rule = format!(".{name}{{fill:#{}}}", rgb.concat());
        assert!(sheet.contains(&rule), "{rule}");
    }
}
