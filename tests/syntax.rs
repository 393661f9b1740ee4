//! Text to tree: what is taken, and how a mistake is told.

use mach_runtime::diagnostic::Diagnostic;
use machc::syntax::parse::parse;
use machc::syntax::tree::*;

const TRUNNION: &str = include_str!("syntax/trunnion.mach");

const CONTROLLER: &str = include_str!("syntax/controller.mach");

fn errors(text: &str) -> Vec<Diagnostic> {
    parse("t.mach", text).expect_err("the text should be refused")
}

#[test]
fn the_trunnion_is_taken() {
    let file = parse("t.mach", TRUNNION).unwrap_or_else(|errors| panic!("{errors:#?}"));
    assert_eq!(file.body.statements.len(), 2);
    let Item::Machine(machine) = &file.body.statements[1].node else { panic!("a machine") };
    assert_eq!(machine.name.value, "tmv710a");
    assert_eq!(machine.body.statements.len(), 14);
    assert_eq!(machine.body.statements[0].trivia.behind.as_deref(), Some("rotary centre below program zero"));
    let MachineStatement::Chain(links) = &machine.body.statements[1].node else { panic!("a chain") };
    assert_eq!(links.len(), 8);
}

#[test]
fn the_controller_is_taken() {
    let file = parse("t.mach", CONTROLLER).unwrap_or_else(|errors| panic!("{errors:#?}"));
    let Item::Controller(controller) = &file.body.statements[0].node else { panic!("a controller") };
    assert_eq!(controller.body.statements.len(), 20);
}

/// Code, line and column of every error.
fn found(text: &str) -> Vec<(&'static str, u64, u64)> {
    errors(text).iter().map(|e| (e.code.id, e.labels[0].place.line, e.labels[0].place.column)).collect()
}

fn in_machine(statements: &str) -> String {
    format!("machine m {{\n{statements}\n}}\n")
}

fn replacement(text: &str) -> Option<String> {
    errors(text).swap_remove(0).suggestion.map(|suggestion| suggestion.replacement)
}

#[test]
fn every_mistake_of_a_file_is_told_at_its_own_place() {
    let text = in_machine(
        "liner X along +x\nlinear Y alogn +y\nlinear Z along +z travel -450 . 60 rapid 36 m/min\n\
         let a = (1, 2)\nbranch { start leest |C| }\nrotary A about +x travel 0 .. 1 degre\n\
         controller s {\n on rapids { \"G0\" }\n on feed { \"G1 {axes\" \"}\" }\n}",
    );
    assert_eq!(
        found(&text),
        [
            ("E0108", 2, 1),
            ("E0107", 3, 10),
            ("E0107", 4, 31),
            ("E0111", 5, 9),
            ("E0107", 6, 16),
            ("E0109", 7, 33),
            ("E0110", 9, 5),
            ("E0107", 10, 21),
            ("E0107", 10, 24),
        ]
    );
}

#[test]
fn a_misspelt_word_is_corrected() {
    for (text, meant) in [
        (in_machine("liner X along +x"), "linear"),
        (in_machine("linear X alogn +x"), "along"),
        (in_machine("linear X along +x rapd 5"), "rapid"),
        (in_machine("branch { start leest |C| }"), "least"),
        (in_machine("records unknown eror"), "error"),
        (in_machine("tolerance axsi 1"), "axis"),
        (in_machine("let a = 5 degrees"), "deg"),
        (in_machine("let a = 5°"), "deg"),
        (in_machine("let a = 5 inch"), "in"),
        ("machin m { }".to_owned(), "machine"),
        ("controller c { on spindel off { } }".to_owned(), "spindle off"),
        ("controller c { on rapid { bre \"%\" } }".to_owned(), "bare"),
        ("controller c { units mn }".to_owned(), "mm"),
    ] {
        assert_eq!(replacement(&text).as_deref(), Some(meant), "{text}: {:#?}", errors(&text));
    }
}
