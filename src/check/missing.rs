//! A machine without a chain, without axes, or without a tool.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;

/// A statement that every machine has.
pub(crate) static MISSING: Code = Code {
    id: "E0209",
    title: "the machine lacks a statement that every machine has",
    explanation: "\
A machine has a chain, its axes, and a tool:

    machine m {
        chain w b X Y Z t
        linear X along +x
        linear Y along +y
        linear Z along +z
        tool along +z
    }

`zero`, `tolerance`, `records`, `branch` and `controller` may be left out.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let needed = [
        (
            draft.chain.is_none() && !draft.lost.may_be(&["chain", "dh"]),
            "chain",
            "`chain w … b … t`, from the workpiece through the bed to the tool",
        ),
        (
            draft.axes.is_empty() && !draft.may_lack_axes(),
            "axes",
            "`linear X along +x`, `rotary C about +z`, each with its direction",
        ),
        (
            draft.tool.is_none() && !draft.lost.may_be(&["tool", "dh"]),
            "tool",
            "`tool along +z`, the direction from the tip to the spindle",
        ),
    ];
    let missing: Vec<_> = needed.into_iter().filter(|(missing, ..)| *missing).collect();
    if missing.is_empty() {
        return Vec::new();
    }
    let names: Vec<&str> = missing.iter().map(|(_, name, _)| *name).collect();
    let message = format!("the machine {} has no {}", draft.name.value, names.join(", no "));
    let diagnostic = super::error(draft, &MISSING, message, &draft.name.at, "");
    vec![missing.iter().fold(diagnostic, |diagnostic, (.., how)| diagnostic.note(format!("write {how}")))]
}
