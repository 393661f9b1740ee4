//! What is in force, as text.

use super::{Feed, State};
use crate::dialect::meaning::{Meaning, Plane, Side, Spindle};
use crate::dialect::names::name;
use crate::number::short;
use std::fmt;

/// What is in force, a word for each part, behind a blank each. What is usual is left out: no compensation, the plane of X and Y, a
/// standing spindle; and so is a feed where nothing moves at feed.
#[derive(Debug, Clone, Copy)]
pub struct InForce<'a> {
    /// It.
    pub state: &'a State,
    /// Whether something moves at feed.
    pub is_at_feed: bool,
    /// How many decimals numbers have at most.
    pub decimals: usize,
}

impl fmt::Display for InForce<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { state, is_at_feed, decimals } = *self;
        let mut number = |letter: char, number: Option<u32>| number.map_or(Ok(()), |it| write!(f, " {letter}{it}"));
        number('T', state.tool)?;
        number('H', state.length_register)?;
        number('O', state.offset)?;
        match state.spindle {
            Spindle::Off => {}
            Spindle::Clockwise => write!(f, " S{} cw", short(state.speed_rpm, decimals))?,
            Spindle::Counterclockwise => write!(f, " S{} ccw", short(state.speed_rpm, decimals))?,
        }
        match state.feed.filter(|_| is_at_feed) {
            None => {}
            Some(Feed::PerMinute(feed)) => write!(f, " F{}", short(feed, decimals))?,
            Some(Feed::PerRevolution(feed)) => write!(f, " F{}/rev", short(feed, decimals))?,
            Some(Feed::Inverse(blocks)) => write!(f, " F{} blocks/min", short(blocks, decimals))?,
        }
        switches(state).try_for_each(|word| write!(f, " {word}"))
    }
}

/// What is not as usual.
fn switches(state: &State) -> impl Iterator<Item = &'static str> {
    let plane = (state.plane != Plane::Xy).then_some(Meaning::Plane(state.plane));
    let side = (state.side != Side::Off).then_some(Meaning::Side(state.side));
    let said = state.coolant.iter().map(Meaning::Coolant).chain(plane).chain(side).chain(state.path.map(Meaning::Path));
    said.filter_map(name).chain(state.tip.then_some("tip"))
}
