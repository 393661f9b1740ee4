//! CL files that no program is made of, and what is said of them: `tests/bad_cl/NAME.cls` and, beside it, `NAME.stderr`.
//!
//! `MACHC_BLESS=1 cargo test --test bad_cl` writes the expected text anew. Read what you accept.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;
#[path = "common/stems.rs"]
mod stems;

use machc::{Run, Workshop};
use std::fs;
use std::path::{Path, PathBuf};
use stems::stems;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad_cl")
}

/// Refuses this CL file, with nothing but diagnostics to show for it, and gives what was said.
fn refused(workshop: &Workshop, cl: &str) -> String {
    let before = workshop.files();
    let to_stdout = workshop.run(&["post", "mill.mach", cl]);
    let to_file = workshop.run(&["post", "mill.mach", cl, "-o", "new.nc"]);
    assert_eq!(workshop.files(), before, "{cl} left something behind");
    for Run { status, stdout, stderr } in [&to_stdout, &to_file] {
        assert_eq!((*status, stdout.as_str()), (1, ""), "{cl}: {stderr}");
        assert!(stderr.contains(&format!("--> {cl}:")), "{cl} without a place: {stderr}");
        assert_eq!(stderr, &to_stdout.stderr);
    }
    to_file.stderr
}

#[test]
fn every_mistake_is_refused_and_shown_as_expected() {
    let bless = std::env::var_os("MACHC_BLESS").is_some();
    let workshop = Workshop::new("bad_cl");
    let mut wrong = Vec::new();
    for stem in stems("tests/bad_cl", "cls") {
        let (cl, expected) = (format!("{stem}.cls"), folder().join(format!("{stem}.stderr")));
        workshop.write_bytes(&cl, &fs::read(folder().join(&cl)).expect("readable"));
        let found = refused(&workshop, &cl);
        if bless {
            fs::write(&expected, &found).expect("tests/bad_cl can be written");
        } else if fs::read_to_string(&expected).ok().as_ref() != Some(&found) {
            wrong.push(format!("{cl} now gives:\n\n{found}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_expected_text_is_left_over() {
    assert_eq!(stems("tests/bad_cl", "stderr"), stems("tests/bad_cl", "cls"));
}

#[test]
fn sizes_that_no_record_has() {
    let workshop = Workshop::new("bad_cl_sizes");
    let line = "1.0, ".repeat(2_000_000);
    let continued = "1.0, $\n".repeat(20_000);
    for (name, text) in [("line", line), ("continued", continued)] {
        let cl = format!("{name}.cls");
        workshop.write(&cl, &format!("FEDRAT/100.0\nGOTO/0.0,0.0,0.0\nGOTO/{text}"));
        let stderr = refused(&workshop, &cl);
        let shown = format!("error[E1002]: this record has more than 64 kB\n --> {cl}:3:1\n");
        assert!(stderr.starts_with(&shown), "{stderr}");
        assert!(stderr.len() < 2000, "{stderr}");
    }
}

#[test]
fn solving_refuses_what_posting_refuses() {
    let workshop = Workshop::new("bad_cl_solve");
    for stem in stems("tests/bad_cl", "cls") {
        let cl = format!("{stem}.cls");
        workshop.write_bytes(&cl, &fs::read(folder().join(&cl)).expect("readable"));
        let run = workshop.run(&["solve", "mill.mach", &cl]);
        assert_eq!(run.status, 1, "{cl}: {}", run.stderr);
    }
}
