/// The sides to look from. Front is where the y axis points away from the viewer.

import { homeAzimuth, homeElevation } from "./camera";
import type { Side } from "./view";

const quarter = Math.PI / 2;

export const sides: Readonly<Record<Side, { readonly azimuth: number; readonly elevation: number }>> = {
  home: { azimuth: homeAzimuth, elevation: homeElevation },
  front: { azimuth: -quarter, elevation: 0 },
  back: { azimuth: quarter, elevation: 0 },
  left: { azimuth: 2 * quarter, elevation: 0 },
  right: { azimuth: 0, elevation: 0 },
  top: { azimuth: -quarter, elevation: quarter },
  bottom: { azimuth: -quarter, elevation: -quarter },
};
