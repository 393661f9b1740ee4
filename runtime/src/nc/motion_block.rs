//! The blocks of motions, taken apart when the program begins: what a motion prints is decided point by point.

use super::dialect::{Block, Dialect, Line, Piece, Trigger, Value};
use super::write_error::WriteError;
use crate::number::Picture;
use crate::toolpath::Approach;

/// The blocks of all motions.
#[derive(Debug)]
pub(super) struct MotionBlocks {
    rapid: Alternatives,
    feed: Alternatives,
}

/// The block of a motion, and that of the first one: the approach, where the controller has it.
#[derive(Debug)]
struct Alternatives {
    plain: Option<MotionBlock>,
    first: Option<MotionBlock>,
}

/// A block of a motion.
#[derive(Debug)]
pub(super) struct MotionBlock {
    pub(super) lines: Vec<MotionLine>,
}

/// A line of it.
#[derive(Debug)]
pub(super) struct MotionLine {
    /// Whether it takes a sequence number.
    pub(super) numbered: bool,
    /// Its axes, if it is left out when none of their words changes: one of several lines, with axis words.
    pub(super) left_out_without: Option<Vec<usize>>,
    pub(super) steps: Vec<Step>,
}

/// What one piece of a line prints. The tag has a byte of its own, because it is read more often than anything else.
#[derive(Debug)]
#[repr(u8)]
pub(super) enum Step {
    /// A blank between two pieces.
    Blank,
    /// Any other text.
    Text(String),
    /// A code (by its index) of a modal group (by its index), when it is not in force.
    Modal { group: usize, code: usize, text: String },
    /// The words of these axes that change.
    Axes(Vec<usize>),
    /// The feed word when it changes, behind the code of its kind when that changes, if the line has no place for that.
    Feed { with_mode: bool },
    /// The code of the feed's kind, when it changes.
    FeedMode,
    /// A value.
    Value(Value, Option<Picture>),
}

impl MotionBlocks {
    pub(super) fn new(dialect: &Dialect) -> Self {
        let block = |trigger| dialect.block(trigger).map(|block| MotionBlock::new(block, dialect));
        let alternatives = |plain, first| Alternatives { plain: block(plain), first: block(first).or(block(plain)) };
        Self {
            rapid: alternatives(Trigger::Rapid, Trigger::Approach),
            feed: alternatives(Trigger::Feed, Trigger::ApproachFeed),
        }
    }

    /// The block of a motion.
    ///
    /// # Errors
    /// When the controller has none.
    #[inline]
    pub(super) fn of(&self, approach: Approach, is_first: bool) -> Result<&MotionBlock, WriteError> {
        let (alternatives, trigger) = match approach {
            Approach::Rapid => (&self.rapid, Trigger::Rapid),
            Approach::Feed(_) => (&self.feed, Trigger::Feed),
        };
        let block = if is_first { &alternatives.first } else { &alternatives.plain };
        block.as_ref().ok_or(WriteError::NoBlock(trigger))
    }
}

impl MotionBlock {
    fn new(block: &Block, dialect: &Dialect) -> Self {
        let is_one_of_several = block.lines.len() > 1;
        Self { lines: block.lines.iter().map(|line| MotionLine::new(line, is_one_of_several, dialect)).collect() }
    }
}

impl MotionLine {
    fn new(line: &Line, is_one_of_several: bool, dialect: &Dialect) -> Self {
        let words =
            line.pieces.iter().filter_map(|piece| if let Piece::Axes(axes) = piece { Some(axes) } else { None });
        let has_words = words.clone().next().is_some();
        Self {
            numbered: line.numbered,
            left_out_without: (is_one_of_several && has_words).then(|| words.flatten().copied().collect()),
            steps: line.pieces.iter().map(|piece| Step::new(piece, line, dialect)).collect(),
        }
    }
}

impl Step {
    fn new(piece: &Piece, line: &Line, dialect: &Dialect) -> Self {
        let says_mode = |piece: &Piece| matches!(piece, Piece::Value(Value::FeedMode, _));
        match piece {
            Piece::Text(text) if text == " " => Self::Blank,
            Piece::Text(text) => Self::Text(text.clone()),
            Piece::Modal { group, code } => {
                Self::Modal { group: *group, code: *code, text: dialect.modal_groups[*group][*code].clone() }
            }
            Piece::Axes(axes) => Self::Axes(axes.clone()),
            Piece::Feed => Self::Feed { with_mode: !line.pieces.iter().any(says_mode) },
            Piece::Value(Value::FeedMode, _) => Self::FeedMode,
            Piece::Value(value, picture) => Self::Value(*value, picture.clone()),
        }
    }
}
