//! What the certificate says of the way between two points, on machines and toolpaths whose way was worked out by hand.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::Workshop;

/// A turning centre without Y: C turns the part about Z, X goes across.
const LATHE: &str = r#"
use "controllers/syntec.mach"
machine mill {
    chain w C b Z X t
    linear X along +x  travel -300 .. 300
    linear Z along +z  travel -300 .. 600
    rotary C about +z  through (0, 0, 0)  turns unlimited
    tool along +z
    controller syntec { }
}
"#;

/// A trunnion: A tilts the part, C turns it, both about the program zero.
const TRUNNION: &str = r#"
use "controllers/syntec.mach"
machine mill {
    chain w C A b X Y Z t
    linear X along +x  travel -500 .. 500
    linear Y along +y  travel -500 .. 500
    linear Z along +z  travel -500 .. 500
    rotary A about +x  through (0, 0, 0)  travel -120 .. 120 deg
    rotary C about +z  through (0, 0, 0)  turns unlimited
    tool along +z
    controller syntec { }
}
"#;

/// What is told of a toolpath between a tool change and the end of its path.
fn told(name: &str, machine: &str, motion: &str) -> String {
    let workshop = Workshop::new(name);
    workshop.write("mill.mach", machine);
    let cl = format!("TOOL PATH/CUT,TOOL,MILL\nLOAD/TOOL,1\nSPINDL/RPM,3000,CLW\n{motion}END-OF-PATH\n");
    workshop.write("part.cls", &cl);
    let run = workshop.run(&["post", "mill.mach", "part.cls"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    run.stderr
}

/// The bound that stands in a line of the certificate, in millimetres, and the line of the CL.
fn bound_mm(told: &str, title: &str) -> (f64, u64) {
    let line = told.lines().find_map(|line| line.trim().strip_prefix(title)).expect("a line of the certificate");
    let words: Vec<&str> = line.split_whitespace().collect();
    let ["at", "most", bound, "mm", "at", "line", number] = words[..] else { panic!("{line}") };
    (bound.parse().expect("a number"), number.parse().expect("a line"))
}

/// The bound is not below the true value, and little above it.
fn assert_near(told: &str, title: &str, true_mm: f64, true_line: u64) {
    let (bound, line) = bound_mm(told, title);
    assert_eq!(line, true_line, "{told}");
    assert!((true_mm..1.02 * true_mm).contains(&bound), "{bound} for {true_mm}\n{told}");
}

#[test]
fn a_flat_across_the_face_goes_through_the_middle_of_the_part() {
    // X22.361 C-63.435 to X-22.361 C-116.565: half-way X is zero, 10 mm off the line.
    let motion = "RAPID\nGOTO/10,-20,5,0,0,1\nFEDRAT/MMPM,200\nGOTO/10,-20,-1,0,0,1\nGOTO/10,20,-1,0,0,1\n";
    let told = told("between_flat", LATHE, motion);
    assert_near(&told, "off the line in cuts", 10.0, 8);
    assert!(told.contains("warning[W1110]: in one block of a cut"), "{told}");
}

#[test]
fn a_quarter_turn_in_rapid_dives_below_its_line() {
    // Y goes from 0 to 180, Z from 180 to 10, A from 0 to 90: half-way the tip is at z = (95 + 90) / √2 instead of 180.
    let motion = "RAPID\nGOTO/20,0,180,0,0,1\nRAPID\nGOTO/20,-10,180,0,-1,0\n";
    let told = told("between_rapid", TRUNNION, motion);
    assert_near(&told, "off the line in rapid", 49.186, 7);
    assert!(!told.contains("W1110"), "the warning is of cuts: {told}");
}

#[test]
fn axes_that_only_move_stay_on_their_line() {
    let motion = "FEDRAT/MMPM,200\nGOTO/10,0,5,0,0.6,0.8\nGOTO/80,40,-1,0,0.6,0.8\nGOTO/-80,0,7,0,0.6,0.8\n";
    let told = told("between_straight", TRUNNION, motion);
    assert_eq!(bound_mm(&told, "off the line in cuts").0, 0.0, "{told}");
    assert!(!told.contains("W1110"), "{told}");
}

#[test]
fn a_turn_that_is_written_within_a_turn_goes_on_the_short_way() {
    // A fine ring on the face: C goes on from 359 to 360, whatever its word says.
    let ring = (0..=360).map(|degree| {
        let (sine, cosine) = libm::sincos(f64::from(degree).to_radians());
        format!("GOTO/{:.6},{:.6},0,0,0,1\n", 20.0 * cosine, 20.0 * sine)
    });
    let motion = format!("FEDRAT/MMPM,200\n{}", ring.collect::<String>());
    let machine = LATHE.replace("controller syntec { }", "controller syntec { write C 0 .. 360 }");
    let told = told("between_ring", &machine, &motion);
    assert!(bound_mm(&told, "off the line in cuts").0 < 0.002, "{told}");
}
