// The content security policy stands in the pages themselves. Vite's development server alone needs more than it
// allows: styles that it writes into the page, and the socket over which it says that a file has changed.

/** @returns {import("vite").Plugin} */
export function policyForDevelopment() {
  return {
    name: "thinshell-policy-for-development",
    apply: "serve",
    transformIndexHtml: (html) =>
      html
        .replace("style-src 'self'", "style-src 'self' 'unsafe-inline'")
        .replace("connect-src 'self'", "connect-src 'self' ws:"),
  };
}
