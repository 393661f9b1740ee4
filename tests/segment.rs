//! Between two points the tip stays within the bound that is stated, wherever it is looked at.

use mach_runtime::kinematics::{LANES, Lane};
use mach_runtime::machine::{Machine, Motion, Rule, ToolGeometry};
use mach_runtime::segment::Segments;
use mach_runtime::vector::{Vec3, add, dot, norm, scale, sub};
use machc::model::tables;
use proptest::prelude::*;

#[path = "common/random.rs"]
mod random;

use random::{has_its_freedoms, machine, run, with_surplus};

const TOOL: ToolGeometry = ToolGeometry::of_length(125.0);

/// So many places of a block are looked at.
const SAMPLES: u32 = 200;

/// What the summing of coordinates of some thousand millimetres loses.
const ROUNDING_MM: f64 = 1e-9;

/// Joints anywhere, and others up to a step from them, in shares of it.
fn ends() -> impl Strategy<Value = (Vec<f64>, Vec<f64>, f64)> {
    let shares = || proptest::collection::vec(-1.0..1.0_f64, 7);
    (shares(), shares(), -3.0..0.0_f64).prop_map(|(at, step, size)| (at, step, libm::exp10(size)))
}

fn joints(machine: &Machine, at: &[f64], step: &[f64], size: f64) -> [Vec<f64>; 2] {
    let reach = |motion| if motion == Motion::Rotary { 180.0 } else { 300.0 };
    let value = |share: &dyn Fn(usize) -> f64| {
        machine.axes.iter().enumerate().map(|(n, axis)| reach(axis.motion) * share(n)).collect::<Vec<_>>()
    };
    [value(&|n| at[n]), value(&|n| at[n] + size * step[n])]
}

/// How far a point is from the straight line between two others.
fn distance_mm(point: Vec3, [start, end]: [Vec3; 2]) -> f64 {
    let line = sub(end, start);
    let share = dot(sub(point, start), line) / dot(line, line).max(f64::MIN_POSITIVE);
    norm(sub(point, add(start, scale(share.clamp(0.0, 1.0), line))))
}

/// What is stated, and the most that is seen.
fn stated_and_seen(machine: &Machine, from: &[f64], to: &[f64]) -> [f64; 2] {
    let pair = [from, to].concat();
    let tips_mm = |joints: &[f64]| {
        let mut tips_mm = [[0.0; LANES]; 3];
        for (lane, joints) in joints.chunks(machine.axes.len()).enumerate() {
            let (tip, _) = machine.chain.pose(joints, TOOL);
            (0..3).for_each(|i| tips_mm[i][lane] = tip[i]);
        }
        tips_mm
    };
    let mut segments = Segments::new(&machine.chain, TOOL);
    segments.go_to(&pair, &tips_mm(&pair));
    let mut half_way = vec![[0.0; LANES]; machine.axes.len()];
    let stated = |segments: &Segments<'_>, half_way: &mut Vec<Lane>, lane: usize| {
        segments.half_way(half_way);
        let joints: Vec<f64> = half_way.iter().map(|joint| joint[lane]).collect();
        let stated = segments.deviation_mm(lane, machine.chain.pose(&joints, TOOL).0);
        assert!(stated <= segments.quick_bound_mm(lane), "the quick bound is one");
        stated
    };
    let together = stated(&segments, &mut half_way, 1);
    // One after the other they say the same.
    [from, to].into_iter().for_each(|end| segments.go_to(end, &tips_mm(end)));
    let stated = stated(&segments, &mut half_way, 0);
    assert_eq!(stated, together);
    let tip = |share: f64| {
        let joints: Vec<f64> = from.iter().zip(to).map(|(a, b)| a + share * (b - a)).collect();
        machine.chain.pose(&joints, TOOL).0
    };
    let line = [tip(0.0), tip(1.0)];
    let seen = (0..=SAMPLES).map(|n| distance_mm(tip(f64::from(n) / f64::from(SAMPLES)), line));
    [stated, seen.fold(0.0, f64::max)]
}

#[test]
fn the_tip_stays_within_the_stated_deviation() {
    for (linears, rotaries) in [(3, 1), (3, 2), (4, 3)] {
        let machines = machine(linears, rotaries).prop_map(|model| with_surplus(model, Rule::Free));
        run(1024, (machines.prop_filter("every freedom", has_its_freedoms), ends()), |(model, (at, step, size))| {
            let machine = tables::machine(&model);
            let [from, to] = joints(&machine, &at, &step, size);
            let [stated, seen] = stated_and_seen(&machine, &from, &to);
            prop_assert!(seen <= stated + ROUNDING_MM, "{seen} mm seen, {stated} mm stated");
            let is_tight = stated < 1.1 * seen + 1e-5;
            prop_assert!(is_tight, "{seen} mm seen, {stated} mm stated");
            Ok(())
        });
    }
}
