//! The command line: what commands take, say and promise, and what the pages say of them.

// What the lists of the public API must be like: enums that may grow.
mod api_lists;
// `mapd bench`: every line is there, on a file and on a running daemon's map, and nothing is left behind.
mod bench_command;
// What the command line promises: exit codes, columns, errors in rows.
mod command_line;
// `--crs` on the command line.
mod command_line_frames;
// A planner that names `mapd-client` builds no parser, no thread pool, no command line.
mod dependencies;
// `mapd export --format svg`: every lane is drawn once, and the drawing is well-formed XML.
mod export;
// What GDAL reads in exported tables, feature by feature: where queries say that it lies, with z.
mod export_by_gdal;
// `mapd export` of maps with nothing in them, with very much, and with names that would be markup.
mod export_extremes;
// `mapd export --format lanelet2`: a file that is whole, lies where the map lies, and links what the map links.
mod export_lanelet2;
// `mapd export --format geojson` and `flatgeobuf`: every feature arrives, where the map has it, as text, and read by GDAL.
mod export_layers;
// What long help and man pages show as examples does what it says.
mod help_examples;
// `mapd help`: topics, commands of commands, suggestions.
mod help_text;
// Numbers that are none, or too large: every option refuses them.
mod numbers;
// Options of the command line and the docs name each other: none is forgotten, and none is named that is gone.
mod options_documented;
// What the page draws and says of places, against an independent evaluator.
mod page_geometry;
// `mapd export --format html`: one page, whole, that lets nothing in and nothing out.
mod page;
// Colours of the page: what has to be told apart differs for people who see all colours, and for those who lack one kind of cones.
mod page_colors;
// What the page says of a lane: everything that the map knows of it.
mod page_sheets;
// What pages say of the program is in the program: messages that a page explains, and calls that it names.
mod pages;
// `mapd query … path`, `corridor`, `project`, `conflicts` and `speed`: columns, values, and JSON of every kind.
mod path_queries;
// What commands say about how far they are, and where: never on stdout, nothing at all if that is asked for.
mod progress;
// `.ci/promises` demands a line in the list of changes for each part that has changed.
mod promises;
// The README's first screen prints what the README says that it prints.
mod readme;
// Sentences of the pages and of `--help` are short enough to be read once.
mod sentences;
// What is wrong in options and input is refused where it is, not dropped: rows that are too long, quotes, options of other formats.
mod refusals;
// What the program says of itself: help, completions and man pages.
mod shell;
mod shell_files;
// What people see on a terminal: colours where they are wanted, and lines of help that fit.
mod terminal;
// `mapd compile` of many files: one archive and one report each, whatever becomes of the others.
mod tiles;
// What `docs/tiles.md` shows works word for word: the rule for make, the line for GNU parallel, the command of a pod.
mod tiles_page;
// The example units of systemd: systemd finds nothing wrong with them, and their command lines do what they say.
mod units;
