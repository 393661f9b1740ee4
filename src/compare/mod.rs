//! Two machines on one toolpath: what a change in a machine file does to the motion.
//!
//! Both machines go to every point of the CL. Compared are the words that are printed, where they take the tool (by each
//! machine's own forward chain), the solutions chosen, and what is left of the travel.

mod branch;
mod side;
mod words;

pub use side::Refusal;
pub use words::WordChange;

use crate::diagnostic::Diagnostic;
use crate::plan::Interpreter;
use mach_runtime::certificate::{Extreme, Range};
use mach_runtime::cl::Reader;
use mach_runtime::rig::Rig;
use mach_runtime::road::{Traveller, travel};
use mach_runtime::toolpath::Point;
use mach_runtime::vector::{Vec3, angle_rad, norm, sub};
use side::{Reached, Walker};
use std::io::{self, Read};
use words::Correspondence;

/// At how many points something is the case, and the CL line of the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Count {
    /// How many.
    pub points: u64,
    /// The line of the first, from 1; 0 when there is none.
    pub first_line: u64,
}

/// The largest distance of two poses of the tool.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Apart {
    /// Of the tips, in millimetres.
    pub tip_mm: Extreme,
    /// Of the axes, in radians.
    pub axis_rad: Extreme,
}

/// What one machine did by itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Way {
    /// Where its axes went.
    pub ranges: Vec<Range>,
    /// Where it could not go.
    pub refused: Count,
    /// Why, at the first of these points.
    pub refusal: Option<Refusal>,
}

/// How two machines differ on a toolpath.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Points of the toolpath.
    pub points: u64,
    /// Points that both go to, by other words.
    pub changed: Count,
    /// Points that only one of the two goes to.
    pub one_only: Count,
    /// The words of the axes that both have, in the old machine's order.
    pub words: Vec<WordChange>,
    /// Axes of the old machine that the new one has not.
    pub only_old: Vec<String>,
    /// Axes of the new machine that the old one has not.
    pub only_new: Vec<String>,
    /// The tool in the workpiece: the old machine by its words, and the new one by its own.
    pub apart: Apart,
    /// The tool in the workpiece as the CL wants it, and as the new machine has it by the old machine's words; nothing
    /// when it has other axes.
    pub old_words: Option<Apart>,
    /// Points at which the rotary axes take the other solution; nothing when the machines have different ones.
    pub branch: Option<Count>,
    /// For each word: points at which the same solution is taken with other whole turns.
    pub turns: Vec<Count>,
    /// The old machine.
    pub old: Way,
    /// The new machine.
    pub new: Way,
}

impl Comparison {
    /// Whether both machines move in the same way, as far as is printed.
    pub fn is_same(&self) -> bool {
        let counts = [self.changed, self.one_only, self.branch.unwrap_or_default()];
        let none = counts.iter().chain(&self.turns).all(|count| count.points == 0);
        none && self.only_old.is_empty() && self.only_new.is_empty()
    }
}

impl Count {
    fn add(&mut self, line: u64) {
        self.points += 1;
        if self.first_line == 0 {
            self.first_line = line;
        }
    }
}

impl Apart {
    fn meet(&mut self, line: u64, a: (Vec3, Vec3), b: (Vec3, Vec3)) {
        self.tip_mm.meet(norm(sub(a.0, b.0)), line);
        self.axis_rad.meet(angle_rad(a.1, b.1), line);
    }
}

/// Takes both machines along the toolpath. Diagnostics of the CL go to `tell` as they come.
///
/// # Errors
/// When the CL cannot be read.
pub fn compare<R: Read>(
    old: &Rig<Interpreter>,
    new: &Rig<Interpreter>,
    mut reader: Reader<R>,
    tell: &mut dyn FnMut(Diagnostic),
) -> io::Result<Comparison> {
    let (mut old_inverse, mut new_inverse) = (old.kinematics.clone(), new.kinematics.clone());
    let mut walk = Walk::new(Walker::new(old, &mut old_inverse), Walker::new(new, &mut new_inverse), tell);
    travel(&mut reader, &mut walk)?;
    Ok(walk.end())
}

/// Both machines on their way.
struct Walk<'a> {
    old: Walker<'a>,
    new: Walker<'a>,
    axes: Correspondence,
    found: Comparison,
    tell: &'a mut dyn FnMut(Diagnostic),
}

impl Traveller for Walk<'_> {
    fn stand_at(&mut self, point: &Point) {
        self.old.stand_at(point);
        self.new.stand_at(point);
    }

    fn go(&mut self, points: &[Point]) {
        let (old, new) = (self.old.go(points), self.new.go(points));
        for (point, (old, new)) in points.iter().zip(old.iter().zip(&new)) {
            self.found.points += 1;
            self.found.old.note(point.line, old);
            self.found.new.note(point.line, new);
            match (old, new) {
                (Ok(old), Ok(new)) => self.both(point.line, old, new),
                (Err(_), Err(_)) => {}
                _ => self.found.one_only.add(point.line),
            }
        }
        self.measure(points, &old, &new);
    }

    fn hear(&mut self, diagnostic: Diagnostic) {
        (self.tell)(diagnostic);
    }
}

impl<'a> Walk<'a> {
    fn new(old: Walker<'a>, new: Walker<'a>, tell: &'a mut dyn FnMut(Diagnostic)) -> Self {
        let axes = Correspondence::of(&old.machine.axes, &new.machine.axes);
        let way = |walker: &Walker<'_>| Way { ranges: walker.ranges.clone(), refused: Count::default(), refusal: None };
        let found = Comparison {
            points: 0,
            changed: Count::default(),
            one_only: Count::default(),
            words: axes.words(&old.machine.axes),
            only_old: axes.only_old(&old.machine.axes),
            only_new: axes.only_new(&new.machine.axes),
            apart: Apart::default(),
            old_words: axes.covers_new().then(Apart::default),
            branch: axes.same_rotaries(&old.machine.axes, &new.machine.axes).then(Count::default),
            turns: vec![Count::default(); axes.pairs.len()],
            old: way(&old),
            new: way(&new),
        };
        Self { old, new, axes, found, tell }
    }

    /// A point that both go to.
    fn both(&mut self, line: u64, old: &Reached, new: &Reached) {
        let Self { axes, found, .. } = self;
        if axes.compare(line, &old.words, &new.words, &mut found.words) {
            found.changed.add(line);
        }
        let Some(branch) = &mut found.branch else { return };
        let rotaries = axes.rotaries(&self.old.machine.axes);
        if branch::is_other(old, new, &rotaries) {
            return branch.add(line);
        }
        for (turns, &(a, b)) in found.turns.iter_mut().zip(&axes.pairs) {
            if rotaries.contains(&(a, b)) && branch::has_other_turns(old.joints()[a], new.joints()[b]) {
                turns.add(line);
            }
        }
    }

    /// Where the printed words take the tool.
    fn measure(&mut self, points: &[Point], old: &[Result<Reached, Refusal>], new: &[Result<Reached, Refusal>]) {
        let words = |reached: &Result<Reached, Refusal>| reached.as_ref().ok().map(|reached| reached.words.clone());
        let (old_words, new_words): (Vec<_>, Vec<_>) =
            (old.iter().map(words).collect(), new.iter().map(words).collect());
        let both = |lane: &usize| old[*lane].is_ok() && new[*lane].is_ok();
        let (by_old, by_new) = (self.old.poses(&old_words), self.new.poses(&new_words));
        for lane in (0..points.len()).filter(both) {
            self.found.apart.meet(points[lane].line, by_old(lane), by_new(lane));
        }
        drop(by_new);
        let Some(apart) = &mut self.found.old_words else { return };
        let carried: Vec<_> = old_words.iter().map(|words| Some(self.axes.carried(words.as_ref()?))).collect();
        let by_new = self.new.poses(&carried);
        for (lane, point) in points.iter().enumerate().filter(|(lane, _)| old[*lane].is_ok()) {
            apart.meet(point.line, (point.tip_mm, point.axis), by_new(lane));
        }
    }

    fn end(self) -> Comparison {
        let Self { old, new, mut found, .. } = self;
        (found.old.ranges, found.new.ranges) = (old.ranges, new.ranges);
        found
    }
}

impl Way {
    fn note(&mut self, line: u64, reached: &Result<Reached, Refusal>) {
        if let Err(refusal) = reached {
            self.refused.add(line);
            self.refusal.get_or_insert_with(|| refusal.clone());
        }
    }
}
