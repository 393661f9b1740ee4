//! The angles that turn the tool into a wanted direction, by the number of rotaries.

use super::chain::{Chain, Element};
use super::symbolic::{Turn, Vector, constant, cross, dot, norm};
use crate::plan::{Graph, Id, Op, snap};
use nalgebra::Vector3;

/// What the wanted direction asks of the rotary elements.
pub(super) struct Orientation {
    /// For each branch the angle of each rotary element, from the workpiece to the tool.
    pub(super) branches: Vec<Vec<Id>>,
    /// Zero inside the reach, else minus the angle to it.
    pub(super) reach: Id,
    /// The sine of the angle between the wanted direction and the first rotary.
    pub(super) pole_sine: Id,
}

/// The angles for the wanted tool axis `u`.
pub(super) fn solve(graph: &mut Graph, chain: &Chain, u: Vector) -> Orientation {
    let rotaries: Vec<&Element> = chain.rotaries().collect();
    match rotaries[..] {
        [] => none(graph, &chain.tool_axis, u),
        [only] => one(graph, &only.direction, &chain.tool_axis, u),
        [first, second] => Two::new(&first.direction, &second.direction, &chain.tool_axis).solve(graph, u),
        _ => unreachable!("a checked chain has at most two rotary axes"),
    }
}

/// The tool axis is what it is.
fn none(graph: &mut Graph, t: &Vector3<f64>, u: Vector) -> Orientation {
    let deviation = angle_between(graph, t, u).0;
    Orientation { branches: vec![vec![]], reach: graph.neg(deviation), pole_sine: graph.constant(1.0) }
}

/// One rotary turns the tool on a cone; the wanted direction must be on it.
fn one(graph: &mut Graph, n: &Vector3<f64>, t: &Vector3<f64>, u: Vector) -> Orientation {
    let sideways = constant(graph, &n.cross(t).map(snap));
    let outwards = constant(graph, &(t - n * n.dot(t)).map(snap));
    let (y, x) = (dot(graph, sideways, u), dot(graph, outwards, u));
    let theta = angle_of_point(graph, y, x);
    let cone = graph.constant(libm::atan2(n.cross(t).norm(), n.dot(t)));
    let tilt = angle_between(graph, n, u).0;
    let excess = graph.sub(tilt, cone);
    let opposite = graph.neg(excess);
    Orientation { branches: vec![vec![theta]], reach: graph.min(excess, opposite), pole_sine: graph.constant(1.0) }
}

/// Two rotaries: the spherical triangle of first direction, second direction and tool, solved in half angles, which
/// keep their digits near the pole.
struct Two<'a> {
    n1: &'a Vector3<f64>,
    n2: &'a Vector3<f64>,
    t: &'a Vector3<f64>,
    /// α + β and α - β, with α = ∠(n1, n2) and β = ∠(n2, t).
    sum: f64,
    difference: f64,
    /// The second angle at which n1, n2 and t lie in one plane.
    phi: f64,
}

/// Angles of the machine that differ by less than this are equal: a few roundings of π.
const SAME_ANGLE_RAD: f64 = 16.0 * f64::EPSILON;

impl<'a> Two<'a> {
    fn new(n1: &'a Vector3<f64>, n2: &'a Vector3<f64>, t: &'a Vector3<f64>) -> Self {
        let angle = |a: &Vector3<f64>, b: &Vector3<f64>| libm::atan2(a.cross(b).norm(), a.dot(b));
        let equal = |a: f64, b: f64| if (a - b).abs() < SAME_ANGLE_RAD { b } else { a };
        let (alpha, beta) = (angle(n1, n2), angle(n2, t));
        let phi = libm::atan2(snap(n1.dot(&n2.cross(t))), snap(n1.dot(t) - n1.dot(n2) * n2.dot(t)));
        let sum = equal(alpha + beta, std::f64::consts::PI);
        Self { n1, n2, t, sum, difference: equal(alpha - beta, 0.0), phi }
    }

    fn solve(&self, graph: &mut Graph, u: Vector) -> Orientation {
        let (gamma, pole_sine) = angle_between(graph, self.n1, u);
        let half = graph.half_angle(gamma);
        let factors = self.half_angle_sines(graph, half);
        let opening = opening(graph, factors);
        let phi = graph.constant(self.phi);
        let second = [graph.add(phi, opening), graph.sub(phi, opening)];
        let branches = second.map(|theta2| vec![self.first(graph, theta2, u), theta2]).to_vec();
        Orientation { branches, reach: reach(graph, factors), pole_sine }
    }

    /// The sines of (γ+α-β)/2, (γ-α+β)/2, (α+β+γ)/2, (α+β-γ)/2: none is negative inside the reach.
    fn half_angle_sines(&self, graph: &mut Graph, half: Id) -> [Id; 4] {
        let difference = graph.constant(self.difference / 2.0);
        let opposite = graph.neg(difference);
        let sum = graph.constant(self.sum / 2.0);
        let angles =
            [graph.add(difference, half), graph.add(opposite, half), graph.add(sum, half), graph.sub(sum, half)];
        angles.map(|angle| graph.sin(angle))
    }

    /// The first angle: the turn about n1 that takes the tool, turned by the second, to the wanted direction.
    fn first(&self, graph: &mut Graph, theta2: Id, u: Vector) -> Id {
        let tool = constant(graph, self.t);
        let v = Turn::by(graph, theta2).apply(graph, self.n2, tool);
        let (e1, e2) = plane_normal_to(self.n1);
        let (e1, e2) = (constant(graph, &e1), constant(graph, &e2));
        let a = [dot(graph, e1, v), dot(graph, e2, v)];
        let b = [dot(graph, e1, u), dot(graph, e2, u)];
        let y = graph.difference_of_products(a[0], b[1], a[1], b[0]);
        let x = graph.sum_of_products(a[0], b[0], a[1], b[1]);
        angle_of_point(graph, y, x)
    }
}

/// The angle from `phi` to the second angle: 2 atan2(√s1, √s2), which is atan2(2 √(s1 s2), s2 - s1).
fn opening(graph: &mut Graph, [a, b, c, d]: [Id; 4]) -> Id {
    let zero = graph.constant(0.0);
    let radicands = [(a, b), (c, d)].map(|(x, y)| {
        let product = graph.mul(x, y);
        graph.max(zero, product)
    });
    let product = graph.mul(radicands[0], radicands[1]);
    let root = graph.sqrt(product);
    let y = graph.double_sine(root);
    let x = graph.sub(radicands[1], radicands[0]);
    let angle = graph.atan2(y, x);
    let radius = graph.add(radicands[0], radicands[1]);
    let (sine, cosine) = (graph.div(y, radius), graph.div(x, radius));
    graph.define_angle(angle, sine, cosine);
    angle
}

/// Twice the least of the sines where it is negative: about the angle by which the direction is out of reach.
fn reach(graph: &mut Graph, factors: [Id; 4]) -> Id {
    let (zero, two) = (graph.constant(0.0), graph.constant(2.0));
    let least = factors.into_iter().fold(zero, |least, factor| graph.min(least, factor));
    graph.mul(two, least)
}

/// The angle between a direction of the machine and a unit vector, and its sine.
fn angle_between(graph: &mut Graph, n: &Vector3<f64>, u: Vector) -> (Id, Id) {
    let n = constant(graph, n);
    let normal = cross(graph, n, u);
    let (sine, cosine) = (norm(graph, normal), dot(graph, n, u));
    let angle = graph.atan2(sine, cosine);
    graph.define_angle(angle, sine, cosine);
    (angle, sine)
}

/// The angle of a point in the plane, with sine and cosine of a true turn however short the vector is.
fn angle_of_point(graph: &mut Graph, y: Id, x: Id) -> Id {
    let angle = graph.atan2(y, x);
    let (y, x) = match graph.op(angle) {
        Op::Atan2(y, x) => (y, x),
        _ => (y, x),
    };
    let squared = graph.sum_of_products(y, y, x, x);
    let radius = graph.sqrt(squared);
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let (sine, cosine) = (graph.div(y, radius), graph.div(x, radius));
    let (sine, cosine) = (graph.select(radius, sine, zero), graph.select(radius, cosine, one));
    graph.define_angle(angle, sine, cosine);
    angle
}

/// Two directions that make a right-handed frame with `n`: along the machine's own axes where `n` is.
fn plane_normal_to(n: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let most = n.iamax();
    let seed = Vector3::from_fn(|i, _| if i == (most + 1) % 3 { 1.0 } else { 0.0 });
    let e1 = (seed - n * n.dot(&seed)).normalize().map(snap);
    (e1, n.cross(&e1).map(snap))
}
