#include "semantics/names.h"
#include "semantics/string_index.h"

namespace texbrdf {

struct NameTable::Impl {
  struct Entry {
    uint32_t spelling = 0;  // the canonical one
    NameTraits traits;
  };
  StringIndex<NameId> spellings;  // canonical ones and all others that were met
  StableList<Entry> names;
};

NameTable::NameTable() : impl_(std::make_unique<Impl>()) {}
NameTable::~NameTable() = default;

NameId NameTable::intern(std::string_view canonical) {
  if (const NameId known = find(canonical); known.valid()) return known;
  const NameId id{impl_->names.size()};
  impl_->names.append({.spelling = impl_->spellings.insert(canonical, id), .traits = name_traits(canonical)});
  return id;
}

NameId NameTable::find(std::string_view spelling) const {
  const uint32_t index = impl_->spellings.find(spelling);
  return index == StringIndex<NameId>::kNone ? NameId{} : impl_->spellings.payload(index);
}

void NameTable::add_spelling(std::string_view spelling, NameId id) {
  impl_->spellings.insert(spelling, id);
}

std::string_view NameTable::text(NameId id) const {
  return impl_->spellings.text(impl_->names[id.value].spelling);
}

const NameTraits& NameTable::traits(NameId id) const {
  return impl_->names[id.value].traits;
}

uint32_t NameTable::size() const {
  return impl_->names.size();
}

}  // namespace texbrdf
