#include "rcm/field_blend.h"

#include <algorithm>
#include <utility>

namespace karcher {
namespace {

/// Values at the ends of half-edge h, in its frame.
EdgeValues valuesAtEnds(const Geometry& geometry, ControlField& field, int h) {
  const EdgeDirection direction = directionOfEdge(geometry, h);
  return {rotateBack(direction.tail, field.at(geometry.mesh->tail(h)).gradient),
          rotateBack(direction.head, field.at(geometry.mesh->head(h)).gradient)};
}

/// The midpoint correction of a field (ControlField), in the frame of half-edge h. It is 0 on the
/// boundary and for a field without values at midpoints.
Vec2 midpointCorrection(const TriangleMesh& mesh, ControlField& field, int h) {
  const int t = mesh.twin[h];
  if (t < 0 || !field.hasMidpoints()) return Vec2::Zero();
  return h < t ? field.midpointCorrection(h) : Vec2(-field.midpointCorrection(t));
}

Vec2 midpointInEdge(const Geometry& geometry, ControlField& field, int h) {
  const EdgeValues ends = valuesAtEnds(geometry, field, h);
  return (ends.tail + ends.head) / 2 + midpointCorrection(*geometry.mesh, field, h);
}

bool anyHasMidpoints(const Array<ControlField*>& fields) {
  return std::any_of(fields.begin(), fields.end(),
                     [](const ControlField* field) { return field->hasMidpoints(); });
}

}  // namespace

Hessian hessian(const Geometry& geometry, int face, const TriangleField& field) {
  const Vec2& apex = geometry.apex[face];
  const Vec2 alongX = (field.corner[1] - field.corner[0]) / geometry.edgeLength[3 * face];
  const Vec2 alongY = (field.corner[2] - field.corner[0] - apex.x() * alongX) / apex.y();
  return {alongX.x(), (alongX.y() + alongY.x()) / 2, alongY.y()};
}

FieldBlend::FieldBlend(const Geometry& geometry, Array<ControlField*> fields)
    : geometry_(geometry),
      fields_(std::move(fields)),
      cells_(*geometry.mesh, anyHasMidpoints(fields_)),
      width_(6 * fields_.count()) {}

void FieldBlend::setFields(const Array<ControlField*>& fields) {
  fields_ = fields;
  cells_.setCut(anyHasMidpoints(fields_));
  slots_.clear();
  lastCell_ = -1;
  // If memory runs out, the width still fits the vectors.
  const int width = 6 * fields_.count();
  if (width == width_) return;
  vectors_.resize(shapes_.size() * static_cast<size_t>(width));
  width_ = width;
}

TriangleField FieldBlend::blend(int cell, Weights weights) {
  // The six components of a field lie side by side, so that the sums vectorise.
  const double* vectors = vectorsOf(slotOf(cell));
  double sum[6] = {};
  for (const double w : weights) {
    for (int c = 0; c < 6; ++c) sum[c] += w * vectors[c];
    vectors += 6;
  }
  return {{Vec2(sum[0], sum[1]), Vec2(sum[2], sum[3]), Vec2(sum[4], sum[5])}};
}

Vec2 FieldBlend::at(const SurfacePoint& point, Weights weights) {
  const CellPoint place = cells_.at(point);
  return rotate(axisInFace(place.cell), blend(place.cell, weights).at(place.bary));
}

Vec2 FieldBlend::atVertex(int vertex, Weights weights) {
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < fields_.count(); ++i)
    sum += weights.data()[i] * fields_[i]->at(vertex).gradient;
  return sum;
}

double FieldBlend::energy(const SurfacePoint& point, Weights weights) {
  const Vec2 x = pointInFace(geometry_, point);
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    if (point.bary[k] == 0) continue;
    const int vertex = geometry_.mesh->corner(point.face, k);
    double corner = 0;
    for (int i = 0; i < fields_.count(); ++i) {
      corner += weights.data()[i] * fields_[i]->at(vertex).squaredDistance;
    }
    const Vec2 gradient =
        rotate(geometry_.vertexToFace[3 * point.face + k], atVertex(vertex, weights));
    const Vec2 step = x - cornerInFace(geometry_, point.face, k);
    sum += point.bary[k] * (corner + gradient.dot(step) / 2);
  }
  return sum;
}

double FieldBlend::zeroAlongEdge(int h, Weights weights) {
  double alongA = 0;
  double alongB = 0;
  const int cell = faceOf(h);
  if (!cells_.cut() || (cell % 4 < 3 && cornerOf(h) != 1)) {
    // The half-edge is an edge of the mesh or half of one.
    const int edge = !cells_.cut() ? h : 3 * (cell / 4) + (cell % 4 + cornerOf(h)) % 3;
    const EdgeValues values = blendAlongEdge(edge, cornerOf(h) == 2, weights);
    alongA = values.tail.x();
    alongB = values.head.x();
  } else {
    const TriangleField field = blend(cell, weights);
    const CellShape& shape = shapes_[slotOf(cell)];
    const Vec2 corners[3] = {Vec2::Zero(), Vec2(shape.edge, 0), Vec2(shape.apexX, shape.apexY)};
    const int a = cornerOf(h);
    const int b = cornerOf(next(h));
    alongA = field.corner[a].dot(corners[b] - corners[a]);
    alongB = field.corner[b].dot(corners[b] - corners[a]);
  }
  if (alongA == alongB) return 0.5;
  return std::clamp(alongA / (alongA - alongB), 0.0, 1.0);
}

EdgeValues FieldBlend::valuesAlongEdge(ControlField& field, int h, int half) {
  EdgeValues values = valuesAtEnds(geometry_, field, h);
  if (cells_.cut()) (half == 0 ? values.head : values.tail) = midpointInEdge(geometry_, field, h);
  return values;
}

void FieldBlend::alongEdge(int h, int half, EdgeField& result) {
  result.fields.clear();
  for (ControlField* field : fields_) result.fields.push_back(valuesAlongEdge(*field, h, half));
}

EdgeValues FieldBlend::blendAlongEdge(int h, int half, Weights weights) {
  EdgeValues sum;
  for (int i = 0; i < fields_.count(); ++i) {
    EdgeField::add(weights.data()[i], valuesAlongEdge(*fields_[i], h, half), sum);
  }
  return sum;
}

FieldBlend::CellJacobian FieldBlend::jacobian(int cell, const TriangleField& field) const {
  const CellShape shape = shapeOf(cell);
  const Vec2 alongX = (field.corner[1] - field.corner[0]) / shape.edge;
  return {alongX, (field.corner[2] - field.corner[0] - shape.apexX * alongX) / shape.apexY};
}

Vec2 FieldBlend::axisInFace(int cell) const {
  if (!cells_.cut()) return Vec2(1, 0);
  const int face = cell / 4;
  if (cell % 4 == 3) return geometry_.apex[face].normalized();
  return halfedgeInFace(geometry_, 3 * face + cell % 4).normalized();
}

FieldBlend::CellShape FieldBlend::shapeOf(int cell) const {
  const auto holonomy = [&](int face, int k) {
    const double bend = std::abs(geometry_.angleScale[geometry_.mesh->corner(face, k)] - 1);
    return std::min(1.0, kPi * bend);
  };
  if (!cells_.cut()) {
    const Vec2& apex = geometry_.apex[cell];
    return {geometry_.edgeLength[3 * cell], apex.x(), apex.y(),
            std::max({holonomy(cell, 0), holonomy(cell, 1), holonomy(cell, 2)})};
  }
  const int face = cell / 4;
  const int k = cell % 4;
  if (k < 3) {
    const Vec2 apex = oppositeOverHalfedge(geometry_, 3 * face + k) / 2;
    return {geometry_.edgeLength[3 * face + k] / 2, apex.x(), apex.y(), holonomy(face, k)};
  }
  const Vec2& side = geometry_.apex[face];
  const double length = side.norm();
  const Vec2 apex = rotateBack(side / length, side - Vec2(geometry_.edgeLength[3 * face], 0)) / 2;
  // Within a face the cells' fields are continuous.
  return {length / 2, apex.x(), apex.y(), 0};
}

int FieldBlend::findSlot(int cell) {
  int slot = slots_.find(cell);
  if (slot < 0) {
    slot = slots_.count();
    fillSlot(slot, cell);
    // The evaluation of a field may throw, so the slot is added after it.
    slots_.add(cell);
  }
  lastCell_ = cell;
  lastSlot_ = slot;
  return slot;
}

void FieldBlend::fillSlot(int slot, int cell) {
  if (slot == shapes_.count()) {
    // A segment of a curve passes some dozens of cells, so the blend reserves memory for many at
    // once.
    const size_t room = static_cast<size_t>(slot == 0 ? 32 : 2 * slot);
    vectors_.resize(room * static_cast<size_t>(width_));
    shapes_.resize(room);
  }
  double* out = vectors_.data() + static_cast<ptrdiff_t>(slot) * width_;
  if (cells_.cut()) {
    fillCut(out, cell);
    shapes_[slot] = shapeOf(cell);
    return;
  }
  double bend = 0;
  for (int k = 0; k < 3; ++k) {
    const int vertex = geometry_.mesh->corner(cell, k);
    bend = std::max(bend, std::abs(geometry_.angleScale[vertex] - 1));
    const Vec2& rotation = geometry_.vertexToFace[3 * cell + k];
    double* at = out + 2 * k;
    for (ControlField* field : fields_) {
      const Vec2 vector = rotate(rotation, field->at(vertex).gradient);
      at[0] = vector.x();
      at[1] = vector.y();
      at += 6;
    }
  }
  const Vec2& apex = geometry_.apex[cell];
  shapes_[slot] = {geometry_.edgeLength[3 * cell], apex.x(), apex.y(), std::min(1.0, kPi * bend)};
}

/// Writes the vectors of all fields in a cell of a divided face.
void FieldBlend::fillCut(double* out, int cell) {
  const Vec2 axis = axisInFace(cell);
  const int first = 3 * (cell / 4);
  const int c = cell % 4;
  for (ControlField* field : fields_) {
    for (int k = 0; k < 3; ++k) {
      const int h = first + (c == 3 ? k : k == 2 ? (c + 2) % 3 : c);
      const Vec2 inFace = c < 3 && k == 0 ? rotate(geometry_.vertexToFace[h],
                                                   field->at(geometry_.mesh->tail(h)).gradient)
                                          : rotate(halfedgeInFace(geometry_, h).normalized(),
                                                   midpointInEdge(geometry_, *field, h));
      const Vec2 vector = rotateBack(axis, inFace);
      *out++ = vector.x();
      *out++ = vector.y();
    }
  }
}

}  // namespace karcher
