//! The statements of a controller.

use mach_runtime::diagnostic::{Code, Diagnostic, Suggestion};

use super::grammar::{self, Pair, Rule};
use super::{Builder, Parts, parts, template, word};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{ControllerStatement, Expression, LengthUnit, Spanned, Text, Trigger};

/// An event that does not exist.
pub static UNKNOWN_EVENT: Code = Code {
    id: "E0110",
    title: "unknown event",
    explanation: "\
An `on` block says what is printed when something happens. What may happen:

    start                  end                      operation     tool
    spindle clockwise      spindle counterclockwise spindle off
    coolant flood          coolant mist             coolant through  coolant off
    stop                   optional stop            dwell         message
    approach               approach feed            rapid         feed

    on spindle clockwise { \"S{speed} M3\" }",
};

impl<'t> Builder<'_, 't> {
    pub(super) fn controller_statement(&mut self, pair: Pair<'t>) -> Option<ControllerStatement> {
        let rule = pair.as_rule();
        let mut parts = parts(pair);
        Some(match rule {
            Rule::units_statement => ControllerStatement::Units(length_unit(&parts.next())),
            Rule::extension_statement => ControllerStatement::Extension(parts.text()),
            Rule::comment_statement => ControllerStatement::Comment {
                open: parts.text(),
                close: parts.take(Rule::text).map(|text| template::text(&text)),
            },
            Rule::sequence_statement => self.sequence(parts),
            Rule::offset_statement => ControllerStatement::Offset(parts.text()),
            Rule::retract_statement => ControllerStatement::Retract(parts.text()),
            Rule::code_statement => codes(parts.next()),
            Rule::format_statement => ControllerStatement::Format {
                name: parts.name(),
                picture: parts.text(),
                inch: text_of(&mut parts, Rule::inch_clause),
                zero: text_of(&mut parts, Rule::zero_clause),
            },
            Rule::word_statement => ControllerStatement::Word {
                names: parts.take_all(Rule::axis).iter().map(word).collect(),
                format: parts.name(),
                address: text_of(&mut parts, Rule::as_clause),
            },
            Rule::write_statement => self.write(parts),
            Rule::modal_statement => ControllerStatement::Modal(parts.rest().map(|code| word(&code)).collect()),
            Rule::on_statement => return self.on(parts),
            rule => unreachable!("{rule:?} is no statement of a controller in the grammar"),
        })
    }

    fn sequence(&mut self, mut parts: Parts<'t>) -> ControllerStatement {
        let Some(address) = parts.take(Rule::text) else { return ControllerStatement::NoSequence };
        ControllerStatement::Sequence {
            address: template::text(&address),
            start: self.number_of(&mut parts, Rule::start_clause),
            step: self.number_of(&mut parts, Rule::step_clause),
            greatest: self.number_of(&mut parts, Rule::greatest_clause),
        }
    }

    fn number_of(&mut self, parts: &mut Parts<'t>, clause: Rule) -> Option<Expression> {
        parts.take(clause).map(|clause| self.expression_of(clause))
    }

    fn write(&mut self, mut parts: Parts<'t>) -> ControllerStatement {
        let axis = parts.name();
        if parts.take(Rule::unwound_clause).is_some() {
            return ControllerStatement::WriteUnwound(axis);
        }
        ControllerStatement::WriteRange { axis, from: self.expression(parts.next()), to: self.expression(parts.next()) }
    }

    fn on(&mut self, mut parts: Parts<'t>) -> Option<ControllerStatement> {
        let event = self.event(&parts.next());
        let body = self.body(parts.next(), Rule::line, |_, pair| Some(template::line(pair)));
        Some(ControllerStatement::On { event: event?, body })
    }

    fn event(&mut self, pair: &Pair<'t>) -> Option<Spanned<Trigger>> {
        let span = grammar::extent(pair);
        let written: Vec<&str> = pair.clone().into_inner().map(|word| word.as_str()).collect();
        let written = written.join(" ");
        let event = Trigger::from_name(&written);
        if event.is_none() {
            let place = self.failures.place(&span);
            let names: Vec<String> = Trigger::ALL.iter().map(|event| format!("`{}`", event.name())).collect();
            let mut diagnostic = Diagnostic::error(&UNKNOWN_EVENT, format!("there is no event `{written}`"))
                .at(place.clone(), "")
                .note(format!("the events are {}", names.join(", ")));
            if let Some(meant) = nearest(&written, Trigger::ALL.into_iter().map(Trigger::name)) {
                let text = format!("did you mean `{meant}`?");
                diagnostic = diagnostic.suggest(Suggestion { text, place, replacement: meant.to_owned() });
            }
            self.failures.push(diagnostic);
        }
        event.map(|value| Spanned { value, span })
    }
}

fn length_unit(pair: &Pair<'_>) -> Spanned<LengthUnit> {
    let value = if pair.as_rule() == Rule::mm_kind { LengthUnit::Millimetre } else { LengthUnit::Inch };
    Spanned { value, span: grammar::extent(pair) }
}

fn codes(pair: Pair<'_>) -> ControllerStatement {
    let rule = pair.as_rule();
    let mut parts = parts(pair);
    if rule == Rule::units_clause {
        return ControllerStatement::UnitsCode { mm: parts.text(), inch: parts.text() };
    }
    ControllerStatement::FeedCode { minute: parts.text(), revolution: text_of(&mut parts, Rule::revolution_clause) }
}

fn text_of(parts: &mut Parts<'_>, clause: Rule) -> Option<Text> {
    parts.take(clause).map(|clause| self::parts(clause).text())
}
