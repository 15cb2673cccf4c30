/** What is said of the page within another page, and where that is arranged. */

import { page } from "./language";

export const embed = page("embed", {
  /** The frame's name in the other page. */
  title: "Elastic matching of two curves",
  begin: "Embed in another page …",
  what: "What embeds the page",
  open: "Open in the page",
  openHelp: "The same shapes and settings, with all there is, in a tab of its own",
  compare: "Compare",

  noKind: (text: string, all: string) => `The address asks for embed=${text}, which must be one of ${all}.`,
  noControl: (text: string, all: string) => `The address asks for the control “${text}”; there are ${all}.`,
  noSetting: (text: string) => `The address asks for the setting “${text}”, which this page does not have.`,
  noChange: (text: string) => `The address asks for the change “${text}”, which must be like bending:0.`,
  noOrigin: (text: string) => `The address names “${text}” as an origin, which must be like https://example.org.`,
  onlyCurves: "Only curves can be compared side by side in a frame.",

  dialog: {
    title: "Embed in another page",
    close: "Close",
    kind: "What it shows",
    kinds: {
      result: "The result",
      compare: "Two settings side by side",
      full: "Everything to draw and match with",
    },
    size: "Size",
    width: "Width, pixels",
    height: "Height, pixels",
    controls: "What can be done in it",
    names: {
      view: "Choose the view",
      morph: "Play the morph",
      numbers: "Read the numbers",
      terms: "See the energies, leave terms out",
      match: "Match, undo, live",
      link: "Open it in the page",
    },
    setting: "Change in the second",
    value: "Its value there",
    run: "Match at once, without a press",
    snippet: "To be copied into the page",
    copy: "Copy",
    copied: "Copied",
    select: "Select all and copy",
    preview: "Preview",
    more: "In the folder docs of the sources, embedding.md says how a page talks to its frame.",
  },
});
