/// Everything that a solver says to a block: every solution, the linear joints at given angles, the pose of the joints.
fn answer(
    solver: &mut dyn Kinematics,
    tool: ToolGeometry,
    poses: &PoseBlock,
    joints: &JointBlock,
    out: &mut Vec<f64>,
) {
    let mut solutions = SolutionBlock::of(solver);
    let surplus: Vec<Lane> = solver.surplus_axes().iter().map(|&axis| joints[axis]).collect();
    solver.inverse(poses, &surplus, tool, &mut solutions);
    solutions.branches.iter().flatten().for_each(|lane| out.extend(lane));
    let (_, margins) = solutions.parts_mut();
    [margins.reach_rad, margins.pole, margins.gap_mm].iter().for_each(|lane| out.extend(lane));
    for lane in 0..LANES {
        let mut placed: Vec<f64> = joints.iter().map(|joint| joint[lane]).collect();
        let is_held = solver.position(poses.tip(lane), tool, &mut placed).is_ok();
        out.extend(placed);
        out.push(f64::from(u8::from(is_held)));
    }
    let mut reached = PoseBlock::ZERO;
    solver.forward(joints, tool, &mut reached);
    reached.tip_mm.iter().chain(&reached.axis).for_each(|lane| out.extend(lane));
    out.push(solver.pole().map_or(-1.0, |pole| pole.axis() as f64));
}
