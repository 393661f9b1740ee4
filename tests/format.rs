//! Tree to text and back.

use machc::syntax::parse::parse;
use machc::syntax::print::print;
use machc::syntax::tree::File;
use proptest::prelude::*;

#[path = "format/generator.rs"]
mod generator;

fn parsed(text: &str) -> File {
    parse("t.mach", text).whole().unwrap_or_else(|errors| panic!("{text}\n{errors:#?}"))
}

fn assert_printed(source: &str, expected: &str) {
    assert_eq!(print(&parsed(source)), expected);
    assert_eq!(print(&parsed(expected)), expected, "the canonical form stays as it is");
}

#[test]
fn a_machine_reads_like_a_data_sheet() {
    assert_printed(include_str!("syntax/trunnion.mach"), include_str!("format/trunnion.mach"));
}

#[test]
fn a_controller_reads_like_a_table() {
    assert_printed(include_str!("syntax/controller.mach"), include_str!("format/controller.mach"));
}

/// The tree without its spans.
fn shape(file: &File) -> String {
    let debug = format!("{file:#?}");
    let mut shape = String::new();
    let mut rest = debug.as_str();
    while let Some(dots) = rest.find("..") {
        let (before, after) = (&rest[..dots], &rest[dots + 2..]);
        shape.push_str(before.trim_end_matches(|c: char| c.is_ascii_digit()));
        shape.push_str("..");
        rest = after.trim_start_matches(|c: char| c.is_ascii_digit());
    }
    shape + rest
}

#[test]
fn comments_and_blank_lines_stay_with_their_statements() {
    let text = "\
// A licence.

// The machine.
machine m {  // behind the brace

    // before

    let a = 1  // behind
    // after a

    branch {
        // only a comment
    }

    let b = 2
    // the last
}
// the end
";
    assert_printed(text, text);
    let loose = "\n\n// A licence.\n\n\n\n//The machine.\nmachine m { // behind the brace\n\n\n  // before\n\nlet // before\n\
                 a=1 // behind\n// after a\n\n\nbranch{\n// only a comment\n}\n\nlet b=2\n// the last\n\n}// the end\n\n";
    let printed = text.replace("    let a", "    // before\n    let a");
    assert_printed(loose, &printed);
}

#[test]
fn line_ends_and_byte_order_marks_do_not_matter() {
    let text = include_str!("format/trunnion.mach");
    assert_printed(&format!("\u{feff}{}", text.replace('\n', "\r\n")), text);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn parsing_what_was_printed_gives_the_same_tree(file in generator::file()) {
        let text = print(&file);
        let parsed = parse("t.mach", &text).whole();
        let parsed = parsed.map_err(|errors| TestCaseError::fail(format!("{text}\n{errors:#?}")))?;
        prop_assert_eq!(shape(&parsed), shape(&file), "{}", text);
        prop_assert_eq!(print(&parsed), text);
    }

    #[test]
    fn no_text_makes_the_parser_panic(file in generator::file(), cut in any::<[proptest::sample::Index; 2]>(),
                                      inserted in "[-{}()\"'/\\\\|=.,a-zA-Z0-9 \n\r\t°]{0,4}") {
        let mut text: Vec<char> = print(&file).chars().collect();
        let mut cut = cut.map(|cut| cut.index(text.len() + 1));
        cut.sort_unstable();
        text.splice(cut[0]..cut[1].min(cut[0] + 5), inserted.chars());
        let text: String = text.into_iter().collect();
        match parse("t.mach", &text).whole() {
            Ok(parsed) => prop_assert_eq!(shape(&parsed), shape(&parse("t.mach", &print(&parsed)).whole().unwrap())),
            Err(errors) => prop_assert!(!errors.is_empty()),
        }
    }
}
