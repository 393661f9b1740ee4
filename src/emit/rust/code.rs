//! A listing as a Rust function.

use crate::emit::comment::comments;
use crate::emit::expression::Language;
use crate::emit::listing::{Function, Listing, Statement, listing};
use crate::plan::Graph;

/// Rust, with `libm` for the trigonometric functions.
const RUST: Language = Language {
    sqrt: "f64::sqrt",
    atan2: "libm::atan2",
    min: "lesser",
    max: "greater",
    select: |condition, then, otherwise| format!("if {condition} > 0.0 {{ {then} }} else {{ {otherwise} }}"),
    reserved: &[
        "as", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false", "fn", "for", "if",
        "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self", "static", "struct",
        "super", "trait", "true", "type", "unsafe", "use", "where", "while", "async", "await", "abstract", "become",
        "box", "do", "final", "macro", "override", "priv", "try", "typeof", "unsized", "virtual", "yield", "gen",
        "libm", "f64", "lesser", "greater",
    ],
};

/// The functions that the code calls, by their names.
pub(super) const HELPERS: [(&str, &str); 2] = [
    ("lesser", "/// The lesser of two.\nfn lesser(a: f64, b: f64) -> f64 { if a < b { a } else { b } }"),
    ("greater", "/// The greater of two.\nfn greater(a: f64, b: f64) -> f64 { if a > b { a } else { b } }"),
];

/// An argument: one number, or an array of them. Inputs are meant by their places among the function's.
pub(super) enum Argument {
    /// An input.
    Number(usize),
    /// A name for several inputs, each with whether it is an angle that is given in degrees.
    Array(&'static str, Vec<(usize, bool)>),
}

/// What stands in the braces of a Rust function, and what its arguments are called.
pub(super) struct Code {
    /// The arguments with their types.
    pub(super) arguments: String,
    /// The statements, with comments.
    pub(super) body: String,
    /// The name of each output.
    pub(super) outputs: Vec<String>,
}

impl Code {
    /// The code of a function that takes its inputs by these arguments.
    pub(super) fn of(graph: &Graph, function: &Function, arguments: &[Argument]) -> Self {
        let mut listing = listing(graph, function, &RUST);
        let mut body = String::new();
        let arguments: Vec<String> =
            arguments.iter().map(|argument| declared(argument, &mut listing, &mut body)).collect();
        for (block, comment) in listing.blocks.iter().zip(comments(function, &listing)) {
            body += "\n";
            body += &comment.iter().map(|line| format!("// {line}\n")).collect::<String>();
            body += &block.statements.iter().map(statement).collect::<String>();
        }
        Self { arguments: arguments.join(", "), body, outputs: listing.outputs }
    }
}

/// The argument with its type; an array is taken apart in the body, and what is given in degrees is converted.
fn declared(argument: &Argument, listing: &mut Listing, body: &mut String) -> String {
    match argument {
        Argument::Number(input) => format!("{}: f64", listing.inputs[*input].as_deref().unwrap_or("_")),
        Argument::Array(name, inputs) => {
            let name = listing.names.claim(name);
            let mut conversions = String::new();
            let elements: Vec<String> =
                inputs.iter().map(|&(input, deg)| element(input, deg, listing, &mut conversions)).collect();
            let is_read = elements.iter().any(|element| element != "_");
            if is_read {
                *body += &format!("let [{}] = {name};\n{conversions}", elements.join(", "));
            }
            format!("{}: [f64; {}]", if is_read { &name } else { "_" }, elements.len())
        }
    }
}

fn element(input: usize, in_degrees: bool, listing: &mut Listing, conversions: &mut String) -> String {
    match listing.inputs[input].clone() {
        Some(name) if in_degrees => {
            let given = listing.names.claim(&format!("{name}_deg"));
            *conversions += &format!("let {name} = {given}.to_radians();\n");
            given
        }
        Some(name) => name,
        None => "_".to_owned(),
    }
}

fn statement(statement: &Statement) -> String {
    match statement {
        Statement::Value { name, value } => format!("let {name} = {value};\n"),
        Statement::SineCosine { sine, cosine, angle } => {
            let [sine, cosine] = [sine, cosine].map(|name| name.as_deref().unwrap_or("_"));
            format!("let ({sine}, {cosine}) = libm::sincos({angle});\n")
        }
    }
}
