//! Runs of scenes by the code of the command `tribos run`, and what they leave.

use crate::arrays::refused;
use crate::scene::{parse, python};
use crate::threads::{detached, pool};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::{PyKeyboardInterrupt, PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::ThreadPool;
use std::fmt;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use tribos::record::Partner;
use tribos::record::RecordError;
use tribos::record::frames::{Bodies, Frame, FrameFolder};
use tribos::run::folder::Manifest;
use tribos::scene::RunBy;
use tribos_cli::failure::Failure;
use tribos_cli::library::{HostProgram, Pictures, Run};

/// How often the thread that waits for a run looks for signals.
const LOOK: Duration = Duration::from_millis(50);

/// Ends runs that were given it.
#[pyclass(frozen, module = "tribos._native")]
#[derive(Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

#[pymethods]
impl Stop {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// Asks them to end.
    fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// The run's end of the line to the thread that waits for it.
struct RunChannel {
    asked: Arc<AtomicBool>,
    told: Option<Sender<(Option<f64>, String)>>,
}

impl HostProgram for RunChannel {
    fn is_cancelled(&self) -> bool {
        self.asked.load(Ordering::Relaxed)
    }

    fn on_progress(&self, done: Option<f64>, words: fmt::Arguments<'_>) {
        if let Some(told) = &self.told {
            // Nobody listens any more: the run goes on.
            let _ = told.send((done, words.to_string()));
        }
    }
}

/// Runs a scene into a folder, as `tribos run` does. `progress` receives the share that is done, or None, and
/// words.
#[pyfunction]
#[pyo3(signature = (name, text, out, *, resume, anew, checkpoint, frames, allow_large, pictures, threads, progress, stop))]
#[expect(clippy::too_many_arguments, reason = "the options of the command")]
pub fn run_scene(
    py: Python<'_>,
    name: &str,
    text: &str,
    out: PathBuf,
    resume: bool,
    anew: bool,
    checkpoint: f64,
    frames: Option<u64>,
    allow_large: bool,
    pictures: bool,
    threads: Option<NonZeroUsize>,
    progress: Option<Bound<'_, PyAny>>,
    stop: Option<Bound<'_, Stop>>,
) -> PyResult<()> {
    let scene = parse(name, text, &[])?;
    let pause = Duration::try_from_secs_f64(checkpoint)
        .map_err(|_| PyValueError::new_err("checkpoint must be a time in s, at least 0"))?;
    if frames == Some(1) {
        let message = "frames must be 0 for none, or a whole number from 2 up";
        return Err(PyValueError::new_err(message));
    }
    let order = Run {
        out: &out,
        resume,
        anew,
        pause,
        frames,
        allow_large,
        pictures: if pictures {
            Pictures::Drawn
        } else {
            Pictures::LeftOut
        },
    };
    let asked = stop.map_or_else(Arc::default, |stop| stop.get().0.clone());
    let threads = threads_of(threads)?;
    follow(py, &asked, progress, |told| {
        let line = RunChannel {
            asked: asked.clone(),
            told,
        };
        threads.install(|| order.run(&scene, &line))
    })?
    .map_err(|failure| end(failure, &out))
}

/// Does `work` on another thread without the interpreter's lock, and listens to it and to signals. A signal, or
/// a callback that raises, asks the work to end; it is waited for.
fn follow<T: Send>(
    py: Python<'_>,
    asked: &AtomicBool,
    progress: Option<Bound<'_, PyAny>>,
    work: impl FnOnce(Option<Sender<(Option<f64>, String)>>) -> T + Send,
) -> PyResult<T> {
    let (told, line) = mpsc::channel();
    let (ended, end) = mpsc::channel();
    let wanted = progress.is_some();
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let done = work(wanted.then_some(told));
            let _ = ended.send(());
            done
        });
        // The interpreter's lock is given away beside it.
        let end = Mutex::new(end);
        let wait = || {
            let end = end.lock().unwrap_or_else(PoisonError::into_inner);
            end.recv_timeout(LOOK)
        };
        let mut raised = None;
        loop {
            // A worker that panicked has hung up.
            let waited = py.detach(wait);
            let look = || -> PyResult<()> {
                py.check_signals()?;
                if let Some(progress) = &progress {
                    for (done, words) in line.try_iter() {
                        progress.call1((done, words))?;
                    }
                }
                Ok(())
            };
            if raised.is_none()
                && let Err(error) = look()
            {
                asked.store(true, Ordering::Relaxed);
                raised = Some(error);
            }
            if waited != Err(RecvTimeoutError::Timeout) {
                break;
            }
        }
        let done = py.detach(|| worker.join());
        let done = done.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        match raised {
            // The run's own words about its end say more.
            Some(error) if !error.is_instance_of::<PyKeyboardInterrupt>(py) => Err(error),
            _ => Ok(done),
        }
    })
}

/// The threads for one run: those of the package, or its own.
fn threads_of(count: Option<NonZeroUsize>) -> PyResult<Arc<ThreadPool>> {
    let Some(count) = count else {
        return pool();
    };
    let builder = rayon::ThreadPoolBuilder::new().num_threads(count.get());
    Ok(Arc::new(builder.build().map_err(refused)?))
}

/// Why a run ended, in Python's words: an option of the command is an argument here.
fn end(failure: Failure, out: &Path) -> PyErr {
    let mut text = failure.to_string();
    for (option, argument) in [
        ("--allow-large", "allow_large=True"),
        ("--resume", "resume=True"),
        ("--anew", "anew=True"),
        ("--frames ", "frames="),
        ("--out", "out"),
    ] {
        text = text.replace(option, argument);
    }
    match failure {
        Failure::Input(_) => PyValueError::new_err(text),
        Failure::NoRoom(_) => PyOSError::new_err(text),
        Failure::Interrupted(_) if out.join(tribos::run::CHECKPOINT).exists() => {
            let told = text.lines().next().unwrap_or_default();
            let place = out.display();
            PyKeyboardInterrupt::new_err(format!("{told}; tribos.resume(\"{place}\") goes on"))
        }
        Failure::Interrupted(_) => {
            let told = text.lines().next().unwrap_or_default();
            PyKeyboardInterrupt::new_err(told.to_owned())
        }
        _ => PyRuntimeError::new_err(text),
    }
}

/// What a run without a folder gives: the summary, names of columns, and rows.
type InMemoryRun<'py> = (
    Bound<'py, PyAny>,
    Vec<&'static str>,
    Bound<'py, PyArray2<f64>>,
);

/// A sliding body, which takes a moment, without a folder; None for a powder or a tip.
#[pyfunction]
pub fn run_at_once<'py>(
    py: Python<'py>,
    name: &str,
    text: &str,
) -> PyResult<Option<InMemoryRun<'py>>> {
    let scene = parse(name, text, &[])?;
    let RunBy::Motion(moved) = scene.run_by() else {
        return Ok(None);
    };
    let run = detached(py, || moved.follow(&mut |_| true))?.map_err(slid)?;
    let rows = table(py, &run.rows.concat(), run.columns.len())?;
    let summary = python(py, &run.json(moved))?;
    Ok(Some((summary, run.columns.to_vec(), rows)))
}

fn slid(error: impl Into<Failure>) -> PyErr {
    match error.into() {
        Failure::Input(text) => PyValueError::new_err(text),
        other => PyRuntimeError::new_err(other.to_string()),
    }
}

fn table<'py>(
    py: Python<'py>,
    numbers: &[f64],
    columns: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let rows = numbers.len() / columns;
    PyArray1::from_slice(py, numbers).reshape([rows, columns])
}

/// The scene that the run in a folder is of, or None if no run is there: body and values.
#[pyfunction]
pub fn folder_scene<'py>(py: Python<'py>, folder: PathBuf) -> PyResult<Option<Bound<'py, PyAny>>> {
    let manifest = Manifest::read(&folder).map_err(refused)?;
    let run = manifest.filter(|manifest| manifest.command == "run");
    run.map(|manifest| python(py, &manifest.about)).transpose()
}

/// The frames that a run keeps.
#[pyclass(frozen, module = "tribos._native")]
#[derive(Debug)]
pub struct Film {
    path: PathBuf,
    bodies: Bodies,
    steps: Vec<u64>,
}

#[pymethods]
impl Film {
    /// Those of a folder; None if none are there.
    #[staticmethod]
    fn open(path: PathBuf) -> PyResult<Option<Self>> {
        let Some(bodies) = FrameFolder::bodies(&path).map_err(unread)? else {
            return Ok(None);
        };
        let steps = FrameFolder::steps(&path).map_err(unread)?;
        Ok(Some(Self {
            path,
            bodies,
            steps,
        }))
    }

    /// Steps of the run that frames are of.
    fn steps(&self) -> Vec<u64> {
        self.steps.clone()
    }

    /// Sides of the cell along x and y, periods along x, y and z (None along an open axis), radii, densities,
    /// materials, layers and parts of the bodies.
    fn bodies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        all.set_item("sides", self.bodies.sides)?;
        all.set_item("periods", self.bodies.periods)?;
        all.set_item(
            "densities",
            PyArray1::from_slice(py, &self.bodies.densities),
        )?;
        all.set_item(
            "materials",
            PyArray1::from_slice(py, &self.bodies.materials),
        )?;
        all.set_item("radii", PyArray1::from_slice(py, &self.bodies.radii))?;
        all.set_item("layers", PyArray1::from_slice(py, &self.bodies.layers))?;
        all.set_item("parts", PyArray1::from_slice(py, &self.bodies.parts))?;
        Ok(all)
    }

    /// The frame of a step.
    fn read<'py>(&self, py: Python<'py>, step: u64) -> PyResult<Bound<'py, PyDict>> {
        let frame = py
            .detach(|| FrameFolder::read(&self.path, &self.bodies, step))
            .map_err(unread)?;
        arrays(py, frame)
    }
}

fn unread(error: RecordError) -> PyErr {
    PyOSError::new_err(error.to_string())
}

/// A frame as arrays.
fn arrays(py: Python<'_>, frame: Frame) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    all.set_item("step", frame.step)?;
    all.set_item("time", frame.time)?;
    all.set_item("height", frame.height)?;
    all.set_item("measure", frame.measure)?;
    all.set_item("tilt", frame.tilt)?;
    let places: Vec<f64> = frame.places.iter().flatten().copied().collect();
    let places = PyArray1::from_vec(py, places).reshape([frame.places.len(), 3])?;
    all.set_item("positions", places)?;
    all.set_item("speeds", PyArray1::from_vec(py, frame.speeds))?;
    for (name, vectors) in [
        ("velocities", &frame.velocities),
        ("tangential_forces", &frame.tangential),
    ] {
        let numbers: Vec<f32> = vectors.iter().flatten().copied().collect();
        let array = PyArray1::from_vec(py, numbers).reshape([vectors.len(), 3])?;
        all.set_item(name, array)?;
    }
    let pairs: Vec<i64> = frame
        .contacts
        .iter()
        .flat_map(|contact| [i64::from(contact.a), partner(contact.b)])
        .collect();
    let pairs = PyArray1::from_vec(py, pairs).reshape([frame.contacts.len(), 2])?;
    all.set_item("contacts", pairs)?;
    let contacts = frame.contacts.iter();
    let forces: Vec<f32> = contacts.map(|contact| contact.normal_force).collect();
    all.set_item("normal_forces", PyArray1::from_vec(py, forces))?;
    let holds: Vec<u8> = frame
        .contacts
        .iter()
        .map(|contact| contact.hold.0)
        .collect();
    all.set_item("holds", PyArray1::from_vec(py, holds))?;
    Ok(all)
}

/// The index of a sphere, or −1 − w for wall w.
fn partner(other: Partner) -> i64 {
    match other {
        Partner::Particle(index) => index.into(),
        Partner::Wall(wall) => -1 - i64::from(wall),
    }
}
