//! Writing drawings to files, in the format of the file extension.

use super::figure::{Figure, FigureError, Panels, canvas};
use super::packing::PackingPicture;
use super::surface::Surface;
use std::path::{Path, PathBuf};
use tribos::record::{RecordError, write_atomically};

/// Why a drawing could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ImageError {
    /// The drawing failed.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// The file cannot be written.
    #[error(transparent)]
    Write(#[from] RecordError),
    /// The file extension is not that of a supported format.
    #[error("{}: end the name in .svg, .png or .csv", .0.display())]
    Ending(PathBuf),
}

/// Anything that can be drawn.
pub trait Drawing {
    /// As SVG text.
    fn to_svg(&self) -> Result<String, FigureError>;
    /// As a PNG file.
    fn to_png(&self) -> Result<Vec<u8>, FigureError> {
        canvas::png(&self.to_svg()?)
    }
    /// Width and height in pixels.
    fn extent(&self) -> (u32, u32);
}

impl Drawing for Figure {
    fn to_svg(&self) -> Result<String, FigureError> {
        self.svg()
    }
    fn extent(&self) -> (u32, u32) {
        self.extent()
    }
}

impl Drawing for Panels {
    fn to_svg(&self) -> Result<String, FigureError> {
        self.svg()
    }
    fn extent(&self) -> (u32, u32) {
        self.extent()
    }
}

impl Drawing for Surface {
    fn to_svg(&self) -> Result<String, FigureError> {
        self.svg()
    }
    fn extent(&self) -> (u32, u32) {
        self.extent()
    }
}

impl Drawing for PackingPicture {
    fn to_svg(&self) -> Result<String, FigureError> {
        self.svg()
    }
    fn extent(&self) -> (u32, u32) {
        self.extent()
    }
}

/// Writes `stem`.svg and `stem`.png into `folder`; returns the SVG.
pub fn write_both(folder: &Path, stem: &str, drawing: &dyn Drawing) -> Result<String, ImageError> {
    let svg = drawing.to_svg()?;
    write_atomically(&folder.join(format!("{stem}.svg")), svg.as_bytes())?;
    write_atomically(&folder.join(format!("{stem}.png")), &drawing.to_png()?)?;
    Ok(svg)
}

/// Writes the drawing, or its numbers, in the format of the file extension.
pub fn write_as_named(
    path: &Path,
    drawing: &dyn Drawing,
    csv: impl FnOnce() -> String,
) -> Result<(), ImageError> {
    let ending = path.extension().and_then(|ending| ending.to_str());
    let bytes = match ending {
        Some("svg") => drawing.to_svg()?.into_bytes(),
        Some("png") => drawing.to_png()?,
        Some("csv") => csv().into_bytes(),
        _ => {
            return Err(ImageError::Ending(path.to_owned()));
        }
    };
    Ok(write_atomically(path, &bytes)?)
}
