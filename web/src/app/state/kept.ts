/// What this browser remembers between visits. Where it may keep nothing (private windows), the page works all the same.

export function kept<T>(name: string, fallback: T): T {
  try {
    const text = localStorage.getItem(`spectralpack.${name}`);
    return text === null ? fallback : (JSON.parse(text) as T);
  } catch {
    return fallback;
  }
}

export function keep(name: string, value: unknown): void {
  try {
    localStorage.setItem(`spectralpack.${name}`, JSON.stringify(value));
  } catch {
    // Nothing depends on it.
  }
}
