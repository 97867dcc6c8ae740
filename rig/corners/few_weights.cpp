#include "rig/corners/few_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stretch::rig {

namespace {

using Places = std::vector<std::size_t>;

struct Fit {
  Places places;
  std::vector<double> weights; // one for each place
  double miss = std::numeric_limits<double>::infinity();
};

// Solves (G + share of its trace) y = 1 by Cholesky's method, G of the places alone.
std::vector<double> solveOnes(const MissProducts& products, const Places& places) {
  constexpr double share = 1e-12;
  const std::size_t n = places.size();
  double trace = 0.0;
  for (const std::size_t place : places) {
    trace += products.at(place, place);
  }
  const double floor = share * trace + std::numeric_limits<double>::epsilon() * 1e-40;
  std::vector<double> lower(n * n, 0.0);
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      double sum = products.at(places[row], places[column]);
      sum += row == column ? floor : 0.0;
      for (std::size_t k = 0; k < column; ++k) {
        sum -= lower[row * n + k] * lower[column * n + k];
      }
      const double pivot = std::sqrt(std::max(sum, floor));
      lower[row * n + column] = row == column ? pivot : sum / lower[column * n + column];
    }
  }
  std::vector<double> ones(n, 1.0);
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t k = 0; k < row; ++k) {
      ones[row] -= lower[row * n + k] * ones[k];
    }
    ones[row] /= lower[row * n + row];
  }
  for (std::size_t row = n; row-- > 0;) {
    for (std::size_t k = row + 1; k < n; ++k) {
      ones[row] -= lower[k * n + row] * ones[k];
    }
    ones[row] /= lower[row * n + row];
  }
  return ones;
}

double missOf(const MissProducts& products, const Fit& fit) {
  double miss = 0.0;
  for (std::size_t a = 0; a < fit.places.size(); ++a) {
    for (std::size_t b = 0; b < fit.places.size(); ++b) {
      miss += fit.weights[a] * fit.weights[b] * products.at(fit.places[a], fit.places[b]);
    }
  }
  return miss;
}

// The best weights of these places; those that would fall below 0 are left out, one after the other.
Fit fitOf(const MissProducts& products, Places places) {
  Fit fit;
  while (true) {
    std::vector<double> weights = solveOnes(products, places);
    double sum = 0.0;
    for (const double weight : weights) {
      sum += weight;
    }
    for (double& weight : weights) {
      weight /= sum;
    }
    const auto least = std::ranges::min_element(weights);
    if (places.size() == 1 || *least >= 0.0) {
      fit.places = std::move(places);
      fit.weights = std::move(weights);
      fit.miss = missOf(products, fit);
      return fit;
    }
    places.erase(places.begin() + (least - weights.begin()));
  }
}

Places without(Places places, std::size_t index) {
  places.erase(places.begin() + static_cast<std::ptrdiff_t>(index));
  return places;
}

Fit reduced(const MissProducts& products, Fit fit, std::size_t limit) {
  while (fit.places.size() > limit) {
    Fit best;
    for (std::size_t i = 0; i < fit.places.size(); ++i) {
      Fit tried = fitOf(products, without(fit.places, i));
      if (!(tried.miss >= best.miss)) {
        best = std::move(tried);
      }
    }
    fit = std::move(best);
  }
  return fit;
}

// The best fit that one more place makes of this one.
Fit extended(const MissProducts& products, const Fit& fit) {
  Fit best = fit;
  for (std::size_t candidate = 0; candidate < products.count; ++candidate) {
    if (std::ranges::find(fit.places, candidate) == fit.places.end()) {
      Places places = fit.places;
      places.push_back(candidate);
      Fit tried = fitOf(products, std::move(places));
      best = tried.miss < best.miss ? std::move(tried) : best;
    }
  }
  return best;
}

// The best fit that one exchange, or one more place, makes of this one.
Fit exchanged(const MissProducts& products, const Fit& fit, std::size_t limit) {
  Fit best = fit.places.size() < limit ? extended(products, fit) : fit;
  for (std::size_t candidate = 0; candidate < products.count; ++candidate) {
    if (std::ranges::find(fit.places, candidate) != fit.places.end()) {
      continue;
    }
    for (std::size_t i = 0; i < fit.places.size(); ++i) {
      Places places = fit.places;
      places[i] = candidate;
      Fit tried = fitOf(products, std::move(places));
      best = tried.miss < best.miss ? std::move(tried) : best;
    }
  }
  return best;
}

// The better of two: what is left of the exact ones, and those that are best to add one after the other.
Fit firstFit(const MissProducts& products, const Places& exact, std::size_t limit) {
  Fit fit;
  for (std::size_t count = 0; count < limit; ++count) {
    Fit more = extended(products, fit);
    if (!(more.miss < fit.miss)) {
      break;
    }
    fit = std::move(more);
  }
  Fit left = reduced(products, fitOf(products, exact), limit);
  return left.miss < fit.miss ? left : fit;
}

} // namespace

std::vector<double> fewWeights(const MissProducts& products, const std::vector<std::size_t>& exact,
                               std::size_t limit) {
  constexpr int mostExchanges = 8;
  Fit fit = firstFit(products, exact, limit);
  for (int i = 0; i < mostExchanges; ++i) {
    Fit better = exchanged(products, fit, limit);
    if (!(better.miss < fit.miss)) {
      break;
    }
    fit = std::move(better);
  }
  std::vector<double> weights(products.count, 0.0);
  for (std::size_t i = 0; i < fit.places.size(); ++i) {
    weights[fit.places[i]] = fit.weights[i];
  }
  return weights;
}

} // namespace stretch::rig
