//! At the end of an axis' travel its word is rounded towards the inside: the control would refuse a value beyond it.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::{Run, Workshop};

/// The words with this address in a program through these points, of a machine with these axes.
fn words(name: &str, address: char, axes: &str, points: &str) -> Vec<String> {
    let workshop = Workshop::new(name);
    let machine = format!(
        "use \"controllers/syntec.mach\"\nmachine mill {{\n    chain w C A b X Y Z t\n    linear Y along +y  travel -400 .. 400\n    \
         linear Z along +z  travel -400 .. 400\n    rotary C about +z  turns unlimited\n    tool along +z\n    {axes}\n}}\n"
    );
    workshop.write("mill.mach", &machine);
    workshop.write("part.cls", &format!("LOAD/TOOL,1\nSPINDL/RPM,100\nFEDRAT/500\n{points}"));
    let Run { status, stdout, stderr } = workshop.run(&["post", "mill.mach", "part.cls"]);
    assert_eq!(status, 0, "{stderr}");
    let words = stdout.split_whitespace().filter_map(|word| word.strip_prefix(address));
    words.map(str::to_owned).collect()
}

#[test]
fn a_word_that_would_be_rounded_out_of_the_travel_is_rounded_into_it() {
    let axes = |zero: &str, controller: &str| {
        format!(
            "linear X along +x  travel -99.9996 .. 99.9996\n    rotary A about +x  travel -30 .. 120\n    {zero}\n    \
             controller syntec {{ {controller} }}"
        )
    };
    let points = "GOTO/99.9992,0,10,0,0,1\nGOTO/0,0,10\nGOTO/99.9996,0,10\nGOTO/0,0,10\nGOTO/-99.9996,0,10\n";
    assert_eq!(words("travel", 'X', &axes("", ""), points), ["99.999", "0.0", "99.999", "0.0", "-99.999"]);
    let inches = ["3.9369", "0.0", "3.9369", "0.0", "-3.9369"];
    assert_eq!(words("inch", 'X', &axes("", "units inch"), points), inches);
    let shifted = "GOTO/100.4996,0,10,0,0,1\nGOTO/-99.4996,0,10\n";
    assert_eq!(words("zero", 'X', &axes("zero (-0.5, 0, 0)", ""), shifted), ["100.499", "-99.499"]);
}

#[test]
fn a_rotary_word_stays_within_its_travel_too() {
    let axes =
        "linear X along +x  travel -99 .. 99\n    rotary A about +x  travel -30 .. 59.9996\n    controller syntec { }";
    let (sine, cosine) = libm::sincos(59.9996_f64.to_radians());
    let point = format!("GOTO/0,0,10,0,{:.12},{cosine:.12}\n", -sine);
    assert_eq!(words("rotary", 'A', axes, &point), ["59.999"]);
}
