//! An axis of the chain that is not declared.

use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::model::draft::Draft;
use crate::syntax::spelling::nearest;
use crate::syntax::tree::Name;

/// An axis that is not declared.
pub(crate) static UNKNOWN_AXIS: Code = Code {
    id: "E0204",
    title: "an axis of the chain is not declared",
    explanation: "\
Every axis of the chain has a statement that says where it lies.

    chain w C A b X Y Z t
    linear X along +x
    linear Y along +y
    linear Z along +z
    rotary A about +x
    rotary B about +z        // the chain calls it C
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let Some(chain) = &draft.chain else { return Vec::new() };
    let report = |name: &Name| {
        let at = chain.at.with(&name.span);
        let message = format!("the chain has an axis {}, and no statement declares it", name.value);
        let diagnostic = super::error(draft, &UNKNOWN_AXIS, message, &at, "not declared");
        let Some(meant) = meant(draft, name) else {
            return diagnostic.note(format!("declare it: `{}`, for example", usual_statement(&name.value)));
        };
        let text = format!("did you mean `{meant}`, which is declared but not in the chain?");
        diagnostic.suggest(Suggestion { text, place: draft.sources.place(&at), replacement: meant.to_owned() })
    };
    unknown(draft).map(report).collect()
}

/// The axes of the chain that are not declared.
pub(super) fn unknown<'a>(draft: &'a Draft<'_>) -> impl Iterator<Item = &'a Name> {
    let is_unknown = |name: &str| draft.axis(name).is_none() && !draft.may_lack_axis(name);
    draft.links().filter(move |name| is_unknown(&name.value))
}

/// The declared axis that an undeclared one of the chain probably stands for: one that is not in the chain.
pub(super) fn meant<'a>(draft: &'a Draft<'_>, name: &Name) -> Option<&'a str> {
    let declared = draft.axes.iter().map(|axis| axis.name.value.as_str());
    let idle: Vec<&str> = declared.filter(|name| draft.links().all(|link| link.value != *name)).collect();
    let only = if let [only] = idle[..] { Some(only) } else { None };
    nearest(&name.value, idle).or(only)
}

/// The statement of an axis of this name, as ISO 841 has it on most machines.
fn usual_statement(name: &str) -> String {
    let (motion, direction) = match name.as_bytes()[0] {
        b'Y' | b'V' | b'Q' => ("linear", "along +y"),
        b'Z' | b'W' | b'R' => ("linear", "along +z"),
        b'A' => ("rotary", "about +x"),
        b'B' => ("rotary", "about +y"),
        b'C' => ("rotary", "about +z"),
        _ => ("linear", "along +x"),
    };
    format!("{motion} {name} {direction}")
}
