//! A five-axis table and a Fanuc-like dialect, as tables.

use mach_runtime::dialect::meaning::Wrap;
use mach_runtime::dialect::table::{BlockKind, Table};
use mach_runtime::machine::{Axis, Motion, Rule, Travel, Written};
use mach_runtime::nc::dialect::{Block, Codes, Dialect, Line, Piece, Sequence, Trigger, Value, Word};
use mach_runtime::number::{DecimalPoint, Picture};
use mach_runtime::unit::LengthUnit;

pub(crate) fn axis(name: &str, motion: Motion) -> Axis {
    Axis {
        name: name.into(),
        motion,
        travel: Travel::UNLIMITED,
        written: Written::Unwound,
        zero: 0.0,
        rule: Rule::Pose,
        length_share: 0.0,
        rapid_per_min: None,
    }
}

/// X Y Z A C; C is written from 0 to 360.
pub(crate) fn axes() -> Vec<Axis> {
    let mut axes: Vec<Axis> = ["X", "Y", "Z"].iter().map(|name| axis(name, Motion::Linear)).collect();
    axes.push(axis("A", Motion::Rotary));
    axes.push(Axis { written: Written::Wrapped { from_deg: 0.0 }, ..axis("C", Motion::Rotary) });
    axes
}

/// `####.###` zero `0.0`.
pub(crate) fn picture() -> Picture {
    Picture {
        plus: false,
        integer_digits: 4,
        integer_least: 0,
        decimals: 3,
        decimals_least: 0,
        point: DecimalPoint::Always,
        zero: Some("0.0".into()),
    }
}

pub(crate) fn word(name: &str) -> Word {
    Word { name: name.into(), address: name.into(), picture: picture() }
}

fn text(text: &str) -> Piece {
    Piece::Text(text.into())
}

fn block(trigger: Trigger, lines: Vec<(bool, Vec<Piece>)>) -> Block {
    let lines = lines.into_iter().map(|(numbered, pieces)| Line { numbered, pieces }).collect();
    Block { trigger, lines }
}

fn motion(trigger: Trigger, code: usize) -> Block {
    let pieces =
        vec![Piece::Modal { group: 0, code }, text(" "), Piece::Axes((0..5).collect()), text(" "), Piece::Feed];
    block(trigger, vec![(true, pieces)])
}

/// The dialect with an approach in three lines; the last one has the length register, in one digit.
pub(crate) fn with_approach() -> Dialect {
    let lines = vec![
        (true, vec![Piece::Modal { group: 0, code: 0 }, text(" "), Piece::Axes(vec![3, 4])]),
        (true, vec![Piece::Modal { group: 0, code: 0 }, text(" "), Piece::Axes(vec![0, 1])]),
        (true, vec![text("G43 H"), Piece::Value(Value::Register, Some(one_digit())), text(" "), Piece::Axes(vec![2])]),
    ];
    let mut dialect = dialect();
    dialect.blocks.push(block(Trigger::Approach, lines));
    dialect
}

fn one_digit() -> Picture {
    Picture { integer_digits: 1, ..Picture::WHOLE }
}

pub(crate) fn dialect() -> Dialect {
    let start = vec![
        (false, vec![text("%")]),
        (false, vec![text("O"), Piece::Value(Value::Program, None)]),
        (true, vec![Piece::Value(Value::Units, None), text(" G90 "), Piece::Value(Value::FeedMode, None)]),
    ];
    let register = Picture { integer_digits: 2, integer_least: 2, ..Picture::WHOLE };
    let tool = vec![
        (true, vec![text("G53 Z0.")]),
        (true, vec![text("T"), Piece::Value(Value::Tool, None), text(" M6")]),
        (true, vec![text("G43 H"), Piece::Value(Value::Register, Some(register))]),
    ];
    Dialect {
        name: "test".into(),
        units: LengthUnit::Millimetre,
        extension: "nc".into(),
        comment: ("(".into(), ")".into()),
        sequence: Some(Sequence { address: "N".into(), start: 10, step: 10, greatest: 50 }),
        offset: "G54".into(),
        retract: None,
        codes: Codes { units: "G21".into(), per_minute: "G94".into(), per_revolution: Some("G95".into()) },
        axes: axes().iter().map(|axis| word(&axis.name)).collect(),
        feed: Word { picture: Picture { integer_digits: 5, decimals: 1, ..picture() }, ..word("F") },
        feed_per_revolution: word("F"),
        modal_groups: vec![vec!["G0".into(), "G1".into()]],
        blocks: vec![
            block(Trigger::Start, start),
            block(Trigger::Tool, tool),
            block(Trigger::Message, vec![(false, vec![text("("), Piece::Value(Value::Text, None), text(")")])]),
            block(Trigger::Dwell, vec![(true, vec![text("G4 P"), Piece::Value(Value::Milliseconds, None)])]),
            block(Trigger::CoolantMist, vec![]),
            block(Trigger::Stop, vec![(true, vec![text("G0 M0 Z5.")])]),
            motion(Trigger::Rapid, 0),
            motion(Trigger::Feed, 1),
        ],
        table: no_table(),
    }
}

/// What is only written needs none.
fn no_table() -> Table {
    Table {
        blocks: BlockKind::Words,
        comment: ("(".into(), ")".into()),
        sequence: None,
        continued: None,
        words: Vec::new(),
        forms: Vec::new(),
        patterns: Vec::new(),
        wrap: Wrap::Shortest,
        inch_feed_mm: 25.4,
        power_on: Vec::new(),
    }
}
