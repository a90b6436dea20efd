"""Other validators: libxml2 for OpenDRIVE 1.4 to 1.7, xmlschema (XSD 1.1) from 1.8 on, with the schemas that the package
`asam-qc-opendrive` carries. Both say what is wrong as (line, kind, attribute, message)."""

import importlib.util
import os
import re
from pathlib import Path

import xmlschema
from lxml import etree

FILES = {
    "1.4": "1.4/OpenDRIVE_1.4H.xsd",
    "1.5": "1.5/OpenDRIVE_1.5M.xsd",
    "1.6": "1.6.1/opendrive_16_core.xsd",
    "1.7": "1.7.0/opendrive_17_core.xsd",
    "1.8": "1.8.0/OpenDRIVE_Core.xsd",
}


def folder():
    if given := os.environ.get("QC_OPENDRIVE"):
        return Path(given) / "schema"
    spec = importlib.util.find_spec("qc_opendrive")
    if spec is None:
        raise SystemExit("expected the package asam-qc-opendrive, found none: see README.md")
    return Path(spec.submodule_search_locations[0]) / "schema"


def validator(version):
    return (Xsd11 if version >= "1.8" else Libxml2)(folder() / FILES[version])


def namespace(path):
    return etree.parse(str(path)).getroot().get("targetNamespace")


def structural(findings):
    """Keys and references between elements are matters of the rules behind the reader."""
    return [finding for finding in findings if finding[1] != "key"]


def line_of_parent(element):
    parent = element.getparent()
    return element.sourceline if parent is None else parent.sourceline


class Libxml2:
    def __init__(self, path):
        self.schema = etree.XMLSchema(etree.parse(str(path)))
        self.namespace = namespace(path)

    def findings(self, tree):
        """`tree` has each start tag on a line of its own."""
        if self.schema.validate(tree):
            return []
        elements = {element.sourceline: element for element in tree.iter(etree.Element)}
        return structural(self.finding(error, elements) for error in self.schema.error_log)

    def finding(self, error, elements):
        attribute = re.search(r"attribute '([^']+)'", error.message)
        attribute = attribute.group(1) if attribute else ""
        line = error.line
        match error.type_name:
            case "SCHEMAV_CVC_COMPLEX_TYPE_3_2_1" | "SCHEMAV_CVC_COMPLEX_TYPE_3_2_2":
                kind = "unknown attribute"
            case "SCHEMAV_CVC_COMPLEX_TYPE_4" | "SCHEMAV_CVC_COMPLEX_TYPE_3_2_4":
                kind = "missing attribute"
            case "SCHEMAV_CVC_COMPLEX_TYPE_2_1" if "Character" in error.message:
                kind = "text"
            case "SCHEMAV_ELEMENT_CONTENT" | "SCHEMAV_CVC_COMPLEX_TYPE_2_1":
                kind = "content"
                if "Missing child" not in error.message and "not allowed" not in error.message and line in elements:
                    line = line_of_parent(elements[line])
            case "SCHEMAV_CVC_COMPLEX_TYPE_2_3" | "SCHEMAV_CVC_COMPLEX_TYPE_2_2" | "SCHEMAV_CVC_ELT_3_2_2":
                kind = "text"
            case "SCHEMAV_CVC_IDC":
                kind = "key"
            case "SCHEMAV_CVC_ELT_1":
                kind = "root"
            case _:
                kind = "value"
        return line, kind, attribute, error.message


class Xsd11:
    def __init__(self, path):
        self.schema = xmlschema.XMLSchema11(str(path))
        self.namespace = namespace(path)

    def findings(self, tree):
        return structural(map(self.finding, self.schema.iter_errors(tree)))

    def finding(self, error):
        line = error.elem.sourceline if error.elem is not None else 0
        reason = error.reason or str(error)
        attribute = re.search(r"^'(\w+)' attribute", reason) or re.search(r"attribute '?(?:\{[^}]*\})?([\w:]+)'?", reason) or re.search(r"^(\w+)='", reason)
        attribute = (attribute.group(1) if attribute else "").replace("=", "")
        if isinstance(error, xmlschema.XMLSchemaChildrenValidationError):
            kind, attribute = "content", ""
        elif "missing required attribute" in reason:
            kind = "missing attribute"
        elif "attribute not allowed" in reason or "not allowed for element" in reason and "attribute" in reason:
            kind = "unknown attribute"
        elif "character data" in reason or "must be empty" in reason:
            kind = "text"
        elif "duplicated" in reason or "not found for" in reason or "key" in reason and "field" in reason:
            kind = "key"
        elif "assertion" in reason:
            kind = "assertion"
        else:
            kind = "value"
        return line, kind, attribute, reason
