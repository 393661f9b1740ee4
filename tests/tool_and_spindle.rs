//! The tool in the spindle, and whether it turns: what the CL says once holds until it says something else.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::{Run, Workshop};

/// Posts CL for a machine of three axes with a shipped controller, perhaps with blocks of its own behind the name.
fn post(name: &str, controller: &str, cl: &str) -> Run {
    let (controller, own) = controller.split_once(' ').unwrap_or((controller, ""));
    let workshop = Workshop::new(name);
    let machine = format!(
        "use \"controllers/{controller}.mach\"\nmachine mill {{\n    chain w X Y b Z t\n    linear X along +x  travel -400 .. 400\n    \
         linear Y along +y  travel -400 .. 400\n    linear Z along +z  travel -500 .. 300\n    tool along +z\n    \
         controller {controller} {{ {own} }}\n}}\n"
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
    for (controller, first, second, changes) in [
        ("syntec", "LOAD/TOOL,1,ADJUST,1", "LOAD/TOOL,1", &["T1 M6"][..]),
        ("syntec", "LOAD/TOOL,1", "LOAD/TOOL,2", &["T1 M6", "T2 M6"]),
        ("syntec", "LOAD/TOOL,1", "LOAD/TOOL,1,ADJUST,11", &["T1 M6", "T1 M6"]),
        ("siemens", "LOAD/TOOL,0", "LOAD/TOOL,0", &["T0"]),
    ] {
        let cl = operation(&format!("{first}\n{on}")) + &operation(&format!("{second}\n{on}"));
        let lines = lines("change", controller, &cl);
        let found: Vec<&String> = lines.iter().filter(|line| line.starts_with('T')).collect();
        assert_eq!(found, changes, "{first} {second}");
        let ways_out = lines.iter().filter(|line| line.contains("G53") || line.contains("SUPA")).count();
        assert_eq!(ways_out, changes.len() + 1, "one for each change, and one at the end");
    }
}

#[test]
fn a_block_with_the_tool_s_register_needs_a_tool() {
    let spindle = "SPINDL/RPM,8000,CLW\n";
    let begins_at_feed = format!("TOOL PATH/CUT,TOOL,MILL\n{spindle}FEDRAT/MMPM,500\nGOTO/0,0,50,0,0,1\nEND-OF-PATH\n");
    let register_zero = format!("LOAD/TOOL,0\n{spindle}");
    for (name, cl, line) in
        [("rapid", operation(spindle), 4), ("feed", begins_at_feed, 4), ("zero", operation(&register_zero), 5)]
    {
        let Run { status, stdout, stderr } = post(name, "syntec", &cl);
        assert_eq!((status, stdout.as_str()), (1, ""), "{stderr}");
        assert!(
            stderr.contains("error[E1166]: the block prints `{register}`, and no tool is in the spindle"),
            "{stderr}"
        );
        assert!(stderr.contains(&format!("--> part.cls:{line}:1")), "{stderr}");
        assert_eq!(stderr.matches("error[").count(), 1, "{stderr}");
    }
    let lines = lines("no-register", "siemens", &operation(spindle));
    assert!(lines.contains(&"G1 Z-1 F500".into()), "its blocks of motion print no register: {lines:?}");
}

#[test]
fn a_cut_with_a_standing_spindle_is_told_once() {
    let (tool, on, off) = ("LOAD/TOOL,1\n", "SPINDL/RPM,8000,CLW\n", "SPINDL/OFF\n");
    let never = operation(tool) + &operation(tool);
    let no_longer = operation(&format!("{tool}{on}")) + off + &operation("");
    for (name, cl, line) in [("never", never, 6), ("no-longer", no_longer, 17)] {
        let Run { status, stderr, .. } = post(name, "syntec", &cl);
        assert_eq!((status, stderr.matches("warning[").count()), (0, 1), "{stderr}");
        assert!(stderr.contains("warning[W1105]: a motion at feed while the spindle stands"), "{stderr}");
        assert!(stderr.contains(&format!("--> part.cls:{line}:1")), "{stderr}");
    }
    lines("in-rapid", "syntec", &format!("{}{off}RAPID\nGOTO/0,0,100\n", operation(&format!("{tool}{on}"))));
}

/// What comes behind a tool change, up to the first motion at feed.
fn behind_the_second_change(lines: &[String]) -> Vec<&str> {
    let change = lines.iter().rposition(|line| line.starts_with('T')).expect("a tool change");
    lines[change + 1..].iter().map(String::as_str).take_while(|line| !line.starts_with("G1")).collect()
}

#[test]
fn what_a_tool_change_switches_off_is_on_again_before_the_first_cut() {
    let first = operation("LOAD/TOOL,1\nSPINDL/RPM,8000,CCLW\nCOOLNT/MIST\n");
    let own = "on tool { \"M09M05 (ALL OFF)\" \"T{tool} M6\" }";
    for (controller, second, expected) in [
        ("syntec", "", &["G54", "G0 X0.0 Y0.0", "G43 H02 Z50.", "S8000 M4", "M7"][..]),
        ("siemens", "", &["M6", "G54", "D1", "G0 X0 Y0", "Z50", "S8000 M4", "M7"]),
        ("syntec", "COOLNT/OFF\n", &["G54", "M9", "G0 X0.0 Y0.0", "G43 H02 Z50.", "S8000 M4"]),
        ("syntec", "SPINDL/RPM,500,CLW\n", &["G54", "S500 M3", "G0 X0.0 Y0.0", "G43 H02 Z50.", "M7"]),
        (&format!("syntec {own}"), "", &["G0 X0.0 Y0.0", "G43 H02 Z50.", "S8000 M4", "M7"]),
        ("syntec on tool { \"T{tool} M6 (M5)\" }", "", &["G0 X0.0 Y0.0", "G43 H02 Z50."]),
    ] {
        let cl = first.clone() + &operation(&format!("LOAD/TOOL,2\n{second}"));
        let lines = lines("again", controller, &cl);
        assert_eq!(behind_the_second_change(&lines), expected, "{controller}: {lines:#?}");
    }
}

#[test]
fn what_a_stop_switches_off_is_on_again_before_the_next_cut() {
    let cl =
        operation("LOAD/TOOL,1\nSPINDL/RPM,8000,CLW\nCOOLNT/FLOOD\n") + "OPSTOP\nRAPID\nGOTO/0,0,50\nGOTO/0,0,-1\n";
    let lines = lines("stop", "syntec on optional stop { \"M5\" \"M1\" }", &cl);
    let stop = lines.iter().position(|line| line == "M1").expect("a stop");
    assert_eq!(lines[stop + 1..][..3], ["X0.0", "S8000 M3", "G1 Z-1."]);
}

#[test]
fn a_spindle_that_turns_is_not_switched_on_again() {
    let cl = operation("LOAD/TOOL,1\nSPINDL/RPM,8000,CLW\nCOOLNT/FLOOD\n") + &operation("STOP\nSPINDL/RPM,900,CCLW\n");
    let own = "on spindle counterclockwise { \"M5\" \"S{speed} M4\" }";
    let lines = lines("turns", &format!("syntec {own}"), &cl);
    for (word, count) in [("M3", 1), ("M4", 1), ("M8", 1)] {
        assert_eq!(lines.iter().filter(|line| line.ends_with(word)).count(), count, "{word}: {lines:#?}");
    }
}

#[test]
fn all_coolants_that_are_on_are_on_again_before_the_next_cut() {
    let cl = operation("LOAD/TOOL,1\nSPINDL/RPM,8000,CLW\nCOOLNT/MIST\nCOOLNT/FLOOD\n");
    let lines = lines("both", "syntec", &(cl + &operation("LOAD/TOOL,2\n")));
    let again = ["G54", "G0 X0.0 Y0.0", "G43 H02 Z50.", "S8000 M3", "M8", "M7"];
    assert_eq!(behind_the_second_change(&lines), again, "{lines:#?}");
}
