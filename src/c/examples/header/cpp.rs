//! Writes the C++ wrappers of the C functions: one method for each function that asks a handle something. The shape of its parameters decides the method.
//!
//! Signature and documentation of a method come from the Rust function. A function of an unknown shape is an error that names file, line and parameter.

use quote::ToTokens as _;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use syn::spanned::Spanned as _;

/// The handles that become classes: the C type, the class, the prefixes that a method's name drops, and the documentation of the class.
const CLASSES: [(&str, &str, &[&str], &str); 4] = [
    ("mapd_projector", "Projector", &[], "Converts between a map's inertial frame and WGS 84."),
    ("mapd_path", "PathQueries", &["path_"], "What a path is asked: see `Path`."),
    ("mapd_snapshot", "Queries", &["snapshot_"], "What a snapshot is asked: see `Snapshot`."),
    ("mapd_view", "ViewQueries", &["view_"], "What a view is asked: see `View`."),
];

/// Functions whose wrapper is written by hand, each with the reason. Those that make a handle are, too: the handle's class comes later.
pub(crate) const BY_HAND: &[(&str, &str)] = &[
    ("mapd_snapshot_verify", "has no answer"),
    ("mapd_snapshot_populate", "has no answer"),
    ("mapd_lane_key", "writes characters"),
    ("mapd_covers", "a negative tolerance stands for none"),
    ("mapd_stance_at", "takes four wheels"),
    ("mapd_match_pose", "answers a list and a number"),
    ("mapd_match_pose_batch", "answers three lists"),
    ("mapd_view_match_pose", "answers a list and a number"),
    ("mapd_path_rebase", "answers two lists of their own lengths"),
];

/// Methods whose name does not follow the rules of [`method`], each with the reason.
pub(crate) const NAMES: &[(&str, &str, &str)] = &[
    ("mapd_map_facts_of", "facts", "the map is the receiver"),
    ("mapd_map_geodetic_bounds", "geodetic_bounds", "the map is the receiver"),
    ("mapd_next_junction_of", "next_junction", "C has a struct of that name"),
    ("mapd_nearest_lane_batch", "nearest_lanes", "the plural of nearest_lane"),
    ("mapd_nearest_mark_batch", "nearest_marks", "the plural of nearest_mark"),
    ("mapd_ground_at_batch", "ground_below", "as in Rust"),
    ("mapd_road_name_id", "road_name_id", "an id of what would not be said"),
    ("mapd_signal_links", "signal_links", "links of what would not be said"),
    ("mapd_signal_movements", "signal_movements", "movements of what would not be said"),
    ("mapd_conflict_approaches", "approaches", "the conflict's lanes are the argument"),
    (
        "mapd_view_signal_out_of_service",
        "signal_out_of_service",
        "what is out of service would not be said",
    ),
    ("mapd_lane_lines", "lane_lines", "beside line, which is another thing"),
];

/// Functions that answer `MAPD_CODE_NONE` where C++ returns an empty list, each with the reason.
pub(crate) const EMPTY: &[(&str, &str)] =
    &[("mapd_road_section_lanes", "a section that the road does not have has no lanes")];

/// Parameters of type `u8` that are booleans. All others are codes.
const BOOLEANS: [&str; 4] = ["forward", "to", "ahead", "has_altitude"];

/// Types whose name in C++ does not follow from theirs in C.
const TYPES: [(&str, &str); 9] = [
    ("mapd_lane_line_at", "LaneLine"),
    ("mapd_text", "std::string_view"),
    ("f64", "double"),
    ("u8", "std::uint8_t"),
    ("u16", "std::uint16_t"),
    ("u32", "std::uint32_t"),
    ("u64", "std::uint64_t"),
    ("i32", "std::int32_t"),
    ("usize", "std::size_t"),
];

/// How C passes a parameter: by value, as `*const T`, as `*mut T`.
#[derive(Clone, PartialEq)]
enum Kind {
    Value(String),
    In(String),
    Out(String),
}

struct Parameter {
    name: String,
    kind: Kind,
    place: String,
}

/// A function of C.
struct Function {
    name: String,
    sentence: String,
    /// Whether the documentation names `MAPD_CODE_NONE`.
    may_be_none: bool,
    /// Whether the body answers it.
    answers_none: bool,
    parameters: Vec<Parameter>,
    place: String,
}

/// An argument of a method. `default` is empty for a required one.
struct Argument {
    declared: String,
    name: String,
    default: &'static str,
}

/// How a function answers.
enum Shape {
    Value(String),
    List(String),
    Batch(String),
    Route,
    Routes,
    Reach,
    Conflicts,
}

/// Where the header lies.
pub(crate) fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("include/mapd/queries.hpp")
}

/// The name of a C type in C++.
fn type_name(of: &str) -> String {
    if let Some((_, other)) = TYPES.iter().find(|(c, _)| *c == of) {
        return (*other).to_owned();
    }
    let words = of.strip_prefix("mapd_").unwrap_or(of).split('_');
    words.map(|word| word[..1].to_uppercase() + &word[1..]).collect()
}

/// Returns the first paragraph without sentences about C alone, and whether the documentation names `MAPD_CODE_NONE`.
fn documented(attributes: &[syn::Attribute]) -> (String, bool) {
    let mut text = String::new();
    for attribute in attributes.iter().filter(|one| one.path().is_ident("doc")) {
        if let syn::Meta::NameValue(syn::MetaNameValue {
            value: syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(line), .. }),
            ..
        }) = &attribute.meta
        {
            text += &line.value();
            text.push('\n');
        }
    }
    let text = text.replace("\\[", "[").replace("\\]", "]");
    let first = text.split("\n\n").next().unwrap_or_default().replace('\n', " ");
    let of_c = |sentence: &&str| {
        !["MAPD_CODE_", " null", "may be NULL"].iter().any(|word| sentence.contains(word))
    };
    let sentences: Vec<&str> =
        first.trim().trim_end_matches('.').split(". ").map(str::trim).filter(of_c).collect();
    (sentences.join(". ") + ".", text.contains("MAPD_CODE_NONE"))
}

fn is_by_hand(function: &Function) -> bool {
    let makes = |one: &Parameter| matches!(&one.kind, Kind::Out(to) if to.starts_with("*mut"));
    function.parameters.iter().any(makes) || BY_HAND.iter().any(|(c, _)| *c == function.name)
}

/// The functions of a source, in its order.
fn functions(file: &str, source: &str) -> Result<Vec<Function>, String> {
    let parsed = syn::parse_file(source).map_err(|error| format!("{file}: {error}"))?;
    let mut all = Vec::new();
    for item in parsed.items {
        let syn::Item::Fn(function) = item else { continue };
        if function.sig.abi.is_none() {
            continue;
        }
        let place = |span: proc_macro2::Span| format!("{file}:{}", span.start().line);
        let (sentence, may_be_none) = documented(&function.attrs);
        let mut parameters = Vec::new();
        for input in &function.sig.inputs {
            let syn::FnArg::Typed(syn::PatType { pat, ty, .. }) = input else { continue };
            let words = |ty: &syn::Type| ty.to_token_stream().to_string().replace(' ', "");
            let kind = match &**ty {
                syn::Type::Ptr(to) if to.mutability.is_some() => Kind::Out(words(&to.elem)),
                syn::Type::Ptr(to) => Kind::In(words(&to.elem)),
                other => Kind::Value(words(other)),
            };
            let name = pat.to_token_stream().to_string();
            parameters.push(Parameter { name, kind, place: place(input.span()) });
        }
        let name = function.sig.ident.to_string();
        let body = function.block.to_token_stream().to_string();
        let answers_none =
            ["put_some", "put_found", "mapd_code :: NONE"].iter().any(|word| body.contains(word));
        let place = place(function.sig.span());
        all.push(Function { name, sentence, may_be_none, answers_none, parameters, place });
    }
    Ok(all)
}

/// Returns the method's name. It drops the receiver's prefix, and the first argument's noun unless another function has the shorter name.
fn method(function: &Function, words: &[&str], all: &[String]) -> String {
    if let Some((_, name, _)) = NAMES.iter().find(|(c, ..)| *c == function.name) {
        return (*name).to_owned();
    }
    let mut name = function.name.trim_start_matches("mapd_");
    name = name.strip_suffix("_batch").unwrap_or(name);
    for word in words {
        name = name.strip_prefix(word).unwrap_or(name);
    }
    if let Some(noun) = name.strip_suffix("_facts_of") {
        return noun.to_owned();
    }
    let Some(Kind::Value(first)) = function.parameters.get(1).map(|one| &one.kind) else {
        return name.to_owned();
    };
    let noun = first.trim_start_matches("mapd_").trim_end_matches("id");
    let rest = name.strip_prefix(noun).filter(|_| first.ends_with("_id"));
    let Some(rest) = rest else { return name.to_owned() };
    let used = |other: String| other != function.name && all.contains(&other);
    if used(format!("mapd_{rest}")) || noun != "lane_" && used(format!("mapd_lane_{rest}")) {
        return name.to_owned();
    }
    rest.to_owned()
}

/// The arguments of a method, what it passes to C, the lines before that call, and how C answers.
struct Signature {
    arguments: Vec<Argument>,
    passed: Vec<String>,
    before: String,
    shape: Shape,
}

/// Reads the parameters between the receiver and the error. Errors: a parameter or a shape without a rule.
fn signature(function: &Function, class: &str) -> Result<Signature, String> {
    let all = &function.parameters[1..];
    let mut signature = Signature {
        arguments: Vec::new(),
        passed: vec!["get()".to_owned()],
        before: String::new(),
        shape: Shape::Value(String::new()),
    };
    let mut at = 0;
    let is = |i: usize, name: &str| all.get(i).is_some_and(|one| one.name == name);
    while let Some(one) = all.get(at) {
        let name = one.name.clone();
        let mut add = |declared: String, passed: String, default: &'static str| {
            let name = declared.rsplit(['&', '*', ' ']).next().unwrap_or_default().to_owned();
            signature.arguments.push(Argument { declared, name, default });
            signature.passed.push(passed);
        };
        match &one.kind {
            Kind::Out(of) if of == "mapd_scratch" => {
                add("Scratch& scratch".into(), "scratch.get()".into(), "");
            }
            Kind::Out(_) => break,
            Kind::Value(of) if of == "mapd_lane_id" && is(at + 1, "s") && class != "Queries" => {
                add("PositionOnLane place".into(), "place.lane, place.s".into(), "");
                at += 1;
            }
            Kind::Value(of) if of == "u8" && BOOLEANS.contains(&&*name) => {
                add(format!("bool {name}"), format!("detail::to_byte({name})"), "");
            }
            Kind::Value(of) => add(format!("{} {name}", type_name(of)), name.clone(), ""),
            Kind::In(of) if of == "c_char" => {
                add(format!("const std::string& {name}"), format!("{name}.c_str()"), "");
            }
            Kind::In(of) if matches!(&**of, "mapd_path" | "mapd_projector") => {
                let class =
                    CLASSES.iter().find(|(c, ..)| c == of).map_or("", |(_, class, ..)| class);
                add(format!("const {class}& {name}"), format!("{name}.get()"), "");
            }
            Kind::In(of) if of == "mapd_nearest_options" => {
                add(format!("const NearestOptions& {name}"), "&own".into(), "{}");
                signature.before = format!("    const mapd_nearest_options own = {name}.c();\n");
            }
            Kind::In(of) if of.ends_with("_options") || of == "mapd_mark_filter" => {
                add(format!("const {}& {name}", type_name(of)), format!("&{name}"), "{}");
            }
            // Null stands for the default classes.
            Kind::In(of) if of == "mapd_class_set" => {
                add(format!("const ClassSet* {name}"), name.clone(), "");
            }
            // The questions of a batch.
            Kind::In(of) if is(at + 1, "count") => {
                signature.shape = Shape::Batch(name.clone());
                let of = if of == "mapd_point" { of.clone() } else { type_name(of) };
                add(format!("span<const {of}> {name}"), "all, count".into(), "");
                at += 1;
            }
            Kind::In(of) if all.get(at + 1).is_some_and(|next| next.name.ends_with("_count")) => {
                let default = if name == "expected" { "{}" } else { "" };
                let passed = format!("{name}.data(), {name}.size()");
                add(format!("span<const {}> {name}", type_name(of)), passed, default);
                at += 1;
            }
            Kind::In(of) if of == "f64" && name == "hint" => {
                add(format!("std::optional<double> {name}"), "begin".into(), "std::nullopt");
                signature.before =
                    format!("    const double* begin = {name} ? &*{name} : nullptr;\n");
            }
            Kind::In(of) if of.starts_with("mapd_") => {
                add(format!("const {}& {name}", type_name(of)), format!("&{name}"), "");
            }
            Kind::In(_) => {
                return Err(format!("{}: {} of {} has no rule", one.place, name, function.name));
            }
        }
        at += 1;
    }
    let names: Vec<&str> = all[at..].iter().map(|one| &*one.name).collect();
    let of = |i: usize| match all.get(at + i).map(|one| &one.kind) {
        Some(Kind::Out(of)) if !of.starts_with("*mut") => Some(type_name(of)),
        _ => None,
    };
    let is_batch = matches!(signature.shape, Shape::Batch(_));
    signature.shape = match (&*names, of(0), of(1)) {
        ([_, "error"], Some(answer), _) if is_batch => {
            let Shape::Batch(questions) = signature.shape else { unreachable!("just matched") };
            let to = Argument {
                declared: format!("span<{answer}> out"),
                name: "out".into(),
                default: "",
            };
            let after = signature.arguments.iter().position(|one| one.name == questions);
            signature.arguments.insert(after.map_or(0, |at| at + 1), to);
            Shape::Batch(questions)
        }
        ([_, "error"], Some(answer), _) => Shape::Value(answer),
        ([_, "capacity", "count", "error"], Some(entry), _) => Shape::List(entry),
        (["sum", "out", "capacity", "count", "error"], ..) => Shape::Route,
        (["sums", "ends", "capacity", "count", "out", _, "step_count", "error"], ..) => {
            Shape::Routes
        }
        ([_, "capacity", "count", "links", _, "link_count", "error"], ..) => Shape::Reach,
        ([_, "capacity", "count", "lanes", _, "lane_count", "error"], ..) => Shape::Conflicts,
        _ => {
            let first = all.get(at).map_or(&function.place, |one| &one.place);
            let (name, list) = (&function.name, names.join(", "));
            return Err(format!("{first}: {list} of {name} have no known shape"));
        }
    };
    // C++ wants arguments with a default last.
    signature.arguments.sort_by_key(|one| !one.default.is_empty());
    Ok(signature)
}

/// Wraps a documentation comment at 160 columns.
fn documentation(text: &str) -> String {
    let mut out = String::new();
    for word in text.split_whitespace() {
        let column = out.len() - out.rfind('\n').map_or(0, |at| at + 1);
        if out.is_empty() || column + word.len() >= 160 {
            out += if out.is_empty() { "  ///" } else { "\n  ///" };
        }
        out.push(' ');
        out += word;
    }
    out.push('\n');
    out
}

/// Returns two texts: the methods that return an error, and those that throw it.
fn methods(function: &Function, class: &str, name: &str) -> Result<(String, String), String> {
    let Signature { arguments, passed, before, shape } = signature(function, class)?;
    let passed = passed.join(", ");
    let (c, sentence) = (&function.name, &function.sentence);
    // The caller's list stands between required arguments and those with a default.
    let split = arguments.iter().position(|one| !one.default.is_empty()).unwrap_or(arguments.len());
    let joined = |extra: Option<&str>, of: &dyn Fn(&Argument) -> String| {
        let mut all: Vec<String> = arguments.iter().map(of).collect();
        all.splice(split..split, extra.map(str::to_owned));
        all.join(", ")
    };
    let declare = |extra: Option<&str>| {
        joined(extra, &|Argument { declared, default, .. }| match *default {
            "" => declared.clone(),
            default => format!("{declared} = {default}"),
        })
    };
    let named = |extra: Option<&str>| joined(extra, &|one| one.name.clone());
    let answers_bool = sentence.starts_with("Whether ");
    let none = function.may_be_none;
    if function.answers_none && !none && matches!(shape, Shape::Value(_) | Shape::List(_)) {
        return Err(format!(
            "{}: {c} may answer MAPD_CODE_NONE and does not say so",
            function.place
        ));
    }
    let (result, ask) = match &shape {
        Shape::Value(of) if of == "std::string_view" && none => {
            (format!("std::optional<{of}>"), "optional_text".to_owned())
        }
        Shape::Value(of) if of == "std::string_view" => (of.clone(), "text".to_owned()),
        Shape::Value(of) if of == "std::uint8_t" && answers_bool => {
            ("bool".to_owned(), "boolean".to_owned())
        }
        Shape::Value(of) if none => (format!("std::optional<{of}>"), format!("optional<{of}>")),
        Shape::Value(of) => (of.clone(), format!("value<{of}>")),
        Shape::List(of) if none && !EMPTY.iter().any(|(name, _)| name == c) => {
            (format!("std::optional<std::vector<{of}>>"), format!("optional_list<{of}>"))
        }
        Shape::List(of) => (format!("std::vector<{of}>"), format!("list<{of}>")),
        Shape::Route => ("std::optional<Route>".to_owned(), "route<Route>".to_owned()),
        Shape::Routes => ("std::vector<Route>".to_owned(), "routes<Route>".to_owned()),
        Shape::Reach => ("Reach".to_owned(), "reach<Reach>".to_owned()),
        Shape::Conflicts => ("PathConflicts".to_owned(), "conflicts<PathConflicts>".to_owned()),
        Shape::Batch(_) => (String::new(), "batch".to_owned()),
    };
    let (mut tries, mut throws) = (documentation(sentence), String::new());
    if let Shape::Batch(questions) = &shape {
        let _ = write!(
            tries,
            "  Error try_{name}({}) const {{\n{before}    return detail::batch({questions}, out, [&](auto all, auto count, auto... rest) {{ return {c}({passed}, rest...); }});\n  }}\n",
            declare(None)
        );
        let _ = writeln!(
            throws,
            "  void {name}({}) const {{ detail::must(try_{name}({})); }}",
            declare(None),
            named(None)
        );
        return Ok((tries, throws));
    }
    let call = format!("[&](auto... rest) {{ return {c}({passed}, rest...); }}");
    let _ = write!(
        tries,
        "  Result<{result}> try_{name}({}) const {{\n{before}    return detail::{ask}({call});\n  }}\n",
        declare(None)
    );
    let _ = writeln!(
        throws,
        "  {result} {name}({}) const {{ return try_{name}({}).value(); }}",
        declare(None),
        named(None)
    );
    if let (Shape::List(of), true) = (&shape, ask.starts_with("list<")) {
        let out = format!("std::vector<{of}>& out");
        let _ = write!(
            tries,
            "  Error try_{name}({}) const {{\n{before}    return detail::list_into(out, {call});\n  }}\n",
            declare(Some(&out))
        );
        let _ = writeln!(
            throws,
            "  void {name}({}) const {{ detail::must(try_{name}({})); }}",
            declare(Some(&out)),
            named(Some("out"))
        );
    }
    Ok((tries, throws))
}

/// Returns the classes for these sources, given as name and text.
pub(crate) fn classes(sources: &[(&str, String)]) -> Result<String, String> {
    let mut all = Vec::new();
    for (file, source) in sources {
        let title = source.lines().next().unwrap_or_default().trim_start_matches("//! ").to_owned();
        all.push((title, functions(file, source)?));
    }
    let names: Vec<String> =
        all.iter().flat_map(|(_, list)| list.iter().map(|one| one.name.clone())).collect();
    let mut out = String::new();
    for (handle, class, words, what) in CLASSES {
        let mut text = String::new();
        for (title, list) in &all {
            let (mut tries, mut throws) = (Vec::new(), String::new());
            for function in list {
                let receives = function.parameters.first().map(|one| &one.kind);
                let is_asked = receives == Some(&Kind::In(handle.into()));
                if !is_asked || is_by_hand(function) {
                    continue;
                }
                let (one, other) = methods(function, class, &method(function, words, &names))?;
                tries.push(one);
                throws += &other;
            }
            if !tries.is_empty() {
                let tries = tries.join("\n");
                let _ = write!(
                    text,
                    "\n  // {title}\n\n{tries}\n#if MAPD_EXCEPTIONS\n{throws}#endif\n"
                );
            }
        }
        if !text.is_empty() {
            let close = format!("{handle}_close");
            let _ = write!(
                out,
                "\n/// {what}\nclass {class} : public detail::Owner<{handle}, {close}> {{\n public:\n  using Owner::Owner;\n{text}}};\n"
            );
        }
    }
    Ok(out)
}

/// The header.
pub(crate) fn header(sources: &[&str]) -> Result<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut read = Vec::new();
    for source in sources {
        let path = folder.join(source).with_extension("rs");
        let text = std::fs::read_to_string(&path).map_err(|error| format!("{source}: {error}"))?;
        read.push((*source, text));
    }
    let classes = classes(&read)?;
    Ok(format!(
        "/// What handles are asked, a method for each function of C; `mapd.h` documents units, signs and errors of each. Made from the sources of the\n/// crate mapd-c by `cargo run -p mapd-c --example header`.\n#pragma once\n\n#include \"base.hpp\"\n\nnamespace mapd {{\n{classes}\n}}  // namespace mapd\n"
    ))
}
