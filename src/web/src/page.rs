//! The page: one HTML file with everything in it.
//!
//! Its policy allows its own script and style, by their hashes, and compiling WebAssembly, and nothing else: no network, no
//! frames, no other script, whatever a map's names hold. The archive lies in it packed and as base64, which cannot end an
//! element; a title is escaped.

mod findings;

use ct_codecs::{Base64, Encoder};
pub use findings::{Findings, ReportedFinding};
use flate2::Compression;
use flate2::write::GzEncoder;
use sha2::{Digest, Sha256};
use std::io::{self, Write};

/// The queries as WebAssembly, packed. `src/web/build` makes it.
pub const MODULE: &[u8] = include_bytes!("../module/mapd_web.wasm.gz");

const TEMPLATE: &str = include_str!("../page/page.html");
const STYLE: &str = include_str!("../page/page.css");
/// What names come from others first.
const SCRIPTS: [&str; 13] = [
    "\"use strict\";\n",
    include_str!("../page/colors.js"),
    include_str!("../page/shaders.js"),
    include_str!("../page/module.js"),
    include_str!("../page/camera.js"),
    include_str!("../page/frames.js"),
    include_str!("../page/painter.js"),
    include_str!("../page/labels.js"),
    include_str!("../page/panel.js"),
    include_str!("../page/list.js"),
    include_str!("../page/search.js"),
    include_str!("../page/live.js"),
    include_str!("../page/main.js"),
];

/// Bytes that are written as base64 at a time: a multiple of three, so that no piece but the last is padded.
const PIECE: usize = 3 << 16;

/// Where a page has its map from.
#[derive(Clone, Copy, Debug)]
pub enum Content<'a> {
    /// An archive and what is laid over it, if anything is, which lie in the page.
    Archive {
        /// The archive's bytes.
        map: &'a [u8],
        /// The overlay's bytes; none without one.
        overlay: &'a [u8],
        /// What was found in the map's file.
        findings: &'a Findings,
    },
    /// Maps of these names, which the server of the page serves, too: the archive of the first at `map/0`, what is laid over it at `overlay/0`, its events
    /// at `events/0`, its findings at `findings/0`, and so on.
    Served(&'a [String]),
}

/// Writes a page.
///
/// Errors: what writing gives.
pub fn write(content: Content<'_>, title: &str, out: &mut dyn Write) -> io::Result<()> {
    let script = SCRIPTS.concat();
    let mut rest = TEMPLATE;
    // The template's own words between braces are these and no others.
    while let Some((before, after)) = rest.split_once('{') {
        let (name, after) = after.split_once('}').unwrap_or((after, ""));
        out.write_all(before.as_bytes())?;
        match name {
            "policy" => out.write_all(policy(&script, content).as_bytes())?,
            "title" => out.write_all(escaped(title).as_bytes())?,
            "style" => out.write_all(STYLE.as_bytes())?,
            "script" => out.write_all(script.as_bytes())?,
            "module" => base64(MODULE, out)?,
            "served" => out.write_all(served(content).as_bytes())?,
            name => packed(content, name, out)?,
        }
        rest = after;
    }
    out.write_all(rest.as_bytes())
}

/// What a browser lets the page do: of a page that is served, also to ask who serves it.
fn policy(script: &str, content: Content<'_>) -> String {
    let hash = |text: &str| encoded(&Sha256::digest(text));
    let (script, style) = (hash(script), hash(STYLE));
    let connect = match content {
        Content::Archive { .. } => "",
        Content::Served(_) => "connect-src 'self'; ",
    };
    format!(
        "default-src 'none'; script-src 'sha256-{script}' 'wasm-unsafe-eval'; style-src 'sha256-{style}'; {connect}base-uri 'none'; form-action 'none'"
    )
}

/// The names of the maps that are served as JSON, `null` for a page of its own.
fn served(content: Content<'_>) -> String {
    let Content::Served(names) = content else { return "null".to_owned() };
    // Within a string only, where this stands for the same; nothing else ends the element.
    serde_json::to_string(names).unwrap_or_default().replace('<', "\\u003c")
}

/// The archive, the overlay or the findings, packed; nothing for a page that fetches them.
fn packed(content: Content<'_>, name: &str, out: &mut dyn Write) -> io::Result<()> {
    let Content::Archive { map, overlay, findings } = content else { return Ok(()) };
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(match name {
        "overlay" => overlay,
        "findings" => findings.json().as_bytes(),
        _ => map,
    })?;
    base64(&packer.finish()?, out)
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
