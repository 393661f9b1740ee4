//! A declared axis that the chain does not have.

use super::unknown_axis;
use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{AxisDraft, Draft};

/// An axis without a place in the chain.
pub(crate) static NOT_IN_CHAIN: Code = Code {
    id: "E0205",
    title: "a declared axis is not in the chain",
    explanation: "\
The chain says what carries what, so every declared axis has its place in it.

    chain w b X Y Z t
    rotary C about +z        // does C carry the workpiece or the tool?

Put it into the chain (`chain w C b X Y Z t`: a table on the bed), or delete the statement.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let Some(chain) = draft.chain.as_ref().filter(|_| draft.is_chain_whole) else { return Vec::new() };
    // One that an unknown axis of the chain stands for is reported there.
    let meant: Vec<&str> = unknown_axis::unknown(draft).filter_map(|name| unknown_axis::meant(draft, name)).collect();
    let stands = |name: &str| draft.links().any(|link| link.value == name) || meant.contains(&name);
    let idle = draft.axes.iter().filter(|axis| !stands(&axis.name.value));
    let report = |axis: &AxisDraft| {
        let message = format!("{} is declared, and the chain does not have it", axis.name.value);
        super::error(draft, &NOT_IN_CHAIN, message, &axis.name.at, "not in the chain")
            .at(draft.sources.place(&chain.at), "the chain")
    };
    idle.map(report).collect()
}
