/** Made while building by scripts/lib/countries.mjs. */
declare module "virtual:countries" {
  const geoJson: string;
  export default geoJson;
}
