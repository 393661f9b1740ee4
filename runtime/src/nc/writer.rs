//! The writer: prints commands and motions by the dialect's blocks, and words only when they change.
//!
//! What is modal: the axis words, the codes of the dialect's modal groups, the feed word and the code of its kind.
//! Motions print them when they change; every other block prints its codes always. After a tool change, and after any
//! block other than a motion that prints an axis word, axis words, codes and the feed are forgotten: the next motion
//! prints them all. The first motion of a program and of a tool prints the block of the approach, if there is one.

use super::axis_word::AxisWord;
use super::dialect::{Block, Dialect, Line as Template, Piece, Trigger, Value};
use super::feed_word::{FeedMode, FeedState};
use super::line::Line;
use super::moves::moves;
pub use super::values::Values;
use super::write_error::WriteError;
use crate::cl::event::{Approach, Feed};
use crate::machine::{Axis, Retract};

/// Prints one program.
#[derive(Debug)]
pub struct Writer {
    dialect: Dialect,
    /// For each trigger its block, as an index into the dialect's.
    blocks: [Option<usize>; Trigger::ALL.len()],
    axes: Vec<AxisWord>,
    retract: Option<Retract>,
    state: State,
}

/// What the control knows from the blocks so far, and what the current motion wants.
#[derive(Debug)]
struct State {
    line: Line,
    /// How many bytes the words of all axes take at most.
    room: usize,
    /// Each axis word's number in units of its last decimal.
    axes: Vec<AxisState>,
    /// Whether the control knows the axes.
    has_axes: bool,
    /// The code in force of each modal group.
    codes: Vec<Option<usize>>,
    feed: Option<FeedState>,
    feed_mode: Option<FeedMode>,
    /// The feed of the last motion that had one, as the CL has it and converted.
    converted: Option<(Feed, FeedState)>,
    /// Whether the next motion is the first of the program or of its tool.
    approaching: bool,
    /// The tool's number and its length register.
    tool: (u64, u64),
}

/// The number of an axis word in units of its last decimal.
#[derive(Debug, Clone, Copy, Default)]
struct AxisState {
    current: i64,
    /// In the motion being printed.
    wanted: i64,
}

/// The axes whose words change, as bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Changes(u64);

impl Changes {
    fn has(self, axis: usize) -> bool {
        self.0 >> axis & 1 != 0
    }

    /// Whether a line has axis words, and none of them changes.
    fn leave_alone(self, line: &Template) -> bool {
        let axes =
            || line.pieces.iter().filter_map(|piece| if let Piece::Axes(axes) = piece { Some(axes) } else { None });
        axes().next().is_some() && !axes().flatten().any(|axis| self.has(*axis))
    }
}

impl State {
    /// Takes nothing for granted any more; only the kind of feed and the sequence number stay.
    fn forget(&mut self) {
        self.has_axes = false;
        self.codes.fill(None);
        self.feed = None;
    }

    /// The feed of a motion, if it has one.
    #[inline]
    fn feed(&mut self, approach: Approach, dialect: &Dialect) -> Result<Option<FeedState>, WriteError> {
        let Approach::Feed(Some(feed)) = approach else { return Ok(None) };
        match self.converted {
            Some((last, converted)) if last == feed => Ok(Some(converted)),
            _ => self.convert(feed, dialect).map(Some),
        }
    }

    #[cold]
    fn convert(&mut self, feed: Feed, dialect: &Dialect) -> Result<FeedState, WriteError> {
        let converted = FeedState::new(feed, dialect)?;
        self.converted = Some((feed, converted));
        Ok(converted)
    }

    /// Takes what a motion wants of the axes, and says which words that changes.
    #[inline]
    fn want(&mut self, axes: &[AxisWord], joints: &[f64], tool_length_mm: f64) -> Result<Changes, WriteError> {
        let is_new = u64::from(!self.has_axes);
        let mut changes = 0;
        for (index, ((axis, state), joint)) in axes.iter().zip(&mut self.axes).zip(joints).enumerate() {
            state.wanted = axis.units(*joint, tool_length_mm)?;
            changes |= (u64::from(state.wanted != state.current) | is_new) << index;
        }
        Ok(Changes(changes))
    }
}

impl Writer {
    /// A writer at the start of a program. `axes` are the machine's, in the order of the dialect's axis words.
    pub fn new(dialect: Dialect, axes: &[Axis]) -> Self {
        assert_eq!(dialect.axes.len(), axes.len(), "a dialect has one word for each axis of its machine");
        assert!(axes.len() <= 64, "the axes of a machine are few");
        let words = dialect.axes.iter().zip(axes);
        let words: Vec<AxisWord> = words.map(|(word, axis)| AxisWord::new(word, axis, dialect.units)).collect();
        let state = State {
            line: Line::new(dialect.sequence.clone()),
            room: words.iter().map(AxisWord::room).sum(),
            axes: vec![AxisState::default(); axes.len()],
            has_axes: false,
            codes: vec![None; dialect.modal_groups.len()],
            feed: None,
            feed_mode: None,
            converted: None,
            approaching: true,
            tool: (0, 0),
        };
        let blocks = Trigger::ALL.map(|trigger| dialect.blocks.iter().position(|block| block.trigger == trigger));
        Self { dialect, blocks, axes: words, retract: Retract::of(axes), state }
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
        let Self { dialect, axes, retract, state, .. } = self;
        let Some(block) = dialect.block(trigger) else {
            return if trigger.may_lack_a_block() { Ok(()) } else { Err(WriteError::NoBlock(trigger)) };
        };
        let start = out.len();
        for line in &block.lines {
            state.line.clear();
            for piece in &line.pieces {
                let printed = match piece {
                    Piece::Value(Value::Retract, _) => print_retract(dialect, axes, *retract, &mut state.line),
                    _ => command_piece(piece, dialect, state, values),
                };
                if let Err(error) = printed {
                    out.truncate(start);
                    return Err(error);
                }
            }
            state.line.finish(line.numbered, out);
        }
        if trigger == Trigger::Tool {
            state.approaching = true;
            state.tool = (values.tool, values.register);
        }
        if trigger == Trigger::Tool || moves(block, dialect) {
            state.forget();
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
        let Self { dialect, blocks, axes, state, .. } = self;
        let feed = state.feed(approach, dialect)?;
        let block = motion_block(dialect, blocks, approach, state.approaching)?;
        let changes = state.want(axes, joints, tool_length_mm)?;
        if changes == Changes(0) {
            return Ok(());
        }
        state.approaching = false;
        let start = out.len();
        for line in &block.lines {
            if block.lines.len() > 1 && changes.leave_alone(line) {
                continue;
            }
            state.line.clear();
            for piece in &line.pieces {
                if let Err(error) = motion_piece(piece, dialect, axes, state, changes, feed) {
                    out.truncate(start);
                    return Err(error);
                }
            }
            state.line.finish(line.numbered, out);
        }
        state.axes.iter_mut().for_each(|axis| axis.current = axis.wanted);
        state.has_axes = true;
        Ok(())
    }
}

/// Prints the word that takes the tool to its way out.
fn print_retract(
    dialect: &Dialect,
    axes: &[AxisWord],
    retract: Option<Retract>,
    line: &mut Line,
) -> Result<(), WriteError> {
    if let Some(text) = &dialect.retract {
        line.text(text);
        return Ok(());
    }
    let retract = retract.expect("some axis of a checked machine moves along its tool");
    let axis = &axes[retract.axis];
    let length = axis.print(axis.retract_units(&retract)?, line.room(axis.room()));
    line.take(length);
    Ok(())
}

/// The block of a motion: that of the approach for a first one, where the controller has it.
fn motion_block<'d>(
    dialect: &'d Dialect,
    blocks: &[Option<usize>],
    approach: Approach,
    is_first: bool,
) -> Result<&'d Block, WriteError> {
    let (first, plain) = match approach {
        Approach::Rapid => (Trigger::Approach, Trigger::Rapid),
        Approach::Feed(_) => (Trigger::ApproachFeed, Trigger::Feed),
    };
    let first = if is_first { blocks[first as usize] } else { None };
    let block = first.or(blocks[plain as usize]).ok_or(WriteError::NoBlock(plain))?;
    Ok(&dialect.blocks[block])
}

/// Prints a piece of a motion's line.
#[inline]
fn motion_piece(
    piece: &Piece,
    dialect: &Dialect,
    axes: &[AxisWord],
    state: &mut State,
    changes: Changes,
    feed: Option<FeedState>,
) -> Result<(), WriteError> {
    match piece {
        Piece::Text(text) => state.line.template(text),
        Piece::Modal { group, code } => {
            if state.codes[*group].replace(*code) != Some(*code) {
                state.line.text(&dialect.modal_groups[*group][*code]);
            }
        }
        Piece::Axes(indices) => print_axes(indices, axes, state, changes),
        Piece::Feed => {
            if let Some(feed) = feed
                && state.feed.replace(feed) != Some(feed)
            {
                print_feed(feed, dialect, state);
            }
        }
        Piece::Value(Value::FeedMode, _) => {
            let mode = feed.map(|feed| feed.mode).or(state.feed_mode).unwrap_or(FeedMode::PerMinute);
            print_feed_mode(mode, dialect, state);
        }
        Piece::Value(value, picture) => {
            let (tool, register) = state.tool;
            let values = Values { tool, register, ..Values::default() };
            return state.line.print(|bytes| values.print(*value, picture.as_ref(), dialect, bytes));
        }
    }
    Ok(())
}

/// Prints the words of these axes that change, a blank between them.
#[inline]
fn print_axes(indices: &[usize], axes: &[AxisWord], state: &mut State, changes: Changes) {
    let room = state.line.room(state.room);
    let mut length = 0;
    for &index in indices {
        if changes.has(index) {
            length += axes[index].print(state.axes[index].wanted, &mut room[length..]);
            room[length] = b' ';
            length += 1;
        }
    }
    state.line.take(length.saturating_sub(1));
}

/// Prints the code of the feed's kind, if it changes, and the feed word.
fn print_feed(feed: FeedState, dialect: &Dialect, state: &mut State) {
    let start = state.line.len();
    print_feed_mode(feed.mode, dialect, state);
    if state.line.len() > start {
        state.line.byte(b' ');
    }
    feed.print(dialect, &mut state.line);
}

/// Prints the code of the feed's kind, if it changes.
fn print_feed_mode(mode: FeedMode, dialect: &Dialect, state: &mut State) {
    if state.feed_mode.replace(mode) != Some(mode) {
        state.line.text(mode.code(dialect));
    }
}

/// Prints a piece of a command's line.
fn command_piece(piece: &Piece, dialect: &Dialect, state: &mut State, values: &Values<'_>) -> Result<(), WriteError> {
    match piece {
        Piece::Text(text) => state.line.template(text),
        Piece::Modal { group, code } => {
            state.codes[*group] = Some(*code);
            state.line.text(&dialect.modal_groups[*group][*code]);
        }
        Piece::Axes(_) | Piece::Feed => {} // a command moves nothing
        Piece::Value(Value::FeedMode, _) => {
            let mode = *state.feed_mode.get_or_insert(FeedMode::PerMinute);
            state.line.text(mode.code(dialect));
        }
        Piece::Value(value, picture) => {
            return state.line.print(|bytes| values.print(*value, picture.as_ref(), dialect, bytes));
        }
    }
    Ok(())
}
