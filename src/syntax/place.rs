//! From a span of bytes to a place that a diagnostic can show.

use mach_runtime::diagnostic::Place;

use super::tree::Span;

/// Of a longer line only the part around the mark is shown.
const EXCERPT_CHARACTERS: usize = 160;
/// How much of a long line is shown before the mark.
const LEAD_CHARACTERS: usize = 60;
/// Of a longer span only the first line is marked.
const MARKED_LINES: usize = 8;
/// The same in bytes.
const MARKED_BYTES: usize = 1000;

/// The place of a span in a text: its line, its column in characters, and its lines as the excerpt (clipped where they
/// are very long).
///
/// # Panics
/// If the span does not lie on character boundaries of the text.
pub fn place(file_name: &str, text: &str, span: &Span) -> Place {
    let line_start = text[..span.start].rfind('\n').map_or(0, |newline| newline + 1);
    let end = marked_end(text, span);
    let line_end = text[end..].find('\n').map_or(text.len(), |length| end + length);
    let column = text[line_start..span.start].chars().filter(|c| *c != '\u{feff}').count() as u64 + 1;
    let first = excerpt_start(text, line_start, line_end, span.start);
    let last = excerpt_end(text, first, line_end, end);
    let excerpt = text[first..last].trim_end_matches('\r').to_owned();
    Place {
        file: file_name.to_owned(),
        line: text.as_bytes()[..line_start].iter().filter(|byte| **byte == b'\n').count() as u64 + 1,
        column,
        start: (span.start.max(first) - first).min(excerpt.len()),
        end: (end.max(first) - first).min(excerpt.len()),
        excerpt,
    }
}

/// The end of what is marked: on the first line where the span runs over many.
fn marked_end(text: &str, span: &Span) -> usize {
    let marked = &text[span.clone()];
    match marked.find('\n') {
        Some(first) if marked.len() > MARKED_BYTES || marked.matches('\n').count() >= MARKED_LINES => {
            span.start + marked[..first].trim_end_matches('\r').len()
        }
        _ => span.end,
    }
}

/// Where the excerpt starts: at the line's first character (not at a byte order mark), or some way before the mark.
fn excerpt_start(text: &str, line_start: usize, line_end: usize, mark: usize) -> usize {
    let line_start = if line_start == 0 && text.starts_with('\u{feff}') && mark > 0 { 3 } else { line_start };
    if text[line_start..line_end].chars().nth(EXCERPT_CHARACTERS).is_none() {
        return line_start;
    }
    text[line_start..mark].char_indices().rev().nth(LEAD_CHARACTERS - 1).map_or(line_start, |(at, _)| line_start + at)
}

/// Where the excerpt ends: with the mark's last line, or some way behind the mark's beginning.
fn excerpt_end(text: &str, first: usize, line_end: usize, mark_end: usize) -> usize {
    let clipped = text[first..line_end].char_indices().nth(EXCERPT_CHARACTERS).map(|(at, _)| first + at);
    match clipped {
        Some(clipped) if text[first..mark_end].contains('\n') => clipped.max(mark_end),
        Some(clipped) => clipped,
        None => line_end,
    }
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn counts_lines_and_characters() {
        let text = "\u{feff}one\r\nzwölf drei\r\n";
        let at = text.find("drei").unwrap();
        let place = place("a.mach", text, &(at..at + 4));
        assert_eq!((place.line, place.column, place.excerpt.as_str()), (2, 7, "zwölf drei"));
        assert_eq!(&place.excerpt[place.start..place.end], "drei");
    }

    #[test]
    fn a_byte_order_mark_is_not_a_column() {
        let place = place("a.mach", "\u{feff}one", &(3..6));
        assert_eq!((place.line, place.column, place.excerpt.as_str(), place.start), (1, 1, "one", 0));
    }

    #[test]
    fn clips_a_long_line_around_the_mark() {
        let text = format!("{}here{}", "ä".repeat(1000), "b".repeat(1000));
        let at = text.find("here").unwrap();
        let place = place("a.mach", &text, &(at..at + 4));
        assert_eq!(place.column, 1001);
        assert_eq!(place.excerpt.chars().count(), 160);
        assert_eq!(&place.excerpt[place.start..place.end], "here");
    }

    #[test]
    fn the_end_of_a_text_is_a_place() {
        for text in ["", "a\n", "a"] {
            let place = place("a.mach", text, &(text.len()..text.len()));
            assert_eq!(place.start, place.end);
        }
    }
}
