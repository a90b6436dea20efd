//! Rules of ASAM's that the schema says already: which structural finding stands for them.
