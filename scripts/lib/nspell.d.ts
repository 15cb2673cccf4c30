/** As far as it is used: the package has no types. */
declare module "nspell" {
  export default function nspell(aff: Buffer, dic: Buffer): { correct(word: string): boolean };
}
