/** Objects as copied text, to paste here or in another tab. */
import type { DrawnObject } from './drawing';
import { fittingObjects } from './fitting';
import { drawnKey } from './meshes';
import { drawingVersion, readObjects } from './saved_drawing';

const format = 'karcher-objects';

/** The text for objects of the surface with this key. */
export const copiedText = (mesh: string, objects: readonly DrawnObject[]) =>
  JSON.stringify({ format, version: drawingVersion, surface: mesh, objects });

/**
 * The objects of a copied text for a surface; null if the page did not write the text. Throws a
 * sentence if the objects belong to another surface or version of the page, or are invalid.
 */
export function pastedObjects(
  text: string,
  mesh: string,
  triangles: number,
): readonly DrawnObject[] | null {
  let content: Partial<Record<'format' | 'version' | 'surface' | 'objects', unknown>> | null;
  try {
    content = JSON.parse(text);
  } catch {
    return null;
  }
  if (content?.format !== format) return null;
  if (content.version !== drawingVersion) {
    throw new Error('what was copied comes from another version of this page');
  }
  if (drawnKey(`${content.surface}`) !== drawnKey(mesh)) {
    throw new Error('what was copied lies on another surface');
  }
  return fittingObjects(readObjects(content.objects), triangles);
}
