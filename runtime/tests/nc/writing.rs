//! The writer: what is printed, and when.

use crate::table::{axes, dialect, with_approach};
use mach_runtime::nc::dialect::{Block, Dialect, Trigger};
use mach_runtime::nc::write_error::WriteError;
use mach_runtime::nc::writer::{Values, Writer};
use mach_runtime::number::{DecimalPoint, Picture};
use mach_runtime::toolpath::{Approach, Feed, LoadedTool};
use mach_runtime::unit::LengthUnit;

const FEED: Approach = Approach::Feed(Some(Feed::PerMinute(500.0)));

/// A dialect without sequence numbers.
fn plain() -> Dialect {
    Dialect { sequence: None, ..dialect() }
}

fn writer() -> Writer {
    Writer::new(plain(), &axes())
}

fn motion(writer: &mut Writer, approach: Approach, joints: [f64; 5]) -> String {
    let mut out = Vec::new();
    writer.motion(approach, &joints, 0.0, &mut out).expect("the motion is printed");
    String::from_utf8(out).expect("ASCII")
}

fn command(writer: &mut Writer, trigger: Trigger, values: &Values<'_>) -> String {
    let mut out = Vec::new();
    writer.command(trigger, values, &mut out).expect("the command is printed");
    String::from_utf8(out).expect("ASCII")
}

fn with_tool(number: u64, register: u64) -> Values<'static> {
    Values { tool: Some(LoadedTool { number, register }), ..Values::default() }
}

#[test]
fn the_golden_words() {
    let mut writer = writer();
    let first = motion(&mut writer, Approach::Rapid, [70.711, 18.271, 21.124, 23.955, 315.0]);
    assert_eq!(first, "G0 X70.711 Y18.271 Z21.124 A23.955 C315.\n");
    let second = motion(&mut writer, FEED, [0.4832, 0.0, 25.0, -0.0003, 0.002]);
    assert_eq!(second, "G1 X.483 Y0.0 Z25. A0.0 C.002 G94 F500.\n");
}

#[test]
fn only_what_changes_is_printed() {
    let mut writer = writer();
    motion(&mut writer, FEED, [1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(motion(&mut writer, FEED, [1.0, 2.5, 3.0004, 4.0, 5.0]), "Y2.5\n");
    assert_eq!(motion(&mut writer, FEED, [1.0, 2.5, 3.0002, 4.0, 365.0]), "");
    assert_eq!(motion(&mut writer, Approach::Rapid, [1.0, 2.5, 3.0, 4.0, 6.0]), "G0 C6.\n");
    let faster = Approach::Feed(Some(Feed::PerMinute(600.04)));
    assert_eq!(motion(&mut writer, faster, [1.0, 2.5, 3.0, 4.0, 7.0]), "G1 C7. F600.\n");
}

#[test]
fn the_kind_of_feed_comes_with_the_word_when_it_changes() {
    let mut writer = writer();
    let head = command(&mut writer, Trigger::Start, &Values { program: "part-1", ..Values::default() });
    assert_eq!(head, "%\nOPART_1\nG21 G90 G94\n");
    assert_eq!(motion(&mut writer, FEED, [0.0; 5]), "G1 X0.0 Y0.0 Z0.0 A0.0 C0.0 F500.\n");
    let turning = Approach::Feed(Some(Feed::PerRevolution(0.125)));
    assert_eq!(motion(&mut writer, turning, [1.0, 0.0, 0.0, 0.0, 0.0]), "X1. G95 F.125\n");
    assert_eq!(motion(&mut writer, FEED, [2.0, 0.0, 0.0, 0.0, 0.0]), "X2. G94 F500.\n");
}

#[test]
fn a_turn_is_taken_off_after_rounding() {
    let mut writer = writer();
    for (joint, word) in [(359.9994, "C359.999"), (359.9996, "C0.0"), (-0.001, "C359.999"), (725.0, "C5.")] {
        let line = motion(&mut writer, Approach::Rapid, [0.0, 0.0, 0.0, 0.0, joint]);
        assert!(line.trim_end().ends_with(word), "{joint}: {line}");
    }
}

#[test]
fn a_tool_change_and_a_block_that_moves_make_the_next_motion_complete() {
    let mut writer = writer();
    let full = "G1 X1. Y2. Z3. A4. C5. F500.\n";
    motion(&mut writer, FEED, [1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(command(&mut writer, Trigger::Tool, &with_tool(3, 4)), "G53 Z0.\nT3 M6\nG43 H04\n");
    assert_eq!(motion(&mut writer, FEED, [1.0, 2.0, 3.0, 4.0, 5.0]), full);
    command(&mut writer, Trigger::Dwell, &Values::default());
    assert_eq!(motion(&mut writer, FEED, [1.0, 2.0, 3.0, 4.0, 5.0]), "");
    command(&mut writer, Trigger::Stop, &Values::default());
    assert_eq!(motion(&mut writer, FEED, [1.0, 2.0, 3.0, 4.0, 5.0]), full);
}

#[test]
fn the_first_rapid_motion_of_a_program_and_of_a_tool_is_the_approach() {
    let mut writer = Writer::new(Dialect { sequence: None, ..with_approach() }, &axes());
    let joints = [1.0, 2.0, 3.0, 4.0, 5.0];
    let mut without_tool = || writer.motion(Approach::Rapid, &joints, 0.0, &mut Vec::new());
    assert_eq!(without_tool(), Err(WriteError::NoTool { name: "register" }));
    command(&mut writer, Trigger::Tool, &with_tool(3, 4));
    command(&mut writer, Trigger::Stop, &Values::default());
    assert_eq!(motion(&mut writer, Approach::Rapid, joints), "G0 A4. C5.\nX1. Y2.\nG43 H4 Z3.\n");
    assert_eq!(motion(&mut writer, Approach::Rapid, [1.0, 2.0, 9.0, 4.0, 5.0]), "Z9.\n");
    command(&mut writer, Trigger::Tool, &with_tool(3, 4));
    assert_eq!(motion(&mut writer, FEED, joints), "G1 X1. Y2. Z3. A4. C5. G94 F500.\n");
    assert_eq!(motion(&mut writer, Approach::Rapid, [0.0; 5]), "G0 X0.0 Y0.0 Z0.0 A0.0 C0.0\n");
}

#[test]
fn an_approach_that_cannot_be_printed_prints_nothing() {
    let mut writer = Writer::new(with_approach(), &axes());
    let mut out = Vec::new();
    writer.command(Trigger::Tool, &with_tool(3, 12), &mut out).expect("printed");
    let before = out.clone();
    let error = writer.motion(Approach::Rapid, &[1.0; 5], 0.0, &mut out);
    assert_eq!(error, Err(WriteError::TooLarge { word: "register".into(), value: 12.0, limit: 10.0 }));
    assert_eq!(out, before);
}

#[test]
fn a_rapid_motion_in_several_lines_leaves_out_those_that_stand_still() {
    let mut dialect = plain();
    for block in with_approach().blocks.into_iter().filter(|block| block.trigger == Trigger::Approach) {
        dialect.blocks.retain(|block| block.trigger != Trigger::Rapid);
        dialect.blocks.push(Block { trigger: Trigger::Rapid, ..block });
    }
    let mut writer = Writer::new(dialect, &axes());
    command(&mut writer, Trigger::Tool, &with_tool(3, 4));
    motion(&mut writer, FEED, [0.0; 5]);
    assert_eq!(motion(&mut writer, Approach::Rapid, [1.0, 0.0, 0.0, 0.0, 0.0]), "G0 X1.\n");
    assert_eq!(motion(&mut writer, Approach::Rapid, [1.0, 0.0, 2.0, 0.0, 5.0]), "C5.\nG43 H4 Z2.\n");
}

#[test]
fn sequence_numbers_begin_again_after_the_greatest() {
    let mut writer = Writer::new(dialect(), &axes());
    let mut out = Vec::new();
    for n in 0..7 {
        let joints = [f64::from(n), 0.0, 0.0, 0.0, 0.0];
        writer.motion(Approach::Rapid, &joints, 0.0, &mut out).expect("printed");
        writer.motion(Approach::Rapid, &joints, 0.0, &mut out).expect("nothing to print");
    }
    let text = String::from_utf8(out).expect("ASCII");
    let numbers: Vec<&str> = text.lines().filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(numbers, ["N10", "N20", "N30", "N40", "N50", "N10", "N20"]);
}

#[test]
fn inches_program_zero_and_tool_length() {
    let mut axes = axes();
    axes[2].zero = 100.0;
    axes[2].length_share = 1.0;
    axes[3].zero = 10.0;
    let mut writer = Writer::new(Dialect { units: LengthUnit::Inch, ..plain() }, &axes);
    let mut out = Vec::new();
    let feed = Approach::Feed(Some(Feed::PerMinute(254.0)));
    writer.motion(feed, &[25.4, 0.0, 100.0 + 50.8 + 120.0, 30.0, 25.4], 120.0, &mut out).expect("printed");
    assert_eq!(out, b"G1 X1. Y0.0 Z2. A20. C25.4 G94 F10.\n");
}

#[test]
fn text_of_the_cl_stays_in_its_comment() {
    let mut writer = writer();
    let values = Values { text: "ROUGH (1)\n% M30", ..Values::default() };
    assert_eq!(command(&mut writer, Trigger::Message, &values), "(ROUGH 1 M30)\n");
}

#[test]
fn what_cannot_be_printed_is_an_error_and_prints_nothing() {
    let mut writer = writer();
    let mut out = b"before".to_vec();
    let far = writer.motion(FEED, &[0.0, 12_345.0, 0.0, 0.0, 0.0], 0.0, &mut out);
    assert_eq!(far, Err(WriteError::TooLarge { word: "Y".into(), value: 12_345.0, limit: 10_000.0 }));
    let slow = writer.motion(Approach::Feed(Some(Feed::PerMinute(0.04))), &[0.0; 5], 0.0, &mut out);
    assert_eq!(slow, Err(WriteError::NoFeed { value: 0.04 }));
    let nameless = writer.command(Trigger::Start, &Values::default(), &mut out);
    assert_eq!(nameless, Err(WriteError::NoProgramName));
    let through = writer.command(Trigger::CoolantThrough, &Values::default(), &mut out);
    assert_eq!(through, Err(WriteError::NoBlock(Trigger::CoolantThrough)));
    let nan = writer.motion(FEED, &[f64::NAN, 0.0, 0.0, 0.0, 0.0], 0.0, &mut out);
    assert!(matches!(nan, Err(WriteError::TooLarge { .. })));
    assert_eq!(out, b"before");
    assert_eq!(writer.command(Trigger::CoolantMist, &Values::default(), &mut out), Ok(()));
    assert_eq!(writer.command(Trigger::End, &Values::default(), &mut out), Ok(()));
    assert_eq!(out, b"before");
}

#[test]
fn a_controller_without_feed_per_revolution_refuses_it() {
    let mut dialect = plain();
    dialect.codes.per_revolution = None;
    let mut writer = Writer::new(dialect, &axes());
    let turning = Approach::Feed(Some(Feed::PerRevolution(0.1)));
    let error = writer.motion(turning, &[0.0; 5], 0.0, &mut Vec::new());
    assert_eq!(error, Err(WriteError::NoFeedPerRevolution));
}

#[test]
fn a_refused_motion_moves_no_axis() {
    let mut writer = Writer::new(Dialect { sequence: None, ..with_approach() }, &axes());
    let mut out = Vec::new();
    writer.command(Trigger::Tool, &with_tool(3, 12), &mut out).expect("printed");
    let approach = writer.motion(Approach::Rapid, &[1.0; 5], 0.0, &mut out);
    assert!(matches!(approach, Err(WriteError::TooLarge { .. })));
    assert_eq!(motion(&mut writer, FEED, [1.0; 5]), "G1 X1. Y1. Z1. A1. C1. G94 F500.\n");
    assert!(writer.motion(FEED, &[2.0, 12_345.0, 1.0, 1.0, 1.0], 0.0, &mut out).is_err());
    assert_eq!(motion(&mut writer, FEED, [2.0, 1.0, 1.0, 1.0, 1.0]), "X2.\n");
}

/// Joints of few and of many digits, some of which stay where they are.
fn wandering() -> impl Iterator<Item = [f64; 5]> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut joints = [0.0; 5];
    (0..20_000).map(move |n| {
        for joint in &mut joints {
            state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let share = (state >> 12) as f64 / (1_u64 << 52) as f64 - 0.5;
            match state >> 3 & 3 {
                0 => {}
                1 => *joint = (share * 100.0).trunc(),
                _ => *joint = share * 2.0 * f64::from(10_u32.pow(n % 7)) / 100.0,
            }
        }
        joints
    })
}

#[test]
fn words_of_all_lengths_are_what_their_pictures_print() {
    let pictures = [(4, 0, 3), (4, 1, 4), (6, 0, 6), (9, 2, 0), (5, 0, 8)];
    for (address, point) in
        [("X", DecimalPoint::Always), ("X1=", DecimalPoint::Needed), ("SPINDLE_X=", DecimalPoint::Always)]
    {
        let mut dialect = plain();
        let words = dialect.axes.iter_mut().zip(pictures).enumerate();
        for (n, (word, (integer_digits, integer_least, decimals))) in words {
            word.address = address.replace('X', &word.name);
            let zero = (n == 0).then(|| "000.0".to_owned());
            let plus = n == 1;
            word.picture =
                Picture { integer_digits, integer_least, decimals, point, plus, zero, ..word.picture.clone() };
        }
        let words = dialect.axes.clone();
        let mut writer = Writer::new(dialect, &axes()[..3].iter().chain(&axes()[..2]).cloned().collect::<Vec<_>>());
        let mut before = [None; 5];
        for joints in wandering() {
            let mut expected = Vec::new();
            for ((word, joint), before) in words.iter().zip(joints).zip(&mut before) {
                let units = word.picture.units(joint);
                if *before != units {
                    let mut text = word.address.clone().into_bytes();
                    word.picture.print(units.expect("the joint fits"), &mut text);
                    expected.push(String::from_utf8(text).expect("ASCII"));
                }
                *before = units;
            }
            let printed = motion(&mut writer, Approach::Rapid, joints);
            assert_eq!(printed.trim_start_matches("G0 ").trim_end(), expected.join(" "), "{joints:?}");
        }
    }
}
