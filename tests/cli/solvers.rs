//! `--solver`, and `machc compare-solvers`.

use super::machc::Workshop;
use serde_json::Value;

#[test]
fn a_program_is_the_same_whatever_solves() {
    let workshop = Workshop::new("solver");
    let post = |solver: &str| workshop.run(&["post", "-q", "mill.mach", "part.cls", "--solver", solver]);
    let expected = post("closed-form");
    assert_eq!((expected.status, expected.stderr.as_str()), (0, ""));
    assert_eq!(expected.stdout, workshop.run(&["post", "-q", "mill.mach", "part.cls"]).stdout);
    for solver in ["newton", "broyden"] {
        assert_eq!(post(solver).stdout, expected.stdout, "{solver}");
    }
    assert_eq!(post("guess").status, 2);
}

#[test]
fn a_point_is_solved_whatever_solves() {
    let workshop = Workshop::new("solver_solve");
    let solve = |solver: &str| -> Vec<Value> {
        let run = workshop.run(&["solve", "mill.mach", "part.cls", "--solver", solver]);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{solver}");
        run.stdout.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
    };
    let chosen = |line: &Value| {
        let joints = &line["candidates"][line["chosen"].as_u64().expect("chosen") as usize]["joints"];
        ["X", "Y", "Z", "A", "C"].map(|axis| joints[axis].as_f64().expect("a number"))
    };
    let expected = solve("closed-form");
    for solver in ["newton", "broyden"] {
        for (found, expected) in solve(solver).iter().zip(&expected) {
            for (a, b) in chosen(found).into_iter().zip(chosen(expected)) {
                assert!((a - b).abs() < 1e-6, "{solver}: {found} {expected}");
            }
        }
    }
}

#[test]
fn a_direction_beyond_the_reach_is_refused_whatever_solves() {
    let workshop = Workshop::new("solver_reach");
    let machine = super::machc::MILL.replace("chain w C A b", "chain w A b").replace("rotary C about", "// ");
    workshop.write("mill.mach", &machine);
    workshop.write("part.cls", "FEDRAT/100\nGOTO/1,2,3,0,0,1\nGOTO/4,5,6,1,0,0\n");
    for solver in ["closed-form", "newton", "broyden"] {
        let run = workshop.run(&["post", "mill.mach", "part.cls", "--solver", solver]);
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{solver}");
        assert!(run.stderr.starts_with("error[E1101]"), "{solver}: {}", run.stderr);
        assert!(run.stderr.contains("part.cls:3:1"), "{solver}: {}", run.stderr);
    }
}

#[test]
fn the_solvers_are_compared() {
    let workshop = Workshop::new("compare_solvers");
    let table = workshop.run(&["compare-solvers", "mill.mach", "part.cls"]);
    assert_eq!((table.status, table.stderr.as_str()), (0, ""));
    assert!(table.stdout.starts_with("mill along the 3 points of part.cls\n"), "{}", table.stdout);
    let row = |title: &str| -> Vec<String> {
        let line = table.stdout.lines().find_map(|line| line.strip_prefix(title)).expect("the row is there");
        line.split_whitespace().map(str::to_owned).collect()
    };
    assert_eq!(row("points without a solution"), ["0", "0", "0"]);
    assert_eq!(row("steps halved")[..2], ["-", "0"]);

    let run = workshop.run(&["--json", "compare-solvers", "mill.mach", "part.cls"]);
    let lines: Vec<Value> = run.stdout.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let names: Vec<&Value> = lines.iter().map(|line| &line["solver"]).collect();
    assert_eq!(names, ["closed-form", "newton", "broyden"]);
    for line in &lines {
        assert!(line["tip_error_mm"]["value"].as_f64().expect("a number") <= 1e-9, "{line}");
        assert!(line["axis_error_rad"]["value"].as_f64().expect("a number") <= 1e-12, "{line}");
        assert_eq!((&line["points"], &line["failures"]), (&3.into(), &0.into()));
        let is_iterated = line["solver"] != "closed-form";
        assert_eq!(line["iterations"]["mean"].as_f64().is_some_and(|mean| mean > 0.0), is_iterated, "{line}");
    }
}

#[test]
fn the_solvers_are_compared_on_the_machine_with_its_errors() {
    let workshop = Workshop::new("compare_solvers_errors");
    let table = "    error EXX { at -300: 10 um at 300: -20 um }\n    error EAC { at 0: 9 urad at 180: -9 urad }\n    tool along";
    workshop.write("mill.mach", &super::machc::MILL.replace("    tool along", table));
    let run = workshop.run(&["--json", "compare-solvers", "mill.mach", "part.cls"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert_eq!(run.stdout.lines().count(), 3);
    for line in run.stdout.lines() {
        let line: Value = serde_json::from_str(line).expect("JSON");
        assert!(line["tip_error_mm"]["value"].as_f64().expect("a number") <= 1e-9, "{line}");
    }
}

#[test]
fn equations_and_data_are_written() {
    let workshop = Workshop::new("emit_data");
    let page = workshop.run(&["emit", "equations", "mill.mach"]);
    assert_eq!(page.status, 0, "{}", page.stderr);
    assert!(page.stdout.contains("i &= \\sin A \\sin C"), "{}", page.stdout);
    let data = workshop.run(&["emit", "json", "mill.mach", "-o", "mill.json"]);
    assert_eq!((data.status, data.stdout.as_str()), (0, ""), "{}", data.stderr);
    let machine: Value = serde_json::from_str(&workshop.read("mill.json")).expect("JSON");
    assert_eq!((&machine["name"], &machine["chain"][0]["axis"]), (&"mill".into(), &"C".into()));
}
