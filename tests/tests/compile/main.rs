//! What compiling yields: the same archive whatever the form, the threads and the source; frames and places on Earth.

// Every map of the shared corpus ends in an accepted map or in a clear error with its place.
mod corpus;
// The same bytes from the same input: twice, from one and two threads, over dirty memory, and on every machine.
mod determinism;
// Georeferences, header offsets and stated bounds of maps: what the archive stores and what is found.
mod georeference;
// Blocks of lanes tell the sections and roads that the lanes' rows lead to.
mod lane_blocks;
// Batches that are checked and lowered by themselves give the archive and the findings of one element after the other, wherever the text is cut.
mod lowering_ahead;
// Patches: roads and junctions that take the place of others while a map is compiled.
mod patches;
// Reading in batches gives the items and findings of reading one element after the other, wherever the text is cut.
mod reading_ahead;
// The compiler's modules import each other only in the order that ARCHITECTURE.md states.
mod rooms;
// The same archive, whatever form the map comes in and however many threads compile it.
mod same_archive;
// Surfaces as files write them: the same heights as worked out in `surfaces.rs`.
mod surface_files;
// Maps compiled into another frame: places, widths, heights, landmarks, and what cannot be transformed.
mod target_frame;
// Maps that make no sense, compiled into another frame: findings or a sound archive, never a panic.
mod target_frame_hostile;
// Maps compiled into another frame, against figures of PROJ.
mod target_frame_proj;
