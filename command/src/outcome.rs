//! What a command came to, and its exit status: 0 done, 1 the input has errors, 2 wrong usage or a file that cannot be
//! read or written.

use std::process::ExitCode;

use crate::report::Report;

/// What a command came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// It did what it was asked for.
    Done,
    /// The input has errors, and they have been told.
    Refused,
}

/// Wrong usage, or a file that cannot be read or written: what is to be said of it.
#[derive(Debug)]
pub struct Failure(pub String);

/// Tells a failure, and gives the exit status.
pub fn exit_code(outcome: Result<Status, Failure>, report: &Report) -> ExitCode {
    match outcome {
        Ok(Status::Done) => ExitCode::SUCCESS,
        Ok(Status::Refused) => ExitCode::from(1),
        Err(failure) => {
            report.failure(&failure);
            ExitCode::from(2)
        }
    }
}
