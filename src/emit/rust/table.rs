//! The table of a dialect's texts as Rust expressions.

use super::literal::{Literal, list};
use mach_runtime::dialect::meaning::Meaning;
use mach_runtime::dialect::pattern::{Argument, Pattern, PatternWord};
use mach_runtime::dialect::table::{Role, TableWord};

impl Literal for Meaning {
    fn literal(&self) -> String {
        let (kind, member) = match self {
            Self::Motion(it) => ("Motion", format!("MotionCode::{it:?}")),
            Self::Plane(it) => ("Plane", format!("Plane::{it:?}")),
            Self::Distance(it) => ("Distance", format!("Distance::{it:?}")),
            Self::Units(it) => ("Units", it.literal()),
            Self::FeedMode(it) => ("FeedMode", format!("FeedMode::{it:?}")),
            Self::Centre(it) => ("Centre", format!("CentreMode::{it:?}")),
            Self::Side(it) => ("Side", format!("Side::{it:?}")),
            Self::Length(it) => ("Length", format!("Switch::{it:?}")),
            Self::Tip(it) => ("Tip", format!("Switch::{it:?}")),
            Self::Frame(it) => ("Frame", format!("Switch::{it:?}")),
            Self::Cycle(it) => ("Cycle", format!("Switch::{it:?}")),
            Self::Wrap(it) => ("Wrap", it.literal()),
            Self::Path(it) => ("Path", format!("PathMode::{it:?}")),
            Self::Spindle(it) => ("Spindle", format!("Spindle::{it:?}")),
            Self::Coolant(it) => ("Coolant", format!("Coolant::{it:?}")),
            Self::Once(it) => ("Once", format!("Once::{it:?}")),
            Self::Offset => return "Meaning::Offset".to_owned(),
            Self::Plain => return "Meaning::Plain".to_owned(),
        };
        format!("Meaning::{kind}({member})")
    }
}

/// By a function of the helpers, as the words of it: there are many.
impl Literal for Pattern {
    fn literal(&self) -> String {
        let Self { meanings, number, words } = self;
        format!("pattern([{}], {}, [{}])", list(meanings), number.literal(), list(words))
    }
}

impl Literal for PatternWord {
    fn literal(&self) -> String {
        match self {
            Self::Code { address, thousandths } => format!("code({address:?}, {thousandths})"),
            Self::Hole { address, hole } => format!("hole({address:?}, Hole::{hole:?})"),
            Self::Number { thousandths } => format!("PatternWord::Number {{ thousandths: {thousandths} }}"),
            Self::Name(name) => format!("PatternWord::Name({})", name.literal()),
            Self::Call { name, arguments } => {
                format!("PatternWord::Call {{ name: {}, arguments: {} }}", name.literal(), arguments.literal())
            }
        }
    }
}

impl Literal for Argument {
    fn literal(&self) -> String {
        match self {
            Self::Literal(text) => format!("Argument::Literal({})", text.literal()),
            Self::Text(hole) => format!("Argument::Text(Hole::{hole:?})"),
        }
    }
}

/// By a function of the helpers, too.
impl Literal for TableWord {
    fn literal(&self) -> String {
        let Self { address, role, metric, inch, pointless } = self;
        let numbers = [metric.literal(), inch.literal(), pointless.literal()].join(", ");
        format!("word({address:?}, {}, {numbers})", role.literal())
    }
}

impl Literal for Role {
    fn literal(&self) -> String {
        format!("Role::{self:?}")
    }
}
