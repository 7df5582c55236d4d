//! Draws one figure into a rectangle of the image.

use super::axis::{Span, Ticks};
use super::canvas::{Area, PX, fitting, font, width};
use super::clip::{self, Point};
use super::legend::Block;
use super::marks::{ReferenceLine, Region, Series, curve};
use super::{Figure, FigureError};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

// Width of thin lines, half the width of an error bar's caps, length of ticks without a label.
const THIN: u32 = PX as u32;
const CAP: i32 = 4 * PX;
const FINE_TICK: i32 = 5 * PX / 2;

// Colours of the frame, the grid and reference lines.
const FRAME: RGBColor = RGBColor(80, 80, 80);
const GRID: RGBColor = RGBColor(226, 226, 226);
const GUIDE: RGBColor = RGBColor(140, 140, 140);

// A plot in which both axes run from 0 to 1, and its inside.
type Chart<'c, 'a> = ChartContext<'c, SVGBackend<'a>, Cartesian2d<Ticks, Ticks>>;
type Plot<'a> = DrawingArea<SVGBackend<'a>, Cartesian2d<Ticks, Ticks>>;

// Spans of the x and the y axis.
type AxisRanges = (Span, Span);

/// Draws a figure with everything around its plot.
pub(super) fn draw(figure: &Figure, area: &Area) -> Result<(), FigureError> {
    let area = area.margin(6 * PX, 6 * PX, 6 * PX, 6 * PX);
    let area = title(&figure.title, 16.0, &area)?;
    let legend = Block::new(figure, &area);
    let (body, side) = legend.split(&area);
    let spans = spans(figure)?;
    let chart = axes(figure, spans, &body)?;
    let plot = chart.plotting_area();
    for guide in &figure.guides {
        rule(guide, spans, plot)?;
    }

    // Points that cannot be shown have no place and break the curve.
    let place = |point: &Point| spans.0.place(point.0).zip(spans.1.place(point.1));
    for (index, series) in figure.series.iter().enumerate() {
        let places = || series.points.iter().map(place);
        let seen = places().flatten().filter(|at| clip::inside(*at));
        let pieces = clip::pieces(places());
        whiskers((series, index), spans, plot)?;
        curve(plot, (series, index), pieces, seen.collect())?;
    }
    for region in &figure.regions {
        name(region, spans, plot)?;
    }
    legend.draw(&side, &plot.strip_coord_spec())
}

/// Writes a title, made smaller when too long, and returns the rest of the area.
pub(super) fn title<'a>(text: &str, size: f64, area: &Area<'a>) -> Result<Area<'a>, FigureError> {
    if text.is_empty() {
        return Ok(area.clone());
    }
    let full = area.dim_in_pixel().0 as i32;
    Ok(area.titled(text, font(fitting(text, size, full)))?)
}

// Draws the error bars of a series with a cap at each end inside the plot.
fn whiskers(
    (series, index): (&Series, usize),
    spans: AxisRanges,
    plot: &Plot,
) -> Result<(), FigureError> {
    let (color, _) = series.look(index);
    let stroke = color.stroke_width(3 * THIN / 2);
    for ends in series.whiskers() {
        if spans.0.place(ends[0].0).is_none() {
            continue;
        }
        let ends = ends.map(|end| corner(end, spans));
        for piece in clip::pieces(ends.into_iter().map(Some)) {
            plot.draw(&PathElement::new(piece, stroke))?;
        }
        for end in ends.into_iter().filter(|end| clip::inside(*end)) {
            let cap = PathElement::new(vec![(-CAP, 0), (CAP, 0)], stroke);
            plot.draw(&(EmptyElement::at(end) + cap))?;
        }
    }
    Ok(())
}

// Spans of both axes from the points, error bars, regions and reference lines.
fn spans(figure: &Figure) -> Result<AxisRanges, FigureError> {
    let corners = figure.regions.iter().flat_map(|region| &region.outline);
    let points = figure.series.iter().flat_map(|series| &series.points);
    let rules = figure.guides.iter().map(|guide| match guide {
        ReferenceLine::Horizontal { at, .. } => (f64::NAN, *at),
        ReferenceLine::Vertical { at, .. } => (*at, f64::NAN),
    });
    let ends = figure.series.iter().flat_map(Series::whiskers).flatten();
    let points = points.chain(corners).copied().chain(ends).chain(rules);
    let points: Vec<Point> = points.collect();
    let x = Span::new(&figure.x, points.iter().map(|point| point.0))?;

    // Heights of points beside the plot do not count.
    let beside = |at: Option<f64>| at.is_some_and(|at| !(0.0..=1.0).contains(&at));
    let seen = points.iter().filter(|point| !beside(x.place(point.0)));
    Ok((x, Span::new(&figure.y, seen.map(|point| point.1))?))
}

// Draws axes as wide as their labels, with the regions between them.
fn axes<'c, 'a>(
    figure: &Figure,
    spans: AxisRanges,
    area: &'c Area<'a>,
) -> Result<Chart<'c, 'a>, FigureError> {
    let (full, height) = area.dim_in_pixel();
    let across = (full / (75 * THIN)).max(2) as usize;
    let up = (height / (45 * THIN)).max(2) as usize;
    let x_ticks = figure.x.ticks(&spans.0, across);
    let y_ticks = figure.y.ticks(&spans.1, up);
    let widest = y_ticks.0.iter().map(|(_, label)| width(label, 12.0)).max();
    let named = |label: &str| if label.is_empty() { 0 } else { 22 * PX };
    let mut chart = ChartBuilder::on(area)
        .margin_right(14 * PX)
        .margin_top(8 * PX)
        .x_label_area_size(22 * PX + named(&figure.x.label))
        .y_label_area_size(12 * PX + widest.unwrap_or(0) + named(&figure.y.label))
        .build_cartesian_2d(x_ticks, y_ticks)?;
    let plot = chart.plotting_area();
    for region in &figure.regions {
        let corners = region.outline.iter().map(|at| corner(*at, spans));
        let corners = clip::polygon(&corners.collect::<Vec<_>>());
        plot.draw(&Polygon::new(corners, region.fill.rgb()))?;
    }
    mesh(figure, &mut chart)?;
    let fine = [spans.0.fine_ticks(across), spans.1.fine_ticks(up)];
    fine_ticks(fine, chart.plotting_area())?;
    Ok(chart)
}

// Draws the grid, unless there are regions, the frame, ticks and the names of the axes.
fn mesh(figure: &Figure, chart: &mut Chart) -> Result<(), FigureError> {
    let (full, height) = chart.plotting_area().dim_in_pixel();
    let size = fitting(&figure.x.label, 14.0, full as i32);
    let size = fitting(&figure.y.label, size, height as i32);
    let shown = f64::from(u8::from(figure.regions.is_empty()));
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID.mix(shown).stroke_width(THIN))
        .axis_style(FRAME.stroke_width(THIN))
        .set_all_tick_mark_size(4 * PX)
        .label_style(font(12.0))
        .axis_desc_style(font(size))
        .x_desc(&figure.x.label)
        .y_desc(&figure.y.label)
        .draw()?;
    let border = vec![(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
    let border = PathElement::new(border, FRAME.stroke_width(THIN));
    Ok(chart.plotting_area().draw(&border)?)
}

// Draws the ticks between the labelled ones of a log axis, outside the frame.
fn fine_ticks([x, y]: [Vec<f64>; 2], plot: &Plot) -> Result<(), FigureError> {
    let across = x.into_iter().map(|at| ((at, 0.0), (0, FINE_TICK)));
    let up = y.into_iter().map(|at| ((0.0, at), (-FINE_TICK, 0)));
    for (at, end) in across.chain(up) {
        let mark = PathElement::new(vec![(0, 0), end], FRAME.stroke_width(THIN));
        plot.draw(&(EmptyElement::at(at) + mark))?;
    }
    Ok(())
}

// Place of a corner or end; values a log axis cannot show stand at its far low end.
fn corner((x, y): Point, spans: AxisRanges) -> Point {
    let end = |value: f64| if value > 0.0 { 1e4 } else { -1e4 };
    let (across, up) = (spans.0.place(x), spans.1.place(y));
    (across.unwrap_or(end(x)), up.unwrap_or(end(y)))
}

// Writes the label of a region, line by line around its place.
fn name(region: &Region, spans: AxisRanges, plot: &Plot) -> Result<(), FigureError> {
    let style = font(14.0).pos(Pos::new(HPos::Center, VPos::Center));
    let mut y = 9 * PX * (1 - region.label.lines().count() as i32);
    for line in region.label.lines() {
        let text = Text::new(line.to_owned(), (0, y), style.clone());
        plot.draw(&(EmptyElement::at(corner(region.label_at, spans)) + text))?;
        y += 18 * PX;
    }
    Ok(())
}

// Draws a reference line with its label at the upper or right end, if inside the plot.
fn rule(guide: &ReferenceLine, spans: AxisRanges, plot: &Plot) -> Result<(), FigureError> {
    let (at, label, upright) = match guide {
        ReferenceLine::Horizontal { at, label } => (spans.1.place(*at), label, false),
        ReferenceLine::Vertical { at, label } => (spans.0.place(*at), label, true),
    };
    let Some(at) = at.filter(|at| (0.0..=1.0).contains(at)) else {
        return Ok(());
    };
    let end = |far: f64| if upright { (at, far) } else { (far, at) };
    let style = font(12.0).pos(Pos::new(HPos::Right, VPos::Bottom));
    let (style, shift) = match upright {
        true => (style.transform(FontTransform::Rotate270), (-PX, 5 * PX)),
        false => (style, (-5 * PX, -PX)),
    };
    let line = PathElement::new(vec![end(0.0), end(1.0)], GUIDE.stroke_width(THIN));
    plot.draw(&line)?;
    let text = Text::new(label.clone(), shift, style);
    Ok(plot.draw(&(EmptyElement::at(end(1.0)) + text))?)
}
