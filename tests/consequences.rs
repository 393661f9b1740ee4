//! A syntax error hides nothing, and nothing is told that only follows from it.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::PathBuf;

use mach_command::render::plain;
use mach_runtime::diagnostic::Diagnostic;
use machc::compile::compile;
use machc::sources::Sources;

/// Files by their names.
#[derive(Debug, Clone)]
struct Texts(BTreeMap<String, String>);

impl Sources for Texts {
    fn read(&self, path: &str) -> Result<String, String> {
        self.0.get(path).cloned().ok_or_else(|| "no such file".to_owned())
    }
}

impl Texts {
    fn with(&self, file: &str, text: String) -> Self {
        let mut texts = self.clone();
        texts.0.insert(file.to_owned(), text);
        texts
    }

    fn compiled(&self, entry: &str) -> Vec<Diagnostic> {
        compile(entry, self).map_or_else(|diagnostics| diagnostics, |compiled| compiled.warnings)
    }
}

/// The shipped machines and controllers.
fn shipped() -> Texts {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let mut texts = BTreeMap::new();
    for folder in ["machines", "machines/controllers"] {
        for entry in fs::read_dir(root.join(folder)).expect("the folder is there") {
            let path = entry.expect("readable").path();
            if path.extension().is_some_and(|extension| extension == "mach") {
                let name = format!("{folder}/{}", path.file_name().expect("a name").to_string_lossy());
                texts.insert(name, fs::read_to_string(path).expect("readable"));
            }
        }
    }
    Texts(texts)
}

/// A text's words, numbers, quoted texts and signs; not its comments.
fn tokens(text: &str) -> Vec<Range<usize>> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let is_in_word = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '.');
        let length = match first {
            '"' => rest[1..].find('"').expect("closed") + 2,
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            c if is_in_word(c) => rest.find(|c| !is_in_word(c)).unwrap_or(rest.len()),
            c => c.len_utf8(),
        };
        if !first.is_whitespace() && !rest.starts_with("//") {
            tokens.push(at..at + length);
        }
        at += length;
    }
    tokens
}

/// How many there are of [`mistaken`].
const MISTAKES: usize = 10;

/// The text with one slip of the pen at a token.
fn mistaken(text: &str, token: &Range<usize>, mistake: usize) -> String {
    let (before, said, behind) = (&text[..token.start], &text[token.clone()], &text[token.end..]);
    let middle = said.len() / 2;
    match mistake {
        0 => format!("{before}{behind}"),
        1 => format!("{before}${said}{behind}"),
        2 => format!("{before}{said} ${behind}"),
        3 => format!("{before}{}{behind}", &said[1..]),
        4 => format!("{before}{}{behind}", &said[..said.len() - 1]),
        5 => format!("{before}{}q{}{behind}", &said[..middle], &said[middle..]),
        6 => format!("{before}{said}\u{7}{behind}"),
        7 => format!("{before}{{{said}{behind}"),
        8 => format!("{before}{said}}}{behind}"),
        _ => format!("{before}{said}"),
    }
}

fn is_of_the_syntax(diagnostic: &Diagnostic) -> bool {
    diagnostic.code.id.starts_with("E01")
}

/// A file that was right, with one slip: what follows from that is not told.
fn check(texts: &Texts, entry: &str, file: &str, token: &Range<usize>, mistake: usize) -> Result<bool, String> {
    let text = mistaken(&texts.0[file], token, mistake);
    let found = texts.with(file, text.clone()).compiled(entry);
    if !found.iter().any(is_of_the_syntax) {
        return Ok(false);
    }
    let line = text.lines().nth(texts.0[file][..token.start].matches('\n').count()).unwrap_or_default();
    match found.iter().find(|diagnostic| !is_of_the_syntax(diagnostic)) {
        Some(_) => Err(format!("{file}, mistake {mistake}: {line}\n{}", plain(&found))),
        None => Ok(true),
    }
}

/// The files that a machine is put together from.
fn files_of(texts: &Texts, entry: &str) -> Vec<String> {
    let used = texts.0.keys().filter(|name| texts.0[entry].contains(name.trim_start_matches("machines/")));
    std::iter::once(entry.to_owned()).chain(used.cloned()).collect()
}

#[test]
fn nothing_that_follows_from_a_slip_is_told_of_it() {
    let texts = shipped();
    let mut told = 0;
    let mut wrong = Vec::new();
    for entry in ["machines/tmv710a_measured.mach", "machines/dmu50ev_dh.mach", "machines/bridge6_quill.mach"] {
        for file in files_of(&texts, entry) {
            for token in tokens(&texts.0[&file]) {
                for mistake in 0..MISTAKES {
                    match check(&texts, entry, &file, &token, mistake) {
                        Ok(is_told) => told += usize::from(is_told),
                        Err(error) => wrong.push(error),
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {told}:\n{}", wrong.len(), wrong.join("\n\n"));
    assert!(told > 5_000, "{told} slips are none");
}
