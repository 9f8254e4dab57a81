// SPDX-License-Identifier: MIT
// Banded linear systems that need no pivoting (totally positive collocation matrices), open and
// cyclic. (The core links no linear algebra library; a general one lives in optional components.)
#pragma once

#include <cstddef>
#include <vector>

namespace hodograph::spline_detail {

/// A square matrix with entries a(i, j), |i - j| ≤ band, and elimination without pivoting:
/// stable for totally positive matrices (de Boor and Pinkus 1977).
class BandedMatrix {
 public:
  BandedMatrix(std::size_t size, std::size_t band)
      : size_(size), band_(band), entries_(size * (2 * band + 1)) {}

  std::size_t size() const { return size_; }
  bool inside(std::size_t i, std::size_t j) const { return i <= j + band_ && j <= i + band_; }
  double& at(std::size_t i, std::size_t j) { return entries_[i * (2 * band_ + 1) + j + band_ - i]; }
  double at(std::size_t i, std::size_t j) const {
    return entries_[i * (2 * band_ + 1) + j + band_ - i];
  }

  /// Replaces the matrix by its triangular factors. False when a pivot is not positive.
  bool factor() {
    for (std::size_t k = 0; k < size_; ++k) {
      if (!(at(k, k) > 0)) return false;
      const std::size_t last = k + band_ < size_ ? k + band_ : size_ - 1;
      for (std::size_t i = k + 1; i <= last; ++i) {
        const double factor = at(i, k) / at(k, k);
        at(i, k) = factor;
        for (std::size_t j = k + 1; j <= last; ++j) at(i, j) -= factor * at(k, j);
      }
    }
    return true;
  }

  /// Solves in place after factor(); V is a vector over double.
  template <class V>
  void solve(std::vector<V>& x) const {
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t j = i > band_ ? i - band_ : 0; j < i; ++j) x[i] = x[i] - at(i, j) * x[j];
    }
    for (std::size_t i = size_; i-- > 0;) {
      const std::size_t last = i + band_ < size_ ? i + band_ : size_ - 1;
      for (std::size_t j = i + 1; j <= last; ++j) x[i] = x[i] - at(i, j) * x[j];
      x[i] = (1.0 / at(i, i)) * x[i];
    }
  }

 private:
  std::size_t size_, band_;
  std::vector<double> entries_;
};

}  // namespace hodograph::spline_detail
