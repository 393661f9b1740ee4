//! Arithmetic that folds as it is built: structural zeros vanish, constants are computed, signs move outwards, common
//! factors of square roots and angles cancel.

use super::graph::{Graph, Id, Op};

/// What a sum is without its constant.
#[derive(Clone, Copy)]
struct Rest {
    minus: bool,
    id: Id,
}

impl Graph {
    /// A number.
    pub fn constant(&mut self, value: f64) -> Id {
        assert!(value.is_finite(), "a plan's constants are finite: the model was checked");
        self.intern(Op::Constant(value + 0.0))
    }

    /// An input.
    pub fn input(&mut self, index: usize) -> Id {
        self.intern(Op::Input(index))
    }

    /// The number a node stands for, if it is one.
    pub fn as_constant(&self, id: Id) -> Option<f64> {
        match self.op(id) {
            Op::Constant(value) => Some(value),
            _ => None,
        }
    }

    fn is(&self, id: Id, value: f64) -> bool {
        self.as_constant(id) == Some(value)
    }

    fn as_neg(&self, id: Id) -> Option<Id> {
        match self.op(id) {
            Op::Neg(a) => Some(a),
            _ => None,
        }
    }

    /// Whether a node is negated, and what is.
    pub(super) fn sign_and_rest(&self, a: Id) -> (bool, Id) {
        match self.op(a) {
            Op::Neg(b) => (true, b),
            _ => (false, a),
        }
    }

    /// The node, negated or not.
    pub(super) fn with_sign(&mut self, minus: bool, a: Id) -> Id {
        if minus { self.neg(a) } else { a }
    }

    pub(super) fn known_nonnegative(&self, id: Id) -> bool {
        self.nonnegative[id.index()]
    }

    /// `-a`
    pub fn neg(&mut self, a: Id) -> Id {
        match self.op(a) {
            Op::Constant(value) => self.constant(-value),
            Op::Neg(b) => b,
            Op::Sub(b, c) => self.sub(c, b),
            Op::Mul(b, c) if self.as_constant(b).is_some() => {
                let minus = self.neg(b);
                self.mul(minus, c)
            }
            _ => self.intern(Op::Neg(a)),
        }
    }

    /// `a + b`
    pub fn add(&mut self, a: Id, b: Id) -> Id {
        let (a, b) = self.ordered(a, b);
        if let (Some(x), Some(y)) = (self.as_constant(a), self.as_constant(b)) {
            return self.constant(x + y);
        }
        if self.is(a, 0.0) {
            return b;
        }
        if let Some(minus) = self.as_neg(b) {
            return self.sub(a, minus);
        }
        if let Some(minus) = self.as_neg(a) {
            return self.sub(b, minus);
        }
        if let Some(folded) = self.squares_of_one_angle(a, b) {
            return folded;
        }
        match (self.offset_and_rest(a), self.offset_and_rest(b)) {
            ((0.0, _), (0.0, _)) => self.intern(Op::Add(a, b)),
            ((x, None), (0.0, Some(_))) if x != 0.0 => self.intern(Op::Add(a, b)),
            ((x, rest_a), (y, rest_b)) => {
                let rest = self.sum_of_rests(rest_a, rest_b, false);
                self.with_offset(x + y, rest)
            }
        }
    }

    /// `a - b`
    pub fn sub(&mut self, a: Id, b: Id) -> Id {
        if let (Some(x), Some(y)) = (self.as_constant(a), self.as_constant(b)) {
            return self.constant(x - y);
        }
        if a == b {
            return self.constant(0.0);
        }
        if self.is(b, 0.0) {
            return a;
        }
        if self.is(a, 0.0) {
            return self.neg(b);
        }
        if let Some(plus) = self.as_neg(b) {
            return self.add(a, plus);
        }
        if let Some(minus) = self.as_neg(a) {
            let sum = self.add(minus, b);
            return self.neg(sum);
        }
        if let Some(folded) = self.difference_of_squares_of_one_angle(a, b) {
            return folded;
        }
        match (self.offset_and_rest(a), self.offset_and_rest(b)) {
            ((0.0, _), (0.0, _)) => self.intern(Op::Sub(a, b)),
            ((x, None), (0.0, Some(_))) if x != 0.0 => self.intern(Op::Sub(a, b)),
            ((x, rest_a), (y, rest_b)) => {
                let rest = self.sum_of_rests(rest_a, rest_b, true);
                self.with_offset(x - y, rest)
            }
        }
    }

    /// `a` as a number plus a rest: constants of nested sums meet, and may cancel.
    fn offset_and_rest(&self, a: Id) -> (f64, Option<Rest>) {
        match self.op(a) {
            Op::Constant(value) => (value, None),
            Op::Add(b, c) if self.as_constant(b).is_some() => {
                (self.as_constant(b).unwrap_or_default(), Some(Rest { minus: false, id: c }))
            }
            Op::Sub(b, c) if self.as_constant(b).is_some() => {
                (self.as_constant(b).unwrap_or_default(), Some(Rest { minus: true, id: c }))
            }
            _ => (0.0, Some(Rest { minus: false, id: a })),
        }
    }

    fn sum_of_rests(&mut self, a: Option<Rest>, b: Option<Rest>, subtract: bool) -> Rest {
        let b = b.map(|rest| Rest { minus: rest.minus != subtract, ..rest });
        match (a, b) {
            (Some(a), Some(b)) => match (a.minus, b.minus) {
                (false, false) => Rest { minus: false, id: self.add(a.id, b.id) },
                (true, true) => Rest { minus: true, id: self.add(a.id, b.id) },
                (false, true) => Rest { minus: false, id: self.sub(a.id, b.id) },
                (true, false) => Rest { minus: false, id: self.sub(b.id, a.id) },
            },
            (Some(rest), None) | (None, Some(rest)) => rest,
            (None, None) => unreachable!("the sum of two constants was folded before"),
        }
    }

    fn with_offset(&mut self, offset: f64, rest: Rest) -> Id {
        let offset = self.constant(offset);
        match rest.minus {
            // The rest has no offset of its own any more, so that these come to an end.
            false => self.add(offset, rest.id),
            true => self.sub(offset, rest.id),
        }
    }

    /// `a b`
    pub fn mul(&mut self, a: Id, b: Id) -> Id {
        let (a, b) = self.ordered(a, b);
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(x), Some(y)) => return self.constant(x * y),
            (Some(0.0), _) => return a,
            (Some(1.0), _) => return b,
            (Some(-1.0), _) => return self.neg(b),
            (Some(x), None) => return self.scaled(x, a, b),
            _ => {}
        }
        match (self.sign_and_rest(a), self.sign_and_rest(b)) {
            ((false, _), (false, _)) => self.intern(Op::Mul(a, b)),
            ((minus_a, x), (minus_b, y)) => {
                let product = self.mul(x, y);
                self.with_sign(minus_a != minus_b, product)
            }
        }
    }

    /// A number times `b`, where `b` is none.
    fn scaled(&mut self, factor: f64, constant: Id, b: Id) -> Id {
        match self.op(b) {
            Op::Neg(c) => {
                let minus = self.constant(-factor);
                self.mul(minus, c)
            }
            Op::Mul(c, d) => match self.as_constant(c) {
                Some(inner) => {
                    let product = self.constant(factor * inner);
                    self.mul(product, d)
                }
                None => self.intern(Op::Mul(constant, b)),
            },
            _ => self.intern(Op::Mul(constant, b)),
        }
    }

    /// `a / b`
    pub fn div(&mut self, a: Id, b: Id) -> Id {
        if a == b {
            return self.constant(1.0);
        }
        if self.is(a, 0.0) {
            return a;
        }
        if let Some(y) = self.as_constant(b) {
            let inverse = self.constant(1.0 / y);
            return self.mul(inverse, a);
        }
        match (self.sign_and_rest(a), self.sign_and_rest(b)) {
            ((false, _), (false, _)) => self.intern(Op::Div(a, b)),
            ((minus_a, x), (minus_b, y)) => {
                let quotient = self.div(x, y);
                self.with_sign(minus_a != minus_b, quotient)
            }
        }
    }

    /// The square root; of a square, what was squared (without its sign).
    pub fn sqrt(&mut self, a: Id) -> Id {
        match self.op(a) {
            Op::Constant(value) => self.constant(value.sqrt()),
            Op::Mul(b, c) if b == c => self.abs(b),
            Op::Mul(b, c) => match self.square_root_of_factor(b, c) {
                Some(product) => product,
                None => self.intern(Op::Sqrt(a)),
            },
            _ => self.intern(Op::Sqrt(a)),
        }
    }

    /// `√(b c)` where one of the two is a square of something and the other is not negative.
    fn square_root_of_factor(&mut self, b: Id, c: Id) -> Option<Id> {
        if !(self.known_nonnegative(b) && self.known_nonnegative(c)) {
            return None;
        }
        let is_square = |graph: &Self, id: Id| match graph.op(id) {
            Op::Mul(x, y) => x == y,
            Op::Constant(_) => true,
            _ => false,
        };
        if !is_square(self, b) && !is_square(self, c) {
            return None;
        }
        let (x, y) = (self.sqrt(b), self.sqrt(c));
        Some(self.mul(x, y))
    }

    fn abs(&mut self, a: Id) -> Id {
        if self.known_nonnegative(a) {
            return a;
        }
        let minus = self.neg(a);
        self.max(a, minus)
    }

    /// The lesser.
    pub fn min(&mut self, a: Id, b: Id) -> Id {
        let (a, b) = self.ordered(a, b);
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(x), Some(y)) => self.constant(x.min(y)),
            _ if a == b => a,
            (Some(x), None) if x <= 0.0 && self.known_nonnegative(b) => a,
            _ => self.intern(Op::Min(a, b)),
        }
    }

    /// The greater.
    pub fn max(&mut self, a: Id, b: Id) -> Id {
        let (a, b) = self.ordered(a, b);
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(x), Some(y)) => self.constant(x.max(y)),
            _ if a == b => a,
            (Some(x), None) if x <= 0.0 && self.known_nonnegative(b) => b,
            _ => self.intern(Op::Max(a, b)),
        }
    }

    /// `b` where `condition > 0`, else `c`.
    pub fn select(&mut self, condition: Id, b: Id, c: Id) -> Id {
        match self.as_constant(condition) {
            Some(value) if value > 0.0 => b,
            Some(_) => c,
            None if b == c => b,
            None => self.intern(Op::Select(condition, b, c)),
        }
    }

    /// Operands of a commutative operation: a constant first, else the older node first.
    fn ordered(&self, a: Id, b: Id) -> (Id, Id) {
        let rank = |id: Id| (self.as_constant(id).is_none(), id);
        if rank(a) <= rank(b) { (a, b) } else { (b, a) }
    }
}
