//! Text to tree: what is taken, and how a mistake is told.

use mach_runtime::diagnostic::Diagnostic;
use machc::syntax::parse::parse;
use machc::syntax::tree::*;

const TRUNNION: &str = include_str!("syntax/trunnion.mach");

const CONTROLLER: &str = include_str!("syntax/controller.mach");

fn errors(text: &str) -> Vec<Diagnostic> {
    parse("t.mach", text).whole().expect_err("the text should be refused")
}

#[test]
fn the_trunnion_is_taken() {
    let file = parse("t.mach", TRUNNION).whole().unwrap_or_else(|errors| panic!("{errors:#?}"));
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
    let file = parse("t.mach", CONTROLLER).whole().unwrap_or_else(|errors| panic!("{errors:#?}"));
    let Item::Controller(controller) = &file.body.statements[0].node else { panic!("a controller") };
    assert_eq!(controller.body.statements.len(), 21);
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
            ("E0108", 3, 10),
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

/// The first error as `code line:column message`.
fn told(text: &str) -> String {
    let first = errors(text).swap_remove(0);
    let place = &first.labels[0].place;
    format!("{} {}:{} {}", first.code.id, place.line, place.column, first.message)
}

#[test]
fn a_message_says_what_was_found_and_what_would_have_fitted() {
    let clauses = "`travel`, `turns`, `rapid`, the next statement or `}`";
    for (statement, message) in [
        ("linear X along +x travel -355 . 355", "E0107 2:31 expected `..`, found `.`".to_owned()),
        ("linear X along +x [1, 2]", format!("E0107 2:19 expected {clauses}, found `[`")),
        ("let tool = 5", "E0107 2:5 expected a name, found `tool`".to_owned()),
        ("let größe = 5", "E0107 2:7 expected `=`, found `öße`".to_owned()),
        ("let a 5", "E0107 2:7 expected `=`, found `5`".to_owned()),
        ("let a =", "E0107 2:8 expected a value, found the end of the line".to_owned()),
        ("let a = (1 + 2", "E0107 2:15 expected `)` or `,`, found the end of the line".to_owned()),
        ("let a = 2 radius", "E0109 2:11 `radius` is not a unit".to_owned()),
        ("chain w c A b", "E0107 2:9 expected an axis, the next statement or `}`, found `c`".to_owned()),
        ("write C 0 .. 360", "E0108 2:1 there is no statement `write` in a machine".to_owned()),
        ("%", "E0108 2:1 a statement cannot begin with `%`".to_owned()),
        ("linear X along +x rapid 1 rapid 2", "E0113 2:27 this has been said of the axis already".to_owned()),
        (
            "rotary C about +z travel 0 .. 1 turns unlimited",
            "E0113 2:33 this has been said of the axis already".to_owned(),
        ),
    ] {
        assert_eq!(told(&in_machine(statement)), message);
    }
}

#[test]
fn the_same_in_tables() {
    for (statement, message) in [
        ("error 5 um", "E0107 2:7 expected the name of an error such as `EX0C`, found `5`"),
        ("error EX0C", "E0107 2:11 expected a value or `{`, found the end of the line"),
        ("error EXX { at 0, 4 um }", "E0107 2:17 expected `:`, found `,`"),
        ("error EXX { at 0: 1 um\n 5: 2 um }", "E0107 2:23 expected `at` or `}`, found the end of the line"),
        ("error EXX { 0: 4 um }", "E0108 2:13 a statement cannot begin with `0`"),
        ("dh { link C: 0, 0, 0, 0 }", "E0114 2:6 a link has five parameters, this has 4"),
        ("dh { link 0, 0, 0, 0, 0, 0 }", "E0114 2:6 a link has five parameters, this has 6"),
        ("dh { lnk C: 0, 0, 0, 0, 0 }", "E0108 2:6 there is no statement `lnk` in a `dh` block"),
    ] {
        assert_eq!(told(&in_machine(statement)), message);
    }
    let rows = "error EXX {\n at 0, 4 um\n at 1: 2\n at = 3\n}\ndh {\n link X: 1\n bed 2\n}";
    assert_eq!(found(&in_machine(rows)), [("E0107", 3, 6), ("E0107", 5, 5), ("E0114", 8, 2), ("E0107", 9, 6)]);
}

#[test]
fn the_same_in_a_controller() {
    for (statement, message) in [
        ("word X Y Z", "E0107 2:11 expected an axis or the name of a format, found the end of the line"),
        ("word x length", "E0107 2:6 expected an axis, found `x`"),
        ("group motions { }", "E0115 2:7 there is no group `motions`"),
        ("group motion { feed \"G1\" }", "E0115 2:16 there is no member of the group `feed`"),
        ("offset \"G54\"", "E0107 2:8 expected a value, found `\"`"),
        ("sequence \"N\" step 5 start 1", "E0107 2:21 expected `greatest` or `}`, found `start`"),
        ("extension nc", "E0107 2:11 expected a text in quotes, found `nc`"),
        ("on rapid { \"G0 {}\" }", "E0107 2:17 expected the name of a placeholder, found `}`"),
        ("on rapid { \"G0 {axes\" }", "E0107 2:21 expected `:` or `}`, found `\"`"),
        ("on rapid { G0 }", "E0108 2:12 there is no statement `G0` in an `on` block"),
        ("on { }", "E0107 2:4 expected an event, found `{`"),
    ] {
        assert_eq!(told(&format!("controller c {{\n{statement}\n}}")), message);
    }
}

#[test]
fn characters_and_braces_are_looked_at_first() {
    for (text, message) in [
        ("use", "E0107 1:4 expected a text in quotes, found the end of the file"),
        ("machine { }", "E0107 1:9 expected a name, found `{`"),
        ("linear X along +x", "E0108 1:1 there is no statement `linear` at the top of a file"),
        ("machine m { } }", "E0105 1:15 this `}` closes nothing"),
        ("use \"abc\nmachine", "E0103 1:5 this text has no closing quote on its line"),
        ("use \"abc\\\n", "E0103 1:5 this text has no closing quote on its line"),
        ("use \"a\\b\"", "E0104 1:7 a backslash stands only before a quote or another backslash"),
        ("// a\u{1b}[0m", "E0102 1:5 the control character U+001B does not belong in a machine file"),
        ("\u{0}\u{1}", "E0102 1:1 the control character U+0000 does not belong in a machine file"),
    ] {
        assert_eq!(told(text), message);
    }
}

#[test]
fn a_brace_without_a_partner_is_looked_for_by_indentation() {
    let block = "    branch {\n        start nearest\n    }\n";
    let rest = "    liner X\n    controller s {\n        on start {\n        }\n    }\n";
    let with = |block: &str| found(&format!("machine m {{\n{block}{rest}}}\n"));
    let unknown = ("E0108", 5, 5);
    assert_eq!(with(block), [unknown]);
    assert_eq!(with(&block.replace("    }\n", "\n")), [("E0105", 2, 12), unknown], "the block is never closed");
    assert_eq!(with(&block.replace("    }", "    } }")), [("E0105", 4, 7), unknown], "closes the machine too early");
    assert_eq!(with(&block.replace("branch {", "branch  ")), [("E0107", 2, 11), unknown], "told where it belongs");
    assert_eq!(found(&format!("machine m\n{block}{rest}}}\n")), [("E0107", 1, 10)], "the rest belongs to it");
    let crowded = "machine m {\nbranch {\nstart nearest\nliner X\nlinear Y along +y\n}\n";
    assert_eq!(found(crowded), [("E0105", 1, 11), ("E0108", 4, 1)], "the indentation does not tell");
    assert_eq!(
        found("machine m {\n    branch {\n        start lea"),
        [("E0105", 1, 11), ("E0105", 2, 12), ("E0107", 3, 15)]
    );
}

#[test]
fn one_mistake_is_told_once() {
    assert_eq!(found(&in_machine("chain w A b X Y Z t\nX along +x")), [("E0108", 3, 1)]);
    assert_eq!(found("machin m {\n linear X along +x\n branch { start nearest }\n}\nuse \"a\"\n"), [("E0108", 1, 1)]);
    let spread = "linear X along +x\n  travel 0 . 1\n  rapid 5\nzero 0";
    assert_eq!(found(&in_machine(spread)), [("E0107", 3, 12)]);
    assert_eq!(found(&in_machine("chain w C $\n  b X Y\n  Z t\nX along +x")), [("E0107", 2, 11), ("E0108", 5, 1)]);
    for characters in ["extension \"nc", "extension nc\"", "extension \"n\\c\"", "ex\u{7}tension \"nc\""] {
        let text = format!("controller c {{\n{characters}\non end {{ \"M30 }}\nlinear X\n}}");
        assert_eq!(found(&text).iter().map(|it| it.1).collect::<Vec<_>>(), [2, 3, 4], "{characters}");
    }
}

#[test]
fn nesting_and_length_have_bounds() {
    let nested = |depth: usize| in_machine(&format!("let a = {}1{}", "(".repeat(depth), ")".repeat(depth)));
    assert!(parse("t.mach", &nested(60)).whole().is_ok());
    assert_eq!(told(&nested(100_000)), "E0106 2:72 more than 64 braces and parentheses are open here");
    assert_eq!(found(&"{".repeat(100_000)), [("E0106", 1, 65)]);
    for repeated in ["-", "1 ^ ", "1 + ", "1, "] {
        let text = in_machine(&format!("let a = f({}1)", repeated.repeat(50_000)));
        assert_eq!(found(&text), [("E0112", 2, 9)], "{repeated}");
    }
    assert_eq!(found(&"\n".repeat(5 << 20)), [("E0101", 1, 1)]);
}

#[test]
fn a_large_file_is_read_and_a_bad_one_given_up() {
    let statements = "let a = 1 mm // one of many\n".repeat(50_000);
    assert!(parse("t.mach", &in_machine(&statements)).whole().is_ok());
    for garbage in ["% ", "liner\n", "\"x\" ", "let a = $\n", "// c\n", "let a = ((((1\n"] {
        let text = in_machine(&format!("%{}", garbage.repeat((1 << 20) / garbage.len())));
        let errors = errors(&text).len();
        assert!((1..=50).contains(&errors), "{garbage}: {errors}");
    }
    let wide = in_machine(&format!("let a = 1{} $", " ".repeat(1 << 20)));
    assert!(errors(&wide)[0].labels[0].place.excerpt.len() < 1000);
}
