//! `machc emit`.

use std::io::Write;

use mach_command::files::cannot_write;
use mach_command::outcome::{Failure, Status};
use mach_command::output::Output;
use mach_command::report::Report;
use machc::emit::c::c;
use machc::emit::rust::rust;

use super::machine::compiled;

/// Write the kinematics of a machine as source code
///
/// What was derived becomes functions that only compute, statement by statement; each says which line of the machine file
/// it comes from.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// What to write
    #[arg(value_enum)]
    form: Form,
    /// The machine file; - reads standard input
    machine: String,
    /// The file to write; without it, or with -, standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<String>,
}

/// A form of source code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Form {
    /// One module for mach-runtime: the solver and the tables
    Rust,
    /// A kinematics module for LinuxCNC
    C,
}

pub(super) fn run(arguments: Arguments, report: &Report) -> Result<Status, Failure> {
    let Arguments { form, machine, output } = arguments;
    let Some(compiled) = compiled(&machine, report)? else { return Ok(Status::Refused) };
    let text = match form {
        Form::Rust => Ok(rust(&compiled)),
        Form::C => c(&compiled),
    };
    let text = match text {
        Ok(text) => text,
        Err(diagnostic) => return Ok(report.tell(&[diagnostic])),
    };
    let mut out = Output::begin(output.as_deref())?;
    out.write_all(text.as_bytes()).map_err(|error| cannot_write(output.as_deref().unwrap_or("<stdout>"), &error))?;
    out.commit()?;
    Ok(Status::Done)
}
