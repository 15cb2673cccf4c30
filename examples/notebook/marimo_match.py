"""`marimo edit examples/notebook/marimo_match.py`: the widget in a marimo notebook."""

import marimo

app = marimo.App()


@app.cell
def _():
    import math

    import marimo as mo
    from thinshell_widget import ThinShellMatch

    return ThinShellMatch, math, mo


@app.cell
def _(math):
    def ellipse(a, b):
        angles = [2 * math.pi * i / 120 for i in range(120)]
        return [[[0.5 + a * math.cos(t), 0.5 + b * math.sin(t)] for t in angles]]

    templates = {"long": ellipse(0.31, 0.17), "round": ellipse(0.3, 0.3)}
    return ellipse, templates


@app.cell
def _(mo, templates):
    shape = mo.ui.dropdown(list(templates), value="long", label="Target")
    shape
    return (shape,)


@app.cell
def _(ThinShellMatch, ellipse, mo, templates):
    match = mo.ui.anywidget(
        ThinShellMatch(
            reference=ellipse(0.15, 0.15), template=templates["long"], settings={"finest": 6}, points=[[0.65, 0.5]]
        )
    )
    match
    return (match,)


@app.cell
def _(match, shape, templates):
    # Into the widget: it matches anew.
    match.widget.template = templates[shape.value]
    return


@app.cell
def _(match, mo):
    # Out of it: whenever a match is final, this is computed again.
    if match.report:
        x, y = match.mapped[0]
        said = f"Stretch {match.report['stretch']['mean']:.2f}; the right end goes to {x:.2f}, {y:.2f}"
    else:
        said = match.problem or "Matching …"
    mo.md(said)
    return


if __name__ == "__main__":
    app.run()
