#!/usr/bin/env python3
"""Compares mapd's verdict on well-formedness with libxml2's, on small documents and random mutations of them.

    pip install -r tests/differential/requirements.txt
    cargo build --release -p mapd-xodr --example scan_xml
    tests/differential/well_formed.py [NUMBER OF MUTATIONS] [MAP …]

Differences that are decided are listed in `DECIDED`, each with its reason; any other ends the run with an error.
"""

import collections
import random
import re
import subprocess
import sys
from pathlib import Path

from lxml import etree

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "target/release/examples/scan_xml"

# (who is stricter, pattern of that side's message, why)
DECIDED = [
    ("libxml2", r"XML or text declaration not at start|XML declaration allowed only at the start", "tolerated with a warning: files in the wild have comments or white space before it"),
    ("libxml2", r"Start tag expected, '<' not found", "text before the first < is passed over with a warning"),
    ("libxml2", r"Document is empty", "text before the first < is passed over with a warning"),
    ("libxml2", r"[Nn]amespace|xmlns|Failed to parse QName|colon|QName", "namespaces are no matter of well-formedness"),
    ("libxml2", r"labelled|encoding|declared", "the bytes win over the declaration, with a warning"),
    ("libxml2", r"DOCTYPE|DTD|Entity|entity|ELEMENT|ATTLIST|NOTATION|internal|Content error|PEReference|SystemLiteral|SYSTEM or PUBLIC|Public|xmlParse|PubidLiteral|SYSTEM", "a document type is an error or a warning as a whole; nothing in it is looked at"),
    ("libxml2", r"Char 0x0 out of allowed range", "UTF-16 without a byte order mark is read, with a warning"),
    ("mapd", r"XML declaration with version", "libxml2 takes the version `1.`, XML 1.0 (2.8, VersionNum) asks for a digit behind the point"),
    ("mapd", r"declarations within the document", "a document type with declarations is refused on purpose"),
    ("mapd", r"one of the entities", "entities that a document declares are not expanded on purpose"),
    ("mapd", r"an encoding that is read", "encodings that hide markup are refused on purpose"),
]

SEEDS = [
    b'<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n<!-- a comment -->\n<OpenDRIVE>\n  <header revMajor="1" revMinor="7" name="a &amp; b"/>\n'
    b'  <road id=\'1\' length="1.0"><userData code="x"><![CDATA[a < b & c]]></userData>text &#65;&#x42; &lt;</road>\n  <?target data?>\n</OpenDRIVE>\n<!-- end -->\n',
    b"<a><b c='1' d='2'/><e>t</e></a>",
    b"<!DOCTYPE a><a/>",
    b'<!DOCTYPE a SYSTEM "a.dtd" [<!ENTITY e "x">]><a>&e;</a>',
    "<?xml version='1.0'?><\u00e4 \u00f6='\u20ac'>\u4f60 \U0001f6e3</\u00e4>".encode(),
    "<?xml version='1.0' encoding='ISO-8859-1'?><a b='\u00e4'/>".encode("latin-1"),
    "\ufeff<a b='\u00e4'/>".encode("utf-16-le"),
    b"\xef\xbb\xbf<a>\r\n</a>",
]

FRAGMENTS = [
    b"<", b">", b"&", b"]]>", b"--", b"-->", b"<!--", b"<?", b"?>", b"<![CDATA[", b"'", b'"', b"=", b" ", b"\n", b"/", b"/>", b"</a>", b"<a>", b"<a/>",
    b"&amp;", b"&bogus;", b"&#0;", b"&#65;", b"&#xD800;", b"&#;", b"&;", b"\x00", b"\x01", b"\x0b", b"\x7f", b"\xff", b"\xc3", "\ufffe".encode(), "\u00b7".encode(),
    "\u00d7".encode(), "\u0300".encode(), b"xml", b"<?xml version='1.0'?>", b"<?XML x?>", b"<!DOCTYPE a>", b"<!", b"<!D", b":", b"-", b".", b"1", b" a='1'", b"a='1'", b" a=1", b" a", b"]",
    b"standalone='yes'", b"encoding='x'", b"version='1.1'", b"version='2.0'", b"\r", b"\t", b"<1>", b"<-a/>", b"</ a>", b"<a b='<'/>", b"<!-->", b"<!--->",
]


def mutate(chooser, document):
    document = bytearray(document)
    for _ in range(chooser.choice([1, 1, 1, 2, 3])):
        place = chooser.randrange(len(document) + 1)
        end = min(len(document), place + chooser.choice([1, 1, 2, 4, 16]))
        kind = chooser.randrange(5)
        if kind == 0:
            del document[place:end]
        elif kind == 1:
            document[place:place] = chooser.choice(FRAGMENTS)
        elif kind == 2:
            document[place:end] = chooser.choice(FRAGMENTS)
        elif kind == 3:
            document[place:place] = document[place:end]
        elif document:
            at = min(place, len(document) - 1)
            document[at] = chooser.randrange(256)
    return bytes(document)


def libxml2(document):
    """The first error, or None."""
    parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False, huge_tree=False)
    try:
        etree.fromstring(document, parser)
    except etree.XMLSyntaxError as error:
        return str(error)
    except ValueError as error:
        return str(error)
    return None


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 50_000
    chooser = random.Random(1)
    maps = [Path(path).read_bytes() for path in sys.argv[2:]]
    seeds = SEEDS + [document for document in maps if len(document) < 20_000]
    judge = subprocess.Popen([PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    outcomes = collections.Counter()
    differences = []
    for number in range(count + len(seeds) + len(maps)):
        if number < len(seeds):
            document = seeds[number]
        elif number < len(seeds) + len(maps):
            document = maps[number - len(seeds)]
        else:
            document = mutate(chooser, chooser.choice(seeds))
        if not document:
            continue
        judge.stdin.write(b"%d\n" % len(document) + document)
        judge.stdin.flush()
        ours = judge.stdout.readline().decode().rstrip("\n")
        theirs = libxml2(document)
        we_refuse = ours.startswith("error")
        if we_refuse == (theirs is not None):
            outcomes["both refuse" if we_refuse else "both accept"] += 1
            continue
        stricter, message = ("mapd", ours) if we_refuse else ("libxml2", theirs)
        reason = next((why for who, pattern, why in DECIDED if who == stricter and re.search(pattern, message)), None)
        if reason:
            outcomes[f"decided, {stricter} is stricter: {reason}"] += 1
        else:
            outcomes["DIFFERENT"] += 1
            differences.append((stricter, message, ours, document))
    judge.stdin.close()
    for outcome, times in outcomes.most_common():
        print(f"{times:8} {outcome}")
    for stricter, message, ours, document in differences[:40]:
        print(f"\n{stricter} is stricter: {message}   [mapd: {ours}]\n  {document[:400]!r}")
    sys.exit(1 if differences else 0)


if __name__ == "__main__":
    main()
