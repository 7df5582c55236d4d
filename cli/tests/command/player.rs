//! The player of `tribos view` in a browser: keys, a narrow page, the arrows of a slider.

use crate::browser::{Browser, Error};
use crate::program::{Outcome, succeed, told};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Some twenty spheres.
const POWDER: &str = "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\n\
                      piston_mass = 100\nmu_rolling = 0.1\nmu_torsion = 0.1\nmax_steps = 60\n";
const READY: &str =
    "['ready', 'failed'].includes(document.querySelector('.tribos-player')?.dataset.state)";
/// A telephone that is held upright.
const PHONE: [u32; 2] = [390, 844];
const DESK: [u32; 2] = [1100, 960];

fn of_player(what: &str) -> String {
    format!("document.querySelector('.tribos-player').player.{what}")
}

/// The page of a scene that is run in the folder.
fn film(folder: &Path, scene: &str) -> Result<PathBuf, Error> {
    succeed(folder, ["run", scene, "--out", "out"])?;
    succeed(folder, "view out")?;
    Ok(folder.join("out/view.html"))
}

fn powder(folder: &Path) -> Result<PathBuf, Error> {
    std::fs::write(folder.join("powder.toml"), POWDER)?;
    film(folder, "powder.toml")
}

#[test]
fn keys_work_before_any_click() -> Outcome {
    let home = tempfile::tempdir()?;
    let page = film(home.path(), "disk")?;
    let Some(mut browser) = Browser::start(DESK[0], DESK[1])? else {
        return Ok(());
    };
    browser.open(&page, READY)?;
    browser.press("ArrowRight")?;
    browser.press("ArrowRight")?;
    assert_eq!(browser.value(&of_player("frame"))?, 2);
    browser.press("End")?;
    assert_eq!(
        browser.value(&of_player("frame"))?,
        browser.value(&of_player("meta.frames.length - 1"))?
    );
    browser.press(" ")?;
    browser.wait(&of_player("playing === true"))?;
    browser.click(".tribos-player .play")?;
    browser.wait(&of_player("playing === false"))?;
    Ok(())
}

#[test]
fn readout_and_legends_of_a_narrow_page_stand_below_the_picture() -> Outcome {
    let Some(mut browser) = Browser::start(PHONE[0], PHONE[1])? else {
        return Ok(());
    };
    for name in ["powder", "disk"] {
        let home = tempfile::tempdir()?;
        let page = match name {
            "powder" => powder(home.path())?,
            scene => film(home.path(), scene)?,
        };
        browser.open(&page, READY)?;
        if name == "powder" {
            browser.value(&of_player("choose({ balls: 'glass', forces: 'on' })"))?;
        }
        browser.value(&of_player("step(20)"))?;
        browser.wait(&of_player("waits !== true"))?;
        let picture = browser.screenshot(&format!("phone-{name}.png"))?;
        assert_eq!((picture.width, picture.colors() > 50), (PHONE[0], true));
        // Nothing is wider than the page, and all of the legend is below the picture.
        let layout = browser.value(
            "(() => { const box = (name) => document.querySelector(name).getBoundingClientRect(); \
             return { wide: document.documentElement.scrollWidth, stage: box('.stage').bottom, \
             below: box('.below').top, high: box('.below').height, next: box('.transport').top, \
             end: box('.below').bottom }; })()",
        )?;
        let number = |key: &str| layout[key].as_f64().unwrap_or(f64::NAN);
        assert!(number("wide") <= f64::from(PHONE[0]), "{name}: {layout}");
        assert!(number("below") >= number("stage"), "{name}: {layout}");
        assert!(
            number("high") > 100.0 && number("next") >= number("end"),
            "{name}: {layout}"
        );
        // What is left on the picture: the axes and the scale bar of a film in space.
        let covered = browser.value(
            "(() => { const ink = document.querySelector('.ink'); \
             const { data } = ink.getContext('2d').getImageData(0, 0, ink.width, ink.height); \
             let count = 0; for (let k = 3; k < data.length; k += 4) count += data[k] > 0; \
             return count / (ink.width * ink.height); })()",
        )?;
        let most = if name == "powder" { 0.08 } else { 0.0 };
        let covered = covered.as_f64().unwrap_or(f64::NAN);
        assert!(covered <= most, "{name}: {covered}");
        let text = browser.value(
            "(() => { const ink = document.querySelector('.below'); \
             const { data } = ink.getContext('2d').getImageData(0, 0, ink.width, ink.height); \
             return new Set(new Uint32Array(data.buffer)).size; })()",
        )?;
        assert!(text.as_u64().unwrap_or(0) > 20, "{name}: {text}");
        // The saved picture has both.
        let saved = browser.value(&of_player(
            "picture().height / document.querySelector('.stage .picture').height",
        ))?;
        assert!(saved.as_f64().unwrap_or(0.0) > 1.1, "{name}: {saved}");
    }
    assert_eq!(browser.complaints(), Vec::<String>::new());
    Ok(())
}

#[test]
fn a_wide_page_has_them_on_the_picture() -> Outcome {
    let home = tempfile::tempdir()?;
    let page = powder(home.path())?;
    let Some(mut browser) = Browser::start(DESK[0], DESK[1])? else {
        return Ok(());
    };
    browser.open(&page, READY)?;
    assert_eq!(
        browser.value("document.querySelector('.below').getBoundingClientRect().height")?,
        0
    );
    Ok(())
}

#[test]
fn a_sliders_film_has_its_parameters_force_and_torque() -> Outcome {
    let home = tempfile::tempdir()?;
    let page = film(home.path(), "disk")?;
    let Some(mut browser) = Browser::start(DESK[0], DESK[1])? else {
        return Ok(());
    };
    browser.open(&page, READY)?;
    let text = browser.value("document.querySelector('.parameters').textContent")?;
    for part in ["speed 1 m/s", "spin 5 rad/s", "gamma 0.3", "mass 0.1 kg"] {
        assert!(
            text.as_str().is_some_and(|text| text.contains(part)),
            "{text}"
        );
    }
    let first = browser.screenshot("disk-first.png")?;
    browser.value(&of_player("step(100)"))?;
    browser.wait(&of_player("waits !== true"))?;
    assert!(browser.screenshot("disk-arrows.png")?.pixels != first.pixels);
    let at: Value = browser.value(&of_player("view.at(100)"))?;
    let number = |key: &str| at[key].as_f64().unwrap_or(f64::NAN);
    // Work and spin: mu m g = 0.2943 N is the most that dry friction can do, and 2/3 R of it.
    let (force, torque) = (number("fx"), number("torque"));
    assert!(force < -0.05 && force > -0.2943, "{at}");
    assert!(
        torque < -1e-4 && torque > -0.2943 * 0.08 * 2.0 / 3.0,
        "{at}"
    );
    // F/(mu N) and T/(mu N R) are those of the ratio of the speeds.
    let [speed, spin] = ["speed", "spin"].map(number);
    let contact = "--coefficient 0.3 --load 0.981 --radius 0.08 --format json";
    let wrench = told(format!("wrench {contact} --speed {speed} --spin {spin}"))?;
    let exact: Value = serde_json::from_str(&wrench)?;
    for (drawn, name) in [(force, "force"), (torque, "torque")] {
        let exact = exact[name].as_f64().unwrap_or(f64::NAN);
        // Means over the two intervals of the series around the picture.
        assert!(
            (drawn + exact).abs() < 1e-3 * exact,
            "{name}: {drawn} {exact}"
        );
    }
    // The three arrows and their names are there.
    let shown = browser.value(&of_player(
        "view.legends()[0].kinds.map((kind) => kind.name)",
    ))?;
    for name in ["velocity", "force on the body", "torque on the body"] {
        assert!(
            shown
                .as_array()
                .is_some_and(|all| all.contains(&json!(name))),
            "{shown}"
        );
    }
    let colors = browser.value(
        "(() => { const canvas = document.querySelector('.picture'); \
         const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height); \
         const count = (r, g, b) => { let n = 0; for (let k = 0; k < data.length; k += 4) \
         n += data[k] === r && data[k + 1] === g && data[k + 2] === b; return n; }; \
         return [count(0x1b, 0x7f, 0x4d), count(0xa3, 0x24, 0x6c), count(0x7a, 0x5c, 0)]; })()",
    )?;
    for pixels in colors.as_array().into_iter().flatten() {
        assert!(pixels.as_u64().unwrap_or(0) > 100, "{colors}");
    }
    assert_eq!(browser.complaints(), Vec::<String>::new());
    Ok(())
}
