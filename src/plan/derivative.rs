//! Derivatives of expressions: each node's by the rule of its operation, built like any other expression, so that what is
//! structurally zero vanishes as it grows.
//!
//! Where an operation has no derivative, it is that of the side the operation itself takes: `min`, `max` and `select`
//! choose among the derivatives of their operands as the interpreter chooses among the operands, at a tie too. A square
//! root at zero and the angle of the point (0, 0) have no such side; the result is not finite there.

use super::graph::{Graph, Id, Op};

impl Graph {
    /// The derivatives of the outputs by an input, in the order of the outputs.
    ///
    /// # Panics
    /// When `input` is no input of the graph.
    pub fn derivatives(&mut self, outputs: &[Id], input: Id) -> Vec<Id> {
        assert!(matches!(self.op(input), Op::Input(_)), "a derivative is by an input");
        let mut known = vec![None; self.len()];
        for node in self.needed(outputs) {
            let derivative = if node == input { self.constant(1.0) } else { self.derivative(node, &known) };
            known[node.index()] = Some(derivative);
        }
        outputs.iter().map(|&output| of(&known, output)).collect()
    }

    /// By the rule of the operation, from the derivatives of its operands.
    fn derivative(&mut self, node: Id, known: &[Option<Id>]) -> Id {
        let d = |operand: Id| of(known, operand);
        match self.op(node) {
            Op::Constant(_) | Op::Input(_) => self.constant(0.0),
            Op::Neg(a) => self.neg(d(a)),
            Op::Add(a, b) => self.add(d(a), d(b)),
            Op::Sub(a, b) => self.sub(d(a), d(b)),
            Op::Mul(a, b) => self.sum_of_products(d(a), b, a, d(b)),
            Op::Div(a, b) => {
                let from_b = self.mul(node, d(b));
                let numerator = self.sub(d(a), from_b);
                self.div(numerator, b)
            }
            Op::Sqrt(a) => {
                let twice = self.add(node, node);
                self.div(d(a), twice)
            }
            Op::Sin(a) => {
                let cosine = self.cos(a);
                self.mul(cosine, d(a))
            }
            Op::Cos(a) => {
                let sine = self.sin(a);
                let product = self.mul(sine, d(a));
                self.neg(product)
            }
            Op::Atan2(y, x) => {
                let numerator = self.difference_of_products(x, d(y), y, d(x));
                let radius_squared = self.sum_of_products(x, x, y, y);
                self.div(numerator, radius_squared)
            }
            Op::Min(a, b) => {
                let is_less = self.sub(b, a);
                self.select(is_less, d(a), d(b))
            }
            Op::Max(a, b) => {
                let is_greater = self.sub(a, b);
                self.select(is_greater, d(a), d(b))
            }
            Op::Select(condition, a, b) => self.select(condition, d(a), d(b)),
        }
    }
}

fn of(known: &[Option<Id>], operand: Id) -> Id {
    known[operand.index()].expect("operands stand before their users")
}
