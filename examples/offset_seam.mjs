// A seam allowance: a panel's outline on a surface, a line at a distance outside it, and the parts
// cut along both.
import { load } from 'karcher';
import { solidOf } from 'karcher/checkup';

const karcher = await load();
const mesh = karcher.shape('sphere', 5000);
const corners = [
  [0.5, 0, 1],
  [0, 0.5, 1],
  [-0.5, 0, 1],
  [0, -0.5, 1],
].map((place) => mesh.nearestPoint(place).point);

// The panel is the region that a closed line through the corners encloses.
const outline = mesh.curve({ kind: 'catmullrom', points: corners, closed: true });
const [panel] = mesh.regions([outline.path()]);
console.log(`panel: area ${panel.area.toFixed(4)}, perimeter ${panel.perimeter.toFixed(4)}`);

// The seam lies outside the panel, at a geodesic distance from the outline.
const distance = 0.05;
const seam = mesh.offset(panel.boundary(), { distance, side: 'right' });
const [withSeam] = mesh.regions(seam);
console.log(`with the seam: area ${withSeam.area.toFixed(4)}`);
const strip = withSeam.area - panel.area;
console.log(
  `the strip between: ${strip.toFixed(4)}, on a plane ${(distance * panel.perimeter).toFixed(4)} and corners`,
);

// Parts for the cutter: the panel, the strip round it, and the rest.
const parts = mesh.cut([...panel.boundary(), ...seam]);
console.log(`parts: ${parts.map((part) => solidOf(part).area.toFixed(4)).join(', ')}`);
