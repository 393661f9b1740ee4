//! What `--json` writes: one object a line, each with a `type`.

use mach_runtime::certificate::{self, Extreme, Range};
use mach_runtime::diagnostic::{self, Place, Severity};
use serde::Serialize;

#[derive(Serialize)]
#[serde(tag = "type", rename = "diagnostic")]
pub(crate) struct Diagnostic<'a> {
    code: &'static str,
    severity: &'static str,
    message: &'a str,
    /// The cause first.
    labels: Vec<Label<'a>>,
    notes: &'a [String],
    suggestion: Option<Suggestion<'a>>,
    /// As a person sees it.
    rendered: &'a str,
}

#[derive(Serialize)]
struct Label<'a> {
    #[serde(flatten)]
    span: Span<'a>,
    text: &'a str,
}

#[derive(Serialize)]
struct Suggestion<'a> {
    #[serde(flatten)]
    span: Span<'a>,
    text: &'a str,
    replacement: &'a str,
}

/// From the first marked character to the one after the last; lines and columns in characters from 1.
#[derive(Serialize)]
struct Span<'a> {
    file: &'a str,
    line: u64,
    column: u64,
    end_line: u64,
    end_column: u64,
}

#[derive(Serialize)]
#[serde(tag = "type", rename = "certificate")]
pub(crate) struct Certificate<'a> {
    machine: &'a str,
    points: u64,
    blocks: u64,
    tip_error_mm: Worst,
    axis_error_rad: Worst,
    rotary_step_deg: Worst,
    off_line_in_cuts_mm: Worst,
    off_line_in_rapid_mm: Worst,
    blocks_off_line: u64,
    axes: Vec<AxisRange<'a>>,
}

/// The largest value, and the CL line it stands at.
#[derive(Serialize)]
struct Worst {
    value: f64,
    line: u64,
}

/// Millimetres or degrees; no margin where there is no limit.
#[derive(Serialize)]
struct AxisRange<'a> {
    name: &'a str,
    unit: &'static str,
    least: Worst,
    greatest: Worst,
    lower_margin: Option<f64>,
    upper_margin: Option<f64>,
}

#[derive(Serialize)]
#[serde(tag = "type", rename = "failure")]
pub(crate) struct Failure<'a> {
    message: &'a str,
}

impl<'a> Diagnostic<'a> {
    pub(crate) fn new(diagnostic: &'a diagnostic::Diagnostic, rendered: &'a str) -> Self {
        let label = |label: &'a diagnostic::Label| Label { span: Span::new(&label.place), text: &label.text };
        let suggestion = diagnostic.suggestion.as_deref().map(|suggestion| Suggestion {
            span: Span::new(&suggestion.place),
            text: &suggestion.text,
            replacement: &suggestion.replacement,
        });
        Self {
            code: diagnostic.code.id,
            severity: match diagnostic.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
            },
            message: &diagnostic.message,
            labels: diagnostic.labels.iter().map(label).collect(),
            notes: &diagnostic.notes,
            suggestion,
            rendered,
        }
    }
}

impl<'a> Span<'a> {
    fn new(place: &'a Place) -> Self {
        let line = place.line + place.excerpt[..place.start].matches('\n').count() as u64;
        let marked = &place.excerpt[place.start..place.end];
        let last = marked.rsplit('\n').next().unwrap_or_default();
        let end_column = last.chars().count() as u64 + if marked.contains('\n') { 1 } else { place.column };
        let end_line = line + marked.matches('\n').count() as u64;
        Self { file: &place.file, line, column: place.column, end_line, end_column }
    }
}

impl<'a> Certificate<'a> {
    pub(crate) fn new(machine: &'a str, certificate: &'a certificate::Certificate) -> Self {
        Self {
            machine,
            points: certificate.points,
            blocks: certificate.blocks,
            tip_error_mm: Worst::new(certificate.worst.tip_mm),
            axis_error_rad: Worst::new(certificate.worst.axis_rad),
            rotary_step_deg: Worst::new(certificate.rotary_step_deg),
            off_line_in_cuts_mm: Worst::new(certificate.between.feed_mm),
            off_line_in_rapid_mm: Worst::new(certificate.between.rapid_mm),
            blocks_off_line: certificate.between.beyond_tolerance,
            axes: certificate.ranges.iter().map(AxisRange::new).collect(),
        }
    }
}

impl Worst {
    fn new(extreme: Extreme) -> Self {
        Self { value: extreme.value, line: extreme.line }
    }
}

impl<'a> AxisRange<'a> {
    fn new(range: &'a Range) -> Self {
        let margin = |margin: f64| margin.is_finite().then_some(margin);
        Self {
            name: &range.axis.name,
            unit: range.axis.motion.unit(),
            least: Worst::new(range.least()),
            greatest: Worst::new(range.greatest()),
            lower_margin: margin(range.lower_margin()),
            upper_margin: margin(range.upper_margin()),
        }
    }
}

impl<'a> Failure<'a> {
    pub(crate) fn new(message: &'a str) -> Self {
        Self { message }
    }
}
