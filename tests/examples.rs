//! The committed CL files are what their generator makes.

use std::path::Path;

#[path = "../examples/make_cl/programs/mod.rs"]
mod programs;

#[test]
fn the_committed_cl_files_are_what_their_generator_makes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    for (name, text) in programs::all() {
        let committed = std::fs::read_to_string(folder.join(name)).unwrap_or_default();
        assert!(committed == text, "examples/{name} is not up to date: run `cargo run --example make_cl`");
    }
}

#[test]
fn every_committed_cl_file_has_a_generator() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let known: Vec<_> = programs::all().iter().map(|(name, _)| *name).collect();
    for entry in std::fs::read_dir(folder).expect("the folder of examples") {
        let name = entry.expect("an entry").file_name().into_string().expect("a name in UTF-8");
        assert!(!name.ends_with(".cls") || known.contains(&name.as_str()), "examples/{name} has no generator");
    }
}
