#include "mesh/mesh_repair.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/error.h"
#include "mesh/flat_triangles.h"
#include "mesh/manifold_repair.h"
#include "mesh/morton.h"
#include "mesh/positions.h"
#include "mesh/rounding.h"
#include "mesh/seams.h"

namespace karcher {
namespace {

/// Edges of at most this length, relative to the diagonal, count as edges without length. So do
/// edges of at most kLocalRounding times the longest edge of their face.
constexpr double kShortOfDiagonal = 1e-14;

/// The vertices that faces use, in ascending order.
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

/// The index of each face after a sort by the smallest vertex, so that faces follow the same curve
/// as vertices.
Array<int> faceOrder(const Array<Triangle>& faces, int vertexCount) {
  Array<int> slot(static_cast<size_t>(vertexCount) + 1, 0);
  for (const Triangle& t : faces) ++slot[t.minCoeff() + 1];
  std::partial_sum(slot.begin(), slot.end(), slot.begin());
  Array<int> order;
  order.reserve(faces.size());
  for (const Triangle& t : faces) order.push_back(slot[t.minCoeff()]++);
  return order;
}

class MeshRepair {
 public:
  MeshRepair(TriangleSoup soup, const ImportOptions& options)
      : soup_(std::move(soup)), options_(options), target_(soup_.positions.count()) {}

  ImportedMesh run() {
    if (std::isnan(options_.weld)) refuse("the tolerance of welding must be a number");
    if (options_.repair) {
      checkCorners(soup_.positions.count(), soup_.triangles);
    } else {
      checkTriangles(soup_.positions, soup_.triangles);
    }
    Array<int> used = usedVertices(soup_);
    const double diagonal = checkPositions(soup_.positions, &used);
    faces_.corners = soup_.triangles;
    faces_.source.resize(soup_.triangles.size());
    std::iota(faces_.source.begin(), faces_.source.end(), 0);

    const int repeated = leaveOutRepeatedCorners();
    tell(Repair::Kind::kContracted, options_.repair ? contractShortEdges(diagonal) : 0);
    used = mortonOrder(soup_.positions, std::move(used));
    const SeamRepairs seams = closeSeams(soup_.positions, used, faces_,
                                         {diagonal, options_.weld, !options_.repair}, target_);
    const int collapsed = leaveOutRepeatedCorners();
    tell(Repair::Kind::kWelded, seams.welded);
    tell(Repair::Kind::kKeptApart, seams.keptApart);
    tell(Repair::Kind::kRepeatedCorner, repeated + collapsed);
    tell(Repair::Kind::kDuplicate, seams.duplicates.count());
    if (options_.repair) {
      tell(Repair::Kind::kNoArea, flipFlatTriangles(soup_.positions, faces_));
      checkFaces();
    }
    number(used);
    connect();
    follow(seams.duplicates);
    lookBeside();
    tell(Repair::Kind::kDropped, result_.droppedPositions.count());
    return std::move(result_);
  }

 private:
  void tell(Repair::Kind kind, int count) { result_.repairs.push_back(repairOf(kind, count)); }

  int leaveOutRepeatedCorners() {
    const int before = faces_.count();
    faces_.leaveOut([&](int f) { return hasRepeatedCorner(faces_.corners[f]); });
    return before - faces_.count();
  }

  /// Contracts short edges, and omits faces that lost an edge. Returns the number of merged
  /// vertices.
  int contractShortEdges(double diagonal) {
    int contracted = 0;
    for (const Triangle& t : faces_.corners) {
      std::array<double, 3> length = {};
      for (int k = 0; k < 3; ++k) {
        length[static_cast<size_t>(k)] =
            (soup_.positions[t[(k + 1) % 3]] - soup_.positions[t[k]]).norm();
      }
      const double longest = std::max({length[0], length[1], length[2]});
      const double limit = std::max(kShortOfDiagonal * diagonal, kLocalRounding * longest);
      for (int k = 0; k < 3; ++k) {
        if (length[static_cast<size_t>(k)] > limit) continue;
        contracted += target_.unite(t[k], t[(k + 1) % 3]) ? 1 : 0;
      }
    }
    if (contracted > 0) {
      faces_.renumber(target_.names());
      leaveOutRepeatedCorners();
    }
    return contracted;
  }

  /// Checks that faces remain, and that each has an area.
  void checkFaces() const {
    if (faces_.corners.empty()) {
      throw Error(ErrorCode::kDegenerateFace,
                  "no face has an area: the corners of each lie on a line, or two are the same");
    }
    for (int f = 0; f < faces_.count(); ++f) {
      checkArea(soup_.positions, faces_.corners[f], faces_.source[f]);
    }
  }

  /// Assigns the engine's numbers: vertices by `order`, faces by their smallest vertex.
  void number(const Array<int>& order) {
    Numbering& numbering = result_.numbering;
    const Array<int> target = target_.names();
    Array<uint8_t> needed(soup_.positions.size(), 0);
    for (const Triangle& t : faces_.corners) {
      for (const int v : t) needed[v] = 1;
    }
    numbering.engineVertex.assign(soup_.positions.size(), -1);
    for (const int v : order) {
      if (!needed[target[v]]) continue;
      int& number = numbering.engineVertex[target[v]];
      if (number < 0) {
        number = numbering.inputVertex.count();
        numbering.inputVertex.push_back(target[v]);
        result_.mesh.positions.push_back(soup_.positions[target[v]]);
      }
      numbering.engineVertex[v] = int(number);
    }
    for (int v = 0; v < soup_.positions.count(); ++v) {
      if (numbering.engineVertex[v] < 0) result_.droppedPositions.push_back(soup_.positions[v]);
    }
    faces_.renumber(numbering.engineVertex);
    const Array<int> place = faceOrder(faces_.corners, numbering.inputVertex.count());
    result_.mesh.faces.resize(faces_.corners.size());
    numbering.inputFace.resize(faces_.corners.size());
    numbering.engineFace.assign(soup_.triangles.size(), kGone);
    for (int i = 0; i < faces_.count(); ++i) {
      const int f = place[i];
      result_.mesh.faces[f] = faces_.corners[i];
      numbering.inputFace[f] = faces_.source[i];
      if (faces_.isWhole(i)) {
        numbering.engineFace[faces_.source[i]] = f;
      } else {
        imageOf(faces_.source[i]).pieces.push_back({f, faces_.weightsOf(i)});
      }
    }
    for (int t = 0; t < soup_.triangles.count(); ++t) {
      if (numbering.engineFace[t] == kGone) imageOf(t);
    }
  }

  void connect() {
    TriangleMesh& mesh = result_.mesh;
    if (!options_.repair) {
      mesh = connectMesh(std::move(mesh.positions), std::move(mesh.faces),
                         {&result_.numbering.inputVertex, &result_.numbering.inputFace});
      return;
    }
    const ManifoldRepairs repairs = connectRepaired(mesh, result_.numbering);
    tell(Repair::Kind::kTurnedOver, repairs.turnedOver);
    tell(Repair::Kind::kBranching, repairs.branching);
    tell(Repair::Kind::kBowTie, repairs.bowTies);
  }

  /// The image of an input triangle that is not a whole face of the engine. Creates it if
  /// necessary.
  FaceImage& imageOf(int t) {
    Numbering& numbering = result_.numbering;
    int& entry = numbering.engineFace[t];
    if (entry == kGone) {
      entry = -1 - numbering.images.count();
      FaceImage image;
      for (int k = 0; k < 3; ++k) {
        const int corner = soup_.triangles[t][k];
        const int v = numbering.engineVertex[corner];
        image.corners[k] = v < 0 ? corner : numbering.inputVertex[v];
        image.places[static_cast<size_t>(k)] = soup_.positions[corner];
      }
      numbering.images.push_back(std::move(image));
    }
    return numbering.images[-1 - entry];
  }

  /// Maps duplicates to the faces that stay.
  void follow(const Array<DuplicateFace>& duplicates) {
    Numbering& numbering = result_.numbering;
    for (const auto& [source, kept, corner] : duplicates) {
      const int f = numbering.engineFace[kept];
      Array<FacePiece> pieces;
      if (f >= 0) {
        pieces.push_back({f, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}});
        if (numbering.isTurnedOver(kept)) std::swap(pieces[0].corners[1], pieces[0].corners[2]);
      } else {
        pieces = numbering.images[-1 - f].pieces;
      }
      for (FacePiece& piece : pieces) {
        for (Vec3& weights : piece.corners) {
          const Vec3 inKept = weights;
          for (size_t k = 0; k < 3; ++k) weights[static_cast<int>(k)] = inKept[corner[k]];
        }
      }
      imageOf(source).pieces = std::move(pieces);
      imageOf(source).isDuplicate = true;
    }
  }

  /// For input triangles without a piece, finds the faces at their corners.
  void lookBeside() {
    Numbering& numbering = result_.numbering;
    const TriangleMesh& mesh = result_.mesh;
    for (FaceImage& image : numbering.images) {
      if (!image.pieces.empty()) continue;
      for (const int corner : image.corners) {
        const int v = numbering.engineVertex[corner];
        if (v < 0) continue;
        for (const int h : outgoingHalfedges(mesh, v)) image.beside.push_back(faceOf(h));
      }
    }
  }

  /// The entry in `engineFace` of a triangle that has no image yet.
  static constexpr int kGone = std::numeric_limits<int>::min();

  TriangleSoup soup_;
  ImportOptions options_;
  DisjointSets target_;  ///< the representatives of the file's vertices
  WorkFaces faces_;
  ImportedMesh result_;
};

}  // namespace

ImportedMesh repairMesh(TriangleSoup soup, const ImportOptions& options) {
  return MeshRepair(std::move(soup), options).run();
}

}  // namespace karcher
