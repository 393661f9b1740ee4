//! Closing the loop: joints to a pose, the pose to every candidate, each candidate back to the pose.

use mach_runtime::kinematics::{Kinematics, LANES, Miss, Outcome, PoseBlock, SolutionBlock, Tolerances};
use mach_runtime::machine::{Motion, Rule};
use mach_runtime::vector::{angle_rad, norm, sub};
use machc::model::machine::{Model, ModelAxis};
use machc::plan::{Interpreter, Plan};

const TIP_BOUND_MM: f64 = 1e-9;
const AXIS_BOUND_RAD: f64 = 1e-12;

/// At the edge of the reach half of the digits go.
const TOLERANCES: Tolerances = Tolerances { axis_rad: 1e-7, plane_mm: TIP_BOUND_MM };

/// Joints spread over the block by a low-discrepancy sequence.
fn joints(model: &Model, block: usize) -> Vec<[f64; LANES]> {
    let spread = |axis: usize, lane: usize| {
        let steps =
            [0.754_877_666, 0.569_840_290, 0.618_033_988, 0.414_213_562, 0.732_050_807, 0.236_067_977, 0.645_751_311];
        let step = steps[axis];
        let n = (block * LANES + lane + 1) as f64;
        2.0 * (n * step).fract() - 1.0
    };
    let bound = |axis: &ModelAxis| if axis.motion == Motion::Rotary { 180.0 } else { 500.0 };
    let joint = |(i, axis): (usize, &ModelAxis)| match axis.rule {
        Rule::Locked(value) => [value; LANES],
        _ => std::array::from_fn(|l| bound(axis) * spread(i, l)),
    };
    model.axes.iter().enumerate().map(joint).collect()
}

/// Whether a rotary between the linear axes stands where they no longer span space, or next to it.
fn far(model: &Model, candidate: &[[f64; LANES]], lane: usize) -> bool {
    let joint = |(axis, joint): (&ModelAxis, &[f64; LANES])| {
        axis.motion == Motion::Linear && (joint[lane].is_nan() || joint[lane].abs() > 1e4)
    };
    has_rotary_between(model) && model.axes.iter().zip(candidate).any(joint)
}

/// Whether a rotary stands between linear axes.
fn has_rotary_between(model: &Model) -> bool {
    let is_linear: Vec<bool> =
        model.chain.iter().map(|joint| model.axes[joint.axis].motion == Motion::Linear).collect();
    let (first, last) = (is_linear.iter().position(|&linear| linear), is_linear.iter().rposition(|&linear| linear));
    first.zip(last).is_some_and(|(first, last)| is_linear[first..=last].contains(&false))
}

/// Takes the poses through the inverse and back. With the joints that the poses were made from, one candidate must be
/// those, up to whole turns.
pub(crate) fn close_the_loop(
    model: &Model,
    plan: &Plan,
    wanted: &PoseBlock,
    asked: Option<&[[f64; LANES]]>,
) -> Result<(), String> {
    let mut machine = Interpreter::new(plan);
    let mut solutions = SolutionBlock::of(&machine);
    let mut reached = PoseBlock::ZERO;
    let given = |axis: &usize| asked.map_or([0.0; LANES], |asked| asked[*axis]);
    let surplus: Vec<_> = machine.surplus_axes().iter().map(given).collect();
    machine.inverse(wanted, &surplus, model.tool.geometry(), &mut solutions);
    let mut found = [asked.is_none(); LANES];
    for candidate in &solutions.branches {
        machine.forward(candidate, model.tool.geometry(), &mut reached);
        for lane in (0..LANES).filter(|&lane| !far(model, candidate, lane)) {
            let outcome = solutions.outcome(lane, TOLERANCES);
            // The other candidate may be singular where this one is not.
            let is_missed = matches!(outcome, Outcome::Missed(miss) if miss != Miss::Singular);
            require(!is_missed, || format!("{outcome:?}"))?;
            let tip = norm(sub(reached.tip(lane), wanted.tip(lane)));
            let axis = angle_rad(reached.axis(lane), wanted.axis(lane));
            require(tip <= TIP_BOUND_MM, || format!("tip {tip:e} mm"))?;
            require(axis <= AXIS_BOUND_RAD, || format!("axis {axis:e} rad"))?;
            found[lane] |= asked.is_some_and(|asked| same_rotaries(model, asked, candidate, lane));
        }
        (0..LANES).filter(|&lane| far(model, candidate, lane)).for_each(|lane| found[lane] = true);
    }
    require(found.iter().all(|&found| found), || "a branch was missed".to_owned())
}

fn require(holds: bool, otherwise: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(otherwise()) }
}

/// Closes the loop for so many blocks of poses that joints within bounds lead to.
pub(crate) fn close_blocks(model: &Model, plan: &Plan, blocks: usize) -> Result<(), String> {
    let mut machine = Interpreter::new(plan);
    (0..blocks).try_for_each(|block| {
        let (joints, mut wanted) = (joints(model, block), PoseBlock::ZERO);
        machine.forward(&joints, model.tool.geometry(), &mut wanted);
        close_the_loop(model, plan, &wanted, Some(&joints))
    })
}

/// Whether two joint vectors agree in the rotaries up to whole turns. The angles' own conditioning is that of a point
/// next to the edge of the reach: the square root of a rounding.
fn same_rotaries(model: &Model, a: &[[f64; LANES]], b: &[[f64; LANES]], lane: usize) -> bool {
    let turn = |d: f64| (d - 360.0 * (d / 360.0).round()).abs();
    (0..model.axes.len())
        .filter(|&i| model.axes[i].motion == Motion::Rotary)
        .all(|i| turn(a[i][lane] - b[i][lane]) < 1e-4)
}
