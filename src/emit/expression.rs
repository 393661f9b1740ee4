//! Expressions of a graph in a programming language, with the operations and the order that the interpreter has: what is
//! printed computes the same bits. Only operands of one sum or product change places, which changes none.

use crate::plan::{Graph, Id, Op};
use std::collections::BTreeMap;

/// How a language writes what languages write differently.
#[derive(Debug)]
pub struct Language {
    /// The function for the square root.
    pub sqrt: &'static str,
    /// The function for the angle of a point, y first.
    pub atan2: &'static str,
    /// The function for the lesser of two.
    pub min: &'static str,
    /// The function for the greater of two.
    pub max: &'static str,
    /// The second where the first is positive, else the third.
    pub select: fn(&str, &str, &str) -> String,
    /// Names that are not free for values.
    pub reserved: &'static [&'static str],
}

/// How tightly what was printed holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Choice,
    Sum,
    Product,
    Sign,
    Atom,
}

/// Prints expressions of one graph; what has a name is printed by it.
pub(super) struct Expressions<'a> {
    pub(super) graph: &'a Graph,
    pub(super) language: &'a Language,
    pub(super) names: BTreeMap<Id, String>,
}

impl Expressions<'_> {
    /// What the node computes, whether it has a name or not.
    ///
    /// # Panics
    ///
    /// When an input or a function of an angle that it reads has no name.
    pub(super) fn value(&self, id: Id) -> String {
        self.print(id).0
    }

    fn operand(&self, id: Id, least: Binding) -> String {
        let (text, binding) = self.part(id);
        if binding < least { format!("({text})") } else { text }
    }

    fn part(&self, id: Id) -> (String, Binding) {
        match self.names.get(&id) {
            Some(name) if self.graph.as_constant(id).is_none() => (name.clone(), Binding::Atom),
            _ => self.print(id),
        }
    }

    fn print(&self, id: Id) -> (String, Binding) {
        use Binding::{Atom, Choice, Product, Sign, Sum};
        let language = self.language;
        match self.graph.op(id) {
            Op::Constant(value) => (number(value), if value < 0.0 { Sign } else { Atom }),
            Op::Input(_) | Op::Sin(_) | Op::Cos(_) => (self.names[&id].clone(), Atom),
            Op::Neg(a) => (format!("-{}", self.operand(a, Atom)), Sign),
            Op::Add(a, b) => (self.sum(a, b), Sum),
            Op::Sub(a, b) => (self.difference(a, b), Sum),
            Op::Mul(a, b) => (self.product(a, b), Product),
            Op::Div(a, b) => (format!("{} / {}", self.operand(a, Product), self.operand(b, Atom)), Product),
            Op::Sqrt(a) => (self.call(language.sqrt, &[a]), Atom),
            Op::Atan2(a, b) => (self.call(language.atan2, &[a, b]), Atom),
            Op::Min(a, b) => (self.call(language.min, &[a, b]), Atom),
            Op::Max(a, b) => (self.call(language.max, &[a, b]), Atom),
            Op::Select(a, b, c) => {
                let [a, b, c] = [a, b, c].map(|part| self.operand(part, Sum));
                ((language.select)(&a, &b, &c), Choice)
            }
        }
    }

    /// A number stands last, and what is a sum itself first.
    fn sum(&self, a: Id, b: Id) -> String {
        if let Some(offset) = self.graph.as_constant(a) {
            let sign = if offset < 0.0 { '-' } else { '+' };
            return format!("{} {sign} {}", self.operand(b, Binding::Sum), number(offset.abs()));
        }
        let (first, second) = if self.needs_brackets_behind(a, b, Binding::Sum) { (b, a) } else { (a, b) };
        let (minus, second) = self.term(second);
        format!("{} {} {second}", self.operand(first, Binding::Sum), if minus { '-' } else { '+' })
    }

    fn difference(&self, a: Id, b: Id) -> String {
        let (minus, second) = self.term(b);
        format!("{} {} {second}", self.operand(a, Binding::Sum), if minus { '+' } else { '-' })
    }

    /// Whether a term is a negative number times something, and the term without that sign.
    fn term(&self, id: Id) -> (bool, String) {
        if let (Op::Mul(factor, rest), false) = (self.graph.op(id), self.names.contains_key(&id))
            && let Some(factor) = self.graph.as_constant(factor).filter(|factor| *factor < 0.0)
        {
            return (true, format!("{} * {}", number(-factor), self.operand(rest, Binding::Atom)));
        }
        (false, self.operand(id, Binding::Product))
    }

    /// A number stands first, and else what is a product itself.
    fn product(&self, a: Id, b: Id) -> String {
        let swap = self.graph.as_constant(a).is_none() && self.needs_brackets_behind(a, b, Binding::Product);
        let (first, second) = if swap { (b, a) } else { (a, b) };
        format!("{} * {}", self.operand(first, Binding::Product), self.operand(second, Binding::Atom))
    }

    fn needs_brackets_behind(&self, a: Id, b: Id, binding: Binding) -> bool {
        self.part(b).1 == binding && self.part(a).1 > binding
    }

    fn call(&self, function: &str, arguments: &[Id]) -> String {
        let arguments: Vec<String> =
            arguments.iter().map(|&argument| self.operand(argument, Binding::Choice)).collect();
        format!("{function}({})", arguments.join(", "))
    }
}

/// A number that reads back as the same bits, in Rust as in C.
pub(super) fn number(value: f64) -> String {
    assert!(value.is_finite(), "a plan's constants are finite");
    format!("{value:?}")
}

#[cfg(test)]
mod tests {
    use super::{Expressions, Language};
    use crate::plan::Graph;
    use std::collections::BTreeMap;

    const LANGUAGE: Language = Language {
        sqrt: "sqrt",
        atan2: "atan2",
        min: "min",
        max: "max",
        select: |a, b, c| format!("{a} > 0.0 ? {b} : {c}"),
        reserved: &[],
    };

    #[test]
    fn brackets_stand_where_the_order_asks_for_them() {
        let mut graph = Graph::default();
        let [a, b, c] = [0, 1, 2].map(|index| graph.input(index));
        let minus_two = graph.constant(-2.0);
        let sum = graph.add(b, c);
        let difference = graph.sub(b, c);
        let product = graph.mul(b, c);
        let quotient = graph.div(b, c);
        let scaled = graph.mul(minus_two, b);
        let nodes = [
            (graph.add(a, sum), "b + c + a"),
            (graph.sub(a, sum), "a - (b + c)"),
            (graph.sub(a, difference), "a - (b - c)"),
            (graph.mul(a, product), "b * c * a"),
            (graph.mul(a, sum), "a * (b + c)"),
            (graph.mul(a, quotient), "b / c * a"),
            (graph.div(a, product), "a / (b * c)"),
            (graph.div(quotient, a), "b / c / a"),
            (graph.add(minus_two, sum), "b + c - 2.0"),
            (graph.mul(minus_two, product), "-2.0 * (b * c)"),
            (graph.add(a, scaled), "a - 2.0 * b"),
            (graph.sub(a, scaled), "a + 2.0 * b"),
            (graph.neg(sum), "-(b + c)"),
            (graph.neg(product), "-(b * c)"),
            (graph.min(sum, a), "min(a, b + c)"),
            (graph.select(sum, a, product), "b + c > 0.0 ? a : b * c"),
        ];
        let names: BTreeMap<_, _> = [(a, "a".to_owned()), (b, "b".to_owned()), (c, "c".to_owned())].into();
        let expressions = Expressions { graph: &graph, language: &LANGUAGE, names };
        for (id, expected) in nodes {
            assert_eq!(expressions.value(id), expected);
        }
    }
}
