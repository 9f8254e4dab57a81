// SPDX-License-Identifier: MIT
// The C99 text of a generated path, apart from its tables. @ stands for the name. The operations
// and their order are those of bernstein/, curve/ and frame/, so that the values agree bit for bit.
#pragma once

namespace hodograph::code_text {

inline constexpr const char* results = R"c(
/* What the functions return. They write to their result only where they return @_ok. */
enum {
  @_ok = 0,
  @_outside = 1,      /* xi lies outside the knots, or is not a number */
  @_standstill = 2,   /* the speed is zero: no frame, rate or curvature exists */
  @_inflection = 3,   /* the curvature is zero, where it has no derivative in space */
  @_unknown_order = 4 /* more derivatives than are offered, or fewer than none */
};
)c";

/// What both dimensions share, before the forms of the algebra.
inline constexpr const char* evaluation = R"c(
/* The segment that holds xi (the later one at a knot) and the local parameter there. */
static int @_locate(double xi, int *segment, double *u) {
  int low = 0, high = @_segments;
  if (!(@_knots[0] <= xi && xi <= @_knots[@_segments])) return 0;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    if (@_knots[middle] <= xi) {
      low = middle;
    } else {
      high = middle;
    }
  }
  *segment = low;
  *u = (xi - @_knots[low]) / (@_knots[low + 1] - @_knots[low]);
  return 1;
}

static double @_choose(int n, int i) { return @_binomials[n * (n + 1) / 2 + i]; }

/* The Bernstein polynomials of degree n at u. */
static void @_weights(double u, int n, double *weights) {
  double left[@_degree + 1] = {0.0}, right[@_degree + 1] = {0.0}; /* powers of u and 1 - u */
  int i, k;
  left[0] = 1.0;
  right[0] = 1.0;
  if (n > 0) {
    left[1] = u;
    right[1] = 1.0 - u;
  }
  for (k = 2; k <= n; ++k) {
    left[k] = left[k / 2] * left[k - k / 2];
    right[k] = right[k / 2] * right[k - k / 2];
  }
  weights[n] = left[n];
  weights[0] = right[n];
  for (i = 1; 2 * i <= n; ++i) {
    const double choices = @_choose(n, i);
    weights[n - i] = (choices * right[i]) * left[n - i];
    weights[i] = (choices * left[i]) * right[n - i];
  }
}

/* The sum of weights[i] terms[i stride], i = 0, ..., n, from both ends inwards. */
static double @_sum(const double *weights, int n, const double *terms, int stride) {
  const int half = (n + 1) / 2;
  const double *last = terms + n * stride;
  double front, back;
  int i;
  if (n == 0) return terms[0];
  front = weights[0] * terms[0];
  back = weights[n] * last[0];
  if (half % 2 == 0) {
    front = front + weights[1] * terms[stride];
    back = back + weights[n - 1] * last[-stride];
  }
  for (i = 2 - half % 2; i < half; i += 2) {
    front = front + (weights[i] * terms[i * stride] + weights[i + 1] * terms[(i + 1) * stride]);
    back = back + (weights[n - i] * last[-i * stride] + weights[n - i - 1] * last[-(i + 1) * stride]);
  }
  front = front + back;
  if (n % 2 == 0) front = front + weights[n / 2] * terms[n / 2 * stride];
  return front;
}

/* The preimage and its derivatives with respect to xi up to the order. */
static void @_jet(int segment, double u, int order, double (*jet)[@_components]) {
  const int n = @_preimage_degree, steps = order < n ? order : n;
  const double *terms = @_preimages + segment * ((n + 1) * @_components);
  const double v = 1.0 - u, step = @_knots[segment + 1] - @_knots[segment];
  double weights[@_preimage_degree + 1] = {0.0}, point[@_most + 1] = {0.0};
  double difference[@_most + 1] = {0.0}, factors[@_most + 1] = {0.0};
  double factor = 1.0, scale = 1.0;
  int c, i, j, r;
  @_weights(u, n - steps, weights);
  for (r = 0; r < steps; ++r) factor = factor * (double)(n - r);
  for (r = steps; r > 0; --r) {
    factors[r] = factor;
    factor = factor / (double)(n - r + 1);
  }
  factors[0] = factor;
  for (c = 0; c < @_components; ++c) {
    for (i = 0; i <= steps; ++i) {
      point[i] = @_sum(weights, n - steps, terms + i * @_components + c, @_components);
    }
    for (r = steps; r >= 0; --r) {
      for (i = 0; i <= steps; ++i) difference[i] = point[i];
      for (j = 0; j < r; ++j) {
        for (i = 0; i + j < r; ++i) difference[i] = difference[i + 1] - difference[i];
      }
      jet[r][c] = factors[r] * difference[0];
      for (i = 0; i < r; ++i) point[i] = v * point[i] + u * point[i + 1];
    }
    for (r = steps + 1; r <= order; ++r) jet[r][c] = 0.0;
  }
  for (r = 1; r <= order; ++r) {
    scale = scale / step;
    for (c = 0; c < @_components; ++c) jet[r][c] = scale * jet[r][c];
  }
}

typedef void (*@_form)(const double *a, const double *b, double *result);

/* The derivative of a symmetric form of the preimage with itself. */
static void @_square(@_form form, int size, double (*jet)[@_components], int r, double *sum) {
  double weight = 1.0, term[@_dimension];
  int i, j;
  form(jet[0], jet[r], sum);
  if (r > 0) {
    for (i = 0; i < size; ++i) sum[i] = 2.0 * sum[i];
  }
  for (j = 1; 2 * j <= r; ++j) {
    weight = weight * (double)(r - j + 1) / (double)j;
    form(jet[j], jet[r - j], term);
    for (i = 0; i < size; ++i) {
      sum[i] = sum[i] + (2 * j == r ? weight : 2.0 * weight) * term[i];
    }
  }
}

/* The derivative of form(A, A') where the form is zero on the diagonal. */
static void @_turning(@_form form, double (*jet)[@_components], int r, double *sum) {
  double term[@_rate_size];
  int i;
  form(jet[0], jet[r + 1], sum);
  if (r == 2) {
    form(jet[1], jet[2], term);
    for (i = 0; i < @_rate_size; ++i) sum[i] = sum[i] + term[i];
  }
}

/* 2 form(A, A') over the speed, and its derivatives. */
static void @_rates(@_form form, double (*jet)[@_components], int order, double *rates) {
  double sigma[3] = {0.0, 0.0, 0.0}, reciprocal;
  int i, j, r;
  for (r = 0; r <= order; ++r) @_square(@_speed_form, 1, jet, r, sigma + r);
  reciprocal = 1.0 / sigma[0];
  for (r = 0; r <= order; ++r) {
    double *rate = rates + r * @_rate_size;
    @_turning(form, jet, r, rate);
    for (i = 0; i < @_rate_size; ++i) {
      rate[i] = 2.0 * rate[i];
      for (j = 0; j < r; ++j) {
        rate[i] = rate[i] - (@_choose(r, j) * sigma[r - j]) * rates[j * @_rate_size + i];
      }
      rate[i] = reciprocal * rate[i];
    }
  }
}

/* The preimage with as many derivatives as wanted, at xi; where frames are meant, in motion. */
static int @_jet_at(double xi, int derivatives, int moving, double (*jet)[@_components]) {
  double u, sigma;
  int segment;
  if (!@_locate(xi, &segment, &u)) return @_outside;
  @_jet(segment, u, derivatives, jet);
  if (moving) {
    @_speed_form(jet[0], jet[0], &sigma);
    if (!(0.0 < sigma)) return @_standstill;
  }
  return @_ok;
}

int @_position(double xi, int order, double *result) {
  double u, weights[@_degree + 1] = {0.0}, jet[@_most + 1][@_components];
  int i, r, segment;
  if (order < 0 || order > 4) return @_unknown_order;
  if (!@_locate(xi, &segment, &u)) return @_outside;
  @_weights(u, @_degree, weights);
  for (i = 0; i < @_dimension; ++i) {
    const double *terms = @_integrals + segment * ((@_degree + 1) * (@_dimension + 1)) + i;
    result[i] = @_starts[segment * @_dimension + i] + @_sum(weights, @_degree, terms, @_dimension + 1);
  }
  if (order > 0) {
    @_jet(segment, u, order - 1, jet);
    for (r = 0; r < order; ++r) {
      @_square(@_hodograph_form, @_dimension, jet, r, result + (r + 1) * @_dimension);
    }
  }
  return @_ok;
}

int @_arc_length(double xi, int order, double *result) {
  double u, weights[@_degree + 1] = {0.0}, jet[@_most + 1][@_components];
  int r, segment;
  if (order < 0 || order > 4) return @_unknown_order;
  if (!@_locate(xi, &segment, &u)) return @_outside;
  if (u == 1.0) {
    result[0] = @_lengths[segment + 1];
  } else {
    const double *terms =
        @_integrals + segment * ((@_degree + 1) * (@_dimension + 1)) + @_dimension;
    @_weights(u, @_degree, weights);
    result[0] = @_lengths[segment] + @_sum(weights, @_degree, terms, @_dimension + 1);
  }
  if (order > 0) {
    @_jet(segment, u, order - 1, jet);
    for (r = 0; r < order; ++r) @_square(@_speed_form, 1, jet, r, result + r + 1);
  }
  return @_ok;
}

int @_speed(double xi, int order, double *result) {
  double jet[@_most + 1][@_components];
  int r;
  if (order < 0 || order > 3) return @_unknown_order;
  if (@_jet_at(xi, order, 0, jet) != @_ok) return @_outside;
  for (r = 0; r <= order; ++r) @_square(@_speed_form, 1, jet, r, result + r);
  return @_ok;
}

int @_body_rate(double xi, int order, double *result) {
  double jet[@_most + 1][@_components];
  int status;
  if (order < 0 || order > 2) return @_unknown_order;
  status = @_jet_at(xi, order + 1, 1, jet);
  if (status == @_ok) @_rates(@_body_form, jet, order, result);
  return status;
}

int @_frame(double xi, int order, double *result) {
  double jet[@_most + 1][@_components], rates[3 * @_rate_size] = {0.0}, sum[@_frame_size];
  double sigma, reciprocal;
  int i, j, r, status;
  if (order < 0 || order > 3) return @_unknown_order;
  status = @_jet_at(xi, order, 1, jet);
  if (status != @_ok) return status;
  @_speed_form(jet[0], jet[0], &sigma);
  reciprocal = 1.0 / sigma;
  @_scaled_frame(jet[0], result);
  for (i = 0; i < @_frame_size; ++i) result[i] = reciprocal * result[i];
  if (order > 0) @_rates(@_body_form, jet, order - 1, rates);
  for (r = 0; r < order; ++r) {
    double *next = result + (r + 1) * @_frame_size;
    @_turned(result + r * @_frame_size, rates, next);
    for (j = 1; j <= r; ++j) {
      @_turned(result + (r - j) * @_frame_size, rates + j * @_rate_size, sum);
      for (i = 0; i < @_frame_size; ++i) next[i] = next[i] + @_choose(r, j) * sum[i];
    }
  }
  return @_ok;
}

int @_curvature(double xi, int order, double *result) {
  double jet[@_most + 1][@_components], square, rate, second;
  double sigma[3] = {0.0, 0.0, 0.0}, turning[3] = {0.0, 0.0, 0.0};
  int r, status;
  if (order < 0 || order > 2) return @_unknown_order;
  status = @_jet_at(xi, order + 1, 1, jet);
  if (status != @_ok) return status;
  if (!@_bending(jet, order, turning)) return @_inflection;
  for (r = 0; r <= order; ++r) @_square(@_speed_form, 1, jet, r, sigma + r);
  square = sigma[0] * sigma[0];
  result[0] = 2.0 * turning[0] / square;
  if (order > 0) {
    rate = 2.0 * (sigma[0] * sigma[1]);
    result[1] = (2.0 * turning[1] - rate * result[0]) / square;
    if (order > 1) {
      second = 2.0 * (sigma[0] * sigma[2] + sigma[1] * sigma[1]);
      result[2] = (2.0 * turning[2] - (2.0 * rate) * result[1] - second * result[0]) / square;
    }
  }
  return @_ok;
}

double @_xi_begin(void) { return @_knots[0]; }
double @_xi_end(void) { return @_knots[@_segments]; }
double @_length(void) { return @_lengths[@_segments]; }
)c";

/// r' = w² and what follows from it.
inline constexpr const char* planar_forms = R"c(
static void @_hodograph_form(const double *a, const double *b, double *result) {
  result[0] = a[0] * b[0] - a[1] * b[1];
  result[1] = a[0] * b[1] + a[1] * b[0];
}

static void @_speed_form(const double *a, const double *b, double *result) {
  result[0] = a[0] * b[0] + a[1] * b[1];
}

static void @_body_form(const double *a, const double *b, double *result) {
  result[0] = a[0] * b[1] - a[1] * b[0];
}

/* The squared length of a times the frame, axis after axis. */
static void @_scaled_frame(const double *a, double *frame) {
  @_hodograph_form(a, a, frame);
  frame[2] = -frame[1];
  frame[3] = frame[0];
}

/* The derivative of a frame that turns with the rate. */
static void @_turned(const double *frame, const double *rate, double *result) {
  int i;
  for (i = 0; i < 2; ++i) {
    result[i] = rate[0] * frame[2 + i];
    result[2 + i] = -(rate[0] * frame[i]);
  }
}
)c";
inline constexpr const char* planar_bending = R"c(
/* Half the curvature times the squared speed, and its derivatives. */
static int @_bending(double (*jet)[@_components], int order, double *turning) {
  int r;
  for (r = 0; r <= order; ++r) @_turning(@_body_form, jet, r, turning + r);
  return 1;
}
)c";

/// r' = A i A* and what follows from it.
inline constexpr const char* spatial_forms = R"c(
static void @_hodograph_form(const double *a, const double *b, double *result) {
  result[0] = (a[0] * b[0] + a[1] * b[1]) - (a[2] * b[2] + a[3] * b[3]);
  result[1] = (a[1] * b[2] + a[2] * b[1]) + (a[0] * b[3] + a[3] * b[0]);
  result[2] = (a[1] * b[3] + a[3] * b[1]) - (a[0] * b[2] + a[2] * b[0]);
}

static void @_speed_form(const double *a, const double *b, double *result) {
  result[0] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

static void @_body_form(const double *a, const double *b, double *result) {
  result[0] = (a[0] * b[1] - a[1] * b[0]) - (a[2] * b[3] - a[3] * b[2]);
  result[1] = (a[0] * b[2] - a[2] * b[0]) - (a[3] * b[1] - a[1] * b[3]);
  result[2] = (a[0] * b[3] - a[3] * b[0]) - (a[1] * b[2] - a[2] * b[1]);
}

static void @_world_form(const double *a, const double *b, double *result) {
  result[0] = (a[0] * b[1] - a[1] * b[0]) + (a[2] * b[3] - a[3] * b[2]);
  result[1] = (a[0] * b[2] - a[2] * b[0]) + (a[3] * b[1] - a[1] * b[3]);
  result[2] = (a[0] * b[3] - a[3] * b[0]) + (a[1] * b[2] - a[2] * b[1]);
}

/* The squared length of a times the frame, axis after axis. */
static void @_scaled_frame(const double *a, double *frame) {
  const double ww = a[0] * a[0], xx = a[1] * a[1], yy = a[2] * a[2], zz = a[3] * a[3];
  const double wx = a[0] * a[1], wy = a[0] * a[2], wz = a[0] * a[3];
  const double xy = a[1] * a[2], xz = a[1] * a[3], yz = a[2] * a[3];
  frame[0] = (ww + xx) - (yy + zz);
  frame[1] = 2.0 * (xy + wz);
  frame[2] = 2.0 * (xz - wy);
  frame[3] = 2.0 * (xy - wz);
  frame[4] = (ww + yy) - (xx + zz);
  frame[5] = 2.0 * (yz + wx);
  frame[6] = 2.0 * (xz + wy);
  frame[7] = 2.0 * (yz - wx);
  frame[8] = (ww + zz) - (xx + yy);
}

/* The derivative of a frame that turns with the rate. */
static void @_turned(const double *frame, const double *rate, double *result) {
  int i;
  for (i = 0; i < 3; ++i) {
    result[i] = rate[2] * frame[3 + i] - rate[1] * frame[6 + i];
    result[3 + i] = rate[0] * frame[6 + i] - rate[2] * frame[i];
    result[6 + i] = rate[1] * frame[i] - rate[0] * frame[3 + i];
  }
}
)c";
inline constexpr const char* spatial_bending = R"c(
/* Half the curvature times the squared speed, and its derivatives; 0 where they do not exist. */
static int @_bending(double (*jet)[@_components], int order, double *turning) {
  double v[3][@_rate_size];
  int r;
  for (r = 0; r <= order; ++r) @_turning(@_body_form, jet, r, v[r]);
  turning[0] = sqrt(v[0][1] * v[0][1] + v[0][2] * v[0][2]);
  if (order > 0) {
    if (!(0.0 < turning[0])) return 0;
    turning[1] = (v[0][1] * v[1][1] + v[0][2] * v[1][2]) / turning[0];
    if (order > 1) {
      turning[2] = ((v[1][1] * v[1][1] + v[1][2] * v[1][2]) +
                    (v[0][1] * v[2][1] + v[0][2] * v[2][2]) - turning[1] * turning[1]) /
                   turning[0];
    }
  }
  return 1;
}
)c";
inline constexpr const char* world_rate = R"c(
int @_world_rate(double xi, int order, double *result) {
  double jet[@_most + 1][@_components];
  int status;
  if (order < 0 || order > 2) return @_unknown_order;
  status = @_jet_at(xi, order + 1, 1, jet);
  if (status == @_ok) @_rates(@_world_form, jet, order, result);
  return status;
}
)c";

/// The external functions, whose tables come before.
inline constexpr const char* casadi = R"c(
/* The derivatives of the order where they are wanted; 0, or 1 where one does not exist. An input
   that is not given counts as zero. Between two results of one function come those with respect to
   its other inputs, which are empty. */
static int @_derive(const double **arg, double **res, int order, int stride) {
  const double xi = arg[0] ? arg[0][0] : 0.0;
  double values[3 * @_frame_size];
  int i, j;
  for (i = 0; i < @_outputs; ++i) {
    double *result = res[i * stride];
    if (!result) continue;
    if (@_functions[i](xi, order, values) != @_ok) return 1;
    for (j = 0; j < @_sizes[i]; ++j) result[j] = values[order * @_sizes[i] + j];
  }
  return 0;
}
)c";

/// One external function: $ stands for its name, # for its order, ~ for how many results it has for
/// each of the path's.
inline constexpr const char* casadi_function = R"c(
int $(const double **arg, double **res, long long int *iw, double *w, int mem) {
  (void)iw;
  (void)w;
  (void)mem;
  return @_derive(arg, res, #, ~);
}
void $_incref(void) {}
void $_decref(void) {}
int $_checkout(void) { return 0; }
void $_release(int mem) { (void)mem; }
long long int $_n_in(void) { return $_inputs; }
long long int $_n_out(void) { return $_results; }
const char *$_name_in(long long int i) {
  return 0 <= i && i < $_inputs ? $_input_names[i] : 0;
}
const char *$_name_out(long long int i) {
  return 0 <= i && i < $_results ? $_result_names[i] : 0;
}
const long long int *$_sparsity_in(long long int i) {
  return 0 <= i && i < $_inputs ? $_input_patterns[i] : 0;
}
const long long int *$_sparsity_out(long long int i) {
  return 0 <= i && i < $_results ? $_result_patterns[i] : 0;
}
int $_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w) {
  if (sz_arg) *sz_arg = $_inputs;
  if (sz_res) *sz_res = $_results;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}
)c";

inline constexpr const char* casadi_declarations = R"c(
int $(const double **arg, double **res, long long int *iw, double *w, int mem);
void $_incref(void);
void $_decref(void);
int $_checkout(void);
void $_release(int mem);
long long int $_n_in(void);
long long int $_n_out(void);
const char *$_name_in(long long int i);
const char *$_name_out(long long int i);
const long long int *$_sparsity_in(long long int i);
const long long int *$_sparsity_out(long long int i);
int $_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
)c";

}  // namespace hodograph::code_text
