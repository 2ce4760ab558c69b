#include <algorithm>
#include <utility>

#include "curves/isoline.h"
#include "distance/window_distance.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

/// The isoline in a face is the border of the union of disks about the source's images. Each disk
/// counts only where the image's paths reach. The edges of the face, and the two rays that bound an
/// image's paths, cut the image's circle into pieces. The pieces in the face and between the rays
/// remain. Other images with shorter paths undercut parts of these pieces: their circles and rays
/// bound such parts, which are removed. Finally the arcs of all faces join where their ends meet.
namespace karcher {
namespace {

/// The largest distance, in mean edges, between two ends of arcs that may be one point. If an arc
/// grazes an edge or a ray, its end moves by the square root of the rounding error. The nearest
/// ends join first.
constexpr double kMeet = 1e-3;

struct Arc {
  int face = -1;
  Vec2 center = Vec2::Zero();
  double radius = 0;
  double begin = 0;  ///< angles in the frame of the face, counterclockwise
  double end = 0;
  bool isCircle = false;

  Vec2 at(double angle) const { return center + radius * unitVector(angle); }
};

class FaceArcs {
 public:
  FaceArcs(const Geometry& geometry, double distance)
      : geometry_(geometry), distance_(distance), rounding_(kChainRounding * geometry.meanEdge) {}

  /// Appends the isoline's arcs in one face. [begin, end) are the images of the source for this
  /// face.
  void append(const SourceImage* begin, const SourceImage* end, Array<Arc>& arcs) {
    begin_ = begin;
    end_ = end;
    for (const SourceImage* image = begin; image != end; ++image) {
      const double radius = distance_ - image->offset;
      if (radius > rounding_) appendOf(*image, radius, arcs);
    }
  }

 private:
  struct Piece {
    double begin = 0;
    double end = 0;
  };

  void appendOf(const SourceImage& own, double radius, Array<Arc>& arcs) {
    findPieces(own, radius);
    for (const SourceImage* other = begin_; other != end_ && !pieces_.empty(); ++other) {
      if (other != &own) takeUndercut(own, radius, *other);
    }
    const int first = arcs.count();
    for (const Piece& piece : pieces_) {
      arcs.push_back({own.face, own.source, radius, piece.begin, piece.end, false});
    }
    joinRound(first, arcs);
  }

  /// Finds the pieces of an image's circle that lie in the face and between the image's rays.
  void findPieces(const SourceImage& own, double radius) {
    cuts_.clear();
    for (int k = 0; k < 3; ++k) {
      const Vec2 corner = cornerInFace(geometry_, own.face, k);
      cutByLine(own, radius, corner, cornerInFace(geometry_, own.face, (k + 1) % 3) - corner);
    }
    if (!own.isFull) {
      cutByLine(own, radius, own.source, own.right);
      cutByLine(own, radius, own.source, own.left);
    }
    std::sort(cuts_.begin(), cuts_.end());
    first_ = cuts_.empty() ? 0 : cuts_.front();
    const Array<Piece> whole{{first_, first_ + 2 * kPi}};
    pieces_.clear();
    keepPieces(whole, radius, [&](double angle) {
      const Vec2 x = own.source + radius * unitVector(angle);
      return barycentric(geometry_, own.face, x).minCoeff() >= 0 && holds(own, x, 0);
    });
  }

  /// Removes from the pieces the parts that another image undercuts.
  void takeUndercut(const SourceImage& own, double radius, const SourceImage& other) {
    cuts_.clear();
    cutByCircle(own, radius, other);
    if (!other.isFull) {
      cutByLine(own, radius, other.source, other.right);
      cutByLine(own, radius, other.source, other.left);
    }
    for (double& cut : cuts_) {
      if (cut < first_) cut += 2 * kPi;
    }
    std::sort(cuts_.begin(), cuts_.end());
    before_.swap(pieces_);
    pieces_.clear();
    keepPieces(before_, radius, [&](double angle) {
      return !undercuts(other, own, own.source + radius * unitVector(angle));
    });
  }

  /// Divides pieces at the cuts, and appends each part whose middle satisfies `isKept`. Adjacent
  /// parts merge into one piece.
  template <typename IsKept>
  void keepPieces(const Array<Piece>& from, double radius, const IsKept& isKept) {
    for (const Piece& piece : from) {
      double begin = piece.begin;
      const auto keepTo = [&](double end) {
        const double start = std::exchange(begin, end);
        if (!((end - start) * radius > rounding_) || !isKept((start + end) / 2)) return;
        const bool goesOn = !pieces_.empty() && (start - pieces_.back().end) * radius <= rounding_;
        if (goesOn) {
          pieces_.back().end = end;
        } else {
          pieces_.push_back({start, end});
        }
      };
      for (const double cut : cuts_) {
        if (cut > piece.begin && cut < piece.end) keepTo(cut);
      }
      keepTo(piece.end);
    }
  }

  /// Joins the last and the first arc of a circle if no gap separates them. If there is only one
  /// arc, it becomes a full circle.
  void joinRound(int first, Array<Arc>& arcs) {
    if (arcs.count() == first) return;
    Arc& begin = arcs[first];
    const double gap = begin.begin + 2 * kPi - arcs.back().end;
    if (gap * begin.radius > rounding_) return;
    if (arcs.count() == first + 1) {
      begin.isCircle = true;
    } else {
      begin.begin = arcs.back().begin - 2 * kPi;
      arcs.pop_back();
    }
  }

  void cutByLine(const SourceImage& own, double radius, const Vec2& through,
                 const Vec2& direction) {
    const Vec2 along = direction.normalized();
    const Vec2 to = through - own.source;
    const double height = cross(along, to);
    const double squared = radius * radius - height * height;
    if (squared < 0) return;
    const Vec2 foot = to - to.dot(along) * along;
    for (const double sign : {-1.0, 1.0}) addCut(foot + sign * std::sqrt(squared) * along);
  }

  void cutByCircle(const SourceImage& own, double radius, const SourceImage& other) {
    const double otherRadius = distance_ - other.offset;
    const Vec2 to = other.source - own.source;
    const double apart = to.norm();
    if (!(apart > rounding_) || !(otherRadius > 0)) return;
    const double along =
        (apart * apart + radius * radius - otherRadius * otherRadius) / (2 * apart);
    const double squared = radius * radius - along * along;
    if (squared < 0) return;
    const Vec2 unit = to / apart;
    const Vec2 across(-unit.y(), unit.x());
    for (const double sign : {-1.0, 1.0}) addCut(along * unit + sign * std::sqrt(squared) * across);
  }

  void addCut(const Vec2& fromSource) {
    const double angle = angleOf(fromSource);
    cuts_.push_back(angle < 0 ? angle + 2 * kPi : angle);
  }

  /// Whether another image has a shorter path to a point of the circle. If both paths are equally
  /// long, the path of the earlier image counts as shorter.
  bool undercuts(const SourceImage& other, const SourceImage& own, const Vec2& x) const {
    if (!holds(other, x, rounding_)) return false;
    const double way = other.offset + (x - other.source).norm();
    return way < distance_ - rounding_ || (way <= distance_ + rounding_ && &other < &own);
  }

  static bool holds(const SourceImage& image, const Vec2& x, double margin) {
    if (image.isFull) return true;
    const Vec2 to = x - image.source;
    return cross(image.right, to) >= -margin && cross(to, image.left) >= -margin &&
           (image.right + image.left).dot(to) >= 0;
  }

  const Geometry& geometry_;
  double distance_;
  double rounding_;
  const SourceImage* begin_ = nullptr;
  const SourceImage* end_ = nullptr;
  Array<double> cuts_;
  /// The pieces of the current circle, with angles from `first_` to `first_` plus a full turn.
  Array<Piece> pieces_;
  Array<Piece> before_;
  double first_ = 0;
};

/// Joins arcs where their ends meet.
class ArcChains {
 public:
  ArcChains(const Geometry& geometry, const Array<Arc>& arcs, double tolerance)
      : geometry_(geometry), arcs_(arcs), tolerance_(tolerance * geometry.meanEdge) {}

  Array<Isoline> run() {
    pairEnds();
    Array<uint8_t> used(arcs_.size(), 0);
    Array<Isoline> isolines;
    const auto follow = [&](int end) {
      Isoline line;
      line.closed = false;
      // The chain follows an arc to its other end, and continues with the arc whose end meets that
      // end.
      while (end >= 0 && !used[end / 2]) {
        used[end / 2] = 1;
        appendArc(end, line);
        end = partner_[end ^ 1];
      }
      line.closed = end >= 0 || arcs_[first_ / 2].isCircle;
      // A short open line is a scrap: the ends next to its own are paired with other ends.
      if (!line.closed && line.length <= kMeet * geometry_.meanEdge) return;
      if (line.closed) line.points.push_back(line.points.front());
      isolines.push_back(std::move(line));
    };
    for (first_ = 0; first_ < 2 * arcs_.count(); ++first_) {
      if (!used[first_ / 2] && partner_[first_] < 0 && !arcs_[first_ / 2].isCircle) follow(first_);
    }
    for (first_ = 0; first_ < 2 * arcs_.count(); first_ += 2) {
      if (!used[first_ / 2]) follow(first_);
    }
    return isolines;
  }

 private:
  /// The place of an end. Arc i begins at end 2 i, and ends at end 2 i + 1.
  SurfacePoint endPoint(int end) const {
    const Arc& arc = arcs_[end / 2];
    return pointOf(arc, end % 2 == 0 ? arc.begin : arc.end);
  }

  SurfacePoint pointOf(const Arc& arc, double angle) const {
    Vec3 bary = barycentric(geometry_, arc.face, arc.at(angle));
    for (int k = 0; k < 3; ++k) {
      if (bary[k] < kChainRounding) bary[k] = 0;
    }
    return clampedPoint(arc.face, bary / bary.sum());
  }

  /// Pairs each end with the nearest free end, the nearest pairs first. The search radius grows in
  /// steps, since a large radius may hold all ends in a narrow face. Most ends meet up to rounding,
  /// so that only few are still free when the radius is large.
  void pairEnds() {
    const int count = 2 * arcs_.count();
    partner_.assign(static_cast<size_t>(count), -1);
    Array<Vec3> places;
    Array<int> order;
    for (int end = 0; end < count; ++end) {
      places.push_back(position(*geometry_.mesh, endPoint(end)));
      if (!arcs_[end / 2].isCircle) order.push_back(end);
    }
    sortNumbers(order, [&](int a, int b) { return places[a].x() < places[b].x(); });
    for (const double part : {1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, kMeet}) {
      pairWithin(part * geometry_.meanEdge, places, order);
      order.erase(
          std::remove_if(order.begin(), order.end(), [&](int end) { return partner_[end] >= 0; }),
          order.end());
    }
  }

  /// Pairs free ends within the distance `meet`, the nearest first. `order` has the ends in
  /// ascending x.
  void pairWithin(double meet, const Array<Vec3>& places, const Array<int>& order) {
    struct Pair {
      double distance;
      int a;
      int b;
    };
    Array<Pair> pairs;
    for (int i = 0; i < order.count(); ++i) {
      for (int j = i + 1; j < order.count(); ++j) {
        const Vec3 apart = places[order[j]] - places[order[i]];
        if (apart.x() > meet) break;
        if (apart.norm() <= meet && mayMeet(order[i], order[j])) {
          pairs.push_back({apart.norm(), order[i], order[j]});
        }
      }
    }
    const auto isBefore = [&](int i, int j) {
      const Pair& a = pairs[i];
      const Pair& b = pairs[j];
      return a.distance != b.distance ? a.distance < b.distance
                                      : std::pair(a.a, a.b) < std::pair(b.a, b.b);
    };
    for (const int i : sortedNumbers(pairs.count(), isBefore)) {
      const Pair& pair = pairs[i];
      if (partner_[pair.a] >= 0 || partner_[pair.b] >= 0) continue;
      partner_[pair.a] = pair.b;
      partner_[pair.b] = pair.a;
    }
  }

  /// Whether two ends may be one point. The ends of the same arc may be one point only if the arc
  /// spans more than half a turn.
  bool mayMeet(int a, int b) const {
    const Arc& arc = arcs_[a / 2];
    return b != (a ^ 1) || arc.end - arc.begin > kPi;
  }

  void appendArc(int fromEnd, Isoline& line) const {
    const Arc& arc = arcs_[fromEnd / 2];
    const double width = arc.end - arc.begin;
    const double step = std::min(std::sqrt(8 * tolerance_ / arc.radius), kPi / 8);
    const int pieces = std::max(1, static_cast<int>(std::ceil(width / step)));
    for (int i = 0; i <= pieces; ++i) {
      const int k = fromEnd % 2 == 0 ? i : pieces - i;
      line.points.push_back(pointOf(arc, arc.begin + width * k / pieces));
    }
    line.length += arc.radius * width;
  }

  const Geometry& geometry_;
  const Array<Arc>& arcs_;
  double tolerance_;
  int first_ = 0;
  Array<int> partner_;
};

}  // namespace

Array<Isoline> exactIsolines(const Geometry& geometry, const SurfacePoint& source, double radius,
                             double tolerance) {
  checkIsolineRadius(radius);
  if (!(tolerance > 0) || !std::isfinite(tolerance)) {
    throw Error(ErrorCode::kBadArgument, "an isoline's tolerance must be a positive number");
  }
  WindowDistance distance(geometry);
  distance.keepImages(radius);
  distance.setSource(source);
  distance.grow(radius + geometry.meanEdge);
  const Array<SourceImage>& found = distance.images();
  Array<SourceImage> images;
  for (const int i :
       sortedNumbers(found.count(), [&](int a, int b) { return found[a].face < found[b].face; })) {
    images.push_back(found[i]);
  }
  Array<Arc> arcs;
  FaceArcs faceArcs(geometry, radius);
  // Whether a whole face is nearer than the radius, by paths through one of its corners.
  const auto isNearer = [&](int face) {
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * face + k;
      const double longest = std::max(geometry.edgeLength[h], geometry.edgeLength[previous(h)]);
      if (distance.distance(geometry.mesh->tail(h)) + longest < radius) return true;
    }
    return false;
  };
  for (int i = 0; i < images.count();) {
    int end = i;
    while (end < images.count() && images[end].face == images[i].face) ++end;
    // If a whole face is nearer than the radius, it has no arcs. Some of its images are missing, so
    // that nothing would undercut the arcs of the other images.
    if (!isNearer(images[i].face)) faceArcs.append(images.data() + i, images.data() + end, arcs);
    i = end;
  }
  return ArcChains(geometry, arcs, tolerance).run();
}

}  // namespace karcher
