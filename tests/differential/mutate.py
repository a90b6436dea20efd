"""Single mutations of a document: one attribute or one element changed."""

import copy

from lxml import etree

# What an attribute of any type may be changed to.
VALUES = ["", "abc", "-1", "0", "0.5", "1", "2", "1e400", "INF", "NaN", " 1 ", "0x1", "1,5", "4.0+0", "true", "True", "yes", "deu", "Germany"]
TEXT = "stray"


def tag(element):
    return etree.QName(element).localname


def mutations(tree, table, version, seen):
    """(kind, parent, element, attribute, value, document) for everything in the document that was not mutated before."""
    root = tree.getroot()
    types = table.types(root)
    for place, element in enumerate(root.iter(etree.Element)):
        if element is root or (element.getparent() is not root and tag(element.getparent()) in ("userData", "dataQuality")):
            continue
        parent = tag(element.getparent())
        where = (parent, tag(element), types.get(element))

        def fresh(kind, attribute="", value=""):
            key = where + (kind, attribute, value)
            if key in seen:
                return False
            seen.add(key)
            return True

        def change(kind, attribute, value, apply):
            changed = copy.deepcopy(tree)
            target = next(e for at, e in enumerate(changed.getroot().iter(etree.Element)) if at == place)
            apply(target)
            return kind, parent, tag(element), attribute, value, changed

        for attribute, old in element.attrib.items():
            if fresh("drop", attribute):
                yield change("drop", attribute, "", lambda e: e.attrib.pop(attribute))
            if fresh("rename", attribute):
                yield change("rename", attribute, "", lambda e: rename(e, attribute))
            for value in VALUES + table.words_of(types.get(element), attribute):
                if value != old and fresh("value", attribute, value):
                    yield change("value", attribute, value, lambda e: e.set(attribute, value))
        for attribute, value in table.foreign_attributes(types.get(element), version):
            if attribute not in element.attrib and fresh("add", attribute):
                yield change("add", attribute, value, lambda e: e.set(attribute, value))
        for child in table.children_of(types.get(element)):
            if fresh("child", child):
                yield change("child", child, "", lambda e: insert(e, child))
        if fresh("remove"):
            yield change("remove", "", "", lambda e: e.getparent().remove(e))
        if fresh("double"):
            yield change("double", "", "", lambda e: e.addnext(copy.deepcopy(e)))
        if element.getprevious() is not None and fresh("to front"):
            yield change("to front", "", "", lambda e: e.getparent().insert(0, e))
        if element.getnext() is not None and fresh("to end"):
            yield change("to end", "", "", lambda e: e.getparent().append(e))
        if fresh("rename element"):
            yield change("rename element", "", "", lambda e: setattr(e, "tag", e.tag + "X"))
        if fresh("text"):
            yield change("text", "", "", lambda e: e.insert(0, etree.Comment(TEXT)))


def insert(element, name):
    namespace = etree.QName(element).namespace
    child = etree.SubElement(element, f"{{{namespace}}}{name}" if namespace else name)
    if name == "userData":
        child.set("code", "c")
        child.set("value", "v")


def rename(element, attribute):
    items = [(name + "X" if name == attribute else name, value) for name, value in element.attrib.items()]
    element.attrib.clear()
    for name, value in items:
        element.set(name, value)


def lines(tree):
    """The document with each start tag on a line of its own, and the tree that has these lines."""
    for element in tree.getroot().iter(etree.Element):
        if len(element) and not (element.text or "").strip():
            element.text = None
        if not (element.tail or "").strip():
            element.tail = None
    text = etree.tostring(tree, pretty_print=True).replace(f"<!--{TEXT}-->".encode(), TEXT.encode())
    return text, etree.ElementTree(etree.fromstring(text))
