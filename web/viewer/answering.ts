/**
 * Answers each message to this worker with the result of `make`; `buffersOf` gives the buffers of a result that are
 * transferred. A failure becomes an error event of the worker.
 */
export function answering<Request, Answer>(
  make: (request: Request) => Promise<Answer>,
  buffersOf: (answer: Answer) => Iterable<Transferable>,
): void {
  self.onmessage = ({ data }: MessageEvent<Request>) => {
    make(data).then(
      (answer) => self.postMessage(answer, { transfer: [...new Set(buffersOf(answer))] }),
      (error) => {
        // The page would not hear of a promise that fails.
        setTimeout(() => {
          throw error;
        });
      },
    );
  };
}
