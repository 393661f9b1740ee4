//! Whether a block other than a motion moves an axis all the same.

use super::dialect::{Block, Dialect, Piece, Value};

/// Whether the block prints an axis word: by `{retract}`, or in its own text, such as the `Z0.` of `G53 Z0.`.
pub(super) fn moves(block: &Block, dialect: &Dialect) -> bool {
    block.lines.iter().flat_map(|line| &line.pieces).any(|piece| match piece {
        Piece::Text(text) => dialect.axes.iter().any(|word| has_word(text, &word.address)),
        Piece::Value(Value::Retract, _) => true,
        _ => false,
    })
}

/// Whether the address stands in the text with a number behind it and no letter before it.
fn has_word(text: &str, address: &str) -> bool {
    text.match_indices(address).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let behind = text[at + address.len()..].chars().next();
        !before.is_some_and(|c| c.is_ascii_alphabetic())
            && behind.is_some_and(|c| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | '='))
    })
}
