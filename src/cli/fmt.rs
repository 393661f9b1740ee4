//! `machc fmt`.

use std::path::Path;

use mach_command::files::{cannot_read, shown, text};
use mach_command::outcome::{Failure, Status};
use mach_command::output::{print, write_file};
use mach_command::report::Report;
use machc::syntax::parse::parse;
use machc::syntax::print::print as printed;

/// Put machine files into the canonical form
///
/// Files are changed in place, and only when they are not canonical yet. Standard input is printed to standard output.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Change nothing; list the files that are not canonical, and exit with 1 if there are any
    #[arg(long)]
    check: bool,
    /// Machine files; - formats standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<String>,
}

pub(super) fn run(arguments: Arguments, report: &mut Report) -> Result<Status, Failure> {
    let mut worst = Status::Done;
    for file in &arguments.files {
        worst = worst.max(format(file, arguments.check, report)?);
    }
    Ok(worst)
}

fn format(file: &str, check: bool, report: &Report) -> Result<Status, Failure> {
    let text = text(file).map_err(|error| cannot_read(file, &error))?;
    let canonical = match parse(shown(file), &text).whole() {
        Ok(tree) => printed(&tree),
        Err(diagnostics) => return Ok(report.tell(&diagnostics)),
    };
    match (canonical == text, file) {
        (true, _) if check => Ok(Status::Done),
        (false, _) if check => print(&format!("{}\n", shown(file))).map(|()| Status::Refused),
        (_, "-") => print(&canonical).map(|()| Status::Done),
        (true, _) => Ok(Status::Done),
        (false, _) => write_file(Path::new(file), &canonical).map(|()| Status::Done),
    }
}
