//! Read-back: what the text says, whoever wrote it.

use crate::table::{axes, dialect};
use mach_runtime::nc::dialect::Dialect;
use mach_runtime::nc::writer::Writer;
use mach_runtime::readback::{Mistake, ReadBack, ReadError};
use mach_runtime::toolpath::{Approach, Feed};
use mach_runtime::unit::LengthUnit;

fn read(reader: &mut ReadBack, text: &str) -> Result<[f64; 5], ReadError> {
    let (_, joints) = reader.read(text.as_bytes(), 0..text.len())?;
    Ok(joints.try_into().expect("five axes"))
}

#[test]
fn words_keep_their_values_and_need_no_blanks() {
    let mut reader = ReadBack::new(&dialect(), &axes(), 0.0);
    let first = read(&mut reader, "N10 G1X1.Y-.5Z0.0 A+3 C359.999 (X9. Y9.) F500.\n");
    assert_eq!(first, Ok([1.0, -0.5, 0.0, 3.0, 359.999]));
    assert_eq!(read(&mut reader, ""), Ok([1.0, -0.5, 0.0, 3.0, 359.999]));
    assert_eq!(read(&mut reader, "X2.\nX3. SUPA S1=500 M2=3 T1\r\n"), Ok([3.0, -0.5, 0.0, 3.0, 359.999]));
    assert_eq!(read(&mut reader, "A-0.\n").map(|joints| joints[3].to_bits()), Ok(0));
}

#[test]
fn long_addresses_and_comments_to_the_end_of_the_line() {
    let mut dialect = Dialect { comment: (";".into(), String::new()), ..dialect() };
    dialect.axes[3].address = "A1=".into();
    dialect.axes[4].address = "A=".into();
    let mut reader = ReadBack::new(&dialect, &axes(), 0.0);
    let joints = read(&mut reader, "X1 Y2 Z3 A1=4.5 A=5 ; X7 (no end\nX8\n");
    assert_eq!(joints, Ok([8.0, 2.0, 3.0, 4.5, 5.0]));
    assert!(read(&mut reader, "A1 4").is_err());
}

#[test]
fn what_is_no_block_is_refused() {
    let cases = [
        ("X1. Y2. $", 8, Mistake::NoWord),
        ("X1. Y", 4, Mistake::NoWord),
        ("X1..", 3, Mistake::NoWord),
        ("X=5", 0, Mistake::NoWord),
        ("x1.", 0, Mistake::NoWord),
        ("X1. (comment\nY2.", 4, Mistake::OpenComment),
        ("X1. Y1. X2.", 8, Mistake::Repeated),
        ("X1. Y2. Z3. C5.", 15, Mistake::Missing(3)),
        ("X1234567890123456789.", 0, Mistake::NoWord),
        ("X1. é", 4, Mistake::NoWord),
        ("N1234567890123456789 X1.", 0, Mistake::NoWord),
        ("N10 N", 4, Mistake::NoWord),
        ("X1.2345 Y1.2345 X2.3456 Z1.2345", 16, Mistake::Repeated),
    ];
    for (text, offset, mistake) in cases {
        let mut reader = ReadBack::new(&dialect(), &axes(), 0.0);
        assert_eq!(read(&mut reader, text), Err(ReadError { offset, mistake }), "{text}");
    }
}

#[test]
fn only_the_motion_is_read() {
    let mut reader = ReadBack::new(&dialect(), &axes(), 0.0);
    let text = b"(not this\nN10 X1.5 Y2.5 Z3.5 A4.5 C5.5\nN20 X6.5\nX7.5\n";
    let (blocks, joints) = reader.read(text, 10..48).expect("two blocks");
    assert_eq!((blocks, joints), (2, &[6.5, 2.5, 3.5, 4.5, 5.5][..]));
    assert_eq!(reader.read(b"N30 X1.5\nN40 $\n", 9..15), Err(ReadError { offset: 4, mistake: Mistake::NoWord }));
}

/// Small jumps of five joints, the same in every run.
fn path(points: usize) -> impl Iterator<Item = [f64; 5]> {
    let mut state = 88_172_645_463_325_252_u64;
    let mut joints = [0.0; 5];
    (0..points).map(move |_| {
        for joint in &mut joints {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            *joint = (*joint + (state % 20_001) as f64 / 1e3 - 10.0).clamp(-900.0, 900.0);
        }
        joints
    })
}

#[test]
fn what_was_written_is_read_to_half_a_unit_of_each_word() {
    for units in [LengthUnit::Millimetre, LengthUnit::Inch] {
        let dialect = Dialect { units, ..dialect() };
        let mut axes = axes();
        axes[0].zero = 12.3456;
        axes[2].length_share = 1.0;
        let mut writer = Writer::new(dialect.clone(), &axes);
        let mut reader = ReadBack::new(&dialect, &axes, 123.4567);
        let half_mm = if units == LengthUnit::Inch { 0.0127 } else { 0.0005 };
        for joints in path(20_000) {
            let mut out = Vec::new();
            let approach = Approach::Feed(Some(Feed::PerMinute(1000.0)));
            writer.motion(approach, &joints, 123.4567, &mut out).expect("printed");
            let (_, read) = reader.read(&out, 0..out.len()).expect("read");
            for (axis, half) in [half_mm, half_mm, half_mm, 0.0005, 0.0005].into_iter().enumerate() {
                let turns = if axis == 4 { ((joints[4] - read[4]) / 360.0).round() } else { 0.0 };
                let difference = joints[axis] - read[axis] - 360.0 * turns;
                assert!(difference.abs() <= half + 1e-9, "axis {axis}: {} read as {}", joints[axis], read[axis]);
            }
        }
    }
}
