//! What is said to the user, on standard error: for people, or as JSON lines for tools.

use std::io::{IsTerminal, Write, stderr, stdout};
use std::process::ExitCode;

use clap::ValueEnum;
use mach_runtime::certificate::Certificate;
use mach_runtime::diagnostic::{Diagnostic, Severity};
use serde::Serialize;
use terminal_size::{Width, terminal_size_of};

use crate::json;
use crate::outcome::{Failure, Status};
use crate::render::{Style, render};

/// How many warnings of one code are told.
const MOST_WARNINGS: u64 = 20;

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ColorChoice {
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

/// What every command can be told.
#[derive(Debug, Clone, Copy, clap::Args)]
pub struct ReportOptions {
    /// Write diagnostics, certificates and results as JSON lines, for tools
    #[arg(long, global = true)]
    json: bool,
    /// When to use colours; auto: on a terminal, unless NO_COLOR is set
    #[arg(long, global = true, value_name = "WHEN", value_enum, default_value_t = ColorChoice::Auto)]
    color: ColorChoice,
    /// Say nothing but errors
    #[arg(short, long, global = true)]
    quiet: bool,
}

/// Where diagnostics go.
#[derive(Debug)]
pub struct Report {
    json: bool,
    quiet: bool,
    style: Style,
    colors_stdout: bool,
}

impl Report {
    /// As the options ask for it.
    pub fn new(options: ReportOptions) -> Self {
        let ReportOptions { json, color, quiet } = options;
        let style = Style { color: color.is_for(&stderr()), width: terminal_width() };
        Self { json, quiet, style, colors_stdout: color.is_for(&stdout()) }
    }

    /// Whether what goes to standard output is for tools.
    pub fn is_json(&self) -> bool {
        self.json
    }

    /// Whether colours are wanted on standard output.
    pub fn colors_stdout(&self) -> bool {
        self.colors_stdout
    }

    /// Whether there is anyone for whom notes are meant.
    pub fn shows_notes(&self) -> bool {
        !self.json && !self.quiet
    }

    /// Whether a person is watching who wants to know how far the work is.
    pub fn shows_progress(&self) -> bool {
        self.shows_notes() && stderr().is_terminal()
    }

    /// Tells diagnostics; the status is `Refused` when an error is among them.
    pub fn tell(&self, diagnostics: &[Diagnostic]) -> Status {
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

    /// Tells how close the program is to the CL.
    pub fn certificate(&self, machine: &str, certificate: &Certificate) {
        if self.json {
            self.line(&json::Certificate::new(machine, certificate));
        } else if !self.quiet {
            say(&certificate.to_string());
        }
    }

    /// A line for people that tools have no use for.
    pub fn note(&self, text: &str) {
        if self.shows_notes() {
            say(&format!("{text}\n"));
        }
    }

    /// Tells what went wrong outside the input.
    fn failure(&self, failure: &Failure) {
        if self.json {
            self.line(&json::Failure::new(&failure.0));
        } else {
            say(&format!("error: {}\n", failure.0));
        }
    }

    /// Tells a failure, and gives the exit status.
    pub fn exit_code(&self, outcome: Result<Status, Failure>) -> ExitCode {
        match outcome {
            Ok(Status::Done) => ExitCode::SUCCESS,
            Ok(Status::Refused) => ExitCode::from(1),
            Err(failure) => {
                self.failure(&failure);
                ExitCode::from(2)
            }
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
pub struct Collected {
    diagnostics: Vec<Diagnostic>,
    warnings: std::collections::BTreeMap<&'static str, (usize, u64)>,
}

impl Collected {
    /// Takes a diagnostic in.
    pub fn add(&mut self, diagnostic: Diagnostic) {
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
    pub fn into_diagnostics(mut self) -> Vec<Diagnostic> {
        for (last, count) in self.warnings.into_values().filter(|(_, count)| *count > MOST_WARNINGS) {
            let more = count - MOST_WARNINGS;
            self.diagnostics[last].notes.push(format!("and {more} more warnings like this one"));
        }
        self.diagnostics
    }
}
