import { onSphere, onTorus } from './surfaces';
import type { Figure, LineId, Panel, Vector } from './types';

const torus = { kind: 'shape', name: 'torus', triangles: 20_000 } as const;
const methods: LineId[] = ['bSurf', 'paper', 'karcher', 'leveled', 'exactLogs'];

const cubic: Vector[] = [onTorus(46, 100), onTorus(70, 20), onTorus(110, 20), onTorus(134, 100)];
const quadratic: Vector[] = [onTorus(48, 84), onTorus(88, 12), onTorus(132, 84)];

const panel = (id: string, title: string, points: string, curve: Panel['curve']): Panel => ({
  id,
  title,
  mesh: torus,
  points,
  curve,
  // Barycentric curves allow no subdivision, and have no levels.
  lines:
    curve.kind === 'barycentric'
      ? methods.filter((id) => id !== 'bSurf' && id !== 'leveled')
      : methods,
  off: ['bSurf', 'exactLogs'],
  samples: 128,
  view: { from: [0, 0.75, 1] },
});

export const rationalFigure: Figure = {
  id: 'rational',
  name: 'Figure 6',
  title: 'Rational curves',
  caption:
    'A rational cubic Bézier curve with all weights 1, then with the inner ones 100 times the outer ones; and a quadratic curve in barycentric form, which passes through its three points. The sliders change the weights. A line is then traced anew together with its fields, so its time is that of the whole curve; the editor keeps the fields. The weights 0.05 and 5 are the paper’s; of β it says 0.5 in its text and 1/4 in its caption, here it is 0.5. Surface and points are ours, distances are exact where the paper has k = 6. b/Surf can be switched on where it makes such curves: with averages of two weighted points it makes rational ones too.',
  points: { cubic, quadratic },
  panels: [
    panel('equal', 'Cubic', 'cubic', { kind: 'rational', weights: [1, 1, 1, 1] }),
    panel('pulled', 'Cubic', 'cubic', {
      kind: 'rational',
      weights: [0.05, 5, 5, 0.05],
    }),
    panel('barycentric', 'Barycentric', 'quadratic', {
      kind: 'barycentric',
      betas: [1, 4, 1],
    }),
    panel('loose', 'Barycentric', 'quadratic', {
      kind: 'barycentric',
      betas: [1, 0.5, 1],
    }),
  ],
};

export const circleFigure: Figure = {
  id: 'circles',
  name: 'Section 5, inset',
  title: 'A circle on a coarse mesh',
  caption:
    'A geodesic circle by seven rational quadratic arcs, the isoline of the distances at the vertices, and the exact isoline. Deviations are differences between the distance to the center and the radius; turning noise is measured against the exact isoline. The arcs are by our method alone, as centers of mass of three points and with the levels of the default; sphere and radius are ours.',
  points: { circle: [onSphere(8, 12), onSphere(48, 20)] },
  panels: [
    {
      id: 'circle',
      title: 'Sphere of 500 triangles',
      mesh: { kind: 'shape', name: 'sphere', triangles: 500 },
      points: 'circle',
      curve: { kind: 'circle', arcs: 7 },
      lines: ['isolineLinear', 'circleArcs', 'circleDefault', 'isolineExact'],
      samples: 16,
      view: { from: [0.15, 0.2, 1], edges: true },
    },
  ],
};
