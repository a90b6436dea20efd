//! Options of compiling as arguments that a child process is given again.

use super::BuildArgs;
use crate::args::JudgingArgs;
use crate::similar::did_you_mean;
use anyhow::Result;
use clap::parser::ValueSource;
use clap::{ArgAction, ArgMatches, Args, Command, FromArgMatches, ValueHint};
use mapd_compiler::{CompileOptions, ReadOptions};
use std::ffi::OsString;
use std::path::Path;

/// All that shapes an archive.
#[derive(Args)]
struct CompileArgs {
    #[command(flatten)]
    options: BuildArgs,
    #[command(flatten)]
    judging: JudgingArgs,
}

/// Options of compiling one map, as arguments of `mapd compile`. Those that are not said are not among them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct CompileArguments(Vec<OsString>);

/// The value of `--on-error` that shapes an archive.
const KEEPS_LINE: &str = "reference-line";

fn grammar() -> Command {
    CompileArgs::augment_args(Command::new("options").no_binary_name(true).disable_help_flag(true))
}

impl CompileArguments {
    /// Those of a command line that has them among others.
    pub(crate) fn of(matches: &ArgMatches) -> Self {
        let mut arguments = Vec::new();
        for arg in grammar().get_arguments() {
            let id = arg.get_id().as_str();
            let Some(long) = arg.get_long() else { continue };
            if matches.value_source(id).is_none_or(|source| source == ValueSource::DefaultValue) {
                continue;
            }
            if matches!(arg.get_action(), ArgAction::SetTrue) {
                arguments.push(format!("--{long}").into());
                continue;
            }
            for value in matches.get_raw(id).into_iter().flatten() {
                arguments.push(format!("--{long}").into());
                arguments.push(value.to_owned());
            }
        }
        Self(arguments)
    }

    /// Adds an option of a configuration file, whose paths are relative to `folder`.
    ///
    /// Errors: there is no such option; it does not take this value.
    pub(crate) fn add(
        &mut self,
        name: &str,
        values: &[String],
        folder: &Path,
    ) -> Result<(), String> {
        let long = name.replace('_', "-");
        let grammar = grammar();
        let Some(arg) = grammar.get_arguments().find(|arg| arg.get_long() == Some(&long)) else {
            let known = grammar.get_arguments().filter_map(clap::Arg::get_long);
            let known: Vec<String> = known.map(|name| name.replace('-', "_")).collect();
            let meant = did_you_mean(name, known.iter().map(String::as_str));
            let known = known.join(", ");
            return Err(format!("there is no option {name:?}; known are {known}{meant}"));
        };
        let is_path = matches!(arg.get_value_hint(), ValueHint::AnyPath | ValueHint::FilePath);
        let mut added = Vec::new();
        for value in values {
            let value = if is_path { folder.join(value).into() } else { OsString::from(value) };
            added.extend([OsString::from(format!("--{long}")), value]);
        }
        let said = |error: clap::Error| {
            let text = error.to_string();
            let first = text.lines().next().unwrap_or_default();
            first.strip_prefix("error: ").unwrap_or(first).to_owned()
        };
        grammar.try_get_matches_from(&added).map_err(said)?;
        self.0.append(&mut added);
        Ok(())
    }

    /// These, and where they are silent, those of `others`.
    pub(crate) fn or(&self, others: &Self) -> Self {
        let mut all = self.0.clone();
        let mut rest = others.0.iter().peekable();
        while let Some(name) = rest.next() {
            let is_name = |text: &&&OsString| text.as_encoded_bytes().starts_with(b"--");
            let value = rest.next_if(|next| !is_name(&next));
            if !self.0.contains(name) {
                all.push(name.clone());
                all.extend(value.cloned());
            }
        }
        Self(all)
    }

    /// As a child process is given them.
    pub(crate) fn as_slice(&self) -> &[OsString] {
        &self.0
    }

    /// The first of these that an archive cannot heed any more, for it shapes how a map is compiled. Bounds on what is in quarantine hold for archives, too.
    pub(crate) fn shaping(&self) -> Option<&str> {
        let names = self.0.iter().enumerate().filter_map(|(i, text)| Some((i, text.to_str()?)));
        let mut names = names.filter(|(_, text)| text.starts_with("--"));
        let keeps_line = |i: usize| self.0.get(i + 1).is_some_and(|value| value == KEEPS_LINE);
        let shapes = |(i, name): &(usize, &str)| match *name {
            "--max-quarantined" | "--max-quarantined-share" => false,
            "--on-error" => keeps_line(*i),
            _ => true,
        };
        names.find(shapes).map(|(_, name)| name)
    }

    /// What they mean now: files that they name are read.
    ///
    /// Errors: a file cannot be read, or has something in it that makes no sense; a value out of range.
    pub(crate) fn parse(&self) -> Result<(ReadOptions, CompileOptions)> {
        let matches = grammar().try_get_matches_from(&self.0)?;
        let args = CompileArgs::from_arg_matches(&matches)?;
        Ok((args.options.reading(&args.judging)?, args.options.validated()?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arguments(options: &[(&str, &str)]) -> CompileArguments {
        let mut all = CompileArguments::default();
        for (name, value) in options {
            all.add(name, &[(*value).to_owned()], Path::new("/etc/mapd")).expect("an option");
        }
        all
    }

    #[test]
    fn options_of_a_file_become_arguments() {
        let all = arguments(&[("landmarks", "3"), ("on_error", "reject")]);
        let (reading, options) = all.parse().expect("good");
        assert_eq!(options.landmarks, 3);
        assert_eq!(reading.policy.on_error, mapd_compiler::OnError::Reject);
        assert_eq!(arguments(&[("rules", "r.toml")]).as_slice()[1], "/etc/mapd/r.toml");
        let wrong = |name: &str, value: &str| {
            CompileArguments::default().add(name, &[value.to_owned()], Path::new(""))
        };
        assert!(wrong("landmark", "3").expect_err("unknown").contains("landmarks"));
        assert!(wrong("landmarks", "99").expect_err("too many").contains("99"));
    }

    #[test]
    fn what_shapes_an_archive_comes_too_late_for_one() {
        let heeded = [
            ("max_quarantined", "0"),
            ("max_quarantined_share", "0.5"),
            ("on_error", "reject"),
            ("on_error", "quarantine"),
        ];
        assert_eq!(arguments(&heeded).shaping(), None);
        for (name, value) in [
            ("on_error", "reference-line"),
            ("profile", "strict"),
            ("rules", "r.toml"),
            ("without", "user-data"),
            ("landmarks", "3"),
            ("crs", "utm"),
            ("remove", "road:1"),
            ("patch", "p.xodr"),
            ("ontology", "o.toml"),
        ] {
            let all = arguments(&[("max_quarantined", "1"), (name, value)]);
            let long = format!("--{}", name.replace('_', "-"));
            assert_eq!(all.shaping(), Some(&*long), "{value}");
        }
    }

    #[test]
    fn a_command_line_is_handed_on_as_it_is() {
        let line = ["--index-tolerance", "0.25", "--landmarks", "5", "--cycles", "all"];
        let matches = grammar().try_get_matches_from(line).expect("good");
        assert_eq!(CompileArguments::of(&matches).as_slice(), line.map(OsString::from));
    }

    #[test]
    fn what_is_said_for_one_map_stands_above_what_is_said_for_all() {
        let all = arguments(&[("landmarks", "3"), ("cycles", "all")]);
        let one = arguments(&[("landmarks", "5")]);
        let (_, options) = one.or(&all).parse().expect("good");
        assert_eq!(options.landmarks, 5);
        assert_eq!(options.cycles, mapd_compiler::CyclePolicy::All);
    }
}
