//! The command line: arguments, files, progress. The only place that does I/O.

mod axis_values;
mod build;
mod builtin;
mod check;
mod compare_solvers;
mod diff;
mod emit;
mod explain;
mod fmt;
mod folders;
mod in_force;
mod joints;
mod machine;
mod motion;
mod new;
mod post;
mod program;
mod review;
mod show;
mod solve;
mod solver;
mod test;
mod text_diff;
mod toolpath;
mod unsigned_zero;
mod verify;
mod workspace;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use mach_command::report::{Report, ReportOptions};

/// A compiler for machine tools.
///
/// A .mach file describes a machine: its joint chain, its offsets and limits, the dialect of its controller. machc
/// derives the kinematics from it and turns CL data into an NC program that has been read back and compared with
/// the CL.
///
/// Exit status: 0 done, 1 the input has errors, 2 wrong usage or a file that cannot be read or written.
#[derive(Debug, Parser)]
#[command(name = "machc", version, max_term_width = 80)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    report: ReportOptions,
}

#[derive(Debug, Subcommand)]
enum Command {
    New(new::Arguments),
    Check(check::Arguments),
    Post(post::Arguments),
    Verify(verify::Arguments),
    Toolpath(toolpath::Arguments),
    Motion(motion::Arguments),
    Show(show::Arguments),
    Build(build::Arguments),
    Emit(emit::Arguments),
    Solve(solve::Arguments),
    Fmt(fmt::Arguments),
    Test(test::Arguments),
    Review(review::Arguments),
    Diff(diff::Arguments),
    CompareSolvers(compare_solvers::Arguments),
    Explain(explain::Arguments),
}

/// Runs the command that the arguments ask for.
pub(crate) fn run() -> ExitCode {
    let Arguments { command, report } = Arguments::parse();
    let mut report = Report::new(report);
    let outcome = match command {
        Command::New(arguments) => new::run(arguments, &report),
        Command::Check(arguments) => check::run(arguments, &mut report),
        Command::Post(arguments) => post::run(arguments, &mut report),
        Command::Verify(arguments) => verify::run(arguments, &mut report),
        Command::Toolpath(arguments) => toolpath::run(arguments, &report),
        Command::Motion(arguments) => motion::run(arguments, &mut report),
        Command::Show(arguments) => show::run(arguments, &mut report),
        Command::Build(arguments) => build::run(arguments, &report),
        Command::Emit(arguments) => emit::run(arguments, &report),
        Command::Solve(arguments) => solve::run(arguments, &mut report),
        Command::Fmt(arguments) => fmt::run(arguments, &mut report),
        Command::Test(arguments) => test::run(arguments, &report),
        Command::Review(arguments) => review::run(arguments, &report),
        Command::Diff(arguments) => diff::run(arguments, &report),
        Command::CompareSolvers(arguments) => compare_solvers::run(arguments, &report),
        Command::Explain(arguments) => explain::run(arguments),
    };
    report.exit_code(outcome)
}
