//! What compiling yields: the same archive whatever the form, the threads and the source; frames and places on Earth.

mod corpus;
mod determinism;
mod georeference;
mod lowering_ahead;
mod patches;
mod reading_ahead;
mod rooms;
mod same_archive;
mod surface_files;
mod target_frame;
mod target_frame_hostile;
mod target_frame_proj;
