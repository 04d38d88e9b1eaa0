//! The command line of bifdiag.

fn main() {}
