//! Any file there may be, as the parser would hand it out but for the spans.

use mach_runtime::dialect::names;
use machc::syntax::tree::*;
use machc::syntax::unit::UNITS;
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;

/// A whole file.
pub(crate) fn file() -> impl Strategy<Value = File> {
    let item = prop_oneof![
        text().prop_map(Item::Use),
        definition(machine_statement()).prop_map(Item::Machine),
        definition(controller_statement()).prop_map(Item::Controller),
    ];
    body(item, 4).prop_map(|mut body| {
        without_leading_blank(&mut body);
        File { body }
    })
}

/// A file does not begin with a blank line.
fn without_leading_blank(body: &mut Body<Item>) {
    let first_comments = match body.statements.first_mut() {
        Some(Stated { trivia, .. }) if trivia.before.is_empty() => {
            trivia.blank_before = false;
            return;
        }
        Some(Stated { trivia, .. }) => &mut trivia.before,
        None => &mut body.trailing,
    };
    first_comments.iter_mut().take(1).for_each(|comment| comment.blank_before = false);
}

fn at<T>(value: T) -> Spanned<T> {
    Spanned { value, span: 0..0 }
}

fn spanned<T: std::fmt::Debug + 'static>(strategy: impl Strategy<Value = T> + 'static) -> BoxedStrategy<Spanned<T>> {
    strategy.prop_map(at).boxed()
}

fn body<T: std::fmt::Debug + 'static>(node: impl Strategy<Value = T>, most: usize) -> impl Strategy<Value = Body<T>> {
    let stated = (node, trivia()).prop_map(|(node, trivia)| Stated { node, span: 0..0, trivia });
    (vec(stated, 0..most), vec(comment(), 0..2)).prop_map(|(statements, trailing)| Body {
        statements,
        broken: Vec::new(),
        trailing,
    })
}

fn trivia() -> impl Strategy<Value = Trivia> {
    let some = (vec(comment(), 0..3), any::<bool>(), option::of(comment_text()));
    let some = some.prop_map(|(before, blank_before, behind)| Trivia { before, blank_before, behind });
    prop_oneof![2 => Just(Trivia::default()), 1 => some]
}

fn comment() -> impl Strategy<Value = Comment> {
    (comment_text(), any::<bool>()).prop_map(|(text, blank_before)| Comment { text, blank_before })
}

fn comment_text() -> impl Strategy<Value = String> {
    prop_oneof!["\\PC{0,12}", "[ /\"{}()\\\\a-z\t]{0,8}"].prop_map(|text| text.trim_end().to_owned())
}

fn definition<T: std::fmt::Debug + 'static>(
    statement: impl Strategy<Value = T>,
) -> impl Strategy<Value = Definition<T>> {
    (name(), option::of(name()), option::of(text()), body(statement, 8))
        .prop_map(|(name, like, title, body)| Definition { name, like, title, body })
}

fn name() -> BoxedStrategy<Name> {
    let words = select(vec!["pi", "x", "z", "mm", "m", "length", "at", "start", "offset", "like", "lets", "_", "Z"]);
    spanned(prop_oneof![words.prop_map(str::to_owned), "p[a-zA-Z0-9_]{0,6}"])
}

fn axis() -> BoxedStrategy<Name> {
    spanned("[A-Z][a-zA-Z0-9_]{0,2}")
}

fn raw_text() -> impl Strategy<Value = String> {
    prop_oneof!["[\"\\\\{}/%()#; a-z\t]{0,10}", "\\PC{0,6}"]
}

fn text() -> BoxedStrategy<Text> {
    spanned(raw_text())
}

fn machine_statement() -> impl Strategy<Value = MachineStatement> {
    use MachineStatement as S;
    let branch = body(branch_statement(), 4).prop_map(S::Branch);
    let controller = (name(), body(controller_statement(), 4)).prop_map(|(name, body)| S::Controller { name, body });
    prop_oneof![
        2 => (name(), expression()).prop_map(|(name, value)| S::Let { name, value }),
        1 => vec(link(), 1..6).prop_map(S::Chain),
        1 => body(dh_row(), 4).prop_map(S::Dh),
        1 => (error_name(), expression()).prop_map(|(name, value)| S::Error { name, value }),
        1 => (error_name(), body(error_row(), 4)).prop_map(|(name, rows)| S::ErrorTable { name, rows }),
        3 => (axis(), option::of(expression()), axis_clauses())
            .prop_map(|(name, along, clauses)| S::Linear { name, along, clauses }),
        3 => (axis(), option::of((expression(), option::of(expression()))), axis_clauses()).prop_map(
            |(name, line, clauses)| {
                let (about, through) = line.map_or((None, None), |(about, through)| (Some(about), through));
                S::Rotary { name, about, through, clauses }
            }
        ),
        1 => (expression(), option::of(expression()), option::of(expression()))
            .prop_map(|(along, at, length)| S::Tool { along, at, length }),
        1 => expression().prop_map(S::Zero),
        1 => (select(vec![ToleranceKind::Axis, ToleranceKind::Chord, ToleranceKind::Plane]), expression())
            .prop_map(|(kind, value)| S::Tolerance { kind: at(kind), value }),
        1 => strictness().prop_map(S::Records),
        1 => branch,
        1 => controller,
    ]
}

fn dh_row() -> impl Strategy<Value = DhRow> {
    let axis = option::of((axis(), any::<bool>()).prop_map(|(name, primed)| DhAxis { name, primed }));
    let parameters = prop::array::uniform5(expression());
    prop_oneof![
        4 => (axis, parameters).prop_map(|(axis, parameters)| DhRow::Link { axis, parameters }),
        1 => Just(DhRow::Bed(0..0)),
    ]
}

fn error_name() -> BoxedStrategy<Name> {
    spanned("E[XYZABC](0|O|\\([0O][XYZ]\\))?[A-Z][0-9]?")
}

fn error_row() -> impl Strategy<Value = ErrorRow> {
    (expression(), expression()).prop_map(|(position, error)| ErrorRow { position, error })
}

fn link() -> impl Strategy<Value = Link> {
    prop_oneof![
        Just(Link::Workpiece(0..0)),
        Just(Link::Bed(0..0)),
        Just(Link::Tool(0..0)),
        (axis(), any::<bool>()).prop_map(|(name, primed)| Link::Axis { name, primed }),
    ]
}

fn axis_clauses() -> impl Strategy<Value = Vec<Spanned<AxisClause>>> {
    let travel = prop_oneof![
        (expression(), expression()).prop_map(|(from, to)| AxisClause::Travel(from, to)),
        Just(AxisClause::Unlimited),
    ];
    let rapid = expression().prop_map(AxisClause::Rapid);
    (option::of(spanned(travel)), option::of(spanned(rapid)), any::<bool>()).prop_map(|(travel, rapid, swapped)| {
        let mut clauses: Vec<_> = travel.into_iter().chain(rapid).collect();
        if swapped {
            clauses.reverse();
        }
        clauses
    })
}

fn strictness() -> BoxedStrategy<Spanned<Strictness>> {
    spanned(select(vec![Strictness::Error, Strictness::Warn]))
}

fn branch_statement() -> impl Strategy<Value = BranchStatement> {
    prop_oneof![
        vec(preference(), 1..4).prop_map(BranchStatement::Start),
        vec(preference(), 1..4).prop_map(BranchStatement::Then),
        (axis(), expression()).prop_map(|(axis, value)| BranchStatement::Lock { axis, value }),
        (axis(), expression()).prop_map(|(axis, value)| BranchStatement::Prefer { axis, value }),
        axis().prop_map(BranchStatement::Free),
        strictness().prop_map(BranchStatement::Reposition),
    ]
}

fn preference() -> BoxedStrategy<Spanned<Preference>> {
    spanned(prop_oneof![
        axis().prop_map(Preference::Least),
        axis().prop_map(Preference::Positive),
        axis().prop_map(Preference::Negative),
        Just(Preference::Nearest),
    ])
}

/// Expressions with every operator; where precedence asks for parentheses, they are there.
fn expression() -> BoxedStrategy<Expression> {
    let operand = prop_oneof![number(), name().prop_map(|name| ExpressionKind::Name(name.value))];
    let leaf = operand.prop_map(|kind| at(Box::new(kind)));
    leaf.prop_recursive(4, 16, 3, |inner| {
        let operators = vec![Operator::Add, Operator::Subtract, Operator::Multiply, Operator::Divide, Operator::Power];
        prop_oneof![
            [inner.clone(), inner.clone(), inner.clone()].prop_map(ExpressionKind::Vector),
            inner.clone().prop_map(ExpressionKind::Group),
            (any::<bool>(), inner.clone())
                .prop_map(|(minus, of)| ExpressionKind::Sign { minus, of: binding(SIGN, of) }),
            (select(operators), inner.clone(), inner.clone()).prop_map(binary),
            (name(), vec(inner, 0..4)).prop_map(|(function, arguments)| ExpressionKind::Call { function, arguments }),
        ]
        .prop_map(|kind| at(Box::new(kind)))
    })
    .boxed()
}

fn number() -> impl Strategy<Value = ExpressionKind> {
    let digits = prop_oneof!["[0-9]{1,3}", "[0-9]{1,2}\\.[0-9]{0,3}([eE][+-]?[0-9])?", "\\.[0-9]{1,2}", "[0-9]e[0-9]"];
    let units: Vec<Unit> = UNITS.iter().map(|(_, unit)| *unit).collect();
    (digits, option::of(spanned(select(units)))).prop_map(|(digits, unit)| ExpressionKind::Number { digits, unit })
}

const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const SIGN: u8 = 3;
const POWER: u8 = 4;
const OPERAND: u8 = 5;

fn strength(kind: &ExpressionKind) -> u8 {
    match kind {
        ExpressionKind::Sign { .. } => SIGN,
        ExpressionKind::Binary { operator: Operator::Add | Operator::Subtract, .. } => SUM,
        ExpressionKind::Binary { operator: Operator::Multiply | Operator::Divide, .. } => PRODUCT,
        ExpressionKind::Binary { operator: Operator::Power, .. } => POWER,
        _ => OPERAND,
    }
}

/// The expression, in parentheses unless it binds as strongly as asked for.
fn binding(least: u8, expression: Expression) -> Expression {
    if strength(&expression.value) >= least {
        return expression;
    }
    at(Box::new(ExpressionKind::Group(expression)))
}

fn binary((operator, left, right): (Operator, Expression, Expression)) -> ExpressionKind {
    let (least_left, least_right) = match operator {
        Operator::Add | Operator::Subtract => (SUM, PRODUCT),
        Operator::Multiply | Operator::Divide => (PRODUCT, SIGN),
        Operator::Power => (OPERAND, SIGN),
    };
    ExpressionKind::Binary { operator, left: binding(least_left, left), right: binding(least_right, right) }
}

fn controller_statement() -> impl Strategy<Value = ControllerStatement> {
    prop_oneof![3 => simple_statement(), 2 => row_statement(), 1 => on_statement(), 1 => group_statement()]
}

fn simple_statement() -> impl Strategy<Value = ControllerStatement> {
    use ControllerStatement as S;
    let number = || option::of(expression());
    prop_oneof![
        select(vec![LengthUnit::Millimetre, LengthUnit::Inch]).prop_map(|unit| S::Units(at(unit))),
        text().prop_map(S::Extension),
        Just(S::Blocks { kind: at(BlockKind::Words), continued: None }),
        option::of(text()).prop_map(|continued| S::Blocks { kind: at(BlockKind::Statements), continued }),
        (select(names::FORMS.to_vec()), pieces())
            .prop_map(|((_, meaning), text)| S::Form { meaning: at(meaning), text: at(text) }),
        (text(), option::of(text())).prop_map(|(open, close)| S::Comment { open, close }),
        Just(S::NoSequence),
        (text(), number(), number(), number()).prop_map(|(address, start, step, greatest)| S::Sequence {
            address,
            start,
            step,
            greatest
        }),
        expression().prop_map(S::Offset),
        text().prop_map(S::Retract),
        (axis(), expression(), expression()).prop_map(|(axis, from, to)| S::WriteRange { axis, from, to }),
        axis().prop_map(S::WriteUnwound),
        (pieces(), option::of(text())).prop_map(|(pattern, note)| S::Plain { pattern: at(pattern), note }),
    ]
}

fn row_statement() -> impl Strategy<Value = ControllerStatement> {
    use ControllerStatement as S;
    let format = || spanned(prop_oneof![Just("length".to_owned()), Just("zero".to_owned()), "q[a-zA-Z0-9_]{0,5}"]);
    prop_oneof![
        (format(), text(), option::of(text()), option::of(text())).prop_map(|(name, picture, inch, zero)| S::Format {
            name,
            picture,
            inch,
            zero
        }),
        (vec(axis(), 1..4), format(), option::of(text()), option::of(expression()))
            .prop_map(|(names, format, address, inch)| S::Word { names, format, address, inch }),
    ]
}

fn on_statement() -> impl Strategy<Value = ControllerStatement> {
    (spanned(select(Trigger::ALL.to_vec())), body(template(), 3))
        .prop_map(|(event, body)| ControllerStatement::On { event, body })
}

/// A group with members of its own names, or numbers.
fn group_statement() -> impl Strategy<Value = ControllerStatement> {
    let group = select(names::groups().collect::<Vec<_>>());
    group.prop_flat_map(|group| {
        body(member(group), 4).prop_map(move |body| ControllerStatement::Group { name: at(group), body })
    })
}

fn member(group: &'static str) -> impl Strategy<Value = Member> {
    let known: Vec<String> = names::members(group).map(str::to_owned).collect();
    let known = if known.is_empty() { vec!["1".to_owned(), "17".to_owned()] } else { known };
    let text =
        (pieces(), vec(effect(), 0..3)).prop_map(|(pattern, effects)| MemberText { pattern: at(pattern), effects });
    (select(known), vec(text, 1..4)).prop_map(move |(name, texts)| Member {
        meaning: names::meaning(group, &name).expect("a name of the group"),
        name: at(name),
        texts,
    })
}

/// A member of another group.
fn effect() -> impl Strategy<Value = Effect> {
    let known: Vec<_> = names::NAMES.iter().filter(|(group, ..)| *group != "once").collect();
    let effect = |(group, member, meaning): &(&'static str, &str, Meaning)| Effect {
        group,
        member: (*member).to_owned(),
        meaning: *meaning,
    };
    select(known.into_iter().map(effect).collect::<Vec<_>>())
}

fn template() -> impl Strategy<Value = LineTemplate> {
    (any::<bool>(), pieces()).prop_map(|(bare, pieces)| LineTemplate { bare, pieces })
}

/// A text with placeholders.
fn pieces() -> impl Strategy<Value = Vec<Spanned<TemplatePiece>>> {
    let placeholder = ("[a-z_]{1,6}", option::of("[#0+.\\[\\]]{1,5}"))
        .prop_map(|(name, picture)| TemplatePiece::Placeholder { name, picture });
    let text = raw_text().prop_map(TemplatePiece::Text);
    vec(prop_oneof![text, placeholder], 0..4).prop_map(merged)
}

/// Texts beside each other are one text; an empty one is none.
fn merged(pieces: Vec<TemplatePiece>) -> Vec<Spanned<TemplatePiece>> {
    let mut merged: Vec<Spanned<TemplatePiece>> = Vec::new();
    for piece in pieces {
        match (&mut merged.last_mut().map(|last| &mut last.value), piece) {
            (_, TemplatePiece::Text(text)) if text.is_empty() => {}
            (Some(TemplatePiece::Text(before)), TemplatePiece::Text(text)) => before.push_str(&text),
            (_, piece) => merged.push(at(piece)),
        }
    }
    merged
}
