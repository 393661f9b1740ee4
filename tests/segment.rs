//! The bound on what the tool does between two joint vectors holds wherever it is looked at, and is not much more than it has to
//! be.

use mach_runtime::kinematics::segment::{Deviation, Place, deviation};
use mach_runtime::machine::{Chain, Machine, Motion, Rule};
use mach_runtime::vector::{Vec3, add, angle_rad, norm, scale, sub};
use machc::emit::tables;
use machc::model::machine::Model;
use proptest::prelude::*;
use std::cell::RefCell;

#[path = "common/random.rs"]
mod random;
#[path = "common/machine.rs"]
mod shipped;
#[path = "common/stems.rs"]
mod stems;

use random::{has_its_freedoms, machine, run, with_surplus};

/// What rounding does to poses some metres away.
const ROUNDING: f64 = 1e-11;

const LENGTH_MM: f64 = 125.0;
const SAMPLES: usize = 240;

/// Two joint vectors, apart by up to so many degrees and millimetres.
fn ends(machine: &Machine, numbers: &[f64], size: f64) -> [Vec<f64>; 2] {
    let start = |axis: usize| numbers[axis] * if machine.axes[axis].motion == Motion::Rotary { 180.0 } else { 500.0 };
    let from: Vec<f64> = (0..machine.axes.len()).map(start).collect();
    let to = from.iter().zip(&numbers[7..]).map(|(from, step)| from + size * step).collect();
    [from, to]
}

fn between(ends: &[Vec<f64>; 2], t: f64) -> Vec<f64> {
    ends[0].iter().zip(&ends[1]).map(|(from, to)| from + t * (to - from)).collect()
}

/// The point of the great circle at `t`.
fn on_great_circle(from: Vec3, to: Vec3, t: f64) -> Vec3 {
    let angle = angle_rad(from, to);
    if angle == 0.0 {
        return from;
    }
    let share = |t: f64| libm::sin(t * angle) / libm::sin(angle);
    add(scale(share(1.0 - t), from), scale(share(t), to))
}

fn bound(chain: &Chain, ends: &[Vec<f64>; 2]) -> Deviation {
    let places = ends.each_ref().map(|joints| {
        let (tip_mm, axis) = chain.pose(joints, LENGTH_MM);
        Place { joints, tip_mm, axis }
    });
    deviation(chain, places, chain.pose(&between(ends, 0.5), LENGTH_MM), LENGTH_MM)
}

/// The greatest that is found on the way.
fn sampled(chain: &Chain, ends: &[Vec<f64>; 2]) -> Deviation {
    let [from, to] = ends.each_ref().map(|joints| chain.pose(joints, LENGTH_MM));
    let mut greatest = Deviation { tip_mm: 0.0, axis_rad: 0.0 };
    for sample in 1..SAMPLES {
        let t = sample as f64 / SAMPLES as f64;
        let (tip, axis) = chain.pose(&between(ends, t), LENGTH_MM);
        let line = add(from.0, scale(t, sub(to.0, from.0)));
        greatest.tip_mm = greatest.tip_mm.max(norm(sub(tip, line)));
        greatest.axis_rad = greatest.axis_rad.max(angle_rad(axis, on_great_circle(from.1, to.1, t)));
    }
    greatest
}

/// How many times what was found the bounds are, for tip and axis.
#[derive(Default)]
struct Ratios {
    tip: Vec<f64>,
    axis: Vec<f64>,
}

impl Ratios {
    fn add(&mut self, machine: &Machine, ends: &[Vec<f64>; 2]) -> Result<(), String> {
        let (bound, found) = (bound(&machine.chain, ends), sampled(&machine.chain, ends));
        if found.tip_mm > bound.tip_mm + ROUNDING || found.axis_rad > bound.axis_rad + ROUNDING {
            return Err(format!("{}: {found:?} is beyond {bound:?} between {ends:?}", machine.name));
        }
        // Of a way that is straight there is only rounding to be had.
        self.tip.extend((found.tip_mm > 1e-6).then(|| bound.tip_mm / found.tip_mm));
        self.axis.extend((found.axis_rad > 1e-9).then(|| bound.axis_rad / found.axis_rad));
        Ok(())
    }

    /// The median of the ratios is no more than this.
    fn require(&mut self, tip: f64, axis: f64) {
        for (ratios, most) in [(&mut self.tip, tip), (&mut self.axis, axis)] {
            ratios.sort_by(f64::total_cmp);
            let (median, count) = (ratios[ratios.len() / 2], ratios.len());
            println!("{count} segments: median {median:.4}, 99 of 100 {:.4}", ratios[count * 99 / 100]);
            assert!(count > 1000 && median <= most, "{median} of {count}");
        }
    }
}

/// Steps as programs have them, and sweeps.
fn size() -> impl Strategy<Value = f64> {
    prop_oneof![3 => 0.1..10.0f64, 1 => 10.0..120.0f64]
}

fn numbers() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-1.0..1.0f64, 14)
}

#[test]
fn no_segment_of_a_shipped_machine_is_beyond_its_bound() {
    let tables =
        |name: &String| tables::machine(&shipped::compiled(&format!("machines/{name}.mach"), &shipped::Files).model);
    let machines: Vec<Machine> = stems::stems("machines", "mach").iter().map(tables).collect();
    let ratios = RefCell::new(Ratios::default());
    run(4096, (0..machines.len(), numbers(), size()), |(machine, numbers, size)| {
        let machine = &machines[machine];
        ratios.borrow_mut().add(machine, &ends(machine, &numbers, size)).map_err(TestCaseError::fail)
    });
    ratios.into_inner().require(1.02, 1.05);
}

#[test]
fn no_segment_of_a_random_machine_is_beyond_its_bound() {
    let any = prop_oneof![machine(3, 1), machine(3, 2), machine(4, 3)];
    let machines = any.prop_map(|model| with_surplus(model, Rule::Free)).prop_filter("freedoms", has_its_freedoms);
    let ratios = RefCell::new(Ratios::default());
    run(4096, (machines, numbers(), size()), |(model, numbers, size): (Model, _, _)| {
        let machine = tables::machine(&model);
        ratios.borrow_mut().add(&machine, &ends(&machine, &numbers, size)).map_err(TestCaseError::fail)
    });
    ratios.into_inner().require(1.02, 1.05);
}

#[test]
fn a_way_that_is_straight_is_known_to_be() {
    let vmc = tables::machine(&shipped::compiled("machines/vmc3.mach", &shipped::Files).model);
    let Deviation { tip_mm, axis_rad } = bound(&vmc.chain, &[vec![0.0, 10.0, 20.0], vec![100.0, -50.0, 3.0]]);
    assert!(tip_mm < ROUNDING && axis_rad == 0.0, "{tip_mm} mm, {axis_rad} rad");
}
