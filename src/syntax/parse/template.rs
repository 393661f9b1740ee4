//! Texts and the templates of an `on` block.

use super::grammar::{self, Pair, Rule};
use super::parts;
use crate::syntax::tree::{LineTemplate, Spanned, TemplatePiece, Text};

/// A quoted text, without its quotes and with its escapes resolved.
pub(super) fn text(pair: &Pair<'_>) -> Text {
    let quoted = pair.as_str();
    Spanned { value: unescape(&quoted[1..quoted.len() - 1]), span: grammar::extent(pair) }
}

/// One line of an `on` block.
pub(super) fn line(pair: Pair<'_>) -> LineTemplate {
    let mut parts = parts(pair);
    let bare = parts.take(Rule::bare_clause).is_some();
    LineTemplate { bare, pieces: pieces(parts.next()).value }
}

/// A text with placeholders.
pub(super) fn pieces(template: Pair<'_>) -> Spanned<Vec<Spanned<TemplatePiece>>> {
    let span = grammar::extent(&template);
    Spanned { value: grammar::content(template).into_iter().map(piece).collect(), span }
}

fn piece(pair: Pair<'_>) -> Spanned<TemplatePiece> {
    let span = grammar::extent(&pair);
    let value = if pair.as_rule() == Rule::placeholder {
        let mut parts = parts(pair);
        TemplatePiece::Placeholder {
            name: parts.next().as_str().to_owned(),
            picture: parts.take(Rule::picture).map(|picture| picture.as_str().to_owned()),
        }
    } else {
        TemplatePiece::Text(unescape(pair.as_str()).replace("{{", "{").replace("}}", "}"))
    };
    Spanned { value, span }
}

/// `\"` and `\\` stand for the character after the backslash.
fn unescape(text: &str) -> String {
    let mut characters = text.chars();
    std::iter::from_fn(|| match characters.next() {
        Some('\\') => characters.next(),
        character => character,
    })
    .collect()
}
