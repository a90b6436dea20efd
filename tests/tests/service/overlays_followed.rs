//! `mapd overlay NAME apply --watch`: what a fetcher writes is laid over the map for as long as it says so.

use super::overlays::{Scene, closed};
use mapd_tests::test_domain::until;
use std::fs::{self, File};
use std::path::Path;
use std::process::Stdio;

/// A process that ends with the test.
struct Ended(std::process::Child);

impl Drop for Ended {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// `mapd overlay town apply --watch` of a file or folder, with its errors there.
fn follows(scene: &Scene, path: &Path, errors: Stdio) -> Ended {
    let mut command = scene.place.command();
    command.args(["overlay", "town", "apply", "--watch"]).arg(path);
    Ended(command.stdout(Stdio::null()).stderr(errors).spawn().expect("starts"))
}

/// Waits until these entries are laid over the map, and no others.
fn becomes(scene: &Scene, expected: &[&str]) {
    until(&format!("{expected:?}"), || {
        let list = scene.list();
        let entries = list["entries"].as_array().expect("a list");
        let mut ids: Vec<_> = entries.iter().filter_map(|e| e["id"].as_str()).collect();
        ids.sort_unstable();
        (ids == expected).then_some(())
    });
}

/// What a fetcher writes into a folder is followed: applied, replaced, removed; what is wrong changes nothing.
#[test]
fn a_folder_is_followed() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let folder = scene.folder.path().join("works");
    fs::create_dir(&folder).expect("a folder");
    let put = |name: &str, text: &str| fs::write(folder.join(name), text).expect("written");
    let _follows = follows(&scene, &folder, Stdio::null());
    scene.ends(&["apply", "-"], &closed("own", -1), 0);
    put("a.json", &closed("a", -1));
    put("b.json", &closed("b", -1));
    becomes(&scene, &["a", "b", "own"]);
    put("a.json", &closed("other", -1));
    becomes(&scene, &["b", "other", "own"]);
    put("a.json", "{");
    fs::remove_file(folder.join("b.json")).expect("removed");
    becomes(&scene, &["other", "own"]);
    put("a.json", &closed("a", 1));
    becomes(&scene, &["a", "own"]);
    // A file by another name has its entries still.
    fs::rename(folder.join("a.json"), folder.join("c.json")).expect("renamed");
    until("the other name", || {
        (scene.list()["entries"][1]["feed"] == "works/c.json").then_some(())
    });
    // An entry of another file is not taken over, and is laid once that file has gone.
    put("d.json", &closed("a", -1));
    std::thread::sleep(std::time::Duration::from_secs(1));
    assert_eq!(scene.list()["entries"][1]["feed"], "works/c.json");
    fs::remove_file(folder.join("c.json")).expect("removed");
    becomes(&scene, &["own"]);
    becomes(&scene, &["a", "own"]);
}

/// A single file is followed: applied, replaced whole, told once where it is wrong. One that is missing removes nothing, nor does a daemon that goes.
#[test]
fn a_file_is_followed() {
    let scene = Scene::new();
    let daemon = scene.place.serve(&scene.args());
    let file = scene.folder.path().join("works.json");
    let errors = scene.folder.path().join("errors");
    let _follows = follows(&scene, &file, File::create(&errors).expect("a file").into());
    let put = |text: &str| fs::write(&file, text).expect("written");
    scene.ends(&["apply", "-"], &closed("own", -1), 0);
    put(&closed("a", -1));
    becomes(&scene, &["a", "own"]);
    assert_eq!(scene.list()["entries"][1]["feed"], "works.json");
    put(&closed("b", -1));
    becomes(&scene, &["b", "own"]);
    let told = |words: &str| {
        let said = || fs::read_to_string(&errors).expect("read").matches(words).count();
        until(words, || (said() > 0).then_some(()));
        said()
    };
    put(&closed("c", -1).replace("\"1\"", "\"no such road\""));
    told("\"c\", lanes[0].road");
    becomes(&scene, &["b", "own"]);
    fs::remove_file(&file).expect("removed");
    assert_eq!(daemon.stop(), 0);
    let _next = scene.place.serve(&scene.args());
    becomes(&scene, &["b", "own"]);
    put(&closed("d", -1));
    becomes(&scene, &["d", "own"]);
    assert_eq!(told("no such road"), 1, "told once");
}
