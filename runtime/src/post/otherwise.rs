//! What is told of a program that does something else than its CL wants.

use super::job::Job;
use crate::diagnostic::{Diagnostic, Place};
use crate::verify::comparison::FoundAt;

/// An error at the CL's line, if one is known.
pub(super) fn error(job: Job<'_>, FoundAt { found: (difference, message), line, cl_line }: FoundAt) -> Diagnostic {
    let error = Diagnostic::error(difference.code(), message);
    let error = match cl_line {
        Some(cl_line) => error.at(Place::line(job.file, cl_line), "for this record"),
        None => error,
    };
    error
        .note(format!("so says line {line} of the program, as its control would read it"))
        .note("the controller's description prints something else than the CL asks for")
}
