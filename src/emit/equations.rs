//! The plan in a person's notation: `X = x cos C + y sin C`.

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
    names: BTreeMap<Id, String>,
    temporaries: usize,
}

impl<'g> Notation<'g> {
    /// A notation with these names for inputs.
    pub fn new(graph: &'g Graph, inputs: impl IntoIterator<Item = (Id, String)>) -> Self {
        Self { graph, names: inputs.into_iter().collect(), temporaries: 0 }
    }

    /// One line each for what several of these share (as `t1 = …`), then one for each of them.
    pub fn equations(&mut self, outputs: &[(String, Id)]) -> Vec<String> {
        let roots: Vec<Id> = outputs.iter().map(|&(_, id)| id).collect();
        let mut lines: Vec<String> = self.shared(&roots).into_iter().map(|id| self.introduce(id)).collect();
        for (name, id) in outputs {
            lines.push(format!("{name} = {}", self.expression(*id)));
            if !self.is_simple(*id) {
                self.names.entry(*id).or_insert_with(|| name.clone());
            }
        }
        lines
    }

    fn introduce(&mut self, id: Id) -> String {
        let right = self.expression(id);
        self.temporaries += 1;
        let name = format!("t{}", self.temporaries);
        self.names.insert(id, name.clone());
        format!("{name} = {right}")
    }

    /// What is used more than once and is worth a name, operands before their users.
    fn shared(&self, roots: &[Id]) -> Vec<Id> {
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
            op => match self.half_angle(id) {
                Some((_, angle)) => vec![angle],
                None => op.operands().collect(),
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
        if binding < least { format!("({text})") } else { text }
    }

    fn print(&self, id: Id) -> (String, Binding) {
        use Binding::{Atom, Product, Sum};
        if let Some((function, angle)) = self.half_angle(id) {
            return (format!("{function}(½ {})", self.operand(angle, Atom)), Atom);
        }
        match self.graph.op(id) {
            Op::Constant(value) if value < 0.0 => (number(value), Sum),
            Op::Constant(value) => (number(value), Atom),
            Op::Input(index) => (self.names.get(&id).cloned().unwrap_or_else(|| format!("in{index}")), Atom),
            Op::Neg(a) => (format!("-{}", self.operand(a, Product)), Sum),
            Op::Add(a, b) => self.sum(a, b),
            Op::Sub(a, b) => (format!("{} - {}", self.operand(a, Sum), self.operand(b, Product)), Sum),
            Op::Mul(a, b) if a == b => (format!("{}²", self.squared(a)), Atom),
            Op::Mul(a, b) => self.product(a, b),
            Op::Div(a, b) => (format!("{} / {}", self.operand(a, Product), self.operand(b, Atom)), Product),
            Op::Sqrt(a) => (format!("√({})", self.operand(a, Sum)), Atom),
            Op::Sin(a) => (format!("sin {}", self.operand(a, Atom)), Atom),
            Op::Cos(a) => (format!("cos {}", self.operand(a, Atom)), Atom),
            Op::Atan2(a, b) => self.call("atan2", &[a, b]),
            Op::Min(a, b) => self.call("min", &[a, b]),
            Op::Max(a, b) => self.call("max", &[a, b]),
            Op::Select(a, b, c) => {
                let [a, b, c] = [a, b, c].map(|part| self.operand(part, Product));
                (format!("({b} if {a} > 0 else {c})"), Atom)
            }
        }
    }

    /// `a + b`, where a negative number goes last: `x - 5` for `-5 + x`.
    fn sum(&self, a: Id, b: Id) -> (String, Binding) {
        let text = match self.graph.as_constant(a) {
            Some(value) if value < 0.0 => format!("{} - {}", self.operand(b, Binding::Sum), number(-value)),
            _ => {
                let mut terms = [self.operand(a, Binding::Sum), self.operand(b, Binding::Sum)];
                if self.is_simple(a) && self.is_simple(b) {
                    terms.sort();
                }
                terms.join(" + ")
            }
        };
        (text, Binding::Sum)
    }

    /// `a b`: numbers and names before functions, those by their arguments.
    fn product(&self, a: Id, b: Id) -> (String, Binding) {
        let key = |id: Id| match self.graph.op(id) {
            Op::Constant(_) => (0, String::new()),
            Op::Sin(angle) | Op::Cos(angle) if !self.names.contains_key(&id) => (2, self.operand(angle, Binding::Atom)),
            _ => (1, String::new()),
        };
        let (a, b) = if key(b) < key(a) { (b, a) } else { (a, b) };
        (format!("{} {}", self.operand(a, Binding::Product), self.operand(b, Binding::Product)), Binding::Product)
    }

    fn squared(&self, id: Id) -> String {
        match self.graph.op(id) {
            Op::Sin(_) | Op::Cos(_) if !self.names.contains_key(&id) => format!("({})", self.operand(id, Binding::Sum)),
            _ => self.operand(id, Binding::Atom),
        }
    }

    fn call(&self, function: &str, arguments: &[Id]) -> (String, Binding) {
        let arguments: Vec<String> = arguments.iter().map(|&a| self.operand(a, Binding::Sum)).collect();
        (format!("{function}({})", arguments.join(", ")), Binding::Atom)
    }
}

/// A number to twelve digits; multiples of a right angle as such, a half diagonal as `√½`.
pub fn number(value: f64) -> String {
    let close = |to: f64| (value.abs() - to).abs() < 4.0 * f64::EPSILON;
    let sign = if value < 0.0 { "-" } else { "" };
    if close(std::f64::consts::PI) {
        return format!("{sign}π");
    }
    if close(std::f64::consts::FRAC_PI_2) {
        return format!("{sign}π/2");
    }
    if close(std::f64::consts::FRAC_1_SQRT_2) {
        return format!("{sign}√½");
    }
    let text = format!("{value:.12}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
