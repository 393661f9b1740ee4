//! Expressions as they are written.

use crate::syntax::tree::{Expression, ExpressionKind, Operator};

/// An expression; its parentheses are part of the tree.
pub(super) fn expression(expression: &Expression) -> String {
    match &*expression.value {
        ExpressionKind::Number { digits, unit: None } => digits.clone(),
        ExpressionKind::Number { digits, unit: Some(unit) } => format!("{digits} {}", unit.value.symbol()),
        ExpressionKind::Name(written) | ExpressionKind::Broken(written) => written.clone(),
        ExpressionKind::Vector(components) => format!("({})", list(components)),
        ExpressionKind::Group(inner) => format!("({})", self::expression(inner)),
        ExpressionKind::Sign { minus, of } => format!("{}{}", if *minus { '-' } else { '+' }, self::expression(of)),
        ExpressionKind::Binary { operator, left, right } => {
            format!("{} {} {}", self::expression(left), symbol(*operator), self::expression(right))
        }
        ExpressionKind::Call { function, arguments } => format!("{}({})", function.value, list(arguments)),
    }
}

fn list(expressions: &[Expression]) -> String {
    expressions.iter().map(expression).collect::<Vec<_>>().join(", ")
}

fn symbol(operator: Operator) -> char {
    match operator {
        Operator::Add => '+',
        Operator::Subtract => '-',
        Operator::Multiply => '*',
        Operator::Divide => '/',
        Operator::Power => '^',
    }
}
