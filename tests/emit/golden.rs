//! Generated files as they are, to be read: `tests/emit/golden`. The benchmarks compile the Rust ones.
//!
//! `MACHC_BLESS=1 cargo test --test emit` writes them anew. Read what you accept.

use crate::machine;
use machc::emit::{c::c, rust::rust};
use std::fs;

fn check(file: &str, text: &str) {
    let path = machine::root().join("tests/emit/golden").join(file);
    if std::env::var_os("MACHC_BLESS").is_some() {
        fs::write(&path, text).expect("writable");
    }
    let kept = fs::read_to_string(&path).unwrap_or_default();
    let differs = kept.lines().zip(text.lines()).position(|(kept, found)| kept != found);
    assert!(kept == text, "{file} is not what is generated now, from line {differs:?} on (from 0)");
}

#[test]
fn generated_files_are_as_they_were_accepted() {
    for name in ["tmv710a", "dmu50ev"] {
        let compiled = machine::compiled(&format!("machines/{name}.mach"), &machine::Files);
        check(&format!("{name}.rs"), &rust(&compiled));
    }
    for name in ["tmv710a", "tilting_ram"] {
        let compiled = machine::compiled(&format!("machines/{name}.mach"), &machine::Files);
        check(&format!("{name}_kins.c"), &c(&compiled).expect("its rotary axes have names of LinuxCNC"));
    }
}
