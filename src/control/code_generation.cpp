// SPDX-License-Identifier: MIT
// One path as C99 source text: its tables, and the text of code_text.hpp round them.
#include "hodograph/control/code_generation.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

#include "code_text.hpp"
#include "hodograph/foundation/version.hpp"
#include "path_coefficients.hpp"

namespace hodograph {
namespace {

// Words that cannot begin the name of a function, or name one (main, and what compilers know).
constexpr std::array taken_words = {
    "alignas",   "alignof",  "and",      "and_eq",   "asm",       "auto",      "bitand",
    "bitor",     "bool",     "break",    "case",     "catch",     "char",      "class",
    "compl",     "concept",  "const",    "continue", "decltype",  "default",   "delete",
    "do",        "double",   "else",     "enum",     "explicit",  "export",    "extern",
    "false",     "float",    "for",      "friend",   "goto",      "if",        "inline",
    "int",       "long",     "main",     "mutable",  "namespace", "new",       "noexcept",
    "not",       "not_eq",   "nullptr",  "operator", "or",        "or_eq",     "private",
    "protected", "public",   "register", "requires", "restrict",  "return",    "short",
    "signed",    "sizeof",   "static",   "struct",   "switch",    "template",  "this",
    "throw",     "true",     "try",      "typedef",  "typeid",    "typename",  "union",
    "unsigned",  "using",    "virtual",  "void",     "volatile",  "while",     "xor",
    "xor_eq",    "unix",     "linux",    "assert",   "errno",     "offsetof",  "stdin",
    "stdout",    "stderr",   "abort",    "abs",      "acos",      "acosh",     "asin",
    "asinh",     "atan",     "atan2",    "atanh",    "calloc",    "cbrt",      "ceil",
    "conj",      "copysign", "cos",      "cosh",     "erf",       "erfc",      "exit",
    "exp",       "exp2",     "expm1",    "fabs",     "fdim",      "floor",     "fma",
    "fmax",      "fmin",     "fmod",     "fputc",    "fputs",     "free",      "frexp",
    "fwrite",    "hypot",    "ilogb",    "isalnum",  "isalpha",   "iscntrl",   "isdigit",
    "isfinite",  "isgraph",  "isinf",    "islower",  "isnan",     "isnormal",  "isprint",
    "ispunct",   "isspace",  "isupper",  "isxdigit", "labs",      "ldexp",     "lgamma",
    "llabs",     "llrint",   "llround",  "log",      "log10",     "log1p",     "log2",
    "logb",      "lrint",    "lround",   "malloc",   "memchr",    "memcmp",    "memcpy",
    "memmove",   "memset",   "modf",     "nan",      "nearbyint", "nextafter", "pow",
    "printf",    "putchar",  "puts",     "realloc",  "remainder", "remquo",    "rint",
    "round",     "scalbln",  "scalbn",   "scanf",    "signbit",   "sin",       "sinh",
    "snprintf",  "sprintf",  "sqrt",     "sscanf",   "strcat",    "strchr",    "strcmp",
    "strcpy",    "strlen",   "strncat",  "strncmp",  "strncpy",   "strrchr",   "strstr",
    "tan",       "tanh",     "tgamma",   "tolower",  "toupper",   "trunc",     "vprintf"};

std::optional<Fault> name_fault(const std::string& name) {
  const auto letter = [](unsigned char c) { return c < 128 && (std::isalnum(c) != 0 || c == '_'); };
  const bool word = !name.empty() && name.size() <= most_name_letters &&
                    std::all_of(name.begin(), name.end(), letter) && name[0] != '_' &&
                    std::isdigit(static_cast<unsigned char>(name[0])) == 0;
  const bool taken = std::find(taken_words.begin(), taken_words.end(), std::string_view(name)) !=
                     taken_words.end();
  if (word && !taken) return std::nullopt;
  std::string sentence = "\"";
  sentence.append(name, 0, most_name_letters + 1);
  sentence += "\" cannot name functions in C";
  if (taken) sentence += ", which has this word";
  sentence += "; a name is letters, digits and underscores, begins with a letter, and has at most ";
  sentence += std::to_string(most_name_letters) + " of them";
  return Fault{FaultCode::unsupported, sentence, std::nullopt, "name", std::nullopt, std::nullopt};
}

std::string replaced(std::string_view text, char mark, std::string_view by) {
  std::string result;
  for (const char c : text) {
    if (c == mark) {
      result += by;
    } else {
      result += c;
    }
  }
  return result;
}

// A number as C99 reads it without a rounding.
std::string exactly(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  return text.data();
}

std::string table(const std::string& name, const std::vector<double>& numbers) {
  constexpr std::size_t a_line = 4;
  std::string text = "static const double @_" + name + "[] = {";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += i == 0 ? "" : ",";
    text += i % a_line == 0 ? "\n  " : " ";
    text += exactly(numbers[i]);
  }
  return text + "\n};\n";
}

struct Tables {
  PathNumbers numbers;
  std::vector<double> integrals, lengths, binomials;
};

Tables tables_of(const AnyPath& path) {
  constexpr std::size_t least_row = 3;  // of the rules of Leibniz
  Tables tables{
      path.numbers(), control_detail::integral_coefficients(path), path.knot_arc_lengths(), {}};
  for (std::size_t n = 0; n <= std::max(path.degree(), least_row); ++n) {
    std::uint64_t choices = 1;
    for (std::size_t i = 0; i <= n; ++i) {
      tables.binomials.push_back(static_cast<double>(choices));
      choices = choices * (n - i) / (i + 1);
    }
  }
  return tables;
}

// ---- the external functions ---------------------------------------------------------------------

struct Quantity {
  std::string name;
  std::size_t rows = 1, columns = 1;
  std::size_t size() const { return rows * columns; }
};

std::vector<Quantity> quantities(std::size_t dimension) {
  if (dimension == 2) {
    return {{"position", 2}, {"frame", 2, 2}, {"body_rate"},
            {"speed"},       {"curvature"},   {"arc_length"}};
  }
  return {{"position", 3}, {"frame", 3, 3}, {"body_rate", 3}, {"world_rate", 3},
          {"speed"},       {"curvature"},   {"arc_length"}};
}

// An input or an output of an external function.
struct Slot {
  std::string name;
  std::size_t rows = 1, columns = 1;
  bool empty = false;  // nothing of it is used, or it is zero
};

struct External {
  std::string name;
  std::size_t order = 0;
  std::vector<Slot> inputs, results;
};

// The external function, its Jacobian and that one's: the inputs of a Jacobian are those of the
// function and its results, which it does not need, and its results are the derivatives of each
// result with respect to each input.
std::array<External, 3> externals(const std::string& name, std::size_t dimension) {
  std::array<External, 3> all;
  all[0] = {name, 0, {{"xi"}}, {}};
  for (const Quantity& q : quantities(dimension)) {
    all[0].results.push_back({q.name, q.rows, q.columns});
  }
  for (std::size_t order = 1; order < all.size(); ++order) {
    const External& before = all[order - 1];
    External& next = all[order];
    next.name = "jac_" + before.name;
    next.order = order;
    next.inputs = before.inputs;
    for (const Slot& result : before.results) {
      next.inputs.push_back({"out_" + result.name, result.rows, result.columns, true});
      for (const Slot& input : before.inputs) {
        next.results.push_back({"jac_" + result.name + "_" + input.name,
                                result.rows * result.columns, input.rows * input.columns,
                                result.empty || input.empty});
      }
    }
  }
  return all;
}

std::string pattern_name(const Slot& slot) {
  return std::string("@_") + (slot.empty ? "empty_" : "full_") + std::to_string(slot.rows) + "_" +
         std::to_string(slot.columns);
}

// Compressed columns: rows, columns, where each column begins and the last one ends, and the row of
// each entry.
std::string pattern(const Slot& slot) {
  const std::size_t entries = slot.empty ? 0 : slot.rows;
  std::string text = "static const long long int " + pattern_name(slot) + "[] = {" +
                     std::to_string(slot.rows) + ", " + std::to_string(slot.columns);
  for (std::size_t j = 0; j <= slot.columns; ++j) text += ", " + std::to_string(j * entries);
  for (std::size_t j = 0; j < slot.columns; ++j) {
    for (std::size_t i = 0; i < entries; ++i) text += ", " + std::to_string(i);
  }
  return text + "};\n";
}

template <class Of>
std::string list(const std::string& head, const std::vector<Slot>& slots, const Of& of) {
  std::string text = head + "[] = {";
  for (std::size_t i = 0; i < slots.size(); ++i) {
    text += i == 0 ? "\n  " : ",\n  ";
    text += of(slots[i]);
  }
  return text + "\n};\n";
}

std::string casadi_source(const std::string& name, std::size_t dimension) {
  const auto known = quantities(dimension);
  std::string text = "\n/* ---- external functions, as CasADi looks for them ---- */\n\n";
  text += "enum { @_outputs = " + std::to_string(known.size()) + " };\n";
  text += "static int (*const @_functions[])(double, int, double *) = {";
  for (std::size_t i = 0; i < known.size(); ++i) {
    text += (i == 0 ? "\n  @_" : ",\n  @_") + known[i].name;
  }
  text += "\n};\nstatic const int @_sizes[] = {";
  for (std::size_t i = 0; i < known.size(); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(known[i].size());
  }
  text += "};\n";
  text += code_text::casadi;

  std::vector<std::string> written;
  const auto patterns_of = [&](const std::vector<Slot>& slots) {
    for (const Slot& slot : slots) {
      if (std::find(written.begin(), written.end(), pattern_name(slot)) != written.end()) continue;
      written.push_back(pattern_name(slot));
      text += pattern(slot);
    }
  };
  text += "\n";
  const auto all = externals(name, dimension);
  for (const External& external : all) {
    patterns_of(external.inputs);
    patterns_of(external.results);
  }
  const auto quoted = [](const Slot& slot) { return "\"" + slot.name + "\""; };
  for (const External& external : all) {
    const std::string prefix = external.name + "_";
    text += "\nenum { ";
    text += prefix;
    text += "inputs = " + std::to_string(external.inputs.size()) + ", ";
    text += prefix;
    text += "results = " + std::to_string(external.results.size()) + " };\n";
    const std::string words = "static const char *const " + prefix;
    const std::string patterns = "static const long long int *const " + prefix;
    text += list(words + "input_names", external.inputs, quoted);
    text += list(words + "result_names", external.results, quoted);
    text += list(patterns + "input_patterns", external.inputs, pattern_name);
    text += list(patterns + "result_patterns", external.results, pattern_name);
    // Between the derivatives of two results with respect to ξ stand those with respect to the
    // other inputs of the function before, at each order.
    std::size_t stride = 1;
    if (external.order > 0) stride = external.results.size() / known.size();
    std::string body = replaced(code_text::casadi_function, '$', external.name);
    body = replaced(body, '#', std::to_string(external.order));
    text += replaced(body, '~', std::to_string(stride));
  }
  return text;
}

std::string casadi_header(const std::string& name, std::size_t dimension) {
  std::string text =
      "\n/* External functions, as CasADi looks for them: the values, and their first and second\n"
      "   derivatives. Out of the knots they return 1. */\n";
  for (const External& external : externals(name, dimension)) {
    text += replaced(code_text::casadi_declarations, '$', external.name);
  }
  return text;
}

std::string title(const AnyPath& path) {
  return std::string("/* Written by hodograph ") + version + ": a " +
         (path.is_closed() ? "closed " : "") + (path.dimension() == 2 ? "planar" : "spatial") +
         " Pythagorean-hodograph path of degree " + std::to_string(path.degree()) + " in " +
         std::to_string(path.segment_count()) +
         (path.segment_count() == 1 ? " segment. */\n" : " segments. */\n");
}

std::string header_text(const AnyPath& path, const CodeOptions& options) {
  const bool planar = path.dimension() == 2;
  const auto number = [](std::size_t n) { return std::to_string(n); };
  std::string text = title(path);
  text +=
      "#ifndef HODOGRAPH_CODE_@_H\n#define HODOGRAPH_CODE_@_H\n\n"
      "#ifdef __cplusplus\nextern \"C\" {\n#endif\n";
  text += code_text::results;
  text += "\nenum {\n  @_dimension = " + number(path.dimension()) +
          ",\n  @_segments = " + number(path.segment_count()) +
          ",\n  @_preimage_degree = " + number(path.preimage_degree()) + "\n};\n";
  text +=
      "\n/* The first and the last knot, and the length between them. */\n"
      "double @_xi_begin(void);\ndouble @_xi_end(void);\ndouble @_length(void);\n";
  text +=
      "\n/* A quantity at xi and its derivatives with respect to xi up to the order, one after\n"
      "   the other: (order + 1) times the numbers of one. */\n\n";
  const std::string vector = planar ? "2 numbers" : "3 numbers";
  const auto add = [&](const std::string& name, const std::string& what) {
    text += "/* " + what + ". */\nint @_" + name + "(double xi, int order, double *result);\n";
  };
  add("position", "The position: " + vector + "; order 0 to 4");
  add("arc_length", "The arc length from the first knot: 1 number; order 0 to 4");
  add("speed", "Its derivative, the parametric speed: 1 number; order 0 to 3");
  add("frame", planar ? "The tangent and the left normal: 4 numbers; order 0 to 3"
                      : "The tangent and the other two axes of the Euler-Rodrigues frame: "
                        "9 numbers; order 0 to 3");
  add("body_rate", planar ? "The rate of the frame's turning, per unit xi: 1 number; order 0 to 2"
                          : "The rates of the frame about its own axes, per unit xi: 3 numbers; "
                            "order 0 to 2");
  if (!planar) {
    add("world_rate",
        "The angular velocity of the frame per unit xi, in the axes of space: "
        "3 numbers; order 0 to 2");
  }
  add("curvature", planar ? "The curvature, positive to the left: 1 number; order 0 to 2"
                          : "The curvature, never negative: 1 number; order 0 to 2");
  if (options.casadi) text += casadi_header(options.name, path.dimension());
  text += "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  return replaced(text, '@', options.name);
}

std::string source_text(const AnyPath& path, const CodeOptions& options) {
  const bool planar = path.dimension() == 2;
  const Tables tables = tables_of(path);
  std::string text = title(path);
  text += "#include \"@.h\"\n\n";
  if (!planar) text += "#include <math.h>\n\n";
  text +=
      "/* A compiler that fuses a product and a sum changes the last digit. */\n"
      "#if !defined(__GNUC__) || defined(__clang__)\n#pragma STDC FP_CONTRACT OFF\n#endif\n\n";
  text += "enum {\n  @_degree = 2 * @_preimage_degree + 1,\n  @_most = 3,\n  @_components = " +
          std::to_string(path.preimage_components()) +
          ",\n  @_rate_size = " + (planar ? "1" : "3") +
          ",\n  @_frame_size = " + (planar ? "4" : "9") + "\n};\n\n";
  text += table("knots", tables.numbers.knots);
  text += table("starts", tables.numbers.starts);
  text += "/* Bernstein coefficients, segment after segment. */\n";
  text += table("preimages", tables.numbers.preimages);
  text += "/* The same of the way from the start of a segment, and of its length. */\n";
  text += table("integrals", tables.integrals);
  text += table("lengths", tables.lengths);
  text += "/* Binomial coefficients, row after row. */\n";
  text += table("binomials", tables.binomials);
  text += planar ? code_text::planar_forms : code_text::spatial_forms;
  std::string evaluation = code_text::evaluation;
  // Where the curvature is made comes after the rates it is made of.
  const std::size_t curvature = evaluation.find("\nint @_curvature");
  evaluation.insert(curvature, planar ? code_text::planar_bending : code_text::spatial_bending);
  text += evaluation;
  if (!planar) text += code_text::world_rate;
  if (options.casadi) text += casadi_source(options.name, path.dimension());
  return replaced(text, '@', options.name);
}

}  // namespace

Result<GeneratedCode> generate_code(const AnyPath& path, const CodeOptions& options) {
  if (const auto fault = name_fault(options.name)) return *fault;
  return GeneratedCode{options.name + ".h", header_text(path, options), options.name + ".c",
                       source_text(path, options)};
}

}  // namespace hodograph
