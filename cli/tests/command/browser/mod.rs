//! Chromium without a screen, driven over a pipe by its DevTools protocol.
//!
//! Rendering is in software, the network is left alone. Where no Chromium is installed a test says
//! so and passes, unless `TRIBOS_REQUIRE_TARGETS` is set.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// What goes wrong.
pub type Error = Box<dyn std::error::Error>;

/// Names under which the browser is installed.
const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];
/// Rendering in software, quiet, and talking through the descriptors 3 and 4.
const OPTIONS: &str = "--headless=new --no-sandbox --disable-gpu-sandbox --use-gl=angle \
    --use-angle=swiftshader --enable-unsafe-swiftshader --disable-background-networking \
    --disable-component-update --disable-sync --disable-quic --no-first-run \
    --hide-scrollbars --remote-debugging-pipe";
/// How long an answer may take.
const PATIENCE: Duration = Duration::from_secs(60);
/// How often a condition is looked at.
const PAUSE: Duration = Duration::from_millis(20);

/// A browser with one page open.
pub struct Browser {
    child: Child,
    orders: ChildStdin,
    answers: Receiver<Value>,
    session: Option<String>,
    asked: u64,
    /// Events that no one waited for.
    events: Vec<Value>,
    _home: tempfile::TempDir,
}

/// A picture: width, height and four bytes a pixel.
pub struct Picture {
    /// Pixels across.
    pub width: u32,
    /// Red, green, blue and opacity, row by row.
    pub pixels: Vec<u8>,
}

impl Picture {
    /// The number of different colours.
    pub fn colors(&self) -> usize {
        let pixels = self.pixels.as_chunks::<4>().0;
        pixels
            .iter()
            .collect::<std::collections::BTreeSet<_>>()
            .len()
    }
}

impl Browser {
    /// Starts it with a page of this size; `None`, with a word on it, where none is installed.
    pub fn start(width: u32, height: u32) -> Result<Option<Self>, Error> {
        let paths = std::env::var_os("PATH").unwrap_or_default();
        let installed = |name: &&str| std::env::split_paths(&paths).any(|p| p.join(name).is_file());
        let Some(name) = NAMES.into_iter().find(installed) else {
            if std::env::var_os("TRIBOS_REQUIRE_TARGETS").is_some() {
                return Err("no Chromium on the PATH; apt-get install chromium".into());
            }
            eprintln!("skipped: no Chromium on the PATH");
            return Ok(None);
        };
        let home = tempfile::tempdir()?;
        let mut child = Command::new("sh")
            .arg("-c")
            .arg(format!(
                "exec {name} {OPTIONS} --user-data-dir=\"$0\" 3<&0 4>&1"
            ))
            .arg(home.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let (Some(orders), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("no pipes".into());
        };
        let (sender, answers) = channel();
        // Ends with the browser, whose end closes the pipe.
        std::thread::spawn(move || {
            for message in BufReader::new(output).split(0).map_while(Result::ok) {
                let Ok(message) = serde_json::from_slice(&message) else {
                    continue;
                };
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        let mut browser = Self {
            child,
            orders,
            answers,
            session: None,
            asked: 0,
            events: Vec::new(),
            _home: home,
        };
        let page = json!({ "url": "about:blank" });
        let target = browser.call("Target.createTarget", page)?["targetId"].clone();
        let attach = json!({ "targetId": target, "flatten": true });
        let session = browser.call("Target.attachToTarget", attach)?;
        browser.session = session["sessionId"].as_str().map(String::from);
        for domain in ["Page", "Runtime", "Log", "Network"] {
            browser.call(&format!("{domain}.enable"), json!({}))?;
        }
        let size =
            json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        browser.call("Emulation.setDeviceMetricsOverride", size)?;
        Ok(Some(browser))
    }

    /// Gives an order and waits for the answer.
    pub fn call(&mut self, method: &str, params: Value) -> Result<Value, Error> {
        self.asked += 1;
        let mut order = json!({ "id": self.asked, "method": method, "params": params });
        if let Some(session) = &self.session {
            order["sessionId"] = session.as_str().into();
        }
        write!(self.orders, "{order}\0")?;
        self.orders.flush()?;
        loop {
            let message = self.answers.recv_timeout(PATIENCE);
            let message = message.map_err(|error| format!("{method}: {error}"))?;
            if message["id"] != self.asked {
                self.events.push(message);
            } else if message["error"].is_null() {
                return Ok(message["result"].clone());
            } else {
                return Err(format!("{method}: {}", message["error"]).into());
            }
        }
    }

    /// The value of an expression, promises awaited.
    pub fn value(&mut self, expression: &str) -> Result<Value, Error> {
        let ask = json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let answer = self.call("Runtime.evaluate", ask)?;
        match &answer["exceptionDetails"] {
            Value::Null => Ok(answer["result"]["value"].clone()),
            failed => Err(format!("{expression}: {failed}").into()),
        }
    }

    /// Opens a file and waits until an expression is true there.
    pub fn open(&mut self, file: &Path, ready: &str) -> Result<(), Error> {
        let url = format!("file://{}", file.canonicalize()?.display());
        self.call("Page.navigate", json!({ "url": url }))?;
        self.wait(ready)
    }

    /// Waits until an expression is true.
    pub fn wait(&mut self, expression: &str) -> Result<(), Error> {
        let since = Instant::now();
        while self.value(expression)? != true {
            if since.elapsed() > PATIENCE {
                return Err(format!("never: {expression}; {:?}", self.complaints()).into());
            }
            std::thread::sleep(PAUSE);
        }
        Ok(())
    }

    /// Brings the first element of a selector into view and clicks into its middle.
    pub fn click(&mut self, selector: &str) -> Result<(), Error> {
        let place = format!(
            "(() => {{ const element = document.querySelector({}); \
             element.scrollIntoView({{ block: 'center', behavior: 'instant' }}); \
             const b = element.getBoundingClientRect(); \
             return [b.left + b.width / 2, b.top + b.height / 2]; }})()",
            json!(selector)
        );
        let place = self.value(&place)?;
        for kind in ["mousePressed", "mouseReleased"] {
            let event = json!({
                "type": kind, "x": place[0], "y": place[1], "button": "left", "clickCount": 1
            });
            self.call("Input.dispatchMouseEvent", event)?;
        }
        Ok(())
    }

    /// Presses a key by its name.
    pub fn press(&mut self, key: &str) -> Result<(), Error> {
        for kind in ["keyDown", "keyUp"] {
            self.call(
                "Input.dispatchKeyEvent",
                json!({ "type": kind, "key": key }),
            )?;
        }
        Ok(())
    }

    /// The page as it is seen; kept under a name in the folder of the build.
    pub fn screenshot(&mut self, name: &str) -> Result<Picture, Error> {
        let answer = self.call("Page.captureScreenshot", json!({ "format": "png" }))?;
        let text = answer["data"].as_str().unwrap_or_default();
        let bytes = {
            use base64::Engine as _;
            base64::engine::general_purpose::STANDARD.decode(text)?
        };
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("screens");
        std::fs::create_dir_all(&folder)?;
        std::fs::write(folder.join(name), &bytes)?;
        let picture = resvg::tiny_skia::Pixmap::decode_png(&bytes)?;
        Ok(Picture {
            width: picture.width(),
            pixels: picture.data().to_vec(),
        })
    }

    /// Errors, warnings and exceptions so far, and addresses outside of the file system.
    pub fn complaints(&mut self) -> Vec<String> {
        let is_complaint = |event: &&Value| match event["method"].as_str() {
            Some("Runtime.exceptionThrown" | "Log.entryAdded") => true,
            Some("Runtime.consoleAPICalled") => event["params"]["type"] != "log",
            Some("Network.requestWillBeSent") => {
                let url = event["params"]["request"]["url"]
                    .as_str()
                    .unwrap_or_default();
                !["file:", "data:", "blob:", "about:"]
                    .iter()
                    .any(|own| url.starts_with(own))
            }
            _ => false,
        };
        self.events
            .iter()
            .filter(is_complaint)
            .map(Value::to_string)
            .collect()
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
