//! What is said to the user, on standard error: for people, or as JSON lines for tools.

use std::io::{IsTerminal, Write, stderr, stdout};

use clap::ValueEnum;
use mach_runtime::certificate::Certificate;
use mach_runtime::render::{Style, render};
use machc::diagnostic::{Diagnostic, Severity};
use serde::Serialize;
use terminal_size::{Width, terminal_size_of};

use super::{Failure, Status, json};

/// How many warnings of one code are told.
const MOST_WARNINGS: u64 = 20;

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ColorChoice {
    Auto,
    Always,
    Never,
}

impl ColorChoice {
    /// Whether to use colours there.
    fn is_for(self, stream: &impl IsTerminal) -> bool {
        match self {
            Self::Auto => {
                let wanted = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
                wanted && stream.is_terminal() && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
            }
            Self::Always => true,
            Self::Never => false,
        }
    }
}

/// Where diagnostics go.
#[derive(Debug)]
pub(super) struct Report {
    json: bool,
    quiet: bool,
    style: Style,
    colors_stdout: bool,
}

impl Report {
    pub(super) fn new(json: bool, color: ColorChoice, quiet: bool) -> Self {
        let style = Style { color: color.is_for(&stderr()), width: terminal_width() };
        Self { json, quiet, style, colors_stdout: color.is_for(&stdout()) }
    }

    /// Whether what goes to standard output is for tools.
    pub(super) fn is_json(&self) -> bool {
        self.json
    }

    /// Whether colours are wanted on standard output.
    pub(super) fn colors_stdout(&self) -> bool {
        self.colors_stdout
    }

    /// Whether a person is watching who wants to know how far the work is.
    pub(super) fn shows_progress(&self) -> bool {
        !self.json && !self.quiet && stderr().is_terminal()
    }

    /// Tells diagnostics; the status is `Refused` when an error is among them.
    pub(super) fn tell(&self, diagnostics: &[Diagnostic]) -> Status {
        let is_error = |diagnostic: &Diagnostic| diagnostic.severity == Severity::Error;
        let told = diagnostics.iter().filter(|diagnostic| is_error(diagnostic) || !self.quiet);
        for diagnostic in told {
            let text = render(std::slice::from_ref(diagnostic), self.style);
            if self.json {
                self.line(&json::Diagnostic::new(diagnostic, &text));
            } else {
                say(&text);
            }
        }
        if diagnostics.iter().any(is_error) { Status::Refused } else { Status::Done }
    }

    pub(super) fn certificate(&self, machine: &str, certificate: &Certificate) {
        if self.json {
            self.line(&json::Certificate::new(machine, certificate));
        } else if !self.quiet {
            say(&certificate.to_string());
        }
    }

    /// A line for people that tools have no use for.
    pub(super) fn note(&self, text: &str) {
        if !self.json && !self.quiet {
            say(&format!("{text}\n"));
        }
    }

    pub(super) fn failure(&self, failure: &Failure) {
        if self.json {
            self.line(&json::Failure::new(&failure.0));
        } else {
            say(&format!("error: {}\n", failure.0));
        }
    }

    fn line(&self, message: &impl Serialize) {
        let text = serde_json::to_string(message).expect("messages are plain data");
        say(&format!("{text}\n"));
    }
}

fn terminal_width() -> usize {
    terminal_size_of(stderr()).map_or(Style::PLAIN.width, |(Width(columns), _)| usize::from(columns))
}

/// Writes to standard error. When nobody listens there, there is nobody to tell.
fn say(text: &str) {
    let _ = stderr().lock().write_all(text.as_bytes());
}

/// Diagnostics that come one by one: all errors, and the first warnings of each code.
#[derive(Debug, Default)]
pub(super) struct Collected {
    diagnostics: Vec<Diagnostic>,
    warnings: std::collections::BTreeMap<&'static str, (usize, u64)>,
}

impl Collected {
    pub(super) fn add(&mut self, diagnostic: Diagnostic) {
        if diagnostic.severity == Severity::Warning {
            let (last, count) = self.warnings.entry(diagnostic.code.id).or_default();
            *count += 1;
            if *count > MOST_WARNINGS {
                return;
            }
            *last = self.diagnostics.len();
        }
        self.diagnostics.push(diagnostic);
    }

    /// What is to be told.
    pub(super) fn into_diagnostics(mut self) -> Vec<Diagnostic> {
        for (last, count) in self.warnings.into_values().filter(|(_, count)| *count > MOST_WARNINGS) {
            let more = count - MOST_WARNINGS;
            self.diagnostics[last].notes.push(format!("and {more} more warnings like this one"));
        }
        self.diagnostics
    }
}
