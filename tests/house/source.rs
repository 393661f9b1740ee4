//! One source file: the paths that it names, with its `use` lines looked through.

use std::collections::BTreeMap;

/// A path, segment by segment.
pub(crate) type Segments = Vec<String>;

/// What a file names.
#[derive(Debug, Default)]
pub(crate) struct Source {
    /// Every path with more than one segment, as it is written or as its `use` line completes it.
    pub(crate) paths: Vec<Segments>,
    /// What it hands on (`pub use`), by the name under which it does.
    pub(crate) hands_on: BTreeMap<String, Segments>,
}

impl Source {
    /// Reads a file's text; tests within the file, which stand at its end, are left out.
    pub(crate) fn read(text: &str) -> Self {
        let tokens = tokens(text.split("#[cfg(test)]").next().unwrap_or(text));
        let (mut source, mut names, mut at) = (Self::default(), BTreeMap::new(), 0);
        while at < tokens.len() {
            match tokens[at].as_str() {
                "use" => {
                    let is_public = is_public(&tokens[..at]);
                    let mut uses = Vec::new();
                    at = tree(&tokens, at + 1, &[], &mut uses);
                    for (name, path) in uses {
                        source.hands_on.extend(is_public.then(|| (name.clone(), path.clone())));
                        source.paths.push(path.clone());
                        names.insert(name, path);
                    }
                }
                token if is_name(token) && tokens.get(at + 1).is_some_and(|next| next == "::") => {
                    let (path, end) = path(&tokens, at);
                    source.paths.extend((path.len() > 1).then_some(path));
                    at = end;
                }
                _ => at += 1,
            }
        }
        for path in &mut source.paths {
            if let Some(known) = names.get(&path[0]).filter(|known| known.len() > 1) {
                path.splice(..1, known.iter().cloned());
            }
        }
        source
    }
}

/// Whether `pub` or `pub(…)` stands last.
fn is_public(before: &[String]) -> bool {
    let closed = before.last().is_some_and(|token| token == ")");
    let open = if closed { before.iter().rposition(|token| token == "(").unwrap_or(0) } else { before.len() };
    open.checked_sub(1).is_some_and(|at| before[at] == "pub")
}

/// A tree of a `use` line from a token on: its names with their paths. Says where it ends.
fn tree(tokens: &[String], mut at: usize, prefix: &[String], uses: &mut Vec<(String, Segments)>) -> usize {
    let mut path = prefix.to_vec();
    while at < tokens.len() {
        match tokens[at].as_str() {
            "::" => at += 1,
            "{" => {
                at += 1;
                while tokens[at] != "}" {
                    at = tree(tokens, at, &path, uses);
                    at += usize::from(tokens[at] == ",");
                }
                return at + 1;
            }
            "as" => {
                uses.push((tokens[at + 1].clone(), path));
                return at + 2;
            }
            "self" if !prefix.is_empty() => at += 1,
            "*" => at += 1,
            token if is_name(token) => {
                path.push(token.to_owned());
                at += 1;
            }
            _ => break,
        }
    }
    uses.extend(path.last().cloned().map(|name| (name, path)));
    at
}

/// The path that begins at a token, and where it ends.
fn path(tokens: &[String], mut at: usize) -> (Segments, usize) {
    let mut path = vec![tokens[at].clone()];
    while tokens.get(at + 1).is_some_and(|token| token == "::")
        && tokens.get(at + 2).is_some_and(|token| is_name(token))
    {
        path.push(tokens[at + 2].clone());
        at += 2;
    }
    (path, at + 1)
}

fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Names, `::`, and all other characters one by one; comments, texts and characters in quotes are left out.
fn tokens(text: &str) -> Vec<String> {
    let (mut tokens, mut rest) = (Vec::new(), text);
    while let Some(first) = rest.chars().next() {
        let length = match first {
            _ if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            'r' if rest[1..].trim_start_matches('#').starts_with('"') => raw_text_end(rest),
            '"' => quoted_end(rest, '"'),
            '\'' if rest[1..].starts_with('\\') || rest.chars().nth(2) == Some('\'') => quoted_end(rest, '\''),
            _ if rest.starts_with("::") => token(&mut tokens, &rest[..2]),
            c if c.is_alphanumeric() || c == '_' => {
                let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
                token(&mut tokens, &rest[..end])
            }
            c if c.is_whitespace() => c.len_utf8(),
            c => token(&mut tokens, &rest[..c.len_utf8()]),
        };
        rest = &rest[length..];
    }
    tokens
}

fn token(tokens: &mut Vec<String>, token: &str) -> usize {
    tokens.push(token.to_owned());
    token.len()
}

/// Behind the closing quote.
fn quoted_end(text: &str, quote: char) -> usize {
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if is_escaped => is_escaped = false,
            '\\' => is_escaped = true,
            c if c == quote => return at + c.len_utf8(),
            _ => {}
        }
    }
    text.len()
}

/// Behind the end of `r#"…"#`.
fn raw_text_end(text: &str) -> usize {
    let hashes = text[1..].len() - text[1..].trim_start_matches('#').len();
    let close = format!("\"{}", "#".repeat(hashes));
    let body = hashes + 2;
    text[body..].find(&close).map_or(text.len(), |at| body + at + close.len())
}

#[test]
fn paths_are_read_as_they_are_meant() {
    let text = r##"
        //! use not::this;
        use std::fs;
        use crate::a::{self, b::{C, d as e}, F};
        pub(crate) use super::g::H;
        fn i<'a>(text: &'a str) -> C { fs::read("x::y"); e::j('"', '\''); a::k(r#"l::"m"#); crate::n::o() }
        #[cfg(test)]
        mod tests { use p::q; }
    "##;
    let source = Source::read(text);
    let mut paths: Vec<String> = source.paths.iter().map(|path| path.join("::")).collect();
    paths.sort();
    let expected = [
        "crate::a",
        "crate::a::F",
        "crate::a::b::C",
        "crate::a::b::d",
        "crate::a::b::d::j",
        "crate::a::k",
        "crate::n::o",
        "std::fs",
        "std::fs::read",
        "super::g::H",
    ];
    assert_eq!(paths, expected);
    assert_eq!(source.hands_on.keys().collect::<Vec<_>>(), ["H"]);
}
