//! A post that stands on its own: one machine, one command.

use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches};
use mach_runtime::kinematics::Kinematics;
use mach_runtime::rig::Rig;

use crate::post::{PostOptions, post};
use crate::report::{Report, ReportOptions};

/// The arguments of the process. What the command is about depends on the machine.
#[derive(Debug, clap::Parser)]
#[command(version, max_term_width = 80)]
struct Arguments {
    #[command(flatten)]
    post: PostOptions,
    #[command(flatten)]
    report: ReportOptions,
}

const MORE: &str = "\
The program is read back as it is written, taken through the machine's forward chain and compared with the CL. The \
certificate (on standard error) says how close it is. When there is any error, no program is written.

Exit status: 0 done, 1 the input has errors, 2 wrong usage or a file that cannot be read or written.";

/// Runs the post of one machine with the arguments of this process. The command calls itself `name`.
pub fn run<K: Kinematics + Clone + Send>(name: &'static str, rig: Rig<K>) -> ExitCode {
    let about = format!("Post a CL file for the machine {}: an NC program and its certificate", rig.machine.name);
    let command = Arguments::command().name(name).long_about(format!("{about}\n\n{MORE}")).about(about);
    let matches = command.get_matches();
    let arguments = Arguments::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    let report = Report::new(arguments.report);
    report.exit_code(post(rig, &arguments.post, &report))
}
