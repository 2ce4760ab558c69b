#include "rcm/field_set.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace karcher {

FieldSet::FieldSet(Surface& surface, const FieldOptions& options)
    : surface_(surface), options_(options) {
  checkFieldOptions(options);
}

size_t FieldSet::Hash::operator()(const Key& key) const {
  uint64_t hash = static_cast<uint64_t>(key.point.face);
  for (const double weight : key.point.bary) {
    // 0.0 and -0.0 are equal, so their hashes must be equal.
    const double positive = weight + 0.0;
    uint64_t bits = 0;
    std::memcpy(&bits, &positive, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  return static_cast<size_t>(hash);
}

std::shared_ptr<PointField> FieldSet::at(const SurfacePoint& point, bool isNear) {
  const auto known = placeOf_.find({point, isNear});
  if (known != placeOf_.end()) return fields_[known->second];
  int place = findSpare();
  // A field that moves keeps its map entry.
  decltype(placeOf_)::node_type entry;
  if (place < 0) {
    place = fields_.count();
    fields_.push_back(std::make_shared<PointField>(surface_, options_, paths_));
  } else {
    entry = placeOf_.extract(keyOf(*fields_[place]));
  }
  try {
    fields_[place]->setPoint(point, isNear);
    if (entry.empty()) {
      placeOf_.emplace(Key{point, isNear}, place);
    } else {
      entry.key() = {point, isNear};
      placeOf_.insert(std::move(entry));
    }
  } catch (...) {
    // The map must not find a half-built field, and the set must not keep it. Nothing may be
    // allocated here, since memory may have run out.
    if (place + 1 < fields_.count()) {
      std::swap(fields_[place], fields_.back());
      renumber(place);
    }
    fields_.pop_back();
    next_ = 0;
    throw;
  }
  ++made_;
  return fields_[place];
}

std::shared_ptr<PointField> FieldSet::find(const SurfacePoint& point, bool isNear) const {
  const auto known = placeOf_.find({point, isNear});
  return known != placeOf_.end() ? fields_[known->second] : nullptr;
}

int FieldSet::findSpare() {
  for (int looked = 0; looked < fields_.count(); ++looked) {
    const int place = next_;
    next_ = next_ + 1 < fields_.count() ? next_ + 1 : 0;
    if (fields_[place].use_count() == 1) return place;
  }
  return -1;
}

void FieldSet::renumber(int place) {
  const auto known = placeOf_.find(keyOf(*fields_[place]));
  if (known != placeOf_.end()) known->second = place;
}

void FieldSet::dropSpare(int kept) {
  std::erase_if(fields_, [&](const auto& field) {
    if (field.use_count() > 1 || --kept >= 0) return false;
    placeOf_.erase(keyOf(*field));
    return true;
  });
  for (int i = 0; i < fields_.count(); ++i) renumber(i);
  next_ = 0;
  surface_.pages()->trim();
}

void FieldSet::trim() {
  const auto held = std::count_if(fields_.begin(), fields_.end(),
                                  [](const auto& field) { return field.use_count() > 1; });
  if (fields_.count() > 2 * held) dropSpare(static_cast<int>(held));
}

void FieldSet::restUnused(int64_t most) {
  int64_t bytes = 0;
  for (const auto& field : fields_) bytes += field->bytesOfSolver();
  const bool isTooMuch = bytes > most;
  while (bytes > most) {
    PointField* longestUnused = nullptr;
    for (const auto& field : fields_) {
      if (field->bytesOfSolver() == 0 || field->lastUse() == uses_) continue;
      if (!longestUnused || field->lastUse() < longestUnused->lastUse())
        longestUnused = field.get();
    }
    if (!longestUnused) break;
    bytes -= longestUnused->bytesOfSolver();
    longestUnused->rest();
  }
  ++uses_;
  if (isTooMuch) surface_.pages()->trim();
}

std::shared_ptr<FieldSet> trimmedAfter(std::shared_ptr<FieldSet> set) {
  FieldSet* const pointer = set.get();
  return {pointer, [set = std::move(set)](FieldSet*) { set->trim(); }};
}

std::shared_ptr<FieldSet> FieldSets::of(const FieldOptions& options) {
  std::erase_if(sets_, [](const auto& set) { return set.expired(); });
  for (const auto& known : sets_) {
    std::shared_ptr<FieldSet> set = known.lock();
    if (set->options() == options) return set;
  }
  auto set = std::make_shared<FieldSet>(surface_, options);
  sets_.push_back(set);
  return set;
}

}  // namespace karcher
