//! The steps of a post, in turn or side by side: a stretch of the CL is read, printed, checked.

use super::checker::Checker;
use super::printer::Printer;
use super::stretch::Stretch;
use crate::cl::Reader;
use crate::diagnostic::Diagnostic;
use crate::kinematics::Kinematics;
use std::io::{self, Read};
use std::sync::mpsc::sync_channel;
use std::thread;

/// So many stretches are under way at once: one is printed, one waits for that, one is read or checked.
const UNDER_WAY: usize = 3;

/// The steps with what they need, from the CL to the NC text.
pub(super) struct Pipeline<'a, R, K> {
    pub(super) reader: Reader<R>,
    pub(super) printer: Printer<'a>,
    pub(super) checker: Checker<'a, K>,
    pub(super) tell: &'a mut dyn FnMut(Diagnostic),
}

impl<R: Read, K: Kinematics> Pipeline<'_, R, K> {
    /// Posts the whole program on one thread.
    ///
    /// # Errors
    /// When the CL cannot be read or the NC text cannot be written.
    pub(super) fn run(&mut self) -> io::Result<()> {
        let mut stretch = Stretch::default();
        while self.step(&mut stretch)? {}
        Ok(())
    }

    /// The same with a thread for the printer, which has about half of the work. It begins with the second stretch: a short
    /// program is over before a thread has begun.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub(super) fn run_side_by_side(&mut self) -> io::Result<()> {
        let mut stretch = Stretch::default();
        if !self.step(&mut stretch)? {
            return Ok(());
        }
        let Self { reader, printer, checker, tell } = self;
        thread::scope(|scope| {
            let (to_printer, read) = sync_channel::<Stretch>(UNDER_WAY);
            let (to_checker, printed) = sync_channel(UNDER_WAY);
            scope.spawn(move || {
                for mut stretch in read {
                    printer.print(&mut stretch);
                    // Nobody listens any more when the post gives up.
                    let _ = to_checker.send(stretch);
                }
            });
            let mut empty = vec![stretch];
            empty.resize_with(UNDER_WAY, Stretch::default);
            let mut is_read = false;
            loop {
                while let (false, Some(mut stretch)) = (is_read, empty.pop()) {
                    stretch.read(reader)?;
                    is_read = stretch.is_last;
                    to_printer.send(stretch).expect("the printer prints until nothing comes");
                }
                let mut stretch = printed.recv().expect("what is printed is sent on");
                if !finish(&mut stretch, checker, tell)? {
                    return Ok(());
                }
                empty.push(stretch);
            }
        })
    }

    /// All that is done with a stretch. Says whether the program goes on.
    fn step(&mut self, stretch: &mut Stretch) -> io::Result<bool> {
        stretch.read(&mut self.reader)?;
        self.printer.print(stretch);
        finish(stretch, &mut self.checker, self.tell)
    }
}

/// Tells and checks what the printer has left. Says whether the program goes on.
fn finish<K: Kinematics>(
    stretch: &mut Stretch,
    checker: &mut Checker<'_, K>,
    tell: &mut dyn FnMut(Diagnostic),
) -> io::Result<bool> {
    stretch.diagnostics.drain(..).for_each(&mut *tell);
    checker.check(stretch, tell)?;
    stretch.clear();
    Ok(!stretch.is_last)
}
