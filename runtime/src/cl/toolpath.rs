//! A CL file item by item, everything resolved.

use super::reader::{Next, Reader};
use crate::diagnostic::Diagnostic;
use crate::toolpath::{Item, Point, State, What};
use std::io::{self, Read};

/// So many points are read at once.
const TOGETHER: usize = 256;

/// The toolpath of a CL file as it is read.
#[derive(Debug)]
pub struct Toolpath<R> {
    reader: Reader<R>,
    state: State,
    /// What has been read, and how much of it has been handed out.
    points: Vec<Point>,
    handed_out: usize,
    frames_handed_out: usize,
    then: Next,
}

impl<R: Read> Toolpath<R> {
    /// At its start.
    pub fn new(reader: Reader<R>) -> Self {
        let (points, then) = (Vec::with_capacity(TOGETHER), Next::Full);
        Self { reader, state: State::default(), points, handed_out: 0, frames_handed_out: 0, then }
    }

    /// The next item, or something to be told; nothing at the end.
    ///
    /// # Errors
    /// When the CL cannot be read.
    pub fn next_item(&mut self) -> io::Result<Option<Result<Item, Diagnostic>>> {
        loop {
            if let Some(item) = self.at_hand() {
                return Ok(Some(Ok(item)));
            }
            match std::mem::replace(&mut self.then, Next::Full) {
                Next::Full => self.read()?,
                Next::From(point) => return Ok(Some(Ok(self.item(point.line, What::From(point))))),
                Next::Command(command, place) => {
                    self.state.take(&command);
                    return Ok(Some(Ok(self.item(place.line, What::Command(command)))));
                }
                Next::Diagnostic(diagnostic) => return Ok(Some(Err(diagnostic))),
                Next::End => {
                    self.then = Next::End;
                    return Ok(None);
                }
            }
        }
    }

    /// A frame or a point that has been read.
    fn at_hand(&mut self) -> Option<Item> {
        if let Some(&(points, line, frame)) = self.reader.frames().get(self.frames_handed_out)
            && points <= self.handed_out
        {
            self.frames_handed_out += 1;
            return Some(self.item(line, What::Frame(frame)));
        }
        let point = *self.points.get(self.handed_out)?;
        self.handed_out += 1;
        self.state.go(&point);
        Some(self.item(point.line, What::Point(point)))
    }

    fn read(&mut self) -> io::Result<()> {
        self.points.clear();
        (self.handed_out, self.frames_handed_out) = (0, 0);
        self.then = self.reader.next_into(&mut self.points, TOGETHER)?;
        Ok(())
    }

    fn item(&self, line: u64, what: What) -> Item {
        Item { line, state: self.state, what }
    }
}
