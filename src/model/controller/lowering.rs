//! What every step of lowering a controller needs: its statements, their places, and the mistakes found so far.

use super::Controller;
use crate::syntax::tree::{ControllerStatement, Span, Text};
use mach_runtime::diagnostic::{Code, Diagnostic, Place};
use std::ops::Range;

/// Text that cannot be in a program.
pub(super) static UNPRINTABLE: Code = Code {
    id: "E0529",
    title: "text that no control reads",
    explanation: "\
NC programs are ASCII text: letters, digits, blanks and signs. An umlaut, a degree sign or a tab in a block would be
another character on the control, or stop the program.

    on start { \"(Fräsen)\" }      // write Fraesen
",
};

/// A controller on its way to a dialect.
pub(super) struct Lowering<'a> {
    pub(super) controller: &'a Controller<'a>,
    pub(super) diagnostics: Vec<Diagnostic>,
}

impl<'a> Lowering<'a> {
    pub(super) fn new(controller: &'a Controller<'a>) -> Self {
        Self { controller, diagnostics: Vec::new() }
    }

    /// The statements with their indices.
    pub(super) fn statements(&self) -> impl Iterator<Item = (usize, &'a ControllerStatement)> + use<'a> {
        self.controller.statements.iter().enumerate()
    }

    /// The last statement that is picked, and its index.
    pub(super) fn last<T>(&self, pick: impl Fn(&'a ControllerStatement) -> Option<T>) -> Option<(usize, T)> {
        let indexed = self.controller.statements.iter().enumerate();
        indexed.rev().find_map(|(index, statement)| pick(statement).map(|picked| (index, picked)))
    }

    pub(super) fn place(&self, index: usize, span: &Span) -> Place {
        (self.controller.place)(index, span)
    }

    /// Reports a mistake in the statement with this index.
    pub(super) fn report(
        &mut self,
        code: &'static Code,
        message: impl Into<String>,
        index: usize,
        span: &Span,
        label: impl Into<String>,
    ) {
        let place = self.place(index, span);
        self.diagnostics.push(Diagnostic::error(code, message).at(place, label));
    }

    /// The text, which is reported if it cannot be in a program.
    pub(super) fn printable(&mut self, index: usize, text: &Text) -> String {
        if let Some((at, c)) = unprintable(&text.value) {
            let span = inside(text, at..at + c.len_utf8());
            self.report(&UNPRINTABLE, "NC programs are ASCII text", index, &span, "this is another character");
        }
        text.value.clone()
    }
}

/// The first character that is not printable ASCII, and where it stands.
pub(super) fn unprintable(text: &str) -> Option<(usize, char)> {
    text.char_indices().find(|(_, c)| !matches!(c, ' '..='~'))
}

/// The span of some bytes of a quoted text; the whole of it where it was written with escapes.
pub(super) fn inside(text: &Text, at: Range<usize>) -> Span {
    if text.span.len() == text.value.len() + 2 {
        let start = text.span.start + 1;
        return start + at.start..start + at.end;
    }
    text.span.clone()
}
