#!/usr/bin/env python3
"""What a package of mapd is made of: THIRD-PARTY.txt (licences of all dependencies), bom.cdx.json (CycloneDX 1.5) and provenance.json (in-toto
statement, SLSA provenance 1.0), from what cargo and git say. materials.py OUT FILE...: the files are what the provenance is about."""

import hashlib
import json
import pathlib
import subprocess
import sys
import uuid

ROOT = pathlib.Path(__file__).resolve().parents[3]
TARGET = "x86_64-unknown-linux-gnu"
# Programs and libraries that packages carry.
PACKED = ("mapd", "mapd-c", "mapd-python")
LICENCE_FILES = ("licen", "copying", "notice", "unlicense", "copyright")


def said(*command):
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


def dependencies():
    """Crates that PACKED link, without those that only build or test."""
    metadata = json.loads(said("cargo", "metadata", "--locked", "--format-version", "1", "--filter-platform", TARGET))
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    found, waiting = {}, [id for id, package in packages.items() if package["name"] in PACKED]
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


def bom(found, version, revision):
    ours = [package for package, _ in found.values() if package["name"] == "mapd"][0]
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
        if package is not ours
    ]
    links = [{"ref": purl(package), "dependsOn": sorted(purl(found[id][0]) for id in linked)} for package, linked in found.values()]
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        # The same for the same revision.
        "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'mapd {version} {revision}')}",
        "version": 1,
        "metadata": {"component": {"type": "application", "bom-ref": purl(ours), "name": "mapd", "version": version, "purl": purl(ours)}},
        "components": sorted(components, key=lambda component: component["bom-ref"]),
        "dependencies": sorted(links, key=lambda link: link["ref"]),
    }


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def provenance(files, revision):
    return {
        "_type": "https://in-toto.io/Statement/v1",
        "subject": [{"name": path.name, "digest": {"sha256": digest(path)}} for path in files],
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


def main(out, *files):
    out = pathlib.Path(out)
    found = dependencies()
    crates = sorted((package for package, _ in found.values() if package["source"]), key=lambda package: package["name"])
    revision = said("git", "rev-parse", "HEAD") if (ROOT / ".git").exists() else "unknown"
    version = [package["version"] for package, _ in found.values() if package["name"] == "mapd"][0]
    without = [package["name"] for package in crates if not package["license"] and not texts(package)]
    if without:
        sys.exit(f"no licence: {', '.join(without)}")
    if files:
        statement = provenance([pathlib.Path(file) for file in files], revision)
        (out / "provenance.json").write_text(json.dumps(statement, indent=1) + "\n")
    else:
        (out / "THIRD-PARTY.txt").write_text(third_party(crates))
        (out / "bom.cdx.json").write_text(json.dumps(bom(found, version, revision), indent=1) + "\n")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
