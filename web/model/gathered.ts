/** The time in milliseconds after which the page pauses its work for other tasks. */
const sliceMilliseconds = 8;

/** All parts of an iterable, computed in slices between which the page does other work. */
export async function gathered<Part>(parts: Iterable<Part>): Promise<Part[]> {
  const all: Part[] = [];
  let started = performance.now();
  for (const part of parts) {
    all.push(part);
    if (performance.now() - started < sliceMilliseconds) continue;
    await new Promise((resolve) => setTimeout(resolve));
    started = performance.now();
  }
  return all;
}
