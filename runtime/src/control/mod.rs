//! A control, as far as a program can tell: text in, motion out, by nothing but the dialect's table.
//!
//! A line is cut into tokens (`token`), patterns claim them (`claim`), the block is what they mean (`block`); plain ones have a
//! shorter way there (`plain`). A block changes what is modal (`modal`), and moves axes (`motion`): a control knows where they are
//! only once it has been told.

mod block;
mod claim;
mod line;
mod mistake;
mod modal;
mod motion;
mod plain;
mod token;

pub use block::{AxisWord, Block, Code};
pub use mistake::Mistake;
pub use modal::Modal;

use crate::dialect::meaning::{Coolant, Distance, FeedMode, Meaning, Once, Spindle};
use crate::dialect::table::{BlockKind, Table};
use crate::machine::Axis;
use crate::motion::{Event, Feed, Item, Motion, What};
use crate::tool::ToolGeometry;
use crate::unit::LengthUnit;
use plain::Plain;
use std::mem;
use std::ops::Range;

/// A mistake in a line, and where it stands, in bytes of the line.
pub type Fault = (Mistake, Range<usize>);

/// A control that runs a program block by block.
#[derive(Debug, Clone)]
pub struct Control<'m> {
    table: &'m Table,
    order: Vec<usize>,
    plain: Plain,
    axes: &'m [Axis],
    tool: ToolGeometry,
    modal: Modal,
    /// Machine coordinates in millimetres and degrees; zero where it is not known.
    joints: Vec<f64>,
    /// The axes whose position is known, the first one in the lowest bit.
    known: u64,
    /// Whether a block has been carried out: a program has begun.
    has_begun: bool,
    /// Whether the program has said that it is over.
    is_over: bool,
    /// The text of lines that go on in the next one.
    continued: String,
    /// The last block, whose room is used again.
    block: Block,
    /// What was modal and where the axes were before it.
    before: (Modal, Vec<f64>, u64),
}

impl<'m> Control<'m> {
    /// A control that has been switched on. `axes` are the machine's, in the order that the table counts them in.
    pub fn new(table: &'m Table, axes: &'m [Axis], tool: ToolGeometry) -> Self {
        let mut modal = Modal::default();
        table.power_on.iter().for_each(|&(meaning, number)| modal.take(meaning, number));
        let joints = vec![0.0; axes.len()];
        Self {
            table,
            order: claim::order(table),
            plain: Plain::of(table),
            axes,
            tool,
            modal,
            before: (modal, joints.clone(), 0),
            joints,
            known: 0,
            has_begun: false,
            is_over: false,
            continued: String::new(),
            block: Block::default(),
        }
    }

    /// The block that was run last.
    pub fn block(&self) -> &Block {
        &self.block
    }

    /// Whether the program has said that it is over.
    pub fn is_over(&self) -> bool {
        self.is_over
    }

    /// Whether the last line goes on in the next one.
    pub fn is_continued(&self) -> bool {
        !self.continued.is_empty()
    }

    /// What is modal now.
    pub fn modal(&self) -> &Modal {
        &self.modal
    }

    /// Puts what is modal into a state, as if blocks had done so.
    pub fn set_modal(&mut self, modal: Modal) {
        self.modal = modal;
        self.has_begun = true;
    }

    /// The axes whose position is known, the first one in the lowest bit.
    pub fn known(&self) -> u64 {
        self.known
    }

    /// Puts the axes somewhere, in machine coordinates.
    pub fn stand_at(&mut self, joints: &[f64]) {
        self.joints.copy_from_slice(joints);
        self.known = (1 << joints.len()) - 1;
    }

    /// Reads a line without running it; `None` for a line without a block.
    ///
    /// # Errors
    /// What the control does not understand.
    pub fn read(&self, text: &str) -> Result<Option<Block>, Fault> {
        let line = line::block(text, self.table)?;
        let capitals = line.text.to_ascii_uppercase();
        if capitals.trim().is_empty() {
            return Ok(None);
        }
        let at = |(mistake, span): Fault| (mistake, span.start + line.at..span.end + line.at);
        Block::read(&capitals, self.table, &self.order).map(Some).map_err(at)
    }

    /// Runs a line of the program, and appends what it does to `out`. Nothing is done by a line without a block, and by one that
    /// goes on in the next.
    ///
    /// # Errors
    /// What the control does not understand, or cannot do. Nothing of the line has been done then.
    pub fn run(&mut self, text: &str, number: u64, out: &mut Motion) -> Result<(), Fault> {
        self.block.clear();
        if self.continued.is_empty() && self.plain.read(text.as_bytes(), &mut self.block) {
            if self.goes_straight() {
                self.go_straight(number, out);
                return Ok(());
            }
            return self.try_block(number, out).map_err(|mistake| (mistake, 0..text.len()));
        }
        let Some((block, span)) = self.whole_block(text)? else { return Ok(()) };
        self.block = block;
        self.try_block(number, out).map_err(|mistake| (mistake, span))
    }

    /// Runs a text line by line, and leaves out what it does not understand.
    pub fn run_what_it_can(&mut self, text: &str, out: &mut Motion) {
        for (number, line) in (1..).zip(text.lines()) {
            let _ = self.run(line, number, out);
        }
    }

    /// The block that ends in a line, and where it stands.
    fn whole_block(&mut self, text: &str) -> Result<Option<(Block, Range<usize>)>, Fault> {
        let line = line::block(text, self.table)?;
        let capitals = line.text.to_ascii_uppercase();
        if let Some(mark) = &self.table.continued
            && let Some(begun) = capitals.trim_end().strip_suffix(mark.as_str())
        {
            self.continued = format!("{}{begun} ", self.continued);
            return Ok(None);
        }
        let begun = mem::take(&mut self.continued);
        let before = begun.len();
        let whole = begun + &capitals;
        if whole.trim().is_empty() {
            return Ok(None);
        }
        // What stands in the lines before is told of the whole of this one.
        let here = line.at..line.at + capitals.len();
        let at = |(mistake, span): Fault| match span.start.checked_sub(before) {
            Some(start) => (mistake, start + line.at..span.end - before + line.at),
            None => (mistake, here.clone()),
        };
        let block = Block::read(&whole, self.table, &self.order).map_err(at)?;
        Ok(Some((block, here)))
    }

    /// Carries the block out, whole or not at all.
    fn try_block(&mut self, line: u64, out: &mut Motion) -> Result<(), Mistake> {
        (self.before.0, self.before.2) = (self.modal, self.known);
        self.before.1.copy_from_slice(&self.joints);
        let (block, items) = (mem::take(&mut self.block), out.items().len());
        let done = self.carry_out(&block, line, out);
        self.block = block;
        if done.is_err() {
            out.truncate(items);
            (self.modal, self.known) = (self.before.0, self.before.2);
            self.joints.copy_from_slice(&self.before.1);
        }
        done
    }

    /// Does what a block says, in the order in which a control does: what is modal, the spindle and the coolant on, the tool,
    /// the motion, and then what stops something.
    fn carry_out(&mut self, block: &Block, line: u64, out: &mut Motion) -> Result<(), Mistake> {
        if self.has_begun && block.once(Once::Program).is_some() {
            return Err(Mistake::NotFollowed("a program that begins within another"));
        }
        self.has_begun = true;
        let number = |code: &Code| code.number.map(|number| number as u32);
        let early = block.codes.iter().filter(|code| !is_late(code.meaning));
        early.for_each(|code| self.modal.take(code.meaning, number(code)));
        self.take_words(block);
        if let Some(code) = block.once(Once::ToolChange) {
            let tool = number(code).or(self.modal.called_tool);
            self.modal.state.tool = tool;
            self.event(Event::ToolChange(tool.unwrap_or(0)), line, out);
        }
        if let Some(code) = block.once(Once::Preselect) {
            self.modal.called_tool = number(code);
        }
        if let Some(code) = block.once(Once::Dwell) {
            self.event(Event::Dwell(code.number.unwrap_or(0.0)), line, out);
        }
        self.place_words(block, line, out)?;
        if self.table.blocks == BlockKind::Statements {
            // A statement says its motion itself.
            self.modal.motion = None;
        }
        let late = block.codes.iter().filter(|code| is_late(code.meaning));
        late.for_each(|code| self.modal.take(code.meaning, number(code)));
        for (once, event) in
            [(Once::Stop, Event::Stop), (Once::OptionalStop, Event::OptionalStop), (Once::End, Event::End)]
        {
            if block.once(once).is_some() {
                self.event(event, line, out);
                self.is_over |= event == Event::End;
            }
        }
        if block.once(Once::ProgramEnd).is_some() && !mem::replace(&mut self.is_over, true) {
            self.event(Event::End, line, out);
        }
        Ok(())
    }

    /// Axis words, which are a motion where the block does not say something else of them.
    fn place_words(&mut self, block: &Block, line: u64, out: &mut Motion) -> Result<(), Mistake> {
        if block.once(Once::Stock).is_some() {
            return Ok(());
        }
        if block.once(Once::Pole).is_some() {
            return self.set_pole(block);
        }
        if block.once(Once::RetractAlongTool).is_some() {
            return self.retract_along_tool(block, line, out);
        }
        if block.axes.is_empty() && block.centre == [None; 3] { Ok(()) } else { self.go(block, line, out) }
    }

    /// Feed, speed and tool.
    fn take_words(&mut self, block: &Block) {
        self.modal.called_tool = block.tool.map(|tool| tool as u32).or(self.modal.called_tool);
        self.modal.state.speed_rpm = block.speed.unwrap_or(self.modal.state.speed_rpm);
        self.take_feed(block.feed);
    }

    /// A feed word, if there is one, or the one before; in metric units, as far as it is known what it counts.
    fn take_feed(&mut self, word: Option<f64>) {
        self.modal.feed = word.or(self.modal.feed);
        let is_inch = self.modal.units == Some(LengthUnit::Inch);
        let (length, speed) = if is_inch { (25.4, self.table.inch_feed_mm) } else { (1.0, 1.0) };
        self.modal.state.feed = self.modal.feed.zip(self.modal.feed_mode).map(|(feed, mode)| match mode {
            FeedMode::PerMinute => Feed::PerMinute(speed * feed),
            FeedMode::PerRevolution => Feed::PerRevolution(length * feed),
            FeedMode::Inverse => Feed::Inverse(feed),
        });
    }

    fn event(&mut self, event: Event, line: u64, out: &mut Motion) {
        let state = out.push_state(&self.modal.state);
        out.push(Item { line, state, what: What::Event(event) });
    }

    /// Whether axis words count from where the axes are.
    fn is_incremental(&self) -> bool {
        self.modal.distance == Some(Distance::Incremental)
    }
}

/// Whether a code acts when the block's motion is over.
fn is_late(meaning: Meaning) -> bool {
    matches!(meaning, Meaning::Spindle(Spindle::Off) | Meaning::Coolant(Coolant::Off))
}
