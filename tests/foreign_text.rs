//! Names and texts from elsewhere, whatever bytes they have, change no block of a program: they stay in their comments.

use mach_runtime::cl::Reader;
use mach_runtime::rig::{Rig, reader_options};
use machc::plan::Interpreter;
use machc::sources::Sources;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::{Config, TestRng, TestRunner};
use std::fs;
use std::num::NonZeroUsize;

#[path = "common/machine.rs"]
#[allow(dead_code)]
mod machine;
#[path = "common/stems.rs"]
mod stems;

/// A machine file in memory; the controllers are those that come along.
struct Mill(String);

impl Sources for Mill {
    fn read(&self, path: &str) -> Result<String, String> {
        if path == "mill.mach" {
            return Ok(self.0.clone());
        }
        fs::read_to_string(machine::root().join("machines").join(path)).map_err(|error| error.to_string())
    }
}

/// A three-axis mill with every shipped controller.
fn mills() -> Vec<Rig<Interpreter>> {
    let mill = |controller: String| {
        let text = format!(
            "use \"controllers/{controller}.mach\"\nmachine mill {{ chain w b X Y Z t linear X along +x linear Y along +y \
             linear Z along +z travel -500 .. 500 tool along +z controller {controller} {{ }} }}"
        );
        machine::compiled("mill.mach", &Mill(text)).rig().expect("it has a controller")
    };
    stems::stems("machines/controllers", "mach").into_iter().map(mill).collect()
}

/// What a person or another system has given a name to.
#[derive(Debug, Clone)]
struct Foreign {
    program: String,
    operation: Vec<u8>,
    tool: Vec<u8>,
    text: Vec<u8>,
}

/// Bytes, many of which mean something to some control or to CL files.
fn bytes() -> impl Strategy<Value = Vec<u8>> {
    let special = select(b"%%()()[]{}\"\"'`;;:/\\<>=#&*!|,.- \n\r\t\0NGMXOZ019".to_vec());
    vec(prop_oneof![2 => special, 1 => any::<u8>()], 0..40)
}

/// A name in one record of a CL file: without control characters, and without the sign that goes on in the next line.
fn in_a_record() -> impl Strategy<Value = Vec<u8>> {
    bytes().prop_map(|bytes| bytes.into_iter().filter(|byte| *byte >= b' ' && *byte != b'$').collect())
}

fn foreign() -> impl Strategy<Value = Foreign> {
    (bytes(), in_a_record(), in_a_record(), in_a_record()).prop_map(|(program, operation, tool, text)| Foreign {
        program: format!("P{}", String::from_utf8_lossy(&program)),
        operation,
        tool,
        text,
    })
}

/// The program, or what was told instead.
fn posted(rig: &Rig<Interpreter>, foreign: &Foreign) -> Result<String, String> {
    let Foreign { program, operation, tool, text } = foreign;
    let tool_path = [b"TOOL PATH/", &operation[..], b",TOOL,", tool, b"\nLOAD/TOOL,1\nSPINDL/RPM,100,CLW\n"].concat();
    let motions = b"FEDRAT/MMPM,100\nGOTO/0,0,5,0,0,1\nGOTO/0,0,1\nEND-OF-PATH\n";
    let cl = [&tool_path[..], b"PPRINT/", text, b"\n", motions].concat();
    let reader = Reader::new("part.cls", &cl[..], reader_options(&rig.machine));
    let (mut nc, mut told) = (Vec::new(), Vec::new());
    let mut tell = |diagnostic| told.push(diagnostic);
    let certificate = rig.post(("part.cls", program), reader, &mut nc, NonZeroUsize::MIN, &mut tell);
    match certificate.expect("memory can be written to") {
        Some(_) => String::from_utf8(nc).map_err(|error| error.to_string()),
        None => Err(format!("{told:#?}")),
    }
}

/// The program without what stands in comments, in quotes, and as a name in angle brackets.
///
/// # Errors
/// When one of them does not end in its line, or something else than printable ASCII stands in it.
fn blocks(nc: &str, comment: &(String, String)) -> Result<Vec<String>, String> {
    nc.lines().map(|line| block(line, comment).ok_or_else(|| format!("not clean: {line:?}"))).collect()
}

fn block(line: &str, (open, close): &(String, String)) -> Option<String> {
    if !line.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
        return None;
    }
    let (mut block, mut rest) = (String::new(), line);
    while let Some(c) = rest.chars().next() {
        let enclosed = [(open.as_str(), close.as_str()), ("<", ">"), ("\"", "\"")];
        let found = enclosed.into_iter().find(|(begin, _)| rest.starts_with(begin));
        let (begin, end) = found.unwrap_or(enclosed[2]);
        rest = match rest.strip_prefix(begin) {
            Some(_) if end.is_empty() => "",
            Some(inside) => inside.split_once(end).filter(|(inside, _)| !inside.contains(begin))?.1,
            None if close.starts_with(c) => return None,
            None => &rest[c.len_utf8()..],
        };
        block.push(c);
    }
    // A program's own name stands between the words of its frame.
    let is_frame = block.contains(" BEGIN PGM ") || block.contains(" END PGM ");
    let words = block.split(' ').enumerate().map(|(index, word)| if is_frame && index == 3 { "P" } else { word });
    Some(words.collect::<Vec<_>>().join(" "))
}

#[test]
fn foreign_names_and_texts_change_no_block() {
    let plain = Foreign { program: "P".into(), operation: b"A".into(), tool: b"B".into(), text: b"C".into() };
    for rig in mills() {
        let comment = &rig.dialect.comment;
        let expected = blocks(&posted(&rig, &plain).expect("a program"), comment).expect("a clean program");
        assert!(expected.iter().any(|line| line.contains("Z1") || line.contains("Z+1")), "{expected:#?}");
        let config = Config { cases: 512, failure_persistence: None, ..Config::default() };
        let rng = TestRng::deterministic_rng(config.rng_algorithm);
        let cases = TestRunner::new_with_rng(config, rng).run(&foreign(), |foreign| {
            let nc = posted(&rig, &foreign).map_err(TestCaseError::fail)?;
            prop_assert_eq!(&blocks(&nc, comment).map_err(TestCaseError::fail)?, &expected, "{}", nc);
            Ok(())
        });
        cases.unwrap_or_else(|error| panic!("{}: {error}", rig.dialect.name));
    }
}

#[test]
fn what_is_not_clean_is_seen() {
    let (parentheses, semicolon) = (("(".to_owned(), ")".to_owned()), (";".to_owned(), String::new()));
    assert_eq!(block("N1 (a) G0 X1", &parentheses).as_deref(), Some("N1 ( G0 X1"));
    assert_eq!(block("MSG(\"a ; b\") ; c", &semicolon).as_deref(), Some("MSG(\") ;"));
    for (line, comment) in
        [("(a", &parentheses), ("(a) b)", &parentheses), ("(a (b)", &parentheses), ("\"a", &semicolon)]
    {
        assert_eq!(block(line, comment), None, "{line}");
    }
    assert_eq!(block("Fräsen", &semicolon), None);
}
