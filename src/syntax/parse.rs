//! Text to tree.
//!
//! A pass over the characters finds comments, texts and braces, and refuses what would not be worth parsing; the
//! grammar does the rest. What no statement of the grammar takes ends up in a `broken` node, which becomes a
//! diagnostic; everything around it is still read.

use mach_runtime::diagnostic::{Code, Diagnostic};
use pest::Parser;

use super::tree::{Body, Definition, File, Item, Name, Span, Spanned, Stated, Text, Trivia};
use failure::Failures;
use grammar::{MachParser, Pair, Rule};
use trivia::Comments;

pub mod controller;
pub mod dh;
mod expected;
pub mod expression;
pub mod failure;
mod found;
mod grammar;
pub mod machine;
pub mod scan;
mod template;
mod trivia;

/// Every kind of mistake that the parser finds.
pub static CODES: [&Code; 14] = [
    &scan::TOO_LARGE,
    &scan::CONTROL_CHARACTER,
    &scan::UNTERMINATED_TEXT,
    &scan::UNKNOWN_ESCAPE,
    &scan::UNMATCHED_BRACE,
    &scan::TOO_DEEP,
    &failure::UNEXPECTED,
    &failure::UNKNOWN_STATEMENT,
    &expression::UNKNOWN_UNIT,
    &controller::UNKNOWN_EVENT,
    &expression::VECTOR_LENGTH,
    &expression::TOO_LONG,
    &machine::CLAUSE_TWICE,
    &dh::FIVE_PARAMETERS,
];

/// Parses a file.
///
/// # Errors
/// Everything that is wrong with the text, in its order (at most [`failure::MOST_ERRORS`]).
pub fn parse(file_name: &str, text: &str) -> Result<File, Vec<Diagnostic>> {
    let scan = scan::scan(file_name, text)?;
    let mut failures = Failures::new(file_name, text);
    let file = match MachParser::parse(Rule::file, text) {
        Ok(mut pairs) => {
            let file = pairs.next().expect("a parse of `file` gives one pair");
            let mut builder = Builder { failures: &mut failures, comments: Comments::new(text, scan.comments) };
            Some(File { body: builder.body(file, Rule::item, Builder::item) })
        }
        Err(_) => {
            failures.syntax(Rule::file, 0, None);
            None
        }
    };
    let errors = failures.into_errors();
    match file {
        Some(file) if errors.is_empty() => Ok(file),
        _ => Err(errors),
    }
}

/// Turns the grammar's pairs into the tree.
struct Builder<'a, 't> {
    failures: &'a mut Failures<'t>,
    comments: Comments<'t>,
}

impl<'t> Builder<'_, 't> {
    /// The statements of a body (or of the file). `rule` is what a statement of it is, to explain a broken one;
    /// `build` gives `None` where it has reported an error.
    fn body<T>(&mut self, body: Pair<'t>, rule: Rule, build: impl Fn(&mut Self, Pair<'t>) -> Option<T>) -> Body<T> {
        let close = grammar::extent(&body).end;
        let mut statements = Vec::new();
        let mut pairs = grammar::content(body).into_iter().peekable();
        while let Some(pair) = pairs.next() {
            let span = grammar::extent(&pair);
            if is_broken(&pair) {
                let next = pairs.peek().filter(|next| is_broken(next)).map(|next| next.as_span().start());
                self.failures.syntax(rule, span.start, next);
                continue;
            }
            let (node, trivia) = self.with_trivia(pair, &span, &build);
            statements.extend(node.map(|node| Stated { node, span, trivia }));
        }
        Body { statements, trailing: self.comments.until(close) }
    }

    fn with_trivia<T>(
        &mut self,
        pair: Pair<'t>,
        span: &Span,
        build: impl Fn(&mut Self, Pair<'t>) -> Option<T>,
    ) -> (Option<T>, Trivia) {
        let before = self.comments.until(span.start);
        let mut trivia = Trivia { before, blank_before: self.comments.blank_line_until(span.start), behind: None };
        // A block's own comment stands behind its opening brace; what is inside belongs to its statements.
        let head_end = grammar::opening_brace(&pair).unwrap_or(span.end);
        let mut inside = self.comments.inside(head_end);
        if let Some(first) = inside.first_mut() {
            first.blank_before = std::mem::take(&mut trivia.blank_before);
        }
        trivia.before.extend(inside);
        trivia.behind = self.comments.behind(head_end);
        let node = build(self, pair);
        if trivia.behind.is_none() && self.comments.is_one_line(head_end, span.end) {
            trivia.behind = self.comments.behind(span.end);
        }
        self.comments.pass(span.end);
        (node, trivia)
    }

    fn item(&mut self, pair: Pair<'t>) -> Option<Item> {
        Some(match pair.as_rule() {
            Rule::use_statement => Item::Use(parts(pair).text()),
            Rule::machine_statement => Item::Machine(self.definition(pair, Rule::in_machine, Self::machine_statement)),
            Rule::controller_statement => {
                Item::Controller(self.definition(pair, Rule::in_controller, Self::controller_statement))
            }
            rule => unreachable!("{rule:?} is no item of the grammar"),
        })
    }

    fn definition<T>(
        &mut self,
        pair: Pair<'t>,
        rule: Rule,
        statement: impl Fn(&mut Self, Pair<'t>) -> Option<T>,
    ) -> Definition<T> {
        let mut parts = parts(pair);
        let name = parts.name();
        let like = parts.take(Rule::like_clause).map(|like| self::parts(like).name());
        let title = parts.take(Rule::text).map(|text| template::text(&text));
        Definition { name, like, title, body: self.body(parts.next(), rule, statement) }
    }
}

fn is_broken(pair: &Pair<'_>) -> bool {
    matches!(pair.as_rule(), Rule::broken | Rule::broken_line | Rule::broken_row)
}

/// What a pair consists of, without keywords and delimiters.
fn parts(pair: Pair<'_>) -> Parts<'_> {
    Parts { pairs: grammar::content(pair).into_iter().peekable() }
}

/// The grammar promises what follows what: `take` where it is optional, the others where it is not.
struct Parts<'t> {
    pairs: std::iter::Peekable<std::vec::IntoIter<Pair<'t>>>,
}

impl<'t> Parts<'t> {
    fn next(&mut self) -> Pair<'t> {
        self.pairs.next().expect("the grammar promises another part")
    }

    fn take(&mut self, rule: Rule) -> Option<Pair<'t>> {
        self.pairs.next_if(|pair| pair.as_rule() == rule)
    }

    fn take_all(&mut self, rule: Rule) -> Vec<Pair<'t>> {
        std::iter::from_fn(|| self.take(rule)).collect()
    }

    fn name(&mut self) -> Name {
        word(&self.next())
    }

    fn text(&mut self) -> Text {
        template::text(&self.next())
    }

    fn rest(self) -> impl Iterator<Item = Pair<'t>> {
        self.pairs
    }
}

/// A name and where it stands.
fn word(pair: &Pair<'_>) -> Name {
    Spanned { value: pair.as_str().to_owned(), span: grammar::extent(pair) }
}
