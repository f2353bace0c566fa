# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The page as text: everything is in it, nothing is fetched."""

import base64
import html
import json
import pathlib

from . import charts, citation, dygraphs
from .laws import judge_laws
from .resolution import judge_resolution
from .verdict import BROKEN, LOOK

HERE = pathlib.Path(__file__).resolve().parent
#: No address is opened, whatever a page contains.
POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:"


def escape(text):
    return html.escape(str(text))


def file(name):
    """Text of a file beside this one."""
    return (HERE / name).read_text(encoding="utf-8")


def json_script(identifier, data):
    """Data that a script of the page reads; nothing in it ends the element."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    return f'<script type="application/json" id="{identifier}">{text}</script>'


def table(rows, head=()):
    """Cells are HTML already; numbers are set to the right."""
    lines = ["".join(f"<th>{escape(cell)}</th>" for cell in head)] if head else []
    for row in rows:
        lines.append(
            "".join(cell if cell.startswith("<td") else f"<td>{cell}</td>" for cell in row)
        )
    return "<table>" + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"


def bullets(texts):
    return "<ul>" + "".join(f"<li>{escape(text)}</li>" for text in texts) + "</ul>"


def verdict_rows(verdicts):
    rows = []
    for verdict in verdicts:
        kind = verdict.state.replace(" ", "-")
        mark = f'<span class="verdict {kind}">{escape(verdict.state)}</span>'
        rows.append([escape(verdict.name), mark, escape(verdict.text)])
    return table(rows)


def headline(verdicts):
    """The worst of the verdicts in a sentence."""
    for state, text in ((BROKEN, "Broken: {}. Do not trust this run."), (LOOK, "Look at: {}.")):
        found = [verdict.name for verdict in verdicts if verdict.state == state]
        if found:
            return text.format(", ".join(found))
    return "All laws that the tables can judge are kept, and mesh and steps carry the contact."


def and_advice(warnings):
    """What the headline adds."""
    if not warnings:
        return ""
    return f" The run has {len(warnings)} warning{'s' if len(warnings) > 1 else ''}: see Advice."


def summary_part(run):
    """Verdicts, advice, and the program's own summary."""
    laws, resolution = judge_laws(run), judge_resolution(run)
    first = headline(laws + resolution) + and_advice(run.log.warnings)
    text = f'<p id="headline"><strong>{escape(first)}</strong></p>'
    text += f'<h3>Laws</h3><div id="laws">{verdict_rows(laws)}</div>'
    text += f'<h3>Resolution</h3><div id="resolution">{verdict_rows(resolution)}</div>'
    text += '<p class="faint">Laws are judged by the tables where the scheme proves them. What '
    text += "another scheme does is an error of its discretisation.</p>"
    advice = [*run.log.warnings, *run.log.notes]
    text += "<h3>Advice</h3>" + (bullets(advice) if advice else "<p>The run has no warnings.</p>")
    if run.log.summary:
        lines = "\n".join(run.log.summary)
        text += f"<h3>The program's summary</h3><pre>{escape(lines)}</pre>"
    return text


def view_part(view, problem):
    """The bodies, or why there are none."""
    if view is None:
        return f"<p>{escape(problem)}. Fields are written with <code>Output/VTU = true</code>.</p>"
    notes = [*view.notes, *view.problems]
    return (
        file("view.html")
        + (bullets(notes) if notes else "")
        + json_script("view-data", view.data())
    )


def curves_part(sections):
    """A place for each table, the first one open."""
    text = '<p class="faint">Drag along an axis to zoom, in all curves at once; with Shift to '
    text += "move; double click to see everything again.</p>"
    for number, (title, _) in enumerate(sections):
        text += (
            f'<details data-curves="{number}"{"" if number else " open"}>'
            f"<summary>{escape(title)}</summary>"
            f'<div class="curves" data-missing="{escape(dygraphs.MISSING)}"></div></details>'
        )
    data = [
        {"title": title, "charts": [chart.data() for chart in found]} for title, found in sections
    ]
    return text + json_script("curve-data", data)


def pictures_part(pictures):
    text = ""
    for path in pictures:
        data = base64.b64encode(path.read_bytes()).decode("ascii")
        name = path.stem.replace("_", " ")
        text += (
            f"<details{' open' if path.stem == 'bodies' else ''}><summary>{escape(name)}</summary>"
            f'<img alt="{escape(name)}" src="data:image/png;base64,{data}"></details>'
        )
    return text or "<p>None could be drawn.</p>"


def scene_part(run):
    facts = [[escape(name), escape(value)] for name, value in run.log.facts]
    text = f"<p>{escape(run.log.program)}</p>" + table(facts)
    for name, content in (("scene.prm", run.scene), ("parameters.prm", run.parameters)):
        if content:
            opened = " open" if name == "scene.prm" else ""
            text += f"<details{opened}><summary>{name}</summary><pre>{escape(content)}</pre>"
            text += "</details>"
    return text


def timers_part(run):
    if not run.log.timers:
        return "<p>log.txt has no table of times.</p>"
    rows = [
        [escape(name), *(f'<td class="number">{value}</td>' for value in (calls, f"{seconds:.4g}"))]
        for name, calls, seconds in sorted(run.log.timers, key=lambda timer: -timer[2])
    ]
    whole = f"<p>{run.log.wall_time:.4g} s in all; means over the processes.</p>"
    return whole + table(rows, ("section", "calls", "seconds"))


def make_page(run, view, view_problem, pictures):
    """The page of a run.

    view is a View or None, then view_problem says why; pictures are paths of PNG files.
    """
    style, program = dygraphs.embedded()
    parts = {
        "Summary": summary_part(run),
        "View": view_part(view, view_problem),
        "Curves": curves_part(charts.sections(run)),
        "Pictures": pictures_part(pictures),
        "Scene": scene_part(run),
        "Times": timers_part(run),
        "Cite": "".join(f"<pre>{escape(entry)}</pre>" for entry in citation.entries(run)),
    }
    if run.problems:
        parts["Missing"] = bullets(run.problems)
    title = f"signorini: {run.folder.resolve().name}"
    links = "".join(f'<a href="#{name}">{name}</a>' for name in parts)
    body = "".join(f'<h2 id="{name}">{name}</h2>\n{text}\n' for name, text in parts.items())
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        '<meta name="viewport" content="width=device-width">'
        f"<title>{escape(title)}</title>\n"
        f"<style>\n{style}\n{file('page.css')}</style></head><body>\n"
        f"<h1>{escape(title)}</h1>\n<nav>{links}</nav>\n{body}"
        f"<script>{program}</script>\n<script>{file('curves.js')}</script>\n"
        f"<script>{file('viewer.js')}</script>\n</body></html>\n"
    )
