#include "rcm/control_field.h"

namespace karcher {

void ControlField::reset(Evaluate evaluate) {
  for (const int page : touchedPages_) pages_[page].reset();
  touchedPages_.clear();
  knownCount_ = 0;
  evaluate_ = std::move(evaluate);
}

const FieldValue& ControlField::compute(int vertex) {
  const FieldValue value = evaluate_(vertex);
  const int number = vertex / kPageSize;
  std::unique_ptr<Page>& page = pages_[number];
  if (!page) {
    page = std::make_unique<Page>();
    touchedPages_.push_back(number);
  }
  const int slot = vertex % kPageSize;
  page->values[slot] = value;
  page->known[slot] = true;
  ++knownCount_;
  return page->values[slot];
}

}  // namespace karcher
