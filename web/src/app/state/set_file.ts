/// Set files: CSV with a line for each part (docs/format.md, Set files). The server tells which there are and what is
/// wrong with them; the page reads the columns that the server's rows leave out.

import type { Mesh, SetFile } from "../../api/types";
import { parseNumber } from "../words/numbers";
import { type DraftPart, freeKey, newPart, type Stands } from "./draft";
import { baseName, isAxis, objectsOf, standsOf, unitOf } from "./job_file_read";

/// UTF-8, and what is none is Windows-1252, as spreadsheets write it.
export function decodeText(bytes: ArrayBuffer): string {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("windows-1252").decode(bytes);
  }
}

/// Lines and fields as in RFC 4180. Semicolons separate where the header has some and no comma.
export function parseCsv(text: string): string[][] {
  const plain = text.replace(/^\ufeff/, "");
  const header = plain.slice(0, plain.search(/\r?\n|$/));
  const separator = header.includes(";") && !header.includes(",") ? ";" : ",";
  const rows: string[][] = [];
  let row: string[] = [];
  let field = "";
  let quoted = false;
  const endField = () => {
    row.push(field);
    field = "";
  };
  const endRow = () => {
    endField();
    if (row.some((value) => value.trim() !== "")) rows.push(row);
    row = [];
  };
  for (let i = 0; i < plain.length; i += 1) {
    const c = plain[i];
    if (quoted) {
      if (c !== '"') field += c;
      else if (plain[i + 1] === '"') {
        field += '"';
        i += 1;
      } else quoted = false;
    } else if (c === '"' && field === "") quoted = true;
    else if (c === separator) endField();
    else if (c === "\n") endRow();
    else if (c !== "\r") field += c;
  }
  if (field !== "" || row.length > 0) endRow();
  return rows;
}

/// The parts of a set file, in its order; null where it is not one that can be read here.
export function partsOfCsv(text: string, meshes: readonly Mesh[], taken: ReadonlySet<string>): DraftPart[] | null {
  const [header, ...rows] = parseCsv(text);
  const columns = header?.map((name) => name.trim().toLowerCase());
  if (!columns?.some((name) => name === "mesh" || name === "file")) return null;
  const keys = new Set(taken);
  const parts: DraftPart[] = [];
  for (const row of rows) {
    const cell = (...names: string[]): string => {
      const column = columns.findIndex((name) => names.includes(name));
      return (row[column] ?? "").trim();
    };
    const path = cell("mesh", "file");
    if (path === "") continue;
    const file = baseName(path);
    for (const object of objectsOf(file, null, meshes)) {
      const key = freeKey(file, object, keys);
      keys.add(key);
      const part = newPart(file, object, key);
      parts.push({
        ...part,
        name: cell("name") || null,
        count: Math.max(1, Math.round(parseNumber(cell("count", "quantity")) ?? 1)),
        scale: parseNumber(cell("scale")) ?? 1,
        unit: unitOf(cell("unit").toLowerCase()),
        gap: parseNumber(cell("gap")),
        priority: parseNumber(cell("priority")) ?? 0,
        due: cell("due") || null,
        value: parseNumber(cell("value")),
        stands: standsOfCell(cell("orientations")),
      });
    }
  }
  return parts;
}

function standsOfCell(text: string): Stands {
  const axes = text.toLowerCase().split(/\s+/).filter(isAxis);
  return axes.length > 0 ? { kind: "axes", axes, yaw: null } : standsOf(text.toLowerCase());
}

/// The same from the server's rows, where the file itself could not be had.
export function partsOfRows(set: SetFile, meshes: readonly Mesh[], taken: ReadonlySet<string>): DraftPart[] {
  const keys = new Set(taken);
  return set.rows.flatMap((row) =>
    objectsOf(baseName(row.mesh), null, meshes).map((object) => {
      const file = baseName(row.mesh);
      const key = freeKey(file, object, keys);
      keys.add(key);
      const { name, count, scale, gap, priority, due } = row;
      return { ...newPart(file, object, key), name: name || null, count, scale, gap, priority, due };
    }),
  );
}
