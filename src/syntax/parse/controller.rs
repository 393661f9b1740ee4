//! The statements of a controller.

use mach_runtime::diagnostic::{Code, Diagnostic, Suggestion};

use super::grammar::{self, Pair, Rule};
use super::{Builder, Parts, parts, template, word};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{
    BlockKind, Body, ControllerStatement, Effect, Expression, LengthUnit, Member, MemberText, Span, Spanned, Text,
    Trigger,
};
use mach_runtime::dialect::names;

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

/// A group or a member of one that does not exist.
pub static UNKNOWN_MEANING: Code = Code {
    id: "E0115",
    title: "unknown meaning",
    explanation: "\
What a text of a program can mean is a fixed list, in groups of which one member is in force at a time:

    motion     rapid, line, arc clockwise, arc counterclockwise
    plane      xy, zx, yz                 distance   absolute, incremental
    units      mm, inch                   feed       minute, revolution, inverse
    centre     from start, absolute       side       off, left, right
    offset     1, 2, 3 …                  length     off, on
    tip        off, on                    frame      off, on
    cycle      off, on                    path       exact, blend
    wrap       counted, shortest
    spindle    off, clockwise, counterclockwise
    coolant    off, flood, mist, through

    group plane { xy \"G17\"  zx \"G18\"  yz \"G19\" }

What happens once in its block: machine coordinates, reference point, retract along tool, pole, stock, tool change, preselect, dwell,
stop, optional stop, end, program, program end, message.

    once { stop \"M0\" }

A code that moves nothing and switches nothing of these is declared with what it does: `plain \"M11\" \"C unclamped\"`.",
};

impl<'t> Builder<'_, 't> {
    pub(super) fn controller_statement(&mut self, pair: Pair<'t>) -> Option<ControllerStatement> {
        let rule = pair.as_rule();
        let mut parts = parts(pair);
        Some(match rule {
            Rule::units_statement => ControllerStatement::Units(length_unit(&parts.next())),
            Rule::blocks_statement => {
                let kind = parts.next();
                ControllerStatement::Blocks {
                    kind: Spanned { value: block_kind(&kind), span: grammar::extent(&kind) },
                    continued: text_of(&mut parts, Rule::continued_clause),
                }
            }
            Rule::form_statement => return self.form(parts),
            Rule::extension_statement => ControllerStatement::Extension(parts.text()),
            Rule::comment_statement => ControllerStatement::Comment {
                open: parts.text(),
                close: parts.take(Rule::text).map(|text| template::text(&text)),
            },
            Rule::sequence_statement => self.sequence(parts),
            Rule::offset_statement => ControllerStatement::Offset(self.expression(parts.next())),
            Rule::retract_statement => ControllerStatement::Retract(parts.text()),
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
                inch: self.number_of(&mut parts, Rule::worth_clause),
            },
            Rule::write_statement => self.write(parts),
            Rule::group_statement => return self.group(parts),
            Rule::once_statement => {
                let body = parts.next();
                let name = Spanned { value: "once", span: grammar::extent(&body) };
                ControllerStatement::Group { body: self.members(name.value, body), name }
            }
            Rule::plain_statement => ControllerStatement::Plain {
                pattern: template::pieces(parts.next()),
                note: parts.take(Rule::text).map(|text| template::text(&text)),
            },
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

    fn form(&mut self, mut parts: Parts<'t>) -> Option<ControllerStatement> {
        let name = parts.next();
        let text = template::pieces(parts.next());
        let span = grammar::extent(&name);
        let Some((_, value)) = names::FORMS.into_iter().find(|(known, _)| *known == name.as_str()) else {
            let known = names::FORMS.iter().map(|(known, _)| *known).collect();
            self.unknown(&UNKNOWN_MEANING, "form of an axis word", name.as_str(), &span, known);
            return None;
        };
        Some(ControllerStatement::Form { meaning: Spanned { value, span }, text })
    }

    fn on(&mut self, mut parts: Parts<'t>) -> Option<ControllerStatement> {
        let event = self.event(&parts.next());
        let body = self.body(parts.next(), Rule::line, |_, pair| Some(template::line(pair)));
        Some(ControllerStatement::On { event: event?, body })
    }

    fn group(&mut self, mut parts: Parts<'t>) -> Option<ControllerStatement> {
        let pair = parts.next();
        let body = parts.next();
        let name = Spanned { value: self.group_name(&pair)?, span: grammar::extent(&pair) };
        Some(ControllerStatement::Group { body: self.members(name.value, body), name })
    }

    fn group_name(&mut self, pair: &Pair<'t>) -> Option<&'static str> {
        let known: Vec<&str> = names::groups().filter(|group| *group != "once").collect();
        let name = known.iter().copied().find(|group| *group == pair.as_str());
        if name.is_none() {
            self.unknown(&UNKNOWN_MEANING, "group", pair.as_str(), &grammar::extent(pair), known);
        }
        name
    }

    /// What a text of a member does beside that.
    fn effects(&mut self, pair: Option<Pair<'t>>) -> Vec<Effect> {
        let effects = pair.into_iter().flat_map(|pair| parts(pair).take_all(Rule::effect));
        effects.filter_map(|effect| self.effect(effect)).collect()
    }

    fn effect(&mut self, pair: Pair<'t>) -> Option<Effect> {
        let mut parts = parts(pair);
        let group = self.group_name(&parts.next())?;
        let name = parts.next();
        let member = words_of(&name);
        let meaning = names::meaning(group, &member).filter(|(_, number)| number.is_none());
        if meaning.is_none() {
            let (span, known) = (grammar::extent(&name), names::members(group).collect());
            self.unknown(&UNKNOWN_MEANING, "member of the group", &member, &span, known);
        }
        meaning.map(|(meaning, _)| Effect { group, member, meaning })
    }

    /// A text of a member, and what it does beside that.
    fn member_text(&mut self, parts: &mut Parts<'t>) -> MemberText {
        let pattern = template::pieces(parts.next());
        MemberText { pattern, effects: self.effects(parts.take(Rule::effects)) }
    }

    /// The members of a group.
    fn members(&mut self, group: &'static str, body: Pair<'t>) -> Body<Member> {
        self.body(body, Rule::member, |builder, pair| {
            let mut parts = parts(pair);
            let name = parts.next();
            let (written, span) = (words_of(&name), grammar::extent(&name));
            let mut texts = vec![builder.member_text(&mut parts)];
            for also in parts.take_all(Rule::also_clause) {
                texts.push(builder.member_text(&mut self::parts(also)));
            }
            let Some(meaning) = names::meaning(group, &written) else {
                builder.unknown(
                    &UNKNOWN_MEANING,
                    "member of the group",
                    &written,
                    &span,
                    names::members(group).collect(),
                );
                return None;
            };
            Some(Member { name: Spanned { value: written, span }, meaning, texts })
        })
    }

    /// Reports a name that does not exist among those that do.
    fn unknown(&mut self, code: &'static Code, kind: &str, written: &str, span: &Span, known: Vec<&str>) {
        let place = self.failures.place(span);
        let quoted: Vec<String> = known.iter().map(|name| format!("`{name}`")).collect();
        let known_are = if known.is_empty() { "they are whole numbers".to_owned() } else { quoted.join(", ") };
        let mut diagnostic = Diagnostic::error(code, format!("there is no {kind} `{written}`"))
            .at(place.clone(), "")
            .note(format!("known: {known_are}"));
        if let Some(meant) = nearest(written, known) {
            let text = format!("did you mean `{meant}`?");
            diagnostic = diagnostic.suggest(Suggestion { text, place, replacement: meant.to_owned() });
        }
        self.failures.push(diagnostic);
    }

    fn event(&mut self, pair: &Pair<'t>) -> Option<Spanned<Trigger>> {
        let span = grammar::extent(pair);
        let written = words_of(pair);
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

/// The words of a name, with one blank between them.
fn words_of(pair: &Pair<'_>) -> String {
    pair.as_str().split_whitespace().collect::<Vec<_>>().join(" ")
}

fn block_kind(pair: &Pair<'_>) -> BlockKind {
    if pair.as_rule() == Rule::words_kind { BlockKind::Words } else { BlockKind::Statements }
}

fn length_unit(pair: &Pair<'_>) -> Spanned<LengthUnit> {
    let value = if pair.as_rule() == Rule::mm_kind { LengthUnit::Millimetre } else { LengthUnit::Inch };
    Spanned { value, span: grammar::extent(pair) }
}

fn text_of(parts: &mut Parts<'_>, clause: Rule) -> Option<Text> {
    parts.take(clause).map(|clause| self::parts(clause).text())
}
