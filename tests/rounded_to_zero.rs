//! A speed or a dwell of the CL that its word rounds to zero is refused: the spindle would stand in the cut.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::{Run, Workshop};

/// Posts a toolpath with this record for the shipped vertical machine with another picture of the speed.
fn post(name: &str, controller: &str, record: &str) -> Run {
    let workshop = Workshop::new(name);
    let machine = format!(
        "use \"controllers/syntec.mach\"\nmachine mill {{\n    chain w b X Y Z t\n    linear X along +x  travel -500 .. 500\n    \
         linear Y along +y  travel -500 .. 500\n    linear Z along +z  travel -500 .. 500\n    tool along +z\n    \
         controller syntec {{ {controller} }}\n}}\n"
    );
    workshop.write("mill.mach", &machine);
    let cl =
        format!("TOOL PATH/SLOW,TOOL,MILL\nLOAD/TOOL,1\n{record}\nFEDRAT/MMPM,100\nGOTO/0,0,5,0,0,1\nEND-OF-PATH\n");
    workshop.write("part.cls", &cl);
    workshop.run(&["post", "mill.mach", "part.cls"])
}

#[test]
fn a_speed_or_a_dwell_that_rounds_to_zero_is_refused_at_its_record() {
    for (name, record, value) in [
        ("zero-speed", "SPINDL/RPM,0.4,CLW", "the value 0.4 of `{speed}`"),
        ("zero-dwell", "DELAY/0.0001", "the value 0.1 of `{milliseconds}`"),
    ] {
        let Run { status, stdout, stderr } = post(name, "", record);
        assert_eq!((status, stdout.as_str()), (1, ""), "{stderr}");
        assert!(stderr.contains(&format!("error[E1165]: {value} is zero once it is rounded")), "{stderr}");
        assert!(stderr.contains("--> part.cls:3:1"), "{stderr}");
    }
}

#[test]
fn a_picture_with_decimals_has_room_for_it() {
    let controller = "on spindle clockwise { \"S{speed:###0[.##]} M3\" }";
    let Run { status, stdout, stderr } = post("slow-speed", controller, "SPINDL/RPM,0.4,CLW");
    assert_eq!(status, 0, "{stderr}");
    assert!(stdout.contains("S0.4 M3"), "{stdout}");
}
