"""The match as a widget: shapes in, the report and phi at points out. `npm run build:element` makes its one file."""

import pathlib

import anywidget
import traitlets

MODULE = pathlib.Path(__file__).parents[2] / "element" / "thin-shell-match.js"


class ThinShellMatch(anywidget.AnyWidget):
    """Loops are lists of points [x, y] in the unit box, y up; a shape is a list of loops."""

    _esm = MODULE

    #: All at once: what the page has behind the # of its address.
    state = traitlets.Unicode("").tag(sync=True)
    reference = traitlets.List().tag(sync=True)
    template = traitlets.List().tag(sync=True)
    #: [x, y, u, v]: a point of the reference and its partner.
    pins = traitlets.List().tag(sync=True)
    settings = traitlets.Dict().tag(sync=True)
    #: Without them as the state says, or the grid and the whole way.
    view = traitlets.Unicode("").tag(sync=True)
    morph = traitlets.Float(None, allow_none=True).tag(sync=True)
    #: Where to ask for phi.
    points = traitlets.List().tag(sync=True)

    #: The numbers of the match of what is given now, empty before; phi at `points`; what is wrong.
    report = traitlets.Dict().tag(sync=True)
    mapped = traitlets.List().tag(sync=True)
    problem = traitlets.Unicode("").tag(sync=True)

    @traitlets.observe("state", "reference", "template", "pins", "settings")
    def _forget(self, _):
        """What has been found was of what was given before."""
        self.report, self.mapped, self.problem = {}, [], ""
