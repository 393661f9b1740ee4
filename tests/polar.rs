//! Turning centres without Y, seen from outside: where X, Z and C go, and what they do not reach.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;
#[path = "common/solving.rs"]
mod solving;

use serde_json::json;
use solving::{PLAIN, chosen, solved, told};

fn lathe(tool: &str) -> String {
    format!(
        "{PLAIN}machine m {{
    chain w C b Z X t
    linear X along +x  travel -1 .. 300
    linear Z along +z
    rotary C about +z
    tool {tool}
    controller plain {{ }}
}}
"
    )
}

const FACE: &str = "along +z length 80";

#[test]
fn on_the_face_c_turns_every_point_to_x() {
    let cl = "RAPID\nGOTO/30,40,5,0,0,1\nRAPID\nGOTO/0,-20,5\nRAPID\nGOTO/-20,-0.0001,5\n";
    let ways: Vec<_> = solved(&lathe(FACE), cl).iter().map(|line| chosen(line, ["X", "Z", "C"])).collect();
    assert_eq!(ways[0], [50.0, 85.0, 53.130102]);
    assert_eq!(ways[1], [20.0, 85.0, -90.0]);
    assert_eq!(ways[2], [20.0, 85.0, -179.999714]);
}

#[test]
fn there_are_two_ways_one_on_each_side_of_the_centre() {
    let line = &solved(&lathe(FACE), "RAPID\nGOTO/30,40,5,0,0,1\n")[0];
    let x: Vec<f64> = [0, 1].map(|way| line["candidates"][way]["joints"]["X"].as_f64().expect("a number")).to_vec();
    assert!((x[0] + x[1]).abs() < 1e-12 && (x[0].abs() - 50.0).abs() < 1e-12, "{x:?}");
}

#[test]
fn at_the_centre_c_stays_where_it_is() {
    let cut = "FEDRAT/100\nGOTO/0,30,0,0,0,1\nGOTO/0,0,0\nGOTO/0,0,-1\n";
    let ways: Vec<_> = solved(&lathe(FACE), cut).iter().map(|line| chosen(line, ["X", "C"])).collect();
    assert_eq!(ways, [[30.0, 90.0], [0.0, 90.0], [0.0, 90.0]]);
}

#[test]
fn a_tool_beside_the_centre_has_a_dead_radius() {
    let beside = lathe("along +z at (0, 12, 0) length 80");
    let cl = "RAPID\nGOTO/3,4,0,0,0,1\nRAPID\nGOTO/0,13,0\n";
    let lines = solved(&beside, cl);
    assert!(lines[0]["chosen"].is_null(), "{}", lines[0]);
    let told_of = &lines[0]["problem"]["inside_dead_radius"];
    let close = |key: &str, wanted: f64| (told_of[key].as_f64().expect("a number") - wanted).abs() < 1e-9;
    assert!(close("mm", 7.0) && close("radius_mm", 12.0), "{told_of}");
    assert_eq!(chosen(&lines[1], ["X"]), [5.0]);
    let (status, stderr) = told(&beside, cl);
    assert_eq!(status, 1);
    assert!(
        stderr.contains("error[E1107]: `m` has two linear axes, and no angle brings the point to them"),
        "{stderr}"
    );
    assert!(stderr.contains("7.000 mm inside the dead radius of 12.000 mm"), "{stderr}");
}

#[test]
fn the_tool_does_not_tilt_on_the_face() {
    let line = &solved(&lathe(FACE), "RAPID\nGOTO/30,40,5,0,0.6,0.8\n")[0];
    let off = line["problem"]["out_of_reach"]["deg"].as_f64().expect("a number");
    assert!((off - 36.869897645844).abs() < 1e-9, "{off}");
}

#[test]
fn on_the_circumference_the_tool_axis_passes_through_the_spindles() {
    let across = lathe("along +x length 80");
    let cl = "RAPID\nGOTO/0,50,-10,0,1,0\nRAPID\nGOTO/3,50,-10\nRAPID\nGOTO/0.0005,50,-10\n";
    let lines = solved(&across, cl);
    assert_eq!(chosen(&lines[0], ["X", "Z", "C"]), [130.0, -10.0, 90.0]);
    assert_eq!(lines[1]["problem"], json!({ "off_plane": { "mm": 3.0 } }));
    assert_eq!(chosen(&lines[2], ["X", "C"]), [130.0, 90.0]);
    let (status, stderr) = told(&across, cl);
    assert_eq!(status, 1);
    assert!(stderr.contains("error[E1108]: `m` has two linear axes, and the point is off their plane"), "{stderr}");
    assert!(stderr.contains("off the plane by 3.000 mm") && stderr.contains("it needs a Y axis"), "{stderr}");
}
