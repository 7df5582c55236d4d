use super::*;

// A figure with a log axis, a legend and a reference line.
fn figure() -> Figure {
    let curve = |power: i32| {
        let xs = (0..200).map(|step| 10_f64.powf(-4.0 + f64::from(step) * 0.03));
        xs.map(|x| (x, (1.0 + x).powi(-power))).collect::<Vec<_>>()
    };
    Figure::new("Two <curves>", Axis::log10("ε"), Axis::linear("μ"))
        .series(Series::line("first", curve(1)))
        .series(Series::dashed("second & last", curve(2)))
        .guide(ReferenceLine::horizontal(0.5, "one half"))
}

// Width and height in the header of a PNG file.
fn png_size(png: &[u8]) -> Option<(u32, u32)> {
    let number = |at: usize| Some(u32::from_be_bytes(png.get(at..at + 4)?.try_into().ok()?));
    let signed = png.starts_with(b"\x89PNG\r\n\x1a\n");
    signed.then(|| number(16).zip(number(20))).flatten()
}

#[test]
fn svg_holds_every_text() -> Result<(), FigureError> {
    let svg = figure().svg()?;
    let texts = ["Two &lt;curves&gt;", "first", "second &amp; last", "ε", "μ"];
    for text in texts
        .iter()
        .chain(&["one half", "10⁻²", "width=\"900\" height=\"560\""])
    {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!figure().legend(Legend::Hidden).svg()?.contains("first"));
    assert_eq!(svg, figure().svg()?);
    Ok(())
}

#[test]
fn png_has_its_size_and_text_and_is_always_the_same() -> Result<(), FigureError> {
    let bare = Figure::new("", Axis::linear("x"), Axis::linear("y")).size(310, 205);
    let named = Figure::new("ω", Axis::linear("x"), Axis::linear("y")).size(310, 205);
    assert_eq!(png_size(&bare.png()?), Some((310, 205)));
    assert_ne!(bare.png()?, named.png()?);
    assert_eq!(figure().png()?, figure().png()?);
    Ok(())
}

#[test]
fn odd_data_is_drawn_without_failing() -> Result<(), FigureError> {
    let bad = [f64::NAN, f64::INFINITY, 0.0, -1.0, 1e308].map(|x| (x, -x));
    let wide = [1e-299, 1e299, -1e299].map(|x| (x, x));
    let near = [1.0, 1.0 + 1e-15, 1.0 - 1e-15].map(|x| (x, x));
    for scale in [Scale::Linear, Scale::Log10] {
        for points in [&bad[..], &wide, &near, &[], &[(1.0, 3.0); 4]] {
            let region = Region {
                label: "A\nB".to_owned(),
                outline: points.to_vec(),
                fill: Color::pale(0),
                label_at: (f64::NAN, 0.0),
            };
            let figure = Figure::new("", Axis::new("x", scale), Axis::new("y", scale))
                .series(Series::line_points("a", points.to_vec()))
                .region(region)
                .guide(ReferenceLine::vertical(f64::NAN, "never"))
                .size(200, 150);
            assert!(!figure.svg()?.contains("NaN"));
            figure.png()?;
        }
    }
    Ok(())
}

#[test]
fn values_a_log_axis_cannot_show_break_the_line() -> Result<(), FigureError> {
    let points = [0.1, 1.0, 0.0, -1.0, 2.0, 10.0].map(|x| (x, x)).to_vec();
    let axis = || Axis::log10("").range(0.1, 10.0);
    let series = Series::line("", points).color(Color(1, 2, 3));
    let svg = Figure::new("", axis(), axis()).series(series).svg()?;
    assert_eq!(svg.matches("#010203").count(), 2);
    Ok(())
}

#[test]
fn lines_and_regions_end_at_the_border() {
    let line = [(-1.0, -1.0), (0.5, 0.5), (0.5, 9.0), (0.75, 0.5)].map(Some);
    let pieces = clip::pieces(line.into_iter());
    assert_eq!(pieces.len(), 2);
    let near = |(x, y): &clip::Point| clip::inside((0.999 * x, 0.999 * y));
    assert!(pieces.iter().flatten().all(near));
    let around = clip::polygon(&[(-1.0, 0.5), (0.5, 2.5), (2.0, 0.5), (0.5, -1.5)]);
    let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
    assert!(corners.iter().all(|corner| around.contains(corner)));
}

#[test]
fn every_legend_place_and_tiny_sizes_work() -> Result<(), FigureError> {
    use Legend::*;
    for legend in [Right, Below, TopLeft, TopRight, BottomLeft, BottomRight] {
        assert!(figure().legend(legend).svg()?.contains("first"));
        figure().legend(legend).size(120, 120).png()?;
    }
    let axis = Axis::log10("x").range(-1.0, 1.0);
    let range = Figure::new("", axis, Axis::linear("y")).svg();
    assert!(matches!(range, Err(FigureError::Range { .. })));
    assert!(matches!(
        figure().size(0, 9).svg(),
        Err(FigureError::Size { .. })
    ));
    Ok(())
}

#[test]
fn panels_hold_all_figures() -> Result<(), FigureError> {
    let names = ["red", "green", "blue"];
    let figures = names.map(|name| Figure::new(name, Axis::linear("x"), Axis::linear("y")));
    let panels = Panels::new("Grid", 2).cell(200, 150);
    let panels = figures.into_iter().fold(panels, Panels::figure);
    let svg = panels.svg()?;
    assert!(
        ["Grid", "red", "green", "blue"]
            .iter()
            .all(|name| svg.contains(name))
    );
    assert_eq!(png_size(&panels.png()?), Some((400, 334)));
    assert!(Panels::new("", 0).svg().is_ok());
    Ok(())
}

// Ends of every two-point line drawn in the colour 1, 2, 3, in pixels.
fn strokes(svg: &str) -> Vec<[f64; 4]> {
    let lines = svg.lines().filter(|line| line.contains("#010203"));
    let points = lines.filter_map(|line| line.split("points=\"").nth(1)?.split('"').next());
    let numbers = |text: &str| {
        let parts = text.split([' ', ',']).filter_map(|part| part.parse().ok());
        let ends: Vec<f64> = parts.map(|at: f64| at / f64::from(canvas::PX)).collect();
        ends.try_into().ok()
    };
    points.filter_map(numbers).collect()
}

#[test]
fn error_bars_reach_one_error_up_and_down() -> Result<(), FigureError> {
    let points = vec![(0.0, 1.0), (1.0, 2.0), (2.0, 2.0), (3.0, 3.0)];
    let series = Series::points("", points).color(Color(1, 2, 3));
    let series = series.errors(vec![1.0, 0.5, f64::NAN]);
    let draw = |low: f64, high: f64| {
        let y = Axis::linear("").range(low, high);
        let figure = Figure::new("", Axis::linear(""), y).series(series.clone());
        figure.legend(Legend::Hidden).svg()
    };

    // Two stems with two caps each; the first is twice as long as the second and ends beside the
    // second's middle.
    let whole = strokes(&draw(0.0, 4.0)?);
    let stems: Vec<_> = whole.iter().filter(|end| end[0] == end[2]).collect();
    let length = |stem: &[f64; 4]| (stem[1] - stem[3]).abs();
    assert_eq!((whole.len(), stems.len()), (6, 2));
    assert!((length(stems[0]) / length(stems[1]) - 2.0).abs() < 0.01);
    let top = stems[0][1].min(stems[0][3]);
    assert!((top - (stems[1][1] + stems[1][3]) / 2.0).abs() < 0.5);

    // Cut by the plot: no cap at the end outside, and the ends count for the range.
    assert_eq!(strokes(&draw(1.0, 4.0)?).len(), 5);
    let spread = Series::points("", vec![(0.0, 10.0)]).errors(vec![5.0]);
    let open = Figure::new("", Axis::linear(""), Axis::linear("")).series(spread);
    assert!(open.svg()?.contains("\n14\n"));
    Ok(())
}

#[test]
fn log_axes_have_eight_fine_ticks_a_decade() -> Result<(), FigureError> {
    let fine = |axis: Axis, count| {
        let span = axis::Span::new(&axis, std::iter::empty())?;
        Ok::<_, FigureError>((span.fine_ticks(count), span.low, span.high))
    };
    let (two, low, high) = fine(Axis::log10("").range(1.0, 100.0), 5)?;
    let values = two.iter().map(|at| 10_f64.powf(low + at * (high - low)));
    let values: Vec<i64> = values.map(|value| value.round() as i64).collect();
    let expected = [2, 3, 4, 5, 6, 7, 8, 9, 20, 30, 40, 50, 60, 70, 80, 90];
    assert_eq!(values, expected);

    // Begun decades have theirs; with every third decade labelled the other two are fine ticks.
    assert_eq!(
        fine(Axis::log10("").range(0.5, 20.0), 5)?.0.len(),
        5 + 8 + 1
    );
    assert_eq!(fine(Axis::log10("").range(1.0, 1e9), 3)?.0.len(), 6);
    for axis in [
        Axis::linear("").range(1.0, 100.0),
        Axis::log10("").range(2.0, 9.0),
    ] {
        assert!(fine(axis, 5)?.0.is_empty());
    }
    Ok(())
}

#[test]
fn a_line_whose_colour_is_repeated_is_dashed() {
    let series = Series::line("one of many", vec![(0.0, 0.0), (1.0, 1.0)]);
    let (first, eighth) = (series.look(0), series.look(7));
    assert_eq!(first.0, eighth.0);
    assert_eq!((first.1, eighth.1), (Style::Line, Style::Dashed));
    // A colour that was chosen is nobody else's.
    assert_eq!(series.color(Color(1, 2, 3)).look(7).1, Style::Line);
}

#[test]
fn an_axis_of_cases_has_their_names() -> Result<(), FigureError> {
    let names = ["(0, 0)", "(1, 0.5)", "(1, 1)"].map(String::from);
    let svg = Figure::new("", Axis::named("case", names.to_vec()), Axis::linear("y"))
        .series(Series::points("", vec![(1.0, 1.0), (2.0, 4.0), (3.0, 9.0)]))
        .svg()?;
    let at = |name: &str| svg.find(name);
    assert!(
        at("(0, 0)").is_some() && at("(0, 0)") < at("(1, 0.5)") && at("(1, 0.5)") < at("(1, 1)")
    );
    assert!(!svg.contains("2.5"));
    Ok(())
}

#[test]
fn zoomed_panels_are_shown_larger_with_the_same_drawing() -> Result<(), FigureError> {
    let panels = || {
        Panels::new("two", 2)
            .figure(figure())
            .figure(figure())
            .cell(300, 260)
    };
    let (plain, zoomed) = (panels(), panels().zoom(1.5));
    assert_eq!((plain.extent(), zoomed.extent()), ((600, 294), (900, 441)));
    let (small, large) = (plain.svg()?, zoomed.svg()?);
    assert!(large.contains("width=\"900\" height=\"441\""));
    let resized = small.replacen(
        "width=\"600\" height=\"294\"",
        "width=\"900\" height=\"441\"",
        1,
    );
    assert_eq!(resized, large);
    assert_eq!(png_size(&zoomed.png()?), Some((900, 441)));
    Ok(())
}
