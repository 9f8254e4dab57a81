#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the list of the public names of the C++ library, tests/golden/cpp_api.txt: every type,
function, constant, alias and public member that the headers of include/hodograph declare.

    tools/cpp_api.py              rewrites it
    tools/cpp_api.py --check      shows how it differs from the headers, and exits 1
    tools/cpp_api.py --self-test

The folders detail/ and the namespaces that end in _detail are nobody's business and left out, like
bodies and values. It reads declarations, not all of C++: what our headers do not use it need not know.
"""

import difflib
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from check_support import blank  # noqa: E402

_ROOT = Path(__file__).resolve().parent.parent
_HEADERS = _ROOT / "include" / "hodograph"
_LIST = _ROOT / "tests" / "golden" / "cpp_api.txt"
_HEAD = ("# Every public name of the C++ library; written by tools/make_stubs. A change here is a change of\n"
         "# the interface: say so in CHANGELOG.md.\n")

_PREPROCESSOR = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
_ATTRIBUTE = re.compile(r"\[\[[^\]]*\]\]\s*")
_MACRO_LINE = re.compile(r"^HODOGRAPH_[A-Z_]+\s*(\([^)]*\))?\s*")
_ACCESS = re.compile(r"^(public|private|protected)\s*:(?!:)\s*")
_TYPE = re.compile(r"^(?:class|struct|union)\s+(?:alignas\s*\([^)]*\)\s*)?([\w:]+)")
_ENUM = re.compile(r"^enum\s+(?:class\s+|struct\s+)?(\w+)")


def _closing(text, position):
    """Where the bracket that opens at `position` closes."""
    depth = 0
    pairs = {"(": ")", "[": "]", "{": "}"}
    for i in range(position, len(text)):
        if text[i] in pairs:
            depth += 1
        elif text[i] in pairs.values():
            depth -= 1
            if depth == 0:
                return i
    raise ValueError(f"a bracket stays open: {text[position:position + 60]!r}")


def _without_template(head):
    """What follows the template parameters and their requires clause begins; (prefix, rest)."""
    rest, prefix = head, ""
    while rest.startswith("template"):
        begin, depth, i = rest.index("<"), 0, rest.index("<")
        while True:
            if rest[i] == "<":
                depth += 1
            elif rest[i] == ">" and rest[i - 1] != "-":
                depth -= 1
                if depth == 0:
                    break
            elif rest[i] in "([{":
                i = _closing(rest, i)
            i += 1
        prefix += rest[:i + 1] + " "
        rest = rest[i + 1:].lstrip()
        assert begin >= 0
    return prefix, rest


def _tidy(text):
    text = " ".join(text.split())
    text = re.sub(r"^((?:template <.*?> )?)(?:inline |extern )+", r"\1", text)
    return text.replace("( ", "(").replace(" )", ")")


def _assignment(head):
    """Where the value of a declaration begins (`= ...`), or None."""
    prefix, rest = _without_template(head)
    depth = 0
    for i, c in enumerate(rest):
        if c in "([{":
            depth += 1
        elif c in ")]}":
            depth -= 1
        elif c == "=" and depth == 0:
            before, after = rest[i - 1:i], rest[i + 1:i + 2]
            if before in "=<>!+-*/" or after == "=" or re.search(r"operator\s*$", rest[:i]):
                continue
            angle = rest[:i].count("<") - rest[:i].count(">") + rest[:i].count("->")
            if angle > 0 and "operator" not in rest[:i]:
                continue  # the default of a template parameter
            return len(head) - len(rest) + i
    return None


def _declarators(declaration):
    """`double a = 1, b{2}` as ["double a", "b"]."""
    names, depth, angle, begin = [], 0, 0, 0
    for i, c in enumerate(declaration + ","):
        depth += (c in "([{") - (c in ")]}")
        if depth == 0 and not re.search(r"=|\{", declaration[begin:i]):
            angle += (c == "<") - (c == ">")
        if c == "," and depth == 0 and angle == 0:
            one = declaration[begin:i]
            names.append(re.split(r"\s*[={]", one)[0].strip())
            begin = i + 1
    return names


def _initialisers(head):
    """Where the initialisers of a constructor begin (`) : a_(a)`), or None."""
    found = re.search(r"\)\s*(?:noexcept(?:\([^)]*\))?\s*)?:(?!:)", head)
    return found.end() - 1 if found else None


class _Scope:
    def __init__(self, name, access="public"):
        self.name, self.access = name, access


class _Reader:
    """Reads the declarations of one header."""

    def __init__(self, text):
        text = _PREPROCESSOR.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), blank(text))
        self.text = _ATTRIBUTE.sub("", text)
        self.lines = []

    def read(self):
        self._scope(0, len(self.text), _Scope(""))
        return self.lines

    def _emit(self, scope, text):
        if scope.access != "public":
            return
        text = _tidy(text)
        if text:
            self.lines.append(f"{scope.name}: {text}" if scope.name else text)

    def _scope(self, position, end, scope):
        while position < end:
            position = self._declaration(position, end, scope)

    def _declaration(self, position, end, scope):
        """Reads one declaration that begins at `position`; where the next begins."""
        text = self.text
        while position < end and (text[position].isspace() or text[position] == ";"):
            position += 1
        begin = i = position
        while i < end:
            rest = text[begin:i + 1]
            c = text[i]
            if c in "([":
                i = _closing(text, i) + 1
                continue
            if c == ":" and _ACCESS.match(rest + " ") and not text.startswith("::", i):
                scope.access = _ACCESS.match(rest + " ")[1]
                return i + 1
            if c == ";":
                self._simple(text[begin:i], scope)
                return i + 1
            if c == "{":
                done = self._braces(begin, i, scope)
                if done is not None:
                    return done
                i = _closing(text, i) + 1
                continue
            i += 1
        return end

    def _braces(self, begin, brace, scope):
        """Deals with `head {`; where the next declaration begins, or None if it goes on."""
        text = self.text
        close = _closing(text, brace)
        head = _MACRO_LINE.sub("", " ".join(text[begin:brace].split()))
        prefix, rest = _without_template(head)
        named = re.match(r"(?:inline )?namespace\s*([\w:]*)", rest)
        if named:
            if named[1] and not named[1].endswith("_detail"):
                inner = named[1].removeprefix("hodograph").lstrip(":")
                name = "::".join(part for part in (scope.name, inner) if part)
                self._scope(brace + 1, close, _Scope(name))
            return close + 1
        clause = re.match(r"requires\b.*?(?=\b(?:class|struct|union)\s+\w+)", rest)
        bare = rest[clause.end():] if clause else rest
        enum = _ENUM.match(rest)
        if enum:
            values = re.sub(r"\s*=\s*[^,]+", "", text[brace + 1:close])
            self._emit(scope, f"{head} {{ {' '.join(values.split()).rstrip(',')} }}")
            return close + 1
        if _TYPE.match(bare) and _assignment(head) is None:
            kind = _TYPE.match(bare)
            self._emit(scope, head)
            name = "::".join(part for part in (scope.name, kind[1]) if part)
            public = scope.access == "public"
            default = "private" if bare.startswith("class") else "public"
            inner = _Scope(name, default)
            if public:
                self._scope(brace + 1, close, inner)
            return close + 1
        if _assignment(head) is not None:
            return None  # a value; goes on to the semicolon
        initialisers = _initialisers(rest)
        if "(" in rest:
            if initialisers is not None and re.search(r"[\w>]$", rest) and not rest.endswith(
                    "noexcept"):
                return None  # a member's value in braces
            signature = rest[:initialisers].rstrip() if initialisers is not None else rest
            self._emit(scope, prefix + signature)
            return close + 1
        return None  # a variable with its value in braces

    def _simple(self, declaration, scope):
        """A declaration that ended with a semicolon."""
        head = _MACRO_LINE.sub("", " ".join(declaration.split()))
        prefix, rest = _without_template(head)
        if not rest or re.match(r"(static_assert|extern template|template )", rest):
            return
        if re.match(r"(extern )?template (class|struct)\b", head) or head.startswith("extern template"):
            return
        if re.match(r"template [^<]", head):
            return  # an explicit instantiation
        if re.fullmatch(r"(class|struct|union|enum class|enum) [\w:<>, ]+", rest) and not prefix:
            return  # a declaration of what is defined elsewhere
        if rest.startswith("friend class") or rest.startswith("friend struct"):
            return
        cut = _assignment(head)
        if rest.startswith("using "):
            self._emit(scope, head)
            return
        if cut is not None and "(" in head[:cut]:  # a function: = default, = delete, = 0
            head = head[:cut].rstrip() + (" = delete" if head.endswith("delete") else "")
        elif "concept " in rest and cut is not None:
            head = head[:cut].rstrip()
        elif "(" not in rest or cut is not None or re.search(r"\w\{", rest):
            head = prefix + ", ".join(_declarators(rest))
        self._emit(scope, head)


def declarations(text):
    """The public declarations of a header, one a line."""
    return _Reader(text).read()


def text_of(folder):
    """The whole list."""
    lines = []
    for path in sorted(folder.rglob("*.hpp")):
        if "detail" in path.relative_to(folder).parts:
            continue
        found = declarations(path.read_text(encoding="utf-8"))
        if found:
            lines += ["", f"[{path.relative_to(folder)}]", *found]
    return _HEAD + "\n".join(lines) + "\n"


def self_test():
    text = '''
#define HODOGRAPH_X(a) \\
  struct a { int no; };
namespace hodograph {
struct Later;
inline constexpr double limit = 3;  // one
enum class Kind { a, b = 3 };
namespace x_detail { int hidden(); }
/// Something { odd.
template <class T, std::size_t n = 2>
  requires(n > 1)
class [[nodiscard]] Box : public Base<T> {
 public:
  using type = std::array<T, n>;
  Box(T t) : t_{t}, u_(t) {}
  explicit Box(int) noexcept;
  template <class F> auto visit(F&& f) const { return f(t_); }
  T operator()(const T& x = {}) const;
  friend bool operator==(const Box&, const Box&) = default;
  struct Inner { int m = 1, k{2}; };
 private:
  T t_;
};
template <class T>
concept Scalar = requires(T t) { t + t; };
[[nodiscard]] inline int f(std::vector<int> v, bool b = true) { return 1; }
extern template class Box<int>;
namespace accuracy { double epsilon(); }
}
'''
    wanted = [
        "constexpr double limit", "enum class Kind { a, b }",
        "template <class T, std::size_t n = 2> requires(n > 1) class Box : public Base<T>",
        "Box: using type = std::array<T, n>", "Box: Box(T t)", "Box: explicit Box(int) noexcept",
        "Box: template <class F> auto visit(F&& f) const", "Box: T operator()(const T& x = {}) const",
        "Box: friend bool operator==(const Box&, const Box&)", "Box: struct Inner",
        "Box::Inner: int m, k", "template <class T> concept Scalar",
        "int f(std::vector<int> v, bool b = true)", "accuracy: double epsilon()"]
    found = declarations(text)
    assert found == wanted, "\n".join(difflib.unified_diff(wanted, found, lineterm=""))


def main():
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        print("cpp_api: self-test passed")
        return 0
    wanted = text_of(_HEADERS)
    there = _LIST.read_text(encoding="utf-8") if _LIST.exists() else ""
    if wanted == there:
        return 0
    name = _LIST.relative_to(_ROOT)
    if sys.argv[1:] != ["--check"]:
        _LIST.write_text(wanted, encoding="utf-8")
        print(f"wrote {name}")
        return 0
    print(f"{name} is not what the headers declare; run tools/make_stubs and look at the difference:")
    lines = difflib.unified_diff(there.splitlines(), wanted.splitlines(), "there", "declared",
                                 lineterm="", n=0)
    print("\n".join(list(lines)[:60]))
    return 1


if __name__ == "__main__":
    sys.exit(main())
