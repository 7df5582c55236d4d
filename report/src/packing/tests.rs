use super::*;

const BOX: [f64; 2] = [10.0, 10.0];
const LOW: [f64; 3] = [3.0, 4.0, 1.0];
const HIGH: [f64; 3] = [3.0, 4.0, 3.0];

fn joined(a: usize, b: impl Into<Option<usize>>, normal_force: f64) -> Contact {
    let b = b.into();
    Contact { a, b, normal_force }
}

// A deposit of a given number of spheres on a lattice that fills the box.
fn lattice(count: usize) -> Vec<[f64; 3]> {
    let at = |place: usize| 1.0 + 2.0 * (place % 5) as f64;
    let centre = |i: usize| [at(i), at(i / 5), 1.0 + 2.0 * (i / 25) as f64];
    (0..count).map(centre).collect()
}

// Ends and widths of the lines drawn in the two colours of forces, nearest colours only.
fn lines(svg: &str) -> Vec<([f64; 4], f64)> {
    let drawn = svg
        .lines()
        .filter(|line| line.contains("stroke-width") && !line.contains("#969696"));
    let number = |line: &str| {
        let numbers = line
            .split(['"', 'M', 'L', ' '])
            .filter_map(|part| part.parse().ok());
        let numbers: Vec<f64> = numbers.collect();
        let ends = numbers.get(..4)?.try_into().ok()?;
        (numbers.len() == 5).then(|| (ends, numbers[4]))
    };
    let samples = 2;
    drawn.filter_map(number).skip(samples).collect()
}

#[test]
fn near_spheres_lie_over_far_ones() -> Result<(), Box<dyn std::error::Error>> {
    let positions = [[5.0, 1.0, 2.0], [5.0, 9.0, 2.0], [5.0, 5.0, 2.0]];
    let packing = Packing::new(&positions, &[1.0; 3], BOX, None)?;
    let values = [0.0, 0.5, 1.0];
    let picture = PackingPicture::spheres("", &packing);
    let picture = picture.color_by(Axis::linear("value").range(0.0, 1.0), &values)?;
    let svg = picture.svg()?;
    let drawn = svg.lines().filter(|line| line.contains("<circle"));
    let colors: Vec<_> = drawn
        .filter_map(|line| line.split("#ball-").nth(1))
        .collect();
    let name = |share: f64| {
        let crate::figure::Color(r, g, b) = super::super::solid::ramp::color(share);
        format!("{r:02x}{g:02x}{b:02x}")
    };
    let expected = [0.5, 1.0, 0.0].map(name);
    assert!(
        colors
            .iter()
            .zip(&expected)
            .all(|(drawn, name)| drawn.starts_with(name.as_str()))
    );
    assert_eq!(colors.len(), 3);
    Ok(())
}

#[test]
fn spheres_outside_the_box_are_drawn_at_their_image() -> Result<(), Box<dyn std::error::Error>> {
    let draw = |x: f64, y: f64| -> Result<String, Box<dyn std::error::Error>> {
        let positions = [[x, y, 2.0]];
        let packing = Packing::new(&positions, &[1.0], BOX, Some(5.0))?;
        Ok(PackingPicture::spheres("one", &packing).svg()?)
    };
    assert_eq!(draw(3.0, 4.0)?, draw(-27.0, 14.0)?);
    assert_ne!(draw(3.0, 4.0)?, draw(3.5, 4.0)?);
    Ok(())
}

#[test]
fn widths_follow_the_force_and_colours_its_sign() -> Result<(), Box<dyn std::error::Error>> {
    let positions = [LOW, HIGH, [3.0, 4.0, 5.0]];
    let packing = Packing::new(&positions, &[1.0; 3], BOX, Some(6.0))?;
    let contacts = [
        joined(0, 1, 2.0),
        joined(1, 2, -1.0),
        joined(0, None, 0.5),
        joined(2, None, f64::NAN),
        joined(0, 2, 0.0),
    ];
    let picture = PackingPicture::forces("Forces", &packing, &contacts)?;
    let svg = picture.svg()?;
    let mut widths: Vec<f64> = lines(&svg).iter().map(|line| line.1).collect();
    widths.sort_by(f64::total_cmp);
    assert_eq!(widths.len(), 3);
    assert!((widths[2] / widths[1] - 2.0).abs() < 0.01);
    assert!((widths[2] / widths[0] - 4.0).abs() < 0.02);
    for text in ["compression", "tension", "radius: 2<"] {
        assert!(svg.contains(text), "{text}");
    }

    // Half the width when the full one stands for twice the force.
    let half = lines(&picture.full_force(4.0, "F_coh").svg()?);
    let widest = half.iter().map(|line| line.1).fold(0.0, f64::max);
    assert!((widths[2] / widest - 2.0).abs() < 0.01);
    Ok(())
}

#[test]
fn no_line_crosses_the_box() -> Result<(), Box<dyn std::error::Error>> {
    let longest = |positions: [[f64; 3]; 2]| -> Result<(usize, f64), Box<dyn std::error::Error>> {
        let packing = Packing::new(&positions, &[1.0; 2], BOX, None)?;
        let contacts = [joined(0, 1, 1.0)];
        let drawn = lines(
            &PackingPicture::forces("", &packing, &contacts)?
                .headroom(9.0)
                .svg()?,
        );
        let length = |line: &([f64; 4], f64)| (line.0[2] - line.0[0]).hypot(line.0[3] - line.0[1]);
        Ok((drawn.len(), drawn.iter().map(length).sum()))
    };

    // Across the border in x, in y and at the corner: two halves as long as one line inside.
    let inside = longest([[4.0, 5.0, 1.0], [6.0, 5.0, 1.0]])?;
    let across = longest([[9.0, 5.0, 1.0], [1.0, 5.0, 1.0]])?;
    assert_eq!((inside.0, across.0), (1, 2));
    assert!((inside.1 - across.1).abs() < 0.05, "{inside:?} {across:?}");
    let diagonal = longest([[4.0, 4.0, 1.0], [5.4, 5.4, 1.0]])?;
    let corner = longest([[9.3, 9.3, 1.0], [20.7, -9.3, 1.0]])?;
    assert_eq!((diagonal.0, corner.0), (1, 2));
    assert!((diagonal.1 - corner.1).abs() < 0.05);
    Ok(())
}

#[test]
fn a_plates_contact_ends_at_the_nearer_plate() -> Result<(), PackingError> {
    let positions = [LOW, [3.0, 4.0, 8.0]];
    let packing = Packing::new(&positions, &[1.0; 2], BOX, Some(9.0))?;
    assert_eq!(packing.branch_to_plate(0), [0.0, 0.0, -1.0]);
    assert_eq!(packing.branch_to_plate(1), [0.0, 0.0, 1.0]);
    let open = Packing::new(&positions, &[1.0; 2], BOX, None)?;
    assert_eq!(open.branch_to_plate(1), [0.0, 0.0, -8.0]);
    Ok(())
}

#[test]
fn contacts_are_counted_for_both_spheres_and_plates() -> Result<(), PackingError> {
    let positions = lattice(3);
    let packing = Packing::new(&positions, &[1.0; 3], BOX, None)?;
    let contacts = [joined(0, 1, 1.0), joined(1, 2, -1.0), joined(0, None, 1.0)];
    assert_eq!(packing.coordination(&contacts)?, [2.0, 2.0, 1.0]);
    Ok(())
}

#[test]
fn the_largest_system_stays_a_reasonable_file() -> Result<(), Box<dyn std::error::Error>> {
    // The largest system of section 4.7, and as many contacts as a dense packing has.
    let positions = lattice(4193);
    let packing = Packing::new(&positions, &[1.0; 4193], BOX, Some(340.0))?;
    let contacts: Vec<_> = (0..4168)
        .flat_map(|i| [1, 5, 25].map(|step| joined(i, i + step, 1.0 - 0.0003 * i as f64)))
        .collect();
    let spheres = PackingPicture::spheres("Spheres", &packing).svg()?;
    let forces = PackingPicture::forces("Forces", &packing, &contacts)?.svg()?;
    assert!(spheres.len() < 600_000, "{}", spheres.len());
    assert!(forces.len() < 2_000_000, "{}", forces.len());
    assert_eq!(spheres.matches("<circle").count(), 4193);
    assert_eq!(spheres, PackingPicture::spheres("Spheres", &packing).svg()?);
    Ok(())
}

#[test]
fn what_cannot_be_drawn_is_refused() -> Result<(), PackingError> {
    let new =
        |radii: &[f64], lengths, piston| Packing::new(&[LOW, HIGH], radii, lengths, piston).err();
    let two = [1.0, 1.0];
    let lists = PackingError::Radii {
        positions: 2,
        radii: 1,
    };
    assert_eq!(new(&[1.0], BOX, None), Some(lists));
    assert_eq!(new(&[1.0, 0.0], BOX, None), Some(PackingError::Sphere(1)));
    let flat = [10.0, -1.0];
    assert_eq!(new(&two, flat, None), Some(PackingError::Box(flat)));
    assert_eq!(new(&two, BOX, Some(0.0)), Some(PackingError::Piston(0.0)));
    let lost = Packing::new(&[[f64::NAN, 0.0, 0.0]], &[1.0], BOX, None);
    assert_eq!(lost.err(), Some(PackingError::Sphere(0)));

    let positions = [LOW, HIGH];
    let packing = Packing::new(&positions, &two, BOX, None)?;
    for bad in [joined(0, 2, 1.0), joined(2, None, 1.0), joined(1, 1, 1.0)] {
        let contacts = [joined(0, 1, 1.0), bad];
        let refused = PackingPicture::forces("", &packing, &contacts).err();
        assert_eq!(refused, Some(PackingError::Contact(1)));
    }
    let values = PackingPicture::spheres("", &packing).color_by(Axis::linear(""), &[1.0]);
    let expected = PackingError::Values {
        values: 1,
        spheres: 2,
    };
    assert_eq!(values.err(), Some(expected));
    Ok(())
}

#[test]
fn empty_boxes_and_odd_sizes_are_drawn() -> Result<(), Box<dyn std::error::Error>> {
    let packing = Packing::new(&[], &[], [1e-9, 1e9], None)?;
    for picture in [
        PackingPicture::spheres("", &packing),
        PackingPicture::forces("", &packing, &[])?.full_force(f64::NAN, ""),
    ] {
        for headroom in [f64::NAN, f64::INFINITY, -1.0, 1e12] {
            let svg = picture.clone().headroom(headroom).size(130, 130).svg()?;
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{headroom}");
        }
    }
    Ok(())
}
