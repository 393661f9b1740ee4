//! Bad CL data: each a diagnostic with line and column, never a panic.

use crate::read::{read, read_with};
use mach_runtime::cl::ReaderOptions;
use mach_runtime::machine::Strictness;

/// The code, line and column of each diagnostic.
fn found(text: impl AsRef<[u8]>) -> Vec<(&'static str, u64, u64)> {
    let place = |diagnostic: &mach_runtime::diagnostic::Diagnostic| {
        let place = &diagnostic.labels[0].place;
        assert!(place.excerpt.is_char_boundary(place.start) && place.excerpt.is_char_boundary(place.end));
        (diagnostic.code.id, place.line, place.column)
    };
    read(text).diagnostics.iter().map(place).collect()
}

#[test]
fn each_mistake_is_told_at_its_place() {
    for (text, expected) in [
        ("GOTO/1,2", ("E1012", 3, 9)),
        ("GOTO/1,2,3,0,0", ("E1012", 3, 15)),
        ("GOTO", ("E1012", 3, 5)),
        ("GOTO/1,2,x", ("E1013", 3, 10)),
        ("GOTO/1,,3", ("E1013", 3, 8)),
        ("GOTO/1,2,3 4", ("E1013", 3, 10)),
        ("GOTO/1,2,nan", ("E1013", 3, 10)),
        ("GOTO/1,2,inf", ("E1013", 3, 10)),
        ("GOTO/1,2,1e999", ("E1013", 3, 10)),
        ("GOTO/1,2000000,3", ("E1015", 3, 8)),
        ("GOTO/1,2,3,0.0,0.0,0.0", ("E1016", 3, 12)),
        ("GOTO/1,2, $\n3,0,x,1", ("E1013", 4, 5)),
        ("GOTP/1,2,3", ("E1010", 3, 1)),
        ("CIRCLE/0,0,0,0,0,1", ("E1012", 3, 19)),
        ("CIRCLE/0,0,0,0,0,1,10", ("E1012", 3, 22)),
        ("CIRCLE/0,0,0,0,0,0,10,0,0,0,0", ("E1016", 3, 14)),
        ("CIRCLE/0,0,0,0,0,1,0,0,0,0,0", ("E1015", 3, 20)),
        ("CIRCLE/0,0,0,0,0,1,10,0,0,0,0,TIMES,0", ("E1015", 3, 37)),
        ("CIRCLE/0,0,0,0,0,1,10,0,0,0,0\nGOTO/9,0,0", ("E1020", 4, 6)),
        ("CIRCLE/0,0,0,0,0,1,10,0,0,0,0\nGOTO/0,10,0,0,1,0", ("E1023", 4, 6)),
        ("CIRCLE/0,0,0,0,0,1,10,0,0,0,0\nSTOP", ("E1021", 3, 1)),
        ("CIRCLE/0,0,0,0,0,1,10,0,0,0,0", ("E1021", 3, 1)),
        ("MSYS/0,0,0,1,0,0,2,0,0", ("E1030", 3, 6)),
        ("MSYS/0,0,0,1,0,0,2,0", ("E1012", 3, 21)),
        ("FEDRAT/0,MMPM", ("E1015", 3, 8)),
        ("FEDRAT/100,MPMM", ("E1014", 3, 12)),
        ("FEDRAT/INVERS,3", ("E1014", 3, 8)),
        ("FEDRAT/IPM,3", ("W1003", 3, 8)),
        ("SPINDL/RPM,CLW", ("E1012", 3, 15)),
        ("SPINDL/SFM,100", ("E1014", 3, 8)),
        ("COOLNT/FLOD", ("E1014", 3, 8)),
        ("LOAD/TOOL", ("E1012", 3, 10)),
        ("LOAD/TOOL,1.5", ("E1015", 3, 11)),
        ("UNITS/CM", ("E1014", 3, 7)),
        ("UNITS/INCHES", ("W1004", 3, 7)),
        ("FINI\nGOTO/1,2,3", ("E1007", 4, 1)),
        ("FINI\nFROM/1,2,3\nGOTO/1,2,3", ("E1007", 4, 1)),
        ("DELAY/10,REV", ("E1014", 3, 10)),
        ("CYCLE/DRILL,RAPTO,3", ("E1011", 3, 1)),
        ("CUTCOM/LEFT", ("E1011", 3, 1)),
        ("NURBS/", ("E1011", 3, 1)),
        ("SET/MODE,INCR", ("E1011", 3, 1)),
        ("GOHOME", ("E1012", 3, 7)),
        ("TOOL PATH/A,TOOL,B", ("E1004", 3, 1)),
        ("GOTO/1,2, $", ("E1003", 3, 11)),
        ("GOTO/1,2,3,0,0,2", ("W1002", 3, 12)),
        ("INSERT G05 P1", ("W1005", 3, 1)),
        ("LINTOL/0.01\nLINTOL/0.02", ("W1011", 3, 8)),
        ("MULTAX/OFF", ("W1011", 3, 8)),
        ("SELECT/TOOL,3", ("W1011", 3, 8)),
        ("MODE/MILL", ("W1011", 3, 6)),
        ("SET/MODE,MILL", ("W1011", 3, 5)),
        ("MODE/TURN", ("E1011", 3, 1)),
    ] {
        let before = "FEDRAT/9\nGOTO/10.0,0.0,0.0\n";
        assert_eq!(found(format!("{before}{text}\n")), [expected], "{text}");
        assert_eq!(found(format!("{before}{text}")), [expected], "{text} without a line end");
    }
}

#[test]
fn a_record_that_asks_for_nothing_is_not_told() {
    assert_eq!(found("FEDRAT/9\nLINTOL/OFF\nMULTAX/ON\nMULTAX\nSET/MODE,ABSOL\nGOTO/1,2,3\n"), []);
}

#[test]
fn an_arc_without_a_beginning() {
    assert_eq!(found("FEDRAT/9\nCIRCLE/0,0,0,0,0,1,10,0,0,0,0\nGOTO/9,0,0"), [("E1021", 2, 1)]);
    assert_eq!(found("FEDRAT/9\nGODLTA/1,0,0\nGOTO/9,0,0"), [("E1021", 2, 1)]);
}

#[test]
fn all_errors_of_a_file_are_told() {
    assert_eq!(found("GOTP/1\nFEDRAT/x\nGOTO/1\n"), [("E1010", 1, 1), ("E1013", 2, 8), ("E1012", 3, 7)]);
}

#[test]
fn the_likely_word_is_suggested() {
    let read = read("RAPID\nGOTO/0,0,0\nFEDART/10\nCOOLNT/FLOD\n");
    let replacements = read.diagnostics.iter().map(|found| found.suggestion.as_ref().unwrap().replacement.as_str());
    assert_eq!(replacements.collect::<Vec<_>>(), ["FEDRAT", "FLOOD"]);
}

#[test]
fn a_file_without_motion() {
    assert_eq!(found(""), [("E1005", 1, 1)]);
    assert_eq!(read("\n\n$$ nothing\nFEDRAT/9\n").codes(), ["E1005"]);
}

#[test]
fn a_binary_file_is_refused_at_once() {
    assert_eq!(found(b"GOTO/1,2,3\nPK\x03\x04\x00\x00\nmore\x00\n"), [("E1001", 2, 3)]);
    assert_eq!(found(b"\xff\xfeG\x00O\x00T\x00O\x00"), [("E1001", 1, 4)]);
    let noise: Vec<u8> = (0..3_000_000_u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    assert_eq!(read(noise).codes(), ["E1001"]);
}

#[test]
fn a_line_of_ten_megabytes() {
    let mut text = b"FEDRAT/9\nGOTO/1,2,3\nGOTO/1".to_vec();
    text.resize(10_000_000, b'1');
    assert_eq!(found(&text), [("E1002", 3, 1)]);
    text.extend(b"\nGOTO/1,2\n");
    assert_eq!(found(&text), [("E1002", 3, 1), ("E1012", 4, 9)]);
}

#[test]
fn a_record_of_too_many_lines() {
    let text = format!("RAPID\nGOTO/1,2,3\nGOTO/{}", "1, $\n".repeat(20_000));
    assert_eq!(found(text)[0].0, "E1002");
}

#[test]
fn errors_come_to_an_end() {
    let codes = read("GOTO/1\n".repeat(1000)).codes();
    assert_eq!(codes.len(), 21);
    assert_eq!(codes[20], "E1006");
}

#[test]
fn warnings_come_to_an_end() {
    let text: String = (0..1000).map(|n| format!("W{n}/1\n")).collect();
    let warn = ReaderOptions { unknown_records: Strictness::Warn, ..ReaderOptions::default() };
    let codes = read_with(format!("RAPID\nGOTO/1,2,3\n{text}"), warn).codes();
    assert_eq!(codes.len(), 21);
    assert_eq!(codes[20], "W1006");
}

#[test]
fn a_file_cut_anywhere_never_panics_and_never_passes() {
    let text = "TOOL PATH/ÄRA,TOOL,B\nMSYS/0,0,0,1,0,0,0,1,0\nFEDRAT/MMPM,9.\nGOTO/0.0,10.0,5.0, $\n0.0,0.0,1.0\n\
                CIRCLE/0.0,0.0,5.0,0.0,0.0,1.0,10.0,0.06,0.5,10.0,0.0,TIMES,2\nGOTO/10.0,0.0,5.0\nEND-OF-PATH\n";
    for length in 0..text.len() - 1 {
        let read = read(&text.as_bytes()[..length]);
        assert!(read.codes().iter().any(|code| code.starts_with('E')), "{length}");
    }
    assert!(read(text).diagnostics.is_empty());
}

#[test]
fn damaged_bytes_never_panic() {
    let text = "TOOL PATH/A,TOOL,B\nGOTO/0.0,10.0,5.0, $ \n0.0,0.0,1.0\nCIRCLE/0,0,5,0,0,1,10.,0.06,0.5,10.,0.\nGOTO/10,0,5\n\
                SPINDL/RPM,800,CLW\nLOAD/TOOL,1,ADJUST,2\nPPRINT a/b\nEND-OF-PATH\n";
    for at in 0..text.len() {
        for byte in [0, b'\n', b',', b'/', b'$', b'-', b'9', b'E', 0xc4, 0xff] {
            let mut bytes = text.as_bytes().to_vec();
            bytes[at] = byte;
            read(bytes);
        }
    }
}
