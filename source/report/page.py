# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""One self-contained HTML page: one column, tables and pictures within, nothing from a network."""
import base64
from html import escape

STYLE = """
:root { --ink: #1c2126; --soft: #5a646e; --line: #d5dbe1; --pale: #f3f6f9; --mark: #0072b2; }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: #fff; line-height: 1.5;
       font: 16px/1.5 system-ui, "Segoe UI", "Liberation Sans", Arial, sans-serif; }
main { max-width: 52rem; margin: 0 auto; padding: 1.5rem 1rem 4rem; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 .4rem; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 .6rem; padding-top: .5rem; border-top: 2px solid var(--line); }
h3 { font-size: 1.02rem; margin: 1.6rem 0 .4rem; }
p { margin: .5rem 0; max-width: 46rem; }
.soft, figcaption, .caption { color: var(--soft); font-size: .875rem; }
nav { background: var(--pale); padding: .6rem 1rem; border-radius: .4rem; margin: 1rem 0; font-size: .9rem; }
nav a { display: inline-block; margin-right: 1.1rem; padding: .15rem 0; }
a { color: var(--mark); }
.wide { overflow-x: auto; }
/* Shadows at the sides to which a wide table goes on. */
.table { background: linear-gradient(to right, #fff 30%, #fff0) 0 0 / 2.5rem 100% local,
    linear-gradient(to left, #fff 30%, #fff0) 100% 0 / 2.5rem 100% local,
    linear-gradient(to right, #1c212640, #1c212600) 0 0 / .8rem 100% scroll,
    linear-gradient(to left, #1c212640, #1c212600) 100% 0 / .8rem 100% scroll; background-repeat: no-repeat; }
table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; margin: .6rem 0; }
.caption { margin: 1rem 0 0; }
th, td { text-align: left; padding: .25rem .9rem .25rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
td.number, th.number { text-align: right; }
td.number { white-space: nowrap; }
td:nth-child(-n+2):not(.number) { min-width: 6.5rem; }
td.long { min-width: 16rem; }
thead th { border-bottom: 2px solid var(--soft); font-weight: 600; }
figure { margin: 1.2rem 0; }
figure img { width: 100%; height: auto; display: block; }
figure input { position: absolute; opacity: 0; }
figure input:focus-visible + img { outline: 2px solid var(--mark); }
@media (max-width: 48rem) { figure input:checked + img { width: auto; min-width: 48rem; } figure label { cursor: zoom-in; } }
.good { color: #00654a; font-weight: 600; white-space: nowrap; }
.bad { color: #a33c00; font-weight: 600; white-space: nowrap; }
.open { color: var(--soft); white-space: nowrap; }
.alarm { border-left: 4px solid #d55e00; background: #fdf3ec; padding: .5rem .9rem; }
@media print {
  @page { size: A4; margin: 16mm 14mm; }
  body { font-size: 10pt; } main { max-width: none; padding: 0; } nav { display: none; }
  figure, tr { break-inside: avoid; } h2, h3 { break-after: avoid; }
  figure input:checked + img, figure img { min-width: 0; width: auto; max-width: 100%; max-height: 125mm; } .wide { overflow: visible; } a { color: inherit; text-decoration: none; }
}
"""

MARKS = {"agrees": ("good", "&#10003; agrees"), "differs": ("bad", "&#10007; differs"),
         "met": ("good", "&#10003; met"), "not met": ("bad", "&#10007; not met"),
         "not judged": ("open", "&ndash; not judged")}
MEDIA = {".svg": "image/svg+xml", ".png": "image/png"}


def format_number(value, digits=5):
    """Digits as one reads them: no exponent between 1e-4 and 1e7; a dash for what is no number."""
    if value is None or value != value:
        return "–"
    if isinstance(value, int):
        return f"{value:,}".replace(",", "\u202f")
    text = f"{value:.{digits}g}"
    if "e" in text and 1e-4 <= abs(value) < 1e7:
        text = f"{value:.0f}"
    return text.replace("-", "\u2212", 1) if text.startswith("-") else text


class Page:
    """Parts are appended in reading order; text() is the whole page."""

    def __init__(self, title, subtitle):
        self.title, self.subtitle = title, subtitle
        self.parts, self.sections, self.n_pictures = [], [], 0

    def section(self, title):
        self.sections.append(title)
        self.parts.append(f'<h2 id="section-{len(self.sections)}">{escape(title)}</h2>')

    def subsection(self, title):
        self.parts.append(f"<h3>{escape(title)}</h3>")

    def paragraph(self, text, kind=""):
        attribute = f' class="{kind}"' if kind else ""
        self.parts.append(f"<p{attribute}>{escape(text)}</p>")

    def table(self, header, rows, caption=""):
        """Cells: numbers, texts; a text that is a verdict is marked."""
        if not rows:
            return
        numeric = [all(isinstance(row[k], (int, float, type(None))) for row in rows)
                   for k in range(len(header))]
        # Not the table's own caption: that would be as wide as the table.
        caption = f'<p class="caption">{escape(caption)}</p>' if caption else ""
        lines = [caption, '<div class="wide table"><table><thead><tr>']
        lines += [f"<th{' class=number' if n else ''}>{escape(h)}</th>" for h, n in zip(header, numeric)]
        lines.append("</tr></thead><tbody>")
        lines += ["<tr>" + "".join(map(self._cell, row)) + "</tr>" for row in rows]
        self.parts.append("".join(lines + ["</tbody></table></div>"]))

    @staticmethod
    def _cell(value):
        if isinstance(value, str):
            kind, text = MARKS.get(value, ("long" if len(value) > 40 else "", escape(value)))
            return f'<td class="{kind}">{text}</td>' if kind else f"<td>{text}</td>"
        return f'<td class="number">{format_number(value)}</td>'

    def picture(self, path, caption, data=None):
        """A .svg or .png within the page, on a narrow screen larger when touched; `data`: name of the
        file with its numbers."""
        self.n_pictures += 1
        code = base64.b64encode(path.read_bytes()).decode()
        data = f' Data: <code>{escape(data)}</code>.' if data else ""
        self.parts.append(
            f'<figure><div class="wide"><label><input type="checkbox" aria-label="larger">'
            f'<img alt="{escape(caption)}" src="data:{MEDIA[path.suffix]};base64,{code}"></label></div>'
            f"<figcaption>{escape(caption)}{data}</figcaption></figure>")

    def text(self):
        links = "".join(f'<a href="#section-{k + 1}">{escape(title)}</a>'
                        for k, title in enumerate(self.sections))
        return ("<!DOCTYPE html>\n"
                "<!-- Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: "
                "LGPL-2.1-or-later -->\n"
                '<html lang="en"><head><meta charset="utf-8">'
                '<meta name="viewport" content="width=device-width, initial-scale=1">'
                f"<title>{escape(self.title)}</title><style>{STYLE}</style></head><body><main>"
                f"<h1>{escape(self.title)}</h1><p class=soft>{escape(self.subtitle)}</p>"
                f"<nav>{links}</nav>" + "\n".join(self.parts) + "</main></body></html>\n")
