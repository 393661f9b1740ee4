//! Axis words: where the axes go, and on which way.

use super::Control;
use super::block::{AxisWord, Block, Code};
use super::mistake::Mistake;
use crate::coordinates::AxisOffset;
use crate::dialect::meaning::{CentreMode, Meaning, MotionCode, Once, Plane, Switch, Wrap};
use crate::dialect::table::FormMeaning;
use crate::machine::{Axis, Motion as AxisMotion, Travel, Written};
use crate::motion::{Arc, Item, Law, Motion, Move, What};
use crate::unit::LengthUnit;
use crate::vector::{Vec3, cross, dot, norm, sub};
use std::f64::consts::TAU;

/// The ends of an arc may be differently far from its centre by so much, in millimetres: two words' rounding in inches and
/// millimetres, and a little more, as controls allow.
const ARC_TOLERANCE_MM: f64 = 0.02;

impl Control<'_> {
    /// Goes where a block's axis words say.
    pub(super) fn go(&mut self, block: &Block, line: u64, out: &mut Motion) -> Result<(), Mistake> {
        let to_reference = block.once(Once::ReferencePoint).is_some();
        let is_machine = block.once(Once::MachineCoordinates).is_some() || to_reference;
        let code = if to_reference { MotionCode::Rapid } else { self.modal.motion.ok_or(Mistake::NoMotionCode)? };
        self.refuse_what_is_not_followed()?;
        let named = block.axes.iter().fold(0, |named, word| named | 1 << word.axis);
        if to_reference {
            // Where that is, is not the program's business; the axes are somewhere else.
            self.known &= !named;
            block.axes.iter().for_each(|word| self.joints[word.axis] = 0.0);
        } else {
            for word in &block.axes {
                self.joints[word.axis] = self.target(word, is_machine)?;
                self.known |= 1 << word.axis;
            }
        }
        let law = match code {
            MotionCode::Rapid => Law::Rapid,
            MotionCode::Line => Law::Line,
            MotionCode::ArcClockwise => Law::Arc(out.push_arc(self.arc(block, true)?)),
            MotionCode::ArcCounterclockwise => Law::Arc(out.push_arc(self.arc(block, false)?)),
        };
        self.push_move(law, named, is_machine, line, out);
        Ok(())
    }

    /// Takes the tool out along its axis. Where the machine stops it is not the program's business.
    pub(super) fn retract_along_tool(&mut self, block: &Block, line: u64, out: &mut Motion) -> Result<(), Mistake> {
        if !block.axes.is_empty() {
            return Err(Mistake::NotFollowed("a way out along the tool together with axis words"));
        }
        let linear = self.axes.iter().enumerate().filter(|(_, axis)| axis.motion == AxisMotion::Linear);
        let named = linear.fold(0, |named, (index, _)| named | 1 << index);
        self.known &= !named;
        let unknown = |(index, joint): (usize, &f64)| if named & 1 << index == 0 { *joint } else { 0.0 };
        self.joints = self.joints.iter().enumerate().map(unknown).collect();
        self.push_move(Law::Rapid, named, true, line, out);
        Ok(())
    }

    /// Puts the centre of the arcs that follow where the axis words say; where there are none, where the tool is.
    pub(super) fn set_pole(&mut self, block: &Block) -> Result<(), Mistake> {
        if block.axes.is_empty() {
            self.modal.pole = self.point(&self.joints, self.known).ok_or(Mistake::NoPosition)?.map(Some);
        }
        for word in &block.axes {
            let name = self.axes[word.axis].name.as_str();
            let along = ["X", "Y", "Z"].iter().position(|it| *it == name);
            let along = along.ok_or(Mistake::NotFollowed("a centre along another axis than X, Y and Z"))?;
            self.modal.pole[along] = Some(self.target(word, false)?);
        }
        Ok(())
    }

    #[inline]
    fn push_move(&self, law: Law, named: u64, is_machine: bool, line: u64, out: &mut Motion) {
        let joints = out.push_joints(&self.joints);
        let state = out.push_state(&self.modal.state);
        let what = What::Move(Move { law, joints, known: self.known, named, is_machine });
        out.push(Item { line, state, what });
    }

    /// Whether a plain block can only move the axes straight to where its words say.
    pub(super) fn goes_straight(&self) -> bool {
        let motion = match self.block.codes.first() {
            Some(Code { meaning: Meaning::Motion(code), .. }) => Some(*code),
            _ => self.modal.motion,
        };
        let is_straight = matches!(motion, Some(MotionCode::Rapid | MotionCode::Line));
        is_straight && !self.is_incremental() && self.refuse_what_is_not_followed().is_ok()
    }

    /// Does what such a block says, which cannot go wrong.
    pub(super) fn go_straight(&mut self, line: u64, out: &mut Motion) {
        if let Some(code) = self.block.codes.first() {
            self.modal.take(code.meaning, None);
        }
        if self.block.feed.is_some() {
            self.take_feed(self.block.feed);
        }
        if self.block.axes.is_empty() {
            return;
        }
        let mut named = 0;
        for index in 0..self.block.axes.len() {
            let word = self.block.axes[index];
            self.joints[word.axis] = self.programmed(&word);
            named |= 1 << word.axis;
        }
        self.known |= named;
        let law = if self.modal.motion == Some(MotionCode::Rapid) { Law::Rapid } else { Law::Line };
        self.push_move(law, named, false, line, out);
    }

    fn refuse_what_is_not_followed(&self) -> Result<(), Mistake> {
        if self.modal.state.tip {
            return Err(Mistake::NotFollowed("a motion while the tip follows the program"));
        }
        if self.modal.frame == Some(Switch::On) {
            return Err(Mistake::NotFollowed("a motion in a turned plane"));
        }
        if self.modal.cycle == Some(Switch::On) {
            return Err(Mistake::NotFollowed("a canned cycle"));
        }
        Ok(())
    }

    /// Where a word sends its axis, in machine coordinates.
    fn target(&self, word: &AxisWord, is_machine: bool) -> Result<f64, Mistake> {
        let value = word.number * self.unit(word);
        let is_known = self.known & 1 << word.axis != 0;
        let is_step = match word.form {
            Some(FormMeaning::Incremental) => true,
            Some(_) => false,
            None => self.is_incremental() && !is_machine,
        };
        if is_step {
            return if is_known { Ok(self.joints[word.axis] + value) } else { Err(Mistake::NoPosition) };
        }
        if is_machine {
            return Ok(value);
        }
        Ok(self.programmed(word))
    }

    /// Where a word sends its axis that counts from the program zero.
    #[inline]
    fn programmed(&self, word: &AxisWord) -> f64 {
        let value = word.number * self.unit(word);
        let axis = &self.axes[word.axis];
        let is_known = self.known & 1 << word.axis != 0;
        let length_mm = if self.modal.state.length_register.is_some() { self.tool.length_mm } else { 0.0 };
        let joint = AxisOffset::of(axis).joint(value, length_mm);
        let from = if is_known { self.joints[word.axis] } else { joint };
        match word.form {
            Some(FormMeaning::Shortest) => nearest(joint, from),
            Some(FormMeaning::Positive) => turned(joint, ((from - joint) / 360.0).ceil()),
            Some(FormMeaning::Negative) => turned(joint, ((from - joint) / 360.0).floor()),
            None if self.goes_the_shortest_way(axis) => nearest(joint, from),
            _ => joint,
        }
    }

    /// Whether the words of an axis are places within a turn, to which it goes the shortest way. Where a block has said so, that
    /// is true of every axis that turns without limits, as it is written or not.
    fn goes_the_shortest_way(&self, axis: &Axis) -> bool {
        let is_said = self.modal.state.wrap == Some(Wrap::Shortest);
        let is_endless = axis.motion == AxisMotion::Rotary && axis.travel == Travel::UNLIMITED;
        match axis.written {
            Written::Wrapped { .. } => self.modal.state.wrap.unwrap_or(self.table.wrap) == Wrap::Shortest,
            Written::Unwound => is_said && is_endless,
        }
    }

    /// What one of the word's numbers is in millimetres or degrees.
    fn unit(&self, word: &AxisWord) -> f64 {
        let word = &self.table.words[word.word];
        if self.modal.units == Some(LengthUnit::Inch) { word.inch } else { word.metric }
    }

    /// The arc from where the axes were to where they are now.
    fn arc(&self, block: &Block, clockwise: bool) -> Result<Arc, Mistake> {
        let plane = self.modal.plane.unwrap_or(Plane::Xy);
        let ends = [(&self.before.1, self.before.2), (&self.joints, self.known)];
        let [Some(start), Some(end)] = ends.map(|(joints, known)| self.point(joints, known)) else {
            return Err(Mistake::NoPosition);
        };
        let normal = plane.normal();
        let flat = |v: Vec3| -> Vec3 { std::array::from_fn(|i| if normal[i] == 0.0 { v[i] } else { 0.0 }) };
        let centre_mm = match (block.centre, block.radius) {
            ([None, None, None], Some(radius)) => {
                let radius_mm = radius * self.length_unit();
                centre_by_radius(flat(start), flat(end), normal, radius_mm, clockwise)?
            }
            ([None, None, None], None) => flat(self.pole(normal)?),
            (words, _) => flat(self.centre_by_words(words, start)),
        };
        let [from, to] = [start, end].map(|point| sub(flat(point), centre_mm));
        let off_mm = (norm(from) - norm(to)).abs();
        if off_mm > ARC_TOLERANCE_MM || norm(from) == 0.0 {
            return Err(Mistake::OffTheArc(off_mm));
        }
        let angle_rad = libm::atan2(dot(normal, cross(from, to)), dot(from, to));
        let counterclockwise_rad = if angle_rad > 0.0 { angle_rad } else { angle_rad + TAU };
        // The ends of a full turn are one point.
        let is_full = norm(sub(to, from)) == 0.0;
        let sweep_rad = match (clockwise, is_full) {
            (false, false) => counterclockwise_rad,
            (true, false) => counterclockwise_rad - TAU,
            (false, true) => TAU,
            (true, true) => -TAU,
        };
        let centre_mm = std::array::from_fn(|i| if normal[i] == 0.0 { centre_mm[i] } else { start[i] });
        Ok(Arc { centre_mm, radius_mm: norm(from), normal, sweep_rad })
    }

    /// The centre that has been said before the arc.
    fn pole(&self, normal: Vec3) -> Result<Vec3, Mistake> {
        let pole = self.modal.pole;
        let is_said = (0..3).all(|along| normal[along] != 0.0 || pole[along].is_some());
        if is_said { Ok(pole.map(Option::unwrap_or_default)) } else { Err(Mistake::NoCentre) }
    }

    /// The machine coordinates of X, Y and Z, in millimetres, if all that the machine has are known.
    fn point(&self, joints: &[f64], known: u64) -> Option<Vec3> {
        let mut point = [0.0; 3];
        for (index, axis) in self.axes.iter().enumerate() {
            let along = ["X", "Y", "Z"].iter().position(|name| *name == axis.name);
            if let (Some(along), AxisMotion::Linear) = (along, axis.motion) {
                point[along] = (known & 1 << index != 0).then_some(joints[index])?;
            }
        }
        Some(point)
    }

    fn centre_by_words(&self, words: [Option<f64>; 3], start: Vec3) -> Vec3 {
        let unit = self.length_unit();
        let zero = |along: usize| {
            let axis = self.axes.iter().find(|axis| axis.name == ["X", "Y", "Z"][along]);
            axis.map_or(0.0, |axis| axis.zero)
        };
        std::array::from_fn(|along| match (words[along], self.modal.centre) {
            (Some(word), Some(CentreMode::Absolute)) => unit * word + zero(along),
            (Some(word), _) => start[along] + unit * word,
            (None, _) => start[along],
        })
    }

    /// Millimetres in the unit of lengths.
    fn length_unit(&self) -> f64 {
        if self.modal.units == Some(LengthUnit::Inch) { 25.4 } else { 1.0 }
    }
}

impl Plane {
    /// The direction against which an arc is seen.
    fn normal(self) -> Vec3 {
        match self {
            Self::Xy => [0.0, 0.0, 1.0],
            Self::Zx => [0.0, 1.0, 0.0],
            Self::Yz => [1.0, 0.0, 0.0],
        }
    }
}

/// The same angle within half a turn of another one.
#[inline]
fn nearest(angle_deg: f64, from_deg: f64) -> f64 {
    let apart_deg = from_deg - angle_deg;
    if apart_deg.abs() < 180.0 { angle_deg } else { turned(angle_deg, (apart_deg / 360.0).round()) }
}

/// The same angle so many turns further; exactly the same without a turn.
fn turned(angle_deg: f64, turns: f64) -> f64 {
    angle_deg + 360.0 * turns
}

/// The centre of an arc of this radius; a negative one is that of the longer arc.
fn centre_by_radius(start: Vec3, end: Vec3, normal: Vec3, radius_mm: f64, clockwise: bool) -> Result<Vec3, Mistake> {
    let chord = sub(end, start);
    let half = 0.5 * norm(chord);
    let over_mm = half - radius_mm.abs();
    if half == 0.0 || over_mm > ARC_TOLERANCE_MM {
        return Err(Mistake::OffTheArc(over_mm));
    }
    let apart = (radius_mm * radius_mm - half * half).max(0.0).sqrt();
    let left = cross(normal, chord);
    let sense = if clockwise == (radius_mm < 0.0) { 1.0 } else { -1.0 };
    let share = sense * apart / (2.0 * half);
    Ok(std::array::from_fn(|i| 0.5 * (start[i] + end[i]) + share * left[i]))
}
