/**
 * Meshes from files, as the browser keeps them: a link cannot hold them. In IndexedDB, for `localStorage` has no room for
 * a mesh of a megabyte.
 */

import type { Solid } from "./solid";

const DATABASE = "thinshell-surfaces";
const TABLE = "meshes";

const PREFIX = "file-";

export function isFile(id: string): boolean {
  return id.startsWith(PREFIX);
}

/** The same bytes have the same key (FNV-1a). */
export function keyOf(bytes: Uint8Array): string {
  let hash = 0x811c9dc5;
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
  return `${PREFIX}${(hash >>> 0).toString(36)}-${bytes.length.toString(36)}`;
}

/** Whether it has been kept: the storage may be full or switched off. */
export async function keep(solid: Solid): Promise<boolean> {
  try {
    await answer("readwrite", (table) => table.put(solid, solid.id));
    return true;
  } catch {
    return false;
  }
}

/** Null where there is none, or no storage. */
export async function kept(id: string): Promise<Solid | null> {
  try {
    return ((await answer("readonly", (table) => table.get(id))) as Solid | undefined) ?? null;
  } catch {
    return null;
  }
}

async function answer(mode: IDBTransactionMode, ask: (table: IDBObjectStore) => IDBRequest): Promise<unknown> {
  const opening = indexedDB.open(DATABASE, 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore(TABLE);
  const database = (await settled(opening)) as IDBDatabase;
  try {
    const transaction = database.transaction(TABLE, mode);
    // A request may succeed and the storage be found full when all is written.
    const written = new Promise((resolve, reject) => {
      transaction.oncomplete = resolve;
      transaction.onabort = () => reject(transaction.error);
    });
    return (await Promise.all([settled(ask(transaction.objectStore(TABLE))), written]))[0];
  } finally {
    database.close();
  }
}

function settled(request: IDBRequest): Promise<unknown> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}
