//! An axis that the chain has twice.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;
use crate::syntax::tree::Span;
use std::collections::BTreeMap;

/// An axis in two places.
pub(crate) static TWICE: Code = Code {
    id: "E0206",
    title: "an axis stands twice in the chain",
    explanation: "\
An axis is one joint, and stands in the chain once.

    chain w C A b X Y X t      // Z was meant
    chain w C A b X Y Z t

Two axes that move together (a gantry's X1 and X2) are one axis here.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let Some(chain) = &draft.chain else { return Vec::new() };
    let mut seen: BTreeMap<&str, &Span> = BTreeMap::new();
    let mut found = Vec::new();
    for name in draft.links() {
        let Some(first) = seen.insert(&name.value, &name.span) else { continue };
        let message = format!("{} stands twice in the chain", name.value);
        let diagnostic = super::error(draft, &TWICE, message, &chain.at.with(&name.span), "again")
            .at(draft.sources.place(&chain.at.with(first)), "first");
        found.push(diagnostic);
    }
    found
}
