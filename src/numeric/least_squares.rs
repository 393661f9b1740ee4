//! Damped linear least squares with six equations, by modified Gram–Schmidt on the equations with the damping below
//! them: as exact as Householder's reflections, and the normal equations' loss of half of the digits does not happen.

use crate::plan::Pose;

/// Working space for so many unknowns.
#[derive(Debug, Clone)]
pub(super) struct LeastSquares {
    unknowns: usize,
    /// The columns: six equations, then one of damping for each unknown.
    columns: Vec<Vec<f64>>,
    right: Vec<f64>,
    /// The triangle, row by row.
    triangle: Vec<Vec<f64>>,
}

impl LeastSquares {
    pub(super) fn new(unknowns: usize) -> Self {
        let rows = 6 + unknowns;
        Self {
            unknowns,
            columns: vec![vec![0.0; rows]; unknowns],
            right: vec![0.0; rows],
            triangle: vec![vec![0.0; unknowns + 1]; unknowns],
        }
    }

    /// The `x` for which `|A x + b|² + damping² |x|²` is least, for a matrix `A` with these columns. The damping is greater
    /// than zero, so that there is one whatever `A` is.
    pub(super) fn solve(&mut self, columns: &[Pose], b: &Pose, damping: f64, x: &mut [f64]) {
        self.load(columns, b, damping);
        for pivot in 0..self.unknowns {
            self.eliminate(pivot);
        }
        for row in (0..self.unknowns).rev() {
            let known: f64 = (row + 1..self.unknowns).map(|column| self.triangle[row][column] * x[column]).sum();
            x[row] = (self.triangle[row][self.unknowns] - known) / self.triangle[row][row];
        }
    }

    fn load(&mut self, columns: &[Pose], b: &Pose, damping: f64) {
        for (index, (target, column)) in self.columns.iter_mut().zip(columns).enumerate() {
            target.fill(0.0);
            target[..6].copy_from_slice(column);
            target[6 + index] = damping;
        }
        self.right.fill(0.0);
        for (target, value) in self.right.iter_mut().zip(b) {
            *target = -value;
        }
    }

    /// Makes a column a unit vector, and everything behind it normal to it.
    fn eliminate(&mut self, pivot: usize) {
        let (done, rest) = self.columns.split_at_mut(pivot + 1);
        let unit = &mut done[pivot];
        let length = dot(unit, unit).sqrt();
        unit.iter_mut().for_each(|entry| *entry /= length);
        let row = &mut self.triangle[pivot];
        row[pivot] = length;
        for (column, entry) in rest.iter_mut().chain([&mut self.right]).zip(&mut row[pivot + 1..]) {
            *entry = dot(unit, column);
            column.iter_mut().zip(unit.iter()).for_each(|(value, along)| *value -= *entry * along);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::LeastSquares;

    #[test]
    fn a_square_system_is_solved_and_a_missing_freedom_left_alone() {
        let mut columns = [[0.0; 6]; 3];
        (columns[0][0], columns[1][0], columns[1][4]) = (2.0, 1.0, 3.0);
        let mut x = [0.0; 3];
        LeastSquares::new(3).solve(&columns, &[-5.0, 0.0, 0.0, 0.0, -6.0, 0.0], 1e-12, &mut x);
        assert!((x[0] - 1.5).abs() < 1e-14 && (x[1] - 2.0).abs() < 1e-14 && x[2] == 0.0, "{x:?}");
    }

    #[test]
    fn nearly_dependent_columns_keep_their_digits() {
        let mut columns = [[0.0; 6]; 2];
        (columns[0][0], columns[1][0], columns[1][1]) = (1.0, 1.0, 1e-9);
        let mut x = [0.0; 2];
        LeastSquares::new(2).solve(&columns, &[-3.0, -1e-9, 0.0, 0.0, 0.0, 0.0], 1e-12, &mut x);
        assert!((x[0] - 2.0).abs() < 1e-5 && (x[1] - 1.0).abs() < 1e-5, "{x:?}");
    }
}
