//! The tool in the spindle, and whether it turns: what the CL says once holds until it says something else.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::{Run, Workshop};

/// Posts CL for a machine of three axes with a shipped controller.
fn post(name: &str, controller: &str, cl: &str) -> Run {
    let workshop = Workshop::new(name);
    let machine = format!(
        "use \"controllers/{controller}.mach\"\nmachine mill {{\n    chain w X Y b Z t\n    linear X along +x  travel -400 .. 400\n    \
         linear Y along +y  travel -400 .. 400\n    linear Z along +z  travel -500 .. 300\n    tool along +z\n    \
         controller {controller} {{ }}\n}}\n"
    );
    workshop.write("mill.mach", &machine);
    workshop.write("part.cls", cl);
    workshop.run(&["post", "mill.mach", "part.cls"])
}

/// The lines of a program that is posted without a warning, without their sequence numbers.
fn lines(name: &str, controller: &str, cl: &str) -> Vec<String> {
    let Run { status, stdout, stderr } = post(name, controller, cl);
    assert_eq!(status, 0, "{stderr}");
    assert!(!stderr.contains("warning["), "{stderr}");
    stdout.lines().map(|line| line.trim_start_matches(|c: char| c == 'N' || c.is_ascii_digit()).trim().into()).collect()
}

/// An operation that begins with these records.
fn operation(records: &str) -> String {
    format!(
        "TOOL PATH/CUT,TOOL,MILL\n{records}RAPID\nGOTO/0,0,50,0,0,1\nFEDRAT/MMPM,500\nGOTO/0,0,-1\nGOTO/30,0,-1\nRAPID\nGOTO/30,0,50\n\
         END-OF-PATH\n"
    )
}

#[test]
fn the_tool_that_is_in_the_spindle_is_not_changed() {
    let on = "SPINDL/RPM,8000,CLW\n";
    for (name, first, second, changes) in [
        ("same", "LOAD/TOOL,1,ADJUST,1", "LOAD/TOOL,1", &["T1 M6"][..]),
        ("other", "LOAD/TOOL,1", "LOAD/TOOL,2", &["T1 M6", "T2 M6"]),
        ("register", "LOAD/TOOL,1", "LOAD/TOOL,1,ADJUST,11", &["T1 M6", "T1 M6"]),
        ("zero", "LOAD/TOOL,0", "LOAD/TOOL,0", &["T0 M6"]),
    ] {
        let cl = operation(&format!("{first}\n{on}")) + &operation(&format!("{second}\n{on}"));
        let lines = lines(name, "syntec", &cl);
        let found: Vec<&String> = lines.iter().filter(|line| line.contains("M6")).collect();
        assert_eq!(found, changes, "{name}");
        let ways_out = lines.iter().filter(|line| line.starts_with("G53")).count();
        assert_eq!(ways_out, changes.len() + 1, "one for each change, and one at the end");
    }
}
