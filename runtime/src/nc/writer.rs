//! The writer: prints commands and motions by the dialect's blocks, and words only when they change.
//!
//! What is modal: the axis words, the codes of the dialect's modal groups, the feed word and the code of its kind.
//! Motions print them when they change; every other block prints its codes always. After a tool change, and after any
//! block other than a motion that prints an axis word, axis words, codes and the feed are forgotten: the next motion
//! prints them all. The first motion of a program and of a tool prints the block of the approach, if there is one.

use super::axis_word::AxisWord;
use super::dialect::{Block, Dialect, Line, Piece, Trigger, Value};
use super::feed_word::{FeedMode, FeedState};
use super::line::{Numbering, OpenLine};
use super::moves::moves;
pub use super::values::Values;
use super::write_error::WriteError;
use crate::cl::event::Approach;
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
    numbering: Numbering,
    /// Each axis word's number in units of its last decimal.
    axes: Vec<Option<i64>>,
    /// The same for the motion being printed.
    wanted: Vec<i64>,
    /// The code in force of each modal group.
    codes: Vec<Option<usize>>,
    feed: Option<FeedState>,
    feed_mode: Option<FeedMode>,
    /// Whether the next motion is the first of the program or of its tool.
    approaching: bool,
    /// The tool's number and its length register.
    tool: (u64, u64),
}

impl State {
    /// Takes nothing for granted any more; only the kind of feed and the sequence number stay.
    fn forget(&mut self) {
        self.axes.fill(None);
        self.codes.fill(None);
        self.feed = None;
    }

    fn changes(&self, axis: usize) -> bool {
        self.axes[axis] != Some(self.wanted[axis])
    }

    /// Whether a line has axis words, and none of them changes.
    fn stands_still(&self, line: &Line) -> bool {
        let axes =
            || line.pieces.iter().filter_map(|piece| if let Piece::Axes(axes) = piece { Some(axes) } else { None });
        axes().next().is_some() && !axes().flatten().any(|axis| self.changes(*axis))
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
            approaching: true,
            tool: (0, 0),
        };
        let words = dialect.axes.iter().zip(axes);
        let words = words.map(|(word, axis)| AxisWord::new(word, axis, dialect.units)).collect();
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
        let Some(block) = self.dialect.block(trigger) else {
            return if trigger.may_lack_a_block() { Ok(()) } else { Err(WriteError::NoBlock(trigger)) };
        };
        let start = out.len();
        for line in &block.lines {
            let open = OpenLine::begin(line.numbered, &self.state.numbering, out);
            for piece in &line.pieces {
                let printed = match piece {
                    Piece::Value(Value::Retract, _) => self.print_retract(out),
                    _ => command_piece(piece, &self.dialect, &mut self.state, values, open, out),
                };
                if let Err(error) = printed {
                    out.truncate(start);
                    return Err(error);
                }
            }
            open.end(&mut self.state.numbering, out);
        }
        if trigger == Trigger::Tool {
            self.state.approaching = true;
            self.state.tool = (values.tool, values.register);
        }
        if trigger == Trigger::Tool || moves(block, &self.dialect) {
            self.state.forget();
        }
        Ok(())
    }

    /// Prints the word that takes the tool to its way out.
    fn print_retract(&self, out: &mut Vec<u8>) -> Result<(), WriteError> {
        if let Some(text) = &self.dialect.retract {
            out.extend_from_slice(text.as_bytes());
            return Ok(());
        }
        let retract = self.retract.expect("some axis of a checked machine moves along its tool");
        let axis = &self.axes[retract.axis];
        axis.print(axis.retract_units(&retract)?, out);
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
        let feed = match approach {
            Approach::Rapid | Approach::Feed(None) => None,
            Approach::Feed(Some(feed)) => Some(FeedState::new(feed, &self.dialect)?),
        };
        let block = motion_block(&self.dialect, &self.blocks, approach, self.state.approaching)?;
        let state = &mut self.state;
        for ((axis, joint), wanted) in self.axes.iter().zip(joints).zip(&mut state.wanted) {
            *wanted = axis.units(*joint, tool_length_mm)?;
        }
        if state.wanted.iter().zip(&state.axes).all(|(wanted, current)| *current == Some(*wanted)) {
            return Ok(());
        }
        state.approaching = false;
        let start = out.len();
        for line in &block.lines {
            if block.lines.len() > 1 && state.stands_still(line) {
                continue;
            }
            let open = OpenLine::begin(line.numbered, &state.numbering, out);
            for piece in &line.pieces {
                if let Err(error) = motion_piece(piece, &self.dialect, &self.axes, state, feed, open, out) {
                    out.truncate(start);
                    return Err(error);
                }
            }
            open.end(&mut state.numbering, out);
        }
        for (current, wanted) in state.axes.iter_mut().zip(&state.wanted) {
            *current = Some(*wanted);
        }
        Ok(())
    }
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
    feed: Option<FeedState>,
    open: OpenLine,
    out: &mut Vec<u8>,
) -> Result<(), WriteError> {
    match piece {
        Piece::Text(text) => open.text(text, out),
        Piece::Modal { group, code } => {
            if state.codes[*group].replace(*code) != Some(*code) {
                out.extend_from_slice(dialect.modal_groups[*group][*code].as_bytes());
            }
        }
        Piece::Axes(indices) => print_axes(indices, axes, state, out),
        Piece::Feed => {
            if let Some(feed) = feed
                && state.feed.replace(feed) != Some(feed)
            {
                print_feed(feed, dialect, state, out);
            }
        }
        Piece::Value(Value::FeedMode, _) => {
            let mode = feed.map(|feed| feed.mode).or(state.feed_mode).unwrap_or(FeedMode::PerMinute);
            print_feed_mode(mode, dialect, state, out);
        }
        Piece::Value(value, picture) => {
            let (tool, register) = state.tool;
            let values = Values { tool, register, ..Values::default() };
            return values.print(*value, picture.as_ref(), dialect, out);
        }
    }
    Ok(())
}

/// Prints the words of these axes that change, a blank between them.
fn print_axes(indices: &[usize], axes: &[AxisWord], state: &State, out: &mut Vec<u8>) {
    let start = out.len();
    for &index in indices {
        if state.changes(index) {
            if out.len() > start {
                out.push(b' ');
            }
            axes[index].print(state.wanted[index], out);
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
    feed.print(dialect, out);
}

/// Prints the code of the feed's kind, if it changes.
fn print_feed_mode(mode: FeedMode, dialect: &Dialect, state: &mut State, out: &mut Vec<u8>) {
    if state.feed_mode.replace(mode) != Some(mode) {
        out.extend_from_slice(mode.code(dialect).as_bytes());
    }
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
        Piece::Axes(_) | Piece::Feed => {} // a command moves nothing
        Piece::Value(Value::FeedMode, _) => {
            let mode = *state.feed_mode.get_or_insert(FeedMode::PerMinute);
            out.extend_from_slice(mode.code(dialect).as_bytes());
        }
        Piece::Value(value, picture) => values.print(*value, picture.as_ref(), dialect, out)?,
    }
    Ok(())
}
