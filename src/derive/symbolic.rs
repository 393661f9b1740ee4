//! Vectors of expressions.

use crate::plan::{Graph, Id, snap};
use nalgebra::{Matrix3, Vector3};

/// Three expressions along x, y, z.
pub(super) type Vector = [Id; 3];

pub(super) fn constant(graph: &mut Graph, vector: &Vector3<f64>) -> Vector {
    std::array::from_fn(|i| graph.constant(vector[i]))
}

/// The numbers that three nodes stand for, if all of them are numbers.
pub(super) fn as_constant(graph: &Graph, v: Vector) -> Option<Vector3<f64>> {
    let [x, y, z] = v.map(|component| graph.as_constant(component));
    Some(Vector3::new(x?, y?, z?))
}

pub(super) fn add(graph: &mut Graph, a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| graph.add(a[i], b[i]))
}

pub(super) fn sub(graph: &mut Graph, a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| graph.sub(a[i], b[i]))
}

pub(super) fn scale(graph: &mut Graph, factor: Id, a: Vector) -> Vector {
    std::array::from_fn(|i| graph.mul(factor, a[i]))
}

pub(super) fn dot(graph: &mut Graph, a: Vector, b: Vector) -> Id {
    let products: Vector = std::array::from_fn(|i| graph.mul(a[i], b[i]));
    let sum = graph.add(products[0], products[1]);
    graph.add(sum, products[2])
}

pub(super) fn cross(graph: &mut Graph, a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        graph.difference_of_products(a[j], b[k], a[k], b[j])
    })
}

/// The length of a vector.
pub(super) fn norm(graph: &mut Graph, a: Vector) -> Id {
    let squared = dot(graph, a, a);
    graph.sqrt(squared)
}

/// Sine and cosine of an angle.
#[derive(Clone, Copy)]
pub(super) struct Turn {
    pub(super) sine: Id,
    pub(super) cosine: Id,
}

impl Turn {
    pub(super) fn by(graph: &mut Graph, angle: Id) -> Self {
        let (sine, cosine) = graph.sine_and_cosine(angle);
        Self { sine, cosine }
    }

    /// The same turn backwards.
    pub(super) fn back(self, graph: &mut Graph) -> Self {
        Self { sine: graph.neg(self.sine), cosine: self.cosine }
    }

    /// `v` turned about the unit direction `n` (Rodrigues): `n nᵀ + (1 - n nᵀ) cos + [n]× sin`.
    pub(super) fn apply(self, graph: &mut Graph, n: &Vector3<f64>, v: Vector) -> Vector {
        let along = (n * n.transpose()).map(snap);
        let across = (Matrix3::identity() - along).map(snap);
        let cross = n.cross_matrix();
        std::array::from_fn(|i| {
            let terms: Vector = std::array::from_fn(|j| {
                let entry = self.entry(graph, along[(i, j)], across[(i, j)], cross[(i, j)]);
                graph.mul(entry, v[j])
            });
            let sum = graph.add(terms[0], terms[1]);
            graph.add(sum, terms[2])
        })
    }

    /// `along + across cos + cross sin`
    fn entry(self, graph: &mut Graph, along: f64, across: f64, cross: f64) -> Id {
        let (along, across, cross) = (graph.constant(along), graph.constant(across), graph.constant(cross));
        let cosine = graph.mul(across, self.cosine);
        let sine = graph.mul(cross, self.sine);
        let sum = graph.add(cosine, sine);
        graph.add(along, sum)
    }

    /// The point `p` turned about the line through `c` along `n`.
    pub(super) fn apply_about(self, graph: &mut Graph, n: &Vector3<f64>, c: &Vector3<f64>, p: Vector) -> Vector {
        let centre = constant(graph, c);
        let arm = sub(graph, p, centre);
        let turned = self.apply(graph, n, arm);
        add(graph, centre, turned)
    }
}
