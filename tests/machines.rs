//! The shipped machine files: each compiles without a word and is laid out canonically.

use machc::syntax::parse::parse;
use machc::syntax::print::print;
use std::fs;
use std::path::PathBuf;

#[path = "common/machine.rs"]
mod machine;

/// Every `.mach` file of a folder, as a path from the package's folder.
fn mach_files(folder: &str) -> Vec<String> {
    let entries = fs::read_dir(machine::root().join(folder)).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("readable").path());
    let is_mach = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "mach");
    let name = |path: PathBuf| format!("{folder}/{}", path.file_name().expect("a name").to_string_lossy());
    let mut files: Vec<String> = paths.filter(is_mach).map(name).collect();
    files.sort();
    files
}

#[test]
fn every_machine_compiles_under_the_name_of_its_file() {
    let files = mach_files("machines");
    assert!(files.len() >= 29, "{files:?}");
    for file in files {
        let model = machine::compiled(&file, &machine::Files).model;
        assert_eq!(format!("machines/{}.mach", model.name), file);
        assert!(model.title.is_some() && model.dialect.is_some(), "{file}");
    }
}

#[test]
fn every_file_is_laid_out_canonically() {
    for file in mach_files("machines").into_iter().chain(mach_files("tests/linuxcnc")) {
        let text = fs::read_to_string(machine::root().join(&file)).expect("readable");
        let tree = parse(&file, &text).whole().unwrap_or_else(|errors| panic!("{file}: {errors:#?}"));
        let printed = print(&tree);
        if std::env::var_os("MACHC_BLESS").is_some() {
            fs::write(machine::root().join(&file), &printed).expect("writable");
        } else {
            assert_eq!(printed, text, "{file}");
        }
    }
}
