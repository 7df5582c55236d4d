//! Logs of every dialect, and what is refused.

use super::*;

type Columns = Vec<(&'static str, Vec<f64>)>;

/// The roles of a fit.
const ROLES: [LogRole; 6] = [
    LogRole::TIME,
    LogRole::VELOCITY.needed(),
    LogRole::FRICTION.needed(),
    LogRole::DEVIATION,
    LogRole::LOAD,
    LogRole::POSITION,
];

fn options(columns: &str, units: &str, skip: u64) -> Result<LogOptions, LogOptionError> {
    let mut options = LogOptions {
        skip,
        ..LogOptions::default()
    };
    if !columns.is_empty() {
        options.columns = columns.parse()?;
    }
    if !units.is_empty() {
        options.units = units.parse()?;
    }
    Ok(options)
}

fn log_of(bytes: &[u8], options: &LogOptions) -> Result<Log, String> {
    read_log_from(Path::new("a.csv"), bytes, &ROLES, options).map_err(|refusal| refusal.to_string())
}

fn log(text: &str) -> Result<Log, String> {
    log_of(text.as_bytes(), &LogOptions::default())
}

fn chosen(text: &str, columns: &str, units: &str, skip: u64) -> Result<Log, String> {
    let options = options(columns, units, skip).map_err(|error| error.to_string())?;
    log_of(text.as_bytes(), &options)
}

/// The columns of a log, rounded to 12 digits: factors of units are not exact.
fn columns(log: Result<Log, String>) -> Result<Columns, String> {
    let round = |x: f64| format!("{x:.11e}").parse().unwrap_or(f64::NAN);
    let rounded =
        |(name, column): (&'static str, Vec<f64>)| (name, column.into_iter().map(round).collect());
    Ok(log?.columns.into_iter().map(rounded).collect())
}

/// Three rows of a record: s, m/s, N.
fn record() -> Result<Columns, String> {
    Ok(vec![
        ("t", vec![0.0, 0.5, 1.0]),
        ("v", vec![0.001, 0.0015, -0.002]),
        ("f", vec![2.5, 1.25, -1234.5]),
    ])
}

#[test]
fn a_table_as_it_was_always_read_has_no_remarks() {
    for text in [
        "t,v,f\n0,0.001,2.5\n0.5,0.0015,1.25\n1,-0.002,-1234.5\n",
        "f,t,v\n2.5,0,1e-3\n1.25,0.5,1.5e-3\n-1234.5,1,-2e-3",
    ] {
        let mut made = log(text);
        assert_eq!(
            made.as_ref()
                .map(|log| (log.brief.len(), log.dropped.len())),
            Ok((0, 0))
        );
        assert_eq!(
            made.as_ref().map(|log| log.lines.clone()),
            Ok(vec![2, 3, 4])
        );
        if let Ok(log) = &mut made {
            log.columns
                .sort_by_key(|(name, _)| ["t", "v", "f"].iter().position(|known| known == name));
        }
        assert_eq!(columns(made), record());
    }
}

#[test]
fn one_record_in_many_dialects_is_one_record() {
    for text in [
        // Semicolons, decimal commas, points between thousands.
        "Time [s];Speed [mm/s];Force [N]\n0;1,0;2,5\n0,5;1,5;1,25\n1;-2,0;-1.234,5\n",
        // The same with a declared mark, which spreadsheets write.
        "sep=;\nZeit;Geschwindigkeit (mm/s);Reibkraft (N)\n0;1;2,5\n0,5;1,5;1,25\n1;-2;-1234,5\n",
        // Tabs, commas between thousands.
        "Time/s\tv / mm/s\tF/N\n0\t1\t2.5\n0.5\t1.5\t1.25\n1\t-2\t-1,234.5\n",
        // Tabs and decimal commas.
        "t\tv\tf\n0,0\t0,001\t2,5\n0,5\t0,0015\t1,25\n1,0\t-0,002\t-1234,5\n",
        // Commas around numbers with decimal commas in quotation marks.
        "\"Time\",\"v [mm/s]\",\"f\"\n\"0,0\",\"1,0\",\"2,5\"\n\"0,5\",\"1,5\",\"1,25\"\n\"1,0\",\"-2,0\",\"-1234,5\"\n",
        // Fixed blanks, names with units behind one blank.
        "  Time (s)   Speed (mm/s)   Force (N)\n   0.0    1.0     2.5\n   0.5   1.5     1.25\n   1.0   -2.0  -1234.5\n",
        // A header between commas over numbers between blanks.
        "t, v, f\n0 0.001 2.5\n0.5 0.0015 1.25\n1 -0.002 -1234.5\n",
        // Strokes.
        "t|v|f\n0|0.001|2.5\n0.5|0.0015|1.25\n1|-0.002|-1234.5\n",
        // Units in a line of their own, with and without brackets, and lines before the header.
        "Rig 7, run 3\nLoad;12\n\nZeit;Geschw.;v;Kraft\ns;rpm;mm/s;N\n0;5;1;2,5\n0,5;5;1,5;1,25\n1;5;-2;-1234,5\n",
        "Test of steel\nOperator,Fritz\nTime,Speed,Friction force\n[s],[mm/s],[N]\n0,1,2.5\n0.5,1.5,1.25\n1,-2,-1234.5\n",
        // A unit that is spelled as a name.
        "Channel,t,Speed,Force\nUnit,s,mm/s,N\nV,0,1,2.5\nV,0.5,1.5,1.25\nV,1,-2,-1234.5\n",
        // Units at the ends of names, in kN and ms.
        "time_ms,sliding_speed_mm_s,force_kN\n0,1,0.0025\n500,1.5,0.00125\n1000,-2,-1.2345\n",
        // Names in a comment, as numpy and gnuplot write them.
        "# t v f\n0 0.001 2.5\n0.5 0.0015 1.25\n1 -0.002 -1234.5\n",
        "# made by a rig\n# Time [s], Speed [mm/s], Force [N]\n0,1,2.5\n0.5,1.5,1.25\n1,-2,-1234.5\n",
        "% t v f\n0 0.001 2.5\n0.5 0.0015 1.25\n1 -0.002 -1234.5\n",
        // Other columns, of words and of dates, and a mark at the end of each line.
        "Date;Time [s];State;Speed [mm/s];Friction [N];Temp [°C];\n2024-01-05;0;on;1,0;2,5;20;\n2024-01-05;0,5;on;1,5;1,25;21;\n2024-01-05;1;off;-2,0;-1234,5;;\n",
        // A typesetter's minus and the exponents of Fortran.
        "t,v,f\n0,1D-3,2.5\n0.5,1.5D-3,1.25\n1,\u{2212}2D-3,\u{2212}1234.5\n",
    ] {
        assert_eq!(columns(log(text)), record(), "{text}");
    }
}

#[test]
fn one_record_in_many_encodings_is_one_record() -> std::io::Result<()> {
    use std::io::Write;
    let text =
        "Zeit;Drehmoment µ;v [mm/s];f\r\n0;1;1,0;2,5\r\n0,5;1;1,5;1,25\r\n1;1;-2,0;-1234,5\r\n";
    let wide = |order: fn(u16) -> [u8; 2]| -> Vec<u8> {
        let units = [0xfeff].into_iter().chain(text.encode_utf16());
        units.flat_map(order).collect()
    };
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    packer.write_all(text.as_bytes())?;
    let returns = text.replace("\r\n", "\r");
    let letters: Vec<u8> = text
        .chars()
        .map(|letter| u8::try_from(letter).unwrap_or(b'?'))
        .collect();
    for (bytes, word) in [
        (
            text.as_bytes().to_vec(),
            "semicolons, decimal commas, t from \"Zeit\", v from \"v [mm/s]\" in mm/s",
        ),
        (format!("\u{feff}{text}").into_bytes(), "semicolons"),
        (returns.into_bytes(), "semicolons"),
        (letters, "Latin-1, semicolons"),
        (wide(u16::to_le_bytes), "UTF-16, semicolons"),
        (wide(u16::to_be_bytes), "UTF-16, semicolons"),
        (packer.finish()?, "gzip, semicolons"),
    ] {
        let made = log_of(&bytes, &LogOptions::default());
        let told = made
            .as_ref()
            .map(|log| log.brief.concat())
            .unwrap_or_default();
        assert!(told.starts_with(word), "{told}");
        assert_eq!(columns(made), record());
    }
    Ok(())
}

#[test]
fn columns_and_units_are_as_the_options_say() {
    let text = "Motor;Speed;F;G\n0;1;5;-2,5\n0,5;1,5;5;-1,25\n1;-2;5;1234,5\n";
    assert_eq!(
        columns(chosen(text, "t=Motor,v=2,f=-G,x=none", "v=mm/s", 0)),
        record()
    );
    // No header: numbers of columns.
    let bare = "0 9 1 2500\n0.5 9 1.5 1250\n1 9 -2 -1234500\n";
    assert_eq!(
        columns(chosen(bare, "t=1,v=3,f=4", "v=mm/s,f=mN", 0)),
        record()
    );
    // Lines with numbers before the header.
    let long = "1,2,3\n4,5,6\nt,v,f\n0,0.001,2.5\n0.5,0.0015,1.25\n1,-0.002,-1234.5\n";
    assert_eq!(columns(chosen(long, "", "", 2)), record());
    let made = chosen(text, "v=Speed,f=-G", "f=gf", 0);
    let told = made.map(|log| log.brief.concat());
    assert_eq!(
        told,
        Ok("semicolons, decimal commas, v from \"Speed\", f from -\"G\" in gf".into())
    );
}

#[test]
fn units_of_headers_become_si() {
    for (header, v, f) in [
        ("v [m/min],f", 0.05, 2.0),
        (
            "Drehzahl [1/min],Drehmoment [Nmm]",
            0.314_159_265_359,
            0.002,
        ),
        ("speed (RPM),cof (%)", 0.314_159_265_359, 0.02),
        ("ω [°/s],Torque [N·m]", 0.052_359_877_559_8, 2.0),
        ("Velocity [µm/s],Friction [uN]", 3e-6, 2e-6),
        ("Velocity [in/s],Friction [lbf]", 0.0762, 8.896_443_230_52),
        ("qd,tau", 3.0, 2.0),
        ("v,Motor current [A]", 3.0, 2.0),
        // A unit that is not known changes nothing.
        ("v [furlong/h],µ", 3.0, 2.0),
    ] {
        let made = columns(log(&format!("{header}\n3,2\n3,2\n")));
        assert_eq!(
            made,
            Ok(vec![("v", vec![v; 2]), ("f", vec![f; 2])]),
            "{header}"
        );
    }
    let told = log("v [furlong/h],Motor current [A]\n3,2\n").map(|log| log.brief.concat());
    let told = told.unwrap_or_default();
    assert!(
        told.contains("the unit `furlong/h` of v is not known"),
        "{told}"
    );
    assert!(told.contains("f is taken as it is, in A"), "{told}");
}

#[test]
fn what_was_understood_names_columns_and_sizes_of_units() {
    let made = log("t;v [mm/s];M [A];F [N];COF\n0;1;2;3;4\n").map(|log| log.understood);
    let wanted = [
        "a.csv",
        "semicolons between cells, decimal points",
        "header in line 1",
        "t is `t`, taken as s",
        "v is `v [mm/s]` in mm/s, of 0.001 m/s each",
        "f is `COF`",
    ];
    assert_eq!(made, Ok(wanted.map(String::from).to_vec()));
}

#[test]
fn names_of_other_quantities_are_not_taken() {
    // A temperature is no time, a normal force no friction, and its own name comes before a usual one.
    let made = columns(log("T [°C],v,speed,F_N,f_N\n20,3,4,10,2\n"));
    assert_eq!(
        made,
        Ok(vec![
            ("v", vec![3.0]),
            ("f", vec![2.0]),
            ("load", vec![10.0])
        ])
    );
    // Words for friction come before a force.
    let made = columns(log("Speed,Force,COF\n3,10,2\n"));
    assert_eq!(made, Ok(vec![("v", vec![3.0]), ("f", vec![2.0])]));
    // What is not needed is left out where it is not clear.
    let made = log("v,f,Normal force,Last\n3,2,10,10\n");
    let told = made
        .as_ref()
        .map(|log| log.brief.concat())
        .unwrap_or_default();
    assert!(
        told.contains("load is not read: `Normal force` and `Last` may both be load"),
        "{told}"
    );
    assert_eq!(made.map(|log| log.columns.len()), Ok(2));
}

#[test]
fn rows_without_a_number_and_times_that_do_not_rise_are_dropped_and_counted() {
    let text = "t,v,f,note\n0,1,1,\n1,,1,\n2,NaN,1,\n2,#N/A,1,\n3,1,1,x\n3,1,2,\n3.5,1,1,\nt,v,f,note\n2,1,1,\n4,1\n5,inf,1,\n6,1,1,\n7,1,1,\n8,1,1,\n9,1,1,\n10,1,1,\n11,1,1,\n";
    let made = log(text);
    let told = made.as_ref().map(|log| log.brief.clone());
    let wanted = "8 rows dropped: 1 with an empty cell, 3 with NaN, 1 too short, 1 with a repeated time, \
                  1 with a time that goes back, 1 that repeat the header";
    assert_eq!(told, Ok(vec![wanted.to_owned()]));
    let made = made.map(|mut log| (log.lines.clone(), log.take("t")));
    let lines = vec![2, 6, 8, 13, 14, 15, 16, 17, 18];
    let times = vec![0.0, 3.0, 3.5, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0];
    assert_eq!(made, Ok((lines, Some(times))));
}

#[test]
fn a_velocity_is_made_from_a_position() {
    let made = log("Time [s]\tPosition [mm]\tFriction\n0\t0\t1\n1\t1\t1\n2\t4\t1\n3\t9\t1\n");
    let told = made
        .as_ref()
        .map(|log| log.brief.concat())
        .unwrap_or_default();
    assert!(
        told.ends_with("v by differences of \"Position [mm]\""),
        "{told}"
    );
    let made = columns(made).map(|columns| columns.into_iter().find(|(name, _)| *name == "v"));
    assert_eq!(made, Ok(Some(("v", vec![0.001, 0.002, 0.004, 0.005]))));
    // Where there is a velocity, gaps of a position cost no rows.
    let made = columns(log("x,v,f\n,1,2\n,3,4\n"));
    assert_eq!(made, Ok(vec![("v", vec![1.0, 3.0]), ("f", vec![2.0, 4.0])]));
    // An acceleration is made where it is wanted.
    let roles = [
        LogRole::TIME,
        LogRole::VELOCITY.needed(),
        LogRole::ACCELERATION.needed(),
    ];
    let made = read_log_from(
        Path::new("a"),
        &b"t,v\n0,1\n1,2\n2,5\n"[..],
        &roles,
        &LogOptions::default(),
    );
    assert_eq!(
        made.ok().and_then(|mut log| log.take("a")),
        Some(vec![1.0, 2.0, 3.0])
    );
}

#[test]
fn refusals_say_what_and_where_and_what_cures() {
    for (text, columns, units, wanted) in [
        (
            "",
            "",
            "",
            &[
                "a.csv:1: no column for v",
                "a single cell",
                "semicolons, tabs or blanks",
            ][..],
        ),
        ("v,f\n", "", "", &["a.csv:2: no rows of numbers"]),
        (
            "speed\n1\n2\n",
            "",
            "",
            &["a.csv:1: no column for f (friction [-])", "single cell"],
        ),
        (
            "1,2\n3,4\n",
            "",
            "",
            &["a.csv:1: no header line", "--columns v=2", "2 columns"],
        ),
        (
            "Versuch;Wert\n1;2\n",
            "",
            "",
            &[
                "a.csv:1: no column for v (sliding velocity [m/s])",
                "1 `Versuch`, 2 `Wert`",
                "--columns v=\"…\"",
            ],
        ),
        (
            "Speed 1;Sliding speed;Speed;f\n1;1;1;1\n",
            "",
            "",
            &[
                "a.csv:1: `Sliding speed` and `Speed` may both be v",
                "--columns v=\"Sliding speed\"",
            ],
        ),
        (
            "v,f,f\n1,1,2\n",
            "",
            "",
            &[
                "a.csv:1: columns 2 and 3 are both named `f`",
                "--columns f=2",
            ],
        ),
        (
            "v,f\n1,abc\n",
            "",
            "",
            &[
                "a.csv:2: f is `abc`; give a number such as 0.5",
                "empty or NaN",
                "--skip N",
            ],
        ),
        (
            "Speed,f\n1,2\n1,2\n12 mm,3\n",
            "",
            "",
            &["a.csv:4: v (`Speed`) is `12 mm`", "numbers carry no units"],
        ),
        (
            "v;f\n1,5;2\n1.5;2\n",
            "",
            "",
            &["a.csv:3: v is `1.5`", "decimal commas"],
        ),
        (
            "v,f\n1,5,2,5\n",
            "",
            "",
            &[
                "a.csv:2: 4 cells between commas instead of 2",
                "decimal commas",
                "semicolons",
            ],
        ),
        (
            "v,f\n1,2\n",
            "v=Sped",
            "",
            &[
                "a.csv:1: --columns v: there is no column `Sped`",
                "1 `v`, 2 `f`",
            ],
        ),
        ("v,f\nabc,1\n2,3\n4,5\n", "", "", &["a.csv:2: v is `abc`"]),
        ("Speed,f\n1,2\n", "v=Sped", "", &["did you mean `Speed`?"]),
        (
            "v,f\n1,2\n",
            "v=3",
            "",
            &["a.csv:1: --columns v: there is no column `3`"],
        ),
        (
            "v,f\n1,2\n",
            "v=0",
            "",
            &["a.csv:1: --columns v: there is no column `0`"],
        ),
        (
            "v,f\n1,2\n",
            "w=1",
            "",
            &["a.csv:1: --columns: `w` is none of t (time), v (sliding velocity)"],
        ),
        (
            "v,f\n1,2\n",
            "v=1,f=1",
            "",
            &["`v` is read for v and for f"],
        ),
        ("v,f\n1,2\n", "f=none", "", &["a.csv:1: no column for f"]),
        (
            "v,f\n1,2\n",
            "",
            "v=knots",
            &[
                "a.csv:1: --units v: the unit `knots` is not known",
                "m/s, cm/s, mm/s",
                "rpm",
            ],
        ),
        (
            "v,f\n1,2\n",
            "",
            "v=N",
            &["--units v: the unit `N` is not known; known are"],
        ),
        (
            "v,f\n1,2\n",
            "",
            "load=N",
            &["--units load=N: no column is read for load"],
        ),
        (
            "v [N],f\n1,2\n",
            "v=1",
            "",
            &["a.csv:1: `v [N]` is in N, a force, but v is sliding velocity [m/s]"],
        ),
        (
            "t,v,f\n0,1,1\n0,1,1\n0,1,1\n",
            "",
            "",
            &[
                "a.csv: 2 of 3 rows cannot be used: 2 with a repeated time",
                "too few digits",
                "--columns t=",
            ],
        ),
        (
            "t,v,f\n5,1,1\n1,1,1\n2,1,1\n",
            "",
            "",
            &["2 with a time that goes back", "several records"],
        ),
        (
            "v,f,sigma\n1,1,\n1,1,\n1,1,1\n",
            "",
            "",
            &[
                "2 with an empty cell",
                "most of them for sigma (`sigma`)",
                "--columns NAME=none",
            ],
        ),
        ("v,f\nv,f\n", "", "", &["a.csv:3: no rows of numbers"]),
    ] {
        let refused = chosen(text, columns, units, 0)
            .map(|log| log.columns)
            .map_err(|told| {
                let all: Vec<_> = wanted
                    .iter()
                    .filter(|word| !told.contains(**word))
                    .collect();
                assert!(all.is_empty(), "{text:?}: {told}\nmisses {all:?}");
            });
        assert_eq!(refused, Err(()), "{text:?}");
    }
}

#[test]
fn columns_in_memory_go_the_same_way() {
    let data = [
        ("Time [ms]".to_owned(), vec![0.0, 500.0, 500.0, 1000.0]),
        ("Speed".to_owned(), vec![1.0, f64::NAN, 2.0, 3.0]),
        ("COF".to_owned(), vec![0.1, 0.2, 0.3, 0.4]),
    ];
    let made = log_of_columns("frame", &data, &ROLES, &LogOptions::default())
        .map_err(|error| error.to_string());
    let told = made.as_ref().map(|log| log.brief.clone());
    let wanted = [
        "t from \"Time [ms]\" in ms, v from \"Speed\", f from \"COF\"",
        "1 row dropped: 1 with NaN",
    ];
    assert_eq!(told, Ok(wanted.map(String::from).to_vec()));
    let wanted = vec![
        ("t", vec![0.0, 0.5, 1.0]),
        ("v", vec![1.0, 2.0, 3.0]),
        ("f", vec![0.1, 0.3, 0.4]),
    ];
    assert_eq!(columns(made), Ok(wanted));
}

#[test]
fn a_look_tells_columns_ranges_and_trouble() {
    let text = "Rig 7\nTime [s];Speed [mm/s];Speed B;COF;State\n0;1,5;1;0,1;on\n1;;2;0,2;off\n";
    let seen = look_from(
        Path::new("a.csv"),
        text.as_bytes(),
        &ROLES,
        &LogOptions::default(),
    );
    let told = seen
        .as_ref()
        .map(LogPreview::text)
        .map_err(|error| error.to_string());
    let wanted = "file          a.csv\n\
        \x20             semicolons between cells, decimal commas\n\
        \x20             header in line 2, 1 before it left out\n\
        rows          2\n\
        \n\
        \x20 column  name          role  unit  numbers  smallest  largest  others\n\
        \x20 1       Time [s]      t     s     2        0         1\n\
        \x20 2       Speed [mm/s]  v     mm/s  1        1.5       1.5      1 missing\n\
        \x20 3       Speed B                   2        1         2\n\
        \x20 4       COF           f           2        0.1       0.2\n\
        \x20 5       State                     0                           2 words\n\
        \n\
        first rows\n\
        \x20 0  1,5  1  0,1  on\n\
        \x20 1       2  0,2  off\n";
    assert_eq!(told, Ok(wanted.to_owned()));
    let json = seen.map(|look| look.json());
    let column = json.map(|json| json["columns"][1].to_string());
    let wanted = r#"{"name":"Speed [mm/s]","role":"v","unit":"mm/s","numbers":1,"missing":1,"words":0,"min":1.5,"max":1.5}"#;
    assert_eq!(column, Ok(wanted.to_owned()));
    let seen = look_from(
        Path::new("a.csv"),
        &b"1;2\n3;4\n"[..],
        &ROLES,
        &LogOptions::default(),
    );
    let trouble = seen.ok().and_then(|look| look.trouble).unwrap_or_default();
    assert!(trouble.starts_with("no header line"), "{trouble}");
}

#[test]
fn a_header_among_the_lines_that_are_left_out_still_names_the_columns() -> Result<(), String> {
    let rows: String = (1..200).map(|k| format!("{k};{};0,3\n", 10 * k)).collect();
    let text = format!("Versuch 7\nZeit [s];Geschwindigkeit [mm/s];Reibwert\n{rows}");
    let log = chosen(&text, "", "", 102)?;
    assert_eq!(log.column("t").map(|t| (t[0], t.len())), Some((101.0, 99)));
    assert_eq!(log.column("v").map(|v| v[0]), Some(1.01));
    Ok(())
}
