//! Number pictures: `####.###` as a person writes it.

use mach_runtime::diagnostic::Code;
use mach_runtime::number::{DecimalPoint, Picture};
use std::ops::Range;

/// A picture that cannot be read.
pub(super) static BAD_PICTURE: Code = Code {
    id: "E0520",
    title: "the picture of a number cannot be read",
    explanation: "\
A picture shows how a number is printed.

| picture | 0.483 | 25 | -12.5 | 0 |
| --- | --- | --- | --- | --- |
| `####.###` | `.483` | `25.` | `-12.5` | `0.` |
| `###0.0##` | `0.483` | `25.0` | `-12.5` | `0.0` |
| `###0[.###]` | `0.483` | `25` | `-12.5` | `0` |
| `000` | `000` | `025` | `-013` | `000` |
| `+##0.000` | `+0.483` | `+25.000` | `-12.500` | `0.000` |

Before the point come all `#`, then all `0`: their number is the greatest number of digits, and every `0` is always
printed. After the point come all `0`, then all `#`: their number is the resolution. Brackets around the point and `#`
drop the point of whole numbers. At most 15 digits in all. `zero \"0.0\"` says what a zero looks like, where it
looks different; it is made of zeros and a point.
",
};

/// What is wrong with a picture, and where in it (in bytes).
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct PictureError {
    /// The bytes at fault.
    pub(super) at: Range<usize>,
    /// What is wrong with them.
    pub(super) message: &'static str,
}

fn mistake<T>(at: Range<usize>, message: &'static str) -> Result<T, PictureError> {
    Err(PictureError { at, message })
}

/// Reads a picture.
///
/// # Errors
/// Where the text stops to be a picture.
pub(super) fn parse(text: &str) -> Result<Picture, PictureError> {
    let plus = text.starts_with('+');
    let start = usize::from(plus);
    let whole = run(text, start, "#");
    let fixed = run(text, whole, "0");
    let bracket = text[fixed..].starts_with('[');
    let behind_bracket = fixed + usize::from(bracket);
    let pointed = text[behind_bracket..].starts_with('.');
    if bracket && !pointed {
        return mistake(fixed..behind_bracket, "a point belongs behind the bracket");
    }
    let point = behind_bracket + usize::from(pointed);
    let always = if pointed && !bracket { run(text, point, "0") } else { point };
    let sometimes = if pointed { run(text, always, "#") } else { always };
    let end = if bracket { close(text, sometimes)? } else { sometimes };
    nothing_behind(text, end)?;
    let digits = (fixed - start) + (sometimes - point);
    if digits == 0 || digits > usize::from(Picture::MOST_DIGITS) {
        return mistake(0..text.len(), "a picture has 1 to 15 digits");
    }
    Ok(Picture {
        plus,
        integer_digits: (fixed - start) as u8,
        integer_least: (fixed - whole) as u8,
        decimals: (sometimes - point) as u8,
        decimals_least: (always - point) as u8,
        point: match (pointed, bracket) {
            (false, _) => DecimalPoint::Never,
            (true, false) => DecimalPoint::Always,
            (true, true) => DecimalPoint::Needed,
        },
        zero: None,
    })
}

/// Reads what a zero looks like.
///
/// # Errors
/// When it would not be read as zero.
pub(super) fn parse_zero(text: &str) -> Result<String, PictureError> {
    let points = text.matches('.').count();
    let (text, whole) = (text.strip_prefix('+').unwrap_or(text), text);
    if text.contains('0') && points <= 1 && text.len() <= 16 && text.bytes().all(|byte| matches!(byte, b'0' | b'.')) {
        return Ok(whole.to_owned());
    }
    mistake(0..whole.len(), "a zero is printed as zeros and at most one point, perhaps behind a sign")
}

/// Where a run of one character ends.
fn run(text: &str, start: usize, character: &str) -> usize {
    text.len() - text[start..].trim_start_matches(character).len()
}

fn close(text: &str, at: usize) -> Result<usize, PictureError> {
    match text[at..].chars().next() {
        Some(']') => Ok(at + 1),
        Some('0') => mistake(at..at + 1, "in brackets every digit is a `#`"),
        Some(c) => mistake(at..at + c.len_utf8(), "`#` or `]` is expected here"),
        None => mistake(at..at, "the bracket is not closed"),
    }
}

fn nothing_behind(text: &str, end: usize) -> Result<(), PictureError> {
    let Some(next) = text[end..].chars().next() else { return Ok(()) };
    let message = match (next, text[..end].contains('.')) {
        ('#', false) => "before the point every `#` stands before the first `0`",
        ('0', true) => "behind the point every `0` stands before the first `#`",
        ('.', true) => "a picture has one point",
        _ => "a picture is made of `+`, `#`, `0`, `.` and brackets",
    };
    mistake(end..end + next.len_utf8(), message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_read() {
        let length = parse("####.###").unwrap();
        assert_eq!((length.integer_digits, length.integer_least), (4, 0));
        assert_eq!((length.decimals, length.decimals_least, length.point), (3, 0, DecimalPoint::Always));
        let full = parse("+##0.0##").unwrap();
        assert_eq!((full.plus, full.integer_digits, full.integer_least), (true, 3, 1));
        assert_eq!((full.decimals, full.decimals_least), (3, 1));
        let needed = parse("###0[.##]").unwrap();
        assert_eq!((needed.decimals, needed.point), (2, DecimalPoint::Needed));
        assert_eq!(parse("00").unwrap().point, DecimalPoint::Never);
        assert_eq!(parse("####.").unwrap().point, DecimalPoint::Always);
        assert_eq!(parse(".###").unwrap().integer_digits, 0);
    }

    #[test]
    fn mistakes_are_found_at_their_place() {
        let cases = [
            ("##0#.#", 3..4),
            ("##.#0", 4..5),
            ("##.##.#", 5..6),
            ("##,##", 2..3),
            ("##[.##", 6..6),
            ("##[##]", 2..3),
            ("##[.0]", 4..5),
            ("##[.#x]", 5..6),
            ("", 0..0),
            ("+", 0..1),
            (".", 0..1),
            ("########.########", 0..17),
            ("#ä", 1..3),
            ("##[.#]#", 6..7),
        ];
        for (text, at) in cases {
            assert_eq!(parse(text).map_err(|error| error.at), Err(at), "{text}");
        }
        assert!(parse_zero("0.0").is_ok() && parse_zero("0").is_ok() && parse_zero("+0").is_ok());
        for text in ["", ".", "-0", "+", "0+", "0.0.0", "1", "zero"] {
            assert!(parse_zero(text).is_err(), "{text}");
        }
    }
}
