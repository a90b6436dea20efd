"""The table of elements (`schemas/opendrive`) as this comparison needs it: documents that have everything a version knows."""

import itertools
import re
import tomllib
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[2]
VERSIONS = ["1.4", "1.5", "1.6", "1.7", "1.8", "1.8.1", "1.9"]


def rank(version):
    return VERSIONS.index(version)


def spanned(text, version):
    """The part of `1.4: a; 1.5: b` that holds in a version."""
    if not re.match(r"\d\.\d", text):
        return text
    found = None
    for part in text.split("; "):
        since, value = part.split(": ", 1)
        if rank(since) <= rank(version):
            found = value
    return found


class Table:
    def __init__(self):
        self.elements, self.words = {}, {}
        for path in sorted((ROOT / "schemas/opendrive").glob("*.toml")):
            part = tomllib.loads(path.read_text())
            for element in part.get("element", []):
                self.elements[element["name"]] = element
            for words in part.get("words", []):
                self.words[words["name"]] = words["words"]

    def has(self, entry, version):
        return rank(entry.get("since", "1.4")) <= rank(version) <= rank(entry.get("until", "1.9"))

    def value(self, kind, version, number):
        """A value of a type. `number` makes identifiers differ."""
        kind = spanned(kind, version)
        name, _, rest = kind.partition(" ")
        if name == "words":
            return next((word["word"] for word in self.words[rest.split()[0]] if self.has(word, version)), f"n{number}")
        if "=" in rest and not rest.startswith((">", "!", "<")):
            return rest.lstrip("=")
        return {
            "text": f"n{number}",
            "boolean": "true",
            "xs_boolean": "true",
            "yes_no": "yes",
            "country": "DEU",
            "speed_limit": "10",
            "lane_speed_limit": "10",
        }.get(name, "1")

    def documents(self, version):
        """Documents that together have every element and attribute of a version, each choice and variant in one."""
        for turn in range(self.turns(version)):
            self.numbers = itertools.count(1)
            root = ElementTree.Element("OpenDRIVE")
            self.fill(root, self.elements["OpenDrive"], version, turn, 0, ())
            yield root

    def turns(self, version):
        def width(element):
            chosen = [child for child in element.get("children", []) if "choice" in child and self.has(child, version)]
            return max(len(chosen), len(element.get("variants", [])), 1)

        return max(width(element) for element in self.elements.values())

    def fill(self, node, element, version, turn, variant, types, path=()):
        known = {word["word"] for words in self.words.values() for word in words if self.has(word, version)}
        variants = [kind for kind in element.get("variants", []) if kind in known or kind == "default"]
        here = variants[turn % len(variants)] if variants else None
        for attribute in element.get("attributes", []):
            if not self.has(attribute, version) or (attribute.get("when") and here not in attribute["when"]):
                continue
            value = self.value(attribute["type"], version, next(self.numbers))
            if node.tag == "lane" and attribute["name"] == "id" and "right" in path:
                value = "-1"
            if node.tag == "header" and attribute["name"] == "version":
                value = "1.00"
            if attribute["name"] == "type" and here and "words" in attribute["type"]:
                value = here
            node.set(attribute["name"], value)
        children = [child for child in element.get("children", []) if self.has(child, version)]
        children = [child for child in children if not child.get("when") or here in child["when"]]
        choices = [child for child in children if "choice" in child]
        chosen = choices[turn % len(choices)] if choices else None
        for child in sorted(children, key=lambda child: child["order"]):
            if (child in choices and child is not chosen) or types.count(child["type"]) > 0:
                continue
            low = int(spanned(child["occurs"], version).split("..")[0])
            for _ in range(max(low, 1)):
                self.fill(ElementTree.SubElement(node, child["name"]), self.elements[child["type"]], version, turn, here, types + (child["type"],), path + (child["name"],))
        if element.get("content"):
            node.text = "text"

    def types(self, root):
        """Name of the type of each element of a document."""
        found = {root: "OpenDrive"}
        for element in root.iter():
            children = {child["name"]: child["type"] for child in self.elements.get(found.get(element), {}).get("children", [])}
            for node in element:
                if isinstance(node.tag, str) and node.tag.rpartition("}")[2] in children:
                    found[node] = children[node.tag.rpartition("}")[2]]
        return found

    def attributes_of(self, kind):
        return self.elements.get(kind, {}).get("attributes", [])

    def words_of(self, kind, attribute):
        """Words of all versions that an attribute may have."""
        for entry in self.attributes_of(kind):
            if entry["name"] == attribute and (found := re.search(r"words (\w+)", entry["type"])):
                return [word["word"] for word in self.words[found.group(1)]]
        return []

    def foreign_attributes(self, kind, version):
        """Attributes that another version has, with a value."""
        for entry in self.attributes_of(kind):
            if not self.has(entry, version):
                other = entry.get("since", "1.4") if rank(entry.get("since", "1.4")) > rank(version) else entry.get("until")
                yield entry["name"], self.value(entry["type"], other, 1)

    def children_of(self, kind):
        """Names of children of any version."""
        return [child["name"] for child in self.elements.get(kind, {}).get("children", [])] + ["userData", "dataQuality"] if kind else []
