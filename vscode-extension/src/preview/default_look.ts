// How a picture looks unless somebody turns it or the settings say otherwise: the numbers of `texbrdf render`.
import type { Look } from '../protocol';

export const defaultLook: Look = { light: { theta: 33.8941, phi: 145.826 }, zoom: 1, exposure: -1.248, gamma: 2.112, cosine: true };
