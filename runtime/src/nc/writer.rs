//! The writer: prints commands and motions by the dialect's blocks, and words only when they change.
//!
//! What is modal: the axis words, the codes of the dialect's modal groups, the feed word and the code of its kind.
//! Motions print them when they change; every other block prints its codes always. After a tool change, and after any
//! block other than a motion that prints an axis word, axis words, codes and the feed are forgotten: the next motion
//! prints them all. The first motion of a program and of a tool prints the block of the approach, if there is one.

use super::dialect::{Dialect, Piece, Trigger, Value};
use super::feed_word::{FeedMode, FeedState};
use super::line_buffer::LineBuffer;
use super::motion_block::{MotionBlocks, MotionLine, Step};
use super::moves::moves;
pub use super::switches_off::SwitchesOff;
pub use super::values::Values;
use super::write_error::WriteError;
use super::written_axes::WrittenAxes;
use crate::machine::{Axis, Retract};
use crate::toolpath::{Approach, Feed, LoadedTool};

/// Prints one program.
#[derive(Debug)]
pub struct Writer {
    dialect: Dialect,
    motions: MotionBlocks,
    /// Of the block of each trigger, in their order.
    switches_off: [SwitchesOff; Trigger::ALL.len()],
    retract: Option<Retract>,
    state: State,
}

/// What the control knows from the blocks so far, and the line being printed.
#[derive(Debug)]
struct State {
    line: LineBuffer,
    axes: WrittenAxes,
    /// The code in force of each modal group.
    codes: Vec<Option<usize>>,
    feed: Option<FeedState>,
    feed_mode: Option<FeedMode>,
    /// The feed of the last motion that had one, as the CL has it and converted.
    converted: Option<(Feed, FeedState)>,
    /// Whether the next motion is the first of the program or of its tool.
    approaching: bool,
    tool: Option<LoadedTool>,
}

impl Writer {
    /// A writer at the start of a program. `axes` are the machine's, in the order of the dialect's axis words.
    pub fn new(dialect: Dialect, axes: &[Axis]) -> Self {
        let state = State {
            line: LineBuffer::new(dialect.sequence.clone()),
            axes: WrittenAxes::new(&dialect, axes),
            codes: vec![None; dialect.modal_groups.len()],
            feed: None,
            feed_mode: None,
            converted: None,
            approaching: true,
            tool: None,
        };
        Self {
            motions: MotionBlocks::new(&dialect),
            switches_off: Trigger::ALL.map(|trigger| SwitchesOff::of(trigger, &dialect)),
            dialect,
            retract: Retract::of(axes),
            state,
        }
    }

    /// The dialect it prints by.
    pub fn dialect(&self) -> &Dialect {
        &self.dialect
    }

    /// Takes it that this tool is in the spindle.
    pub fn load(&mut self, tool: LoadedTool) {
        self.state.tool = Some(tool);
    }

    /// Whether the control knows where all axes are: not before the first motion, nor behind a block that moves an axis
    /// elsewhere.
    pub fn knows_position(&self) -> bool {
        self.state.axes.are_known()
    }

    /// What the block of a command switches off beside what it is for.
    pub fn switches_off(&self, trigger: Trigger) -> SwitchesOff {
        self.switches_off[trigger as usize]
    }

    /// Appends the block of a command (any trigger but a motion).
    ///
    /// # Errors
    /// When the controller has no such block, or a value cannot be printed; `out` is then as it was.
    pub fn command(&mut self, trigger: Trigger, values: &Values<'_>, out: &mut Vec<u8>) -> Result<(), WriteError> {
        let Self { dialect, retract, state, .. } = self;
        let Some(block) = dialect.block(trigger) else {
            return if trigger.may_lack_a_block() { Ok(()) } else { Err(WriteError::NoBlock(trigger)) };
        };
        let start = out.len();
        for line in &block.lines {
            state.line.clear();
            for piece in &line.pieces {
                let printed = match piece {
                    Piece::Value(Value::Retract, _) => state.print_retract(retract.as_ref(), dialect),
                    _ => state.print_piece(piece, values, dialect),
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
            state.tool = values.tool;
        }
        if trigger == Trigger::Tool || moves(block, dialect) {
            state.forget();
        }
        Ok(())
    }

    /// Appends the block of a motion to `joints` (machine coordinates in mm and degrees, in the machine's order).
    /// Nothing is printed when no axis word changes. Gives the number of blocks.
    ///
    /// # Errors
    /// When the controller has no such block, or a number does not fit its word; `out` is then as it was.
    pub fn motion(
        &mut self,
        approach: Approach,
        joints: &[f64],
        tool_length_mm: f64,
        out: &mut Vec<u8>,
    ) -> Result<u64, WriteError> {
        let Self { dialect, motions, state, .. } = self;
        let feed = state.convert(approach, dialect)?;
        let block = motions.of(approach, state.approaching)?;
        if !state.axes.go_to(joints, tool_length_mm)? {
            return Ok(0);
        }
        state.approaching = false;
        let (start, mut blocks) = (out.len(), 0);
        for line in &block.lines {
            if line.left_out_without.as_ref().is_some_and(|axes| !state.axes.change(axes)) {
                continue;
            }
            if let Err(error) = state.print_line(line, feed, dialect) {
                state.axes.go_back();
                out.truncate(start);
                return Err(error);
            }
            blocks += u64::from(state.line.finish(line.numbered, out));
        }
        Ok(blocks)
    }
}

impl State {
    /// Takes nothing for granted any more; only the kind of feed and the sequence number stay.
    fn forget(&mut self) {
        self.axes.forget();
        self.codes.fill(None);
        self.feed = None;
    }

    /// The feed of a motion, if it has one.
    #[inline]
    fn convert(&mut self, approach: Approach, dialect: &Dialect) -> Result<Option<FeedState>, WriteError> {
        let Approach::Feed(Some(feed)) = approach else { return Ok(None) };
        match self.converted {
            Some((last, converted)) if last == feed => Ok(Some(converted)),
            _ => self.convert_other(feed, dialect).map(Some),
        }
    }

    #[cold]
    fn convert_other(&mut self, feed: Feed, dialect: &Dialect) -> Result<FeedState, WriteError> {
        let converted = FeedState::new(feed, dialect)?;
        self.converted = Some((feed, converted));
        Ok(converted)
    }

    /// Prints a line of a motion.
    #[inline]
    fn print_line(&mut self, line: &MotionLine, feed: Option<FeedState>, dialect: &Dialect) -> Result<(), WriteError> {
        self.line.clear();
        for step in &line.steps {
            match step {
                Step::Blank => self.line.blank(),
                Step::Text(text) => self.line.template(text),
                Step::Modal { group, code, text } => {
                    if self.codes[*group] != Some(*code) {
                        self.codes[*group] = Some(*code);
                        self.line.text(text);
                    }
                }
                Step::Axes(indices) => self.axes.print(indices, &mut self.line),
                Step::Feed { with_mode } => {
                    if let Some(feed) = feed
                        && self.feed != Some(feed)
                    {
                        self.print_feed(feed, *with_mode, dialect);
                    }
                }
                Step::FeedMode => {
                    let mode = feed.map(|feed| feed.mode).or(self.feed_mode).unwrap_or(FeedMode::PerMinute);
                    self.print_feed_mode(mode, dialect);
                }
                Step::Value(value, picture) => {
                    // Register zero is none: the control would compensate no length.
                    let tool = self.tool.filter(|tool| *value != Value::Register || tool.register > 0);
                    let values = Values { tool, ..Values::default() };
                    self.line.print(|bytes| values.print(*value, picture.as_ref(), dialect, bytes))?;
                }
            }
        }
        Ok(())
    }

    /// Prints the feed word, and the code of its kind before it, if that changes and stands there.
    #[cold]
    fn print_feed(&mut self, feed: FeedState, with_mode: bool, dialect: &Dialect) {
        self.feed = Some(feed);
        let start = self.line.len();
        if with_mode {
            self.print_feed_mode(feed.mode, dialect);
        }
        if self.line.len() > start {
            self.line.byte(b' ');
        }
        feed.print(dialect, &mut self.line);
    }

    /// Prints the code of the feed's kind, if it changes.
    fn print_feed_mode(&mut self, mode: FeedMode, dialect: &Dialect) {
        if self.feed_mode.replace(mode) != Some(mode) {
            self.line.text(mode.code(dialect));
        }
    }

    /// Prints the word that takes the tool to its way out.
    fn print_retract(&mut self, retract: Option<&Retract>, dialect: &Dialect) -> Result<(), WriteError> {
        if let Some(text) = &dialect.retract {
            self.line.text(text);
            return Ok(());
        }
        let retract = retract.expect("some axis of a checked machine moves along its tool");
        self.axes.print_retract(retract, &mut self.line)
    }

    /// Prints a piece of a command's line.
    fn print_piece(&mut self, piece: &Piece, values: &Values<'_>, dialect: &Dialect) -> Result<(), WriteError> {
        match piece {
            Piece::Text(text) => self.line.template(text),
            Piece::Modal { group, code } => {
                self.codes[*group] = Some(*code);
                self.line.text(&dialect.modal_groups[*group][*code]);
            }
            Piece::Axes(_) | Piece::Feed => {} // a command moves nothing
            Piece::Value(Value::FeedMode, _) => {
                let mode = *self.feed_mode.get_or_insert(FeedMode::PerMinute);
                self.line.text(mode.code(dialect));
            }
            Piece::Value(value, picture) => {
                return self.line.print(|bytes| values.print(*value, picture.as_ref(), dialect, bytes));
            }
        }
        Ok(())
    }
}
