//! The way back: what a program does, as CL data.

use super::pose::Pose;
use crate::coordinates::from_program_zero;
use crate::dialect::meaning::{Coolant, Spindle};
use crate::machine::Machine;
use crate::motion::{Arc, Coolants, Event, Feed, Item, Law, Motion, Move, State, What};
use crate::vector::{Vec3, add, cross, dot, scale, sub};
use std::io::{self, Write};

/// Writes a program as a CL file. Blocks in machine coordinates, and those before every axis is known, are the control's
/// business and are left out; arcs are written as straight moves within the machine's chord tolerance.
pub struct ReverseCl<'a> {
    out: &'a mut dyn Write,
    machine: &'a Machine,
    tool: Option<u32>,
    spindle: (Spindle, f64),
    coolant: Coolants,
    feed: Option<Feed>,
    at: Option<Pose>,
}

impl<'a> ReverseCl<'a> {
    /// Begins the file with the name of the program.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn begin(out: &'a mut dyn Write, machine: &'a Machine, program: &str) -> io::Result<Self> {
        let name: String =
            program.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' }).collect();
        writeln!(out, "TOOL PATH/{name},TOOL,PROGRAM\nUNITS/MM")?;
        let spindle = (Spindle::Off, 0.0);
        Ok(Self { out, machine, tool: None, spindle, coolant: Coolants::OFF, feed: None, at: None })
    }

    /// Ends it.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn end(self) -> io::Result<()> {
        writeln!(self.out, "END-OF-PATH")
    }

    /// Takes an item that leaves the tool at a pose, if that is known.
    pub(super) fn take(&mut self, item: &Item, motion: &Motion, after: Option<Pose>) -> io::Result<()> {
        let state = motion.state(item);
        match &item.what {
            What::Event(event) => self.event(*event),
            What::Move(it) => {
                self.switch(state)?;
                if let Some(pose) = after.filter(|_| !it.is_machine) {
                    self.go(it, motion, state, pose)?;
                }
                self.at = after;
                Ok(())
            }
        }
    }

    fn event(&mut self, event: Event) -> io::Result<()> {
        match event {
            Event::ToolChange(tool) => {
                self.tool = Some(tool);
                writeln!(self.out, "LOAD/TOOL,{tool}")
            }
            Event::Dwell(seconds) => writeln!(self.out, "DELAY/{seconds}"),
            Event::Stop => writeln!(self.out, "STOP"),
            Event::OptionalStop => writeln!(self.out, "OPSTOP"),
            Event::End => Ok(()),
        }
    }

    /// What is switched since the last move.
    fn switch(&mut self, state: &State) -> io::Result<()> {
        let spindle = (state.spindle, state.speed_rpm);
        if self.spindle != spindle {
            match spindle {
                (Spindle::Off, _) if self.spindle.0 == Spindle::Off => {}
                (Spindle::Off, _) => writeln!(self.out, "SPINDL/OFF")?,
                (Spindle::Clockwise, rpm) => writeln!(self.out, "SPINDL/RPM,{rpm},CLW")?,
                (Spindle::Counterclockwise, rpm) => writeln!(self.out, "SPINDL/RPM,{rpm},CCLW")?,
            }
            self.spindle = spindle;
        }
        if self.coolant != state.coolant {
            if self.coolant.iter().any(|coolant| state.coolant.with(coolant) != state.coolant) {
                writeln!(self.out, "COOLNT/OFF")?;
                self.coolant = Coolants::OFF;
            }
            let before = self.coolant;
            for coolant in state.coolant.iter().filter(|coolant| before.with(*coolant) != before) {
                let word = match coolant {
                    Coolant::Flood => "FLOOD",
                    Coolant::Mist => "MIST",
                    Coolant::Through => "THRU",
                    Coolant::Off => "OFF",
                };
                writeln!(self.out, "COOLNT/{word}")?;
            }
            self.coolant = state.coolant;
        }
        Ok(())
    }

    fn go(&mut self, it: &Move, motion: &Motion, state: &State, pose: Pose) -> io::Result<()> {
        if it.law == Law::Rapid {
            writeln!(self.out, "RAPID")?;
            return self.goto(pose);
        }
        if self.feed != state.feed {
            match state.feed {
                Some(Feed::PerMinute(mm_per_min)) => writeln!(self.out, "FEDRAT/MMPM,{mm_per_min}")?,
                Some(Feed::PerRevolution(mm_per_rev)) => writeln!(self.out, "FEDRAT/MMPR,{mm_per_rev}")?,
                // A time a block is no feed of a CL: the length of the block gives one.
                Some(Feed::Inverse(_)) | None => {}
            }
            self.feed = state.feed;
        }
        if let (Law::Arc(index), Some(from)) = (it.law, self.at) {
            let points = along(motion.arc(index), from, pose, self.machine.chord_tolerance_mm);
            points.into_iter().try_for_each(|point| self.goto(point))?;
        }
        self.goto(pose)
    }

    fn goto(&mut self, pose: Pose) -> io::Result<()> {
        let [x, y, z] = from_program_zero(self.machine, pose.tip_mm).map(|value| value + 0.0);
        let [i, j, k] = pose.axis.map(|value| value + 0.0);
        writeln!(self.out, "GOTO/{x:.6},{y:.6},{z:.6},{i:.9},{j:.9},{k:.9}")
    }
}

/// Points on an arc between its ends, so close that straight moves stay within the tolerance.
fn along(arc: &Arc, from: Pose, to: Pose, tolerance_mm: f64) -> Vec<Pose> {
    let share = (tolerance_mm / arc.radius_mm).clamp(1e-9, 0.5);
    let step_rad = 2.0 * libm::acos(1.0 - share);
    let count = (arc.sweep_rad.abs() / step_rad).ceil().max(1.0) as u32;
    let rise_mm = dot(sub(to.tip_mm, from.tip_mm), arc.normal);
    let centre = centre_of(arc, from, to);
    let arm = sub(from.tip_mm, centre);
    (1..count)
        .map(|n| {
            let part = f64::from(n) / f64::from(count);
            let (sine, cosine) = libm::sincos(part * arc.sweep_rad);
            let turned = add(scale(cosine, arm), scale(sine, cross(arc.normal, arm)));
            Pose { tip_mm: add(add(centre, turned), scale(part * rise_mm, arc.normal)), axis: from.axis }
        })
        .collect()
}

/// The centre as the tip sees it: as far from where it starts as the linear axes' centre is from where they start.
fn centre_of(arc: &Arc, from: Pose, to: Pose) -> Vec3 {
    let chord = sub(to.tip_mm, from.tip_mm);
    let flat = sub(chord, scale(dot(chord, arc.normal), arc.normal));
    let half_sweep = 0.5 * arc.sweep_rad;
    let middle = add(from.tip_mm, scale(0.5, flat));
    let (sine, cosine) = libm::sincos(half_sweep);
    // Half of the chord is the radius times the sine; the centre is beside its middle by the cosine.
    let beside = if sine.abs() > 1e-12 { 0.5 * cosine / sine } else { 0.0 };
    add(middle, scale(beside, cross(arc.normal, flat)))
}
