//! `machc toolpath` from outside: a CL file with everything resolved.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::{Run, Workshop};

/// Every kind of item, modal words left out wherever a CL may.
const CL: &str = "\
TOOL PATH/ROUGH,TOOL,MILL_D10
MSYS/10.0,0.0,0.0,1.0,0.0,0.0,0.0,1.0,0.0
LOAD/TOOL,3,ADJUST,13
FROM/0,0,100
SPINDL/RPM,3000,CLW
COOLNT/FLOOD
RAPID
GOTO/0.0,-0.00004,50.0,0.0,0.0,1.0
FEDRAT/MMPM,250.0
GOTO/10.123456789,0.0,0.0
COOLNT/MIST
PPRINT look at the clamp
DELAY/2.5
GOTO/20.0,0.0,0.0,0.0,-0.6,0.8
MSYS/10.0,50.0,0.0,0.0,1.0,0.0,-1.0,0.0,0.0
FEDRAT/MMPR,0.2
GOTO/1.0,2.0,3.0
GOTO/2.0,2.0,3.0
COOLNT/OFF
OPSTOP
SPINDL/OFF
STOP
END-OF-PATH
";

fn toolpath(name: &str, cl: &str, more: &[&str]) -> Run {
    let workshop = Workshop::new(name);
    workshop.write("all.cls", cl);
    workshop.run(&[&["toolpath", "all.cls"], more].concat())
}

#[test]
fn a_cl_file_as_toolpath() {
    let Run { status, stdout, stderr } = toolpath("toolpath-text", CL, &[]);
    assert_eq!((status, stderr.as_str()), (0, ""));
    insta::assert_snapshot!("cl", stdout);
}

#[test]
fn the_same_as_json_lines() {
    let Run { status, stdout, stderr } = toolpath("toolpath-json", CL, &["--json"]);
    assert_eq!((status, stderr.as_str()), (0, ""));
    insta::assert_snapshot!("cl_json", stdout);
}

#[test]
fn inches_and_decimals_are_as_they_are_asked_for() {
    let cl = "TOOL PATH/A,TOOL,B\nFEDRAT/IPM,10\nGOTO/1,0.5,0\nEND-OF-PATH\n";
    let Run { status, stdout, .. } = toolpath("toolpath-inch", cl, &["--cl-units", "inch", "--decimals", "1"]);
    assert_eq!(status, 0);
    let point: Vec<&str> = stdout.lines().last().expect("a point").split_whitespace().collect();
    assert_eq!(point.join(" "), "3 line 25.4 12.7 0.0 0.0000 0.0000 1.0000 F254");
}

#[test]
fn what_is_wrong_is_told_and_the_rest_is_there() {
    let Run { status, stdout, stderr } = toolpath("toolpath-wrong", "FEDRAT/100\nGOTO/0,0,x\nGOTO/1,2,3\n", &[]);
    assert_eq!(status, 1);
    assert!(stderr.contains("error[E1013]") && stderr.contains("--> all.cls:2:10\n"), "{stderr}");
    assert_eq!(stdout.lines().count(), 2, "{stdout}");
}
