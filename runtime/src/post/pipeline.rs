//! The two halves of a post, in turn or side by side.

use super::checker::Checker;
use super::printed::Printed;
use super::printer::Printer;
use crate::kinematics::Kinematics;
use std::io::{self, Read};
use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread;

/// So many stretches may wait for the checker.
const WAITING: usize = 2;

/// Prints and checks the program to its end. With more than one thread the checker has its own as soon as the program is
/// longer than one stretch: a short one is over before a thread has begun.
///
/// # Errors
/// When the CL cannot be read or the NC text cannot be written.
pub(super) fn run<R: Read, K: Kinematics + Send>(
    printer: &mut Printer<'_, R>,
    checker: &mut Checker<'_, K>,
    threads: NonZeroUsize,
) -> io::Result<()> {
    let mut printed = Printed::default();
    printer.begin(&mut printed);
    let mut goes_on = true;
    while goes_on {
        goes_on = printer.print(&mut printed)?;
        if goes_on && threads.get() > 1 {
            return side_by_side(printer, checker, printed);
        }
        checker.check(&mut printed)?;
    }
    Ok(())
}

/// The printer on this thread, the checker on another.
fn side_by_side<R: Read, K: Kinematics + Send>(
    printer: &mut Printer<'_, R>,
    checker: &mut Checker<'_, K>,
    printed: Printed,
) -> io::Result<()> {
    let (to_checker, stretches) = sync_channel(WAITING);
    let (to_printer, checked) = channel();
    thread::scope(|scope| {
        let checking = scope.spawn(move || check_all(checker, &stretches, &to_printer));
        let printing = print_all(printer, printed, to_checker, &checked);
        let checking = checking.join().unwrap_or_else(|panic| resume_unwind(panic));
        printing.and(checking)
    })
}

/// Hands on the first stretch, and prints the others.
fn print_all<R: Read>(
    printer: &mut Printer<'_, R>,
    first: Printed,
    to_checker: SyncSender<Printed>,
    checked: &Receiver<Printed>,
) -> io::Result<()> {
    let (mut printed, mut goes_on) = (first, true);
    // A checker that listens no more says why when it is joined.
    while to_checker.send(printed).is_ok() && goes_on {
        printed = checked.try_recv().unwrap_or_default();
        goes_on = printer.print(&mut printed)?;
    }
    Ok(())
}

/// Checks each stretch, and gives it back to be used again.
fn check_all<K: Kinematics>(
    checker: &mut Checker<'_, K>,
    stretches: &Receiver<Printed>,
    to_printer: &Sender<Printed>,
) -> io::Result<()> {
    for mut printed in stretches {
        checker.check(&mut printed)?;
        let _ = to_printer.send(printed); // a printer that is done needs no more
    }
    Ok(())
}
