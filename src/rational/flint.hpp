// SPDX-License-Identifier: MIT
// The FLINT values behind Rational and RationalPolynomial, and owners of FLINT matrices. Only
// sources of this module include it.
#pragma once

#include <fmpq.h>
#include <fmpq_mat.h>
#include <fmpq_poly.h>
#include <fmpz_poly.h>

#include <cstddef>
#include <new>
#include <utility>

#include "hodograph/rational/polynomial.hpp"

namespace hodograph::rational_detail {

struct FlintAccess {
  static_assert(sizeof(fmpq) <= sizeof(Rational) && alignof(fmpq) <= alignof(Rational));
  static_assert(sizeof(fmpq_poly_struct) <= sizeof(RationalPolynomial) &&
                alignof(fmpq_poly_struct) <= alignof(RationalPolynomial));
  static void* storage(Rational& x) { return x.storage_; }
  static void* storage(RationalPolynomial& p) { return p.storage_; }
  static fmpq* get(Rational& x) { return std::launder(reinterpret_cast<fmpq*>(x.storage_)); }
  static const fmpq* get(const Rational& x) {
    return std::launder(reinterpret_cast<const fmpq*>(x.storage_));
  }
  static fmpq_poly_struct* get(RationalPolynomial& p) {
    return std::launder(reinterpret_cast<fmpq_poly_struct*>(p.storage_));
  }
  static const fmpq_poly_struct* get(const RationalPolynomial& p) {
    return std::launder(reinterpret_cast<const fmpq_poly_struct*>(p.storage_));
  }
};

inline fmpq* raw(Rational& x) { return FlintAccess::get(x); }
inline const fmpq* raw(const Rational& x) { return FlintAccess::get(x); }
inline fmpq_poly_struct* raw(RationalPolynomial& p) { return FlintAccess::get(p); }
inline const fmpq_poly_struct* raw(const RationalPolynomial& p) { return FlintAccess::get(p); }

inline slong signed_size(std::size_t n) { return static_cast<slong>(n); }

/// A matrix over ℚ, rows × columns, of zeros at first.
class RationalMatrix {
 public:
  RationalMatrix(std::size_t rows, std::size_t columns) {
    fmpq_mat_init(value_, signed_size(rows), signed_size(columns));
  }
  RationalMatrix(const RationalMatrix& other) { fmpq_mat_init_set(value_, other.value_); }
  RationalMatrix(RationalMatrix&& other) noexcept : RationalMatrix(0, 0) {
    fmpq_mat_swap(value_, other.value_);
  }
  RationalMatrix& operator=(const RationalMatrix&) = delete;
  ~RationalMatrix() { fmpq_mat_clear(value_); }

  std::size_t rows() const { return static_cast<std::size_t>(fmpq_mat_nrows(value_)); }
  std::size_t columns() const { return static_cast<std::size_t>(fmpq_mat_ncols(value_)); }
  fmpq* at(std::size_t i, std::size_t j) {
    return fmpq_mat_entry(value_, signed_size(i), signed_size(j));
  }
  const fmpq* at(std::size_t i, std::size_t j) const {
    return fmpq_mat_entry(value_, signed_size(i), signed_size(j));
  }
  fmpq_mat_struct* get() { return value_; }
  const fmpq_mat_struct* get() const { return value_; }

  /// The entry (i, j) becomes the coefficient of t^k in p.
  void set_coefficient(std::size_t i, std::size_t j, const RationalPolynomial& p, std::size_t k) {
    fmpq_poly_get_coeff_fmpq(at(i, j), raw(p), signed_size(k));
  }

  /// A basis of the null space {x : M x = 0}, one row each.
  RationalMatrix null_space() const;

 private:
  fmpq_mat_t value_;
};

/// A matrix over ℤ, rows × columns, of zeros at first.
class IntegerMatrix {
 public:
  IntegerMatrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(value_, signed_size(rows), signed_size(columns));
  }
  IntegerMatrix(const IntegerMatrix&) = delete;
  IntegerMatrix(IntegerMatrix&& other) noexcept : IntegerMatrix(0, 0) {
    fmpz_mat_swap(value_, other.value_);
  }
  IntegerMatrix& operator=(const IntegerMatrix&) = delete;
  ~IntegerMatrix() { fmpz_mat_clear(value_); }

  std::size_t rows() const { return static_cast<std::size_t>(fmpz_mat_nrows(value_)); }
  std::size_t columns() const { return static_cast<std::size_t>(fmpz_mat_ncols(value_)); }
  fmpz* at(std::size_t i, std::size_t j) {
    return fmpz_mat_entry(value_, signed_size(i), signed_size(j));
  }
  fmpz_mat_struct* get() { return value_; }

  /// A basis of the null space {x : M x = 0}, one row each, 1 in the column that is its own.
  /// Destroys the matrix.
  RationalMatrix null_space();

 private:
  fmpz_mat_t value_;
};

/// An integer polynomial, for what FLINT offers on those alone.
class IntegerPolynomial {
 public:
  /// The primitive integer multiple of p.
  explicit IntegerPolynomial(const RationalPolynomial& p) {
    fmpz_poly_init(value_);
    fmpq_poly_get_numerator(value_, raw(p));
    fmpz_poly_primitive_part(value_, value_);
  }
  IntegerPolynomial(const IntegerPolynomial& other) {
    fmpz_poly_init(value_);
    fmpz_poly_set(value_, other.value_);
  }
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }
  fmpz_poly_struct* get() { return value_; }
  const fmpz_poly_struct* get() const { return value_; }

 private:
  fmpz_poly_t value_;
};

}  // namespace hodograph::rational_detail
