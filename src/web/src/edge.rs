//! The functions that the page calls.
//!
//! A module has one map, which lives as long as the module: a page that shows another one makes a module of its own for it.
//! WebAssembly has one thread, so that nothing is locked.
//!
//! SAFETY: the one thing here that the compiler cannot check is that no other function of the module has the name of an exported one. The
//! module has no other exports, and the linker refuses two of one name. All memory is that of safe Rust.
#![allow(unsafe_code)]

use crate::{Answer, Drawing, Kind, Layer, Link, Question};
use mapd_archive::{Archive, open, open_overlay};
use mapd_query::Map;
use mapd_query::view::View;
use std::cell::RefCell;
use std::time::{Duration, UNIX_EPOCH};

#[derive(Default)]
struct Module {
    archive: Option<&'static Archive<'static>>,
    /// What is laid over the map: an overlay's bytes; none where nothing is.
    overlay: Vec<u64>,
    overlay_bytes: usize,
    /// The moment that is asked about, in seconds since 1970.
    moment: f64,
    /// Room for what the page hands over: the archive, then texts.
    input: &'static mut [u64],
    answer: String,
    drawing: Drawing,
}

impl Module {
    /// Does something with the map and what is laid over it; none without an open archive.
    fn with_view<T>(&self, work: impl FnOnce(View<'_>) -> T) -> Option<T> {
        let map = Map::new(self.archive?, 0);
        let bytes: &[u8] = bytemuck::cast_slice(&self.overlay);
        let overlay = bytes.get(..self.overlay_bytes).and_then(|bytes| open_overlay(bytes).ok());
        let since = Duration::try_from_secs_f64(self.moment).unwrap_or_default();
        let view = View::new(map, overlay.as_ref(), UNIX_EPOCH + since);
        view.or_else(|_| View::new(map, None, UNIX_EPOCH + since)).ok().map(work)
    }
}

thread_local! {
    static MODULE: RefCell<Module> = RefCell::default();
}

/// Room for as many bytes, aligned as an archive must be. What lay there before is lost to the page.
#[unsafe(no_mangle)]
extern "C" fn reserve(bytes: usize) -> *mut u64 {
    MODULE.with_borrow_mut(|module| {
        let words = bytes.div_ceil(size_of::<u64>());
        // Room that is there already serves again.
        if module.input.len() < words {
            module.input = Box::leak(vec![0; words].into_boxed_slice());
        }
        module.input.as_mut_ptr()
    })
}

/// Opens the archive of so many bytes in the room that was reserved: whether it could be opened. The answer is what the map
/// is, or why it could not.
#[unsafe(no_mangle)]
extern "C" fn open_archive(bytes: usize, generation: f64) -> bool {
    MODULE.with_borrow_mut(|module| {
        let input: &'static mut [u64] = std::mem::take(&mut module.input);
        let input: &'static [u64] = input;
        let input: &'static [u8] = bytemuck::cast_slice(input);
        match open(&input[..bytes.min(input.len())]) {
            Ok(archive) => {
                let archive: &'static Archive<'static> = Box::leak(Box::new(archive));
                module.archive = Some(archive);
                let map = Map::new(archive, generation as u64);
                let view = View::new(map, None, UNIX_EPOCH);
                module.answer =
                    view.map(|view| Question::Map.answer(view).json).unwrap_or_default();
                true
            }
            Err(error) => {
                module.answer = error.to_string();
                false
            }
        }
    })
}

/// Lays the overlay of so many bytes in the room that was reserved over the map; 0: nothing any more. Whether it is one of this map; if not, nothing
/// is laid over it.
#[unsafe(no_mangle)]
extern "C" fn lay(bytes: usize) -> bool {
    MODULE.with_borrow_mut(|module| {
        let input: &[u8] = bytemuck::cast_slice(&*module.input);
        let overlay = input.get(..bytes).and_then(|bytes| open_overlay(bytes).ok());
        let of = overlay.map(|overlay| overlay.header.provenance.input_hash);
        let own = module.archive.map(|archive| archive.header.content_hash);
        let is_own = of.is_some() && of == own;
        let words = if is_own { bytes.div_ceil(size_of::<u64>()) } else { 0 };
        module.overlay = module.input.get(..words).unwrap_or_default().to_vec();
        module.overlay_bytes = if is_own { bytes } else { 0 };
        is_own
    })
}

/// Sets the moment of all that is asked from now on, in seconds since 1970.
#[unsafe(no_mangle)]
extern "C" fn set_moment(seconds: f64) {
    MODULE.with_borrow_mut(|module| module.moment = seconds);
}

/// Asks: length of the answer, 0 without an open archive.
fn ask(question: impl FnOnce(&[u8]) -> Option<Question<'_>>) -> usize {
    MODULE.with_borrow_mut(|module| {
        let input: &[u8] = bytemuck::cast_slice(&*module.input);
        let Some(question) = question(input) else { return 0 };
        let answer = module.with_view(|view| question.answer(view));
        let Some(Answer { json, drawing }) = answer else { return 0 };
        module.answer = json;
        module.drawing = drawing.unwrap_or_default();
        module.answer.len()
    })
}

/// [`Question::Place`].
#[unsafe(no_mangle)]
extern "C" fn place(x: f64, y: f64) -> usize {
    ask(|_| Some(Question::Place([x, y])))
}

/// [`Question::Geodetic`].
#[unsafe(no_mangle)]
extern "C" fn geodetic(latitude: f64, longitude: f64) -> usize {
    ask(|_| Some(Question::Geodetic([latitude, longitude])))
}

/// [`Question::Pick`].
#[unsafe(no_mangle)]
extern "C" fn pick(x: f64, y: f64, radius: f64) -> usize {
    ask(|_| Some(Question::Pick([x, y], radius)))
}

/// [`Question::Sheet`] of a [`Kind`] by its number.
#[unsafe(no_mangle)]
extern "C" fn sheet(kind: usize, row: u32) -> usize {
    ask(|_| Some(Question::Sheet(Link { kind: *Kind::ALL.get(kind)?, row })))
}

/// [`Question::Find`] of the UTF-8 text of so many bytes in the room that was reserved.
#[unsafe(no_mangle)]
extern "C" fn find(bytes: usize) -> usize {
    ask(|input| Some(Question::Find(std::str::from_utf8(input.get(..bytes)?).ok()?)))
}

/// [`Question::Way`].
#[unsafe(no_mangle)]
extern "C" fn way(from_x: f64, from_y: f64, to_x: f64, to_y: f64) -> usize {
    ask(|_| Some(Question::Way([from_x, from_y], [to_x, to_y])))
}

/// [`Question::LeftOut`].
#[unsafe(no_mangle)]
extern "C" fn left_out() -> usize {
    ask(|_| Some(Question::LeftOut))
}

/// Where the last answer lies: UTF-8.
#[unsafe(no_mangle)]
extern "C" fn answer() -> *const u8 {
    MODULE.with_borrow(|module| module.answer.as_ptr())
}

/// Length of the last answer.
#[unsafe(no_mangle)]
extern "C" fn answer_length() -> usize {
    MODULE.with_borrow(|module| module.answer.len())
}

/// Draws a [`Layer`] by its number.
#[unsafe(no_mangle)]
extern "C" fn draw(layer: usize) {
    MODULE.with_borrow_mut(|module| {
        let Some(layer) = Layer::ALL.get(layer) else { return };
        // What came before need not lie beside it.
        module.drawing = Drawing::default();
        module.drawing = module.with_view(|view| layer.draw(view)).unwrap_or_default();
    });
}

/// Where a part of the drawing lies: 0 corners, 1 triangles, 2 strokes, 3 chunks.
#[unsafe(no_mangle)]
extern "C" fn drawn(part: usize) -> *const u8 {
    MODULE.with_borrow(|module| match part {
        0 => module.drawing.corners.as_ptr().cast(),
        1 => module.drawing.triangles.as_ptr().cast(),
        2 => module.drawing.strokes.as_ptr().cast(),
        _ => module.drawing.chunks.as_ptr().cast(),
    })
}

/// Number of entries of a part of the drawing, as [`drawn`].
#[unsafe(no_mangle)]
extern "C" fn drawn_count(part: usize) -> usize {
    MODULE.with_borrow(|module| match part {
        0 => module.drawing.corners.len(),
        1 => module.drawing.triangles.len(),
        2 => module.drawing.strokes.len(),
        _ => module.drawing.chunks.len(),
    })
}
