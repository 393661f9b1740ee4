//! The writer: prints commands and motions by the dialect's blocks, and words only when they change.
//!
//! What is modal: the axis words, the codes of the dialect's modal groups, the feed word and the code of its kind.
//! Motions print them when they change; every other block prints its codes always. After a tool change, and after any
//! block other than a motion whose text holds an axis word, axis words, codes and the feed are forgotten: the next
//! motion prints them all.

use super::axis_word::AxisWord;
use super::dialect::{Block, Dialect, LengthUnit, Picture, Piece, Point, Trigger, Value, Word};
use super::line::{Numbering, OpenLine};
use super::text::{print_comment, print_program_name};
use super::write_error::WriteError;
use crate::cl::event::{Approach, Feed};
use crate::machine::Axis;

/// What the placeholders of a command's block stand for.
#[derive(Debug, Clone, Copy, Default)]
pub struct Values<'a> {
    /// The program's name, as the user gave it.
    pub program: &'a str,
    /// The machine's name.
    pub machine: &'a str,
    /// The CL's operation.
    pub operation: &'a str,
    /// The CL's name of the tool.
    pub tool_name: &'a str,
    /// A message or a comment.
    pub text: &'a str,
    /// The tool's number.
    pub tool: u64,
    /// The tool's length register.
    pub register: u64,
    /// The spindle's speed in revolutions a minute.
    pub speed_rpm: f64,
    /// A dwell.
    pub dwell_s: f64,
}

/// Which feed the control is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum FeedMode {
    PerMinute,
    PerRevolution,
}

/// A feed rate, ready to print.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct FeedState {
    mode: FeedMode,
    units: i64,
}

/// Prints one program.
#[derive(Debug)]
pub struct Writer {
    dialect: Dialect,
    axes: Vec<AxisWord>,
    state: State,
}

/// What the control knows from the blocks so far, and what the current motion wants.
#[derive(Debug)]
struct State {
    numbering: Numbering,
    /// Each axis word's number in units of its last decimal.
    axes: Vec<Option<i64>>,
    /// The same for the motion being printed.
    wanted: Vec<i64>,
    /// The code in force of each modal group.
    codes: Vec<Option<usize>>,
    feed: Option<FeedState>,
    feed_mode: Option<FeedMode>,
}

impl State {
    /// Takes nothing for granted any more; only the kind of feed and the sequence number stay.
    fn forget(&mut self) {
        self.axes.fill(None);
        self.codes.fill(None);
        self.feed = None;
    }
}

impl Writer {
    /// A writer at the start of a program. `axes` are the machine's, in the order of the dialect's axis words.
    pub fn new(dialect: Dialect, axes: &[Axis]) -> Self {
        assert_eq!(dialect.axes.len(), axes.len(), "a dialect has one word for each axis of its machine");
        let state = State {
            numbering: Numbering::new(dialect.sequence.clone()),
            axes: vec![None; axes.len()],
            wanted: vec![0; axes.len()],
            codes: vec![None; dialect.modal_groups.len()],
            feed: None,
            feed_mode: None,
        };
        let words = dialect.axes.iter().zip(axes);
        let axes = words.map(|(word, axis)| AxisWord::new(word, axis, dialect.units)).collect();
        Self { dialect, axes, state }
    }

    /// The dialect it prints by.
    pub fn dialect(&self) -> &Dialect {
        &self.dialect
    }

    /// Appends the block of a command (any trigger but a motion).
    ///
    /// # Errors
    /// When the controller has no such block, or a value cannot be printed; `out` is then as it was.
    pub fn command(&mut self, trigger: Trigger, values: &Values<'_>, out: &mut Vec<u8>) -> Result<(), WriteError> {
        let Some(block) = self.dialect.block(trigger) else {
            return if trigger.may_lack_a_block() { Ok(()) } else { Err(WriteError::NoBlock(trigger)) };
        };
        let start = out.len();
        for line in &block.lines {
            let open = OpenLine::begin(line.numbered, &self.state.numbering, out);
            for piece in &line.pieces {
                if let Err(error) = command_piece(piece, &self.dialect, &mut self.state, values, open, out) {
                    out.truncate(start);
                    return Err(error);
                }
            }
            open.end(&mut self.state.numbering, out);
        }
        if trigger == Trigger::Tool || moves(block, &self.dialect) {
            self.state.forget();
        }
        Ok(())
    }

    /// Appends the block of a motion to `joints` (machine coordinates in mm and degrees, in the machine's order).
    /// Nothing is printed when no axis word changes.
    ///
    /// # Errors
    /// When the controller has no such block, or a number does not fit its word; `out` is then as it was.
    pub fn motion(
        &mut self,
        approach: Approach,
        joints: &[f64],
        tool_length_mm: f64,
        out: &mut Vec<u8>,
    ) -> Result<(), WriteError> {
        let (trigger, feed) = match approach {
            Approach::Rapid => (Trigger::Rapid, None),
            Approach::Feed(feed) => (Trigger::Feed, feed.map(|feed| feed_state(feed, &self.dialect)).transpose()?),
        };
        let block = self.dialect.block(trigger).ok_or(WriteError::NoBlock(trigger))?;
        let state = &mut self.state;
        for ((axis, joint), wanted) in self.axes.iter().zip(joints).zip(&mut state.wanted) {
            *wanted = axis.units(*joint, tool_length_mm)?;
        }
        if state.wanted.iter().zip(&state.axes).all(|(wanted, current)| *current == Some(*wanted)) {
            return Ok(());
        }
        for line in &block.lines {
            let open = OpenLine::begin(line.numbered, &state.numbering, out);
            for piece in &line.pieces {
                motion_piece(piece, &self.dialect, &self.axes, state, feed, open, out);
            }
            open.end(&mut state.numbering, out);
        }
        for (current, wanted) in state.axes.iter_mut().zip(&state.wanted) {
            *current = Some(*wanted);
        }
        Ok(())
    }
}

/// Prints a piece of a motion's line.
fn motion_piece(
    piece: &Piece,
    dialect: &Dialect,
    axes: &[AxisWord],
    state: &mut State,
    feed: Option<FeedState>,
    open: OpenLine,
    out: &mut Vec<u8>,
) {
    match piece {
        Piece::Text(text) => open.text(text, out),
        Piece::Modal { group, code } => {
            if state.codes[*group].replace(*code) != Some(*code) {
                out.extend_from_slice(dialect.modal_groups[*group][*code].as_bytes());
            }
        }
        Piece::Axes => print_axes(axes, state, out),
        Piece::Feed => {
            if let Some(feed) = feed
                && state.feed.replace(feed) != Some(feed)
            {
                print_feed(feed, dialect, state, out);
            }
        }
        Piece::Value(value, _) => match value {
            Value::Offset => out.extend_from_slice(dialect.offset.as_bytes()),
            Value::Units => out.extend_from_slice(dialect.codes.units.as_bytes()),
            Value::FeedMode => {
                let mode = feed.map(|feed| feed.mode).or(state.feed_mode).unwrap_or(FeedMode::PerMinute);
                print_feed_mode(mode, dialect, state, out);
            }
            _ => {} // a motion has no other values
        },
    }
}

/// Prints the words of the axes that change, a blank between them.
fn print_axes(axes: &[AxisWord], state: &State, out: &mut Vec<u8>) {
    let start = out.len();
    for ((axis, wanted), current) in axes.iter().zip(&state.wanted).zip(&state.axes) {
        if *current != Some(*wanted) {
            if out.len() > start {
                out.push(b' ');
            }
            axis.print(*wanted, out);
        }
    }
}

/// Prints the code of the feed's kind, if it changes, and the feed word.
fn print_feed(feed: FeedState, dialect: &Dialect, state: &mut State, out: &mut Vec<u8>) {
    let start = out.len();
    print_feed_mode(feed.mode, dialect, state, out);
    if out.len() > start {
        out.push(b' ');
    }
    let word = feed_word(feed.mode, dialect);
    out.extend_from_slice(word.address.as_bytes());
    word.picture.print(feed.units, out);
}

/// Prints the code of the feed's kind, if it changes.
fn print_feed_mode(mode: FeedMode, dialect: &Dialect, state: &mut State, out: &mut Vec<u8>) {
    if state.feed_mode.replace(mode) != Some(mode) {
        out.extend_from_slice(feed_code(mode, dialect).as_bytes());
    }
}

fn feed_code(mode: FeedMode, dialect: &Dialect) -> &str {
    match mode {
        FeedMode::PerMinute => &dialect.codes.per_minute,
        FeedMode::PerRevolution => dialect.codes.per_revolution.as_deref().unwrap_or_default(),
    }
}

fn feed_word(mode: FeedMode, dialect: &Dialect) -> &Word {
    match mode {
        FeedMode::PerMinute => &dialect.feed,
        FeedMode::PerRevolution => &dialect.feed_per_revolution,
    }
}

/// The feed in units of its word.
fn feed_state(feed: Feed, dialect: &Dialect) -> Result<FeedState, WriteError> {
    let (mode, metric) = match feed {
        Feed::PerMinute(mm_per_min) => (FeedMode::PerMinute, mm_per_min),
        Feed::PerRevolution(mm_per_rev) => (FeedMode::PerRevolution, mm_per_rev),
    };
    if mode == FeedMode::PerRevolution && dialect.codes.per_revolution.is_none() {
        return Err(WriteError::NoFeedPerRevolution);
    }
    let value = match dialect.units {
        LengthUnit::Millimetre => metric,
        LengthUnit::Inch => metric / 25.4,
    };
    let word = feed_word(mode, dialect);
    let units = word.picture.units(value).ok_or_else(|| WriteError::too_large(word, value))?;
    if units <= 0 {
        return Err(WriteError::NoFeed { value });
    }
    Ok(FeedState { mode, units })
}

/// Prints a piece of a command's line.
fn command_piece(
    piece: &Piece,
    dialect: &Dialect,
    state: &mut State,
    values: &Values<'_>,
    open: OpenLine,
    out: &mut Vec<u8>,
) -> Result<(), WriteError> {
    match piece {
        Piece::Text(text) => open.text(text, out),
        Piece::Modal { group, code } => {
            state.codes[*group] = Some(*code);
            out.extend_from_slice(dialect.modal_groups[*group][*code].as_bytes());
        }
        Piece::Axes | Piece::Feed => {} // a command moves nothing
        Piece::Value(Value::FeedMode, _) => {
            let mode = *state.feed_mode.get_or_insert(FeedMode::PerMinute);
            out.extend_from_slice(feed_code(mode, dialect).as_bytes());
        }
        Piece::Value(value, picture) => print_value(*value, picture.as_ref(), dialect, values, out)?,
    }
    Ok(())
}

/// Seconds where the template gives no picture.
const SECONDS: Picture = Picture { decimals: 3, point: Point::Needed, ..Picture::WHOLE };

/// Prints what a placeholder stands for.
fn print_value(
    value: Value,
    picture: Option<&Picture>,
    dialect: &Dialect,
    values: &Values<'_>,
    out: &mut Vec<u8>,
) -> Result<(), WriteError> {
    let delimiters = (dialect.comment.0.as_str(), dialect.comment.1.as_str());
    let mut number = |name, plain: &Picture, number| print_number(name, number, picture.unwrap_or(plain), out);
    match value {
        Value::Tool => return number("tool", &Picture::WHOLE, values.tool as f64),
        Value::Register => return number("register", &Picture::WHOLE, values.register as f64),
        Value::Speed => return number("speed", &Picture::WHOLE, values.speed_rpm),
        Value::Seconds => return number("seconds", &SECONDS, values.dwell_s),
        Value::Milliseconds => return number("milliseconds", &Picture::WHOLE, values.dwell_s * 1000.0),
        Value::Program if print_program_name(values.program, out) => {}
        Value::Program => return Err(WriteError::NoProgramName),
        Value::Machine => print_comment(values.machine, delimiters, out),
        Value::Operation => print_comment(values.operation, delimiters, out),
        Value::ToolName => print_comment(values.tool_name, delimiters, out),
        Value::Text => print_comment(values.text, delimiters, out),
        Value::Offset => out.extend_from_slice(dialect.offset.as_bytes()),
        Value::Units => out.extend_from_slice(dialect.codes.units.as_bytes()),
        Value::FeedMode => {} // printed with the state at hand
    }
    Ok(())
}

fn print_number(name: &str, value: f64, picture: &Picture, out: &mut Vec<u8>) -> Result<(), WriteError> {
    let units = picture.units(value).ok_or_else(|| {
        let word = Word { name: name.into(), address: String::new(), picture: picture.clone() };
        WriteError::too_large(&word, value)
    })?;
    picture.print(units, out);
    Ok(())
}

/// Whether the block's own text holds an axis word, such as the `Z0.` of `G53 Z0.`.
fn moves(block: &Block, dialect: &Dialect) -> bool {
    let texts = block.lines.iter().flat_map(|line| &line.pieces).filter_map(|piece| match piece {
        Piece::Text(text) => Some(text.as_str()),
        _ => None,
    });
    texts.into_iter().any(|text| dialect.axes.iter().any(|word| has_word(text, &word.address)))
}

/// Whether the address stands in the text with a number behind it and no letter before it.
fn has_word(text: &str, address: &str) -> bool {
    text.match_indices(address).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let behind = text[at + address.len()..].chars().next();
        !before.is_some_and(|c| c.is_ascii_alphabetic())
            && behind.is_some_and(|c| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | '='))
    })
}
