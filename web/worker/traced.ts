/** The engine's results in the form that the page draws. */
import type { Circle, CurvePoints, CurveView, Ellipse, Path } from 'karcher';
import { lostIntervals } from '../model/lost';
import type { Fill, TracedCurve, TracedIsolines } from '../model/traced';

export function tracedCurve(
  view: CurveView,
  marks: CurvePoints | null,
  fill: Fill | null,
): TracedCurve {
  const { samples, bridged, knots, levels, legs, drawnLegs, length, times } = view;
  return {
    polyline: view.polyline as Float32Array,
    polylineStatus: view.unconverged,
    samples,
    lost: lostIntervals(samples, bridged),
    knots,
    levels,
    legs: legs as readonly Float32Array[],
    drawnLegs,
    marks,
    arcsNotShortest: 0,
    deviation: null,
    length,
    milliseconds: Object.values(times).reduce((sum, time) => sum + time, 0),
    fill,
    outlines: null,
  };
}

export function tracedCircle(
  circle: Ellipse & Partial<Circle>,
  milliseconds: () => number,
  fill: Fill | null,
): TracedCurve {
  const { path, unconverged, samples, bridged, levels, notShortest } = circle;
  return {
    polyline: path.polyline(),
    polylineStatus: unconverged,
    samples,
    lost: lostIntervals(samples, bridged),
    knots: new Float64Array(),
    levels,
    legs: [],
    drawnLegs: [],
    marks: null,
    arcsNotShortest: notShortest.length,
    deviation: circle.deviation ?? null,
    length: path.length,
    milliseconds: milliseconds(),
    fill,
    outlines: [path],
  };
}

export function tracedLines(
  paths: readonly Path[],
  milliseconds: number,
  fill: Fill | null,
): TracedIsolines {
  const lines = paths.map((line) => ({
    ...{ closed: line.closed, length: line.length },
    polyline: line.polyline(),
  }));
  const length = lines.reduce((sum, line) => sum + line.length, 0);
  return { lines, length, milliseconds, fill, outlines: paths };
}
