#!/usr/bin/env python3
"""Compares mapd's findings about structure and values with those of other validators; see README.md.

    tests/differential/structure.py [--versions 1.4,1.7] [--step N] [--maps FOLDER] [--list]

Every difference is explained in `explained.tsv`, or ends the run with an error.
"""

import argparse
import collections
import csv
import itertools
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from xml.etree import ElementTree

import mutate
import schemas
from lxml import etree
from table import ROOT, Table

TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release"
# Reads thousands of mutations in one process; whole files are read by `mapd check`.
PROGRAM, CHECK = TARGET / "examples/read_xodr", TARGET / "mapd"
# Corpus files that are mutated are small, so that thousands of mutations are read in a minute.
SMALL = 30_000

KINDS = {
    "mapd:structure.missing_attribute": "missing attribute",
    "mapd:structure.unknown_attribute": "unknown attribute",
    "mapd:structure.missing_element": "content",
    "mapd:structure.occurrence": "content",
    "mapd:structure.choice": "content",
    "mapd:structure.order": "content",
    "mapd:structure.unknown_element": "content",
    "mapd:structure.text": "text",
    "mapd:value.type": "value",
    "mapd:value.finite": "value",
    "mapd:value.range": "value",
    "mapd:value.lexical": "value",
    "mapd:value.space": "value",
    "mapd:value.empty": "value",
    "mapd:value.enumeration": "value",
    "asam.net:xodr:1.0.0:xml.version_is_defined": "value",
    "asam.net:xodr:1.0.0:xml.root_tag_is_opendrive": "root",
}
# About elements, attributes or words.
VARYING = {"mapd:structure.other_version", "mapd:structure.variant"}
# Said about what is allowed, too.
REMARKS = {"mapd:structure.deprecated", "mapd:xml.namespace", "mapd:structure.not_kept"}


class Mapd:
    def __init__(self):
        self.process = subprocess.Popen([PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def findings(self, text, tree):
        """(line, kind, attribute, message, severity) of each finding."""
        return self.normal(self.rows(text), tree)

    def rows(self, text):
        self.process.stdin.write(b"%d\n" % len(text) + text)
        self.process.stdin.flush()
        while line := self.process.stdout.readline().decode().rstrip("\n"):
            at, severity, rule, subject, _, message = line.split("\t", 5)
            yield int(at), severity, rule, subject, message

    def check(self, text, tree):
        """The same by `mapd check`, where it is built."""
        if not CHECK.exists():
            return self.findings(text, tree)
        with tempfile.NamedTemporaryFile(suffix=".xodr") as file:
            file.write(text)
            file.flush()
            command = [CHECK, "check", file.name, "--format", "json", "--max-findings", "10000"]
            report = json.loads(subprocess.run(command, stdout=subprocess.PIPE).stdout)
        found = [finding for finding in report["findings"] if finding["rule"] in KINDS.keys() | VARYING]
        return self.normal(((f["line"], f["severity"].capitalize(), f["rule"], f.get("subject", ""), f["message"]) for f in found), tree)

    def normal(self, rows, tree):
        elements = {element.sourceline: element for element in tree.iter(etree.Element)}
        found = []
        for at, severity, rule, subject, message in rows:
            if rule in REMARKS:
                continue
            element = elements.get(at)
            is_child = element is not None and mutate.tag(element) == subject
            if rule in VARYING:
                if is_child:
                    kind = "content"
                elif "@" + subject.lstrip("@") in message.split(" in ")[0] or message.startswith("expected no @"):
                    kind = "unknown attribute"
                else:
                    kind = "value"
            else:
                kind = KINDS.get(rule, rule)
            if kind == "content" and is_child and rule != "mapd:structure.missing_element":
                at = schemas.line_of_parent(element)
            if kind == "text" and element is None:
                at -= 1
            found.append((at, kind, subject.lstrip("@"), f"{rule}: {message}", severity))
        return found


def same(a, b):
    return a[:2] == b[:2] and (a[2] == b[2] or not a[2] or not b[2] or a[1] in ("content", "text"))


def new(after, before):
    """Findings that a mutation brought; those before it may stand on other lines now."""
    known = collections.Counter(finding[1:4] for finding in before)
    found = []
    for finding in after:
        if known[finding[1:4]] > 0:
            known[finding[1:4]] -= 1
        else:
            found.append(finding)
    return found


def compare(ours, theirs):
    """What the two disagree in about a single mutation: nothing, `missed` by mapd, `extra` with mapd, or `elsewhere`."""
    if not theirs:
        return "extra" if ours else ""
    if not ours:
        return "missed"
    return "" if any(same(a, b) for a in ours for b in theirs) else "elsewhere"


def compare_all(ours, theirs, tree):
    """Each finding of a whole file that only one side has: (verdict, finding, element)."""
    elements = {element.sourceline: element for element in tree.iter(etree.Element)}
    # Behind a child that they do not expect, other validators look at nothing more in the parent.
    passed_over = {line for line, kind, *_ in theirs if kind in ("content", "unknown")}

    def is_passed_over(element):
        return element is not None and (element.sourceline in passed_over or is_passed_over(element.getparent()))

    for finding in theirs:
        if not any(same(finding, other) for other in ours):
            yield "missed", finding, elements.get(finding[0])
    for finding in ours:
        element = elements.get(finding[0])
        if not any(same(finding, other) for other in theirs) and not is_passed_over(element):
            yield "extra", finding, element


def repair(tree, validator):
    """Takes out of a document what a validator finds wrong with it."""
    for _ in range(20):
        findings = validator.findings(tree)
        if not findings:
            break
        elements = {element.sourceline: element for element in tree.iter(etree.Element)}
        for line, kind, attribute, message in findings:
            element = elements[line]
            if attribute and attribute in element.attrib:
                del element.attrib[attribute]
            elif kind == "content" and (unexpected := re.search(r"Element '(?:{.*})?(\w+)': This|with tag '(\w+)'", message)):
                name = unexpected.group(1) or unexpected.group(2)
                for child in [child for child in element if mutate.tag(child) == name]:
                    element.remove(child)
            elif element.getparent() is not None:
                element.getparent().remove(element)
        _, tree = mutate.lines(tree)
    return tree


class Explained:
    """Differences that are decided: patterns of version, verdict, mutation, element and attribute, and why."""

    def __init__(self):
        rows = csv.reader((Path(__file__).parent / "explained.tsv").open(), delimiter="\t", quoting=csv.QUOTE_NONE)
        self.rows = [row for row in rows if row and not row[0].startswith("#")]
        self.uses = collections.Counter()

    def why(self, *facts):
        for row in self.rows:
            if all(re.fullmatch(pattern, fact) for pattern, fact in zip(row, facts)):
                self.uses[tuple(row)] += 1
                return row[-1]
        return None


def prepare(root, version, namespace):
    """A document as both sides read it: of the version and in the schema's namespace."""
    for element in root.iter(etree.Element):
        element.tag = f"{{{namespace}}}{mutate.tag(element)}" if namespace else mutate.tag(element)
    etree.cleanup_namespaces(root)
    return mutate.lines(etree.ElementTree(root))


def stated(root):
    header = next((e for e in root.iter(etree.Element) if mutate.tag(e) == "header"), None)
    return f"{header.get('revMajor', '').strip()}.{header.get('revMinor', '').strip()}" if header is not None else ""


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("--versions", default=",".join(schemas.FILES))
    options.add_argument("--step", type=int, default=1, help="every so many mutations only")
    options.add_argument("--maps", type=Path, default=ROOT.parent / "shared/maps")
    options.add_argument("--list", action="store_true", help="print every difference, not one of each kind")
    options = options.parse_args()
    if not CHECK.exists():
        print("mapd is not built: whole files are read without `mapd check`, too")
    table, mapd, explained = Table(), Mapd(), Explained()
    maps = []
    for path in sorted(options.maps.rglob("*.xodr")) + sorted((ROOT / "examples/maps").glob("*.xodr")):
        try:
            maps.append((path, etree.parse(str(path), etree.XMLParser(remove_comments=True, remove_pis=True, huge_tree=True)).getroot()))
        except etree.XMLSyntaxError:
            pass  # `well_formed.py` compares these.
    outcomes, different = collections.Counter(), []
    for version in options.versions.split(","):
        start = time.time()
        validator = schemas.validator(version)
        counts = collections.Counter()

        def note(verdict, what, ours, theirs):
            if verdict == "extra":
                worst = max((finding[4] for finding in ours), key=["Info", "Warning", "Error"].index)
                verdict += f" {worst.lower()}"
            if reason := explained.why(version, verdict, *what):
                outcomes[f"explained, {verdict}: {reason}"] += 1
            else:
                outcomes["DIFFERENT"] += 1
                different.append((version, verdict, what, ours[:3], theirs[:3]))

        def judge(text, tree, before, *what):
            counts[what[0]] += 1
            ours, theirs = mapd.findings(text, tree), validator.findings(tree)
            ours, theirs = (new(after, known) for after, known in zip((ours, theirs), before))
            if verdict := compare(ours, theirs):
                note(verdict, what, ours, theirs)
            else:
                outcomes["same: both find" if ours else "same: both accept"] += 1

        def judge_whole(text, tree, name):
            counts[name] += 1
            ours, theirs = mapd.check(text, tree), validator.findings(tree)
            for verdict, finding, element in compare_all(ours, theirs, tree):
                parent = element.getparent() if element is not None else None
                names = ["" if e is None else mutate.tag(e) for e in (parent, element)]
                sides = ([finding], []) if verdict == "extra" else ([], [finding])
                note(verdict, (name, *names, finding[2], finding[1]), *sides)

        bases = []
        for root in table.documents(version):
            header = root.find("header")
            header.set("revMajor", "1"), header.set("revMinor", version[2:])
            bases.append(("generated", etree.fromstring(ElementTree.tostring(root))))
        for path, root in maps:
            if stated(root) != version:
                continue
            text, tree = prepare(root, version, validator.namespace)
            judge_whole(text, tree, "file")
            if len(text) < SMALL and not validator.findings(tree):
                bases.append((path.name, tree.getroot()))
        seen = set()
        for name, root in bases:
            text, tree = prepare(root, version, validator.namespace)
            if name == "generated":
                judge_whole(text, tree, "generated")
                tree = repair(tree, validator)
            mutated = mutate.mutations(tree, table, version, seen)
            text, tree = mutate.lines(tree)
            before = mapd.findings(text, tree), validator.findings(tree)
            for kind, parent, element, attribute, value, changed in itertools.islice(mutated, 0, None, options.step):
                text, tree_of = mutate.lines(changed)
                judge(text, tree_of, before, kind, parent, element, attribute, value)
        print(f"{version}: {sum(counts.values())} documents in {time.time() - start:.0f} s: {dict(counts)}", flush=True)
    for outcome, count in outcomes.most_common():
        print(f"{count:8} {outcome}")
    shown = set()
    for version, verdict, what, ours, theirs in different:
        alike = (version, verdict, what[:4] if what[0] == "value" else what)
        if alike in shown and not options.list:
            continue
        shown.add(alike)
        print("\n" + "\t".join((version, verdict, *what)))
        for who, findings in (("mapd", ours), ("other", theirs)):
            for finding in findings:
                print(f"   {who:5} line {finding[0]} {finding[1]} {finding[2]}: {finding[3][:240]}")
    if options.step == 1 and options.versions == ",".join(schemas.FILES):
        for row in explained.rows:
            if not explained.uses[tuple(row)]:
                print("unused explanation:", *row, sep="\t")
                different.append(row)
    sys.exit(1 if different else 0)


if __name__ == "__main__":
    main()
