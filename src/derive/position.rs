//! The linear joints for given angles: the tip is affine in them.

use super::chain::{Chain, Element};
use super::symbolic::{Turn, Vector, add, constant, cross, dot, scale, sub};
use crate::plan::{Graph, Id};

/// The values of the linear elements, in the order of the chain, that put the tip on `tip` with the rotary elements at
/// `angles`.
///
/// The rotaries before the first linear element are taken off the tip; what is left is `D s = r`, with a constant `D`
/// unless a rotary stands between linear elements. Where det D is zero the values are not finite.
pub(super) fn solve(graph: &mut Graph, chain: &Chain, tip: Vector, tool_length: Id, angles: &[Id]) -> Vec<Id> {
    let mut turns: Vec<Turn> = angles.iter().map(|&angle| Turn::by(graph, angle)).collect();
    let first = chain.elements.iter().position(|element| !element.is_rotary());
    let (before, rest) = chain.elements.split_at(first.expect("a checked chain has three linear axes"));
    let inner_turns = turns.split_off(before.len());
    let reached = undo(graph, before, &turns, tip);
    let home = chain.tip_at_home(graph, tool_length);
    let (columns, start) = columns(graph, rest, inner_turns, home);
    let right = sub(graph, reached, start);
    solve_three(graph, columns, right)
}

/// The tip as seen from behind these rotaries.
fn undo(graph: &mut Graph, rotaries: &[Element], turns: &[Turn], tip: Vector) -> Vector {
    rotaries.iter().zip(turns).fold(tip, |tip, (element, turn)| {
        turn.back(graph).apply_about(graph, &element.direction, &element.point_mm, tip)
    })
}

/// Where each linear element takes the tip, and where the tip is with all of them at zero.
fn columns(graph: &mut Graph, elements: &[Element], mut turns: Vec<Turn>, home: Vector) -> (Vec<Vector>, Vector) {
    let (mut columns, mut tip) = (Vec::new(), home);
    for element in elements.iter().rev() {
        if element.is_rotary() {
            let turn = turns.pop().expect("one turn for each rotary element");
            tip = turn.apply_about(graph, &element.direction, &element.point_mm, tip);
            for column in &mut columns {
                *column = turn.apply(graph, &element.direction, *column);
            }
        } else {
            columns.push(constant(graph, &element.direction));
        }
    }
    columns.reverse();
    (columns, tip)
}

/// Solves `D s = right` for a matrix with these columns.
fn solve_three(graph: &mut Graph, columns: Vec<Vector>, right: Vector) -> Vec<Id> {
    let system = System::new(graph, columns);
    let solution = system.solve(graph, right);
    if graph.as_constant(system.determinant).is_some() {
        return solution.to_vec();
    }
    // Near a singular position Cramer's rule leaves a residual; solving for it once more takes it away.
    let reached = system.product(graph, solution);
    let residual = sub(graph, right, reached);
    let correction = system.solve(graph, residual);
    add(graph, solution, correction).to_vec()
}

/// Cramer's rule with vector products.
struct System {
    columns: [Vector; 3],
    normals: [Vector; 3],
    determinant: Id,
}

impl System {
    fn new(graph: &mut Graph, columns: Vec<Vector>) -> Self {
        let columns: [Vector; 3] = columns.try_into().expect("a checked chain has three linear axes");
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
