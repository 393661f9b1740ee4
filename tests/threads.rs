//! What comes out of a post does not depend on the number of threads.

use std::fs;
use std::num::NonZeroUsize;

#[path = "common/machine.rs"]
mod machine;
#[path = "common/program.rs"]
mod program;

/// The CL files in a folder of the package's.
fn cl_files(folder: &str) -> Vec<String> {
    let entries = fs::read_dir(machine::root().join(folder)).expect("readable");
    let names = entries.map(|entry| entry.expect("readable").file_name().into_string().expect("a name in UTF-8"));
    let mut files: Vec<String> =
        names.filter(|name| name.ends_with(".cls")).map(|name| format!("{folder}/{name}")).collect();
    files.sort();
    assert!(!files.is_empty(), "{folder} has CL files");
    files
}
