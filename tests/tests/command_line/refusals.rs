//! What is wrong in options and input is refused where it is, not dropped.

use mapd_tests::command;
use std::ffi::OsStr;
use std::io::Write as _;
use std::os::unix::ffi::OsStrExt as _;
use std::process::{Command, Output, Stdio};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// Runs a command that is wrong in itself, and checks what it answers before and what it says.
fn refuses(args: &[&str], input: impl AsRef<[u8]>, answers: usize, said: &str) {
    let output = command::run(MAPD, args, input);
    let errors = errors(&output);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {errors}");
    assert!(errors.contains(said), "{args:?}: {errors}");
    let lines = output.stdout.iter().filter(|byte| **byte == b'\n').count();
    assert_eq!(lines, answers, "{args:?}: {}", String::from_utf8_lossy(&output.stdout));
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// They were dropped in silence.
#[test]
fn options_that_do_not_fit_the_format() {
    let map = town();
    for (format, option, formats) in [
        ("html", &["--report", "report.csv"][..], "lanelet2"),
        ("svg", &["--layers", "lanes"], "geojson or flatgeobuf"),
        ("flatgeobuf", &["--index-boxes"], "svg"),
        ("html", &["--route", "1,38,-1:3,30,-1"], "svg"),
        ("flatgeobuf", &["--origin", "48,11"], "geojson or lanelet2"),
        ("svg", &["--origin", "48,11"], "geojson or lanelet2"),
        ("geojson", &["--autoware"], "lanelet2"),
    ] {
        let args = [&["export", &map, "--format", format], option].concat();
        refuses(
            &args,
            "",
            0,
            &format!("{} goes with --format {formats}, not with {format}", option[0]),
        );
    }
}

/// They were dropped in silence, but for --overlay.
#[test]
fn options_that_the_kind_does_not_heed() {
    let map = town();
    let along = ["route", "path", "corridor", "project", "conflicts"];
    let traffic = [&along[..], &["speed", "signals"]].concat();
    let with_vehicle = [&traffic[..], &["nearest", "match"]].concat();
    let program = mapd::cli::command();
    let query = program.find_subcommand("query").expect("a command");
    let kinds = query.get_arguments().find(|arg| arg.get_id() == "kind").expect("an argument");
    let kinds = kinds.get_possible_values();
    for (option, value, heeding) in [
        ("--radius", Some("10"), &["nearest", "nearest-marks"][..]),
        ("--types", Some("drivable"), &["nearest", "match", "nearest-marks"]),
        ("--z-tolerance", Some("1"), &["nearest", "match"]),
        ("--heading-tolerance", Some("1"), &["nearest"]),
        ("--outline", Some("1,1,1,1"), &["match"]),
        ("--by", Some("length"), &along),
        ("--alternatives", Some("1"), &["route"]),
        ("--avoid", Some("1:0:-1"), &along),
        ("--lane-change", Some("20"), &along),
        ("--vehicle", Some("passengerCar"), &with_vehicle),
        ("--overlay", None, &traffic),
        ("--rules", Some("DE"), &["conflicts"]),
        ("--step", Some("1"), &["path", "corridor"]),
    ] {
        let args =
            |kind| ["query", &map, kind, option].into_iter().chain(value).collect::<Vec<_>>();
        let others =
            kinds.iter().map(|kind| kind.get_name()).filter(|kind| !heeding.contains(kind));
        for kind in others {
            refuses(&args(kind), "", 0, &format!("{kind} does not heed {option}"));
        }
        // Who heeds it gets as far as what else is wrong.
        let said = if option == "--overlay" { "shm:NAME" } else { "needs the columns" };
        refuses(&args(heeding[0]), "", 0, said);
    }
}

/// A prefix that cannot be one kept commands from files, for which it means nothing.
#[test]
fn a_prefix_is_for_live_maps() {
    let map = town();
    let ends = |args: &[&str]| {
        let output = Command::new(MAPD).env("MAPD_PREFIX", "no/prefix").args(args).output();
        let output = output.expect("ends");
        (output.status.code(), errors(&output))
    };
    assert_eq!(ends(&["inspect", &map]).0, Some(0));
    assert_eq!(ends(&["export", &map, "--format", "svg", "-o", "/dev/null"]).0, Some(0));
    assert_eq!(ends(&["bench", &map, "--clients", "1"]).0, Some(0));
    let (code, said) = ends(&["inspect", "shm:town"]);
    assert!(code == Some(2) && said.contains("no/prefix"), "{said}");
}

/// All rows behind it were taken for its text, with exit code 0.
#[test]
fn a_quote_that_is_not_closed() {
    let map = town();
    let said = "line 3: a quote opens that is not closed";
    let rows = "x,y,name\n50,-1.75,a\n60,-1.75,\"open\n70,-1.75,b\n";
    refuses(&["query", &map, "nearest"], rows, 2, said);
    let trace = "time,x,y,name\n0,50,-1.75,\"a\nb\"\n1,60,-1.75,\"open\n2,70,-1.75,c\n";
    refuses(&["match", &map], trace, 0, "line 4: a quote opens that is not closed");
    // Quotes inside of fields, doubled ones and line ends between them are text.
    let rows = "\u{feff}\"x\",y,name\n50,-1.75,\"a \"\"b\"\"\nc\"\n60,-1.75,5\" pipe\n";
    let output = command::run(MAPD, &["query", &map, "nearest"], rows);
    assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
}

/// Of all that can be wrong in CSV, this alone ended as if a file could not be read.
#[test]
fn csv_that_is_not_utf_8() {
    let map = town();
    for (kind, input, answers) in [
        ("query", &b"x,y,name\n50,-1.75,a\n60,-1.75,\xff\n70,-1.75,b\n"[..], 2),
        ("query", b"x,y,\xff\n50,-1.75,a\n", 0),
        ("match", b"time,x,y,name\n0,50,-1.75,a\n1,60,-1.75,\xe9\n", 0),
        ("match", b"time,x,y,\xe9\n", 0),
    ] {
        let args = [&[kind, &map][..], if kind == "query" { &["nearest"] } else { &[] }].concat();
        refuses(&args, input, answers, "invalid UTF-8");
    }
}

/// Time grew by the square of a number's length, and memory without bound.
#[test]
fn a_row_that_is_too_long() {
    let map = town();
    let long = "1".repeat(1 << 20);
    let rows = format!("x,y\n50,-1.75\n{long},0\n60,-1.75\n");
    refuses(&["query", &map, "nearest"], &rows, 2, "line 3: the row is longer than 1048576 bytes");
    refuses(&["query", &map, "nearest"], &long, 0, "");
    let trace = format!("time,x,y\n0,{long},0\n");
    refuses(&["match", &map], &trace, 0, "line 2: the row is longer than 1048576 bytes");
}

/// What no place and no distance can be is an error in its row.
#[test]
fn numbers_that_mean_nothing() {
    let map = town();
    for (kind, rows, said) in [
        ("signals", "road_id,s,lane_id,distance\n1,0,-1,-5\n", "distance must not be negative"),
        ("surface", "road_id,s,t\n1,5,1e308\n", "not finite numbers of at most 1e9"),
        (
            "match",
            "x,y,hdg,sx,sy,shdg\n50,-1.75,1e300,1,1,1\n",
            "heading of the pose is not a finite number of at most 1e9",
        ),
    ] {
        let output = command::run(MAPD, &["query", &map, kind], rows);
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(text.lines().nth(1).is_some_and(|row| row.contains(said)), "{kind}: {text}");
    }
}

/// Who reads no further wants no more, and no message.
#[test]
fn a_reader_who_has_gone() {
    let map = town();
    let rows = "x,y\n".to_owned() + &"50,-1.75\n".repeat(20_000);
    let folder = tempfile::tempdir().expect("a folder");
    let input = folder.path().join("rows.csv");
    std::fs::write(&input, rows).expect("written");
    for args in [
        &["query", &map, "nearest"][..],
        &["query", &map, "nearest", "--json"],
        &["check", &map, "--json"],
        &["export", &map, "--format", "svg"],
    ] {
        let mut command = Command::new(MAPD);
        command.args(args).stdin(std::fs::File::open(&input).expect("opens"));
        let mut child =
            command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("starts");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("ends");
        assert_eq!((output.status.code(), errors(&output)), (Some(0), String::new()), "{args:?}");
    }
}

/// A name need not be UTF-8, as none of `compile` has to be: these were refused before they were looked for.
#[test]
fn files_of_any_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let named = |bytes: &[u8]| folder.path().join(OsStr::from_bytes(bytes));
    let (written, archive) = (named(b"to\xffwn.xodr"), named(b"to\xffwn.mapd"));
    std::fs::copy(town(), &written).expect("copied");
    let ask = |args: &[&OsStr], input: &str| {
        let mut command = Command::new(MAPD);
        command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("starts");
        let _ = child.stdin.take().expect("stdin").write_all(input.as_bytes());
        child.wait_with_output().expect("ends")
    };
    let compile = [OsStr::new("compile"), written.as_os_str(), "-o".as_ref(), archive.as_ref()];
    assert_eq!(ask(&compile, "").status.code(), Some(0));
    let commands: [(&[&str], &str); 4] = [
        (&["inspect"], ""),
        (&["query", "nearest"], "x,y\n50,-1.75\n"),
        (&["match"], "time,x,y\n0,50,-1.75\n"),
        (&["export", "--format", "html"], ""),
    ];
    for (command, input) in commands {
        for (file, code) in [(&written, 0), (&archive, 0), (&named(b"n\xfft.xodr"), 1)] {
            let mut args: Vec<&OsStr> = command.iter().map(|arg| OsStr::new(*arg)).collect();
            args.insert(1, file.as_os_str());
            let output = ask(&args, input);
            assert_eq!(output.status.code(), Some(code), "{args:?}: {}", errors(&output));
            let said = "n\u{fffd}t.xodr";
            assert_eq!(errors(&output).contains(said), code == 1, "{args:?}: {}", errors(&output));
        }
    }
}
