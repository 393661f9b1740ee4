//! Records that hold text.

/// Words after which the rest of the line is text, commas, slashes and dollar signs included.
const FREE_TEXT: [&str; 7] = ["DISPLAY", "INSERT", "LETTER", "PARTNO", "PPRINT", "REMARK", "TPRINT"];

/// Whether the line starts with a word after which the rest is text.
pub(super) fn is_free_text(line: &[u8]) -> bool {
    let line = line.trim_ascii_start();
    let length = line.iter().position(|byte| !byte.is_ascii_alphanumeric()).unwrap_or(line.len());
    FREE_TEXT.iter().any(|word| word.as_bytes().eq_ignore_ascii_case(&line[..length]))
}
