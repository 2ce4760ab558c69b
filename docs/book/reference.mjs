// What the reference says of each public name: whether it has a sentence, and whether an example.
import { ReflectionKind } from 'typedoc';

const named =
  ReflectionKind.Class |
  ReflectionKind.Interface |
  ReflectionKind.Function |
  ReflectionKind.TypeAlias |
  ReflectionKind.Variable |
  ReflectionKind.Method |
  ReflectionKind.Property |
  ReflectionKind.Accessor;
/** What is called or made; types are shown where these take them. */
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

/** How many names there are, those without a sentence, and of those that are called those without an example. */
export function reportOf(project) {
  const names = project
    .getReflectionsByKind(named)
    .filter((one) => !one.flags.isPrivate && !one.flags.isExternal && !one.flags.isInherited)
    // Fields of objects that a type spells out are shown with it.
    .filter((one) => !one.parent?.kindOf(ReflectionKind.TypeLiteral));
  const listOf = (which) => which.map((one) => one.getFullName()).sort();
  return {
    names: names.length,
    withoutSentence: listOf(names.filter((one) => !has(one, 'summary'))),
    withoutExample: listOf(names.filter((one) => one.kindOf(called) && !has(one, 'example'))),
  };
}
