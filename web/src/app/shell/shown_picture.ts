/// The picture of the tray that is on the screen, for the export menu; the tray's pane says how it is made.

type Draw = () => Promise<Blob>;

let draw: Draw | null = null;

export function offerPicture(how: Draw): () => void {
  draw = how;
  return () => {
    if (draw === how) draw = null;
  };
}

export async function shownPicture(): Promise<Blob | null> {
  return draw ? draw() : null;
}
