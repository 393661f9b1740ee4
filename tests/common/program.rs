//! CL files, posted.

use crate::machine::root;
use mach_runtime::kinematics::Kinematics;
use mach_runtime::rig::{Posted, Rig};
use machc::compile::Compiled;
use machc::model::tables;
use machc::plan::Interpreter;
use std::fs;
use std::num::NonZeroUsize;

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
    let dialect = compiled.model.dialect.clone().expect("a machine with a controller");
    let rig = Rig { machine: tables::machine(&compiled.model), kinematics: kinematics.clone(), dialect };
    rig.post_text_by(cl, text, threads)
}
