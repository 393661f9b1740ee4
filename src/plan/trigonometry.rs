//! Trigonometry that folds as it is built. An angle made by [`Graph::atan2`] of a point on the unit circle knows its sine
//! and cosine; sums with constants and halves of it know theirs, so that few trigonometric functions are left.

use super::graph::{Graph, Id, Op};

/// A sine or cosine of a constant below this is a structural zero: a few ulp of 1.
const STRUCTURAL_ZERO: f64 = 4.0 * f64::EPSILON;

/// The sine of a constant angle, with 0 and ±1 where only rounding keeps it from them.
pub fn sin_constant(angle_rad: f64) -> f64 {
    snap(libm::sin(angle_rad))
}

/// The cosine of a constant angle, with 0 and ±1 where only rounding keeps it from them.
pub fn cos_constant(angle_rad: f64) -> f64 {
    snap(libm::cos(angle_rad))
}

/// 0, 1 or -1 where the value is that up to rounding.
pub fn snap(value: f64) -> f64 {
    let nearest = value.round();
    if (value - nearest).abs() < STRUCTURAL_ZERO && nearest.abs() <= 1.0 { nearest + 0.0 } else { value }
}

impl Graph {
    /// Says that the sine and the cosine of an angle are these nodes.
    pub fn define_angle(&mut self, angle: Id, sine: Id, cosine: Id) {
        self.angles.insert(angle, (sine, cosine));
    }

    /// The sine.
    pub fn sin(&mut self, angle: Id) -> Id {
        self.sine_and_cosine(angle).0
    }

    /// The cosine.
    pub fn cos(&mut self, angle: Id) -> Id {
        self.sine_and_cosine(angle).1
    }

    /// Both, from what is known of the angle.
    pub fn sine_and_cosine(&mut self, angle: Id) -> (Id, Id) {
        if let Some(&known) = self.angles.get(&angle) {
            return known;
        }
        match self.op(angle) {
            Op::Constant(value) => (self.constant(sin_constant(value)), self.constant(cos_constant(value))),
            Op::Neg(a) => {
                let (sine, cosine) = self.sine_and_cosine(a);
                (self.neg(sine), cosine)
            }
            Op::Add(a, b) if self.as_constant(a).is_some() || self.are_known(a, b) => self.sum_formula(a, b, false),
            Op::Sub(a, b) if self.as_constant(a).is_some() || self.are_known(a, b) => self.sum_formula(a, b, true),
            _ => (self.intern(Op::Sin(angle)), self.intern(Op::Cos(angle))),
        }
    }

    /// Whether sine and cosine of both angles are at hand without a trigonometric function.
    fn are_known(&self, a: Id, b: Id) -> bool {
        let is_known = |angle: Id| match self.op(angle) {
            _ if self.angles.contains_key(&angle) => true,
            Op::Constant(_) => true,
            Op::Neg(a) => self.are_known(a, a),
            Op::Add(a, b) | Op::Sub(a, b) => self.are_known(a, b),
            _ => false,
        };
        is_known(a) && is_known(b)
    }

    /// Sine and cosine of `a + b` or `a - b`.
    fn sum_formula(&mut self, a: Id, b: Id, minus: bool) -> (Id, Id) {
        let (sin_a, cos_a) = self.sine_and_cosine(a);
        let (sin_b, cos_b) = self.sine_and_cosine(b);
        let sin_b = if minus { self.neg(sin_b) } else { sin_b };
        (self.sum_of_products(sin_a, cos_b, cos_a, sin_b), self.difference_of_products(cos_a, cos_b, sin_a, sin_b))
    }

    /// `a b + c d`
    pub fn sum_of_products(&mut self, a: Id, b: Id, c: Id, d: Id) -> Id {
        let (left, right) = (self.mul(a, b), self.mul(c, d));
        self.add(left, right)
    }

    /// `a b - c d`
    pub fn difference_of_products(&mut self, a: Id, b: Id, c: Id, d: Id) -> Id {
        let (left, right) = (self.mul(a, b), self.mul(c, d));
        self.sub(left, right)
    }

    /// The angle of the point (x, y). A common factor that is not negative cancels.
    pub fn atan2(&mut self, y: Id, x: Id) -> Id {
        if let (Some(y), Some(x)) = (self.as_constant(y), self.as_constant(x)) {
            return self.constant(libm::atan2(y, x));
        }
        if let Some((y, x)) = self.without_common_factor(y, x) {
            return self.atan2(y, x);
        }
        // The angle that has this sine and this cosine, if there is one from 0 to π.
        let known = self.angles.iter().find(|&(_, &pair)| pair == (y, x)).map(|(&angle, _)| angle);
        match known {
            Some(angle) if self.known_nonnegative(y) => angle,
            _ => self.half_turn_from_known(y, x).unwrap_or_else(|| self.intern(Op::Atan2(y, x))),
        }
    }

    /// The angle of a point whose opposite has its angle already: half a turn away, without a second arc tangent.
    fn half_turn_from_known(&mut self, y: Id, x: Id) -> Option<Id> {
        let opposite = Op::Atan2(self.neg(y), self.neg(x));
        let angle = self.find(opposite)?;
        let half_turn = self.constant(std::f64::consts::PI);
        let (less, more) = (self.sub(angle, half_turn), self.add(angle, half_turn));
        let result = self.select(angle, less, more);
        self.points.insert(result, (y, x));
        Some(result)
    }

    /// The point (x, y), given as (y, x), that an angle is the angle of.
    pub fn point_of_angle(&self, angle: Id) -> Option<(Id, Id)> {
        match self.op(angle) {
            Op::Atan2(y, x) => Some((y, x)),
            _ => self.points.get(&angle).copied(),
        }
    }

    /// `(y / k, x / k)` where both have a factor `k >= 0`.
    fn without_common_factor(&mut self, y: Id, x: Id) -> Option<(Id, Id)> {
        let ((minus_y, y), (minus_x, x)) = (self.sign_and_rest(y), self.sign_and_rest(x));
        let (Op::Mul(a, b), Op::Mul(c, d)) = (self.op(y), self.op(x)) else { return None };
        let (shared, rest_y, rest_x) = [(a, b, c, d), (a, b, d, c), (b, a, c, d), (b, a, d, c)]
            .into_iter()
            .find(|&(k, _, l, _)| k == l && self.known_nonnegative(k))
            .map(|(k, rest_y, _, rest_x)| (k, rest_y, rest_x))?;
        debug_assert!(self.known_nonnegative(shared), "only a factor that keeps the quadrant may cancel");
        Some((self.with_sign(minus_y, rest_y), self.with_sign(minus_x, rest_x)))
    }

    /// `sin² h + cos² h = 1`.
    pub(super) fn squares_of_one_angle(&mut self, a: Id, b: Id) -> Option<Id> {
        let angle = self.squared_pair(a, b).or_else(|| self.squared_pair(b, a))?;
        debug_assert!(self.angles.contains_key(&angle), "the pair was found among the known angles");
        Some(self.constant(1.0))
    }

    /// `cos² h - sin² h = cos 2h`.
    pub(super) fn difference_of_squares_of_one_angle(&mut self, a: Id, b: Id) -> Option<Id> {
        let half = self.squared_pair(b, a)?;
        let double = self.double_of(half)?;
        Some(self.cos(double))
    }

    /// `2 sin h cos h = sin 2h`, for an angle whose double is known.
    pub fn double_sine(&mut self, product: Id) -> Id {
        let two = self.constant(2.0);
        if let Op::Mul(a, b) = self.op(product) {
            let half = self.angle_of_pair(a, b).or_else(|| self.angle_of_pair(b, a));
            if let Some(double) = half.and_then(|half| self.double_of(half)) {
                return self.sin(double);
            }
        }
        self.mul(two, product)
    }

    /// The angle whose squared sine and cosine these two are.
    fn squared_pair(&self, sine_squared: Id, cosine_squared: Id) -> Option<Id> {
        match (self.op(sine_squared), self.op(cosine_squared)) {
            (Op::Mul(a, b), Op::Mul(c, d)) if a == b && c == d => self.angle_of_pair(a, c),
            _ => None,
        }
    }

    fn angle_of_pair(&self, sine: Id, cosine: Id) -> Option<Id> {
        self.angles.iter().find(|&(_, &pair)| pair == (sine, cosine)).map(|(&angle, _)| angle)
    }

    /// The known angle of which this one is the half.
    fn double_of(&self, half: Id) -> Option<Id> {
        match self.op(half) {
            Op::Mul(factor, angle) if self.as_constant(factor) == Some(0.5) => Some(angle),
            _ => None,
        }
    }

    /// The angles whose sine and cosine are at hand, each with both.
    pub fn known_angles(&self) -> impl Iterator<Item = (Id, Id, Id)> + '_ {
        self.angles.iter().map(|(&angle, &(sine, cosine))| (angle, sine, cosine))
    }

    /// Whether a node is the sine (`true`) or the cosine of half a known angle, and that whole angle.
    pub fn half_angle_of(&self, id: Id) -> Option<(bool, Id)> {
        let halves = self.angles.iter().filter_map(|(&half, &pair)| Some((self.double_of(half)?, pair)));
        halves
            .filter(|(_, (sine, cosine))| id == *sine || id == *cosine)
            .map(|(double, (sine, _))| (id == sine, double))
            .next()
    }

    /// The half of an angle from 0 to π with known sine and cosine, without a trigonometric function: the larger of
    /// the two half-angle functions from the root, the smaller from the sine, so that neither loses digits.
    pub fn half_angle(&mut self, angle: Id) -> Id {
        let (sine, cosine) = self.sine_and_cosine(angle);
        let (one, half, minus) = (self.constant(1.0), self.constant(0.5), self.neg(cosine));
        let magnitude = self.max(cosine, minus);
        let sum = self.add(one, magnitude);
        let squared = self.mul(half, sum);
        let larger = self.sqrt(squared);
        let twice = self.add(larger, larger);
        let smaller = self.div(sine, twice);
        let half_sine = self.select(cosine, smaller, larger);
        let half_cosine = self.select(cosine, larger, smaller);
        let result = self.mul(half, angle);
        self.define_angle(result, half_sine, half_cosine);
        result
    }
}

#[cfg(test)]
mod tests {
    use crate::plan::{Graph, Op, Program};

    #[test]
    fn the_opposite_angle_is_half_a_turn_away_and_prints_as_an_arc_tangent() {
        let mut graph = Graph::default();
        let [y, x] = [0, 1].map(|input| graph.input(input));
        let [minus_y, minus_x] = [y, x].map(|id| graph.neg(id));
        let angle = graph.atan2(y, minus_x);
        let opposite = graph.atan2(minus_y, x);
        assert_eq!(graph.op(angle), Op::Atan2(y, minus_x));
        assert_eq!(graph.point_of_angle(opposite), Some((minus_y, x)));
        let mut program = Program::<1>::new(&graph, 2, &[opposite]);
        for (y, x) in [(0.3, 0.4), (-0.3, 0.4), (0.3, -0.4), (-0.3, -0.4), (1e-20, -1.0), (0.0, -1.0)] {
            (*program.input(0), *program.input(1)) = ([y], [x]);
            program.run();
            let [found] = *program.output(0);
            let (expected, half_turn) = (libm::atan2(-y, x), std::f64::consts::PI);
            assert!((found.abs() - expected.abs()).abs() <= f64::EPSILON * half_turn, "{y} {x}: {found}");
            assert!(found * expected > 0.0 || found.abs() == half_turn, "{y} {x}: {found}");
        }
    }
}
