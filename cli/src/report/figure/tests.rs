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
        .guide(Guide::horizontal(0.5, "one half"))
}

// Width and height in the header of a PNG file.
fn png_size(png: &[u8]) -> Option<(u32, u32)> {
    let number = |at: usize| {
        let bytes = png.get(at..at + 4)?.try_into().ok()?;
        Some(u32::from_be_bytes(bytes))
    };
    png.starts_with(b"\x89PNG\r\n\x1a\n")
        .then(|| number(16).zip(number(20)))
        .flatten()
}

#[test]
fn svg_holds_every_text() -> Result<(), FigureError> {
    let svg = figure().svg()?;
    for text in [
        "Two &lt;curves&gt;",
        "first",
        "second &amp; last",
        "one half",
        "ε",
        "μ",
        "10⁻²",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(svg.contains("width=\"900\" height=\"560\""));
    assert!(svg.contains("font-family=\"sans-serif\""));
    Ok(())
}

#[test]
fn a_hidden_legend_shows_no_labels() -> Result<(), FigureError> {
    assert!(!figure().legend(Legend::Hidden).svg()?.contains("first"));
    Ok(())
}

#[test]
fn png_has_the_size_asked_for() -> Result<(), FigureError> {
    let png = figure().size(310, 205).png()?;
    assert_eq!(png_size(&png), Some((310, 205)));
    Ok(())
}

#[test]
fn same_figure_gives_same_bytes() -> Result<(), FigureError> {
    assert_eq!(figure().svg()?, figure().svg()?);
    let small = figure().size(300, 200);
    assert_eq!(small.png()?, small.png()?);
    Ok(())
}

#[test]
fn odd_data_is_drawn_without_failing() -> Result<(), FigureError> {
    let bad = vec![
        (f64::NAN, 1.0),
        (0.0, f64::INFINITY),
        (-1.0, -1.0),
        (1e308, -1e308),
    ];
    let constant = vec![(1.0, 3.0); 4];
    for scale in [Scale::Linear, Scale::Log10] {
        for points in [vec![], bad.clone(), constant.clone(), vec![(1e-300, 1e300)]] {
            let outline = points.clone();
            let region = Region {
                label: "A\nB".to_owned(),
                outline,
                fill: Color::pale(0),
                label_at: (f64::NAN, 0.0),
            };
            let figure = Figure::new("", Axis::new("x", scale), Axis::new("y", scale))
                .series(Series::line_points("a", points))
                .region(region)
                .guide(Guide::vertical(f64::NAN, "never"))
                .size(200, 150);
            assert!(figure.svg()?.contains("</svg>"));
            figure.png()?;
        }
    }
    Ok(())
}

#[test]
fn every_legend_place_and_tiny_sizes_work() -> Result<(), FigureError> {
    use Legend::*;
    for legend in [Right, Below, TopLeft, TopRight, BottomLeft, BottomRight] {
        assert!(figure().legend(legend).svg()?.contains("first"));
        figure().legend(legend).size(120, 120).png()?;
    }
    Ok(())
}

#[test]
fn bad_sizes_and_ranges_are_errors() {
    assert!(matches!(
        figure().size(0, 9).svg(),
        Err(FigureError::Size { .. })
    ));
    let axis = Axis::log10("x").range(-1.0, 1.0);
    let figure = Figure::new("", axis, Axis::linear("y"));
    assert!(matches!(figure.svg(), Err(FigureError::Range { .. })));
}

#[test]
fn panels_hold_all_figures() -> Result<(), FigureError> {
    let mut panels = Panels::new("Grid", 2).cell(200, 150);
    for name in ["red", "green", "blue"] {
        panels = panels.figure(Figure::new(name, Axis::linear("x"), Axis::linear("y")));
    }
    let svg = panels.svg()?;
    assert!(
        ["Grid", "red", "green", "blue"]
            .iter()
            .all(|name| svg.contains(name))
    );
    assert_eq!(png_size(&panels.png()?), Some((400, 338)));
    assert!(Panels::new("", 0).svg().is_ok());
    Ok(())
}

#[test]
fn filled_regions_stay_inside_the_plot() -> Result<(), FigureError> {
    let region = Region {
        label: "stick".to_owned(),
        outline: vec![(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)],
        fill: Color(1, 2, 3),
        label_at: (0.5, 0.5),
    };
    let (x, y) = (
        Axis::linear("").range(0.0, 1.0),
        Axis::linear("").range(0.0, 1.0),
    );
    let svg = Figure::new("", x, y).region(region).svg()?;
    let line = svg.lines().find(|line| line.contains("#010203"));
    let points = line.and_then(|line| line.split("points=\"").nth(1));
    let numbers = points.unwrap_or("").split(['"', ' ', ',']);
    let numbers: Vec<i32> = numbers.filter_map(|text| text.parse().ok()).collect();
    assert!(numbers.len() >= 8);
    assert!(numbers.iter().all(|number| (0..9000).contains(number)));
    assert!(svg.contains("stick"));
    Ok(())
}
