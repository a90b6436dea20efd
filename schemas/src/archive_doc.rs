//! The tables' parts of `docs/format.md`: the archive's and the overlay's.

use crate::archive::{Layout, size_of};
use anyhow::{Context, Result};
use std::fmt::Write as _;

const END: &str = "<!-- end of tables -->\n";

/// Replaces what stands between the mark of a source and the next end.
pub(crate) fn splice(page: &str, source: &str, layout: &Layout) -> Result<String> {
    let mark = format!("<!-- tables: written from schemas/{source} -->\n");
    let start = page.find(&mark).with_context(|| format!("docs/format.md lacks {mark:?}"))?;
    let start = start + mark.len();
    let end = page[start..].find(END).context("docs/format.md lacks the mark where tables end")?;
    Ok(format!("{}{}{}", &page[..start], render(layout)?, &page[start + end..]))
}

fn render(layout: &Layout) -> Result<String> {
    let mut out = format!("\nFormat {}.\n", layout.format);
    for feature in &layout.features {
        let ([major, minor, patch], name) = (feature.release, &feature.name);
        let _ = write!(
            out,
            "\nBit {} of `must_understand`, `{name}`, from {major}.{minor}.{patch} on: {}\n",
            feature.bit, feature.doc
        );
    }
    for table in &layout.tables {
        let _ = write!(out, "\n### {}. `{}`\n\n{}\n", table.number, table.name, table.doc);
        let need = if table.required { "Required" } else { "Optional" };
        let parallel = table.parallel.as_ref().map(|to| format!(", a row for each of `{to}`"));
        let parallel = parallel.unwrap_or_default();
        let _ = write!(out, "\n{need}{parallel}, row id `{:016x}`.\n", table.row_id());
        if let Some(scalar) = &table.scalar {
            let to = table.to.as_ref().map(|to| format!(" → `{to}`")).unwrap_or_default();
            let _ =
                write!(out, "\nElements: `{scalar}`{to}, {} bytes each.\n", table.element_bytes());
            continue;
        }
        if let Some(other) = &table.fields_of {
            let _ = write!(out, "\nRows as in `{other}`, {} bytes each.\n", table.element_bytes());
            continue;
        }
        let _ = write!(
            out,
            "\n{} bytes a row.\n\n| at | field | type | unit | meaning |\n|---|---|---|---|---|\n",
            table.element_bytes()
        );
        let mut offset = 0;
        for f in &table.fields {
            let to = f.to.as_ref().map(|to| format!(" → `{to}`")).unwrap_or_default();
            let to = match &f.count {
                Some(count) => format!("{to} × `{count}`"),
                None => to,
            };
            let optional = if f.optional { " or none" } else { "" };
            let _ = writeln!(
                out,
                "| {offset} | `{}` | {}{to}{optional} | {} | {} |",
                f.name,
                f.kind,
                f.unit.as_deref().unwrap_or(""),
                f.doc.replace('|', "\\|")
            );
            offset += size_of(&f.kind)?.bytes;
        }
    }
    out.push('\n');
    Ok(out)
}
