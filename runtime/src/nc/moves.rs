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

/// Whether a word with this address stands in the text, in any spelling that a control reads: `X5`, `x 5`, `X=5`, `X#100`,
/// `C1=DC(5)`.
pub fn has_word(text: &str, address: &str) -> bool {
    let text = text.to_ascii_uppercase();
    let name = address.trim_end_matches('=');
    let is_number = |c: char| {
        let begins_one = c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | '#' | '[');
        c == '=' || (begins_one && name == address)
    };
    text.match_indices(name).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let behind = text[at + name.len()..].trim_start_matches(' ').chars().next();
        !before.is_some_and(|c| c.is_ascii_alphabetic() || c == '_') && behind.is_some_and(is_number)
    })
}

#[cfg(test)]
mod tests {
    use super::has_word;

    #[test]
    fn a_word_is_seen_in_any_spelling() {
        for text in ["G53 X0.", "G0X-5", "X 999", "x999", "X=5", "X#100", "X[#1+5]", "G0 X+.5"] {
            assert!(has_word(text, "X"), "{text}");
        }
        for text in ["C1=5", "c1 = DC(90)", "G0 C1=AC(5)"] {
            assert!(has_word(text, "C1="), "{text}");
        }
        for text in ["MAX5", "X", "G53", "EX_5", "CX 5"] {
            assert!(!has_word(text, "X"), "{text}");
        }
        for text in ["C15", "C1", "AC1=5"] {
            assert!(!has_word(text, "C1="), "{text}");
        }
    }
}
