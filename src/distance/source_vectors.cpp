#include "distance/source_vectors.h"

#include "mesh/rounding.h"

namespace karcher {

void SourceVectors::setSource(const SurfacePoint& source) {
  const TriangleMesh& mesh = *geometry_.mesh;
  const auto count = static_cast<size_t>(mesh.vertexCount());
  vectors_.resize(count);
  states_.assign(count, State::kUnknown);
  const PointLocation location = locate(mesh, source);
  const bool isVertex = location.simplex == Simplex::kVertex;
  angleScale_ = isVertex ? geometry_.angleScale[location.vertex] : 1;
  if (isVertex) {
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

const Vec2& SourceVectors::at(DistanceSolver& solver, int vertex) {
  // The loop ends, since it visits each vertex at most once. Rounding may make two vertices wait
  // for each other: each is an end of the edge that the other's path crosses last. One of the two
  // then takes its vector from the other end of its edge alone.
  ask(solver, vertex);
  while (!asked_.empty()) {
    const Asked last = asked_.back();
    if (ask(solver, last.tail) || ask(solver, last.head)) continue;
    asked_.pop_back();
    take(last, solver.distance(last.vertex));
  }
  return vectors_[vertex];
}

/// Queues a vertex if its vector is unknown, and returns whether it did.
bool SourceVectors::ask(DistanceSolver& solver, int vertex) {
  if (vertex < 0 || states_[vertex] != State::kUnknown) return false;
  states_[vertex] = State::kAsked;
  const double distance = solver.growTo(vertex);
  const PathStep step = solver.stepTo(vertex);
  Asked asked{vertex, step.tail, step.head, step.part};
  if (step.halfedge >= 0) {
    const int h = step.halfedge;
    const Vec2 tail = cornerInFace(geometry_, faceOf(h), cornerOf(h));
    const Vec2 edge = halfedgeInFace(geometry_, h);
    const Vec2 apex = cornerInFace(geometry_, faceOf(h), cornerOf(previous(h)));
    const Vec2 fromSource = (apex - tail - step.part * edge).normalized();
    const Vec2 source = apex - distance * fromSource;
    asked.fromTail = rotateBack(tail - source, fromSource);
    asked.fromHead = rotateBack(tail + edge - source, fromSource);
    const auto seesSource = [&](int side) {
      const int end = geometry_.mesh->tail(side);
      const double length = solver.growTo(end);
      const double rounding = kChainRounding * (distance + length);
      const Vec2 toSource = source - cornerInFace(geometry_, faceOf(side), cornerOf(side));
      // Most ends on curved surfaces have another length, for which no direction is needed.
      if (!(std::abs(toSource.norm() - length) <= rounding)) return false;
      const Vec2 seen = rotate(geometry_.vertexToFace[side], solver.logVector(end) / -2);
      return (seen - toSource).norm() <= rounding;
    };
    const bool byTail = seesSource(h);
    const bool byHead = seesSource(next(h));
    // In the tangent plane of a vertex, whose angles are scaled, interpolation is not exact.
    if (byTail && (!byHead || angleScale_ != 1)) {
      asked.head = -1;
    } else if (byHead && !byTail) {
      asked.tail = -1;
    }
  }
  asked_.push_back(asked);
  return true;
}

void SourceVectors::take(const Asked& asked, double distance) {
  const auto isKnown = [&](int v) { return v >= 0 && states_[v] == State::kKnown; };
  const auto turned = [&](const Vec2& turn, int v) {
    return rotate(angleScale_ == 1 ? turn : unitVector(angleScale_ * angleOf(turn)), vectors_[v]);
  };
  Vec2 vector = Vec2::Zero();
  if (isKnown(asked.tail) && isKnown(asked.head)) {
    vector = (1 - asked.part) * vectors_[asked.tail] + asked.part * vectors_[asked.head];
  } else if (isKnown(asked.head)) {
    vector = turned(asked.fromHead, asked.head);
  }
  // The interpolated vector may vanish if the ends lie on opposite sides of the source.
  if (!(vector.norm() > 0) && isKnown(asked.tail)) {
    vector = turned(asked.fromTail, asked.tail);
  }
  const double length = vector.norm();
  vectors_[asked.vertex] = length > 0 ? Vec2(distance / length * vector) : Vec2::Zero();
  states_[asked.vertex] = State::kKnown;
}

}  // namespace karcher
