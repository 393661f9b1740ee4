//! Whatever is wrong with a text, there is a tree of what was understood.

use std::fs;
use std::path::PathBuf;

use machc::syntax::parse::{Parsed, parse};
use machc::syntax::tree::{Body, ControllerStatement, File, Item, MachineStatement, Span};
use proptest::prelude::*;
use proptest::sample::{Index, select};

/// The shipped files, by their names.
fn shipped() -> Vec<(String, String)> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let folders = ["machines", "machines/controllers", "src/cli/families"];
    let paths = folders.iter().flat_map(|folder| fs::read_dir(root.join(folder)).expect("the folder is there"));
    let paths = paths.map(|entry| entry.expect("readable").path());
    let mut files: Vec<(String, String)> = paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "mach"))
        .map(|path| (path.display().to_string(), fs::read_to_string(path).expect("readable")))
        .collect();
    files.sort();
    files
}

/// Where a body has its statements, and where something broken.
struct Extent {
    statements: Vec<Span>,
    broken: Vec<Span>,
}

fn extent<T>(body: &Body<T>) -> Extent {
    Extent {
        statements: body.statements.iter().map(|stated| stated.span.clone()).collect(),
        broken: body.broken.iter().map(|broken| broken.span.clone()).collect(),
    }
}

/// The bodies of a file, each before those in it.
fn bodies(file: &File) -> Vec<Extent> {
    let inside = |item: &Item| match item {
        Item::Use(_) => Vec::new(),
        Item::Machine(definition) => in_machine(&definition.body),
        Item::Controller(definition) => in_controller(&definition.body),
    };
    let items = file.body.statements.iter().flat_map(|stated| inside(&stated.node));
    std::iter::once(extent(&file.body)).chain(items).collect()
}

fn in_machine(body: &Body<MachineStatement>) -> Vec<Extent> {
    let inside = |statement: &MachineStatement| match statement {
        MachineStatement::Branch(body) => vec![extent(body)],
        MachineStatement::Dh(body) => vec![extent(body)],
        MachineStatement::ErrorTable { rows, .. } => vec![extent(rows)],
        MachineStatement::Controller { body, .. } => in_controller(body),
        _ => Vec::new(),
    };
    std::iter::once(extent(body)).chain(body.statements.iter().flat_map(|stated| inside(&stated.node))).collect()
}

fn in_controller(body: &Body<ControllerStatement>) -> Vec<Extent> {
    let inside = |statement: &ControllerStatement| match statement {
        ControllerStatement::On { body, .. } => Some(extent(body)),
        _ => None,
    };
    std::iter::once(extent(body)).chain(body.statements.iter().filter_map(|stated| inside(&stated.node))).collect()
}

#[test]
fn the_tree_of_a_shipped_file_has_no_errors() {
    let files = shipped();
    assert!(files.len() > 40, "{} files", files.len());
    for (name, text) in files {
        let Parsed { tree, diagnostics } = parse(&name, &text);
        assert!(diagnostics.is_empty(), "{name}: {diagnostics:#?}");
        assert!(bodies(&tree).iter().all(|body| body.broken.is_empty()), "{name}");
    }
}

/// What every tree is: the statements of a body and what is broken between them stand one behind the other, in the text;
/// and nothing is left out in silence.
fn check(text: &str) -> Result<(), TestCaseError> {
    let Parsed { tree, diagnostics } = parse("t.mach", text);
    let bodies = bodies(&tree);
    for Extent { statements, broken } in &bodies {
        let mut spans: Vec<&Span> = statements.iter().chain(broken).collect();
        spans.sort_by_key(|span| (span.start, span.end));
        prop_assert!(spans.windows(2).all(|pair| pair[0].end <= pair[1].start), "{:?}\n{}", spans, text);
        prop_assert!(spans.iter().all(|span| text.get((*span).clone()).is_some()), "{:?}\n{}", spans, text);
    }
    let is_whole = bodies.iter().all(|body| body.broken.is_empty());
    prop_assert!(is_whole || !diagnostics.is_empty(), "something is left out in silence:\n{}", text);
    let lines: Vec<_> = diagnostics.iter().map(|it| (it.labels[0].place.line, it.labels[0].place.column)).collect();
    prop_assert!(lines.is_sorted() && lines.len() <= 50, "{:?}\n{}", lines, text);
    prop_assert!(diagnostics.iter().all(|diagnostic| diagnostic.code.id.starts_with("E01")), "{:#?}", diagnostics);
    Ok(())
}

/// Something in the place of a part of a text.
#[derive(Debug, Clone)]
enum Change {
    /// Nothing any more from here on.
    Cut,
    /// Other characters instead of up to so many.
    Replace(usize, String),
    /// A part of the same text instead of up to so many characters.
    Move(usize, Index, usize),
}

fn change() -> impl Strategy<Value = Change> {
    let characters = "[-{}()\"'/\\\\|=.,:a-zA-Z0-9 \n\r\t\u{7}°€$]{0,6}";
    prop_oneof![
        1 => Just(Change::Cut),
        4 => (0..8_usize, characters).prop_map(|(count, text)| Change::Replace(count, text)),
        2 => (0..80_usize, any::<Index>(), 0..80_usize).prop_map(|(count, from, length)| Change::Move(count, from, length)),
    ]
}

fn changed(text: &str, at: Index, change: &Change) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    let at = at.index(characters.len() + 1);
    let end = |start: usize, count: usize| (start + count).min(characters.len());
    match change {
        Change::Cut => characters.truncate(at),
        Change::Replace(count, text) => drop(characters.splice(at..end(at, *count), text.chars())),
        Change::Move(count, from, length) => {
            let from = from.index(characters.len() + 1);
            let moved = characters[from..end(from, *length)].to_vec();
            drop(characters.splice(at..end(at, *count), moved));
        }
    }
    characters.into_iter().collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2048, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_file_that_is_cut_and_changed_has_a_tree(file in select(shipped()),
                                                 changes in prop::collection::vec((any::<Index>(), change()), 1..4)) {
        let changed = changes.iter().fold(file.1, |text, (at, change)| changed(&text, *at, change));
        check(&changed)?;
    }

    #[test]
    fn any_text_has_a_tree(text in "(\\PC|[-{}()\"'/\\\\|=.,: \n\r\t\u{0}\u{7}]|machine|on|branch|linear){0,200}") {
        check(&text)?;
    }
}

#[test]
fn what_is_no_text_has_a_tree_of_nothing() {
    for text in
        ["", "\u{feff}", "\n", "PK\u{3}\u{4}\u{0}\u{0}", "\u{7f}ELF\u{2}", "{", "}", "\"", "//", "\\", "{\"", "}{"]
    {
        check(text).unwrap_or_else(|error| panic!("{text:?}: {error}"));
    }
    let nested = ["{", "(", "{(", "\n  {", "on {", "let a = (", "{}\n", "}"].map(|part| part.repeat(20_000));
    nested.iter().for_each(|text| check(text).unwrap_or_else(|error| panic!("{error}")));
}
