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
    : geometry_(geometry), fields_(std::move(fields)) {
  table_.resize(256);
  vectors_.reserve(static_cast<size_t>(64 * 6 * fieldCount()));
}

TriangleField FieldBlend::blend(int face, Weights weights) {
  // Six components a field side by side, so that the sums vectorise.
  const double* vectors = transported(face);
  double sum[6] = {};
  for (const double w : weights) {
    for (int c = 0; c < 6; ++c) sum[c] += w * vectors[c];
    vectors += 6;
  }
  return {{Vec2(sum[0], sum[1]), Vec2(sum[2], sum[3]), Vec2(sum[4], sum[5])}};
}

bool FieldBlend::findZero(int face, Weights weights, FaceZero& zero) {
  const double* v = transported(face);
  double sum[6] = {};
  for (const double w : weights) {
    for (int c = 0; c < 6; ++c) sum[c] += w * v[c];
    v += 6;
  }
  const double x0 = sum[0], y0 = sum[1], x1 = sum[2], y1 = sum[3], x2 = sum[4], y2 = sum[5];
  // hessian(...).positiveDefinite(), without its divisions.
  const double apexX = geometry_.apex[face].x();
  const double apexY = geometry_.apex[face].y();
  const double xx = apexY * (x1 - x0);
  const double yy = geometry_.edgeLength[3 * face] * (y2 - y0) - apexX * (y1 - y0);
  const double xy =
      (apexY * (y1 - y0) + geometry_.edgeLength[3 * face] * (x2 - x0) - apexX * (x1 - x0)) / 2;
  if (!(xx > 0 && xx * yy > xy * xy)) return false;
  const double b0 = x1 * y2 - y1 * x2;
  const double b1 = x2 * y0 - y2 * x0;
  const double b2 = x0 * y1 - y0 * x1;
  zero.determinant = b0 + b1 + b2;
  zero.jump = jumps_[lastSlot_];
  const double scale = 1 / zero.determinant;
  zero.bary[0] = b0 * scale;
  zero.bary[1] = b1 * scale;
  zero.bary[2] = b2 * scale;
  zero.field.corner[0] = Vec2(x0, y0);
  zero.field.corner[1] = Vec2(x1, y1);
  zero.field.corner[2] = Vec2(x2, y2);
  return true;
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

const double* FieldBlend::transported(int face) {
  if (face != lastFace_) {
    lastSlot_ = slotOf(face);
    lastFace_ = face;
  }
  return vectors_.data() + static_cast<size_t>(lastSlot_) * static_cast<size_t>(6 * fieldCount());
}

int FieldBlend::slotOf(int face) {
  const size_t mask = table_.size() - 1;
  size_t place = hashOf(face) & mask;
  while (table_[place].face != -1) {
    if (table_[place].face == face) return table_[place].slot;
    place = (place + 1) & mask;
  }
  const size_t width = static_cast<size_t>(6 * fieldCount());
  const size_t begin = static_cast<size_t>(slotCount_) * width;
  vectors_.resize(begin + width);
  jumps_.resize(static_cast<size_t>(slotCount_) + 1);
  double bend = 0;
  for (int k = 0; k < 3; ++k) {
    const int vertex = geometry_.mesh->corner(face, k);
    bend = std::max(bend, std::abs(geometry_.angleScale[vertex] - 1));
    const Vec2& rotation = geometry_.vertexToFace[3 * face + k];
    double* out = vectors_.data() + begin + 2 * k;
    for (ControlField* field : fields_) {
      const Vec2 vector = rotate(rotation, field->at(vertex).gradient);
      out[0] = vector.x();
      out[1] = vector.y();
      out += 6;
    }
  }
  jumps_[slotCount_] = std::min(1.0, kPi * bend);
  // Only now, since a field's evaluation may throw.
  table_[place] = {face, slotCount_};
  const int slot = slotCount_++;
  if (2 * static_cast<size_t>(slotCount_) > table_.size()) growTable();
  return slot;
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
