#include "distance/source_vectors.h"

namespace karcher {

void SourceVectors::setSource(const SurfacePoint& source) {
  const TriangleMesh& mesh = *geometry_.mesh;
  const auto count = static_cast<size_t>(mesh.vertexCount());
  vectors_.resize(count);
  states_.assign(count, State::kUnknown);
  const PointLocation location = locate(mesh, source);
  if (location.simplex == Simplex::kVertex) {
    know(location.vertex, Vec2::Zero());
    for (const int h : outgoingHalfedges(mesh, location.vertex)) {
      know(mesh.head(h), geometry_.edgeLength[h] * directionOfEdge(geometry_, h).tail);
      // At the boundary, the last edge has only the half-edge that leads to the source.
      const int last = previous(h);
      if (mesh.twin[last] >= 0) continue;
      know(mesh.tail(last), -geometry_.edgeLength[last] * directionOfEdge(geometry_, last).head);
    }
    return;
  }
  const Vec2 place = pointInFace(geometry_, source);
  for (int k = 0; k < 3; ++k) {
    know(mesh.corner(source.face, k), cornerInFace(geometry_, source.face, k) - place);
  }
  if (location.simplex != Simplex::kEdge) return;
  // The corner across the edge, unfolded.
  const int twin = mesh.twin[location.halfedge];
  if (twin < 0) return;
  const int across = previous(twin);
  const Vec2 fromHead = cornerInFace(geometry_, faceOf(twin), cornerOf(across)) -
                        cornerInFace(geometry_, faceOf(twin), cornerOf(twin));
  know(mesh.tail(across), vectors_[mesh.tail(twin)] + acrossEdge(geometry_, twin, fromHead));
}

void SourceVectors::know(int vertex, const Vec2& vector) {
  vectors_[vertex] = vector;
  states_[vertex] = State::kKnown;
}

const Vec2& SourceVectors::at(const DistanceSolver& solver, int vertex) {
  // The loop ends, since it visits each vertex at most once. Rounding may make two vertices wait
  // for each other: each is an end of the edge that the other's path crosses last. One of the two
  // then takes its vector from the other end of its edge alone.
  ask(solver, vertex);
  while (!asked_.empty()) {
    const Asked last = asked_.back();
    if (ask(solver, last.step.tail) || ask(solver, last.step.head)) continue;
    asked_.pop_back();
    take(last, solver.distance(last.vertex));
  }
  return vectors_[vertex];
}

/// Queues a vertex if its vector is unknown, and returns whether it did.
bool SourceVectors::ask(const DistanceSolver& solver, int vertex) {
  if (vertex < 0 || states_[vertex] != State::kUnknown) return false;
  states_[vertex] = State::kAsked;
  asked_.push_back({vertex, solver.stepTo(vertex)});
  return true;
}

void SourceVectors::take(const Asked& asked, double distance) {
  const PathStep& step = asked.step;
  const auto isKnown = [&](int v) { return v >= 0 && states_[v] == State::kKnown; };
  Vec2 vector = Vec2::Zero();
  if (isKnown(step.tail) && isKnown(step.head)) {
    vector = (1 - step.part) * vectors_[step.tail] + step.part * vectors_[step.head];
  } else if (isKnown(step.head)) {
    vector = vectors_[step.head];
  }
  // The interpolated vector may vanish if the ends lie on opposite sides of the source.
  if (!(vector.norm() > 0) && isKnown(step.tail)) vector = vectors_[step.tail];
  const double length = vector.norm();
  vectors_[asked.vertex] = length > 0 ? Vec2(distance / length * vector) : Vec2::Zero();
  states_[asked.vertex] = State::kKnown;
}

}  // namespace karcher
