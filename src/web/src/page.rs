//! The page: one HTML file with everything in it.
//!
//! Its policy allows its own script and style, by their hashes, and compiling WebAssembly, and nothing else: no network, no
//! frames, no other script, whatever a map's names hold. The archive lies in it packed and as base64, which cannot end an
//! element; a title is escaped.

use ct_codecs::{Base64, Encoder};
use flate2::Compression;
use flate2::write::GzEncoder;
use sha2::{Digest, Sha256};
use std::io::{self, Write};

/// The queries as WebAssembly, packed. `src/web/build` makes it.
pub const MODULE: &[u8] = include_bytes!("../module/mapd_web.wasm.gz");

const TEMPLATE: &str = include_str!("../page/page.html");
const STYLE: &str = include_str!("../page/page.css");
/// What names come from others first.
const SCRIPTS: [&str; 10] = [
    "\"use strict\";\n",
    include_str!("../page/colors.js"),
    include_str!("../page/shaders.js"),
    include_str!("../page/module.js"),
    include_str!("../page/camera.js"),
    include_str!("../page/painter.js"),
    include_str!("../page/labels.js"),
    include_str!("../page/panel.js"),
    include_str!("../page/search.js"),
    include_str!("../page/main.js"),
];

/// Bytes that are written as base64 at a time: a multiple of three, so that no piece but the last is padded.
const PIECE: usize = 3 << 16;

/// Writes the page of an archive.
///
/// Errors: what writing gives.
pub fn write(archive: &[u8], title: &str, out: &mut dyn Write) -> io::Result<()> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(archive)?;
    let packed = packer.finish()?;
    let script = SCRIPTS.concat();
    let mut rest = TEMPLATE;
    // The template's own words between braces are these and no others.
    while let Some((before, after)) = rest.split_once('{') {
        let (name, after) = after.split_once('}').unwrap_or((after, ""));
        out.write_all(before.as_bytes())?;
        match name {
            "policy" => out.write_all(policy(&script).as_bytes())?,
            "title" => out.write_all(escaped(title).as_bytes())?,
            "style" => out.write_all(STYLE.as_bytes())?,
            "script" => out.write_all(script.as_bytes())?,
            "module" => base64(MODULE, out)?,
            _ => base64(&packed, out)?,
        }
        rest = after;
    }
    out.write_all(rest.as_bytes())
}

/// What a browser lets the page do.
fn policy(script: &str) -> String {
    let hash = |text: &str| encoded(&Sha256::digest(text));
    format!(
        "default-src 'none'; script-src 'sha256-{}' 'wasm-unsafe-eval'; style-src 'sha256-{}'; base-uri 'none'; form-action 'none'",
        hash(script),
        hash(STYLE)
    )
}

fn encoded(bytes: &[u8]) -> String {
    // It fails only where there is no room for the text.
    Base64::encode_to_string(bytes).unwrap_or_default()
}

fn base64(bytes: &[u8], out: &mut dyn Write) -> io::Result<()> {
    bytes.chunks(PIECE).try_for_each(|piece| out.write_all(encoded(piece).as_bytes()))
}

/// Text that may stand between tags.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
