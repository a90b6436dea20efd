//! A browser without a window, driven over a pipe by the DevTools protocol.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Programs that are tried.
const PROGRAMS: [&str; 2] = ["chromium", "google-chrome"];
/// A browser that takes longer in all is ended.
const PATIENCE: Duration = Duration::from_secs(240);
/// Longest wait for a state, which is generous because machines may be busy.
const WAIT: Duration = Duration::from_secs(120);
/// Pause between two looks.
const PAUSE: Duration = Duration::from_millis(50);

/// The browser hears on descriptor 3 and answers on 4.
const START: &str = r#"exec "$0" "$@" 3<&0 4>&1 0</dev/null 1>/dev/null 2>/dev/null"#;

/// A browser with one page.
pub struct Browser {
    child: Arc<Mutex<Child>>,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
    session: Option<String>,
    asked: u64,
    /// Where the page is served, if it is.
    served: Option<String>,
    /// What went wrong in the page: exceptions, refusals by its policy, requests beyond files and where it is served.
    pub complaints: Vec<String>,
    _profile: tempfile::TempDir,
}

impl Browser {
    /// Starts one, with a page as large as that; none where there is no browser.
    pub fn start((width, height): (u32, u32)) -> Option<Self> {
        let found = |name: &&&str| {
            let output = Command::new(name).arg("--version").output();
            output.is_ok_and(|output| output.status.success())
        };
        let program = PROGRAMS.iter().find(found)?;
        let profile = tempfile::tempdir().expect("a folder");
        let mut child = Command::new("sh")
            .args([
                "-c",
                START,
                program,
                "--headless=new",
                "--no-sandbox",
                "--remote-debugging-pipe",
            ])
            .args(["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars"])
            .args(["--no-first-run", "--disable-background-networking", "--disable-sync"])
            .arg(format!("--window-size={width},{height}"))
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("sh runs");
        let (to, from) =
            (child.stdin.take().expect("a pipe"), child.stdout.take().expect("a pipe"));
        let child = Arc::new(Mutex::new(child));
        end_after_a_while(&child);
        let mut browser = Self {
            child,
            to,
            from: BufReader::new(from),
            session: None,
            asked: 0,
            served: None,
            complaints: Vec::new(),
            _profile: profile,
        };
        let page = browser.call("Target.createTarget", json!({ "url": "about:blank" }));
        let attach = json!({ "targetId": page["targetId"], "flatten": true });
        let session = browser.call("Target.attachToTarget", attach);
        browser.session = session["sessionId"].as_str().map(str::to_owned);
        for domain in ["Page", "Runtime", "Log", "Network"] {
            browser.call(&format!("{domain}.enable"), json!({}));
        }
        let size =
            json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        browser.call("Emulation.setDeviceMetricsOverride", size);
        Some(browser)
    }

    /// Asks the browser, and waits for its answer.
    pub fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.asked += 1;
        let mut request = json!({ "id": self.asked, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            request["sessionId"] = json!(session);
        }
        let mut bytes = request.to_string().into_bytes();
        bytes.push(0);
        self.to.write_all(&bytes).expect("the browser hears");
        loop {
            let mut message = Vec::new();
            self.from.read_until(0, &mut message).expect("the browser answers");
            assert_eq!(
                message.pop(),
                Some(0),
                "the browser ended, or took longer than {PATIENCE:?}: {method}"
            );
            let message: Value = serde_json::from_slice(&message).expect("JSON");
            if message["id"] == json!(self.asked) {
                assert!(message["error"].is_null(), "{method}: {}", message["error"]);
                return message["result"].clone();
            }
            self.listen(&message);
        }
    }

    fn listen(&mut self, event: &Value) {
        let what = &event["params"];
        match event["method"].as_str() {
            Some("Runtime.exceptionThrown") => {
                self.complaints.push(what["exceptionDetails"].to_string());
            }
            Some("Log.entryAdded") if what["entry"]["level"] == "error" => {
                self.complaints.push(what["entry"].to_string());
            }
            Some("Network.requestWillBeSent") => {
                let url = what["request"]["url"].as_str().unwrap_or_default();
                let is_served = self.served.as_ref().is_some_and(|own| url.starts_with(own));
                if !url.starts_with("file:") && !url.starts_with("blob:") && !is_served {
                    self.complaints.push(format!("asked for {url}"));
                }
            }
            _ => {}
        }
    }

    /// Opens a file, and waits until an expression is true.
    pub fn open(&mut self, file: &Path, ready: &str) {
        self.call("Page.navigate", json!({ "url": format!("file://{}", file.display()) }));
        self.wait(ready);
    }

    /// Opens a page that is served at an address, which may ask for more at that address, and waits likewise.
    pub fn open_served(&mut self, address: &str, ready: &str) {
        self.served = address.split('#').next().map(str::to_owned);
        self.call("Page.navigate", json!({ "url": address }));
        self.wait(ready);
    }

    /// Waits until an expression is true.
    pub fn wait(&mut self, state: &str) {
        let begun = Instant::now();
        while self.evaluate(&format!("Boolean({state})")) != json!(true) {
            let now = self.evaluate("document.body?.innerText");
            assert!(begun.elapsed() < WAIT, "{state}; {:?}; {now}", self.complaints);
            std::thread::sleep(PAUSE);
        }
    }

    /// The value of an expression of JavaScript, a promise's once it is kept.
    pub fn evaluate(&mut self, expression: &str) -> Value {
        let asked =
            json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let answer = self.call("Runtime.evaluate", asked);
        assert!(answer["exceptionDetails"].is_null(), "{}", answer["exceptionDetails"]);
        answer["result"]["value"].clone()
    }

    /// Presses and releases the left button.
    pub fn click(&mut self, x: f64, y: f64) {
        for kind in ["mouseMoved", "mousePressed", "mouseReleased"] {
            let button = if kind == "mouseMoved" { "none" } else { "left" };
            let count = u32::from(kind != "mouseMoved");
            let event =
                json!({ "type": kind, "x": x, "y": y, "button": button, "clickCount": count });
            self.call("Input.dispatchMouseEvent", event);
        }
    }

    /// Makes it a phone's browser, with a screen of so many pixels of the page, two of its own each.
    pub fn become_phone(&mut self, (width, height): (u32, u32)) {
        let size =
            json!({ "width": width, "height": height, "deviceScaleFactor": 2, "mobile": true });
        self.call("Emulation.setDeviceMetricsOverride", size);
        let touch = json!({ "enabled": true, "maxTouchPoints": 5 });
        self.call("Emulation.setTouchEmulationEnabled", touch);
    }

    /// Puts fingers down, moves them all at once from place to place, and lifts them; each finger's places in turn.
    pub fn touch(&mut self, fingers: &[&[[f64; 2]]]) {
        let steps = fingers.iter().map(|places| places.len()).min().unwrap_or(0);
        for step in 0..steps {
            let kind = if step == 0 { "touchStart" } else { "touchMove" };
            let points = fingers.iter().enumerate().filter_map(|(id, places)| {
                places.get(step).map(|[x, y]| json!({ "x": x, "y": y, "id": id }))
            });
            let points: Vec<Value> = points.collect();
            self.call("Input.dispatchTouchEvent", json!({ "type": kind, "touchPoints": points }));
        }
        self.call("Input.dispatchTouchEvent", json!({ "type": "touchEnd", "touchPoints": [] }));
    }

    /// Presses a key.
    pub fn key(&mut self, key: &str) {
        for kind in ["keyDown", "keyUp"] {
            let text = if key.chars().count() == 1 && kind == "keyDown" { key } else { "" };
            self.call("Input.dispatchKeyEvent", json!({ "type": kind, "key": key, "text": text }));
        }
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        end(&self.child);
    }
}

fn end(child: &Mutex<Child>) {
    if let Ok(mut child) = child.lock() {
        // It may have ended.
        let _ = child.kill();
        let _ = child.wait();
    }
}

/// So that a browser that hangs ends the test that waits for it.
fn end_after_a_while(child: &Arc<Mutex<Child>>) {
    let child = Arc::downgrade(child);
    std::thread::spawn(move || {
        let begun = Instant::now();
        while begun.elapsed() < PATIENCE && child.strong_count() > 0 {
            std::thread::sleep(Duration::from_millis(500));
        }
        if let Some(child) = child.upgrade() {
            end(&child);
        }
    });
}
