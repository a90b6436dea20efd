// The list of what was found in the file: a pane of its own, so that it stays while the sheet shows one thing after the other.

class List extends Panel {
  // Shows parts that are left out, as many as there are in all.
  leftOut(parts, count) {
    const rows = parts.map(part => [part.name, part.rule, part.message, `${part.file ? `${part.file}:` : ""}${part.line}:${part.column}`]);
    const note = count > parts.length ? `The first ${parts.length} of ${count}.` : "These parts of the file have errors and are not in the map.";
    const table = this.table(["part", "rule", "why", "line:column"], rows);
    this.rows = [...table.tBodies[0].rows].map((row, i) => [parts[i].name.link, row]);
    this.open(`Left out: ${count}`, element("div", { className: "body" }, element("p", { className: "soft", textContent: note }), table));
  }

  // Marks the row of what the sheet shows.
  mark(link) {
    for (const [one, row] of this.rows ?? []) row.ariaCurrent = one.kind === link?.kind && one.row === link?.row ? "true" : null;
  }

  hide() {
    super.hide();
    this.rows = [];
  }
}
