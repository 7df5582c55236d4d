//! Frames of runs, and `tribos view`: the same frames after a break, a page that plays.

use crate::browser::Browser;
use crate::program::{self, Error, Outcome, files, prepared, wait_for};
use std::path::Path;

/// Some twenty spheres.
const POWDER: &str = "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\n\
                      piston_mass = 100\nmu_rolling = 0.1\nmu_torsion = 0.1\n";
/// 748 atoms, 400 steps.
const TIP: &str = "body = \"tip\"\nlambda = 0.02\nsubstrate_columns = 12\nsubstrate_rows = 14\ntip_side_atoms = 3\n\
                   substrate_layers = 4\ntip_layers = 4\nequilibration = 0.5\ndrive_time = 1\n\
                   rest_time = 0.5\nsample_every = 20\n";

/// Runs a command in the folder, where the scenes are: exit code, output and errors.
fn tribos(folder: &Path, arguments: &str) -> Result<(Option<i32>, String, String), Error> {
    std::fs::write(folder.join("powder.toml"), POWDER)?;
    std::fs::write(folder.join("tip.toml"), TIP)?;
    program::tribos(folder, arguments)
}

/// Runs it with success.
fn succeed(folder: &Path, arguments: &str) -> Result<String, Error> {
    let (code, out, err) = tribos(folder, arguments)?;
    assert_eq!(code, Some(0), "{arguments}: {err}");
    Ok(out)
}

#[test]
fn a_killed_run_leaves_the_same_bounded_frames() -> Outcome {
    let home = tempfile::tempdir()?;
    let run = "run powder.toml --set max_steps=400 --frames 20";
    succeed(home.path(), &format!("{run} --out whole"))?;
    let whole = files(&home.path().join("whole/frames"))?;
    // 0, 32, …, 384, the end and what all have in common.
    assert_eq!(whole.len(), 13 + 1 + 1);
    assert!(whole.contains_key("000000000384.frame") && whole.contains_key("000000000400.frame"));

    // No frames change nothing else.
    succeed(
        home.path(),
        "run powder.toml --set max_steps=400 --frames 0 --out bare",
    )?;
    assert!(!home.path().join("bare/frames").exists());
    for file in ["series.csv", "final.vtp", "final.xyz"] {
        let [a, b] = ["whole", "bare"].map(|out| std::fs::read(home.path().join(out).join(file)));
        assert!(a? == b?, "{file}");
    }

    // A checkpoint after every step, until the run is killed on its way.
    let broken = home.path().join("broken");
    let under_way = format!("{run} --checkpoint 0 --out broken");
    let mut child = prepared(home.path(), under_way).spawn()?;
    wait_for("the run is under way", || {
        broken.join("checkpoint.json").exists() && broken.join("frames/000000000064.frame").exists()
    });
    child.kill()?;
    child.wait()?;
    assert!(!broken.join("summary.json").exists(), "killed too late");
    std::fs::write(
        broken.join("frames/.tribos-Ab3.tmp"),
        "a frame that was being written",
    )?;

    // As many as at the start, or none: other frames are not there any more.
    let (code, _, said) = tribos(
        home.path(),
        "run powder.toml --set max_steps=400 --frames 30 --resume --out broken",
    )?;
    assert_eq!(code, Some(2));
    assert!(
        said.contains("--frames 20") && said.contains("--anew"),
        "{said}"
    );
    succeed(
        home.path(),
        "run powder.toml --set max_steps=400 --resume --out broken",
    )?;
    assert!(files(&broken.join("frames"))? == whole);
    Ok(())
}

#[test]
fn pictures_of_frames_are_drawn() -> Outcome {
    let home = tempfile::tempdir()?;
    succeed(
        home.path(),
        "run powder.toml --set max_steps=9 --out powder",
    )?;
    succeed(home.path(), "view powder --still 2,last --network")?;
    succeed(home.path(), "run tip.toml --out tip")?;
    // One frame every line of the series.
    assert_eq!(files(&home.path().join("tip/frames"))?.len(), 21 + 1);
    succeed(home.path(), "view tip --still 21")?;
    for file in [
        "powder/still-2.png",
        "powder/still-10.png",
        "tip/still-21.png",
    ] {
        assert!(home.path().join(file).metadata()?.len() > 5000, "{file}");
    }
    Ok(())
}

/// Addresses that a page would load or link to.
fn addresses(page: &str) -> Vec<&str> {
    let starts = ["http://", "https://", "src=", "@import", "url("];
    starts
        .into_iter()
        .filter(|start| page.contains(start))
        .collect()
}

/// The coordinates in a line of a file of states.
fn coordinates(line: &str) -> Vec<f64> {
    let words = line.split_whitespace().skip(2).take(3);
    words.filter_map(|word| word.parse().ok()).collect()
}

/// The state of the player, as an expression.
fn of_player(what: &str) -> String {
    format!("document.querySelector('.tribos-player').player.{what}")
}

const READY: &str =
    "['ready', 'failed'].includes(document.querySelector('.tribos-player')?.dataset.state)";

/// Colours that the drawing surface shows, by reading its pixels back.
const SHADES: &str = "(() => { const { gl, canvas } = document.querySelector('.tribos-player').player.view; \
    const pixels = new Uint8Array(4 * canvas.width * canvas.height); \
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels); \
    return new Set(new Uint32Array(pixels.buffer)).size; })()";

#[test]
fn the_page_plays_in_a_browser_without_a_network() -> Outcome {
    let home = tempfile::tempdir()?;
    succeed(
        home.path(),
        "run powder.toml --set max_steps=400 --frames 60 --out powder",
    )?;
    succeed(home.path(), "view powder")?;
    succeed(home.path(), "run tip.toml --out tip")?;
    succeed(home.path(), "view tip --out tip.html")?;
    let cylinder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/cylinder.toml");
    succeed(home.path(), &format!("run {cylinder} --out cylinder"))?;
    succeed(home.path(), "view cylinder")?;
    let pages =
        ["powder/view.html", "tip.html", "cylinder/view.html"].map(|file| home.path().join(file));
    for page in &pages {
        assert_eq!(
            addresses(&std::fs::read_to_string(page)?),
            [""; 0],
            "{}",
            page.display()
        );
    }

    let Some(mut browser) = Browser::start(1100, 960)? else {
        return Ok(());
    };
    browser.open(&pages[0], READY)?;
    browser.wait(&format!("{SHADES} > 100"))?;
    let first = browser.screenshot("powder.png")?;
    assert!(first.width == 1100 && first.colors() > 100);

    // The film's last frame is the run's last state, as near as two roundings to places allow.
    let last = of_player("view.film");
    let places = browser.value(&format!(
        "(() => {{ const f = {last}; const [low, high] = f.meta.box; \
         return Array.from(f.places.subarray(3 * f.n * (f.frames - 1)), \
         (x, k) => low[k % 3] + (high[k % 3] - low[k % 3]) * x / 65535); }})()"
    ))?;
    let shown: Vec<f64> = places
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(serde_json::Value::as_f64)
        .collect();
    let xyz = std::fs::read_to_string(home.path().join("powder/final.xyz"))?;
    let exact: Vec<f64> = xyz.lines().skip(2).flat_map(coordinates).collect();
    assert_eq!(shown.len(), exact.len());
    for (shown, exact) in shown.iter().zip(&exact) {
        assert!(
            (shown - exact).abs() < 1.01 * 12.0 / 65535.0,
            "{shown} {exact}"
        );
    }
    let summary = std::fs::read_to_string(home.path().join("powder/summary.json"))?;
    let summary: serde_json::Value = serde_json::from_str(&summary)?;
    let most = browser.value(&format!(
        "(() => {{ const f = {last}; const at = f.starts[f.frames - 1]; \
         return f.forces.subarray(at).filter((_, k) => f.b[at + k] < f.n).reduce((a, b) => Math.max(a, b), 0); }})()"
    ))?;
    let largest = summary["statistics"]["compression"]["largest"]
        .as_f64()
        .unwrap_or(f64::NAN);
    let error = most.as_f64().unwrap_or(f64::NAN) / largest - 1.0;
    assert!(error.abs() <= 1.0 / 256.0, "{most} {largest}");

    // Play goes on by itself, the arrow key by one, the scrub bar anywhere.
    browser.click(".tribos-player .play")?;
    browser.wait(&of_player("frame > 3"))?;
    browser.click(".tribos-player .play")?;
    browser.wait(&of_player("playing === false"))?;
    let at = browser.value(&of_player("frame"))?.as_i64().unwrap_or(-1);
    browser.press("ArrowRight")?;
    assert_eq!(browser.value(&of_player("frame"))?, at + 1);
    browser.click(".tribos-player .scrub")?;
    let middle = browser.value(&of_player("frame"))?.as_i64().unwrap_or(-1);
    let frames = browser
        .value(&of_player("meta.frames.length"))?
        .as_i64()
        .unwrap_or(-1);
    assert!((middle - frames / 2).abs() <= 2, "{middle} of {frames}");

    // Other colours and the forces are other pictures, and the legend names them.
    let mut seen = vec![first.pixels];
    for look in [
        "color: 'speed'",
        "color: 'mode'",
        "balls: 'glass', forces: 'on'",
    ] {
        browser.value(&of_player(&format!("choose({{ {look} }})")))?;
        browser.wait(&of_player("waits !== true"))?;
        seen.push(
            browser
                .screenshot(&format!("powder-{}.png", seen.len()))?
                .pixels,
        );
    }
    for (k, picture) in seen.iter().enumerate() {
        assert!(!seen[..k].contains(picture), "{k}");
    }
    let label = browser.value("document.querySelector('.stage').getAttribute('aria-label')")?;
    assert!(
        label
            .as_str()
            .is_some_and(|label| label.contains("porosity")),
        "{label}"
    );
    let saved = browser.value(&of_player("picture().toDataURL('image/png').length"))?;
    assert!(saved.as_i64().unwrap_or(0) > 20_000, "{saved}");

    for (page, name) in [(&pages[1], "tip.png"), (&pages[2], "cylinder.png")] {
        browser.open(page, READY)?;
        browser.value(&of_player("step(Infinity)"))?;
        assert!(browser.screenshot(name)?.colors() > 50, "{name}");
    }
    assert_eq!(browser.complaints(), Vec::<String>::new());
    Ok(())
}
