/** What this page writes into its own files as `format`. Apart from the readers, which nobody needs for saving. */
export const FORMAT = "thinshell";
