//! What stands directly beside a placeholder: no word or number of the program may run into it.

use super::lowering::Lowering;
use super::placeholder::Meaning;
use super::scene::Scene;
use crate::syntax::tree::{Spanned, TemplatePiece};
use mach_runtime::diagnostic::Code;
use mach_runtime::nc::dialect::Value;

/// A placeholder that runs into its neighbour.
pub(super) static RUNS_TOGETHER: Code = Code {
    id: "E0531",
    title: "a placeholder runs into what stands beside it",
    explanation: "\
What a placeholder prints must be read as it was meant, whatever it is.

    on feed { \"G1 {axes}0 {feed}\" }      // X10 becomes X100
    on feed { \"G1{axes} {feed}5\" }       // a blank before {axes}, nothing behind {feed}
    on tool { \"T0{tool} M6\" }            // {tool:00}

The words of axes and the feed, `{retract}`, `{offset}`, `{units}` and `{feed_mode}` are whole words: no letter, digit,
point, sign or `=` stands before them, and no digit, point, sign or `=` behind them. No digit, point or sign stands before
a number (`{tool}`, `{register}`, `{speed}`, `{seconds}`, `{milliseconds}`), and no digit or point behind it. Two
placeholders have something between them. In comments and in quotes all of this may stand.
",
};

/// What meets at the border of two pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    /// An address and its number, or a code.
    Word,
    Number,
    /// A name or a text of the program's.
    Name,
    /// A character of the template's text.
    Character(char),
}

impl Side {
    /// The side of a piece that shows this character of its text.
    fn of(piece: &TemplatePiece, character: fn(&str) -> Option<char>) -> Option<Self> {
        match piece {
            TemplatePiece::Text(text) => character(text).map(Self::Character),
            TemplatePiece::Placeholder { name, .. } => Meaning::of(name).map(Self::printed_by),
        }
    }

    fn printed_by(meaning: Meaning<'_>) -> Self {
        use Value::{Machine, Milliseconds, Operation, Program, Register, Seconds, Speed, Text, Tool, ToolName};
        match meaning {
            Meaning::Value(Program | Machine | Operation | ToolName | Text) => Self::Name,
            Meaning::Value(Tool | Register | Speed | Seconds | Milliseconds) => Self::Number,
            _ => Self::Word,
        }
    }

    /// Whether this and what stands directly behind it can be read as something else.
    fn runs_into(self, next: Self) -> bool {
        use Side::{Character, Name, Number, Word};
        match (self, next) {
            (Character(c), Word) => c.is_ascii_alphanumeric() || matches!(c, '.' | '+' | '-' | '='),
            (Character(c), Number) => c.is_ascii_digit() || matches!(c, '.' | '+' | '-'),
            (Word, Character(c)) => c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | '='),
            (Number, Character(c)) => c.is_ascii_digit() || c == '.',
            (Word | Number, Word | Number | Name) | (Name, Word | Number) => true,
            (Name | Character(_), Name | Character(_)) => false,
        }
    }
}

/// Reports two pieces of a line, the one directly behind the other, that run together.
pub(super) fn check(
    lowering: &mut Lowering<'_>,
    scene: &Scene<'_>,
    left: &Spanned<TemplatePiece>,
    right: &Spanned<TemplatePiece>,
) {
    let end = Side::of(&left.value, |text| text.chars().next_back());
    let beginning = Side::of(&right.value, |text| text.chars().next());
    let (Some(end), Some(beginning)) = (end, beginning) else { return };
    if end.runs_into(beginning) {
        let message = format!("nothing keeps {} and {} apart", shown(&left.value), shown(&right.value));
        let placeholder = if matches!(end, Side::Character(_)) { right } else { left };
        lowering.report(&RUNS_TOGETHER, message, scene.index, &placeholder.span, "can be read as one with it");
    }
}

fn shown(piece: &TemplatePiece) -> String {
    match piece {
        TemplatePiece::Placeholder { name, .. } => format!("`{{{name}}}`"),
        TemplatePiece::Text(text) => format!("`{text}`"),
    }
}
