// Records the calls into the module that a mesh and its curves make.

/**
 * The result of `work`, and the calls that meshes and curves of the mesh's module make meanwhile:
 * the name and the result of each.
 */
export function noted(mesh, work) {
  const calls = [];
  const restores = prototypesOf(mesh).map((prototype) => note(prototype, calls));
  const restore = () => {
    for (const one of restores) one();
  };
  let value;
  try {
    value = work();
  } catch (error) {
    restore();
    throw error;
  }
  if (!(value instanceof Promise)) {
    restore();
    return { value, calls };
  }
  return value.then((result) => ({ value: result, calls })).finally(restore);
}

/** A new curve of a mesh, and the module's own mesh and curve. */
export function curveInModule(mesh, options) {
  const engineMesh = mesh.handle.call((target) => target);
  const { curve: make } = engineMesh;
  let engineCurve;
  engineMesh.curve = (...args) => {
    engineCurve = make.apply(engineMesh, args);
    return engineCurve;
  };
  const curve = mesh.curve(options);
  delete engineMesh.curve;
  return { curve, engineMesh, engineCurve };
}

/** The prototypes of the module's own meshes and curves. */
function prototypesOf(mesh) {
  const points = [0, 1].map((vertex) => ({ vertex }));
  const { curve, ...made } = curveInModule(mesh, { kind: 'polyline', points });
  curve.dispose();
  return Object.values(made).map(Object.getPrototypeOf);
}

/** Records the calls of a prototype's methods, until the returned function is called. */
function note(prototype, calls) {
  const kept = Object.entries(prototype).filter(
    ([name, method]) => typeof method === 'function' && name !== 'constructor',
  );
  for (const [name, method] of kept) {
    prototype[name] = function (...args) {
      const returned = method.apply(this, args);
      calls.push({ name, returned });
      return returned;
    };
  }
  return () => Object.assign(prototype, Object.fromEntries(kept));
}
