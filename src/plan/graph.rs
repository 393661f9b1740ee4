//! Scalar expressions that share what is equal: each node is an operation on earlier nodes.

use std::collections::{BTreeMap, BTreeSet};

/// A node of the graph.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Id(pub(super) u32);

impl Id {
    /// Its place in the graph, operands before their users.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One scalar operation. Angles are in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    /// A number of the machine.
    Constant(f64),
    /// An input of the program, by its index.
    Input(usize),
    /// `-a`
    Neg(Id),
    /// `a + b`
    Add(Id, Id),
    /// `a - b`
    Sub(Id, Id),
    /// `a b`
    Mul(Id, Id),
    /// `a / b`
    Div(Id, Id),
    /// The square root.
    Sqrt(Id),
    /// The sine.
    Sin(Id),
    /// The cosine.
    Cos(Id),
    /// The angle of the point (x, y), given as (y, x); 0 for (0, 0).
    Atan2(Id, Id),
    /// The lesser.
    Min(Id, Id),
    /// The greater.
    Max(Id, Id),
    /// `b` where `a > 0`, else `c`.
    Select(Id, Id, Id),
}

impl Op {
    /// The nodes it reads.
    pub fn operands(self) -> impl Iterator<Item = Id> {
        let (list, count) = match self {
            Op::Constant(_) | Op::Input(_) => ([Id(0); 3], 0),
            Op::Neg(a) | Op::Sqrt(a) | Op::Sin(a) | Op::Cos(a) => ([a; 3], 1),
            Op::Add(a, b)
            | Op::Sub(a, b)
            | Op::Mul(a, b)
            | Op::Div(a, b)
            | Op::Atan2(a, b)
            | Op::Min(a, b)
            | Op::Max(a, b) => ([a, b, b], 2),
            Op::Select(a, b, c) => ([a, b, c], 3),
        };
        list.into_iter().take(count)
    }

    /// A total order over operations, so that equal ones are found: the kind, then the operands or the bits.
    fn key(self) -> (u8, u64, u64, u64) {
        let id = |a: Id| u64::from(a.0);
        match self {
            Op::Constant(value) => (0, value.to_bits(), 0, 0),
            Op::Input(index) => (1, index as u64, 0, 0),
            Op::Neg(a) => (2, id(a), 0, 0),
            Op::Add(a, b) => (3, id(a), id(b), 0),
            Op::Sub(a, b) => (4, id(a), id(b), 0),
            Op::Mul(a, b) => (5, id(a), id(b), 0),
            Op::Div(a, b) => (6, id(a), id(b), 0),
            Op::Sqrt(a) => (7, id(a), 0, 0),
            Op::Sin(a) => (8, id(a), 0, 0),
            Op::Cos(a) => (9, id(a), 0, 0),
            Op::Atan2(a, b) => (10, id(a), id(b), 0),
            Op::Min(a, b) => (11, id(a), id(b), 0),
            Op::Max(a, b) => (12, id(a), id(b), 0),
            Op::Select(a, b, c) => (13, id(a), id(b), id(c)),
        }
    }
}

/// Expressions under construction. The building functions are in `simplify` and `trigonometry`.
#[derive(Debug, Default, Clone)]
pub struct Graph {
    nodes: Vec<Op>,
    known: BTreeMap<(u8, u64, u64, u64), Id>,
    /// Angles whose sine and cosine are at hand without a trigonometric function.
    pub(super) angles: BTreeMap<Id, (Id, Id)>,
    /// Angles that come from another one, with their points (x, y), given as (y, x).
    pub(super) points: BTreeMap<Id, (Id, Id)>,
    /// Nodes known not to be negative.
    pub(super) nonnegative: Vec<bool>,
}

impl Graph {
    /// What a node does.
    pub fn op(&self, id: Id) -> Op {
        self.nodes[id.index()]
    }

    /// The inputs that are there, with their indices.
    pub fn inputs(&self) -> impl Iterator<Item = (Id, usize)> + '_ {
        let input = |(place, op): (usize, &Op)| match op {
            Op::Input(index) => Some((Id(u32::try_from(place).expect("ids fit")), *index)),
            _ => None,
        };
        self.nodes.iter().enumerate().filter_map(input)
    }

    /// What the outputs are computed from, and they, operands before their users.
    pub fn needed(&self, outputs: &[Id]) -> BTreeSet<Id> {
        let mut needed: BTreeSet<Id> = outputs.iter().copied().collect();
        let mut open = outputs.to_vec();
        while let Some(id) = open.pop() {
            open.extend(self.op(id).operands().filter(|&operand| needed.insert(operand)));
        }
        needed
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The node of this operation, if there is one.
    pub(super) fn find(&self, op: Op) -> Option<Id> {
        self.known.get(&op.key()).copied()
    }

    /// The node of this operation as it stands: an old one where there is an equal one.
    pub(super) fn intern(&mut self, op: Op) -> Id {
        if let Some(id) = self.find(op) {
            return id;
        }
        let id = Id(u32::try_from(self.nodes.len()).expect("a plan has far fewer than 2^32 nodes"));
        self.nodes.push(op);
        let nonnegative = self.is_nonnegative(op);
        self.nonnegative.push(nonnegative);
        self.known.insert(op.key(), id);
        id
    }

    fn is_nonnegative(&self, op: Op) -> bool {
        let known = |a: Id| self.nonnegative[a.index()];
        match op {
            Op::Constant(value) => value >= 0.0,
            Op::Sqrt(_) => true,
            Op::Mul(a, b) => a == b || (known(a) && known(b)),
            Op::Add(a, b) | Op::Div(a, b) | Op::Min(a, b) => known(a) && known(b),
            Op::Max(a, b) => known(a) || known(b),
            Op::Select(_, b, c) => known(b) && known(c),
            // An angle of the upper half plane: 0 to π.
            Op::Atan2(y, _) => known(y),
            _ => false,
        }
    }
}
