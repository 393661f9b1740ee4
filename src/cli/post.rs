//! `machc post`.

use std::num::NonZeroUsize;
use std::thread::available_parallelism;

use mach_runtime::post::{Job, post};
use machc::diagnostic::{Code, Diagnostic, Place};
use machc::model::machine::Model;
use machc::plan::Interpreter;

use super::files::{cannot_read, shown, stem};
use super::machine::prepare;
use super::output::Output;
use super::report::{Collected, Report};
use super::toolpath::{Options, quoted};
use super::{Failure, Status};

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
    /// The CL file; - reads standard input
    cl: String,
    /// The NC file; without it, or with -, standard output
    #[arg(short, long, value_name = "NC")]
    output: Option<String>,
    /// Threads to work with; as many as the machine has, where it is not given
    #[arg(long, value_name = "COUNT")]
    threads: Option<NonZeroUsize>,
    /// The program's name; the CL file's name where it is not given
    #[arg(long, value_name = "NAME")]
    program: Option<String>,
    #[command(flatten)]
    options: Options,
}

pub(super) fn run(arguments: Arguments, report: &mut Report) -> Result<Status, Failure> {
    let Arguments { machine, cl, output, threads, program, options } = arguments;
    let Some(prepared) = prepare(&machine, report)? else { return Ok(Status::Refused) };
    let Some(dialect) = &prepared.model.dialect else {
        return Ok(report.tell(&[no_controller(&prepared.model, &machine)]));
    };
    let machine = options.equipped(prepared.machine);
    let reader = options.reader(&cl, &machine, report)?;
    let program = program.as_deref().or(stem(&cl)).unwrap_or(&machine.name);
    let job = Job { file: shown(&cl), program, machine: &machine, dialect };
    let mut nc = Output::begin(output.as_deref())?;
    let mut told = Collected::default();
    let mut tell = |diagnostic| told.add(diagnostic);
    let threads = threads.or_else(|| available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
    let certificate = match post(job, &Interpreter::new(&prepared.plan), reader, &mut nc, threads, &mut tell) {
        Ok(certificate) => certificate,
        Err(error) => return Err(nc.into_failure().unwrap_or_else(|| cannot_read(&cl, &error))),
    };
    let status = report.tell(&quoted(told.into_diagnostics(), &cl));
    let Some(certificate) = certificate else { return Ok(Status::Refused) };
    nc.commit()?;
    report.certificate(&machine.name, &certificate);
    Ok(status)
}

/// Nothing can be posted for this machine.
pub(super) fn no_controller(model: &Model, file: &str) -> Diagnostic {
    let message = format!("machine `{}` names no controller", model.name);
    Diagnostic::error(&NO_CONTROLLER, message).at(Place::line(shown(file), 1), "")
}
