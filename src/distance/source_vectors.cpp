#include "distance/source_vectors.h"

namespace karcher {

void SourceVectors::setSource(const SurfacePoint& source) {
  const TriangleMesh& mesh = *geometry_.mesh;
  const auto count = static_cast<size_t>(mesh.vertexCount());
  vectors_.resize(count);
  states_.assign(count, State::kUnknown);
  const Vec2 place = pointInFace(geometry_, source);
  for (int k = 0; k < 3; ++k) {
    const int vertex = mesh.corner(source.face, k);
    vectors_[vertex] = cornerInFace(geometry_, source.face, k) - place;
    states_[vertex] = State::kKnown;
  }
}

const Vec2& SourceVectors::at(const DistanceSolver& solver, int vertex) {
  // Each vertex is asked once, so that this ends; where a path seems to come from a vertex whose
  // own comes from it, as rounding may have it, the other end of the edge counts alone.
  if (isToBeAsked(vertex)) {
    states_[vertex] = State::kAsked;
    asked_.push_back(vertex);
  }
  while (!asked_.empty()) {
    const int last = asked_.back();
    const PathStep step = solver.stepTo(last);
    const int open = isToBeAsked(step.tail) ? step.tail : isToBeAsked(step.head) ? step.head : -1;
    if (open >= 0) {
      states_[open] = State::kAsked;
      asked_.push_back(open);
    } else {
      take(solver, last);
      asked_.pop_back();
    }
  }
  return vectors_[vertex];
}

void SourceVectors::take(const DistanceSolver& solver, int vertex) {
  const PathStep step = solver.stepTo(vertex);
  const auto isKnown = [&](int v) { return v >= 0 && states_[v] == State::kKnown; };
  Vec2 vector = Vec2::Zero();
  if (isKnown(step.tail) && isKnown(step.head)) {
    vector = (1 - step.part) * vectors_[step.tail] + step.part * vectors_[step.head];
  } else if (isKnown(step.tail) || isKnown(step.head)) {
    vector = vectors_[isKnown(step.tail) ? step.tail : step.head];
  }
  // Ends on opposite sides of the source may leave nothing between them.
  if (!(vector.norm() > 0) && isKnown(step.tail)) vector = vectors_[step.tail];
  const double length = vector.norm();
  vectors_[vertex] = length > 0 ? Vec2(solver.distance(vertex) / length * vector) : Vec2::Zero();
  states_[vertex] = State::kKnown;
}

}  // namespace karcher
