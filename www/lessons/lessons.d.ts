/** What plugin.ts makes of docs/lessons while the page is built. */

declare module "virtual:lessons" {
  const LESSONS: readonly import("./lesson").Listed[];
  export default LESSONS;
}
