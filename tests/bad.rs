//! Mistakes and what is said of them: `tests/bad/NAME.mach` and the rendered diagnostics in `NAME.stderr`.
//!
//! `MACHC_BLESS=1 cargo test --test bad` writes the expected text anew. Read what you accept.

use mach_command::render::plain;
use machc::codes;
use machc::compile::compile;
use machc::sources::Sources;
use std::fs;
use std::path::{Path, PathBuf};

#[path = "common/stems.rs"]
mod stems;

use stems::stems;

/// Files below `tests/bad`.
struct Folder(PathBuf);

impl Sources for Folder {
    fn read(&self, path: &str) -> Result<String, String> {
        fs::read_to_string(self.0.join(path)).map_err(|_| "no such file".to_owned())
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad")
}

fn rendered(stem: &str) -> String {
    match compile(&format!("{stem}.mach"), &Folder(folder())) {
        Ok(compiled) if compiled.warnings.is_empty() => panic!("{stem}.mach has no mistake"),
        Ok(compiled) => plain(&compiled.warnings),
        Err(diagnostics) => plain(&diagnostics),
    }
}

#[test]
fn every_mistake_is_shown_as_expected() {
    let bless = std::env::var_os("MACHC_BLESS").is_some();
    let mut wrong = Vec::new();
    for stem in stems("tests/bad", "mach") {
        let path = folder().join(format!("{stem}.stderr"));
        let found = rendered(&stem);
        if bless {
            fs::write(&path, &found).expect("tests/bad can be written");
        } else if fs::read_to_string(&path).ok().as_ref() != Some(&found) {
            wrong.push(format!("{stem}.mach now gives:\n\n{found}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_expected_text_is_left_over() {
    assert_eq!(stems("tests/bad", "stderr"), stems("tests/bad", "mach"));
}

#[test]
fn every_code_of_the_model_and_the_checks_has_its_example() {
    let texts: String = stems("tests/bad", "mach").iter().map(|stem| rendered(stem)).collect();
    let of_the_model = |id: &str| ["E02", "E03", "E04", "E055", "W0"].iter().any(|group| id.starts_with(group));
    for code in codes::all().into_iter().filter(|code| of_the_model(code.id)) {
        assert!(texts.contains(&format!("[{}]", code.id)), "no file in tests/bad shows {}", code.id);
    }
}
