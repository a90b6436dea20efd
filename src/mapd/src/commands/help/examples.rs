//! What people do with each command, at the end of its long help and of its man page. A test runs all of it.

use clap::Command;

/// Commands of the command line, with an empty name for the program itself: what for, and what to type.
const EXAMPLES: &[(&str, &[(&str, &str)])] = &[
    (
        "",
        &[
            ("Serve a map under the name town", "mapd --load town.xodr"),
            (
                "Serve a folder of maps, and follow changes of its files",
                "mapd --load maps/ --watch --metrics 127.0.0.1:9464",
            ),
        ],
    ),
    (
        "compile",
        &[
            (
                "One map, with all findings",
                "mapd compile town.xodr -o town.mapd --report town.json",
            ),
            ("A folder of maps, two at once", "mapd compile maps/ --output-dir compiled --jobs 2"),
        ],
    ),
    (
        "check",
        &[
            ("What is wrong with a map", "mapd check town.xodr"),
            ("The same for a code scanner", "mapd check town.xodr --format sarif > town.sarif"),
        ],
    ),
    (
        "inspect",
        &[
            ("A page about a map", "mapd inspect town.xodr"),
            ("The served one, table by table", "mapd inspect shm:town --tables"),
        ],
    ),
    (
        "query",
        &[
            (
                "Which lane is at this place?",
                "printf 'x,y\\n50,-1.75\\n' | mapd query shm:town nearest",
            ),
            (
                "The way between two places, as JSON",
                "printf 'from_road,from_s,from_lane,to_road,to_s,to_lane\\n1,38,-1,3,30,-1\\n' | mapd query town.xodr route --json",
            ),
        ],
    ),
    (
        "match",
        &[(
            "The lanes of a drive, whose places are known to 2 m",
            "printf 'time,x,y\\n0,20,-1.9\\n1,30,-1.5\\n' | mapd match shm:town --deviation 2",
        )],
    ),
    (
        "export",
        &[
            (
                "A drawing, with a route",
                "mapd export town.xodr --format svg --route 1,38,-1:3,30,-1 -o town.svg",
            ),
            ("A page for a browser", "mapd export shm:town --format html -o town.html"),
        ],
    ),
    ("view", &[("Look at the served map, and follow its changes", "mapd view shm:town")]),
    (
        "status",
        &[
            ("What is served", "mapd status"),
            ("For a health check: the exit code alone", "mapd status --healthy > /dev/null"),
        ],
    ),
    (
        "bench",
        &[("With fewer questions than usual", "mapd bench shm:town --queries 1000 --clients 4")],
    ),
    (
        "doctor",
        &[
            ("Is this machine fit to serve?", "mapd doctor"),
            ("Is this configuration right?", "mapd doctor --config mapd.toml"),
        ],
    ),
    (
        "sign",
        &[(
            "Sign an archive, whose readers trust one public key",
            "mapd sign --key mapd.key town.mapd && mapd inspect town.mapd --trust mapd.pub",
        )],
    ),
    (
        "reload",
        &[
            ("Compile the file again, and serve it", "mapd reload town"),
            ("Compile it now, serve it later", "mapd reload town --stage && mapd activate town"),
        ],
    ),
    ("rollback", &[("Serve what was served before", "mapd rollback town")]),
    ("activate", &[("Serve what was staged", "mapd reload town --stage && mapd activate town")]),
    (
        "overlay",
        &[
            (
                "Close a lane between two places",
                "echo '{\"entries\":[{\"id\":\"works\",\"kind\":\"closed\",\"lanes\":[{\"road\":\"1\",\"s\":[40,60],\"lane\":-1}]}]}' | mapd overlay town apply -",
            ),
            ("What holds now", "mapd overlay town list"),
            ("Open it again", "mapd overlay town remove works"),
        ],
    ),
    (
        "overlay apply",
        &[(
            "A limit of 8 m/s on a whole road",
            "echo '{\"entries\":[{\"id\":\"dust\",\"kind\":\"speed\",\"value\":8,\"lanes\":[{\"road\":\"1\"}]}]}' > dust.json && mapd overlay town apply dust.json",
        )],
    ),
    ("overlay list", &[("What holds now, for programs", "mapd overlay town list --json")]),
    ("overlay show", &[("All of one entry", "mapd overlay town show dust")]),
    ("overlay remove", &[("What is over", "mapd overlay town remove dust")]),
    ("overlay clear", &[("As the map says, again", "mapd overlay town clear")]),
    (
        "completions",
        &[
            ("For bash", "mapd completions bash > ~/.local/share/bash-completion/completions/mapd"),
            ("For fish", "mapd completions fish > ~/.config/fish/completions/mapd.fish"),
            ("For zsh, in a folder of $fpath", "mapd completions zsh > ~/.zfunc/_mapd"),
        ],
    ),
    ("man", &[("Pages for this user", "mapd man ~/.local/share/man/man1")]),
    (
        "help",
        &[("A command of a command", "mapd help overlay apply"), ("A topic", "mapd help units")],
    ),
];

/// What stands above the examples.
pub(crate) const HEADING: &str = "Examples:";

/// Appends its examples to each command's long help.
pub(super) fn with_examples(mut program: Command) -> Command {
    for (name, examples) in EXAMPLES {
        program = at(program, name, examples);
    }
    program
}

/// Appends examples to the help of a command, named by the words that lead to it.
fn at(command: Command, names: &str, examples: &[(&str, &str)]) -> Command {
    match names.split_once(' ').unwrap_or((names, "")) {
        ("", _) => told(command, examples),
        (name, below) => command.mut_subcommand(name, |command| at(command, below, examples)),
    }
}

fn told(command: Command, examples: &[(&str, &str)]) -> Command {
    let mut text = command.get_after_help().map(|help| format!("{help}\n\n")).unwrap_or_default();
    text.push_str(HEADING);
    for (purpose, line) in examples {
        let end = if purpose.ends_with('?') { "" } else { ":" };
        text.push_str(&format!("\n  {purpose}{end}\n    {line}\n"));
    }
    command.after_long_help(text.trim_end().to_owned())
}
