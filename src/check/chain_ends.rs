//! A chain, or a `dh` table, that does not lead from the workpiece through the bed to the tool.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;
use crate::syntax::tree::{Link, Span};

/// `w`, `b` or `t` missing, twice, or in the wrong place.
pub(crate) static ENDS: Code = Code {
    id: "E0207",
    title: "the chain does not lead from `w` through `b` to `t`",
    explanation: "\
A chain is written as in ISO 10791: it begins with the workpiece `w`, passes the bed `b` once, and ends with the tool
`t`. The axes before `b` move the workpiece, those after it move the tool.

    chain w C A b X Y Z t      // trunnion table: C on A, the tool moves in X, Y and Z
    chain w b X Y Z C A t      // fork head: the workpiece stands still
    chain w Y X b Z t          // three axes, a cross table

A `dh` table begins with the workpiece and ends with the tool by itself. Its row `bed` stands once, where a chain has `b`.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let Some(chain) = &draft.chain else { return Vec::new() };
    let (whole, stations) =
        if draft.is_chain_of_a_table { ("table", &OF_A_TABLE[..]) } else { ("chain", &OF_A_CHAIN[..]) };
    let links = &chain.value;
    let last = links.len().saturating_sub(1);
    let report = |place: &Station, problem: String, span: Option<&Span>| {
        let at = span.map_or(chain.at.clone(), |span| chain.at.with(span));
        super::error(draft, &ENDS, format!("{} {problem}", place.name), &at, place.rule)
    };
    let mut found = Vec::new();
    for place in stations {
        let standing: Vec<(usize, &Span)> =
            links.iter().enumerate().filter_map(|(i, link)| (place.span)(link).map(|span| (i, span))).collect();
        let (first_allowed, last_allowed) = (place.allowed)(last);
        let fits = |index: usize| (first_allowed..=last_allowed).contains(&index);
        match standing[..] {
            [] if !draft.is_chain_whole => {}
            [] => found.push(report(place, format!("is missing from the {whole}"), None)),
            [(index, span)] if !fits(index) => {
                found.push(report(place, "is in the wrong place".to_owned(), Some(span)))
            }
            [_] => {}
            [_, (_, again), ..] => found.push(report(place, format!("stands twice in the {whole}"), Some(again))),
        }
    }
    found
}

/// A place that is passed on the way from the workpiece to the tool.
struct Station {
    name: &'static str,
    rule: &'static str,
    span: fn(&Link) -> Option<&Span>,
    /// The first and the last index it may have, from the chain's last index.
    allowed: fn(usize) -> (usize, usize),
}

static OF_A_CHAIN: [Station; 3] = [
    Station {
        name: "`w`, the workpiece,",
        rule: "a chain begins with `w`",
        span: |link| if let Link::Workpiece(span) = link { Some(span) } else { None },
        allowed: |_| (0, 0),
    },
    Station {
        name: "`b`, the bed,",
        rule: "a chain passes `b` once, between `w` and `t`",
        span: bed,
        allowed: |last| (0, last),
    },
    Station {
        name: "`t`, the tool,",
        rule: "a chain ends with `t`",
        span: |link| if let Link::Tool(span) = link { Some(span) } else { None },
        allowed: |last| (last, last),
    },
];

/// A table has its ends by itself.
static OF_A_TABLE: [Station; 1] = [Station {
    name: "the row `bed`",
    rule: "`bed` stands once, behind what moves the workpiece and before what moves the tool",
    span: bed,
    allowed: |last| (0, last),
}];

fn bed(link: &Link) -> Option<&Span> {
    if let Link::Bed(span) = link { Some(span) } else { None }
}
