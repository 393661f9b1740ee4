//! Text to tree.
//!
//! A pass over the characters finds comments, texts and braces, and mends what would make nonsense of the rest; the
//! grammar does the rest. What no statement of the grammar takes ends up in a `broken` node, which becomes a
//! diagnostic and is recorded; everything around it is still read.

use mach_runtime::diagnostic::{Code, Diagnostic};
use pest::Parser;

use super::tree::{Body, Broken, Definition, File, Item, Name, Span, Spanned, Stated, Text, Trivia};
use braces::Unpaired;
use failure::Failures;
use grammar::{MachParser, Pair, Rule};
use trivia::Comments;

pub mod bounds;
mod braces;
mod broken;
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
mod words;

/// Every kind of mistake that the parser finds.
pub static CODES: [&Code; 15] = [
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
    &controller::UNKNOWN_MEANING,
];

/// What a text says, and what is wrong with it.
#[derive(Debug, Clone)]
pub struct Parsed {
    /// Everything that was understood; what was not is recorded where it stands.
    pub tree: File,
    /// What was not understood, in the order of the text (at most [`bounds::MOST_ERRORS`]). Where there are none, the tree
    /// has the whole text.
    pub diagnostics: Vec<Diagnostic>,
}

impl Parsed {
    /// The tree of a text in which nothing is wrong.
    ///
    /// # Errors
    /// Everything that is wrong.
    pub fn whole(self) -> Result<File, Vec<Diagnostic>> {
        if self.diagnostics.is_empty() { Ok(self.tree) } else { Err(self.diagnostics) }
    }
}

/// Parses a file. Whatever the text is, there is a tree.
pub fn parse(file_name: &str, text: &str) -> Parsed {
    let scan = match scan::scan(file_name, text) {
        Ok(scan) => scan,
        Err(no_text) => {
            let broken = vec![Broken::anything(0..text.len())];
            let body = Body { statements: Vec::new(), broken, trailing: Vec::new() };
            return Parsed { tree: File { body }, diagnostics: vec![no_text] };
        }
    };
    let mut failures = Failures::new(file_name, text, &scan);
    let mut pairs = MachParser::parse(Rule::file, &scan.text).expect("every text that has been mended is a file");
    let file = pairs.next().expect("a parse of `file` gives one pair");
    let comments = Comments::new(text, scan.comments.clone());
    let mut builder = Builder { failures: &mut failures, comments, unpaired: &scan.unpaired, told: 0..0 };
    let body = builder.body(file, Rule::item, Builder::item);
    Parsed { tree: File { body }, diagnostics: failures.into_errors() }
}

/// Turns the grammar's pairs into the tree.
struct Builder<'a, 't> {
    failures: &'a mut Failures<'t>,
    comments: Comments<'t>,
    unpaired: &'a Unpaired,
    /// What is broken and has been told last, with what goes on with it.
    told: Span,
}

impl<'t> Builder<'_, 't> {
    /// The statements of a body (or of the file). `rule` is what a statement of it is, to explain a broken one;
    /// `build` gives `None` where it has reported an error.
    fn body<T>(&mut self, pair: Pair<'t>, rule: Rule, build: impl Fn(&mut Self, Pair<'t>) -> Option<T>) -> Body<T> {
        let (close, is_complete, is_cut) = (grammar::extent(&pair).end, self.is_complete(&pair), is_cut(&pair));
        let mut body = Body { statements: Vec::new(), broken: Vec::new(), trailing: Vec::new() };
        let mut pairs = grammar::content(pair).into_iter().peekable();
        while let Some(pair) = pairs.next() {
            if is_broken(&pair) {
                let next = pairs.peek().filter(|next| is_broken(next)).map(|next| next.as_span().start());
                self.broken(&pair, rule, next, &mut body);
                continue;
            }
            let span = grammar::extent(&pair);
            match self.with_trivia(pair, &span, &build) {
                (Some(node), trivia) => body.statements.push(Stated { node, span, trivia }),
                (None, _) => body.broken.push(self.refused(rule, span)),
            }
        }
        if is_cut {
            self.cut_off(rule, &mut body);
        }
        body.broken.extend((!is_complete).then(|| Broken::anything(close..close)));
        Body { trailing: self.comments.until(close), ..body }
    }

    /// Whether a body holds what it should, as far as its braces tell.
    fn is_complete(&self, body: &Pair<'t>) -> bool {
        let last = grammar::extent(body).end.saturating_sub(1);
        // A `}` that stands only in the text that is parsed.
        let is_mended = || self.unpaired.missing.iter().any(|gap| gap.contains(&last));
        let is_closed = body.as_rule() == Rule::file || !is_cut(body) && !is_mended();
        is_closed && self.unpaired.is_certain
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

/// Whether a body ends with the text.
fn is_cut(body: &Pair<'_>) -> bool {
    body.as_rule() != Rule::file && body.clone().into_inner().next_back().is_some_and(|end| end.as_rule() == Rule::EOI)
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
