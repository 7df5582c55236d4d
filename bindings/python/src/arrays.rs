//! Arguments as rows of numbers, broadcast over their leading axes, and the arrays for results.

use numpy::{
    PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use std::borrow::Cow;
use std::fmt::Display;
use std::ops::Range;

/// The refusal of an argument, with the kernel's text.
pub fn refused(error: impl Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// An argument of shape (…, `N`), contiguous and of type float64.
pub struct Rows<'py, const N: usize> {
    name: &'static str,
    values: PyReadonlyArrayDyn<'py, f64>,
    is_row: bool,
}

impl<'py, const N: usize> Rows<'py, N> {
    /// Anything that numpy makes an array of real numbers of, the last axis of length `N`.
    pub fn new(name: &'static str, given: &Bound<'py, PyAny>) -> PyResult<Self> {
        let array = contiguous(name, given)?;
        if array.shape().last() != Some(&N) {
            let shape = tuple(array.shape());
            return Err(PyValueError::new_err(format!(
                "{name} must have shape (..., {N}), not {shape}"
            )));
        }
        Ok(Self {
            name,
            values: array.readonly(),
            is_row: true,
        })
    }

    fn batch(&self) -> &[usize] {
        let shape = self.values.shape();
        &shape[..shape.len() - usize::from(self.is_row)]
    }
}

impl<'py> Rows<'py, 1> {
    /// An argument with one number an element: its whole shape is broadcast.
    pub fn numbers(name: &'static str, given: &Bound<'py, PyAny>) -> PyResult<Self> {
        Ok(Self {
            name,
            values: contiguous(name, given)?.readonly(),
            is_row: false,
        })
    }
}

/// An argument of one number an element; a Python number makes no array.
pub enum Numbers<'py> {
    /// The same for all elements.
    One(f64),
    /// An array.
    Many(Rows<'py, 1>),
}

impl<'py> Numbers<'py> {
    /// A number or an array of them.
    pub fn new(name: &'static str, given: &Bound<'py, PyAny>) -> PyResult<Self> {
        if let Ok(float) = given.cast::<pyo3::types::PyFloat>() {
            return Ok(Self::One(float.extract()?));
        }
        let rows = Rows::numbers(name, given)?;
        Ok(match rows.values.as_slice() {
            Ok([one]) if rows.batch().is_empty() => Self::One(*one),
            _ => Self::Many(rows),
        })
    }

    fn batch(&self) -> &[usize] {
        match self {
            Self::One(_) => &[],
            Self::Many(rows) => rows.batch(),
        }
    }

    /// The numbers of a batch of this shape.
    pub fn over(self, batch: &[usize]) -> PyResult<Column<'py, 1>> {
        match self {
            Self::One(one) => Ok(Column::One([one])),
            Self::Many(rows) => rows.over(batch),
        }
    }
}

/// Something with leading axes.
pub trait Batched {
    /// Its leading axes.
    fn leading(&self) -> &[usize];
    /// Its name in messages.
    fn called(&self) -> &'static str;
}

impl<const N: usize> Batched for Rows<'_, N> {
    fn leading(&self) -> &[usize] {
        self.batch()
    }
    fn called(&self) -> &'static str {
        self.name
    }
}

impl Batched for Numbers<'_> {
    fn leading(&self) -> &[usize] {
        self.batch()
    }
    fn called(&self) -> &'static str {
        match self {
            Self::One(_) => "",
            Self::Many(rows) => rows.name,
        }
    }
}

/// The shape that the leading axes of all arguments are broadcast to, by numpy's rule.
pub fn broadcast(all: &[&dyn Batched]) -> PyResult<Vec<usize>> {
    let most = all.iter().map(|one| one.leading().len()).max().unwrap_or(0);
    let mut batch = vec![1; most];
    for one in all {
        let shape = one.leading();
        for (at, &length) in batch[most - shape.len()..].iter_mut().zip(shape) {
            if *at == 1 {
                *at = length;
            } else if length != 1 && length != *at {
                let list: Vec<String> = all
                    .iter()
                    .filter(|one| !one.leading().is_empty())
                    .map(|one| format!("{} {}", one.called(), tuple(one.leading())))
                    .collect();
                return Err(PyValueError::new_err(format!(
                    "leading axes cannot be broadcast together: {}",
                    list.join(", ")
                )));
            }
        }
    }
    Ok(batch)
}

/// The rows of an argument for every element of a batch.
pub enum Column<'py, const N: usize> {
    /// The same row for all.
    One([f64; N]),
    /// A row an element.
    Each(PyReadonlyArrayDyn<'py, f64>),
}

impl<'py, const N: usize> Rows<'py, N> {
    /// The rows of a batch of this shape, which is one that they are broadcast to.
    pub fn over(self, batch: &[usize]) -> PyResult<Column<'py, N>> {
        let same = self.batch() == batch;
        if let (false, Ok(slice)) = (same, self.values.as_slice())
            && let Ok(row) = <[f64; N]>::try_from(slice)
        {
            return Ok(Column::One(row));
        }
        if same {
            return Ok(Column::Each(self.values));
        }
        let py = self.values.py();
        let mut shape = batch.to_vec();
        if self.is_row {
            shape.push(N);
        }
        let numpy = py.import("numpy")?;
        let spread = numpy.call_method1("broadcast_to", (self.values.as_any(), shape))?;
        Ok(Column::Each(contiguous(self.name, &spread)?.readonly()))
    }
}

impl<const N: usize> Column<'_, N> {
    /// The rows without Python, for work on other threads.
    pub fn view(&self) -> PyResult<View<'_, N>> {
        Ok(match self {
            Self::One(row) => View::One(*row),
            Self::Each(array) => View::Each(array.as_slice().map_err(refused)?.as_chunks().0),
        })
    }
}

/// The rows of a [`Column`].
#[derive(Clone, Copy)]
pub enum View<'a, const N: usize> {
    /// The same row for all.
    One([f64; N]),
    /// A row an element.
    Each(&'a [[f64; N]]),
}

impl<const N: usize> View<'_, N> {
    /// The row of element `index`.
    #[inline(always)]
    pub fn at(&self, index: usize) -> [f64; N] {
        match self {
            Self::One(row) => *row,
            Self::Each(rows) => rows[index],
        }
    }

    /// The rows of these elements.
    pub fn rows(&self, of: Range<usize>) -> Cow<'_, [[f64; N]]> {
        match self {
            Self::One(row) => Cow::Owned(vec![*row; of.len()]),
            Self::Each(rows) => Cow::Borrowed(&rows[of]),
        }
    }
}

/// An array for results: a new one, or the caller's `out`.
pub struct Output<'py> {
    /// The caller's array, if it gets a copy.
    out: Option<Bound<'py, PyAny>>,
    /// Whether the result is one number.
    is_number: bool,
    array: Bound<'py, PyArrayDyn<f64>>,
    memory: PyReadwriteArrayDyn<'py, f64>,
}

impl<'py> Output<'py> {
    /// For a batch of this shape with rows of shape `row`. `out` may be of any type that float64 is
    /// cast to within its kind, and may share memory with arguments.
    pub fn new(
        py: Python<'py>,
        batch: &[usize],
        row: &[usize],
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Self> {
        let shape = [batch, row].concat();
        if let Some(out) = out {
            check(out, &shape)?;
            // Written in place, unless an argument shares its memory.
            if let Ok(array) = out.cast::<PyArrayDyn<f64>>()
                && array.is_c_contiguous()
                && let Ok(memory) = array.try_readwrite()
            {
                return Ok(Self {
                    out: None,
                    is_number: false,
                    memory,
                    array: array.clone(),
                });
            }
        }
        let array = PyArrayDyn::<f64>::zeros(py, shape.clone(), false);
        Ok(Self {
            out: out.cloned(),
            is_number: shape.is_empty(),
            memory: array.readwrite(),
            array,
        })
    }

    /// The rows to be filled.
    pub fn rows<const N: usize>(&mut self) -> PyResult<&mut [[f64; N]]> {
        let slice = self.memory.as_slice_mut().map_err(refused)?;
        Ok(slice.as_chunks_mut().0)
    }

    /// The filled array.
    pub fn finish(self) -> PyResult<Bound<'py, PyAny>> {
        let array = self.array.into_any();
        let Some(out) = self.out else {
            // A number for a number, as numpy's functions do.
            let index = pyo3::types::PyTuple::empty(array.py());
            return if self.is_number {
                array.get_item(index)
            } else {
                Ok(array)
            };
        };
        out.set_item(pyo3::types::PyEllipsis::get(out.py()), array)?;
        Ok(out)
    }
}

/// Refuses an array that results of this shape cannot be written to.
fn check(out: &Bound<'_, PyAny>, shape: &[usize]) -> PyResult<()> {
    let Ok(array) = out.cast::<numpy::PyUntypedArray>() else {
        let kind = out.get_type().name()?;
        return Err(PyValueError::new_err(format!(
            "out must be a numpy array, not {kind}"
        )));
    };
    if array.shape() != shape {
        return Err(PyValueError::new_err(format!(
            "out must have shape {}, not {}",
            tuple(shape),
            tuple(array.shape())
        )));
    }
    let kind: char = array.dtype().getattr("kind")?.extract()?;
    if kind != 'f' {
        return Err(PyValueError::new_err(format!(
            "out must be an array of floats, not of {}",
            array.dtype()
        )));
    }
    let writeable: bool = out.getattr("flags")?.getattr("writeable")?.extract()?;
    if !writeable {
        return Err(PyValueError::new_err("out must be writeable"));
    }
    Ok(())
}

/// `given` as a contiguous array of float64: itself, if it is one.
fn contiguous<'py>(
    name: &'static str,
    given: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    if let Ok(array) = given.cast::<PyArrayDyn<f64>>()
        && array.is_c_contiguous()
    {
        return Ok(array.clone());
    }
    converted(name, given)
}

#[cold]
fn converted<'py>(
    name: &'static str,
    given: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    static ASARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let py = given.py();
    let refused = |error: PyErr| {
        let reason = error.value(py).to_string();
        PyValueError::new_err(format!("{name} must be real numbers: {reason}"))
    };
    let asarray = ASARRAY.import(py, "numpy", "asarray")?;
    let array = asarray.call1((given,)).map_err(refused)?;
    let kind: char = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !"fiub".contains(kind) {
        let dtype = array.getattr("dtype")?;
        return Err(PyValueError::new_err(format!(
            "{name} must be real numbers, not {dtype}"
        )));
    }
    let contiguous = py.import("numpy")?.getattr("ascontiguousarray")?;
    let made = contiguous.call1((&array, "float64")).map_err(refused)?;
    // It makes a row of a lone number.
    let made = if array.getattr("ndim")?.extract::<usize>()? == 0 {
        made.call_method1("reshape", (pyo3::types::PyTuple::empty(py),))?
    } else {
        made
    };
    Ok(made.cast_into::<PyArrayDyn<f64>>()?)
}

/// A shape as Python prints it.
fn tuple(shape: &[usize]) -> String {
    let list: Vec<String> = shape.iter().map(usize::to_string).collect();
    match list.as_slice() {
        [one] => format!("({one},)"),
        _ => format!("({})", list.join(", ")),
    }
}
