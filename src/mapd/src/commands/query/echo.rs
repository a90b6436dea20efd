//! What comes back of the questions, so that answers can be assigned to them.

use csv::StringRecord;

/// In front of the name of an input's column where a column of the answer has that name.
pub(in crate::commands) const INPUT: &str = "input_";

/// Column that says why a row has no answer.
pub(in crate::commands) const ERROR: &str = "error";

/// Names of the input's columns in the output, where `answers` stand behind them: each is told from those, and from the others.
pub(in crate::commands) fn names(headers: &StringRecord, answers: &[&str]) -> Vec<String> {
    let is_answers = |name: &str| answers.contains(&name) || name == ERROR;
    let mut names: Vec<String> = Vec::with_capacity(headers.len());
    for header in headers {
        let mut name = header.to_owned();
        if is_answers(&name) {
            let is_taken = |name: &str| {
                is_answers(name)
                    || headers.iter().any(|h| h == name)
                    || names.iter().any(|n| n == name)
            };
            while is_taken(&name) {
                name.insert_str(0, INPUT);
            }
        }
        names.push(name);
    }
    names
}

/// The values of a row in these columns; one that ends before them has none there.
pub(in crate::commands) fn values<'r>(
    record: &'r StringRecord,
    names: &[String],
) -> impl Iterator<Item = &'r str> {
    (0..names.len()).map(|i| record.get(i).unwrap_or(""))
}
