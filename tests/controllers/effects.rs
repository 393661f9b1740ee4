//! A controller whose text does something else than it says is refused, with the event and what it does.

const MACHINE: &str = r#"
machine m {
    chain w C A b X Y Z t
    linear X along +x  travel -355 .. 355
    linear Y along +y  travel -310 .. 200
    linear Z along +z  travel -450 .. 60
    rotary A about +x  travel -30 .. 120 deg
    rotary C about +z  turns unlimited
    tool along +z
    controller CONTROLLER { OWN }
}
"#;

use machc::compile::compile;
use machc::sources::Sources;

struct Files(String);

impl Sources for Files {
    fn read(&self, path: &str) -> Result<String, String> {
        match path {
            "m.mach" => Ok(self.0.clone()),
            "controllers/syntec.mach" => Ok(include_str!("../../machines/controllers/syntec.mach").to_owned()),
            "controllers/siemens.mach" => Ok(include_str!("../../machines/controllers/siemens.mach").to_owned()),
            "controllers/heidenhain.mach" => Ok(include_str!("../../machines/controllers/heidenhain.mach").to_owned()),
            _ => Err("no such file".to_owned()),
        }
    }
}

/// The codes and messages of a machine with a shipped controller and statements of its own.
fn told(controller: &str, own: &str) -> Vec<(String, String)> {
    let machine = MACHINE.replace("CONTROLLER", controller).replace("OWN", own);
    let files = Files(format!("use \"controllers/{controller}.mach\"\n{machine}"));
    match compile("m.mach", &files) {
        Ok(_) => Vec::new(),
        Err(found) => found.into_iter().map(|it| (it.code.id.to_owned(), it.message)).collect(),
    }
}

/// Refused once, with this code and these words.
fn assert_refused(controller: &str, own: &str, code: &str, words: &str) {
    let told = told(controller, own);
    assert!(matches!(&told[..], [(id, message)] if id == code && message.contains(words)), "{own}: {told:#?}");
}

#[test]
fn a_cut_is_a_cut() {
    for (own, words) in [
        (r#"on feed { "G0 {axes} {feed}" }"#, "`on feed` moves in rapid traverse"),
        (r#"on feed { "G53 G1 {axes} {feed}" }"#, "does not move on a straight line to the programmed point"),
        (r#"on feed { "G1 {axes} ({feed})" }"#, "does not cut at the feed that it is given"),
        (r#"on feed { "G1 {axes} {feed}" "G91" }"#, "leaves incremental words in force"),
        (r#"on rapid { "G1 {axes}" }"#, "`on rapid` moves at feed"),
        (r#"on feed { "G1 {axes} {feed}" "G94" }"#, "leaves another kind of feed in force"),
        (r#"on rapid { "G94 G0 {axes}" }"#, "leaves another kind of feed in force"),
        (r#"on rapid { "G0 {axes} F3000" }"#, "has a feed, which the next cut would take for its own"),
        (r#"on rapid { "G0 {axes} M5" }"#, "leaves the spindle standing"),
        (r#"on approach { "G0 {axes}" "G43.4 H{register}" }"#, "leaves a function of the control on"),
    ] {
        assert_refused("syntec", own, "E0563", words);
    }
    for (own, words) in [
        (r#"on feed { "{axes} {feed}" }"#, "no code says how the axis moves"),
        (r#"on feed { "(G1) {axes} {feed}" }"#, "no code says how the axis moves"),
        (r#"on feed { "G2 {axes} {feed}" }"#, "the arc has neither a centre nor a radius"),
        (r#"on feed { "G1 {axes} {feed} (cut" }"#, "the comment is not closed in its line"),
        (r#"on feed { "G95 G1 {axes} {feed}" }"#, "two codes that exclude each other"),
        (r#"on feed { "G0 G1 {axes} {feed}" }"#, "two codes that exclude each other"),
        (r#"on approach { "G43.4 H{register}" "G0 {axes}" }"#, "a motion while the tip follows the program"),
        (r#"on rapid { "G0 {axes} X999." }"#, "an axis word that is written out"),
    ] {
        assert_refused("syntec", own, "E0562", words);
    }
}

#[test]
fn every_other_block_does_what_its_event_says_and_no_more() {
    for (own, words) in [
        (r#"on stop { "M0" "G91" }"#, "leaves incremental words in force"),
        (r#"on stop { "M0" "G0G40" }"#, "has the code of a motion"),
        (r#"on message { "({text})" "M5" }"#, "leaves the spindle standing"),
        (r#"on stop { "M0" "M4" }"#, "leaves the spindle turning counterclockwise"),
        (r#"on stop { "M1" }"#, "does an optional stop instead of a stop"),
        (r#"on stop { "M0" "F500" }"#, "has a feed"),
        (r#"on stop { "M0" "G94" }"#, "leaves another kind of feed in force"),
        (r#"on stop { "M0" "G95" }"#, "leaves another kind of feed in force"),
        (r#"on stop { "G40" }"#, "there should be a stop"),
        (r#"on dwell { "G4 P{seconds}" }"#, "a dwell of 0.0015 s instead of a dwell of 1.5 s"),
        (r#"on tool { "G91 G28 {retract}" "T{tool} M6" }"#, "leaves incremental words in force"),
        (r#"on tool { "G0 {retract}" "T{tool} M6" }"#, "otherwise than in rapid traverse and machine coordinates"),
        (r#"on tool { "G53 G1 {retract}" "T{tool} M6" }"#, "otherwise than in rapid traverse and machine coordinates"),
        (r#"on tool { "G53 G0 {retract}" "T{tool}" }"#, "there should be a change to tool 7"),
        (r#"on dwell { "G4 P{milliseconds}" "M9" }"#, "switches the coolant otherwise than it says"),
        (r#"on spindle clockwise { "S{speed} M4" }"#, "turning counterclockwise"),
        (r#"on spindle clockwise { "M3" }"#, "turning clockwise at 500"),
        (r#"on coolant mist { }"#, "switches the coolant otherwise than it says"),
        (r#"on stop { "M0" "G49" }"#, "leaves another length of the tool in force"),
        (r#"on operation { "G43 H2" }"#, "leaves another length of the tool in force"),
        (r#"on rapid { "G0 {axes} G49" }"#, "leaves another length of the tool in force"),
        (r#"on stop { "M0" "G55" }"#, "leaves another work offset in force"),
        (r#"offset 2 on stop { "M0" "G54" }"#, "leaves another work offset in force"),
        (r#"on coolant flood { "M7" }"#, "switches the coolant otherwise than it says"),
        (r#"on end { "M9" }"#, "there should be the end of the program"),
        (r#"on start { "G17 {units} {feed_mode}" }"#, "does not say that words are absolute"),
        (r#"on start { "G90 {feed_mode}" }"#, "does not say the unit of length"),
        (r#"on start { "G90 {units}" }"#, "does not say what the feed counts"),
    ] {
        assert_refused("syntec", own, "E0563", words);
    }
    for (own, words) in [
        (r#"on tool { "G0 ZZ400. G0G0 Q??" "T{tool} M6" }"#, "no word begins with this character"),
        (r#"on tool { "G0 ZZ400." "T{tool} M6" }"#, "the controller knows no word `ZZ400.`"),
        (r#"on tool { "T{register} M6 T{tool}" }"#, "stands twice in one block"),
        (r#"on tool { "T{tool} M6 M11" }"#, "the controller knows no word `M11`"),
        (r#"on stop { "M0" "G54 X5." }"#, "an axis word that is written out"),
        (r#"on stop { "M0" "x 999." }"#, "an axis word that is written out"),
        (r#"on stop { "M0" "X#100" }"#, "no word begins with this character"),
    ] {
        assert_refused("syntec", own, "E0562", words);
    }
    assert_refused("siemens", r#"on stop { "M0" "C1=DC(90)" }"#, "E0562", "no word begins with this character");
}

#[test]
fn a_statement_does_what_its_event_says() {
    for (own, words) in [
        (r#"on feed { "L {axes} R0 {feed} FMAX" }"#, "`on feed` moves in rapid traverse"),
        (r#"on feed { "L {axes} R0 ; {feed}" }"#, "does not cut at the feed that it is given"),
        (r#"on feed { "L {axes} RL {feed}" }"#, "leaves a function of the control on"),
        (r#"on rapid { "L {axes} R0" }"#, "`on rapid` moves at feed"),
        (r#"on feed { "L {axes} R0 {feed} M91" }"#, "does not move on a straight line to the programmed point"),
        (r#"on feed { "L {axes} R0 {feed} M5" }"#, "leaves the spindle standing"),
        (r#"on tool { "L {retract} R0 FMAX" "TOOL CALL {tool} Z" }"#, "otherwise than in rapid traverse and machine"),
        (
            r#"on tool { "L {retract} R0 F1000 M91" "TOOL CALL {tool} Z" }"#,
            "otherwise than in rapid traverse and machine",
        ),
        (r#"on tool { "TOOL DEF {tool}" }"#, "there should be a change to tool 7"),
        (r#"on stop { "M0" "TOOL CALL 2 Z" }"#, "leaves another length of the tool in force"),
        (r#"on dwell { "CYCL DEF 9.0 DWELL TIME" }"#, "there should be a dwell of 1.5 s"),
        (r#"on dwell { "CYCL DEF 9.1 DWELL {milliseconds}" }"#, "a dwell of 1500 s instead of a dwell of 1.5 s"),
        (r#"on end { "M9" }"#, "there should be the end of the program"),
        (r#"on start { "BEGIN PGM {program} INCH" "M137" }"#, "another unit of length"),
        (r#"on start { "BEGIN PGM {program}" "M137" }"#, "does not say the unit of length"),
        (r#"on spindle clockwise { "M13" }"#, "turning clockwise at 500"),
        (r#"on spindle clockwise { "TOOL CALL Z S{speed}" "M13" }"#, "switches the coolant otherwise than it says"),
        (r#"on stop { "M0" "CYCL DEF 247 DATUM SETTING ~" bare "Q339=+3" }"#, "leaves another work offset in force"),
    ] {
        assert_refused("heidenhain", own, "E0563", words);
    }
    for (own, words) in [
        (r#"on feed { "{axes} R0 {feed}" }"#, "knows no word `X+0.5`"),
        (r#"on feed { "R0 L {axes} {feed}" }"#, "knows no word `L`"),
        (r#"on feed { "LN {axes} R0 {feed}" }"#, "knows no word `LN`"),
        (r#"on feed { "M3 {axes} R0 {feed}" }"#, "no code says how the axis moves"),
        (r#"on feed { "C {axes} DR+ R0 {feed}" }"#, "neither a centre nor a radius"),
        (r#"on tool { "TOOL CALL {tool}" }"#, "knows no word `TOOL`"),
        (r#"on tool { "L Z+5 R0 FMAX" "TOOL CALL {tool} Z" }"#, "an axis word that is written out"),
        (r#"on stop { "M0" "M128" }"#, "knows no word `M128`"),
        (r#"on stop { "M0" "CYCL DEF 247 DATUM SETTING ~" "M5" }"#, "knows no word `CYCL`"),
    ] {
        assert_refused("heidenhain", own, "E0562", words);
    }
}

#[test]
fn units_of_another_program_are_refused() {
    assert_refused(
        "syntec",
        r#"on start { "G17 G20 G40 G49 G80 G90 {feed_mode}" }"#,
        "E0563",
        "another unit of length",
    );
    assert_refused("syntec", r#"on stop { "M0" "G20" }"#, "E0563", "another unit of length");
}

#[test]
fn a_declared_code_may_stand() {
    assert_eq!(told("syntec", r#"plain "M11" "C unclamped" on tool { "T{tool} M6 M11" }"#), []);
    assert_eq!(told("syntec", r#"on stop { "M0" "{feed_mode}" }"#), []);
    let smoothed = r#"plain "CYCLE832(0.1)" on rapid { "G0 {axes} CYCLE832(0.1)" }"#;
    assert_eq!(told("siemens", smoothed), []);
    assert_eq!(told("syntec", r#"word F_revolution feed_revolution as "E""#), []);
    assert_eq!(told("syntec", r#"offset 2 on stop { "M0" "{offset}" }"#), []);
    assert_eq!(told("syntec", r#"on approach { "G0 G43 H{register} {axes}" }"#), []);
    assert_eq!(told("syntec", ""), []);
    assert_eq!(told("siemens", ""), []);
    assert_eq!(told("heidenhain", ""), []);
    assert_eq!(
        told("heidenhain", r#"plain "M116" "feeds along rotary axes" on feed { "L {axes} R0 {feed} M116" }"#),
        []
    );
    assert_eq!(told("heidenhain", r#"offset 2 on operation { "{offset}" }"#), []);
    assert_eq!(told("heidenhain", "units inch"), []);
}
