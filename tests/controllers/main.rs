//! Controllers from outside: a description in, program text or diagnostics out.

mod describe;
mod effects;
mod mistakes;
mod shipped;
