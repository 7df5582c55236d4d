use super::super::axis::{Axis, Scale};
use super::*;

// A plane of 100 by 100 pixels over given spans.
fn plane(x: Axis, y: Axis) -> Plane {
    let span = |axis: &Axis| {
        let (low, high) = axis.range.unwrap_or((0.0, 1.0));
        let log = axis.scale == Scale::Log10;
        Span {
            scale: axis.scale,
            low: if log { low.log10() } else { low },
            high: if log { high.log10() } else { high },
        }
    };
    Plane {
        x: span(&x),
        y: span(&y),
        plot: Rect::new(0.0, 0.0, 100.0, 100.0),
    }
}

#[test]
fn non_positive_points_break_a_line_on_a_log_axis() {
    let plane = plane(Axis::log10("x").range(0.1, 10.0), Axis::linear("y"));
    let points = [
        (0.1, 0.1),
        (1.0, 0.2),
        (0.0, 0.3),
        (-1.0, 0.4),
        (1.0, 0.5),
        (10.0, 0.6),
    ];
    let pieces = plane.pieces(&points);
    assert_eq!(pieces.len(), 2);
    assert_eq!(pieces.concat().len(), 4);
}

#[test]
fn non_finite_points_break_a_line() {
    let plane = plane(Axis::linear("x"), Axis::linear("y"));
    let points = [
        (0.1, 0.1),
        (0.2, 0.2),
        (0.3, f64::NAN),
        (0.4, 0.4),
        (0.5, 0.5),
    ];
    assert_eq!(plane.pieces(&points).len(), 2);
}

#[test]
fn lines_end_at_the_border() {
    let plane = plane(Axis::linear("x"), Axis::linear("y"));
    let pieces = plane.pieces(&[(-1.0, -1.0), (0.5, 0.5), (0.5, 1e200), (0.75, 0.5)]);
    assert!(!pieces.is_empty());
    let slack = Rect::new(-1e-6, -1e-6, 100.0 + 1e-6, 100.0 + 1e-6);
    assert!(pieces.concat().iter().all(|point| slack.holds(*point)));
    assert!(plane.pieces(&[(-1.0, 0.5), (-0.5, 0.5)]).is_empty());
}

#[test]
fn polygons_are_cut_to_the_rectangle() {
    let rect = Rect::new(0.0, 0.0, 10.0, 10.0);
    let around = [(-5.0, -5.0), (15.0, -5.0), (15.0, 15.0), (-5.0, 15.0)];
    let kept = clip_polygon(&around, &rect);
    assert!(rect.corners().iter().all(|corner| kept.contains(corner)));
    assert!(kept.iter().all(|point| rect.holds(*point)));
    assert!(clip_polygon(&[(20.0, 1.0), (30.0, 1.0), (30.0, 5.0)], &rect).is_empty());
    assert!(clip_polygon(&[], &rect).is_empty());
}

#[test]
fn dashes_cover_their_share_of_the_line() {
    let line: Vec<Point> = (0..=130).map(|x| (f64::from(x), 0.0)).collect();
    let dashes = dashes(&line);
    assert_eq!(dashes.len(), 10);
    let length = |dash: &Vec<Point>| distance(dash[0], dash[dash.len() - 1]);
    assert!((dashes.iter().map(length).sum::<f64>() - 80.0).abs() < 1e-9);
}
