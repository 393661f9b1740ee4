//! The parser that pest makes from `grammar/mach.pest`, and what its pairs have in common.

use crate::syntax::tree::Span;

#[derive(pest_derive::Parser)]
#[grammar = "../grammar/mach.pest"]
pub(super) struct MachParser;

pub(super) type Pair<'t> = pest::iterators::Pair<'t, Rule>;

/// The pairs inside, without the tokens that carry nothing of their own: the grammar lists these last.
pub(super) fn content(pair: Pair<'_>) -> Vec<Pair<'_>> {
    pair.into_inner().filter(|inner| inner.as_rule() != Rule::EOI && inner.as_rule() < Rule::open_brace).collect()
}

/// From the first to the last token: a pair of pest's may end with blanks and comments.
pub(super) fn extent(pair: &Pair<'_>) -> Span {
    let start = pair.as_span().start();
    let mut last = pair.clone();
    while let Some(inner) = last.clone().into_inner().next_back() {
        last = inner;
    }
    start..last.as_span().end().max(start)
}

/// The end of the brace that opens a block statement's body.
pub(super) fn opening_brace(statement: &Pair<'_>) -> Option<usize> {
    let body = statement.clone().into_inner().next_back()?;
    let first = body.into_inner().next()?;
    let is_body = matches!(statement.as_rule(), Rule::machine_statement | Rule::controller_statement)
        || matches!(statement.as_rule(), Rule::dh_statement | Rule::error_statement)
        || matches!(statement.as_rule(), Rule::group_statement | Rule::once_statement)
        || matches!(statement.as_rule(), Rule::branch_statement | Rule::controller_choice | Rule::on_statement);
    (is_body && first.as_rule() == Rule::open_brace).then(|| first.as_span().end())
}
