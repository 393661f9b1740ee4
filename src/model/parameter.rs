//! The parameters of a machine: every `let`, in whatever order they are written.

use super::evaluate::{CONSTANTS, Evaluator, Known};
use super::source::{Located, Location};
use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::tree::{Expression, ExpressionKind, Name};
use std::collections::{BTreeMap, BTreeSet};

/// A parameter that needs itself.
pub(crate) static CYCLE: Code = Code {
    id: "E0408",
    title: "parameters define each other in a circle",
    explanation: "\
The value of a parameter may name other parameters, before or after it, but not itself, neither directly nor through
others.

    let height = reach + 20 mm
    let reach  = height - 20 mm      // needs `height`, which needs `reach`
",
};

/// A parameter with a name that means something else.
pub(crate) static RESERVED: Code = Code {
    id: "E0410",
    title: "this name is reserved",
    explanation: "\
`pi` and the unit vectors `x`, `y` and `z` are always there and cannot be defined again.

    let x = 20 mm            // `x` is a direction
    let offset_x = 20 mm
",
};

/// A parameter and its expression.
pub(crate) struct Parameter<'a> {
    pub(crate) name: Located<&'a Name>,
    pub(crate) value: &'a Expression,
}

/// Evaluates every parameter into the evaluator. The order of the definitions does not matter.
pub(crate) fn define(evaluator: &mut Evaluator<'_>, parameters: &[Parameter<'_>]) {
    let index: BTreeMap<&str, usize> = (0..).zip(parameters).map(|(i, p)| (p.name.value.value.as_str(), i)).collect();
    let mut waits_for: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); parameters.len()];
    let mut needed_by: Vec<Vec<usize>> = vec![Vec::new(); parameters.len()];
    for (i, parameter) in parameters.iter().enumerate() {
        names(parameter.value, &mut |name| waits_for[i].extend(index.get(name)));
        waits_for[i].iter().for_each(|needed| needed_by[*needed].push(i));
        let at = parameter.name.at.with(&parameter.value.span);
        evaluator.parameters.insert(parameter.name.value.value.clone(), Known { value: None, at });
        refuse_reserved(evaluator, parameter);
    }
    let mut ready: BTreeSet<usize> = (0..parameters.len()).filter(|i| waits_for[*i].is_empty()).collect();
    while let Some(i) = ready.pop_first() {
        let Parameter { name, value } = &parameters[i];
        let known = Known { value: evaluator.evaluate(name.at.source, value), at: name.at.with(&value.span) };
        evaluator.parameters.insert(name.value.value.clone(), known);
        for waiting in &needed_by[i] {
            waits_for[*waiting].remove(&i);
            if waits_for[*waiting].is_empty() {
                ready.insert(*waiting);
            }
        }
    }
    report_circles(evaluator, parameters, &waits_for);
}

/// Every name in an expression.
pub(crate) fn names(expression: &Expression, visit: &mut impl FnMut(&str)) {
    match expression.value.as_ref() {
        ExpressionKind::Broken(_) | ExpressionKind::Number { .. } => {}
        ExpressionKind::Name(name) => visit(name),
        ExpressionKind::Vector(components) => components.iter().for_each(|component| names(component, visit)),
        ExpressionKind::Group(inner) | ExpressionKind::Sign { of: inner, .. } => names(inner, visit),
        ExpressionKind::Binary { left, right, .. } => [left, right].into_iter().for_each(|side| names(side, visit)),
        ExpressionKind::Call { arguments, .. } => arguments.iter().for_each(|argument| names(argument, visit)),
    }
}

fn refuse_reserved(evaluator: &mut Evaluator<'_>, parameter: &Parameter<'_>) {
    let name = parameter.name.value;
    if CONSTANTS.contains(&name.value.as_str()) {
        let message = format!("`{}` is reserved and cannot be defined", name.value);
        evaluator.report(&RESERVED, parameter.name.at.source, &name.span, message, "always defined");
    }
}

/// Whatever still waits is in a circle or behind one: each circle is reported once.
fn report_circles(evaluator: &mut Evaluator<'_>, parameters: &[Parameter<'_>], waits_for: &[BTreeSet<usize>]) {
    let mut seen = BTreeSet::new();
    for start in 0..parameters.len() {
        let mut path = Vec::new();
        let mut at = start;
        while let Some(next) = waits_for[at].first() {
            if !seen.insert(at) {
                break;
            }
            path.push(at);
            at = *next;
        }
        if let Some(first) = path.iter().position(|member| *member == at) {
            report_circle(evaluator, parameters, &path[first..]);
        }
    }
}

fn report_circle(evaluator: &mut Evaluator<'_>, parameters: &[Parameter<'_>], circle: &[usize]) {
    let name = |i: usize| parameters[i].name.value.value.as_str();
    let mut way: Vec<String> = circle.iter().map(|i| format!("`{}`", name(*i))).collect();
    way.push(way[0].clone());
    let message = format!("`{}` is defined by itself", name(circle[0]));
    let mut diagnostic = Diagnostic::error(&CYCLE, message);
    for member in circle {
        let Parameter { name, value } = &parameters[*member];
        let at = Location { source: name.at.source, span: name.value.span.start..value.span.end };
        diagnostic = diagnostic.at(evaluator.sources.place(&at), "");
    }
    evaluator.diagnostics.push(diagnostic.note(format!("the circle: {}", way.join(" needs "))));
}
