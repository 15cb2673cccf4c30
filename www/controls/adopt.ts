/**
 * The style of a part that comes on demand, brought in that part's script: a style sheet of its own could fail by
 * itself, and Vite fetches one only once.
 */
export function adopt(css: string): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}
