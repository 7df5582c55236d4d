use super::super::scene::Anchor;
use super::*;

// Pixels of one large character.
fn glyph(character: char) -> Result<Vec<u8>, FigureError> {
    let mut scene = Scene::new((120, 120))?;
    let text = character.to_string();
    scene.text(&text, (40.0, 80.0), 40.0, Color(0, 0, 0), Anchor::Start);
    pixels(&scene)
}

#[test]
fn the_font_has_greek_raised_and_lowered_characters() -> Result<(), FigureError> {
    let missing = glyph('\u{e123}')?;
    let blank = glyph(' ')?;
    for character in "εαωγμσφ⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂₃₄₅₆₇₈₉−×·≤∞".chars()
    {
        let drawn = glyph(character)?;
        assert!(drawn != missing && drawn != blank, "{character}");
    }
    Ok(())
}

#[test]
fn baselines_sit_where_the_scene_wants_them() -> Result<(), FigureError> {
    let drawn = glyph('H')?;
    let dark = |row: &[u8]| row.chunks(3).any(|pixel| pixel[0] < 128);
    let rows: Vec<bool> = drawn.chunks(120 * 3).map(dark).collect();
    let last = rows.iter().rposition(|dark| *dark);
    let first = rows.iter().position(|dark| *dark);
    assert!(last.is_some_and(|row| (78..=81).contains(&row)), "{last:?}");
    assert!(
        first.is_some_and(|row| (49..=53).contains(&row)),
        "{first:?}"
    );
    Ok(())
}

#[test]
fn averaging_takes_the_mean_of_a_block() {
    let fine = [0, 0, 0, 90, 30, 9, 90, 30, 9, 0, 0, 0];
    assert_eq!(averaged(&fine, 6, 2), [45, 15, 5]);
}

#[test]
fn thin_lines_are_one_pixel_wide() -> Result<(), FigureError> {
    let mut scene = Scene::new((120, 120))?;
    scene.stroke(vec![(10.5, 40.5), (90.5, 40.5)], 1.0, Color(0, 0, 0));
    scene.stroke(vec![(60.5, 50.5), (60.5, 90.5)], 1.0, Color(0, 0, 0));
    let pixels = pixels(&scene)?;
    let at = |x: usize, y: usize| pixels[(y * 120 + x) * 3];
    assert_eq!([39, 40, 41].map(|y| at(50, y)), [255, 0, 255]);
    assert_eq!([59, 60, 61].map(|x| at(x, 70)), [255, 0, 255]);
    Ok(())
}
