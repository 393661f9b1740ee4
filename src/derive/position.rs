//! The linear joints for given angles: the tip is affine in them.

use super::chain::{Chain, Element, Values};
use super::symbolic::{Turn, Vector, add, as_constant, constant, cross, dot, norm, scale, sub};
use crate::plan::{Graph, Id};
use std::iter::zip;

/// The linear joints.
pub(super) struct Placed {
    /// The values of the linear elements that were open, in the order of the chain.
    pub(super) linear: Vec<Id>,
    /// How far the tip is off the plane of two linear axes, in millimetres; zero where there are three.
    pub(super) gap: Id,
}

/// What an element does.
#[derive(Clone, Copy)]
enum Move {
    Turn(Turn),
    Shift(Id),
    /// A linear element that is solved for.
    Open,
}

/// The values of the open linear elements that put the tip on `tip`.
///
/// The elements before the first open one are taken off the tip; what is left is `D s = r`, with a constant `D` unless a
/// rotary stands between linear elements. Where det D is zero the values are not finite. Of two linear elements the
/// normal of their plane makes three, and what it has to move is the gap.
pub(super) fn solve(graph: &mut Graph, chain: &Chain, tip: Vector, tool_length: Id, values: &Values) -> Placed {
    let (columns, right) = equations(graph, chain, tip, tool_length, values);
    match columns[..] {
        [a, b, c] => Placed { linear: solve_three(graph, [a, b, c], right).to_vec(), gap: graph.constant(0.0) },
        [a, b] => {
            let normal = cross(graph, a, b);
            let normal = unit(graph, normal);
            let [first, second, off] = solve_three(graph, [a, b, normal], right);
            let opposite = graph.neg(off);
            Placed { linear: vec![first, second], gap: graph.max(off, opposite) }
        }
        _ => unreachable!("a checked chain has two or three linear axes to be solved"),
    }
}

/// Where each open element takes the tip, and where they have to take it together.
pub(super) fn equations(
    graph: &mut Graph,
    chain: &Chain,
    tip: Vector,
    tool_length: Id,
    values: &Values,
) -> (Vec<Vector>, Vector) {
    let moves: Vec<Move> = zip(&chain.elements, values).map(|(element, value)| element.moves(graph, *value)).collect();
    let elements: Vec<(&Element, Move)> = zip(&chain.elements, moves).collect();
    let first = elements.iter().position(|(_, moves)| matches!(moves, Move::Open));
    let (before, rest) = elements.split_at(first.expect("a checked chain has linear axes to be solved"));
    let reached = before.iter().fold(tip, |tip, (element, moves)| element.undo(graph, *moves, tip));
    let home = chain.tip_at_home(graph, tool_length);
    let (columns, start) = columns(graph, rest, home);
    (columns, sub(graph, reached, start))
}

impl Element {
    fn moves(&self, graph: &mut Graph, value: Option<Id>) -> Move {
        match value {
            None => Move::Open,
            Some(angle) if self.is_rotary() => Move::Turn(Turn::by(graph, angle)),
            Some(value) => Move::Shift(value),
        }
    }

    /// The tip as seen from behind this element.
    fn undo(&self, graph: &mut Graph, moves: Move, tip: Vector) -> Vector {
        match moves {
            Move::Turn(turn) => turn.back(graph).apply_about(graph, &self.direction, &self.point_mm, tip),
            Move::Shift(value) => {
                let way = self.way(graph, value);
                sub(graph, tip, way)
            }
            Move::Open => unreachable!("what stands before the first open element is known"),
        }
    }

    fn way(&self, graph: &mut Graph, value: Id) -> Vector {
        let direction = constant(graph, &self.direction);
        scale(graph, value, direction)
    }
}

/// Where each open element takes the tip, and where the tip is with all of them at zero.
fn columns(graph: &mut Graph, elements: &[(&Element, Move)], home: Vector) -> (Vec<Vector>, Vector) {
    let (mut columns, mut tip) = (Vec::new(), home);
    for (element, moves) in elements.iter().rev() {
        match moves {
            Move::Turn(turn) => {
                tip = turn.apply_about(graph, &element.direction, &element.point_mm, tip);
                for column in &mut columns {
                    *column = turn.apply(graph, &element.direction, *column);
                }
            }
            Move::Shift(value) => {
                let way = element.way(graph, *value);
                tip = add(graph, tip, way);
            }
            Move::Open => columns.push(constant(graph, &element.direction)),
        }
    }
    columns.reverse();
    (columns, tip)
}

/// The vector with length 1.
fn unit(graph: &mut Graph, v: Vector) -> Vector {
    if let Some(v) = as_constant(graph, v) {
        return constant(graph, &v.normalize());
    }
    let length = norm(graph, v);
    v.map(|component| graph.div(component, length))
}

/// Solves `D s = right` for a matrix with these columns.
fn solve_three(graph: &mut Graph, columns: [Vector; 3], right: Vector) -> Vector {
    let system = System::new(graph, columns);
    let solution = system.solve(graph, right);
    if graph.as_constant(system.determinant).is_some() {
        return solution;
    }
    // Near a singular position Cramer's rule leaves a residual; solving for it once more takes it away.
    let reached = system.product(graph, solution);
    let residual = sub(graph, right, reached);
    let correction = system.solve(graph, residual);
    add(graph, solution, correction)
}

/// Cramer's rule with vector products.
struct System {
    columns: [Vector; 3],
    normals: [Vector; 3],
    determinant: Id,
}

impl System {
    fn new(graph: &mut Graph, columns: [Vector; 3]) -> Self {
        let [a, b, c] = columns;
        let normals = [cross(graph, b, c), cross(graph, c, a), cross(graph, a, b)];
        Self { columns, normals, determinant: dot(graph, a, normals[0]) }
    }

    fn solve(&self, graph: &mut Graph, right: Vector) -> Vector {
        self.normals.map(|normal| {
            let numerator = dot(graph, right, normal);
            graph.div(numerator, self.determinant)
        })
    }

    fn product(&self, graph: &mut Graph, factors: Vector) -> Vector {
        let [a, b, c] = std::array::from_fn(|i| scale(graph, factors[i], self.columns[i]));
        let sum = add(graph, a, b);
        add(graph, sum, c)
    }
}
