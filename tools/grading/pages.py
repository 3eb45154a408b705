"""The pages that grading writes. They load nothing, neither from the net nor from elsewhere."""

import html
import io
import re

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem;
  color: #222; background: #fff }
h1 { font-size: 1.5rem } h2 { font-size: 1.15rem; margin: 2rem 0 .3rem }
pre { background: #f4f4f4; padding: .7rem; overflow-x: auto; font-size: .85rem; max-height: 24rem }
table { border-collapse: collapse } td, th { border: 1px solid #bbb; padding: .25rem .6rem;
  text-align: left; vertical-align: top } td.n { text-align: right }
.points { font-weight: 600 } .holds { color: #1b6e3c } .fails { color: #a02020 }
.open { color: #8a5a00 } .two { display: grid; grid-template-columns: 1fr 1fr; gap: 1.5rem;
  align-items: start }
.question { background: #f7f7fb; padding: .5rem 1rem } svg { vertical-align: middle }
input { font: inherit } textarea { width: 100%; font: inherit }
@media print { pre { max-height: none } }
"""
LOCKED = "default-src 'none'; style-src 'unsafe-inline'"
SCRIPTED = LOCKED + "; script-src 'unsafe-inline'"
LONGEST_FORMULA, MOST_FORMULAS = 300, 60


def page(title, body, policy=LOCKED):
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        '<meta name="viewport" content="width=device-width">\n'
        f"<title>{html.escape(title)}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
        f"<h1>{html.escape(title)}</h1>\n{body}\n</body>\n</html>\n"
    )


def formula(tex):
    """Return a picture of a formula, or its text where there is none."""
    plain = f"<code>{html.escape(tex)}</code>"
    if len(tex) > LONGEST_FORMULA:
        return plain
    try:
        from matplotlib.mathtext import math_to_image

        tex = re.sub(r"\\[dt]frac", r"\\frac", tex.replace("\n", " "))
        out = io.StringIO()
        math_to_image(f"${tex}$", out, format="svg", dpi=80)
    except Exception:
        return plain
    svg = out.getvalue()
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg[svg.index("<svg") :], flags=re.DOTALL)
    return svg.replace("<svg", f'<svg role="img" aria-label="{html.escape(tex)}"', 1)


def prose(text):
    """Return Markdown as far as it is used in answers: paragraphs, lists, emphasis, formulas."""
    text = text.replace("\x00", "")
    text = re.sub(r"</?(details|summary)>|<!--.*?-->", "", text, flags=re.DOTALL)
    parts = re.split(r"\$\$(.+?)\$\$|\$([^$\n]+?)\$", text, flags=re.DOTALL)
    pieces, formulas = [], []
    for k, part in enumerate(parts):
        if part is None:
            continue
        if k % 3 == 0:
            pieces.append(html.escape(part))
        else:
            known = len(formulas) < MOST_FORMULAS
            formulas.append(formula(part) if known else f"<code>{html.escape(part)}</code>")
            pieces.append(f"\x00{len(formulas) - 1}\x00")  # put in when the text is done
    body = "".join(pieces)
    body = re.sub(r"^#+ (.+)$", r"<strong>\1</strong>", body, flags=re.MULTILINE)
    body = re.sub(r"\*\*(.+?)\*\*", r"<strong>\1</strong>", body)
    body = re.sub(r"(?<!\*)\*([^*\n]+)\*(?!\*)", r"<em>\1</em>", body)
    body = re.sub(r"`([^`\n]+)`", r"<code>\1</code>", body)
    blocks = [block.strip() for block in re.split(r"\n\s*\n", body)]
    body = "\n".join(f"<p>{block.replace(chr(10), '<br>')}</p>" for block in blocks if block)
    return re.sub("\x00(\\d+)\x00", lambda found: formulas[int(found[1])], body)


def inline(text):
    return re.sub(r"^<p>|</p>$", "", prose(text))


def number(x):
    return f"{x:g}"


def feedback(record, material):
    """Return the page of one student for one problem set."""
    rows = [summary_line(record, material)]
    if record.get("unreadable"):
        rows.append(f'<p class="open">Not graded: {html.escape(record["unreadable"])}.</p>')
    for name, part in material.parts.items():
        if record.get("unreadable"):
            break
        points, said, shown = record["parts"].get(name, [None, record.get("failed", ""), ""])
        answer = record["answers"].get(name, {})
        rows.append(f"<h2>{inline(re.sub(r' *[(][^()]*points[^()]*[)]', '', part.title))}</h2>")
        rows.append(verdict(points, said, shown, part))
        if answer.get("touched"):
            shown = answer.get("html") or f"<pre>{html.escape(answer['source'])}</pre>"
            rows.append(f"<details><summary>Your answer</summary>{shown}</details>")
    return page(f"{record['student']}: {material.name}", "\n".join(rows))


def summary_line(record, material):
    got = sum(p[0] for p in record["parts"].values() if p[0] is not None)
    return f'<p class="points">{number(got)} of {number(material.points)} points so far.</p>'


def verdict(points, said, shown, part):
    most = number(part.points)
    if points is None and part.by_hand and not said.startswith("its cell"):
        return f'<p class="open">Waits for a person ({most} points).</p>'
    if points is None:
        return f'<p class="open">Not graded ({most} points): {html.escape(said or "?")}</p>'
    kind = "holds" if points == part.points else "fails"
    text = html.escape(shown or said or ("" if part.by_hand else "It holds."))
    return f'<p><span class="points {kind}">{number(points)} of {most} points.</span> {text}</p>'


def summary(tables, notes):
    """Return the page for the assistant: which parts fail, with what, and what was noticed."""
    body = []
    for name, rows in tables.items():
        body.append(f"<h2>{html.escape(name)}</h2><table><tr><th>part</th><th>holds</th>")
        body.append("<th>fails</th><th>no answer</th><th>open</th><th>most often</th></tr>")
        for title, counts, common in rows:
            cells = "".join(f'<td class="n">{n}</td>' for n in counts)
            often = "<br>".join(f"{n} × {html.escape(text)}" for text, n in common)
            body.append(f"<tr><td>{inline(title)}</td>{cells}<td>{often}</td></tr>")
        body.append("</table>")
    body.append("<h2>What was noticed</h2>")
    body.append("<p>None of it changes a mark. Look at these submissions yourself.</p><table>")
    for who, said in notes:
        body.append(f"<tr><td>{html.escape(who)}</td><td>{html.escape(said)}</td></tr>")
    body.append("</table>")
    return page("Grading", "\n".join(body))


SAVE = """
const KEY = 'prose-marks';
function rows() { return [...document.querySelectorAll('[data-student]')]; }
function cell(text) { return '"' + text.replaceAll('"', '""') + '"'; }
function save() {
  const lines = ['student,set,part,points,comment'];
  for (const row of rows()) {
    const mark = row.querySelector('input').value;
    const said = row.querySelector('textarea').value;
    const d = row.dataset;
    if (mark !== '') lines.push([d.student, d.set, d.part, mark, said].map(cell).join(','));
  }
  const a = document.createElement('a');
  const blob = new Blob([lines.join('\\r\\n') + '\\r\\n'], {type: 'text/csv'});
  a.href = URL.createObjectURL(blob);
  a.download = 'prose.csv';
  a.click();
}
"""


def prose_page(answers, materials, marks):
    """Return the page on which a person enters marks for prose, beside question and rubric."""
    body = [
        "<p>Enter the marks, save, put <code>prose.csv</code> into this folder and run the same "
        "command again: it grades nothing twice.</p>",
        '<p><button onclick="save()">Save prose.csv</button></p>',
    ]
    for (set_name, part_name), found in answers.items():
        part = materials[set_name].parts[part_name]
        body.append(f"<h2>{html.escape(set_name)}: {inline(part.title)}</h2>")
        body.append(f'<div class="two"><div class="question">{prose(part.stub)}</div>')
        body.append(
            f'<div class="question"><strong>Rubric</strong>{prose(part.rubric)}</div></div>'
        )
        for student, shown in found:
            key = (student, set_name, part_name)
            points, said = marks.get(key, ("", ""))
            quoted = [html.escape(str(x), quote=True) for x in (*key, points)]
            body.append(
                '<div class="two" data-student="{0}" data-set="{1}" data-part="{2}"><div>'
                "<h3>{0}</h3>{answer}</div><div><p>Points (of {most}): "
                '<input type="number" min="0" max="{most}" step="0.5" value="{3}"></p>'
                '<textarea rows="3" placeholder="A word to the student">{said}</textarea>'
                "</div></div>".format(
                    *quoted, answer=shown, most=number(part.points), said=html.escape(said)
                )
            )
    body.append(f'<p><button onclick="save()">Save prose.csv</button></p><script>{SAVE}</script>')
    return page("Marks for prose", "\n".join(body), SCRIPTED)
