#!/usr/bin/env python3
"""For docs/build. `site.py sidebar INDEX` writes mdBook's SUMMARY.md from the headings and lists of the index; `site.py folders SITE` gives folders
without a page one that lists their files; `site.py links SITE` proves that every link inside the site leads somewhere, to headings too.

`site.py run [--with LANGUAGE] PAGE...` runs the pages: their blocks of `sh` in order, and compares what they write with the block of `text` behind;
there … stands for anything. mapd and the examples must be in PATH. LANGUAGE adds its blocks: `c++` those of `sh c++`, where pkg-config knows mapd;
`py` those of `py`, by python3, with the module mapd."""

import html
import html.parser
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse


def sidebar(index):
    """Sections are parts, list items are pages; what is no page stays out, and so does a page that was listed before."""
    print("# Summary\n\n[mapd](index.md)\n[All pages](docs/index.md)")
    seen = set()
    for line in pathlib.Path(index).read_text().splitlines():
        if line.startswith("## "):
            print(f"\n# {line[3:]}\n")
        item = re.match(r"- ((, )?\[[^]]+\]\([^)]+\))+", line)
        for target in re.findall(r"\(([^)]+)\)", item[0]) if item else []:
            path = urllib.parse.urljoin("docs/", target)
            if path.endswith(".md") and path not in seen:
                seen.add(path)
                print(f"- [{title(path)}]({path})")
                for part in sorted(pathlib.Path(path).with_suffix("").glob("*.md")):
                    print(f"  - [{title(part)}]({part})")


def title(path):
    for line in pathlib.Path(path).read_text().splitlines():
        if line.startswith("# "):
            return line[2:].strip()
    sys.exit(f"{path} has no title")


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.ids, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.ids.update(value for name, value in attributes.items() if name in ("id", "name") and value)
        link = attributes.get("href") or attributes.get("src")
        if link and tag in ("a", "img", "link", "script"):
            self.links.append(link)


def folders(site):
    site = pathlib.Path(site)
    for folder in [path for name in ("examples", "schemas", "docs") for path in [site / name, *(site / name).rglob("*")]]:
        if not folder.is_dir() or (folder / "index.html").exists():
            continue
        names = sorted(path.name + "/" * path.is_dir() for path in folder.iterdir())
        rows = "".join(f'<li><a href="{html.escape(name)}">{html.escape(name)}</a></li>' for name in names)
        title = html.escape(str(folder.relative_to(site)))
        (folder / "index.html").write_text(f"<!doctype html><meta charset=utf-8><title>{title}</title><h1>{title}</h1><ul>{rows}</ul>\n")


def links(site):
    site = pathlib.Path(site).resolve()
    # rustdoc checks its own.
    pages = {path: Page(path.read_text()) for path in site.rglob("*.html") if "api" not in path.relative_to(site).parts[:1]}
    wrong, count = [], 0
    for path, page in pages.items():
        if path.name in ("print.html", "404.html", "toc.html"):
            continue
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            count += 1
            leads = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if leads.is_dir():
                leads = leads / "index.html"
            found = leads.exists() and leads.is_relative_to(site)
            if found and parts.fragment and leads in pages:
                found = urllib.parse.unquote(parts.fragment) in pages[leads].ids
            if not found:
                wrong.append(f"{path.relative_to(site)}: {link}")
    print("\n".join(wrong) or f"{count} links on {len(pages)} pages lead somewhere")
    sys.exit(bool(wrong))


def run(*pages):
    kinds = {"sh"}
    if pages[0] == "--with":
        kinds.add({"c++": "sh c++", "py": "py"}[pages[1]])
        pages = pages[2:]
    for page in pages:
        blocks, wanted = [], False
        for kind, text in re.findall(r"^```(sh|sh c\+\+|py|text)\n(.*?)^```", pathlib.Path(page).read_text(), re.S | re.M):
            # What a block writes belongs to it.
            wanted = kind in kinds or (kind == "text" and wanted)
            if wanted:
                blocks.append((kind, text))
        with tempfile.TemporaryDirectory() as folder:
            run_in(pathlib.Path(folder), page, blocks)
        print(f"{page}: {sum(kind in kinds for kind, _ in blocks)} blocks do what the page says")


def run_in(folder, page, blocks):
    """All in one shell, so that a block goes on where the one before ended; what it has started ends with it."""
    (folder / "examples").symlink_to(pathlib.Path("examples").resolve())
    commands = [f"python3 - <<'PAGE'\n{text}PAGE" if kind == "py" else text for kind, text in blocks if kind != "text"]
    script = ["set -e", "trap 'kill $(jobs -p) 2>/dev/null || true; wait' EXIT"]
    for number, text in enumerate(commands):
        script += [f"exec >written.{number} 2>&1", text]
    environment = {**os.environ, "MAPD_PREFIX": f"page{os.getpid()}_", "MAPD_CACHE": str(folder / "cache"), "RUST_BACKTRACE": "0"}
    ended = subprocess.run(["bash", "-c", "\n".join(script)], cwd=folder, env=environment, stdin=subprocess.DEVNULL, timeout=120)
    written = [path.read_text() if (path := folder / f"written.{number}").exists() else "" for number in range(len(commands))]
    if ended.returncode != 0:
        sys.exit(f"{page}: a block ends with {ended.returncode}: {''.join(written)}")
    number = -1
    for kind, text in blocks:
        if kind != "text":
            number += 1
            continue
        pattern = ".*?".join(re.escape(part) for part in text.strip().split("…"))
        if not re.fullmatch(pattern, written[number].strip(), re.S):
            sys.exit(f"{page}: expected\n{text}found\n{written[number]}")


if __name__ == "__main__":
    jobs = {"sidebar": sidebar, "folders": folders, "links": links, "run": run}
    if len(sys.argv) < 3 or sys.argv[1] not in jobs:
        sys.exit(__doc__)
    jobs[sys.argv[1]](*sys.argv[2:])
