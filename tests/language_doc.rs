//! Every example of the language's reference is what it says.

use machc::compile::compile;
use machc::sources::Sources;
use machc::syntax::parse::parse;
use machc::syntax::print::print;
use machc::syntax::tree::Trigger;
use machc::syntax::unit::UNITS;

const REFERENCE: &str = include_str!("../docs/language.md");

/// An example as a file of its own, with the reference's line on which it begins.
struct Example {
    line: usize,
    text: String,
}

/// The examples: whole files (```` ```mach ````) and parts of a machine's or a controller's body
/// (```` ```mach machine ````, ```` ```mach controller ````).
fn examples() -> Vec<Example> {
    let mut examples = Vec::new();
    let mut lines = REFERENCE.lines().enumerate();
    while let Some((line, fence)) = lines.next() {
        let Some(kind) = fence.strip_prefix("```mach") else { continue };
        let body: Vec<&str> = lines.by_ref().map(|(_, text)| text).take_while(|text| *text != "```").collect();
        let text = match kind.trim() {
            "" => body.join("\n") + "\n",
            kind @ ("machine" | "controller") => format!("{kind} example {{\n{}}}\n", indented(&body)),
            other => panic!("line {}: no such kind of example: {other}", line + 1),
        };
        examples.push(Example { line: line + 1, text });
    }
    examples
}

fn indented(lines: &[&str]) -> String {
    lines.iter().map(|line| if line.is_empty() { "\n".to_owned() } else { format!("    {line}\n") }).collect()
}

#[test]
fn every_example_is_taken_and_laid_out_as_the_printer_would() {
    let examples = examples();
    assert!(examples.len() >= 15, "only {} examples were found", examples.len());
    for Example { line, text } in examples {
        match parse("example.mach", &text).whole() {
            Ok(file) => assert_eq!(print(&file), text, "the example at line {line} is not in the canonical form"),
            Err(errors) => panic!("the example at line {line} is refused: {errors:#?}\n{text}"),
        }
    }
}

#[test]
fn every_unit_and_event_is_in_a_table() {
    let tables: Vec<&str> = REFERENCE.lines().filter(|line| line.starts_with('|')).collect();
    for word in UNITS.iter().map(|(unit, _)| *unit).chain(Trigger::ALL.iter().map(|event| event.name())) {
        assert!(tables.iter().any(|line| line.contains(&format!("`{word}`"))), "`{word}` is not in the reference");
    }
}

/// The shipped controllers, and the example that is being compiled.
struct Library<'a>(&'a str);

impl Sources for Library<'_> {
    fn read(&self, path: &str) -> Result<String, String> {
        match path {
            "example.mach" => Ok(self.0.to_owned()),
            "controllers/syntec.mach" => Ok(include_str!("../machines/controllers/syntec.mach").to_owned()),
            "controllers/siemens.mach" => Ok(include_str!("../machines/controllers/siemens.mach").to_owned()),
            "controllers/heidenhain.mach" => Ok(include_str!("../machines/controllers/heidenhain.mach").to_owned()),
            "base.mach" => Ok(BASE.to_owned()),
            _ => Err("no such file".to_owned()),
        }
    }
}

/// What the parts of the reference are parts of.
const BASE: &str = r#"
use "controllers/syntec.mach"
use "controllers/siemens.mach"
machine base {
    chain w C A b X Y Z t
    linear X along +x
    linear Y along +y
    linear Z along +z travel -500 .. 500
    rotary A about +x
    rotary C about +z
    tool along +z
    controller syntec {}
}
"#;

/// The example as a file that defines a machine.
fn whole(text: &str) -> String {
    let base = |name: &str| format!("use \"base.mach\"\nmachine {name} like base ");
    if let Some(body) = text.strip_prefix("machine example ") {
        return base("example") + body;
    }
    if let Some(body) = text.strip_prefix("controller example ") {
        return base("other") + "{ controller syntec " + body + "}\n";
    }
    text.to_owned()
}

#[test]
fn every_example_compiles() {
    for Example { line, text } in examples() {
        if let Err(errors) = compile("example.mach", &Library(&whole(&text))) {
            let errors = mach_command::render::plain(&errors);
            panic!("the example at line {line} does not compile:\n{errors}");
        }
    }
}
