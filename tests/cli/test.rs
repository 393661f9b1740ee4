//! `machc test` and `machc review` from outside: what is posted, compared, accepted and rejected.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::machc::{MILL, Run, Workshop};

const SNAPSHOT: &str = "snapshots/mill@part.snap";
const PENDING: &str = "snapshots/mill@part.snap.new";

/// A workshop with a program in `programs/`.
fn workshop(name: &str) -> Workshop {
    let workshop = Workshop::new(name);
    fs::create_dir(workshop.path("programs")).unwrap();
    fs::rename(workshop.path("part.cls"), workshop.path("programs/part.cls")).unwrap();
    workshop
}

/// The same with the program's output accepted.
fn accepted(name: &str) -> Workshop {
    let workshop = workshop(name);
    assert_eq!(workshop.run(&["test"]).status, 1);
    assert_eq!(workshop.run(&["review", "--accept"]).status, 0);
    workshop
}

/// The machine file's text is part of what is locked.
fn change(workshop: &Workshop) {
    workshop.write("mill.mach", &format!("// changed\n{MILL}"));
}

#[test]
fn new_output_waits_for_a_review_and_is_then_locked() {
    let workshop = workshop("test-new");
    let run = workshop.run(&["test"]);
    assert_eq!(run.status, 1);
    assert_eq!(run.stdout, format!("new       {SNAPSHOT}\n"));
    assert!(run.stderr.contains("0 as accepted, 1 new"), "{}", run.stderr);
    let pending = workshop.read(PENDING);
    let head = "---\nsource: mill.mach\ndescription: part on mill\n---\n==== mill.mach\n";
    assert!(pending.starts_with(head), "{pending}");
    assert!(pending.contains("\n==== programs/part.cls\nwarning[W1110]: "), "{pending}");
    assert!(pending.contains("\ncertificate: "), "{pending}");

    let run = workshop.run(&["review", "--accept"]);
    assert_eq!((run.status, workshop.path(PENDING).exists()), (0, false), "{}", run.stderr);
    assert_eq!(workshop.read(SNAPSHOT), pending);
    let Run { status, stdout, stderr } = workshop.run(&["test"]);
    assert_eq!((status, stdout.as_str(), stderr.as_str()), (0, "", "1 as accepted\n"));
}

#[test]
fn a_change_is_shown_and_can_be_rejected() {
    let workshop = accepted("test-change");
    let locked = workshop.read(SNAPSHOT);
    change(&workshop);
    let run = workshop.run(&["test"]);
    assert_eq!(run.status, 1);
    assert!(run.stdout.starts_with(&format!("differs   {SNAPSHOT}\n@@ ")), "{}", run.stdout);
    assert!(run.stdout.contains("\n+// changed\n"), "{}", run.stdout);
    let coloured = workshop.run(&["test", "--color", "always"]).stdout;
    assert!(coloured.contains("\x1b[32m+// changed\x1b[0m\n"), "{coloured}");

    assert_eq!(workshop.run(&["review", "--reject"]).status, 0);
    assert!(!workshop.path(PENDING).exists());
    assert_eq!(workshop.read(SNAPSHOT), locked);
}

#[test]
fn a_pending_file_goes_when_the_difference_goes() {
    let workshop = accepted("test-gone");
    change(&workshop);
    assert_eq!(workshop.run(&["test"]).status, 1);
    assert!(workshop.path(PENDING).exists());
    workshop.write("mill.mach", MILL);
    assert_eq!(workshop.run(&["test"]).status, 0);
    assert!(!workshop.path(PENDING).exists());
}

#[test]
fn a_review_asks() {
    let workshop = accepted("review-asks");
    fs::copy(workshop.path("programs/part.cls"), workshop.path("programs/more.cls")).unwrap();
    change(&workshop);
    assert_eq!(workshop.run(&["test"]).status, 1);
    let run = workshop.run_with(&["review"], "what\ns\na\n");
    assert_eq!(run.status, 1, "{}", run.stderr);
    assert!(run.stdout.contains("\n+// changed\n"), "{}", run.stdout);
    assert!(run.stdout.contains("1 of 2: snapshots/mill@more.snap"), "{}", run.stdout);
    assert!(run.stderr.contains("1 still pending"), "{}", run.stderr);
    assert!(workshop.read(SNAPSHOT).contains("// changed"));
    assert!(workshop.path("snapshots/mill@more.snap.new").exists());

    let nobody_answers = workshop.run_with(&["review"], "");
    assert_eq!(nobody_answers.status, 1);
    assert_eq!(workshop.run_with(&["review"], "r\n").status, 0);
    assert!(!workshop.path("snapshots/mill@more.snap.new").exists());
    assert_eq!(workshop.run(&["review"]).stderr, "nothing is pending\n");
}

#[test]
fn what_is_accepted_is_what_insta_would_write() {
    let workshop = accepted("review-insta");
    let path = workshop.path(SNAPSHOT);
    let bytes = workshop.read(SNAPSHOT);
    let read = insta::Snapshot::from_file(&path).unwrap();
    assert_eq!(read.metadata().source(), Some("mill.mach"));
    read.save(&path).unwrap();
    assert_eq!(workshop.read(SNAPSHOT), bytes);
    workshop.write(PENDING, &bytes.replacen("description", "assertion_line: 12\ndescription", 1));
    assert_eq!(workshop.run(&["review", "--accept"]).status, 0);
    assert_eq!(workshop.read(SNAPSHOT), bytes);
}

#[test]
fn a_refusal_is_locked_like_a_program() {
    let workshop = workshop("test-refusal");
    workshop.write("programs/part.cls", "FEDRAT/100\nGOTO/0,0,0\nGOTO/9999,0,0\n");
    assert_eq!(workshop.run(&["test"]).status, 1);
    assert!(workshop.read(PENDING).contains("error[E1102]"));
    assert_eq!(workshop.run(&["review", "--accept"]).status, 0);
    assert_eq!(workshop.run(&["test"]).status, 0);
}

#[test]
fn snapshots_that_are_left_over_are_told() {
    let workshop = accepted("test-left-over");
    for name in ["mill@gone", "gone@part", "something_else"] {
        fs::copy(workshop.path(SNAPSHOT), workshop.path(&format!("snapshots/{name}.snap"))).unwrap();
    }
    let run = workshop.run(&["test"]);
    assert_eq!((run.status, run.stdout.lines().count()), (1, 2), "{}", run.stdout);
    assert!(run.stdout.contains("left over snapshots/gone@part.snap: "), "{}", run.stdout);
    // Only this machine's:
    let run = workshop.run(&["test", "mill.mach"]);
    assert_eq!((run.status, run.stdout.lines().count()), (1, 1), "{}", run.stdout);
    assert!(run.stdout.contains("snapshots/mill@gone.snap"), "{}", run.stdout);
}

#[test]
fn a_machines_own_programs_are_only_its_own() {
    let workshop = workshop("test-own");
    workshop.write("other.mach", &MILL.replace("machine mill", "machine other"));
    workshop.write("library.mach", "controller unused { }\n");
    fs::create_dir(workshop.path("programs/other")).unwrap();
    fs::copy(workshop.path("programs/part.cls"), workshop.path("programs/other/own.cls")).unwrap();
    let run = workshop.run(&["test"]);
    let names: Vec<&str> = run.stdout.lines().filter_map(|line| line.strip_prefix("new       snapshots/")).collect();
    assert_eq!(names, ["mill@part.snap", "other@own.snap", "other@part.snap"], "{}", run.stderr);
}

#[test]
fn a_machine_with_errors_is_told_and_the_others_are_tested() {
    let workshop = accepted("test-broken");
    workshop.write("broken.mach", "machine broken {");
    workshop.write("silent.mach", "machine silent { }");
    let run = workshop.run(&["test"]);
    assert_eq!(run.status, 1);
    assert!(run.stderr.contains("--> broken.mach:1"), "{}", run.stderr);
    assert!(run.stderr.ends_with("1 as accepted, 2 machines with errors\n"), "{}", run.stderr);
}

#[test]
fn output_does_not_depend_on_the_folder_that_it_is_made_in() {
    let workshop = accepted("test-folder");
    let home = workshop.path("").to_string_lossy().into_owned();
    for path in [home.as_str(), &format!("{home}mill.mach"), "./mill.mach", "programs/../"] {
        let run = workshop.run(&["test", path]);
        assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{path}: {}", run.stderr);
    }
}

#[test]
fn machines_may_have_a_folder_of_their_own() {
    let workshop = workshop("test-machines");
    fs::create_dir(workshop.path("machines")).unwrap();
    fs::rename(workshop.path("mill.mach"), workshop.path("machines/mill.mach")).unwrap();
    assert_eq!(workshop.run(&["test"]).stdout, format!("new       {SNAPSHOT}\n"));
    for path in ["machines", "machines/mill.mach", "."] {
        assert_eq!(workshop.run(&["test", path]).stdout, format!("new       {SNAPSHOT}\n"), "{path}");
    }
    assert!(workshop.read(PENDING).contains("\n==== machines/mill.mach\n"));
    assert_eq!(workshop.run(&["review", "--accept", "machines/mill.mach"]).status, 0);
    assert_eq!(workshop.run(&["test", "machines"]).status, 0);
}

#[test]
fn nothing_to_test_is_no_success() {
    let workshop = Workshop::new("test-nothing");
    let run = workshop.run(&["test"]);
    assert_eq!(run.status, 2);
    assert!(run.stderr.contains("no programs to post"), "{}", run.stderr);
    fs::remove_file(workshop.path("mill.mach")).unwrap();
    assert_eq!(workshop.run(&["test"]).status, 2);
    assert_eq!(workshop.run(&["test", "no/where"]).status, 2);
}

#[test]
fn results_for_tools() {
    let workshop = accepted("test-json");
    fs::copy(workshop.path("programs/part.cls"), workshop.path("programs/more.cls")).unwrap();
    let lines = |arguments: &[&str]| -> Vec<Value> {
        workshop.run(arguments).stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    };
    let test = lines(&["test", "--json"]);
    assert_eq!((&test[0]["name"], &test[0]["outcome"]), (&"mill@more".into(), &"new".into()));
    assert_eq!((&test[1]["file"], &test[1]["outcome"]), (&SNAPSHOT.into(), &"accepted".into()));
    let review = lines(&["review", "--json"]);
    assert_eq!((review.len(), &review[0]["outcome"]), (1, &"pending".into()));
}

#[test]
fn the_shipped_machines_are_as_accepted() {
    let workshop = Workshop::new("test-shipped");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let run = workshop.run(&["test", root.join("machines/tmv710a.mach").to_str().unwrap()]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
    assert!(run.stderr.contains(" as accepted"), "{}", run.stderr);
}
