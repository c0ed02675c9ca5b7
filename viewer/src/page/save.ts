import type { Clock } from '../model/clock';
import { decimalsFor } from '../model/moment';
import type { LoadedRun } from '../model/run';
import type { Stage } from '../scene/stage';

/** Saves the views as they are, with legend and time, twice as fine as on the screen. */
export function savePicture(stage: Stage, runs: readonly LoadedRun[], clock: Clock): void {
  const { clientWidth, clientHeight } = stage.views[0]!.element;
  const picture = stage.picture(2 * clientWidth * stage.views.length, 2 * clientHeight, 2);
  const names = runs.map((run) => run.index.name).join('-');
  picture.toBlob((blob) => {
    if (blob) download(blob, `${names}-${clock.state.time.toFixed(decimalsFor(clock.times))}s.png`);
  });
}

function download(blob: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
