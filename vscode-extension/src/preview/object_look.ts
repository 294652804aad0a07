// What is made of the BRDF, and in which light: what the pane adds to the sphere.

export interface Sun {
  /** Degrees over the horizon, 0 to 90. */
  elevation: number;
  /** Degrees from behind the viewer to his right. */
  azimuth: number;
}

export interface ObjectLook {
  /** `sphere`, `teapot`, or the path of a .obj file, absolute or from the folder of the document. */
  shape: string;
  /** `directional`, `sky`, `furnace`, or the path of a .hdr file. */
  light: string;
  /** Degrees that the object is turned around its upright axis. */
  yaw: number;
  /** Degrees that its top is tipped towards the viewer. */
  pitch: number;
  /** Of each pixel, where light comes from all directions. */
  samples: number;
  sun: Sun;
  /** Of the sky, 2 to 10. */
  turbidity: number;
}

export const plainObject: ObjectLook = {
  shape: 'sphere', light: 'directional', yaw: 0, pitch: 0, samples: 64, sun: { elevation: 45, azimuth: -30 }, turbidity: 3,
};

/** The sphere whose light is turned by dragging. */
export function isPlain({ shape, light }: ObjectLook): boolean {
  return shape === 'sphere' && light === 'directional';
}

/** The object, turned as it is dragged to the right and down. */
export function orbited(object: ObjectLook, right: number, down: number): ObjectLook {
  const yaw = ((object.yaw + right + 180) % 360 + 360) % 360 - 180;
  return { ...object, yaw, pitch: Math.min(Math.max(object.pitch + down, -90), 90) };
}

/** From where an object shows most. */
export function withStandardOrbit(object: ObjectLook): ObjectLook {
  return { ...object, ...(object.shape === 'teapot' ? { yaw: -30, pitch: 20 } : { yaw: 0, pitch: 0 }) };
}

/** From what a page kept. */
export function isObjectLook(value: unknown): value is ObjectLook {
  if (typeof value !== 'object' || value === null) return false;
  const { shape, light, yaw, pitch, samples, turbidity, sun } = value as Partial<ObjectLook>;
  return typeof shape === 'string' && typeof light === 'string' && [yaw, pitch, samples, turbidity, sun?.elevation, sun?.azimuth].every(Number.isFinite);
}
