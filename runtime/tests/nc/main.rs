//! NC text from outside: what is printed for a small dialect written by hand.

mod table;
mod writing;
