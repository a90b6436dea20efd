//! Which files an `include` may read.

use mapd_xodr::source::{IncludeRefusal, Inputs, Places, SourceLimits};
use std::fs;
use std::io::Read as _;
use std::path::Path;
use tempfile::TempDir;

/// A folder `base` with a main file, others within and outside of it.
fn folder() -> TempDir {
    let folder = TempDir::new().expect("a folder");
    let root = folder.path();
    for (path, text) in [
        ("base/main.xodr", "<OpenDRIVE/>"),
        ("base/roads.xodr", "<OpenDRIVE>\n</OpenDRIVE>"),
        ("base/sub/deep.xodr", "deep"),
        ("base/sub/beside.xodr", "beside"),
        ("outside.xodr", "secret"),
        ("base2/near.xodr", "secret"),
    ] {
        let path = root.join(path);
        fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    #[cfg(unix)]
    std::os::unix::fs::symlink(root.join("outside.xodr"), root.join("base/link.xodr"))
        .expect("a link");
    folder
}

fn inputs(folder: &Path, limits: SourceLimits) -> Inputs {
    let mut inputs = Inputs::new(limits);
    inputs.open_file(&folder.join("base/main.xodr")).expect("the main file");
    inputs
}

/// Follows references one within the other; the text of the last, or why one is refused.
fn follow(inputs: &mut Inputs, references: &[&str]) -> Result<String, IncludeRefusal> {
    let mut text = String::new();
    for reference in references {
        let mut source = inputs.include(reference, 7)?;
        text.clear();
        source.read_to_string(&mut text).expect("the file can be read");
    }
    Ok(text)
}

#[test]
fn relative_to_the_including_file() {
    let folder = folder();
    for (references, text) in [
        (&["sub/deep.xodr", "beside.xodr"][..], "beside"),
        (&["sub\\deep.xodr", "../roads.xodr"], "<OpenDRIVE>\n</OpenDRIVE>"),
        (&["./sub/../sub/deep.xodr"], "deep"),
        (&[" sub/deep.xodr "], "deep"),
        (&["../base/sub/deep.xodr"], "deep"),
    ] {
        let mut inputs = inputs(folder.path(), SourceLimits::default());
        assert_eq!(follow(&mut inputs, references).as_deref(), Ok(text), "{references:?}");
    }
}

#[test]
fn refused() {
    use IncludeRefusal as R;
    let folder = folder();
    let limits = SourceLimits { include_depth: 2, ..SourceLimits::default() };
    let absolute = folder.path().join("base/roads.xodr").display().to_string();
    type Expected = fn(&IncludeRefusal) -> bool;
    let cases: [(&[&str], Expected); 16] = [
        (&[""], |r| *r == R::Empty),
        (&["../outside.xodr"], |r| matches!(r, R::Outside(..))),
        (&["sub/../../outside.xodr"], |r| matches!(r, R::Outside(..))),
        (&["../base2/near.xodr"], |r| matches!(r, R::Outside(..))),
        (&["link.xodr"], |r| matches!(r, R::Outside(..))),
        (&["sub/deep.xodr", "../../outside.xodr"], |r| matches!(r, R::Outside(..))),
        (&[&absolute], |r| matches!(r, R::NotRelative(_))),
        (&["/etc/passwd"], |r| matches!(r, R::NotRelative(_))),
        (&["file:///etc/passwd"], |r| matches!(r, R::NotRelative(_))),
        (&["http://example.com/a.xodr"], |r| matches!(r, R::NotRelative(_))),
        (&["C:\\maps\\a.xodr"], |r| matches!(r, R::NotRelative(_))),
        (&["absent.xodr"], |r| matches!(r, R::Unreadable(..))),
        (&["sub"], |r| matches!(r, R::Unreadable(..))),
        (&["main.xodr"], |r| matches!(r, R::Cycle(_))),
        (&["roads.xodr", "sub/../main.xodr"], |r| matches!(r, R::Cycle(_))),
        (&["roads.xodr", "sub/deep.xodr", "beside.xodr"], |r| *r == R::Depth(2)),
    ];
    for (references, expected) in cases {
        let refusal =
            follow(&mut inputs(folder.path(), limits), references).expect_err("a refusal");
        assert!(expected(&refusal), "{references:?}: {refusal}");
    }
}

#[test]
fn options() {
    let folder = folder();
    let main = folder.path().join("base/main.xodr");
    let limits = SourceLimits::default();

    let mut inputs = Inputs::new(limits).with_include_folder(folder.path());
    inputs.open_file(&main).expect("the main file");
    assert_eq!(follow(&mut inputs, &["../outside.xodr"]).as_deref(), Ok("secret"));

    let mut inputs = Inputs::new(limits).with_includes_from_anywhere();
    inputs.open_file(&main).expect("the main file");
    assert_eq!(follow(&mut inputs, &["../base2/near.xodr"]).as_deref(), Ok("secret"));

    let mut inputs = Inputs::new(limits).with_include_folder(folder.path().join("base"));
    let _ = inputs.open(Box::new(&b"<a/>"[..]), "memory");
    assert_eq!(follow(&mut inputs, &["sub/deep.xodr"]).as_deref(), Ok("deep"));
    assert!(matches!(
        follow(&mut inputs, &["../../outside.xodr"]),
        Err(IncludeRefusal::Outside(..))
    ));

    let mut inputs = self::inputs(folder.path(), SourceLimits { files: 3, ..limits });
    for _ in 0..2 {
        assert!(inputs.include("roads.xodr", 0).is_ok());
        inputs.leave();
    }
    assert_eq!(inputs.include("roads.xodr", 0).err(), Some(IncludeRefusal::Files(3)));
}

#[test]
fn decoded_bytes_are_counted_over_all_files() {
    let folder = folder();
    let mut inputs =
        inputs(folder.path(), SourceLimits { decoded_bytes: 40, ..SourceLimits::default() });
    for expected in [true, false] {
        let mut source = inputs.include("roads.xodr", 0).expect("it may be included");
        assert_eq!(source.read_to_string(&mut String::new()).is_ok(), expected);
        inputs.leave();
    }
}

#[test]
fn places_name_their_file() {
    let folder = folder();
    let mut inputs = inputs(folder.path(), SourceLimits::default());
    let at = Places::start(0, 3);
    let mut source = inputs.include("roads.xodr", at).expect("it may be included");
    source.read_to_string(&mut String::new()).expect("it can be read");
    let start = Places::start(source.file(), 14);
    assert_eq!((source.file(), Places::file_of(start), Places::offset_of(start)), (1, 1, 14));
    let place = inputs.places().place(start);
    assert!(place.to_string().ends_with("base/roads.xodr:2:3"), "{place}");
    assert_eq!(inputs.places().included_at(start), Some(at));
    assert_eq!(inputs.places().included_at(at), None);
}
