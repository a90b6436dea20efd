//! The command line: what commands take, say and promise, and what the pages say of them.

mod bench_command;
mod command_line;
mod command_line_frames;
mod dependencies;
mod export;
mod export_by_gdal;
mod export_extremes;
mod export_lanelet2;
mod export_layers;
mod help_examples;
mod help_text;
mod numbers;
mod options_documented;
mod page;
mod page_colors;
mod page_sheets;
mod pages;
mod path_queries;
mod progress;
mod promises;
mod readme;
mod shell;
mod terminal;
mod tiles;
mod tiles_page;
mod units;
