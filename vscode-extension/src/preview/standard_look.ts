// How a picture looks unless somebody turns it: the numbers of `texbrdf render` and the settings.
import * as vscode from 'vscode';
import type { Look } from '../protocol';

export function standardLook(): Look {
  const setting = vscode.workspace.getConfiguration('texbrdf.preview');
  return {
    light: { theta: 33.8941, phi: 145.826 },
    zoom: 1,
    exposure: setting.get('exposure', -1.248),
    gamma: setting.get('gamma', 2.112),
    cosine: setting.get('cosine', true),
  };
}
