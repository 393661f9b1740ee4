//! The post: CL in, NC text out, read back as it is written.

mod between;
mod checker;
mod in_force;
mod job;
mod otherwise;
mod pipeline;
mod printer;
mod refusal;
mod stretch;

use crate::certificate::Certificate;
use crate::cl::Reader;
use crate::diagnostic::{Code, Diagnostic};
use crate::kinematics::Kinematics;
use checker::Checker;
use pipeline::Pipeline;
use printer::Printer;
use std::io::{self, Read, Write};
use std::num::NonZeroUsize;

pub(crate) use job::Job;

pub use between::OFF_THE_LINE;
pub use refusal::{
    INSIDE_DEAD_RADIUS, NO_FEED_RATE, NOT_COMPENSATED, OFF_PLANE, OUT_OF_REACH, OUT_OF_TRAVEL, REPOSITION,
    REPOSITION_WARNING, SINGULAR, SPINDLE_STANDS, TOO_MANY_ERRORS,
};

/// See [`crate::rig::Rig::post`].
pub(crate) fn post<R: Read, K: Kinematics + Clone + Send>(
    job: Job<'_>,
    kinematics: &K,
    reader: Reader<R>,
    nc: &mut dyn Write,
    threads: NonZeroUsize,
    tell: &mut dyn FnMut(Diagnostic),
) -> io::Result<Option<Certificate>> {
    let mut solving = kinematics.clone();
    let printer = Printer::new(job, &mut solving);
    let checker = Checker::new(job, kinematics.clone(), nc);
    let mut pipeline = Pipeline { reader, printer, checker, tell };
    if threads.get() == 1 {
        pipeline.run()?
    } else {
        pipeline.run_side_by_side()?
    }
    let Pipeline { printer, checker, tell, .. } = pipeline;
    if !printer.is_without_errors() {
        return Ok(None);
    }
    let certificate = checker.finish(tell)?;
    let between = certificate.as_ref().and_then(|certificate| between::warning(job, &certificate.between));
    between.into_iter().for_each(tell);
    Ok(certificate)
}

/// The codes that a post may raise by itself.
pub static CODES: [&Code; 12] = [
    &OUT_OF_REACH,
    &OUT_OF_TRAVEL,
    &REPOSITION,
    &SINGULAR,
    &NOT_COMPENSATED,
    &TOO_MANY_ERRORS,
    &INSIDE_DEAD_RADIUS,
    &OFF_PLANE,
    &REPOSITION_WARNING,
    &NO_FEED_RATE,
    &SPINDLE_STANDS,
    &OFF_THE_LINE,
];
