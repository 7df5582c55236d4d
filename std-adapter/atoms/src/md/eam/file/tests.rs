//! Errors in files are reported at their line.

use super::PotentialFile;
use crate::md::text::TextError;

/// Two elements and six knots a table.
fn setfl() -> Vec<String> {
    let table = |from: i32| -> Vec<String> {
        vec![
            format!("{} {} {}", from, from + 1, from + 2),
            format!("{} {} {}", from + 3, from + 4, from + 5),
        ]
    };
    let head = ["a", "b", "c", "2 Cu Ni", "6 0.5 6 1.0 4.5"];
    let mut lines: Vec<String> = head.map(String::from).into();
    for (element, from) in [("29 63.5 3.6 fcc", 0), ("28 58.7 3.5 fcc", 100)] {
        lines.push(element.into());
        lines.extend(table(from));
        lines.extend(table(from + 10));
    }
    for from in [20, 30, 40] {
        lines.extend(table(from));
    }
    lines
}

fn read(lines: &[String]) -> Result<PotentialFile, TextError> {
    PotentialFile::read(&lines.join("\n"))
}

/// The message after one line is replaced.
fn refused(number: usize, by: &str) -> String {
    let mut lines = setfl();
    lines[number - 1] = by.into();
    read(&lines).unwrap_err().to_string()
}

#[test]
fn tables_go_to_their_elements_and_pairs() {
    let file = read(&setfl()).unwrap();
    let names = ["Ni", "Cu"].map(String::from);
    assert_eq!(file.elements_of(Some(&names), 2), Ok(vec![1, 0]));
    assert_eq!(file.elements_of(None, 2), Ok(vec![0, 1]));
    let message = |names: Option<&[String]>| file.elements_of(names, 3).unwrap_err().to_string();
    assert!(
        message(Some(&["Ag".into()]))
            .contains("no element `Ag` in the potential file, which has Cu, Ni")
    );
    assert!(message(None).contains("no element number 3"));
    assert_eq!(file.elements[1].mass, 58.7);
    assert_eq!(
        [file.embeddings[1][0], file.densities[1][5]],
        [100.0, 115.0]
    );
    let firsts = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[a, b]| file.pair(a, b)[0]);
    assert_eq!(firsts, [20.0, 30.0, 30.0, 40.0]);
}

#[test]
fn a_charge_becomes_a_pair_energy() {
    let text = "Cu\n29 63.5 3.6 fcc\n6 0.5 7 1.0 4.5\n1 2 3 4 5 6\n7 6 5 4 3 2 1\n0 0 0 0 0 0 9";
    let file = PotentialFile::read(text).unwrap();
    assert_eq!(file.pair(0, 0)[1], 27.2 * 0.529 * 6.0 * 6.0);
    assert_eq!([file.embeddings[0].len(), file.densities[0].len()], [5, 6]);
}

#[test]
fn refusals_name_the_line_and_the_cure() {
    assert!(refused(4, "2 Cu").contains("line 4: the line of elements must be 2 names"));
    assert!(refused(4, "2 Cu Cu").contains("second time"));
    assert!(refused(4, "65 Cu").contains("from 1 to 64"));
    assert!(refused(5, "6 0.5 6 1.0").contains("line 5"));
    assert!(refused(5, "6 0.5 4 1.0 4.5").contains("nr must be a whole number from 6"));
    assert!(refused(5, "6 -0.5 6 1.0 4.5").contains("drho must be a number > 0"));
    assert!(refused(6, "29").contains("line 6"));
    assert!(
        refused(8, "3 x 5")
            .contains("line 8: the embedding energy must be a finite number, not `x`")
    );
    assert!(refused(8, "3 4 nan").contains("finite"));
    assert!(refused(8, "3 4 5 6").contains("6 values that end with a line"));
    let mut lines = setfl();
    lines.push("1.0".into());
    assert!(read(&lines).unwrap_err().to_string().contains(".eam.fs"));
    lines.truncate(20);
    let message = read(&lines).unwrap_err().to_string();
    assert!(
        message.contains("line 21: the pair energy is missing; 3 of 6"),
        "{message}"
    );
    assert!(PotentialFile::read("").is_err());
}

#[test]
fn a_file_with_a_density_for_each_pair_is_told_from_one_with_one_for_each_element() {
    let table = "0 0 0 0 0 0\n";
    let head = "comment\n\n\n2 Cu Ni\n6 0.5 6 1.0 4.5\n";
    let element = |number: u8, densities: usize| {
        format!("{number} 60 3.6 fcc\n{table}{}", table.repeat(densities))
    };
    let file = |densities: usize| {
        let elements = element(29, densities) + &element(28, densities);
        PotentialFile::read(&format!("{head}{elements}{}", table.repeat(3)))
    };
    assert!(file(1).is_ok());
    let refused = file(2).map_or_else(|error| error.to_string(), |_| "read".into());
    assert!(refused.contains("*.eam.fs"), "{refused}");
    assert!(refused.contains("give setfl"), "{refused}");
}
