#include "mesh/mesh_import.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/morton.h"
#include "mesh/obj_reader.h"
#include "mesh/welding.h"

namespace karcher {
namespace {

/// "1 vertex", "2 vertices".
std::string counted(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

Array<int> usedVertices(const TriangleSoup& soup) {
  Array<uint8_t> used(soup.positions.size(), 0);
  for (const Triangle& t : soup.triangles) {
    for (const int v : t) used[v] = 1;
  }
  Array<int> result;
  result.reserve(soup.positions.size());
  for (int v = 0; v < soup.positions.count(); ++v) {
    if (used[v]) result.push_back(v);
  }
  return result;
}

/// Engine vertices follow `order`, one for each set of welded vertices.
void numberVertices(const Array<int>& order, const Welding& welding, Numbering& numbering) {
  numbering.engineVertex.assign(welding.target.size(), -1);
  for (const int v : order) {
    const int target = welding.target[v];
    if (numbering.engineVertex[target] < 0) {
      numbering.engineVertex[target] = numbering.inputVertex.count();
      numbering.inputVertex.push_back(target);
    }
    numbering.engineVertex[v] = numbering.engineVertex[target];
  }
}

/// Engine faces follow their smallest engine vertex, and so the same curve.
Array<Triangle> orderFaces(const Array<Triangle>& triangles, Numbering& numbering) {
  const auto smallest = [&](const Triangle& t) {
    return std::min(
        {numbering.engineVertex[t[0]], numbering.engineVertex[t[1]], numbering.engineVertex[t[2]]});
  };
  Array<int> slot(numbering.inputVertex.size() + 1, 0);
  for (const Triangle& t : triangles) ++slot[smallest(t) + 1];
  std::partial_sum(slot.begin(), slot.end(), slot.begin());
  Array<Triangle> faces(triangles.size());
  numbering.engineFace.resize(triangles.size());
  numbering.inputFace.resize(triangles.size());
  for (int t = 0; t < triangles.count(); ++t) {
    const int f = slot[smallest(triangles[t])]++;
    numbering.engineFace[t] = f;
    numbering.inputFace[f] = t;
    for (int k = 0; k < 3; ++k) faces[f][k] = numbering.engineVertex[triangles[t][k]];
  }
  return faces;
}

void reportWelding(const Welding& welding, Array<Repair>& repairs) {
  if (welding.welded > 0) {
    repairs.push_back({Repair::Kind::kWelded, welding.welded,
                       counted(welding.welded, "vertex was", "vertices were") +
                           " welded to another at the same position"});
  }
  if (welding.keptApart > 0) {
    repairs.push_back({Repair::Kind::kKeptApart, welding.keptApart,
                       counted(welding.keptApart, "vertex", "vertices") +
                           " at the position of another stayed apart, where no edge joins their "
                           "faces"});
  }
}

}  // namespace

const char* repairName(Repair::Kind kind) {
  switch (kind) {
    case Repair::Kind::kTriangulated:
      return "triangulated";
    case Repair::Kind::kWelded:
      return "welded";
    case Repair::Kind::kKeptApart:
      return "keptApart";
    case Repair::Kind::kDropped:
      return "dropped";
  }
  return "unknown";
}

ImportedMesh importMesh(TriangleSoup soup) {
  checkTriangles(soup.positions, soup.triangles);
  ImportedMesh result;
  Numbering& numbering = result.numbering;
  Array<int> order = usedVertices(soup);
  const int dropped = soup.positions.count() - order.count();
  {
    order = mortonOrder(soup.positions, std::move(order));
    const Welding welding = findWelding(soup, order);
    numberVertices(order, welding, numbering);
    reportWelding(welding, result.repairs);
  }
  if (dropped > 0) {
    result.repairs.push_back(
        {Repair::Kind::kDropped, dropped,
         counted(dropped, "vertex that no face uses was", "vertices that no face uses were") +
             " left out"});
  }
  Array<Triangle> faces = orderFaces(soup.triangles, numbering);
  for (int v = 0; v < soup.positions.count(); ++v) {
    if (numbering.engineVertex[v] < 0) result.droppedPositions.push_back(soup.positions[v]);
  }
  Array<Vec3> positions;
  positions.reserve(numbering.inputVertex.size());
  for (const int v : numbering.inputVertex) positions.push_back(soup.positions[v]);
  soup = {};
  result.mesh = connectMesh(std::move(positions), std::move(faces),
                            {&numbering.inputVertex, &numbering.inputFace});
  return result;
}

ImportedMesh importObj(std::string_view bytes) {
  ObjContents contents = readObj(bytes);
  ImportedMesh result = importMesh(std::move(contents.soup));
  if (contents.polygonsCut > 0) {
    result.repairs.insert(
        result.repairs.begin(),
        {Repair::Kind::kTriangulated, contents.polygonsCut,
         counted(contents.polygonsCut, "polygon was", "polygons were") + " cut into triangles"});
  }
  return result;
}

}  // namespace karcher
