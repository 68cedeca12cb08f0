/// The 3D views are loaded when they are first needed, so that the start page does not wait for them.

export const trayViews = () => import("../../view/tray_view");
export const partViews = () => import("../../view/part_view");
export const pictures = () => import("../../view/thumbnails");
export const bundles = () => import("../../view/bundle");
export const clashes = () => import("../../view/clash");
