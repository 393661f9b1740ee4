//! A branch preference about something that is not a rotary axis.

use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::model::draft::{AxisDraft, Draft};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{Name, Preference};
use mach_runtime::machine::Motion;

/// A preference that names no rotary axis.
pub(crate) static NO_ROTARY: Code = Code {
    id: "E0213",
    title: "a branch preference names no rotary axis",
    explanation: "\
The ways to point the tool in one direction differ in the rotary axes, so `least`, `positive` and `negative` name one of
the machine's rotary axes.

    branch {
        start least |X|        // X follows from the rotary axes
        start least |C|
    }
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let preferences = draft.start.iter().chain(&draft.then);
    let named = preferences.filter_map(|said| Some((axis_name(&said.value)?, &said.at)));
    named.filter_map(|(name, at)| report(draft, name, at)).collect()
}

fn axis_name(preference: &Preference) -> Option<&Name> {
    match preference {
        Preference::Least(name) | Preference::Positive(name) | Preference::Negative(name) => Some(name),
        Preference::Nearest => None,
    }
}

fn report(draft: &Draft<'_>, name: &Name, at: &crate::model::source::Location) -> Option<Diagnostic> {
    let (message, label) = match draft.axis(&name.value) {
        Some((_, AxisDraft { motion: Motion::Rotary, .. })) => return None,
        Some(_) => (format!("{} is not a rotary axis", name.value), "a linear axis"),
        None if draft.may_lack_axis(&name.value) => return None,
        None => (format!("the machine has no axis {}", name.value), "unknown axis"),
    };
    let at = at.with(&name.span);
    let mut diagnostic = super::error(draft, &NO_ROTARY, message, &at, label);
    let rotaries: Vec<&str> = draft.rotaries().map(|axis| axis.name.value.as_str()).collect();
    if let Some(meant) = nearest(&name.value, rotaries.iter().copied()) {
        let text = format!("did you mean `{meant}`?");
        let replacement = meant.to_owned();
        diagnostic = diagnostic.suggest(Suggestion { text, place: draft.sources.place(&at), replacement });
    }
    if draft.may_lack_axes() {
        return Some(diagnostic);
    }
    Some(diagnostic.note(match &rotaries[..] {
        [] => "the machine has no rotary axes".to_owned(),
        rotaries => format!("the machine's rotary axes: {}", rotaries.join(", ")),
    }))
}
