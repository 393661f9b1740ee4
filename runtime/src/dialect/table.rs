//! The whole of a dialect as a control reads it.

use super::meaning::{Meaning, Wrap};
use super::pattern::Pattern;

/// What the texts of a dialect mean, for one machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// How blocks are put together.
    pub blocks: BlockKind,
    /// What opens and closes a comment; an empty close means the end of the line.
    pub comment: (String, String),
    /// The address of sequence numbers; empty where they have none (`12 L X+5`). `None`: there are none.
    pub sequence: Option<String>,
    /// What stands at the end of a line that goes on in the next one (`~`).
    pub continued: Option<String>,
    /// Words that have a number of their own.
    pub words: Vec<TableWord>,
    /// Other ways to write an axis word.
    pub forms: Vec<Form>,
    /// The codes, and the words that stand only with them.
    pub patterns: Vec<Pattern>,
    /// How the control takes the word of a rotary axis that is written within a turn, while no block has said it.
    pub wrap: Wrap,
    /// What one of the feed word is in a program in inches, in millimetres a minute.
    pub inch_feed_mm: f64,
    /// What is in force when the control is switched on, as far as the dialect says.
    pub power_on: Vec<(Meaning, Option<u32>)>,
}

/// How blocks are put together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BlockKind {
    /// Words of a letter and a number, blanks between them or none: `N10G1X5.`.
    Words,
    /// Words between blanks, the first of which say what the block is: `L X+10 R0 FMAX`. A motion is said in each block.
    Statements,
}

/// A word that has a number of its own, wherever it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct TableWord {
    /// What stands before the number, in capitals: `X`, `C1=`, `CR=`.
    pub address: String,
    /// What the number is.
    pub role: Role,
    /// What one is in millimetres, degrees or the like, in a metric program.
    pub metric: f64,
    /// The same in a program in inches.
    pub inch: f64,
    /// What a number without a decimal point is multiplied with; `None` where that is not known, so that it is refused.
    pub pointless: Option<f64>,
}

/// What the number of a word is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Where the axis with this index goes.
    Axis(usize),
    /// A coordinate of an arc's centre, along X, Y or Z.
    Centre(usize),
    /// The radius of an arc, negative for the longer one of two.
    Radius,
    /// The feed.
    Feed,
    /// The spindle's speed.
    Speed,
    /// The tool that comes next.
    Tool,
}

/// Another way to write an axis word: `X=IC(10)`, `IX+10`, `C=DC(90)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Form {
    /// How the number is meant.
    pub meaning: FormMeaning,
    /// Before the axis' name.
    pub before: String,
    /// Between the name and the number.
    pub between: String,
    /// Behind the number.
    pub behind: String,
}

/// How the number of an axis word is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FormMeaning {
    /// From the zero in force, whatever is modal.
    Absolute,
    /// From where the axis is.
    Incremental,
    /// Within the turn, the shortest way.
    Shortest,
    /// Within the turn, in the positive sense.
    Positive,
    /// Within the turn, in the negative sense.
    Negative,
}
