// The module of fates, which a notebook's kernel sends when it is asked for: it is larger than most notebooks.

const PATIENCE = 20_000; // milliseconds

/** The part of an anywidget model that is used. */
export type Model = {
  get(name: string): any;
  set(name: string, value: unknown): void;
  save_changes(): void;
  send(message: object): void;
  on(name: string, listener: (...values: any[]) => void): void;
  off(name: string, listener: (...values: any[]) => void): void;
};

export class NotebookKernel {
  constructor(readonly model: Model) {}

  /** Several views of one widget share its messages; each answers to its own. */
  fates(): Promise<DataView<ArrayBuffer>> {
    const { model } = this;
    const number = Math.random();
    return new Promise((resolve, reject) => {
      const end = () => {
        clearTimeout(timer);
        model.off("msg:custom", answered);
      };
      const answered = (message: any, buffers: DataView<ArrayBuffer>[]) => {
        if (message?.number !== number) return;
        end();
        resolve(buffers[0]);
      };
      // a saved notebook plays without a kernel
      const timer = setTimeout(() => {
        end();
        reject(new Error("backend.notebook_silent"));
      }, PATIENCE);
      model.on("msg:custom", answered);
      model.send({ number });
    });
  }
}
