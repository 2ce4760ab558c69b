// The coverage of the reference: whether each public name has a sentence and an example.
import { readFileSync } from 'node:fs';
import { Comment, CommentTag, ReflectionKind } from 'typedoc';
import { filesBelow, inRoot } from '../../.tools/shell.mjs';

const named =
  ReflectionKind.Class |
  ReflectionKind.Interface |
  ReflectionKind.Function |
  ReflectionKind.TypeAlias |
  ReflectionKind.Variable |
  ReflectionKind.Method |
  ReflectionKind.Property |
  ReflectionKind.Accessor;
const called = ReflectionKind.Class | ReflectionKind.Function | ReflectionKind.Method;

const commentsOf = (reflection) =>
  [
    reflection.comment,
    ...(reflection.signatures ?? []).map(({ comment }) => comment),
    reflection.getSignature?.comment,
    reflection.type?.declaration?.comment,
    reflection.type?.declaration?.signatures?.[0]?.comment,
  ].filter(Boolean);

const has = (reflection, tag) =>
  commentsOf(reflection).some(
    (comment) =>
      (tag === 'summary' && comment.summary.some(({ text }) => text.trim())) ||
      comment.blockTags.some((block) => block.tag === `@${tag}`),
  );

const publicIn = (project, kinds) =>
  project
    .getReflectionsByKind(kinds)
    .filter((one) => !one.flags.isPrivate && !one.flags.isExternal && !one.flags.isInherited)
    // The reference shows fields of object types with their type.
    .filter((one) => !one.parent?.kindOf(ReflectionKind.TypeLiteral));

/** The names that users call, without methods of interfaces, which they pass or find in a class. */
const calledIn = (project) =>
  publicIn(project, called).filter((one) => !one.parent?.kindOf(ReflectionKind.Interface));

/** The number of public names, those without a sentence, and calls without an example. */
export function reportOf(project) {
  const names = publicIn(project, named);
  const listOf = (which) => which.map((one) => one.getFullName()).sort();
  return {
    names: names.length,
    withoutSentence: listOf(names.filter((one) => !has(one, 'summary'))),
    withoutExample: listOf(calledIn(project).filter((one) => !has(one, 'example'))),
  };
}

const codeOf = (text) =>
  [...text.matchAll(/^```(?:js|ts|tsx)\n([\s\S]*?)^```$/gm)].map(([, code]) => code).join('\n');

/** The lines of programs that the tests run or compile: those of every call first. */
function triedLines() {
  const pages = [inRoot('docs/every-call.md'), ...filesBelow('docs', /\.md$/)];
  const programs = filesBelow('examples', /\.(mjs|tsx?)$/);
  return [
    ...pages.map((page) => codeOf(readFileSync(page, 'utf8'))),
    ...programs.map((page) => readFileSync(page, 'utf8')),
  ]
    .join('\n')
    .split('\n')
    .filter((line) => !/^\s*(import|\/\/|export)/.test(line));
}

/** The names of a class's objects in tried programs, if other classes have equal methods. */
const receivers = {
  Curve: '(curve|parts\\[0\\])',
  CurveMeter: 'new CurveMeter\\(\\w+\\)',
  Karcher: 'karcher',
  Mesh: '(mesh|same)',
  Path: 'path',
  Region: 'region',
  Surface: '(surface|own)',
  SurfaceCurve: 'line',
  Ruler: 'ruler',
  CurveDrag: 'drag',
  WorkerClient: 'client',
};

/** Calls that create an object of a class that users do not construct. */
const makers = {
  Curve: /mesh\.curve\(/,
  CurveView: /curve\.view\(/,
  Karcher: /karcher = await load\(/,
  Mesh: /karcher\.shape\(/,
  Path: /mesh\.shortestPath\(/,
  Peers: /loadPeers\(/,
  Region: /mesh\.regions\(/,
  Surface: /surfaceFromMesh\(/,
};

/** The pattern of a call of a method or function. */
function patternOf(one) {
  const { name } = one;
  if (one.kindOf(ReflectionKind.Function)) return new RegExp(`\\b${name}\\(`);
  if (!one.kindOf(ReflectionKind.Method)) {
    return makers[name] ?? new RegExp(`\\bnew ${name}\\(|instanceof ${name}\\b`);
  }
  return new RegExp(`\\b${receivers[one.parent?.name] ?? '\\w+'}\\.${name}\\(`);
}

/** Adds an example to each call without one: the first line of a tried program that contains it. */
export function addExamples(project) {
  const lines = triedLines();
  for (const one of calledIn(project)) {
    if (has(one, 'example')) continue;
    const pattern = patternOf(one);
    const line = lines.find((text) => pattern.test(text));
    if (!line) continue;
    const owner = one.signatures?.[0] ?? one;
    owner.comment ??= new Comment();
    const code = `\`\`\`ts\n${line.trim()}\n\`\`\``;
    owner.comment.blockTags.push(new CommentTag('@example', [{ kind: 'code', text: code }]));
  }
}
