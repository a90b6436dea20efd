//! Every object of the shared corpus is in its map, or named as left out.

use mapd_archive::{encode, verify};
use mapd_client::Snapshot;
use mapd_compiler::{CompileOptions, PartKind, ReadOptions, compile_from};
use mapd_query::vocabulary::StructureKind;
use std::collections::HashMap;

/// Counts of each map of the corpus as its manifest has them: column by column.
fn manifest() -> Option<Vec<HashMap<String, String>>> {
    let text = std::fs::read_to_string(mapd_tests::shared("maps")?.join("manifest.tsv")).ok()?;
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next()?.split('\t').collect();
    let row = |line: &str| {
        let pairs = names.iter().zip(line.split('\t'));
        pairs.map(|(name, value)| ((*name).to_owned(), value.to_owned())).collect()
    };
    Some(lines.map(row).collect())
}

#[test]
fn counts_are_those_of_the_manifest() {
    let (Some(manifest), Some(corpus)) = (manifest(), mapd_tests::corpus()) else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    let (mut compared, mut objects) = (0, 0);
    for (name, path) in &corpus {
        let (reading, options) = (ReadOptions::default(), CompileOptions::default());
        let open = || std::fs::File::open(path);
        let compiled = compile_from(open, &reading, &options, &mut |_| {}).expect("reading works");
        let Some(rows) = &compiled.rows else { continue };
        let file = format!("{name}.xodr");
        let line = manifest.iter().find(|line| line["map"] == file);
        let line = line.unwrap_or_else(|| panic!("{name} is not in the manifest"));
        let expected = |column: &str| line[column].parse::<usize>().unwrap_or(0);
        let lost = compiled.quarantined.iter().filter(|p| p.kind == PartKind::Object).count();
        // What is left out with a road is not counted apart.
        let roads = compiled.quarantined.iter().filter(|p| p.kind == PartKind::Road).count();
        let bytes = encode(rows, &compiled.provenance).expect("encodes");
        verify(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
        let snapshot = Snapshot::from_bytes(bytes).expect("opens");
        let map = snapshot.map();
        let found = map.objects().count() + lost;
        let wanted = expected("objects");
        assert!(found == wanted || (roads > 0 && found < wanted), "{name}: {found} of {wanted}");
        let structures = |kind| map.structures().filter(|s| s.kind() == kind).count();
        let beside = [
            ("tunnels", structures(StructureKind::Tunnel)),
            ("bridges", structures(StructureKind::Bridge)),
            ("objectRefs", map.object_references().len()),
        ];
        for (column, found) in beside {
            assert!(found == expected(column) || roads > 0, "{name}: {found} {column}");
        }
        for object in map.objects() {
            assert!(object.placements().next().is_some(), "{name}: {} is nowhere", object.id());
            assert_eq!(map.object_by_id(object.id()).expect("found").id(), object.id());
        }
        objects += found;
        compared += usize::from(wanted > 0);
    }
    assert!(compared >= 17 && objects >= 600, "{compared} maps with {objects} objects");
}
