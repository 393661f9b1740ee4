//! What the grammar would have taken, in words.

use pest::Parser;
use pest::error::{ErrorVariant, InputLocation};

use super::grammar::{MachParser, Rule};

/// How far `rule` gets in a text, and what would have fitted there.
pub(super) fn furthest_failure(rule: Rule, text: &str) -> (usize, Vec<Rule>) {
    let Err(error) = MachParser::parse(rule, text) else { return (0, Vec::new()) };
    let at = match error.location {
        InputLocation::Pos(at) | InputLocation::Span((at, _)) => at,
    };
    match error.variant {
        ErrorVariant::ParsingError { positives, .. } => (at, positives),
        ErrorVariant::CustomError { .. } => (at, Vec::new()),
    }
}

/// The keywords of the statements that a context may hold.
pub(super) fn statements(context: Rule) -> Vec<String> {
    furthest_failure(context, "").1.into_iter().filter_map(keyword).collect()
}

/// The keyword that a rule begins with: the grammar's rules are named after theirs.
pub(super) fn keyword(rule: Rule) -> Option<String> {
    let name = format!("{rule:?}");
    let suffixes = ["_statement", "_choice", "_clause", "_kind"];
    let keyword = name.strip_prefix("kw_").or_else(|| suffixes.iter().find_map(|suffix| name.strip_suffix(suffix)));
    match rule {
        Rule::line => Some("bare".to_owned()),
        _ => keyword.map(str::to_owned),
    }
}

/// What would have fitted, in words; that an expression might have gone on is said only when nothing else fits.
pub(super) fn described(expected: &[Rule]) -> Vec<String> {
    let mut words = unique(expected.iter().filter_map(|rule| description(*rule)));
    if words.is_empty() {
        words = unique(expected.iter().filter_map(|rule| continuation(*rule)));
    }
    if words.iter().any(|word| word == A_VALUE) {
        words.retain(|word| word != A_NAME);
    }
    words.sort_by_key(|word| [NEXT_STATEMENT, "`}`"].contains(&word.as_str()));
    words
}

fn unique(words: impl Iterator<Item = String>) -> Vec<String> {
    words.fold(Vec::new(), |mut unique, word| {
        if !unique.contains(&word) {
            unique.push(word);
        }
        unique
    })
}

const A_NAME: &str = "a name";
const A_VALUE: &str = "a value";
const NEXT_STATEMENT: &str = "the next statement";

fn description(rule: Rule) -> Option<String> {
    let words = match rule {
        Rule::name => A_NAME,
        Rule::axis | Rule::link => "an axis",
        Rule::format => "the name of a format",
        Rule::error_name => "the name of an error such as `EX0C`",
        Rule::variable => "an axis",
        Rule::group_name => "the name of a group",
        Rule::member | Rule::member_name => "a meaning and its text",
        Rule::text => "a text in quotes",
        Rule::line | Rule::template => "a line in quotes",
        Rule::placeholder_name => "the name of a placeholder",
        Rule::picture => "a picture such as `##0.0`",
        Rule::event | Rule::word => "an event",
        Rule::number | Rule::quantity | Rule::call | Rule::parenthesised | Rule::expression => A_VALUE,
        Rule::statement_word => NEXT_STATEMENT,
        Rule::open_brace => "`{`",
        Rule::dh_body | Rule::error_body => "`{`",
        Rule::machine_body | Rule::branch_body | Rule::controller_body | Rule::line_body | Rule::group_body => "`{`",
        Rule::close_brace => "`}`",
        Rule::close_parenthesis => "`)`",
        Rule::comma => "`,`",
        Rule::colon => "`:`",
        Rule::equals => "`=`",
        Rule::range_dots => "`..`",
        Rule::bar => "`|`",
        Rule::quote => "`\"`",
        rule => return keyword(rule).map(|keyword| format!("`{keyword}`")),
    };
    Some(words.to_owned())
}

/// What may follow an operand.
fn continuation(rule: Rule) -> Option<String> {
    let words = match rule {
        Rule::unit | Rule::unknown_unit => "a unit",
        Rule::add | Rule::subtract | Rule::multiply | Rule::divide | Rule::power => "an operator",
        Rule::open_parenthesis => "`(`",
        _ => "something else",
    };
    Some(words.to_owned())
}

/// `a, b or c`.
pub(super) fn list(words: &[String]) -> String {
    match words {
        [] => "something else".to_owned(),
        [only] => only.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}
