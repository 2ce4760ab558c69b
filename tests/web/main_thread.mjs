// Traces the threads of a page for a while, as the browser records them.

/** The browser's names for the page's main thread and for the workers'. */
const mainThread = 'CrRendererMain';
const workerThread = 'DedicatedWorker thread';
/** The browser's name for a task of a thread. */
const task = 'ThreadControllerImpl::RunTask';

/**
 * The tasks of a page during an action, in milliseconds: the longest task of the main thread by the
 * clock, the longest by processor time, which other programs do not lengthen, and the total
 * processor time of the main thread and the workers.
 */
export async function tasksDuring(tab, action) {
  const client = await tab.page.context().newCDPSession(tab.page);
  const events = [];
  client.on('Tracing.dataCollected', ({ value }) => {
    for (const event of value) {
      if (event.name === 'thread_name' || event.name === task) events.push(event);
    }
  });
  await client.send('Tracing.start', {
    transferMode: 'ReportEvents',
    traceConfig: { includedCategories: ['__metadata', 'toplevel'] },
  });
  const result = await action();
  const complete = new Promise((resolve) => client.once('Tracing.tracingComplete', resolve));
  await client.send('Tracing.end');
  await complete;
  await client.detach();
  const nameOf = new Map(
    events
      .filter(({ name }) => name === 'thread_name')
      .map(({ pid, tid, args }) => [`${pid} ${tid}`, args.name]),
  );
  const on = (thread) =>
    events.filter(
      ({ name, pid, tid }) =>
        name === task && (nameOf.get(`${pid} ${tid}`) ?? '').startsWith(thread),
    );
  const sum = (tasks) => tasks.reduce((all, { tdur = 0 }) => all + tdur / 1000, 0);
  const longest = (tasks, field) => Math.max(0, ...tasks.map((one) => (one[field] ?? 0) / 1000));
  const main = on(mainThread);
  return {
    result,
    longest: {
      byClock: Math.round(longest(main, 'dur')),
      ofProcessor: Math.round(longest(main, 'tdur')),
    },
    main: sum(main),
    workers: sum(on(workerThread)),
  };
}
