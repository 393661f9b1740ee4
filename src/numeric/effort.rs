//! What the iterations cost.

/// Counted over all poses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Effort {
    /// Poses that were solved for; the repetitions that fill a block do not count.
    pub poses: u64,
    /// Evaluations of the forward chain, each at new joints, for all solutions followed.
    pub iterations: u64,
    /// The most for one pose.
    pub most_iterations: u64,
    /// Steps of the path that were halved.
    pub bisections: u64,
    /// Poses for which the grid of starts was searched.
    pub searches: u64,
}

impl Effort {
    /// The mean number of iterations for a pose; zero without poses.
    pub fn mean_iterations(&self) -> f64 {
        if self.poses == 0 { 0.0 } else { self.iterations as f64 / self.poses as f64 }
    }

    /// The pose that was begun when `before` was counted is done.
    pub(super) fn end_pose(&mut self, before: &Self) {
        self.poses += 1;
        self.most_iterations = self.most_iterations.max(self.iterations - before.iterations);
    }
}
