//! The shipped controllers: a whole program of each, byte for byte.

use crate::describe::dialect;
use mach_runtime::machine::{Axis, Motion, Rule, Travel, Written};
use mach_runtime::nc::dialect::{Dialect, Trigger};
use mach_runtime::nc::writer::{Values, Writer};
use mach_runtime::toolpath::{Approach, Feed, LoadedTool};

const SYNTEC: &str = include_str!("../../machines/controllers/syntec.mach");
const FANUC: &str = include_str!("../../machines/controllers/fanuc.mach");
const LINUXCNC: &str = include_str!("../../machines/controllers/linuxcnc.mach");
const SIEMENS: &str = include_str!("../../machines/controllers/siemens.mach");

fn axes() -> Vec<Axis> {
    let axis = |(name, motion): (&str, Motion)| Axis {
        name: name.into(),
        motion,
        travel: Travel::UNLIMITED,
        written: Written::Unwound,
        zero: 0.0,
        rule: Rule::Pose,
        length_share: 0.0,
        rapid_per_min: None,
    };
    let linear = ["X", "Y", "Z"].map(|name| axis((name, Motion::Linear)));
    let rotary = ["A", "C"].map(|name| axis((name, Motion::Rotary)));
    let mut axes: Vec<Axis> = linear.into_iter().chain(rotary).collect();
    (axes[2].length_share, axes[2].travel) = (1.0, Travel { lower: -450.0, upper: 60.0 });
    axes
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
        tool: Some(LoadedTool { number: 3, register: 3 }),
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
N20 G54
(ROUGH 1)
N30 M9
N40 M5
N50 G53 G0 Z60.
N60 T3 M6
N70 G54
N80 S8000 M3
N90 M8
N100 G0 A23.955 C315.
N110 X70.711 Y18.271
N120 G43 H03 Z21.124
N130 G1 X.483 Y0.0 Z25. A0.0 C.002 F1234.6
N140 Y-.5
N150 Y-12.7 G95 F.05
N160 G4 P1250
(check the probe)
N170 M5
N180 M9
N190 M9
N200 M5
N210 G53 G0 Z60.
N220 M30
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
; ROUGH 1
N40 M9
N50 M5
N60 G0 SUPA Z60 D0
N70 T3
N80 M6
N90 G54
N100 D1
N110 S8000 M3
N120 M8
N130 G0 A23.955 C315
N140 X70.711 Y18.271
N150 Z21.124
N160 G1 X0.483 Y0 Z25 A0 C0.002 F1234.6
N170 Y-0.5
N180 Y-12.7 G95 F0.05
N190 G4 F1.25
N200 MSG(\"check the probe\")
N210 M5
N220 M9
N230 M9
N240 M5
N250 G0 SUPA Z60 D0
N260 M30
";
    assert_eq!(program(lowered(SIEMENS)), expected);
}

#[test]
fn fanuc_in_millimetres() {
    let expected = "\
%
<SINE_SURFACE>
N10 G21
N20 G17 G40 G49 G80 G90 G94
N30 G54
(ROUGH 1)
N40 M9
N50 M5
N60 G53 G0 Z60.
N70 G49
N80 T3 M6
N90 G54
N100 S8000 M3
N110 M8
N120 G0 A23.955 C315.
N130 X70.711 Y18.271
N140 G43 H03 Z21.124
N150 G1 X.483 Y0. Z25. A0. C.002 F1234.6
N160 Y-.5
N170 Y-12.7 G95 F.05
N180 G4 P1250
(check the probe)
N190 M5
N200 M9
N210 M9
N220 M5
N230 G53 G0 Z60.
N240 G49
N250 M30
%
";
    assert_eq!(program(lowered(FANUC)), expected);
}

#[test]
fn linuxcnc_in_millimetres() {
    let expected = "\
(SINE_SURFACE)
G17 G21 G40 G49 G80 G90 G94 G91.1
G64 P0.002
G54
(operation ROUGH 1)
M9
M5
G53 G0 Z60
G49
T3 M6
G54
S8000 M3
M8
G0 A23.955 C315
X70.711 Y18.271
G43 H3 Z21.124
G1 X0.483 Y0 Z25 A0 C0.002 F1234.6
Y-0.5
Y-12.7 G95 F0.05
G4 P1.25
(MSG, check the probe)
M5
M9
M9
M5
G53 G0 Z60
G49
M2
";
    assert_eq!(program(lowered(LINUXCNC)), expected);
}

/// In inches the end of the travel is rounded into it: 60 mm are 2.36220… inches.
#[test]
fn the_way_out_is_within_the_travel() {
    assert!(program(lowered(&unnumbered(&inch(SYNTEC)))).contains("\nG53 G0 Z2.3622\n"));
    let mut axes = axes();
    for (upper, word) in [(100.0, "Z3.937\n"), (99.997, "Z3.9368\n")] {
        axes[2].travel.upper = upper;
        let mut out = Vec::new();
        let mut writer = Writer::new(lowered(&unnumbered(&inch(SYNTEC))), &axes);
        writer.command(Trigger::End, &Values::default(), &mut out).expect("printed");
        let text = String::from_utf8(out).expect("ASCII");
        assert!(text.contains(&format!("G53 G0 {word}")), "{upper}: {text}");
    }
}

/// The lines of a first motion to these joints with tool 7, on a machine with these axes.
fn approach(text: &str, names: &[&str], approach: Approach) -> String {
    let axes: Vec<Axis> = axes().into_iter().filter(|axis| names.contains(&axis.name.as_str())).collect();
    let dialect = dialect(&unnumbered(text), names).unwrap_or_else(|diagnostics| panic!("{diagnostics:#?}"));
    let mut writer = Writer::new(dialect, &axes);
    let mut out = Vec::new();
    let values = Values { program: "part", tool: Some(LoadedTool { number: 7, register: 7 }), ..Values::default() };
    writer.command(Trigger::Start, &values, &mut out).expect("printed");
    writer.command(Trigger::Tool, &values, &mut out).expect("printed");
    out.clear();
    writer.motion(approach, &vec![1.0; axes.len()], 0.0, &mut out).expect("printed");
    writer.motion(Approach::Rapid, &vec![2.0; axes.len()], 0.0, &mut out).expect("printed");
    String::from_utf8(out).expect("ASCII")
}

#[test]
fn the_tool_is_never_without_its_length() {
    let feed = Approach::Feed(Some(Feed::PerMinute(500.0)));
    let three = &["X", "Y", "Z"];
    let rapid = approach(SYNTEC, three, Approach::Rapid);
    assert_eq!(rapid, "G0 X1. Y1.\nG43 H07 Z1.\nX2. Y2. Z2.\n");
    assert_eq!(approach(SYNTEC, three, feed), "G1 X1. Y1. F500.\nG43 H07 Z1.\nG0 X2. Y2. Z2.\n");
    let five = &["X", "Y", "Z", "A", "C"];
    let cut = approach(SYNTEC, five, feed);
    assert_eq!(cut, "G1 A1. C1. F500.\nX1. Y1.\nG43 H07 Z1.\nG0 X2. Y2. Z2. A2. C2.\n");
    assert_eq!(approach(SYNTEC, five, Approach::Feed(None)), cut.replace(" F500.", ""));
    assert_eq!(approach(SIEMENS, three, Approach::Rapid), "G0 X1 Y1\nZ1\nX2 Y2 Z2\n");
}

/// The lines that print a motion.
fn motions(program: &str) -> Vec<&str> {
    program
        .lines()
        .filter(|line| ["G0 A", "X", "Z", "G43", "G1 X", "Y"].iter().any(|head| line.starts_with(head)))
        .collect()
}

#[test]
fn both_in_inches() {
    let syntec = program(lowered(&unnumbered(&inch(SYNTEC))));
    assert!(syntec.contains("\nG17 G20 G40"), "{syntec}");
    let expected = [
        "G0 A23.955 C315.",
        "X2.7839 Y.7193",
        "G43 H03 Z.8317",
        "G1 X.019 Y0.0 Z.9843 A0.0 C.002 F48.6",
        "Y-.0197",
        "Y-.5 G95 F.00197",
    ];
    assert_eq!(motions(&syntec), expected);
    let siemens = program(lowered(&unnumbered(&inch(SIEMENS))));
    assert!(siemens.contains("\nG17 G700 G40"), "{siemens}");
    let expected = [
        "G0 A23.955 C315",
        "X2.7839 Y0.7193",
        "Z0.8317",
        "G1 X0.019 Y0 Z0.9843 A0 C0.002 F48.6",
        "Y-0.0197",
        "Y-0.5 G95 F0.00197",
    ];
    assert_eq!(motions(&siemens), expected);
}

#[test]
fn file_names_end_as_the_control_wants() {
    assert_eq!(lowered(SYNTEC).extension, "nc");
    assert_eq!(lowered(FANUC).extension, "nc");
    assert_eq!(lowered(LINUXCNC).extension, "ngc");
    assert_eq!(lowered(SIEMENS).extension, "mpf");
}
