/// The parts list by keys, as a grid: arrow keys go from cell to cell, Enter goes into a cell's field and back, Space
/// chooses a row, Shift with up or down chooses several. One cell at a time can be reached by Tab.

import type { PartsList } from "./parts_list";

export interface Cell {
  readonly row: number;
  readonly column: number;
}

export const columns = ["check", "name", "count", "scale", "stands", "gap", "priority", "due"] as const;
export type Column = (typeof columns)[number];

const fields = "input, select, button";

/// Columns whose fields are text until their row is looked at.
const opening: ReadonlySet<string> = new Set(["scale", "stands", "gap", "priority", "due"]);

export class GridKeys {
  cell: Cell = { row: 0, column: 1 };
  private wanted = false;
  private fresh = false;

  constructor(private readonly list: PartsList) {}

  /// After drawing: the focus goes where the arrow keys led.
  settle(): void {
    if (!this.wanted) return;
    this.wanted = false;
    this.element(this.cell)?.focus();
  }

  focused(event: FocusEvent): void {
    const element = (event.target as HTMLElement).closest<HTMLElement>("[data-column]");
    const row = element?.closest<HTMLElement>("[data-row]");
    if (!element || !row) return;
    const cell = { row: Number(row.dataset.row), column: columns.indexOf(element.dataset.column as Column) };
    if (cell.row === this.cell.row && cell.column === this.cell.column) return;
    this.cell = cell;
    this.look();
    this.list.requestUpdate();
  }

  pressed(event: PointerEvent): void {
    const row = (event.target as HTMLElement).closest<HTMLElement>("[data-row]");
    this.fresh = row !== null && !row.classList.contains("sel");
  }

  /// A press on a row that was not looked at goes on into the field that appears. There is no click: what was pressed is
  /// gone by then.
  released(event: PointerEvent): void {
    const cell = (event.target as HTMLElement).closest<HTMLElement>("[data-column]");
    if (!this.fresh || !cell || !opening.has(cell.dataset.column ?? "")) return;
    this.fresh = false;
    void this.list.updateComplete.then(() => this.enter(cell));
  }

  key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    const cell = target.closest<HTMLElement>("[data-column]");
    if (!cell) return;
    if (target !== cell) this.keyInField(event, cell);
    else this.keyOnCell(event, cell);
  }

  private keyInField(event: KeyboardEvent, cell: HTMLElement): void {
    if (event.key === "Escape") {
      event.stopPropagation();
      cell.focus();
    } else if (event.key === "Enter" && !event.ctrlKey && !event.metaKey && event.target instanceof HTMLInputElement) {
      event.preventDefault();
      this.move(1, 0);
    }
  }

  private keyOnCell(event: KeyboardEvent, cell: HTMLElement): void {
    const page = 8;
    const last = this.list.shown.length - 1;
    const moves: Readonly<Record<string, readonly [number, number]>> = {
      ArrowUp: [-1, 0],
      ArrowDown: [1, 0],
      ArrowLeft: [0, -1],
      ArrowRight: [0, 1],
      PageUp: [-page, 0],
      PageDown: [page, 0],
      Home: event.ctrlKey ? [-last, -columns.length] : [0, -columns.length],
      End: event.ctrlKey ? [last, 0] : [0, columns.length],
    };
    const move = moves[event.key];
    if (move) {
      event.preventDefault();
      event.stopPropagation();
      if (event.shiftKey && move[1] === 0) this.choose(this.cell.row, true);
      this.move(move[0], move[1]);
      if (event.shiftKey && move[1] === 0) this.choose(this.cell.row, true);
    } else if ((event.key === "Enter" || event.key === "F2") && !event.ctrlKey && !event.metaKey) {
      event.preventDefault();
      this.enter(cell);
    } else if (event.key === " ") {
      event.preventDefault();
      this.choose(this.cell.row, null);
    } else if (event.key === "a" && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      this.list.session.view.set({ chosen: new Set(this.list.shown.map((row) => row.part.key)) });
    } else if (/^[0-9]$/.test(event.key) && cell.querySelector("input")) {
      // A number begins: it goes into the field.
      event.stopPropagation();
      this.enter(cell);
    }
  }

  private enter(cell: HTMLElement): void {
    const field = cell.querySelector<HTMLElement>("input, select") ?? cell.querySelector<HTMLElement>(fields);
    if (!field) return;
    field.focus();
    if (field instanceof HTMLInputElement) field.select?.();
    else if (field instanceof HTMLButtonElement) field.click();
  }

  private move(rows: number, cells: number): void {
    const row = Math.max(0, Math.min(this.list.shown.length - 1, this.cell.row + rows));
    const column = Math.max(0, Math.min(columns.length - 1, this.cell.column + cells));
    this.cell = { row, column };
    this.wanted = true;
    this.look();
    this.list.reveal(row);
  }

  /// The preview shows the row that one is in.
  private look(): void {
    const key = this.list.shown[this.cell.row]?.part.key;
    if (key !== undefined) this.list.session.view.set({ current: key });
  }

  private choose(place: number, on: boolean | null): void {
    const { view } = this.list.session;
    const key = this.list.shown[place]?.part.key;
    if (key === undefined) return;
    const chosen = new Set(view.value.chosen);
    if (on ?? !chosen.has(key)) chosen.add(key);
    else chosen.delete(key);
    view.set({ chosen });
  }

  private element(cell: Cell): HTMLElement | null {
    const column = columns[cell.column] ?? "name";
    return this.list.querySelector(`[data-row="${cell.row}"] [data-column="${column}"]`);
  }
}
