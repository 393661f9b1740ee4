//! The syntax tree of a `.mach` file. Every node that a diagnostic may point at carries its span.

pub use mach_runtime::dialect::meaning::Meaning;
pub use mach_runtime::dialect::table::{BlockKind, FormMeaning};
pub use mach_runtime::nc::dialect::Trigger;
pub use mach_runtime::strictness::Strictness;
pub use mach_runtime::unit::LengthUnit;
use std::ops::Range;

/// A byte range in the file's text.
pub type Span = Range<usize>;

/// A value and where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Spanned<T> {
    /// What it is.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

/// An identifier (`centre`), an axis name (`X`, `C1`) or a controller's or machine's name.
pub type Name = Spanned<String>;

/// A quoted string, without its quotes.
pub type Text = Spanned<String>;

/// A comment on a line of its own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Comment {
    /// Without the `//` and one blank after it.
    pub text: String,
    /// Whether a blank line stands before it.
    pub blank_before: bool,
}

/// Comments and blank lines around a statement: what the printer must keep.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trivia {
    /// Comments on lines of their own before it, and those inside it.
    pub before: Vec<Comment>,
    /// Whether a blank line stands between those comments (or what comes before) and the statement.
    pub blank_before: bool,
    /// The comment behind it on its last line (for a block: on the line of its opening brace).
    pub behind: Option<String>,
}

/// A statement with its trivia.
#[derive(Debug, Clone, PartialEq)]
pub struct Stated<T> {
    /// The statement.
    pub node: T,
    /// The whole statement.
    pub span: Span,
    /// What stands around it.
    pub trivia: Trivia,
}

/// A body in braces.
#[derive(Debug, Clone, PartialEq)]
pub struct Body<T> {
    /// Its statements in order.
    pub statements: Vec<Stated<T>>,
    /// What stands between them and is no statement, in order.
    pub broken: Vec<Broken>,
    /// Comments after the last statement.
    pub trailing: Vec<Comment>,
}

/// What was to be a statement and is none. It has been reported, and is left out; what it was to say may be guessed from its
/// words.
#[derive(Debug, Clone, PartialEq)]
pub struct Broken {
    /// Where it stands.
    pub span: Span,
    /// The keywords of the statements that it may be; `None` where it may be any.
    pub keywords: Option<Vec<String>>,
    /// The words among which the names are that it may speak of; `None` where it may be any.
    pub names: Option<Vec<String>>,
}

impl Broken {
    /// What may be any number of any statements.
    pub fn anything(span: Span) -> Self {
        Self { span, keywords: None, names: None }
    }

    /// Whether it may be a statement with one of these keywords.
    pub fn may_be(&self, keywords: &[&str]) -> bool {
        self.keywords.as_ref().is_none_or(|known| known.iter().any(|known| keywords.contains(&known.as_str())))
    }

    /// The only statement that it may be, by its keyword, and what it speaks of.
    pub fn only_meaning(&self) -> Option<(&str, &str)> {
        let ([keyword], [_, name, ..]) = (&self.keywords.as_ref()?[..], &self.names.as_ref()?[..]) else { return None };
        Some((keyword, name))
    }

    /// Whether it may speak of something of this name.
    pub fn may_speak_of(&self, name: &str) -> bool {
        let says = |names: &Vec<String>| name.split(' ').all(|word| names.iter().any(|known| known == word));
        self.names.as_ref().is_none_or(says)
    }
}

/// A whole file.
#[derive(Debug, Clone, PartialEq)]
pub struct File {
    /// Its items and the comments after the last.
    pub body: Body<Item>,
}

/// What stands at the top of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// `use "controllers/syntec.mach"`: the items of another file, by a path relative to this one.
    Use(Text),
    /// `machine NAME like OTHER "title" { … }`.
    Machine(Definition<MachineStatement>),
    /// `controller NAME like OTHER "title" { … }`.
    Controller(Definition<ControllerStatement>),
}

/// A named thing, perhaps like another of its kind, and what is said of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Definition<T> {
    /// Its name.
    pub name: Name,
    /// The one it takes over from; its own statements come on top.
    pub like: Option<Name>,
    /// What people call it.
    pub title: Option<Text>,
    /// What is said of it.
    pub body: Body<T>,
}

/// One statement of a machine.
#[derive(Debug, Clone, PartialEq)]
pub enum MachineStatement {
    /// `let NAME = EXPRESSION`.
    Let {
        /// The parameter.
        name: Name,
        /// Its value: a number with or without a unit, or a vector.
        value: Expression,
    },
    /// `chain w C' A' b X Y Z t`.
    Chain(Vec<Link>),
    /// `dh { … }`: the chain as a Denavit–Hartenberg table.
    Dh(Body<DhRow>),
    /// `linear NAME along DIRECTION CLAUSE…`.
    Linear {
        /// The axis.
        name: Name,
        /// Where a positive motion goes; a `dh` block says it too.
        along: Option<Expression>,
        /// Travel and rapid, in any order, each at most once.
        clauses: Vec<Spanned<AxisClause>>,
    },
    /// `rotary NAME about DIRECTION through POINT CLAUSE…`.
    Rotary {
        /// The axis.
        name: Name,
        /// Its direction; right-handed. A `dh` block says it too.
        about: Option<Expression>,
        /// A point on it; the origin where nothing is said.
        through: Option<Expression>,
        /// Travel and rapid.
        clauses: Vec<Spanned<AxisClause>>,
    },
    /// `error EX0C 12 um`: a measured error that does not depend on a position.
    Error {
        /// Its name in ISO 230.
        name: Name,
        /// A length or an angle.
        value: Expression,
    },
    /// `error EXX { at -300 mm: 4 um … }`: a measured error by the positions of its axis.
    ErrorTable {
        /// Its name in ISO 230.
        name: Name,
        /// Its rows.
        rows: Body<ErrorRow>,
    },
    /// `tool along DIRECTION at POINT length EXPRESSION`.
    Tool {
        /// From the tip to the spindle.
        along: Expression,
        /// The gauge point with every axis at zero; the origin where nothing is said.
        at: Option<Expression>,
        /// From the gauge point to the tip, against `along`; zero where nothing is said.
        length: Option<Expression>,
    },
    /// `zero POINT`: the program zero in the machine frame with every axis at zero.
    Zero(Expression),
    /// `tolerance axis EXPRESSION`, `tolerance chord EXPRESSION` or `tolerance plane EXPRESSION`.
    Tolerance {
        /// Which tolerance.
        kind: Spanned<ToleranceKind>,
        /// Its value.
        value: Expression,
    },
    /// `records unknown error` or `records unknown warn`.
    Records(Spanned<Strictness>),
    /// `branch { … }`.
    Branch(Body<BranchStatement>),
    /// `controller NAME { … }`: the controller, with what this machine changes of it.
    Controller {
        /// Which one.
        name: Name,
        /// Changes.
        body: Body<ControllerStatement>,
    },
}

/// One place of the chain, from the workpiece to the tool.
#[derive(Debug, Clone, PartialEq)]
pub enum Link {
    /// `w`.
    Workpiece(Span),
    /// `b`.
    Bed(Span),
    /// `t`.
    Tool(Span),
    /// An axis; primed when its positive sense is the workpiece's motion.
    Axis {
        /// Its name, without the prime.
        name: Name,
        /// Whether it has a prime.
        primed: bool,
    },
}

/// One row of a Denavit–Hartenberg table.
#[derive(Debug, Clone, PartialEq)]
pub enum DhRow {
    /// `link C: θ, a, b, l, α`: a link, with the axis that moves it where one does.
    Link {
        /// The axis: a rotary one adds to θ, a linear one to l.
        axis: Option<DhAxis>,
        /// θ, a, b, l, α.
        parameters: [Expression; 5],
    },
    /// `bed`.
    Bed(Span),
}

/// The axis of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct DhAxis {
    /// Its name, without the prime.
    pub name: Name,
    /// Whether it has a prime.
    pub primed: bool,
}

/// One row of a table of errors: `at POSITION: ERROR`.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorRow {
    /// Where the axis is.
    pub position: Expression,
    /// What its error is there.
    pub error: Expression,
}

/// A clause of an axis.
#[derive(Debug, Clone, PartialEq)]
pub enum AxisClause {
    /// `travel -30 .. 120 deg`. A bare first bound takes the unit of the second.
    Travel(Expression, Expression),
    /// `turns unlimited`.
    Unlimited,
    /// `rapid 36 m/min`.
    Rapid(Expression),
}

/// Which tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToleranceKind {
    /// Between the wanted and the reached tool axis.
    Axis,
    /// Between an arc and the segments it is written as.
    Chord,
    /// Between a tip and the plane of two linear axes.
    Plane,
}

/// A statement of a `branch` block.
#[derive(Debug, Clone, PartialEq)]
pub enum BranchStatement {
    /// `start PREFERENCE, …`: at the first point.
    Start(Vec<Spanned<Preference>>),
    /// `then PREFERENCE, …`: afterwards.
    Then(Vec<Spanned<Preference>>),
    /// `reposition error` or `reposition warn`.
    Reposition(Spanned<Strictness>),
    /// `lock W 0 mm`: the axis always stands there.
    Lock {
        /// A surplus axis.
        axis: Name,
        /// Where.
        value: Expression,
    },
    /// `prefer A 0 deg`: the axis stands there wherever it can.
    Prefer {
        /// A surplus axis.
        axis: Name,
        /// Where.
        value: Expression,
    },
    /// `free A`: the axis stays where it is while it can.
    Free(Name),
}

/// One way to prefer a candidate.
#[derive(Debug, Clone, PartialEq)]
pub enum Preference {
    /// `least |C|`.
    Least(Name),
    /// `positive A`.
    Positive(Name),
    /// `negative A`.
    Negative(Name),
    /// `nearest`.
    Nearest,
}

/// An expression, with its span.
pub type Expression = Spanned<Box<ExpressionKind>>;

/// What an expression is.
#[derive(Debug, Clone, PartialEq)]
pub enum ExpressionKind {
    /// What has no value, as it is written: it has been reported.
    Broken(String),
    /// `36`, `36 m/min`, `-1.5e-3 mm` has its sign outside.
    Number {
        /// As written.
        digits: String,
        /// The unit, if any.
        unit: Option<Spanned<Unit>>,
    },
    /// A parameter, `pi`, or one of the unit vectors `x`, `y`, `z`.
    Name(String),
    /// `(1, 0, 0)`.
    Vector([Expression; 3]),
    /// `(a + b)`: parentheses are kept as written.
    Group(Expression),
    /// `-a`, `+a`.
    Sign {
        /// Whether it is a minus.
        minus: bool,
        /// What it applies to.
        of: Expression,
    },
    /// `a + b` and so on.
    Binary {
        /// The operator.
        operator: Operator,
        /// The left side.
        left: Expression,
        /// The right side.
        right: Expression,
    },
    /// `cos(60 deg)`.
    Call {
        /// The function's name.
        function: Name,
        /// Its arguments.
        arguments: Vec<Expression>,
    },
}

/// A binary operator. `^` binds tightest and to the right, then `*` and `/`, then `+` and `-`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `^`
    Power,
}

/// A unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// `mm`
    Millimetre,
    /// `um`
    Micrometre,
    /// `m`
    Metre,
    /// `in`
    Inch,
    /// `deg`
    Degree,
    /// `rad`
    Radian,
    /// `mrad`
    Milliradian,
    /// `urad`
    Microradian,
    /// `arcsec`
    Arcsecond,
    /// `rpm`
    RevolutionPerMinute,
    /// `mm/min`
    MillimetrePerMinute,
    /// `m/min`
    MetrePerMinute,
    /// `mm/s`
    MillimetrePerSecond,
    /// `in/min`
    InchPerMinute,
    /// `deg/min`
    DegreePerMinute,
    /// `deg/s`
    DegreePerSecond,
}

/// One statement of a controller. In a machine's own `controller` block a statement replaces the family's statement
/// about the same thing.
#[derive(Debug, Clone, PartialEq)]
pub enum ControllerStatement {
    /// `units mm` or `units inch`: of the program.
    Units(Spanned<LengthUnit>),
    /// `blocks words`, `blocks statements continued "~"`.
    Blocks {
        /// How they are put together.
        kind: Spanned<BlockKind>,
        /// What stands at the end of a line that goes on in the next one.
        continued: Option<Text>,
    },
    /// `extension "nc"`.
    Extension(Text),
    /// `comment "(" ")"`, `comment ";"`.
    Comment {
        /// What opens a comment.
        open: Text,
        /// What closes it; the end of the line where nothing is said.
        close: Option<Text>,
    },
    /// `sequence none`.
    NoSequence,
    /// `sequence "N" start 10 step 10 greatest 9999`.
    Sequence {
        /// The address.
        address: Text,
        /// The first number; 1 where nothing is said.
        start: Option<Expression>,
        /// From block to block; 1 where nothing is said.
        step: Option<Expression>,
        /// The greatest; 99999 where nothing is said.
        greatest: Option<Expression>,
    },
    /// `offset 1`: the number of the work offset.
    Offset(Expression),
    /// `retract "Z0."`: what `{retract}` prints, where it is not the end of the travel.
    Retract(Text),
    /// `format length "####.###" inch "###.####" zero "0.0"`.
    Format {
        /// The format's name.
        name: Name,
        /// Its picture.
        picture: Text,
        /// Its picture in an inch program, where it differs.
        inch: Option<Text>,
        /// What a number that rounds to zero prints, where it differs.
        zero: Option<Text>,
    },
    /// `word X Y Z length`, `word C1 angle as "C1="`.
    Word {
        /// Axes, or `F`.
        names: Vec<Name>,
        /// The format's name.
        format: Name,
        /// What is printed before the number, where it is not the name itself.
        address: Option<Text>,
        /// What one is in a program in inches, where it is not an inch.
        inch: Option<Expression>,
    },
    /// `form incremental "I{address}{number}"`: another way to write the word of an axis.
    Form {
        /// How the number is meant.
        meaning: Spanned<FormMeaning>,
        /// The word.
        text: Spanned<Vec<Spanned<TemplatePiece>>>,
    },
    /// `write C 0 .. 360`.
    WriteRange {
        /// A rotary axis.
        axis: Name,
        /// The least value.
        from: Expression,
        /// 360 degrees above it, itself never written.
        to: Expression,
    },
    /// `write C unwound`.
    WriteUnwound(Name),
    /// `group motion { rapid "G0" … }`: texts that replace each other, and what they mean; `once { … }`, where what they mean
    /// happens once.
    Group {
        /// Its name; `once` for those.
        name: Spanned<&'static str>,
        /// Its members.
        body: Body<Member>,
    },
    /// `plain "M11" "the C axis is unclamped"`: a text that moves nothing and switches nothing that is known.
    Plain {
        /// The text.
        pattern: Spanned<Vec<Spanned<TemplatePiece>>>,
        /// What the machine's builder says of it.
        note: Option<Text>,
    },
    /// `on EVENT { LINE… }`.
    On {
        /// Which event.
        event: Spanned<Trigger>,
        /// The lines it prints.
        body: Body<LineTemplate>,
    },
}

/// A member of a group: `line "G1"`, `reference point "G28" also "G30"`.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// Its name there, with one blank between words; digits in the group `offset`.
    pub name: Spanned<String>,
    /// What it means, and the number that goes with it.
    pub meaning: (Meaning, Option<u32>),
    /// Its texts: the first one is printed, all are read.
    pub texts: Vec<MemberText>,
}

/// A text of a member, and what it does beside that.
#[derive(Debug, Clone, PartialEq)]
pub struct MemberText {
    /// The text.
    pub pattern: Spanned<Vec<Spanned<TemplatePiece>>>,
    /// `(length on)`: members of other groups, which come into force with it.
    pub effects: Vec<Effect>,
}

/// A member of a group that comes into force with another text.
#[derive(Debug, Clone, PartialEq)]
pub struct Effect {
    /// The group.
    pub group: &'static str,
    /// The member's name in it.
    pub member: String,
    /// What it means.
    pub meaning: Meaning,
}

/// One line of a block: `"T{tool} M6"`, or `bare "%"` for a line without a sequence number.
#[derive(Debug, Clone, PartialEq)]
pub struct LineTemplate {
    /// Whether it is `bare`.
    pub bare: bool,
    /// Its pieces.
    pub pieces: Vec<Spanned<TemplatePiece>>,
}

/// A piece of a line.
#[derive(Debug, Clone, PartialEq)]
pub enum TemplatePiece {
    /// Literal text, as it is printed (`{{` and `}}` stand for single braces, `\"` for a quote).
    Text(String),
    /// `{tool}`, `{tool:00}`.
    Placeholder {
        /// Its name.
        name: String,
        /// Its picture, if any.
        picture: Option<String>,
    },
}
