//! A straight-line program: what a graph leaves to be done for a set of outputs, interpreted over blocks of lanes.

use super::graph::{Graph, Id, Op};
use mach_runtime::kinematics::LANES;
use std::collections::BTreeSet;

/// Index of a register.
type Register = usize;

/// One step, its target first.
#[derive(Debug, Clone, Copy)]
enum Step {
    Unary(Unary, Register, Register),
    Binary(Binary, Register, Register, Register),
    /// Sine and cosine of the third.
    SinCos(Register, Register, Register),
    /// The second where the first is positive, else the third.
    Select(Register, [Register; 3]),
}

#[derive(Debug, Clone, Copy)]
enum Unary {
    Neg,
    Sqrt,
}

#[derive(Debug, Clone, Copy)]
enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Atan2,
    Min,
    Max,
}

/// A program with its registers, for `N` lanes at once. Inputs are the first registers, constants follow.
#[derive(Debug, Clone)]
pub struct Program<const N: usize = LANES> {
    inputs: usize,
    steps: Vec<Step>,
    outputs: Vec<Register>,
    registers: Vec<[f64; N]>,
}

impl<const N: usize> Program<N> {
    /// The program that computes `outputs` from `inputs` inputs.
    pub fn new(graph: &Graph, inputs: usize, outputs: &[Id]) -> Self {
        let needed = graph.needed(outputs);
        Assembler::new(graph, inputs, outputs, &needed).assemble()
    }

    /// How many steps it takes.
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether it takes none.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// The lane of an input, to be filled before [`Self::run`].
    pub fn input(&mut self, index: usize) -> &mut [f64; N] {
        assert!(index < self.inputs, "a program has only its own inputs");
        &mut self.registers[index]
    }

    /// The lane of an output, after [`Self::run`].
    pub fn output(&self, index: usize) -> &[f64; N] {
        &self.registers[self.outputs[index]]
    }

    /// Runs the program over all lanes.
    pub fn run(&mut self) {
        for step in &self.steps {
            step.run(&mut self.registers);
        }
    }
}

impl Step {
    fn run<const N: usize>(self, registers: &mut [[f64; N]]) {
        match self {
            Step::Unary(Unary::Neg, target, a) => unary(registers, target, a, |a| -a),
            Step::Unary(Unary::Sqrt, target, a) => unary(registers, target, a, f64::sqrt),
            Step::Binary(kind, target, a, b) => kind.run(registers, target, a, b),
            Step::SinCos(sine, cosine, angle) => {
                let [sine, cosine, angle] = disjoint(registers, [sine, cosine, angle]);
                for lane in 0..N {
                    (sine[lane], cosine[lane]) = libm::sincos(angle[lane]);
                }
            }
            Step::Select(target, [condition, a, b]) => {
                let (condition, a, b) = (registers[condition], registers[a], registers[b]);
                let target = &mut registers[target];
                for lane in 0..N {
                    target[lane] = if condition[lane] > 0.0 { a[lane] } else { b[lane] };
                }
            }
        }
    }
}

impl Binary {
    fn run<const N: usize>(self, registers: &mut [[f64; N]], target: Register, a: Register, b: Register) {
        match self {
            Binary::Add => binary(registers, target, a, b, |a, b| a + b),
            Binary::Sub => binary(registers, target, a, b, |a, b| a - b),
            Binary::Mul => binary(registers, target, a, b, |a, b| a * b),
            Binary::Div => binary(registers, target, a, b, |a, b| a / b),
            Binary::Atan2 => binary(registers, target, a, b, libm::atan2),
            Binary::Min => binary(registers, target, a, b, |a, b| if a < b { a } else { b }),
            Binary::Max => binary(registers, target, a, b, |a, b| if a > b { a } else { b }),
        }
    }
}

#[inline(always)]
fn unary<const N: usize>(registers: &mut [[f64; N]], target: Register, a: Register, f: impl Fn(f64) -> f64) {
    let [target, a] = disjoint(registers, [target, a]);
    for lane in 0..N {
        target[lane] = f(a[lane]);
    }
}

#[inline(always)]
fn binary<const N: usize>(
    registers: &mut [[f64; N]],
    target: Register,
    a: Register,
    b: Register,
    f: impl Fn(f64, f64) -> f64,
) {
    if a == b {
        return unary(registers, target, a, |a| f(a, a));
    }
    let [target, a, b] = disjoint(registers, [target, a, b]);
    for lane in 0..N {
        target[lane] = f(a[lane], b[lane]);
    }
}

fn disjoint<const N: usize, const M: usize>(registers: &mut [[f64; N]], places: [Register; M]) -> [&mut [f64; N]; M] {
    registers.get_disjoint_mut(places).expect("a register is written while its operands are still held elsewhere")
}

/// Assigns registers: a register is used again once nothing reads its value any more.
struct Assembler<'a, const N: usize> {
    graph: &'a Graph,
    outputs: &'a [Id],
    inputs: usize,
    needed: &'a BTreeSet<Id>,
    /// The last node that reads each node; outputs are read at the very end, and have none.
    last_use: Vec<Option<Id>>,
    register: Vec<Option<Register>>,
    free: Vec<Register>,
    registers: Vec<[f64; N]>,
    steps: Vec<Step>,
}

impl<'a, const N: usize> Assembler<'a, N> {
    fn new(graph: &'a Graph, inputs: usize, outputs: &'a [Id], needed: &'a BTreeSet<Id>) -> Self {
        let mut last_use = vec![None; graph.len()];
        for &node in needed {
            for operand in graph.op(node).operands() {
                last_use[operand.index()] = Some(node);
            }
        }
        for output in outputs {
            last_use[output.index()] = None;
        }
        let register = vec![None; graph.len()];
        let registers = vec![[0.0; N]; inputs];
        Self { graph, outputs, inputs, needed, last_use, register, free: Vec::new(), registers, steps: Vec::new() }
    }

    fn assemble(mut self) -> Program<N> {
        self.needed.iter().for_each(|&node| self.load(node));
        for &node in self.needed {
            if self.register[node.index()].is_none() {
                self.step(node);
            }
            self.release(node);
        }
        let outputs = self.outputs.iter().map(|&output| self.of(output)).collect();
        Program { inputs: self.inputs, steps: self.steps, outputs, registers: self.registers }
    }

    /// Constants and inputs have registers of their own for good.
    fn load(&mut self, node: Id) {
        match self.graph.op(node) {
            Op::Constant(value) => {
                self.registers.push([value; N]);
                self.register[node.index()] = Some(self.registers.len() - 1);
            }
            Op::Input(input) => self.register[node.index()] = Some(input),
            _ => {}
        }
    }

    fn step(&mut self, node: Id) {
        let step = match self.graph.op(node) {
            Op::Constant(_) | Op::Input(_) => unreachable!("constants and inputs were loaded"),
            Op::Neg(a) => Step::Unary(Unary::Neg, self.target(node), self.of(a)),
            Op::Sqrt(a) => Step::Unary(Unary::Sqrt, self.target(node), self.of(a)),
            Op::Add(a, b) => self.binary(Binary::Add, node, a, b),
            Op::Sub(a, b) => self.binary(Binary::Sub, node, a, b),
            Op::Mul(a, b) => self.binary(Binary::Mul, node, a, b),
            Op::Div(a, b) => self.binary(Binary::Div, node, a, b),
            Op::Atan2(a, b) => self.binary(Binary::Atan2, node, a, b),
            Op::Min(a, b) => self.binary(Binary::Min, node, a, b),
            Op::Max(a, b) => self.binary(Binary::Max, node, a, b),
            Op::Select(a, b, c) => Step::Select(self.target(node), [self.of(a), self.of(b), self.of(c)]),
            Op::Sin(angle) | Op::Cos(angle) => self.sine_and_cosine(angle),
        };
        self.steps.push(step);
    }

    fn binary(&mut self, kind: Binary, node: Id, a: Id, b: Id) -> Step {
        Step::Binary(kind, self.target(node), self.of(a), self.of(b))
    }

    /// Both at once: whoever needs the one mostly needs the other.
    fn sine_and_cosine(&mut self, angle: Id) -> Step {
        let [sine, cosine] = [self.fresh(), self.fresh()];
        for (op, register) in [(Op::Sin(angle), sine), (Op::Cos(angle), cosine)] {
            if let Some(node) = self.graph.find(op) {
                self.register[node.index()] = Some(register);
            }
        }
        Step::SinCos(sine, cosine, self.of(angle))
    }

    fn target(&mut self, node: Id) -> Register {
        let register = self.free.pop().unwrap_or_else(|| self.fresh());
        self.register[node.index()] = Some(register);
        register
    }

    fn fresh(&mut self) -> Register {
        self.registers.push([0.0; N]);
        self.registers.len() - 1
    }

    fn of(&self, id: Id) -> Register {
        self.register[id.index()].expect("operands stand before their users")
    }

    /// Frees the registers of the operands that this node was the last to read.
    fn release(&mut self, node: Id) {
        let operands: BTreeSet<Id> = self.graph.op(node).operands().collect();
        for operand in operands {
            let reusable = !matches!(self.graph.op(operand), Op::Constant(_) | Op::Input(_) | Op::Sin(_) | Op::Cos(_));
            if reusable && self.last_use[operand.index()] == Some(node) {
                self.free.extend(self.register[operand.index()]);
            }
        }
    }
}
