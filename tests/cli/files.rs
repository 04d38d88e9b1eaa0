//! Output files: whole or not there.

use std::fs;
use std::path::Path;

use tempfile::tempdir;

use crate::builder::{bifdiag, plain};

fn names(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn the_main_job_writes_an_atlas_and_a_diagram() {
    let place = tempdir().unwrap();
    let done = bifdiag("--A 2,1.1,1 --r 0.94868,0,0.61623").inside(place.path()).succeeds().telling_nothing();
    done.printing("A = (2, 1.1, 1)").printing("written: bifdiag-out/atlas.json").printing("bifdiag-out/diagram.svg");
    let [atlas, tex, text, diagram] = ["atlas.json", "diagram.caption.tex", "diagram.caption.txt", "diagram.svg"];
    assert_eq!(names(&place.path().join("bifdiag-out")), [atlas, tex, text, diagram]);
}

#[test]
fn what_leaves_a_diagram_is_in_its_caption() {
    let place = tempdir().unwrap();
    let read = |name: &str| fs::read_to_string(place.path().join(name)).unwrap();
    bifdiag("--body paper --out below --legend below --table").inside(place.path()).succeeds();
    bifdiag("--body paper --out file --legend file --title none --format svg,tikz").inside(place.path()).succeeds();
    bifdiag("--body paper --out none --legend none --title Ours").inside(place.path()).succeeds();
    for entry in ["dashed: unstable", "pitchfork"] {
        assert!(read("below/diagram.svg").contains(entry), "{entry}");
        for leaving in ["file", "none"] {
            assert!(!read(&format!("{leaving}/diagram.svg")).contains(&format!(">{entry}<")), "{entry}");
            assert!(read(&format!("{leaving}/diagram.caption.txt")).contains(entry), "{entry}");
        }
    }
    assert!(read("file/diagram.caption.txt").contains("pole −r̂ enters U"));
    assert!(read("file/diagram.legend.svg").contains("dashed: unstable"));
    assert!(read("file/diagram.legend.tikz").contains("dashed: unstable"));
    assert!(!place.path().join("none/diagram.legend.svg").exists());
    // Each row of the table, in the picture or in the caption.
    let heading = "small motions 2 % inside";
    assert!(read("below/diagram.svg").contains(heading) && !read("below/diagram.caption.txt").contains(heading));
    assert!(!read("file/diagram.svg").contains(heading) && read("file/diagram.caption.txt").contains(heading));
    let count = |text: &str| text.matches("between axis 3 and axis 1 ").count();
    assert_eq!(count(&read("file/diagram.caption.txt")), 3);
    assert!(read("file/diagram.caption.tex").contains("\\end{tabular}"));
    assert!(
        !read("file/diagram.svg").contains("</tspan> = (2, 1.1, 1), ") && read("none/diagram.svg").contains("\">Ours<")
    );
    bifdiag("--body paper --out file --legend below").inside(place.path()).succeeds();
    assert!(!place.path().join("file/diagram.legend.svg").exists(), "of an earlier run");
}

/// The largest h of the picture lies between those of a curve half a last digit below and above the l that is printed.
#[test]
fn a_stretch_in_the_caption_ends_where_the_curve_leaves_the_picture() {
    let place = tempdir().unwrap();
    bifdiag("--body paper --out here").inside(place.path()).succeeds();
    let read = |name: &str| fs::read_to_string(place.path().join(name)).unwrap();
    let atlas: serde_json::Value = serde_json::from_str(&read("here/atlas.json")).unwrap();
    let largest = atlas["drawing"]["view"]["everything"]["h"][1].as_f64().unwrap();
    let caption = read("here/diagram.caption.txt");
    for id in ["G0.1", "G1.1", "S2.1"] {
        let row = caption.lines().rfind(|line| line.starts_with(&format!("{id}, "))).unwrap();
        let end: f64 = row.split(" … ").nth(1).unwrap().split_whitespace().next().unwrap().parse().unwrap();
        let h = |l: f64| {
            let json = bifdiag(&format!("critical --body paper --l {l} --json")).succeeds().json();
            let points = json["critical"].as_array().unwrap().clone();
            points.iter().find(|point| point["branch"] == id).unwrap()["h"].as_f64().unwrap()
        };
        assert!(h(end - 5.001e-4) <= largest && largest <= h(end + 5.001e-4), "{row}");
    }
}

/// A straightened diagram shows all energies: its curves end at the largest l.
#[test]
fn a_stretch_of_a_straightened_diagram_ends_at_its_edge() {
    let place = tempdir().unwrap();
    bifdiag("--A 3,5,8 --r 0,1,0.5 --view straight --out here").inside(place.path()).succeeds();
    let caption = fs::read_to_string(place.path().join("here/diagram.caption.txt")).unwrap();
    let ends: Vec<&str> = ["S1.2, ", "G0.2, ", "G1.1, "]
        .into_iter()
        .map(|id| caption.lines().rfind(|line| line.starts_with(id)).unwrap())
        .map(|row| row.split(" … ").nth(1).unwrap().split_whitespace().next().unwrap())
        .collect();
    assert_eq!(ends, ["17.55"; 3], "{caption}");
}

#[test]
fn pictures_are_as_wide_and_as_fine_as_is_asked() {
    let place = tempdir().unwrap();
    let read = |name: &str| fs::read(place.path().join(name)).unwrap();
    for (asked, reply) in [("246pt", "86.46"), ("8.6cm", "86"), ("4in", "101.6"), ("178mm", "178"), (" 200 mm", "200")]
    {
        bifdiag("--body paper --out w").and("--width").and(asked).inside(place.path()).succeeds();
        let svg = String::from_utf8(read("w/diagram.svg")).unwrap();
        assert!(svg.contains(&format!(" width=\"{reply}mm\"")), "{asked}: {}", svg.lines().next().unwrap());
    }
    bifdiag("sphere --body paper --region R5 --width 120mm --format png --dpi 600 --out s")
        .inside(place.path())
        .succeeds();
    let png = read("s/sphere.png");
    let at = png.windows(4).position(|bytes| bytes == b"pHYs").unwrap() + 4;
    assert_eq!(png[at..at + 4], 23_622_u32.to_be_bytes(), "600 dots in an inch");
    bifdiag("--body paper --format tikz --out t").inside(place.path()).succeeds();
    let tikz = String::from_utf8(read("t/diagram.tikz")).unwrap();
    assert!(!tikz.contains("\\documentclass") && tikz.trim_end().ends_with("\\endgroup%"));
    bifdiag("--body paper --format tikz --standalone --out t").inside(place.path()).succeeds();
    let document = String::from_utf8(read("t/diagram.tikz")).unwrap();
    assert!(document.starts_with("\\documentclass") && document.contains(&tikz));
}

#[test]
fn the_default_command_is_atlas() {
    let place = tempdir().unwrap();
    let long = bifdiag("atlas --body paper --no-plot --out a").inside(place.path()).succeeds().stdout();
    let short = bifdiag("--body paper --no-plot --out a").inside(place.path()).succeeds().stdout();
    assert_eq!(long, short);
    assert_eq!(names(&place.path().join("a")), ["atlas.json"]);
}

#[test]
fn json_goes_to_stdout_and_to_files_only_if_asked() {
    let place = tempdir().unwrap();
    let done = bifdiag("--body paper --json").inside(place.path()).succeeds();
    assert_eq!(done.json()["schema_version"], "3");
    assert!(names(place.path()).is_empty());
    let both = bifdiag("--body paper --json --out x/y --format svg,png").inside(place.path()).succeeds();
    assert_eq!(both.stdout(), done.stdout());
    assert_eq!(fs::read_to_string(place.path().join("x/y/atlas.json")).unwrap(), done.stdout());
    assert_eq!(
        names(&place.path().join("x/y")),
        ["atlas.json", "diagram.caption.tex", "diagram.caption.txt", "diagram.png", "diagram.svg"]
    );
}

#[test]
fn a_sphere_of_a_point_and_of_a_region() {
    let place = tempdir().unwrap();
    let point = bifdiag("sphere --body paper --h 4.45 --l 3.25 --format svg,png").inside(place.path()).succeeds();
    point.printing("h = 4.45, l = 3.25").printing("written: bifdiag-out/sphere.svg");
    assert_eq!(names(&place.path().join("bifdiag-out")), ["sphere.png", "sphere.svg"]);
    let svg = plain(&fs::read_to_string(place.path().join("bifdiag-out/sphere.svg")).unwrap());
    assert!(svg.contains("2: 1 boundary circle, pole −r̂;  E = S³, P = T² (genus 1)"));
    bifdiag("sphere --body paper --region R1 --out a").inside(place.path()).succeeds().printing("region R1");
}

#[test]
fn a_sphere_without_a_point_or_without_u_is_refused() {
    for (line, reply) in [
        ("sphere --body paper --h 1", "--l is missing"),
        ("sphere --body paper --region R77", "--region R77: the atlas of this body has the regions R1, "),
        ("sphere --body paper --h=-9 --l 1", "(h, l) = (-9, 1) is forbidden: the lowest energy at l = 1 is -0.846338"),
    ] {
        bifdiag(line).refused().telling(reply);
    }
}

#[cfg(feature = "pdf")]
#[test]
fn pdf_is_written_beside_the_other_formats() {
    let place = tempdir().unwrap();
    bifdiag("--body paper --out . --format svg,pdf").inside(place.path()).succeeds();
    assert_eq!(
        names(place.path()),
        ["atlas.json", "diagram.caption.tex", "diagram.caption.txt", "diagram.pdf", "diagram.svg"]
    );
    assert!(fs::read(place.path().join("diagram.pdf")).unwrap().starts_with(b"%PDF-"));
}

#[cfg(not(feature = "pdf"))]
#[test]
fn pdf_is_refused_before_any_work_and_the_feature_is_named() {
    let place = tempdir().unwrap();
    for line in [
        "--body paper --format svg,pdf",
        "sphere --body paper --region R1 --format pdf",
        "scan map none.csv --x A2 --y A3 --format pdf",
    ] {
        bifdiag(line)
            .inside(place.path())
            .refused()
            .telling("'pdf' for '--format <FORMAT>': PDF needs the feature `pdf`");
    }
    assert!(names(place.path()).is_empty());
}

#[test]
fn a_directory_that_cannot_be_made_is_named_with_the_reason() {
    let place = tempdir().unwrap();
    fs::write(place.path().join("file"), "mine").unwrap();
    for out in ["file", "file/below", "file/far/below"] {
        let done = bifdiag("--body paper --out").and(out).inside(place.path()).fails().printing_nothing();
        done.telling(&format!("error: cannot create the directory {out}: "))
            .telling("os error")
            .telling("another place");
    }
    assert_eq!(fs::read_to_string(place.path().join("file")).unwrap(), "mine");
    assert_eq!(names(place.path()), ["file"]);
}

#[test]
#[cfg(unix)]
fn a_read_only_directory_is_named_with_the_reason() {
    use std::os::unix::fs::PermissionsExt;
    let place = tempdir().unwrap();
    let locked = place.path().join("locked");
    fs::create_dir(&locked).unwrap();
    fs::set_permissions(&locked, fs::Permissions::from_mode(0o555)).unwrap();
    let allowed_all_the_same = fs::write(locked.join("probe"), "").is_ok();
    let run = bifdiag("--body paper --out").and(&locked);
    if allowed_all_the_same {
        // The superuser writes everywhere; then the run must succeed.
        fs::remove_file(locked.join("probe")).unwrap();
        run.succeeds();
    } else {
        run.fails().telling("cannot write").telling("atlas.json").telling("Permission denied");
        assert!(names(&locked).is_empty());
    }
}

#[test]
fn a_directory_in_the_way_of_a_file_changes_nothing() {
    let place = tempdir().unwrap();
    let out = place.path().join("out");
    fs::create_dir_all(out.join("diagram.svg")).unwrap();
    fs::write(out.join("atlas.json"), "old").unwrap();
    bifdiag("--body paper --out").and(&out).fails().telling("diagram.svg: a directory of this name is in the way");
    assert_eq!(fs::read_to_string(out.join("atlas.json")).unwrap(), "old");
    assert_eq!(names(&out), ["atlas.json", "diagram.svg"]);
}

/// The size of a file is limited as a full disk would limit it: the write stops in the middle.
#[test]
#[cfg(target_os = "linux")]
fn a_disk_that_fills_up_in_the_middle_leaves_the_old_files() {
    use std::process::Command;

    use crate::builder::PROGRAM;

    let place = tempdir().unwrap();
    let (old, new) = (place.path().join("old"), place.path().join("new/deep"));
    fs::create_dir(&old).unwrap();
    fs::write(old.join("atlas.json"), "old").unwrap();
    for out in [&old, &new] {
        let limited = format!("ulimit -f 1; exec '{PROGRAM}' --body paper --out '{}'", out.display());
        let output = Command::new("sh").args(["-c", &limited]).output().unwrap();
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{stderr}");
        assert!(stderr.contains("cannot write") && stderr.contains("File too large"), "{stderr}");
        assert!(output.stdout.is_empty());
    }
    assert_eq!(names(&old), ["atlas.json"]);
    assert_eq!(fs::read_to_string(old.join("atlas.json")).unwrap(), "old");
    assert_eq!(names(place.path()), ["old"], "directories made on the way are taken away again");
}

#[test]
#[cfg(unix)]
fn files_can_be_read_by_whom_the_umask_lets() {
    use std::os::unix::fs::PermissionsExt;
    let place = tempdir().unwrap();
    fs::write(place.path().join("ordinary"), "").unwrap();
    bifdiag("--body paper --out").and(place.path()).succeeds();
    let mode = |name: &str| fs::metadata(place.path().join(name)).unwrap().permissions().mode();
    assert_eq!(mode("atlas.json"), mode("ordinary"));
}
