//! Controllers from outside: a description in, program text or diagnostics out.

mod describe;
mod mistakes;
mod shipped;
