//! Six axes and more: what `lock`, `prefer` and `free` make of the axes that a pose leaves open, seen from outside.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;
#[path = "common/solving.rs"]
mod solving;

use solving::{PLAIN, chosen, solved, told};

/// Z and a quill beside it.
fn quill(branch: &str) -> String {
    format!(
        "{PLAIN}machine m {{
    chain w C A b X Y Z W t
    linear X along +x
    linear Y along +y
    linear Z along +z  travel -50 .. 50
    linear W along +z  travel -100 .. 0
    rotary A about +x  travel -30 .. 120 deg
    rotary C about +z
    tool along +z
    branch {{ {branch} }}
    controller plain {{ }}
}}
"
    )
}

/// A head whose B reaches 10 degrees, with an A behind it.
fn head(branch: &str) -> String {
    format!(
        "{PLAIN}machine m {{
    chain w C b X Y Z B A t
    linear X along +x
    linear Y along +y
    linear Z along +z
    rotary A about +x  through (0, 0, 150)  travel -90 .. 90 deg
    rotary B about +y  through (0, 0, 150)  travel -10 .. 10 deg
    rotary C about +z
    tool along +z
    branch {{ {branch} }}
    controller plain {{ }}
}}
"
    )
}

/// Down out of Z's travel and up again.
const DOWN: &str = "RAPID\nGOTO/0,0,0,0,0,1\nRAPID\nGOTO/0,0,-80\nRAPID\nGOTO/0,0,-80.5\nRAPID\nGOTO/0,0,0\n";

fn quill_goes(branch: &str) -> Vec<[f64; 2]> {
    solved(&quill(branch), DOWN).iter().map(|line| chosen(line, ["Z", "W"])).collect()
}

#[test]
fn a_preferred_axis_leaves_its_place_only_where_it_must() {
    assert_eq!(quill_goes("prefer W 0 mm"), [[0.0, 0.0], [-50.0, -30.0], [-49.5, -31.0], [0.0, 0.0]]);
    assert_eq!(quill_goes("prefer W -20")[0], [20.0, -20.0]);
}

#[test]
fn a_free_axis_stays_until_it_must_go() {
    assert_eq!(quill_goes("free W"), [[0.0, 0.0], [-50.0, -30.0], [-49.5, -31.0], [31.0, -31.0]]);
}

#[test]
fn a_locked_axis_never_moves() {
    let lines = solved(&quill("lock W -1 in"), DOWN);
    assert_eq!(chosen(&lines[0], ["Z", "W"]), [25.4, -25.4]);
    assert!(lines[1]["chosen"].is_null(), "{}", lines[1]);
    assert_eq!(lines[1]["problem"], "out_of_travel");
}

#[test]
fn a_third_rotary_helps_out_where_two_do_not_reach() {
    let cl = "RAPID\nGOTO/0,0,0,0.1,0,0.994987437107\nRAPID\nGOTO/0,0,0,.5,0,.866025403784\nRAPID\nGOTO/5,0,0,0,0,1\n";
    let axes = |branch: &str| -> Vec<[f64; 2]> {
        solved(&head(branch), cl).iter().map(|line| chosen(line, ["A", "B"])).collect()
    };
    // cos 30 deg = cos A cos B: with B within 10 degrees A is beyond 28.4.
    let tilt_b = libm::acos(0.866025403784 / libm::cos(29_f64.to_radians())).to_degrees();
    let preferred = axes("prefer A 0 deg");
    assert_eq!([preferred[0][0], preferred[1][0], preferred[2][0]], [0.0, 29.0, 0.0]);
    assert!((preferred[1][1].abs() - tilt_b).abs() < 1e-5, "{preferred:?}");
    let free = axes("free A");
    assert_eq!([free[0][0], free[1][0]], [0.0, 29.0]);
    // The vertical cannot be reached with A at 29: it goes as far back as it must.
    assert!(free[2][0].abs() <= 10.0, "{free:?}");
}

#[test]
fn any_two_of_three_rotaries_may_be_the_ones_that_are_solved_for() {
    let cl = "RAPID\nGOTO/10,20,30,0.1,0.05,0.993730345736\n";
    for (branch, axis, value) in [("lock A 3 deg", "A", 3.0), ("lock B 4 deg", "B", 4.0), ("lock C 20 deg", "C", 20.0)]
    {
        assert_eq!(chosen(&solved(&head(branch), cl)[0], [axis]), [value], "{branch}");
    }
}

#[test]
fn a_jump_in_a_cut_is_a_reposition() {
    let cut = "FEDRAT/100\nGOTO/0,0,0,0,0,1\nGOTO/0,0,-80\nGOTO/0,0,0\n";
    let (status, stderr) = told(&quill("free W"), cut);
    assert_eq!(status, 1, "{stderr}");
    assert!(
        stderr.contains("error[E1103]: a surplus axis jumps in the middle of a cut\n --> part.cls:3:1\n"),
        "{stderr}"
    );
    assert!(stderr.contains("W goes from 0.000 mm to -30.000 mm"), "{stderr}");
    assert!(stderr.contains("no way to this point with W at 0.000 mm"), "{stderr}");
    assert_eq!(stderr.matches("E1103").count(), 1, "a free axis stays where it went: {stderr}");
    let (status, stderr) = told(&quill("prefer W 0 reposition warn"), cut);
    assert_eq!((status, stderr.matches("warning[W1103]").count()), (0, 2), "{stderr}");
    assert!(stderr.contains("back to where the machine file prefers it"), "{stderr}");
}

#[test]
fn a_family_member_says_something_else_of_an_axis() {
    let family = quill("lock W -20").replace("machine m {", "machine family {");
    let workshop = machc::Workshop::new("family");
    workshop.write("family.mach", &family);
    workshop.write("m.mach", "use \"family.mach\"\nmachine m like family {\n    branch { prefer W -10 }\n}\n");
    let run = workshop.run_with(&["solve", "m.mach", "-"], DOWN);
    let first = serde_json::from_str(run.stdout.lines().next().expect("a point")).expect("JSON");
    assert_eq!(chosen(&first, ["Z", "W"]), [10.0, -10.0], "{}", run.stderr);
}
