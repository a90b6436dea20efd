//! Looks at a page of `mapd export --format html` in Chromium: how large it is, how soon ready, how many frames it draws a second while it is moved, and
//! what it looks like.
//!
//! ```text
//! look map.html                              the figures
//! look map.html --least-frames 20            fails if it draws fewer a second, unless other programs keep the machine busy
//! look map.html --picture map.png            a picture instead of frames
//! look map.html --size 800x500 --run 'viewer.choose({ kind: "road", row: 0 })' --picture map.png
//! ```
//!
//! Chromium draws in software (SwiftShader), so that every machine has the same picture and no graphics card helps.

use clap::Parser;
use ct_codecs::{Base64, Decoder};
use mapd_tests::browser::Browser;
use serde_json::{Value, json};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

/// Looks at a page.
#[derive(Parser)]
struct Arguments {
    /// The page
    page: PathBuf,
    #[arg(long, help = "Its size on the screen [px]", default_value = "1000x700", value_parser = size)]
    size: (u32, u32),
    /// JavaScript to run first, whose value is printed; `viewer` is the page
    #[arg(long)]
    run: Option<String>,
    /// Frames a second that it must draw, of the whole map and of a piece; fewer are an error
    #[arg(long, value_name = "N", conflicts_with = "picture")]
    least_frames: Option<f64>,
    /// PNG to write
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let parts = text.split_once('x').map(|(width, height)| (width.parse(), height.parse()));
    let Some((Ok(width), Ok(height))) = parts else { return Err("expected WIDTHxHEIGHT".into()) };
    Ok((width, height))
}

/// How long it is looked at what other programs do.
const BEFORE: Duration = Duration::from_secs(2);
/// Share of the processors' time that other programs may take where frames a second are to decide.
const MOST_OTHERS: f64 = 0.15;

/// Share of the processors' time that programs take now; none where the system does not tell.
fn busy() -> Option<f64> {
    let times = || -> Option<[f64; 2]> {
        let text = std::fs::read_to_string("/proc/stat").ok()?;
        let fields = text.lines().next()?.split_whitespace().skip(1);
        let ticks: Vec<f64> = fields.map_while(|field| field.parse().ok()).collect();
        // The fourth and fifth are idle, and waiting for disks; the first eight are all.
        Some([ticks.get(3)? + ticks.get(4)?, ticks.iter().take(8).sum()])
    };
    let before = times()?;
    std::thread::sleep(BEFORE);
    let after = times()?;
    Some(1.0 - (after[0] - before[0]) / (after[1] - before[1]).max(1.0))
}

/// Moves the map, each frame a little, for some seconds: frames a second of the whole map, and of a piece of 600 m.
const MOVE: &str = "(async () => {
    const speed = async () => {
        viewer.paint();
        const { gl } = viewer.painter, begun = performance.now();
        let frames = 0;
        while (performance.now() - begun < 5000) {
            viewer.camera.x += 6 / viewer.camera.scale * (frames % 200 < 100 ? 1 : -1);
            // As when somebody drags it: the page paints in the browser's next frame, before this goes on.
            viewer.changed();
            await new Promise(requestAnimationFrame);
            // Until it is drawn.
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
            frames++;
        }
        return frames / (performance.now() - begun) * 1000;
    };
    viewer.fit();
    const whole = await speed();
    viewer.fit();
    const { x, y } = viewer.camera;
    viewer.show([x - 300, y - 300, x + 300, y + 300]);
    const near = await speed();
    viewer.fit();
    viewer.paint();
    return [whole, near];
})()";

fn main() -> ExitCode {
    let Arguments { page, size, run, least_frames, picture } = Arguments::parse();
    let page = page.canonicalize().expect("the page is there");
    let others = least_frames.and_then(|_| busy()).unwrap_or(0.0);
    let mut browser = Browser::start(size).expect("Chromium is installed");
    browser.open(
        &page,
        "globalThis.viewer?.ready || document.querySelector('#message')?.textContent.includes('cannot')",
    );
    let mut out = std::io::stdout().lock();
    let bytes = page.metadata().expect("a file").len();
    let ready = browser.evaluate("viewer.ready / 1000");
    let mut say = |text: String| writeln!(out, "{text}").expect("stdout");
    say(format!("{:.1} MB, ready after {:.1} s", bytes as f64 / 1e6, number(&ready)));
    let mut is_slow = false;
    if picture.is_none() {
        let speeds = browser.evaluate(MOVE);
        let [whole, near] = [0, 1].map(|at| number(&speeds[at]));
        say(format!("{whole:.0} frames/s of the whole map, {near:.0} of a piece of 600 m"));
        // Also what is not a number.
        is_slow = least_frames.is_some_and(|least| !(whole >= least && near >= least));
        if is_slow {
            say(format!("fewer than {} frames/s", least_frames.unwrap_or_default()));
        }
        if is_slow && others > MOST_OTHERS {
            let share = 100.0 * others;
            say(format!(
                "SKIPPED: other programs take {share:.0} % of the processors' time, so that this decides nothing"
            ));
            is_slow = false;
        }
    }
    let value = run.map(|run| browser.evaluate(&run)).unwrap_or_default();
    if !value.is_null() {
        say(value.to_string());
    }
    // Until all of it is painted.
    browser.evaluate("new Promise(done => setTimeout(done, 500))");
    if let Some(file) = picture {
        let taken = browser.call("Page.captureScreenshot", json!({ "format": "png" }));
        let text = taken["data"].as_str().expect("a picture");
        std::fs::write(file, Base64::decode_to_vec(text, None).expect("base64")).expect("written");
    }
    assert_eq!(browser.complaints, [""; 0]);
    if is_slow { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}
