//! The digits of numbers: read (`decimal`, `usual_decimal`), rounded to a picture's last decimal (`rounding`), printed by it
//! (`picture`, `short_number`), shown to people (`rounded`) and counted up (`counter`). Nearly all numbers are short; those are
//! read, printed and counted with all of their digits at once, in the bytes of one machine word.

mod counter;
mod decimal;
mod digits;
mod picture;
mod rounded;
mod rounding;
mod short_number;
mod usual_decimal;

pub(crate) use counter::Counter;
pub(crate) use decimal::Decimal;
pub use picture::{DecimalPoint, Picture};
pub use rounded::{fixed, short};
pub(crate) use rounding::Rounding;
pub(crate) use short_number::ShortNumber;
pub(crate) use usual_decimal::usual_decimal;
