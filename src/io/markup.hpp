// SPDX-License-Identifier: MIT
// Writes the elements of an SVG picture.
#pragma once

#include <string>
#include <string_view>

#include "hodograph/io/svg.hpp"

namespace hodograph::io_detail {

/// Appends a number of pixels with at most two decimals.
void append_pixels(std::string& out, double pixels);

/// Elements with attributes; numbers are pixels.
class Markup {
 public:
  Markup& open(std::string_view name) {
    out += '<';
    out += name;
    return *this;
  }
  Markup& attribute(std::string_view name, double value) {
    out += ' ';
    out += name;
    out += "=\"";
    append_pixels(out, value);
    out += '"';
    return *this;
  }
  Markup& attribute(std::string_view name, std::string_view value) {
    out += ' ';
    out += name;
    out += "=\"";
    out += escaped_markup(value);
    out += '"';
    return *this;
  }
  void close() { out += "/>\n"; }
  void close_with_text(std::string_view name, std::string_view text) {
    out += '>';
    out += escaped_markup(text);
    out += "</";
    out += name;
    out += ">\n";
  }
  void text(double x, double y, std::string_view style, std::string_view content) {
    open("text").attribute("x", x).attribute("y", y).attribute("class", style);
    close_with_text("text", content);
  }
  void line(double x1, double y1, double x2, double y2, std::string_view style) {
    open("path").attribute("class", style);
    out += " d=\"M";
    point(x1, y1);
    out += 'L';
    point(x2, y2);
    out += '"';
    close();
  }
  void point(double x, double y) {
    append_pixels(out, x);
    out += ' ';
    append_pixels(out, y);
  }
  std::string out;
};

}  // namespace hodograph::io_detail
