//! CL files, posted.

use crate::machine::root;
use mach_runtime::certificate::Certificate;
use mach_runtime::cl::{Reader, ReaderOptions, quote};
use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::kinematics::Kinematics;
use mach_runtime::post::{Job, post};
use machc::compile::Compiled;
use machc::emit::tables;
use machc::plan::Interpreter;
use std::fs;
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

/// Posts a CL file by the closed form; the path is from the package's folder.
pub(crate) fn posted(compiled: &Compiled, cl: &str) -> Posted {
    posted_by(&Interpreter::new(&compiled.plan), compiled, cl)
}

/// Posts a CL file by these kinematics.
pub(crate) fn posted_by<K: Kinematics + Clone + Send>(kinematics: &K, compiled: &Compiled, cl: &str) -> Posted {
    let text = fs::read(root().join(cl)).unwrap_or_else(|error| panic!("{cl}: {error}"));
    posted_text(kinematics, compiled, cl, &text, NonZeroUsize::MIN)
}

/// Posts CL text under a file's name.
pub(crate) fn posted_text<K: Kinematics + Clone + Send>(
    kinematics: &K,
    compiled: &Compiled,
    cl: &str,
    text: &[u8],
    threads: NonZeroUsize,
) -> Posted {
    let machine = tables::machine(&compiled.model);
    let dialect = compiled.model.dialect.as_ref().expect("a machine with a controller");
    let program = Path::new(cl).file_stem().and_then(|stem| stem.to_str()).expect("a name in UTF-8");
    let job = Job { file: cl, program, machine: &machine, dialect };
    let reader = Reader::new(cl, text, ReaderOptions::of(&machine));
    let (mut nc, mut diagnostics) = (Vec::new(), Vec::new());
    let mut tell = |diagnostic| diagnostics.push(diagnostic);
    let certificate = post(job, kinematics, reader, &mut nc, threads, &mut tell)
        .expect("reading from and writing to memory does not fail");
    quote(&mut diagnostics, cl, text).expect("reading from memory does not fail");
    Posted { nc, certificate, diagnostics }
}
