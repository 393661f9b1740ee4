//! The statements of a controller.

use super::expression::expression;
use super::layout::{Line, Table};
use super::machine::clause;
use super::{Printer, escaped, quoted};
use crate::syntax::tree::{ControllerStatement, LengthUnit, LineTemplate, Name, TemplatePiece, Text};

impl Printer {
    pub(super) fn controller_statement(&mut self, statement: &ControllerStatement, behind: Option<&str>) {
        match statement {
            ControllerStatement::On { event, body } => {
                self.lines(&format!("on {}", event.value.name()), body, behind);
            }
            statement => self.line(line(statement), behind),
        }
    }
}

/// A statement without a block.
fn line(statement: &ControllerStatement) -> Line {
    match statement {
        ControllerStatement::Format { name, picture, inch, zero } => {
            let cells = vec![
                format!("format {}", name.value),
                quoted(picture),
                text_clause("inch", inch.as_ref()),
                text_clause("zero", zero.as_ref()),
            ];
            Line::row(Table::Formats, cells)
        }
        ControllerStatement::Word { names, format, address } => {
            let cells =
                vec![format!("word {}", joined(names)), format.value.clone(), text_clause("as", address.as_ref())];
            Line::row(Table::Words, cells)
        }
        statement => Line::plain(plain(statement)),
    }
}

fn plain(statement: &ControllerStatement) -> String {
    match statement {
        ControllerStatement::Units(unit) => match unit.value {
            LengthUnit::Millimetre => "units mm".to_owned(),
            LengthUnit::Inch => "units inch".to_owned(),
        },
        ControllerStatement::Extension(text) => format!("extension {}", quoted(text)),
        ControllerStatement::Comment { open, close } => {
            let close = close.as_ref().map_or(String::new(), |close| format!(" {}", quoted(close)));
            format!("comment {}{close}", quoted(open))
        }
        ControllerStatement::NoSequence => "sequence none".to_owned(),
        ControllerStatement::Sequence { address, start, step, greatest } => {
            let clauses = [("start", start), ("step", step), ("greatest", greatest)];
            let clauses: String = clauses.iter().map(|(keyword, value)| clause(keyword, value.as_ref())).collect();
            format!("sequence {}{clauses}", quoted(address))
        }
        ControllerStatement::Offset(text) => format!("offset {}", quoted(text)),
        ControllerStatement::Retract(text) => format!("retract {}", quoted(text)),
        ControllerStatement::UnitsCode { mm, inch } => {
            format!("code units mm {} inch {}", quoted(mm), quoted(inch))
        }
        ControllerStatement::FeedCode { minute, revolution } => {
            let revolution = text_clause(" revolution", revolution.as_ref());
            format!("code feed minute {}{revolution}", quoted(minute))
        }
        ControllerStatement::WriteRange { axis, from, to } => {
            format!("write {} {} .. {}", axis.value, expression(from), expression(to))
        }
        ControllerStatement::WriteUnwound(axis) => format!("write {} unwound", axis.value),
        ControllerStatement::Modal(codes) => format!("modal {}", joined(codes)),
        ControllerStatement::Format { .. } | ControllerStatement::Word { .. } | ControllerStatement::On { .. } => {
            unreachable!("printed as a row or a block")
        }
    }
}

fn text_clause(keyword: &str, text: Option<&Text>) -> String {
    text.map_or(String::new(), |text| format!("{keyword} {}", quoted(text)))
}

fn joined(names: &[Name]) -> String {
    names.iter().map(|name| name.value.as_str()).collect::<Vec<_>>().join(" ")
}

/// One line of an `on` block.
pub(super) fn template(line: &LineTemplate) -> String {
    let pieces: String = line.pieces.iter().map(|piece| template_piece(&piece.value)).collect();
    format!("{}\"{pieces}\"", if line.bare { "bare " } else { "" })
}

fn template_piece(piece: &TemplatePiece) -> String {
    match piece {
        TemplatePiece::Text(text) => escaped(text).replace('{', "{{").replace('}', "}}"),
        TemplatePiece::Placeholder { name, picture: None } => format!("{{{name}}}"),
        TemplatePiece::Placeholder { name, picture: Some(picture) } => format!("{{{name}:{picture}}}"),
    }
}
