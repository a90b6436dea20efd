#!/usr/bin/env python3
"""Validates what mapd reports: JSON by schemas/report.schema.json, SARIF by its own schema, .xqar by the reader of ASAM's framework.

    reports.py --mapd PATH/mapd FILE...

The schema of SARIF 2.1.0 comes with the crate serde-sarif, which cargo fetches; nothing of it is in this project. Needs the packages
jsonschema and asam-qc-baselib. Ends with 1 where a report is not valid.
"""

import argparse
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema
from qc_baselib import Result

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANIFEST = """[package]
name = "schema-of-sarif"
version = "0.0.0"
edition = "2024"
[dependencies]
serde-sarif = "=0.8.0"
[workspace]
"""
LEVELS = {"error": 1, "warning": 2, "info": 3}


def sarif_schema(folder):
    """The schema that the crate carries."""
    (folder / "src").mkdir()
    (folder / "src/lib.rs").touch()
    (folder / "Cargo.toml").write_text(MANIFEST, encoding="utf-8")
    done = subprocess.run(["cargo", "metadata", "--format-version", "1"], cwd=folder, capture_output=True, check=True)
    packages = json.loads(done.stdout)["packages"]
    crate = next(package for package in packages if package["name"] == "serde-sarif")
    text = (pathlib.Path(crate["manifest_path"]).parent / "src/schema.json").read_text(encoding="utf-8")
    return json.loads(text)


def validator(schema):
    """A validator of documents by a schema, which is valid itself; formats such as URIs count."""
    kind = jsonschema.validators.validator_for(schema)
    kind.check_schema(schema)
    return kind(schema, format_checker=kind.FORMAT_CHECKER)


def wrong(validate, document):
    """What is wrong with a document, in words."""
    errors = sorted(validate.iter_errors(document), key=lambda error: list(map(str, error.absolute_path)))
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:200]}" for error in errors[:5]]


def check(mapd, file, form):
    """A report of a file. 0, 3 and 4 are the ends of a check that was done."""
    done = subprocess.run([mapd, "check", file, "--format", form], capture_output=True, timeout=600)
    if done.returncode not in (0, 3, 4):
        raise RuntimeError(f"{file}: {done.stderr.decode(errors='replace')}")
    return done.stdout


def xqar(text, folder, findings):
    """What the framework's reader sees otherwise than the findings say."""
    path = folder / "result.xqar"
    path.write_bytes(text)
    result = Result()
    result.load_from_file(str(path))
    seen = collections.Counter()
    for bundle in result.get_checker_bundle_names():
        for checker in result.get_checker_results(bundle):
            for issue in checker.issues:
                places = [place for location in issue.locations for place in location.file_location]
                seen.update((issue.level.value, place.row, place.column) for place in places)
    due = collections.Counter((LEVELS[f["severity"]], f["line"], f["column"]) for f in findings)
    return [f"findings {due - seen} are missing, {seen - due} are new"] if seen != due else []


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mapd", required=True)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    counts, failures = collections.Counter(), []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        own = validator(json.loads((ROOT / "schemas/report.schema.json").read_text(encoding="utf-8")))
        sarif = validator(sarif_schema(folder))
        for file in arguments.files:
            document = json.loads(check(arguments.mapd, file, "json"))
            log = json.loads(check(arguments.mapd, file, "sarif"))
            report = folder / "report.json"
            compile_map = ["compile", file, "-o", folder / "map.mapd", "--report", report]
            subprocess.run([arguments.mapd, *compile_map], capture_output=True, timeout=600)
            found = [f"json: {error}" for error in wrong(own, document)]
            found += [f"report: {error}" for error in wrong(own, json.loads(report.read_text(encoding="utf-8")))]
            found += [f"sarif: {error}" for error in wrong(sarif, log)]
            if len(log["runs"][0]["results"]) != len(document["findings"]):
                found.append("sarif: another number of results than findings")
            found += [f"xqar: {error}" for error in xqar(check(arguments.mapd, file, "xqar"), folder, document["findings"])]
            counts["findings"] += len(document["findings"])
            counts["files"] += 1
            failures += [f"{file}: {error}" for error in found]
    print("\n".join(failures))
    print(f"{counts['files']} files, {counts['findings']} findings, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
