//! `machc post`.

use mach_command::outcome::{Failure, Status};
use mach_command::post::{PostOptions, post};
use mach_command::report::Report;
use mach_runtime::rig::Rig;
use machc::diagnostic::{Code, Diagnostic};
use machc::model::origin::Origins;
use machc::numeric::Inverse;

use super::machine::prepare;
use super::solver::SolverOption;

/// A machine that nothing can be posted for.
pub(super) static NO_CONTROLLER: Code = Code {
    id: "E1106",
    title: "the machine names no controller",
    explanation: "\
A program is written in the dialect of a controller, and the machine file does not say which one the machine has. It can be
checked, shown and solved without one, but not posted for. Name one:

    use \"controllers/syntec.mach\"

    machine tmv710a {
        // …
        controller syntec { }
    }
",
};

/// Post a CL file: an NC program and its certificate
///
/// The program is read back as it is written, taken through the machine's forward chain and compared with the CL. The
/// certificate (on standard error) says how close it is. When there is any error, no program is written.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The machine file
    machine: String,
    #[command(flatten)]
    solver: SolverOption,
    #[command(flatten)]
    post: PostOptions,
}

pub(super) fn run(arguments: Arguments, report: &mut Report) -> Result<Status, Failure> {
    let Some(prepared) = prepare(&arguments.machine, report)? else { return Ok(Status::Refused) };
    let Some(dialect) = prepared.model.dialect.clone() else {
        return Ok(report.tell(&[no_controller(&prepared.origins)]));
    };
    let inverse = arguments.solver.inverse(&prepared)?;
    let machine = prepared.machine;
    match inverse {
        Inverse::ClosedForm(solver) => post(Rig { machine, kinematics: *solver, dialect }, &arguments.post, report),
        Inverse::Numeric(solver) => post(Rig { machine, kinematics: *solver, dialect }, &arguments.post, report),
    }
}

/// Nothing can be posted for this machine.
pub(super) fn no_controller(origins: &Origins) -> Diagnostic {
    Diagnostic::error(&NO_CONTROLLER, NO_CONTROLLER.title)
        .at(origins.name.clone(), "a program is written in the dialect of a controller")
        .note("name it in the machine: `controller syntec { }`, with `use \"controllers/syntec.mach\"` at the head")
}
