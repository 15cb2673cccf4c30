/** Files out of what has been chosen or dropped: of folders, those that can be read, in the order of their names. */

export type Dropped = readonly (File | FileSystemEntry)[];

/** More are no batch to be watched. */
export const MOST_FILES = 500;

const READABLE = /\.(svg|png|jpe?g|webp|gif|bmp|json|geojson|csv|txt|tps)$/i;

export async function gathered(dropped: Dropped): Promise<File[]> {
  const found: File[] = [];
  for (const item of dropped) {
    if (item instanceof File) found.push(item);
    else if (item.isFile) found.push(await fileOf(item as FileSystemFileEntry));
    else await walk(item as FileSystemDirectoryEntry, found);
  }
  return found;
}

/** What of a folder that has been chosen can be read: the browser lists all there is. */
export function readable(files: readonly File[]): File[] {
  return files.filter(({ name }) => READABLE.test(name)).sort(byName);
}

async function walk(folder: FileSystemDirectoryEntry, found: File[]): Promise<void> {
  const reader = folder.createReader();
  const entries: FileSystemEntry[] = [];
  // Browsers give a hundred at a time, and none at the end.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) break;
    entries.push(...some);
  }
  for (const entry of entries.sort(byName)) {
    if (found.length > MOST_FILES) return;
    if (entry.isDirectory) await walk(entry as FileSystemDirectoryEntry, found);
    else if (READABLE.test(entry.name)) found.push(await fileOf(entry as FileSystemFileEntry));
  }
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) => entry.file(resolve, reject));
}

function byName(a: { readonly name: string }, b: { readonly name: string }): number {
  return a.name.localeCompare(b.name, undefined, { numeric: true });
}
