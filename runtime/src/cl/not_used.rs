//! Records that ask for something a program can do without, and does.

use crate::cl::record::Record;
use crate::diagnostic::{Code, Diagnostic};

/// A record that asks in vain.
pub(super) static NOT_USED: Code = Code {
    id: "W1011",
    title: "a record is not used",
    explanation: "\
The record is known, and the program does not do what it asks for: points put in between where the tool turns (LINTOL), three
axes only (MULTAX/OFF), the next tool made ready (SELECT/TOOL), a mode of the machine (MODE/MILL). The points of the CL are
posted as they are. Each word is reported once.
",
};

/// The words of such records in order, the arguments with which they ask for nothing, and what is done instead.
static RECORDS: [(&str, &[&str], &str); 6] = [
    ("LINTOL", &["OFF"], "no points are put in between those of the CL"),
    ("MODE", &[], MODE),
    ("MULTAX", &["ON"], "every point keeps its tool axis"),
    ("SELCTL", &[], READY),
    ("SELECT", &[], READY),
    ("SET", &["MODE", "ABSOL", "LINEAR"], MODE),
];

const MODE: &str = "what the machine is stands in its own file";
const READY: &str = "no tool is made ready before its change";

/// A warning, if the record asks for something.
pub(super) fn warning(record: &Record, word: &str) -> Option<Diagnostic> {
    let (_, idle, instead) = RECORDS.iter().find(|entry| entry.0 == word)?;
    let asks = (0..record.len()).any(|index| !idle.contains(&record.argument(index)));
    let warning = || Diagnostic::warning(&NOT_USED, format!("{word} is not used: {instead}"));
    asks.then(|| warning().at(record.place_of_all(), "without effect on the program"))
}
