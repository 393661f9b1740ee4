//! Motion, the machine side: what a control does, block by block. The planner makes it from a toolpath, the control reads it
//! from NC text; the comparison, plots, time and the way back to CL see motion and nothing else.
//!
//! Everything is resolved: nothing is modal, there are no units to remember, and each item knows the line of its text.

mod in_force;
mod item;
mod state;
mod text;

pub use in_force::InForce;
pub use item::{Arc, Event, Item, Law, Move, What};
pub use state::{Coolants, Feed, State};
pub use text::MotionText;

/// A stretch of motion, in columns; emptied and used again.
#[derive(Debug, Clone)]
pub struct Motion {
    axes: usize,
    items: Vec<Item>,
    joints: Vec<f64>,
    states: Vec<State>,
    arcs: Vec<Arc>,
}

impl Motion {
    /// No motion yet, of a machine with so many axes.
    pub fn new(axes: usize) -> Self {
        Self { axes, items: Vec::new(), joints: Vec::new(), states: Vec::new(), arcs: Vec::new() }
    }

    /// How many axes the machine has.
    pub fn axes(&self) -> usize {
        self.axes
    }

    /// The items in their order.
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Where a move ends: machine coordinates in millimetres and degrees, in the machine's order. Those that are not
    /// [known](Move::known) are zero.
    #[inline]
    pub fn joints(&self, of: &Move) -> &[f64] {
        self.joints_at(of.joints)
    }

    /// The joints that begin there in their column.
    #[inline]
    pub fn joints_at(&self, at: u32) -> &[f64] {
        &self.joints[at as usize..][..self.axes]
    }

    /// The state during an item.
    #[inline]
    pub fn state(&self, item: &Item) -> &State {
        &self.states[item.state as usize]
    }

    /// The arc of a move on one.
    pub fn arc(&self, index: u32) -> &Arc {
        &self.arcs[index as usize]
    }

    /// Appends the end of a move, to be named by the next item.
    #[inline]
    pub fn push_joints(&mut self, joints: &[f64]) -> u32 {
        debug_assert_eq!(joints.len(), self.axes, "a move ends with all axes somewhere");
        let at = self.joints.len() as u32;
        self.joints.extend_from_slice(joints);
        at
    }

    /// Appends an arc, to be named by the next item.
    pub fn push_arc(&mut self, arc: Arc) -> u32 {
        self.arcs.push(arc);
        self.arcs.len() as u32 - 1
    }

    /// The number of a state, which the last one keeps while it does not change.
    pub fn push_state(&mut self, state: &State) -> u32 {
        if self.states.last() != Some(state) {
            self.states.push(*state);
        }
        self.states.len() as u32 - 1
    }

    /// Appends an item.
    #[inline]
    pub fn push(&mut self, item: Item) {
        self.items.push(item);
    }

    /// Takes all items out but the first ones, so many.
    pub fn truncate(&mut self, items: usize) {
        self.items.truncate(items);
    }

    /// Empties it.
    pub fn clear(&mut self) {
        self.items.clear();
        self.joints.clear();
        self.states.clear();
        self.arcs.clear();
    }
}
