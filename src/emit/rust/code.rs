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

/// An argument: one number, or an array of them.
pub(super) enum Argument {
    /// The input of this place in the function's inputs.
    Number(usize),
    /// A run of inputs, each with whether it is an angle that is given in degrees.
    Array(Vec<(usize, bool)>),
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
            arguments.iter().map(|argument| pattern(argument, &mut listing, &mut body)).collect();
        for (block, comment) in listing.blocks.iter().zip(comments(function, &listing)) {
            body += "\n";
            body += &comment.iter().map(|line| format!("// {line}\n")).collect::<String>();
            body += &block.statements.iter().map(statement).collect::<String>();
        }
        Self { arguments: arguments.join(", "), body, outputs: listing.outputs }
    }
}

/// The argument as a pattern; what is given in degrees is converted in the body.
fn pattern(argument: &Argument, listing: &mut Listing, body: &mut String) -> String {
    match argument {
        Argument::Number(input) => match &listing.inputs[*input] {
            Some(name) => format!("{name}: f64"),
            None => "_: f64".to_owned(),
        },
        Argument::Array(inputs) => {
            let names: Vec<String> = inputs.iter().map(|&(input, deg)| element(input, deg, listing, body)).collect();
            match names.iter().all(|name| name == "_") {
                true => format!("_: [f64; {}]", names.len()),
                false => format!("[{}]: [f64; {}]", names.join(", "), names.len()),
            }
        }
    }
}

fn element(input: usize, in_degrees: bool, listing: &mut Listing, body: &mut String) -> String {
    match listing.inputs[input].clone() {
        Some(name) if in_degrees => {
            let given = listing.names.claim(&format!("{name}_deg"));
            *body += &format!("let {name} = {given}.to_radians();\n");
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
