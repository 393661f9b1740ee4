//! The angles that turn the tool into a wanted direction, by the number of rotaries.

use super::Angles;
use super::chain::{Chain, Element, Values};
use super::symbolic::{Turn, Vector, as_constant, constant, cross, dot, norm};
use crate::model::directions::ALONG_SINE;
use crate::plan::{Graph, Id, snap};
use mach_runtime::kinematics::Pole;
use nalgebra::Vector3;

/// A rotary element whose value is given.
type Given<'a> = (&'a Element, Turn);

/// What is to be solved: the given rotaries before the first and behind the last of the solved ones are taken into the
/// directions beside them.
pub(super) struct Orientation<'a> {
    /// The rotaries to be solved, from the workpiece to the tool.
    solved: Vec<&'a Element>,
    /// The given ones between them.
    between: Vec<Given<'a>>,
    /// The wanted tool axis as seen from the first of them.
    wanted: Vector,
    /// The tool axis as the last of them sees it.
    tool: Vector,
}

impl<'a> Orientation<'a> {
    /// The problem for the wanted tool axis `u`.
    pub(super) fn of(graph: &mut Graph, chain: &'a Chain, given: &Values, u: Vector) -> Self {
        let mut orientation =
            Self { solved: vec![], between: vec![], wanted: u, tool: constant(graph, &chain.tool_axis) };
        // The given rotaries since the last solved one.
        let mut open: Vec<Given<'a>> = Vec::new();
        for (element, value) in chain.elements.iter().zip(given).filter(|(element, _)| element.is_rotary()) {
            match value {
                Some(value) => open.push((element, Turn::by(graph, *value))),
                None => orientation.next(graph, element, std::mem::take(&mut open)),
            }
        }
        orientation.tool = turned(graph, &open, orientation.tool);
        orientation
    }

    /// Takes up a rotary to be solved, with the given ones before it.
    fn next(&mut self, graph: &mut Graph, element: &'a Element, before: Vec<Given<'a>>) {
        if self.solved.is_empty() {
            for (given, turn) in before {
                self.wanted = turn.back(graph).apply(graph, &given.direction, self.wanted);
            }
        } else {
            self.between = before;
        }
        self.solved.push(element);
    }

    /// The only rotary to be solved, where it turns about the tool.
    pub(super) fn rotary_along_tool(&self, graph: &Graph) -> Option<&'a Element> {
        let ([only], Some(tool)) = (&self.solved[..], as_constant(graph, self.tool)) else { return None };
        (only.direction.cross(&tool).norm() < ALONG_SINE).then_some(only)
    }

    pub(super) fn solve(&self, graph: &mut Graph) -> Angles {
        match self.solved[..] {
            [] => self.fixed(graph),
            [only] => self.one(graph, &only.direction),
            [first, second] => Two::new(graph, self, first, second).solve(graph, self),
            _ => unreachable!("a checked machine has at most two rotary axes to be solved"),
        }
    }

    /// The tool axis is what it is: minus the angle to the wanted one.
    pub(super) fn deviation(&self, graph: &mut Graph) -> Id {
        let deviation = angle_between(graph, self.tool, self.wanted).0;
        graph.neg(deviation)
    }

    fn fixed(&self, graph: &mut Graph) -> Angles {
        let reach = self.deviation(graph);
        Angles { branches: vec![vec![]], reach, pole_distance: graph.constant(1.0), pole: None, gap: None }
    }

    /// One rotary turns the tool on a cone; the wanted direction must be on it.
    fn one(&self, graph: &mut Graph, n: &Vector3<f64>) -> Angles {
        let t = as_constant(graph, self.tool).expect("beside a single rotary to be solved others are locked");
        let sideways = constant(graph, &n.cross(&t).map(snap));
        let outwards = constant(graph, &(t - n * n.dot(&t)).map(snap));
        let (y, x) = (dot(graph, sideways, self.wanted), dot(graph, outwards, self.wanted));
        let theta = angle_of_point(graph, y, x);
        let cone = graph.constant(libm::atan2(n.cross(&t).norm(), n.dot(&t)));
        let direction = constant(graph, n);
        let tilt = angle_between(graph, direction, self.wanted).0;
        let excess = graph.sub(tilt, cone);
        let opposite = graph.neg(excess);
        let reach = graph.min(excess, opposite);
        Angles { branches: vec![vec![theta]], reach, pole_distance: graph.constant(1.0), pole: None, gap: None }
    }
}

/// A direction behind given rotaries, as seen from before them.
fn turned(graph: &mut Graph, given: &[Given<'_>], v: Vector) -> Vector {
    given.iter().rev().fold(v, |v, (element, turn)| turn.apply(graph, &element.direction, v))
}

/// Two rotaries: the spherical triangle of first direction, second direction and tool, solved in half angles, which
/// keep their digits near the pole.
struct Two<'a> {
    first: &'a Element,
    second: &'a Element,
    triangle: Triangle,
}

/// The sides and the angle of the triangle that the wanted direction does not change. All are constants unless a surplus
/// rotary turns the second rotary or the tool.
struct Triangle {
    /// (α + β) / 2 and (α - β) / 2, with α from the first rotary to the second and β from that to the tool.
    half_sum: Id,
    half_difference: Id,
    /// The second angle at which both rotaries and the tool lie in one plane.
    phi: Id,
}

/// Angles of the machine that differ by less than this are equal: a few roundings of π.
const SAME_ANGLE_RAD: f64 = 16.0 * f64::EPSILON;

impl Triangle {
    /// Of a machine's constant directions.
    fn of_constants(graph: &mut Graph, n1: &Vector3<f64>, n2: &Vector3<f64>, t: &Vector3<f64>) -> Self {
        let angle = |a: &Vector3<f64>, b: &Vector3<f64>| libm::atan2(a.cross(b).norm(), a.dot(b));
        let equal = |a: f64, b: f64| if (a - b).abs() < SAME_ANGLE_RAD { b } else { a };
        let (alpha, beta) = (angle(n1, n2), angle(n2, t));
        let phi = libm::atan2(snap(n1.dot(&n2.cross(t))), snap(n1.dot(t) - n1.dot(n2) * n2.dot(t)));
        Self {
            half_sum: graph.constant(equal(alpha + beta, std::f64::consts::PI) / 2.0),
            half_difference: graph.constant(equal(alpha - beta, 0.0) / 2.0),
            phi: graph.constant(phi),
        }
    }

    /// Of directions that surplus rotaries turn.
    fn of_expressions(graph: &mut Graph, n1: Vector, n2: Vector, t: Vector) -> Self {
        let [alpha, beta] = [(n1, n2), (n2, t)].map(|(a, b)| {
            let angle = angle_between(graph, a, b).0;
            half(graph, angle)
        });
        let normal = cross(graph, n2, t);
        let y = dot(graph, n1, normal);
        let [along, cosine_alpha, cosine_beta] = [(n1, t), (n1, n2), (n2, t)].map(|(a, b)| dot(graph, a, b));
        let product = graph.mul(cosine_alpha, cosine_beta);
        let x = graph.sub(along, product);
        Self {
            half_sum: graph.add(alpha, beta),
            half_difference: graph.sub(alpha, beta),
            phi: angle_of_point(graph, y, x),
        }
    }
}

/// Half of an angle from 0 to π.
fn half(graph: &mut Graph, angle: Id) -> Id {
    match graph.as_constant(angle) {
        Some(angle) => graph.constant(angle / 2.0),
        None => graph.half_angle(angle),
    }
}

impl<'a> Two<'a> {
    fn new(graph: &mut Graph, problem: &Orientation<'a>, first: &'a Element, second: &'a Element) -> Self {
        let n2 = constant(graph, &second.direction);
        let n2 = turned(graph, &problem.between, n2);
        let tool = turned(graph, &problem.between, problem.tool);
        let triangle = match (as_constant(graph, n2), as_constant(graph, tool)) {
            (Some(n2), Some(tool)) => Triangle::of_constants(graph, &first.direction, &n2, &tool),
            _ => {
                let n1 = constant(graph, &first.direction);
                Triangle::of_expressions(graph, n1, n2, tool)
            }
        };
        Self { first, second, triangle }
    }

    fn solve(&self, graph: &mut Graph, problem: &Orientation<'a>) -> Angles {
        let n1 = constant(graph, &self.first.direction);
        let (gamma, pole_distance) = angle_between(graph, n1, problem.wanted);
        let half = graph.half_angle(gamma);
        let factors = self.half_angle_sines(graph, half);
        let opening = opening(graph, factors);
        let phi = self.triangle.phi;
        let second = [graph.add(phi, opening), graph.sub(phi, opening)];
        let branches = second.map(|theta2| vec![self.first_angle(graph, problem, theta2), theta2]).to_vec();
        let pole = Some(Pole::Direction { axis: self.first.axis });
        Angles { branches, reach: reach(graph, factors), pole_distance, pole, gap: None }
    }

    /// The sines of (γ+α-β)/2, (γ-α+β)/2, (α+β+γ)/2, (α+β-γ)/2: none is negative inside the reach.
    fn half_angle_sines(&self, graph: &mut Graph, half: Id) -> [Id; 4] {
        let (sum, difference) = (self.triangle.half_sum, self.triangle.half_difference);
        let opposite = graph.neg(difference);
        let angles =
            [graph.add(difference, half), graph.add(opposite, half), graph.add(sum, half), graph.sub(sum, half)];
        angles.map(|angle| graph.sin(angle))
    }

    /// The first angle: the turn about n1 that takes the tool, turned by the second, to the wanted direction.
    fn first_angle(&self, graph: &mut Graph, problem: &Orientation<'a>, theta2: Id) -> Id {
        let v = Turn::by(graph, theta2).apply(graph, &self.second.direction, problem.tool);
        let v = turned(graph, &problem.between, v);
        let (e1, e2) = plane_normal_to(&self.first.direction);
        let (e1, e2) = (constant(graph, &e1), constant(graph, &e2));
        let a = [dot(graph, e1, v), dot(graph, e2, v)];
        let b = [dot(graph, e1, problem.wanted), dot(graph, e2, problem.wanted)];
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

/// The angle between two unit vectors, and its sine.
fn angle_between(graph: &mut Graph, n: Vector, u: Vector) -> (Id, Id) {
    let normal = cross(graph, n, u);
    let (sine, cosine) = (norm(graph, normal), dot(graph, n, u));
    let angle = graph.atan2(sine, cosine);
    if graph.as_constant(angle).is_none() {
        graph.define_angle(angle, sine, cosine);
    }
    (angle, sine)
}

/// The angle of a point in the plane, with sine and cosine of a true turn however short the vector is.
pub(super) fn angle_of_point(graph: &mut Graph, y: Id, x: Id) -> Id {
    let angle = graph.atan2(y, x);
    let (y, x) = graph.point_of_angle(angle).unwrap_or((y, x));
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
