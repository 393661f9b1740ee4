//! What can be wrong with a block.

use crate::dialect::meaning::Meaning;
use std::fmt;

/// What is wrong with a block.
#[derive(Debug, Clone, PartialEq)]
pub enum Mistake {
    /// No word begins here.
    NoWord,
    /// A comment without its end.
    OpenComment,
    /// The dialect has no such word.
    Unknown(String),
    /// The same word twice.
    Repeated(String),
    /// Two codes of one group.
    TwoOfAGroup(Meaning, Meaning),
    /// A number without a point, whose unit the dialect does not say.
    Pointless(String),
    /// An axis word, and no code says how to get there.
    NoMotionCode,
    /// An arc without a centre and a radius.
    NoCentre,
    /// An arc whose radius is too small for its ends, or whose ends are not equally far from the centre, by so many
    /// millimetres.
    OffTheArc(f64),
    /// An arc, a step or a centre that counts from a place which is not known.
    NoPosition,
    /// The program is over where a block should go on.
    Unfinished,
    /// Something that is understood and not followed yet.
    NotFollowed(&'static str),
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoWord => write!(f, "no word begins with this character"),
            Self::OpenComment => write!(f, "the comment is not closed in its line"),
            Self::Unknown(word) => write!(f, "the controller knows no word `{word}`"),
            Self::Repeated(word) => write!(f, "`{word}` stands twice in one block"),
            Self::TwoOfAGroup(..) => write!(f, "two codes that exclude each other stand in one block"),
            Self::Pointless(word) => {
                write!(f, "`{word}` has no decimal point, and its unit is a parameter of the control")
            }
            Self::NoMotionCode => write!(f, "an axis word stands where no code says how the axis moves"),
            Self::NoCentre => write!(f, "the arc has neither a centre nor a radius"),
            Self::OffTheArc(by_mm) => write!(f, "the ends are off the arc by {by_mm:.3} mm"),
            Self::NoPosition => write!(f, "the motion counts from a position that is not known"),
            Self::Unfinished => write!(f, "the program ends in a block that should go on"),
            Self::NotFollowed(what) => write!(f, "{what} is not followed"),
        }
    }
}
