//! Sequence numbers.

use super::lowering::Lowering;
use crate::syntax::tree::{ControllerStatement, Expression, ExpressionKind, Text};
use mach_runtime::diagnostic::Code;
use mach_runtime::nc::dialect::Sequence;

/// Sequence numbers that cannot be counted.
pub(super) static BAD_SEQUENCE: Code = Code {
    id: "E0527",
    title: "sequence numbers are whole numbers from the start to the greatest",
    explanation: "\
    sequence \"N\" start 10 step 10 greatest 99999

The numbers are written as digits, without a unit. The step is 1 or more, the greatest not below the start, and at most
99999999. Behind the greatest, counting begins again at the start. `sequence none` prints no numbers.
",
};

/// The greatest sequence number that any control takes.
const MOST_SEQUENCE: u64 = 99_999_999;

/// What is said of sequence numbers.
struct Said<'a> {
    index: usize,
    address: &'a Text,
    start: &'a Option<Expression>,
    step: &'a Option<Expression>,
    greatest: &'a Option<Expression>,
}

fn said<'a>(lowering: &Lowering<'a>) -> Option<Said<'a>> {
    let (index, statement) = lowering.last(|statement| match statement {
        ControllerStatement::NoSequence | ControllerStatement::Sequence { .. } => Some(statement),
        _ => None,
    })?;
    let ControllerStatement::Sequence { address, start, step, greatest } = statement else { return None };
    Some(Said { index, address, start, step, greatest })
}

/// Their address and the index of the statement, if there are any.
pub(super) fn address<'a>(lowering: &Lowering<'a>) -> Option<(usize, &'a Text)> {
    said(lowering).map(|said| (said.index, said.address))
}

/// The sequence numbers, if there are any.
pub(super) fn sequence(lowering: &mut Lowering<'_>) -> Option<Sequence> {
    let Said { index, address, start, step, greatest } = said(lowering)?;
    let mut number = |said: &Option<Expression>, least: u64, plain: u64| match said {
        Some(expression) => whole(lowering, index, expression, least),
        None => Some(plain),
    };
    let start = number(start, 0, 1)?;
    let step = number(step, 1, 1)?;
    let greatest = number(greatest, start, MOST_SEQUENCE.min(99_999.max(start)))?;
    Some(Sequence { address: address.value.clone(), start, step, greatest })
}

/// A whole number written as digits.
pub(super) fn whole(lowering: &mut Lowering<'_>, index: usize, expression: &Expression, least: u64) -> Option<u64> {
    let number = match &*expression.value {
        ExpressionKind::Broken(_) => return None,
        ExpressionKind::Number { digits, unit: None } => digits.parse().ok(),
        _ => None,
    };
    let number = number.filter(|number| (least..=MOST_SEQUENCE).contains(number));
    if number.is_none() {
        let label = format!("a whole number from {least} to {MOST_SEQUENCE} is expected");
        lowering.report(&BAD_SEQUENCE, "this is not the whole number that is needed", index, &expression.span, label);
    }
    number
}
