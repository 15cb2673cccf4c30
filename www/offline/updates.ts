/** The page's side of the service worker: has it installed, hears of a new version, and lets that take over. */

import { signal } from "@preact/signals";

/** A new version of the page that waits until it may take over. */
export const waiting = signal<{ postMessage(word: string): void } | null>(null);

type Container = Pick<ServiceWorkerContainer, "register" | "controller" | "addEventListener">;

/**
 * Browsers look for another version with every visit by themselves. Where there can be no worker (a private window, a
 * server without https), the page needs the network, as any other.
 */
export async function keepOffline(container: Container | null = navigator.serviceWorker ?? null): Promise<void> {
  // In another tab somebody has let the new version in; this one goes on with the parts of the old.
  container?.addEventListener("controllerchange", () => {
    waiting.value = null;
  });
  const registration = await container?.register("./sw.js").catch(() => undefined);
  if (!container || !registration) return;
  const tell = (worker: ServiceWorker | null) => {
    // The first of all replaces nobody.
    if (worker?.state === "installed" && container.controller) waiting.value = worker;
  };
  tell(registration.waiting);
  const follow = (worker: ServiceWorker | null) => worker?.addEventListener("statechange", () => tell(worker));
  follow(registration.installing);
  registration.addEventListener("updatefound", () => follow(registration.installing));
}

/** The new version takes over and the page begins anew with it; what has been drawn is in the address. */
export function takeOver(
  container: Container = navigator.serviceWorker,
  reload: () => void = () => location.reload(),
): void {
  container.addEventListener("controllerchange", reload, { once: true });
  waiting.value?.postMessage("take over");
}
