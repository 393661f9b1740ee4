//! The command line from outside: output, diagnostics, exit status, files.

#[path = "cli/diff.rs"]
mod diff;
#[path = "cli/machc.rs"]
mod machc;
#[path = "cli/new.rs"]
mod new;
#[path = "cli/solvers.rs"]
mod solvers;
#[path = "cli/test.rs"]
mod test;

use machc::{Run, Workshop};
use serde_json::Value;

#[test]
fn a_sound_machine_passes() {
    let workshop = Workshop::new("check");
    let Run { status, stdout, stderr } = workshop.run(&["check", "mill.mach", "mill.mach"]);
    assert_eq!((status, stdout.as_str(), stderr.as_str()), (0, "", ""));
}

#[test]
fn a_mistake_in_a_machine_is_shown_and_refused() {
    let workshop = Workshop::new("mistake");
    workshop.write("bad.mach", &machc::MILL.replace("rotary A about", "rotary A abuot"));
    let run = workshop.run(&["check", "bad.mach", "mill.mach"]);
    assert_eq!(run.status, 1);
    assert!(run.stderr.starts_with("error[E0"), "{}", run.stderr);
    assert!(run.stderr.contains("--> bad.mach:35:14\n"), "{}", run.stderr);
}

#[test]
fn files_that_are_not_there_are_no_mistake_of_the_input() {
    let workshop = Workshop::new("missing");
    for arguments in [
        &["check", "no.mach"][..],
        &["show", "no.mach"],
        &["emit", "rust", "no.mach"],
        &["emit", "c", "mill.mach", "-o", "no/mill.c"],
        &["emit", "pascal", "mill.mach"],
        &["post", "no.mach", "part.cls"],
        &["post", "mill.mach", "no.cls"],
        &["solve", "mill.mach", "no.cls"],
        &["solve", "--joints", "mill.mach", "no.jsonl"],
        &["solve", "--joints", "mill.mach", "part.cls", "--solver", "newton"],
        &["fmt", "no.mach"],
        &["post", "mill.mach", "part.cls", "-o", "no/part.nc"],
        &["post", "mill.mach", "part.cls", "-o", "."],
        &["explain", "E9999"],
        &["frobnicate"],
        &["post", "mill.mach", "part.cls", "--tool-length", "long"],
        &["post", "mill.mach", "part.cls", "--threads", "0"],
        &["post", "mill.mach", "part.cls", "--solver", "guess"],
    ] {
        let run = workshop.run(arguments);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{arguments:?}: {}", run.stderr);
        assert!(!run.stderr.is_empty(), "{arguments:?}");
    }
}

#[test]
fn a_folder_that_is_not_there_is_named() {
    let workshop = Workshop::new("no-folder");
    for (file, folder) in [("no/such/part.nc", "no/such"), ("part.cls/part.nc", "part.cls")] {
        let run = workshop.run(&["post", "mill.mach", "part.cls", "-o", file]);
        assert_eq!(run.stderr, format!("error: cannot write `{file}`: there is no folder `{folder}`\n"));
    }
}

#[test]
fn a_program_goes_to_standard_output_and_the_certificate_beside_it() {
    let workshop = Workshop::new("stdout");
    let run = workshop.run(&["post", "mill.mach", "part.cls"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(run.stdout.contains("G1 X10.000"), "{}", run.stdout);
    assert!(run.stderr.contains("certificate"), "{}", run.stderr);
    let quiet = workshop.run(&["post", "-q", "mill.mach", "part.cls", "-o", "-"]);
    assert_eq!((quiet.stdout, quiet.stderr.as_str()), (run.stdout, ""));
}

#[test]
fn a_program_appears_in_its_file() {
    let workshop = Workshop::new("file");
    let printed = workshop.run(&["post", "mill.mach", "part.cls"]).stdout;
    workshop.write("part.nc", "an older program");
    let run = workshop.run(&["post", "mill.mach", "part.cls", "-o", "part.nc"]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
    assert_eq!(workshop.read("part.nc"), printed);
    assert_eq!(workshop.files(), ["mill.mach", "part.cls", "part.nc"]);
}

#[test]
fn an_error_leaves_an_older_program_as_it_is() {
    let workshop = Workshop::new("no_output");
    workshop.write("old.nc", "an older program");
    workshop.write("bad.cls", "FEDRAT/100\nGOTO/0,0,0\nGOTO/5000,0,0\n");
    let run = workshop.run(&["post", "mill.mach", "bad.cls", "-o", "old.nc"]);
    assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{}", run.stderr);
    assert_eq!(workshop.read("old.nc"), "an older program");
    assert_eq!(workshop.files(), ["bad.cls", "mill.mach", "old.nc", "part.cls"]);
}

#[test]
fn a_point_that_cannot_be_reached_is_shown_with_its_line() {
    let workshop = Workshop::new("quote");
    workshop.write("far.cls", "FEDRAT/100\nGOTO/0,0,0\nGOTO/9999,0,0 $$ far\n");
    let run = workshop.run(&["post", "mill.mach", "far.cls"]);
    assert!(run.stderr.contains("3 | GOTO/9999,0,0 $$ far\n"), "{}", run.stderr);
}

#[test]
fn source_code_appears_whole_or_not_at_all() {
    let workshop = Workshop::new("emit");
    for (form, wanted) in [("rust", "impl Kinematics for Solver {"), ("c", "int kinematicsInverse(")] {
        let printed = workshop.run(&["emit", form, "mill.mach"]);
        assert_eq!((printed.status, printed.stderr.as_str()), (0, ""));
        assert!(printed.stdout.contains(wanted) && printed.stdout.contains("from mill.mach"), "{}", printed.stdout);
        let run = workshop.run(&["emit", form, "mill.mach", "-o", "source"]);
        assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
        assert_eq!(workshop.read("source"), printed.stdout);
    }
    let machine = "machine lathe {\n  chain w C1 b X Y Z t\n  linear X along +x\n  linear Y along +y\n  linear Z along +z\n\
                   rotary C1 about +z\n  tool along +x\n}\n";
    workshop.write("renamed.mach", machine);
    let before = workshop.read("source");
    let run = workshop.run(&["emit", "c", "renamed.mach", "-o", "source"]);
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.starts_with("error[E0602]") && run.stderr.contains("--> renamed.mach:6:"), "{}", run.stderr);
    assert_eq!(workshop.read("source"), before);
}

#[test]
fn generated_source_names_no_folder_of_ones_own() {
    let (workshop, elsewhere) = (Workshop::new("emit_here"), Workshop::new("emit_elsewhere"));
    let outside = elsewhere.path("mill.mach");
    for form in ["rust", "c"] {
        let wanted = workshop.run(&["emit", form, "mill.mach"]).stdout;
        assert!(wanted.contains("from mill.mach") && wanted.contains("// mill.mach:"), "{wanted}");
        let inside = workshop.path("mill.mach").canonicalize().unwrap();
        for path in [&inside, &outside] {
            assert_eq!(workshop.run(&["emit", form, path.to_str().unwrap()]).stdout, wanted);
        }
    }
}

#[test]
fn diagnostics_and_certificates_for_tools() {
    let workshop = Workshop::new("json");
    let run = workshop.run(&["--json", "post", "mill.mach", "part.cls"]);
    let certificate: Value = serde_json::from_str(run.stderr.lines().last().unwrap()).unwrap();
    assert_eq!(certificate["type"], "certificate");
    assert_eq!(certificate["points"], 3);
    assert_eq!(certificate["axes"][0]["name"], "X");

    workshop.write("bad.cls", "FEDRAT/100\nGOTO/0,0,x\n");
    let run = workshop.run(&["post", "--json", "mill.mach", "bad.cls"]);
    let diagnostic: Value = serde_json::from_str(run.stderr.lines().next().unwrap()).unwrap();
    assert_eq!(diagnostic["type"], "diagnostic");
    assert_eq!(diagnostic["code"], "E1013");
    let label = &diagnostic["labels"][0];
    assert_eq!((&label["line"], &label["column"], &label["end_column"]), (&2.into(), &10.into(), &11.into()));
    assert!(diagnostic["rendered"].as_str().unwrap().starts_with("error[E1013]"));

    let run = workshop.run(&["--json", "check", "no.mach"]);
    let failure: Value = serde_json::from_str(&run.stderr).unwrap();
    assert_eq!(failure["type"], "failure");
}

#[test]
fn standard_input_is_a_file_like_others() {
    let workshop = Workshop::new("stdin");
    let part = workshop.read("part.cls");
    let run = workshop.run_with(&["post", "mill.mach", "-", "--program", "part"], &part);
    assert_eq!(run.stdout, workshop.run(&["post", "mill.mach", "part.cls"]).stdout, "{}", run.stderr);
    assert_eq!(workshop.run_with(&["check", "-"], machc::MILL).status, 0);
    assert_eq!(workshop.run_with(&["post", "mill.mach", "-"], "GOTO/1").status, 1);
}

#[test]
fn solving_reads_standard_input_as_well() {
    let workshop = Workshop::new("solve_stdin");
    let printed = workshop.run(&["solve", "mill.mach", "part.cls"]).stdout;
    assert_eq!(workshop.run_with(&["solve", "mill.mach", "-"], &workshop.read("part.cls")).stdout, printed);
    assert!(workshop.run_with(&["solve", "mill.mach", "-"], "GOTO/1").stderr.contains("--> <stdin>:1:7\n"));
}

#[test]
fn solving_goes_both_ways() {
    let workshop = Workshop::new("solve");
    let solved = workshop.run(&["solve", "mill.mach", "part.cls"]);
    assert_eq!(solved.status, 0, "{}", solved.stderr);
    let lines: Vec<Value> = solved.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines.len(), 3);
    for line in &lines {
        let chosen = &line["candidates"][line["chosen"].as_u64().unwrap() as usize];
        let back = workshop.run_with(&["solve", "--joints", "mill.mach", "-"], &chosen.to_string());
        let pose: Value = serde_json::from_str(&back.stdout).unwrap();
        for field in ["tip_mm", "axis"] {
            for i in 0..3 {
                let off = pose[field][i].as_f64().unwrap() - line[field][i].as_f64().unwrap();
                assert!(off.abs() < 1e-9, "{pose} {line}");
            }
        }
    }
}

#[test]
fn joint_values_that_are_none() {
    let workshop = Workshop::new("joints");
    let run = workshop.run_with(&["solve", "--joints", "mill.mach", "-"], "[1,2,3,4,5]\n\n{\"X\":1}\nnonsense\n");
    assert_eq!(run.status, 1);
    assert_eq!(run.stdout.lines().count(), 1);
    assert_eq!(run.stderr.matches("error[E1040]").count(), 2, "{}", run.stderr);
    assert!(run.stderr.contains("--> <stdin>:3:1\n"), "{}", run.stderr);
}

#[test]
fn joint_values_of_other_axes() {
    let workshop = Workshop::new("other_joints");
    for (line, said) in [
        ("[1,2,3,4,5,6]", "6 values for 5 axes: X, Y, Z, A, C"),
        ("[1,2,3,4]", "4 values for 5 axes: X, Y, Z, A, C"),
        ("[1,2,3,4,\"5\"]", "the value of axis C is not a number"),
        (r#"{"X":1,"Y":2,"Z":3,"A":4,"C":5,"W":6}"#, "the machine has no axis W\n"),
        (r#"{"X":1,"Y":2,"Z":3,"a":4,"C":5}"#, "the machine has no axis a, and there is no value for axis A\n"),
        (r#"{"X":1,"Y":2,"Z":3}"#, "]: there is no value for axis A, C\n"),
        (r#"{"X":1,"Y":2,"Z":3,"A":null,"C":5}"#, "the value of axis A is not a number"),
        ("5", "this is neither an object nor an array"),
    ] {
        let run = workshop.run_with(&["solve", "--joints", "mill.mach", "-"], line);
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{line}");
        assert!(run.stderr.starts_with("error[E1040]: ") && run.stderr.contains(said), "{line}: {}", run.stderr);
    }
}

#[test]
fn formatting_in_place_and_to_standard_output() {
    let workshop = Workshop::new("fmt");
    workshop.write("untidy.mach", &machc::MILL.replace("    ", "  "));
    let check = workshop.run(&["fmt", "--check", "untidy.mach"]);
    assert_eq!((check.status, check.stdout.as_str()), (1, "untidy.mach\n"));
    let printed = workshop.run_with(&["fmt", "-"], &workshop.read("untidy.mach")).stdout;
    assert_eq!(workshop.run(&["fmt", "untidy.mach"]).status, 0);
    assert_eq!(workshop.read("untidy.mach"), printed);
    assert_eq!(workshop.run(&["fmt", "--check", "untidy.mach"]).status, 0);
    workshop.write("broken.mach", "machine {");
    assert_eq!(workshop.run(&["fmt", "broken.mach"]).status, 1);
    assert_eq!(workshop.read("broken.mach"), "machine {");
}

#[test]
fn every_code_is_explained() {
    let workshop = Workshop::new("explain");
    let list = workshop.run(&["explain"]).stdout;
    assert!(list.lines().count() > 60, "{list}");
    for line in list.lines() {
        let (id, title) = line.split_once("  ").unwrap();
        let explained = workshop.run(&["explain", &id.to_lowercase()]);
        assert!(explained.stdout.starts_with(&format!("{id}: {title}\n\n")), "{id}");
        assert!(explained.stdout.lines().count() < 30, "{id} does not fit a screen");
    }
}

#[test]
fn a_machine_is_shown() {
    let workshop = Workshop::new("show");
    let run = workshop.run(&["show", "mill.mach"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(run.stdout.contains("w C A b X Y Z t"), "{}", run.stdout);
}

#[test]
fn a_reader_that_has_seen_enough_is_no_failure() {
    let workshop = Workshop::new("pipe");
    workshop.write("long.cls", &format!("FEDRAT/100\n{}", "GOTO/0,0,0\nGOTO/1,0,0\n".repeat(20_000)));
    for arguments in
        [&["show", "mill.mach"][..], &["solve", "mill.mach", "long.cls"], &["post", "mill.mach", "long.cls"]]
    {
        let (status, stderr) = workshop.run_unread(arguments);
        assert_eq!(status, 0, "{arguments:?}: {stderr}");
        assert!(!stderr.contains("panicked"), "{stderr}");
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_with_a_name_is_read_once() {
    let workshop = Workshop::new("fifo");
    let pipe = workshop.path("pipe.cls");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let writer = std::thread::spawn(move || std::fs::write(pipe, "FEDRAT/100\nGOTO/9999,0,0\n").unwrap());
    let run = workshop.run(&["post", "mill.mach", "pipe.cls"]);
    writer.join().unwrap();
    assert_eq!(run.status, 1);
    assert!(run.stderr.contains("--> pipe.cls:2:1\n"), "{}", run.stderr);
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_not_replaced() {
    let workshop = Workshop::new("link");
    std::os::unix::fs::symlink("real.nc", workshop.path("link.nc")).unwrap();
    workshop.write("real.nc", "");
    assert_eq!(workshop.run(&["post", "mill.mach", "part.cls", "-o", "link.nc"]).status, 0);
    assert!(workshop.read("real.nc").ends_with("M30\n"));
    assert!(std::fs::symlink_metadata(workshop.path("link.nc")).unwrap().is_symlink());
}

#[test]
fn help_fits_the_terminal() {
    let workshop = Workshop::new("help");
    for command in [
        "new",
        "test",
        "review",
        "diff",
        "check",
        "post",
        "verify",
        "motion",
        "show",
        "solve",
        "compare-solvers",
        "emit",
        "fmt",
        "explain",
    ] {
        for flag in ["-h", "--help"] {
            let help = workshop.run(&[command, flag]).stdout;
            assert!(help.lines().all(|line| line.chars().count() <= 80), "{help}");
        }
    }
}
