/** A value that tells its listeners when it changes. */
export class Store<T extends object> {
  #value: T;
  #listeners = new Set<(value: Readonly<T>) => void>();

  constructor(value: T) {
    this.#value = value;
  }

  get value(): Readonly<T> {
    return this.#value;
  }

  set(change: Partial<T>): void {
    this.#value = { ...this.#value, ...change };
    for (const listener of this.#listeners) listener(this.#value);
  }

  /** Calls `listener` now and at each change. */
  subscribe(listener: (value: Readonly<T>) => void): void {
    this.#listeners.add(listener);
    listener(this.#value);
  }
}
