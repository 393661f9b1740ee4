//! Posting a CL file from the command line.

use std::num::NonZeroUsize;
use std::thread::available_parallelism;

use mach_runtime::kinematics::Kinematics;
use mach_runtime::rig::Rig;

use crate::files::{cannot_read, shown, stem};
use crate::outcome::{Failure, Status};
use crate::output::Output;
use crate::report::{Collected, Report};
use crate::toolpath::{Options, quoted};

/// What is posted, and where to.
#[derive(Debug, clap::Args)]
pub struct PostOptions {
    /// The CL file; - reads standard input
    cl: String,
    /// The NC file; without it, or with -, standard output
    #[arg(short, long, value_name = "NC")]
    output: Option<String>,
    /// Threads to work with, 1 or 2: more are not used; as many as there are processors, where it is not given
    #[arg(long, value_name = "COUNT", value_parser = thread_count)]
    threads: Option<NonZeroUsize>,
    /// The program's name; the CL file's name where it is not given
    #[arg(long, value_name = "NAME")]
    program: Option<String>,
    #[command(flatten)]
    toolpath: Options,
}

/// Posts, and tells the certificate and whatever else there is to tell.
///
/// # Errors
///
/// A file that cannot be read or written.
pub fn post<K: Kinematics + Clone + Send>(
    mut rig: Rig<K>,
    options: &PostOptions,
    report: &Report,
) -> Result<Status, Failure> {
    let PostOptions { cl, output, threads, program, toolpath } = options;
    rig.machine = toolpath.equipped(rig.machine);
    let reader = toolpath.reader(cl, &rig.machine, report)?;
    let program = program.as_deref().or(stem(cl)).unwrap_or(&rig.machine.name);
    let mut nc = Output::begin(output.as_deref())?;
    let mut told = Collected::default();
    let mut tell = |diagnostic| told.add(diagnostic);
    let threads = threads.or_else(|| available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
    let certificate = match rig.post((shown(cl), program), reader, &mut nc, threads, &mut tell) {
        Ok(certificate) => certificate,
        Err(error) => return Err(nc.into_failure().unwrap_or_else(|| cannot_read(cl, &error))),
    };
    let status = report.tell(&quoted(told.into_diagnostics(), cl));
    let Some(certificate) = certificate else { return Ok(Status::Refused) };
    nc.commit()?;
    report.certificate(&rig.machine.name, &certificate);
    Ok(status)
}

fn thread_count(text: &str) -> Result<NonZeroUsize, String> {
    text.parse().map_err(|_| "expected a number of threads, at least 1".to_owned())
}
