// How a picture looks unless somebody turns it: as the settings say.
import * as vscode from 'vscode';
import type { Look } from '../protocol';
import { defaultLook } from './default_look';

export function standardLook(): Look {
  const setting = vscode.workspace.getConfiguration('texbrdf.preview');
  return {
    ...defaultLook,
    exposure: setting.get('exposure', defaultLook.exposure),
    gamma: setting.get('gamma', defaultLook.gamma),
    cosine: setting.get('cosine', defaultLook.cosine),
  };
}
