import { beforeEach, expect, test } from "vitest";
import { keepOffline, takeOver, waiting } from "./updates";

/** An event target with the fields given, to be changed by the test. */
function target<T extends object>(fields: T): T & EventTarget {
  return Object.assign(new EventTarget(), fields);
}

function stage({ controlled = true, already = false } = {}) {
  const told: string[] = [];
  const worker = target({ state: "installing", postMessage: (word: string) => told.push(word) });
  const registration = target({
    waiting: already ? { ...worker, state: "installed" } : null,
    installing: null as unknown,
  });
  const container = target({
    controller: controlled ? {} : null,
    register: async () => registration,
  }) as unknown as ServiceWorkerContainer & EventTarget;
  const arrive = () => {
    registration.installing = worker;
    registration.dispatchEvent(new Event("updatefound"));
    worker.state = "installed";
    worker.dispatchEvent(new Event("statechange"));
  };
  return { told, container, arrive };
}

beforeEach(() => {
  waiting.value = null;
});

test("a new version that has been fetched waits, and takes over at a press: then the page begins anew", async () => {
  const { told, container, arrive } = stage();
  await keepOffline(container);
  expect(waiting.value).toBeNull();
  arrive();
  expect(waiting.value).not.toBeNull();
  let reloads = 0;
  takeOver(container, () => {
    reloads += 1;
  });
  expect([told, reloads]).toEqual([["take over"], 0]);
  container.dispatchEvent(new Event("controllerchange"));
  expect([reloads, waiting.value]).toEqual([1, null]);
});

test("the first version of all is no news", async () => {
  const { container, arrive } = stage({ controlled: false });
  await keepOffline(container);
  arrive();
  expect(waiting.value).toBeNull();
});

test("a version that waits since an earlier visit is told of at once", async () => {
  const { container } = stage({ already: true });
  await keepOffline(container);
  expect(waiting.value).not.toBeNull();
});

test("in a tab that did not ask for it, another version's coming ends the notice and reloads nothing", async () => {
  const { container, arrive } = stage();
  await keepOffline(container);
  arrive();
  container.dispatchEvent(new Event("controllerchange"));
  expect(waiting.value).toBeNull();
});

test("where there can be no worker, nothing happens", async () => {
  await keepOffline(null);
  const { container } = stage();
  container.register = () => Promise.reject(new Error("denied"));
  await keepOffline(container);
  expect(waiting.value).toBeNull();
});
