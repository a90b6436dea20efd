//! The checked-in headers are what the sources yield.

#[path = "../examples/header/cpp.rs"]
mod cpp;
#[path = "../examples/header/text.rs"]
mod text;

const REMEDY: &str = "run `cargo run -p mapd-c --example header`";

#[test]
fn the_header_is_what_the_sources_yield() {
    let found = std::fs::read_to_string(text::path()).unwrap_or_default();
    assert!(found == text::header(), "{REMEDY}");
}

#[test]
fn the_wrappers_are_what_the_sources_yield() {
    let found = std::fs::read_to_string(cpp::path()).unwrap_or_default();
    assert!(cpp::header(text::SOURCES).is_ok_and(|header| header == found), "{REMEDY}");
}

#[test]
fn every_exception_of_the_wrappers_is_a_function() {
    let header = text::header();
    let named = cpp::NAMES.iter().map(|(c, ..)| *c);
    let exceptions = cpp::BY_HAND.iter().chain(cpp::EMPTY).map(|(c, _)| *c).chain(named);
    let gone: Vec<_> = exceptions.filter(|c| !header.contains(&format!("{c}("))).collect();
    assert!(gone.is_empty(), "{gone:?}");
}

/// Checks the lines that the generator writes for a function of C.
#[track_caller]
fn wraps(documentation: &str, parameters: &str, expected: &[&str]) {
    let source = format!(
        "//! Lanes.\n/// {documentation}\npub unsafe extern \"C\" fn mapd_lane_f({parameters}, error: *mut mapd_error) -> mapd_code {{ todo!() }}"
    );
    let written = cpp::classes(&[("lane", source)]).unwrap();
    let methods = written.lines().filter(|line| line.starts_with("  ") && !line.contains("//"));
    let methods: Vec<&str> = methods
        .map(str::trim)
        .filter(|line| *line != "using Owner::Owner;" && *line != "}")
        .collect();
    assert_eq!(methods, expected);
}

const LANE: &str = "snapshot: *const mapd_snapshot, lane: mapd_lane_id";

#[test]
fn a_value() {
    wraps(
        "The width.",
        &format!("{LANE}, s: f64, out: *mut f64"),
        &[
            "Result<double> try_f(LaneId lane, double s) const {",
            "return detail::value<double>([&](auto... rest) { return mapd_lane_f(get(), lane, s, rest...); });",
            "double f(LaneId lane, double s) const { return try_f(lane, s).value(); }",
        ],
    );
}

#[test]
fn a_value_or_none_and_options() {
    wraps(
        "The lane. `MAPD_CODE_NONE` if there is none.",
        "snapshot: *const mapd_snapshot, point: mapd_point, options: *const mapd_nearest_options, scratch: *mut mapd_scratch, out: *mut mapd_lane_id",
        &[
            "Result<std::optional<LaneId>> try_lane_f(Point point, Scratch& scratch, const NearestOptions& options = {}) const {",
            "const mapd_nearest_options own = options.c();",
            "return detail::optional<LaneId>([&](auto... rest) { return mapd_lane_f(get(), point, &own, scratch.get(), rest...); });",
            "std::optional<LaneId> lane_f(Point point, Scratch& scratch, const NearestOptions& options = {}) const { return try_lane_f(point, scratch, options).value(); }",
        ],
    );
}

#[test]
fn a_boolean() {
    wraps(
        "Whether it is so, 1 or 0.",
        &format!("{LANE}, forward: u8, out: *mut u8"),
        &[
            "Result<bool> try_f(LaneId lane, bool forward) const {",
            "return detail::boolean([&](auto... rest) { return mapd_lane_f(get(), lane, detail::to_byte(forward), rest...); });",
            "bool f(LaneId lane, bool forward) const { return try_f(lane, forward).value(); }",
        ],
    );
}

#[test]
fn a_text() {
    wraps(
        "The name.",
        &format!("{LANE}, out: *mut mapd_text"),
        &[
            "Result<std::string_view> try_f(LaneId lane) const {",
            "return detail::text([&](auto... rest) { return mapd_lane_f(get(), lane, rest...); });",
            "std::string_view f(LaneId lane) const { return try_f(lane).value(); }",
        ],
    );
}

#[test]
fn a_list() {
    wraps(
        "Lanes.",
        "snapshot: *const mapd_snapshot, steps: *const mapd_route_step, step_count: usize, out: *mut mapd_lane_id, capacity: usize, count: *mut usize",
        &[
            "Result<std::vector<LaneId>> try_lane_f(span<const RouteStep> steps) const {",
            "return detail::list<LaneId>([&](auto... rest) { return mapd_lane_f(get(), steps.data(), steps.size(), rest...); });",
            "Error try_lane_f(span<const RouteStep> steps, std::vector<LaneId>& out) const {",
            "return detail::list_into(out, [&](auto... rest) { return mapd_lane_f(get(), steps.data(), steps.size(), rest...); });",
            "std::vector<LaneId> lane_f(span<const RouteStep> steps) const { return try_lane_f(steps).value(); }",
            "void lane_f(span<const RouteStep> steps, std::vector<LaneId>& out) const { detail::must(try_lane_f(steps, out)); }",
        ],
    );
}

#[test]
fn a_list_or_none() {
    wraps(
        "Lanes. `MAPD_CODE_NONE` for a country without rules.",
        &format!(
            "{LANE}, country: *const c_char, out: *mut mapd_lane_id, capacity: usize, count: *mut usize"
        ),
        &[
            "Result<std::optional<std::vector<LaneId>>> try_f(LaneId lane, const std::string& country) const {",
            "return detail::optional_list<LaneId>([&](auto... rest) { return mapd_lane_f(get(), lane, country.c_str(), rest...); });",
            "std::optional<std::vector<LaneId>> f(LaneId lane, const std::string& country) const { return try_f(lane, country).value(); }",
        ],
    );
}

#[test]
fn a_batch() {
    wraps(
        "As one.",
        "path: *const mapd_path, points: *const mapd_vec2, count: usize, hint: *const f64, out: *mut mapd_path_position",
        &[
            "Error try_lane_f(span<const Vec2> points, span<PathPosition> out, std::optional<double> hint = std::nullopt) const {",
            "const double* begin = hint ? &*hint : nullptr;",
            "return detail::batch(points, out, [&](auto all, auto count, auto... rest) { return mapd_lane_f(get(), all, count, begin, rest...); });",
            "void lane_f(span<const Vec2> points, span<PathPosition> out, std::optional<double> hint = std::nullopt) const { detail::must(try_lane_f(points, out, hint)); }",
        ],
    );
}

#[test]
fn a_route_routes_and_what_is_reached() {
    let asked = "view: *const mapd_view, request: *const mapd_route_request";
    let list = "capacity: usize, count: *mut usize";
    let forms = [
        (
            "std::optional<Route>",
            "route<Route>",
            format!("sum: *mut mapd_route_sum, out: *mut mapd_route_step, {list}"),
        ),
        (
            "std::vector<Route>",
            "routes<Route>",
            format!(
                "sums: *mut mapd_route_sum, ends: *mut usize, {list}, out: *mut mapd_route_step, step_capacity: usize, step_count: *mut usize"
            ),
        ),
        (
            "Reach",
            "reach<Reach>",
            format!(
                "out: *mut mapd_reached_piece, {list}, links: *mut mapd_reach_link, link_capacity: usize, link_count: *mut usize"
            ),
        ),
        (
            "PathConflicts",
            "conflicts<PathConflicts>",
            format!(
                "out: *mut mapd_path_conflict, {list}, lanes: *mut mapd_conflict_lane, lane_capacity: usize, lane_count: *mut usize"
            ),
        ),
    ];
    for (result, ask, answers) in forms {
        wraps(
            "By request.",
            &format!("{asked}, {answers}"),
            &[
                &format!("Result<{result}> try_lane_f(const RouteRequest& request) const {{"),
                &format!(
                    "return detail::{ask}([&](auto... rest) {{ return mapd_lane_f(get(), &request, rest...); }});"
                ),
                &format!(
                    "{result} lane_f(const RouteRequest& request) const {{ return try_lane_f(request).value(); }}"
                ),
            ],
        );
    }
}

#[test]
fn a_place_of_a_view_is_one_argument() {
    wraps(
        "The limit.",
        "view: *const mapd_view, lane: mapd_lane_id, s: f64, path: *const mapd_path, out: *mut u8",
        &[
            "Result<std::uint8_t> try_f(PositionOnLane place, const PathQueries& path) const {",
            "return detail::value<std::uint8_t>([&](auto... rest) { return mapd_lane_f(get(), place.lane, place.s, path.get(), rest...); });",
            "std::uint8_t f(PositionOnLane place, const PathQueries& path) const { return try_f(place, path).value(); }",
        ],
    );
}

#[test]
fn an_unknown_shape_names_file_line_and_parameter() {
    let refused = |parameters: &str| {
        let source = format!(
            "//! Lanes.\n/// What.\npub unsafe extern \"C\" fn mapd_lane_f(\n{LANE},\n{parameters}, error: *mut mapd_error) -> mapd_code {{ todo!() }}"
        );
        cpp::classes(&[("lane", source)]).unwrap_err()
    };
    assert_eq!(refused("deep: *const *const f64"), "lane:5: deep of mapd_lane_f has no rule");
    assert_eq!(
        refused("out: *mut f64, other: *mut f64"),
        "lane:5: out, other, error of mapd_lane_f have no known shape"
    );
}

#[test]
fn every_function_of_the_sources_stands_in_the_header() {
    let header = text::header();
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut functions = 0;
    for file in std::fs::read_dir(folder).unwrap().flatten() {
        let source = std::fs::read_to_string(file.path()).unwrap();
        for line in source
            .lines()
            .filter(|line| line.starts_with("pub ") && line.contains("extern \"C\" fn "))
        {
            let name = line.split("fn ").nth(1).and_then(|rest| rest.split('(').next()).unwrap();
            assert!(header.contains(&format!("{name}(")), "{name} of {:?}", file.path());
            functions += 1;
        }
    }
    assert!(functions > 90, "{functions}");
}

/// A file of this crate.
fn read(name: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// C without its comments, word by word.
fn without_comments(text: &str) -> Vec<String> {
    let mut code = String::new();
    for (i, part) in text.split("/*").enumerate() {
        let after = if i == 0 { part } else { part.split_once("*/").unwrap().1 };
        code += after;
        code.push(' ');
    }
    let lines = code.lines().filter_map(|line| line.split("//").next());
    lines.flat_map(str::split_whitespace).map(str::to_owned).collect()
}

const ACCEPT: &str = "if that is meant: src/c/install PREFIX && src/c/abi PREFIX --write";

#[test]
fn the_accepted_header_is_this_one() {
    let (header, accepted) = (without_comments(&read("include/mapd.h")), read("abi.h"));
    let accepted: Vec<&str> = accepted.split_whitespace().collect();
    let other = header.iter().zip(&accepted).position(|(own, accepted)| own != accepted);
    let at = other.unwrap_or(header.len().min(accepted.len()));
    let of = |all: String| all.split(' ').skip(at).take(12).collect::<Vec<_>>().join(" ");
    let (own, old) = (of(header.join(" ")), of(accepted.join(" ")));
    assert!(header == accepted, "mapd.h has `{own}` where abi.h has `{old}`; {ACCEPT}");
}

#[test]
fn the_accepted_abi_has_the_headers_functions_and_structs() {
    let header = without_comments(&read("include/mapd.h"));
    let functions = header.iter().filter_map(|word| word.split_once('(')).map(|(name, _)| name);
    let mut expected: Vec<String> = functions
        .map(|name| name.trim_start_matches('*'))
        .filter(|name| name.starts_with("mapd_"))
        .map(str::to_owned)
        .collect();
    // Those with fields; handles have none.
    let structs = header.windows(4).filter(|words| words[..2] == ["typedef", "struct"]);
    expected.extend(
        structs.filter(|words| words[3] == "{").map(|words| format!("struct {}", words[2])),
    );
    expected.sort();
    let abi = read("abi.txt");
    let mut accepted: Vec<String> = abi
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| match line.strip_prefix("struct ") {
            Some(rest) => format!("struct {}", rest.split(' ').next().unwrap_or_default()),
            None => line.to_owned(),
        })
        .collect();
    accepted.sort();
    assert!(expected.len() > 300, "{}", expected.len());
    let lacks: Vec<_> = expected.iter().filter(|one| !accepted.contains(one)).collect();
    let has: Vec<_> = accepted.iter().filter(|one| !expected.contains(one)).collect();
    assert!(expected == accepted, "abi.txt lacks {lacks:?}, and has besides {has:?}; {ACCEPT}");
}
