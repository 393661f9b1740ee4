//! Expressions: precedence, quantities, vectors.

use std::sync::LazyLock;

use mach_runtime::diagnostic::{Code, Diagnostic, Suggestion};
use pest::pratt_parser::{Assoc, Op, PrattParser};

use super::grammar::{self, Pair, Rule};
use super::{Builder, parts, word};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{Expression, ExpressionKind, Operator, Spanned, Unit};
use crate::syntax::unit::{SYNONYMS, UNITS};

/// The greatest number of operators, operands and parentheses in one expression: the tree is walked recursively.
pub const MOST_PARTS: usize = 1000;

/// A unit that does not exist.
pub static UNKNOWN_UNIT: Code = Code {
    id: "E0109",
    title: "unknown unit",
    explanation: "\
After a number stands a unit or nothing:

| quantity      | units                                    |
| ------------- | ---------------------------------------- |
| length        | `mm` `um` `m` `in`                       |
| angle         | `deg` `rad` `mrad` `urad` `arcsec`       |
| linear speed  | `mm/min` `m/min` `mm/s` `in/min`         |
| angular speed | `deg/min` `deg/s` `rpm`                  |

A product needs its sign: `2 * radius`, not `2 radius`. A unit of two parts is written without blanks: `m/min`.",
};

/// Neither a group nor a vector.
pub static VECTOR_LENGTH: Code = Code {
    id: "E0111",
    title: "a vector has three components",
    explanation: "\
Points and directions have three components in parentheses, in the order x, y, z:

    zero (0, 0, -20)
    rotary B about (0, -1, 1)

A single expression in parentheses is a group: `2 * (a + b)`.",
};

/// An expression of too many parts.
pub static TOO_LONG: Code = Code {
    id: "E0112",
    title: "expression too long",
    explanation: "\
An expression may have up to 1000 parts (operands, operators, parentheses). Give parts of it names with `let`.",
};

static PRECEDENCE: LazyLock<PrattParser<Rule>> = LazyLock::new(|| {
    PrattParser::new()
        .op(Op::infix(Rule::add, Assoc::Left) | Op::infix(Rule::subtract, Assoc::Left))
        .op(Op::infix(Rule::multiply, Assoc::Left) | Op::infix(Rule::divide, Assoc::Left))
        .op(Op::prefix(Rule::plus_sign) | Op::prefix(Rule::minus_sign))
        .op(Op::infix(Rule::power, Assoc::Right))
});

impl<'t> Builder<'_, 't> {
    /// A whole expression; what is wrong in it is reported.
    pub(super) fn expression(&mut self, pair: Pair<'t>) -> Expression {
        if pair.clone().into_inner().flatten().take(MOST_PARTS + 1).count() > MOST_PARTS {
            let message = format!("this expression has more than {MOST_PARTS} parts");
            let span = grammar::extent(&pair);
            self.failures.error(&TOO_LONG, message, span.clone(), "");
            return Spanned { value: Box::new(broken(&pair)), span };
        }
        self.operation(pair)
    }

    fn operation(&mut self, pair: Pair<'t>) -> Expression {
        PRECEDENCE
            .map_primary(|operand| self.operand(operand))
            .map_prefix(|sign, of| Spanned {
                span: sign.as_span().start()..of.span.end,
                value: Box::new(ExpressionKind::Sign { minus: sign.as_rule() == Rule::minus_sign, of }),
            })
            .map_infix(|left, operator, right| Spanned {
                span: left.span.start..right.span.end,
                value: Box::new(ExpressionKind::Binary { operator: operator_of(operator.as_rule()), left, right }),
            })
            .parse(grammar::content(pair).into_iter())
    }

    fn operand(&mut self, pair: Pair<'t>) -> Expression {
        let span = grammar::extent(&pair);
        let value = match pair.as_rule() {
            Rule::quantity => self.quantity(pair),
            Rule::call => {
                let mut parts = parts(pair);
                let function = parts.name();
                let arguments = parts.rest().map(|argument| self.operation(argument)).collect();
                ExpressionKind::Call { function, arguments }
            }
            Rule::parenthesised => self.parenthesised(pair),
            _ => ExpressionKind::Name(pair.as_str().to_owned()),
        };
        Spanned { value: Box::new(value), span }
    }

    fn quantity(&mut self, pair: Pair<'t>) -> ExpressionKind {
        let whole = broken(&pair);
        let mut parts = parts(pair);
        let digits = parts.next().as_str().to_owned();
        let unit = parts.take(Rule::unit).and_then(|unit| {
            let Spanned { value, span } = word(&unit);
            Unit::from_symbol(&value).map(|value| Spanned { value, span })
        });
        if let Some(unknown) = parts.take(Rule::unknown_unit) {
            self.unknown_unit(&unknown);
            return whole;
        }
        ExpressionKind::Number { digits, unit }
    }

    fn unknown_unit(&mut self, unit: &Pair<'t>) {
        let written = unit.as_str();
        let meant = SYNONYMS
            .iter()
            .find(|(synonym, _)| *synonym == written.to_lowercase())
            .map(|(_, unit)| *unit)
            .or_else(|| nearest(written, UNITS.iter().map(|(symbol, _)| *symbol)));
        let place = self.failures.place(&grammar::extent(unit));
        let symbols: Vec<String> = UNITS.iter().map(|(symbol, _)| format!("`{symbol}`")).collect();
        let mut diagnostic = Diagnostic::error(&UNKNOWN_UNIT, format!("`{written}` is not a unit"))
            .at(place.clone(), "")
            .note(format!("the units are {}", symbols.join(", ")));
        if let Some(meant) = meant {
            let text = format!("did you mean `{meant}`?");
            diagnostic = diagnostic.suggest(Suggestion { text, place, replacement: meant.to_owned() });
        } else {
            diagnostic = diagnostic.note("a product is written with its sign, as in `2 * a`");
        }
        self.failures.push(diagnostic);
    }

    fn parenthesised(&mut self, pair: Pair<'t>) -> ExpressionKind {
        let (span, whole) = (grammar::extent(&pair), broken(&pair));
        let components: Vec<_> = parts(pair).rest().map(|component| self.operation(component)).collect();
        match <[Expression; 3]>::try_from(components) {
            Ok(components) => ExpressionKind::Vector(components),
            Err(mut components) if components.len() == 1 => ExpressionKind::Group(components.swap_remove(0)),
            Err(components) => {
                let message = format!("a vector has three components, this has {}", components.len());
                self.failures.error(&VECTOR_LENGTH, message, span, "");
                whole
            }
        }
    }
}

fn broken(pair: &Pair<'_>) -> ExpressionKind {
    ExpressionKind::Broken(pair.as_str().trim_end().to_owned())
}

fn operator_of(rule: Rule) -> Operator {
    match rule {
        Rule::add => Operator::Add,
        Rule::subtract => Operator::Subtract,
        Rule::multiply => Operator::Multiply,
        Rule::divide => Operator::Divide,
        _ => Operator::Power,
    }
}
