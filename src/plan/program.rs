//! A straight-line program: what a graph leaves to be done for a set of outputs, interpreted over blocks of lanes.

use super::graph::{Graph, Id, Op};
use mach_runtime::kinematics::LANES;

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
        Assembler::new(graph, inputs, outputs).assemble()
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
    needed: Vec<bool>,
    /// The last node that reads each node; outputs are read at the very end.
    last_use: Vec<usize>,
    register: Vec<Option<Register>>,
    free: Vec<Register>,
    registers: Vec<[f64; N]>,
    steps: Vec<Step>,
}

impl<'a, const N: usize> Assembler<'a, N> {
    fn new(graph: &'a Graph, inputs: usize, outputs: &'a [Id]) -> Self {
        let needed = needed(graph, outputs);
        let mut last_use = vec![0; graph.len()];
        for (index, _) in needed.iter().enumerate().filter(|(_, needed)| **needed) {
            for operand in graph.op(id(index)).operands() {
                last_use[operand.index()] = index;
            }
        }
        for output in outputs {
            last_use[output.index()] = usize::MAX;
        }
        let register = vec![None; graph.len()];
        let registers = vec![[0.0; N]; inputs];
        Self { graph, outputs, inputs, needed, last_use, register, free: Vec::new(), registers, steps: Vec::new() }
    }

    fn assemble(mut self) -> Program<N> {
        for index in 0..self.graph.len() {
            if self.needed[index] {
                self.load(index);
            }
        }
        for index in 0..self.graph.len() {
            if self.needed[index] && self.register[index].is_none() {
                self.step(index);
            }
            self.release(index);
        }
        let outputs = self.outputs.iter().map(|&output| self.of(output)).collect();
        Program { inputs: self.inputs, steps: self.steps, outputs, registers: self.registers }
    }

    /// Constants and inputs have registers of their own for good.
    fn load(&mut self, index: usize) {
        match self.graph.op(id(index)) {
            Op::Constant(value) => {
                self.registers.push([value; N]);
                self.register[index] = Some(self.registers.len() - 1);
            }
            Op::Input(input) => self.register[index] = Some(input),
            _ => {}
        }
    }

    fn step(&mut self, index: usize) {
        let step = match self.graph.op(id(index)) {
            Op::Constant(_) | Op::Input(_) => unreachable!("constants and inputs were loaded"),
            Op::Neg(a) => Step::Unary(Unary::Neg, self.target(index), self.of(a)),
            Op::Sqrt(a) => Step::Unary(Unary::Sqrt, self.target(index), self.of(a)),
            Op::Add(a, b) => self.binary(Binary::Add, index, a, b),
            Op::Sub(a, b) => self.binary(Binary::Sub, index, a, b),
            Op::Mul(a, b) => self.binary(Binary::Mul, index, a, b),
            Op::Div(a, b) => self.binary(Binary::Div, index, a, b),
            Op::Atan2(a, b) => self.binary(Binary::Atan2, index, a, b),
            Op::Min(a, b) => self.binary(Binary::Min, index, a, b),
            Op::Max(a, b) => self.binary(Binary::Max, index, a, b),
            Op::Select(a, b, c) => Step::Select(self.target(index), [self.of(a), self.of(b), self.of(c)]),
            Op::Sin(angle) | Op::Cos(angle) => self.sine_and_cosine(angle),
        };
        self.steps.push(step);
    }

    fn binary(&mut self, kind: Binary, index: usize, a: Id, b: Id) -> Step {
        Step::Binary(kind, self.target(index), self.of(a), self.of(b))
    }

    /// Both at once: whoever needs the one mostly needs the other.
    fn sine_and_cosine(&mut self, angle: Id) -> Step {
        let of_angle = |op: Op| matches!(op, Op::Sin(a) | Op::Cos(a) if a == angle);
        let both: Vec<usize> = (0..self.graph.len()).filter(|&index| of_angle(self.graph.op(id(index)))).collect();
        let targets = [self.fresh(), self.fresh()];
        for index in both {
            let which = usize::from(matches!(self.graph.op(id(index)), Op::Cos(_)));
            self.register[index] = Some(targets[which]);
        }
        Step::SinCos(targets[0], targets[1], self.of(angle))
    }

    fn target(&mut self, index: usize) -> Register {
        let register = self.free.pop().unwrap_or_else(|| self.fresh());
        self.register[index] = Some(register);
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
    fn release(&mut self, index: usize) {
        if !self.needed[index] {
            return;
        }
        let mut done: Vec<usize> = self.graph.op(id(index)).operands().map(Id::index).collect();
        done.sort_unstable();
        done.dedup();
        for operand in done {
            let reusable =
                !matches!(self.graph.op(id(operand)), Op::Constant(_) | Op::Input(_) | Op::Sin(_) | Op::Cos(_));
            if reusable && self.last_use[operand] == index {
                self.free.extend(self.register[operand]);
            }
        }
    }
}

fn id(index: usize) -> Id {
    Id(u32::try_from(index).expect("a plan has far fewer than 2^32 nodes"))
}

/// Which nodes the outputs depend on.
fn needed(graph: &Graph, outputs: &[Id]) -> Vec<bool> {
    let mut needed = vec![false; graph.len()];
    for output in outputs {
        needed[output.index()] = true;
    }
    for index in (0..graph.len()).rev() {
        if needed[index] {
            for operand in graph.op(id(index)).operands() {
                needed[operand.index()] = true;
            }
        }
    }
    needed
}
