//! The angle that brings the tip to the linear axes, where there are two of these and the only rotary turns about the tool.

use super::Angles;
use super::chain::{Chain, Element, Values, filled};
use super::orientation::{Orientation, angle_of_point};
use super::position;
use super::symbolic::{Vector, constant, cross, dot, norm, scale, sub};
use crate::plan::{Graph, Id, Inputs};
use mach_runtime::kinematics::Pole;
use std::f64::consts::{FRAC_PI_2, PI};

/// The two angles of the rotary at which the tip lies in the plane of the linear axes.
///
/// That the tip can be reached says that `det(d1, d2, r) = 0`, with `d1`, `d2` the directions of the linear axes and `r`
/// the way they have to go. Wherever the rotary stands in the chain, this is `a cos θ + b sin θ + d`. Its roots are
/// `(cos θ, sin θ) = (-a d ∓ b w, -b d ± a w) / ρ²` with `ρ² = a² + b²` and `w² = ρ² - d²`; without a root the tip is
/// inside the dead radius.
pub(super) fn solve(
    graph: &mut Graph,
    chain: &Chain,
    inputs: &Inputs,
    given: &Values,
    rotary: &Element,
    orientation: &Orientation<'_>,
) -> Angles {
    let [at_zero, at_right_angle, at_half_turn] = [0.0, FRAC_PI_2, PI].map(|angle| {
        let angle = graph.constant(angle);
        let known = filled(given, Element::is_rotary, &chain.elements, &[angle]);
        let (columns, right) = position::equations(graph, chain, inputs.tip, inputs.tool_length, &known);
        let normal = cross(graph, columns[0], columns[1]);
        (dot(graph, normal, right), normal)
    });
    let (two_d, half) = (graph.add(at_zero.0, at_half_turn.0), graph.constant(0.5));
    let d = graph.mul(half, two_d);
    let (a, b) = (graph.sub(at_zero.0, d), graph.sub(at_right_angle.0, d));
    let amplitude = graph.sum_of_products(a, a, b, b);
    let (amplitude, size) = (graph.sqrt(amplitude), size(graph, d));
    let root = root(graph, amplitude, size);
    let branches = roots(graph, [a, b, d], root);
    let across = across(graph, rotary, at_zero.1);
    let zero = graph.constant(0.0);
    let short = graph.sub(size, amplitude);
    let short = graph.max(zero, short);
    Angles {
        branches: branches.map(|angle| vec![angle]).to_vec(),
        reach: orientation.deviation(graph),
        pole_distance: graph.div(amplitude, across),
        pole: Some(Pole::Position { axis: rotary.axis }),
        gap: Some(graph.div(short, across)),
    }
}

/// `|d|`
fn size(graph: &mut Graph, d: Id) -> Id {
    match graph.as_constant(d) {
        Some(d) => graph.constant(d.abs()),
        None => {
            let opposite = graph.neg(d);
            graph.max(d, opposite)
        }
    }
}

/// `√(ρ² - d²)`, as a product that keeps its digits; zero where there is none.
fn root(graph: &mut Graph, amplitude: Id, size: Id) -> Id {
    let (less, more) = (graph.sub(amplitude, size), graph.add(amplitude, size));
    let product = graph.mul(less, more);
    let zero = graph.constant(0.0);
    let radicand = graph.max(zero, product);
    graph.sqrt(radicand)
}

fn roots(graph: &mut Graph, [a, b, d]: [Id; 3], root: Id) -> [Id; 2] {
    let opposite = graph.neg(root);
    let minus_d = graph.neg(d);
    [root, opposite].map(|root| {
        let sine = graph.sum_of_products(b, minus_d, a, root);
        let cosine = graph.difference_of_products(a, minus_d, b, root);
        angle_of_point(graph, sine, cosine)
    })
}

/// How far the normal of the linear axes' plane is across the rotary: what a millimetre at a right angle to the rotary
/// counts in the determinant.
fn across(graph: &mut Graph, rotary: &Element, normal: Vector) -> Id {
    let n = constant(graph, &rotary.direction);
    let along = dot(graph, n, normal);
    let along = scale(graph, along, n);
    let across = sub(graph, normal, along);
    norm(graph, across)
}
