//! The text of lines that are known by number only.

use std::collections::BTreeMap;
use std::io::{self, Read};

use crate::cl::record::decoded;
use crate::cl::source::{Source, SourceLine};
use crate::diagnostic::{Diagnostic, Place};

/// Fills in the source lines that the diagnostics about `file` lack: those found when the points were long read.
///
/// # Errors
/// When the input cannot be read.
pub fn quote(diagnostics: &mut [Diagnostic], file: &str, input: impl Read) -> io::Result<()> {
    let mut wanted: BTreeMap<u64, Vec<&mut Place>> = BTreeMap::new();
    let labels = diagnostics.iter_mut().flat_map(|diagnostic| &mut diagnostic.labels);
    for place in labels.map(|label| &mut label.place).filter(|place| place.file == file && place.excerpt.is_empty()) {
        wanted.entry(place.line).or_default().push(place);
    }
    let mut source = Source::new(input);
    let mut line = 0;
    while !wanted.is_empty() {
        let Some(text) = source.next_line()? else { break };
        line += 1;
        let Some(places) = wanted.remove(&line) else { continue };
        let (SourceLine::Text(bytes) | SourceLine::TooLong(bytes)) = text;
        let excerpt = decoded(bytes);
        for place in places {
            place.start = excerpt.len() - excerpt.trim_start().len();
            place.end = excerpt.trim_end().len().max(place.start);
            place.column = excerpt[..place.start].chars().count() as u64 + 1;
            place.excerpt.clone_from(&excerpt);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Code;

    static CODE: Code = Code { id: "E9999", title: "", explanation: "" };

    #[test]
    fn lines_are_found_by_their_number() {
        let at = |line| Diagnostic::error(&CODE, "").at(Place::line("a.cls", line), "");
        let mut diagnostics = [at(3), at(1), at(3), at(9)];
        quote(&mut diagnostics, "a.cls", &b"GOTO/1\n\n  GOTO/\xc4 \nGOTO/4"[..]).unwrap();
        let quoted = diagnostics.map(|diagnostic| {
            let place = diagnostic.labels[0].place.clone();
            (place.excerpt[place.start..place.end].to_owned(), place.column)
        });
        let third = ("GOTO/Ä".to_owned(), 3);
        assert_eq!(quoted, [third.clone(), ("GOTO/1".to_owned(), 1), third, (String::new(), 1)]);
    }
}
