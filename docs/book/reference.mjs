// What the reference says of each public name: whether it has a sentence, and whether an example.
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
    // Fields of objects that a type spells out are shown with it.
    .filter((one) => !one.parent?.kindOf(ReflectionKind.TypeLiteral));

/** What users call; methods of interfaces are what they hand in, or what a class has that they call. */
const calledIn = (project) =>
  publicIn(project, called).filter((one) => !one.parent?.kindOf(ReflectionKind.Interface));

/** How many names there are, those without a sentence, and of those that are called those without an example. */
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

/** What the tried programs name objects of a class, where others have methods of the same names. */
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

/** What makes an object of a class that users do not construct. */
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

/** How a call of it looks. */
function patternOf(one) {
  const { name } = one;
  if (one.kindOf(ReflectionKind.Function)) return new RegExp(`\\b${name}\\(`);
  if (!one.kindOf(ReflectionKind.Method)) {
    return makers[name] ?? new RegExp(`\\bnew ${name}\\(|instanceof ${name}\\b`);
  }
  return new RegExp(`\\b${receivers[one.parent?.name] ?? '\\w+'}\\.${name}\\(`);
}

/** Adds to each call without an example the first line of a tried program that makes it. */
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
