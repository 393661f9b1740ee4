//! `machc diff`.

mod json;
mod table;

use mach_command::files::cannot_read;
use mach_command::outcome::{Failure, Status};
use mach_command::output::{Lines, print};
use mach_command::report::{Collected, Report};
use mach_command::toolpath::{Options, quoted};
use mach_runtime::rig::Rig;
use machc::compare::compare;
use machc::diagnostic::Severity;
use machc::plan::Interpreter;

use super::machine::prepare;
use super::post;

/// Show what a change in a machine file does to the motion
///
/// Both machines are taken along the toolpath. Compared are the words of each axis, where they put the tool in the
/// workpiece (by each machine's own forward chain), the solutions of the rotary axes, and what is left of the travel.
/// The old program on the new machine is compared with the CL, too: what happens when nothing is posted anew.
///
/// Exit status, as that of diff: 0 the motion is the same, 1 it differs, 2 wrong usage, an input with errors, or a file
/// that cannot be read.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The machine file as it was
    old: String,
    /// The machine file as it is now
    new: String,
    /// The CL file; arcs are divided by the old machine's tolerance
    cl: String,
    #[command(flatten)]
    options: Options,
}

pub(super) fn run(arguments: Arguments, report: &Report) -> Result<Status, Failure> {
    let Arguments { old, new, cl, options } = arguments;
    let (old_machine, new_machine) = (machine(&old, &options, report), machine(&new, &options, report));
    let (old_machine, new_machine) = (old_machine?, new_machine?);
    let reader = options.reader(&cl, &old_machine.machine, report)?;
    let mut told = Collected::default();
    let compared = compare(&old_machine, &new_machine, reader, &mut |diagnostic| told.add(diagnostic));
    let comparison = compared.map_err(|error| cannot_read(&cl, &error))?;
    let diagnostics = quoted(told.into_diagnostics(), &cl);
    report.tell(&diagnostics);
    if diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error) {
        return Err(has_errors(&cl));
    }
    let files = [old.as_str(), &new];
    if report.is_json() {
        let mut lines = Lines::stdout();
        lines.add(&json::comparison(&comparison, files));
        lines.flush()?;
    } else {
        print(&table::comparison(&comparison, files, &cl))?;
    }
    Ok(if comparison.is_same() { Status::Done } else { Status::Refused })
}

/// A machine with a controller.
fn machine(file: &str, options: &Options, report: &Report) -> Result<Rig<Interpreter>, Failure> {
    let prepared = prepare(file, report)?.ok_or_else(|| has_errors(file))?;
    let Some(mut rig) = prepared.rig() else {
        report.tell(&[post::no_controller(&prepared.origins)]);
        return Err(has_errors(file));
    };
    rig.machine = options.equipped(rig.machine);
    Ok(rig)
}

fn has_errors(file: &str) -> Failure {
    Failure(format!("nothing is compared: `{file}` has errors"))
}
