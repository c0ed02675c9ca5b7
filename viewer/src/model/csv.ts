/** A column of history.csv or tracks.csv: "torque [N m]" gives name "torque" and unit "N m". */
export interface Column {
  name: string;
  unit: string; // "" where the header has none
  values: Float64Array;
}

export interface Table {
  columns: Column[];
  rows: number;
}

/** Name and unit out of a header such as "kinetic energy [J/m]". */
export function parseHeader(text: string): { name: string; unit: string } {
  const match = /^(.*?)\s*\[([^\]]*)\]$/.exec(text.trim());
  return match ? { name: match[1]!, unit: match[2]! } : { name: text.trim(), unit: '' };
}

/** A number, or NaN where a cell is empty or holds none. */
function toNumber(cell: string): number {
  return cell.trim() === '' ? NaN : Number(cell);
}

/**
 * Reads a table of numbers whose first line names the columns; empty cells are NaN. A last line
 * without a line break is dropped, as in a run that is still going on: its last number may be half
 * a number. Lines of another length than the header are left out.
 */
export function parseTable(text: string): Table {
  const lines = text.split(/\r?\n/);
  const headers = lines.shift()!.split(',').map(parseHeader);
  const rows = lines
    .slice(0, -1)
    .map((line) => line.split(','))
    .filter((cells) => cells.length === headers.length);
  const values = headers.map((_, column) =>
    Float64Array.from(rows, (cells) => toNumber(cells[column]!)),
  );
  const columns = headers.map((header, i) => ({ ...header, values: values[i]! }));
  return { columns, rows: rows.length };
}

/** One line of a table; cells with commas, quotes or line breaks are quoted (RFC 4180). */
export function csvLine(cells: readonly (string | number)[]): string {
  const quoted = (cell: string) =>
    /[",\r\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell;
  return cells.map((cell) => quoted(String(cell))).join();
}

/** The column of a name, or null where the table has none. */
export function findColumn(table: Table | null, name: string): Column | null {
  return table?.columns.find((column) => column.name === name) ?? null;
}
