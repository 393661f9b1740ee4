//! Three-axis operations under an MSYS that is turned: a point without a tool axis has that of its MSYS.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::{Run, Workshop};

const TRUNNION: &str = "\
use \"controllers/syntec.mach\"
machine trunnion {
    chain w C A b X Y Z t
    linear X along +x  travel -500 .. 500
    linear Y along +y  travel -500 .. 500
    linear Z along +z  travel -500 .. 500
    rotary A about +x  through (0, 0, -20)  travel -30 .. 120
    rotary C about +z  through (0, 0, -20)  turns unlimited
    tool along +z
    controller syntec { write C 0 .. 360 }
}
";

/// An operation on the top, one on the front, and one on the top again, each begun by a point with this tool axis.
fn part(axis: &str) -> String {
    let top = "MSYS/0.0,0.0,0.0,1.0,0.0,0.0,0.0,1.0,0.0";
    let front = "MSYS/0.0,-40.0,-30.0,1.0,0.0,0.0,0.0,0.0,1.0";
    let operations = [("TOP", top), ("FRONT", front), ("TOP_AGAIN", top)].map(|(name, frame)| {
        format!(
            "TOOL PATH/{name},TOOL,M\n{frame}\nLOAD/TOOL,1\nSPINDL/RPM,4000,CLW\nRAPID\nGOTO/0.0,0.0,30.0{axis}\nFEDRAT/MMPM,500.0\n\
             GOTO/5.0,7.0,0.0\nEND-OF-PATH\n"
        )
    });
    operations.concat()
}

/// The program for this part.
fn program(name: &str, cl: &str) -> Vec<String> {
    let workshop = Workshop::new(name);
    workshop.write("trunnion.mach", TRUNNION);
    workshop.write("part.cls", cl);
    let Run { status, stdout, stderr } = workshop.run(&["post", "trunnion.mach", "part.cls"]);
    assert_eq!(status, 0, "{stderr}");
    stdout.lines().map(|line| line.split_once(' ').map_or(line, |(_, words)| words).to_owned()).collect()
}

#[test]
fn the_tool_axis_is_the_z_of_the_msys_in_force() {
    let lines = program("turned", &part(""));
    assert_eq!(lines, program("written", &part(",0.0,0.0,1.0")));
    let begins = lines.iter().position(|line| line == "(FRONT)").expect("the second operation");
    assert_eq!(lines[begins + 1..][..3], ["S4000 M3", "G0 X0.0 Y-10. Z50. A90.", "G1 X5. Y-3. Z20."]);
}

#[test]
fn a_tool_axis_that_is_given_holds_until_the_next_msys() {
    let tilted = part("").replacen("GOTO/5.0,7.0,0.0", "GOTO/5.0,7.0,0.0,0.0,-0.6,0.8\nGOTO/6.0,7.0,0.0", 1);
    let lines = program("tilted", &tilted);
    let turns: Vec<&str> = lines.iter().flat_map(|line| line.split(' ')).filter(|word| word.starts_with('A')).collect();
    assert_eq!(turns, ["A0.0", "A36.87", "A90.", "A0.0"]);
}
