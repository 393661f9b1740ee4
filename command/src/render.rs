//! The one file that knows how a diagnostic looks on a terminal.

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Patch, Renderer, Snippet, normalize_untrusted_str};

use mach_runtime::diagnostic::{Diagnostic, Label, Place, Severity, Suggestion};

/// How diagnostics are rendered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// With terminal colours.
    pub color: bool,
    /// The width of the terminal, in columns.
    pub width: usize,
}

impl Style {
    /// Without colours, for files and tests.
    pub const PLAIN: Self = Self { color: false, width: 140 };
}

/// The diagnostics as text, each followed by an empty line.
pub fn render(diagnostics: &[Diagnostic], style: Style) -> String {
    let renderer = if style.color { Renderer::styled() } else { Renderer::plain() }.term_width(style.width);
    let one = |diagnostic| renderer.render(&groups(diagnostic)) + "\n\n";
    diagnostics.iter().map(one).collect()
}

/// The diagnostics as files and tests have them.
pub fn plain(diagnostics: &[Diagnostic]) -> String {
    render(diagnostics, Style::PLAIN)
}

fn groups(diagnostic: &Diagnostic) -> Vec<Group<'_>> {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let title = level.primary_title(diagnostic.message.as_str()).id(diagnostic.code.id);
    let mut group = Group::with_title(title);
    let mut labels = diagnostic.labels.as_slice();
    while let Some(first) = labels.first() {
        let together = labels.iter().take_while(|label| is_same_excerpt(&label.place, &first.place)).count();
        let is_cause = labels.len() == diagnostic.labels.len();
        group = group.element(snippet(&labels[..together], is_cause));
        labels = &labels[together..];
    }
    group = group.elements(diagnostic.notes.iter().map(|note| Level::NOTE.message(normalize_untrusted_str(note))));
    std::iter::once(group).chain(diagnostic.suggestion.as_deref().map(help)).collect()
}

fn is_same_excerpt(a: &Place, b: &Place) -> bool {
    (&a.file, a.line, &a.excerpt) == (&b.file, b.line, &b.excerpt)
}

fn snippet<'a>(labels: &'a [Label], is_cause: bool) -> Snippet<'a, Annotation<'a>> {
    let place = &labels[0].place;
    let annotations = labels.iter().enumerate().map(|(index, label)| {
        let kind = if is_cause && index == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
        let text = (!label.text.is_empty()).then(|| normalize_untrusted_str(&label.text));
        kind.span(label.place.start..label.place.end).label(text)
    });
    let source = Snippet::source(place.excerpt.as_str()).line_start(place.line as usize);
    source.path(place.file.as_str()).annotations(annotations)
}

fn help(suggestion: &Suggestion) -> Group<'_> {
    let place = &suggestion.place;
    let patch = Patch::new(place.start..place.end, suggestion.replacement.as_str());
    Level::HELP
        .secondary_title(normalize_untrusted_str(&suggestion.text))
        .element(Snippet::source(place.excerpt.as_str()).line_start(place.line as usize).patch(patch))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mach_runtime::diagnostic::Code;

    static CODE: Code = Code { id: "E9999", title: "", explanation: "" };

    fn place(excerpt: &str, mark: &str, column: u64) -> Place {
        let start = excerpt.find(mark).unwrap();
        let (file, excerpt) = ("part.cls".to_owned(), excerpt.to_owned());
        Place { file, line: 12, column, excerpt, start, end: start + mark.len() }
    }

    #[test]
    fn a_cause_with_context_and_a_fix() {
        let line = "FEDRAT/100,MPMM";
        let diagnostic = Diagnostic::error(&CODE, "`MPMM` is not known in FEDRAT")
            .at(place(line, "MPMM", 12), "expected a unit")
            .at(place(line, "FEDRAT", 1), "of this record")
            .note("feeds are MMPM, IPM, MMPR or IPR")
            .suggest(Suggestion {
                text: "did you mean `MMPM`?".to_owned(),
                place: place(line, "MPMM", 12),
                replacement: "MMPM".to_owned(),
            });
        let expected = "\
error[E9999]: `MPMM` is not known in FEDRAT
  --> part.cls:12:12
   |
12 | FEDRAT/100,MPMM
   | ------     ^^^^ expected a unit
   | |
   | of this record
   |
   = note: feeds are MMPM, IPM, MMPR or IPR
help: did you mean `MMPM`?
   |
12 - FEDRAT/100,MPMM
12 + FEDRAT/100,MMPM
   |

";
        assert_eq!(plain(&[diagnostic]), expected);
    }

    #[test]
    fn marks_stand_under_their_text_behind_tabs_and_wide_letters() {
        let diagnostic = Diagnostic::warning(&CODE, "odd").at(place("\t刀具Ä x", "x", 6), "");
        let text = plain(&[diagnostic]);
        assert!(text.starts_with("warning[E9999]: odd\n  --> part.cls:12:6\n"), "{text}");
        assert!(text.contains("12 |     刀具Ä x\n   |           ^\n"), "{text}");
    }

    #[test]
    fn a_long_line_is_cut_about_the_mark() {
        let line = format!("GOTO/{}x{}", "1,".repeat(2000), ",2".repeat(2000));
        let text = plain(&[Diagnostic::error(&CODE, "odd").at(place(&line, "x", 4006), "here")]);
        assert!(text.contains("--> part.cls:12:4006\n"), "{text}");
        assert!(text.contains("1,1,x,2,2") && text.lines().all(|line| line.len() < 160), "{text}");
    }

    #[test]
    fn escape_codes_of_the_input_do_not_reach_the_terminal() {
        let mut odd = Diagnostic::error(&CODE, "a \u{1b}[31m b").at(place("\u{1b}[31m x", "x", 7), "\u{1b}[31m");
        odd = odd.note("\u{1b}[31m");
        assert!(!plain(&[odd]).contains('\u{1b}'));
    }

    #[test]
    fn a_diagnostic_without_a_place() {
        let text = plain(&[Diagnostic::error(&CODE, "no place")]);
        assert_eq!(text, "error[E9999]: no place\n\n");
    }
}
