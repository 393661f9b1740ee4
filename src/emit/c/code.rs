//! A listing as the body of a C function.

use crate::emit::comment::comments;
use crate::emit::expression::Language;
use crate::emit::listing::{Function, Statement, listing};
use crate::plan::Graph;

/// C, with the functions of its mathematical library.
const C: Language = Language {
    sqrt: "sqrt",
    atan2: "atan2",
    min: "fmin",
    max: "fmax",
    select: |condition, then, otherwise| format!("{condition} > 0.0 ? {then} : {otherwise}"),
    reserved: &[
        "auto",
        "break",
        "case",
        "char",
        "const",
        "continue",
        "default",
        "do",
        "double",
        "else",
        "enum",
        "extern",
        "float",
        "for",
        "goto",
        "if",
        "inline",
        "int",
        "long",
        "register",
        "restrict",
        "return",
        "short",
        "signed",
        "sizeof",
        "static",
        "struct",
        "switch",
        "typedef",
        "union",
        "unsigned",
        "void",
        "volatile",
        "while",
        "asm",
        "typeof",
        "bool",
        "true",
        "false",
        "nullptr",
        "alignas",
        "alignof",
        "constexpr",
        "sin",
        "cos",
        "sqrt",
        "atan2",
        "fmin",
        "fmax",
        "isfinite",
        "joints",
        "world",
        "fflags",
        "iflags",
        "pins",
    ],
};

/// The statements of a C function.
pub(super) struct Body {
    /// The text, with comments.
    pub(super) text: String,
    /// The name of each output.
    pub(super) outputs: Vec<String>,
}

impl Body {
    /// The body of a function whose inputs are read from these expressions.
    pub(super) fn of(graph: &Graph, function: &Function, given: &[String]) -> Self {
        let listing = listing(graph, function, &C);
        let read = |(name, given): (&Option<String>, &String)| Some(constant(name.as_ref()?, given));
        let mut text: String = listing.inputs.iter().zip(given).filter_map(read).collect();
        for (block, comment) in listing.blocks.iter().zip(comments(function, &listing)) {
            text += "\n";
            text += &comment.iter().map(|line| format!("    // {line}\n")).collect::<String>();
            text += &block.statements.iter().map(statement).collect::<String>();
        }
        Self { text, outputs: listing.outputs }
    }
}

fn statement(statement: &Statement) -> String {
    match statement {
        Statement::Value { name, value } => constant(name, value),
        Statement::SineCosine { sine, cosine, angle } => [("sin", sine), ("cos", cosine)]
            .into_iter()
            .filter_map(|(function, name)| Some(constant(name.as_ref()?, &format!("{function}({angle})"))))
            .collect(),
    }
}

fn constant(name: &str, value: &str) -> String {
    format!("    const double {name} = {value};\n")
}
