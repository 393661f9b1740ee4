//! CL files, posted.

use mach_runtime::certificate::Certificate;
use mach_runtime::cl::{Reader, ReaderOptions, quote};
use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::post::{Job, post};
use machc::compile::Compiled;
use machc::emit::tables;
use machc::plan::Interpreter;
use std::num::NonZeroUsize;
use std::path::Path;

/// What a post gave.
pub(crate) struct Posted {
    /// What was written; worth nothing without a certificate.
    pub(crate) nc: Vec<u8>,
    /// There when the input had no errors.
    pub(crate) certificate: Option<Certificate>,
    /// With the CL lines they speak of.
    pub(crate) diagnostics: Vec<Diagnostic>,
}

/// Posts CL text under a file's name.
pub(crate) fn posted(compiled: &Compiled, cl: &str, text: &[u8], threads: NonZeroUsize) -> Posted {
    let machine = tables::machine(&compiled.model);
    let dialect = compiled.model.dialect.as_ref().expect("a machine with a controller");
    let program = Path::new(cl).file_stem().and_then(|stem| stem.to_str()).expect("a name in UTF-8");
    let job = Job { file: cl, program, machine: &machine, dialect };
    let kinematics = Interpreter::new(&compiled.plan);
    let reader = Reader::new(cl, text, ReaderOptions::of(&machine));
    let (mut nc, mut diagnostics) = (Vec::new(), Vec::new());
    let mut tell = |diagnostic| diagnostics.push(diagnostic);
    let certificate = post(job, &kinematics, reader, &mut nc, threads, &mut tell)
        .expect("reading from and writing to memory does not fail");
    quote(&mut diagnostics, cl, text).expect("reading from memory does not fail");
    Posted { nc, certificate, diagnostics }
}
