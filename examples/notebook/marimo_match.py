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
def _(ThinShellMatch, math, mo):
    def ellipse(a, b):
        angles = [2 * math.pi * i / 120 for i in range(120)]
        return [[[0.5 + a * math.cos(t), 0.5 + b * math.sin(t)] for t in angles]]

    match = mo.ui.anywidget(
        ThinShellMatch(reference=ellipse(0.15, 0.15), template=ellipse(0.31, 0.17), settings={"finest": 6}, points=[[0.65, 0.5]])
    )
    match
    return (match,)


@app.cell
def _(match, mo):
    mo.md(f"Stretch {match.report['stretch']['mean']:.2f}; the right end goes to {match.mapped[0]}" if match.report else "Matching …")
    return


if __name__ == "__main__":
    app.run()
