/// A small store: one object, replaced as a whole, and who wants to know of it.

export class Store<T extends object> {
  private current: T;
  private readonly listeners = new Set<() => void>();

  constructor(value: T) {
    this.current = value;
  }

  get value(): Readonly<T> {
    return this.current;
  }

  /// Nobody is told where nothing changes.
  set(patch: Partial<T>): void {
    const next = { ...this.current, ...patch };
    const keys = Object.keys(patch) as (keyof T)[];
    if (keys.every((key) => Object.is(next[key], this.current[key]))) return;
    this.current = next;
    for (const listener of [...this.listeners]) listener();
  }

  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
