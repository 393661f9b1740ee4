/// Everything that a solver says to a block: every solution, the linear joints at given angles, the pose of the joints.
fn answer(
    solver: &mut dyn Kinematics,
    tool_length_mm: f64,
    poses: &PoseBlock,
    joints: &JointBlock,
    out: &mut Vec<f64>,
) {
    let mut solutions = SolutionBlock::new(solver.branch_count(), solver.axis_count());
    let surplus: Vec<Lane> = solver.surplus_axes().iter().map(|&axis| joints[axis]).collect();
    solver.inverse(poses, &surplus, tool_length_mm, &mut solutions);
    solutions.branches.iter().flatten().for_each(|lane| out.extend(lane));
    out.extend(solutions.reach_rad);
    out.extend(solutions.pole_sine);
    out.extend(solutions.gap_mm);
    for lane in 0..LANES {
        let mut placed: Vec<f64> = joints.iter().map(|joint| joint[lane]).collect();
        solver.position(poses.tip(lane), tool_length_mm, &mut placed);
        out.extend(placed);
    }
    let mut reached = PoseBlock::ZERO;
    solver.forward(joints, tool_length_mm, &mut reached);
    reached.tip_mm.iter().chain(&reached.axis).for_each(|lane| out.extend(lane));
    out.push(solver.free_axis().map_or(-1.0, |axis| axis as f64));
}
