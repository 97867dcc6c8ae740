#include "skinning/bind/weight_row.h"

#include <algorithm>

namespace stretch::skinning {

void WeightSum::add(std::uint16_t joint, double weight) {
  if (!(weight > 0.0)) {
    return;
  }
  const auto known = std::ranges::find(entries_, joint, &Entry::joint);
  if (known != entries_.end()) {
    known->weight += weight;
  } else {
    entries_.push_back({joint, weight});
  }
}

void WeightSum::add(const Influences& row, double factor) {
  for (std::size_t i = 0; i < Influences::capacity; ++i) {
    add(row.bones[i], factor * static_cast<double>(row.weights[i]));
  }
}

double WeightSum::of(std::uint16_t joint) const {
  const auto known = std::ranges::find(entries_, joint, &Entry::joint);
  return known == entries_.end() ? 0.0 : known->weight;
}

Influences WeightSum::strongest(std::size_t most) const {
  std::vector<Entry> sorted = entries_;
  std::ranges::sort(sorted, [](const Entry& a, const Entry& b) {
    return a.weight > b.weight || (a.weight == b.weight && a.joint < b.joint);
  });
  sorted.resize(std::min(sorted.size(), std::min(most, Influences::capacity)));
  double total = 0.0;
  for (const Entry& entry : sorted) {
    total += entry.weight;
  }
  Influences row;
  row.weights[0] = sorted.empty() ? 1.0F : 0.0F;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    row.bones[i] = sorted[i].joint;
    row.weights[i] = static_cast<float>(sorted[i].weight / total);
  }
  return row;
}

} // namespace stretch::skinning
