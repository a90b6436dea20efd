//! Small programs that show how mapd is used; each lies beside this folder and shows one thing.
//!
//! ```text
//! cargo run -p mapd-examples --example compile_from_code
//! cargo run -p mapd-examples --example which_lane -- town 50 -1.75
//! cargo run -p mapd-examples --example wait_at_boot -- town 10
//! ```
//!
//! The last two need a served map: `cargo run -- --load examples/maps/town.xodr`.
