/** A column of history.csv or tracks.csv: "torque [N m]" gives name "torque" and unit "N m". */
export interface Column {
  name: string;
  unit: string; // "" where the header has none
  values: Float64Array;
}

export interface Table {
  columns: Column[];
  rows: number;
  incomplete: boolean; // the last line was cut off, as in a run that is still going on
}

/** Name and unit out of a header such as "kinetic energy [J/m]". */
export function parseHeader(text: string): { name: string; unit: string } {
  const match = /^(.*?)\s*\[([^\]]*)\]$/.exec(text.trim());
  return match ? { name: match[1]!, unit: match[2]! } : { name: text.trim(), unit: '' };
}

/** Whether a line ends before its last number does; without its line break nobody can tell. */
function isCut(line: string, columns: number): boolean {
  const cells = line.split(',');
  return cells.length !== columns || cells.some((cell) => cell.trim() === '');
}

/**
 * Reads a table of numbers whose first line names the columns. A last line without a line break is
 * dropped: its last number may be half a number. Lines of another length than the header are
 * left out.
 */
export function parseTable(text: string): Table {
  const lines = text.split(/\r?\n/);
  const headers = lines.shift()!.split(',').map(parseHeader);
  const rest = lines.pop() ?? '';
  const whole = lines.filter((line) => !isCut(line, headers.length));
  const values = headers.map(() => new Float64Array(whole.length));
  whole.forEach((line, row) => {
    line.split(',').forEach((cell, column) => (values[column]![row] = Number(cell)));
  });
  const columns = headers.map((header, i) => ({ ...header, values: values[i]! }));
  return { columns, rows: whole.length, incomplete: rest.trim() !== '' };
}

/** The column of a name, or null where the table has none. */
export function findColumn(table: Table | null, name: string): Column | null {
  return table?.columns.find((column) => column.name === name) ?? null;
}
