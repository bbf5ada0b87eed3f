# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""contrib/site: all pages, found by the search, with formulas and pictures, and nothing from a network. Exit code 77: Sphinx
and the like are missing."""
import html
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from urllib.parse import unquote

ROOT = Path(__file__).resolve().parents[2]
failures = []


def check(what, holds):
    if not holds:
        print(f"FAILED: {what}")
        failures.append(what)


def check_page(page, site):
    text = page.read_text()
    name = page.relative_to(site)
    for tag in re.findall(r"<(?:script|link|img|iframe)\b[^>]*>", text):
        for address in re.findall(r'(?:src|href)="([^"]*)"', tag):
            target = unquote(html.unescape(address)).split("?")[0].split("#")[0]
            check(f"{name}: {address} is part of the site",
                  address.startswith("data:") or (not re.match(r"(\w+:)?//", address) and (page.parent / target).exists()))
    for address in re.findall(r'<a\b[^>]*href="([^"]*)"', text):
        target, _, anchor = unquote(html.unescape(address)).partition("#")
        if re.match(r"\w+:", target):
            continue
        linked = page.parent / target if target else page
        check(f"{name}: link to {address}", linked.is_file())
        if anchor and linked.is_file() and linked.suffix == ".html" and "api" not in linked.relative_to(site).parts:
            check(f"{name}: anchor of {address}", f'id="{anchor}"' in linked.read_text())
    shown = re.sub(r'<(div|span) class="math.*?</\1>|<pre.*?</pre>|<code.*?</code>|<script.*?</script>', "", text, flags=re.S)
    check(f"{name}: no formula is left as text", "$$" not in shown and "\\frac" not in shown)


def main():
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder) / "site"
        done = subprocess.run([ROOT / "contrib/site", site], capture_output=True, text=True)
        if done.returncode == 77:
            print(done.stderr)
            return 77
        check(f"the site is built: {done.stderr}", done.returncode == 0)
        if failures:
            return 1
        sources = [ROOT / f"{name}.md" for name in ("README", "CHANGELOG", "CONTRIBUTING")]
        sources += [page for page in (ROOT / "doc").rglob("*.md") if "site" not in page.relative_to(ROOT).parts]
        navigation = (site / "index.html").read_text()
        for source in sources:
            name = source.relative_to(ROOT).with_suffix(".html").as_posix()
            check(f"{name} is there and in the navigation", (site / name).is_file() and f'href="{name}"' in navigation)
            formulas = len(re.findall(r"^\$\$$", source.read_text(), re.M)) // 2
            check(f"{name} has {formulas} formulas", (site / name).read_text().count('<div class="math notranslate') == formulas)
        for page in [*site.glob("*.html"), *(site / "doc").rglob("*.html")]:
            check_page(page, site)
        index = (site / "searchindex.js").read_text()
        for word in ("windup", "penalti", "glossari"):  # stems
            check(f"the search knows {word}", word in index)
        check("MathJax is part of the site", (site / "_static/mathjax/jax/output/CommonHTML/jax.js").is_file())
        check("classes are described", (site / "api/index.html").is_file())
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
