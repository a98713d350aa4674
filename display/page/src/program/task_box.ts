// A place for one task at a time: says that it runs and for how long, has a button to stop it, shows what came of it.
import { button, el } from "../../../report/src/dom";
import type { Task } from "./client";

export class TaskBox {
  readonly root: HTMLElement;
  private readonly status = el("p", { role: "status", class: "status" });
  private readonly clock = el("span", { class: "clock", "aria-hidden": "true" });
  private readonly stopButton = button("Stop", () => this.running?.stop("stopped, as you asked"));
  private readonly tools = el("div", { class: "tools" }, this.status, this.clock, this.stopButton);
  private readonly out = el("div", { class: "came" });
  private running: Task<unknown> | undefined;

  constructor() {
    this.stopButton.hidden = true;
    this.root = el("div", { class: "task" }, this.tools, this.out);
  }

  /** Shows what `show` makes of the task's result; an error becomes a message. A task that runs is stopped before. */
  async run<Result>(words: string, task: Task<Result>, show: (result: Result, seconds: number) => (Node | string)[]): Promise<void> {
    this.running?.stop("stopped, as another was begun");
    this.running = task;
    const start = performance.now();
    const seconds = (): number => (performance.now() - start) / 1000;
    this.out.replaceChildren();
    this.status.textContent = words;
    this.stopButton.hidden = false;
    const tick = window.setInterval(() => (this.clock.textContent = `${Math.floor(seconds())} s`), 500);
    try {
      const result = await task.done;
      if (this.running !== task) return;
      this.out.replaceChildren(...show(result, seconds()));
      this.status.textContent = `Done in ${seconds().toFixed(1)} s.`;
    } catch (error) {
      if (this.running !== task) return;
      this.status.textContent = "";
      this.out.replaceChildren(el("p", { class: "wrong", role: "alert" }, error instanceof Error ? error.message : String(error)));
    } finally {
      clearInterval(tick);
      if (this.running === task) {
        this.running = undefined;
        this.clock.textContent = "";
        this.stopButton.hidden = true;
      }
    }
  }
}
