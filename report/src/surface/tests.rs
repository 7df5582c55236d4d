use super::*;

const GRID: [f64; 5] = [0.0, 0.1, 0.2, 0.4, 1.0];

fn axes() -> [Axis; 3] {
    let unit = |name: &str| Axis::linear(name).range(0.0, 1.0);
    [unit("μ_t"), unit("μ_n"), Axis::linear("porosity <E>")]
}

// Rises from the near corner.
fn rise(i: usize, j: usize) -> f64 {
    0.5 + 0.2 * GRID[i].sqrt() + 0.1 * GRID[j].sqrt()
}

fn surface(value: impl Fn(usize, usize) -> f64) -> Surface {
    Surface::new("Final porosity", axes(), [&GRID, &GRID], value)
}

// Outlines of cells, whiskers with their caps, and dots.
fn counts(svg: &str) -> [usize; 3] {
    let whiskers = svg.matches("stroke=\"#141414\"").count();
    [
        svg.matches("stroke=\"#3c3c3c\"").count(),
        whiskers,
        svg.matches("<circle").count(),
    ]
}

#[test]
fn every_cell_and_text_is_drawn_and_always_the_same() -> Result<(), FigureError> {
    let svg = surface(rise).svg()?;
    assert_eq!(counts(&svg), [16, 0, 0]);
    for text in [
        "Final porosity",
        "μ_t",
        "μ_n",
        "porosity &lt;E&gt;",
        ">0.4<",
        ">0.6<",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    assert_eq!(svg, surface(rise).svg()?);
    assert!(svg.len() < 150_000, "{}", svg.len());
    Ok(())
}

#[test]
fn missing_values_leave_holes_and_lone_points_are_dots() -> Result<(), FigureError> {
    let hole = |i, j| {
        if (i, j) == (2, 2) {
            f64::NAN
        } else {
            rise(i, j)
        }
    };
    assert_eq!(counts(&surface(hole).svg()?), [12, 0, 0]);
    let lone = |i, j| {
        if i % 2 == 0 && j == 3 {
            rise(i, j)
        } else {
            f64::INFINITY
        }
    };
    assert_eq!(counts(&surface(lone).svg()?), [0, 0, 3]);
    let nothing = surface(|_, _| f64::NAN).svg()?;
    assert!(counts(&nothing) == [0, 0, 0] && !nothing.contains("NaN"));
    Ok(())
}

#[test]
fn values_outside_a_given_range_are_missing() -> Result<(), FigureError> {
    let [x, y, z] = axes();
    let low = Surface::new("", [x, y, z.range(0.4, 0.79)], [&GRID, &GRID], rise);
    assert_eq!(counts(&low.svg()?), [15, 0, 0]);
    Ok(())
}

#[test]
fn whiskers_have_a_stem_two_caps_and_a_dot() -> Result<(), FigureError> {
    let at_two = |i, j| if i == j && i > 2 { 0.05 } else { f64::NAN };
    let open = surface(rise).errors(at_two);
    assert_eq!(counts(&open.svg()?), [16, 6, 2]);

    // The upper end of the last leaves the given range: no cap there.
    let [x, y, z] = axes();
    let cut = Surface::new("", [x, y, z.range(0.4, 0.82)], [&GRID, &GRID], rise);
    assert_eq!(counts(&cut.errors(at_two).svg()?), [16, 5, 2]);
    Ok(())
}

#[test]
fn grid_lines_may_come_in_any_order() -> Result<(), FigureError> {
    let mixed = [4, 0, 2, 1, 3];
    let xs = mixed.map(|at| GRID[at]);
    let ys = [1.0, f64::NAN, 0.4, 0.2, 0.1, 0.0];
    let other = Surface::new("Final porosity", axes(), [&xs, &ys], |i, j| {
        rise(mixed[i], if j == 0 { 4 } else { 5 - j })
    });
    assert_eq!(other.svg()?, surface(rise).svg()?);
    Ok(())
}

#[test]
fn nearer_cells_lie_over_farther_ones() -> Result<(), FigureError> {
    // On a level surface near corners stand lower in the picture.
    let svg = surface(|_, _| 0.5).svg()?;
    let outlines = svg.lines().filter(|line| line.contains("#3c3c3c"));
    let near = outlines.filter_map(|line| line.split([' ', 'L']).nth(2)?.parse().ok());
    let heights: Vec<f64> = near.collect();
    let lowest = heights.iter().copied().fold(f64::MIN, f64::max);
    let highest = heights.iter().copied().fold(f64::MAX, f64::min);
    assert_eq!((heights.len(), lowest > highest), (16, true));
    assert_eq!((heights[0], heights[15]), (highest, lowest));
    Ok(())
}

#[test]
fn odd_grids_are_drawn_without_failing() -> Result<(), FigureError> {
    for places in [&[][..], &[1.0], &[2.0, 2.0], &[-1e300, 1e299], &[f64::NAN]] {
        for log in [Axis::linear("z"), Axis::log10("z")] {
            let axes = [Axis::linear("x"), Axis::log10("y"), log];
            let odd = Surface::new("", axes, [places, places], |i, j| (i + j) as f64);
            let svg = odd.errors(|_, _| 0.5).size(160, 130).svg()?;
            assert!(!svg.contains("NaN") && !svg.contains("inf"));
        }
    }
    Ok(())
}
