#include "rcm/field_blend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "intrinsic/angles.h"

namespace karcher {
namespace {

/// A field's values at the corners of a face, in its frame.
struct FaceValues {
  Vec2 gradients[3];
  double squaredDistances[3];
  bool isStraight = false;  ///< whether all corners see the source at one place of the plane
};

/// Whether the distances of the corners of a face can be those from one place in its plane.
bool mayHaveOneSource(const Geometry& geometry, int face, const double (&squares)[3], double size) {
  const double edge = geometry.edgeLength[3 * face];
  const Vec2& apex = geometry.apex[face];
  const double x = (squares[0] - squares[1] + edge * edge) / (2 * edge);
  const double y =
      (squares[0] - squares[2] + apex.squaredNorm() - 2 * apex.x() * x) / (2 * apex.y());
  return std::abs(x * x + y * y - squares[0]) <= kChainRounding * size;
}

/// Replaces the gradients by those of straight paths, if all corners of the face see the source at
/// one place in its plane: if the place that the nearest corner sees, by the unscaled direction of
/// its path, has the distances of the others.
void straighten(const Geometry& geometry, int face, FaceValues& values) {
  const double(&squares)[3] = values.squaredDistances;
  int nearest = 0;
  double size = 0;
  for (int k = 0; k < 3; ++k) {
    if (squares[k] < squares[nearest]) nearest = k;
    const int h = 3 * face + k;
    size += squares[k] + geometry.edgeLength[h] * geometry.edgeLength[h];
  }
  if (!mayHaveOneSource(geometry, face, squares, size)) return;
  const Vec2 corner = cornerInFace(geometry, face, nearest);
  const Vec2 toSource = values.gradients[nearest] / -2;
  // The frames of a vertex and of a face agree in the direction of the face's centroid.
  const Vec2 centroid = (Vec2(geometry.edgeLength[3 * face], 0) + geometry.apex[face]) / 3;
  const double scaled = angleFromTo(centroid - corner, toSource);
  const double unscaled = scaled / geometry.angleScale[geometry.mesh->corner(face, nearest)];
  const Vec2 source = corner + rotate(unitVector(unscaled - scaled), toSource);
  Vec2 straight[3];
  for (int k = 0; k < 3; ++k) {
    const Vec2 fromSource = cornerInFace(geometry, face, k) - source;
    if (!(std::abs(fromSource.squaredNorm() - squares[k]) <= kChainRounding * size)) return;
    straight[k] = 2 * fromSource;
  }
  std::copy(straight, straight + 3, values.gradients);
  values.isStraight = true;
}

FaceValues valuesInFace(const Geometry& geometry, ControlField& field, int face) {
  FaceValues values;
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * face + k;
    const FieldValue& value = field.at(geometry.mesh->tail(h));
    values.gradients[k] = rotate(geometry.vertexToFace[h], value.gradient);
    values.squaredDistances[k] = value.squaredDistance;
  }
  if (field.isOfPaths() && hasTurnedFrame(geometry, face)) straighten(geometry, face, values);
  return values;
}

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
  straight_.resize(shapes_.size() * fields_.size());
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
  for (int i = 0; i < fields_.count(); ++i) {
    const FaceValues values = valuesInFace(geometry_, *fields_[i], point.face);
    for (int k = 0; k < 3; ++k) {
      if (point.bary[k] == 0) continue;
      const Vec2 step = x - cornerInFace(geometry_, point.face, k);
      sum += weights.data()[i] * point.bary[k] *
             (values.squaredDistances[k] + values.gradients[k].dot(step) / 2);
    }
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

EdgeValues FieldBlend::valuesAlongEdge(int i, int h, int half) {
  ControlField& field = *fields_[i];
  if (field.isOfPaths() && !cells_.cut()) {
    for (const int side : {h, geometry_.mesh->twin[h]}) {
      if (side < 0 || !hasTurnedFrame(geometry_, faceOf(side))) continue;
      const int slot = slotOf(faceOf(side));
      if (straight_[static_cast<ptrdiff_t>(slot) * fields_.count() + i] == 0) continue;
      const double* vectors = vectorsOf(slot) + 6 * i;
      const auto inEdge = [&](int corner) {
        return rotateBack(halfedgeInFace(geometry_, side) / geometry_.edgeLength[side],
                          Vec2(vectors[2 * corner], vectors[2 * corner + 1]));
      };
      const EdgeValues values{inEdge(cornerOf(side)), inEdge(cornerOf(next(side)))};
      return side == h ? values : EdgeValues{-values.head, -values.tail};
    }
  }
  EdgeValues values = valuesAtEnds(geometry_, field, h);
  if (cells_.cut()) (half == 0 ? values.head : values.tail) = midpointInEdge(geometry_, field, h);
  return values;
}

void FieldBlend::alongEdge(int h, int half, EdgeField& result) {
  result.fields.clear();
  for (int i = 0; i < fields_.count(); ++i) result.fields.push_back(valuesAlongEdge(i, h, half));
}

EdgeValues FieldBlend::blendAlongEdge(int h, int half, Weights weights) {
  EdgeValues sum;
  for (int i = 0; i < fields_.count(); ++i) {
    EdgeField::add(weights.data()[i], valuesAlongEdge(i, h, half), sum);
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
    straight_.resize(room * fields_.size());
    shapes_.resize(room);
  }
  double* out = vectors_.data() + static_cast<ptrdiff_t>(slot) * width_;
  if (cells_.cut()) {
    fillCut(out, cell);
    shapes_[slot] = shapeOf(cell);
    return;
  }
  shapes_[slot] = shapeOf(cell);
  const double bound = shapes_[slot].holonomy;
  char* straight = straight_.data() + static_cast<ptrdiff_t>(slot) * fields_.count();
  for (ControlField* field : fields_) {
    const FaceValues values = valuesInFace(geometry_, *field, cell);
    for (const Vec2& vector : values.gradients) {
      *out++ = vector.x();
      *out++ = vector.y();
    }
    *straight++ = values.isStraight;
    // A straight field may meet one of scaled angles at an edge, and differ twice as much from it.
    if (values.isStraight) shapes_[slot].holonomy = std::min(1.0, 2 * bound);
  }
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
