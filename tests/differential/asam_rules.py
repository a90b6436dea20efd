#!/usr/bin/env python3
"""Compares mapd's rules with asam-qc-opendrive's, rule by rule and file by file.

    asam_rules.py --mapd PATH/mapd --qc PATH/qc_opendrive [--explained asam_rules.tsv] FILE...

A rule is compared only where the other checker ran it to its end. Differences that are not in the list of explained ones end
the run with 1; explained ones are counted. The list has the columns rule, file (its stem, or *), who finds (mapd or qc), why.
"""

import argparse
import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as tree

CONFIG = """<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<Config><Param name="InputFile" value="{file}"/><CheckerBundle application="xodrBundle">
<Param name="resultFile" value="{result}"/></CheckerBundle></Config>"""


def key(rule):
    """What names a rule in both: its name in small letters without underscores and version."""
    return rule.split(":")[-1].lower().replace("_", "")


def others(qc, file, folder):
    """Rules that the other checker ran, with the number of its findings."""
    config, result = folder / "config.xml", folder / "result.xqar"
    config.write_text(CONFIG.format(file=file, result=result), encoding="utf-8")
    result.unlink(missing_ok=True)
    done = subprocess.run([qc, "-c", config], capture_output=True, timeout=600)
    if not result.exists():
        return None, done.stderr.decode(errors="replace")[-200:]
    found = {}
    for checker in tree.parse(result).iter("Checker"):
        if checker.get("status") != "completed":
            continue
        for rule in checker.iter("AddressedRule"):
            issues = [i for i in checker.iter("Issue") if i.get("ruleUID") == rule.get("ruleUID")]
            found[key(rule.get("ruleUID"))] = len(issues)
    return found, ""


def ours(mapd, file, aliases):
    """Rules with the number of mapd's findings."""
    done = subprocess.run(
        [mapd, "check", file, "--format", "json", "--max-findings", "1000000"], capture_output=True, timeout=600
    )
    found = {}
    for finding in json.loads(done.stdout)["findings"]:
        for rule in {finding["rule"], finding["asam_rule"] or finding["rule"]} | aliases.get(finding["rule"], set()):
            found[key(rule)] = found.get(key(rule), 0) + 1
    return found


def read_aliases(docs):
    """Further ids of mapd's rules, from the pages of its documentation."""
    aliases, rule = {}, None
    for page in docs.glob("*.md"):
        for line in page.read_text(encoding="utf-8").splitlines():
            if heading := re.match(r"## `(.+)`", line):
                rule = heading[1]
            elif line.startswith("Also `") and rule:
                aliases[rule] = set(re.findall(r"`([^`]+)`", line))
    return aliases


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mapd", required=True)
    parser.add_argument("--qc", required=True)
    parser.add_argument("--explained", type=pathlib.Path)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    docs = pathlib.Path(__file__).resolve().parents[2] / "docs/rules"
    aliases = read_aliases(docs)
    explained = set()
    if arguments.explained:
        for line in arguments.explained.read_text(encoding="utf-8").splitlines()[1:]:
            rule, file, who, _ = line.split("\t")
            explained.add((rule, file, who))
    agree = known = 0
    different, unread = [], []
    spent = {"mapd": 0.0, "qc": 0.0}
    with tempfile.TemporaryDirectory() as folder:
        for file in arguments.files:
            start = time.monotonic()
            theirs, reason = others(arguments.qc, file, pathlib.Path(folder))
            middle = time.monotonic()
            mine = ours(arguments.mapd, file, aliases)
            spent["qc"] += middle - start
            spent["mapd"] += time.monotonic() - middle
            if theirs is None:
                unread.append((file.stem, reason))
                continue
            for rule, count in sorted(theirs.items()):
                if bool(count) == bool(mine.get(rule)):
                    agree += 1
                    continue
                who = "qc" if count else "mapd"
                if {(rule, file.stem, who), (rule, "*", who)} & explained:
                    known += 1
                else:
                    different.append((rule, file.stem, who, count, mine.get(rule, 0)))
    for rule, file, who, count, mine in different:
        print(f"{rule}\t{file}\t{who}\tqc {count}, mapd {mine}")
    for file, reason in unread:
        print(f"qc yields no result for {file}: {reason}")
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(f"{agree} agree, {known} differ as explained, {len(different)} differ; "
          f"qc {spent['qc']:.1f} s, mapd {spent['mapd']:.1f} s, largest process {memory:.0f} MiB")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
