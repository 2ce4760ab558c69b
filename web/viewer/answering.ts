/**
 * Answers each message to this worker with the result of `make`. `buffersOf` returns the buffers of
 * a result for transfer. A failure becomes an error event of the worker.
 */
export function answering<Request, Answer>(
  make: (request: Request) => Promise<Answer>,
  buffersOf: (answer: Answer) => Iterable<Transferable>,
): void {
  self.onmessage = ({ data }: MessageEvent<Request>) => {
    make(data).then(
      (answer) => self.postMessage(answer, { transfer: [...new Set(buffersOf(answer))] }),
      (error) => {
        // A rejected promise would not reach the page; an error thrown in a timer does.
        setTimeout(() => {
          throw error;
        });
      },
    );
  };
}
