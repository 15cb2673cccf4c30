import { en } from "../words/en";

/**
 * A part of the page that comes on demand. Rejects with a sentence where it does not come. The next call tries again,
 * except in browsers that remember a failure; there a reload helps, and loses nothing.
 */
export async function fetched<T>(name: string, load: () => Promise<T>): Promise<T> {
  try {
    return await load();
  } catch {
    throw new Error(en.missing.sentence(name));
  }
}
