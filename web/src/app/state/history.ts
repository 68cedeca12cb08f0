/// Undo and redo of one immutable document. Changes with the same tag that follow each other closely are one step, so
/// that ten clicks on a stepper are undone at once.

export class History<T> {
  private past: T[] = [];
  private future: T[] = [];
  private tag = "";
  private at = 0;

  constructor(
    private document: T,
    private readonly now: () => number = () => Date.now(),
    private readonly closely = 1200,
    private readonly most = 200,
  ) {}

  get value(): T {
    return this.document;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  change(next: T, tag = ""): void {
    if (next === this.document) return;
    const time = this.now();
    const goesOn = tag !== "" && tag === this.tag && time - this.at < this.closely && this.past.length > 0;
    if (!goesOn) {
      this.past.push(this.document);
      if (this.past.length > this.most) this.past.shift();
    }
    this.tag = tag;
    this.at = time;
    this.future = [];
    this.document = next;
  }

  undo(): void {
    const before = this.past.pop();
    if (before === undefined) return;
    this.future.push(this.document);
    this.document = before;
    this.tag = "";
  }

  redo(): void {
    const after = this.future.pop();
    if (after === undefined) return;
    this.past.push(this.document);
    this.document = after;
    this.tag = "";
  }

  /// Another document; nothing of the one before can come back.
  reset(document: T): void {
    this.past = [];
    this.future = [];
    this.tag = "";
    this.document = document;
  }
}
