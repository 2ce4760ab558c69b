/**
 * Answers each message to this worker with what is made of it; `buffersOf` tells what of that is
 * transferred. A failure is an error event of the worker.
 */
export function answering<Request, Answer>(
  make: (request: Request) => Promise<Answer>,
  buffersOf: (answer: Answer) => Iterable<Transferable>,
): void {
  self.onmessage = ({ data }: MessageEvent<Request>) => {
    make(data).then(
      (answer) => self.postMessage(answer, { transfer: [...new Set(buffersOf(answer))] }),
      (error) => {
        // Of a promise that fails the page would hear nothing.
        setTimeout(() => {
          throw error;
        });
      },
    );
  };
}
