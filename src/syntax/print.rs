//! Tree to text: the one way a `.mach` file is laid out.
//!
//! What is said stays as it was written (digits, parentheses, order, comments, single blank lines); how it stands on
//! the page is decided here.

use super::tree::{Body, Comment, Definition, File, Item, LineTemplate, Name, Stated, Text, Trivia};
use layout::{Page, StatementText};

mod controller;
mod expression;
mod layout;
mod machine;

/// Prints a file in its canonical form. Parsing the result gives the same tree but for its spans.
pub fn print(file: &File) -> String {
    let mut printer = Printer::default();
    printer.body(&file.body, Printer::item);
    printer.page.text()
}

/// Prints statements as lines of the page.
#[derive(Default)]
struct Printer {
    page: Page,
    depth: usize,
}

impl Printer {
    fn body<T>(&mut self, body: &Body<T>, print: impl Fn(&mut Self, &T, Option<&str>)) {
        for Stated { node, trivia, .. } in &body.statements {
            self.comments(&trivia.before);
            if trivia.blank_before {
                self.page.blank();
            }
            print(self, node, trivia.behind.as_deref());
        }
        self.comments(&body.trailing);
    }

    fn comments(&mut self, comments: &[Comment]) {
        for comment in comments {
            if comment.blank_before {
                self.page.blank();
            }
            self.page.comment(self.depth, &comment.text);
        }
    }

    fn line(&mut self, line: StatementText, behind: Option<&str>) {
        self.page.push(self.depth, line, behind);
    }

    /// `HEAD {`, the statements, `}`; on one line where there is nothing inside.
    fn block<T>(
        &mut self,
        head: &str,
        body: &Body<T>,
        behind: Option<&str>,
        print: impl Fn(&mut Self, &T, Option<&str>),
    ) {
        if body.statements.is_empty() && body.trailing.is_empty() {
            return self.line(StatementText::plain(format!("{head} {{ }}")), behind);
        }
        self.line(StatementText::plain(format!("{head} {{")), behind);
        self.depth += 1;
        self.body(body, print);
        self.depth -= 1;
        self.line(StatementText::plain("}"), None);
    }

    /// An `on` block: one line of NC text stands on one line with it.
    fn lines(&mut self, head: &str, body: &Body<LineTemplate>, behind: Option<&str>) {
        match body.statements.as_slice() {
            [only] if only.trivia == Trivia::default() && body.trailing.is_empty() => {
                let template = controller::template(&only.node);
                self.line(StatementText::plain(format!("{head} {{ {template} }}")), behind);
            }
            _ => self.block(head, body, behind, |printer, template, behind| {
                printer.line(StatementText::plain(controller::template(template)), behind);
            }),
        }
    }

    fn item(&mut self, item: &Item, behind: Option<&str>) {
        match item {
            Item::Use(path) => self.line(StatementText::plain(format!("use {}", quoted(path))), behind),
            Item::Machine(machine) => {
                self.block(&head("machine", machine), &machine.body, behind, Self::machine_statement);
            }
            Item::Controller(controller) => {
                self.block(&head("controller", controller), &controller.body, behind, Self::controller_statement);
            }
        }
    }
}

fn head<T>(keyword: &str, definition: &Definition<T>) -> String {
    let Definition { name: Name { value: name, .. }, like, title, .. } = definition;
    let like = like.as_ref().map_or(String::new(), |like| format!(" like {}", like.value));
    let title = title.as_ref().map_or(String::new(), |title| format!(" {}", quoted(title)));
    format!("{keyword} {name}{like}{title}")
}

/// A text with its quotes and escapes.
fn quoted(text: &Text) -> String {
    format!("\"{}\"", escaped(&text.value))
}

fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"")
}
