#include "rcm/field_blend.h"

#include <algorithm>
#include <utility>

namespace karcher {
namespace {

size_t hashOf(int face) { return static_cast<size_t>(static_cast<uint32_t>(face) * 2654435761u); }

/// The direction of half-edge h, in the frames of its ends; at the head the way on.
EdgeValues directionOfEdge(const Geometry& geometry, int h) {
  const int onward = next(h);
  const double back = geometry.cumulatedAngle[onward] + geometry.cornerAngle[onward];
  return {unitVector(geometry.angleScale[geometry.mesh->tail(h)] * geometry.cumulatedAngle[h]),
          unitVector(geometry.angleScale[geometry.mesh->head(h)] * back + kPi)};
}

}  // namespace

Hessian hessian(const Geometry& geometry, int face, const TriangleField& field) {
  const Vec2& apex = geometry.apex[face];
  const Vec2 alongX = (field.corner[1] - field.corner[0]) / geometry.edgeLength[3 * face];
  const Vec2 alongY = (field.corner[2] - field.corner[0] - apex.x() * alongX) / apex.y();
  return {alongX.x(), (alongX.y() + alongY.x()) / 2, alongY.y()};
}

FieldBlend::FieldBlend(const Geometry& geometry, Array<ControlField*> fields)
    : geometry_(geometry), fields_(std::move(fields)), width_(6 * fields_.count()) {
  table_.resize(256);
}

TriangleField FieldBlend::blend(int face, Weights weights) {
  // Six components a field side by side, so that the sums vectorise.
  const double* vectors = vectorsOf(slotOf(face));
  double sum[6] = {};
  for (const double w : weights) {
    for (int c = 0; c < 6; ++c) sum[c] += w * vectors[c];
    vectors += 6;
  }
  return {{Vec2(sum[0], sum[1]), Vec2(sum[2], sum[3]), Vec2(sum[4], sum[5])}};
}

Vec2 FieldBlend::atVertex(int vertex, Weights weights) {
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < fields_.count(); ++i)
    sum += weights.data()[i] * fields_[i]->at(vertex).gradient;
  return sum;
}

double FieldBlend::energy(const SurfacePoint& point, Weights weights) {
  const TriangleField field = blend(point.face, weights);
  const Vec2 x = pointInFace(geometry_, point);
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    if (point.bary[k] == 0) continue;
    const int vertex = geometry_.mesh->corner(point.face, k);
    double corner = 0;
    for (int i = 0; i < fields_.count(); ++i) {
      corner += weights.data()[i] * fields_[i]->at(vertex).squaredDistance;
    }
    const Vec2 step = x - cornerInFace(geometry_, point.face, k);
    sum += point.bary[k] * (corner + field.corner[k].dot(step) / 2);
  }
  return sum;
}

double FieldBlend::zeroAlongEdge(int h, Weights weights) {
  const EdgeValues direction = directionOfEdge(geometry_, h);
  const double alongA = atVertex(geometry_.mesh->tail(h), weights).dot(direction.tail);
  const double alongB = atVertex(geometry_.mesh->head(h), weights).dot(direction.head);
  if (alongA == alongB) return 0.5;
  return std::clamp(alongA / (alongA - alongB), 0.0, 1.0);
}

EdgeField FieldBlend::alongEdge(int h) {
  const EdgeValues direction = directionOfEdge(geometry_, h);
  EdgeField result;
  for (ControlField* field : fields_) {
    result.fields.push_back(
        {rotateBack(direction.tail, field->at(geometry_.mesh->tail(h)).gradient),
         rotateBack(direction.head, field->at(geometry_.mesh->head(h)).gradient)});
  }
  return result;
}

int FieldBlend::findSlot(int face) {
  const size_t mask = table_.size() - 1;
  size_t place = hashOf(face) & mask;
  while (table_[place].face != face && table_[place].face != -1) place = (place + 1) & mask;
  int slot = table_[place].slot;
  if (table_[place].face == -1) {
    slot = slotCount_;
    fillSlot(slot, face);
    // Only now, since a field's evaluation may throw.
    table_[place] = {face, slot};
    ++slotCount_;
    if (2 * static_cast<size_t>(slotCount_) > table_.size()) growTable();
  }
  lastFace_ = face;
  lastSlot_ = slot;
  return slot;
}

void FieldBlend::fillSlot(int slot, int face) {
  if (slot == shapes_.count()) {
    // Room for many faces at once: a segment passes some dozens.
    const size_t room = static_cast<size_t>(slot == 0 ? 32 : 2 * slot);
    vectors_.resize(room * static_cast<size_t>(width_));
    shapes_.resize(room);
  }
  double bend = 0;
  for (int k = 0; k < 3; ++k) {
    const int vertex = geometry_.mesh->corner(face, k);
    bend = std::max(bend, std::abs(geometry_.angleScale[vertex] - 1));
    const Vec2& rotation = geometry_.vertexToFace[3 * face + k];
    double* out = vectors_.data() + static_cast<ptrdiff_t>(slot) * width_ + 2 * k;
    for (ControlField* field : fields_) {
      const Vec2 vector = rotate(rotation, field->at(vertex).gradient);
      out[0] = vector.x();
      out[1] = vector.y();
      out += 6;
    }
  }
  const Vec2& apex = geometry_.apex[face];
  shapes_[slot] = {geometry_.edgeLength[3 * face], apex.x(), apex.y(), std::min(1.0, kPi * bend)};
}

void FieldBlend::growTable() {
  Array<Place> larger(2 * table_.size());
  const size_t mask = larger.size() - 1;
  for (const Place& old : table_) {
    if (old.face == -1) continue;
    size_t place = hashOf(old.face) & mask;
    while (larger[place].face != -1) place = (place + 1) & mask;
    larger[place] = old;
  }
  table_ = std::move(larger);
}

}  // namespace karcher
