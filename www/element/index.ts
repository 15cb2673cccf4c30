/** One file for pages and for notebooks: it defines the element, and it is an anywidget. */

import { define } from "./element";
import { render } from "./widget";

export { TAG, ThinShellMatch } from "./element";

define();

export default { render };
