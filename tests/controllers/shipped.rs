//! The shipped controllers: a whole program of each, byte for byte.

use crate::describe::dialect;
use mach_runtime::cl::event::{Approach, Feed};
use mach_runtime::machine::{Axis, Motion, Travel, Written};
use mach_runtime::nc::dialect::{Dialect, Trigger};
use mach_runtime::nc::writer::{Values, Writer};

const SYNTEC: &str = include_str!("../../machines/controllers/syntec.mach");
const SIEMENS: &str = include_str!("../../machines/controllers/siemens.mach");

fn axes() -> Vec<Axis> {
    let axis = |(name, motion): (&str, Motion)| Axis {
        name: name.into(),
        motion,
        travel: Travel::UNLIMITED,
        written: Written::Unwound,
        zero: 0.0,
        length_share: 0.0,
        rapid_per_min: None,
    };
    let linear = ["X", "Y", "Z"].map(|name| axis((name, Motion::Linear)));
    let rotary = ["A", "C"].map(|name| axis((name, Motion::Rotary)));
    linear.into_iter().chain(rotary).collect()
}

fn lowered(text: &str) -> Dialect {
    dialect(text, &["X", "Y", "Z", "A", "C"]).unwrap_or_else(|diagnostics| panic!("{diagnostics:#?}"))
}

/// A program with everything a controller has a block for.
fn program(dialect: Dialect) -> String {
    let mut writer = Writer::new(dialect, &axes());
    let mut out = Vec::new();
    let values = Values {
        program: "sine-surface",
        operation: "ROUGH (1)",
        text: "check the \"probe\"",
        tool: 3,
        register: 3,
        speed_rpm: 7999.6,
        dwell_s: 1.25,
        ..Values::default()
    };
    use Trigger::{
        CoolantFlood, CoolantOff, Dwell, End, Message, Operation, SpindleClockwise, SpindleOff, Start, Tool,
    };
    let feed = Approach::Feed(Some(Feed::PerMinute(1234.56)));
    let turning = Approach::Feed(Some(Feed::PerRevolution(0.05)));
    let command = |writer: &mut Writer, triggers: &[Trigger], out: &mut Vec<u8>| {
        for trigger in triggers {
            writer.command(*trigger, &values, out).expect("the command is printed");
        }
    };
    let motion = |writer: &mut Writer, approach, joints: [f64; 5], out: &mut Vec<u8>| {
        writer.motion(approach, &joints, 0.0, out).expect("the motion is printed");
    };
    command(&mut writer, &[Start, Operation, Tool, SpindleClockwise, CoolantFlood], &mut out);
    motion(&mut writer, Approach::Rapid, [70.711, 18.271, 21.124, 23.955, 315.0], &mut out);
    motion(&mut writer, feed, [0.483, 0.0, 25.0, 0.0, 0.002], &mut out);
    motion(&mut writer, feed, [0.483, -0.5, 25.0, 0.0, 0.002], &mut out);
    motion(&mut writer, turning, [0.483, -12.7, 25.0, 0.0, 0.002], &mut out);
    command(&mut writer, &[Dwell, Message, SpindleOff, CoolantOff, End], &mut out);
    String::from_utf8(out).expect("NC text is ASCII")
}

fn unnumbered(text: &str) -> String {
    text.replace("sequence \"N\" start 10 step 10", "sequence none //")
}

fn inch(text: &str) -> String {
    text.replace("units mm\n", "units inch\n")
}

#[test]
fn syntec_in_millimetres() {
    let expected = "\
%
(SINE_SURFACE)
N10 G17 G21 G40 G49 G80 G90 G94
(ROUGH 1)
N20 M9
N30 M5
N40 G53 G0 Z0.
N50 T3 M6
N60 G54
N70 G43 H03
N80 S8000 M3
N90 M8
N100 G0 X70.711 Y18.271 Z21.124 A23.955 C315.
N110 G1 X.483 Y0.0 Z25. A0.0 C.002 F1234.6
N120 Y-.5
N130 Y-12.7 G95 F.05
N140 G4 P1250
(check the probe)
N150 M5
N160 M9
N170 M9
N180 M5
N190 G53 G0 Z0.
N200 M30
%
";
    assert_eq!(program(lowered(SYNTEC)), expected);
}

#[test]
fn siemens_in_millimetres() {
    let expected = "\
; %_N_SINE_SURFACE_MPF
N10 G54
N20 G17 G710 G40 G90 G94
N30 G64
; ROUGH (1)
N40 M9
N50 M5
N60 G0 SUPA Z0 D0
N70 T3
N80 M6
N90 G54
N100 D1
N110 S8000 M3
N120 M8
N130 G0 X70.711 Y18.271 Z21.124 A23.955 C315
N140 G1 X0.483 Y0 Z25 A0 C0.002 F1234.6
N150 Y-0.5
N160 Y-12.7 G95 F0.05
N170 G4 F1.25
N180 MSG(\"check the probe\")
N190 M5
N200 M9
N210 M9
N220 M5
N230 G0 SUPA Z0 D0
N240 M30
";
    assert_eq!(program(lowered(SIEMENS)), expected);
}

/// The lines that print a motion.
fn motions(program: &str) -> Vec<&str> {
    program.lines().filter(|line| ["G0 X", "G1 X", "Y"].iter().any(|head| line.starts_with(head))).collect()
}

#[test]
fn both_in_inches() {
    let syntec = program(lowered(&unnumbered(&inch(SYNTEC))));
    assert!(syntec.contains("\nG17 G20 G40"), "{syntec}");
    let expected = [
        "G0 X2.7839 Y.7193 Z.8317 A23.955 C315.",
        "G1 X.019 Y0.0 Z.9843 A0.0 C.002 F48.6",
        "Y-.0197",
        "Y-.5 G95 F.00197",
    ];
    assert_eq!(motions(&syntec), expected);
    let siemens = program(lowered(&unnumbered(&inch(SIEMENS))));
    assert!(siemens.contains("\nG17 G700 G40"), "{siemens}");
    let expected = [
        "G0 X2.7839 Y0.7193 Z0.8317 A23.955 C315",
        "G1 X0.019 Y0 Z0.9843 A0 C0.002 F48.6",
        "Y-0.0197",
        "Y-0.5 G95 F0.00197",
    ];
    assert_eq!(motions(&siemens), expected);
}

#[test]
fn file_names_end_as_the_control_wants() {
    assert_eq!(lowered(SYNTEC).extension, "nc");
    assert_eq!(lowered(SIEMENS).extension, "mpf");
}
