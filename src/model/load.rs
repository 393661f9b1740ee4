//! Reading: the entry file and everything it uses, each once.

use super::lost::Lost;
use super::source::{Located, Location, SourceId, SourceMap};
use crate::diagnostic::{Code, Diagnostic};
use crate::sources::Sources;
use crate::syntax::parse::{Parsed, parse};
use crate::syntax::tree::{File, Item, Text};

/// A file that cannot be read.
pub(crate) static CANNOT_READ: Code = Code {
    id: "E0201",
    title: "a file cannot be read",
    explanation: "\
The machine file, or a file that it names with `use`, is not there or is not text. The path of a `use` is relative to
the file it stands in, with `/` between folders.

    use \"controllers/syntec.mach\"      // next to this file: controllers/syntec.mach
",
};

/// Files that use each other.
pub(crate) static USE_CYCLE: Code = Code {
    id: "E0202",
    title: "files use each other in a circle",
    explanation: "\
A file must not use itself, neither directly nor through the files it uses.

    // a.mach
    use \"b.mach\"
    // b.mach
    use \"a.mach\"

Put what both need into a third file, and let both use that.
",
};

/// How deep `use` may go: deeper is a circle that the paths do not show (a folder linked into itself).
const GREATEST_DEPTH: usize = 64;

/// Every file that belongs to a machine.
#[derive(Default)]
pub(crate) struct Program {
    /// The texts.
    pub(crate) sources: SourceMap,
    /// The trees, by [`SourceId`].
    pub(crate) files: Vec<File>,
    /// What stands beside the items of the files, and the files that cannot be read.
    pub(crate) lost: Lost,
}

impl Program {
    /// Every item of every file, the entry's first.
    pub(crate) fn items(&self) -> impl Iterator<Item = (SourceId, &Item)> {
        let files = self.sources.ids().zip(&self.files);
        files.flat_map(|(id, file)| file.body.statements.iter().map(move |stated| (id, &stated.node)))
    }
}

/// Reads and parses. Mistakes of all files are collected.
pub(crate) fn load(entry: &str, sources: &dyn Sources, diagnostics: &mut Vec<Diagnostic>) -> Program {
    let mut loader = Loader { sources, program: Program::default(), open: Vec::new(), diagnostics };
    loader.file(normal(entry), None);
    loader.program
}

struct Loader<'a> {
    sources: &'a dyn Sources,
    program: Program,
    /// The files between the entry and the one being read.
    open: Vec<String>,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl Loader<'_> {
    fn file(&mut self, path: String, used_at: Option<Location>) {
        if self.open.contains(&path) || self.open.len() > GREATEST_DEPTH {
            return self.report_cycle(&path, used_at);
        }
        if self.program.sources.find(&path).is_some() {
            return;
        }
        match self.sources.read(&path) {
            Ok(text) => self.text(path, text),
            Err(reason) => self.report_unreadable(&path, &reason, used_at),
        }
    }

    fn text(&mut self, path: String, text: String) {
        let Parsed { tree, diagnostics } = parse(&path, &text);
        self.diagnostics.extend(diagnostics);
        let source = self.program.sources.add(path.clone(), text);
        self.program.lost.extend(Lost::of(source, tree.body.broken.iter().cloned()));
        let used: Vec<Located<Text>> = uses(source, &tree);
        self.program.files.push(tree);
        self.open.push(path.clone());
        for Located { value: text, at } in used {
            self.file(beside(&path, &text.value), Some(at));
        }
        self.open.pop();
    }

    fn report_unreadable(&mut self, path: &str, reason: &str, used_at: Option<Location>) {
        if let Some(Location { source, span }) = used_at.clone() {
            self.program.lost.extend(Lost::anything(source, span));
        }
        let diagnostic = Diagnostic::error(&CANNOT_READ, format!("cannot read `{path}`: {reason}"));
        self.diagnostics.push(self.placed(diagnostic, used_at));
    }

    fn report_cycle(&mut self, path: &str, used_at: Option<Location>) {
        let start = self.open.iter().position(|open| open == path).unwrap_or(0);
        let way: Vec<&str> = self.open[start..].iter().map(String::as_str).chain([path]).collect();
        let diagnostic = Diagnostic::error(&USE_CYCLE, format!("`{path}` is used by itself"))
            .note(format!("the circle: {}", way.join(" uses ")));
        self.diagnostics.push(self.placed(diagnostic, used_at));
    }

    fn placed(&self, diagnostic: Diagnostic, at: Option<Location>) -> Diagnostic {
        match at {
            Some(at) => diagnostic.at(self.program.sources.place(&at), "used here"),
            None => diagnostic,
        }
    }
}

fn uses(source: SourceId, file: &File) -> Vec<Located<Text>> {
    let items = file.body.statements.iter().map(|stated| &stated.node);
    let texts = items.filter_map(|item| if let Item::Use(text) = item { Some(text) } else { None });
    texts.map(|text| Located { value: text.clone(), at: Location { source, span: text.span.clone() } }).collect()
}

/// A path relative to the folder of the file that names it.
fn beside(using: &str, path: &str) -> String {
    match using.rfind('/') {
        Some(end) if !path.starts_with('/') => normal(&format!("{}/{path}", &using[..end])),
        _ => normal(path),
    }
}

/// Without `.` and, as far as possible, without `..`: one name for one file.
fn normal(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for (i, part) in path.split('/').enumerate() {
        match (part, parts.last()) {
            ("" | ".", _) if i > 0 || part == "." => {}
            ("..", Some(last)) if !matches!(*last, ".." | "") => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::{beside, normal};

    #[test]
    fn paths_are_relative_to_the_using_file() {
        assert_eq!(beside("machines/a.mach", "controllers/s.mach"), "machines/controllers/s.mach");
        assert_eq!(beside("machines/a.mach", "../b.mach"), "b.mach");
        assert_eq!(beside("a.mach", "./b.mach"), "b.mach");
        assert_eq!(beside("a.mach", "/lib/b.mach"), "/lib/b.mach");
        assert_eq!(beside("../a.mach", "../b.mach"), "../../b.mach");
    }

    #[test]
    fn one_file_has_one_name() {
        assert_eq!(normal("/a//b/../c.mach"), "/a/c.mach");
        assert_eq!(normal("./a/./c.mach"), "a/c.mach");
    }
}
