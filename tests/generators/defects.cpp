#include "generators/defects.h"

#include <utility>

namespace karcher {

const char* defectName(Defect defect) {
  switch (defect) {
    case Defect::kOnALine:
      return "triangle on a line";
    case Defect::kRepeatedCorner:
      return "repeated corner";
    case Defect::kDuplicate:
      return "duplicate face";
    case Defect::kDuplicateTurned:
      return "duplicate face, turned over";
    case Defect::kTurnedOver:
      return "face turned over";
    case Defect::kFin:
      return "third face on an edge";
    case Defect::kBowTie:
      return "bow-tie vertex";
    case Defect::kShortEdge:
      return "edge of 1e-16 of the diagonal";
    case Defect::kNotANumber:
      return "unused vertex that is no number";
    case Defect::kSeams:
      return "triangles with vertices of their own";
  }
  return "";
}

Repair::Kind repairOf(Defect defect) {
  switch (defect) {
    case Defect::kOnALine:
      return Repair::Kind::kNoArea;
    case Defect::kRepeatedCorner:
      return Repair::Kind::kRepeatedCorner;
    case Defect::kDuplicate:
    case Defect::kDuplicateTurned:
      return Repair::Kind::kDuplicate;
    case Defect::kTurnedOver:
      return Repair::Kind::kTurnedOver;
    case Defect::kFin:
      return Repair::Kind::kBranching;
    case Defect::kBowTie:
      return Repair::Kind::kBowTie;
    case Defect::kShortEdge:
      return Repair::Kind::kContracted;
    case Defect::kNotANumber:
      return Repair::Kind::kDropped;
    case Defect::kSeams:
      break;
  }
  return Repair::Kind::kWelded;
}

DefectiveMesh::DefectiveMesh(TriangleSoup sound, uint64_t seed)
    : mesh_(buildMesh(sound.positions, sound.triangles)),
      soup_(std::move(sound)),
      taken_(soup_.positions.size(), 0),
      random_(seed),
      diagonal_(boundingBoxDiagonal(mesh_)) {}

int DefectiveMesh::takeVertex() {
  constexpr int kMostTries = 1000;
  for (int i = 0; i < kMostTries; ++i) {
    const int v = random_.index(mesh_.vertexCount());
    bool free = !mesh_.onBoundary[v] && !taken_[v];
    for (const int h : outgoingHalfedges(mesh_, v)) free = free && !taken_[mesh_.head(h)];
    if (!free) continue;
    taken_[v] = 1;
    for (const int h : outgoingHalfedges(mesh_, v)) taken_[mesh_.head(h)] = 1;
    return v;
  }
  return -1;
}

int DefectiveMesh::takeFace() {
  const int v = takeVertex();
  return v < 0 ? -1 : faceOf(mesh_.outgoing[v]);
}

int DefectiveMesh::add(Defect defect, int count) {
  if (defect == Defect::kSeams) return explode();
  int added = 0;
  for (; added < count; ++added) {
    const int f = takeFace();
    if (f < 0) break;
    const Triangle t = mesh_.faces[f];
    const Vec3 a = soup_.positions[t[0]];
    const Vec3 normal = (soup_.positions[t[1]] - a).cross(soup_.positions[t[2]] - a).normalized();
    const double edge = (soup_.positions[t[1]] - a).norm();
    const int next = soup_.positions.count();
    switch (defect) {
      case Defect::kOnALine:
        putOnALine(f);
        break;
      case Defect::kRepeatedCorner:
        soup_.triangles.emplace_back(t[0], t[1], t[0]);
        break;
      case Defect::kDuplicate:
        soup_.triangles.emplace_back(t[1], t[2], t[0]);
        break;
      case Defect::kDuplicateTurned:
        soup_.triangles.emplace_back(t[1], t[0], t[2]);
        break;
      case Defect::kTurnedOver:
        std::swap(soup_.triangles[f][0], soup_.triangles[f][1]);
        break;
      case Defect::kFin:
        soup_.positions.push_back(a + edge * normal);
        soup_.triangles.emplace_back(t[0], t[1], next);
        break;
      case Defect::kBowTie: {
        for (const Vec3& corner :
             {Vec3(a + edge * normal), Vec3(soup_.positions[t[1]] + 2 * edge * normal),
              Vec3(soup_.positions[t[2]] + 2 * edge * normal)}) {
          soup_.positions.push_back(corner);
        }
        for (const Triangle& face :
             {Triangle(t[0], next, next + 1), Triangle(t[0], next + 1, next + 2),
              Triangle(t[0], next + 2, next), Triangle(next, next + 2, next + 1)}) {
          soup_.triangles.push_back(face);
        }
        break;
      }
      case Defect::kShortEdge: {
        const Vec3 normalised = soup_.positions[t[0]];
        splitVertex(t[0]);
        soup_.positions.back() = normalised + 1e-16 * diagonal_ * normal;
        break;
      }
      case Defect::kNotANumber:
        soup_.positions.push_back(Vec3::Constant(std::nan("")));
        break;
      case Defect::kSeams:
        break;
    }
  }
  return added;
}

/// Cuts the face across the first edge of face f in the edge's middle m, and fills the gap by a
/// triangle a, b, m.
void DefectiveMesh::putOnALine(int f) {
  const int h = 3 * f;
  const int across = mesh_.twin[h];
  const int a = mesh_.tail(h);
  const int b = mesh_.head(h);
  const int d = mesh_.opposite(across);
  const int m = soup_.positions.count();
  soup_.positions.push_back((soup_.positions[a] + soup_.positions[b]) / 2);
  soup_.triangles[faceOf(across)] = {b, m, d};
  soup_.triangles.emplace_back(m, a, d);
  soup_.triangles.emplace_back(b, a, m);
}

/// Splits vertex v: the last vertex takes half of its faces, and two faces fill the edge between.
void DefectiveMesh::splitVertex(int v) {
  const int added = soup_.positions.count();
  soup_.positions.push_back(Vec3(soup_.positions[v]));
  Array<int> fan;
  for (const int h : outgoingHalfedges(mesh_, v)) fan.push_back(h);
  const int half = fan.count() / 2;
  for (int i = 0; i < half; ++i) soup_.triangles[faceOf(fan[i])][cornerOf(fan[i])] = added;
  soup_.triangles.emplace_back(v, mesh_.head(fan[0]), added);
  soup_.triangles.emplace_back(added, mesh_.head(fan[half]), v);
}

int DefectiveMesh::explode() {
  TriangleSoup apart;
  Array<uint8_t> used(soup_.positions.size(), 0);
  int vertices = 0;
  for (const Triangle& t : soup_.triangles) {
    const int first = apart.positions.count();
    for (const int v : t) {
      vertices += used[v] == 0;
      used[v] = 1;
      const Vec3 shift(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1));
      apart.positions.push_back(soup_.positions[v] + 0.5e-9 * diagonal_ * shift);
    }
    apart.triangles.emplace_back(first, first + 1, first + 2);
  }
  soup_ = std::move(apart);
  return soup_.positions.count() - vertices;
}

}  // namespace karcher
