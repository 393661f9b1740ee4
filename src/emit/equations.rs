//! The plan in a person's notation: `X = x cos C + y sin C`.

use super::spelling::Spelling;
use crate::plan::{Graph, Id, Op};
use std::collections::BTreeMap;

/// How tightly what was printed holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Atom,
}

/// Prints parts of one graph; what has a name is printed by it.
pub struct Notation<'g> {
    graph: &'g Graph,
    spelling: Spelling,
    names: BTreeMap<Id, String>,
    temporaries: usize,
}

impl<'g> Notation<'g> {
    /// A plain notation with these names for inputs.
    pub fn new(graph: &'g Graph, inputs: impl IntoIterator<Item = (Id, String)>) -> Self {
        Self { graph, spelling: Spelling::Plain, names: inputs.into_iter().collect(), temporaries: 0 }
    }

    /// The same notation, spelled this way.
    pub fn spelled(self, spelling: Spelling) -> Self {
        let names = self.names.into_iter().map(|(id, name)| (id, spelling.name(&name))).collect();
        Self { spelling, names, ..self }
    }

    /// One line each for what these share, as `t1 = …`; from then on it is printed by that name.
    pub fn shared(&mut self, roots: &[Id]) -> Vec<String> {
        self.used_again(roots).into_iter().map(|id| self.introduce(id)).collect()
    }

    /// `NAME = …`; from then on the name stands for it.
    pub fn equation(&mut self, name: &str, id: Id) -> String {
        let name = self.spelling.name(name);
        let line = format!("{name} = {}", self.operand(id, Binding::Sum));
        if !self.is_simple(id) {
            self.names.entry(id).or_insert(name);
        }
        line
    }

    /// From now on the name stands for the node.
    pub fn call(&mut self, id: Id, name: String) {
        self.names.insert(id, name);
    }

    fn introduce(&mut self, id: Id) -> String {
        let right = self.expression(id);
        self.temporaries += 1;
        let name = self.spelling.name(&format!("t{}", self.temporaries));
        self.call(id, name.clone());
        format!("{name} = {right}")
    }

    /// What is used more than once and is worth a name, operands before their users.
    fn used_again(&self, roots: &[Id]) -> Vec<Id> {
        let mut uses: BTreeMap<Id, usize> = BTreeMap::new();
        let mut open: Vec<Id> = roots.to_vec();
        while let Some(id) = open.pop() {
            let count = uses.entry(id).or_default();
            *count += 1;
            if *count == 1 && !self.names.contains_key(&id) {
                open.extend(self.parts(id));
            }
        }
        let worth = |&(id, count): &(Id, usize)| count > 1 && !self.is_simple(id) && !self.names.contains_key(&id);
        uses.into_iter().filter(worth).map(|(id, _)| id).collect()
    }

    /// What is printed inside of a node.
    fn parts(&self, id: Id) -> Vec<Id> {
        match self.graph.op(id) {
            Op::Mul(a, b) if a == b => vec![a],
            op => match (self.half_angle(id), self.graph.point_of_angle(id)) {
                (Some((_, angle)), _) => vec![angle],
                (None, Some((y, x))) => vec![y, x],
                (None, None) => op.operands().collect(),
            },
        }
    }

    /// Inputs, numbers, and their signs, sines, cosines and squares.
    fn is_simple(&self, id: Id) -> bool {
        match self.graph.op(id) {
            Op::Constant(_) | Op::Input(_) => true,
            Op::Neg(a) => self.is_simple(a),
            Op::Sin(a) | Op::Cos(a) => matches!(self.graph.op(a), Op::Input(_) | Op::Neg(_)),
            Op::Mul(a, b) => (a == b || self.graph.as_constant(a).is_some()) && self.is_simple(b),
            _ => false,
        }
    }

    /// The sine or cosine of half a known angle is printed as that, not as the roots it is computed from.
    fn half_angle(&self, id: Id) -> Option<(&'static str, Id)> {
        let select = matches!(self.graph.op(id), Op::Select(..));
        select
            .then(|| self.graph.half_angle_of(id))
            .flatten()
            .map(|(is_sine, angle)| (if is_sine { "sin" } else { "cos" }, angle))
    }

    fn expression(&self, id: Id) -> String {
        self.print(id).0
    }

    fn operand(&self, id: Id, least: Binding) -> String {
        let (text, binding) = match self.names.get(&id) {
            Some(name) => (name.clone(), Binding::Atom),
            None => self.print(id),
        };
        if binding < least { self.spelling.in_parentheses(&text) } else { text }
    }

    fn print(&self, id: Id) -> (String, Binding) {
        use Binding::{Atom, Product, Sum};
        let spelling = self.spelling;
        if let Some((function, angle)) = self.half_angle(id) {
            return (spelling.of_half_angle(function, &self.operand(angle, Atom)), Atom);
        }
        if let Some((y, x)) = self.graph.point_of_angle(id) {
            return self.function("atan2", &[y, x]);
        }
        match self.graph.op(id) {
            Op::Constant(value) if value < 0.0 => (spelling.number(value), Sum),
            Op::Constant(value) => (spelling.number(value), Atom),
            Op::Input(index) => (self.names.get(&id).cloned().unwrap_or_else(|| format!("in{index}")), Atom),
            Op::Neg(_) | Op::Add(..) | Op::Sub(..) => (self.sum(id), Sum),
            Op::Mul(a, b) if a == b => (spelling.square(&self.squared(a)), Atom),
            Op::Mul(..) => match self.product(id) {
                (true, text) => (format!("-{text}"), Sum),
                (false, text) => (text, Product),
            },
            Op::Div(a, b) if spelling == Spelling::Latex => {
                (format!("\\frac{{{}}}{{{}}}", self.operand(a, Sum), self.operand(b, Sum)), Product)
            }
            Op::Div(a, b) => (format!("{} / {}", self.operand(a, Product), self.operand(b, Atom)), Product),
            Op::Sqrt(a) => (spelling.root(&self.operand(a, Sum)), Atom),
            Op::Sin(a) => (spelling.of_angle("sin", &self.operand(a, Atom)), Atom),
            Op::Cos(a) => (spelling.of_angle("cos", &self.operand(a, Atom)), Atom),
            Op::Atan2(..) => unreachable!("every arc tangent is the angle of its point"),
            Op::Min(a, b) => self.function("min", &[a, b]),
            Op::Max(a, b) => self.function("max", &[a, b]),
            Op::Select(a, b, c) => (spelling.choice([a, b, c].map(|part| self.operand(part, Product))), Atom),
        }
    }

    /// A sum of any length: what is positive first, numbers last.
    fn sum(&self, id: Id) -> String {
        let mut terms = Vec::new();
        self.terms(id, false, true, &mut terms);
        if terms.iter().all(|&(id, _)| self.is_simple(id)) {
            terms.sort_by_cached_key(|&(id, _)| self.operand(id, Binding::Product));
        }
        let mut printed: Vec<(u8, bool, String)> = terms.into_iter().map(|(id, minus)| self.term(id, minus)).collect();
        printed.sort_by_key(|&(kind, minus, _)| (kind, minus));
        if printed[0].1
            && let Some(positive) = printed.iter().position(|&(_, minus, _)| !minus)
        {
            let first = printed.remove(positive);
            printed.insert(0, first);
        }
        let mut text = String::new();
        for (place, (_, minus, term)) in printed.iter().enumerate() {
            text += match (place, minus) {
                (0, true) => "-",
                (0, false) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            };
            text += term;
        }
        text
    }

    /// The signed terms of nested sums that have no names.
    fn terms(&self, id: Id, minus: bool, outermost: bool, terms: &mut Vec<(Id, bool)>) {
        match self.graph.op(id) {
            _ if self.names.contains_key(&id) && !outermost => terms.push((id, minus)),
            Op::Add(a, b) => {
                self.terms(a, minus, false, terms);
                self.terms(b, minus, false, terms);
            }
            Op::Sub(a, b) => {
                self.terms(a, minus, false, terms);
                self.terms(b, !minus, false, terms);
            }
            Op::Neg(a) => self.terms(a, !minus, false, terms),
            _ => terms.push((id, minus)),
        }
    }

    /// Whether a term is a number (and goes last), its sign, and what follows the sign.
    fn term(&self, id: Id, minus: bool) -> (u8, bool, String) {
        match self.graph.op(id) {
            Op::Constant(value) => (1, minus != (value < 0.0), self.spelling.number(value.abs())),
            Op::Mul(a, b) if a != b && !self.names.contains_key(&id) => {
                let (negative, text) = self.product(id);
                (0, minus != negative, text)
            }
            _ => (0, minus, self.operand(id, Binding::Product)),
        }
    }

    /// A product of any length, its sign apart: numbers first, then names, then functions by their arguments.
    fn product(&self, id: Id) -> (bool, String) {
        let mut factors = Vec::new();
        self.factors(id, true, &mut factors);
        let key = |id: &Id| match self.graph.op(*id) {
            Op::Constant(_) => (0, String::new()),
            Op::Sin(angle) | Op::Cos(angle) if !self.names.contains_key(id) => (2, self.operand(angle, Binding::Atom)),
            Op::Div(..) if !self.names.contains_key(id) => (3, String::new()),
            _ => (1, String::new()),
        };
        factors.sort_by_key(key);
        let minus = self.graph.as_constant(factors[0]).is_some_and(|value| value < 0.0);
        let print = |&id: &Id| match self.graph.as_constant(id) {
            Some(value) => self.spelling.number(value.abs()),
            None => self.operand(id, Binding::Product),
        };
        (minus, factors.iter().map(print).collect::<Vec<_>>().join(" "))
    }

    /// The factors of nested products that have no names.
    fn factors(&self, id: Id, outermost: bool, factors: &mut Vec<Id>) {
        match self.graph.op(id) {
            Op::Mul(a, b) if a != b && (outermost || !self.names.contains_key(&id)) => {
                self.factors(a, false, factors);
                self.factors(b, false, factors);
            }
            _ => factors.push(id),
        }
    }

    fn squared(&self, id: Id) -> String {
        match self.graph.op(id) {
            Op::Sin(_) | Op::Cos(_) if !self.names.contains_key(&id) => {
                self.spelling.in_parentheses(&self.operand(id, Binding::Sum))
            }
            _ => self.operand(id, Binding::Atom),
        }
    }

    fn function(&self, function: &str, arguments: &[Id]) -> (String, Binding) {
        let arguments: Vec<String> = arguments.iter().map(|&a| self.operand(a, Binding::Sum)).collect();
        (self.spelling.function(function, &arguments), Binding::Atom)
    }
}
