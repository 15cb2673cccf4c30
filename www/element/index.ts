/** One file for pages and for notebooks: it defines the element, and it is an anywidget. */

import { define } from "./element";
import type * as Declared from "./thin-shell-match";
import { render } from "./widget";

export { TAG, ThinShellMatch } from "./element";

define();

export default { render } satisfies typeof Declared.default;
