//! The runtime's tables as Rust expressions.

use mach_runtime::dialect::meaning::Wrap;
use mach_runtime::dialect::table::{BlockKind, Form, FormMeaning, Table};
use mach_runtime::kinematics::Pole;
use mach_runtime::machine::{
    Axis, BranchPolicy, Chain, Component, ErrorTable, Joint, Machine, Motion, Preference, Rule, Strictness,
    ToolGeometry, Travel, Written,
};
use mach_runtime::nc::dialect::{Block, Codes, Dialect, Line, Piece, Sequence, Trigger, Value, Word};
use mach_runtime::number::{DecimalPoint, Picture};
use mach_runtime::unit::LengthUnit;

/// A value that can be written down as a Rust expression.
pub(super) trait Literal {
    /// The expression, with the types' names as they are in their modules.
    fn literal(&self) -> String;
}

/// The functions that the literals call, by their names.
pub(super) const HELPERS: [(&str, &str); 7] = [
    (
        "numbered",
        "/// A line with a sequence number.
fn numbered<const N: usize>(pieces: [Piece; N]) -> Line { Line { numbered: true, pieces: pieces.into() } }",
    ),
    (
        "bare",
        "/// A line without a sequence number.
fn bare<const N: usize>(pieces: [Piece; N]) -> Line { Line { numbered: false, pieces: pieces.into() } }",
    ),
    (
        "pattern",
        "/// A text, and what it means.
fn pattern<const M: usize, const N: usize>(meanings: [Meaning; M], number: Option<u32>, words: [PatternWord; N]) -> Pattern {
    Pattern { meanings: meanings.into(), number, words: words.into() }
}",
    ),
    (
        "code",
        "/// A letter and a number, in thousandths.
fn code(address: &str, thousandths: i64) -> PatternWord { PatternWord::Code { address: address.to_owned(), thousandths } }",
    ),
    (
        "hole",
        "/// A letter and a number that the program says.
fn hole(address: &str, hole: Hole) -> PatternWord { PatternWord::Hole { address: address.to_owned(), hole } }",
    ),
    (
        "word",
        "/// A word with a number of its own.
fn word(address: &str, role: Role, metric: f64, inch: f64, pointless: Option<f64>) -> TableWord {
    TableWord { address: address.to_owned(), role, metric, inch, pointless }
}",
    ),
    ("text", "/// Printed as it is.\nfn text(text: &str) -> Piece { Piece::Text(text.to_owned()) }"),
];

/// Structs field by field; a field that is missing here is an error.
macro_rules! structs {
    ($($name:ident { $($field:ident),* $(,)? })*) => {$(
        impl Literal for $name {
            fn literal(&self) -> String {
                let Self { $($field),* } = self;
                let fields = [$(format!("{}: {}", stringify!($field), $field.literal())),*];
                format!("{} {{ {} }}", stringify!($name), fields.join(", "))
            }
        }
    )*};
}

/// Enums without values, whose `Debug` is their name.
macro_rules! names {
    ($($name:ident)*) => {$(
        impl Literal for $name {
            fn literal(&self) -> String {
                format!("{}::{self:?}", stringify!($name))
            }
        }
    )*};
}

/// Types whose `Debug` is the expression.
macro_rules! plain {
    ($($name:ident)*) => {$(
        impl Literal for $name {
            fn literal(&self) -> String {
                format!("{self:?}")
            }
        }
    )*};
}

structs! {
    Machine {
        name, axes, chain, branch, axis_tolerance_rad, plane_tolerance_mm, chord_tolerance_mm, unknown_records, zero_mm,
        tools, errors,
    }
    Axis { name, motion, travel, rule, written, zero, length_share, rapid_per_min }
    Chain { joints, bed, tool_axis, gauge_mm }
    ToolGeometry { length_mm }
    Joint { axis, motion, direction, point_mm, primed }
    Travel { lower, upper }
    ErrorTable { axis, component, rows }
    BranchPolicy { start, then, reposition }
    Dialect {
        name, units, extension, comment, sequence, offset, retract, codes, axes, feed, feed_per_revolution,
        modal_groups, blocks, table,
    }
    Table { blocks, comment, sequence, continued, words, forms, patterns, wrap, inch_feed_mm, power_on }
    Form { meaning, before, between, behind }
    Picture { plus, integer_digits, integer_least, decimals, decimals_least, point, zero }
    Word { name, address, picture }
    Sequence { address, start, step, greatest }
    Codes { units, per_minute, per_revolution }
    Block { trigger, lines }
}

names! { Component Motion Strictness LengthUnit DecimalPoint Trigger Value BlockKind FormMeaning Wrap }
plain! { bool u8 u32 u64 usize }

impl Literal for f64 {
    fn literal(&self) -> String {
        match *self {
            Self::INFINITY => "f64::INFINITY".to_owned(),
            Self::NEG_INFINITY => "f64::NEG_INFINITY".to_owned(),
            value => format!("{value:?}"),
        }
    }
}

impl Literal for String {
    fn literal(&self) -> String {
        format!("{self:?}.to_owned()")
    }
}

impl<T: Literal> Literal for Vec<T> {
    fn literal(&self) -> String {
        if self.is_empty() { "Vec::new()".to_owned() } else { format!("Vec::from([{}])", list(self)) }
    }
}

impl<T: Literal, const N: usize> Literal for [T; N] {
    fn literal(&self) -> String {
        format!("[{}]", list(self))
    }
}

impl<T: Literal> Literal for Option<T> {
    fn literal(&self) -> String {
        self.as_ref().map_or("None".to_owned(), |value| format!("Some({})", value.literal()))
    }
}

impl<A: Literal, B: Literal> Literal for (A, B) {
    fn literal(&self) -> String {
        format!("({}, {})", self.0.literal(), self.1.literal())
    }
}

impl Literal for Pole {
    fn literal(&self) -> String {
        match self {
            Self::Direction { axis } => format!("Pole::Direction {{ axis: {axis} }}"),
            Self::Position { axis } => format!("Pole::Position {{ axis: {axis} }}"),
        }
    }
}

impl Literal for Written {
    fn literal(&self) -> String {
        match self {
            Self::Unwound => "Written::Unwound".to_owned(),
            Self::Wrapped { from_deg } => format!("Written::Wrapped {{ from_deg: {} }}", from_deg.literal()),
        }
    }
}

impl Literal for Rule {
    fn literal(&self) -> String {
        match self {
            Self::Pose => "Rule::Pose".to_owned(),
            Self::Locked(value) => format!("Rule::Locked({})", value.literal()),
            Self::Preferred(value) => format!("Rule::Preferred({})", value.literal()),
            Self::Free => "Rule::Free".to_owned(),
        }
    }
}

impl Literal for Preference {
    fn literal(&self) -> String {
        match self {
            Self::Least(axis) => format!("Preference::Least({axis})"),
            Self::Positive(axis) => format!("Preference::Positive({axis})"),
            Self::Negative(axis) => format!("Preference::Negative({axis})"),
            Self::Nearest => "Preference::Nearest".to_owned(),
        }
    }
}

/// By a function of [`HELPERS`], as the next one: there are many.
impl Literal for Line {
    fn literal(&self) -> String {
        let Self { numbered, pieces } = self;
        format!("{}([{}])", if *numbered { "numbered" } else { "bare" }, list(pieces))
    }
}

impl Literal for Piece {
    fn literal(&self) -> String {
        match self {
            Self::Text(text) => format!("text({text:?})"),
            Self::Modal { group, code } => format!("Piece::Modal {{ group: {group}, code: {code} }}"),
            Self::Axes(axes) => format!("Piece::Axes({})", axes.literal()),
            Self::Feed => "Piece::Feed".to_owned(),
            Self::Value(value, picture) => format!("Piece::Value({}, {})", value.literal(), picture.literal()),
        }
    }
}

/// One after the other, between commas.
pub(super) fn list<T: Literal>(items: &[T]) -> String {
    items.iter().map(T::literal).collect::<Vec<_>>().join(", ")
}
