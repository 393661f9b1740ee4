//! Functions of a plan as straight-line code: which nodes get a name, which name, in which order. Every language prints
//! the same listing.

use super::equations::Notation;
use super::expression::{Expressions, Language};
use super::names::Names;
use crate::plan::{Graph, Id, Op};
use mach_runtime::diagnostic::Place;
use std::collections::{BTreeMap, BTreeSet};

/// An expression of more leaves than this is taken apart.
const GREATEST_WEIGHT: usize = 8;

/// A function: what it reads, and what it gives.
#[derive(Debug)]
pub struct Function {
    /// What it reads.
    pub arguments: Vec<Argument>,
    /// What it gives.
    pub outputs: Vec<Output>,
    /// In which order the outputs (as indices) are computed, where none needs another.
    pub order: Vec<usize>,
}

/// An argument of a function.
#[derive(Debug)]
pub enum Argument {
    /// One number.
    Number(Input),
    /// An array under a name of its own.
    Array(&'static str, Vec<Input>),
}

impl Function {
    /// The inputs of all arguments, in order.
    pub fn inputs(&self) -> impl Iterator<Item = &Input> {
        self.arguments.iter().flat_map(|argument| match argument {
            Argument::Number(input) => std::slice::from_ref(input),
            Argument::Array(_, inputs) => inputs,
        })
    }
}

/// An input.
#[derive(Debug)]
pub struct Input {
    /// Its index in the plan.
    pub index: usize,
    /// The name to be given to it.
    pub name: String,
    /// What people write for it.
    pub symbol: String,
    /// Whether it is an angle: the plan has it in radians, whoever calls the function in degrees.
    pub is_angle: bool,
}

/// An output. Angles are in radians.
#[derive(Debug)]
pub struct Output {
    /// Its node.
    pub id: Id,
    /// The name to be given to it.
    pub name: String,
    /// What people write for it; an output without a symbol has no equation.
    pub symbol: Option<String>,
    /// Where it comes from.
    pub remark: Remark,
}

/// What is said of an output.
#[derive(Debug, Clone)]
pub enum Remark {
    /// The statement of the machine file that it comes from.
    Stated(Place),
    /// What it is.
    Meaning(String),
}

/// A function in a programming language.
#[derive(Debug)]
pub struct Listing {
    /// The names of the inputs by their indices; those that nothing reads have none.
    pub inputs: BTreeMap<usize, String>,
    /// The code, in order.
    pub blocks: Vec<Block>,
    /// The name of each output.
    pub outputs: Vec<String>,
    /// The names that are still free.
    pub names: Names,
}

/// What computes one output, as far as nothing before has done so.
#[derive(Debug)]
pub struct Block {
    /// The output, as an index.
    pub output: usize,
    /// Its equation in a person's notation.
    pub equation: Option<String>,
    /// The output's own statement is the last.
    pub statements: Vec<Statement>,
}

/// One statement.
#[derive(Debug)]
pub enum Statement {
    /// `name = value`
    Value {
        /// The name.
        name: String,
        /// The expression, in the language.
        value: String,
    },
    /// The sine and the cosine of an angle; at least one of them has a name.
    SineCosine {
        /// The name of the sine, where it is needed.
        sine: Option<String>,
        /// The name of the cosine, where it is needed.
        cosine: Option<String>,
        /// The angle's name.
        angle: String,
    },
}

/// Lists a function in a language.
pub fn listing(graph: &Graph, function: &Function, language: &Language) -> Listing {
    Lister::new(graph, function, language).list()
}

struct Lister<'a> {
    graph: &'a Graph,
    function: &'a Function,
    needed: BTreeSet<Id>,
    /// The nodes that are to have a name.
    named: BTreeSet<Id>,
    /// The outputs by their nodes; the first one names a node that is two.
    roots: BTreeMap<Id, usize>,
    /// Names for nodes that have a meaning, with what people write for them.
    meanings: BTreeMap<Id, (String, String)>,
    expressions: Expressions<'a>,
    notation: Notation<'a>,
    names: Names,
    temporaries: usize,
    /// The outputs that have their block.
    listed: BTreeSet<Id>,
    blocks: Vec<Block>,
}

impl<'a> Lister<'a> {
    fn new(graph: &'a Graph, function: &'a Function, language: &'a Language) -> Self {
        let outputs: Vec<Id> = function.outputs.iter().map(|output| output.id).collect();
        let needed = graph.needed(&outputs);
        let named = named(graph, &needed, &outputs);
        let symbols: BTreeMap<usize, &str> =
            function.inputs().map(|input| (input.index, input.symbol.as_str())).collect();
        let symbol = |(id, index): (Id, usize)| Some((id, (*symbols.get(&index)?).to_owned()));
        Self {
            graph,
            function,
            needed,
            named,
            roots: function.order.iter().rev().map(|&output| (outputs[output], output)).collect(),
            meanings: meanings(graph, function),
            expressions: Expressions { graph, language, names: BTreeMap::new() },
            notation: Notation::new(graph, graph.inputs().filter_map(symbol)),
            names: Names::new(language.reserved),
            temporaries: 0,
            listed: BTreeSet::new(),
            blocks: Vec::new(),
        }
    }

    fn list(mut self) -> Listing {
        let inputs = self.inputs();
        for &output in &self.function.order {
            self.output(output);
        }
        let name = |output: &Output| self.expressions.names[&output.id].clone();
        let outputs = self.function.outputs.iter().map(name).collect();
        Listing { inputs, blocks: self.blocks, outputs, names: self.names }
    }

    fn inputs(&mut self) -> BTreeMap<usize, String> {
        let nodes: BTreeMap<usize, Id> = self.graph.inputs().map(|(id, index)| (index, id)).collect();
        let mut names = BTreeMap::new();
        for Input { index, name, .. } in self.function.inputs() {
            if let Some(&id) = nodes.get(index).filter(|id| self.needed.contains(id)) {
                let name = self.names.claim(name);
                self.expressions.names.insert(id, name.clone());
                names.insert(*index, name);
            }
        }
        names
    }

    /// The block of an output, behind those of other outputs that it needs.
    fn output(&mut self, output: usize) {
        let Output { id, symbol, .. } = &self.function.outputs[output];
        if !self.listed.insert(*id) {
            return;
        }
        for other in self.missing(*id) {
            if let Some(&other_output) = self.roots.get(&other).filter(|_| other != *id) {
                self.output(other_output);
            }
        }
        let mut statements = Vec::new();
        let mut equation = None;
        for node in self.missing(*id) {
            if let Some(symbol) = symbol.as_ref().filter(|_| node == *id) {
                equation = Some(self.notation.equation(symbol, node));
            }
            // An input has its name from the start; as an output it still gets a statement.
            if !self.expressions.names.contains_key(&node) || matches!(self.graph.op(node), Op::Input(_)) {
                statements.push(self.statement(node));
            }
        }
        if !statements.is_empty() {
            self.blocks.push(Block { output, equation, statements });
        }
    }

    /// The nodes under this one that are still to be named, operands before their users, itself last.
    fn missing(&self, id: Id) -> BTreeSet<Id> {
        let (mut missing, mut seen, mut open) = (BTreeSet::from([id]), BTreeSet::new(), vec![id]);
        while let Some(id) = open.pop() {
            for operand in self.graph.op(id).operands() {
                if !self.expressions.names.contains_key(&operand) && seen.insert(operand) {
                    open.push(operand);
                    missing.extend(self.named.contains(&operand).then_some(operand));
                }
            }
        }
        missing
    }

    fn statement(&mut self, id: Id) -> Statement {
        match self.graph.op(id) {
            Op::Sin(angle) | Op::Cos(angle) => self.sine_and_cosine(angle),
            _ => {
                let value = self.expressions.value(id);
                Statement::Value { name: self.introduce(id), value }
            }
        }
    }

    fn sine_and_cosine(&mut self, angle: Id) -> Statement {
        let of_angle = |id: &&Id| matches!(self.graph.op(**id), Op::Sin(a) | Op::Cos(a) if a == angle);
        let found: Vec<Id> = self.needed.iter().filter(of_angle).copied().collect();
        let angle_name = self.expressions.names[&angle].clone();
        let (mut sine, mut cosine) = (None, None);
        for id in found {
            let is_sine = matches!(self.graph.op(id), Op::Sin(_));
            let name = self.names.claim(&format!("{}_{angle_name}", if is_sine { "sin" } else { "cos" }));
            self.expressions.names.insert(id, name.clone());
            *(if is_sine { &mut sine } else { &mut cosine }) = Some(name);
        }
        Statement::SineCosine { sine, cosine, angle: angle_name }
    }

    /// Gives a node its name; from then on it is printed by that.
    fn introduce(&mut self, id: Id) -> String {
        let root = self.roots.get(&id).map(|&output| &self.function.outputs[output]);
        let (wanted, symbol) = match (root, self.meanings.get(&id)) {
            (Some(output), _) => (output.name.clone(), None),
            (None, Some((name, symbol))) => (name.clone(), Some(symbol.clone())),
            (None, None) => (self.name_by_kind(id), None),
        };
        let name = self.names.claim(&wanted);
        self.expressions.names.insert(id, name.clone());
        if root.is_none() {
            self.notation.call(id, symbol.unwrap_or_else(|| name.clone()));
        }
        name
    }

    /// The name of a node without a meaning.
    fn name_by_kind(&mut self, id: Id) -> String {
        match self.graph.op(id) {
            Op::Sqrt(_) => "root".to_owned(),
            Op::Atan2(..) => "angle".to_owned(),
            _ => {
                self.temporaries += 1;
                format!("t{}", self.temporaries)
            }
        }
    }
}

/// The sines and cosines that were found without a trigonometric function: of outputs, and of half an angle.
fn meanings(graph: &Graph, function: &Function) -> BTreeMap<Id, (String, String)> {
    let mut meanings = BTreeMap::new();
    for (angle, sine, cosine) in graph.known_angles() {
        let output = function.outputs.iter().find(|output| output.id == angle && output.symbol.is_some());
        let (name, symbol) = match output {
            Some(Output { name, symbol: Some(symbol), .. }) => (format!("_{name}"), format!(" {symbol}")),
            _ if graph.half_angle_of(sine).is_some() => ("_half".to_owned(), "_half".to_owned()),
            _ => continue,
        };
        for (function, node) in [("sin", sine), ("cos", cosine)] {
            let meaning = (format!("{function}{name}"), format!("{function}{symbol}"));
            meanings.entry(node).or_insert(meaning);
        }
    }
    meanings
}

/// Whether a function divides by what may be zero.
pub fn divides(graph: &Graph, function: &Function) -> bool {
    let outputs: Vec<Id> = function.outputs.iter().map(|output| output.id).collect();
    graph.needed(&outputs).into_iter().any(|id| matches!(graph.op(id), Op::Div(..)))
}

/// Which nodes get a name: outputs, what is used twice, functions that are costly or do not read well inside of an
/// expression, and parts of long expressions.
fn named(graph: &Graph, needed: &BTreeSet<Id>, outputs: &[Id]) -> BTreeSet<Id> {
    let mut named: BTreeSet<Id> = outputs.iter().copied().collect();
    let mut uses: BTreeMap<Id, usize> = BTreeMap::new();
    for &id in needed.iter().rev() {
        let op = graph.op(id);
        let used_again = uses.get(&id).is_some_and(|&count| count > 1);
        match op {
            Op::Constant(_) | Op::Input(_) => {}
            Op::Sin(angle) | Op::Cos(angle) => named.extend([id, angle]),
            Op::Atan2(..) | Op::Select(..) => named.extend([id]),
            Op::Neg(_) => {}
            _ if used_again => named.extend([id]),
            _ => {}
        }
        // A sign costs nothing: it is written as often as it is used.
        let count = if matches!(op, Op::Neg(_)) && !named.contains(&id) { uses.get(&id).copied() } else { None };
        for operand in op.operands() {
            *uses.entry(operand).or_default() += count.unwrap_or(1);
        }
    }
    split_long_ones(graph, needed, &mut named);
    named
}

/// Names the heaviest operands of expressions that are too long.
fn split_long_ones(graph: &Graph, needed: &BTreeSet<Id>, named: &mut BTreeSet<Id>) {
    let mut weights: BTreeMap<Id, usize> = BTreeMap::new();
    for &id in needed {
        let operands: Vec<Id> = graph.op(id).operands().collect();
        let seen = |named: &BTreeSet<Id>, operand: &Id| if named.contains(operand) { 1 } else { weights[operand] };
        let weigh = |named: &BTreeSet<Id>| operands.iter().map(|operand| seen(named, operand)).sum::<usize>().max(1);
        while weigh(named) > GREATEST_WEIGHT {
            let heaviest = operands.iter().max_by_key(|operand| seen(named, operand));
            named.extend(heaviest);
        }
        let weight = weigh(named);
        weights.insert(id, weight);
    }
}
