//! `machc show`.

use mach_command::outcome::{Failure, Status};
use mach_command::output::print;
use mach_command::report::Report;
use machc::emit::data_sheet::data_sheet;

use super::machine::prepare;

/// Show what was derived from a machine file
///
/// The chain and its family, the forward and the inverse transformation as equations, constants, the reachable cone,
/// singular directions, travel, and how the proof came out.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The machine file; - reads standard input
    machine: String,
}

pub(super) fn run(arguments: Arguments, report: &mut Report) -> Result<Status, Failure> {
    let Some(prepared) = prepare(&arguments.machine, report)? else { return Ok(Status::Refused) };
    print(&data_sheet(&prepared.model, &prepared.plan, &prepared.proof))?;
    Ok(Status::Done)
}
