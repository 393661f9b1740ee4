//! The text of a meaning: codes and words with holes. Printing fills the holes, reading matches them.

use super::meaning::Meaning;

/// One text, and what it means.
#[derive(Debug, Clone, PartialEq)]
pub struct Pattern {
    /// What it means; a text such as `G49` may switch off more than one thing.
    pub meanings: Vec<Meaning>,
    /// The number that goes with it where no hole has it: `2` of `group offset { 2 "G55" }`.
    pub number: Option<u32>,
    /// What stands in the block, in any order. Never empty.
    pub words: Vec<PatternWord>,
}

/// One word of a pattern.
#[derive(Debug, Clone, PartialEq)]
pub enum PatternWord {
    /// An address and a number: `G54`, `G43.4`, `D0`. Numbers compare by value: `G01` is `G1`.
    Code {
        /// In capitals.
        address: String,
        /// In thousandths.
        thousandths: i64,
    },
    /// An address and a number that is a hole: `H{register}`.
    Hole {
        /// In capitals; empty for a number that stands alone (`TOOL CALL {tool}`), `<` for a name in angle brackets.
        address: String,
        /// What the number is.
        hole: Hole,
    },
    /// A number that stands alone.
    Number {
        /// In thousandths.
        thousandths: i64,
    },
    /// A word without a number: `SUPA`, `FMAX`, `CALL`, `DR+`.
    Name(String),
    /// A name with arguments: `MSG("{text}")`.
    Call {
        /// In capitals.
        name: String,
        /// One after the other.
        arguments: Vec<Argument>,
    },
}

/// An argument of a call.
#[derive(Debug, Clone, PartialEq)]
pub enum Argument {
    /// This very text (numbers compare by value); may be empty.
    Literal(String),
    /// Text in quotes.
    Text(Hole),
}

/// What a hole stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hole {
    /// The tool's number.
    Tool,
    /// A register of the tool's length or radius.
    Register,
    /// A time in seconds.
    Seconds,
    /// A time in milliseconds.
    Milliseconds,
    /// The program's name or number.
    Program,
    /// Text for the operator.
    Text,
    /// Any number, of which nothing is made.
    Any,
}
