#!/usr/bin/env python3
"""What packages of mapd are made of, from what cargo and git say.

    materials.py OUT                      OUT/KIND/THIRD-PARTY.txt (licences of all dependencies) and OUT/KIND/bom.cdx.json (CycloneDX 1.5) of each
                                          kind of package
    materials.py --provenance FILE...     FILE.provenance.json beside each package (in-toto statement, SLSA provenance 1.0)
"""

import hashlib
import json
import pathlib
import subprocess
import sys
import uuid

ROOT = pathlib.Path(__file__).resolve().parents[3]
TARGET = "x86_64-unknown-linux-gnu"
# Programs and libraries that each kind of package carries. An image has what `mapd`, which is installed in it, has.
PACKED = {"mapd": ("mapd",), "libmapd": ("mapd-c",), "tarball": ("mapd", "mapd-c"), "wheel": ("mapd-python",)}
LICENCE_FILES = ("licen", "copying", "notice", "unlicense", "copyright")


def said(*command):
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


def resolved():
    """Every crate of the workspace's lock file, and what each depends on."""
    metadata = json.loads(said("cargo", "metadata", "--locked", "--format-version", "1", "--filter-platform", TARGET))
    packages = {package["id"]: package for package in metadata["packages"]}
    return packages, {node["id"]: node for node in metadata["resolve"]["nodes"]}


def dependencies(packages, nodes, packed):
    """Crates that are packed or linked, without those that only build or test."""
    found, waiting = {}, [id for id, package in packages.items() if package["name"] in packed]
    while waiting:
        id = waiting.pop()
        if id in found:
            continue
        linked = [dep["pkg"] for dep in nodes[id]["deps"] if any(kind["kind"] is None for kind in dep["dep_kinds"])]
        found[id] = (packages[id], linked)
        waiting += linked
    return found


def texts(package):
    folder = pathlib.Path(package["manifest_path"]).parent
    names = [path for path in sorted(folder.iterdir()) if path.is_file() and path.name.lower().startswith(LICENCE_FILES)]
    return [path.read_text(errors="replace").strip() for path in names]


def third_party(crates):
    """Each text once, under the crates that have it."""
    lines = ["Licences of the libraries that mapd contains.", ""]
    owners = {}
    for package in crates:
        name = f"{package['name']} {package['version']}"
        lines.append(f"{name}: {package['license'] or 'see its text'}, {package['repository'] or 'no repository given'}")
        for text in texts(package):
            owners.setdefault(text, []).append(name)
    for text, names in owners.items():
        lines += ["", "-" * 100, ", ".join(names), "-" * 100, "", text]
    return "\n".join(lines) + "\n"


def purl(package):
    return f"pkg:cargo/{package['name']}@{package['version']}"


def bom(kind, packed, found, version, revision):
    components = [
        {
            "type": "library",
            "bom-ref": purl(package),
            "name": package["name"],
            "version": package["version"],
            "purl": purl(package),
            **({"licenses": [{"expression": package["license"].replace("/", " OR ")}]} if package["license"] else {}),
        }
        for package, _ in found.values()
    ]
    links = [{"ref": kind, "dependsOn": sorted(purl(package) for package, _ in found.values() if package["name"] in packed)}]
    links += [{"ref": purl(package), "dependsOn": sorted(purl(found[id][0]) for id in linked)} for package, linked in found.values()]
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        # The same for the same revision.
        "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'mapd {version} {kind} {revision}')}",
        "version": 1,
        "metadata": {"component": {"type": "application", "bom-ref": kind, "name": f"mapd ({kind})", "version": version}},
        "components": sorted(components, key=lambda component: component["bom-ref"]),
        "dependencies": sorted(links, key=lambda link: link["ref"]),
    }


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def provenance(file, revision):
    return {
        "_type": "https://in-toto.io/Statement/v1",
        "subject": [{"name": file.name, "digest": {"sha256": digest(file)}}],
        "predicateType": "https://slsa.dev/provenance/v1",
        "predicate": {
            "buildDefinition": {
                "buildType": "src/mapd/package/build",
                "externalParameters": {"target": TARGET},
                "internalParameters": {"rustc": said("rustc", "-V"), "cargo": said("cargo", "-V")},
                "resolvedDependencies": [
                    {"name": "mapd", "digest": {"gitCommit": revision}},
                    {"name": "Cargo.lock", "digest": {"sha256": digest(ROOT / "Cargo.lock")}},
                ],
            },
            "runDetails": {"builder": {"id": "src/mapd/package/build"}},
        },
    }


def written(path, value):
    path.write_text(json.dumps(value, indent=1) + "\n")


def revision():
    return said("git", "rev-parse", "HEAD") if (ROOT / ".git").exists() else "unknown"


def make(out):
    packages, nodes = resolved()
    for kind, packed in PACKED.items():
        found = dependencies(packages, nodes, packed)
        crates = sorted((package for package, _ in found.values() if package["source"]), key=lambda package: package["name"])
        without = [package["name"] for package in crates if not package["license"] and not texts(package)]
        if without:
            sys.exit(f"no licence: {', '.join(without)}")
        version = [package["version"] for package, _ in found.values() if package["name"] in packed][0]
        folder = pathlib.Path(out) / kind
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "THIRD-PARTY.txt").write_text(third_party(crates))
        written(folder / "bom.cdx.json", bom(kind, packed, found, version, revision()))


def main(first="", *files):
    if first == "--provenance" and files:
        for file in map(pathlib.Path, files):
            written(file.with_name(f"{file.name}.provenance.json"), provenance(file, revision()))
    elif first and not files:
        make(first)
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(*sys.argv[1:])
