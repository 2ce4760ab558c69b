#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "rcm/point_field.h"

namespace karcher {

/// The fields of points on one surface, by point. Centers of mass and curves may share a set: where
/// one of them has the field of a point already, the others get that one. A field's values depend
/// on the surface, the options and the point alone, so that no answer depends on what a set holds.
///
/// A field that nobody holds is spare. It is still found by its point, until a new point needs its
/// memory: a drag makes no fields but moves spare ones.
class FieldSet {
 public:
  /// The surface must outlive the set. Throws what `checkFieldOptions` throws.
  FieldSet(Surface& surface, const FieldOptions& options);
  FieldSet(const FieldSet&) = delete;
  FieldSet& operator=(const FieldSet&) = delete;

  const FieldOptions& options() const { return options_; }
  Surface& surface() const { return surface_; }

  /// The field of a point, near or not (point_field.h): the one that is at it, else a spare one
  /// that is moved to it, else a new one.
  std::shared_ptr<PointField> at(const SurfacePoint& point, bool isNear = false);

  /// The field that is at a point, or none.
  std::shared_ptr<PointField> find(const SurfacePoint& point, bool isNear = false) const;

  /// Gives the memory of spare fields back, but of at most `kept` of them.
  void dropSpare(int kept = 0);

  /// The same, but of as many as are held.
  void trim();

  /// How many fields there are.
  int count() const { return fields_.count(); }

  /// How many fields were made or moved to another point so far.
  int made() const { return made_; }

 private:
  struct Key {
    SurfacePoint point;
    bool isNear;
    bool operator==(const Key& other) const {
      return point.face == other.point.face && point.bary == other.point.bary &&
             isNear == other.isNear;
    }
  };
  struct Hash {
    size_t operator()(const Key& key) const;
  };
  static Key keyOf(const PointField& field) { return {field.point(), field.isNear()}; }

  /// Tells the place of a field that was moved there.
  void renumber(int place);

  /// The place of a spare field, in turn; -1 if there is none.
  int findSpare();

  Surface& surface_;
  FieldOptions options_;
  Array<std::shared_ptr<PointField>> fields_;
  std::shared_ptr<FindPathWorkspace> paths_ = std::make_shared<FindPathWorkspace>();
  std::unordered_map<Key, int, Hash> placeOf_;
  int next_ = 0;  ///< where the search for a spare field goes on
  int made_ = 0;
};

/// The same set for a curve, which may hold many fields: when the last copy of the pointer goes,
/// the set is trimmed, since what that curve held is spare then.
std::shared_ptr<FieldSet> trimmedAfter(std::shared_ptr<FieldSet> set);

/// The sets of one surface: one for each options that somebody uses.
class FieldSets {
 public:
  /// The surface must outlive the object.
  explicit FieldSets(Surface& surface) : surface_(surface) {}

  Surface& surface() const { return surface_; }

  /// The set of these options, which lives as long as a caller holds it. Throws what
  /// `checkFieldOptions` throws.
  std::shared_ptr<FieldSet> of(const FieldOptions& options);

 private:
  Surface& surface_;
  Array<std::weak_ptr<FieldSet>> sets_;
};

}  // namespace karcher
