// Data out of the page: see fields.py.

// Return packed bytes; throw an error unless there are `count` of them.
async function unpackBytes(text, count) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  if (bytes.length !== count) throw new Error("the data of this page are damaged");
  return bytes;
}

// Return the columns of a packed table as Int16Arrays of that many rows.
async function unpack(text, rows, columns) {
  const size = rows * columns, planes = await unpackBytes(text, 2 * size);
  const found = [];
  for (let c = 0; c < columns; c++) {
    const column = new Int16Array(rows);
    let value = 0;
    for (let t = 0, at = c * rows; t < rows; t++, at++) {
      const folded = planes[at] | (planes[size + at] << 8);
      value += (folded >>> 1) ^ -(folded & 1);
      column[t] = value; // wraps round, as the changes do
    }
    found.push(column);
  }
  return found;
}
