//! The command line: arguments, files, progress. The only place that does I/O.

mod builtin;
mod check;
mod compare_solvers;
mod diff;
mod explain;
mod files;
mod fmt;
mod joints;
mod json;
mod machine;
mod new;
mod output;
mod post;
mod progress;
mod report;
mod review;
mod show;
mod solve;
mod solver;
mod test;
mod text_diff;
mod toolpath;
mod workspace;

use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};

use report::{ColorChoice, Report};

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
    global: Global,
}

#[derive(Debug, Args)]
struct Global {
    /// Write diagnostics, certificates and results as JSON lines, for tools
    #[arg(long, global = true)]
    json: bool,
    /// When to use colours; auto: on a terminal, unless NO_COLOR is set
    #[arg(long, global = true, value_name = "WHEN", value_enum, default_value_t = ColorChoice::Auto)]
    color: ColorChoice,
    /// Say nothing but errors
    #[arg(short, long, global = true)]
    quiet: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    New(new::Arguments),
    Check(check::Arguments),
    Post(post::Arguments),
    Show(show::Arguments),
    Solve(solve::Arguments),
    Fmt(fmt::Arguments),
    Test(test::Arguments),
    Review(review::Arguments),
    Diff(diff::Arguments),
    CompareSolvers(compare_solvers::Arguments),
    Explain(explain::Arguments),
}

/// What a command came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Status {
    Done,
    /// The input has errors, and they have been told.
    Refused,
}

/// Wrong usage, or a file that cannot be read or written: what is to be said of it.
#[derive(Debug)]
struct Failure(String);

/// Runs the command that the arguments ask for.
pub(crate) fn run() -> ExitCode {
    let Arguments { command, global } = Arguments::parse();
    let mut report = Report::new(global.json, global.color, global.quiet);
    let outcome = match command {
        Command::New(arguments) => new::run(arguments, &report),
        Command::Check(arguments) => check::run(arguments, &mut report),
        Command::Post(arguments) => post::run(arguments, &mut report),
        Command::Show(arguments) => show::run(arguments, &mut report),
        Command::Solve(arguments) => solve::run(arguments, &mut report),
        Command::Fmt(arguments) => fmt::run(arguments, &mut report),
        Command::Test(arguments) => test::run(arguments, &report),
        Command::Review(arguments) => review::run(arguments, &report),
        Command::Diff(arguments) => diff::run(arguments, &report),
        Command::CompareSolvers(arguments) => compare_solvers::run(arguments, &report),
        Command::Explain(arguments) => explain::run(arguments),
    };
    match outcome {
        Ok(Status::Done) => ExitCode::SUCCESS,
        Ok(Status::Refused) => ExitCode::from(1),
        Err(failure) => {
            report.failure(&failure);
            ExitCode::from(2)
        }
    }
}
