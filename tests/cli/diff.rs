//! `machc diff` from outside: what a change in a machine file does to the motion.

use serde_json::Value;

use crate::machc::{MILL, Run, Workshop};

/// A workshop with `new.mach`: the mill with each first text replaced by the second.
fn workshop(name: &str, changes: &[(&str, &str)]) -> Workshop {
    let workshop = Workshop::new(name);
    let change = |text: String, (from, to): &(&str, &str)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    };
    workshop.write("new.mach", &changes.iter().fold(MILL.to_owned(), change));
    workshop
}

fn compared(workshop: &Workshop, cl: &str) -> (i32, Value) {
    let Run { status, stdout, stderr } = workshop.run(&["diff", "--json", "mill.mach", "new.mach", cl]);
    (status, serde_json::from_str(&stdout).unwrap_or_else(|_| panic!("{stderr}")))
}

fn word<'a>(found: &'a Value, name: &str) -> &'a Value {
    found["words"].as_array().unwrap().iter().find(|word| word["name"] == name).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

#[test]
fn the_same_machine_moves_in_the_same_way() {
    // Neither a name nor a comment moves anything.
    let workshop = workshop("diff-same", &[("machine mill", "machine other // renamed\n")]);
    let run = workshop.run(&["diff", "mill.mach", "new.mach", "part.cls"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.starts_with("the same motion at all 3 points of part.cls\n"), "{}", run.stdout);
    assert_eq!(compared(&workshop, "part.cls").1["same"], true);
}

#[test]
fn a_centre_elsewhere_changes_words_and_not_the_pose() {
    let workshop = workshop("diff-centre", &[("through (0, 0, -20)  travel", "through (0, 0, -20.1)  travel")]);
    let (status, found) = compared(&workshop, "part.cls");
    assert_eq!((status, &found["points"], &found["changed"]["points"]), (1, &3.into(), &1.into()));
    assert_eq!(found["changed"]["first_line"], 6);
    // A turns by 36.87 degrees there: the old words miss by 0.1 mm times twice the sine of half of that.
    let missed = &found["old_words_on_new"]["tip_mm"];
    assert!((number(&missed["value"]) - 0.063_246).abs() < 1.5e-3, "{missed}");
    assert_eq!(missed["line"], 6);
    assert!(number(&found["apart"]["tip_mm"]["value"]) < 2e-3, "{found}");
    assert_eq!(number(&found["apart"]["axis_rad"]["value"]), 0.0);
    let y = word(&found, "Y");
    assert!((number(&y["largest"]["value"]) - 0.06).abs() < 1e-9, "{y}");
    assert!((number(&y["new"]) - number(&y["old"])).abs() > 0.0599, "{y}");
    assert_eq!((&word(&found, "A")["points"], &found["branch"]["points"]), (&0.into(), &0.into()));
    let margin = |side: &str| number(&found[side]["axes"][1]["upper_margin"]);
    assert!((margin("old") - margin("new") - 0.06).abs() < 1e-9, "{found}");
}

#[test]
fn the_other_solution_is_told() {
    let workshop = workshop(
        "diff-branch",
        &[("    controller plain { }", "branch { start negative A then negative A }\n    controller plain { }")],
    );
    workshop
        .write("tilt.cls", "FEDRAT/100\nGOTO/0,0,0,0,-0.3,0.953939201416946\nGOTO/5,0,0,0,-0.3,0.953939201416946\n");
    let (status, found) = compared(&workshop, "tilt.cls");
    assert_eq!((status, &found["branch"]["points"], &found["branch"]["first_line"]), (1, &2.into(), &2.into()));
    assert_eq!(found["turns"], serde_json::json!({}));
    assert!(number(&found["apart"]["tip_mm"]["value"]) < 2e-3, "{found}");
}

#[test]
fn whole_turns_are_told() {
    let workshop = workshop("diff-turns", &[("turns unlimited", "travel 270 .. 700")]);
    let (status, found) = compared(&workshop, "part.cls");
    assert_eq!(status, 1);
    assert_eq!(found["branch"]["points"], 0);
    assert_eq!(found["turns"]["C"]["points"], 3, "{found}");
    let run = workshop.run(&["diff", "mill.mach", "new.mach", "part.cls"]);
    assert!(run.stdout.contains("whole turns of C     3 points, first at line 3\n"), "{}", run.stdout);
}

#[test]
fn points_out_of_travel_are_told_and_margins() {
    let workshop =
        workshop("diff-travel", &[("linear X along +x  travel -300 .. 300", "linear X along +x travel -300 .. 15")]);
    let (status, found) = compared(&workshop, "part.cls");
    assert_eq!(
        (status, &found["one_only"]["points"], &found["new"]["refused"]["first_line"]),
        (1, &1.into(), &6.into())
    );
    assert_eq!(found["new"]["reason"], "X beyond its travel");
    assert_eq!(found["old"]["refused"]["points"], 0);
    assert_eq!(number(&found["old"]["axes"][0]["upper_margin"]), 280.0);
    assert_eq!(number(&found["new"]["axes"][0]["upper_margin"]), 5.0);
    assert_eq!(found["new"]["axes"][4]["upper_margin"], Value::Null);
    let text = workshop.run(&["diff", "mill.mach", "new.mach", "part.cls"]).stdout;
    assert!(text.contains("new.mach cannot go to 1 point, first at line 6: X beyond its travel\n"), "{text}");
}

#[test]
fn machines_with_other_axes_are_compared_by_their_pose() {
    let changes = [
        ("rotary A about +x", "rotary B about +y"),
        ("chain w C A b", "chain w C B b"),
        ("word X Y Z", "word B X Y Z"),
    ];
    let workshop = workshop("diff-axes", &changes);
    let (status, found) = compared(&workshop, "part.cls");
    assert_eq!(status, 1);
    assert_eq!((&found["only_old"], &found["only_new"]), (&serde_json::json!(["A"]), &serde_json::json!(["B"])));
    assert_eq!((&found["branch"], &found["old_words_on_new"]), (&Value::Null, &Value::Null));
    assert!(number(&found["apart"]["tip_mm"]["value"]) < 2e-3, "{found}");
    assert!(number(&found["apart"]["axis_rad"]["value"]) < 2e-5, "{found}");
}

#[test]
fn inputs_with_errors_are_not_compared() {
    let workshop = workshop("diff-errors", &[("rotary A about", "rotary A abuot")]);
    workshop.write("bad.cls", "FEDRAT/100\nGOTO/0,0,x\n");
    workshop
        .write("silent.mach", MILL.split_once("machine mill").unwrap().1.replace("controller plain { }", "").as_str());
    let silent = format!("machine mill{}", workshop.read("silent.mach"));
    workshop.write("silent.mach", &silent);
    for (arguments, said) in [
        (["mill.mach", "new.mach", "part.cls"], "error[E0"),
        (["silent.mach", "mill.mach", "part.cls"], "error[E1106]"),
        (["mill.mach", "mill.mach", "bad.cls"], "--> bad.cls:2"),
        (["mill.mach", "mill.mach", "no.cls"], "cannot read `no.cls`"),
        (["mill.mach", "no.mach", "part.cls"], "cannot read `no.mach`"),
    ] {
        let run = workshop.run(&[&["diff"], &arguments[..]].concat());
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(said), "{arguments:?}: {}", run.stderr);
    }
}

#[test]
fn the_table_fits_the_terminal() {
    let workshop = workshop("diff-table", &[("through (0, 0, -20)  travel", "through (0, 0, -20.1)  travel")]);
    let text = workshop.run(&["diff", "mill.mach", "new.mach", "part.cls"]).stdout;
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    assert!(!text.contains("-0.0000 "), "{text}");
    for heading in ["word ", "in the workpiece ", "rotary solution ", "to the limits "] {
        assert!(text.lines().any(|line| line.starts_with(heading)), "{heading}: {text}");
    }
}
