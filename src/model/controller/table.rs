//! The table of a dialect: what its texts mean, for reading.

use super::ControlledAxis;
use super::blocks::Blocks;
use super::lowering::Lowering;
use super::pattern;
use super::word::{self, FEED, FEED_PER_REVOLUTION, Formats};
use super::{feed_unit, form};
use crate::syntax::tree::{ControllerStatement, Member, MemberText, Spanned, TemplatePiece};
use mach_runtime::diagnostic::{Code, Diagnostic};
use mach_runtime::dialect::meaning::{FeedMode, Meaning, Switch, Wrap};
use mach_runtime::dialect::pattern::{Pattern, PatternWord};
use mach_runtime::dialect::table::{Role, Table, TableWord};
use mach_runtime::machine::Motion;
use mach_runtime::nc::dialect::{Sequence, Word};
use mach_runtime::number::DecimalPoint;
use mach_runtime::unit::LengthUnit;

/// A text of a meaning that is no pattern.
pub(super) static BAD_PATTERN: Code = Code {
    id: "E0560",
    title: "this is no pattern of a code",
    explanation: "\
The text of a meaning is made of codes and words as they stand in a block, with holes for their numbers:

    group length { off \"G49\"  on \"G43 H{register:00}\" }
    once {
        dwell \"G4 P{milliseconds}\" also \"G4 X{seconds}\"
        message \"MSG(\\\"{text}\\\")\"
    }

The holes are `{tool}`, `{register}`, `{seconds}`, `{milliseconds}`, `{program}`, `{text}` and `{any}`.",
};

/// A text with two meanings.
pub(super) static TWO_MEANINGS: Code = Code {
    id: "E0561",
    title: "a code has two meanings",
    explanation: "\
Each text means one thing, so that a program can be read. Only what switches off may switch off more than one thing:

    group length { off \"G49\"  on \"G43 H{register}\" }
    group tip    { off \"G49\"  on \"G43.4 H{register}\" }",
};

/// The table, for a machine with these axes.
pub(super) fn table(
    lowering: &mut Lowering<'_>,
    formats: &Formats<'_>,
    axes: &[ControlledAxis<'_>],
    axis_words: &[Word],
    comment: &(String, String),
    sequence: Option<&Sequence>,
    blocks: &Blocks,
) -> Table {
    let words = axes.iter().zip(axis_words).enumerate();
    let words = words.map(|(index, (axis, word))| table_word(word, Role::Axis(index), axis.motion == Motion::Linear));
    let others = [
        ("I", Role::Centre(0)),
        ("J", Role::Centre(1)),
        ("K", Role::Centre(2)),
        ("R", Role::Radius),
        (FEED, Role::Feed),
        (FEED_PER_REVOLUTION, Role::Feed),
        ("S", Role::Speed),
        ("T", Role::Tool),
    ];
    let mut words: Vec<TableWord> = words.collect();
    for (name, role) in others.into_iter().filter(|(name, _)| axes.iter().all(|axis| axis.name != *name)) {
        let word = word::find(lowering, formats, name);
        words.extend(word.map(|word| table_word(&word, role, false)));
    }
    let patterns = patterns(lowering, blocks.continued.as_deref());
    let says_wrap = patterns.iter().flat_map(|it| &it.meanings).any(|it| matches!(it, Meaning::Wrap(_)));
    Table {
        blocks: blocks.kind,
        comment: comment.clone(),
        sequence: sequence.map(|sequence| sequence.address.clone()),
        continued: blocks.continued.clone(),
        words,
        forms: form::forms(lowering),
        // Where programs say it, nothing is taken for granted while they have not.
        wrap: if says_wrap { Wrap::Counted } else { Wrap::Shortest },
        inch_feed_mm: f64::from(feed_unit::inch_um(lowering)) / 1000.0,
        power_on: taken_for_granted(super::units(lowering), &patterns),
        patterns,
    }
}

/// What no program says, because the controller has no code for it: its unit of length, and that a feed counts length a minute.
fn taken_for_granted(units: LengthUnit, patterns: &[Pattern]) -> Vec<(Meaning, Option<u32>)> {
    let granted = [Meaning::Units(units), Meaning::FeedMode(FeedMode::PerMinute)];
    let is_said = |granted: &Meaning| patterns.iter().flat_map(|it| &it.meanings).any(|said| said.excludes(*granted));
    granted.into_iter().filter(|granted| !is_said(granted)).map(|granted| (granted, None)).collect()
}

fn table_word(word: &Word, role: Role, is_length: bool) -> TableWord {
    // A control for which every word has its point may take one without as thousandths.
    let is_sure = word.picture.point != DecimalPoint::Always || matches!(role, Role::Feed | Role::Speed | Role::Tool);
    TableWord {
        address: word.address.clone(),
        role,
        metric: 1.0,
        inch: if is_length { 25.4 } else { 1.0 },
        pointless: is_sure.then_some(1.0),
    }
}

/// The members of all groups, with the index of their statement.
pub(super) fn members<'a>(lowering: &Lowering<'a>) -> Vec<(usize, &'a Member)> {
    let groups = lowering.statements().filter_map(|(index, statement)| match statement {
        ControllerStatement::Group { body, .. } => Some((index, body)),
        _ => None,
    });
    groups.flat_map(|(index, body)| body.statements.iter().map(move |member| (index, &member.node))).collect()
}

/// The text of a meaning as it is printed, where it has no hole.
pub(super) fn literal(lowering: &Lowering<'_>, meaning: (Meaning, Option<u32>)) -> Option<String> {
    let members = members(lowering);
    let (_, member) = members.iter().find(|(_, member)| member.meaning == meaning)?;
    match member.texts.first()?.pattern.value.as_slice() {
        [piece] => match &piece.value {
            TemplatePiece::Text(text) => Some(text.clone()),
            TemplatePiece::Placeholder { .. } => None,
        },
        _ => None,
    }
}

fn patterns(lowering: &mut Lowering<'_>, continued: Option<&str>) -> Vec<Pattern> {
    let mut patterns: Vec<Pattern> = Vec::new();
    for (index, member) in members(lowering) {
        let (meaning, number) = member.meaning;
        for MemberText { pattern: said, effects } in &member.texts {
            let Some(words) = read(lowering, index, continued, said) else { continue };
            let meanings = [meaning].into_iter().chain(effects.iter().map(|effect| effect.meaning)).collect();
            match patterns.iter_mut().find(|pattern| pattern.words == words) {
                None => patterns.push(Pattern { meanings, number, words }),
                Some(same)
                    if meanings.iter().all(|it| is_off(*it)) && same.meanings.iter().all(|other| is_off(*other)) =>
                {
                    same.meanings.extend(meanings);
                }
                Some(_) => {
                    let place = lowering.place(index, &said.span);
                    let message = "this text has another meaning already";
                    let error = Diagnostic::error(&TWO_MEANINGS, message).at(place, "means something else here");
                    lowering.diagnostics.push(error);
                }
            }
        }
    }
    for (index, statement) in lowering.statements() {
        let ControllerStatement::Plain { pattern, .. } = statement else { continue };
        let words = read(lowering, index, continued, pattern);
        patterns.extend(words.map(|words| Pattern { meanings: vec![Meaning::Plain], number: None, words }));
    }
    patterns
}

fn is_off(meaning: Meaning) -> bool {
    use Meaning::{Cycle, Frame, Length, Tip};
    matches!(meaning, Length(Switch::Off) | Tip(Switch::Off) | Frame(Switch::Off) | Cycle(Switch::Off))
}

fn read(
    lowering: &mut Lowering<'_>,
    index: usize,
    continued: Option<&str>,
    said: &Spanned<Vec<Spanned<TemplatePiece>>>,
) -> Option<Vec<PatternWord>> {
    pattern::words(&said.value, continued)
        .map_err(|mistake| lowering.report(&BAD_PATTERN, "this is no pattern of a code", index, &said.span, mistake))
        .ok()
}
