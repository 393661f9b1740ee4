//! One line of a block: its text cut at the codes of modal groups, its placeholders understood.

use super::lowering::{Lowering, UNPRINTABLE, unprintable};
use super::picture::{self, BAD_PICTURE};
use super::placeholder::{Meaning, PLACEHOLDER_ELSEWHERE, PLACEHOLDERS, UNKNOWN_PLACEHOLDER};
use super::scene::Scene;
use super::{address, beside};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{ControllerStatement, LineTemplate, Span, Spanned, TemplatePiece};
use mach_runtime::diagnostic::{Diagnostic, Suggestion};
use mach_runtime::nc::dialect::{Line, Piece};

/// A line of a block.
pub(super) fn line(lowering: &mut Lowering<'_>, scene: &Scene<'_>, template: &LineTemplate) -> Line {
    let mut pieces = Vec::new();
    let mut aside = Aside::Nowhere;
    let last = template.pieces.len().saturating_sub(1);
    for (n, piece) in template.pieces.iter().enumerate() {
        if let Some(before) = n.checked_sub(1).filter(|_| aside == Aside::Nowhere) {
            beside::check(lowering, scene, &template.pieces[before], piece);
            address::check_number(lowering, scene, &template.pieces[before].value, piece);
        }
        match &piece.value {
            TemplatePiece::Text(text) => {
                report_unprintable(lowering, scene, text, &piece.span);
                let at_ends = (n == 0, n == last);
                cut_text(text, at_ends, scene, &mut aside, &mut pieces);
            }
            TemplatePiece::Placeholder { name, picture } => {
                pieces.extend(placeholder(lowering, scene, piece, name, picture.as_deref()));
            }
        }
    }
    Line { numbered: !template.bare, pieces }
}

/// Where codes are only text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Aside {
    Nowhere,
    Comment,
    Quotes,
}

impl Aside {
    /// The state behind a word of the text.
    fn behind(mut self, word: &str, comment: &(String, String)) -> Self {
        for (at, c) in word.char_indices() {
            let rest = &word[at..];
            self = match self {
                Self::Nowhere if !comment.0.is_empty() && rest.starts_with(&comment.0) => Self::Comment,
                Self::Comment if !comment.1.is_empty() && rest.starts_with(&comment.1) => Self::Nowhere,
                Self::Nowhere if c == '"' => Self::Quotes,
                Self::Quotes if c == '"' => Self::Nowhere,
                same => same,
            };
        }
        self
    }
}

/// Cuts the codes of modal groups out of a text: words between blanks or the ends of the line, not in a comment and not
/// in quotes.
fn cut_text(text: &str, ends: (bool, bool), scene: &Scene<'_>, aside: &mut Aside, pieces: &mut Vec<Piece>) {
    let words: Vec<&str> = text.split(' ').collect();
    let mut plain = String::new();
    for (n, word) in words.iter().enumerate() {
        let touches_placeholder = (n == 0 && !ends.0) || (n + 1 == words.len() && !ends.1);
        if n > 0 {
            plain.push(' ');
        }
        match modal_code(word, scene.modal_groups) {
            Some((group, code)) if *aside == Aside::Nowhere && !touches_placeholder => {
                push_text(&mut plain, pieces);
                pieces.push(Piece::Modal { group, code });
            }
            _ => plain.push_str(word),
        }
        *aside = aside.behind(word, scene.comment);
    }
    push_text(&mut plain, pieces);
}

fn push_text(plain: &mut String, pieces: &mut Vec<Piece>) {
    if !plain.is_empty() {
        pieces.push(Piece::Text(std::mem::take(plain)));
    }
}

fn modal_code(word: &str, groups: &[Vec<String>]) -> Option<(usize, usize)> {
    let found = |group: &Vec<String>| group.iter().position(|code| code == word);
    groups.iter().enumerate().find_map(|(index, group)| found(group).map(|code| (index, code)))
}

/// The piece of a placeholder; what is wrong with it is reported.
fn placeholder(
    lowering: &mut Lowering<'_>,
    scene: &Scene<'_>,
    piece: &Spanned<TemplatePiece>,
    name: &str,
    picture: Option<&str>,
) -> Option<Piece> {
    let (index, span) = (scene.index, &piece.span);
    let known = Meaning::of(name).filter(|meaning| match meaning {
        Meaning::Axis(axis) => has_a_word(lowering, axis),
        _ => true,
    });
    let Some(meaning) = known else {
        report_unknown(lowering, scene, span, name);
        return None;
    };
    if !meaning.is_known_in(scene.trigger) {
        let message = format!("`{{{name}}}` has no value in `on {}`", scene.trigger.name());
        lowering.report(&PLACEHOLDER_ELSEWHERE, message, index, span, "not known here");
        return None;
    }
    let Some(text) = picture else { return Some(meaning.piece(scene.axes)) };
    if !meaning.is_a_number() {
        let message = format!("`{{{name}}}` is no number that a picture could print");
        lowering.report(&PLACEHOLDER_ELSEWHERE, message, index, span, "takes no picture");
        return None;
    }
    match (picture::parse(text), meaning) {
        (Ok(picture), Meaning::Value(value)) => Some(Piece::Value(value, Some(picture))),
        (Err(error), _) => {
            let start = span.end - 1 - text.len();
            let at = start + error.at.start..start + error.at.end;
            let message = format!("`{text}` is no picture of a number");
            lowering.report(&BAD_PICTURE, message, index, &at, error.message);
            None
        }
        (Ok(_), _) => None,
    }
}

/// Whether the controller has a word for this axis; the machine need not have the axis.
fn has_a_word(lowering: &Lowering<'_>, axis: &str) -> bool {
    let said = |statement: &_| match statement {
        ControllerStatement::Word { names, .. } => names.iter().any(|name| name.value == axis),
        _ => false,
    };
    lowering.controller.statements.iter().any(said)
}

fn report_unknown(lowering: &mut Lowering<'_>, scene: &Scene<'_>, span: &Span, name: &str) {
    let place = lowering.place(scene.index, span);
    let message = format!("no placeholder is called `{{{name}}}`");
    let mut diagnostic = Diagnostic::error(&UNKNOWN_PLACEHOLDER, message).at(place, "unknown");
    let known = PLACEHOLDERS.iter().filter(|(_, meaning)| meaning.is_known_in(scene.trigger)).map(|(known, _)| *known);
    if let Some(meant) = nearest(name, known.clone()) {
        let place = lowering.place(scene.index, &(span.start + 1..span.start + 1 + name.len()));
        let text = format!("did you mean `{{{meant}}}`?");
        diagnostic = diagnostic.suggest(Suggestion { text, place, replacement: meant.to_owned() });
    } else {
        let known: Vec<String> = known.map(|name| format!("`{{{name}}}`")).collect();
        diagnostic = diagnostic.note(format!("`on {}` knows {}", scene.trigger.name(), known.join(", ")));
    }
    lowering.diagnostics.push(diagnostic);
}

fn report_unprintable(lowering: &mut Lowering<'_>, scene: &Scene<'_>, text: &str, span: &Span) {
    if let Some((at, c)) = unprintable(text) {
        let exact =
            if span.len() == text.len() { span.start + at..span.start + at + c.len_utf8() } else { span.clone() };
        lowering.report(&UNPRINTABLE, "NC programs are ASCII text", scene.index, &exact, "this is another character");
    }
}
