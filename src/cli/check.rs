//! `machc check`.

use mach_command::outcome::{Failure, Status};
use mach_command::report::Report;

use super::machine::{prepare, status};

/// Check machine files
///
/// Every mistake is told with its place and a way to mend it; `machc explain CODE` says more about it. The kinematics
/// are derived and proved: random poses are taken through the inverse and back.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Machine files; - reads standard input
    #[arg(required = true, value_name = "MACHINE")]
    machines: Vec<String>,
}

pub(super) fn run(arguments: Arguments, report: &mut Report) -> Result<Status, Failure> {
    let mut worst = Status::Done;
    for machine in &arguments.machines {
        worst = worst.max(status(prepare(machine, report)?));
    }
    Ok(worst)
}
