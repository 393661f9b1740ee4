//! Tree to text and back.

use machc::syntax::parse::parse;
use machc::syntax::print::print;
use machc::syntax::tree::File;

fn parsed(text: &str) -> File {
    parse("t.mach", text).unwrap_or_else(|errors| panic!("{text}\n{errors:#?}"))
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
